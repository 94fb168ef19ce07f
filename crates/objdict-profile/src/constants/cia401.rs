// Generated from `data/cia401.toml` by `cargo xtask profiles`: edit that file.

#![allow(unused_imports, reason = "not every document has facts of every kind")]

use std::borrow::Cow;

use crate::model::{Access, Access::*, DataType, ObjectType, ObjectType::*, Value, Value::*};
use crate::tables::{NeedRow::*, Term::*, *};
use crate::{Condition, Confidence::*, Mapping::*, Profile};

pub(super) static PROFILE: Profile = Profile {
    group: "cia401",
    document: Cow::Borrowed("CiA 401"),
    title: Cow::Borrowed("generic I/O modules"),
    version: Some(Cow::Borrowed("3.0")),
    number: Some(401),
    repeats: false,
    tables: Tables {
        objects: Cow::Borrowed(OBJECTS),
        entries: Cow::Borrowed(ENTRIES),
        bits: Cow::Borrowed(BITS),
        meanings: Cow::Borrowed(MEANINGS),
        conditions: Cow::Borrowed(CONDITIONS),
        object_types: Cow::Borrowed(OBJECT_TYPES),
        data_types: Cow::Borrowed(DATA_TYPES),
        access: Cow::Borrowed(ACCESS),
        values: Cow::Borrowed(VALUES),
        defaults: Cow::Borrowed(DEFAULTS),
        indexes: Cow::Borrowed(INDEXES),
        commands: Cow::Borrowed(COMMANDS),
        transitions: Cow::Borrowed(TRANSITIONS),
        texts: Cow::Borrowed(TEXTS),
        errors: Part(0, 0),
        machine: None,
    },
};

