// Generated from `data/cia402.toml` by `cargo xtask profiles`: edit that file.

#![allow(unused_imports, reason = "not every document has facts of every kind")]

use std::borrow::Cow;

use crate::model::{Access, Access::*, DataType, ObjectType, ObjectType::*, Value, Value::*};
use crate::tables::{NeedRow::*, Term::*, *};
use crate::{Condition, Confidence::*, Mapping::*, Profile};

pub(super) static PROFILE: Profile = Profile {
    group: "cia402",
    document: Cow::Borrowed("CiA 402"),
    title: Cow::Borrowed("drives and motion control"),
    version: Some(Cow::Borrowed("3")),
    number: Some(402),
    repeats: true,
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
        errors: SubList(121, 147),
        machine: Some(MachineRow { status: 24641, command: 24640 }),
    },
};

static OBJECTS: &[ObjectRow] = table!(ObjectRow { first, last, name, object_types, need, only, as_many_as, entries, source, about, confidence }:
    (4096, 4096, SubList(93, 11), SubList(0, 0), Optional, None, SubList(0, 0), SubList(0, 1), SubList(0, 0), SubList(104, 51), High) // 1000h Device type
    (24583, 24583, SubList(230, 28), SubList(0, 1), Optional, None, SubList(0, 0), SubList(1, 1), SubList(0, 0), SubList(258, 62), High) // 6007h Abort connection option code
    (24639, 24639, SubList(320, 10), SubList(0, 1), Optional, None, SubList(0, 0), SubList(2, 1), SubList(0, 0), SubList(330, 49), High) // 603Fh Error code
    (24640, 24640, SubList(458, 11), SubList(0, 1), Mandatory, None, SubList(0, 0), SubList(3, 1), SubList(0, 0), SubList(469, 75), High) // 6040h Controlword
    (24641, 24641, SubList(741, 10), SubList(0, 1), Mandatory, None, SubList(0, 0), SubList(4, 1), SubList(0, 0), SubList(751, 68), High) // 6041h Statusword
    (24642, 24642, SubList(819, 18), SubList(0, 1), When(0), None, SubList(0, 0), SubList(5, 1), SubList(0, 0), SubList(837, 45), High) // 6042h vl target velocity
    (24643, 24643, SubList(882, 18), SubList(0, 1), When(0), None, SubList(0, 0), SubList(6, 1), SubList(0, 0), SubList(900, 53), High) // 6043h vl velocity demand
    (24644, 24644, SubList(953, 24), SubList(0, 1), When(0), None, SubList(0, 0), SubList(6, 1), SubList(0, 0), SubList(977, 59), High) // 6044h vl velocity actual value
    (24645, 24645, SubList(1036, 23), SubList(0, 1), Optional, None, SubList(0, 0), SubList(7, 1), SubList(0, 0), SubList(1059, 63), High) // 6045h vl manipulated velocity
    (24646, 24646, SubList(1193, 26), SubList(1, 1), When(0), None, SubList(0, 0), SubList(8, 3), SubList(0, 0), SubList(1219, 71), High) // 6046h vl velocity min max amount
    (24647, 24647, SubList(1290, 19), SubList(1, 1), Optional, None, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(1309, 70), High) // 6047h vl velocity min max
    (24648, 24648, SubList(1401, 24), SubList(2, 1), When(0), None, SubList(0, 0), SubList(11, 3), SubList(0, 0), SubList(1425, 81), High) // 6048h vl velocity acceleration
    (24649, 24649, SubList(1506, 24), SubList(2, 1), Optional, None, SubList(0, 0), SubList(11, 3), SubList(0, 0), SubList(1530, 81), High) // 6049h vl velocity deceleration
    (24650, 24650, SubList(1611, 22), SubList(2, 1), Optional, None, SubList(0, 0), SubList(11, 3), SubList(0, 0), SubList(1633, 79), High) // 604Ah vl velocity quick stop
    (24651, 24651, SubList(1772, 19), SubList(3, 2), Optional, None, SubList(0, 0), SubList(14, 3), SubList(0, 0), SubList(1791, 65), High) // 604Bh vl set-point factor
    (24652, 24652, SubList(1916, 19), SubList(3, 2), Optional, None, SubList(0, 0), SubList(17, 3), SubList(0, 0), SubList(1935, 76), High) // 604Ch vl dimension factor
    (24653, 24653, SubList(2011, 14), SubList(0, 1), Optional, None, SubList(0, 0), SubList(20, 1), SubList(0, 0), SubList(2025, 33), High) // 604Dh vl pole number
    (24654, 24654, SubList(2058, 21), SubList(0, 1), Optional, None, SubList(0, 0), SubList(21, 1), SubList(0, 0), SubList(2079, 53), High) // 604Eh vl velocity reference
    (24655, 24655, SubList(2134, 21), SubList(0, 1), Optional, None, SubList(0, 0), SubList(22, 1), SubList(0, 0), SubList(2155, 76), High) // 604Fh vl ramp function time
    (24656, 24656, SubList(2231, 17), SubList(0, 1), Optional, None, SubList(0, 0), SubList(22, 1), SubList(0, 0), SubList(2248, 76), High) // 6050h vl slow down time
    (24657, 24657, SubList(2324, 18), SubList(0, 1), Optional, None, SubList(0, 0), SubList(22, 1), SubList(0, 0), SubList(2342, 74), High) // 6051h vl quick stop time
    (24658, 24658, SubList(2416, 21), SubList(0, 1), Optional, None, SubList(0, 0), SubList(23, 1), SubList(0, 0), SubList(2437, 55), High) // 6052h vl nominal percentage
    (24659, 24659, SubList(2492, 20), SubList(0, 1), Optional, None, SubList(0, 0), SubList(6, 1), SubList(0, 0), SubList(2512, 50), High) // 6053h vl percentage demand
    (24660, 24660, SubList(2562, 20), SubList(0, 1), Optional, None, SubList(0, 0), SubList(6, 1), SubList(0, 0), SubList(2582, 44), High) // 6054h vl actual percentage
    (24661, 24661, SubList(2626, 25), SubList(0, 1), Optional, None, SubList(0, 0), SubList(6, 1), SubList(0, 0), SubList(2651, 47), High) // 6055h vl manipulated percentage
    (24662, 24662, SubList(2698, 32), SubList(0, 0), Optional, None, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(2730, 77), High) // 6056h vl velocity motor min max amount
    (24663, 24663, SubList(2807, 25), SubList(0, 0), Optional, None, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(2832, 76), High) // 6057h vl velocity motor min max
    (24664, 24664, SubList(2908, 33), SubList(0, 0), Optional, None, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(2941, 81), High) // 6058h vl frequency motor min max amount
    (24665, 24665, SubList(3022, 26), SubList(0, 0), Optional, None, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(3048, 80), High) // 6059h vl frequency motor min max
    (24666, 24666, SubList(3468, 22), SubList(0, 1), Optional, None, SubList(0, 0), SubList(24, 1), SubList(0, 0), SubList(3490, 46), High) // 605Ah Quick stop option code
    (24667, 24667, SubList(3564, 20), SubList(0, 1), Optional, None, SubList(0, 0), SubList(25, 1), SubList(0, 0), SubList(3584, 64), High) // 605Bh Shutdown option code
    (24668, 24668, SubList(3648, 29), SubList(0, 1), Optional, None, SubList(0, 0), SubList(26, 1), SubList(0, 0), SubList(3677, 57), High) // 605Ch Disable operation option code
    (24669, 24669, SubList(3789, 16), SubList(0, 1), Optional, None, SubList(0, 0), SubList(27, 1), SubList(0, 0), SubList(3805, 64), High) // 605Dh Halt option code
    (24670, 24670, SubList(3869, 26), SubList(0, 1), Optional, None, SubList(0, 0), SubList(28, 1), SubList(0, 0), SubList(3895, 40), High) // 605Eh Fault reaction option code
    (24672, 24672, SubList(4154, 18), SubList(0, 1), Optional, None, SubList(0, 0), SubList(29, 1), SubList(0, 0), SubList(4172, 30), High) // 6060h Modes of operation
    (24673, 24673, SubList(4202, 26), SubList(0, 1), Optional, None, SubList(0, 0), SubList(30, 1), SubList(0, 0), SubList(4228, 37), High) // 6061h Modes of operation display
    (24674, 24674, SubList(4265, 21), SubList(0, 1), Optional, None, SubList(0, 0), SubList(31, 1), SubList(0, 0), SubList(4286, 49), High) // 6062h Position demand value
    (24675, 24675, SubList(4335, 30), SubList(0, 1), Optional, None, SubList(0, 0), SubList(31, 1), SubList(0, 0), SubList(4365, 49), High) // 6063h Position actual internal value
    (24676, 24676, SubList(4414, 21), SubList(0, 1), When(1), None, SubList(0, 0), SubList(31, 1), SubList(0, 0), SubList(4435, 44), High) // 6064h Position actual value
    (24677, 24677, SubList(4479, 22), SubList(0, 1), Optional, None, SubList(0, 0), SubList(32, 1), SubList(0, 0), SubList(4501, 85), High) // 6065h Following error window
    (24678, 24678, SubList(4586, 24), SubList(0, 1), Optional, None, SubList(0, 0), SubList(33, 1), SubList(0, 0), SubList(4610, 59), High) // 6066h Following error time out
    (24679, 24679, SubList(4669, 15), SubList(0, 1), Optional, None, SubList(0, 0), SubList(21, 1), SubList(0, 0), SubList(4684, 65), High) // 6067h Position window
    (24680, 24680, SubList(4749, 20), SubList(0, 1), Optional, None, SubList(0, 0), SubList(33, 1), SubList(0, 0), SubList(4769, 72), High) // 6068h Position window time
    (24681, 24681, SubList(4841, 28), SubList(0, 1), Optional, None, SubList(0, 0), SubList(31, 1), SubList(0, 0), SubList(4869, 33), High) // 6069h Velocity sensor actual value
    (24682, 24682, SubList(4956, 21), SubList(0, 1), Optional, None, SubList(0, 0), SubList(34, 1), SubList(0, 0), SubList(4977, 46), High) // 606Ah Sensor selection code
    (24683, 24683, SubList(5023, 21), SubList(0, 1), Optional, None, SubList(0, 0), SubList(31, 1), SubList(0, 0), SubList(5044, 46), High) // 606Bh Velocity demand value
    (24684, 24684, SubList(5090, 21), SubList(0, 1), When(2), None, SubList(0, 0), SubList(31, 1), SubList(0, 0), SubList(5111, 17), High) // 606Ch Velocity actual value
    (24685, 24685, SubList(5128, 15), SubList(0, 1), Optional, None, SubList(0, 0), SubList(35, 1), SubList(0, 0), SubList(5143, 71), High) // 606Dh Velocity window
    (24686, 24686, SubList(5214, 20), SubList(0, 1), Optional, None, SubList(0, 0), SubList(33, 1), SubList(0, 0), SubList(5234, 81), High) // 606Eh Velocity window time
    (24687, 24687, SubList(5315, 18), SubList(0, 1), Optional, None, SubList(0, 0), SubList(35, 1), SubList(0, 0), SubList(5333, 49), High) // 606Fh Velocity threshold
    (24688, 24688, SubList(5382, 23), SubList(0, 1), Optional, None, SubList(0, 0), SubList(33, 1), SubList(0, 0), SubList(5405, 81), High) // 6070h Velocity threshold time
    (24689, 24689, SubList(5511, 13), SubList(0, 1), When(3), None, SubList(0, 0), SubList(36, 1), SubList(0, 0), SubList(5524, 64), High) // 6071h Target torque
    (24690, 24690, SubList(5588, 10), SubList(0, 1), Optional, None, SubList(0, 0), SubList(37, 1), SubList(0, 0), SubList(5598, 47), High) // 6072h Max torque
    (24691, 24691, SubList(5671, 11), SubList(0, 1), Optional, None, SubList(0, 0), SubList(38, 1), SubList(0, 0), SubList(5682, 48), High) // 6073h Max current
    (24692, 24692, SubList(5730, 13), SubList(0, 1), Optional, None, SubList(0, 0), SubList(39, 1), SubList(0, 0), SubList(5743, 47), High) // 6074h Torque demand
    (24693, 24693, SubList(5792, 19), SubList(0, 1), Optional, None, SubList(0, 0), SubList(40, 1), SubList(0, 0), SubList(5811, 65), High) // 6075h Motor rated current
    (24694, 24694, SubList(5879, 18), SubList(0, 1), Optional, None, SubList(0, 0), SubList(41, 1), SubList(0, 0), SubList(5897, 63), High) // 6076h Motor rated torque
    (24695, 24695, SubList(5960, 19), SubList(0, 1), When(4), None, SubList(0, 0), SubList(39, 1), SubList(0, 0), SubList(5979, 18), High) // 6077h Torque actual value
    (24696, 24696, SubList(5997, 20), SubList(0, 1), Optional, None, SubList(0, 0), SubList(42, 1), SubList(0, 0), SubList(6017, 19), High) // 6078h Current actual value
    (24697, 24697, SubList(6038, 23), SubList(0, 1), Optional, None, SubList(0, 0), SubList(43, 1), SubList(0, 0), SubList(6061, 27), High) // 6079h DC link circuit voltage
    (24698, 24698, SubList(6088, 15), SubList(0, 1), When(5), None, SubList(0, 0), SubList(44, 1), SubList(0, 0), SubList(6103, 70), High) // 607Ah Target position
    (24699, 24699, SubList(6221, 20), SubList(3, 2), Optional, None, SubList(0, 0), SubList(45, 3), SubList(0, 0), SubList(6241, 75), High) // 607Bh Position range limit
    (24700, 24700, SubList(6316, 11), SubList(0, 1), Optional, None, SubList(0, 0), SubList(44, 1), SubList(0, 0), SubList(6327, 85), High) // 607Ch Home offset
    (24701, 24701, SubList(6448, 23), SubList(3, 2), Optional, None, SubList(0, 0), SubList(48, 3), SubList(0, 0), SubList(6471, 59), High) // 607Dh Software position limit
    (24702, 24702, SubList(6564, 8), SubList(0, 1), Optional, None, SubList(0, 0), SubList(51, 1), SubList(0, 0), SubList(6572, 36), High) // 607Eh Polarity
    (24703, 24703, SubList(6608, 20), SubList(0, 1), Optional, None, SubList(0, 0), SubList(21, 1), SubList(0, 0), SubList(6628, 40), High) // 607Fh Max profile velocity
    (24704, 24704, SubList(6671, 15), SubList(0, 1), Optional, None, SubList(0, 0), SubList(52, 1), SubList(0, 0), SubList(6686, 42), High) // 6080h Max motor speed
    (24705, 24705, SubList(6728, 16), SubList(0, 1), When(6), None, SubList(0, 0), SubList(32, 1), SubList(0, 0), SubList(6744, 54), High) // 6081h Profile velocity
    (24706, 24706, SubList(6798, 12), SubList(0, 1), Optional, None, SubList(0, 0), SubList(21, 1), SubList(0, 0), SubList(6810, 66), High) // 6082h End velocity
    (24707, 24707, SubList(6876, 20), SubList(0, 1), When(7), None, SubList(0, 0), SubList(32, 1), SubList(0, 0), SubList(6896, 39), High) // 6083h Profile acceleration
    (24708, 24708, SubList(6935, 20), SubList(0, 1), Optional, None, SubList(0, 0), SubList(32, 1), SubList(0, 0), SubList(6955, 39), High) // 6084h Profile deceleration
    (24709, 24709, SubList(6994, 23), SubList(0, 1), Optional, None, SubList(0, 0), SubList(32, 1), SubList(0, 0), SubList(7017, 33), High) // 6085h Quick stop deceleration
    (24710, 24710, SubList(7107, 19), SubList(0, 1), Optional, None, SubList(0, 0), SubList(53, 1), SubList(0, 0), SubList(7126, 45), High) // 6086h Motion profile type
    (24711, 24711, SubList(7207, 12), SubList(0, 1), When(8), None, SubList(0, 0), SubList(54, 1), SubList(0, 0), SubList(7219, 51), High) // 6087h Torque slope
    (24712, 24712, SubList(7270, 19), SubList(0, 1), Optional, None, SubList(0, 0), SubList(55, 1), SubList(0, 0), SubList(7289, 29), High) // 6088h Torque profile type
    (24713, 24713, SubList(7318, 23), SubList(0, 1), Optional, None, SubList(0, 0), SubList(56, 1), SubList(7341, 9), SubList(7350, 69), Medium) // 6089h Position notation index
    (24714, 24714, SubList(7419, 24), SubList(0, 1), Optional, None, SubList(0, 0), SubList(20, 1), SubList(7341, 9), SubList(7443, 58), Medium) // 608Ah Position dimension index
    (24715, 24715, SubList(7501, 23), SubList(0, 1), Optional, None, SubList(0, 0), SubList(56, 1), SubList(7341, 9), SubList(7524, 66), Medium) // 608Bh Velocity notation index
    (24716, 24716, SubList(7590, 24), SubList(0, 1), Optional, None, SubList(0, 0), SubList(20, 1), SubList(7341, 9), SubList(7614, 55), Medium) // 608Ch Velocity dimension index
    (24717, 24717, SubList(7669, 27), SubList(0, 1), Optional, None, SubList(0, 0), SubList(56, 1), SubList(7341, 9), SubList(7696, 73), Medium) // 608Dh Acceleration notation index
    (24718, 24718, SubList(7769, 28), SubList(0, 1), Optional, None, SubList(0, 0), SubList(20, 1), SubList(7341, 9), SubList(7797, 62), Medium) // 608Eh Acceleration dimension index
    (24719, 24719, SubList(7894, 27), SubList(3, 2), Optional, None, SubList(0, 0), SubList(57, 3), SubList(0, 0), SubList(7921, 92), High) // 608Fh Position encoder resolution
    (24720, 24720, SubList(8070, 27), SubList(3, 2), Optional, None, SubList(0, 0), SubList(60, 3), SubList(0, 0), SubList(8097, 101), High) // 6090h Velocity encoder resolution
    (24721, 24721, SubList(8215, 10), SubList(3, 2), Optional, None, SubList(0, 0), SubList(63, 3), SubList(0, 0), SubList(8225, 70), High) // 6091h Gear ratio
    (24722, 24722, SubList(8299, 13), SubList(3, 2), Optional, None, SubList(0, 0), SubList(66, 3), SubList(0, 0), SubList(8312, 74), High) // 6092h Feed constant
    (24723, 24723, SubList(8395, 15), SubList(3, 2), Optional, None, SubList(0, 0), SubList(69, 3), SubList(0, 0), SubList(8410, 67), High) // 6093h Position factor
    (24724, 24724, SubList(8484, 23), SubList(3, 2), Optional, None, SubList(0, 0), SubList(72, 3), SubList(0, 0), SubList(8507, 76), High) // 6094h Velocity encoder factor
    (24725, 24725, SubList(8583, 17), SubList(3, 2), Optional, None, SubList(0, 0), SubList(72, 3), SubList(0, 0), SubList(8600, 55), High) // 6095h Velocity factor 1
    (24726, 24726, SubList(8655, 15), SubList(3, 2), Optional, None, SubList(0, 0), SubList(72, 3), SubList(0, 0), SubList(8670, 64), High) // 6096h Velocity factor
    (24727, 24727, SubList(8734, 19), SubList(3, 2), Optional, None, SubList(0, 0), SubList(72, 3), SubList(0, 0), SubList(8753, 71), High) // 6097h Acceleration factor
    (24728, 24728, SubList(9329, 13), SubList(0, 1), When(9), None, SubList(0, 0), SubList(75, 1), SubList(0, 0), SubList(9342, 46), High) // 6098h Homing method
    (24729, 24729, SubList(9446, 13), SubList(3, 2), When(9), None, SubList(0, 0), SubList(76, 3), SubList(0, 0), SubList(9459, 61), High) // 6099h Homing speeds
    (24730, 24730, SubList(9520, 19), SubList(0, 1), Optional, None, SubList(0, 0), SubList(32, 1), SubList(0, 0), SubList(9539, 44), High) // 609Ah Homing acceleration
    (24738, 24738, SubList(9583, 11), SubList(3, 2), Optional, None, SubList(0, 0), SubList(72, 3), SubList(0, 0), SubList(9594, 62), High) // 60A2h Jerk factor
    (24739, 24739, SubList(9656, 16), SubList(0, 1), Optional, None, SubList(0, 0), SubList(79, 1), SubList(0, 0), SubList(9672, 49), High) // 60A3h Profile jerk use
    (24740, 24740, SubList(9754, 12), SubList(3, 2), Optional, None, SubList(0, 0), SubList(80, 3), SubList(0, 0), SubList(9766, 47), High) // 60A4h Profile jerk
    (24744, 24744, SubList(9854, 16), SubList(0, 1), Optional, None, SubList(0, 0), SubList(83, 1), SubList(9870, 9), SubList(9879, 22), Medium) // 60A8h SI unit position
    (24745, 24745, SubList(9901, 16), SubList(0, 1), Optional, None, SubList(0, 0), SubList(83, 1), SubList(9870, 9), SubList(9917, 19), Medium) // 60A9h SI unit velocity
    (24746, 24746, SubList(9936, 20), SubList(0, 1), Optional, None, SubList(0, 0), SubList(83, 1), SubList(9870, 9), SubList(9956, 26), Medium) // 60AAh SI unit acceleration
    (24747, 24747, SubList(9982, 12), SubList(0, 1), Optional, None, SubList(0, 0), SubList(83, 1), SubList(9870, 9), SubList(9994, 17), Medium) // 60ABh SI unit jerk
    (24752, 24752, SubList(10011, 15), SubList(0, 1), Optional, None, SubList(0, 0), SubList(44, 1), SubList(0, 0), SubList(10026, 51), High) // 60B0h Position offset
    (24753, 24753, SubList(10077, 15), SubList(0, 1), Optional, None, SubList(0, 0), SubList(44, 1), SubList(0, 0), SubList(10092, 48), High) // 60B1h Velocity offset
    (24754, 24754, SubList(10140, 13), SubList(0, 1), Optional, None, SubList(0, 0), SubList(36, 1), SubList(0, 0), SubList(10153, 49), High) // 60B2h Torque offset
    (24760, 24760, SubList(10492, 20), SubList(0, 1), Optional, None, SubList(0, 0), SubList(84, 1), SubList(0, 0), SubList(10512, 37), High) // 60B8h Touch probe function
    (24761, 24761, SubList(10673, 18), SubList(0, 1), Optional, None, SubList(0, 0), SubList(85, 1), SubList(0, 0), SubList(10691, 64), High) // 60B9h Touch probe status
    (24762, 24762, SubList(10755, 27), SubList(0, 1), Optional, None, SubList(0, 0), SubList(31, 1), SubList(0, 0), SubList(10782, 49), High) // 60BAh Touch probe 1 positive edge
    (24763, 24763, SubList(10831, 27), SubList(0, 1), Optional, None, SubList(0, 0), SubList(31, 1), SubList(0, 0), SubList(10858, 50), High) // 60BBh Touch probe 1 negative edge
    (24764, 24764, SubList(10908, 27), SubList(0, 1), Optional, None, SubList(0, 0), SubList(31, 1), SubList(0, 0), SubList(10935, 49), High) // 60BCh Touch probe 2 positive edge
    (24765, 24765, SubList(10984, 27), SubList(0, 1), Optional, None, SubList(0, 0), SubList(31, 1), SubList(0, 0), SubList(11011, 50), High) // 60BDh Touch probe 2 negative edge
    (24768, 24768, SubList(11094, 29), SubList(0, 1), Optional, None, SubList(0, 0), SubList(86, 1), SubList(0, 0), SubList(11123, 76), High) // 60C0h Interpolation sub mode select
    (24769, 24769, SubList(11228, 25), SubList(3, 2), Optional, None, SubList(0, 0), SubList(87, 3), SubList(0, 0), SubList(11253, 45), High) // 60C1h Interpolation data record
    (24770, 24770, SubList(11353, 25), SubList(2, 1), When(10), None, SubList(0, 0), SubList(90, 3), SubList(0, 0), SubList(11378, 76), High) // 60C2h Interpolation time period
    (24771, 24771, SubList(11454, 29), SubList(3, 2), Optional, None, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(11483, 78), High) // 60C3h Interpolation sync definition
    (24772, 24772, SubList(11683, 32), SubList(2, 1), Optional, None, SubList(0, 0), SubList(93, 7), SubList(0, 0), SubList(11715, 72), High) // 60C4h Interpolation data configuration
    (24773, 24773, SubList(11787, 16), SubList(0, 1), Optional, None, SubList(0, 0), SubList(21, 1), SubList(0, 0), SubList(11803, 41), High) // 60C5h Max acceleration
    (24774, 24774, SubList(11844, 16), SubList(0, 1), Optional, None, SubList(0, 0), SubList(21, 1), SubList(0, 0), SubList(11860, 41), High) // 60C6h Max deceleration
    (24784, 24784, SubList(11901, 18), SubList(3, 2), Optional, None, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(11919, 48), High) // 60D0h Touch probe source
    (24785, 24785, SubList(11967, 39), SubList(0, 1), Optional, None, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(12006, 45), High) // 60D1h Touch probe time stamp 1 positive value
    (24786, 24786, SubList(12051, 39), SubList(0, 1), Optional, None, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(12090, 46), High) // 60D2h Touch probe time stamp 1 negative value
    (24787, 24787, SubList(12136, 39), SubList(0, 1), Optional, None, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(12175, 45), High) // 60D3h Touch probe time stamp 2 positive value
    (24788, 24788, SubList(12220, 39), SubList(0, 1), Optional, None, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(12259, 46), High) // 60D4h Touch probe time stamp 2 negative value
    (24789, 24789, SubList(12305, 35), SubList(0, 1), Optional, None, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(12340, 41), High) // 60D5h Touch probe 1 positive edge counter
    (24790, 24790, SubList(12381, 35), SubList(0, 1), Optional, None, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(12416, 42), High) // 60D6h Touch probe 1 negative edge counter
    (24791, 24791, SubList(12458, 35), SubList(0, 1), Optional, None, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(12493, 41), High) // 60D7h Touch probe 2 positive edge counter
    (24792, 24792, SubList(12534, 35), SubList(0, 1), Optional, None, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(12569, 42), High) // 60D8h Touch probe 2 negative edge counter
    (24800, 24800, SubList(12611, 27), SubList(0, 1), Optional, None, SubList(0, 0), SubList(100, 1), SubList(9870, 9), SubList(12638, 41), Medium) // 60E0h Positive torque limit value
    (24801, 24801, SubList(12679, 27), SubList(0, 1), Optional, None, SubList(0, 0), SubList(100, 1), SubList(9870, 9), SubList(12706, 41), Medium) // 60E1h Negative torque limit value
    (24803, 24803, SubList(12747, 24), SubList(3, 2), Optional, None, SubList(0, 0), SubList(101, 3), SubList(9870, 9), SubList(12771, 49), Medium) // 60E3h Supported homing methods
    (24804, 24804, SubList(12820, 32), SubList(3, 2), Optional, None, SubList(0, 0), SubList(104, 3), SubList(9870, 9), SubList(12852, 34), Medium) // 60E4h Additional position actual value
    (24805, 24805, SubList(12886, 32), SubList(3, 2), Optional, None, SubList(0, 0), SubList(107, 3), SubList(9870, 9), SubList(12918, 31), Medium) // 60E5h Additional velocity actual value
    (24806, 24806, SubList(12949, 58), SubList(3, 2), Optional, None, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(13007, 93), High) // 60E6h Additional position encoder resolution, encoder increments
    (24807, 24807, SubList(13100, 69), SubList(3, 2), Optional, None, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(13169, 104), High) // 60E7h Additional velocity encoder resolution, encoder increments per second
    (24808, 24808, SubList(13273, 46), SubList(3, 2), Optional, None, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(13319, 87), High) // 60E8h Additional gear ratio, motor shaft revolutions
    (24809, 24809, SubList(13406, 30), SubList(3, 2), Optional, None, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(13436, 66), High) // 60E9h Additional feed constant, feed
    (24810, 24810, SubList(13502, 17), SubList(0, 1), When(11), None, SubList(0, 0), SubList(110, 1), SubList(9870, 9), SubList(13519, 102), Medium) // 60EAh Commutation angle
    (24811, 24811, SubList(13621, 57), SubList(3, 2), Optional, None, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(13678, 73), High) // 60EBh Additional position encoder resolution, motor revolutions
    (24812, 24812, SubList(13751, 68), SubList(3, 2), Optional, None, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(13819, 84), High) // 60ECh Additional velocity encoder resolution, motor revolutions per second
    (24813, 24813, SubList(13903, 48), SubList(3, 2), Optional, None, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(13951, 64), High) // 60EDh Additional gear ratio, driving shaft revolutions
    (24814, 24814, SubList(14015, 51), SubList(3, 2), Optional, None, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(14066, 58), High) // 60EEh Additional feed constant, driving shaft revolutions
    (24818, 24818, SubList(14386, 23), SubList(0, 1), Optional, None, SubList(0, 0), SubList(111, 1), SubList(0, 0), SubList(14409, 107), High) // 60F2h Positioning option code
    (24820, 24820, SubList(14516, 28), SubList(0, 1), Optional, None, SubList(0, 0), SubList(31, 1), SubList(0, 0), SubList(14544, 52), High) // 60F4h Following error actual value
    (24822, 24822, SubList(14596, 28), SubList(0, 0), Optional, None, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(14624, 66), High) // 60F6h Torque control parameter set
    (24823, 24823, SubList(14690, 22), SubList(0, 0), Optional, None, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(14712, 60), High) // 60F7h Power stage parameters
    (24824, 24824, SubList(14772, 12), SubList(0, 1), Optional, None, SubList(0, 0), SubList(112, 1), SubList(0, 0), SubList(14784, 81), High) // 60F8h Max slippage
    (24825, 24825, SubList(14865, 30), SubList(0, 0), Optional, None, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(14895, 68), High) // 60F9h Velocity control parameter set
    (24826, 24826, SubList(14963, 14), SubList(0, 1), Optional, None, SubList(0, 0), SubList(31, 1), SubList(0, 0), SubList(14977, 38), High) // 60FAh Control effort
    (24827, 24827, SubList(15015, 30), SubList(0, 0), Optional, None, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(15045, 68), High) // 60FBh Position control parameter set
    (24828, 24828, SubList(15113, 30), SubList(0, 1), Optional, None, SubList(0, 0), SubList(31, 1), SubList(0, 0), SubList(15143, 51), High) // 60FCh Position demand internal value
    (24829, 24829, SubList(15214, 14), SubList(0, 1), Optional, None, SubList(0, 0), SubList(113, 1), SubList(0, 0), SubList(15228, 75), High) // 60FDh Digital inputs
    (24830, 24830, SubList(15336, 15), SubList(3, 2), Optional, None, SubList(0, 0), SubList(114, 3), SubList(0, 0), SubList(15351, 54), High) // 60FEh Digital outputs
    (24831, 24831, SubList(15405, 15), SubList(0, 1), When(2), None, SubList(0, 0), SubList(44, 1), SubList(0, 0), SubList(15420, 67), High) // 60FFh Target velocity
    (25602, 25602, SubList(15821, 10), SubList(0, 1), Optional, None, SubList(0, 0), SubList(117, 1), SubList(0, 0), SubList(15831, 22), High) // 6402h Motor type
    (25603, 25603, SubList(15853, 22), SubList(0, 1), Optional, None, SubList(0, 0), SubList(118, 1), SubList(0, 0), SubList(15875, 34), High) // 6403h Motor catalogue number
    (25604, 25604, SubList(15909, 18), SubList(0, 1), Optional, None, SubList(0, 0), SubList(118, 1), SubList(0, 0), SubList(15927, 30), High) // 6404h Motor manufacturer
    (25605, 25605, SubList(15957, 28), SubList(0, 1), Optional, None, SubList(0, 0), SubList(118, 1), SubList(0, 0), SubList(15985, 41), High) // 6405h HTTP motor catalogue address
    (25606, 25606, SubList(16026, 22), SubList(0, 1), Optional, None, SubList(0, 0), SubList(119, 1), SubList(0, 0), SubList(16048, 34), High) // 6406h Motor calibration date
    (25607, 25607, SubList(16083, 20), SubList(0, 1), Optional, None, SubList(0, 0), SubList(120, 1), SubList(0, 0), SubList(16103, 45), High) // 6407h Motor service period
    (25616, 25616, SubList(16148, 10), SubList(0, 0), Optional, None, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(16158, 44), High) // 6410h Motor data
    (25858, 25858, SubList(16202, 21), SubList(0, 1), Optional, None, SubList(0, 0), SubList(121, 1), SubList(16223, 59), SubList(16282, 61), High) // 6502h Supported drive modes
    (25859, 25859, SubList(16343, 22), SubList(0, 1), Optional, None, SubList(0, 0), SubList(118, 1), SubList(0, 0), SubList(16365, 34), High) // 6503h Drive catalogue number
    (25860, 25860, SubList(16399, 18), SubList(0, 1), Optional, None, SubList(0, 0), SubList(118, 1), SubList(0, 0), SubList(16417, 30), High) // 6504h Drive manufacturer
    (25861, 25861, SubList(16447, 28), SubList(0, 1), Optional, None, SubList(0, 0), SubList(118, 1), SubList(0, 0), SubList(16475, 41), High) // 6505h HTTP drive catalogue address
    (25872, 25872, SubList(16516, 10), SubList(0, 0), Optional, None, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(16526, 44), High) // 6510h Drive data
    (26622, 26622, SubList(16570, 14), SubList(0, 1), Optional, None, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(16584, 50), High) // 67FEh Version number
    (26623, 26623, SubList(16634, 18), SubList(0, 1), Optional, None, SubList(0, 0), SubList(122, 1), SubList(0, 0), SubList(16652, 57), High) // 67FFh Single device type
);

