// Generated from `data/cia404.toml` by `cargo xtask profiles`: edit that file.

#![allow(unused_imports, reason = "not every document has facts of every kind")]

use std::borrow::Cow;

use crate::model::{Access, Access::*, DataType, ObjectType, ObjectType::*, Value, Value::*};
use crate::tables::{NeedRow::*, Term::*, *};
use crate::{Condition, Mapping::*, Profile};

pub(super) static PROFILE: Profile = Profile {
    group: "cia404",
    document: Cow::Borrowed("CiA 404"),
    title: Cow::Borrowed("measuring devices and closed-loop controllers"),
    version: Some(Cow::Borrowed("1.2")),
    number: Some(404),
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
    ObjectRow { first: 24576, last: 24576, name: Part(0, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 3), source: Part(0, 0) }, // 6000h DI read state 8 input lines
    ObjectRow { first: 24578, last: 24578, name: Part(54, 25), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(3, 3), source: Part(0, 0) }, // 6002h DI polarity 8 input lines
    ObjectRow { first: 24608, last: 24608, name: Part(79, 26), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(6, 3), source: Part(0, 0) }, // 6020h DI read state 1 input line
    ObjectRow { first: 24624, last: 24624, name: Part(105, 24), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(9, 3), source: Part(0, 0) }, // 6030h DI polarity 1 input line
    ObjectRow { first: 24832, last: 24832, name: Part(129, 11), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(12, 3), source: Part(0, 0) }, // 6100h AI input FV
    ObjectRow { first: 24835, last: 24835, name: Part(140, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(15, 3), source: Part(0, 0) }, // 6103h AI interrupt delta input FV
    ObjectRow { first: 24848, last: 24848, name: Part(167, 14), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(18, 3), source: Part(0, 0) }, // 6110h AI sensor type
    ObjectRow { first: 24849, last: 24849, name: Part(181, 18), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(21, 3), source: Part(0, 0) }, // 6111h AI autocalibration
    ObjectRow { first: 24850, last: 24850, name: Part(199, 17), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(24, 3), source: Part(0, 0) }, // 6112h AI operating mode
    ObjectRow { first: 24852, last: 24852, name: Part(242, 18), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(27, 3), source: Part(0, 0) }, // 6114h AI ADC sample rate
    ObjectRow { first: 24864, last: 24864, name: Part(260, 21), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(30, 3), source: Part(0, 0) }, // 6120h AI input scaling 1 FV
    ObjectRow { first: 24865, last: 24865, name: Part(281, 21), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(33, 3), source: Part(0, 0) }, // 6121h AI input scaling 1 PV
    ObjectRow { first: 24866, last: 24866, name: Part(302, 21), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(36, 3), source: Part(0, 0) }, // 6122h AI input scaling 2 FV
    ObjectRow { first: 24867, last: 24867, name: Part(323, 21), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(39, 3), source: Part(0, 0) }, // 6123h AI input scaling 2 PV
    ObjectRow { first: 24868, last: 24868, name: Part(344, 15), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(42, 3), source: Part(0, 0) }, // 6124h AI input offset
    ObjectRow { first: 24869, last: 24869, name: Part(359, 11), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(45, 3), source: Part(0, 0) }, // 6125h AI autozero
    ObjectRow { first: 24870, last: 24870, name: Part(370, 17), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(48, 3), source: Part(0, 0) }, // 6126h AI scaling factor
    ObjectRow { first: 24871, last: 24871, name: Part(387, 17), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(51, 3), source: Part(0, 0) }, // 6127h AI scaling offset
    ObjectRow { first: 24880, last: 24880, name: Part(404, 11), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(54, 3), source: Part(0, 0) }, // 6130h AI input PV
    ObjectRow { first: 24881, last: 24881, name: Part(415, 19), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(57, 3), source: Part(0, 0) }, // 6131h AI physical unit PV
    ObjectRow { first: 24882, last: 24882, name: Part(475, 20), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(60, 3), source: Part(0, 0) }, // 6132h AI decimal digits PV
    ObjectRow { first: 24883, last: 24883, name: Part(495, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(63, 3), source: Part(0, 0) }, // 6133h AI interrupt delta input PV
    ObjectRow { first: 24884, last: 24884, name: Part(522, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(66, 3), source: Part(0, 0) }, // 6134h AI interrupt lower input PV
    ObjectRow { first: 24885, last: 24885, name: Part(549, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(69, 3), source: Part(0, 0) }, // 6135h AI interrupt upper input PV
    ObjectRow { first: 24888, last: 24888, name: Part(576, 12), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(72, 3), source: Part(0, 0) }, // 6138h AI tare zero
    ObjectRow { first: 24889, last: 24889, name: Part(588, 11), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(75, 3), source: Part(0, 0) }, // 6139h AI autotare
    ObjectRow { first: 24896, last: 24896, name: Part(599, 9), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(78, 3), source: Part(0, 0) }, // 6140h AI net PV
    ObjectRow { first: 24899, last: 24899, name: Part(608, 25), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(81, 3), source: Part(0, 0) }, // 6143h AI interrupt delta net PV
    ObjectRow { first: 24900, last: 24900, name: Part(633, 31), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(84, 3), source: Part(0, 0) }, // 6144h AI interrupt lower limit net PV
    ObjectRow { first: 24901, last: 24901, name: Part(664, 31), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(87, 3), source: Part(0, 0) }, // 6145h AI interrupt upper limit net PV
    ObjectRow { first: 24904, last: 24904, name: Part(695, 13), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(90, 3), source: Part(0, 0) }, // 6148h AI span start
    ObjectRow { first: 24905, last: 24905, name: Part(708, 11), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(93, 3), source: Part(0, 0) }, // 6149h AI span end
    ObjectRow { first: 24912, last: 24912, name: Part(719, 9), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(96, 3), source: Part(0, 0) }, // 6150h AI status
    ObjectRow { first: 24928, last: 24928, name: Part(777, 15), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(99, 3), source: Part(0, 0) }, // 6160h AI control byte
    ObjectRow { first: 24929, last: 24929, name: Part(792, 22), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(102, 3), source: Part(0, 0) }, // 6161h AI control byte enable
    ObjectRow { first: 24992, last: 24992, name: Part(814, 14), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(105, 3), source: Part(0, 0) }, // 61A0h AI filter type
    ObjectRow { first: 24993, last: 24993, name: Part(890, 18), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(108, 3), source: Part(0, 0) }, // 61A1h AI filter constant
    ObjectRow { first: 25088, last: 25088, name: Part(908, 29), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(111, 3), source: Part(0, 0) }, // 6200h DO write state 8 output lines
    ObjectRow { first: 25090, last: 25090, name: Part(937, 26), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(114, 3), source: Part(0, 0) }, // 6202h DO polarity 8 output lines
    ObjectRow { first: 25094, last: 25094, name: Part(963, 28), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(117, 3), source: Part(0, 0) }, // 6206h DO fault mode 8 output lines
    ObjectRow { first: 25095, last: 25095, name: Part(991, 29), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(120, 3), source: Part(0, 0) }, // 6207h DO fault state 8 output lines
    ObjectRow { first: 25104, last: 25104, name: Part(1020, 29), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(123, 3), source: Part(0, 0) }, // 6210h DO link object 8 output lines
    ObjectRow { first: 25120, last: 25120, name: Part(1049, 28), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(126, 3), source: Part(0, 0) }, // 6220h DO write state 1 output line
    ObjectRow { first: 25152, last: 25152, name: Part(1077, 25), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(129, 3), source: Part(0, 0) }, // 6240h DO polarity 1 output line
    ObjectRow { first: 25168, last: 25168, name: Part(1102, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(132, 3), source: Part(0, 0) }, // 6250h DO fault mode 1 output line
    ObjectRow { first: 25184, last: 25184, name: Part(1129, 28), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(135, 3), source: Part(0, 0) }, // 6260h DO fault state 1 output line
    ObjectRow { first: 25216, last: 25216, name: Part(1157, 28), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(138, 3), source: Part(0, 0) }, // 6280h DO link object 1 output line
    ObjectRow { first: 25344, last: 25344, name: Part(1185, 12), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(141, 3), source: Part(0, 0) }, // 6300h AO output PV
    ObjectRow { first: 25345, last: 25345, name: Part(1197, 19), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(144, 3), source: Part(0, 0) }, // 6301h AO physical unit PV
    ObjectRow { first: 25346, last: 25346, name: Part(1216, 20), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(147, 3), source: Part(0, 0) }, // 6302h AO decimal digits PV
    ObjectRow { first: 25347, last: 25347, name: Part(1236, 17), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(150, 3), source: Part(0, 0) }, // 6303h AO link output PV
    ObjectRow { first: 25360, last: 25360, name: Part(1253, 14), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(153, 3), source: Part(0, 0) }, // 6310h AO output type
    ObjectRow { first: 25376, last: 25376, name: Part(1267, 22), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(156, 3), source: Part(0, 0) }, // 6320h AO output scaling 1 PV
    ObjectRow { first: 25377, last: 25377, name: Part(1289, 22), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(159, 3), source: Part(0, 0) }, // 6321h AO output scaling 1 FV
    ObjectRow { first: 25378, last: 25378, name: Part(1311, 22), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(162, 3), source: Part(0, 0) }, // 6322h AO output scaling 2 PV
    ObjectRow { first: 25379, last: 25379, name: Part(1333, 22), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(165, 3), source: Part(0, 0) }, // 6323h AO output scaling 2 FV
    ObjectRow { first: 25392, last: 25392, name: Part(1355, 12), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(168, 3), source: Part(0, 0) }, // 6330h AO output FV
    ObjectRow { first: 25393, last: 25393, name: Part(1367, 19), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(171, 3), source: Part(0, 0) }, // 6331h AO physical unit FV
    ObjectRow { first: 25394, last: 25394, name: Part(1386, 20), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(174, 3), source: Part(0, 0) }, // 6332h AO decimal digits FV
    ObjectRow { first: 25408, last: 25408, name: Part(1406, 13), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(177, 3), source: Part(0, 0) }, // 6340h AO fault mode
    ObjectRow { first: 25409, last: 25409, name: Part(1419, 11), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(180, 3), source: Part(0, 0) }, // 6341h AO fault FV
    ObjectRow { first: 25600, last: 25600, name: Part(1430, 31), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(183, 3), source: Part(0, 0) }, // 6400h CO effective current value Xeff
    ObjectRow { first: 25601, last: 25601, name: Part(1461, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(186, 3), source: Part(0, 0) }, // 6401h CO effective set point Weff
    ObjectRow { first: 25602, last: 25602, name: Part(1488, 14), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(189, 3), source: Part(0, 0) }, // 6402h CO set point W
    ObjectRow { first: 25603, last: 25603, name: Part(1502, 19), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(192, 3), source: Part(0, 0) }, // 6403h CO 2nd set point W2
    ObjectRow { first: 25604, last: 25604, name: Part(1521, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(195, 3), source: Part(0, 0) }, // 6404h CO lower set point limit W0
    ObjectRow { first: 25605, last: 25605, name: Part(1548, 29), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(198, 3), source: Part(0, 0) }, // 6405h CO upper set point limit W100
    ObjectRow { first: 25606, last: 25606, name: Part(1577, 19), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(201, 3), source: Part(0, 0) }, // 6406h CO physical unit XW
    ObjectRow { first: 25607, last: 25607, name: Part(1596, 20), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(204, 3), source: Part(0, 0) }, // 6407h CO decimal digits XW
    ObjectRow { first: 25616, last: 25616, name: Part(1616, 32), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(207, 3), source: Part(0, 0) }, // 6410h CO effective controller output Y
    ObjectRow { first: 25617, last: 25617, name: Part(1648, 39), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(210, 3), source: Part(0, 0) }, // 6411h CO differential controller output Ydiff
    ObjectRow { first: 25618, last: 25618, name: Part(1687, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(213, 3), source: Part(0, 0) }, // 6412h CO manual controller output
    ObjectRow { first: 25619, last: 25619, name: Part(1714, 37), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(216, 3), source: Part(0, 0) }, // 6413h CO lower controller output limit Ymin
    ObjectRow { first: 25620, last: 25620, name: Part(1751, 37), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(219, 3), source: Part(0, 0) }, // 6414h CO upper controller output limit Ymax
    ObjectRow { first: 25621, last: 25621, name: Part(1788, 34), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(222, 3), source: Part(0, 0) }, // 6415h CO physical unit controller output
    ObjectRow { first: 25632, last: 25632, name: Part(1822, 24), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(225, 3), source: Part(0, 0) }, // 6420h CO set point switch W-W2
    ObjectRow { first: 25633, last: 25633, name: Part(1846, 28), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(228, 3), source: Part(0, 0) }, // 6421h CO automatic/manual mode A-M
    ObjectRow { first: 25634, last: 25634, name: Part(1885, 20), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(231, 3), source: Part(0, 0) }, // 6422h CO controller on/off
    ObjectRow { first: 25635, last: 25635, name: Part(1918, 18), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(234, 3), source: Part(0, 0) }, // 6423h CO controller mode
    ObjectRow { first: 25636, last: 25636, name: Part(1936, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(237, 3), source: Part(0, 0) }, // 6424h CO self optimization on/off
    ObjectRow { first: 25637, last: 25637, name: Part(1963, 15), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(240, 3), source: Part(0, 0) }, // 6425h CO control byte
    ObjectRow { first: 25638, last: 25638, name: Part(1978, 22), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(243, 3), source: Part(0, 0) }, // 6426h CO control byte enable
    ObjectRow { first: 25639, last: 25639, name: Part(2000, 14), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(246, 3), source: Part(0, 0) }, // 6427h CO status word
    ObjectRow { first: 25648, last: 25648, name: Part(2014, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(249, 3), source: Part(0, 0) }, // 6430h CO minimum pulse time Tmin1
    ObjectRow { first: 25649, last: 25649, name: Part(2041, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(252, 3), source: Part(0, 0) }, // 6431h CO minimum pulse time Tmin2
    ObjectRow { first: 25650, last: 25650, name: Part(2068, 25), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(255, 3), source: Part(0, 0) }, // 6432h CO motor response time Tm
    ObjectRow { first: 25651, last: 25651, name: Part(2093, 25), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(258, 3), source: Part(0, 0) }, // 6433h CO min pulse length Tpuls
    ObjectRow { first: 25652, last: 25652, name: Part(2118, 29), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(261, 3), source: Part(0, 0) }, // 6434h CO physical unit pulse timing
    ObjectRow { first: 25653, last: 25653, name: Part(2147, 20), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(264, 3), source: Part(0, 0) }, // 6435h CO decimal digits PT
    ObjectRow { first: 25664, last: 25664, name: Part(2167, 32), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(267, 3), source: Part(0, 0) }, // 6440h CO neutral zone three-point Xsh1
    ObjectRow { first: 25665, last: 25665, name: Part(2199, 32), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(270, 3), source: Part(0, 0) }, // 6441h CO neutral zone three-point Xsh2
    ObjectRow { first: 25666, last: 25666, name: Part(2231, 40), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(273, 3), source: Part(0, 0) }, // 6442h CO neutral zone three-point stepping Xsh
    ObjectRow { first: 25667, last: 25667, name: Part(2271, 41), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(276, 3), source: Part(0, 0) }, // 6443h CO switching difference of signaller Xsd1
    ObjectRow { first: 25668, last: 25668, name: Part(2312, 50), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(279, 3), source: Part(0, 0) }, // 6444h CO switching difference of additional contact Xsd2
    ObjectRow { first: 25669, last: 25669, name: Part(2362, 52), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(282, 3), source: Part(0, 0) }, // 6445h CO trigger point separation of additional contact LW
    ObjectRow { first: 25680, last: 25680, name: Part(2414, 24), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(285, 3), source: Part(0, 0) }, // 6450h CO proportional band Xp1
    ObjectRow { first: 25681, last: 25681, name: Part(2438, 24), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(288, 3), source: Part(0, 0) }, // 6451h CO proportional band Xp2
    ObjectRow { first: 25682, last: 25682, name: Part(2462, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(291, 3), source: Part(0, 0) }, // 6452h CO integral action time Tn1
    ObjectRow { first: 25683, last: 25683, name: Part(2489, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(294, 3), source: Part(0, 0) }, // 6453h CO integral action time Tn2
    ObjectRow { first: 25684, last: 25684, name: Part(2516, 29), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(297, 3), source: Part(0, 0) }, // 6454h CO derivative action time Tv1
    ObjectRow { first: 25685, last: 25685, name: Part(2545, 29), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(300, 3), source: Part(0, 0) }, // 6455h CO derivative action time Tv2
    ObjectRow { first: 25686, last: 25686, name: Part(2574, 16), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(303, 3), source: Part(0, 0) }, // 6456h CO cycle time T1
    ObjectRow { first: 25687, last: 25687, name: Part(2590, 16), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(306, 3), source: Part(0, 0) }, // 6457h CO cycle time T2
    ObjectRow { first: 25688, last: 25688, name: Part(2606, 20), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(309, 3), source: Part(0, 0) }, // 6458h CO physical unit PID
    ObjectRow { first: 25689, last: 25689, name: Part(2626, 21), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(312, 3), source: Part(0, 0) }, // 6459h CO decimal digits PID
    ObjectRow { first: 25856, last: 25856, name: Part(2647, 14), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(315, 3), source: Part(0, 0) }, // 6500h AL input value
    ObjectRow { first: 25859, last: 25859, name: Part(2661, 13), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(318, 3), source: Part(0, 0) }, // 6503h AL link input
    ObjectRow { first: 25860, last: 25860, name: Part(2674, 24), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(321, 3), source: Part(0, 0) }, // 6504h AL alternate input value
    ObjectRow { first: 25861, last: 25861, name: Part(2698, 23), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(324, 3), source: Part(0, 0) }, // 6505h AL link alternate input
    ObjectRow { first: 25862, last: 25862, name: Part(2721, 13), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(327, 3), source: Part(0, 0) }, // 6506h AL fault mode
    ObjectRow { first: 25863, last: 25863, name: Part(2734, 14), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(330, 3), source: Part(0, 0) }, // 6507h AL fault state
    ObjectRow { first: 25864, last: 25864, name: Part(2772, 7), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(333, 3), source: Part(0, 0) }, // 6508h AL type
    ObjectRow { first: 25865, last: 25865, name: Part(2779, 9), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(336, 3), source: Part(0, 0) }, // 6509h AL action
    ObjectRow { first: 25866, last: 25866, name: Part(2788, 8), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(339, 3), source: Part(0, 0) }, // 650Ah AL level
    ObjectRow { first: 25867, last: 25867, name: Part(2796, 13), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(342, 3), source: Part(0, 0) }, // 650Bh AL hysteresis
    ObjectRow { first: 25868, last: 25868, name: Part(2809, 8), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(345, 3), source: Part(0, 0) }, // 650Ch AL group
    ObjectRow { first: 25869, last: 25869, name: Part(2817, 8), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(348, 3), source: Part(0, 0) }, // 650Dh AL state
    ObjectRow { first: 25870, last: 25870, name: Part(2830, 8), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(351, 3), source: Part(0, 0) }, // 650Eh AL reset
    ObjectRow { first: 26112, last: 26112, name: Part(2853, 15), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(354, 3), source: Part(0, 0) }, // 6600h AL 1 to 8 state
    ObjectRow { first: 26113, last: 26113, name: Part(2924, 16), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(357, 3), source: Part(0, 0) }, // 6601h AL 9 to 16 state
    ObjectRow { first: 26114, last: 26114, name: Part(3011, 16), object_types: Part(2, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(360, 1), source: Part(0, 0) }, // 6602h AL general state
    ObjectRow { first: 26115, last: 26115, name: Part(3179, 21), object_types: Part(2, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(361, 1), source: Part(0, 0) }, // 6603h AL group 1 to 8 state
    ObjectRow { first: 26128, last: 26128, name: Part(3216, 16), object_types: Part(2, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(362, 1), source: Part(0, 0) }, // 6610h AL general reset
    ObjectRow { first: 26129, last: 26129, name: Part(3232, 15), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(363, 3), source: Part(0, 0) }, // 6611h AL 1 to 8 reset
    ObjectRow { first: 26130, last: 26130, name: Part(3351, 16), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(366, 3), source: Part(0, 0) }, // 6612h AL 9 to 16 reset
    ObjectRow { first: 28448, last: 28448, name: Part(3478, 12), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(369, 3), source: Part(0, 0) }, // 6F20h Life counter
    ObjectRow { first: 28464, last: 28464, name: Part(3490, 17), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(372, 3), source: Part(0, 0) }, // 6F30h Receive PDO check
    ObjectRow { first: 28465, last: 28465, name: Part(3507, 18), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(375, 3), source: Part(0, 0) }, // 6F31h Transmit PDO check
    ObjectRow { first: 28496, last: 28496, name: Part(3525, 10), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(378, 3), source: Part(0, 0) }, // 6F50h Receive PV
    ObjectRow { first: 28497, last: 28497, name: Part(3535, 20), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(381, 3), source: Part(0, 0) }, // 6F51h Alternate receive PV
    ObjectRow { first: 28498, last: 28498, name: Part(3555, 15), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(384, 3), source: Part(0, 0) }, // 6F52h Received status
    ObjectRow { first: 28499, last: 28499, name: Part(3570, 25), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(387, 3), source: Part(0, 0) }, // 6F53h Alternate received status
    ObjectRow { first: 28512, last: 28512, name: Part(3595, 19), object_types: Part(2, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(390, 1), source: Part(0, 0) }, // 6F60h Transmission enable
    ObjectRow { first: 28928, last: 28928, name: Part(129, 11), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(391, 3), source: Part(0, 0) }, // 7100h AI input FV
    ObjectRow { first: 28931, last: 28931, name: Part(140, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(394, 3), source: Part(0, 0) }, // 7103h AI interrupt delta input FV
    ObjectRow { first: 28960, last: 28960, name: Part(260, 21), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(397, 3), source: Part(0, 0) }, // 7120h AI input scaling 1 FV
    ObjectRow { first: 28961, last: 28961, name: Part(281, 21), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(400, 3), source: Part(0, 0) }, // 7121h AI input scaling 1 PV
    ObjectRow { first: 28962, last: 28962, name: Part(302, 21), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(403, 3), source: Part(0, 0) }, // 7122h AI input scaling 2 FV
    ObjectRow { first: 28963, last: 28963, name: Part(323, 21), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(406, 3), source: Part(0, 0) }, // 7123h AI input scaling 2 PV
    ObjectRow { first: 28964, last: 28964, name: Part(344, 15), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(409, 3), source: Part(0, 0) }, // 7124h AI input offset
    ObjectRow { first: 28976, last: 28976, name: Part(404, 11), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(412, 3), source: Part(0, 0) }, // 7130h AI input PV
    ObjectRow { first: 28979, last: 28979, name: Part(495, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(415, 3), source: Part(0, 0) }, // 7133h AI interrupt delta input PV
    ObjectRow { first: 28980, last: 28980, name: Part(522, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(418, 3), source: Part(0, 0) }, // 7134h AI interrupt lower input PV
    ObjectRow { first: 28981, last: 28981, name: Part(549, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(421, 3), source: Part(0, 0) }, // 7135h AI interrupt upper input PV
    ObjectRow { first: 28984, last: 28984, name: Part(576, 12), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(424, 3), source: Part(0, 0) }, // 7138h AI tare zero
    ObjectRow { first: 28992, last: 28992, name: Part(599, 9), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(427, 3), source: Part(0, 0) }, // 7140h AI net PV
    ObjectRow { first: 28995, last: 28995, name: Part(608, 25), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(430, 3), source: Part(0, 0) }, // 7143h AI interrupt delta net PV
    ObjectRow { first: 28996, last: 28996, name: Part(633, 31), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(433, 3), source: Part(0, 0) }, // 7144h AI interrupt lower limit net PV
    ObjectRow { first: 28997, last: 28997, name: Part(664, 31), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(436, 3), source: Part(0, 0) }, // 7145h AI interrupt upper limit net PV
    ObjectRow { first: 29000, last: 29000, name: Part(695, 13), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(439, 3), source: Part(0, 0) }, // 7148h AI span start
    ObjectRow { first: 29001, last: 29001, name: Part(708, 11), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(442, 3), source: Part(0, 0) }, // 7149h AI span end
    ObjectRow { first: 29440, last: 29440, name: Part(1185, 12), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(445, 3), source: Part(0, 0) }, // 7300h AO output PV
    ObjectRow { first: 29472, last: 29472, name: Part(1267, 22), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(448, 3), source: Part(0, 0) }, // 7320h AO output scaling 1 PV
    ObjectRow { first: 29473, last: 29473, name: Part(1289, 22), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(451, 3), source: Part(0, 0) }, // 7321h AO output scaling 1 FV
    ObjectRow { first: 29474, last: 29474, name: Part(1311, 22), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(454, 3), source: Part(0, 0) }, // 7322h AO output scaling 2 PV
    ObjectRow { first: 29475, last: 29475, name: Part(1333, 22), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(457, 3), source: Part(0, 0) }, // 7323h AO output scaling 2 FV
    ObjectRow { first: 29488, last: 29488, name: Part(1355, 12), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(460, 3), source: Part(0, 0) }, // 7330h AO output FV
    ObjectRow { first: 29505, last: 29505, name: Part(1419, 11), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(463, 3), source: Part(0, 0) }, // 7341h AO fault FV
    ObjectRow { first: 29696, last: 29696, name: Part(1430, 31), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(466, 3), source: Part(0, 0) }, // 7400h CO effective current value Xeff
    ObjectRow { first: 29697, last: 29697, name: Part(1461, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(469, 3), source: Part(0, 0) }, // 7401h CO effective set point Weff
    ObjectRow { first: 29698, last: 29698, name: Part(1488, 14), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(472, 3), source: Part(0, 0) }, // 7402h CO set point W
    ObjectRow { first: 29699, last: 29699, name: Part(1502, 19), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(475, 3), source: Part(0, 0) }, // 7403h CO 2nd set point W2
    ObjectRow { first: 29700, last: 29700, name: Part(1521, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(478, 3), source: Part(0, 0) }, // 7404h CO lower set point limit W0
    ObjectRow { first: 29701, last: 29701, name: Part(1548, 29), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(481, 3), source: Part(0, 0) }, // 7405h CO upper set point limit W100
    ObjectRow { first: 29744, last: 29744, name: Part(2014, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(484, 3), source: Part(0, 0) }, // 7430h CO minimum pulse time Tmin1
    ObjectRow { first: 29745, last: 29745, name: Part(2041, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(487, 3), source: Part(0, 0) }, // 7431h CO minimum pulse time Tmin2
    ObjectRow { first: 29746, last: 29746, name: Part(2068, 25), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(490, 3), source: Part(0, 0) }, // 7432h CO motor response time Tm
    ObjectRow { first: 29747, last: 29747, name: Part(2093, 25), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(493, 3), source: Part(0, 0) }, // 7433h CO min pulse length Tpuls
    ObjectRow { first: 29760, last: 29760, name: Part(2167, 32), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(496, 3), source: Part(0, 0) }, // 7440h CO neutral zone three-point Xsh1
    ObjectRow { first: 29761, last: 29761, name: Part(2199, 32), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(499, 3), source: Part(0, 0) }, // 7441h CO neutral zone three-point Xsh2
    ObjectRow { first: 29762, last: 29762, name: Part(2231, 40), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(502, 3), source: Part(0, 0) }, // 7442h CO neutral zone three-point stepping Xsh
    ObjectRow { first: 29763, last: 29763, name: Part(2271, 41), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(505, 3), source: Part(0, 0) }, // 7443h CO switching difference of signaller Xsd1
    ObjectRow { first: 29764, last: 29764, name: Part(2312, 50), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(508, 3), source: Part(0, 0) }, // 7444h CO switching difference of additional contact Xsd2
    ObjectRow { first: 29765, last: 29765, name: Part(2362, 52), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(511, 3), source: Part(0, 0) }, // 7445h CO trigger point separation of additional contact LW
    ObjectRow { first: 29776, last: 29776, name: Part(2414, 24), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(514, 3), source: Part(0, 0) }, // 7450h CO proportional band Xp1
    ObjectRow { first: 29777, last: 29777, name: Part(2438, 24), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(517, 3), source: Part(0, 0) }, // 7451h CO proportional band Xp2
    ObjectRow { first: 29778, last: 29778, name: Part(2462, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(520, 3), source: Part(0, 0) }, // 7452h CO integral action time Tn1
    ObjectRow { first: 29779, last: 29779, name: Part(2489, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(523, 3), source: Part(0, 0) }, // 7453h CO integral action time Tn2
    ObjectRow { first: 29780, last: 29780, name: Part(2516, 29), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(526, 3), source: Part(0, 0) }, // 7454h CO derivative action time Tv1
    ObjectRow { first: 29781, last: 29781, name: Part(2545, 29), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(529, 3), source: Part(0, 0) }, // 7455h CO derivative action time Tv2
    ObjectRow { first: 29782, last: 29782, name: Part(2574, 16), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(532, 3), source: Part(0, 0) }, // 7456h CO cycle time T1
    ObjectRow { first: 29783, last: 29783, name: Part(2590, 16), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(535, 3), source: Part(0, 0) }, // 7457h CO cycle time T2
    ObjectRow { first: 29952, last: 29952, name: Part(2647, 14), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(538, 3), source: Part(0, 0) }, // 7500h AL input value
    ObjectRow { first: 29956, last: 29956, name: Part(2674, 24), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(541, 3), source: Part(0, 0) }, // 7504h AL alternate input value
    ObjectRow { first: 29962, last: 29962, name: Part(2788, 8), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(544, 3), source: Part(0, 0) }, // 750Ah AL level
    ObjectRow { first: 29963, last: 29963, name: Part(2796, 13), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(547, 3), source: Part(0, 0) }, // 750Bh AL hysteresis
    ObjectRow { first: 32592, last: 32592, name: Part(3525, 10), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(550, 3), source: Part(0, 0) }, // 7F50h Receive PV
    ObjectRow { first: 32593, last: 32593, name: Part(3535, 20), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(553, 3), source: Part(0, 0) }, // 7F51h Alternate receive PV
    ObjectRow { first: 33024, last: 33024, name: Part(129, 11), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(556, 3), source: Part(0, 0) }, // 8100h AI input FV
    ObjectRow { first: 33027, last: 33027, name: Part(140, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(559, 3), source: Part(0, 0) }, // 8103h AI interrupt delta input FV
    ObjectRow { first: 33056, last: 33056, name: Part(260, 21), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(562, 3), source: Part(0, 0) }, // 8120h AI input scaling 1 FV
    ObjectRow { first: 33057, last: 33057, name: Part(281, 21), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(565, 3), source: Part(0, 0) }, // 8121h AI input scaling 1 PV
    ObjectRow { first: 33058, last: 33058, name: Part(302, 21), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(568, 3), source: Part(0, 0) }, // 8122h AI input scaling 2 FV
    ObjectRow { first: 33059, last: 33059, name: Part(323, 21), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(571, 3), source: Part(0, 0) }, // 8123h AI input scaling 2 PV
    ObjectRow { first: 33060, last: 33060, name: Part(344, 15), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(574, 3), source: Part(0, 0) }, // 8124h AI input offset
    ObjectRow { first: 33072, last: 33072, name: Part(404, 11), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(577, 3), source: Part(0, 0) }, // 8130h AI input PV
    ObjectRow { first: 33075, last: 33075, name: Part(495, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(580, 3), source: Part(0, 0) }, // 8133h AI interrupt delta input PV
    ObjectRow { first: 33076, last: 33076, name: Part(522, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(583, 3), source: Part(0, 0) }, // 8134h AI interrupt lower input PV
    ObjectRow { first: 33077, last: 33077, name: Part(549, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(586, 3), source: Part(0, 0) }, // 8135h AI interrupt upper input PV
    ObjectRow { first: 33080, last: 33080, name: Part(576, 12), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(589, 3), source: Part(0, 0) }, // 8138h AI tare zero
    ObjectRow { first: 33088, last: 33088, name: Part(599, 9), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(592, 3), source: Part(0, 0) }, // 8140h AI net PV
    ObjectRow { first: 33091, last: 33091, name: Part(608, 25), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(595, 3), source: Part(0, 0) }, // 8143h AI interrupt delta net PV
    ObjectRow { first: 33092, last: 33092, name: Part(633, 31), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(598, 3), source: Part(0, 0) }, // 8144h AI interrupt lower limit net PV
    ObjectRow { first: 33093, last: 33093, name: Part(664, 31), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(601, 3), source: Part(0, 0) }, // 8145h AI interrupt upper limit net PV
    ObjectRow { first: 33096, last: 33096, name: Part(695, 13), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(604, 3), source: Part(0, 0) }, // 8148h AI span start
    ObjectRow { first: 33097, last: 33097, name: Part(708, 11), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(607, 3), source: Part(0, 0) }, // 8149h AI span end
    ObjectRow { first: 33536, last: 33536, name: Part(1185, 12), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(610, 3), source: Part(0, 0) }, // 8300h AO output PV
    ObjectRow { first: 33568, last: 33568, name: Part(1267, 22), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(613, 3), source: Part(0, 0) }, // 8320h AO output scaling 1 PV
    ObjectRow { first: 33569, last: 33569, name: Part(1289, 22), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(616, 3), source: Part(0, 0) }, // 8321h AO output scaling 1 FV
    ObjectRow { first: 33570, last: 33570, name: Part(1311, 22), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(619, 3), source: Part(0, 0) }, // 8322h AO output scaling 2 PV
    ObjectRow { first: 33571, last: 33571, name: Part(1333, 22), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(622, 3), source: Part(0, 0) }, // 8323h AO output scaling 2 FV
    ObjectRow { first: 33584, last: 33584, name: Part(1355, 12), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(625, 3), source: Part(0, 0) }, // 8330h AO output FV
    ObjectRow { first: 33601, last: 33601, name: Part(1419, 11), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(628, 3), source: Part(0, 0) }, // 8341h AO fault FV
    ObjectRow { first: 33792, last: 33792, name: Part(1430, 31), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(631, 3), source: Part(0, 0) }, // 8400h CO effective current value Xeff
    ObjectRow { first: 33793, last: 33793, name: Part(1461, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(634, 3), source: Part(0, 0) }, // 8401h CO effective set point Weff
    ObjectRow { first: 33794, last: 33794, name: Part(1488, 14), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(637, 3), source: Part(0, 0) }, // 8402h CO set point W
    ObjectRow { first: 33795, last: 33795, name: Part(1502, 19), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(640, 3), source: Part(0, 0) }, // 8403h CO 2nd set point W2
    ObjectRow { first: 33796, last: 33796, name: Part(1521, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(643, 3), source: Part(0, 0) }, // 8404h CO lower set point limit W0
    ObjectRow { first: 33797, last: 33797, name: Part(1548, 29), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(646, 3), source: Part(0, 0) }, // 8405h CO upper set point limit W100
    ObjectRow { first: 33840, last: 33840, name: Part(2014, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(649, 3), source: Part(0, 0) }, // 8430h CO minimum pulse time Tmin1
    ObjectRow { first: 33841, last: 33841, name: Part(2041, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(652, 3), source: Part(0, 0) }, // 8431h CO minimum pulse time Tmin2
    ObjectRow { first: 33842, last: 33842, name: Part(2068, 25), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(655, 3), source: Part(0, 0) }, // 8432h CO motor response time Tm
    ObjectRow { first: 33843, last: 33843, name: Part(2093, 25), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(658, 3), source: Part(0, 0) }, // 8433h CO min pulse length Tpuls
    ObjectRow { first: 33856, last: 33856, name: Part(2167, 32), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(661, 3), source: Part(0, 0) }, // 8440h CO neutral zone three-point Xsh1
    ObjectRow { first: 33857, last: 33857, name: Part(2199, 32), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(664, 3), source: Part(0, 0) }, // 8441h CO neutral zone three-point Xsh2
    ObjectRow { first: 33858, last: 33858, name: Part(2231, 40), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(667, 3), source: Part(0, 0) }, // 8442h CO neutral zone three-point stepping Xsh
    ObjectRow { first: 33859, last: 33859, name: Part(2271, 41), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(670, 3), source: Part(0, 0) }, // 8443h CO switching difference of signaller Xsd1
    ObjectRow { first: 33860, last: 33860, name: Part(2312, 50), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(673, 3), source: Part(0, 0) }, // 8444h CO switching difference of additional contact Xsd2
    ObjectRow { first: 33861, last: 33861, name: Part(2362, 52), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(676, 3), source: Part(0, 0) }, // 8445h CO trigger point separation of additional contact LW
    ObjectRow { first: 33872, last: 33872, name: Part(2414, 24), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(679, 3), source: Part(0, 0) }, // 8450h CO proportional band Xp1
    ObjectRow { first: 33873, last: 33873, name: Part(2438, 24), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(682, 3), source: Part(0, 0) }, // 8451h CO proportional band Xp2
    ObjectRow { first: 33874, last: 33874, name: Part(2462, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(685, 3), source: Part(0, 0) }, // 8452h CO integral action time Tn1
    ObjectRow { first: 33875, last: 33875, name: Part(2489, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(688, 3), source: Part(0, 0) }, // 8453h CO integral action time Tn2
    ObjectRow { first: 33876, last: 33876, name: Part(2516, 29), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(691, 3), source: Part(0, 0) }, // 8454h CO derivative action time Tv1
    ObjectRow { first: 33877, last: 33877, name: Part(2545, 29), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(694, 3), source: Part(0, 0) }, // 8455h CO derivative action time Tv2
    ObjectRow { first: 33878, last: 33878, name: Part(2574, 16), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(697, 3), source: Part(0, 0) }, // 8456h CO cycle time T1
    ObjectRow { first: 33879, last: 33879, name: Part(2590, 16), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(700, 3), source: Part(0, 0) }, // 8457h CO cycle time T2
    ObjectRow { first: 34048, last: 34048, name: Part(2647, 14), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(703, 3), source: Part(0, 0) }, // 8500h AL input value
    ObjectRow { first: 34052, last: 34052, name: Part(2674, 24), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(706, 3), source: Part(0, 0) }, // 8504h AL alternate input value
    ObjectRow { first: 34058, last: 34058, name: Part(2788, 8), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(709, 3), source: Part(0, 0) }, // 850Ah AL level
    ObjectRow { first: 34059, last: 34059, name: Part(2796, 13), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(712, 3), source: Part(0, 0) }, // 850Bh AL hysteresis
    ObjectRow { first: 36688, last: 36688, name: Part(3525, 10), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(715, 3), source: Part(0, 0) }, // 8F50h Receive PV
    ObjectRow { first: 36689, last: 36689, name: Part(3535, 20), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(718, 3), source: Part(0, 0) }, // 8F51h Alternate receive PV
    ObjectRow { first: 37120, last: 37120, name: Part(129, 11), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(721, 3), source: Part(0, 0) }, // 9100h AI input FV
    ObjectRow { first: 37123, last: 37123, name: Part(140, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(724, 3), source: Part(0, 0) }, // 9103h AI interrupt delta input FV
    ObjectRow { first: 37152, last: 37152, name: Part(260, 21), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(727, 3), source: Part(0, 0) }, // 9120h AI input scaling 1 FV
    ObjectRow { first: 37153, last: 37153, name: Part(281, 21), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(730, 3), source: Part(0, 0) }, // 9121h AI input scaling 1 PV
    ObjectRow { first: 37154, last: 37154, name: Part(302, 21), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(733, 3), source: Part(0, 0) }, // 9122h AI input scaling 2 FV
    ObjectRow { first: 37155, last: 37155, name: Part(323, 21), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(736, 3), source: Part(0, 0) }, // 9123h AI input scaling 2 PV
    ObjectRow { first: 37156, last: 37156, name: Part(344, 15), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(739, 3), source: Part(0, 0) }, // 9124h AI input offset
    ObjectRow { first: 37168, last: 37168, name: Part(404, 11), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(742, 3), source: Part(0, 0) }, // 9130h AI input PV
    ObjectRow { first: 37171, last: 37171, name: Part(495, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(745, 3), source: Part(0, 0) }, // 9133h AI interrupt delta input PV
    ObjectRow { first: 37172, last: 37172, name: Part(522, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(748, 3), source: Part(0, 0) }, // 9134h AI interrupt lower input PV
    ObjectRow { first: 37173, last: 37173, name: Part(549, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(751, 3), source: Part(0, 0) }, // 9135h AI interrupt upper input PV
    ObjectRow { first: 37176, last: 37176, name: Part(576, 12), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(754, 3), source: Part(0, 0) }, // 9138h AI tare zero
    ObjectRow { first: 37184, last: 37184, name: Part(599, 9), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(757, 3), source: Part(0, 0) }, // 9140h AI net PV
    ObjectRow { first: 37187, last: 37187, name: Part(608, 25), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(760, 3), source: Part(0, 0) }, // 9143h AI interrupt delta net PV
    ObjectRow { first: 37188, last: 37188, name: Part(633, 31), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(763, 3), source: Part(0, 0) }, // 9144h AI interrupt lower limit net PV
    ObjectRow { first: 37189, last: 37189, name: Part(664, 31), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(766, 3), source: Part(0, 0) }, // 9145h AI interrupt upper limit net PV
    ObjectRow { first: 37192, last: 37192, name: Part(695, 13), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(769, 3), source: Part(0, 0) }, // 9148h AI span start
    ObjectRow { first: 37193, last: 37193, name: Part(708, 11), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(772, 3), source: Part(0, 0) }, // 9149h AI span end
    ObjectRow { first: 37632, last: 37632, name: Part(1185, 12), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(775, 3), source: Part(0, 0) }, // 9300h AO output PV
    ObjectRow { first: 37664, last: 37664, name: Part(1267, 22), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(778, 3), source: Part(0, 0) }, // 9320h AO output scaling 1 PV
    ObjectRow { first: 37665, last: 37665, name: Part(1289, 22), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(781, 3), source: Part(0, 0) }, // 9321h AO output scaling 1 FV
    ObjectRow { first: 37666, last: 37666, name: Part(1311, 22), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(784, 3), source: Part(0, 0) }, // 9322h AO output scaling 2 PV
    ObjectRow { first: 37667, last: 37667, name: Part(1333, 22), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(787, 3), source: Part(0, 0) }, // 9323h AO output scaling 2 FV
    ObjectRow { first: 37680, last: 37680, name: Part(1355, 12), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(790, 3), source: Part(0, 0) }, // 9330h AO output FV
    ObjectRow { first: 37697, last: 37697, name: Part(1419, 11), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(793, 3), source: Part(0, 0) }, // 9341h AO fault FV
    ObjectRow { first: 37888, last: 37888, name: Part(1430, 31), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(796, 3), source: Part(0, 0) }, // 9400h CO effective current value Xeff
    ObjectRow { first: 37889, last: 37889, name: Part(1461, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(799, 3), source: Part(0, 0) }, // 9401h CO effective set point Weff
    ObjectRow { first: 37890, last: 37890, name: Part(1488, 14), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(802, 3), source: Part(0, 0) }, // 9402h CO set point W
    ObjectRow { first: 37891, last: 37891, name: Part(1502, 19), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(805, 3), source: Part(0, 0) }, // 9403h CO 2nd set point W2
    ObjectRow { first: 37892, last: 37892, name: Part(1521, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(808, 3), source: Part(0, 0) }, // 9404h CO lower set point limit W0
    ObjectRow { first: 37893, last: 37893, name: Part(1548, 29), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(811, 3), source: Part(0, 0) }, // 9405h CO upper set point limit W100
    ObjectRow { first: 37936, last: 37936, name: Part(2014, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(814, 3), source: Part(0, 0) }, // 9430h CO minimum pulse time Tmin1
    ObjectRow { first: 37937, last: 37937, name: Part(2041, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(817, 3), source: Part(0, 0) }, // 9431h CO minimum pulse time Tmin2
    ObjectRow { first: 37938, last: 37938, name: Part(2068, 25), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(820, 3), source: Part(0, 0) }, // 9432h CO motor response time Tm
    ObjectRow { first: 37939, last: 37939, name: Part(2093, 25), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(823, 3), source: Part(0, 0) }, // 9433h CO min pulse length Tpuls
    ObjectRow { first: 37952, last: 37952, name: Part(2167, 32), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(826, 3), source: Part(0, 0) }, // 9440h CO neutral zone three-point Xsh1
    ObjectRow { first: 37953, last: 37953, name: Part(2199, 32), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(829, 3), source: Part(0, 0) }, // 9441h CO neutral zone three-point Xsh2
    ObjectRow { first: 37954, last: 37954, name: Part(2231, 40), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(832, 3), source: Part(0, 0) }, // 9442h CO neutral zone three-point stepping Xsh
    ObjectRow { first: 37955, last: 37955, name: Part(2271, 41), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(835, 3), source: Part(0, 0) }, // 9443h CO switching difference of signaller Xsd1
    ObjectRow { first: 37956, last: 37956, name: Part(2312, 50), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(838, 3), source: Part(0, 0) }, // 9444h CO switching difference of additional contact Xsd2
    ObjectRow { first: 37957, last: 37957, name: Part(2362, 52), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(841, 3), source: Part(0, 0) }, // 9445h CO trigger point separation of additional contact LW
    ObjectRow { first: 37968, last: 37968, name: Part(2414, 24), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(844, 3), source: Part(0, 0) }, // 9450h CO proportional band Xp1
    ObjectRow { first: 37969, last: 37969, name: Part(2438, 24), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(847, 3), source: Part(0, 0) }, // 9451h CO proportional band Xp2
    ObjectRow { first: 37970, last: 37970, name: Part(2462, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(850, 3), source: Part(0, 0) }, // 9452h CO integral action time Tn1
    ObjectRow { first: 37971, last: 37971, name: Part(2489, 27), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(853, 3), source: Part(0, 0) }, // 9453h CO integral action time Tn2
    ObjectRow { first: 37972, last: 37972, name: Part(2516, 29), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(856, 3), source: Part(0, 0) }, // 9454h CO derivative action time Tv1
    ObjectRow { first: 37973, last: 37973, name: Part(2545, 29), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(859, 3), source: Part(0, 0) }, // 9455h CO derivative action time Tv2
    ObjectRow { first: 37974, last: 37974, name: Part(2574, 16), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(862, 3), source: Part(0, 0) }, // 9456h CO cycle time T1
    ObjectRow { first: 37975, last: 37975, name: Part(2590, 16), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(865, 3), source: Part(0, 0) }, // 9457h CO cycle time T2
    ObjectRow { first: 38144, last: 38144, name: Part(2647, 14), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(868, 3), source: Part(0, 0) }, // 9500h AL input value
    ObjectRow { first: 38148, last: 38148, name: Part(2674, 24), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(871, 3), source: Part(0, 0) }, // 9504h AL alternate input value
    ObjectRow { first: 38154, last: 38154, name: Part(2788, 8), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(874, 3), source: Part(0, 0) }, // 950Ah AL level
    ObjectRow { first: 38155, last: 38155, name: Part(2796, 13), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(877, 3), source: Part(0, 0) }, // 950Bh AL hysteresis
    ObjectRow { first: 40784, last: 40784, name: Part(3525, 10), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(880, 3), source: Part(0, 0) }, // 9F50h Receive PV
    ObjectRow { first: 40785, last: 40785, name: Part(3535, 20), object_types: Part(0, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(883, 3), source: Part(0, 0) }, // 9F51h Alternate receive PV
];

static ENTRIES: &[EntryRow] = &[
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(0, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // DI read state 8 input lines
    EntryRow { first: 2, last: 199, mapping: Some(Tpdo), need: Optional, name: Part(0, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // DI read state 8 input lines
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(54, 25), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // DI polarity 8 input lines
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(54, 25), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // DI polarity 8 input lines
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(79, 26), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // DI read state 1 input line
    EntryRow { first: 2, last: 199, mapping: Some(Tpdo), need: Optional, name: Part(79, 26), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // DI read state 1 input line
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(105, 24), data_types: Part(1, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // DI polarity 1 input line
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(105, 24), data_types: Part(1, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // DI polarity 1 input line
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(129, 11), data_types: Part(2, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input FV
    EntryRow { first: 2, last: 199, mapping: Some(Tpdo), need: Optional, name: Part(129, 11), data_types: Part(2, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(140, 27), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt delta input FV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(140, 27), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt delta input FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(167, 14), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI sensor type
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(167, 14), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI sensor type
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(181, 18), data_types: Part(4, 1), access: Part(2, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI autocalibration
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(181, 18), data_types: Part(4, 1), access: Part(2, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI autocalibration
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(199, 17), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 1) }, // AI operating mode
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(199, 17), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 1) }, // AI operating mode
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(242, 18), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI ADC sample rate
    EntryRow { first: 2, last: 199, mapping: Some(Tpdo), need: Optional, name: Part(242, 18), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI ADC sample rate
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(260, 21), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 1 FV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(260, 21), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 1 FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(281, 21), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 1 PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(281, 21), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 1 PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(302, 21), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 2 FV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(302, 21), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 2 FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(323, 21), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 2 PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(323, 21), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 2 PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(344, 15), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input offset
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(344, 15), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input offset
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(359, 11), data_types: Part(4, 1), access: Part(2, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI autozero
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(359, 11), data_types: Part(4, 1), access: Part(2, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI autozero
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(370, 17), data_types: Part(2, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI scaling factor
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(370, 17), data_types: Part(2, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI scaling factor
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(387, 17), data_types: Part(2, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI scaling offset
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(387, 17), data_types: Part(2, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI scaling offset
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(404, 11), data_types: Part(2, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input PV
    EntryRow { first: 2, last: 199, mapping: Some(Tpdo), need: Optional, name: Part(404, 11), data_types: Part(2, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(415, 19), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(1, 3) }, // AI physical unit PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(415, 19), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(1, 3) }, // AI physical unit PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(475, 20), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI decimal digits PV
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(475, 20), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI decimal digits PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(495, 27), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt delta input PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(495, 27), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt delta input PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(522, 27), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt lower input PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(522, 27), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt lower input PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(549, 27), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt upper input PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(549, 27), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt upper input PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(576, 12), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI tare zero
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(576, 12), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI tare zero
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(588, 11), data_types: Part(4, 1), access: Part(2, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI autotare
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(588, 11), data_types: Part(4, 1), access: Part(2, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI autotare
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(599, 9), data_types: Part(2, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI net PV
    EntryRow { first: 2, last: 199, mapping: Some(Tpdo), need: Optional, name: Part(599, 9), data_types: Part(2, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI net PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(608, 25), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt delta net PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(608, 25), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt delta net PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(633, 31), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt lower limit net PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(633, 31), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt lower limit net PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(664, 31), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt upper limit net PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(664, 31), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt upper limit net PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(695, 13), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI span start
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(695, 13), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI span start
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(708, 11), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI span end
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(708, 11), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI span end
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(719, 9), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(4, 3) }, // AI status
    EntryRow { first: 2, last: 199, mapping: Some(Tpdo), need: Optional, name: Part(719, 9), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(4, 3) }, // AI status
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(777, 15), data_types: Part(0, 1), access: Part(2, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI control byte
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(777, 15), data_types: Part(0, 1), access: Part(2, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI control byte
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(792, 22), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI control byte enable
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(792, 22), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI control byte enable
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(814, 14), data_types: Part(0, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(7, 1) }, // AI filter type
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(814, 14), data_types: Part(0, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(7, 1) }, // AI filter type
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(890, 18), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI filter constant
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(890, 18), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI filter constant
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(908, 29), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // DO write state 8 output lines
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(908, 29), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // DO write state 8 output lines
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(937, 26), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // DO polarity 8 output lines
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(937, 26), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // DO polarity 8 output lines
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(963, 28), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // DO fault mode 8 output lines
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(963, 28), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // DO fault mode 8 output lines
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(991, 29), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // DO fault state 8 output lines
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(991, 29), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // DO fault state 8 output lines
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1020, 29), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // DO link object 8 output lines
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1020, 29), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // DO link object 8 output lines
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(1049, 28), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // DO write state 1 output line
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(1049, 28), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // DO write state 1 output line
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1077, 25), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // DO polarity 1 output line
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1077, 25), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // DO polarity 1 output line
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1102, 27), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // DO fault mode 1 output line
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1102, 27), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // DO fault mode 1 output line
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1129, 28), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // DO fault state 1 output line
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1129, 28), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // DO fault state 1 output line
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1157, 28), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // DO link object 1 output line
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1157, 28), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // DO link object 1 output line
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(1185, 12), data_types: Part(2, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output PV
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(1185, 12), data_types: Part(2, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1197, 19), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(1, 3) }, // AO physical unit PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1197, 19), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(1, 3) }, // AO physical unit PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1216, 20), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO decimal digits PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1216, 20), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO decimal digits PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1236, 17), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO link output PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1236, 17), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO link output PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1253, 14), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output type
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1253, 14), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output type
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1267, 22), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 1 PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1267, 22), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 1 PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1289, 22), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 1 FV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1289, 22), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 1 FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1311, 22), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 2 PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1311, 22), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 2 PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1333, 22), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 2 FV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1333, 22), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 2 FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1355, 12), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output FV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1355, 12), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1367, 19), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(1, 3) }, // AO physical unit FV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1367, 19), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(1, 3) }, // AO physical unit FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1386, 20), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO decimal digits FV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1386, 20), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO decimal digits FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1406, 13), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO fault mode
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1406, 13), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO fault mode
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1419, 11), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO fault FV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1419, 11), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO fault FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(1430, 31), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO effective current value Xeff
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(1430, 31), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO effective current value Xeff
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(1461, 27), data_types: Part(2, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO effective set point Weff
    EntryRow { first: 2, last: 199, mapping: Some(Tpdo), need: Optional, name: Part(1461, 27), data_types: Part(2, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO effective set point Weff
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(1488, 14), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO set point W
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(1488, 14), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO set point W
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(1502, 19), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO 2nd set point W2
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(1502, 19), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO 2nd set point W2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1521, 27), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO lower set point limit W0
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1521, 27), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO lower set point limit W0
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1548, 29), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO upper set point limit W100
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1548, 29), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO upper set point limit W100
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1577, 19), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(1, 3) }, // CO physical unit XW
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1577, 19), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(1, 3) }, // CO physical unit XW
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1596, 20), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO decimal digits XW
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1596, 20), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO decimal digits XW
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(1616, 32), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO effective controller output Y
    EntryRow { first: 2, last: 199, mapping: Some(Tpdo), need: Optional, name: Part(1616, 32), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO effective controller output Y
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(1648, 39), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO differential controller output Ydiff
    EntryRow { first: 2, last: 199, mapping: Some(Tpdo), need: Optional, name: Part(1648, 39), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO differential controller output Ydiff
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(1687, 27), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO manual controller output
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(1687, 27), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO manual controller output
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1714, 37), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO lower controller output limit Ymin
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1714, 37), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO lower controller output limit Ymin
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1751, 37), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO upper controller output limit Ymax
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1751, 37), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO upper controller output limit Ymax
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1788, 34), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(1, 3) }, // CO physical unit controller output
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1788, 34), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(1, 3) }, // CO physical unit controller output
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(1822, 24), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO set point switch W-W2
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(1822, 24), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO set point switch W-W2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(1846, 28), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(8, 1) }, // CO automatic/manual mode A-M
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(1846, 28), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(8, 1) }, // CO automatic/manual mode A-M
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(1885, 20), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(9, 1) }, // CO controller on/off
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(1885, 20), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(9, 1) }, // CO controller on/off
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(1918, 18), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO controller mode
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(1918, 18), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO controller mode
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(1936, 27), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO self optimization on/off
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(1936, 27), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO self optimization on/off
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(1963, 15), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO control byte
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(1963, 15), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO control byte
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1978, 22), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO control byte enable
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1978, 22), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO control byte enable
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(2000, 14), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO status word
    EntryRow { first: 2, last: 199, mapping: Some(Tpdo), need: Optional, name: Part(2000, 14), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO status word
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2014, 27), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO minimum pulse time Tmin1
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2014, 27), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO minimum pulse time Tmin1
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2041, 27), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO minimum pulse time Tmin2
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2041, 27), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO minimum pulse time Tmin2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2068, 25), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO motor response time Tm
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2068, 25), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO motor response time Tm
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2093, 25), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO min pulse length Tpuls
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2093, 25), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO min pulse length Tpuls
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2118, 29), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(1, 3) }, // CO physical unit pulse timing
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2118, 29), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(1, 3) }, // CO physical unit pulse timing
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2147, 20), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO decimal digits PT
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2147, 20), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO decimal digits PT
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2167, 32), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO neutral zone three-point Xsh1
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2167, 32), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO neutral zone three-point Xsh1
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2199, 32), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO neutral zone three-point Xsh2
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2199, 32), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO neutral zone three-point Xsh2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2231, 40), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO neutral zone three-point stepping Xsh
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2231, 40), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO neutral zone three-point stepping Xsh
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2271, 41), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO switching difference of signaller Xsd1
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2271, 41), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO switching difference of signaller Xsd1
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2312, 50), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO switching difference of additional contact Xsd2
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2312, 50), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO switching difference of additional contact Xsd2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2362, 52), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO trigger point separation of additional contact LW
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2362, 52), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO trigger point separation of additional contact LW
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2414, 24), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO proportional band Xp1
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2414, 24), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO proportional band Xp1
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2438, 24), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO proportional band Xp2
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2438, 24), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO proportional band Xp2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2462, 27), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO integral action time Tn1
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2462, 27), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO integral action time Tn1
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2489, 27), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO integral action time Tn2
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2489, 27), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO integral action time Tn2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2516, 29), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO derivative action time Tv1
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2516, 29), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO derivative action time Tv1
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2545, 29), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO derivative action time Tv2
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2545, 29), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO derivative action time Tv2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2574, 16), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO cycle time T1
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2574, 16), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO cycle time T1
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2590, 16), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO cycle time T2
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2590, 16), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO cycle time T2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2606, 20), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(1, 3) }, // CO physical unit PID
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2606, 20), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(1, 3) }, // CO physical unit PID
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2626, 21), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO decimal digits PID
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2626, 21), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO decimal digits PID
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(2647, 14), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL input value
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(2647, 14), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL input value
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2661, 13), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL link input
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2661, 13), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL link input
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2674, 24), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL alternate input value
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2674, 24), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL alternate input value
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2698, 23), data_types: Part(0, 0), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL link alternate input
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2698, 23), data_types: Part(0, 0), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL link alternate input
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2721, 13), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL fault mode
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2721, 13), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL fault mode
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2734, 14), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(10, 1) }, // AL fault state
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2734, 14), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(10, 1) }, // AL fault state
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2772, 7), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL type
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2772, 7), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL type
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2779, 9), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL action
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2779, 9), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL action
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2788, 8), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL level
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2788, 8), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL level
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2796, 13), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL hysteresis
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2796, 13), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL hysteresis
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2809, 8), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL group
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2809, 8), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL group
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(2817, 8), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(11, 1) }, // AL state
    EntryRow { first: 2, last: 199, mapping: Some(Tpdo), need: Optional, name: Part(2817, 8), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(11, 1) }, // AL state
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2830, 8), data_types: Part(1, 1), access: Part(2, 2), values: Part(0, 0), default: None, bits: Part(12, 1) }, // AL reset
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2830, 8), data_types: Part(1, 1), access: Part(2, 2), values: Part(0, 0), default: None, bits: Part(12, 1) }, // AL reset
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(2853, 15), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(13, 8) }, // AL 1 to 8 state
    EntryRow { first: 2, last: 199, mapping: Some(Tpdo), need: Optional, name: Part(2853, 15), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(13, 8) }, // AL 1 to 8 state
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(2924, 16), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(21, 8) }, // AL 9 to 16 state
    EntryRow { first: 2, last: 199, mapping: Some(Tpdo), need: Optional, name: Part(2924, 16), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(21, 8) }, // AL 9 to 16 state
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(29, 1) },
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(30, 8) },
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(4, 1), values: Part(0, 0), default: None, bits: Part(38, 1) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(3232, 15), data_types: Part(0, 1), access: Part(2, 2), values: Part(0, 0), default: None, bits: Part(39, 8) }, // AL 1 to 8 reset
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(3232, 15), data_types: Part(0, 1), access: Part(2, 2), values: Part(0, 0), default: None, bits: Part(39, 8) }, // AL 1 to 8 reset
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(3351, 16), data_types: Part(0, 1), access: Part(2, 2), values: Part(0, 0), default: None, bits: Part(47, 8) }, // AL 9 to 16 reset
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(3351, 16), data_types: Part(0, 1), access: Part(2, 2), values: Part(0, 0), default: None, bits: Part(47, 8) }, // AL 9 to 16 reset
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(3478, 12), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Life counter
    EntryRow { first: 2, last: 199, mapping: Some(Tpdo), need: Optional, name: Part(3478, 12), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Life counter
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(3490, 17), data_types: Part(0, 1), access: Part(2, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Receive PDO check
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(3490, 17), data_types: Part(0, 1), access: Part(2, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Receive PDO check
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(3507, 18), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Transmit PDO check
    EntryRow { first: 2, last: 199, mapping: Some(Tpdo), need: Optional, name: Part(3507, 18), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Transmit PDO check
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(3525, 10), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Receive PV
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(3525, 10), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Receive PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(3535, 20), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Alternate receive PV
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(3535, 20), data_types: Part(2, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Alternate receive PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(3555, 15), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Received status
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(3555, 15), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Received status
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(3570, 25), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Alternate received status
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(3570, 25), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Alternate received status
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(129, 11), data_types: Part(5, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input FV
    EntryRow { first: 2, last: 199, mapping: Some(Tpdo), need: Optional, name: Part(129, 11), data_types: Part(5, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(140, 27), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt delta input FV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(140, 27), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt delta input FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(260, 21), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 1 FV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(260, 21), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 1 FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(281, 21), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 1 PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(281, 21), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 1 PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(302, 21), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 2 FV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(302, 21), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 2 FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(323, 21), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 2 PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(323, 21), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 2 PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(344, 15), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input offset
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(344, 15), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input offset
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(404, 11), data_types: Part(5, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input PV
    EntryRow { first: 2, last: 199, mapping: Some(Tpdo), need: Optional, name: Part(404, 11), data_types: Part(5, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(495, 27), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt delta input PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(495, 27), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt delta input PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(522, 27), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt lower input PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(522, 27), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt lower input PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(549, 27), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt upper input PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(549, 27), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt upper input PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(576, 12), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI tare zero
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(576, 12), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI tare zero
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(599, 9), data_types: Part(5, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI net PV
    EntryRow { first: 2, last: 199, mapping: Some(Tpdo), need: Optional, name: Part(599, 9), data_types: Part(5, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI net PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(608, 25), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt delta net PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(608, 25), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt delta net PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(633, 31), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt lower limit net PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(633, 31), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt lower limit net PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(664, 31), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt upper limit net PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(664, 31), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt upper limit net PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(695, 13), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI span start
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(695, 13), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI span start
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(708, 11), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI span end
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(708, 11), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI span end
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(1185, 12), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output PV
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(1185, 12), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1267, 22), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 1 PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1267, 22), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 1 PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1289, 22), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 1 FV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1289, 22), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 1 FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1311, 22), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 2 PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1311, 22), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 2 PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1333, 22), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 2 FV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1333, 22), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 2 FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1355, 12), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output FV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1355, 12), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1419, 11), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO fault FV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1419, 11), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO fault FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(1430, 31), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO effective current value Xeff
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(1430, 31), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO effective current value Xeff
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(1461, 27), data_types: Part(5, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO effective set point Weff
    EntryRow { first: 2, last: 199, mapping: Some(Tpdo), need: Optional, name: Part(1461, 27), data_types: Part(5, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO effective set point Weff
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(1488, 14), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO set point W
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(1488, 14), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO set point W
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(1502, 19), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO 2nd set point W2
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(1502, 19), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO 2nd set point W2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1521, 27), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO lower set point limit W0
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1521, 27), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO lower set point limit W0
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1548, 29), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO upper set point limit W100
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1548, 29), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO upper set point limit W100
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2014, 27), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO minimum pulse time Tmin1
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2014, 27), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO minimum pulse time Tmin1
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2041, 27), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO minimum pulse time Tmin2
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2041, 27), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO minimum pulse time Tmin2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2068, 25), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO motor response time Tm
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2068, 25), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO motor response time Tm
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2093, 25), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO min pulse length Tpuls
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2093, 25), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO min pulse length Tpuls
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2167, 32), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO neutral zone three-point Xsh1
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2167, 32), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO neutral zone three-point Xsh1
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2199, 32), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO neutral zone three-point Xsh2
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2199, 32), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO neutral zone three-point Xsh2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2231, 40), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO neutral zone three-point stepping Xsh
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2231, 40), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO neutral zone three-point stepping Xsh
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2271, 41), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO switching difference of signaller Xsd1
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2271, 41), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO switching difference of signaller Xsd1
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2312, 50), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO switching difference of additional contact Xsd2
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2312, 50), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO switching difference of additional contact Xsd2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2362, 52), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO trigger point separation of additional contact LW
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2362, 52), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO trigger point separation of additional contact LW
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2414, 24), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO proportional band Xp1
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2414, 24), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO proportional band Xp1
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2438, 24), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO proportional band Xp2
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2438, 24), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO proportional band Xp2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2462, 27), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO integral action time Tn1
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2462, 27), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO integral action time Tn1
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2489, 27), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO integral action time Tn2
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2489, 27), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO integral action time Tn2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2516, 29), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO derivative action time Tv1
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2516, 29), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO derivative action time Tv1
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2545, 29), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO derivative action time Tv2
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2545, 29), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO derivative action time Tv2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2574, 16), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO cycle time T1
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2574, 16), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO cycle time T1
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2590, 16), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO cycle time T2
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2590, 16), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO cycle time T2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(2647, 14), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL input value
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(2647, 14), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL input value
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2674, 24), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL alternate input value
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2674, 24), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL alternate input value
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2788, 8), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL level
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2788, 8), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL level
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2796, 13), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL hysteresis
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2796, 13), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL hysteresis
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(3525, 10), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Receive PV
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(3525, 10), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Receive PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(3535, 20), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Alternate receive PV
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(3535, 20), data_types: Part(5, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Alternate receive PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(129, 11), data_types: Part(6, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input FV
    EntryRow { first: 2, last: 199, mapping: Some(Tpdo), need: Optional, name: Part(129, 11), data_types: Part(6, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(140, 27), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt delta input FV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(140, 27), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt delta input FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(260, 21), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 1 FV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(260, 21), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 1 FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(281, 21), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 1 PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(281, 21), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 1 PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(302, 21), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 2 FV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(302, 21), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 2 FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(323, 21), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 2 PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(323, 21), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 2 PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(344, 15), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input offset
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(344, 15), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input offset
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(404, 11), data_types: Part(6, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input PV
    EntryRow { first: 2, last: 199, mapping: Some(Tpdo), need: Optional, name: Part(404, 11), data_types: Part(6, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(495, 27), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt delta input PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(495, 27), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt delta input PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(522, 27), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt lower input PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(522, 27), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt lower input PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(549, 27), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt upper input PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(549, 27), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt upper input PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(576, 12), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI tare zero
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(576, 12), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI tare zero
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(599, 9), data_types: Part(6, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI net PV
    EntryRow { first: 2, last: 199, mapping: Some(Tpdo), need: Optional, name: Part(599, 9), data_types: Part(6, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI net PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(608, 25), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt delta net PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(608, 25), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt delta net PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(633, 31), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt lower limit net PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(633, 31), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt lower limit net PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(664, 31), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt upper limit net PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(664, 31), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt upper limit net PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(695, 13), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI span start
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(695, 13), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI span start
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(708, 11), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI span end
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(708, 11), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI span end
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(1185, 12), data_types: Part(6, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output PV
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(1185, 12), data_types: Part(6, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1267, 22), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 1 PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1267, 22), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 1 PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1289, 22), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 1 FV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1289, 22), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 1 FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1311, 22), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 2 PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1311, 22), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 2 PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1333, 22), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 2 FV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1333, 22), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 2 FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1355, 12), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output FV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1355, 12), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1419, 11), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO fault FV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1419, 11), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO fault FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(1430, 31), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO effective current value Xeff
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(1430, 31), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO effective current value Xeff
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(1461, 27), data_types: Part(6, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO effective set point Weff
    EntryRow { first: 2, last: 199, mapping: Some(Tpdo), need: Optional, name: Part(1461, 27), data_types: Part(6, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO effective set point Weff
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(1488, 14), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO set point W
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(1488, 14), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO set point W
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(1502, 19), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO 2nd set point W2
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(1502, 19), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO 2nd set point W2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1521, 27), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO lower set point limit W0
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1521, 27), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO lower set point limit W0
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1548, 29), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO upper set point limit W100
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1548, 29), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO upper set point limit W100
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2014, 27), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO minimum pulse time Tmin1
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2014, 27), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO minimum pulse time Tmin1
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2041, 27), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO minimum pulse time Tmin2
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2041, 27), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO minimum pulse time Tmin2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2068, 25), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO motor response time Tm
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2068, 25), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO motor response time Tm
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2093, 25), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO min pulse length Tpuls
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2093, 25), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO min pulse length Tpuls
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2167, 32), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO neutral zone three-point Xsh1
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2167, 32), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO neutral zone three-point Xsh1
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2199, 32), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO neutral zone three-point Xsh2
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2199, 32), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO neutral zone three-point Xsh2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2231, 40), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO neutral zone three-point stepping Xsh
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2231, 40), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO neutral zone three-point stepping Xsh
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2271, 41), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO switching difference of signaller Xsd1
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2271, 41), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO switching difference of signaller Xsd1
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2312, 50), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO switching difference of additional contact Xsd2
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2312, 50), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO switching difference of additional contact Xsd2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2362, 52), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO trigger point separation of additional contact LW
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2362, 52), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO trigger point separation of additional contact LW
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2414, 24), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO proportional band Xp1
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2414, 24), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO proportional band Xp1
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2438, 24), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO proportional band Xp2
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2438, 24), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO proportional band Xp2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2462, 27), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO integral action time Tn1
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2462, 27), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO integral action time Tn1
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2489, 27), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO integral action time Tn2
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2489, 27), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO integral action time Tn2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2516, 29), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO derivative action time Tv1
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2516, 29), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO derivative action time Tv1
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2545, 29), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO derivative action time Tv2
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2545, 29), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO derivative action time Tv2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2574, 16), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO cycle time T1
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2574, 16), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO cycle time T1
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2590, 16), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO cycle time T2
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2590, 16), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO cycle time T2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(2647, 14), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL input value
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(2647, 14), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL input value
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2674, 24), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL alternate input value
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2674, 24), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL alternate input value
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2788, 8), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL level
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2788, 8), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL level
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2796, 13), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL hysteresis
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2796, 13), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL hysteresis
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(3525, 10), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Receive PV
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(3525, 10), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Receive PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(3535, 20), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Alternate receive PV
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(3535, 20), data_types: Part(6, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Alternate receive PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(129, 11), data_types: Part(7, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input FV
    EntryRow { first: 2, last: 199, mapping: Some(Tpdo), need: Optional, name: Part(129, 11), data_types: Part(7, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(140, 27), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt delta input FV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(140, 27), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt delta input FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(260, 21), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 1 FV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(260, 21), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 1 FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(281, 21), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 1 PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(281, 21), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 1 PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(302, 21), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 2 FV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(302, 21), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 2 FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(323, 21), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 2 PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(323, 21), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input scaling 2 PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(344, 15), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input offset
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(344, 15), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input offset
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(404, 11), data_types: Part(7, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input PV
    EntryRow { first: 2, last: 199, mapping: Some(Tpdo), need: Optional, name: Part(404, 11), data_types: Part(7, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI input PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(495, 27), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt delta input PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(495, 27), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt delta input PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(522, 27), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt lower input PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(522, 27), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt lower input PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(549, 27), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt upper input PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(549, 27), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt upper input PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(576, 12), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI tare zero
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(576, 12), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI tare zero
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(599, 9), data_types: Part(7, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI net PV
    EntryRow { first: 2, last: 199, mapping: Some(Tpdo), need: Optional, name: Part(599, 9), data_types: Part(7, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI net PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(608, 25), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt delta net PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(608, 25), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt delta net PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(633, 31), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt lower limit net PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(633, 31), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt lower limit net PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(664, 31), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt upper limit net PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(664, 31), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI interrupt upper limit net PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(695, 13), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI span start
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(695, 13), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI span start
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(708, 11), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI span end
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(708, 11), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AI span end
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(1185, 12), data_types: Part(7, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output PV
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(1185, 12), data_types: Part(7, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1267, 22), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 1 PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1267, 22), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 1 PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1289, 22), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 1 FV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1289, 22), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 1 FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1311, 22), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 2 PV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1311, 22), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 2 PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1333, 22), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 2 FV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1333, 22), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output scaling 2 FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1355, 12), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output FV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1355, 12), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO output FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1419, 11), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO fault FV
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1419, 11), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AO fault FV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(1430, 31), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO effective current value Xeff
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(1430, 31), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO effective current value Xeff
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(1461, 27), data_types: Part(7, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO effective set point Weff
    EntryRow { first: 2, last: 199, mapping: Some(Tpdo), need: Optional, name: Part(1461, 27), data_types: Part(7, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO effective set point Weff
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(1488, 14), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO set point W
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(1488, 14), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO set point W
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(1502, 19), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO 2nd set point W2
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(1502, 19), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO 2nd set point W2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1521, 27), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO lower set point limit W0
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1521, 27), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO lower set point limit W0
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1548, 29), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO upper set point limit W100
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(1548, 29), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO upper set point limit W100
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2014, 27), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO minimum pulse time Tmin1
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2014, 27), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO minimum pulse time Tmin1
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2041, 27), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO minimum pulse time Tmin2
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2041, 27), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO minimum pulse time Tmin2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2068, 25), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO motor response time Tm
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2068, 25), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO motor response time Tm
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2093, 25), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO min pulse length Tpuls
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2093, 25), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO min pulse length Tpuls
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2167, 32), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO neutral zone three-point Xsh1
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2167, 32), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO neutral zone three-point Xsh1
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2199, 32), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO neutral zone three-point Xsh2
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2199, 32), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO neutral zone three-point Xsh2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2231, 40), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO neutral zone three-point stepping Xsh
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2231, 40), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO neutral zone three-point stepping Xsh
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2271, 41), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO switching difference of signaller Xsd1
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2271, 41), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO switching difference of signaller Xsd1
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2312, 50), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO switching difference of additional contact Xsd2
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2312, 50), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO switching difference of additional contact Xsd2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2362, 52), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO trigger point separation of additional contact LW
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2362, 52), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO trigger point separation of additional contact LW
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2414, 24), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO proportional band Xp1
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2414, 24), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO proportional band Xp1
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2438, 24), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO proportional band Xp2
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2438, 24), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO proportional band Xp2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2462, 27), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO integral action time Tn1
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2462, 27), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO integral action time Tn1
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2489, 27), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO integral action time Tn2
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2489, 27), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO integral action time Tn2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2516, 29), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO derivative action time Tv1
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2516, 29), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO derivative action time Tv1
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2545, 29), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO derivative action time Tv2
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2545, 29), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO derivative action time Tv2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2574, 16), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO cycle time T1
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2574, 16), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO cycle time T1
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2590, 16), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO cycle time T2
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2590, 16), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CO cycle time T2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(2647, 14), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL input value
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(2647, 14), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL input value
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2674, 24), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL alternate input value
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2674, 24), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL alternate input value
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2788, 8), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL level
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2788, 8), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL level
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2796, 13), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL hysteresis
    EntryRow { first: 2, last: 199, mapping: None, need: Optional, name: Part(2796, 13), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // AL hysteresis
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(3525, 10), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Receive PV
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(3525, 10), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Receive PV
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(27, 27), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(3535, 20), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Alternate receive PV
    EntryRow { first: 2, last: 199, mapping: Some(Any), need: Optional, name: Part(3535, 20), data_types: Part(7, 1), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Alternate receive PV
];

static BITS: &[BitRow] = &[
    BitRow { first: 0, last: 7, name: Part(216, 7), values: Part(0, 2) }, // channel
    BitRow { first: 8, last: 15, name: Part(434, 11), values: Part(0, 0) }, // denominator
    BitRow { first: 16, last: 23, name: Part(445, 9), values: Part(0, 0) }, // numerator
    BitRow { first: 24, last: 31, name: Part(454, 21), values: Part(0, 0) }, // prefix, a power of 10
    BitRow { first: 0, last: 0, name: Part(728, 15), values: Part(0, 0) }, // value not valid
    BitRow { first: 1, last: 1, name: Part(743, 17), values: Part(0, 0) }, // positive overload
    BitRow { first: 2, last: 2, name: Part(760, 17), values: Part(0, 0) }, // negative overload
    BitRow { first: 0, last: 7, name: Part(828, 6), values: Part(2, 4) }, // filter
    BitRow { first: 0, last: 0, name: Part(1874, 11), values: Part(0, 0) }, // manual mode
    BitRow { first: 0, last: 0, name: Part(1905, 13), values: Part(0, 0) }, // controller on
    BitRow { first: 0, last: 0, name: Part(2748, 24), values: Part(0, 0) }, // alarm in case of a fault
    BitRow { first: 0, last: 0, name: Part(2825, 5), values: Part(0, 0) }, // alarm
    BitRow { first: 0, last: 0, name: Part(2838, 15), values: Part(0, 0) }, // reset the alarm
    BitRow { first: 0, last: 0, name: Part(2868, 7), values: Part(0, 0) }, // alarm 1
    BitRow { first: 1, last: 1, name: Part(2875, 7), values: Part(0, 0) }, // alarm 2
    BitRow { first: 2, last: 2, name: Part(2882, 7), values: Part(0, 0) }, // alarm 3
    BitRow { first: 3, last: 3, name: Part(2889, 7), values: Part(0, 0) }, // alarm 4
    BitRow { first: 4, last: 4, name: Part(2896, 7), values: Part(0, 0) }, // alarm 5
    BitRow { first: 5, last: 5, name: Part(2903, 7), values: Part(0, 0) }, // alarm 6
    BitRow { first: 6, last: 6, name: Part(2910, 7), values: Part(0, 0) }, // alarm 7
    BitRow { first: 7, last: 7, name: Part(2917, 7), values: Part(0, 0) }, // alarm 8
    BitRow { first: 0, last: 0, name: Part(2940, 7), values: Part(0, 0) }, // alarm 9
    BitRow { first: 1, last: 1, name: Part(2947, 8), values: Part(0, 0) }, // alarm 10
    BitRow { first: 2, last: 2, name: Part(2955, 8), values: Part(0, 0) }, // alarm 11
    BitRow { first: 3, last: 3, name: Part(2963, 8), values: Part(0, 0) }, // alarm 12
    BitRow { first: 4, last: 4, name: Part(2971, 8), values: Part(0, 0) }, // alarm 13
    BitRow { first: 5, last: 5, name: Part(2979, 8), values: Part(0, 0) }, // alarm 14
    BitRow { first: 6, last: 6, name: Part(2987, 8), values: Part(0, 0) }, // alarm 15
    BitRow { first: 7, last: 7, name: Part(2995, 8), values: Part(0, 0) }, // alarm 16
    BitRow { first: 0, last: 0, name: Part(3003, 8), values: Part(0, 0) }, // an alarm
    BitRow { first: 0, last: 0, name: Part(3027, 19), values: Part(0, 0) }, // an alarm of group 1
    BitRow { first: 1, last: 1, name: Part(3046, 19), values: Part(0, 0) }, // an alarm of group 2
    BitRow { first: 2, last: 2, name: Part(3065, 19), values: Part(0, 0) }, // an alarm of group 3
    BitRow { first: 3, last: 3, name: Part(3084, 19), values: Part(0, 0) }, // an alarm of group 4
    BitRow { first: 4, last: 4, name: Part(3103, 19), values: Part(0, 0) }, // an alarm of group 5
    BitRow { first: 5, last: 5, name: Part(3122, 19), values: Part(0, 0) }, // an alarm of group 6
    BitRow { first: 6, last: 6, name: Part(3141, 19), values: Part(0, 0) }, // an alarm of group 7
    BitRow { first: 7, last: 7, name: Part(3160, 19), values: Part(0, 0) }, // an alarm of group 8
    BitRow { first: 0, last: 0, name: Part(3200, 16), values: Part(0, 0) }, // reset all alarms
    BitRow { first: 0, last: 0, name: Part(3247, 13), values: Part(0, 0) }, // reset alarm 1
    BitRow { first: 1, last: 1, name: Part(3260, 13), values: Part(0, 0) }, // reset alarm 2
    BitRow { first: 2, last: 2, name: Part(3273, 13), values: Part(0, 0) }, // reset alarm 3
    BitRow { first: 3, last: 3, name: Part(3286, 13), values: Part(0, 0) }, // reset alarm 4
    BitRow { first: 4, last: 4, name: Part(3299, 13), values: Part(0, 0) }, // reset alarm 5
    BitRow { first: 5, last: 5, name: Part(3312, 13), values: Part(0, 0) }, // reset alarm 6
    BitRow { first: 6, last: 6, name: Part(3325, 13), values: Part(0, 0) }, // reset alarm 7
    BitRow { first: 7, last: 7, name: Part(3338, 13), values: Part(0, 0) }, // reset alarm 8
    BitRow { first: 0, last: 0, name: Part(3367, 13), values: Part(0, 0) }, // reset alarm 9
    BitRow { first: 1, last: 1, name: Part(3380, 14), values: Part(0, 0) }, // reset alarm 10
    BitRow { first: 2, last: 2, name: Part(3394, 14), values: Part(0, 0) }, // reset alarm 11
    BitRow { first: 3, last: 3, name: Part(3408, 14), values: Part(0, 0) }, // reset alarm 12
    BitRow { first: 4, last: 4, name: Part(3422, 14), values: Part(0, 0) }, // reset alarm 13
    BitRow { first: 5, last: 5, name: Part(3436, 14), values: Part(0, 0) }, // reset alarm 14
    BitRow { first: 6, last: 6, name: Part(3450, 14), values: Part(0, 0) }, // reset alarm 15
    BitRow { first: 7, last: 7, name: Part(3464, 14), values: Part(0, 0) }, // reset alarm 16
];

static MEANINGS: &[MeaningRow] = &[
    MeaningRow { first: 0, last: 0, text: Part(223, 3) }, // off
    MeaningRow { first: 1, last: 1, text: Part(226, 16) }, // normal operation
    MeaningRow { first: 0, last: 0, text: Part(834, 4) }, // none
    MeaningRow { first: 1, last: 1, text: Part(838, 14) }, // moving average
    MeaningRow { first: 2, last: 2, text: Part(852, 17) }, // repeating average
    MeaningRow { first: 100, last: 255, text: Part(869, 21) }, // manufacturer-specific
];

static CONDITIONS: &[Condition] = &[
];

static OBJECT_TYPES: &[ObjectType] = &[Array, Record, Var];

static DATA_TYPES: &[DataType] = &[DataType(5), DataType(1), DataType(8), DataType(6), DataType(7), DataType(3), DataType(16), DataType(4)];

static ACCESS: &[Access] = &[Ro, Rw, Wo, Rw, Wo];

static VALUES: &[std::ops::RangeInclusive<i128>] = &[1..=199];

static DEFAULTS: &[Value] = &[];

static INDEXES: &[u16] = &[];

static TEXTS: &str = concat!(
    "DI read state 8 input lines", "Highest sub-index supported", "DI polarity 8 input lines",
    "DI read state 1 input line", "DI polarity 1 input line", "AI input FV", "AI interrupt delta input FV",
    "AI sensor type", "AI autocalibration", "AI operating mode", "channel", "off", "normal operation",
    "AI ADC sample rate", "AI input scaling 1 FV", "AI input scaling 1 PV", "AI input scaling 2 FV",
    "AI input scaling 2 PV", "AI input offset", "AI autozero", "AI scaling factor", "AI scaling offset",
    "AI input PV", "AI physical unit PV", "denominator", "numerator", "prefix, a power of 10",
    "AI decimal digits PV", "AI interrupt delta input PV", "AI interrupt lower input PV",
    "AI interrupt upper input PV", "AI tare zero", "AI autotare", "AI net PV", "AI interrupt delta net PV",
    "AI interrupt lower limit net PV", "AI interrupt upper limit net PV", "AI span start", "AI span end",
    "AI status", "value not valid", "positive overload", "negative overload", "AI control byte",
    "AI control byte enable", "AI filter type", "filter", "none", "moving average", "repeating average",
    "manufacturer-specific", "AI filter constant", "DO write state 8 output lines", "DO polarity 8 output lines",
    "DO fault mode 8 output lines", "DO fault state 8 output lines", "DO link object 8 output lines",
    "DO write state 1 output line", "DO polarity 1 output line", "DO fault mode 1 output line",
    "DO fault state 1 output line", "DO link object 1 output line", "AO output PV", "AO physical unit PV",
    "AO decimal digits PV", "AO link output PV", "AO output type", "AO output scaling 1 PV",
    "AO output scaling 1 FV", "AO output scaling 2 PV", "AO output scaling 2 FV", "AO output FV",
    "AO physical unit FV", "AO decimal digits FV", "AO fault mode", "AO fault FV",
    "CO effective current value Xeff", "CO effective set point Weff", "CO set point W", "CO 2nd set point W2",
    "CO lower set point limit W0", "CO upper set point limit W100", "CO physical unit XW",
    "CO decimal digits XW", "CO effective controller output Y", "CO differential controller output Ydiff",
    "CO manual controller output", "CO lower controller output limit Ymin",
    "CO upper controller output limit Ymax", "CO physical unit controller output", "CO set point switch W-W2",
    "CO automatic/manual mode A-M", "manual mode", "CO controller on/off", "controller on", "CO controller mode",
    "CO self optimization on/off", "CO control byte", "CO control byte enable", "CO status word",
    "CO minimum pulse time Tmin1", "CO minimum pulse time Tmin2", "CO motor response time Tm",
    "CO min pulse length Tpuls", "CO physical unit pulse timing", "CO decimal digits PT",
    "CO neutral zone three-point Xsh1", "CO neutral zone three-point Xsh2",
    "CO neutral zone three-point stepping Xsh", "CO switching difference of signaller Xsd1",
    "CO switching difference of additional contact Xsd2", "CO trigger point separation of additional contact LW",
    "CO proportional band Xp1", "CO proportional band Xp2", "CO integral action time Tn1",
    "CO integral action time Tn2", "CO derivative action time Tv1", "CO derivative action time Tv2",
    "CO cycle time T1", "CO cycle time T2", "CO physical unit PID", "CO decimal digits PID", "AL input value",
    "AL link input", "AL alternate input value", "AL link alternate input", "AL fault mode", "AL fault state",
    "alarm in case of a fault", "AL type", "AL action", "AL level", "AL hysteresis", "AL group", "AL state",
    "alarm", "AL reset", "reset the alarm", "AL 1 to 8 state", "alarm 1", "alarm 2", "alarm 3", "alarm 4",
    "alarm 5", "alarm 6", "alarm 7", "alarm 8", "AL 9 to 16 state", "alarm 9", "alarm 10", "alarm 11",
    "alarm 12", "alarm 13", "alarm 14", "alarm 15", "alarm 16", "an alarm", "AL general state",
    "an alarm of group 1", "an alarm of group 2", "an alarm of group 3", "an alarm of group 4",
    "an alarm of group 5", "an alarm of group 6", "an alarm of group 7", "an alarm of group 8",
    "AL group 1 to 8 state", "reset all alarms", "AL general reset", "AL 1 to 8 reset", "reset alarm 1",
    "reset alarm 2", "reset alarm 3", "reset alarm 4", "reset alarm 5", "reset alarm 6", "reset alarm 7",
    "reset alarm 8", "AL 9 to 16 reset", "reset alarm 9", "reset alarm 10", "reset alarm 11", "reset alarm 12",
    "reset alarm 13", "reset alarm 14", "reset alarm 15", "reset alarm 16", "Life counter", "Receive PDO check",
    "Transmit PDO check", "Receive PV", "Alternate receive PV", "Received status", "Alternate received status",
    "Transmission enable",
);