static OBJECTS: &[ObjectRow] = &[
    ObjectRow { first: 4096, last: 4096, name: Part(140, 11), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 1), source: Part(151, 12), about: Part(163, 84), confidence: High }, // 1000h Device type
    ObjectRow { first: 4137, last: 4137, name: Part(289, 21), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(1, 3), source: Part(310, 27), about: Part(337, 82), confidence: High }, // 1029h Error behavior object
    ObjectRow { first: 5120, last: 5120, name: Part(419, 30), object_types: Part(0, 0), need: When(0), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(449, 12), about: Part(461, 81), confidence: High }, // 1400h RPDO 1 communication parameter
    ObjectRow { first: 5121, last: 5121, name: Part(542, 30), object_types: Part(0, 0), need: When(1), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(449, 12), about: Part(572, 90), confidence: High }, // 1401h RPDO 2 communication parameter
    ObjectRow { first: 5122, last: 5122, name: Part(662, 30), object_types: Part(0, 0), need: When(2), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(449, 12), about: Part(692, 89), confidence: High }, // 1402h RPDO 3 communication parameter
    ObjectRow { first: 5123, last: 5123, name: Part(781, 30), object_types: Part(0, 0), need: When(3), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(449, 12), about: Part(811, 91), confidence: High }, // 1403h RPDO 4 communication parameter
    ObjectRow { first: 5632, last: 5632, name: Part(902, 24), object_types: Part(0, 0), need: When(0), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(449, 12), about: Part(926, 68), confidence: High }, // 1600h RPDO 1 mapping parameter
    ObjectRow { first: 5633, last: 5633, name: Part(994, 24), object_types: Part(0, 0), need: When(1), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(449, 12), about: Part(1018, 77), confidence: High }, // 1601h RPDO 2 mapping parameter
    ObjectRow { first: 5634, last: 5634, name: Part(1095, 24), object_types: Part(0, 0), need: When(2), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(449, 12), about: Part(1119, 76), confidence: High }, // 1602h RPDO 3 mapping parameter
    ObjectRow { first: 5635, last: 5635, name: Part(1195, 24), object_types: Part(0, 0), need: When(3), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(449, 12), about: Part(1219, 78), confidence: High }, // 1603h RPDO 4 mapping parameter
    ObjectRow { first: 6144, last: 6144, name: Part(1297, 30), object_types: Part(0, 0), need: When(4), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(1327, 12), about: Part(1339, 66), confidence: High }, // 1800h TPDO 1 communication parameter
    ObjectRow { first: 6145, last: 6145, name: Part(1405, 30), object_types: Part(0, 0), need: When(5), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(1327, 12), about: Part(1435, 75), confidence: High }, // 1801h TPDO 2 communication parameter
    ObjectRow { first: 6146, last: 6146, name: Part(1510, 30), object_types: Part(0, 0), need: When(6), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(1327, 12), about: Part(1540, 74), confidence: High }, // 1802h TPDO 3 communication parameter
    ObjectRow { first: 6147, last: 6147, name: Part(1614, 30), object_types: Part(0, 0), need: When(7), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(1327, 12), about: Part(1644, 76), confidence: High }, // 1803h TPDO 4 communication parameter
    ObjectRow { first: 6656, last: 6656, name: Part(1720, 24), object_types: Part(0, 0), need: When(4), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(1327, 12), about: Part(1744, 57), confidence: High }, // 1A00h TPDO 1 mapping parameter
    ObjectRow { first: 6657, last: 6657, name: Part(1801, 24), object_types: Part(0, 0), need: When(5), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(1327, 12), about: Part(1825, 66), confidence: High }, // 1A01h TPDO 2 mapping parameter
    ObjectRow { first: 6658, last: 6658, name: Part(1891, 24), object_types: Part(0, 0), need: When(6), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(1327, 12), about: Part(1915, 65), confidence: High }, // 1A02h TPDO 3 mapping parameter
    ObjectRow { first: 6659, last: 6659, name: Part(1980, 24), object_types: Part(0, 0), need: When(7), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(1327, 12), about: Part(2004, 67), confidence: High }, // 1A03h TPDO 4 mapping parameter
    ObjectRow { first: 24576, last: 24576, name: Part(2071, 16), object_types: Part(0, 2), need: When(8), only: None, as_many_as: Part(0, 0), entries: Part(4, 3), source: Part(2114, 12), about: Part(2126, 47), confidence: High }, // 6000h Read input 8-bit
    ObjectRow { first: 24578, last: 24578, name: Part(2173, 20), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 1), entries: Part(7, 3), source: Part(2193, 12), about: Part(2205, 38), confidence: High }, // 6002h Polarity input 8-bit
    ObjectRow { first: 24579, last: 24579, name: Part(2243, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 1), entries: Part(10, 3), source: Part(2270, 9), about: Part(2279, 44), confidence: High }, // 6003h Filter constant input 8-bit
    ObjectRow { first: 24581, last: 24581, name: Part(2323, 31), object_types: Part(2, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(13, 1), source: Part(2270, 9), about: Part(2354, 64), confidence: High }, // 6005h Global interrupt enable digital
    ObjectRow { first: 24582, last: 24582, name: Part(2418, 31), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 1), entries: Part(14, 3), source: Part(2270, 9), about: Part(2449, 63), confidence: High }, // 6006h Interrupt mask any change 8-bit
    ObjectRow { first: 24583, last: 24583, name: Part(2512, 32), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 1), entries: Part(17, 3), source: Part(2270, 9), about: Part(2544, 71), confidence: High }, // 6007h Interrupt mask low-to-high 8-bit
    ObjectRow { first: 24584, last: 24584, name: Part(2615, 32), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 1), entries: Part(20, 3), source: Part(2270, 9), about: Part(2647, 71), confidence: High }, // 6008h Interrupt mask high-to-low 8-bit
    ObjectRow { first: 24608, last: 24615, name: Part(2718, 14), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(23, 3), source: Part(2270, 9), about: Part(2732, 49), confidence: High }, // 6020h Read input bit
    ObjectRow { first: 24624, last: 24631, name: Part(2781, 18), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(1, 1), entries: Part(26, 3), source: Part(2270, 9), about: Part(2799, 40), confidence: High }, // 6030h Polarity input bit
    ObjectRow { first: 24632, last: 24639, name: Part(2839, 25), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(1, 1), entries: Part(29, 3), source: Part(2270, 9), about: Part(2864, 46), confidence: High }, // 6038h Filter constant input bit
    ObjectRow { first: 24656, last: 24663, name: Part(2910, 35), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(1, 1), entries: Part(32, 3), source: Part(2270, 9), about: Part(2945, 65), confidence: High }, // 6050h Interrupt mask input bit any change
    ObjectRow { first: 24672, last: 24679, name: Part(3010, 36), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(1, 1), entries: Part(35, 3), source: Part(2270, 9), about: Part(3046, 73), confidence: High }, // 6060h Interrupt mask input bit low-to-high
    ObjectRow { first: 24688, last: 24695, name: Part(3119, 36), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(1, 1), entries: Part(38, 3), source: Part(2270, 9), about: Part(3155, 73), confidence: High }, // 6070h Interrupt mask input bit high-to-low
    ObjectRow { first: 24832, last: 24832, name: Part(3228, 17), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(41, 3), source: Part(2270, 9), about: Part(3245, 48), confidence: High }, // 6100h Read input 16-bit
    ObjectRow { first: 24834, last: 24834, name: Part(3293, 21), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(2, 1), entries: Part(44, 3), source: Part(2270, 9), about: Part(3314, 39), confidence: High }, // 6102h Polarity input 16-bit
    ObjectRow { first: 24835, last: 24835, name: Part(3353, 28), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(2, 1), entries: Part(47, 3), source: Part(2270, 9), about: Part(3381, 45), confidence: High }, // 6103h Filter constant input 16-bit
    ObjectRow { first: 24838, last: 24838, name: Part(3426, 32), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(2, 1), entries: Part(50, 3), source: Part(2270, 9), about: Part(3458, 64), confidence: High }, // 6106h Interrupt mask any change 16-bit
    ObjectRow { first: 24839, last: 24839, name: Part(3522, 33), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(2, 1), entries: Part(53, 3), source: Part(2270, 9), about: Part(3555, 72), confidence: High }, // 6107h Interrupt mask low-to-high 16-bit
    ObjectRow { first: 24840, last: 24840, name: Part(3627, 33), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(2, 1), entries: Part(56, 3), source: Part(2270, 9), about: Part(3660, 72), confidence: High }, // 6108h Interrupt mask high-to-low 16-bit
    ObjectRow { first: 24864, last: 24864, name: Part(3732, 17), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(59, 3), source: Part(2270, 9), about: Part(3749, 48), confidence: High }, // 6120h Read input 32-bit
    ObjectRow { first: 24866, last: 24866, name: Part(3797, 21), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(3, 1), entries: Part(62, 3), source: Part(2270, 9), about: Part(3818, 39), confidence: High }, // 6122h Polarity input 32-bit
    ObjectRow { first: 24867, last: 24867, name: Part(3857, 28), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(3, 1), entries: Part(65, 3), source: Part(2270, 9), about: Part(3885, 45), confidence: High }, // 6123h Filter constant input 32-bit
    ObjectRow { first: 24870, last: 24870, name: Part(3930, 32), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(3, 1), entries: Part(68, 3), source: Part(2270, 9), about: Part(3962, 64), confidence: High }, // 6126h Interrupt mask any change 32-bit
    ObjectRow { first: 24871, last: 24871, name: Part(4026, 33), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(3, 1), entries: Part(71, 3), source: Part(2270, 9), about: Part(4059, 72), confidence: High }, // 6127h Interrupt mask low-to-high 32-bit
    ObjectRow { first: 24872, last: 24872, name: Part(4131, 33), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(3, 1), entries: Part(74, 3), source: Part(2270, 9), about: Part(4164, 72), confidence: High }, // 6128h Interrupt mask high-to-low 32-bit
    ObjectRow { first: 25088, last: 25088, name: Part(4236, 18), object_types: Part(0, 2), need: When(9), only: None, as_many_as: Part(0, 0), entries: Part(77, 3), source: Part(4254, 12), about: Part(4266, 40), confidence: High }, // 6200h Write output 8-bit
    ObjectRow { first: 25090, last: 25090, name: Part(4306, 28), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(4, 1), entries: Part(80, 3), source: Part(4334, 12), about: Part(4346, 39), confidence: High }, // 6202h Change polarity output 8-bit
    ObjectRow { first: 25094, last: 25094, name: Part(4385, 23), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(4, 1), entries: Part(83, 3), source: Part(4408, 12), about: Part(4420, 74), confidence: High }, // 6206h Error mode output 8-bit
    ObjectRow { first: 25095, last: 25095, name: Part(4494, 24), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(4, 1), entries: Part(86, 3), source: Part(4408, 12), about: Part(4518, 65), confidence: High }, // 6207h Error value output 8-bit
    ObjectRow { first: 25096, last: 25096, name: Part(4583, 24), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(4, 1), entries: Part(89, 3), source: Part(2270, 9), about: Part(4607, 40), confidence: High }, // 6208h Filter mask output 8-bit
    ObjectRow { first: 25120, last: 25127, name: Part(4647, 16), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(92, 3), source: Part(2270, 9), about: Part(4663, 42), confidence: High }, // 6220h Write output bit
    ObjectRow { first: 25152, last: 25159, name: Part(4705, 26), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(5, 1), entries: Part(95, 3), source: Part(2270, 9), about: Part(4731, 41), confidence: High }, // 6240h Change polarity output bit
    ObjectRow { first: 25168, last: 25175, name: Part(4772, 21), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(5, 1), entries: Part(98, 3), source: Part(2270, 9), about: Part(4793, 85), confidence: High }, // 6250h Error mode output bit
    ObjectRow { first: 25184, last: 25191, name: Part(4878, 22), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(5, 1), entries: Part(101, 3), source: Part(2270, 9), about: Part(4900, 69), confidence: High }, // 6260h Error value output bit
    ObjectRow { first: 25200, last: 25207, name: Part(4969, 22), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(5, 1), entries: Part(104, 3), source: Part(2270, 9), about: Part(4991, 42), confidence: High }, // 6270h Filter mask output bit
    ObjectRow { first: 25344, last: 25344, name: Part(5033, 19), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(107, 3), source: Part(2270, 9), about: Part(5052, 41), confidence: High }, // 6300h Write output 16-bit
    ObjectRow { first: 25346, last: 25346, name: Part(5093, 29), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(6, 1), entries: Part(110, 3), source: Part(2270, 9), about: Part(5122, 40), confidence: High }, // 6302h Change polarity output 16-bit
    ObjectRow { first: 25350, last: 25350, name: Part(5162, 24), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(6, 1), entries: Part(113, 3), source: Part(2270, 9), about: Part(5186, 75), confidence: High }, // 6306h Error mode output 16-bit
    ObjectRow { first: 25351, last: 25351, name: Part(5261, 25), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(6, 1), entries: Part(116, 3), source: Part(2270, 9), about: Part(5286, 66), confidence: High }, // 6307h Error value output 16-bit
    ObjectRow { first: 25352, last: 25352, name: Part(5352, 25), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(6, 1), entries: Part(119, 3), source: Part(2270, 9), about: Part(5377, 41), confidence: High }, // 6308h Filter mask output 16-bit
    ObjectRow { first: 25376, last: 25376, name: Part(5418, 19), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(122, 3), source: Part(2270, 9), about: Part(5437, 41), confidence: High }, // 6320h Write output 32-bit
    ObjectRow { first: 25378, last: 25378, name: Part(5478, 29), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(7, 1), entries: Part(125, 3), source: Part(2270, 9), about: Part(5507, 40), confidence: High }, // 6322h Change polarity output 32-bit
    ObjectRow { first: 25382, last: 25382, name: Part(5547, 24), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(7, 1), entries: Part(128, 3), source: Part(2270, 9), about: Part(5571, 75), confidence: High }, // 6326h Error mode output 32-bit
    ObjectRow { first: 25383, last: 25383, name: Part(5646, 25), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(7, 1), entries: Part(131, 3), source: Part(2270, 9), about: Part(5671, 66), confidence: High }, // 6327h Error value output 32-bit
    ObjectRow { first: 25384, last: 25384, name: Part(5737, 25), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(7, 1), entries: Part(134, 3), source: Part(2270, 9), about: Part(5762, 41), confidence: High }, // 6328h Filter mask output 32-bit
    ObjectRow { first: 25600, last: 25600, name: Part(5803, 25), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(137, 3), source: Part(2270, 9), about: Part(5828, 68), confidence: High }, // 6400h Read analogue input 8-bit
    ObjectRow { first: 25601, last: 25601, name: Part(5896, 26), object_types: Part(0, 2), need: When(10), only: None, as_many_as: Part(0, 0), entries: Part(140, 3), source: Part(5922, 12), about: Part(5934, 69), confidence: High }, // 6401h Read analogue input 16-bit
    ObjectRow { first: 25602, last: 25602, name: Part(6003, 26), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(143, 3), source: Part(2270, 9), about: Part(6029, 69), confidence: High }, // 6402h Read analogue input 32-bit
    ObjectRow { first: 25603, last: 25603, name: Part(6098, 25), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(146, 3), source: Part(2270, 9), about: Part(6123, 77), confidence: High }, // 6403h Read analogue input float
    ObjectRow { first: 25604, last: 25604, name: Part(6200, 41), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(2270, 9), about: Part(6241, 77), confidence: Medium }, // 6404h Read manufacturer specific analogue input
    ObjectRow { first: 25616, last: 25616, name: Part(6318, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(149, 3), source: Part(2270, 9), about: Part(6345, 60), confidence: High }, // 6410h Write analogue output 8-bit
    ObjectRow { first: 25617, last: 25617, name: Part(6405, 28), object_types: Part(0, 2), need: When(11), only: None, as_many_as: Part(0, 0), entries: Part(152, 3), source: Part(6433, 13), about: Part(6446, 61), confidence: High }, // 6411h Write analogue output 16-bit
    ObjectRow { first: 25618, last: 25618, name: Part(6507, 28), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(155, 3), source: Part(2270, 9), about: Part(6535, 61), confidence: High }, // 6412h Write analogue output 32-bit
    ObjectRow { first: 25619, last: 25619, name: Part(6596, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(158, 3), source: Part(2270, 9), about: Part(6623, 69), confidence: High }, // 6413h Write analogue output float
    ObjectRow { first: 25620, last: 25620, name: Part(6692, 43), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(2270, 9), about: Part(6735, 69), confidence: Medium }, // 6414h Write manufacturer specific analogue output
    ObjectRow { first: 25633, last: 25633, name: Part(6804, 42), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(161, 3), source: Part(2270, 9), about: Part(6981, 69), confidence: High }, // 6421h Analogue input interrupt trigger selection
    ObjectRow { first: 25634, last: 25634, name: Part(7050, 31), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(164, 3), source: Part(2270, 9), about: Part(7081, 85), confidence: High }, // 6422h Analogue input interrupt source
    ObjectRow { first: 25635, last: 25635, name: Part(7166, 38), object_types: Part(2, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(167, 1), source: Part(2270, 9), about: Part(7204, 65), confidence: High }, // 6423h Analogue input global interrupt enable
    ObjectRow { first: 25636, last: 25636, name: Part(7269, 44), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(168, 3), source: Part(2270, 9), about: Part(7313, 66), confidence: High }, // 6424h Analogue input interrupt upper limit integer
    ObjectRow { first: 25637, last: 25637, name: Part(7379, 44), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(171, 3), source: Part(2270, 9), about: Part(7423, 66), confidence: High }, // 6425h Analogue input interrupt lower limit integer
    ObjectRow { first: 25638, last: 25638, name: Part(7489, 39), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(174, 3), source: Part(2270, 9), about: Part(7528, 82), confidence: High }, // 6426h Analogue input interrupt delta unsigned
    ObjectRow { first: 25639, last: 25639, name: Part(7610, 48), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(177, 3), source: Part(2270, 9), about: Part(7658, 81), confidence: High }, // 6427h Analogue input interrupt negative delta unsigned
    ObjectRow { first: 25640, last: 25640, name: Part(7739, 48), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(180, 3), source: Part(2270, 9), about: Part(7787, 80), confidence: High }, // 6428h Analogue input interrupt positive delta unsigned
    ObjectRow { first: 25641, last: 25641, name: Part(7867, 42), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(183, 3), source: Part(2270, 9), about: Part(7909, 52), confidence: High }, // 6429h Analogue input interrupt upper limit float
    ObjectRow { first: 25642, last: 25642, name: Part(7961, 42), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(186, 3), source: Part(2270, 9), about: Part(8003, 52), confidence: High }, // 642Ah Analogue input interrupt lower limit float
    ObjectRow { first: 25643, last: 25643, name: Part(8055, 36), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(189, 3), source: Part(2270, 9), about: Part(8091, 47), confidence: High }, // 642Bh Analogue input interrupt delta float
    ObjectRow { first: 25644, last: 25644, name: Part(8138, 45), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(192, 3), source: Part(2270, 9), about: Part(8183, 45), confidence: High }, // 642Ch Analogue input interrupt negative delta float
    ObjectRow { first: 25645, last: 25645, name: Part(8228, 45), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(195, 3), source: Part(2270, 9), about: Part(8273, 45), confidence: High }, // 642Dh Analogue input interrupt positive delta float
    ObjectRow { first: 25646, last: 25646, name: Part(8318, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(198, 3), source: Part(2270, 9), about: Part(8345, 75), confidence: High }, // 642Eh Analogue input offset float
    ObjectRow { first: 25647, last: 25647, name: Part(8420, 28), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(201, 3), source: Part(2270, 9), about: Part(8448, 75), confidence: High }, // 642Fh Analogue input scaling float
    ObjectRow { first: 25648, last: 25648, name: Part(8523, 22), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(204, 3), source: Part(2270, 9), about: Part(8545, 30), confidence: High }, // 6430h Analogue input SI unit
    ObjectRow { first: 25649, last: 25649, name: Part(8575, 29), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(207, 3), source: Part(2270, 9), about: Part(8604, 62), confidence: High }, // 6431h Analogue input offset integer
    ObjectRow { first: 25650, last: 25650, name: Part(8666, 30), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(210, 3), source: Part(2270, 9), about: Part(8696, 62), confidence: High }, // 6432h Analogue input scaling integer
    ObjectRow { first: 25665, last: 25665, name: Part(8758, 28), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(13, 5), entries: Part(213, 3), source: Part(2270, 9), about: Part(8786, 76), confidence: High }, // 6441h Analogue output offset float
    ObjectRow { first: 25666, last: 25666, name: Part(8862, 29), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(13, 5), entries: Part(216, 3), source: Part(2270, 9), about: Part(8891, 76), confidence: High }, // 6442h Analogue output scaling float
    ObjectRow { first: 25667, last: 25667, name: Part(8967, 26), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(13, 5), entries: Part(219, 3), source: Part(9038, 13), about: Part(9051, 70), confidence: High }, // 6443h Analogue output error mode
    ObjectRow { first: 25668, last: 25668, name: Part(9121, 35), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(13, 5), entries: Part(222, 3), source: Part(9038, 13), about: Part(9156, 76), confidence: High }, // 6444h Analogue output error value integer
    ObjectRow { first: 25669, last: 25669, name: Part(9232, 33), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(13, 5), entries: Part(225, 3), source: Part(2270, 9), about: Part(9265, 89), confidence: High }, // 6445h Analogue output error value float
    ObjectRow { first: 25670, last: 25670, name: Part(9354, 30), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(13, 5), entries: Part(228, 3), source: Part(2270, 9), about: Part(9384, 63), confidence: High }, // 6446h Analogue output offset integer
    ObjectRow { first: 25671, last: 25671, name: Part(9447, 31), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(13, 5), entries: Part(231, 3), source: Part(2270, 9), about: Part(9478, 63), confidence: High }, // 6447h Analogue output scaling integer
    ObjectRow { first: 25680, last: 25680, name: Part(9541, 23), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(13, 5), entries: Part(234, 3), source: Part(2270, 9), about: Part(9564, 31), confidence: High }, // 6450h Analogue output SI unit
    ObjectRow { first: 26623, last: 26623, name: Part(140, 11), object_types: Part(2, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(237, 1), source: Part(9595, 15), about: Part(9610, 100), confidence: High }, // 67FFh Device type
];

static ENTRIES: &[EntryRow] = &[
    EntryRow { first: 0, last: 0, mapping: None, need: Optional, name: Part(0, 0), data_types: Part(0, 0), access: Part(0, 0), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 7) },
    EntryRow { first: 1, last: 1, mapping: None, need: Optional, name: Part(247, 19), data_types: Part(0, 0), access: Part(0, 0), values: Part(0, 2), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Communication error
    EntryRow { first: 2, last: 2, mapping: None, need: Optional, name: Part(266, 12), data_types: Part(0, 0), access: Part(0, 0), values: Part(0, 2), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Output error
    EntryRow { first: 3, last: 3, mapping: None, need: Optional, name: Part(278, 11), data_types: Part(0, 0), access: Part(0, 0), values: Part(0, 2), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Input error
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(2071, 16), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Read input 8-bit
    EntryRow { first: 2, last: 254, mapping: Some(Tpdo), need: Optional, name: Part(2071, 16), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Read input 8-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2173, 20), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Polarity input 8-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(2173, 20), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Polarity input 8-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2243, 27), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Filter constant input 8-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(2243, 27), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Filter constant input 8-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(1, 2), access: Part(1, 1), values: Part(0, 0), default: Some(1), unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2418, 31), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(2), unit: Part(0, 0), bits: Part(0, 0) }, // Interrupt mask any change 8-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(2418, 31), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(2), unit: Part(0, 0), bits: Part(0, 0) }, // Interrupt mask any change 8-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2512, 32), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Interrupt mask low-to-high 8-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(2512, 32), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Interrupt mask low-to-high 8-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2615, 32), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Interrupt mask high-to-low 8-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(2615, 32), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Interrupt mask high-to-low 8-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(3, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(2718, 14), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Read input bit
    EntryRow { first: 2, last: 128, mapping: Some(Tpdo), need: Optional, name: Part(2718, 14), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Read input bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(3, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2781, 18), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(3), unit: Part(0, 0), bits: Part(0, 0) }, // Polarity input bit
    EntryRow { first: 2, last: 128, mapping: Some(No), need: Optional, name: Part(2781, 18), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(3), unit: Part(0, 0), bits: Part(0, 0) }, // Polarity input bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(3, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2839, 25), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(3), unit: Part(0, 0), bits: Part(0, 0) }, // Filter constant input bit
    EntryRow { first: 2, last: 128, mapping: Some(No), need: Optional, name: Part(2839, 25), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(3), unit: Part(0, 0), bits: Part(0, 0) }, // Filter constant input bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(3, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2910, 35), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(1), unit: Part(0, 0), bits: Part(0, 0) }, // Interrupt mask input bit any change
    EntryRow { first: 2, last: 128, mapping: Some(No), need: Optional, name: Part(2910, 35), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(1), unit: Part(0, 0), bits: Part(0, 0) }, // Interrupt mask input bit any change
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(3, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(3010, 36), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(3), unit: Part(0, 0), bits: Part(0, 0) }, // Interrupt mask input bit low-to-high
    EntryRow { first: 2, last: 128, mapping: Some(No), need: Optional, name: Part(3010, 36), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(3), unit: Part(0, 0), bits: Part(0, 0) }, // Interrupt mask input bit low-to-high
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(3, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(3119, 36), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(3), unit: Part(0, 0), bits: Part(0, 0) }, // Interrupt mask input bit high-to-low
    EntryRow { first: 2, last: 128, mapping: Some(No), need: Optional, name: Part(3119, 36), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(3), unit: Part(0, 0), bits: Part(0, 0) }, // Interrupt mask input bit high-to-low
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(3228, 17), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Read input 16-bit
    EntryRow { first: 2, last: 254, mapping: Some(Tpdo), need: Optional, name: Part(3228, 17), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Read input 16-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(3293, 21), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Polarity input 16-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(3293, 21), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Polarity input 16-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(3353, 28), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Filter constant input 16-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(3353, 28), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Filter constant input 16-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(3426, 32), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(4), unit: Part(0, 0), bits: Part(0, 0) }, // Interrupt mask any change 16-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(3426, 32), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(4), unit: Part(0, 0), bits: Part(0, 0) }, // Interrupt mask any change 16-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(3522, 33), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Interrupt mask low-to-high 16-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(3522, 33), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Interrupt mask low-to-high 16-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(3627, 33), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Interrupt mask high-to-low 16-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(3627, 33), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Interrupt mask high-to-low 16-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(3732, 17), data_types: Part(5, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Read input 32-bit
    EntryRow { first: 2, last: 254, mapping: Some(Tpdo), need: Optional, name: Part(3732, 17), data_types: Part(5, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Read input 32-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(3797, 21), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Polarity input 32-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(3797, 21), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Polarity input 32-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(3857, 28), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Filter constant input 32-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(3857, 28), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Filter constant input 32-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(3930, 32), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(5), unit: Part(0, 0), bits: Part(0, 0) }, // Interrupt mask any change 32-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(3930, 32), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(5), unit: Part(0, 0), bits: Part(0, 0) }, // Interrupt mask any change 32-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(4026, 33), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Interrupt mask low-to-high 32-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(4026, 33), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Interrupt mask low-to-high 32-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(4131, 33), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Interrupt mask high-to-low 32-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(4131, 33), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Interrupt mask high-to-low 32-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Rpdo), need: Mandatory, name: Part(4236, 18), data_types: Part(0, 1), access: Part(2, 2), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Write output 8-bit
    EntryRow { first: 2, last: 254, mapping: Some(Rpdo), need: Optional, name: Part(4236, 18), data_types: Part(0, 1), access: Part(2, 2), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Write output 8-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(4306, 28), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Change polarity output 8-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(4306, 28), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Change polarity output 8-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(4385, 23), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(2), unit: Part(0, 0), bits: Part(0, 0) }, // Error mode output 8-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(4385, 23), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(2), unit: Part(0, 0), bits: Part(0, 0) }, // Error mode output 8-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(4494, 24), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Error value output 8-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(4494, 24), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Error value output 8-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(4583, 24), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(2), unit: Part(0, 0), bits: Part(0, 0) }, // Filter mask output 8-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(4583, 24), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(2), unit: Part(0, 0), bits: Part(0, 0) }, // Filter mask output 8-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(3, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Rpdo), need: Mandatory, name: Part(4647, 16), data_types: Part(3, 1), access: Part(2, 2), values: Part(0, 0), default: Some(3), unit: Part(0, 0), bits: Part(0, 0) }, // Write output bit
    EntryRow { first: 2, last: 128, mapping: Some(Rpdo), need: Optional, name: Part(4647, 16), data_types: Part(3, 1), access: Part(2, 2), values: Part(0, 0), default: Some(3), unit: Part(0, 0), bits: Part(0, 0) }, // Write output bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(3, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(4705, 26), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(3), unit: Part(0, 0), bits: Part(0, 0) }, // Change polarity output bit
    EntryRow { first: 2, last: 128, mapping: Some(No), need: Optional, name: Part(4705, 26), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(3), unit: Part(0, 0), bits: Part(0, 0) }, // Change polarity output bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(3, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(4772, 21), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(1), unit: Part(0, 0), bits: Part(0, 0) }, // Error mode output bit
    EntryRow { first: 2, last: 128, mapping: Some(No), need: Optional, name: Part(4772, 21), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(1), unit: Part(0, 0), bits: Part(0, 0) }, // Error mode output bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(3, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(4878, 22), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(3), unit: Part(0, 0), bits: Part(0, 0) }, // Error value output bit
    EntryRow { first: 2, last: 128, mapping: Some(No), need: Optional, name: Part(4878, 22), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(3), unit: Part(0, 0), bits: Part(0, 0) }, // Error value output bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(3, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(4969, 22), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(1), unit: Part(0, 0), bits: Part(0, 0) }, // Filter mask output bit
    EntryRow { first: 2, last: 128, mapping: Some(No), need: Optional, name: Part(4969, 22), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(1), unit: Part(0, 0), bits: Part(0, 0) }, // Filter mask output bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Rpdo), need: Mandatory, name: Part(5033, 19), data_types: Part(4, 1), access: Part(2, 2), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Write output 16-bit
    EntryRow { first: 2, last: 254, mapping: Some(Rpdo), need: Optional, name: Part(5033, 19), data_types: Part(4, 1), access: Part(2, 2), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Write output 16-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(5093, 29), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Change polarity output 16-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(5093, 29), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Change polarity output 16-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(5162, 24), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(4), unit: Part(0, 0), bits: Part(0, 0) }, // Error mode output 16-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(5162, 24), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(4), unit: Part(0, 0), bits: Part(0, 0) }, // Error mode output 16-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(5261, 25), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Error value output 16-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(5261, 25), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Error value output 16-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(5352, 25), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(4), unit: Part(0, 0), bits: Part(0, 0) }, // Filter mask output 16-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(5352, 25), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(4), unit: Part(0, 0), bits: Part(0, 0) }, // Filter mask output 16-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Rpdo), need: Mandatory, name: Part(5418, 19), data_types: Part(5, 1), access: Part(2, 2), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Write output 32-bit
    EntryRow { first: 2, last: 254, mapping: Some(Rpdo), need: Optional, name: Part(5418, 19), data_types: Part(5, 1), access: Part(2, 2), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Write output 32-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(5478, 29), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Change polarity output 32-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(5478, 29), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Change polarity output 32-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(5547, 24), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(5), unit: Part(0, 0), bits: Part(0, 0) }, // Error mode output 32-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(5547, 24), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(5), unit: Part(0, 0), bits: Part(0, 0) }, // Error mode output 32-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(5646, 25), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Error value output 32-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(5646, 25), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Error value output 32-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(5737, 25), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(5), unit: Part(0, 0), bits: Part(0, 0) }, // Filter mask output 32-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(5737, 25), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(5), unit: Part(0, 0), bits: Part(0, 0) }, // Filter mask output 32-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(5803, 25), data_types: Part(6, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Read analogue input 8-bit
    EntryRow { first: 2, last: 254, mapping: Some(Tpdo), need: Optional, name: Part(5803, 25), data_types: Part(6, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Read analogue input 8-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(5896, 26), data_types: Part(7, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Read analogue input 16-bit
    EntryRow { first: 2, last: 254, mapping: Some(Tpdo), need: Optional, name: Part(5896, 26), data_types: Part(7, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Read analogue input 16-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(6003, 26), data_types: Part(8, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Read analogue input 32-bit
    EntryRow { first: 2, last: 254, mapping: Some(Tpdo), need: Optional, name: Part(6003, 26), data_types: Part(8, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Read analogue input 32-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(6098, 25), data_types: Part(9, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Read analogue input float
    EntryRow { first: 2, last: 254, mapping: Some(Tpdo), need: Optional, name: Part(6098, 25), data_types: Part(9, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Read analogue input float
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Rpdo), need: Mandatory, name: Part(6318, 27), data_types: Part(6, 1), access: Part(2, 2), values: Part(0, 0), default: Some(6), unit: Part(0, 0), bits: Part(0, 0) }, // Write analogue output 8-bit
    EntryRow { first: 2, last: 254, mapping: Some(Rpdo), need: Optional, name: Part(6318, 27), data_types: Part(6, 1), access: Part(2, 2), values: Part(0, 0), default: Some(6), unit: Part(0, 0), bits: Part(0, 0) }, // Write analogue output 8-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Rpdo), need: Mandatory, name: Part(6405, 28), data_types: Part(7, 1), access: Part(2, 2), values: Part(0, 0), default: Some(6), unit: Part(0, 0), bits: Part(0, 0) }, // Write analogue output 16-bit
    EntryRow { first: 2, last: 254, mapping: Some(Rpdo), need: Optional, name: Part(6405, 28), data_types: Part(7, 1), access: Part(2, 2), values: Part(0, 0), default: Some(6), unit: Part(0, 0), bits: Part(0, 0) }, // Write analogue output 16-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Rpdo), need: Mandatory, name: Part(6507, 28), data_types: Part(8, 1), access: Part(2, 2), values: Part(0, 0), default: Some(6), unit: Part(0, 0), bits: Part(0, 0) }, // Write analogue output 32-bit
    EntryRow { first: 2, last: 254, mapping: Some(Rpdo), need: Optional, name: Part(6507, 28), data_types: Part(8, 1), access: Part(2, 2), values: Part(0, 0), default: Some(6), unit: Part(0, 0), bits: Part(0, 0) }, // Write analogue output 32-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Rpdo), need: Mandatory, name: Part(6596, 27), data_types: Part(9, 1), access: Part(2, 2), values: Part(0, 0), default: Some(7), unit: Part(0, 0), bits: Part(0, 0) }, // Write analogue output float
    EntryRow { first: 2, last: 254, mapping: Some(Rpdo), need: Optional, name: Part(6596, 27), data_types: Part(9, 1), access: Part(2, 2), values: Part(0, 0), default: Some(7), unit: Part(0, 0), bits: Part(0, 0) }, // Write analogue output float
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(6804, 42), data_types: Part(0, 1), access: Part(1, 1), values: Part(4, 1), default: Some(8), unit: Part(0, 0), bits: Part(7, 5) }, // Analogue input interrupt trigger selection
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(6804, 42), data_types: Part(0, 1), access: Part(1, 1), values: Part(4, 1), default: Some(8), unit: Part(0, 0), bits: Part(7, 5) }, // Analogue input interrupt trigger selection
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(5, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(7050, 31), data_types: Part(5, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input interrupt source
    EntryRow { first: 2, last: 8, mapping: None, need: Optional, name: Part(7050, 31), data_types: Part(5, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input interrupt source
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(1, 2), access: Part(1, 1), values: Part(0, 0), default: Some(3), unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(7269, 44), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input interrupt upper limit integer
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(7269, 44), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input interrupt upper limit integer
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(7379, 44), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input interrupt lower limit integer
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(7379, 44), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input interrupt lower limit integer
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(7489, 39), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input interrupt delta unsigned
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(7489, 39), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input interrupt delta unsigned
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(7610, 48), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input interrupt negative delta unsigned
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(7610, 48), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input interrupt negative delta unsigned
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(7739, 48), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input interrupt positive delta unsigned
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(7739, 48), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input interrupt positive delta unsigned
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(7867, 42), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input interrupt upper limit float
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(7867, 42), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input interrupt upper limit float
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(7961, 42), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input interrupt lower limit float
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(7961, 42), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input interrupt lower limit float
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(8055, 36), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input interrupt delta float
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(8055, 36), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input interrupt delta float
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(8138, 45), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input interrupt negative delta float
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(8138, 45), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input interrupt negative delta float
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(8228, 45), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input interrupt positive delta float
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(8228, 45), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input interrupt positive delta float
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(8318, 27), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: Some(7), unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input offset float
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(8318, 27), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: Some(7), unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input offset float
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(8420, 28), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: Some(9), unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input scaling float
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(8420, 28), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: Some(9), unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input scaling float
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(8523, 22), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input SI unit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(8523, 22), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input SI unit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(8575, 29), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: Some(6), unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input offset integer
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(8575, 29), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: Some(6), unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input offset integer
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(8666, 30), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: Some(10), unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input scaling integer
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(8666, 30), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: Some(10), unit: Part(0, 0), bits: Part(0, 0) }, // Analogue input scaling integer
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(8758, 28), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: Some(7), unit: Part(0, 0), bits: Part(0, 0) }, // Analogue output offset float
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(8758, 28), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: Some(7), unit: Part(0, 0), bits: Part(0, 0) }, // Analogue output offset float
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(8862, 29), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: Some(9), unit: Part(0, 0), bits: Part(0, 0) }, // Analogue output scaling float
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(8862, 29), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: Some(9), unit: Part(0, 0), bits: Part(0, 0) }, // Analogue output scaling float
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(8967, 26), data_types: Part(0, 1), access: Part(1, 1), values: Part(6, 2), default: Some(11), unit: Part(0, 0), bits: Part(12, 1) }, // Analogue output error mode
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(8967, 26), data_types: Part(0, 1), access: Part(1, 1), values: Part(6, 2), default: Some(11), unit: Part(0, 0), bits: Part(12, 1) }, // Analogue output error mode
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(9121, 35), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: Some(6), unit: Part(0, 0), bits: Part(0, 0) }, // Analogue output error value integer
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(9121, 35), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: Some(6), unit: Part(0, 0), bits: Part(0, 0) }, // Analogue output error value integer
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(9232, 33), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: Some(7), unit: Part(0, 0), bits: Part(0, 0) }, // Analogue output error value float
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(9232, 33), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: Some(7), unit: Part(0, 0), bits: Part(0, 0) }, // Analogue output error value float
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(9354, 30), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: Some(6), unit: Part(0, 0), bits: Part(0, 0) }, // Analogue output offset integer
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(9354, 30), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: Some(6), unit: Part(0, 0), bits: Part(0, 0) }, // Analogue output offset integer
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(9447, 31), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: Some(10), unit: Part(0, 0), bits: Part(0, 0) }, // Analogue output scaling integer
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(9447, 31), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: Some(10), unit: Part(0, 0), bits: Part(0, 0) }, // Analogue output scaling integer
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(2087, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(9541, 23), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Analogue output SI unit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(9541, 23), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // Analogue output SI unit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(5, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 7) },
];

static BITS: &[BitRow] = &[
    BitRow { first: 0, last: 15, name: Part(0, 21), values: Part(0, 0) }, // device profile number
    BitRow { first: 16, last: 16, name: Part(21, 14), values: Part(0, 0) }, // digital inputs
    BitRow { first: 17, last: 17, name: Part(35, 15), values: Part(0, 0) }, // digital outputs
    BitRow { first: 18, last: 18, name: Part(50, 15), values: Part(0, 0) }, // analogue inputs
    BitRow { first: 19, last: 19, name: Part(65, 16), values: Part(0, 0) }, // analogue outputs
    BitRow { first: 23, last: 23, name: Part(81, 11), values: Part(0, 2) }, // PDO mapping
    BitRow { first: 24, last: 24, name: Part(132, 8), values: Part(0, 0) }, // joystick
    BitRow { first: 0, last: 0, name: Part(6846, 20), values: Part(0, 0) }, // upper limit exceeded
    BitRow { first: 1, last: 1, name: Part(6866, 17), values: Part(0, 0) }, // below lower limit
    BitRow { first: 2, last: 2, name: Part(6883, 26), values: Part(0, 0) }, // changed by more than delta
    BitRow { first: 3, last: 3, name: Part(6909, 35), values: Part(0, 0) }, // reduced by more than negative delta
    BitRow { first: 4, last: 4, name: Part(6944, 37), values: Part(0, 0) }, // increased by more than positive delta
    BitRow { first: 0, last: 7, name: Part(8993, 11), values: Part(2, 2) }, // on an error
];

static MEANINGS: &[MeaningRow] = &[
    MeaningRow { first: 0, last: 0, text: Part(92, 21) }, // as the profile has it
    MeaningRow { first: 1, last: 1, text: Part(113, 19) }, // of the manufacturer
    MeaningRow { first: 0, last: 0, text: Part(9004, 14) }, // keep the value
    MeaningRow { first: 1, last: 1, text: Part(9018, 20) }, // take the error value
];

static COMMANDS: &[CommandRow] = &[
];

static TRANSITIONS: &[TransitionRow] = &[
];

static CONDITIONS: &[Condition] = &[
    Condition::constant("1000h[17] and not 1000h[23]", &[All(2), BitsIn(4096, 0, [17, 17], 1), Range(1, 170141183460469231731687303715884105727), Not, BitsIn(4096, 0, [23, 23], 1), Range(1, 170141183460469231731687303715884105727)]),
    Condition::constant("1000h[19] and not 1000h[23]", &[All(2), BitsIn(4096, 0, [19, 19], 1), Range(1, 170141183460469231731687303715884105727), Not, BitsIn(4096, 0, [23, 23], 1), Range(1, 170141183460469231731687303715884105727)]),
    Condition::constant("6411h:0 > 4 and not 1000h[23]", &[All(2), ValueIn(25617, 0, 1), Range(5, 170141183460469231731687303715884105727), Not, BitsIn(4096, 0, [23, 23], 1), Range(1, 170141183460469231731687303715884105727)]),
    Condition::constant("6411h:0 > 8 and not 1000h[23]", &[All(2), ValueIn(25617, 0, 1), Range(9, 170141183460469231731687303715884105727), Not, BitsIn(4096, 0, [23, 23], 1), Range(1, 170141183460469231731687303715884105727)]),
    Condition::constant("1000h[16] and not 1000h[23]", &[All(2), BitsIn(4096, 0, [16, 16], 1), Range(1, 170141183460469231731687303715884105727), Not, BitsIn(4096, 0, [23, 23], 1), Range(1, 170141183460469231731687303715884105727)]),
    Condition::constant("1000h[18] and not 1000h[23]", &[All(2), BitsIn(4096, 0, [18, 18], 1), Range(1, 170141183460469231731687303715884105727), Not, BitsIn(4096, 0, [23, 23], 1), Range(1, 170141183460469231731687303715884105727)]),
    Condition::constant("6401h:0 > 4 and not 1000h[23]", &[All(2), ValueIn(25601, 0, 1), Range(5, 170141183460469231731687303715884105727), Not, BitsIn(4096, 0, [23, 23], 1), Range(1, 170141183460469231731687303715884105727)]),
    Condition::constant("6401h:0 > 8 and not 1000h[23]", &[All(2), ValueIn(25601, 0, 1), Range(9, 170141183460469231731687303715884105727), Not, BitsIn(4096, 0, [23, 23], 1), Range(1, 170141183460469231731687303715884105727)]),
    Condition::constant("6100h or 6120h or 6020h", &[OneOf(3), Described(24832, None), Described(24864, None), Described(24608, None)]),
    Condition::constant("6300h or 6320h or 6220h", &[OneOf(3), Described(25344, None), Described(25376, None), Described(25120, None)]),
    Condition::constant("6400h or 6402h or 6403h or 6404h", &[OneOf(4), Described(25600, None), Described(25602, None), Described(25603, None), Described(25604, None)]),
    Condition::constant("6410h or 6412h or 6413h or 6414h", &[OneOf(4), Described(25616, None), Described(25618, None), Described(25619, None), Described(25620, None)]),
];

static OBJECT_TYPES: &[ObjectType] = &[Array, Record, Var];

static DATA_TYPES: &[DataType] = &[DataType(5), DataType(1), DataType(5), DataType(1), DataType(6), DataType(7), DataType(2), DataType(3), DataType(4), DataType(8)];

static ACCESS: &[Access] = &[Ro, Rw, Rww, Rw];

static VALUES: &[std::ops::RangeInclusive<i128>] = &[0..=2, 128..=255, 1..=254, 1..=128, 0..=31, 1..=8, 0..=0, 1..=1];

static DEFAULTS: &[Value] = &[Unsigned(0), Boolean(true), Unsigned(255), Boolean(false), Unsigned(65535), Unsigned(4294967295), Signed(0), Real32(0.0), Unsigned(7), Real32(1.0), Signed(1), Unsigned(1)];

static INDEXES: &[u16] = &[24576, 24608, 24832, 24864, 25088, 25120, 25344, 25376, 25601, 25600, 25602, 25603, 25604, 25617, 25616, 25618, 25619, 25620];

static TEXTS: &str = concat!(
    "device profile number", "digital inputs", "digital outputs", "analogue inputs", "analogue outputs",
    "PDO mapping", "as the profile has it", "of the manufacturer", "joystick", "Device type", "book 3.4.2.1",
    "Says that the device is an I/O module, and which kinds of inputs and outputs it has.",
    "Communication error", "Output error", "Input error", "Error behavior object", "errata sheet of version 2.0",
    "The NMT state that the device enters after a communication, output or input error.",
    "RPDO 1 communication parameter", "book 3.4.2.2",
    "When the device takes over its first received PDO, which carries digital outputs.",
    "RPDO 2 communication parameter",
    "When the device takes over its second received PDO, which carries analogue outputs 1 to 4.",
    "RPDO 3 communication parameter",
    "When the device takes over its third received PDO, which carries analogue outputs 5 to 8.",
    "RPDO 4 communication parameter",
    "When the device takes over its fourth received PDO, which carries analogue outputs 9 to 12.",
    "RPDO 1 mapping parameter", "Which objects the first received PDO is written to: digital outputs.",
    "RPDO 2 mapping parameter", "Which objects the second received PDO is written to: analogue outputs 1 to 4.",
    "RPDO 3 mapping parameter", "Which objects the third received PDO is written to: analogue outputs 5 to 8.",
    "RPDO 4 mapping parameter", "Which objects the fourth received PDO is written to: analogue outputs 9 to 12.",
    "TPDO 1 communication parameter", "book 3.4.2.3",
    "When the device sends its first PDO, which carries digital inputs.", "TPDO 2 communication parameter",
    "When the device sends its second PDO, which carries analogue inputs 1 to 4.",
    "TPDO 3 communication parameter",
    "When the device sends its third PDO, which carries analogue inputs 5 to 8.",
    "TPDO 4 communication parameter",
    "When the device sends its fourth PDO, which carries analogue inputs 9 to 12.", "TPDO 1 mapping parameter",
    "Which objects the first sent PDO carries: digital inputs.", "TPDO 2 mapping parameter",
    "Which objects the second sent PDO carries: analogue inputs 1 to 4.", "TPDO 3 mapping parameter",
    "Which objects the third sent PDO carries: analogue inputs 5 to 8.", "TPDO 4 mapping parameter",
    "Which objects the fourth sent PDO carries: analogue inputs 9 to 12.", "Read input 8-bit",
    "Highest sub-index supported", "book 3.4.2.4", "The state of the digital inputs, 8 a sub-index.",
    "Polarity input 8-bit", "book 3.4.2.5", "Inverts digital inputs, 8 a sub-index.",
    "Filter constant input 8-bit", "databases", "Switches the input filter on, 8 a sub-index.",
    "Global interrupt enable digital", "Switches messages of digital inputs on and off, for all of them.",
    "Interrupt mask any change 8-bit", "Which inputs trigger a message when they change, 8 a sub-index.",
    "Interrupt mask low-to-high 8-bit",
    "Which inputs trigger a message when they go from 0 to 1, 8 a sub-index.",
    "Interrupt mask high-to-low 8-bit",
    "Which inputs trigger a message when they go from 1 to 0, 8 a sub-index.", "Read input bit",
    "The state of the digital inputs, one a sub-index.", "Polarity input bit",
    "Inverts digital inputs, one a sub-index.", "Filter constant input bit",
    "Switches the input filter on, one a sub-index.", "Interrupt mask input bit any change",
    "Which inputs trigger a message when they change, one a sub-index.", "Interrupt mask input bit low-to-high",
    "Which inputs trigger a message when they go from 0 to 1, one a sub-index.",
    "Interrupt mask input bit high-to-low",
    "Which inputs trigger a message when they go from 1 to 0, one a sub-index.", "Read input 16-bit",
    "The state of the digital inputs, 16 a sub-index.", "Polarity input 16-bit",
    "Inverts digital inputs, 16 a sub-index.", "Filter constant input 16-bit",
    "Switches the input filter on, 16 a sub-index.", "Interrupt mask any change 16-bit",
    "Which inputs trigger a message when they change, 16 a sub-index.", "Interrupt mask low-to-high 16-bit",
    "Which inputs trigger a message when they go from 0 to 1, 16 a sub-index.",
    "Interrupt mask high-to-low 16-bit",
    "Which inputs trigger a message when they go from 1 to 0, 16 a sub-index.", "Read input 32-bit",
    "The state of the digital inputs, 32 a sub-index.", "Polarity input 32-bit",
    "Inverts digital inputs, 32 a sub-index.", "Filter constant input 32-bit",
    "Switches the input filter on, 32 a sub-index.", "Interrupt mask any change 32-bit",
    "Which inputs trigger a message when they change, 32 a sub-index.", "Interrupt mask low-to-high 32-bit",
    "Which inputs trigger a message when they go from 0 to 1, 32 a sub-index.",
    "Interrupt mask high-to-low 32-bit",
    "Which inputs trigger a message when they go from 1 to 0, 32 a sub-index.", "Write output 8-bit",
    "book 3.4.2.6", "Sets the digital outputs, 8 a sub-index.", "Change polarity output 8-bit", "book 3.4.2.7",
    "Inverts digital outputs, 8 a sub-index.", "Error mode output 8-bit", "book 3.4.2.8",
    "Which outputs take the state of 6207h when an error occurs, 8 a sub-index.", "Error value output 8-bit",
    "The states that outputs take when an error occurs, 8 a sub-index.", "Filter mask output 8-bit",
    "Which outputs may be set, 8 a sub-index.", "Write output bit", "Sets the digital outputs, one a sub-index.",
    "Change polarity output bit", "Inverts digital outputs, one a sub-index.", "Error mode output bit",
    "Which outputs take the value of 6260h to 6267h when an error occurs, one a sub-index.",
    "Error value output bit", "The state that an output takes when an error occurs, one a sub-index.",
    "Filter mask output bit", "Which outputs may be set, one a sub-index.", "Write output 16-bit",
    "Sets the digital outputs, 16 a sub-index.", "Change polarity output 16-bit",
    "Inverts digital outputs, 16 a sub-index.", "Error mode output 16-bit",
    "Which outputs take the state of 6307h when an error occurs, 16 a sub-index.", "Error value output 16-bit",
    "The states that outputs take when an error occurs, 16 a sub-index.", "Filter mask output 16-bit",
    "Which outputs may be set, 16 a sub-index.", "Write output 32-bit",
    "Sets the digital outputs, 32 a sub-index.", "Change polarity output 32-bit",
    "Inverts digital outputs, 32 a sub-index.", "Error mode output 32-bit",
    "Which outputs take the state of 6327h when an error occurs, 32 a sub-index.", "Error value output 32-bit",
    "The states that outputs take when an error occurs, 32 a sub-index.", "Filter mask output 32-bit",
    "Which outputs may be set, 32 a sub-index.", "Read analogue input 8-bit",
    "The values of the analogue inputs as 8-bit numbers, one a sub-index.", "Read analogue input 16-bit",
    "book 3.4.2.9", "The values of the analogue inputs as 16-bit numbers, one a sub-index.",
    "Read analogue input 32-bit", "The values of the analogue inputs as 32-bit numbers, one a sub-index.",
    "Read analogue input float", "The values of the analogue inputs as floating-point numbers, one a sub-index.",
    "Read manufacturer specific analogue input",
    "The values of the analogue inputs in a format of the vendor, one a sub-index.",
    "Write analogue output 8-bit", "Sets the analogue outputs as 8-bit numbers, one a sub-index.",
    "Write analogue output 16-bit", "book 3.4.2.10",
    "Sets the analogue outputs as 16-bit numbers, one a sub-index.", "Write analogue output 32-bit",
    "Sets the analogue outputs as 32-bit numbers, one a sub-index.", "Write analogue output float",
    "Sets the analogue outputs as floating-point numbers, one a sub-index.",
    "Write manufacturer specific analogue output",
    "Sets the analogue outputs in a format of the vendor, one a sub-index.",
    "Analogue input interrupt trigger selection", "upper limit exceeded", "below lower limit",
    "changed by more than delta", "reduced by more than negative delta", "increased by more than positive delta",
    "Which events of an analogue input trigger a message: limits, changes.", "Analogue input interrupt source",
    "Which analogue inputs have triggered a message since the last read, one bit an input.",
    "Analogue input global interrupt enable",
    "Switches messages of analogue inputs on and off, for all of them.",
    "Analogue input interrupt upper limit integer",
    "An analogue input triggers a message when its value is above this.",
    "Analogue input interrupt lower limit integer",
    "An analogue input triggers a message when its value is below this.",
    "Analogue input interrupt delta unsigned",
    "An analogue input triggers a message when its value has changed by more than this.",
    "Analogue input interrupt negative delta unsigned",
    "An analogue input triggers a message when its value has fallen by more than this.",
    "Analogue input interrupt positive delta unsigned",
    "An analogue input triggers a message when its value has risen by more than this.",
    "Analogue input interrupt upper limit float", "The upper limit of 6424h as a floating-point number.",
    "Analogue input interrupt lower limit float", "The lower limit of 6425h as a floating-point number.",
    "Analogue input interrupt delta float", "The change of 6426h as a floating-point number.",
    "Analogue input interrupt negative delta float", "The fall of 6427h as a floating-point number.",
    "Analogue input interrupt positive delta float", "The rise of 6428h as a floating-point number.",
    "Analogue input offset float", "Added to the scaled value of an analogue input, as a floating-point number.",
    "Analogue input scaling float",
    "Multiplied with the value of an analogue input, as a floating-point number.", "Analogue input SI unit",
    "The unit of an analogue input.", "Analogue input offset integer",
    "Added to the scaled value of an analogue input, as an integer.", "Analogue input scaling integer",
    "Multiplied with the value of an analogue input, as an integer.", "Analogue output offset float",
    "Added to the scaled value of an analogue output, as a floating-point number.",
    "Analogue output scaling float",
    "Multiplied with the value of an analogue output, as a floating-point number.", "Analogue output error mode",
    "on an error", "keep the value", "take the error value", "book 3.4.2.11",
    "Whether an analogue output takes its error value when an error occurs.",
    "Analogue output error value integer",
    "The value that an analogue output takes when an error occurs, as an integer.",
    "Analogue output error value float",
    "The value that an analogue output takes when an error occurs, as a floating-point number.",
    "Analogue output offset integer", "Added to the scaled value of an analogue output, as an integer.",
    "Analogue output scaling integer", "Multiplied with the value of an analogue output, as an integer.",
    "Analogue output SI unit", "The unit of an analogue output.", "CiA 301 §7.4.1",
    "The device type of this logical device: an I/O module, and which kinds of inputs and outputs it has.",
);
