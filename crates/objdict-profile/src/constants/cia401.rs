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
        errors: SubList(0, 0),
        machine: None,
    },
};

static OBJECTS: &[ObjectRow] = table!(ObjectRow { first, last, name, object_types, need, only, as_many_as, entries, source, about, confidence }:
    (4096, 4096, SubList(140, 11), SubList(0, 0), Optional, None, SubList(0, 0), SubList(0, 1), SubList(151, 12), SubList(163, 84), High) // 1000h Device type
    (4137, 4137, SubList(289, 21), SubList(0, 0), Optional, None, SubList(0, 0), SubList(1, 3), SubList(310, 27), SubList(337, 82), High) // 1029h Error behavior object
    (5120, 5120, SubList(419, 30), SubList(0, 0), When(0), None, SubList(0, 0), SubList(0, 0), SubList(449, 12), SubList(461, 81), High) // 1400h RPDO 1 communication parameter
    (5121, 5121, SubList(542, 30), SubList(0, 0), When(1), None, SubList(0, 0), SubList(0, 0), SubList(449, 12), SubList(572, 90), High) // 1401h RPDO 2 communication parameter
    (5122, 5122, SubList(662, 30), SubList(0, 0), When(2), None, SubList(0, 0), SubList(0, 0), SubList(449, 12), SubList(692, 89), High) // 1402h RPDO 3 communication parameter
    (5123, 5123, SubList(781, 30), SubList(0, 0), When(3), None, SubList(0, 0), SubList(0, 0), SubList(449, 12), SubList(811, 91), High) // 1403h RPDO 4 communication parameter
    (5632, 5632, SubList(902, 24), SubList(0, 0), When(0), None, SubList(0, 0), SubList(0, 0), SubList(449, 12), SubList(926, 68), High) // 1600h RPDO 1 mapping parameter
    (5633, 5633, SubList(994, 24), SubList(0, 0), When(1), None, SubList(0, 0), SubList(0, 0), SubList(449, 12), SubList(1018, 77), High) // 1601h RPDO 2 mapping parameter
    (5634, 5634, SubList(1095, 24), SubList(0, 0), When(2), None, SubList(0, 0), SubList(0, 0), SubList(449, 12), SubList(1119, 76), High) // 1602h RPDO 3 mapping parameter
    (5635, 5635, SubList(1195, 24), SubList(0, 0), When(3), None, SubList(0, 0), SubList(0, 0), SubList(449, 12), SubList(1219, 78), High) // 1603h RPDO 4 mapping parameter
    (6144, 6144, SubList(1297, 30), SubList(0, 0), When(4), None, SubList(0, 0), SubList(0, 0), SubList(1327, 12), SubList(1339, 66), High) // 1800h TPDO 1 communication parameter
    (6145, 6145, SubList(1405, 30), SubList(0, 0), When(5), None, SubList(0, 0), SubList(0, 0), SubList(1327, 12), SubList(1435, 75), High) // 1801h TPDO 2 communication parameter
    (6146, 6146, SubList(1510, 30), SubList(0, 0), When(6), None, SubList(0, 0), SubList(0, 0), SubList(1327, 12), SubList(1540, 74), High) // 1802h TPDO 3 communication parameter
    (6147, 6147, SubList(1614, 30), SubList(0, 0), When(7), None, SubList(0, 0), SubList(0, 0), SubList(1327, 12), SubList(1644, 76), High) // 1803h TPDO 4 communication parameter
    (6656, 6656, SubList(1720, 24), SubList(0, 0), When(4), None, SubList(0, 0), SubList(0, 0), SubList(1327, 12), SubList(1744, 57), High) // 1A00h TPDO 1 mapping parameter
    (6657, 6657, SubList(1801, 24), SubList(0, 0), When(5), None, SubList(0, 0), SubList(0, 0), SubList(1327, 12), SubList(1825, 66), High) // 1A01h TPDO 2 mapping parameter
    (6658, 6658, SubList(1891, 24), SubList(0, 0), When(6), None, SubList(0, 0), SubList(0, 0), SubList(1327, 12), SubList(1915, 65), High) // 1A02h TPDO 3 mapping parameter
    (6659, 6659, SubList(1980, 24), SubList(0, 0), When(7), None, SubList(0, 0), SubList(0, 0), SubList(1327, 12), SubList(2004, 67), High) // 1A03h TPDO 4 mapping parameter
    (24576, 24576, SubList(2071, 16), SubList(0, 2), When(8), None, SubList(0, 0), SubList(4, 3), SubList(2114, 12), SubList(2126, 47), High) // 6000h Read input 8-bit
    (24578, 24578, SubList(2173, 20), SubList(0, 2), Optional, None, SubList(0, 1), SubList(7, 3), SubList(2193, 12), SubList(2205, 38), High) // 6002h Polarity input 8-bit
    (24579, 24579, SubList(2243, 27), SubList(0, 2), Optional, None, SubList(0, 1), SubList(10, 3), SubList(2270, 9), SubList(2279, 44), High) // 6003h Filter constant input 8-bit
    (24581, 24581, SubList(2323, 31), SubList(2, 1), Optional, None, SubList(0, 0), SubList(13, 1), SubList(2270, 9), SubList(2354, 64), High) // 6005h Global interrupt enable digital
    (24582, 24582, SubList(2418, 31), SubList(0, 2), Optional, None, SubList(0, 1), SubList(14, 3), SubList(2270, 9), SubList(2449, 63), High) // 6006h Interrupt mask any change 8-bit
    (24583, 24583, SubList(2512, 32), SubList(0, 2), Optional, None, SubList(0, 1), SubList(17, 3), SubList(2270, 9), SubList(2544, 71), High) // 6007h Interrupt mask low-to-high 8-bit
    (24584, 24584, SubList(2615, 32), SubList(0, 2), Optional, None, SubList(0, 1), SubList(20, 3), SubList(2270, 9), SubList(2647, 71), High) // 6008h Interrupt mask high-to-low 8-bit
    (24608, 24615, SubList(2718, 14), SubList(0, 2), Optional, None, SubList(0, 0), SubList(23, 3), SubList(2270, 9), SubList(2732, 49), High) // 6020h Read input bit
    (24624, 24631, SubList(2781, 18), SubList(0, 2), Optional, None, SubList(1, 1), SubList(26, 3), SubList(2270, 9), SubList(2799, 40), High) // 6030h Polarity input bit
    (24632, 24639, SubList(2839, 25), SubList(0, 2), Optional, None, SubList(1, 1), SubList(29, 3), SubList(2270, 9), SubList(2864, 46), High) // 6038h Filter constant input bit
    (24656, 24663, SubList(2910, 35), SubList(0, 2), Optional, None, SubList(1, 1), SubList(32, 3), SubList(2270, 9), SubList(2945, 65), High) // 6050h Interrupt mask input bit any change
    (24672, 24679, SubList(3010, 36), SubList(0, 2), Optional, None, SubList(1, 1), SubList(35, 3), SubList(2270, 9), SubList(3046, 73), High) // 6060h Interrupt mask input bit low-to-high
    (24688, 24695, SubList(3119, 36), SubList(0, 2), Optional, None, SubList(1, 1), SubList(38, 3), SubList(2270, 9), SubList(3155, 73), High) // 6070h Interrupt mask input bit high-to-low
    (24832, 24832, SubList(3228, 17), SubList(0, 2), Optional, None, SubList(0, 0), SubList(41, 3), SubList(2270, 9), SubList(3245, 48), High) // 6100h Read input 16-bit
    (24834, 24834, SubList(3293, 21), SubList(0, 2), Optional, None, SubList(2, 1), SubList(44, 3), SubList(2270, 9), SubList(3314, 39), High) // 6102h Polarity input 16-bit
    (24835, 24835, SubList(3353, 28), SubList(0, 2), Optional, None, SubList(2, 1), SubList(47, 3), SubList(2270, 9), SubList(3381, 45), High) // 6103h Filter constant input 16-bit
    (24838, 24838, SubList(3426, 32), SubList(0, 2), Optional, None, SubList(2, 1), SubList(50, 3), SubList(2270, 9), SubList(3458, 64), High) // 6106h Interrupt mask any change 16-bit
    (24839, 24839, SubList(3522, 33), SubList(0, 2), Optional, None, SubList(2, 1), SubList(53, 3), SubList(2270, 9), SubList(3555, 72), High) // 6107h Interrupt mask low-to-high 16-bit
    (24840, 24840, SubList(3627, 33), SubList(0, 2), Optional, None, SubList(2, 1), SubList(56, 3), SubList(2270, 9), SubList(3660, 72), High) // 6108h Interrupt mask high-to-low 16-bit
    (24864, 24864, SubList(3732, 17), SubList(0, 2), Optional, None, SubList(0, 0), SubList(59, 3), SubList(2270, 9), SubList(3749, 48), High) // 6120h Read input 32-bit
    (24866, 24866, SubList(3797, 21), SubList(0, 2), Optional, None, SubList(3, 1), SubList(62, 3), SubList(2270, 9), SubList(3818, 39), High) // 6122h Polarity input 32-bit
    (24867, 24867, SubList(3857, 28), SubList(0, 2), Optional, None, SubList(3, 1), SubList(65, 3), SubList(2270, 9), SubList(3885, 45), High) // 6123h Filter constant input 32-bit
    (24870, 24870, SubList(3930, 32), SubList(0, 2), Optional, None, SubList(3, 1), SubList(68, 3), SubList(2270, 9), SubList(3962, 64), High) // 6126h Interrupt mask any change 32-bit
    (24871, 24871, SubList(4026, 33), SubList(0, 2), Optional, None, SubList(3, 1), SubList(71, 3), SubList(2270, 9), SubList(4059, 72), High) // 6127h Interrupt mask low-to-high 32-bit
    (24872, 24872, SubList(4131, 33), SubList(0, 2), Optional, None, SubList(3, 1), SubList(74, 3), SubList(2270, 9), SubList(4164, 72), High) // 6128h Interrupt mask high-to-low 32-bit
    (25088, 25088, SubList(4236, 18), SubList(0, 2), When(9), None, SubList(0, 0), SubList(77, 3), SubList(4254, 12), SubList(4266, 40), High) // 6200h Write output 8-bit
    (25090, 25090, SubList(4306, 28), SubList(0, 2), Optional, None, SubList(4, 1), SubList(80, 3), SubList(4334, 12), SubList(4346, 39), High) // 6202h Change polarity output 8-bit
    (25094, 25094, SubList(4385, 23), SubList(0, 2), Optional, None, SubList(4, 1), SubList(83, 3), SubList(4408, 12), SubList(4420, 74), High) // 6206h Error mode output 8-bit
    (25095, 25095, SubList(4494, 24), SubList(0, 2), Optional, None, SubList(4, 1), SubList(86, 3), SubList(4408, 12), SubList(4518, 65), High) // 6207h Error value output 8-bit
    (25096, 25096, SubList(4583, 24), SubList(0, 2), Optional, None, SubList(4, 1), SubList(89, 3), SubList(2270, 9), SubList(4607, 40), High) // 6208h Filter mask output 8-bit
    (25120, 25127, SubList(4647, 16), SubList(0, 2), Optional, None, SubList(0, 0), SubList(92, 3), SubList(2270, 9), SubList(4663, 42), High) // 6220h Write output bit
    (25152, 25159, SubList(4705, 26), SubList(0, 2), Optional, None, SubList(5, 1), SubList(95, 3), SubList(2270, 9), SubList(4731, 41), High) // 6240h Change polarity output bit
    (25168, 25175, SubList(4772, 21), SubList(0, 2), Optional, None, SubList(5, 1), SubList(98, 3), SubList(2270, 9), SubList(4793, 85), High) // 6250h Error mode output bit
    (25184, 25191, SubList(4878, 22), SubList(0, 2), Optional, None, SubList(5, 1), SubList(101, 3), SubList(2270, 9), SubList(4900, 69), High) // 6260h Error value output bit
    (25200, 25207, SubList(4969, 22), SubList(0, 2), Optional, None, SubList(5, 1), SubList(104, 3), SubList(2270, 9), SubList(4991, 42), High) // 6270h Filter mask output bit
    (25344, 25344, SubList(5033, 19), SubList(0, 2), Optional, None, SubList(0, 0), SubList(107, 3), SubList(2270, 9), SubList(5052, 41), High) // 6300h Write output 16-bit
    (25346, 25346, SubList(5093, 29), SubList(0, 2), Optional, None, SubList(6, 1), SubList(110, 3), SubList(2270, 9), SubList(5122, 40), High) // 6302h Change polarity output 16-bit
    (25350, 25350, SubList(5162, 24), SubList(0, 2), Optional, None, SubList(6, 1), SubList(113, 3), SubList(2270, 9), SubList(5186, 75), High) // 6306h Error mode output 16-bit
    (25351, 25351, SubList(5261, 25), SubList(0, 2), Optional, None, SubList(6, 1), SubList(116, 3), SubList(2270, 9), SubList(5286, 66), High) // 6307h Error value output 16-bit
    (25352, 25352, SubList(5352, 25), SubList(0, 2), Optional, None, SubList(6, 1), SubList(119, 3), SubList(2270, 9), SubList(5377, 41), High) // 6308h Filter mask output 16-bit
    (25376, 25376, SubList(5418, 19), SubList(0, 2), Optional, None, SubList(0, 0), SubList(122, 3), SubList(2270, 9), SubList(5437, 41), High) // 6320h Write output 32-bit
    (25378, 25378, SubList(5478, 29), SubList(0, 2), Optional, None, SubList(7, 1), SubList(125, 3), SubList(2270, 9), SubList(5507, 40), High) // 6322h Change polarity output 32-bit
    (25382, 25382, SubList(5547, 24), SubList(0, 2), Optional, None, SubList(7, 1), SubList(128, 3), SubList(2270, 9), SubList(5571, 75), High) // 6326h Error mode output 32-bit
    (25383, 25383, SubList(5646, 25), SubList(0, 2), Optional, None, SubList(7, 1), SubList(131, 3), SubList(2270, 9), SubList(5671, 66), High) // 6327h Error value output 32-bit
    (25384, 25384, SubList(5737, 25), SubList(0, 2), Optional, None, SubList(7, 1), SubList(134, 3), SubList(2270, 9), SubList(5762, 41), High) // 6328h Filter mask output 32-bit
    (25600, 25600, SubList(5803, 25), SubList(0, 2), Optional, None, SubList(0, 0), SubList(137, 3), SubList(2270, 9), SubList(5828, 68), High) // 6400h Read analogue input 8-bit
    (25601, 25601, SubList(5896, 26), SubList(0, 2), When(10), None, SubList(0, 0), SubList(140, 3), SubList(5922, 12), SubList(5934, 69), High) // 6401h Read analogue input 16-bit
    (25602, 25602, SubList(6003, 26), SubList(0, 2), Optional, None, SubList(0, 0), SubList(143, 3), SubList(2270, 9), SubList(6029, 69), High) // 6402h Read analogue input 32-bit
    (25603, 25603, SubList(6098, 25), SubList(0, 2), Optional, None, SubList(0, 0), SubList(146, 3), SubList(2270, 9), SubList(6123, 77), High) // 6403h Read analogue input float
    (25604, 25604, SubList(6200, 41), SubList(0, 0), Optional, None, SubList(0, 0), SubList(0, 0), SubList(2270, 9), SubList(6241, 77), Medium) // 6404h Read manufacturer specific analogue input
    (25616, 25616, SubList(6318, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(149, 3), SubList(2270, 9), SubList(6345, 60), High) // 6410h Write analogue output 8-bit
    (25617, 25617, SubList(6405, 28), SubList(0, 2), When(11), None, SubList(0, 0), SubList(152, 3), SubList(6433, 13), SubList(6446, 61), High) // 6411h Write analogue output 16-bit
    (25618, 25618, SubList(6507, 28), SubList(0, 2), Optional, None, SubList(0, 0), SubList(155, 3), SubList(2270, 9), SubList(6535, 61), High) // 6412h Write analogue output 32-bit
    (25619, 25619, SubList(6596, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(158, 3), SubList(2270, 9), SubList(6623, 69), High) // 6413h Write analogue output float
    (25620, 25620, SubList(6692, 43), SubList(0, 0), Optional, None, SubList(0, 0), SubList(0, 0), SubList(2270, 9), SubList(6735, 69), Medium) // 6414h Write manufacturer specific analogue output
    (25633, 25633, SubList(6804, 42), SubList(0, 2), Optional, None, SubList(8, 5), SubList(161, 3), SubList(2270, 9), SubList(6981, 69), High) // 6421h Analogue input interrupt trigger selection
    (25634, 25634, SubList(7050, 31), SubList(0, 2), Optional, None, SubList(0, 0), SubList(164, 3), SubList(2270, 9), SubList(7081, 85), High) // 6422h Analogue input interrupt source
    (25635, 25635, SubList(7166, 38), SubList(2, 1), When(12), None, SubList(0, 0), SubList(167, 1), SubList(2270, 9), SubList(7204, 65), Medium) // 6423h Analogue input global interrupt enable
    (25636, 25636, SubList(7269, 44), SubList(0, 2), Optional, None, SubList(8, 5), SubList(168, 3), SubList(2270, 9), SubList(7313, 66), High) // 6424h Analogue input interrupt upper limit integer
    (25637, 25637, SubList(7379, 44), SubList(0, 2), Optional, None, SubList(8, 5), SubList(171, 3), SubList(2270, 9), SubList(7423, 66), High) // 6425h Analogue input interrupt lower limit integer
    (25638, 25638, SubList(7489, 39), SubList(0, 2), Optional, None, SubList(8, 5), SubList(174, 3), SubList(2270, 9), SubList(7528, 82), High) // 6426h Analogue input interrupt delta unsigned
    (25639, 25639, SubList(7610, 48), SubList(0, 2), Optional, None, SubList(8, 5), SubList(177, 3), SubList(2270, 9), SubList(7658, 81), High) // 6427h Analogue input interrupt negative delta unsigned
    (25640, 25640, SubList(7739, 48), SubList(0, 2), Optional, None, SubList(8, 5), SubList(180, 3), SubList(2270, 9), SubList(7787, 80), High) // 6428h Analogue input interrupt positive delta unsigned
    (25641, 25641, SubList(7867, 42), SubList(0, 2), Optional, None, SubList(8, 5), SubList(183, 3), SubList(2270, 9), SubList(7909, 52), High) // 6429h Analogue input interrupt upper limit float
    (25642, 25642, SubList(7961, 42), SubList(0, 2), Optional, None, SubList(8, 5), SubList(186, 3), SubList(2270, 9), SubList(8003, 52), High) // 642Ah Analogue input interrupt lower limit float
    (25643, 25643, SubList(8055, 36), SubList(0, 2), Optional, None, SubList(8, 5), SubList(189, 3), SubList(2270, 9), SubList(8091, 47), High) // 642Bh Analogue input interrupt delta float
    (25644, 25644, SubList(8138, 45), SubList(0, 2), Optional, None, SubList(8, 5), SubList(192, 3), SubList(2270, 9), SubList(8183, 45), High) // 642Ch Analogue input interrupt negative delta float
    (25645, 25645, SubList(8228, 45), SubList(0, 2), Optional, None, SubList(8, 5), SubList(195, 3), SubList(2270, 9), SubList(8273, 45), High) // 642Dh Analogue input interrupt positive delta float
    (25646, 25646, SubList(8318, 27), SubList(0, 2), Optional, None, SubList(8, 5), SubList(198, 3), SubList(2270, 9), SubList(8345, 75), High) // 642Eh Analogue input offset float
    (25647, 25647, SubList(8420, 28), SubList(0, 2), Optional, None, SubList(8, 5), SubList(201, 3), SubList(2270, 9), SubList(8448, 75), High) // 642Fh Analogue input scaling float
    (25648, 25648, SubList(8523, 22), SubList(0, 2), Optional, None, SubList(8, 5), SubList(204, 3), SubList(2270, 9), SubList(8545, 30), High) // 6430h Analogue input SI unit
    (25649, 25649, SubList(8575, 29), SubList(0, 2), Optional, None, SubList(8, 5), SubList(207, 3), SubList(2270, 9), SubList(8604, 62), High) // 6431h Analogue input offset integer
    (25650, 25650, SubList(8666, 30), SubList(0, 2), Optional, None, SubList(8, 5), SubList(210, 3), SubList(2270, 9), SubList(8696, 62), High) // 6432h Analogue input scaling integer
    (25665, 25665, SubList(8758, 28), SubList(0, 2), Optional, None, SubList(13, 5), SubList(213, 3), SubList(2270, 9), SubList(8786, 76), High) // 6441h Analogue output offset float
    (25666, 25666, SubList(8862, 29), SubList(0, 2), Optional, None, SubList(13, 5), SubList(216, 3), SubList(2270, 9), SubList(8891, 76), High) // 6442h Analogue output scaling float
    (25667, 25667, SubList(8967, 26), SubList(0, 2), Optional, None, SubList(13, 5), SubList(219, 3), SubList(9038, 13), SubList(9051, 70), High) // 6443h Analogue output error mode
    (25668, 25668, SubList(9121, 35), SubList(0, 2), Optional, None, SubList(13, 5), SubList(222, 3), SubList(9038, 13), SubList(9156, 76), High) // 6444h Analogue output error value integer
    (25669, 25669, SubList(9232, 33), SubList(0, 2), Optional, None, SubList(13, 5), SubList(225, 3), SubList(2270, 9), SubList(9265, 89), High) // 6445h Analogue output error value float
    (25670, 25670, SubList(9354, 30), SubList(0, 2), Optional, None, SubList(13, 5), SubList(228, 3), SubList(2270, 9), SubList(9384, 63), High) // 6446h Analogue output offset integer
    (25671, 25671, SubList(9447, 31), SubList(0, 2), Optional, None, SubList(13, 5), SubList(231, 3), SubList(2270, 9), SubList(9478, 63), High) // 6447h Analogue output scaling integer
    (25680, 25680, SubList(9541, 23), SubList(0, 2), Optional, None, SubList(13, 5), SubList(234, 3), SubList(2270, 9), SubList(9564, 31), High) // 6450h Analogue output SI unit
    (26623, 26623, SubList(140, 11), SubList(2, 1), Optional, None, SubList(0, 0), SubList(237, 1), SubList(9595, 15), SubList(9610, 100), High) // 67FFh Device type
);

static ENTRIES: &[EntryRow] = table!(EntryRow { first, last, mapping, need, name, data_types, access, values, default, unit, bits }:
    (0, 0, None, Optional, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 7))
    (1, 1, None, Optional, SubList(247, 19), SubList(0, 0), SubList(0, 0), SubList(0, 2), Some(0), SubList(0, 0), SubList(0, 0)) // Communication error
    (2, 2, None, Optional, SubList(266, 12), SubList(0, 0), SubList(0, 0), SubList(0, 2), Some(0), SubList(0, 0), SubList(0, 0)) // Output error
    (3, 3, None, Optional, SubList(278, 11), SubList(0, 0), SubList(0, 0), SubList(0, 2), Some(0), SubList(0, 0), SubList(0, 0)) // Input error
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(2071, 16), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Read input 8-bit
    (2, 254, Some(Tpdo), Optional, SubList(2071, 16), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Read input 8-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(2173, 20), SubList(0, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Polarity input 8-bit
    (2, 254, Some(No), Optional, SubList(2173, 20), SubList(0, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Polarity input 8-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(2243, 27), SubList(0, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Filter constant input 8-bit
    (2, 254, Some(No), Optional, SubList(2243, 27), SubList(0, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Filter constant input 8-bit
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(1, 2), SubList(1, 1), SubList(0, 0), Some(1), SubList(0, 0), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(2418, 31), SubList(0, 1), SubList(1, 1), SubList(0, 0), Some(2), SubList(0, 0), SubList(0, 0)) // Interrupt mask any change 8-bit
    (2, 254, Some(No), Optional, SubList(2418, 31), SubList(0, 1), SubList(1, 1), SubList(0, 0), Some(2), SubList(0, 0), SubList(0, 0)) // Interrupt mask any change 8-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(2512, 32), SubList(0, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Interrupt mask low-to-high 8-bit
    (2, 254, Some(No), Optional, SubList(2512, 32), SubList(0, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Interrupt mask low-to-high 8-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(2615, 32), SubList(0, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Interrupt mask high-to-low 8-bit
    (2, 254, Some(No), Optional, SubList(2615, 32), SubList(0, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Interrupt mask high-to-low 8-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(3, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(2718, 14), SubList(3, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Read input bit
    (2, 128, Some(Tpdo), Optional, SubList(2718, 14), SubList(3, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Read input bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(3, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(2781, 18), SubList(3, 1), SubList(1, 1), SubList(0, 0), Some(3), SubList(0, 0), SubList(0, 0)) // Polarity input bit
    (2, 128, Some(No), Optional, SubList(2781, 18), SubList(3, 1), SubList(1, 1), SubList(0, 0), Some(3), SubList(0, 0), SubList(0, 0)) // Polarity input bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(3, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(2839, 25), SubList(3, 1), SubList(1, 1), SubList(0, 0), Some(3), SubList(0, 0), SubList(0, 0)) // Filter constant input bit
    (2, 128, Some(No), Optional, SubList(2839, 25), SubList(3, 1), SubList(1, 1), SubList(0, 0), Some(3), SubList(0, 0), SubList(0, 0)) // Filter constant input bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(3, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(2910, 35), SubList(3, 1), SubList(1, 1), SubList(0, 0), Some(1), SubList(0, 0), SubList(0, 0)) // Interrupt mask input bit any change
    (2, 128, Some(No), Optional, SubList(2910, 35), SubList(3, 1), SubList(1, 1), SubList(0, 0), Some(1), SubList(0, 0), SubList(0, 0)) // Interrupt mask input bit any change
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(3, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(3010, 36), SubList(3, 1), SubList(1, 1), SubList(0, 0), Some(3), SubList(0, 0), SubList(0, 0)) // Interrupt mask input bit low-to-high
    (2, 128, Some(No), Optional, SubList(3010, 36), SubList(3, 1), SubList(1, 1), SubList(0, 0), Some(3), SubList(0, 0), SubList(0, 0)) // Interrupt mask input bit low-to-high
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(3, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(3119, 36), SubList(3, 1), SubList(1, 1), SubList(0, 0), Some(3), SubList(0, 0), SubList(0, 0)) // Interrupt mask input bit high-to-low
    (2, 128, Some(No), Optional, SubList(3119, 36), SubList(3, 1), SubList(1, 1), SubList(0, 0), Some(3), SubList(0, 0), SubList(0, 0)) // Interrupt mask input bit high-to-low
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(3228, 17), SubList(4, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Read input 16-bit
    (2, 254, Some(Tpdo), Optional, SubList(3228, 17), SubList(4, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Read input 16-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(3293, 21), SubList(4, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Polarity input 16-bit
    (2, 254, Some(No), Optional, SubList(3293, 21), SubList(4, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Polarity input 16-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(3353, 28), SubList(4, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Filter constant input 16-bit
    (2, 254, Some(No), Optional, SubList(3353, 28), SubList(4, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Filter constant input 16-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(3426, 32), SubList(4, 1), SubList(1, 1), SubList(0, 0), Some(4), SubList(0, 0), SubList(0, 0)) // Interrupt mask any change 16-bit
    (2, 254, Some(No), Optional, SubList(3426, 32), SubList(4, 1), SubList(1, 1), SubList(0, 0), Some(4), SubList(0, 0), SubList(0, 0)) // Interrupt mask any change 16-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(3522, 33), SubList(4, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Interrupt mask low-to-high 16-bit
    (2, 254, Some(No), Optional, SubList(3522, 33), SubList(4, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Interrupt mask low-to-high 16-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(3627, 33), SubList(4, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Interrupt mask high-to-low 16-bit
    (2, 254, Some(No), Optional, SubList(3627, 33), SubList(4, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Interrupt mask high-to-low 16-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(3732, 17), SubList(5, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Read input 32-bit
    (2, 254, Some(Tpdo), Optional, SubList(3732, 17), SubList(5, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Read input 32-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(3797, 21), SubList(5, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Polarity input 32-bit
    (2, 254, Some(No), Optional, SubList(3797, 21), SubList(5, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Polarity input 32-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(3857, 28), SubList(5, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Filter constant input 32-bit
    (2, 254, Some(No), Optional, SubList(3857, 28), SubList(5, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Filter constant input 32-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(3930, 32), SubList(5, 1), SubList(1, 1), SubList(0, 0), Some(5), SubList(0, 0), SubList(0, 0)) // Interrupt mask any change 32-bit
    (2, 254, Some(No), Optional, SubList(3930, 32), SubList(5, 1), SubList(1, 1), SubList(0, 0), Some(5), SubList(0, 0), SubList(0, 0)) // Interrupt mask any change 32-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(4026, 33), SubList(5, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Interrupt mask low-to-high 32-bit
    (2, 254, Some(No), Optional, SubList(4026, 33), SubList(5, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Interrupt mask low-to-high 32-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(4131, 33), SubList(5, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Interrupt mask high-to-low 32-bit
    (2, 254, Some(No), Optional, SubList(4131, 33), SubList(5, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Interrupt mask high-to-low 32-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Rpdo), Mandatory, SubList(4236, 18), SubList(0, 1), SubList(2, 2), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Write output 8-bit
    (2, 254, Some(Rpdo), Optional, SubList(4236, 18), SubList(0, 1), SubList(2, 2), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Write output 8-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(4306, 28), SubList(0, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Change polarity output 8-bit
    (2, 254, Some(No), Optional, SubList(4306, 28), SubList(0, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Change polarity output 8-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(4385, 23), SubList(0, 1), SubList(1, 1), SubList(0, 0), Some(2), SubList(0, 0), SubList(0, 0)) // Error mode output 8-bit
    (2, 254, Some(No), Optional, SubList(4385, 23), SubList(0, 1), SubList(1, 1), SubList(0, 0), Some(2), SubList(0, 0), SubList(0, 0)) // Error mode output 8-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(4494, 24), SubList(0, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Error value output 8-bit
    (2, 254, Some(No), Optional, SubList(4494, 24), SubList(0, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Error value output 8-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(4583, 24), SubList(0, 1), SubList(1, 1), SubList(0, 0), Some(2), SubList(0, 0), SubList(0, 0)) // Filter mask output 8-bit
    (2, 254, Some(No), Optional, SubList(4583, 24), SubList(0, 1), SubList(1, 1), SubList(0, 0), Some(2), SubList(0, 0), SubList(0, 0)) // Filter mask output 8-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(3, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Rpdo), Mandatory, SubList(4647, 16), SubList(3, 1), SubList(2, 2), SubList(0, 0), Some(3), SubList(0, 0), SubList(0, 0)) // Write output bit
    (2, 128, Some(Rpdo), Optional, SubList(4647, 16), SubList(3, 1), SubList(2, 2), SubList(0, 0), Some(3), SubList(0, 0), SubList(0, 0)) // Write output bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(3, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(4705, 26), SubList(3, 1), SubList(1, 1), SubList(0, 0), Some(3), SubList(0, 0), SubList(0, 0)) // Change polarity output bit
    (2, 128, Some(No), Optional, SubList(4705, 26), SubList(3, 1), SubList(1, 1), SubList(0, 0), Some(3), SubList(0, 0), SubList(0, 0)) // Change polarity output bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(3, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(4772, 21), SubList(3, 1), SubList(1, 1), SubList(0, 0), Some(1), SubList(0, 0), SubList(0, 0)) // Error mode output bit
    (2, 128, Some(No), Optional, SubList(4772, 21), SubList(3, 1), SubList(1, 1), SubList(0, 0), Some(1), SubList(0, 0), SubList(0, 0)) // Error mode output bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(3, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(4878, 22), SubList(3, 1), SubList(1, 1), SubList(0, 0), Some(3), SubList(0, 0), SubList(0, 0)) // Error value output bit
    (2, 128, Some(No), Optional, SubList(4878, 22), SubList(3, 1), SubList(1, 1), SubList(0, 0), Some(3), SubList(0, 0), SubList(0, 0)) // Error value output bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(3, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(4969, 22), SubList(3, 1), SubList(1, 1), SubList(0, 0), Some(1), SubList(0, 0), SubList(0, 0)) // Filter mask output bit
    (2, 128, Some(No), Optional, SubList(4969, 22), SubList(3, 1), SubList(1, 1), SubList(0, 0), Some(1), SubList(0, 0), SubList(0, 0)) // Filter mask output bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Rpdo), Mandatory, SubList(5033, 19), SubList(4, 1), SubList(2, 2), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Write output 16-bit
    (2, 254, Some(Rpdo), Optional, SubList(5033, 19), SubList(4, 1), SubList(2, 2), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Write output 16-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(5093, 29), SubList(4, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Change polarity output 16-bit
    (2, 254, Some(No), Optional, SubList(5093, 29), SubList(4, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Change polarity output 16-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(5162, 24), SubList(4, 1), SubList(1, 1), SubList(0, 0), Some(4), SubList(0, 0), SubList(0, 0)) // Error mode output 16-bit
    (2, 254, Some(No), Optional, SubList(5162, 24), SubList(4, 1), SubList(1, 1), SubList(0, 0), Some(4), SubList(0, 0), SubList(0, 0)) // Error mode output 16-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(5261, 25), SubList(4, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Error value output 16-bit
    (2, 254, Some(No), Optional, SubList(5261, 25), SubList(4, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Error value output 16-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(5352, 25), SubList(4, 1), SubList(1, 1), SubList(0, 0), Some(4), SubList(0, 0), SubList(0, 0)) // Filter mask output 16-bit
    (2, 254, Some(No), Optional, SubList(5352, 25), SubList(4, 1), SubList(1, 1), SubList(0, 0), Some(4), SubList(0, 0), SubList(0, 0)) // Filter mask output 16-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Rpdo), Mandatory, SubList(5418, 19), SubList(5, 1), SubList(2, 2), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Write output 32-bit
    (2, 254, Some(Rpdo), Optional, SubList(5418, 19), SubList(5, 1), SubList(2, 2), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Write output 32-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(5478, 29), SubList(5, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Change polarity output 32-bit
    (2, 254, Some(No), Optional, SubList(5478, 29), SubList(5, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Change polarity output 32-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(5547, 24), SubList(5, 1), SubList(1, 1), SubList(0, 0), Some(5), SubList(0, 0), SubList(0, 0)) // Error mode output 32-bit
    (2, 254, Some(No), Optional, SubList(5547, 24), SubList(5, 1), SubList(1, 1), SubList(0, 0), Some(5), SubList(0, 0), SubList(0, 0)) // Error mode output 32-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(5646, 25), SubList(5, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Error value output 32-bit
    (2, 254, Some(No), Optional, SubList(5646, 25), SubList(5, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Error value output 32-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(5737, 25), SubList(5, 1), SubList(1, 1), SubList(0, 0), Some(5), SubList(0, 0), SubList(0, 0)) // Filter mask output 32-bit
    (2, 254, Some(No), Optional, SubList(5737, 25), SubList(5, 1), SubList(1, 1), SubList(0, 0), Some(5), SubList(0, 0), SubList(0, 0)) // Filter mask output 32-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(5803, 25), SubList(6, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Read analogue input 8-bit
    (2, 254, Some(Tpdo), Optional, SubList(5803, 25), SubList(6, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Read analogue input 8-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(5896, 26), SubList(7, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Read analogue input 16-bit
    (2, 254, Some(Tpdo), Optional, SubList(5896, 26), SubList(7, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Read analogue input 16-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(6003, 26), SubList(8, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Read analogue input 32-bit
    (2, 254, Some(Tpdo), Optional, SubList(6003, 26), SubList(8, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Read analogue input 32-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(6098, 25), SubList(9, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Read analogue input float
    (2, 254, Some(Tpdo), Optional, SubList(6098, 25), SubList(9, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Read analogue input float
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Rpdo), Mandatory, SubList(6318, 27), SubList(6, 1), SubList(2, 2), SubList(0, 0), Some(6), SubList(0, 0), SubList(0, 0)) // Write analogue output 8-bit
    (2, 254, Some(Rpdo), Optional, SubList(6318, 27), SubList(6, 1), SubList(2, 2), SubList(0, 0), Some(6), SubList(0, 0), SubList(0, 0)) // Write analogue output 8-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Rpdo), Mandatory, SubList(6405, 28), SubList(7, 1), SubList(2, 2), SubList(0, 0), Some(6), SubList(0, 0), SubList(0, 0)) // Write analogue output 16-bit
    (2, 254, Some(Rpdo), Optional, SubList(6405, 28), SubList(7, 1), SubList(2, 2), SubList(0, 0), Some(6), SubList(0, 0), SubList(0, 0)) // Write analogue output 16-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Rpdo), Mandatory, SubList(6507, 28), SubList(8, 1), SubList(2, 2), SubList(0, 0), Some(6), SubList(0, 0), SubList(0, 0)) // Write analogue output 32-bit
    (2, 254, Some(Rpdo), Optional, SubList(6507, 28), SubList(8, 1), SubList(2, 2), SubList(0, 0), Some(6), SubList(0, 0), SubList(0, 0)) // Write analogue output 32-bit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Rpdo), Mandatory, SubList(6596, 27), SubList(9, 1), SubList(2, 2), SubList(0, 0), Some(7), SubList(0, 0), SubList(0, 0)) // Write analogue output float
    (2, 254, Some(Rpdo), Optional, SubList(6596, 27), SubList(9, 1), SubList(2, 2), SubList(0, 0), Some(7), SubList(0, 0), SubList(0, 0)) // Write analogue output float
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(6804, 42), SubList(0, 1), SubList(1, 1), SubList(4, 1), Some(8), SubList(0, 0), SubList(7, 5)) // Analogue input interrupt trigger selection
    (2, 254, Some(No), Optional, SubList(6804, 42), SubList(0, 1), SubList(1, 1), SubList(4, 1), Some(8), SubList(0, 0), SubList(7, 5)) // Analogue input interrupt trigger selection
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(5, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7050, 31), SubList(5, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Analogue input interrupt source
    (2, 8, None, Optional, SubList(7050, 31), SubList(5, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Analogue input interrupt source
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(1, 2), SubList(1, 1), SubList(0, 0), Some(3), SubList(0, 0), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(7269, 44), SubList(8, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Analogue input interrupt upper limit integer
    (2, 254, Some(No), Optional, SubList(7269, 44), SubList(8, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Analogue input interrupt upper limit integer
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(7379, 44), SubList(8, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Analogue input interrupt lower limit integer
    (2, 254, Some(No), Optional, SubList(7379, 44), SubList(8, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Analogue input interrupt lower limit integer
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(7489, 39), SubList(5, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Analogue input interrupt delta unsigned
    (2, 254, Some(No), Optional, SubList(7489, 39), SubList(5, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Analogue input interrupt delta unsigned
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(7610, 48), SubList(5, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Analogue input interrupt negative delta unsigned
    (2, 254, Some(No), Optional, SubList(7610, 48), SubList(5, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Analogue input interrupt negative delta unsigned
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(7739, 48), SubList(5, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Analogue input interrupt positive delta unsigned
    (2, 254, Some(No), Optional, SubList(7739, 48), SubList(5, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Analogue input interrupt positive delta unsigned
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(7867, 42), SubList(9, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Analogue input interrupt upper limit float
    (2, 254, Some(No), Optional, SubList(7867, 42), SubList(9, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Analogue input interrupt upper limit float
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(7961, 42), SubList(9, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Analogue input interrupt lower limit float
    (2, 254, Some(No), Optional, SubList(7961, 42), SubList(9, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Analogue input interrupt lower limit float
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(8055, 36), SubList(9, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Analogue input interrupt delta float
    (2, 254, Some(No), Optional, SubList(8055, 36), SubList(9, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Analogue input interrupt delta float
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(8138, 45), SubList(9, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Analogue input interrupt negative delta float
    (2, 254, Some(No), Optional, SubList(8138, 45), SubList(9, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Analogue input interrupt negative delta float
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(8228, 45), SubList(9, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Analogue input interrupt positive delta float
    (2, 254, Some(No), Optional, SubList(8228, 45), SubList(9, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Analogue input interrupt positive delta float
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(8318, 27), SubList(9, 1), SubList(1, 1), SubList(0, 0), Some(7), SubList(0, 0), SubList(0, 0)) // Analogue input offset float
    (2, 254, Some(No), Optional, SubList(8318, 27), SubList(9, 1), SubList(1, 1), SubList(0, 0), Some(7), SubList(0, 0), SubList(0, 0)) // Analogue input offset float
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(8420, 28), SubList(9, 1), SubList(1, 1), SubList(0, 0), Some(9), SubList(0, 0), SubList(0, 0)) // Analogue input scaling float
    (2, 254, Some(No), Optional, SubList(8420, 28), SubList(9, 1), SubList(1, 1), SubList(0, 0), Some(9), SubList(0, 0), SubList(0, 0)) // Analogue input scaling float
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(8523, 22), SubList(5, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Analogue input SI unit
    (2, 254, Some(No), Optional, SubList(8523, 22), SubList(5, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Analogue input SI unit
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(8575, 29), SubList(8, 1), SubList(1, 1), SubList(0, 0), Some(6), SubList(0, 0), SubList(0, 0)) // Analogue input offset integer
    (2, 254, Some(No), Optional, SubList(8575, 29), SubList(8, 1), SubList(1, 1), SubList(0, 0), Some(6), SubList(0, 0), SubList(0, 0)) // Analogue input offset integer
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(8666, 30), SubList(8, 1), SubList(1, 1), SubList(0, 0), Some(10), SubList(0, 0), SubList(0, 0)) // Analogue input scaling integer
    (2, 254, Some(No), Optional, SubList(8666, 30), SubList(8, 1), SubList(1, 1), SubList(0, 0), Some(10), SubList(0, 0), SubList(0, 0)) // Analogue input scaling integer
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(8758, 28), SubList(9, 1), SubList(1, 1), SubList(0, 0), Some(7), SubList(0, 0), SubList(0, 0)) // Analogue output offset float
    (2, 254, Some(No), Optional, SubList(8758, 28), SubList(9, 1), SubList(1, 1), SubList(0, 0), Some(7), SubList(0, 0), SubList(0, 0)) // Analogue output offset float
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(8862, 29), SubList(9, 1), SubList(1, 1), SubList(0, 0), Some(9), SubList(0, 0), SubList(0, 0)) // Analogue output scaling float
    (2, 254, Some(No), Optional, SubList(8862, 29), SubList(9, 1), SubList(1, 1), SubList(0, 0), Some(9), SubList(0, 0), SubList(0, 0)) // Analogue output scaling float
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(8967, 26), SubList(0, 1), SubList(1, 1), SubList(6, 2), Some(11), SubList(0, 0), SubList(12, 1)) // Analogue output error mode
    (2, 254, Some(No), Optional, SubList(8967, 26), SubList(0, 1), SubList(1, 1), SubList(6, 2), Some(11), SubList(0, 0), SubList(12, 1)) // Analogue output error mode
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(9121, 35), SubList(8, 1), SubList(1, 1), SubList(0, 0), Some(6), SubList(0, 0), SubList(0, 0)) // Analogue output error value integer
    (2, 254, Some(No), Optional, SubList(9121, 35), SubList(8, 1), SubList(1, 1), SubList(0, 0), Some(6), SubList(0, 0), SubList(0, 0)) // Analogue output error value integer
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(9232, 33), SubList(9, 1), SubList(1, 1), SubList(0, 0), Some(7), SubList(0, 0), SubList(0, 0)) // Analogue output error value float
    (2, 254, Some(No), Optional, SubList(9232, 33), SubList(9, 1), SubList(1, 1), SubList(0, 0), Some(7), SubList(0, 0), SubList(0, 0)) // Analogue output error value float
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(9354, 30), SubList(8, 1), SubList(1, 1), SubList(0, 0), Some(6), SubList(0, 0), SubList(0, 0)) // Analogue output offset integer
    (2, 254, Some(No), Optional, SubList(9354, 30), SubList(8, 1), SubList(1, 1), SubList(0, 0), Some(6), SubList(0, 0), SubList(0, 0)) // Analogue output offset integer
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(9447, 31), SubList(8, 1), SubList(1, 1), SubList(0, 0), Some(10), SubList(0, 0), SubList(0, 0)) // Analogue output scaling integer
    (2, 254, Some(No), Optional, SubList(9447, 31), SubList(8, 1), SubList(1, 1), SubList(0, 0), Some(10), SubList(0, 0), SubList(0, 0)) // Analogue output scaling integer
    (0, 0, Some(No), Mandatory, SubList(2087, 27), SubList(0, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(9541, 23), SubList(5, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Analogue output SI unit
    (2, 254, Some(No), Optional, SubList(9541, 23), SubList(5, 1), SubList(1, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Analogue output SI unit
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(5, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 7))
);

static BITS: &[BitRow] = table!(BitRow { first, last, name, values }:
    (0, 15, SubList(0, 21), SubList(0, 0)) // device profile number
    (16, 16, SubList(21, 14), SubList(0, 0)) // digital inputs
    (17, 17, SubList(35, 15), SubList(0, 0)) // digital outputs
    (18, 18, SubList(50, 15), SubList(0, 0)) // analogue inputs
    (19, 19, SubList(65, 16), SubList(0, 0)) // analogue outputs
    (23, 23, SubList(81, 11), SubList(0, 2)) // PDO mapping
    (24, 24, SubList(132, 8), SubList(0, 0)) // joystick
    (0, 0, SubList(6846, 20), SubList(0, 0)) // upper limit exceeded
    (1, 1, SubList(6866, 17), SubList(0, 0)) // below lower limit
    (2, 2, SubList(6883, 26), SubList(0, 0)) // changed by more than delta
    (3, 3, SubList(6909, 35), SubList(0, 0)) // reduced by more than negative delta
    (4, 4, SubList(6944, 37), SubList(0, 0)) // increased by more than positive delta
    (0, 7, SubList(8993, 11), SubList(2, 2)) // on an error
);

static MEANINGS: &[MeaningRow] = table!(MeaningRow { first, last, text }:
    (0, 0, SubList(92, 21)) // as the profile has it
    (1, 1, SubList(113, 19)) // of the manufacturer
    (0, 0, SubList(9004, 14)) // keep the value
    (1, 1, SubList(9018, 20)) // take the error value
);

static COMMANDS: &[CommandRow] = &[];

static TRANSITIONS: &[TransitionRow] = &[];

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
    Condition::constant("6421h", &[Described(25633, None)]),
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
