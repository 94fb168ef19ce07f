// Generated from `data/cia401.toml` by `cargo xtask profiles`: edit that file.

#![allow(unused_imports, reason = "not every document has facts of every kind")]

use std::borrow::Cow;

use crate::model::{Access, Access::*, DataType, ObjectType, ObjectType::*, Value, Value::*};
use crate::tables::{NeedRow::*, Term::*, *};
use crate::{Condition, Mapping::*, Profile};

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
        texts: Cow::Borrowed(TEXTS),
    },
};

static OBJECTS: &[ObjectRow] = &[
    ObjectRow { first: 4096, last: 4096, name: Part(140, 11), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 1), source: Part(151, 12) }, // 1000h Device type
    ObjectRow { first: 4137, last: 4137, name: Part(205, 21), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(1, 3), source: Part(226, 27) }, // 1029h Error behavior object
    ObjectRow { first: 5120, last: 5120, name: Part(253, 30), object_types: Part(0, 0), need: When(0), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(283, 12) }, // 1400h RPDO 1 communication parameter
    ObjectRow { first: 5121, last: 5121, name: Part(295, 30), object_types: Part(0, 0), need: When(1), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(283, 12) }, // 1401h RPDO 2 communication parameter
    ObjectRow { first: 5122, last: 5122, name: Part(325, 30), object_types: Part(0, 0), need: When(2), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(283, 12) }, // 1402h RPDO 3 communication parameter
    ObjectRow { first: 5123, last: 5123, name: Part(355, 30), object_types: Part(0, 0), need: When(3), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(283, 12) }, // 1403h RPDO 4 communication parameter
    ObjectRow { first: 5632, last: 5632, name: Part(385, 24), object_types: Part(0, 0), need: When(0), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(283, 12) }, // 1600h RPDO 1 mapping parameter
    ObjectRow { first: 5633, last: 5633, name: Part(409, 24), object_types: Part(0, 0), need: When(1), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(283, 12) }, // 1601h RPDO 2 mapping parameter
    ObjectRow { first: 5634, last: 5634, name: Part(433, 24), object_types: Part(0, 0), need: When(2), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(283, 12) }, // 1602h RPDO 3 mapping parameter
    ObjectRow { first: 5635, last: 5635, name: Part(457, 24), object_types: Part(0, 0), need: When(3), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(283, 12) }, // 1603h RPDO 4 mapping parameter
    ObjectRow { first: 6144, last: 6144, name: Part(481, 30), object_types: Part(0, 0), need: When(4), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(511, 12) }, // 1800h TPDO 1 communication parameter
    ObjectRow { first: 6145, last: 6145, name: Part(523, 30), object_types: Part(0, 0), need: When(5), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(511, 12) }, // 1801h TPDO 2 communication parameter
    ObjectRow { first: 6146, last: 6146, name: Part(553, 30), object_types: Part(0, 0), need: When(6), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(511, 12) }, // 1802h TPDO 3 communication parameter
    ObjectRow { first: 6147, last: 6147, name: Part(583, 30), object_types: Part(0, 0), need: When(7), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(511, 12) }, // 1803h TPDO 4 communication parameter
    ObjectRow { first: 6656, last: 6656, name: Part(613, 24), object_types: Part(0, 0), need: When(4), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(511, 12) }, // 1A00h TPDO 1 mapping parameter
    ObjectRow { first: 6657, last: 6657, name: Part(637, 24), object_types: Part(0, 0), need: When(5), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(511, 12) }, // 1A01h TPDO 2 mapping parameter
    ObjectRow { first: 6658, last: 6658, name: Part(661, 24), object_types: Part(0, 0), need: When(6), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(511, 12) }, // 1A02h TPDO 3 mapping parameter
    ObjectRow { first: 6659, last: 6659, name: Part(685, 24), object_types: Part(0, 0), need: When(7), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(511, 12) }, // 1A03h TPDO 4 mapping parameter
    ObjectRow { first: 24576, last: 24576, name: Part(709, 16), object_types: Part(0, 2), need: When(8), only: None, as_many_as: Part(0, 0), entries: Part(4, 3), source: Part(752, 12) }, // 6000h Read input 8-bit
    ObjectRow { first: 24578, last: 24578, name: Part(764, 20), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 1), entries: Part(7, 3), source: Part(784, 12) }, // 6002h Polarity input 8-bit
    ObjectRow { first: 24579, last: 24579, name: Part(796, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 1), entries: Part(10, 3), source: Part(823, 9) }, // 6003h Filter constant input 8-bit
    ObjectRow { first: 24581, last: 24581, name: Part(832, 31), object_types: Part(2, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(13, 1), source: Part(823, 9) }, // 6005h Global interrupt enable digital
    ObjectRow { first: 24582, last: 24582, name: Part(863, 31), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 1), entries: Part(14, 3), source: Part(823, 9) }, // 6006h Interrupt mask any change 8-bit
    ObjectRow { first: 24583, last: 24583, name: Part(894, 32), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 1), entries: Part(17, 3), source: Part(823, 9) }, // 6007h Interrupt mask low-to-high 8-bit
    ObjectRow { first: 24584, last: 24584, name: Part(926, 32), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 1), entries: Part(20, 3), source: Part(823, 9) }, // 6008h Interrupt mask high-to-low 8-bit
    ObjectRow { first: 24608, last: 24615, name: Part(958, 14), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(23, 3), source: Part(823, 9) }, // 6020h Read input bit
    ObjectRow { first: 24624, last: 24631, name: Part(972, 18), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(1, 1), entries: Part(26, 3), source: Part(823, 9) }, // 6030h Polarity input bit
    ObjectRow { first: 24632, last: 24639, name: Part(990, 25), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(1, 1), entries: Part(29, 3), source: Part(823, 9) }, // 6038h Filter constant input bit
    ObjectRow { first: 24656, last: 24663, name: Part(1015, 35), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(1, 1), entries: Part(32, 3), source: Part(823, 9) }, // 6050h Interrupt mask input bit any change
    ObjectRow { first: 24672, last: 24679, name: Part(1050, 36), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(1, 1), entries: Part(35, 3), source: Part(823, 9) }, // 6060h Interrupt mask input bit low-to-high
    ObjectRow { first: 24688, last: 24695, name: Part(1086, 36), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(1, 1), entries: Part(38, 3), source: Part(823, 9) }, // 6070h Interrupt mask input bit high-to-low
    ObjectRow { first: 24832, last: 24832, name: Part(1122, 17), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(41, 3), source: Part(823, 9) }, // 6100h Read input 16-bit
    ObjectRow { first: 24834, last: 24834, name: Part(1139, 21), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(2, 1), entries: Part(44, 3), source: Part(823, 9) }, // 6102h Polarity input 16-bit
    ObjectRow { first: 24835, last: 24835, name: Part(1160, 28), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(2, 1), entries: Part(47, 3), source: Part(823, 9) }, // 6103h Filter constant input 16-bit
    ObjectRow { first: 24838, last: 24838, name: Part(1188, 32), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(2, 1), entries: Part(50, 3), source: Part(823, 9) }, // 6106h Interrupt mask any change 16-bit
    ObjectRow { first: 24839, last: 24839, name: Part(1220, 33), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(2, 1), entries: Part(53, 3), source: Part(823, 9) }, // 6107h Interrupt mask low-to-high 16-bit
    ObjectRow { first: 24840, last: 24840, name: Part(1253, 33), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(2, 1), entries: Part(56, 3), source: Part(823, 9) }, // 6108h Interrupt mask high-to-low 16-bit
    ObjectRow { first: 24864, last: 24864, name: Part(1286, 17), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(59, 3), source: Part(823, 9) }, // 6120h Read input 32-bit
    ObjectRow { first: 24866, last: 24866, name: Part(1303, 21), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(3, 1), entries: Part(62, 3), source: Part(823, 9) }, // 6122h Polarity input 32-bit
    ObjectRow { first: 24867, last: 24867, name: Part(1324, 28), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(3, 1), entries: Part(65, 3), source: Part(823, 9) }, // 6123h Filter constant input 32-bit
    ObjectRow { first: 24870, last: 24870, name: Part(1352, 32), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(3, 1), entries: Part(68, 3), source: Part(823, 9) }, // 6126h Interrupt mask any change 32-bit
    ObjectRow { first: 24871, last: 24871, name: Part(1384, 33), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(3, 1), entries: Part(71, 3), source: Part(823, 9) }, // 6127h Interrupt mask low-to-high 32-bit
    ObjectRow { first: 24872, last: 24872, name: Part(1417, 33), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(3, 1), entries: Part(74, 3), source: Part(823, 9) }, // 6128h Interrupt mask high-to-low 32-bit
    ObjectRow { first: 25088, last: 25088, name: Part(1450, 18), object_types: Part(0, 2), need: When(9), only: None, as_many_as: Part(0, 0), entries: Part(77, 3), source: Part(1468, 12) }, // 6200h Write output 8-bit
    ObjectRow { first: 25090, last: 25090, name: Part(1480, 28), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(4, 1), entries: Part(80, 3), source: Part(1508, 12) }, // 6202h Change polarity output 8-bit
    ObjectRow { first: 25094, last: 25094, name: Part(1520, 23), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(4, 1), entries: Part(83, 3), source: Part(1543, 12) }, // 6206h Error mode output 8-bit
    ObjectRow { first: 25095, last: 25095, name: Part(1555, 24), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(4, 1), entries: Part(86, 3), source: Part(1543, 12) }, // 6207h Error value output 8-bit
    ObjectRow { first: 25096, last: 25096, name: Part(1579, 24), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(4, 1), entries: Part(89, 3), source: Part(823, 9) }, // 6208h Filter mask output 8-bit
    ObjectRow { first: 25120, last: 25127, name: Part(1603, 16), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(92, 3), source: Part(823, 9) }, // 6220h Write output bit
    ObjectRow { first: 25152, last: 25159, name: Part(1619, 26), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(5, 1), entries: Part(95, 3), source: Part(823, 9) }, // 6240h Change polarity output bit
    ObjectRow { first: 25168, last: 25175, name: Part(1645, 21), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(5, 1), entries: Part(98, 3), source: Part(823, 9) }, // 6250h Error mode output bit
    ObjectRow { first: 25184, last: 25191, name: Part(1666, 22), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(5, 1), entries: Part(101, 3), source: Part(823, 9) }, // 6260h Error value output bit
    ObjectRow { first: 25200, last: 25207, name: Part(1688, 22), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(5, 1), entries: Part(104, 3), source: Part(823, 9) }, // 6270h Filter mask output bit
    ObjectRow { first: 25344, last: 25344, name: Part(1710, 19), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(107, 3), source: Part(823, 9) }, // 6300h Write output 16-bit
    ObjectRow { first: 25346, last: 25346, name: Part(1729, 29), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(6, 1), entries: Part(110, 3), source: Part(823, 9) }, // 6302h Change polarity output 16-bit
    ObjectRow { first: 25350, last: 25350, name: Part(1758, 24), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(6, 1), entries: Part(113, 3), source: Part(823, 9) }, // 6306h Error mode output 16-bit
    ObjectRow { first: 25351, last: 25351, name: Part(1782, 25), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(6, 1), entries: Part(116, 3), source: Part(823, 9) }, // 6307h Error value output 16-bit
    ObjectRow { first: 25352, last: 25352, name: Part(1807, 25), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(6, 1), entries: Part(119, 3), source: Part(823, 9) }, // 6308h Filter mask output 16-bit
    ObjectRow { first: 25376, last: 25376, name: Part(1832, 19), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(122, 3), source: Part(823, 9) }, // 6320h Write output 32-bit
    ObjectRow { first: 25378, last: 25378, name: Part(1851, 29), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(7, 1), entries: Part(125, 3), source: Part(823, 9) }, // 6322h Change polarity output 32-bit
    ObjectRow { first: 25382, last: 25382, name: Part(1880, 24), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(7, 1), entries: Part(128, 3), source: Part(823, 9) }, // 6326h Error mode output 32-bit
    ObjectRow { first: 25383, last: 25383, name: Part(1904, 25), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(7, 1), entries: Part(131, 3), source: Part(823, 9) }, // 6327h Error value output 32-bit
    ObjectRow { first: 25384, last: 25384, name: Part(1929, 25), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(7, 1), entries: Part(134, 3), source: Part(823, 9) }, // 6328h Filter mask output 32-bit
    ObjectRow { first: 25600, last: 25600, name: Part(1954, 25), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(137, 3), source: Part(823, 9) }, // 6400h Read analogue input 8-bit
    ObjectRow { first: 25601, last: 25601, name: Part(1979, 26), object_types: Part(0, 2), need: When(10), only: None, as_many_as: Part(0, 0), entries: Part(140, 3), source: Part(2005, 12) }, // 6401h Read analogue input 16-bit
    ObjectRow { first: 25602, last: 25602, name: Part(2017, 26), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(143, 3), source: Part(823, 9) }, // 6402h Read analogue input 32-bit
    ObjectRow { first: 25603, last: 25603, name: Part(2043, 25), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(146, 3), source: Part(823, 9) }, // 6403h Read analogue input float
    ObjectRow { first: 25604, last: 25604, name: Part(2068, 41), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(823, 9) }, // 6404h Read manufacturer specific analogue input
    ObjectRow { first: 25616, last: 25616, name: Part(2109, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(149, 3), source: Part(823, 9) }, // 6410h Write analogue output 8-bit
    ObjectRow { first: 25617, last: 25617, name: Part(2136, 28), object_types: Part(0, 2), need: When(11), only: None, as_many_as: Part(0, 0), entries: Part(152, 3), source: Part(2164, 13) }, // 6411h Write analogue output 16-bit
    ObjectRow { first: 25618, last: 25618, name: Part(2177, 28), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(155, 3), source: Part(823, 9) }, // 6412h Write analogue output 32-bit
    ObjectRow { first: 25619, last: 25619, name: Part(2205, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(158, 3), source: Part(823, 9) }, // 6413h Write analogue output float
    ObjectRow { first: 25620, last: 25620, name: Part(2232, 43), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(823, 9) }, // 6414h Write manufacturer specific analogue output
    ObjectRow { first: 25633, last: 25633, name: Part(2275, 42), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(161, 3), source: Part(823, 9) }, // 6421h Analogue input interrupt trigger selection
    ObjectRow { first: 25634, last: 25634, name: Part(2452, 31), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(164, 3), source: Part(823, 9) }, // 6422h Analogue input interrupt source
    ObjectRow { first: 25635, last: 25635, name: Part(2483, 38), object_types: Part(2, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(167, 1), source: Part(823, 9) }, // 6423h Analogue input global interrupt enable
    ObjectRow { first: 25636, last: 25636, name: Part(2521, 44), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(168, 3), source: Part(823, 9) }, // 6424h Analogue input interrupt upper limit integer
    ObjectRow { first: 25637, last: 25637, name: Part(2565, 44), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(171, 3), source: Part(823, 9) }, // 6425h Analogue input interrupt lower limit integer
    ObjectRow { first: 25638, last: 25638, name: Part(2609, 39), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(174, 3), source: Part(823, 9) }, // 6426h Analogue input interrupt delta unsigned
    ObjectRow { first: 25639, last: 25639, name: Part(2648, 48), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(177, 3), source: Part(823, 9) }, // 6427h Analogue input interrupt negative delta unsigned
    ObjectRow { first: 25640, last: 25640, name: Part(2696, 48), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(180, 3), source: Part(823, 9) }, // 6428h Analogue input interrupt positive delta unsigned
    ObjectRow { first: 25641, last: 25641, name: Part(2744, 42), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(183, 3), source: Part(823, 9) }, // 6429h Analogue input interrupt upper limit float
    ObjectRow { first: 25642, last: 25642, name: Part(2786, 42), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(186, 3), source: Part(823, 9) }, // 642Ah Analogue input interrupt lower limit float
    ObjectRow { first: 25643, last: 25643, name: Part(2828, 36), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(189, 3), source: Part(823, 9) }, // 642Bh Analogue input interrupt delta float
    ObjectRow { first: 25644, last: 25644, name: Part(2864, 45), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(192, 3), source: Part(823, 9) }, // 642Ch Analogue input interrupt negative delta float
    ObjectRow { first: 25645, last: 25645, name: Part(2909, 45), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(195, 3), source: Part(823, 9) }, // 642Dh Analogue input interrupt positive delta float
    ObjectRow { first: 25646, last: 25646, name: Part(2954, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(198, 3), source: Part(823, 9) }, // 642Eh Analogue input offset float
    ObjectRow { first: 25647, last: 25647, name: Part(2981, 28), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(201, 3), source: Part(823, 9) }, // 642Fh Analogue input scaling float
    ObjectRow { first: 25648, last: 25648, name: Part(3009, 22), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(204, 3), source: Part(823, 9) }, // 6430h Analogue input SI unit
    ObjectRow { first: 25649, last: 25649, name: Part(3031, 29), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(207, 3), source: Part(823, 9) }, // 6431h Analogue input offset integer
    ObjectRow { first: 25650, last: 25650, name: Part(3060, 30), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(8, 5), entries: Part(210, 3), source: Part(823, 9) }, // 6432h Analogue input scaling integer
    ObjectRow { first: 25665, last: 25665, name: Part(3090, 28), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(13, 5), entries: Part(213, 3), source: Part(823, 9) }, // 6441h Analogue output offset float
    ObjectRow { first: 25666, last: 25666, name: Part(3118, 29), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(13, 5), entries: Part(216, 3), source: Part(823, 9) }, // 6442h Analogue output scaling float
    ObjectRow { first: 25667, last: 25667, name: Part(3147, 26), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(13, 5), entries: Part(219, 3), source: Part(3218, 13) }, // 6443h Analogue output error mode
    ObjectRow { first: 25668, last: 25668, name: Part(3231, 35), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(13, 5), entries: Part(222, 3), source: Part(3218, 13) }, // 6444h Analogue output error value integer
    ObjectRow { first: 25669, last: 25669, name: Part(3266, 33), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(13, 5), entries: Part(225, 3), source: Part(823, 9) }, // 6445h Analogue output error value float
    ObjectRow { first: 25670, last: 25670, name: Part(3299, 30), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(13, 5), entries: Part(228, 3), source: Part(823, 9) }, // 6446h Analogue output offset integer
    ObjectRow { first: 25671, last: 25671, name: Part(3329, 31), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(13, 5), entries: Part(231, 3), source: Part(823, 9) }, // 6447h Analogue output scaling integer
    ObjectRow { first: 25680, last: 25680, name: Part(3360, 23), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(13, 5), entries: Part(234, 3), source: Part(823, 9) }, // 6450h Analogue output SI unit
    ObjectRow { first: 26623, last: 26623, name: Part(140, 11), object_types: Part(2, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(237, 1), source: Part(3383, 15) }, // 67FFh Device type
];

static ENTRIES: &[EntryRow] = &[
    EntryRow { first: 0, last: 0, mapping: None, need: Optional, name: Part(0, 0), data_types: Part(0, 0), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 7) },
    EntryRow { first: 1, last: 1, mapping: None, need: Optional, name: Part(163, 19), data_types: Part(0, 0), access: Part(0, 0), values: Part(0, 2), default: Some(0), bits: Part(0, 0) }, // Communication error
    EntryRow { first: 2, last: 2, mapping: None, need: Optional, name: Part(182, 12), data_types: Part(0, 0), access: Part(0, 0), values: Part(0, 2), default: Some(0), bits: Part(0, 0) }, // Output error
    EntryRow { first: 3, last: 3, mapping: None, need: Optional, name: Part(194, 11), data_types: Part(0, 0), access: Part(0, 0), values: Part(0, 2), default: Some(0), bits: Part(0, 0) }, // Input error
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(709, 16), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Read input 8-bit
    EntryRow { first: 2, last: 254, mapping: Some(Tpdo), need: Optional, name: Part(709, 16), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Read input 8-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(764, 20), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Polarity input 8-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(764, 20), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Polarity input 8-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(796, 27), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Filter constant input 8-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(796, 27), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Filter constant input 8-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(1, 2), access: Part(1, 1), values: Part(0, 0), default: Some(1), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(863, 31), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(2), bits: Part(0, 0) }, // Interrupt mask any change 8-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(863, 31), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(2), bits: Part(0, 0) }, // Interrupt mask any change 8-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(894, 32), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Interrupt mask low-to-high 8-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(894, 32), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Interrupt mask low-to-high 8-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(926, 32), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Interrupt mask high-to-low 8-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(926, 32), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Interrupt mask high-to-low 8-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(3, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(958, 14), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Read input bit
    EntryRow { first: 2, last: 128, mapping: Some(Tpdo), need: Optional, name: Part(958, 14), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Read input bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(3, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(972, 18), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(3), bits: Part(0, 0) }, // Polarity input bit
    EntryRow { first: 2, last: 128, mapping: Some(No), need: Optional, name: Part(972, 18), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(3), bits: Part(0, 0) }, // Polarity input bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(3, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(990, 25), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(3), bits: Part(0, 0) }, // Filter constant input bit
    EntryRow { first: 2, last: 128, mapping: Some(No), need: Optional, name: Part(990, 25), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(3), bits: Part(0, 0) }, // Filter constant input bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(3, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1015, 35), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(1), bits: Part(0, 0) }, // Interrupt mask input bit any change
    EntryRow { first: 2, last: 128, mapping: Some(No), need: Optional, name: Part(1015, 35), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(1), bits: Part(0, 0) }, // Interrupt mask input bit any change
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(3, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1050, 36), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(3), bits: Part(0, 0) }, // Interrupt mask input bit low-to-high
    EntryRow { first: 2, last: 128, mapping: Some(No), need: Optional, name: Part(1050, 36), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(3), bits: Part(0, 0) }, // Interrupt mask input bit low-to-high
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(3, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1086, 36), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(3), bits: Part(0, 0) }, // Interrupt mask input bit high-to-low
    EntryRow { first: 2, last: 128, mapping: Some(No), need: Optional, name: Part(1086, 36), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(3), bits: Part(0, 0) }, // Interrupt mask input bit high-to-low
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(1122, 17), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Read input 16-bit
    EntryRow { first: 2, last: 254, mapping: Some(Tpdo), need: Optional, name: Part(1122, 17), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Read input 16-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1139, 21), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Polarity input 16-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1139, 21), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Polarity input 16-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1160, 28), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Filter constant input 16-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1160, 28), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Filter constant input 16-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1188, 32), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(4), bits: Part(0, 0) }, // Interrupt mask any change 16-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1188, 32), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(4), bits: Part(0, 0) }, // Interrupt mask any change 16-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1220, 33), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Interrupt mask low-to-high 16-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1220, 33), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Interrupt mask low-to-high 16-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1253, 33), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Interrupt mask high-to-low 16-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1253, 33), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Interrupt mask high-to-low 16-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(1286, 17), data_types: Part(5, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Read input 32-bit
    EntryRow { first: 2, last: 254, mapping: Some(Tpdo), need: Optional, name: Part(1286, 17), data_types: Part(5, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Read input 32-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1303, 21), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Polarity input 32-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1303, 21), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Polarity input 32-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1324, 28), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Filter constant input 32-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1324, 28), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Filter constant input 32-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1352, 32), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(5), bits: Part(0, 0) }, // Interrupt mask any change 32-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1352, 32), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(5), bits: Part(0, 0) }, // Interrupt mask any change 32-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1384, 33), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Interrupt mask low-to-high 32-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1384, 33), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Interrupt mask low-to-high 32-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1417, 33), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Interrupt mask high-to-low 32-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1417, 33), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Interrupt mask high-to-low 32-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Rpdo), need: Mandatory, name: Part(1450, 18), data_types: Part(0, 1), access: Part(2, 2), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Write output 8-bit
    EntryRow { first: 2, last: 254, mapping: Some(Rpdo), need: Optional, name: Part(1450, 18), data_types: Part(0, 1), access: Part(2, 2), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Write output 8-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1480, 28), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Change polarity output 8-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1480, 28), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Change polarity output 8-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1520, 23), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(2), bits: Part(0, 0) }, // Error mode output 8-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1520, 23), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(2), bits: Part(0, 0) }, // Error mode output 8-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1555, 24), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Error value output 8-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1555, 24), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Error value output 8-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1579, 24), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(2), bits: Part(0, 0) }, // Filter mask output 8-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1579, 24), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: Some(2), bits: Part(0, 0) }, // Filter mask output 8-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(3, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Rpdo), need: Mandatory, name: Part(1603, 16), data_types: Part(3, 1), access: Part(2, 2), values: Part(0, 0), default: Some(3), bits: Part(0, 0) }, // Write output bit
    EntryRow { first: 2, last: 128, mapping: Some(Rpdo), need: Optional, name: Part(1603, 16), data_types: Part(3, 1), access: Part(2, 2), values: Part(0, 0), default: Some(3), bits: Part(0, 0) }, // Write output bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(3, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1619, 26), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(3), bits: Part(0, 0) }, // Change polarity output bit
    EntryRow { first: 2, last: 128, mapping: Some(No), need: Optional, name: Part(1619, 26), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(3), bits: Part(0, 0) }, // Change polarity output bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(3, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1645, 21), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(1), bits: Part(0, 0) }, // Error mode output bit
    EntryRow { first: 2, last: 128, mapping: Some(No), need: Optional, name: Part(1645, 21), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(1), bits: Part(0, 0) }, // Error mode output bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(3, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1666, 22), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(3), bits: Part(0, 0) }, // Error value output bit
    EntryRow { first: 2, last: 128, mapping: Some(No), need: Optional, name: Part(1666, 22), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(3), bits: Part(0, 0) }, // Error value output bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(3, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1688, 22), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(1), bits: Part(0, 0) }, // Filter mask output bit
    EntryRow { first: 2, last: 128, mapping: Some(No), need: Optional, name: Part(1688, 22), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: Some(1), bits: Part(0, 0) }, // Filter mask output bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Rpdo), need: Mandatory, name: Part(1710, 19), data_types: Part(4, 1), access: Part(2, 2), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Write output 16-bit
    EntryRow { first: 2, last: 254, mapping: Some(Rpdo), need: Optional, name: Part(1710, 19), data_types: Part(4, 1), access: Part(2, 2), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Write output 16-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1729, 29), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Change polarity output 16-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1729, 29), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Change polarity output 16-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1758, 24), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(4), bits: Part(0, 0) }, // Error mode output 16-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1758, 24), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(4), bits: Part(0, 0) }, // Error mode output 16-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1782, 25), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Error value output 16-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1782, 25), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Error value output 16-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1807, 25), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(4), bits: Part(0, 0) }, // Filter mask output 16-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1807, 25), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: Some(4), bits: Part(0, 0) }, // Filter mask output 16-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Rpdo), need: Mandatory, name: Part(1832, 19), data_types: Part(5, 1), access: Part(2, 2), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Write output 32-bit
    EntryRow { first: 2, last: 254, mapping: Some(Rpdo), need: Optional, name: Part(1832, 19), data_types: Part(5, 1), access: Part(2, 2), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Write output 32-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1851, 29), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Change polarity output 32-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1851, 29), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Change polarity output 32-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1880, 24), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(5), bits: Part(0, 0) }, // Error mode output 32-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1880, 24), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(5), bits: Part(0, 0) }, // Error mode output 32-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1904, 25), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Error value output 32-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1904, 25), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Error value output 32-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1929, 25), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(5), bits: Part(0, 0) }, // Filter mask output 32-bit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1929, 25), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(5), bits: Part(0, 0) }, // Filter mask output 32-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(1954, 25), data_types: Part(6, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Read analogue input 8-bit
    EntryRow { first: 2, last: 254, mapping: Some(Tpdo), need: Optional, name: Part(1954, 25), data_types: Part(6, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Read analogue input 8-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(1979, 26), data_types: Part(7, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Read analogue input 16-bit
    EntryRow { first: 2, last: 254, mapping: Some(Tpdo), need: Optional, name: Part(1979, 26), data_types: Part(7, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Read analogue input 16-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(2017, 26), data_types: Part(8, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Read analogue input 32-bit
    EntryRow { first: 2, last: 254, mapping: Some(Tpdo), need: Optional, name: Part(2017, 26), data_types: Part(8, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Read analogue input 32-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(2043, 25), data_types: Part(9, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Read analogue input float
    EntryRow { first: 2, last: 254, mapping: Some(Tpdo), need: Optional, name: Part(2043, 25), data_types: Part(9, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Read analogue input float
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Rpdo), need: Mandatory, name: Part(2109, 27), data_types: Part(6, 1), access: Part(2, 2), values: Part(0, 0), default: Some(6), bits: Part(0, 0) }, // Write analogue output 8-bit
    EntryRow { first: 2, last: 254, mapping: Some(Rpdo), need: Optional, name: Part(2109, 27), data_types: Part(6, 1), access: Part(2, 2), values: Part(0, 0), default: Some(6), bits: Part(0, 0) }, // Write analogue output 8-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Rpdo), need: Mandatory, name: Part(2136, 28), data_types: Part(7, 1), access: Part(2, 2), values: Part(0, 0), default: Some(6), bits: Part(0, 0) }, // Write analogue output 16-bit
    EntryRow { first: 2, last: 254, mapping: Some(Rpdo), need: Optional, name: Part(2136, 28), data_types: Part(7, 1), access: Part(2, 2), values: Part(0, 0), default: Some(6), bits: Part(0, 0) }, // Write analogue output 16-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Rpdo), need: Mandatory, name: Part(2177, 28), data_types: Part(8, 1), access: Part(2, 2), values: Part(0, 0), default: Some(6), bits: Part(0, 0) }, // Write analogue output 32-bit
    EntryRow { first: 2, last: 254, mapping: Some(Rpdo), need: Optional, name: Part(2177, 28), data_types: Part(8, 1), access: Part(2, 2), values: Part(0, 0), default: Some(6), bits: Part(0, 0) }, // Write analogue output 32-bit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Rpdo), need: Mandatory, name: Part(2205, 27), data_types: Part(9, 1), access: Part(2, 2), values: Part(0, 0), default: Some(7), bits: Part(0, 0) }, // Write analogue output float
    EntryRow { first: 2, last: 254, mapping: Some(Rpdo), need: Optional, name: Part(2205, 27), data_types: Part(9, 1), access: Part(2, 2), values: Part(0, 0), default: Some(7), bits: Part(0, 0) }, // Write analogue output float
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2275, 42), data_types: Part(0, 1), access: Part(1, 1), values: Part(4, 1), default: Some(8), bits: Part(7, 5) }, // Analogue input interrupt trigger selection
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(2275, 42), data_types: Part(0, 1), access: Part(1, 1), values: Part(4, 1), default: Some(8), bits: Part(7, 5) }, // Analogue input interrupt trigger selection
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(5, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2452, 31), data_types: Part(5, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Analogue input interrupt source
    EntryRow { first: 2, last: 8, mapping: None, need: Optional, name: Part(2452, 31), data_types: Part(5, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Analogue input interrupt source
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(1, 2), access: Part(1, 1), values: Part(0, 0), default: Some(3), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2521, 44), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Analogue input interrupt upper limit integer
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(2521, 44), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Analogue input interrupt upper limit integer
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2565, 44), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Analogue input interrupt lower limit integer
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(2565, 44), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Analogue input interrupt lower limit integer
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2609, 39), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Analogue input interrupt delta unsigned
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(2609, 39), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Analogue input interrupt delta unsigned
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2648, 48), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Analogue input interrupt negative delta unsigned
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(2648, 48), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Analogue input interrupt negative delta unsigned
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2696, 48), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Analogue input interrupt positive delta unsigned
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(2696, 48), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Analogue input interrupt positive delta unsigned
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2744, 42), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Analogue input interrupt upper limit float
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(2744, 42), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Analogue input interrupt upper limit float
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2786, 42), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Analogue input interrupt lower limit float
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(2786, 42), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Analogue input interrupt lower limit float
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2828, 36), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Analogue input interrupt delta float
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(2828, 36), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Analogue input interrupt delta float
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2864, 45), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Analogue input interrupt negative delta float
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(2864, 45), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Analogue input interrupt negative delta float
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2909, 45), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Analogue input interrupt positive delta float
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(2909, 45), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Analogue input interrupt positive delta float
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2954, 27), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: Some(7), bits: Part(0, 0) }, // Analogue input offset float
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(2954, 27), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: Some(7), bits: Part(0, 0) }, // Analogue input offset float
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2981, 28), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: Some(9), bits: Part(0, 0) }, // Analogue input scaling float
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(2981, 28), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: Some(9), bits: Part(0, 0) }, // Analogue input scaling float
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(3009, 22), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Analogue input SI unit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(3009, 22), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Analogue input SI unit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(3031, 29), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: Some(6), bits: Part(0, 0) }, // Analogue input offset integer
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(3031, 29), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: Some(6), bits: Part(0, 0) }, // Analogue input offset integer
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(3060, 30), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: Some(10), bits: Part(0, 0) }, // Analogue input scaling integer
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(3060, 30), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: Some(10), bits: Part(0, 0) }, // Analogue input scaling integer
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(3090, 28), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: Some(7), bits: Part(0, 0) }, // Analogue output offset float
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(3090, 28), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: Some(7), bits: Part(0, 0) }, // Analogue output offset float
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(3118, 29), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: Some(9), bits: Part(0, 0) }, // Analogue output scaling float
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(3118, 29), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: Some(9), bits: Part(0, 0) }, // Analogue output scaling float
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(3147, 26), data_types: Part(0, 1), access: Part(1, 1), values: Part(6, 2), default: Some(11), bits: Part(12, 1) }, // Analogue output error mode
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(3147, 26), data_types: Part(0, 1), access: Part(1, 1), values: Part(6, 2), default: Some(11), bits: Part(12, 1) }, // Analogue output error mode
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(3231, 35), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: Some(6), bits: Part(0, 0) }, // Analogue output error value integer
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(3231, 35), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: Some(6), bits: Part(0, 0) }, // Analogue output error value integer
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(3266, 33), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: Some(7), bits: Part(0, 0) }, // Analogue output error value float
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(3266, 33), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: Some(7), bits: Part(0, 0) }, // Analogue output error value float
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(3299, 30), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: Some(6), bits: Part(0, 0) }, // Analogue output offset integer
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(3299, 30), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: Some(6), bits: Part(0, 0) }, // Analogue output offset integer
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(3329, 31), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: Some(10), bits: Part(0, 0) }, // Analogue output scaling integer
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(3329, 31), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: Some(10), bits: Part(0, 0) }, // Analogue output scaling integer
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(725, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(3360, 23), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Analogue output SI unit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(3360, 23), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: Some(0), bits: Part(0, 0) }, // Analogue output SI unit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(5, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 7) },
];

