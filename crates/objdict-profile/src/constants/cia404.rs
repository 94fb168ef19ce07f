// Generated from `data/cia404.toml` by `cargo xtask profiles`: edit that file.

#![allow(unused_imports, reason = "not every document has facts of every kind")]

use std::borrow::Cow;

use crate::model::{Access, Access::*, DataType, ObjectType, ObjectType::*, Value, Value::*};
use crate::tables::{NeedRow::*, Term::*, *};
use crate::{Condition, Confidence::*, Mapping::*, Profile};

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
        commands: Cow::Borrowed(COMMANDS),
        transitions: Cow::Borrowed(TRANSITIONS),
        texts: Cow::Borrowed(TEXTS),
        errors: SubList(0, 0),
        machine: None,
    },
};

static OBJECTS: &[ObjectRow] = table!(ObjectRow { first, last, name, object_types, need, only, as_many_as, entries, source, about, confidence }:
    (24576, 24576, SubList(0, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(0, 3), SubList(0, 0), SubList(54, 51), Medium) // 6000h DI read state 8 input lines
    (24578, 24578, SubList(105, 25), SubList(0, 2), Optional, None, SubList(0, 0), SubList(3, 3), SubList(0, 0), SubList(130, 42), Medium) // 6002h DI polarity 8 input lines
    (24608, 24608, SubList(172, 26), SubList(0, 2), Optional, None, SubList(0, 0), SubList(6, 3), SubList(0, 0), SubList(198, 49), Medium) // 6020h DI read state 1 input line
    (24624, 24624, SubList(247, 24), SubList(0, 2), Optional, None, SubList(0, 0), SubList(9, 3), SubList(0, 0), SubList(271, 40), Medium) // 6030h DI polarity 1 input line
    (24832, 24832, SubList(311, 11), SubList(0, 2), Optional, None, SubList(0, 0), SubList(12, 3), SubList(0, 0), SubList(322, 71), Medium) // 6100h AI input FV
    (24835, 24835, SubList(393, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(15, 3), SubList(0, 0), SubList(420, 54), Medium) // 6103h AI interrupt delta input FV
    (24848, 24848, SubList(474, 14), SubList(0, 2), Optional, None, SubList(0, 0), SubList(18, 3), SubList(0, 0), SubList(488, 44), Medium) // 6110h AI sensor type
    (24849, 24849, SubList(532, 18), SubList(0, 2), Optional, None, SubList(0, 0), SubList(21, 3), SubList(0, 0), SubList(550, 44), Medium) // 6111h AI autocalibration
    (24850, 24850, SubList(594, 17), SubList(0, 2), Optional, None, SubList(0, 0), SubList(24, 3), SubList(0, 0), SubList(637, 55), Medium) // 6112h AI operating mode
    (24852, 24852, SubList(692, 18), SubList(0, 2), Optional, None, SubList(0, 0), SubList(27, 3), SubList(0, 0), SubList(713, 50), Medium) // 6114h AI ADC sample rate
    (24864, 24864, SubList(763, 21), SubList(0, 2), Optional, None, SubList(0, 0), SubList(30, 3), SubList(0, 0), SubList(784, 77), Medium) // 6120h AI input scaling 1 FV
    (24865, 24865, SubList(861, 21), SubList(0, 2), Optional, None, SubList(0, 0), SubList(33, 3), SubList(0, 0), SubList(882, 79), Medium) // 6121h AI input scaling 1 PV
    (24866, 24866, SubList(961, 21), SubList(0, 2), Optional, None, SubList(0, 0), SubList(36, 3), SubList(0, 0), SubList(982, 78), Medium) // 6122h AI input scaling 2 FV
    (24867, 24867, SubList(1060, 21), SubList(0, 2), Optional, None, SubList(0, 0), SubList(39, 3), SubList(0, 0), SubList(1081, 80), Medium) // 6123h AI input scaling 2 PV
    (24868, 24868, SubList(1161, 15), SubList(0, 2), Optional, None, SubList(0, 0), SubList(42, 3), SubList(0, 0), SubList(1176, 48), Medium) // 6124h AI input offset
    (24869, 24869, SubList(1224, 11), SubList(0, 2), Optional, None, SubList(0, 0), SubList(45, 3), SubList(0, 0), SubList(1235, 82), Medium) // 6125h AI autozero
    (24870, 24870, SubList(1317, 17), SubList(0, 2), Optional, None, SubList(0, 0), SubList(48, 3), SubList(0, 0), SubList(1334, 53), Medium) // 6126h AI scaling factor
    (24871, 24871, SubList(1387, 17), SubList(0, 2), Optional, None, SubList(0, 0), SubList(51, 3), SubList(0, 0), SubList(1404, 53), Medium) // 6127h AI scaling offset
    (24880, 24880, SubList(1457, 11), SubList(0, 2), Optional, None, SubList(0, 0), SubList(54, 3), SubList(0, 0), SubList(1468, 68), Medium) // 6130h AI input PV
    (24881, 24881, SubList(1536, 19), SubList(0, 2), Optional, None, SubList(0, 0), SubList(57, 3), SubList(0, 0), SubList(1596, 51), Medium) // 6131h AI physical unit PV
    (24882, 24882, SubList(1647, 20), SubList(0, 2), Optional, None, SubList(0, 0), SubList(60, 3), SubList(0, 0), SubList(1667, 73), Medium) // 6132h AI decimal digits PV
    (24883, 24883, SubList(1740, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(63, 3), SubList(0, 0), SubList(1767, 56), Medium) // 6133h AI interrupt delta input PV
    (24884, 24884, SubList(1823, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(66, 3), SubList(0, 0), SubList(1850, 60), Medium) // 6134h AI interrupt lower input PV
    (24885, 24885, SubList(1910, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(69, 3), SubList(0, 0), SubList(1937, 60), Medium) // 6135h AI interrupt upper input PV
    (24888, 24888, SubList(1997, 12), SubList(0, 2), Optional, None, SubList(0, 0), SubList(72, 3), SubList(0, 0), SubList(2009, 73), Medium) // 6138h AI tare zero
    (24889, 24889, SubList(2082, 11), SubList(0, 2), Optional, None, SubList(0, 0), SubList(75, 3), SubList(0, 0), SubList(2093, 62), Medium) // 6139h AI autotare
    (24896, 24896, SubList(2155, 9), SubList(0, 2), Optional, None, SubList(0, 0), SubList(78, 3), SubList(0, 0), SubList(2164, 56), Medium) // 6140h AI net PV
    (24899, 24899, SubList(2220, 25), SubList(0, 2), Optional, None, SubList(0, 0), SubList(81, 3), SubList(0, 0), SubList(2245, 52), Medium) // 6143h AI interrupt delta net PV
    (24900, 24900, SubList(2297, 31), SubList(0, 2), Optional, None, SubList(0, 0), SubList(84, 3), SubList(0, 0), SubList(2328, 56), Medium) // 6144h AI interrupt lower limit net PV
    (24901, 24901, SubList(2384, 31), SubList(0, 2), Optional, None, SubList(0, 0), SubList(87, 3), SubList(0, 0), SubList(2415, 56), Medium) // 6145h AI interrupt upper limit net PV
    (24904, 24904, SubList(2471, 13), SubList(0, 2), Optional, None, SubList(0, 0), SubList(90, 3), SubList(0, 0), SubList(2484, 68), Medium) // 6148h AI span start
    (24905, 24905, SubList(2552, 11), SubList(0, 2), Optional, None, SubList(0, 0), SubList(93, 3), SubList(0, 0), SubList(2563, 68), Medium) // 6149h AI span end
    (24912, 24912, SubList(2631, 9), SubList(0, 2), Optional, None, SubList(0, 0), SubList(96, 3), SubList(0, 0), SubList(2689, 69), Medium) // 6150h AI status
    (24928, 24928, SubList(2758, 15), SubList(0, 2), Optional, None, SubList(0, 0), SubList(99, 3), SubList(0, 0), SubList(2773, 73), Medium) // 6160h AI control byte
    (24929, 24929, SubList(2846, 22), SubList(0, 2), Optional, None, SubList(0, 0), SubList(102, 3), SubList(0, 0), SubList(2868, 46), Medium) // 6161h AI control byte enable
    (24992, 24992, SubList(2914, 14), SubList(0, 2), Optional, None, SubList(0, 0), SubList(105, 3), SubList(0, 0), SubList(2990, 32), Medium) // 61A0h AI filter type
    (24993, 24993, SubList(3022, 18), SubList(0, 2), Optional, None, SubList(0, 0), SubList(108, 3), SubList(0, 0), SubList(3040, 48), Medium) // 61A1h AI filter constant
    (25088, 25088, SubList(3088, 29), SubList(0, 2), Optional, None, SubList(0, 0), SubList(111, 3), SubList(0, 0), SubList(3117, 44), Medium) // 6200h DO write state 8 output lines
    (25090, 25090, SubList(3161, 26), SubList(0, 2), Optional, None, SubList(0, 0), SubList(114, 3), SubList(0, 0), SubList(3187, 43), Medium) // 6202h DO polarity 8 output lines
    (25094, 25094, SubList(3230, 28), SubList(0, 2), Optional, None, SubList(0, 0), SubList(117, 3), SubList(0, 0), SubList(3258, 74), Medium) // 6206h DO fault mode 8 output lines
    (25095, 25095, SubList(3332, 29), SubList(0, 2), Optional, None, SubList(0, 0), SubList(120, 3), SubList(0, 0), SubList(3361, 68), Medium) // 6207h DO fault state 8 output lines
    (25104, 25104, SubList(3429, 29), SubList(0, 2), Optional, None, SubList(0, 0), SubList(123, 3), SubList(0, 0), SubList(3458, 61), Medium) // 6210h DO link object 8 output lines
    (25120, 25120, SubList(3519, 28), SubList(0, 2), Optional, None, SubList(0, 0), SubList(126, 3), SubList(0, 0), SubList(3547, 42), Medium) // 6220h DO write state 1 output line
    (25152, 25152, SubList(3589, 25), SubList(0, 2), Optional, None, SubList(0, 0), SubList(129, 3), SubList(0, 0), SubList(3614, 41), Medium) // 6240h DO polarity 1 output line
    (25168, 25168, SubList(3655, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(132, 3), SubList(0, 0), SubList(3682, 77), Medium) // 6250h DO fault mode 1 output line
    (25184, 25184, SubList(3759, 28), SubList(0, 2), Optional, None, SubList(0, 0), SubList(135, 3), SubList(0, 0), SubList(3787, 68), Medium) // 6260h DO fault state 1 output line
    (25216, 25216, SubList(3855, 28), SubList(0, 2), Optional, None, SubList(0, 0), SubList(138, 3), SubList(0, 0), SubList(3883, 56), Medium) // 6280h DO link object 1 output line
    (25344, 25344, SubList(3939, 12), SubList(0, 2), Optional, None, SubList(0, 0), SubList(141, 3), SubList(0, 0), SubList(3951, 69), Medium) // 6300h AO output PV
    (25345, 25345, SubList(4020, 19), SubList(0, 2), Optional, None, SubList(0, 0), SubList(144, 3), SubList(0, 0), SubList(4039, 52), Medium) // 6301h AO physical unit PV
    (25346, 25346, SubList(4091, 20), SubList(0, 2), Optional, None, SubList(0, 0), SubList(147, 3), SubList(0, 0), SubList(1667, 73), Medium) // 6302h AO decimal digits PV
    (25347, 25347, SubList(4111, 17), SubList(0, 2), Optional, None, SubList(0, 0), SubList(150, 3), SubList(0, 0), SubList(4128, 58), Medium) // 6303h AO link output PV
    (25360, 25360, SubList(4186, 14), SubList(0, 2), Optional, None, SubList(0, 0), SubList(153, 3), SubList(0, 0), SubList(4200, 45), Medium) // 6310h AO output type
    (25376, 25376, SubList(4245, 22), SubList(0, 2), Optional, None, SubList(0, 0), SubList(156, 3), SubList(0, 0), SubList(4267, 80), Medium) // 6320h AO output scaling 1 PV
    (25377, 25377, SubList(4347, 22), SubList(0, 2), Optional, None, SubList(0, 0), SubList(159, 3), SubList(0, 0), SubList(4369, 78), Medium) // 6321h AO output scaling 1 FV
    (25378, 25378, SubList(4447, 22), SubList(0, 2), Optional, None, SubList(0, 0), SubList(162, 3), SubList(0, 0), SubList(4469, 81), Medium) // 6322h AO output scaling 2 PV
    (25379, 25379, SubList(4550, 22), SubList(0, 2), Optional, None, SubList(0, 0), SubList(165, 3), SubList(0, 0), SubList(4572, 79), Medium) // 6323h AO output scaling 2 FV
    (25392, 25392, SubList(4651, 12), SubList(0, 2), Optional, None, SubList(0, 0), SubList(168, 3), SubList(0, 0), SubList(4663, 74), Medium) // 6330h AO output FV
    (25393, 25393, SubList(4737, 19), SubList(0, 2), Optional, None, SubList(0, 0), SubList(171, 3), SubList(0, 0), SubList(4756, 50), Medium) // 6331h AO physical unit FV
    (25394, 25394, SubList(4806, 20), SubList(0, 2), Optional, None, SubList(0, 0), SubList(174, 3), SubList(0, 0), SubList(4826, 71), Medium) // 6332h AO decimal digits FV
    (25408, 25408, SubList(4897, 13), SubList(0, 2), Optional, None, SubList(0, 0), SubList(177, 3), SubList(0, 0), SubList(4910, 49), Medium) // 6340h AO fault mode
    (25409, 25409, SubList(4959, 11), SubList(0, 2), Optional, None, SubList(0, 0), SubList(180, 3), SubList(0, 0), SubList(4970, 66), Medium) // 6341h AO fault FV
    (25600, 25600, SubList(5036, 31), SubList(0, 2), Optional, None, SubList(0, 0), SubList(183, 3), SubList(0, 0), SubList(5067, 48), Medium) // 6400h CO effective current value Xeff
    (25601, 25601, SubList(5115, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(186, 3), SubList(0, 0), SubList(5142, 45), Medium) // 6401h CO effective set point Weff
    (25602, 25602, SubList(5187, 14), SubList(0, 2), Optional, None, SubList(0, 0), SubList(189, 3), SubList(0, 0), SubList(5201, 32), Medium) // 6402h CO set point W
    (25603, 25603, SubList(5233, 19), SubList(0, 2), Optional, None, SubList(0, 0), SubList(192, 3), SubList(0, 0), SubList(5252, 66), Medium) // 6403h CO 2nd set point W2
    (25604, 25604, SubList(5318, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(195, 3), SubList(0, 0), SubList(5345, 21), Medium) // 6404h CO lower set point limit W0
    (25605, 25605, SubList(5366, 29), SubList(0, 2), Optional, None, SubList(0, 0), SubList(198, 3), SubList(0, 0), SubList(5395, 22), Medium) // 6405h CO upper set point limit W100
    (25606, 25606, SubList(5417, 19), SubList(0, 2), Optional, None, SubList(0, 0), SubList(201, 3), SubList(0, 0), SubList(5436, 39), Medium) // 6406h CO physical unit XW
    (25607, 25607, SubList(5475, 20), SubList(0, 2), Optional, None, SubList(0, 0), SubList(204, 3), SubList(0, 0), SubList(5495, 82), Medium) // 6407h CO decimal digits XW
    (25616, 25616, SubList(5577, 32), SubList(0, 2), Optional, None, SubList(0, 0), SubList(207, 3), SubList(0, 0), SubList(5609, 29), Medium) // 6410h CO effective controller output Y
    (25617, 25617, SubList(5638, 39), SubList(0, 2), Optional, None, SubList(0, 0), SubList(210, 3), SubList(0, 0), SubList(5677, 38), Medium) // 6411h CO differential controller output Ydiff
    (25618, 25618, SubList(5715, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(213, 3), SubList(0, 0), SubList(5742, 44), Medium) // 6412h CO manual controller output
    (25619, 25619, SubList(5786, 37), SubList(0, 2), Optional, None, SubList(0, 0), SubList(216, 3), SubList(0, 0), SubList(5823, 36), Medium) // 6413h CO lower controller output limit Ymin
    (25620, 25620, SubList(5859, 37), SubList(0, 2), Optional, None, SubList(0, 0), SubList(219, 3), SubList(0, 0), SubList(5896, 37), Medium) // 6414h CO upper controller output limit Ymax
    (25621, 25621, SubList(5933, 34), SubList(0, 2), Optional, None, SubList(0, 0), SubList(222, 3), SubList(0, 0), SubList(5967, 36), Medium) // 6415h CO physical unit controller output
    (25632, 25632, SubList(6003, 24), SubList(0, 2), Optional, None, SubList(0, 0), SubList(225, 3), SubList(0, 0), SubList(6027, 43), Medium) // 6420h CO set point switch W-W2
    (25633, 25633, SubList(6070, 28), SubList(0, 2), Optional, None, SubList(0, 0), SubList(228, 3), SubList(0, 0), SubList(6109, 33), Medium) // 6421h CO automatic/manual mode A-M
    (25634, 25634, SubList(6142, 20), SubList(0, 2), Optional, None, SubList(0, 0), SubList(231, 3), SubList(0, 0), SubList(6175, 35), Medium) // 6422h CO controller on/off
    (25635, 25635, SubList(6210, 18), SubList(0, 2), Optional, None, SubList(0, 0), SubList(234, 3), SubList(0, 0), SubList(6228, 27), Medium) // 6423h CO controller mode
    (25636, 25636, SubList(6255, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(237, 3), SubList(0, 0), SubList(6282, 53), Medium) // 6424h CO self optimization on/off
    (25637, 25637, SubList(6335, 15), SubList(0, 2), Optional, None, SubList(0, 0), SubList(240, 3), SubList(0, 0), SubList(6350, 39), Medium) // 6425h CO control byte
    (25638, 25638, SubList(6389, 22), SubList(0, 2), Optional, None, SubList(0, 0), SubList(243, 3), SubList(0, 0), SubList(2868, 46), Medium) // 6426h CO control byte enable
    (25639, 25639, SubList(6411, 14), SubList(0, 2), Optional, None, SubList(0, 0), SubList(246, 3), SubList(0, 0), SubList(6425, 42), Medium) // 6427h CO status word
    (25648, 25648, SubList(6467, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(249, 3), SubList(0, 0), SubList(6494, 57), Medium) // 6430h CO minimum pulse time Tmin1
    (25649, 25649, SubList(6551, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(252, 3), SubList(0, 0), SubList(6578, 58), Medium) // 6431h CO minimum pulse time Tmin2
    (25650, 25650, SubList(6636, 25), SubList(0, 2), Optional, None, SubList(0, 0), SubList(255, 3), SubList(0, 0), SubList(6661, 64), Medium) // 6432h CO motor response time Tm
    (25651, 25651, SubList(6725, 25), SubList(0, 2), Optional, None, SubList(0, 0), SubList(258, 3), SubList(0, 0), SubList(6750, 45), Medium) // 6433h CO min pulse length Tpuls
    (25652, 25652, SubList(6795, 29), SubList(0, 2), Optional, None, SubList(0, 0), SubList(261, 3), SubList(0, 0), SubList(6824, 32), Medium) // 6434h CO physical unit pulse timing
    (25653, 25653, SubList(6856, 20), SubList(0, 2), Optional, None, SubList(0, 0), SubList(264, 3), SubList(0, 0), SubList(6876, 75), Medium) // 6435h CO decimal digits PT
    (25664, 25664, SubList(6951, 32), SubList(0, 2), Optional, None, SubList(0, 0), SubList(267, 3), SubList(0, 0), SubList(6983, 80), Medium) // 6440h CO neutral zone three-point Xsh1
    (25665, 25665, SubList(7063, 32), SubList(0, 2), Optional, None, SubList(0, 0), SubList(270, 3), SubList(0, 0), SubList(7095, 81), Medium) // 6441h CO neutral zone three-point Xsh2
    (25666, 25666, SubList(7176, 40), SubList(0, 2), Optional, None, SubList(0, 0), SubList(273, 3), SubList(0, 0), SubList(7216, 54), Medium) // 6442h CO neutral zone three-point stepping Xsh
    (25667, 25667, SubList(7270, 41), SubList(0, 2), Optional, None, SubList(0, 0), SubList(276, 3), SubList(0, 0), SubList(7311, 39), Medium) // 6443h CO switching difference of signaller Xsd1
    (25668, 25668, SubList(7350, 50), SubList(0, 2), Optional, None, SubList(0, 0), SubList(279, 3), SubList(0, 0), SubList(7400, 41), Medium) // 6444h CO switching difference of additional contact Xsd2
    (25669, 25669, SubList(7441, 52), SubList(0, 2), Optional, None, SubList(0, 0), SubList(282, 3), SubList(0, 0), SubList(7493, 76), Medium) // 6445h CO trigger point separation of additional contact LW
    (25680, 25680, SubList(7569, 24), SubList(0, 2), Optional, None, SubList(0, 0), SubList(285, 3), SubList(0, 0), SubList(7593, 49), Medium) // 6450h CO proportional band Xp1
    (25681, 25681, SubList(7642, 24), SubList(0, 2), Optional, None, SubList(0, 0), SubList(288, 3), SubList(0, 0), SubList(7666, 50), Medium) // 6451h CO proportional band Xp2
    (25682, 25682, SubList(7716, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(291, 3), SubList(0, 0), SubList(7743, 52), Medium) // 6452h CO integral action time Tn1
    (25683, 25683, SubList(7795, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(294, 3), SubList(0, 0), SubList(7822, 53), Medium) // 6453h CO integral action time Tn2
    (25684, 25684, SubList(7875, 29), SubList(0, 2), Optional, None, SubList(0, 0), SubList(297, 3), SubList(0, 0), SubList(7904, 54), Medium) // 6454h CO derivative action time Tv1
    (25685, 25685, SubList(7958, 29), SubList(0, 2), Optional, None, SubList(0, 0), SubList(300, 3), SubList(0, 0), SubList(7987, 55), Medium) // 6455h CO derivative action time Tv2
    (25686, 25686, SubList(8042, 16), SubList(0, 2), Optional, None, SubList(0, 0), SubList(303, 3), SubList(0, 0), SubList(8058, 41), Medium) // 6456h CO cycle time T1
    (25687, 25687, SubList(8099, 16), SubList(0, 2), Optional, None, SubList(0, 0), SubList(306, 3), SubList(0, 0), SubList(8115, 42), Medium) // 6457h CO cycle time T2
    (25688, 25688, SubList(8157, 20), SubList(0, 2), Optional, None, SubList(0, 0), SubList(309, 3), SubList(0, 0), SubList(8177, 40), Medium) // 6458h CO physical unit PID
    (25689, 25689, SubList(8217, 21), SubList(0, 2), Optional, None, SubList(0, 0), SubList(312, 3), SubList(0, 0), SubList(8238, 83), Medium) // 6459h CO decimal digits PID
    (25856, 25856, SubList(8321, 14), SubList(0, 2), Optional, None, SubList(0, 0), SubList(315, 3), SubList(0, 0), SubList(8335, 32), Medium) // 6500h AL input value
    (25859, 25859, SubList(8367, 13), SubList(0, 2), Optional, None, SubList(0, 0), SubList(318, 3), SubList(0, 0), SubList(8380, 58), Medium) // 6503h AL link input
    (25860, 25860, SubList(8438, 24), SubList(0, 2), Optional, None, SubList(0, 0), SubList(321, 3), SubList(0, 0), SubList(8462, 68), Medium) // 6504h AL alternate input value
    (25861, 25861, SubList(8530, 23), SubList(0, 2), Optional, None, SubList(0, 0), SubList(324, 3), SubList(0, 0), SubList(8553, 94), Medium) // 6505h AL link alternate input
    (25862, 25862, SubList(8647, 13), SubList(0, 2), Optional, None, SubList(0, 0), SubList(327, 3), SubList(0, 0), SubList(8660, 44), Medium) // 6506h AL fault mode
    (25863, 25863, SubList(8704, 14), SubList(0, 2), Optional, None, SubList(0, 0), SubList(330, 3), SubList(0, 0), SubList(8742, 55), Medium) // 6507h AL fault state
    (25864, 25864, SubList(8797, 7), SubList(0, 2), Optional, None, SubList(0, 0), SubList(333, 3), SubList(0, 0), SubList(8804, 60), Medium) // 6508h AL type
    (25865, 25865, SubList(8864, 9), SubList(0, 2), Optional, None, SubList(0, 0), SubList(336, 3), SubList(0, 0), SubList(8873, 66), Medium) // 6509h AL action
    (25866, 25866, SubList(8939, 8), SubList(0, 2), Optional, None, SubList(0, 0), SubList(339, 3), SubList(0, 0), SubList(8947, 42), Medium) // 650Ah AL level
    (25867, 25867, SubList(8989, 13), SubList(0, 2), Optional, None, SubList(0, 0), SubList(342, 3), SubList(0, 0), SubList(9002, 68), Medium) // 650Bh AL hysteresis
    (25868, 25868, SubList(9070, 8), SubList(0, 2), Optional, None, SubList(0, 0), SubList(345, 3), SubList(0, 0), SubList(9078, 35), Medium) // 650Ch AL group
    (25869, 25869, SubList(9113, 8), SubList(0, 2), Optional, None, SubList(0, 0), SubList(348, 3), SubList(0, 0), SubList(9126, 22), Medium) // 650Dh AL state
    (25870, 25870, SubList(9148, 8), SubList(0, 2), Optional, None, SubList(0, 0), SubList(351, 3), SubList(0, 0), SubList(9171, 22), Medium) // 650Eh AL reset
    (26112, 26112, SubList(9193, 15), SubList(0, 2), Optional, None, SubList(0, 0), SubList(354, 3), SubList(0, 0), SubList(9264, 46), Medium) // 6600h AL 1 to 8 state
    (26113, 26113, SubList(9310, 16), SubList(0, 2), Optional, None, SubList(0, 0), SubList(357, 3), SubList(0, 0), SubList(9389, 47), Medium) // 6601h AL 9 to 16 state
    (26114, 26114, SubList(9444, 16), SubList(2, 1), Optional, None, SubList(0, 0), SubList(360, 1), SubList(0, 0), SubList(9460, 28), Medium) // 6602h AL general state
    (26115, 26115, SubList(9640, 21), SubList(2, 1), Optional, None, SubList(0, 0), SubList(361, 1), SubList(0, 0), SubList(9661, 52), Medium) // 6603h AL group 1 to 8 state
    (26128, 26128, SubList(9729, 16), SubList(2, 1), Optional, None, SubList(0, 0), SubList(362, 1), SubList(0, 0), SubList(9745, 24), Medium) // 6610h AL general reset
    (26129, 26129, SubList(9769, 15), SubList(0, 2), Optional, None, SubList(0, 0), SubList(363, 3), SubList(0, 0), SubList(9888, 45), Medium) // 6611h AL 1 to 8 reset
    (26130, 26130, SubList(9933, 16), SubList(0, 2), Optional, None, SubList(0, 0), SubList(366, 3), SubList(0, 0), SubList(10060, 46), Medium) // 6612h AL 9 to 16 reset
    (28448, 28448, SubList(10106, 12), SubList(0, 2), Optional, None, SubList(0, 0), SubList(369, 3), SubList(0, 0), SubList(10118, 33), Medium) // 6F20h Life counter
    (28464, 28464, SubList(10151, 17), SubList(0, 2), Optional, None, SubList(0, 0), SubList(372, 3), SubList(0, 0), SubList(10168, 52), Medium) // 6F30h Receive PDO check
    (28465, 28465, SubList(10220, 18), SubList(0, 2), Optional, None, SubList(0, 0), SubList(375, 3), SubList(0, 0), SubList(10238, 33), Medium) // 6F31h Transmit PDO check
    (28496, 28496, SubList(10271, 10), SubList(0, 2), Optional, None, SubList(0, 0), SubList(378, 3), SubList(0, 0), SubList(10281, 58), Medium) // 6F50h Receive PV
    (28497, 28497, SubList(10339, 20), SubList(0, 2), Optional, None, SubList(0, 0), SubList(381, 3), SubList(0, 0), SubList(10359, 67), Medium) // 6F51h Alternate receive PV
    (28498, 28498, SubList(10426, 15), SubList(0, 2), Optional, None, SubList(0, 0), SubList(384, 3), SubList(0, 0), SubList(10441, 55), Medium) // 6F52h Received status
    (28499, 28499, SubList(10496, 25), SubList(0, 2), Optional, None, SubList(0, 0), SubList(387, 3), SubList(0, 0), SubList(10521, 81), Medium) // 6F53h Alternate received status
    (28512, 28512, SubList(10602, 19), SubList(2, 1), Optional, None, SubList(0, 0), SubList(390, 1), SubList(0, 0), SubList(10621, 47), Medium) // 6F60h Transmission enable
    (28928, 28928, SubList(311, 11), SubList(0, 2), Optional, None, SubList(0, 0), SubList(391, 3), SubList(0, 0), SubList(322, 71), Medium) // 7100h AI input FV
    (28931, 28931, SubList(393, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(394, 3), SubList(0, 0), SubList(420, 54), Medium) // 7103h AI interrupt delta input FV
    (28960, 28960, SubList(763, 21), SubList(0, 2), Optional, None, SubList(0, 0), SubList(397, 3), SubList(0, 0), SubList(784, 77), Medium) // 7120h AI input scaling 1 FV
    (28961, 28961, SubList(861, 21), SubList(0, 2), Optional, None, SubList(0, 0), SubList(400, 3), SubList(0, 0), SubList(882, 79), Medium) // 7121h AI input scaling 1 PV
    (28962, 28962, SubList(961, 21), SubList(0, 2), Optional, None, SubList(0, 0), SubList(403, 3), SubList(0, 0), SubList(982, 78), Medium) // 7122h AI input scaling 2 FV
    (28963, 28963, SubList(1060, 21), SubList(0, 2), Optional, None, SubList(0, 0), SubList(406, 3), SubList(0, 0), SubList(1081, 80), Medium) // 7123h AI input scaling 2 PV
    (28964, 28964, SubList(1161, 15), SubList(0, 2), Optional, None, SubList(0, 0), SubList(409, 3), SubList(0, 0), SubList(1176, 48), Medium) // 7124h AI input offset
    (28976, 28976, SubList(1457, 11), SubList(0, 2), Optional, None, SubList(0, 0), SubList(412, 3), SubList(0, 0), SubList(1468, 68), Medium) // 7130h AI input PV
    (28979, 28979, SubList(1740, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(415, 3), SubList(0, 0), SubList(1767, 56), Medium) // 7133h AI interrupt delta input PV
    (28980, 28980, SubList(1823, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(418, 3), SubList(0, 0), SubList(1850, 60), Medium) // 7134h AI interrupt lower input PV
    (28981, 28981, SubList(1910, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(421, 3), SubList(0, 0), SubList(1937, 60), Medium) // 7135h AI interrupt upper input PV
    (28984, 28984, SubList(1997, 12), SubList(0, 2), Optional, None, SubList(0, 0), SubList(424, 3), SubList(0, 0), SubList(2009, 73), Medium) // 7138h AI tare zero
    (28992, 28992, SubList(2155, 9), SubList(0, 2), Optional, None, SubList(0, 0), SubList(427, 3), SubList(0, 0), SubList(2164, 56), Medium) // 7140h AI net PV
    (28995, 28995, SubList(2220, 25), SubList(0, 2), Optional, None, SubList(0, 0), SubList(430, 3), SubList(0, 0), SubList(2245, 52), Medium) // 7143h AI interrupt delta net PV
    (28996, 28996, SubList(2297, 31), SubList(0, 2), Optional, None, SubList(0, 0), SubList(433, 3), SubList(0, 0), SubList(2328, 56), Medium) // 7144h AI interrupt lower limit net PV
    (28997, 28997, SubList(2384, 31), SubList(0, 2), Optional, None, SubList(0, 0), SubList(436, 3), SubList(0, 0), SubList(2415, 56), Medium) // 7145h AI interrupt upper limit net PV
    (29000, 29000, SubList(2471, 13), SubList(0, 2), Optional, None, SubList(0, 0), SubList(439, 3), SubList(0, 0), SubList(2484, 68), Medium) // 7148h AI span start
    (29001, 29001, SubList(2552, 11), SubList(0, 2), Optional, None, SubList(0, 0), SubList(442, 3), SubList(0, 0), SubList(2563, 68), Medium) // 7149h AI span end
    (29440, 29440, SubList(3939, 12), SubList(0, 2), Optional, None, SubList(0, 0), SubList(445, 3), SubList(0, 0), SubList(3951, 69), Medium) // 7300h AO output PV
    (29472, 29472, SubList(4245, 22), SubList(0, 2), Optional, None, SubList(0, 0), SubList(448, 3), SubList(0, 0), SubList(4267, 80), Medium) // 7320h AO output scaling 1 PV
    (29473, 29473, SubList(4347, 22), SubList(0, 2), Optional, None, SubList(0, 0), SubList(451, 3), SubList(0, 0), SubList(4369, 78), Medium) // 7321h AO output scaling 1 FV
    (29474, 29474, SubList(4447, 22), SubList(0, 2), Optional, None, SubList(0, 0), SubList(454, 3), SubList(0, 0), SubList(4469, 81), Medium) // 7322h AO output scaling 2 PV
    (29475, 29475, SubList(4550, 22), SubList(0, 2), Optional, None, SubList(0, 0), SubList(457, 3), SubList(0, 0), SubList(4572, 79), Medium) // 7323h AO output scaling 2 FV
    (29488, 29488, SubList(4651, 12), SubList(0, 2), Optional, None, SubList(0, 0), SubList(460, 3), SubList(0, 0), SubList(4663, 74), Medium) // 7330h AO output FV
    (29505, 29505, SubList(4959, 11), SubList(0, 2), Optional, None, SubList(0, 0), SubList(463, 3), SubList(0, 0), SubList(4970, 66), Medium) // 7341h AO fault FV
    (29696, 29696, SubList(5036, 31), SubList(0, 2), Optional, None, SubList(0, 0), SubList(466, 3), SubList(0, 0), SubList(5067, 48), Medium) // 7400h CO effective current value Xeff
    (29697, 29697, SubList(5115, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(469, 3), SubList(0, 0), SubList(5142, 45), Medium) // 7401h CO effective set point Weff
    (29698, 29698, SubList(5187, 14), SubList(0, 2), Optional, None, SubList(0, 0), SubList(472, 3), SubList(0, 0), SubList(5201, 32), Medium) // 7402h CO set point W
    (29699, 29699, SubList(5233, 19), SubList(0, 2), Optional, None, SubList(0, 0), SubList(475, 3), SubList(0, 0), SubList(5252, 66), Medium) // 7403h CO 2nd set point W2
    (29700, 29700, SubList(5318, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(478, 3), SubList(0, 0), SubList(5345, 21), Medium) // 7404h CO lower set point limit W0
    (29701, 29701, SubList(5366, 29), SubList(0, 2), Optional, None, SubList(0, 0), SubList(481, 3), SubList(0, 0), SubList(5395, 22), Medium) // 7405h CO upper set point limit W100
    (29744, 29744, SubList(6467, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(484, 3), SubList(0, 0), SubList(6494, 57), Medium) // 7430h CO minimum pulse time Tmin1
    (29745, 29745, SubList(6551, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(487, 3), SubList(0, 0), SubList(6578, 58), Medium) // 7431h CO minimum pulse time Tmin2
    (29746, 29746, SubList(6636, 25), SubList(0, 2), Optional, None, SubList(0, 0), SubList(490, 3), SubList(0, 0), SubList(6661, 64), Medium) // 7432h CO motor response time Tm
    (29747, 29747, SubList(6725, 25), SubList(0, 2), Optional, None, SubList(0, 0), SubList(493, 3), SubList(0, 0), SubList(6750, 45), Medium) // 7433h CO min pulse length Tpuls
    (29760, 29760, SubList(6951, 32), SubList(0, 2), Optional, None, SubList(0, 0), SubList(496, 3), SubList(0, 0), SubList(6983, 80), Medium) // 7440h CO neutral zone three-point Xsh1
    (29761, 29761, SubList(7063, 32), SubList(0, 2), Optional, None, SubList(0, 0), SubList(499, 3), SubList(0, 0), SubList(7095, 81), Medium) // 7441h CO neutral zone three-point Xsh2
    (29762, 29762, SubList(7176, 40), SubList(0, 2), Optional, None, SubList(0, 0), SubList(502, 3), SubList(0, 0), SubList(7216, 54), Medium) // 7442h CO neutral zone three-point stepping Xsh
    (29763, 29763, SubList(7270, 41), SubList(0, 2), Optional, None, SubList(0, 0), SubList(505, 3), SubList(0, 0), SubList(7311, 39), Medium) // 7443h CO switching difference of signaller Xsd1
    (29764, 29764, SubList(7350, 50), SubList(0, 2), Optional, None, SubList(0, 0), SubList(508, 3), SubList(0, 0), SubList(7400, 41), Medium) // 7444h CO switching difference of additional contact Xsd2
    (29765, 29765, SubList(7441, 52), SubList(0, 2), Optional, None, SubList(0, 0), SubList(511, 3), SubList(0, 0), SubList(7493, 76), Medium) // 7445h CO trigger point separation of additional contact LW
    (29776, 29776, SubList(7569, 24), SubList(0, 2), Optional, None, SubList(0, 0), SubList(514, 3), SubList(0, 0), SubList(7593, 49), Medium) // 7450h CO proportional band Xp1
    (29777, 29777, SubList(7642, 24), SubList(0, 2), Optional, None, SubList(0, 0), SubList(517, 3), SubList(0, 0), SubList(7666, 50), Medium) // 7451h CO proportional band Xp2
    (29778, 29778, SubList(7716, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(520, 3), SubList(0, 0), SubList(7743, 52), Medium) // 7452h CO integral action time Tn1
    (29779, 29779, SubList(7795, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(523, 3), SubList(0, 0), SubList(7822, 53), Medium) // 7453h CO integral action time Tn2
    (29780, 29780, SubList(7875, 29), SubList(0, 2), Optional, None, SubList(0, 0), SubList(526, 3), SubList(0, 0), SubList(7904, 54), Medium) // 7454h CO derivative action time Tv1
    (29781, 29781, SubList(7958, 29), SubList(0, 2), Optional, None, SubList(0, 0), SubList(529, 3), SubList(0, 0), SubList(7987, 55), Medium) // 7455h CO derivative action time Tv2
    (29782, 29782, SubList(8042, 16), SubList(0, 2), Optional, None, SubList(0, 0), SubList(532, 3), SubList(0, 0), SubList(8058, 41), Medium) // 7456h CO cycle time T1
    (29783, 29783, SubList(8099, 16), SubList(0, 2), Optional, None, SubList(0, 0), SubList(535, 3), SubList(0, 0), SubList(8115, 42), Medium) // 7457h CO cycle time T2
    (29952, 29952, SubList(8321, 14), SubList(0, 2), Optional, None, SubList(0, 0), SubList(538, 3), SubList(0, 0), SubList(8335, 32), Medium) // 7500h AL input value
    (29956, 29956, SubList(8438, 24), SubList(0, 2), Optional, None, SubList(0, 0), SubList(541, 3), SubList(0, 0), SubList(8462, 68), Medium) // 7504h AL alternate input value
    (29962, 29962, SubList(8939, 8), SubList(0, 2), Optional, None, SubList(0, 0), SubList(544, 3), SubList(0, 0), SubList(8947, 42), Medium) // 750Ah AL level
    (29963, 29963, SubList(8989, 13), SubList(0, 2), Optional, None, SubList(0, 0), SubList(547, 3), SubList(0, 0), SubList(9002, 68), Medium) // 750Bh AL hysteresis
    (32592, 32592, SubList(10271, 10), SubList(0, 2), Optional, None, SubList(0, 0), SubList(550, 3), SubList(0, 0), SubList(10281, 58), Medium) // 7F50h Receive PV
    (32593, 32593, SubList(10339, 20), SubList(0, 2), Optional, None, SubList(0, 0), SubList(553, 3), SubList(0, 0), SubList(10359, 67), Medium) // 7F51h Alternate receive PV
    (33024, 33024, SubList(311, 11), SubList(0, 2), Optional, None, SubList(0, 0), SubList(556, 3), SubList(0, 0), SubList(322, 71), Medium) // 8100h AI input FV
    (33027, 33027, SubList(393, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(559, 3), SubList(0, 0), SubList(420, 54), Medium) // 8103h AI interrupt delta input FV
    (33056, 33056, SubList(763, 21), SubList(0, 2), Optional, None, SubList(0, 0), SubList(562, 3), SubList(0, 0), SubList(784, 77), Medium) // 8120h AI input scaling 1 FV
    (33057, 33057, SubList(861, 21), SubList(0, 2), Optional, None, SubList(0, 0), SubList(565, 3), SubList(0, 0), SubList(882, 79), Medium) // 8121h AI input scaling 1 PV
    (33058, 33058, SubList(961, 21), SubList(0, 2), Optional, None, SubList(0, 0), SubList(568, 3), SubList(0, 0), SubList(982, 78), Medium) // 8122h AI input scaling 2 FV
    (33059, 33059, SubList(1060, 21), SubList(0, 2), Optional, None, SubList(0, 0), SubList(571, 3), SubList(0, 0), SubList(1081, 80), Medium) // 8123h AI input scaling 2 PV
    (33060, 33060, SubList(1161, 15), SubList(0, 2), Optional, None, SubList(0, 0), SubList(574, 3), SubList(0, 0), SubList(1176, 48), Medium) // 8124h AI input offset
    (33072, 33072, SubList(1457, 11), SubList(0, 2), Optional, None, SubList(0, 0), SubList(577, 3), SubList(0, 0), SubList(1468, 68), Medium) // 8130h AI input PV
    (33075, 33075, SubList(1740, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(580, 3), SubList(0, 0), SubList(1767, 56), Medium) // 8133h AI interrupt delta input PV
    (33076, 33076, SubList(1823, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(583, 3), SubList(0, 0), SubList(1850, 60), Medium) // 8134h AI interrupt lower input PV
    (33077, 33077, SubList(1910, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(586, 3), SubList(0, 0), SubList(1937, 60), Medium) // 8135h AI interrupt upper input PV
    (33080, 33080, SubList(1997, 12), SubList(0, 2), Optional, None, SubList(0, 0), SubList(589, 3), SubList(0, 0), SubList(2009, 73), Medium) // 8138h AI tare zero
    (33088, 33088, SubList(2155, 9), SubList(0, 2), Optional, None, SubList(0, 0), SubList(592, 3), SubList(0, 0), SubList(2164, 56), Medium) // 8140h AI net PV
    (33091, 33091, SubList(2220, 25), SubList(0, 2), Optional, None, SubList(0, 0), SubList(595, 3), SubList(0, 0), SubList(2245, 52), Medium) // 8143h AI interrupt delta net PV
    (33092, 33092, SubList(2297, 31), SubList(0, 2), Optional, None, SubList(0, 0), SubList(598, 3), SubList(0, 0), SubList(2328, 56), Medium) // 8144h AI interrupt lower limit net PV
    (33093, 33093, SubList(2384, 31), SubList(0, 2), Optional, None, SubList(0, 0), SubList(601, 3), SubList(0, 0), SubList(2415, 56), Medium) // 8145h AI interrupt upper limit net PV
    (33096, 33096, SubList(2471, 13), SubList(0, 2), Optional, None, SubList(0, 0), SubList(604, 3), SubList(0, 0), SubList(2484, 68), Medium) // 8148h AI span start
    (33097, 33097, SubList(2552, 11), SubList(0, 2), Optional, None, SubList(0, 0), SubList(607, 3), SubList(0, 0), SubList(2563, 68), Medium) // 8149h AI span end
    (33536, 33536, SubList(3939, 12), SubList(0, 2), Optional, None, SubList(0, 0), SubList(610, 3), SubList(0, 0), SubList(3951, 69), Medium) // 8300h AO output PV
    (33568, 33568, SubList(4245, 22), SubList(0, 2), Optional, None, SubList(0, 0), SubList(613, 3), SubList(0, 0), SubList(4267, 80), Medium) // 8320h AO output scaling 1 PV
    (33569, 33569, SubList(4347, 22), SubList(0, 2), Optional, None, SubList(0, 0), SubList(616, 3), SubList(0, 0), SubList(4369, 78), Medium) // 8321h AO output scaling 1 FV
    (33570, 33570, SubList(4447, 22), SubList(0, 2), Optional, None, SubList(0, 0), SubList(619, 3), SubList(0, 0), SubList(4469, 81), Medium) // 8322h AO output scaling 2 PV
    (33571, 33571, SubList(4550, 22), SubList(0, 2), Optional, None, SubList(0, 0), SubList(622, 3), SubList(0, 0), SubList(4572, 79), Medium) // 8323h AO output scaling 2 FV
    (33584, 33584, SubList(4651, 12), SubList(0, 2), Optional, None, SubList(0, 0), SubList(625, 3), SubList(0, 0), SubList(4663, 74), Medium) // 8330h AO output FV
    (33601, 33601, SubList(4959, 11), SubList(0, 2), Optional, None, SubList(0, 0), SubList(628, 3), SubList(0, 0), SubList(4970, 66), Medium) // 8341h AO fault FV
    (33792, 33792, SubList(5036, 31), SubList(0, 2), Optional, None, SubList(0, 0), SubList(631, 3), SubList(0, 0), SubList(5067, 48), Medium) // 8400h CO effective current value Xeff
    (33793, 33793, SubList(5115, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(634, 3), SubList(0, 0), SubList(5142, 45), Medium) // 8401h CO effective set point Weff
    (33794, 33794, SubList(5187, 14), SubList(0, 2), Optional, None, SubList(0, 0), SubList(637, 3), SubList(0, 0), SubList(5201, 32), Medium) // 8402h CO set point W
    (33795, 33795, SubList(5233, 19), SubList(0, 2), Optional, None, SubList(0, 0), SubList(640, 3), SubList(0, 0), SubList(5252, 66), Medium) // 8403h CO 2nd set point W2
    (33796, 33796, SubList(5318, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(643, 3), SubList(0, 0), SubList(5345, 21), Medium) // 8404h CO lower set point limit W0
    (33797, 33797, SubList(5366, 29), SubList(0, 2), Optional, None, SubList(0, 0), SubList(646, 3), SubList(0, 0), SubList(5395, 22), Medium) // 8405h CO upper set point limit W100
    (33840, 33840, SubList(6467, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(649, 3), SubList(0, 0), SubList(6494, 57), Medium) // 8430h CO minimum pulse time Tmin1
    (33841, 33841, SubList(6551, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(652, 3), SubList(0, 0), SubList(6578, 58), Medium) // 8431h CO minimum pulse time Tmin2
    (33842, 33842, SubList(6636, 25), SubList(0, 2), Optional, None, SubList(0, 0), SubList(655, 3), SubList(0, 0), SubList(6661, 64), Medium) // 8432h CO motor response time Tm
    (33843, 33843, SubList(6725, 25), SubList(0, 2), Optional, None, SubList(0, 0), SubList(658, 3), SubList(0, 0), SubList(6750, 45), Medium) // 8433h CO min pulse length Tpuls
    (33856, 33856, SubList(6951, 32), SubList(0, 2), Optional, None, SubList(0, 0), SubList(661, 3), SubList(0, 0), SubList(6983, 80), Medium) // 8440h CO neutral zone three-point Xsh1
    (33857, 33857, SubList(7063, 32), SubList(0, 2), Optional, None, SubList(0, 0), SubList(664, 3), SubList(0, 0), SubList(7095, 81), Medium) // 8441h CO neutral zone three-point Xsh2
    (33858, 33858, SubList(7176, 40), SubList(0, 2), Optional, None, SubList(0, 0), SubList(667, 3), SubList(0, 0), SubList(7216, 54), Medium) // 8442h CO neutral zone three-point stepping Xsh
    (33859, 33859, SubList(7270, 41), SubList(0, 2), Optional, None, SubList(0, 0), SubList(670, 3), SubList(0, 0), SubList(7311, 39), Medium) // 8443h CO switching difference of signaller Xsd1
    (33860, 33860, SubList(7350, 50), SubList(0, 2), Optional, None, SubList(0, 0), SubList(673, 3), SubList(0, 0), SubList(7400, 41), Medium) // 8444h CO switching difference of additional contact Xsd2
    (33861, 33861, SubList(7441, 52), SubList(0, 2), Optional, None, SubList(0, 0), SubList(676, 3), SubList(0, 0), SubList(7493, 76), Medium) // 8445h CO trigger point separation of additional contact LW
    (33872, 33872, SubList(7569, 24), SubList(0, 2), Optional, None, SubList(0, 0), SubList(679, 3), SubList(0, 0), SubList(7593, 49), Medium) // 8450h CO proportional band Xp1
    (33873, 33873, SubList(7642, 24), SubList(0, 2), Optional, None, SubList(0, 0), SubList(682, 3), SubList(0, 0), SubList(7666, 50), Medium) // 8451h CO proportional band Xp2
    (33874, 33874, SubList(7716, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(685, 3), SubList(0, 0), SubList(7743, 52), Medium) // 8452h CO integral action time Tn1
    (33875, 33875, SubList(7795, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(688, 3), SubList(0, 0), SubList(7822, 53), Medium) // 8453h CO integral action time Tn2
    (33876, 33876, SubList(7875, 29), SubList(0, 2), Optional, None, SubList(0, 0), SubList(691, 3), SubList(0, 0), SubList(7904, 54), Medium) // 8454h CO derivative action time Tv1
    (33877, 33877, SubList(7958, 29), SubList(0, 2), Optional, None, SubList(0, 0), SubList(694, 3), SubList(0, 0), SubList(7987, 55), Medium) // 8455h CO derivative action time Tv2
    (33878, 33878, SubList(8042, 16), SubList(0, 2), Optional, None, SubList(0, 0), SubList(697, 3), SubList(0, 0), SubList(8058, 41), Medium) // 8456h CO cycle time T1
    (33879, 33879, SubList(8099, 16), SubList(0, 2), Optional, None, SubList(0, 0), SubList(700, 3), SubList(0, 0), SubList(8115, 42), Medium) // 8457h CO cycle time T2
    (34048, 34048, SubList(8321, 14), SubList(0, 2), Optional, None, SubList(0, 0), SubList(703, 3), SubList(0, 0), SubList(8335, 32), Medium) // 8500h AL input value
    (34052, 34052, SubList(8438, 24), SubList(0, 2), Optional, None, SubList(0, 0), SubList(706, 3), SubList(0, 0), SubList(8462, 68), Medium) // 8504h AL alternate input value
    (34058, 34058, SubList(8939, 8), SubList(0, 2), Optional, None, SubList(0, 0), SubList(709, 3), SubList(0, 0), SubList(8947, 42), Medium) // 850Ah AL level
    (34059, 34059, SubList(8989, 13), SubList(0, 2), Optional, None, SubList(0, 0), SubList(712, 3), SubList(0, 0), SubList(9002, 68), Medium) // 850Bh AL hysteresis
    (36688, 36688, SubList(10271, 10), SubList(0, 2), Optional, None, SubList(0, 0), SubList(715, 3), SubList(0, 0), SubList(10281, 58), Medium) // 8F50h Receive PV
    (36689, 36689, SubList(10339, 20), SubList(0, 2), Optional, None, SubList(0, 0), SubList(718, 3), SubList(0, 0), SubList(10359, 67), Medium) // 8F51h Alternate receive PV
    (37120, 37120, SubList(311, 11), SubList(0, 2), Optional, None, SubList(0, 0), SubList(721, 3), SubList(0, 0), SubList(322, 71), Medium) // 9100h AI input FV
    (37123, 37123, SubList(393, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(724, 3), SubList(0, 0), SubList(420, 54), Medium) // 9103h AI interrupt delta input FV
    (37152, 37152, SubList(763, 21), SubList(0, 2), Optional, None, SubList(0, 0), SubList(727, 3), SubList(0, 0), SubList(784, 77), Medium) // 9120h AI input scaling 1 FV
    (37153, 37153, SubList(861, 21), SubList(0, 2), Optional, None, SubList(0, 0), SubList(730, 3), SubList(0, 0), SubList(882, 79), Medium) // 9121h AI input scaling 1 PV
    (37154, 37154, SubList(961, 21), SubList(0, 2), Optional, None, SubList(0, 0), SubList(733, 3), SubList(0, 0), SubList(982, 78), Medium) // 9122h AI input scaling 2 FV
    (37155, 37155, SubList(1060, 21), SubList(0, 2), Optional, None, SubList(0, 0), SubList(736, 3), SubList(0, 0), SubList(1081, 80), Medium) // 9123h AI input scaling 2 PV
    (37156, 37156, SubList(1161, 15), SubList(0, 2), Optional, None, SubList(0, 0), SubList(739, 3), SubList(0, 0), SubList(1176, 48), Medium) // 9124h AI input offset
    (37168, 37168, SubList(1457, 11), SubList(0, 2), Optional, None, SubList(0, 0), SubList(742, 3), SubList(0, 0), SubList(1468, 68), Medium) // 9130h AI input PV
    (37171, 37171, SubList(1740, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(745, 3), SubList(0, 0), SubList(1767, 56), Medium) // 9133h AI interrupt delta input PV
    (37172, 37172, SubList(1823, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(748, 3), SubList(0, 0), SubList(1850, 60), Medium) // 9134h AI interrupt lower input PV
    (37173, 37173, SubList(1910, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(751, 3), SubList(0, 0), SubList(1937, 60), Medium) // 9135h AI interrupt upper input PV
    (37176, 37176, SubList(1997, 12), SubList(0, 2), Optional, None, SubList(0, 0), SubList(754, 3), SubList(0, 0), SubList(2009, 73), Medium) // 9138h AI tare zero
    (37184, 37184, SubList(2155, 9), SubList(0, 2), Optional, None, SubList(0, 0), SubList(757, 3), SubList(0, 0), SubList(2164, 56), Medium) // 9140h AI net PV
    (37187, 37187, SubList(2220, 25), SubList(0, 2), Optional, None, SubList(0, 0), SubList(760, 3), SubList(0, 0), SubList(2245, 52), Medium) // 9143h AI interrupt delta net PV
    (37188, 37188, SubList(2297, 31), SubList(0, 2), Optional, None, SubList(0, 0), SubList(763, 3), SubList(0, 0), SubList(2328, 56), Medium) // 9144h AI interrupt lower limit net PV
    (37189, 37189, SubList(2384, 31), SubList(0, 2), Optional, None, SubList(0, 0), SubList(766, 3), SubList(0, 0), SubList(2415, 56), Medium) // 9145h AI interrupt upper limit net PV
    (37192, 37192, SubList(2471, 13), SubList(0, 2), Optional, None, SubList(0, 0), SubList(769, 3), SubList(0, 0), SubList(2484, 68), Medium) // 9148h AI span start
    (37193, 37193, SubList(2552, 11), SubList(0, 2), Optional, None, SubList(0, 0), SubList(772, 3), SubList(0, 0), SubList(2563, 68), Medium) // 9149h AI span end
    (37632, 37632, SubList(3939, 12), SubList(0, 2), Optional, None, SubList(0, 0), SubList(775, 3), SubList(0, 0), SubList(3951, 69), Medium) // 9300h AO output PV
    (37664, 37664, SubList(4245, 22), SubList(0, 2), Optional, None, SubList(0, 0), SubList(778, 3), SubList(0, 0), SubList(4267, 80), Medium) // 9320h AO output scaling 1 PV
    (37665, 37665, SubList(4347, 22), SubList(0, 2), Optional, None, SubList(0, 0), SubList(781, 3), SubList(0, 0), SubList(4369, 78), Medium) // 9321h AO output scaling 1 FV
    (37666, 37666, SubList(4447, 22), SubList(0, 2), Optional, None, SubList(0, 0), SubList(784, 3), SubList(0, 0), SubList(4469, 81), Medium) // 9322h AO output scaling 2 PV
    (37667, 37667, SubList(4550, 22), SubList(0, 2), Optional, None, SubList(0, 0), SubList(787, 3), SubList(0, 0), SubList(4572, 79), Medium) // 9323h AO output scaling 2 FV
    (37680, 37680, SubList(4651, 12), SubList(0, 2), Optional, None, SubList(0, 0), SubList(790, 3), SubList(0, 0), SubList(4663, 74), Medium) // 9330h AO output FV
    (37697, 37697, SubList(4959, 11), SubList(0, 2), Optional, None, SubList(0, 0), SubList(793, 3), SubList(0, 0), SubList(4970, 66), Medium) // 9341h AO fault FV
    (37888, 37888, SubList(5036, 31), SubList(0, 2), Optional, None, SubList(0, 0), SubList(796, 3), SubList(0, 0), SubList(5067, 48), Medium) // 9400h CO effective current value Xeff
    (37889, 37889, SubList(5115, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(799, 3), SubList(0, 0), SubList(5142, 45), Medium) // 9401h CO effective set point Weff
    (37890, 37890, SubList(5187, 14), SubList(0, 2), Optional, None, SubList(0, 0), SubList(802, 3), SubList(0, 0), SubList(5201, 32), Medium) // 9402h CO set point W
    (37891, 37891, SubList(5233, 19), SubList(0, 2), Optional, None, SubList(0, 0), SubList(805, 3), SubList(0, 0), SubList(5252, 66), Medium) // 9403h CO 2nd set point W2
    (37892, 37892, SubList(5318, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(808, 3), SubList(0, 0), SubList(5345, 21), Medium) // 9404h CO lower set point limit W0
    (37893, 37893, SubList(5366, 29), SubList(0, 2), Optional, None, SubList(0, 0), SubList(811, 3), SubList(0, 0), SubList(5395, 22), Medium) // 9405h CO upper set point limit W100
    (37936, 37936, SubList(6467, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(814, 3), SubList(0, 0), SubList(6494, 57), Medium) // 9430h CO minimum pulse time Tmin1
    (37937, 37937, SubList(6551, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(817, 3), SubList(0, 0), SubList(6578, 58), Medium) // 9431h CO minimum pulse time Tmin2
    (37938, 37938, SubList(6636, 25), SubList(0, 2), Optional, None, SubList(0, 0), SubList(820, 3), SubList(0, 0), SubList(6661, 64), Medium) // 9432h CO motor response time Tm
    (37939, 37939, SubList(6725, 25), SubList(0, 2), Optional, None, SubList(0, 0), SubList(823, 3), SubList(0, 0), SubList(6750, 45), Medium) // 9433h CO min pulse length Tpuls
    (37952, 37952, SubList(6951, 32), SubList(0, 2), Optional, None, SubList(0, 0), SubList(826, 3), SubList(0, 0), SubList(6983, 80), Medium) // 9440h CO neutral zone three-point Xsh1
    (37953, 37953, SubList(7063, 32), SubList(0, 2), Optional, None, SubList(0, 0), SubList(829, 3), SubList(0, 0), SubList(7095, 81), Medium) // 9441h CO neutral zone three-point Xsh2
    (37954, 37954, SubList(7176, 40), SubList(0, 2), Optional, None, SubList(0, 0), SubList(832, 3), SubList(0, 0), SubList(7216, 54), Medium) // 9442h CO neutral zone three-point stepping Xsh
    (37955, 37955, SubList(7270, 41), SubList(0, 2), Optional, None, SubList(0, 0), SubList(835, 3), SubList(0, 0), SubList(7311, 39), Medium) // 9443h CO switching difference of signaller Xsd1
    (37956, 37956, SubList(7350, 50), SubList(0, 2), Optional, None, SubList(0, 0), SubList(838, 3), SubList(0, 0), SubList(7400, 41), Medium) // 9444h CO switching difference of additional contact Xsd2
    (37957, 37957, SubList(7441, 52), SubList(0, 2), Optional, None, SubList(0, 0), SubList(841, 3), SubList(0, 0), SubList(7493, 76), Medium) // 9445h CO trigger point separation of additional contact LW
    (37968, 37968, SubList(7569, 24), SubList(0, 2), Optional, None, SubList(0, 0), SubList(844, 3), SubList(0, 0), SubList(7593, 49), Medium) // 9450h CO proportional band Xp1
    (37969, 37969, SubList(7642, 24), SubList(0, 2), Optional, None, SubList(0, 0), SubList(847, 3), SubList(0, 0), SubList(7666, 50), Medium) // 9451h CO proportional band Xp2
    (37970, 37970, SubList(7716, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(850, 3), SubList(0, 0), SubList(7743, 52), Medium) // 9452h CO integral action time Tn1
    (37971, 37971, SubList(7795, 27), SubList(0, 2), Optional, None, SubList(0, 0), SubList(853, 3), SubList(0, 0), SubList(7822, 53), Medium) // 9453h CO integral action time Tn2
    (37972, 37972, SubList(7875, 29), SubList(0, 2), Optional, None, SubList(0, 0), SubList(856, 3), SubList(0, 0), SubList(7904, 54), Medium) // 9454h CO derivative action time Tv1
    (37973, 37973, SubList(7958, 29), SubList(0, 2), Optional, None, SubList(0, 0), SubList(859, 3), SubList(0, 0), SubList(7987, 55), Medium) // 9455h CO derivative action time Tv2
    (37974, 37974, SubList(8042, 16), SubList(0, 2), Optional, None, SubList(0, 0), SubList(862, 3), SubList(0, 0), SubList(8058, 41), Medium) // 9456h CO cycle time T1
    (37975, 37975, SubList(8099, 16), SubList(0, 2), Optional, None, SubList(0, 0), SubList(865, 3), SubList(0, 0), SubList(8115, 42), Medium) // 9457h CO cycle time T2
    (38144, 38144, SubList(8321, 14), SubList(0, 2), Optional, None, SubList(0, 0), SubList(868, 3), SubList(0, 0), SubList(8335, 32), Medium) // 9500h AL input value
    (38148, 38148, SubList(8438, 24), SubList(0, 2), Optional, None, SubList(0, 0), SubList(871, 3), SubList(0, 0), SubList(8462, 68), Medium) // 9504h AL alternate input value
    (38154, 38154, SubList(8939, 8), SubList(0, 2), Optional, None, SubList(0, 0), SubList(874, 3), SubList(0, 0), SubList(8947, 42), Medium) // 950Ah AL level
    (38155, 38155, SubList(8989, 13), SubList(0, 2), Optional, None, SubList(0, 0), SubList(877, 3), SubList(0, 0), SubList(9002, 68), Medium) // 950Bh AL hysteresis
    (40784, 40784, SubList(10271, 10), SubList(0, 2), Optional, None, SubList(0, 0), SubList(880, 3), SubList(0, 0), SubList(10281, 58), Medium) // 9F50h Receive PV
    (40785, 40785, SubList(10339, 20), SubList(0, 2), Optional, None, SubList(0, 0), SubList(883, 3), SubList(0, 0), SubList(10359, 67), Medium) // 9F51h Alternate receive PV
);

static ENTRIES: &[EntryRow] = table!(EntryRow { first, last, mapping, need, name, data_types, access, values, default, unit, bits }:
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(0, 27), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // DI read state 8 input lines
    (2, 199, Some(Tpdo), Optional, SubList(0, 27), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // DI read state 8 input lines
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(105, 25), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // DI polarity 8 input lines
    (2, 199, None, Optional, SubList(105, 25), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // DI polarity 8 input lines
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(172, 26), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // DI read state 1 input line
    (2, 199, Some(Tpdo), Optional, SubList(172, 26), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // DI read state 1 input line
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(247, 24), SubList(1, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // DI polarity 1 input line
    (2, 199, None, Optional, SubList(247, 24), SubList(1, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // DI polarity 1 input line
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(311, 11), SubList(2, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input FV
    (2, 199, Some(Tpdo), Optional, SubList(311, 11), SubList(2, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(393, 27), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt delta input FV
    (2, 199, None, Optional, SubList(393, 27), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt delta input FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(474, 14), SubList(3, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI sensor type
    (2, 199, Some(Any), Optional, SubList(474, 14), SubList(3, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI sensor type
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(532, 18), SubList(4, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI autocalibration
    (2, 199, None, Optional, SubList(532, 18), SubList(4, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI autocalibration
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(594, 17), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 1)) // AI operating mode
    (2, 199, Some(Any), Optional, SubList(594, 17), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 1)) // AI operating mode
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(692, 18), SubList(4, 1), SubList(0, 1), SubList(0, 0), None, SubList(710, 3), SubList(0, 0)) // AI ADC sample rate
    (2, 199, Some(Tpdo), Optional, SubList(692, 18), SubList(4, 1), SubList(0, 1), SubList(0, 0), None, SubList(710, 3), SubList(0, 0)) // AI ADC sample rate
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(763, 21), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 1 FV
    (2, 199, None, Optional, SubList(763, 21), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 1 FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(861, 21), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 1 PV
    (2, 199, None, Optional, SubList(861, 21), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 1 PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(961, 21), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 2 FV
    (2, 199, None, Optional, SubList(961, 21), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 2 FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(1060, 21), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 2 PV
    (2, 199, None, Optional, SubList(1060, 21), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 2 PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(1161, 15), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input offset
    (2, 199, None, Optional, SubList(1161, 15), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input offset
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(1224, 11), SubList(4, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI autozero
    (2, 199, None, Optional, SubList(1224, 11), SubList(4, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI autozero
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(1317, 17), SubList(2, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI scaling factor
    (2, 199, None, Optional, SubList(1317, 17), SubList(2, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI scaling factor
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(1387, 17), SubList(2, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI scaling offset
    (2, 199, Some(Any), Optional, SubList(1387, 17), SubList(2, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI scaling offset
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(1457, 11), SubList(2, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input PV
    (2, 199, Some(Tpdo), Optional, SubList(1457, 11), SubList(2, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(1536, 19), SubList(4, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(1, 3)) // AI physical unit PV
    (2, 199, None, Optional, SubList(1536, 19), SubList(4, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(1, 3)) // AI physical unit PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(1647, 20), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI decimal digits PV
    (2, 199, Some(Any), Optional, SubList(1647, 20), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI decimal digits PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(1740, 27), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt delta input PV
    (2, 199, None, Optional, SubList(1740, 27), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt delta input PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(1823, 27), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt lower input PV
    (2, 199, None, Optional, SubList(1823, 27), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt lower input PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(1910, 27), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt upper input PV
    (2, 199, None, Optional, SubList(1910, 27), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt upper input PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(1997, 12), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI tare zero
    (2, 199, None, Optional, SubList(1997, 12), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI tare zero
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(2082, 11), SubList(4, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI autotare
    (2, 199, Some(Any), Optional, SubList(2082, 11), SubList(4, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI autotare
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(2155, 9), SubList(2, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI net PV
    (2, 199, Some(Tpdo), Optional, SubList(2155, 9), SubList(2, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI net PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(2220, 25), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt delta net PV
    (2, 199, None, Optional, SubList(2220, 25), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt delta net PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(2297, 31), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt lower limit net PV
    (2, 199, None, Optional, SubList(2297, 31), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt lower limit net PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(2384, 31), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt upper limit net PV
    (2, 199, None, Optional, SubList(2384, 31), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt upper limit net PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(2471, 13), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI span start
    (2, 199, None, Optional, SubList(2471, 13), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI span start
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(2552, 11), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI span end
    (2, 199, None, Optional, SubList(2552, 11), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI span end
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(2631, 9), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(4, 3)) // AI status
    (2, 199, Some(Tpdo), Optional, SubList(2631, 9), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(4, 3)) // AI status
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(2758, 15), SubList(0, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI control byte
    (2, 199, Some(Any), Optional, SubList(2758, 15), SubList(0, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI control byte
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(2846, 22), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI control byte enable
    (2, 199, None, Optional, SubList(2846, 22), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI control byte enable
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(2914, 14), SubList(0, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(7, 1)) // AI filter type
    (2, 199, None, Optional, SubList(2914, 14), SubList(0, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(7, 1)) // AI filter type
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(3022, 18), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI filter constant
    (2, 199, None, Optional, SubList(3022, 18), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI filter constant
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(3088, 29), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // DO write state 8 output lines
    (2, 199, Some(Any), Optional, SubList(3088, 29), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // DO write state 8 output lines
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(3161, 26), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // DO polarity 8 output lines
    (2, 199, None, Optional, SubList(3161, 26), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // DO polarity 8 output lines
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(3230, 28), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // DO fault mode 8 output lines
    (2, 199, None, Optional, SubList(3230, 28), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // DO fault mode 8 output lines
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(3332, 29), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // DO fault state 8 output lines
    (2, 199, None, Optional, SubList(3332, 29), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // DO fault state 8 output lines
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(3429, 29), SubList(4, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // DO link object 8 output lines
    (2, 199, None, Optional, SubList(3429, 29), SubList(4, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // DO link object 8 output lines
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(3519, 28), SubList(1, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // DO write state 1 output line
    (2, 199, Some(Any), Optional, SubList(3519, 28), SubList(1, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // DO write state 1 output line
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(3589, 25), SubList(1, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // DO polarity 1 output line
    (2, 199, None, Optional, SubList(3589, 25), SubList(1, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // DO polarity 1 output line
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(3655, 27), SubList(1, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // DO fault mode 1 output line
    (2, 199, None, Optional, SubList(3655, 27), SubList(1, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // DO fault mode 1 output line
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(3759, 28), SubList(1, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // DO fault state 1 output line
    (2, 199, None, Optional, SubList(3759, 28), SubList(1, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // DO fault state 1 output line
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(3855, 28), SubList(4, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // DO link object 1 output line
    (2, 199, None, Optional, SubList(3855, 28), SubList(4, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // DO link object 1 output line
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(3939, 12), SubList(2, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output PV
    (2, 199, Some(Any), Optional, SubList(3939, 12), SubList(2, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(4020, 19), SubList(4, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(1, 3)) // AO physical unit PV
    (2, 199, None, Optional, SubList(4020, 19), SubList(4, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(1, 3)) // AO physical unit PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(4091, 20), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO decimal digits PV
    (2, 199, None, Optional, SubList(4091, 20), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO decimal digits PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(4111, 17), SubList(4, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO link output PV
    (2, 199, None, Optional, SubList(4111, 17), SubList(4, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO link output PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(4186, 14), SubList(3, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output type
    (2, 199, None, Optional, SubList(4186, 14), SubList(3, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output type
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(4245, 22), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 1 PV
    (2, 199, None, Optional, SubList(4245, 22), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 1 PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(4347, 22), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 1 FV
    (2, 199, None, Optional, SubList(4347, 22), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 1 FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(4447, 22), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 2 PV
    (2, 199, None, Optional, SubList(4447, 22), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 2 PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(4550, 22), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 2 FV
    (2, 199, None, Optional, SubList(4550, 22), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 2 FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(4651, 12), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output FV
    (2, 199, None, Optional, SubList(4651, 12), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(4737, 19), SubList(4, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(1, 3)) // AO physical unit FV
    (2, 199, None, Optional, SubList(4737, 19), SubList(4, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(1, 3)) // AO physical unit FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(4806, 20), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO decimal digits FV
    (2, 199, None, Optional, SubList(4806, 20), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO decimal digits FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(4897, 13), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO fault mode
    (2, 199, None, Optional, SubList(4897, 13), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO fault mode
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(4959, 11), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO fault FV
    (2, 199, None, Optional, SubList(4959, 11), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO fault FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(5036, 31), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO effective current value Xeff
    (2, 199, Some(Any), Optional, SubList(5036, 31), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO effective current value Xeff
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(5115, 27), SubList(2, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO effective set point Weff
    (2, 199, Some(Tpdo), Optional, SubList(5115, 27), SubList(2, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO effective set point Weff
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(5187, 14), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO set point W
    (2, 199, Some(Any), Optional, SubList(5187, 14), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO set point W
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(5233, 19), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO 2nd set point W2
    (2, 199, Some(Any), Optional, SubList(5233, 19), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO 2nd set point W2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(5318, 27), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO lower set point limit W0
    (2, 199, None, Optional, SubList(5318, 27), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO lower set point limit W0
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(5366, 29), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO upper set point limit W100
    (2, 199, None, Optional, SubList(5366, 29), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO upper set point limit W100
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(5417, 19), SubList(4, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(1, 3)) // CO physical unit XW
    (2, 199, None, Optional, SubList(5417, 19), SubList(4, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(1, 3)) // CO physical unit XW
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(5475, 20), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO decimal digits XW
    (2, 199, None, Optional, SubList(5475, 20), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO decimal digits XW
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(5577, 32), SubList(3, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO effective controller output Y
    (2, 199, Some(Tpdo), Optional, SubList(5577, 32), SubList(3, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO effective controller output Y
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(5638, 39), SubList(3, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO differential controller output Ydiff
    (2, 199, Some(Tpdo), Optional, SubList(5638, 39), SubList(3, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO differential controller output Ydiff
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(5715, 27), SubList(3, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO manual controller output
    (2, 199, Some(Any), Optional, SubList(5715, 27), SubList(3, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO manual controller output
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(5786, 37), SubList(3, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO lower controller output limit Ymin
    (2, 199, None, Optional, SubList(5786, 37), SubList(3, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO lower controller output limit Ymin
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(5859, 37), SubList(3, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO upper controller output limit Ymax
    (2, 199, None, Optional, SubList(5859, 37), SubList(3, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO upper controller output limit Ymax
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(5933, 34), SubList(4, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(1, 3)) // CO physical unit controller output
    (2, 199, None, Optional, SubList(5933, 34), SubList(4, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(1, 3)) // CO physical unit controller output
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(6003, 24), SubList(1, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO set point switch W-W2
    (2, 199, Some(Any), Optional, SubList(6003, 24), SubList(1, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO set point switch W-W2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(6070, 28), SubList(1, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(8, 1)) // CO automatic/manual mode A-M
    (2, 199, Some(Any), Optional, SubList(6070, 28), SubList(1, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(8, 1)) // CO automatic/manual mode A-M
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(6142, 20), SubList(1, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(9, 1)) // CO controller on/off
    (2, 199, Some(Any), Optional, SubList(6142, 20), SubList(1, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(9, 1)) // CO controller on/off
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(6210, 18), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO controller mode
    (2, 199, Some(Any), Optional, SubList(6210, 18), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO controller mode
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(6255, 27), SubList(1, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO self optimization on/off
    (2, 199, Some(Any), Optional, SubList(6255, 27), SubList(1, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO self optimization on/off
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(6335, 15), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO control byte
    (2, 199, Some(Any), Optional, SubList(6335, 15), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO control byte
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(6389, 22), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO control byte enable
    (2, 199, None, Optional, SubList(6389, 22), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO control byte enable
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(6411, 14), SubList(3, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO status word
    (2, 199, Some(Tpdo), Optional, SubList(6411, 14), SubList(3, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO status word
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(6467, 27), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO minimum pulse time Tmin1
    (2, 199, None, Optional, SubList(6467, 27), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO minimum pulse time Tmin1
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(6551, 27), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO minimum pulse time Tmin2
    (2, 199, None, Optional, SubList(6551, 27), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO minimum pulse time Tmin2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(6636, 25), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO motor response time Tm
    (2, 199, None, Optional, SubList(6636, 25), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO motor response time Tm
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(6725, 25), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO min pulse length Tpuls
    (2, 199, None, Optional, SubList(6725, 25), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO min pulse length Tpuls
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(6795, 29), SubList(4, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(1, 3)) // CO physical unit pulse timing
    (2, 199, None, Optional, SubList(6795, 29), SubList(4, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(1, 3)) // CO physical unit pulse timing
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(6856, 20), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO decimal digits PT
    (2, 199, None, Optional, SubList(6856, 20), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO decimal digits PT
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(6951, 32), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO neutral zone three-point Xsh1
    (2, 199, None, Optional, SubList(6951, 32), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO neutral zone three-point Xsh1
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7063, 32), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO neutral zone three-point Xsh2
    (2, 199, None, Optional, SubList(7063, 32), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO neutral zone three-point Xsh2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7176, 40), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO neutral zone three-point stepping Xsh
    (2, 199, None, Optional, SubList(7176, 40), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO neutral zone three-point stepping Xsh
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7270, 41), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO switching difference of signaller Xsd1
    (2, 199, None, Optional, SubList(7270, 41), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO switching difference of signaller Xsd1
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7350, 50), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO switching difference of additional contact Xsd2
    (2, 199, None, Optional, SubList(7350, 50), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO switching difference of additional contact Xsd2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7441, 52), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO trigger point separation of additional contact LW
    (2, 199, None, Optional, SubList(7441, 52), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO trigger point separation of additional contact LW
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7569, 24), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO proportional band Xp1
    (2, 199, None, Optional, SubList(7569, 24), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO proportional band Xp1
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7642, 24), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO proportional band Xp2
    (2, 199, None, Optional, SubList(7642, 24), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO proportional band Xp2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7716, 27), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO integral action time Tn1
    (2, 199, None, Optional, SubList(7716, 27), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO integral action time Tn1
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7795, 27), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO integral action time Tn2
    (2, 199, None, Optional, SubList(7795, 27), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO integral action time Tn2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7875, 29), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO derivative action time Tv1
    (2, 199, None, Optional, SubList(7875, 29), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO derivative action time Tv1
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7958, 29), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO derivative action time Tv2
    (2, 199, None, Optional, SubList(7958, 29), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO derivative action time Tv2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8042, 16), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO cycle time T1
    (2, 199, None, Optional, SubList(8042, 16), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO cycle time T1
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8099, 16), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO cycle time T2
    (2, 199, None, Optional, SubList(8099, 16), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO cycle time T2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8157, 20), SubList(4, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(1, 3)) // CO physical unit PID
    (2, 199, None, Optional, SubList(8157, 20), SubList(4, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(1, 3)) // CO physical unit PID
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8217, 21), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO decimal digits PID
    (2, 199, None, Optional, SubList(8217, 21), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO decimal digits PID
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(8321, 14), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL input value
    (2, 199, Some(Any), Optional, SubList(8321, 14), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL input value
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8367, 13), SubList(4, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL link input
    (2, 199, None, Optional, SubList(8367, 13), SubList(4, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL link input
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8438, 24), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL alternate input value
    (2, 199, None, Optional, SubList(8438, 24), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL alternate input value
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8530, 23), SubList(0, 0), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL link alternate input
    (2, 199, None, Optional, SubList(8530, 23), SubList(0, 0), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL link alternate input
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8647, 13), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL fault mode
    (2, 199, None, Optional, SubList(8647, 13), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL fault mode
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8704, 14), SubList(1, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(10, 1)) // AL fault state
    (2, 199, None, Optional, SubList(8704, 14), SubList(1, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(10, 1)) // AL fault state
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8797, 7), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL type
    (2, 199, None, Optional, SubList(8797, 7), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL type
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8864, 9), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL action
    (2, 199, None, Optional, SubList(8864, 9), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL action
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8939, 8), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL level
    (2, 199, None, Optional, SubList(8939, 8), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL level
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8989, 13), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL hysteresis
    (2, 199, None, Optional, SubList(8989, 13), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL hysteresis
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(9070, 8), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL group
    (2, 199, None, Optional, SubList(9070, 8), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL group
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(9113, 8), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(11, 1)) // AL state
    (2, 199, Some(Tpdo), Optional, SubList(9113, 8), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(11, 1)) // AL state
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(9148, 8), SubList(1, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(12, 1)) // AL reset
    (2, 199, None, Optional, SubList(9148, 8), SubList(1, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(12, 1)) // AL reset
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(9193, 15), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(13, 8)) // AL 1 to 8 state
    (2, 199, Some(Tpdo), Optional, SubList(9193, 15), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(13, 8)) // AL 1 to 8 state
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(9310, 16), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(21, 8)) // AL 9 to 16 state
    (2, 199, Some(Tpdo), Optional, SubList(9310, 16), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(21, 8)) // AL 9 to 16 state
    (0, 0, Some(Any), Mandatory, SubList(0, 0), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(29, 1))
    (0, 0, Some(Any), Mandatory, SubList(0, 0), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(30, 8))
    (0, 0, Some(Any), Mandatory, SubList(0, 0), SubList(1, 1), SubList(4, 1), SubList(0, 0), None, SubList(0, 0), SubList(38, 1))
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(9769, 15), SubList(0, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(39, 8)) // AL 1 to 8 reset
    (2, 199, Some(Any), Optional, SubList(9769, 15), SubList(0, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(39, 8)) // AL 1 to 8 reset
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(9933, 16), SubList(0, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(47, 8)) // AL 9 to 16 reset
    (2, 199, Some(Any), Optional, SubList(9933, 16), SubList(0, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(47, 8)) // AL 9 to 16 reset
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(10106, 12), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Life counter
    (2, 199, Some(Tpdo), Optional, SubList(10106, 12), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Life counter
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(10151, 17), SubList(0, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Receive PDO check
    (2, 199, Some(Any), Optional, SubList(10151, 17), SubList(0, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Receive PDO check
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(10220, 18), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Transmit PDO check
    (2, 199, Some(Tpdo), Optional, SubList(10220, 18), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Transmit PDO check
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(10271, 10), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Receive PV
    (2, 199, Some(Any), Optional, SubList(10271, 10), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Receive PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(10339, 20), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Alternate receive PV
    (2, 199, Some(Any), Optional, SubList(10339, 20), SubList(2, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Alternate receive PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(10426, 15), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Received status
    (2, 199, Some(Any), Optional, SubList(10426, 15), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Received status
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(10496, 25), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Alternate received status
    (2, 199, Some(Any), Optional, SubList(10496, 25), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Alternate received status
    (0, 0, None, Mandatory, SubList(0, 0), SubList(1, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(311, 11), SubList(5, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input FV
    (2, 199, Some(Tpdo), Optional, SubList(311, 11), SubList(5, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(393, 27), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt delta input FV
    (2, 199, None, Optional, SubList(393, 27), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt delta input FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(763, 21), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 1 FV
    (2, 199, None, Optional, SubList(763, 21), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 1 FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(861, 21), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 1 PV
    (2, 199, None, Optional, SubList(861, 21), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 1 PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(961, 21), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 2 FV
    (2, 199, None, Optional, SubList(961, 21), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 2 FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(1060, 21), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 2 PV
    (2, 199, None, Optional, SubList(1060, 21), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 2 PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(1161, 15), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input offset
    (2, 199, None, Optional, SubList(1161, 15), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input offset
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(1457, 11), SubList(5, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input PV
    (2, 199, Some(Tpdo), Optional, SubList(1457, 11), SubList(5, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(1740, 27), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt delta input PV
    (2, 199, None, Optional, SubList(1740, 27), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt delta input PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(1823, 27), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt lower input PV
    (2, 199, None, Optional, SubList(1823, 27), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt lower input PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(1910, 27), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt upper input PV
    (2, 199, None, Optional, SubList(1910, 27), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt upper input PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(1997, 12), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI tare zero
    (2, 199, None, Optional, SubList(1997, 12), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI tare zero
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(2155, 9), SubList(5, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI net PV
    (2, 199, Some(Tpdo), Optional, SubList(2155, 9), SubList(5, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI net PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(2220, 25), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt delta net PV
    (2, 199, None, Optional, SubList(2220, 25), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt delta net PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(2297, 31), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt lower limit net PV
    (2, 199, None, Optional, SubList(2297, 31), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt lower limit net PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(2384, 31), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt upper limit net PV
    (2, 199, None, Optional, SubList(2384, 31), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt upper limit net PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(2471, 13), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI span start
    (2, 199, None, Optional, SubList(2471, 13), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI span start
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(2552, 11), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI span end
    (2, 199, None, Optional, SubList(2552, 11), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI span end
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(3939, 12), SubList(5, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output PV
    (2, 199, Some(Any), Optional, SubList(3939, 12), SubList(5, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(4245, 22), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 1 PV
    (2, 199, None, Optional, SubList(4245, 22), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 1 PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(4347, 22), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 1 FV
    (2, 199, None, Optional, SubList(4347, 22), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 1 FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(4447, 22), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 2 PV
    (2, 199, None, Optional, SubList(4447, 22), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 2 PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(4550, 22), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 2 FV
    (2, 199, None, Optional, SubList(4550, 22), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 2 FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(4651, 12), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output FV
    (2, 199, None, Optional, SubList(4651, 12), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(4959, 11), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO fault FV
    (2, 199, None, Optional, SubList(4959, 11), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO fault FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(5036, 31), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO effective current value Xeff
    (2, 199, Some(Any), Optional, SubList(5036, 31), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO effective current value Xeff
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(5115, 27), SubList(5, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO effective set point Weff
    (2, 199, Some(Tpdo), Optional, SubList(5115, 27), SubList(5, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO effective set point Weff
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(5187, 14), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO set point W
    (2, 199, Some(Any), Optional, SubList(5187, 14), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO set point W
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(5233, 19), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO 2nd set point W2
    (2, 199, Some(Any), Optional, SubList(5233, 19), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO 2nd set point W2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(5318, 27), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO lower set point limit W0
    (2, 199, None, Optional, SubList(5318, 27), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO lower set point limit W0
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(5366, 29), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO upper set point limit W100
    (2, 199, None, Optional, SubList(5366, 29), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO upper set point limit W100
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(6467, 27), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO minimum pulse time Tmin1
    (2, 199, None, Optional, SubList(6467, 27), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO minimum pulse time Tmin1
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(6551, 27), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO minimum pulse time Tmin2
    (2, 199, None, Optional, SubList(6551, 27), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO minimum pulse time Tmin2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(6636, 25), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO motor response time Tm
    (2, 199, None, Optional, SubList(6636, 25), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO motor response time Tm
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(6725, 25), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO min pulse length Tpuls
    (2, 199, None, Optional, SubList(6725, 25), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO min pulse length Tpuls
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(6951, 32), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO neutral zone three-point Xsh1
    (2, 199, None, Optional, SubList(6951, 32), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO neutral zone three-point Xsh1
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7063, 32), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO neutral zone three-point Xsh2
    (2, 199, None, Optional, SubList(7063, 32), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO neutral zone three-point Xsh2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7176, 40), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO neutral zone three-point stepping Xsh
    (2, 199, None, Optional, SubList(7176, 40), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO neutral zone three-point stepping Xsh
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7270, 41), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO switching difference of signaller Xsd1
    (2, 199, None, Optional, SubList(7270, 41), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO switching difference of signaller Xsd1
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7350, 50), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO switching difference of additional contact Xsd2
    (2, 199, None, Optional, SubList(7350, 50), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO switching difference of additional contact Xsd2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7441, 52), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO trigger point separation of additional contact LW
    (2, 199, None, Optional, SubList(7441, 52), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO trigger point separation of additional contact LW
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7569, 24), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO proportional band Xp1
    (2, 199, None, Optional, SubList(7569, 24), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO proportional band Xp1
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7642, 24), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO proportional band Xp2
    (2, 199, None, Optional, SubList(7642, 24), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO proportional band Xp2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7716, 27), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO integral action time Tn1
    (2, 199, None, Optional, SubList(7716, 27), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO integral action time Tn1
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7795, 27), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO integral action time Tn2
    (2, 199, None, Optional, SubList(7795, 27), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO integral action time Tn2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7875, 29), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO derivative action time Tv1
    (2, 199, None, Optional, SubList(7875, 29), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO derivative action time Tv1
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7958, 29), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO derivative action time Tv2
    (2, 199, None, Optional, SubList(7958, 29), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO derivative action time Tv2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8042, 16), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO cycle time T1
    (2, 199, None, Optional, SubList(8042, 16), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO cycle time T1
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8099, 16), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO cycle time T2
    (2, 199, None, Optional, SubList(8099, 16), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO cycle time T2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(8321, 14), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL input value
    (2, 199, Some(Any), Optional, SubList(8321, 14), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL input value
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8438, 24), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL alternate input value
    (2, 199, None, Optional, SubList(8438, 24), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL alternate input value
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8939, 8), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL level
    (2, 199, None, Optional, SubList(8939, 8), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL level
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8989, 13), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL hysteresis
    (2, 199, None, Optional, SubList(8989, 13), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL hysteresis
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(10271, 10), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Receive PV
    (2, 199, Some(Any), Optional, SubList(10271, 10), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Receive PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(10339, 20), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Alternate receive PV
    (2, 199, Some(Any), Optional, SubList(10339, 20), SubList(5, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Alternate receive PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(311, 11), SubList(6, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input FV
    (2, 199, Some(Tpdo), Optional, SubList(311, 11), SubList(6, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(393, 27), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt delta input FV
    (2, 199, None, Optional, SubList(393, 27), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt delta input FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(763, 21), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 1 FV
    (2, 199, None, Optional, SubList(763, 21), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 1 FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(861, 21), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 1 PV
    (2, 199, None, Optional, SubList(861, 21), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 1 PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(961, 21), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 2 FV
    (2, 199, None, Optional, SubList(961, 21), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 2 FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(1060, 21), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 2 PV
    (2, 199, None, Optional, SubList(1060, 21), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 2 PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(1161, 15), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input offset
    (2, 199, None, Optional, SubList(1161, 15), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input offset
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(1457, 11), SubList(6, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input PV
    (2, 199, Some(Tpdo), Optional, SubList(1457, 11), SubList(6, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(1740, 27), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt delta input PV
    (2, 199, None, Optional, SubList(1740, 27), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt delta input PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(1823, 27), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt lower input PV
    (2, 199, None, Optional, SubList(1823, 27), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt lower input PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(1910, 27), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt upper input PV
    (2, 199, None, Optional, SubList(1910, 27), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt upper input PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(1997, 12), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI tare zero
    (2, 199, None, Optional, SubList(1997, 12), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI tare zero
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(2155, 9), SubList(6, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI net PV
    (2, 199, Some(Tpdo), Optional, SubList(2155, 9), SubList(6, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI net PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(2220, 25), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt delta net PV
    (2, 199, None, Optional, SubList(2220, 25), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt delta net PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(2297, 31), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt lower limit net PV
    (2, 199, None, Optional, SubList(2297, 31), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt lower limit net PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(2384, 31), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt upper limit net PV
    (2, 199, None, Optional, SubList(2384, 31), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt upper limit net PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(2471, 13), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI span start
    (2, 199, None, Optional, SubList(2471, 13), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI span start
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(2552, 11), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI span end
    (2, 199, None, Optional, SubList(2552, 11), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI span end
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(3939, 12), SubList(6, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output PV
    (2, 199, Some(Any), Optional, SubList(3939, 12), SubList(6, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(4245, 22), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 1 PV
    (2, 199, None, Optional, SubList(4245, 22), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 1 PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(4347, 22), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 1 FV
    (2, 199, None, Optional, SubList(4347, 22), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 1 FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(4447, 22), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 2 PV
    (2, 199, None, Optional, SubList(4447, 22), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 2 PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(4550, 22), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 2 FV
    (2, 199, None, Optional, SubList(4550, 22), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 2 FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(4651, 12), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output FV
    (2, 199, None, Optional, SubList(4651, 12), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(4959, 11), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO fault FV
    (2, 199, None, Optional, SubList(4959, 11), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO fault FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(5036, 31), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO effective current value Xeff
    (2, 199, Some(Any), Optional, SubList(5036, 31), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO effective current value Xeff
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(5115, 27), SubList(6, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO effective set point Weff
    (2, 199, Some(Tpdo), Optional, SubList(5115, 27), SubList(6, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO effective set point Weff
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(5187, 14), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO set point W
    (2, 199, Some(Any), Optional, SubList(5187, 14), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO set point W
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(5233, 19), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO 2nd set point W2
    (2, 199, Some(Any), Optional, SubList(5233, 19), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO 2nd set point W2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(5318, 27), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO lower set point limit W0
    (2, 199, None, Optional, SubList(5318, 27), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO lower set point limit W0
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(5366, 29), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO upper set point limit W100
    (2, 199, None, Optional, SubList(5366, 29), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO upper set point limit W100
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(6467, 27), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO minimum pulse time Tmin1
    (2, 199, None, Optional, SubList(6467, 27), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO minimum pulse time Tmin1
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(6551, 27), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO minimum pulse time Tmin2
    (2, 199, None, Optional, SubList(6551, 27), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO minimum pulse time Tmin2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(6636, 25), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO motor response time Tm
    (2, 199, None, Optional, SubList(6636, 25), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO motor response time Tm
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(6725, 25), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO min pulse length Tpuls
    (2, 199, None, Optional, SubList(6725, 25), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO min pulse length Tpuls
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(6951, 32), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO neutral zone three-point Xsh1
    (2, 199, None, Optional, SubList(6951, 32), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO neutral zone three-point Xsh1
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7063, 32), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO neutral zone three-point Xsh2
    (2, 199, None, Optional, SubList(7063, 32), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO neutral zone three-point Xsh2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7176, 40), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO neutral zone three-point stepping Xsh
    (2, 199, None, Optional, SubList(7176, 40), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO neutral zone three-point stepping Xsh
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7270, 41), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO switching difference of signaller Xsd1
    (2, 199, None, Optional, SubList(7270, 41), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO switching difference of signaller Xsd1
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7350, 50), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO switching difference of additional contact Xsd2
    (2, 199, None, Optional, SubList(7350, 50), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO switching difference of additional contact Xsd2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7441, 52), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO trigger point separation of additional contact LW
    (2, 199, None, Optional, SubList(7441, 52), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO trigger point separation of additional contact LW
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7569, 24), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO proportional band Xp1
    (2, 199, None, Optional, SubList(7569, 24), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO proportional band Xp1
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7642, 24), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO proportional band Xp2
    (2, 199, None, Optional, SubList(7642, 24), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO proportional band Xp2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7716, 27), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO integral action time Tn1
    (2, 199, None, Optional, SubList(7716, 27), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO integral action time Tn1
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7795, 27), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO integral action time Tn2
    (2, 199, None, Optional, SubList(7795, 27), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO integral action time Tn2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7875, 29), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO derivative action time Tv1
    (2, 199, None, Optional, SubList(7875, 29), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO derivative action time Tv1
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7958, 29), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO derivative action time Tv2
    (2, 199, None, Optional, SubList(7958, 29), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO derivative action time Tv2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8042, 16), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO cycle time T1
    (2, 199, None, Optional, SubList(8042, 16), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO cycle time T1
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8099, 16), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO cycle time T2
    (2, 199, None, Optional, SubList(8099, 16), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO cycle time T2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(8321, 14), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL input value
    (2, 199, Some(Any), Optional, SubList(8321, 14), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL input value
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8438, 24), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL alternate input value
    (2, 199, None, Optional, SubList(8438, 24), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL alternate input value
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8939, 8), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL level
    (2, 199, None, Optional, SubList(8939, 8), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL level
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8989, 13), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL hysteresis
    (2, 199, None, Optional, SubList(8989, 13), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL hysteresis
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(10271, 10), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Receive PV
    (2, 199, Some(Any), Optional, SubList(10271, 10), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Receive PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(10339, 20), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Alternate receive PV
    (2, 199, Some(Any), Optional, SubList(10339, 20), SubList(6, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Alternate receive PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(311, 11), SubList(7, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input FV
    (2, 199, Some(Tpdo), Optional, SubList(311, 11), SubList(7, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(393, 27), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt delta input FV
    (2, 199, None, Optional, SubList(393, 27), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt delta input FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(763, 21), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 1 FV
    (2, 199, None, Optional, SubList(763, 21), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 1 FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(861, 21), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 1 PV
    (2, 199, None, Optional, SubList(861, 21), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 1 PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(961, 21), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 2 FV
    (2, 199, None, Optional, SubList(961, 21), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 2 FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(1060, 21), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 2 PV
    (2, 199, None, Optional, SubList(1060, 21), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input scaling 2 PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(1161, 15), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input offset
    (2, 199, None, Optional, SubList(1161, 15), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input offset
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(1457, 11), SubList(7, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input PV
    (2, 199, Some(Tpdo), Optional, SubList(1457, 11), SubList(7, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI input PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(1740, 27), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt delta input PV
    (2, 199, None, Optional, SubList(1740, 27), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt delta input PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(1823, 27), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt lower input PV
    (2, 199, None, Optional, SubList(1823, 27), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt lower input PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(1910, 27), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt upper input PV
    (2, 199, None, Optional, SubList(1910, 27), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt upper input PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(1997, 12), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI tare zero
    (2, 199, None, Optional, SubList(1997, 12), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI tare zero
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(2155, 9), SubList(7, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI net PV
    (2, 199, Some(Tpdo), Optional, SubList(2155, 9), SubList(7, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI net PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(2220, 25), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt delta net PV
    (2, 199, None, Optional, SubList(2220, 25), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt delta net PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(2297, 31), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt lower limit net PV
    (2, 199, None, Optional, SubList(2297, 31), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt lower limit net PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(2384, 31), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt upper limit net PV
    (2, 199, None, Optional, SubList(2384, 31), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI interrupt upper limit net PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(2471, 13), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI span start
    (2, 199, None, Optional, SubList(2471, 13), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI span start
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(2552, 11), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI span end
    (2, 199, None, Optional, SubList(2552, 11), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AI span end
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(3939, 12), SubList(7, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output PV
    (2, 199, Some(Any), Optional, SubList(3939, 12), SubList(7, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(4245, 22), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 1 PV
    (2, 199, None, Optional, SubList(4245, 22), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 1 PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(4347, 22), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 1 FV
    (2, 199, None, Optional, SubList(4347, 22), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 1 FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(4447, 22), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 2 PV
    (2, 199, None, Optional, SubList(4447, 22), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 2 PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(4550, 22), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 2 FV
    (2, 199, None, Optional, SubList(4550, 22), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output scaling 2 FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(4651, 12), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output FV
    (2, 199, None, Optional, SubList(4651, 12), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO output FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(4959, 11), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO fault FV
    (2, 199, None, Optional, SubList(4959, 11), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AO fault FV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(5036, 31), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO effective current value Xeff
    (2, 199, Some(Any), Optional, SubList(5036, 31), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO effective current value Xeff
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(5115, 27), SubList(7, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO effective set point Weff
    (2, 199, Some(Tpdo), Optional, SubList(5115, 27), SubList(7, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO effective set point Weff
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(5187, 14), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO set point W
    (2, 199, Some(Any), Optional, SubList(5187, 14), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO set point W
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(5233, 19), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO 2nd set point W2
    (2, 199, Some(Any), Optional, SubList(5233, 19), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO 2nd set point W2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(5318, 27), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO lower set point limit W0
    (2, 199, None, Optional, SubList(5318, 27), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO lower set point limit W0
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(5366, 29), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO upper set point limit W100
    (2, 199, None, Optional, SubList(5366, 29), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO upper set point limit W100
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(6467, 27), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO minimum pulse time Tmin1
    (2, 199, None, Optional, SubList(6467, 27), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO minimum pulse time Tmin1
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(6551, 27), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO minimum pulse time Tmin2
    (2, 199, None, Optional, SubList(6551, 27), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO minimum pulse time Tmin2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(6636, 25), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO motor response time Tm
    (2, 199, None, Optional, SubList(6636, 25), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO motor response time Tm
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(6725, 25), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO min pulse length Tpuls
    (2, 199, None, Optional, SubList(6725, 25), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO min pulse length Tpuls
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(6951, 32), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO neutral zone three-point Xsh1
    (2, 199, None, Optional, SubList(6951, 32), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO neutral zone three-point Xsh1
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7063, 32), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO neutral zone three-point Xsh2
    (2, 199, None, Optional, SubList(7063, 32), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO neutral zone three-point Xsh2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7176, 40), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO neutral zone three-point stepping Xsh
    (2, 199, None, Optional, SubList(7176, 40), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO neutral zone three-point stepping Xsh
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7270, 41), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO switching difference of signaller Xsd1
    (2, 199, None, Optional, SubList(7270, 41), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO switching difference of signaller Xsd1
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7350, 50), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO switching difference of additional contact Xsd2
    (2, 199, None, Optional, SubList(7350, 50), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO switching difference of additional contact Xsd2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7441, 52), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO trigger point separation of additional contact LW
    (2, 199, None, Optional, SubList(7441, 52), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO trigger point separation of additional contact LW
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7569, 24), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO proportional band Xp1
    (2, 199, None, Optional, SubList(7569, 24), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO proportional band Xp1
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7642, 24), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO proportional band Xp2
    (2, 199, None, Optional, SubList(7642, 24), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO proportional band Xp2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7716, 27), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO integral action time Tn1
    (2, 199, None, Optional, SubList(7716, 27), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO integral action time Tn1
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7795, 27), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO integral action time Tn2
    (2, 199, None, Optional, SubList(7795, 27), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO integral action time Tn2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7875, 29), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO derivative action time Tv1
    (2, 199, None, Optional, SubList(7875, 29), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO derivative action time Tv1
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7958, 29), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO derivative action time Tv2
    (2, 199, None, Optional, SubList(7958, 29), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO derivative action time Tv2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8042, 16), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO cycle time T1
    (2, 199, None, Optional, SubList(8042, 16), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO cycle time T1
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8099, 16), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO cycle time T2
    (2, 199, None, Optional, SubList(8099, 16), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CO cycle time T2
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(8321, 14), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL input value
    (2, 199, Some(Any), Optional, SubList(8321, 14), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL input value
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8438, 24), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL alternate input value
    (2, 199, None, Optional, SubList(8438, 24), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL alternate input value
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8939, 8), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL level
    (2, 199, None, Optional, SubList(8939, 8), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL level
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8989, 13), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL hysteresis
    (2, 199, None, Optional, SubList(8989, 13), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // AL hysteresis
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(10271, 10), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Receive PV
    (2, 199, Some(Any), Optional, SubList(10271, 10), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Receive PV
    (0, 0, Some(No), Mandatory, SubList(27, 27), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(10339, 20), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Alternate receive PV
    (2, 199, Some(Any), Optional, SubList(10339, 20), SubList(7, 1), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Alternate receive PV
);

static BITS: &[BitRow] = table!(BitRow { first, last, name, values }:
    (0, 7, SubList(611, 7), SubList(0, 2)) // channel
    (8, 15, SubList(1555, 11), SubList(0, 0)) // denominator
    (16, 23, SubList(1566, 9), SubList(0, 0)) // numerator
    (24, 31, SubList(1575, 21), SubList(0, 0)) // prefix, a power of 10
    (0, 0, SubList(2640, 15), SubList(0, 0)) // value not valid
    (1, 1, SubList(2655, 17), SubList(0, 0)) // positive overload
    (2, 2, SubList(2672, 17), SubList(0, 0)) // negative overload
    (0, 7, SubList(2928, 6), SubList(2, 4)) // filter
    (0, 0, SubList(6098, 11), SubList(0, 0)) // manual mode
    (0, 0, SubList(6162, 13), SubList(0, 0)) // controller on
    (0, 0, SubList(8718, 24), SubList(0, 0)) // alarm in case of a fault
    (0, 0, SubList(9121, 5), SubList(0, 0)) // alarm
    (0, 0, SubList(9156, 15), SubList(0, 0)) // reset the alarm
    (0, 0, SubList(9208, 7), SubList(0, 0)) // alarm 1
    (1, 1, SubList(9215, 7), SubList(0, 0)) // alarm 2
    (2, 2, SubList(9222, 7), SubList(0, 0)) // alarm 3
    (3, 3, SubList(9229, 7), SubList(0, 0)) // alarm 4
    (4, 4, SubList(9236, 7), SubList(0, 0)) // alarm 5
    (5, 5, SubList(9243, 7), SubList(0, 0)) // alarm 6
    (6, 6, SubList(9250, 7), SubList(0, 0)) // alarm 7
    (7, 7, SubList(9257, 7), SubList(0, 0)) // alarm 8
    (0, 0, SubList(9326, 7), SubList(0, 0)) // alarm 9
    (1, 1, SubList(9333, 8), SubList(0, 0)) // alarm 10
    (2, 2, SubList(9341, 8), SubList(0, 0)) // alarm 11
    (3, 3, SubList(9349, 8), SubList(0, 0)) // alarm 12
    (4, 4, SubList(9357, 8), SubList(0, 0)) // alarm 13
    (5, 5, SubList(9365, 8), SubList(0, 0)) // alarm 14
    (6, 6, SubList(9373, 8), SubList(0, 0)) // alarm 15
    (7, 7, SubList(9381, 8), SubList(0, 0)) // alarm 16
    (0, 0, SubList(9436, 8), SubList(0, 0)) // an alarm
    (0, 0, SubList(9488, 19), SubList(0, 0)) // an alarm of group 1
    (1, 1, SubList(9507, 19), SubList(0, 0)) // an alarm of group 2
    (2, 2, SubList(9526, 19), SubList(0, 0)) // an alarm of group 3
    (3, 3, SubList(9545, 19), SubList(0, 0)) // an alarm of group 4
    (4, 4, SubList(9564, 19), SubList(0, 0)) // an alarm of group 5
    (5, 5, SubList(9583, 19), SubList(0, 0)) // an alarm of group 6
    (6, 6, SubList(9602, 19), SubList(0, 0)) // an alarm of group 7
    (7, 7, SubList(9621, 19), SubList(0, 0)) // an alarm of group 8
    (0, 0, SubList(9713, 16), SubList(0, 0)) // reset all alarms
    (0, 0, SubList(9784, 13), SubList(0, 0)) // reset alarm 1
    (1, 1, SubList(9797, 13), SubList(0, 0)) // reset alarm 2
    (2, 2, SubList(9810, 13), SubList(0, 0)) // reset alarm 3
    (3, 3, SubList(9823, 13), SubList(0, 0)) // reset alarm 4
    (4, 4, SubList(9836, 13), SubList(0, 0)) // reset alarm 5
    (5, 5, SubList(9849, 13), SubList(0, 0)) // reset alarm 6
    (6, 6, SubList(9862, 13), SubList(0, 0)) // reset alarm 7
    (7, 7, SubList(9875, 13), SubList(0, 0)) // reset alarm 8
    (0, 0, SubList(9949, 13), SubList(0, 0)) // reset alarm 9
    (1, 1, SubList(9962, 14), SubList(0, 0)) // reset alarm 10
    (2, 2, SubList(9976, 14), SubList(0, 0)) // reset alarm 11
    (3, 3, SubList(9990, 14), SubList(0, 0)) // reset alarm 12
    (4, 4, SubList(10004, 14), SubList(0, 0)) // reset alarm 13
    (5, 5, SubList(10018, 14), SubList(0, 0)) // reset alarm 14
    (6, 6, SubList(10032, 14), SubList(0, 0)) // reset alarm 15
    (7, 7, SubList(10046, 14), SubList(0, 0)) // reset alarm 16
);

static MEANINGS: &[MeaningRow] = table!(MeaningRow { first, last, text }:
    (0, 0, SubList(618, 3)) // off
    (1, 1, SubList(621, 16)) // normal operation
    (0, 0, SubList(2934, 4)) // none
    (1, 1, SubList(2938, 14)) // moving average
    (2, 2, SubList(2952, 17)) // repeating average
    (100, 255, SubList(2969, 21)) // manufacturer-specific
);

static COMMANDS: &[CommandRow] = &[];

static TRANSITIONS: &[TransitionRow] = &[];

static CONDITIONS: &[Condition] = &[
];

static OBJECT_TYPES: &[ObjectType] = &[Array, Record, Var];

static DATA_TYPES: &[DataType] = &[DataType(5), DataType(1), DataType(8), DataType(6), DataType(7), DataType(3), DataType(16), DataType(4)];

static ACCESS: &[Access] = &[Ro, Rw, Wo, Rw, Wo];

static VALUES: &[std::ops::RangeInclusive<i128>] = &[1..=199];

static DEFAULTS: &[Value] = &[];

static INDEXES: &[u16] = &[];

static TEXTS: &str = concat!(
    "DI read state 8 input lines", "Highest sub-index supported",
    "The state of the digital inputs, eight a sub-index.", "DI polarity 8 input lines",
    "Inverts digital inputs, eight a sub-index.", "DI read state 1 input line",
    "The state of the digital inputs, one a sub-index.", "DI polarity 1 input line",
    "Inverts digital inputs, one a sub-index.", "AI input FV",
    "The value of an analogue input as its converter gives it (field value).", "AI interrupt delta input FV",
    "The change of the field value that triggers a message.", "AI sensor type",
    "The type of the sensor at an analogue input.", "AI autocalibration",
    "Starts the calibration of an analogue input.", "AI operating mode", "channel", "off", "normal operation",
    "Switches an analogue input off or selects how it works.", "AI ADC sample rate", "µs",
    "The time between two samples of an analogue input.", "AI input scaling 1 FV",
    "The field value of the first point of the line that scales an analogue input.", "AI input scaling 1 PV",
    "The process value of the first point of the line that scales an analogue input.", "AI input scaling 2 FV",
    "The field value of the second point of the line that scales an analogue input.", "AI input scaling 2 PV",
    "The process value of the second point of the line that scales an analogue input.", "AI input offset",
    "Added to the process value of an analogue input.", "AI autozero",
    "Makes the present process value of an analogue input zero by adjusting its offset.", "AI scaling factor",
    "Multiplied with the field value of an analogue input.", "AI scaling offset",
    "Added to the scaled field value of an analogue input.", "AI input PV",
    "The value of an analogue input in its physical unit (process value).", "AI physical unit PV", "denominator",
    "numerator", "prefix, a power of 10", "The unit of the process value of an analogue input.",
    "AI decimal digits PV", "How many of the digits of the process value are behind the decimal point.",
    "AI interrupt delta input PV", "The change of the process value that triggers a message.",
    "AI interrupt lower input PV", "A message is triggered when the process value is below this.",
    "AI interrupt upper input PV", "A message is triggered when the process value is above this.",
    "AI tare zero", "The tare that is subtracted from the process value to give the net value.", "AI autotare",
    "Makes the present process value of an analogue input its tare.", "AI net PV",
    "The process value of an analogue input without the tare.", "AI interrupt delta net PV",
    "The change of the net value that triggers a message.", "AI interrupt lower limit net PV",
    "A message is triggered when the net value is below this.", "AI interrupt upper limit net PV",
    "A message is triggered when the net value is above this.", "AI span start",
    "The process value below which an analogue input is out of its range.", "AI span end",
    "The process value above which an analogue input is out of its range.", "AI status", "value not valid",
    "positive overload", "negative overload",
    "Whether the value of an analogue input is valid and within its range.", "AI control byte",
    "Commands to an analogue input in one byte, such as autozero and autotare.", "AI control byte enable",
    "Which commands of the control byte are obeyed.", "AI filter type", "filter", "none", "moving average",
    "repeating average", "manufacturer-specific", "The filter of an analogue input.", "AI filter constant",
    "The strength of the filter of an analogue input.", "DO write state 8 output lines",
    "Sets the digital outputs, eight a sub-index.", "DO polarity 8 output lines",
    "Inverts digital outputs, eight a sub-index.", "DO fault mode 8 output lines",
    "Which outputs take the fault state when a fault occurs, eight a sub-index.",
    "DO fault state 8 output lines", "The states that outputs take when a fault occurs, eight a sub-index.",
    "DO link object 8 output lines", "The object inside the device that sets eight digital outputs.",
    "DO write state 1 output line", "Sets the digital outputs, one a sub-index.", "DO polarity 1 output line",
    "Inverts digital outputs, one a sub-index.", "DO fault mode 1 output line",
    "Whether an output takes the fault state when a fault occurs, one a sub-index.",
    "DO fault state 1 output line", "The state that an output takes when a fault occurs, one a sub-index.",
    "DO link object 1 output line", "The object inside the device that sets a digital output.", "AO output PV",
    "The value of an analogue output in its physical unit (process value).", "AO physical unit PV",
    "The unit of the process value of an analogue output.", "AO decimal digits PV", "AO link output PV",
    "The object inside the device that sets an analogue output.", "AO output type",
    "The type of the signal at an analogue output.", "AO output scaling 1 PV",
    "The process value of the first point of the line that scales an analogue output.", "AO output scaling 1 FV",
    "The field value of the first point of the line that scales an analogue output.", "AO output scaling 2 PV",
    "The process value of the second point of the line that scales an analogue output.",
    "AO output scaling 2 FV", "The field value of the second point of the line that scales an analogue output.",
    "AO output FV", "The value that the converter of an analogue output is given (field value).",
    "AO physical unit FV", "The unit of the field value of an analogue output.", "AO decimal digits FV",
    "How many of the digits of the field value are behind the decimal point.", "AO fault mode",
    "What an analogue output does when a fault occurs.", "AO fault FV",
    "The field value that an analogue output takes when a fault occurs.", "CO effective current value Xeff",
    "The actual value that the controller works with.", "CO effective set point Weff",
    "The set-point that the controller works with.", "CO set point W", "The set-point of the controller.",
    "CO 2nd set point W2", "A second set-point of the controller, to which it can be switched.",
    "CO lower set point limit W0", "The lowest set-point.", "CO upper set point limit W100",
    "The highest set-point.", "CO physical unit XW", "The unit of set-point and actual value.",
    "CO decimal digits XW", "How many of the digits of set-point and actual value are behind the decimal point.",
    "CO effective controller output Y", "The output of the controller.",
    "CO differential controller output Ydiff", "The change of the controller's output.",
    "CO manual controller output", "The output of the controller in manual mode.",
    "CO lower controller output limit Ymin", "The lowest output of the controller.",
    "CO upper controller output limit Ymax", "The highest output of the controller.",
    "CO physical unit controller output", "The unit of the controller's output.", "CO set point switch W-W2",
    "Selects which of the two set-points counts.", "CO automatic/manual mode A-M", "manual mode",
    "Selects automatic or manual mode.", "CO controller on/off", "controller on",
    "Switches the controller on and off.", "CO controller mode", "The kind of the controller.",
    "CO self optimization on/off", "Starts and stops self-optimisation of the controller.", "CO control byte",
    "Commands to the controller in one byte.", "CO control byte enable", "CO status word",
    "The state of the controller, one bit each.", "CO minimum pulse time Tmin1",
    "The shortest pulse of the first output of the controller.", "CO minimum pulse time Tmin2",
    "The shortest pulse of the second output of the controller.", "CO motor response time Tm",
    "The time that the motor of the actuator needs for its whole way.", "CO min pulse length Tpuls",
    "The shortest pulse that the actuator follows.", "CO physical unit pulse timing",
    "The unit of the times of pulses.", "CO decimal digits PT",
    "How many of the digits of the times of pulses are behind the decimal point.",
    "CO neutral zone three-point Xsh1",
    "The first neutral zone of a three-point controller, in which it does not switch.",
    "CO neutral zone three-point Xsh2",
    "The second neutral zone of a three-point controller, in which it does not switch.",
    "CO neutral zone three-point stepping Xsh", "The neutral zone of a three-point stepping controller.",
    "CO switching difference of signaller Xsd1", "The hysteresis of the switching output.",
    "CO switching difference of additional contact Xsd2", "The hysteresis of the additional contact.",
    "CO trigger point separation of additional contact LW",
    "The distance of the additional contact's switching point from the set-point.", "CO proportional band Xp1",
    "The proportional band of the first parameter set.", "CO proportional band Xp2",
    "The proportional band of the second parameter set.", "CO integral action time Tn1",
    "The integral action time of the first parameter set.", "CO integral action time Tn2",
    "The integral action time of the second parameter set.", "CO derivative action time Tv1",
    "The derivative action time of the first parameter set.", "CO derivative action time Tv2",
    "The derivative action time of the second parameter set.", "CO cycle time T1",
    "The switching period of the first output.", "CO cycle time T2",
    "The switching period of the second output.", "CO physical unit PID",
    "The unit of the times of the controller.", "CO decimal digits PID",
    "How many of the digits of the times of the controller are behind the decimal point.", "AL input value",
    "The value that an alarm watches.", "AL link input",
    "The object inside the device whose value an alarm watches.", "AL alternate input value",
    "The value that an alarm watches when the first one is not available.", "AL link alternate input",
    "The object inside the device whose value an alarm watches when the first one is not available.",
    "AL fault mode", "What an alarm does when its input is faulty.", "AL fault state",
    "alarm in case of a fault", "The state that an alarm takes when its input is faulty.", "AL type",
    "The condition of an alarm, such as above or below its level.", "AL action",
    "What an alarm does while it is active and when it is acknowledged.", "AL level",
    "The level that the input is compared with.", "AL hysteresis",
    "How far the input must go back from the level before the alarm ends.", "AL group",
    "The group that an alarm belongs to.", "AL state", "alarm", "The state of an alarm.", "AL reset",
    "reset the alarm", "Acknowledges an alarm.", "AL 1 to 8 state", "alarm 1", "alarm 2", "alarm 3", "alarm 4",
    "alarm 5", "alarm 6", "alarm 7", "alarm 8", "The states of the alarms 1 to 8, one bit each.",
    "AL 9 to 16 state", "alarm 9", "alarm 10", "alarm 11", "alarm 12", "alarm 13", "alarm 14", "alarm 15",
    "alarm 16", "The states of the alarms 9 to 16, one bit each.", "an alarm", "AL general state",
    "Whether any alarm is active.", "an alarm of group 1", "an alarm of group 2", "an alarm of group 3",
    "an alarm of group 4", "an alarm of group 5", "an alarm of group 6", "an alarm of group 7",
    "an alarm of group 8", "AL group 1 to 8 state", "The states of the alarm groups 1 to 8, one bit each.",
    "reset all alarms", "AL general reset", "Acknowledges all alarms.", "AL 1 to 8 reset", "reset alarm 1",
    "reset alarm 2", "reset alarm 3", "reset alarm 4", "reset alarm 5", "reset alarm 6", "reset alarm 7",
    "reset alarm 8", "Acknowledges the alarms 1 to 8, one bit each.", "AL 9 to 16 reset", "reset alarm 9",
    "reset alarm 10", "reset alarm 11", "reset alarm 12", "reset alarm 13", "reset alarm 14", "reset alarm 15",
    "reset alarm 16", "Acknowledges the alarms 9 to 16, one bit each.", "Life counter",
    "Counts up while the device works.", "Receive PDO check",
    "Says which received PDOs are watched for being late.", "Transmit PDO check",
    "Says which sent PDOs are watched.", "Receive PV",
    "A process value that the device receives from another one.", "Alternate receive PV",
    "A process value that the device receives in place of the first one.", "Received status",
    "The status of a process value that the device receives.", "Alternate received status",
    "The status of a process value that the device receives in place of the first one.", "Transmission enable",
    "Switches the transmission of process values on.",
);