static ENTRIES: &[EntryRow] = table!(EntryRow { first, last, mapping, need, name, data_types, access, values, default, unit, bits }:
    (0, 0, None, Optional, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 5))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(5, 1))
    (0, 0, Some(Tpdo), Mandatory, SubList(0, 0), SubList(1, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(Any), Mandatory, SubList(0, 0), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(6, 9))
    (0, 0, Some(Tpdo), Mandatory, SubList(0, 0), SubList(1, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(15, 15))
    (0, 0, Some(Any), Mandatory, SubList(0, 0), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(Tpdo), Mandatory, SubList(0, 0), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, None, Mandatory, SubList(0, 0), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, None, Mandatory, SubList(1122, 27), SubList(2, 1), SubList(2, 2), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(1149, 22), SubList(3, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // vl velocity min amount
    (2, 2, None, Mandatory, SubList(1171, 22), SubList(3, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // vl velocity max amount
    (0, 0, None, Mandatory, SubList(1122, 27), SubList(2, 1), SubList(2, 2), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(1379, 11), SubList(3, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Delta speed
    (2, 2, None, Mandatory, SubList(1390, 10), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(1400, 1), SubList(0, 0)) // Delta time
    (0, 0, None, Mandatory, SubList(1122, 27), SubList(2, 1), SubList(2, 2), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(1712, 29), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // vl set-point factor numerator
    (2, 2, None, Mandatory, SubList(1741, 31), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // vl set-point factor denominator
    (0, 0, None, Mandatory, SubList(1122, 27), SubList(2, 1), SubList(2, 2), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(1856, 29), SubList(4, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // vl dimension factor numerator
    (2, 2, None, Mandatory, SubList(1885, 31), SubList(4, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // vl dimension factor denominator
    (0, 0, None, Mandatory, SubList(0, 0), SubList(2, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, None, Mandatory, SubList(0, 0), SubList(3, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, None, Mandatory, SubList(0, 0), SubList(3, 1), SubList(0, 1), SubList(0, 0), None, SubList(2132, 2), SubList(0, 0))
    (0, 0, None, Mandatory, SubList(0, 0), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(0, 1), SubList(0, 1), SubList(2, 1), Some(0), SubList(0, 0), SubList(30, 1))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(0, 1), SubList(0, 1), SubList(3, 1), Some(1), SubList(0, 0), SubList(31, 1))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(0, 1), SubList(0, 1), SubList(3, 1), Some(2), SubList(0, 0), SubList(31, 1))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(0, 1), SubList(0, 1), SubList(4, 1), Some(2), SubList(0, 0), SubList(32, 1))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(0, 1), SubList(0, 1), SubList(4, 1), Some(0), SubList(0, 0), SubList(32, 1))
    (0, 0, Some(Any), Mandatory, SubList(0, 0), SubList(5, 1), SubList(4, 2), SubList(5, 2), None, SubList(0, 0), SubList(33, 1))
    (0, 0, Some(Tpdo), Mandatory, SubList(0, 0), SubList(5, 1), SubList(1, 1), SubList(5, 2), None, SubList(0, 0), SubList(33, 1))
    (0, 0, Some(Tpdo), Mandatory, SubList(0, 0), SubList(4, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(Any), Mandatory, SubList(0, 0), SubList(3, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, None, Mandatory, SubList(0, 0), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(2132, 2), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(34, 1))
    (0, 0, None, Mandatory, SubList(0, 0), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(Any), Mandatory, SubList(0, 0), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(5486, 25), SubList(0, 0))
    (0, 0, Some(Any), Mandatory, SubList(0, 0), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(5486, 25), SubList(0, 0))
    (0, 0, None, Mandatory, SubList(0, 0), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(5645, 26), SubList(0, 0))
    (0, 0, Some(Tpdo), Mandatory, SubList(0, 0), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(5486, 25), SubList(0, 0))
    (0, 0, None, Mandatory, SubList(0, 0), SubList(3, 1), SubList(6, 2), SubList(0, 0), None, SubList(5790, 2), SubList(0, 0))
    (0, 0, None, Mandatory, SubList(0, 0), SubList(3, 1), SubList(6, 2), SubList(0, 0), None, SubList(5876, 3), SubList(0, 0))
    (0, 0, Some(Tpdo), Mandatory, SubList(0, 0), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(5645, 26), SubList(0, 0))
    (0, 0, Some(Tpdo), Mandatory, SubList(0, 0), SubList(3, 1), SubList(1, 1), SubList(0, 0), None, SubList(6036, 2), SubList(0, 0))
    (0, 0, Some(Any), Mandatory, SubList(0, 0), SubList(4, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, None, Mandatory, SubList(1122, 27), SubList(2, 1), SubList(2, 2), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(6173, 24), SubList(4, 1), SubList(6, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Min position range limit
    (2, 2, None, Mandatory, SubList(6197, 24), SubList(4, 1), SubList(6, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Max position range limit
    (0, 0, None, Mandatory, SubList(1122, 27), SubList(2, 1), SubList(2, 2), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(6412, 18), SubList(4, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Min position limit
    (2, 2, None, Mandatory, SubList(6430, 18), SubList(4, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Max position limit
    (0, 0, None, Mandatory, SubList(0, 0), SubList(2, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(35, 2))
    (0, 0, None, Mandatory, SubList(0, 0), SubList(3, 1), SubList(0, 1), SubList(0, 0), None, SubList(6668, 3), SubList(0, 0))
    (0, 0, Some(Any), Mandatory, SubList(0, 0), SubList(0, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(37, 1))
    (0, 0, Some(Any), Mandatory, SubList(0, 0), SubList(3, 1), SubList(0, 1), SubList(0, 0), None, SubList(7171, 36), SubList(0, 0))
    (0, 0, None, Mandatory, SubList(0, 0), SubList(0, 1), SubList(0, 1), SubList(3, 1), None, SubList(0, 0), SubList(38, 1))
    (0, 0, None, Mandatory, SubList(0, 0), SubList(5, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, None, Mandatory, SubList(1122, 27), SubList(2, 1), SubList(2, 2), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7859, 18), SubList(3, 1), SubList(6, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Encoder increments
    (2, 2, None, Mandatory, SubList(7877, 17), SubList(3, 1), SubList(6, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Motor revolutions
    (0, 0, None, Mandatory, SubList(1122, 27), SubList(2, 1), SubList(2, 2), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8013, 29), SubList(3, 1), SubList(6, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Encoder increments per second
    (2, 2, None, Mandatory, SubList(8042, 28), SubList(3, 1), SubList(6, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Motor revolutions per second
    (0, 0, None, Mandatory, SubList(1122, 27), SubList(2, 1), SubList(2, 2), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(7877, 17), SubList(3, 1), SubList(6, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Motor revolutions
    (2, 2, None, Mandatory, SubList(8198, 17), SubList(3, 1), SubList(6, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Shaft revolutions
    (0, 0, None, Mandatory, SubList(1122, 27), SubList(2, 1), SubList(2, 2), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8295, 4), SubList(3, 1), SubList(6, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Feed
    (2, 2, None, Mandatory, SubList(8198, 17), SubList(3, 1), SubList(6, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Shaft revolutions
    (0, 0, None, Mandatory, SubList(1122, 27), SubList(2, 1), SubList(2, 2), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8386, 9), SubList(3, 1), SubList(6, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Numerator
    (2, 2, None, Mandatory, SubList(8299, 13), SubList(3, 1), SubList(6, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Feed constant
    (0, 0, None, Mandatory, SubList(1122, 27), SubList(2, 1), SubList(2, 2), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(8386, 9), SubList(3, 1), SubList(6, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Numerator
    (2, 2, None, Mandatory, SubList(8477, 7), SubList(3, 1), SubList(6, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Divisor
    (0, 0, Some(Any), Mandatory, SubList(0, 0), SubList(5, 1), SubList(0, 1), SubList(7, 4), None, SubList(0, 0), SubList(39, 1))
    (0, 0, None, Mandatory, SubList(1122, 27), SubList(2, 1), SubList(2, 2), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(9388, 30), SubList(3, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Speed during search for switch
    (2, 2, Some(Any), Mandatory, SubList(9418, 28), SubList(3, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Speed during search for zero
    (0, 0, None, Mandatory, SubList(0, 0), SubList(2, 1), SubList(0, 1), SubList(11, 4), None, SubList(0, 0), SubList(0, 0))
    (0, 0, None, Mandatory, SubList(1122, 27), SubList(2, 1), SubList(2, 2), SubList(15, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(9721, 14), SubList(3, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Profile jerk 1
    (2, 6, None, Optional, SubList(9735, 19), SubList(3, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Profile jerk 2 to 6
    (0, 0, None, Mandatory, SubList(0, 0), SubList(3, 1), SubList(6, 2), SubList(0, 0), None, SubList(0, 0), SubList(40, 3))
    (0, 0, Some(Any), Mandatory, SubList(0, 0), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(43, 12))
    (0, 0, Some(Tpdo), Mandatory, SubList(0, 0), SubList(1, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(55, 8))
    (0, 0, None, Mandatory, SubList(0, 0), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(63, 1))
    (0, 0, None, Mandatory, SubList(1122, 27), SubList(2, 1), SubList(2, 2), SubList(16, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(11199, 11), SubList(4, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Set-point 1
    (2, 254, Some(Any), Optional, SubList(11210, 18), SubList(4, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Set-point 2 to 254
    (0, 0, None, Mandatory, SubList(1122, 27), SubList(2, 1), SubList(2, 2), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(11298, 31), SubList(2, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Interpolation time period value
    (2, 2, None, Mandatory, SubList(11329, 24), SubList(5, 1), SubList(0, 1), SubList(17, 1), None, SubList(0, 0), SubList(0, 0)) // Interpolation time index
    (0, 0, None, Mandatory, SubList(1122, 27), SubList(2, 1), SubList(2, 2), SubList(18, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(11561, 19), SubList(3, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Maximum buffer size
    (2, 2, None, Mandatory, SubList(11580, 18), SubList(3, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Actual buffer size
    (3, 3, None, Mandatory, SubList(11618, 19), SubList(2, 1), SubList(0, 1), SubList(19, 2), None, SubList(0, 0), SubList(64, 1)) // Buffer organization
    (4, 4, None, Mandatory, SubList(11637, 15), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Buffer position
    (5, 5, None, Mandatory, SubList(11652, 19), SubList(2, 1), SubList(8, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Size of data record
    (6, 6, None, Mandatory, SubList(11671, 12), SubList(2, 1), SubList(8, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Buffer clear
    (0, 0, Some(Any), Mandatory, SubList(0, 0), SubList(6, 2), SubList(0, 1), SubList(0, 0), None, SubList(5486, 25), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(1122, 27), SubList(2, 1), SubList(1, 1), SubList(16, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, SubList(12747, 24), SubList(5, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Supported homing methods
    (2, 254, None, Optional, SubList(12747, 24), SubList(5, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Supported homing methods
    (0, 0, Some(No), Mandatory, SubList(1122, 27), SubList(2, 1), SubList(1, 1), SubList(16, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(12820, 32), SubList(4, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Additional position actual value
    (2, 254, Some(Tpdo), Optional, SubList(12820, 32), SubList(4, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Additional position actual value
    (0, 0, Some(No), Mandatory, SubList(1122, 27), SubList(2, 1), SubList(1, 1), SubList(16, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(12886, 32), SubList(4, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Additional velocity actual value
    (2, 254, Some(Tpdo), Optional, SubList(12886, 32), SubList(4, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Additional velocity actual value
    (0, 0, Some(Any), Mandatory, SubList(0, 0), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, None, Mandatory, SubList(0, 0), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(65, 7))
    (0, 0, None, Mandatory, SubList(0, 0), SubList(4, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(Tpdo), Mandatory, SubList(0, 0), SubList(3, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(72, 5))
    (0, 0, None, Mandatory, SubList(1122, 27), SubList(2, 1), SubList(2, 2), SubList(21, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(15312, 16), SubList(3, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(77, 2)) // Physical outputs
    (2, 2, Some(Any), Optional, SubList(15328, 8), SubList(3, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(77, 2)) // Bit mask
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(1, 1), SubList(6, 2), SubList(0, 0), None, SubList(0, 0), SubList(79, 1))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(8, 1), SubList(6, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(9, 1), SubList(6, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(3, 1), SubList(6, 2), SubList(0, 0), None, SubList(16082, 1), SubList(0, 0))
    (0, 0, None, Mandatory, SubList(0, 0), SubList(3, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(80, 11))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(3, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 5))
);

static BITS: &[BitRow] = table!(BitRow { first, last, name, values }:
    (16, 16, SubList(0, 19), SubList(0, 0)) // frequency converter
    (17, 17, SubList(19, 11), SubList(0, 0)) // servo drive
    (18, 18, SubList(30, 13), SubList(0, 0)) // stepper motor
    (22, 22, SubList(43, 31), SubList(0, 0)) // PDO mapping of the manufacturer
    (24, 31, SubList(74, 19), SubList(0, 0)) // of the manufacturer
    (0, 15, SubList(155, 8), SubList(0, 5)) // reaction
    (0, 0, SubList(379, 9), SubList(0, 0)) // switch on
    (1, 1, SubList(388, 14), SubList(0, 0)) // enable voltage
    (2, 2, SubList(402, 14), SubList(0, 0)) // quick stop off
    (3, 3, SubList(416, 16), SubList(0, 0)) // enable operation
    (4, 6, SubList(432, 11), SubList(0, 0)) // of the mode
    (7, 7, SubList(443, 11), SubList(0, 0)) // fault reset
    (8, 8, SubList(454, 4), SubList(0, 0)) // halt
    (9, 9, SubList(432, 11), SubList(0, 0)) // of the mode
    (11, 15, SubList(74, 19), SubList(0, 0)) // of the manufacturer
    (0, 6, SubList(544, 5), SubList(5, 24)) // state
    (0, 0, SubList(614, 18), SubList(0, 0)) // ready to switch on
    (1, 1, SubList(632, 11), SubList(0, 0)) // switched on
    (2, 2, SubList(643, 17), SubList(0, 0)) // operation enabled
    (3, 3, SubList(588, 5), SubList(0, 0)) // fault
    (4, 4, SubList(678, 15), SubList(0, 0)) // voltage enabled
    (5, 5, SubList(402, 14), SubList(0, 0)) // quick stop off
    (6, 6, SubList(660, 18), SubList(0, 0)) // switch on disabled
    (7, 7, SubList(693, 7), SubList(0, 0)) // warning
    (8, 8, SubList(74, 19), SubList(0, 0)) // of the manufacturer
    (9, 9, SubList(700, 6), SubList(0, 0)) // remote
    (10, 10, SubList(706, 14), SubList(0, 0)) // target reached
    (11, 11, SubList(720, 21), SubList(0, 0)) // internal limit active
    (12, 13, SubList(432, 11), SubList(0, 0)) // of the mode
    (14, 15, SubList(74, 19), SubList(0, 0)) // of the manufacturer
    (0, 15, SubList(155, 8), SubList(29, 10)) // reaction
    (0, 15, SubList(155, 8), SubList(39, 3)) // reaction
    (0, 15, SubList(155, 8), SubList(42, 6)) // reaction
    (0, 7, SubList(3935, 4), SubList(48, 12)) // mode
    (0, 15, SubList(4902, 22), SubList(60, 3)) // source of the velocity
    (6, 6, SubList(6530, 17), SubList(0, 0)) // velocity times -1
    (7, 7, SubList(6547, 17), SubList(0, 0)) // position times -1
    (0, 15, SubList(7050, 5), SubList(63, 5)) // shape
    (0, 15, SubList(7050, 5), SubList(68, 3)) // shape
    (0, 7, SubList(8824, 6), SubList(71, 18)) // method
    (8, 15, SubList(9813, 11), SubList(0, 0)) // denominator
    (16, 23, SubList(9824, 9), SubList(0, 0)) // numerator
    (24, 31, SubList(9833, 21), SubList(0, 0)) // prefix, a power of 10
    (0, 0, SubList(10202, 16), SubList(0, 0)) // touch probe 1 on
    (1, 1, SubList(10218, 24), SubList(0, 0)) // touch probe 1 continuous
    (2, 3, SubList(10242, 20), SubList(89, 3)) // touch probe 1 source
    (4, 4, SubList(10285, 35), SubList(0, 0)) // touch probe 1 samples positive edge
    (5, 5, SubList(10320, 35), SubList(0, 0)) // touch probe 1 samples negative edge
    (6, 7, SubList(74, 19), SubList(0, 0)) // of the manufacturer
    (8, 8, SubList(10355, 16), SubList(0, 0)) // touch probe 2 on
    (9, 9, SubList(10371, 24), SubList(0, 0)) // touch probe 2 continuous
    (10, 11, SubList(10395, 20), SubList(92, 3)) // touch probe 2 source
    (12, 12, SubList(10422, 35), SubList(0, 0)) // touch probe 2 samples positive edge
    (13, 13, SubList(10457, 35), SubList(0, 0)) // touch probe 2 samples negative edge
    (14, 15, SubList(74, 19), SubList(0, 0)) // of the manufacturer
    (0, 0, SubList(10202, 16), SubList(0, 0)) // touch probe 1 on
    (1, 1, SubList(10549, 31), SubList(0, 0)) // touch probe 1 has positive edge
    (2, 2, SubList(10580, 31), SubList(0, 0)) // touch probe 1 has negative edge
    (6, 7, SubList(74, 19), SubList(0, 0)) // of the manufacturer
    (8, 8, SubList(10355, 16), SubList(0, 0)) // touch probe 2 on
    (9, 9, SubList(10611, 31), SubList(0, 0)) // touch probe 2 has positive edge
    (10, 10, SubList(10642, 31), SubList(0, 0)) // touch probe 2 has negative edge
    (14, 15, SubList(74, 19), SubList(0, 0)) // of the manufacturer
    (0, 15, SubList(11061, 13), SubList(95, 2)) // interpolation
    (0, 7, SubList(11598, 12), SubList(97, 2)) // organization
    (0, 1, SubList(14124, 11), SubList(99, 3)) // relative to
    (2, 3, SubList(14197, 6), SubList(102, 2)) // change
    (4, 5, SubList(14265, 20), SubList(0, 0)) // request and response
    (6, 7, SubList(14285, 11), SubList(104, 4)) // rotary axis
    (8, 11, SubList(11061, 13), SubList(0, 0)) // interpolation
    (12, 14, SubList(14378, 8), SubList(0, 0)) // reserved
    (15, 15, SubList(74, 19), SubList(0, 0)) // of the manufacturer
    (0, 0, SubList(9077, 21), SubList(0, 0)) // negative limit switch
    (1, 1, SubList(9098, 21), SubList(0, 0)) // positive limit switch
    (2, 2, SubList(15194, 11), SubList(0, 0)) // home switch
    (3, 3, SubList(15205, 9), SubList(0, 0)) // interlock
    (16, 31, SubList(74, 19), SubList(0, 0)) // of the manufacturer
    (0, 0, SubList(15303, 9), SubList(0, 0)) // set brake
    (16, 31, SubList(74, 19), SubList(0, 0)) // of the manufacturer
    (0, 15, SubList(15487, 5), SubList(108, 13)) // motor
    (0, 0, SubList(3946, 16), SubList(0, 0)) // profile position
    (1, 1, SubList(3962, 8), SubList(0, 0)) // velocity
    (2, 2, SubList(3970, 16), SubList(0, 0)) // profile velocity
    (3, 3, SubList(3986, 14), SubList(0, 0)) // torque profile
    (5, 5, SubList(4000, 6), SubList(0, 0)) // homing
    (6, 6, SubList(4006, 21), SubList(0, 0)) // interpolated position
    (7, 7, SubList(4027, 27), SubList(0, 0)) // cyclic synchronous position
    (8, 8, SubList(4054, 27), SubList(0, 0)) // cyclic synchronous velocity
    (9, 9, SubList(4081, 25), SubList(0, 0)) // cyclic synchronous torque
    (10, 10, SubList(4106, 48), SubList(0, 0)) // cyclic synchronous torque with commutation angle
    (16, 31, SubList(74, 19), SubList(0, 0)) // of the manufacturer
);

static MEANINGS: &[MeaningRow] = table!(MeaningRow { first, last, text }:
    (0, 0, SubList(163, 9)) // no action
    (1, 1, SubList(172, 12)) // fault signal
    (2, 2, SubList(184, 15)) // disable voltage
    (3, 3, SubList(199, 10)) // quick stop
    (32768, 65535, SubList(209, 21)) // manufacturer-specific
    (0, 0, SubList(549, 22)) // not ready to switch on
    (7, 7, SubList(571, 17)) // quick stop active
    (8, 8, SubList(588, 5)) // fault
    (15, 15, SubList(593, 21)) // fault reaction active
    (16, 16, SubList(549, 22)) // not ready to switch on
    (23, 23, SubList(571, 17)) // quick stop active
    (24, 24, SubList(588, 5)) // fault
    (31, 31, SubList(593, 21)) // fault reaction active
    (32, 32, SubList(549, 22)) // not ready to switch on
    (33, 33, SubList(614, 18)) // ready to switch on
    (35, 35, SubList(632, 11)) // switched on
    (39, 39, SubList(643, 17)) // operation enabled
    (40, 40, SubList(588, 5)) // fault
    (47, 47, SubList(593, 21)) // fault reaction active
    (48, 48, SubList(549, 22)) // not ready to switch on
    (49, 49, SubList(614, 18)) // ready to switch on
    (51, 51, SubList(632, 11)) // switched on
    (55, 55, SubList(643, 17)) // operation enabled
    (56, 56, SubList(588, 5)) // fault
    (63, 63, SubList(593, 21)) // fault reaction active
    (64, 64, SubList(660, 18)) // switch on disabled
    (80, 80, SubList(660, 18)) // switch on disabled
    (96, 96, SubList(660, 18)) // switch on disabled
    (112, 112, SubList(660, 18)) // switch on disabled
    (0, 0, SubList(3128, 22)) // disable drive function
    (1, 1, SubList(3150, 39)) // slow down ramp, then switch on disabled
    (2, 2, SubList(3189, 40)) // quick stop ramp, then switch on disabled
    (3, 3, SubList(3229, 38)) // current limit, then switch on disabled
    (4, 4, SubList(3267, 38)) // voltage limit, then switch on disabled
    (5, 5, SubList(3305, 41)) // slow down ramp, stay in quick stop active
    (6, 6, SubList(3346, 42)) // quick stop ramp, stay in quick stop active
    (7, 7, SubList(3388, 40)) // current limit, stay in quick stop active
    (8, 8, SubList(3428, 40)) // voltage limit, stay in quick stop active
    (32768, 65535, SubList(209, 21)) // manufacturer-specific
    (0, 0, SubList(3128, 22)) // disable drive function
    (1, 1, SubList(3536, 28)) // slow down ramp, then disable
    (32768, 65535, SubList(209, 21)) // manufacturer-specific
    (0, 0, SubList(3128, 22)) // disable drive function
    (1, 1, SubList(3734, 14)) // slow down ramp
    (2, 2, SubList(3748, 15)) // quick stop ramp
    (3, 3, SubList(3763, 13)) // current limit
    (4, 4, SubList(3776, 13)) // voltage limit
    (32768, 65535, SubList(209, 21)) // manufacturer-specific
    (0, 0, SubList(3939, 7)) // no mode
    (1, 1, SubList(3946, 16)) // profile position
    (2, 2, SubList(3962, 8)) // velocity
    (3, 3, SubList(3970, 16)) // profile velocity
    (4, 4, SubList(3986, 14)) // torque profile
    (6, 6, SubList(4000, 6)) // homing
    (7, 7, SubList(4006, 21)) // interpolated position
    (8, 8, SubList(4027, 27)) // cyclic synchronous position
    (9, 9, SubList(4054, 27)) // cyclic synchronous velocity
    (10, 10, SubList(4081, 25)) // cyclic synchronous torque
    (11, 11, SubList(4106, 48)) // cyclic synchronous torque with commutation angle
    (128, 255, SubList(209, 21)) // manufacturer-specific
    (0, 0, SubList(4924, 16)) // position encoder
    (1, 1, SubList(4940, 16)) // velocity encoder
    (32768, 65535, SubList(209, 21)) // manufacturer-specific
    (0, 0, SubList(7055, 11)) // linear ramp
    (1, 1, SubList(7066, 10)) // sin² ramp
    (2, 2, SubList(7076, 14)) // jerk-free ramp
    (3, 3, SubList(7090, 17)) // jerk-limited ramp
    (32768, 65535, SubList(209, 21)) // manufacturer-specific
    (0, 0, SubList(7055, 11)) // linear ramp
    (1, 1, SubList(7066, 10)) // sin² ramp
    (32768, 65535, SubList(209, 21)) // manufacturer-specific
    (0, 0, SubList(8830, 9)) // no homing
    (1, 1, SubList(8839, 37)) // negative limit switch and index pulse
    (2, 2, SubList(8876, 37)) // positive limit switch and index pulse
    (3, 4, SubList(8913, 36)) // positive home switch and index pulse
    (5, 6, SubList(8949, 36)) // negative home switch and index pulse
    (7, 10, SubList(8985, 46)) // home switch and index pulse, starting positive
    (11, 14, SubList(9031, 46)) // home switch and index pulse, starting negative
    (17, 17, SubList(9077, 21)) // negative limit switch
    (18, 18, SubList(9098, 21)) // positive limit switch
    (19, 20, SubList(9119, 20)) // positive home switch
    (21, 22, SubList(9139, 20)) // negative home switch
    (23, 26, SubList(9159, 30)) // home switch, starting positive
    (27, 30, SubList(9189, 30)) // home switch, starting negative
    (33, 33, SubList(9219, 33)) // index pulse in negative direction
    (34, 34, SubList(9252, 33)) // index pulse in positive direction
    (35, 35, SubList(9285, 28)) // current position (version 2)
    (37, 37, SubList(9313, 16)) // current position
    (128, 255, SubList(209, 21)) // manufacturer-specific
    (0, 0, SubList(10262, 5)) // input
    (1, 1, SubList(10267, 11)) // index pulse
    (2, 2, SubList(10278, 7)) // 60D0h:1
    (0, 0, SubList(10262, 5)) // input
    (1, 1, SubList(10267, 11)) // index pulse
    (2, 2, SubList(10415, 7)) // 60D0h:2
    (0, 0, SubList(11074, 20)) // linear interpolation
    (32768, 65535, SubList(209, 21)) // manufacturer-specific
    (0, 0, SubList(11610, 4)) // FIFO
    (1, 1, SubList(11614, 4)) // ring
    (0, 0, SubList(14135, 20)) // last target position
    (1, 1, SubList(14155, 21)) // position demand value
    (2, 2, SubList(14176, 21)) // position actual value
    (0, 0, SubList(14203, 7)) // at once
    (1, 1, SubList(14210, 55)) // of the set-point at once, of the rest with the next one
    (0, 0, SubList(14296, 40)) // within one revolution like a linear axis
    (1, 1, SubList(14336, 15)) // always negative
    (2, 2, SubList(14351, 15)) // always positive
    (3, 3, SubList(14366, 12)) // shortest way
    (0, 0, SubList(15492, 18)) // non-standard motor
    (1, 1, SubList(15510, 24)) // phase modulated DC motor
    (2, 2, SubList(15534, 29)) // frequency controlled DC motor
    (3, 3, SubList(15563, 34)) // permanent magnet synchronous motor
    (4, 4, SubList(15597, 38)) // frequency controlled synchronous motor
    (5, 5, SubList(15635, 25)) // switched reluctance motor
    (6, 6, SubList(15660, 27)) // wound rotor induction motor
    (7, 7, SubList(15687, 29)) // squirrel cage induction motor
    (8, 8, SubList(30, 13)) // stepper motor
    (9, 9, SubList(15716, 24)) // micro-step stepper motor
    (10, 10, SubList(15740, 43)) // brushless motor with sinusoidal commutation
    (11, 11, SubList(15783, 38)) // brushless motor with block commutation
    (32768, 65535, SubList(209, 21)) // manufacturer-specific
    (8464, 8464, SubList(16709, 42)) // short circuit or earth leakage, input side
    (8480, 8480, SubList(16751, 25)) // earth leakage, input side
    (8481, 8481, SubList(16776, 23)) // earth leakage, phase L1
    (8482, 8482, SubList(16799, 23)) // earth leakage, phase L2
    (8483, 8483, SubList(16822, 23)) // earth leakage, phase L3
    (8496, 8496, SubList(16845, 25)) // short circuit, input side
    (8497, 8497, SubList(16870, 31)) // short circuit, phases L1 and L2
    (8498, 8498, SubList(16901, 31)) // short circuit, phases L2 and L3
    (8499, 8499, SubList(16932, 31)) // short circuit, phases L3 and L1
    (8721, 8721, SubList(16963, 18)) // internal current 1
    (8722, 8722, SubList(16981, 18)) // internal current 2
    (8723, 8723, SubList(16999, 33)) // over-current in the ramp function
    (8724, 8724, SubList(17032, 28)) // over-current in the sequence
    (8736, 8736, SubList(17060, 37)) // continuous over-current in the device
    (8737, 8737, SubList(17097, 39)) // continuous over-current 1 in the device
    (8738, 8738, SubList(17136, 39)) // continuous over-current 2 in the device
    (8752, 8752, SubList(17175, 44)) // short circuit or earth leakage in the device
    (8768, 8768, SubList(17219, 27)) // earth leakage in the device
    (8784, 8784, SubList(17246, 27)) // short circuit in the device
    (8976, 8976, SubList(17273, 35)) // continuous over-current, motor side
    (8977, 8977, SubList(17308, 37)) // continuous over-current 1, motor side
    (8978, 8978, SubList(17345, 37)) // continuous over-current 2, motor side
    (8992, 8992, SubList(17382, 42)) // short circuit or earth leakage, motor side
    (9008, 9008, SubList(17424, 25)) // earth leakage, motor side
    (9009, 9009, SubList(17449, 22)) // earth leakage, phase U
    (9010, 9010, SubList(17471, 22)) // earth leakage, phase V
    (9011, 9011, SubList(17493, 22)) // earth leakage, phase W
    (9024, 9024, SubList(17515, 25)) // short circuit, motor side
    (9025, 9025, SubList(17540, 29)) // short circuit, phases U and V
    (9026, 9026, SubList(17569, 29)) // short circuit, phases V and W
    (9027, 9027, SubList(17598, 29)) // short circuit, phases W and U
    (9040, 9040, SubList(17627, 29)) // overload (I2t, thermal state)
    (9041, 9041, SubList(17656, 38)) // overload (I2t, thermal state), warning
    (12560, 12560, SubList(17694, 18)) // mains over-voltage
    (12561, 12561, SubList(17712, 28)) // mains over-voltage, phase L1
    (12562, 12562, SubList(17740, 28)) // mains over-voltage, phase L2
    (12563, 12563, SubList(17768, 28)) // mains over-voltage, phase L3
    (12576, 12576, SubList(17796, 19)) // mains under-voltage
    (12577, 12577, SubList(17815, 29)) // mains under-voltage, phase L1
    (12578, 12578, SubList(17844, 29)) // mains under-voltage, phase L2
    (12579, 12579, SubList(17873, 29)) // mains under-voltage, phase L3
    (12592, 12592, SubList(17902, 13)) // phase failure
    (12593, 12593, SubList(17915, 17)) // phase failure, L1
    (12594, 12594, SubList(17932, 17)) // phase failure, L2
    (12595, 12595, SubList(17949, 17)) // phase failure, L3
    (12596, 12596, SubList(17966, 14)) // phase sequence
    (12608, 12608, SubList(17980, 15)) // mains frequency
    (12609, 12609, SubList(17995, 24)) // mains frequency too high
    (12610, 12610, SubList(18019, 23)) // mains frequency too low
    (12816, 12816, SubList(18042, 20)) // DC link over-voltage
    (12817, 12817, SubList(18062, 22)) // DC link over-voltage 1
    (12818, 12818, SubList(18084, 22)) // DC link over-voltage 2
    (12832, 12832, SubList(18106, 21)) // DC link under-voltage
    (12833, 12833, SubList(18127, 23)) // DC link under-voltage 1
    (12834, 12834, SubList(18150, 23)) // DC link under-voltage 2
    (12848, 12848, SubList(18173, 10)) // load error
    (13072, 13072, SubList(18183, 19)) // output over-voltage
    (13073, 13073, SubList(18202, 28)) // output over-voltage, phase U
    (13074, 13074, SubList(18230, 28)) // output over-voltage, phase V
    (13075, 13075, SubList(18258, 28)) // output over-voltage, phase W
    (13088, 13088, SubList(18286, 16)) // armature circuit
    (13089, 13089, SubList(18302, 28)) // armature circuit interrupted
    (13104, 13104, SubList(18330, 13)) // field circuit
    (13105, 13105, SubList(18343, 25)) // field circuit interrupted
    (16656, 16656, SubList(18368, 28)) // ambient temperature too high
    (16672, 16672, SubList(18396, 27)) // ambient temperature too low
    (16688, 16688, SubList(18423, 29)) // temperature of the supply air
    (16704, 16704, SubList(18452, 29)) // temperature of the air outlet
    (16912, 16912, SubList(18481, 27)) // device temperature too high
    (16928, 16928, SubList(18508, 26)) // device temperature too low
    (17152, 17152, SubList(18534, 24)) // temperature of the drive
    (17168, 17168, SubList(18558, 33)) // temperature of the drive too high
    (17184, 17184, SubList(18591, 32)) // temperature of the drive too low
    (17408, 17408, SubList(18623, 25)) // temperature of the supply
    (17424, 17424, SubList(18648, 34)) // temperature of the supply too high
    (17440, 17440, SubList(18682, 33)) // temperature of the supply too low
    (20736, 20736, SubList(18715, 6)) // supply
    (20752, 20752, SubList(18721, 23)) // low voltage of a supply
    (20753, 20753, SubList(18744, 30)) // low voltage of the 15 V supply
    (20754, 20754, SubList(18774, 30)) // low voltage of the 24 V supply
    (20755, 20755, SubList(18804, 29)) // low voltage of the 5 V supply
    (20756, 20761, SubList(18833, 43)) // low voltage of a supply of the manufacturer
    (20768, 20768, SubList(18876, 34)) // supply of the intermediate circuit
    (20992, 20992, SubList(18910, 7)) // control
    (21008, 21008, SubList(18917, 17)) // measuring circuit
    (21024, 21024, SubList(18934, 17)) // computing circuit
    (21248, 21248, SubList(18951, 14)) // operating unit
    (21504, 21504, SubList(18965, 13)) // power section
    (21520, 21520, SubList(18978, 13)) // output stages
    (21536, 21536, SubList(18991, 7)) // chopper
    (21552, 21552, SubList(18998, 12)) // input stages
    (21568, 21568, SubList(19010, 8)) // contacts
    (21569, 21577, SubList(19018, 27)) // contact of the manufacturer
    (21584, 21584, SubList(19045, 5)) // fuses
    (21585, 21593, SubList(19050, 24)) // fuse of the manufacturer
    (21760, 21760, SubList(19074, 12)) // data storage
    (21776, 21776, SubList(19086, 14)) // working memory
    (21792, 21792, SubList(19100, 14)) // program memory
    (21808, 21808, SubList(19114, 24)) // non-volatile data memory
    (24592, 24592, SubList(19138, 25)) // software reset (watchdog)
    (25345, 25359, SubList(19163, 11)) // data record
    (25360, 25360, SubList(19174, 18)) // loss of parameters
    (25376, 25376, SubList(19192, 15)) // parameter error
    (28928, 28928, SubList(19207, 5)) // power
    (28944, 28944, SubList(19212, 13)) // brake chopper
    (28945, 28945, SubList(19225, 28)) // failure of the brake chopper
    (28946, 28946, SubList(19253, 33)) // over-current of the brake chopper
    (28947, 28947, SubList(19286, 39)) // protective circuit of the brake chopper
    (28960, 28960, SubList(15487, 5)) // motor
    (28961, 28961, SubList(19325, 13)) // motor blocked
    (28962, 28962, SubList(19338, 32)) // motor error or wrong commutation
    (28963, 28963, SubList(19370, 12)) // motor tilted
    (29184, 29184, SubList(19382, 24)) // measuring circuit module
    (29440, 29440, SubList(19406, 6)) // sensor
    (29441, 29441, SubList(19412, 16)) // tachometer fault
    (29442, 29442, SubList(19428, 32)) // wrong polarity of the tachometer
    (29443, 29443, SubList(19460, 19)) // fault of resolver 1
    (29444, 29444, SubList(19479, 19)) // fault of resolver 2
    (29445, 29445, SubList(19498, 29)) // fault of incremental sensor 1
    (29446, 29446, SubList(19527, 29)) // fault of incremental sensor 2
    (29447, 29447, SubList(19556, 29)) // fault of incremental sensor 3
    (29456, 29456, SubList(19585, 5)) // speed
    (29472, 29472, SubList(19590, 8)) // position
    (29696, 29696, SubList(19598, 24)) // computing circuit module
    (29952, 29952, SubList(19622, 20)) // communication module
    (29968, 29968, SubList(19642, 18)) // serial interface 1
    (29984, 29984, SubList(19660, 18)) // serial interface 2
    (30208, 30208, SubList(19678, 19)) // data storage module
    (33536, 33536, SubList(19697, 14)) // torque control
    (33553, 33553, SubList(19711, 15)) // torque too high
    (33554, 33554, SubList(19726, 18)) // difficult start-up
    (33555, 33555, SubList(19744, 20)) // torque at standstill
    (33569, 33569, SubList(19764, 14)) // torque too low
    (33585, 33585, SubList(19778, 12)) // torque fault
    (33792, 33792, SubList(19790, 19)) // velocity controller
    (34048, 34048, SubList(19809, 19)) // position controller
    (34304, 34304, SubList(19828, 22)) // positioning controller
    (34321, 34321, SubList(19850, 15)) // following error
    (34322, 34322, SubList(19865, 15)) // reference limit
    (34560, 34560, SubList(19880, 22)) // synchronous controller
    (34816, 34816, SubList(19902, 18)) // winding controller
    (35072, 35072, SubList(19920, 23)) // process data monitoring
    (35328, 35328, SubList(19943, 18)) // control monitoring
    (61441, 61441, SubList(19961, 12)) // deceleration
    (61442, 61442, SubList(19973, 19)) // sub-synchronous run
    (61443, 61443, SubList(19992, 16)) // stroke operation
    (61444, 61444, SubList(18910, 7)) // control
);

static COMMANDS: &[CommandRow] = table!(CommandRow { name, mask }:
    (SubList(20008, 8), SubList(20016, 9)) // shutdown
    (SubList(379, 9), SubList(20025, 9)) // switch on
    (SubList(416, 16), SubList(20034, 9)) // enable operation
    (SubList(20043, 17), SubList(20025, 9)) // disable operation
    (SubList(199, 10), SubList(20060, 9)) // quick stop
    (SubList(184, 15), SubList(20069, 9)) // disable voltage
    (SubList(20078, 25), SubList(20103, 9)) // fault reset (bit 7 rises)
);

static TRANSITIONS: &[TransitionRow] = table!(TransitionRow { number, from, to, by }:
    (0, SubList(20112, 5), SubList(549, 22), SubList(20117, 17)) // not ready to switch on
    (1, SubList(549, 22), SubList(660, 18), SubList(20134, 22)) // switch on disabled
    (2, SubList(660, 18), SubList(614, 18), SubList(20008, 8)) // ready to switch on
    (3, SubList(614, 18), SubList(632, 11), SubList(379, 9)) // switched on
    (4, SubList(632, 11), SubList(643, 17), SubList(416, 16)) // operation enabled
    (5, SubList(643, 17), SubList(632, 11), SubList(20043, 17)) // switched on
    (6, SubList(632, 11), SubList(614, 18), SubList(20008, 8)) // ready to switch on
    (7, SubList(614, 18), SubList(660, 18), SubList(20156, 27)) // switch on disabled
    (8, SubList(643, 17), SubList(614, 18), SubList(20008, 8)) // ready to switch on
    (9, SubList(643, 17), SubList(660, 18), SubList(184, 15)) // switch on disabled
    (10, SubList(632, 11), SubList(660, 18), SubList(20156, 27)) // switch on disabled
    (11, SubList(643, 17), SubList(571, 17), SubList(199, 10)) // quick stop active
    (12, SubList(571, 17), SubList(660, 18), SubList(20183, 53)) // switch on disabled
    (13, SubList(20236, 9), SubList(593, 21), SubList(20245, 7)) // fault reaction active
    (14, SubList(593, 21), SubList(588, 5), SubList(20252, 22)) // fault
    (15, SubList(588, 5), SubList(660, 18), SubList(20078, 25)) // switch on disabled
    (16, SubList(571, 17), SubList(643, 17), SubList(20274, 34)) // operation enabled
);

static CONDITIONS: &[Condition] = &[
    Condition::constant("6502h[1]", &[BitsIn(25858, 0, [1, 1], 1), Range(1, 170141183460469231731687303715884105727)]),
    Condition::constant("6502h[0] or 6502h[6] or 6502h[7]", &[OneOf(3), BitsIn(25858, 0, [0, 0], 1), Range(1, 170141183460469231731687303715884105727), BitsIn(25858, 0, [6, 6], 1), Range(1, 170141183460469231731687303715884105727), BitsIn(25858, 0, [7, 7], 1), Range(1, 170141183460469231731687303715884105727)]),
    Condition::constant("6502h[2] or 6502h[8]", &[OneOf(2), BitsIn(25858, 0, [2, 2], 1), Range(1, 170141183460469231731687303715884105727), BitsIn(25858, 0, [8, 8], 1), Range(1, 170141183460469231731687303715884105727)]),
    Condition::constant("6502h[3] or 6502h[9] or 6502h[10]", &[OneOf(3), BitsIn(25858, 0, [3, 3], 1), Range(1, 170141183460469231731687303715884105727), BitsIn(25858, 0, [9, 9], 1), Range(1, 170141183460469231731687303715884105727), BitsIn(25858, 0, [10, 10], 1), Range(1, 170141183460469231731687303715884105727)]),
    Condition::constant("6502h[3] or 6502h[9]", &[OneOf(2), BitsIn(25858, 0, [3, 3], 1), Range(1, 170141183460469231731687303715884105727), BitsIn(25858, 0, [9, 9], 1), Range(1, 170141183460469231731687303715884105727)]),
    Condition::constant("6502h[0] or 6502h[7]", &[OneOf(2), BitsIn(25858, 0, [0, 0], 1), Range(1, 170141183460469231731687303715884105727), BitsIn(25858, 0, [7, 7], 1), Range(1, 170141183460469231731687303715884105727)]),
    Condition::constant("6502h[0]", &[BitsIn(25858, 0, [0, 0], 1), Range(1, 170141183460469231731687303715884105727)]),
    Condition::constant("6502h[0] or 6502h[2]", &[OneOf(2), BitsIn(25858, 0, [0, 0], 1), Range(1, 170141183460469231731687303715884105727), BitsIn(25858, 0, [2, 2], 1), Range(1, 170141183460469231731687303715884105727)]),
    Condition::constant("6502h[3]", &[BitsIn(25858, 0, [3, 3], 1), Range(1, 170141183460469231731687303715884105727)]),
    Condition::constant("6502h[5]", &[BitsIn(25858, 0, [5, 5], 1), Range(1, 170141183460469231731687303715884105727)]),
    Condition::constant("6502h[7] or 6502h[8] or 6502h[9]", &[OneOf(3), BitsIn(25858, 0, [7, 7], 1), Range(1, 170141183460469231731687303715884105727), BitsIn(25858, 0, [8, 8], 1), Range(1, 170141183460469231731687303715884105727), BitsIn(25858, 0, [9, 9], 1), Range(1, 170141183460469231731687303715884105727)]),
    Condition::constant("6502h[10]", &[BitsIn(25858, 0, [10, 10], 1), Range(1, 170141183460469231731687303715884105727)]),
];

static OBJECT_TYPES: &[ObjectType] = &[Var, Array, Record, Array, Record];

static DATA_TYPES: &[DataType] = &[DataType(3), DataType(6), DataType(5), DataType(7), DataType(4), DataType(2), DataType(6), DataType(3), DataType(9), DataType(12)];

static ACCESS: &[Access] = &[Rw, Ro, Const, Ro, Rw, Wo, Rw, Ro, Wo, Rw];

static VALUES: &[std::ops::RangeInclusive<i128>] = &[-32768..=3, 2..=2, -32768..=8, -32768..=1, -32768..=4, -128..=4, 6..=11, -128..=14, 17..=30, 33..=35, 37..=37, 1..=1, 2..=2, 4..=4, 6..=6, 1..=6, 1..=254, -128..=63, 6..=6, 0..=0, 1..=1, 1..=2];

static DEFAULTS: &[Value] = &[Signed(2), Signed(0), Signed(1)];

static INDEXES: &[u16] = &[];

static TEXTS: &str = concat!(
    "frequency converter", "servo drive", "stepper motor", "PDO mapping of the manufacturer",
    "of the manufacturer", "Device type", "Says that the device is a drive, and of which kind.", "reaction",
    "no action", "fault signal", "disable voltage", "quick stop", "manufacturer-specific",
    "Abort connection option code", "What the drive does when the connection to its master is lost.",
    "Error code", "The code of the latest error, as EMCY reports it.", "switch on", "enable voltage",
    "quick stop off", "enable operation", "of the mode", "fault reset", "halt", "Controlword",
    "Commands the state machine of the drive and controls the mode of operation.", "state",
    "not ready to switch on", "quick stop active", "fault", "fault reaction active", "ready to switch on",
    "switched on", "operation enabled", "switch on disabled", "voltage enabled", "warning", "remote",
    "target reached", "internal limit active", "Statusword",
    "Shows the state of the drive and what the mode of operation reports.", "vl target velocity",
    "The speed that velocity mode (vl) must reach.", "vl velocity demand",
    "The speed that the ramp of velocity mode demands now.", "vl velocity actual value",
    "The speed of the motor, in the unit of the target velocity.", "vl manipulated velocity",
    "The speed behind the controller's correction, in velocity mode.", "Highest sub-index supported",
    "vl velocity min amount", "vl velocity max amount", "vl velocity min max amount",
    "The lowest and the highest speed of velocity mode, for both directions.", "vl velocity min max",
    "The lowest and the highest speed of velocity mode, for each direction.", "Delta speed", "Delta time", "s",
    "vl velocity acceleration",
    "The slope of the acceleration ramp of velocity mode: a speed and the time for it.",
    "vl velocity deceleration",
    "The slope of the deceleration ramp of velocity mode: a speed and the time for it.",
    "vl velocity quick stop", "The slope of the quick stop ramp of velocity mode: a speed and the time for it.",
    "vl set-point factor numerator", "vl set-point factor denominator", "vl set-point factor",
    "A fraction by which the set-point of velocity mode is multiplied.", "vl dimension factor numerator",
    "vl dimension factor denominator", "vl dimension factor",
    "A fraction that converts the speed of velocity mode into a unit of the user.", "vl pole number",
    "The number of poles of the motor.", "vl velocity reference",
    "The speed that percentages of velocity mode refer to.", "ms", "vl ramp function time",
    "The time of the acceleration ramp of velocity mode, from 0 to the reference.", "vl slow down time",
    "The time of the deceleration ramp of velocity mode, from the reference to 0.", "vl quick stop time",
    "The time of the quick stop ramp of velocity mode, from the reference to 0.", "vl nominal percentage",
    "The target of velocity mode as a part of the reference.", "vl percentage demand",
    "The demand of the ramp as a part of the reference.", "vl actual percentage",
    "The actual speed as a part of the reference.", "vl manipulated percentage",
    "The corrected speed as a part of the reference.", "vl velocity motor min max amount",
    "The lowest and the highest motor speed of velocity mode, for both directions.", "vl velocity motor min max",
    "The lowest and the highest motor speed of velocity mode, for each direction.",
    "vl frequency motor min max amount",
    "The lowest and the highest motor frequency of velocity mode, for both directions.",
    "vl frequency motor min max",
    "The lowest and the highest motor frequency of velocity mode, for each direction.", "disable drive function",
    "slow down ramp, then switch on disabled", "quick stop ramp, then switch on disabled",
    "current limit, then switch on disabled", "voltage limit, then switch on disabled",
    "slow down ramp, stay in quick stop active", "quick stop ramp, stay in quick stop active",
    "current limit, stay in quick stop active", "voltage limit, stay in quick stop active",
    "Quick stop option code", "How the drive stops on the command quick stop.", "slow down ramp, then disable",
    "Shutdown option code", "How the drive gets from operation enabled to ready to switch on.",
    "Disable operation option code", "How the drive gets from operation enabled to switched on.",
    "slow down ramp", "quick stop ramp", "current limit", "voltage limit", "Halt option code",
    "How the drive stops when the halt bit of the controlword is set.", "Fault reaction option code",
    "How the drive stops when a fault occurs.", "mode", "no mode", "profile position", "velocity",
    "profile velocity", "torque profile", "homing", "interpolated position", "cyclic synchronous position",
    "cyclic synchronous velocity", "cyclic synchronous torque",
    "cyclic synchronous torque with commutation angle", "Modes of operation", "Selects the mode of operation.",
    "Modes of operation display", "The mode of operation that is active.", "Position demand value",
    "The position that the controller is to reach now.", "Position actual internal value",
    "The actual position in increments of the encoder.", "Position actual value",
    "The actual position in the unit of the user.", "Following error window",
    "How far the position may differ from the demand before a following error is reported.",
    "Following error time out", "How long it may do so before a following error is reported.", "Position window",
    "How close to the target the position must be to count as reached.", "Position window time",
    "How long it must be that close before the target is reported as reached.", "Velocity sensor actual value",
    "The speed as the sensor gives it.", "source of the velocity", "position encoder", "velocity encoder",
    "Sensor selection code", "Says which sensor the actual speed comes from.", "Velocity demand value",
    "The speed that the controller is to reach now.", "Velocity actual value", "The actual speed.",
    "Velocity window", "How close to the target velocity the speed must be to count as reached.",
    "Velocity window time", "How long it must be that close before the target velocity is reported as reached.",
    "Velocity threshold", "The speed above which the motor counts as moving.", "Velocity threshold time",
    "How long the speed must be above the threshold before the motor counts as moving.",
    "0.1 % of the rated torque", "Target torque",
    "The torque that profile torque or cyclic torque mode must reach.", "Max torque",
    "The highest torque that the motor may be given.", "0.1 % of the rated current", "Max current",
    "The highest current that the motor may be given.", "Torque demand",
    "The torque that the controller is to reach now.", "mA", "Motor rated current",
    "The rated current of the motor, to which relative currents refer.", "mNm", "Motor rated torque",
    "The rated torque of the motor, to which relative torques refer.", "Torque actual value",
    "The actual torque.", "Current actual value", "The actual current.", "mV", "DC link circuit voltage",
    "The voltage of the DC link.", "Target position",
    "The position that profile position or cyclic position mode must reach.", "Min position range limit",
    "Max position range limit", "Position range limit",
    "The range of position values; beyond an end they continue at the other one.", "Home offset",
    "The distance from the home position that homing finds to the zero of the application.",
    "Min position limit", "Max position limit", "Software position limit",
    "The lowest and the highest position that a target may have.", "velocity times -1", "position times -1",
    "Polarity", "Inverts position or velocity values.", "Max profile velocity",
    "The highest speed of a profile movement.", "rpm", "Max motor speed",
    "The highest speed that the motor may have.", "Profile velocity",
    "The speed of a positioning movement between its ramps.", "End velocity",
    "The speed with which a positioning movement arrives at its target.", "Profile acceleration",
    "The acceleration of a profile movement.", "Profile deceleration", "The deceleration of a profile movement.",
    "Quick stop deceleration", "The deceleration of a quick stop.", "shape", "linear ramp", "sin² ramp",
    "jerk-free ramp", "jerk-limited ramp", "Motion profile type",
    "The shape of the ramps of a profile movement.", "0.1 % of the rated torque per second", "Torque slope",
    "How fast the torque changes in profile torque mode.", "Torque profile type",
    "The shape of the torque ramp.", "Position notation index", "version 2",
    "The power of ten of the unit of positions (version 2 of the profile).", "Position dimension index",
    "The physical unit of positions (version 2 of the profile).", "Velocity notation index",
    "The power of ten of the unit of speeds (version 2 of the profile).", "Velocity dimension index",
    "The physical unit of speeds (version 2 of the profile).", "Acceleration notation index",
    "The power of ten of the unit of accelerations (version 2 of the profile).", "Acceleration dimension index",
    "The physical unit of accelerations (version 2 of the profile).", "Encoder increments", "Motor revolutions",
    "Position encoder resolution",
    "The resolution of the position encoder: increments for a number of revolutions of the motor.",
    "Encoder increments per second", "Motor revolutions per second", "Velocity encoder resolution",
    "The resolution of the velocity encoder: increments per second for a number of revolutions per second.",
    "Shaft revolutions", "Gear ratio", "The gear: revolutions of the motor for a number of those of the shaft.",
    "Feed", "Feed constant", "The distance that the load moves for a number of revolutions of the shaft.",
    "Numerator", "Position factor", "A fraction that converts positions between user and internal units.",
    "Divisor", "Velocity encoder factor",
    "A fraction that converts speeds between user units and those of the encoder.", "Velocity factor 1",
    "A fraction that converts speeds between motor and load.", "Velocity factor",
    "A fraction that converts speeds between user and internal units.", "Acceleration factor",
    "A fraction that converts accelerations between user and internal units.", "method", "no homing",
    "negative limit switch and index pulse", "positive limit switch and index pulse",
    "positive home switch and index pulse", "negative home switch and index pulse",
    "home switch and index pulse, starting positive", "home switch and index pulse, starting negative",
    "negative limit switch", "positive limit switch", "positive home switch", "negative home switch",
    "home switch, starting positive", "home switch, starting negative", "index pulse in negative direction",
    "index pulse in positive direction", "current position (version 2)", "current position", "Homing method",
    "Selects how the drive finds its home position.", "Speed during search for switch",
    "Speed during search for zero", "Homing speeds",
    "The speeds of homing: for the switch, then for the zero mark.", "Homing acceleration",
    "The acceleration and deceleration of homing.", "Jerk factor",
    "A fraction that converts jerk between user and internal units.", "Profile jerk use",
    "How many of the values in 60A4h the profile uses.", "Profile jerk 1", "Profile jerk 2 to 6", "Profile jerk",
    "The jerk of the sections of a profile movement.", "denominator", "numerator", "prefix, a power of 10",
    "SI unit position", "version 4", "The unit of positions.", "SI unit velocity", "The unit of speeds.",
    "SI unit acceleration", "The unit of accelerations.", "SI unit jerk", "The unit of jerk.", "Position offset",
    "Added to the demanded position in the cyclic modes.", "Velocity offset",
    "Added to the demanded speed in the cyclic modes.", "Torque offset",
    "Added to the demanded torque in the cyclic modes.", "touch probe 1 on", "touch probe 1 continuous",
    "touch probe 1 source", "input", "index pulse", "60D0h:1", "touch probe 1 samples positive edge",
    "touch probe 1 samples negative edge", "touch probe 2 on", "touch probe 2 continuous",
    "touch probe 2 source", "60D0h:2", "touch probe 2 samples positive edge",
    "touch probe 2 samples negative edge", "Touch probe function", "Selects what the two touch probes do.",
    "touch probe 1 has positive edge", "touch probe 1 has negative edge", "touch probe 2 has positive edge",
    "touch probe 2 has negative edge", "Touch probe status",
    "Shows whether the touch probes are on and what they have caught.", "Touch probe 1 positive edge",
    "The position at the rising edge of touch probe 1.", "Touch probe 1 negative edge",
    "The position at the falling edge of touch probe 1.", "Touch probe 2 positive edge",
    "The position at the rising edge of touch probe 2.", "Touch probe 2 negative edge",
    "The position at the falling edge of touch probe 2.", "interpolation", "linear interpolation",
    "Interpolation sub mode select",
    "Selects how interpolated position mode computes the path between set-points.", "Set-point 1",
    "Set-point 2 to 254", "Interpolation data record", "The set-points of interpolated position mode.",
    "Interpolation time period value", "Interpolation time index", "Interpolation time period",
    "The time between two set-points, as a number and a power of ten of a second.",
    "Interpolation sync definition",
    "What interpolated position mode is synchronised to (version 2 of the profile).", "Maximum buffer size",
    "Actual buffer size", "organization", "FIFO", "ring", "Buffer organization", "Buffer position",
    "Size of data record", "Buffer clear", "Interpolation data configuration",
    "The buffer of set-points: its size, its organisation and how full it is.", "Max acceleration",
    "The highest acceleration of any movement.", "Max deceleration", "The highest deceleration of any movement.",
    "Touch probe source", "Selects the signals that the touch probes watch.",
    "Touch probe time stamp 1 positive value", "The time of the rising edge of touch probe 1.",
    "Touch probe time stamp 1 negative value", "The time of the falling edge of touch probe 1.",
    "Touch probe time stamp 2 positive value", "The time of the rising edge of touch probe 2.",
    "Touch probe time stamp 2 negative value", "The time of the falling edge of touch probe 2.",
    "Touch probe 1 positive edge counter", "Counts the rising edges of touch probe 1.",
    "Touch probe 1 negative edge counter", "Counts the falling edges of touch probe 1.",
    "Touch probe 2 positive edge counter", "Counts the rising edges of touch probe 2.",
    "Touch probe 2 negative edge counter", "Counts the falling edges of touch probe 2.",
    "Positive torque limit value", "The highest torque in positive direction.", "Negative torque limit value",
    "The highest torque in negative direction.", "Supported homing methods",
    "Lists the homing methods that the drive supports.", "Additional position actual value",
    "The positions of further encoders.", "Additional velocity actual value", "The speeds of further encoders.",
    "Additional position encoder resolution, encoder increments",
    "The increments in the resolution of each further position encoder; 60EBh has the revolutions.",
    "Additional velocity encoder resolution, encoder increments per second",
    "The increments per second in the resolution of each further velocity encoder; 60ECh has the revolutions.",
    "Additional gear ratio, motor shaft revolutions",
    "The motor revolutions in the gear ratio of each further encoder; 60EDh has the shaft's.",
    "Additional feed constant, feed", "The feed of each further encoder; 60EEh has the shaft revolutions.",
    "Commutation angle",
    "The electrical angle of the field that the drive commutates with, for motors without a rotor position.",
    "Additional position encoder resolution, motor revolutions",
    "The motor revolutions in the resolution of each further position encoder.",
    "Additional velocity encoder resolution, motor revolutions per second",
    "The motor revolutions per second in the resolution of each further velocity encoder.",
    "Additional gear ratio, driving shaft revolutions",
    "The shaft revolutions in the gear ratio of each further encoder.",
    "Additional feed constant, driving shaft revolutions",
    "The shaft revolutions of the feed of each further encoder.", "relative to", "last target position",
    "position demand value", "position actual value", "change", "at once",
    "of the set-point at once, of the rest with the next one", "request and response", "rotary axis",
    "within one revolution like a linear axis", "always negative", "always positive", "shortest way", "reserved",
    "Positioning option code",
    "How a positioning movement is done: relative to what, at which moment, in which direction of a rotary axis.",
    "Following error actual value", "The difference between demanded and actual position.",
    "Torque control parameter set", "The parameters of the torque controller, which the vendor defines.",
    "Power stage parameters", "The parameters of the power stage, which the vendor defines.", "Max slippage",
    "How far the speed may differ from the demand before a slippage error is reported.",
    "Velocity control parameter set", "The parameters of the velocity controller, which the vendor defines.",
    "Control effort", "The output of the position controller.", "Position control parameter set",
    "The parameters of the position controller, which the vendor defines.", "Position demand internal value",
    "The demanded position in increments of the encoder.", "home switch", "interlock", "Digital inputs",
    "The state of the digital inputs, limit switches and home switch among them.", "set brake",
    "Physical outputs", "Bit mask", "Digital outputs", "Sets digital outputs; the bit mask says which of them.",
    "Target velocity", "The speed that profile velocity or cyclic velocity mode must reach.", "motor",
    "non-standard motor", "phase modulated DC motor", "frequency controlled DC motor",
    "permanent magnet synchronous motor", "frequency controlled synchronous motor", "switched reluctance motor",
    "wound rotor induction motor", "squirrel cage induction motor", "micro-step stepper motor",
    "brushless motor with sinusoidal commutation", "brushless motor with block commutation", "Motor type",
    "The type of the motor.", "Motor catalogue number", "The catalogue number of the motor.",
    "Motor manufacturer", "The manufacturer of the motor.", "HTTP motor catalogue address",
    "The web address of the motor's catalogue.", "Motor calibration date", "When the motor was last inspected.",
    "h", "Motor service period", "After how many hours the motor needs service.", "Motor data",
    "Data of the motor, which the vendor defines.", "Supported drive modes",
    "mandatory from version 3 on; version 2 left it to the drive",
    "The modes of operation that the drive supports, one bit each.", "Drive catalogue number",
    "The catalogue number of the drive.", "Drive manufacturer", "The manufacturer of the drive.",
    "HTTP drive catalogue address", "The web address of the drive's catalogue.", "Drive data",
    "Data of the drive, which the vendor defines.", "Version number",
    "The version of the profile that this axis follows.", "Single device type",
    "The device type of this axis: a drive, and of which kind.", "short circuit or earth leakage, input side",
    "earth leakage, input side", "earth leakage, phase L1", "earth leakage, phase L2", "earth leakage, phase L3",
    "short circuit, input side", "short circuit, phases L1 and L2", "short circuit, phases L2 and L3",
    "short circuit, phases L3 and L1", "internal current 1", "internal current 2",
    "over-current in the ramp function", "over-current in the sequence", "continuous over-current in the device",
    "continuous over-current 1 in the device", "continuous over-current 2 in the device",
    "short circuit or earth leakage in the device", "earth leakage in the device", "short circuit in the device",
    "continuous over-current, motor side", "continuous over-current 1, motor side",
    "continuous over-current 2, motor side", "short circuit or earth leakage, motor side",
    "earth leakage, motor side", "earth leakage, phase U", "earth leakage, phase V", "earth leakage, phase W",
    "short circuit, motor side", "short circuit, phases U and V", "short circuit, phases V and W",
    "short circuit, phases W and U", "overload (I2t, thermal state)", "overload (I2t, thermal state), warning",
    "mains over-voltage", "mains over-voltage, phase L1", "mains over-voltage, phase L2",
    "mains over-voltage, phase L3", "mains under-voltage", "mains under-voltage, phase L1",
    "mains under-voltage, phase L2", "mains under-voltage, phase L3", "phase failure", "phase failure, L1",
    "phase failure, L2", "phase failure, L3", "phase sequence", "mains frequency", "mains frequency too high",
    "mains frequency too low", "DC link over-voltage", "DC link over-voltage 1", "DC link over-voltage 2",
    "DC link under-voltage", "DC link under-voltage 1", "DC link under-voltage 2", "load error",
    "output over-voltage", "output over-voltage, phase U", "output over-voltage, phase V",
    "output over-voltage, phase W", "armature circuit", "armature circuit interrupted", "field circuit",
    "field circuit interrupted", "ambient temperature too high", "ambient temperature too low",
    "temperature of the supply air", "temperature of the air outlet", "device temperature too high",
    "device temperature too low", "temperature of the drive", "temperature of the drive too high",
    "temperature of the drive too low", "temperature of the supply", "temperature of the supply too high",
    "temperature of the supply too low", "supply", "low voltage of a supply", "low voltage of the 15 V supply",
    "low voltage of the 24 V supply", "low voltage of the 5 V supply",
    "low voltage of a supply of the manufacturer", "supply of the intermediate circuit", "control",
    "measuring circuit", "computing circuit", "operating unit", "power section", "output stages", "chopper",
    "input stages", "contacts", "contact of the manufacturer", "fuses", "fuse of the manufacturer",
    "data storage", "working memory", "program memory", "non-volatile data memory", "software reset (watchdog)",
    "data record", "loss of parameters", "parameter error", "power", "brake chopper",
    "failure of the brake chopper", "over-current of the brake chopper",
    "protective circuit of the brake chopper", "motor blocked", "motor error or wrong commutation",
    "motor tilted", "measuring circuit module", "sensor", "tachometer fault", "wrong polarity of the tachometer",
    "fault of resolver 1", "fault of resolver 2", "fault of incremental sensor 1",
    "fault of incremental sensor 2", "fault of incremental sensor 3", "speed", "position",
    "computing circuit module", "communication module", "serial interface 1", "serial interface 2",
    "data storage module", "torque control", "torque too high", "difficult start-up", "torque at standstill",
    "torque too low", "torque fault", "velocity controller", "position controller", "positioning controller",
    "following error", "reference limit", "synchronous controller", "winding controller",
    "process data monitoring", "control monitoring", "deceleration", "sub-synchronous run", "stroke operation",
    "shutdown", "0xxx x110", "0xxx 0111", "0xxx 1111", "disable operation", "0xxx x01x", "0xxx xx0x",
    "fault reset (bit 7 rises)", "1xxx xxxx", "start", "power-on or reset", "initialisation is done",
    "quick stop, disable voltage", "disable voltage, quick stop is done (605Ah is 0 to 4)", "any state",
    "a fault", "fault reaction is done", "enable operation (605Ah is 5 to 8)",
);