static BITS: &[BitRow] = &[
    BitRow { first: 0, last: 15, name: Part(0, 21), values: Part(0, 0) }, // device profile number
    BitRow { first: 16, last: 16, name: Part(21, 14), values: Part(0, 0) }, // digital inputs
    BitRow { first: 17, last: 17, name: Part(35, 15), values: Part(0, 0) }, // digital outputs
    BitRow { first: 18, last: 18, name: Part(50, 15), values: Part(0, 0) }, // analogue inputs
    BitRow { first: 19, last: 19, name: Part(65, 16), values: Part(0, 0) }, // analogue outputs
    BitRow { first: 23, last: 23, name: Part(81, 11), values: Part(0, 2) }, // PDO mapping
    BitRow { first: 24, last: 24, name: Part(132, 8), values: Part(0, 0) }, // joystick
    BitRow { first: 0, last: 0, name: Part(2317, 20), values: Part(0, 0) }, // upper limit exceeded
    BitRow { first: 1, last: 1, name: Part(2337, 17), values: Part(0, 0) }, // below lower limit
    BitRow { first: 2, last: 2, name: Part(2354, 26), values: Part(0, 0) }, // changed by more than delta
    BitRow { first: 3, last: 3, name: Part(2380, 35), values: Part(0, 0) }, // reduced by more than negative delta
    BitRow { first: 4, last: 4, name: Part(2415, 37), values: Part(0, 0) }, // increased by more than positive delta
    BitRow { first: 0, last: 7, name: Part(3173, 11), values: Part(2, 2) }, // on an error
];

static MEANINGS: &[MeaningRow] = &[
    MeaningRow { first: 0, last: 0, text: Part(92, 21) }, // as the profile has it
    MeaningRow { first: 1, last: 1, text: Part(113, 19) }, // of the manufacturer
    MeaningRow { first: 0, last: 0, text: Part(3184, 14) }, // keep the value
    MeaningRow { first: 1, last: 1, text: Part(3198, 20) }, // take the error value
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
    "Communication error", "Output error", "Input error", "Error behavior object", "errata sheet of version 2.0",
    "RPDO 1 communication parameter", "book 3.4.2.2", "RPDO 2 communication parameter",
    "RPDO 3 communication parameter", "RPDO 4 communication parameter", "RPDO 1 mapping parameter",
    "RPDO 2 mapping parameter", "RPDO 3 mapping parameter", "RPDO 4 mapping parameter",
    "TPDO 1 communication parameter", "book 3.4.2.3", "TPDO 2 communication parameter",
    "TPDO 3 communication parameter", "TPDO 4 communication parameter", "TPDO 1 mapping parameter",
    "TPDO 2 mapping parameter", "TPDO 3 mapping parameter", "TPDO 4 mapping parameter", "Read input 8-bit",
    "Highest sub-index supported", "book 3.4.2.4", "Polarity input 8-bit", "book 3.4.2.5",
    "Filter constant input 8-bit", "databases", "Global interrupt enable digital",
    "Interrupt mask any change 8-bit", "Interrupt mask low-to-high 8-bit", "Interrupt mask high-to-low 8-bit",
    "Read input bit", "Polarity input bit", "Filter constant input bit", "Interrupt mask input bit any change",
    "Interrupt mask input bit low-to-high", "Interrupt mask input bit high-to-low", "Read input 16-bit",
    "Polarity input 16-bit", "Filter constant input 16-bit", "Interrupt mask any change 16-bit",
    "Interrupt mask low-to-high 16-bit", "Interrupt mask high-to-low 16-bit", "Read input 32-bit",
    "Polarity input 32-bit", "Filter constant input 32-bit", "Interrupt mask any change 32-bit",
    "Interrupt mask low-to-high 32-bit", "Interrupt mask high-to-low 32-bit", "Write output 8-bit",
    "book 3.4.2.6", "Change polarity output 8-bit", "book 3.4.2.7", "Error mode output 8-bit", "book 3.4.2.8",
    "Error value output 8-bit", "Filter mask output 8-bit", "Write output bit", "Change polarity output bit",
    "Error mode output bit", "Error value output bit", "Filter mask output bit", "Write output 16-bit",
    "Change polarity output 16-bit", "Error mode output 16-bit", "Error value output 16-bit",
    "Filter mask output 16-bit", "Write output 32-bit", "Change polarity output 32-bit",
    "Error mode output 32-bit", "Error value output 32-bit", "Filter mask output 32-bit",
    "Read analogue input 8-bit", "Read analogue input 16-bit", "book 3.4.2.9", "Read analogue input 32-bit",
    "Read analogue input float", "Read manufacturer specific analogue input", "Write analogue output 8-bit",
    "Write analogue output 16-bit", "book 3.4.2.10", "Write analogue output 32-bit",
    "Write analogue output float", "Write manufacturer specific analogue output",
    "Analogue input interrupt trigger selection", "upper limit exceeded", "below lower limit",
    "changed by more than delta", "reduced by more than negative delta", "increased by more than positive delta",
    "Analogue input interrupt source", "Analogue input global interrupt enable",
    "Analogue input interrupt upper limit integer", "Analogue input interrupt lower limit integer",
    "Analogue input interrupt delta unsigned", "Analogue input interrupt negative delta unsigned",
    "Analogue input interrupt positive delta unsigned", "Analogue input interrupt upper limit float",
    "Analogue input interrupt lower limit float", "Analogue input interrupt delta float",
    "Analogue input interrupt negative delta float", "Analogue input interrupt positive delta float",
    "Analogue input offset float", "Analogue input scaling float", "Analogue input SI unit",
    "Analogue input offset integer", "Analogue input scaling integer", "Analogue output offset float",
    "Analogue output scaling float", "Analogue output error mode", "on an error", "keep the value",
    "take the error value", "book 3.4.2.11", "Analogue output error value integer",
    "Analogue output error value float", "Analogue output offset integer", "Analogue output scaling integer",
    "Analogue output SI unit", "CiA 301 §7.4.1",
);
