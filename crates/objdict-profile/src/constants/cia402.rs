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
        errors: Part(121, 147),
        machine: Some(MachineRow { status: 24641, command: 24640 }),
    },
};

static OBJECTS: &[ObjectRow] = table!(ObjectRow { first, last, name, object_types, need, only, as_many_as, entries, source, about, confidence }:
    (4096, 4096, Part(93, 11), Part(0, 0), Optional, None, Part(0, 0), Part(0, 1), Part(0, 0), Part(104, 51), High) // 1000h Device type
    (24583, 24583, Part(230, 28), Part(0, 1), Optional, None, Part(0, 0), Part(1, 1), Part(0, 0), Part(258, 62), High) // 6007h Abort connection option code
    (24639, 24639, Part(320, 10), Part(0, 1), Optional, None, Part(0, 0), Part(2, 1), Part(0, 0), Part(330, 49), High) // 603Fh Error code
    (24640, 24640, Part(458, 11), Part(0, 1), Mandatory, None, Part(0, 0), Part(3, 1), Part(0, 0), Part(469, 75), High) // 6040h Controlword
    (24641, 24641, Part(741, 10), Part(0, 1), Mandatory, None, Part(0, 0), Part(4, 1), Part(0, 0), Part(751, 68), High) // 6041h Statusword
    (24642, 24642, Part(819, 18), Part(0, 1), When(0), None, Part(0, 0), Part(5, 1), Part(0, 0), Part(837, 45), High) // 6042h vl target velocity
    (24643, 24643, Part(882, 18), Part(0, 1), When(0), None, Part(0, 0), Part(6, 1), Part(0, 0), Part(900, 53), High) // 6043h vl velocity demand
    (24644, 24644, Part(953, 24), Part(0, 1), When(0), None, Part(0, 0), Part(6, 1), Part(0, 0), Part(977, 59), High) // 6044h vl velocity actual value
    (24645, 24645, Part(1036, 23), Part(0, 1), Optional, None, Part(0, 0), Part(7, 1), Part(0, 0), Part(1059, 63), High) // 6045h vl manipulated velocity
    (24646, 24646, Part(1193, 26), Part(1, 1), When(0), None, Part(0, 0), Part(8, 3), Part(0, 0), Part(1219, 71), High) // 6046h vl velocity min max amount
    (24647, 24647, Part(1290, 19), Part(1, 1), Optional, None, Part(0, 0), Part(0, 0), Part(0, 0), Part(1309, 70), High) // 6047h vl velocity min max
    (24648, 24648, Part(1401, 24), Part(2, 1), When(0), None, Part(0, 0), Part(11, 3), Part(0, 0), Part(1425, 81), High) // 6048h vl velocity acceleration
    (24649, 24649, Part(1506, 24), Part(2, 1), Optional, None, Part(0, 0), Part(11, 3), Part(0, 0), Part(1530, 81), High) // 6049h vl velocity deceleration
    (24650, 24650, Part(1611, 22), Part(2, 1), Optional, None, Part(0, 0), Part(11, 3), Part(0, 0), Part(1633, 79), High) // 604Ah vl velocity quick stop
    (24651, 24651, Part(1772, 19), Part(3, 2), Optional, None, Part(0, 0), Part(14, 3), Part(0, 0), Part(1791, 65), High) // 604Bh vl set-point factor
    (24652, 24652, Part(1916, 19), Part(3, 2), Optional, None, Part(0, 0), Part(17, 3), Part(0, 0), Part(1935, 76), High) // 604Ch vl dimension factor
    (24653, 24653, Part(2011, 14), Part(0, 1), Optional, None, Part(0, 0), Part(20, 1), Part(0, 0), Part(2025, 33), High) // 604Dh vl pole number
    (24654, 24654, Part(2058, 21), Part(0, 1), Optional, None, Part(0, 0), Part(21, 1), Part(0, 0), Part(2079, 53), High) // 604Eh vl velocity reference
    (24655, 24655, Part(2134, 21), Part(0, 1), Optional, None, Part(0, 0), Part(22, 1), Part(0, 0), Part(2155, 76), High) // 604Fh vl ramp function time
    (24656, 24656, Part(2231, 17), Part(0, 1), Optional, None, Part(0, 0), Part(22, 1), Part(0, 0), Part(2248, 76), High) // 6050h vl slow down time
    (24657, 24657, Part(2324, 18), Part(0, 1), Optional, None, Part(0, 0), Part(22, 1), Part(0, 0), Part(2342, 74), High) // 6051h vl quick stop time
    (24658, 24658, Part(2416, 21), Part(0, 1), Optional, None, Part(0, 0), Part(23, 1), Part(0, 0), Part(2437, 55), High) // 6052h vl nominal percentage
    (24659, 24659, Part(2492, 20), Part(0, 1), Optional, None, Part(0, 0), Part(6, 1), Part(0, 0), Part(2512, 50), High) // 6053h vl percentage demand
    (24660, 24660, Part(2562, 20), Part(0, 1), Optional, None, Part(0, 0), Part(6, 1), Part(0, 0), Part(2582, 44), High) // 6054h vl actual percentage
    (24661, 24661, Part(2626, 25), Part(0, 1), Optional, None, Part(0, 0), Part(6, 1), Part(0, 0), Part(2651, 47), High) // 6055h vl manipulated percentage
    (24662, 24662, Part(2698, 32), Part(0, 0), Optional, None, Part(0, 0), Part(0, 0), Part(0, 0), Part(2730, 77), High) // 6056h vl velocity motor min max amount
    (24663, 24663, Part(2807, 25), Part(0, 0), Optional, None, Part(0, 0), Part(0, 0), Part(0, 0), Part(2832, 76), High) // 6057h vl velocity motor min max
    (24664, 24664, Part(2908, 33), Part(0, 0), Optional, None, Part(0, 0), Part(0, 0), Part(0, 0), Part(2941, 81), High) // 6058h vl frequency motor min max amount
    (24665, 24665, Part(3022, 26), Part(0, 0), Optional, None, Part(0, 0), Part(0, 0), Part(0, 0), Part(3048, 80), High) // 6059h vl frequency motor min max
    (24666, 24666, Part(3468, 22), Part(0, 1), Optional, None, Part(0, 0), Part(24, 1), Part(0, 0), Part(3490, 46), High) // 605Ah Quick stop option code
    (24667, 24667, Part(3564, 20), Part(0, 1), Optional, None, Part(0, 0), Part(25, 1), Part(0, 0), Part(3584, 64), High) // 605Bh Shutdown option code
    (24668, 24668, Part(3648, 29), Part(0, 1), Optional, None, Part(0, 0), Part(26, 1), Part(0, 0), Part(3677, 57), High) // 605Ch Disable operation option code
    (24669, 24669, Part(3789, 16), Part(0, 1), Optional, None, Part(0, 0), Part(27, 1), Part(0, 0), Part(3805, 64), High) // 605Dh Halt option code
    (24670, 24670, Part(3869, 26), Part(0, 1), Optional, None, Part(0, 0), Part(28, 1), Part(0, 0), Part(3895, 40), High) // 605Eh Fault reaction option code
    (24672, 24672, Part(4154, 18), Part(0, 1), Optional, None, Part(0, 0), Part(29, 1), Part(0, 0), Part(4172, 30), High) // 6060h Modes of operation
    (24673, 24673, Part(4202, 26), Part(0, 1), Optional, None, Part(0, 0), Part(30, 1), Part(0, 0), Part(4228, 37), High) // 6061h Modes of operation display
    (24674, 24674, Part(4265, 21), Part(0, 1), Optional, None, Part(0, 0), Part(31, 1), Part(0, 0), Part(4286, 49), High) // 6062h Position demand value
    (24675, 24675, Part(4335, 30), Part(0, 1), Optional, None, Part(0, 0), Part(31, 1), Part(0, 0), Part(4365, 49), High) // 6063h Position actual internal value
    (24676, 24676, Part(4414, 21), Part(0, 1), When(1), None, Part(0, 0), Part(31, 1), Part(0, 0), Part(4435, 44), High) // 6064h Position actual value
    (24677, 24677, Part(4479, 22), Part(0, 1), Optional, None, Part(0, 0), Part(32, 1), Part(0, 0), Part(4501, 85), High) // 6065h Following error window
    (24678, 24678, Part(4586, 24), Part(0, 1), Optional, None, Part(0, 0), Part(33, 1), Part(0, 0), Part(4610, 59), High) // 6066h Following error time out
    (24679, 24679, Part(4669, 15), Part(0, 1), Optional, None, Part(0, 0), Part(21, 1), Part(0, 0), Part(4684, 65), High) // 6067h Position window
    (24680, 24680, Part(4749, 20), Part(0, 1), Optional, None, Part(0, 0), Part(33, 1), Part(0, 0), Part(4769, 72), High) // 6068h Position window time
    (24681, 24681, Part(4841, 28), Part(0, 1), Optional, None, Part(0, 0), Part(31, 1), Part(0, 0), Part(4869, 33), High) // 6069h Velocity sensor actual value
    (24682, 24682, Part(4956, 21), Part(0, 1), Optional, None, Part(0, 0), Part(34, 1), Part(0, 0), Part(4977, 46), High) // 606Ah Sensor selection code
    (24683, 24683, Part(5023, 21), Part(0, 1), Optional, None, Part(0, 0), Part(31, 1), Part(0, 0), Part(5044, 46), High) // 606Bh Velocity demand value
    (24684, 24684, Part(5090, 21), Part(0, 1), When(2), None, Part(0, 0), Part(31, 1), Part(0, 0), Part(5111, 17), High) // 606Ch Velocity actual value
    (24685, 24685, Part(5128, 15), Part(0, 1), Optional, None, Part(0, 0), Part(35, 1), Part(0, 0), Part(5143, 71), High) // 606Dh Velocity window
    (24686, 24686, Part(5214, 20), Part(0, 1), Optional, None, Part(0, 0), Part(33, 1), Part(0, 0), Part(5234, 81), High) // 606Eh Velocity window time
    (24687, 24687, Part(5315, 18), Part(0, 1), Optional, None, Part(0, 0), Part(35, 1), Part(0, 0), Part(5333, 49), High) // 606Fh Velocity threshold
    (24688, 24688, Part(5382, 23), Part(0, 1), Optional, None, Part(0, 0), Part(33, 1), Part(0, 0), Part(5405, 81), High) // 6070h Velocity threshold time
    (24689, 24689, Part(5511, 13), Part(0, 1), When(3), None, Part(0, 0), Part(36, 1), Part(0, 0), Part(5524, 64), High) // 6071h Target torque
    (24690, 24690, Part(5588, 10), Part(0, 1), Optional, None, Part(0, 0), Part(37, 1), Part(0, 0), Part(5598, 47), High) // 6072h Max torque
    (24691, 24691, Part(5671, 11), Part(0, 1), Optional, None, Part(0, 0), Part(38, 1), Part(0, 0), Part(5682, 48), High) // 6073h Max current
    (24692, 24692, Part(5730, 13), Part(0, 1), Optional, None, Part(0, 0), Part(39, 1), Part(0, 0), Part(5743, 47), High) // 6074h Torque demand
    (24693, 24693, Part(5792, 19), Part(0, 1), Optional, None, Part(0, 0), Part(40, 1), Part(0, 0), Part(5811, 65), High) // 6075h Motor rated current
    (24694, 24694, Part(5879, 18), Part(0, 1), Optional, None, Part(0, 0), Part(41, 1), Part(0, 0), Part(5897, 63), High) // 6076h Motor rated torque
    (24695, 24695, Part(5960, 19), Part(0, 1), When(4), None, Part(0, 0), Part(39, 1), Part(0, 0), Part(5979, 18), High) // 6077h Torque actual value
    (24696, 24696, Part(5997, 20), Part(0, 1), Optional, None, Part(0, 0), Part(42, 1), Part(0, 0), Part(6017, 19), High) // 6078h Current actual value
    (24697, 24697, Part(6038, 23), Part(0, 1), Optional, None, Part(0, 0), Part(43, 1), Part(0, 0), Part(6061, 27), High) // 6079h DC link circuit voltage
    (24698, 24698, Part(6088, 15), Part(0, 1), When(5), None, Part(0, 0), Part(44, 1), Part(0, 0), Part(6103, 70), High) // 607Ah Target position
    (24699, 24699, Part(6221, 20), Part(3, 2), Optional, None, Part(0, 0), Part(45, 3), Part(0, 0), Part(6241, 75), High) // 607Bh Position range limit
    (24700, 24700, Part(6316, 11), Part(0, 1), Optional, None, Part(0, 0), Part(44, 1), Part(0, 0), Part(6327, 85), High) // 607Ch Home offset
    (24701, 24701, Part(6448, 23), Part(3, 2), Optional, None, Part(0, 0), Part(48, 3), Part(0, 0), Part(6471, 59), High) // 607Dh Software position limit
    (24702, 24702, Part(6564, 8), Part(0, 1), Optional, None, Part(0, 0), Part(51, 1), Part(0, 0), Part(6572, 36), High) // 607Eh Polarity
    (24703, 24703, Part(6608, 20), Part(0, 1), Optional, None, Part(0, 0), Part(21, 1), Part(0, 0), Part(6628, 40), High) // 607Fh Max profile velocity
    (24704, 24704, Part(6671, 15), Part(0, 1), Optional, None, Part(0, 0), Part(52, 1), Part(0, 0), Part(6686, 42), High) // 6080h Max motor speed
    (24705, 24705, Part(6728, 16), Part(0, 1), When(6), None, Part(0, 0), Part(32, 1), Part(0, 0), Part(6744, 54), High) // 6081h Profile velocity
    (24706, 24706, Part(6798, 12), Part(0, 1), Optional, None, Part(0, 0), Part(21, 1), Part(0, 0), Part(6810, 66), High) // 6082h End velocity
    (24707, 24707, Part(6876, 20), Part(0, 1), When(7), None, Part(0, 0), Part(32, 1), Part(0, 0), Part(6896, 39), High) // 6083h Profile acceleration
    (24708, 24708, Part(6935, 20), Part(0, 1), Optional, None, Part(0, 0), Part(32, 1), Part(0, 0), Part(6955, 39), High) // 6084h Profile deceleration
    (24709, 24709, Part(6994, 23), Part(0, 1), Optional, None, Part(0, 0), Part(32, 1), Part(0, 0), Part(7017, 33), High) // 6085h Quick stop deceleration
    (24710, 24710, Part(7107, 19), Part(0, 1), Optional, None, Part(0, 0), Part(53, 1), Part(0, 0), Part(7126, 45), High) // 6086h Motion profile type
    (24711, 24711, Part(7207, 12), Part(0, 1), When(8), None, Part(0, 0), Part(54, 1), Part(0, 0), Part(7219, 51), High) // 6087h Torque slope
    (24712, 24712, Part(7270, 19), Part(0, 1), Optional, None, Part(0, 0), Part(55, 1), Part(0, 0), Part(7289, 29), High) // 6088h Torque profile type
    (24713, 24713, Part(7318, 23), Part(0, 1), Optional, None, Part(0, 0), Part(56, 1), Part(7341, 9), Part(7350, 69), Medium) // 6089h Position notation index
    (24714, 24714, Part(7419, 24), Part(0, 1), Optional, None, Part(0, 0), Part(20, 1), Part(7341, 9), Part(7443, 58), Medium) // 608Ah Position dimension index
    (24715, 24715, Part(7501, 23), Part(0, 1), Optional, None, Part(0, 0), Part(56, 1), Part(7341, 9), Part(7524, 66), Medium) // 608Bh Velocity notation index
    (24716, 24716, Part(7590, 24), Part(0, 1), Optional, None, Part(0, 0), Part(20, 1), Part(7341, 9), Part(7614, 55), Medium) // 608Ch Velocity dimension index
    (24717, 24717, Part(7669, 27), Part(0, 1), Optional, None, Part(0, 0), Part(56, 1), Part(7341, 9), Part(7696, 73), Medium) // 608Dh Acceleration notation index
    (24718, 24718, Part(7769, 28), Part(0, 1), Optional, None, Part(0, 0), Part(20, 1), Part(7341, 9), Part(7797, 62), Medium) // 608Eh Acceleration dimension index
    (24719, 24719, Part(7894, 27), Part(3, 2), Optional, None, Part(0, 0), Part(57, 3), Part(0, 0), Part(7921, 92), High) // 608Fh Position encoder resolution
    (24720, 24720, Part(8070, 27), Part(3, 2), Optional, None, Part(0, 0), Part(60, 3), Part(0, 0), Part(8097, 101), High) // 6090h Velocity encoder resolution
    (24721, 24721, Part(8215, 10), Part(3, 2), Optional, None, Part(0, 0), Part(63, 3), Part(0, 0), Part(8225, 70), High) // 6091h Gear ratio
    (24722, 24722, Part(8299, 13), Part(3, 2), Optional, None, Part(0, 0), Part(66, 3), Part(0, 0), Part(8312, 74), High) // 6092h Feed constant
    (24723, 24723, Part(8395, 15), Part(3, 2), Optional, None, Part(0, 0), Part(69, 3), Part(0, 0), Part(8410, 67), High) // 6093h Position factor
    (24724, 24724, Part(8484, 23), Part(3, 2), Optional, None, Part(0, 0), Part(72, 3), Part(0, 0), Part(8507, 76), High) // 6094h Velocity encoder factor
    (24725, 24725, Part(8583, 17), Part(3, 2), Optional, None, Part(0, 0), Part(72, 3), Part(0, 0), Part(8600, 55), High) // 6095h Velocity factor 1
    (24726, 24726, Part(8655, 15), Part(3, 2), Optional, None, Part(0, 0), Part(72, 3), Part(0, 0), Part(8670, 64), High) // 6096h Velocity factor
    (24727, 24727, Part(8734, 19), Part(3, 2), Optional, None, Part(0, 0), Part(72, 3), Part(0, 0), Part(8753, 71), High) // 6097h Acceleration factor
    (24728, 24728, Part(9329, 13), Part(0, 1), When(9), None, Part(0, 0), Part(75, 1), Part(0, 0), Part(9342, 46), High) // 6098h Homing method
    (24729, 24729, Part(9446, 13), Part(3, 2), When(9), None, Part(0, 0), Part(76, 3), Part(0, 0), Part(9459, 61), High) // 6099h Homing speeds
    (24730, 24730, Part(9520, 19), Part(0, 1), Optional, None, Part(0, 0), Part(32, 1), Part(0, 0), Part(9539, 44), High) // 609Ah Homing acceleration
    (24738, 24738, Part(9583, 11), Part(3, 2), Optional, None, Part(0, 0), Part(72, 3), Part(0, 0), Part(9594, 62), High) // 60A2h Jerk factor
    (24739, 24739, Part(9656, 16), Part(0, 1), Optional, None, Part(0, 0), Part(79, 1), Part(0, 0), Part(9672, 49), High) // 60A3h Profile jerk use
    (24740, 24740, Part(9754, 12), Part(3, 2), Optional, None, Part(0, 0), Part(80, 3), Part(0, 0), Part(9766, 47), High) // 60A4h Profile jerk
    (24744, 24744, Part(9854, 16), Part(0, 1), Optional, None, Part(0, 0), Part(83, 1), Part(9870, 9), Part(9879, 22), Medium) // 60A8h SI unit position
    (24745, 24745, Part(9901, 16), Part(0, 1), Optional, None, Part(0, 0), Part(83, 1), Part(9870, 9), Part(9917, 19), Medium) // 60A9h SI unit velocity
    (24746, 24746, Part(9936, 20), Part(0, 1), Optional, None, Part(0, 0), Part(83, 1), Part(9870, 9), Part(9956, 26), Medium) // 60AAh SI unit acceleration
    (24747, 24747, Part(9982, 12), Part(0, 1), Optional, None, Part(0, 0), Part(83, 1), Part(9870, 9), Part(9994, 17), Medium) // 60ABh SI unit jerk
    (24752, 24752, Part(10011, 15), Part(0, 1), Optional, None, Part(0, 0), Part(44, 1), Part(0, 0), Part(10026, 51), High) // 60B0h Position offset
    (24753, 24753, Part(10077, 15), Part(0, 1), Optional, None, Part(0, 0), Part(44, 1), Part(0, 0), Part(10092, 48), High) // 60B1h Velocity offset
    (24754, 24754, Part(10140, 13), Part(0, 1), Optional, None, Part(0, 0), Part(36, 1), Part(0, 0), Part(10153, 49), High) // 60B2h Torque offset
    (24760, 24760, Part(10492, 20), Part(0, 1), Optional, None, Part(0, 0), Part(84, 1), Part(0, 0), Part(10512, 37), High) // 60B8h Touch probe function
    (24761, 24761, Part(10673, 18), Part(0, 1), Optional, None, Part(0, 0), Part(85, 1), Part(0, 0), Part(10691, 64), High) // 60B9h Touch probe status
    (24762, 24762, Part(10755, 27), Part(0, 1), Optional, None, Part(0, 0), Part(31, 1), Part(0, 0), Part(10782, 49), High) // 60BAh Touch probe 1 positive edge
    (24763, 24763, Part(10831, 27), Part(0, 1), Optional, None, Part(0, 0), Part(31, 1), Part(0, 0), Part(10858, 50), High) // 60BBh Touch probe 1 negative edge
    (24764, 24764, Part(10908, 27), Part(0, 1), Optional, None, Part(0, 0), Part(31, 1), Part(0, 0), Part(10935, 49), High) // 60BCh Touch probe 2 positive edge
    (24765, 24765, Part(10984, 27), Part(0, 1), Optional, None, Part(0, 0), Part(31, 1), Part(0, 0), Part(11011, 50), High) // 60BDh Touch probe 2 negative edge
    (24768, 24768, Part(11094, 29), Part(0, 1), Optional, None, Part(0, 0), Part(86, 1), Part(0, 0), Part(11123, 76), High) // 60C0h Interpolation sub mode select
    (24769, 24769, Part(11228, 25), Part(3, 2), Optional, None, Part(0, 0), Part(87, 3), Part(0, 0), Part(11253, 45), High) // 60C1h Interpolation data record
    (24770, 24770, Part(11353, 25), Part(2, 1), When(10), None, Part(0, 0), Part(90, 3), Part(0, 0), Part(11378, 76), High) // 60C2h Interpolation time period
    (24771, 24771, Part(11454, 29), Part(3, 2), Optional, None, Part(0, 0), Part(0, 0), Part(0, 0), Part(11483, 78), High) // 60C3h Interpolation sync definition
    (24772, 24772, Part(11683, 32), Part(2, 1), Optional, None, Part(0, 0), Part(93, 7), Part(0, 0), Part(11715, 72), High) // 60C4h Interpolation data configuration
    (24773, 24773, Part(11787, 16), Part(0, 1), Optional, None, Part(0, 0), Part(21, 1), Part(0, 0), Part(11803, 41), High) // 60C5h Max acceleration
    (24774, 24774, Part(11844, 16), Part(0, 1), Optional, None, Part(0, 0), Part(21, 1), Part(0, 0), Part(11860, 41), High) // 60C6h Max deceleration
    (24784, 24784, Part(11901, 18), Part(3, 2), Optional, None, Part(0, 0), Part(0, 0), Part(0, 0), Part(11919, 48), High) // 60D0h Touch probe source
    (24785, 24785, Part(11967, 39), Part(0, 1), Optional, None, Part(0, 0), Part(0, 0), Part(0, 0), Part(12006, 45), High) // 60D1h Touch probe time stamp 1 positive value
    (24786, 24786, Part(12051, 39), Part(0, 1), Optional, None, Part(0, 0), Part(0, 0), Part(0, 0), Part(12090, 46), High) // 60D2h Touch probe time stamp 1 negative value
    (24787, 24787, Part(12136, 39), Part(0, 1), Optional, None, Part(0, 0), Part(0, 0), Part(0, 0), Part(12175, 45), High) // 60D3h Touch probe time stamp 2 positive value
    (24788, 24788, Part(12220, 39), Part(0, 1), Optional, None, Part(0, 0), Part(0, 0), Part(0, 0), Part(12259, 46), High) // 60D4h Touch probe time stamp 2 negative value
    (24789, 24789, Part(12305, 35), Part(0, 1), Optional, None, Part(0, 0), Part(0, 0), Part(0, 0), Part(12340, 41), High) // 60D5h Touch probe 1 positive edge counter
    (24790, 24790, Part(12381, 35), Part(0, 1), Optional, None, Part(0, 0), Part(0, 0), Part(0, 0), Part(12416, 42), High) // 60D6h Touch probe 1 negative edge counter
    (24791, 24791, Part(12458, 35), Part(0, 1), Optional, None, Part(0, 0), Part(0, 0), Part(0, 0), Part(12493, 41), High) // 60D7h Touch probe 2 positive edge counter
    (24792, 24792, Part(12534, 35), Part(0, 1), Optional, None, Part(0, 0), Part(0, 0), Part(0, 0), Part(12569, 42), High) // 60D8h Touch probe 2 negative edge counter
    (24800, 24800, Part(12611, 27), Part(0, 1), Optional, None, Part(0, 0), Part(100, 1), Part(9870, 9), Part(12638, 41), Medium) // 60E0h Positive torque limit value
    (24801, 24801, Part(12679, 27), Part(0, 1), Optional, None, Part(0, 0), Part(100, 1), Part(9870, 9), Part(12706, 41), Medium) // 60E1h Negative torque limit value
    (24803, 24803, Part(12747, 24), Part(3, 2), Optional, None, Part(0, 0), Part(101, 3), Part(9870, 9), Part(12771, 49), Medium) // 60E3h Supported homing methods
    (24804, 24804, Part(12820, 32), Part(3, 2), Optional, None, Part(0, 0), Part(104, 3), Part(9870, 9), Part(12852, 34), Medium) // 60E4h Additional position actual value
    (24805, 24805, Part(12886, 32), Part(3, 2), Optional, None, Part(0, 0), Part(107, 3), Part(9870, 9), Part(12918, 31), Medium) // 60E5h Additional velocity actual value
    (24806, 24806, Part(12949, 58), Part(3, 2), Optional, None, Part(0, 0), Part(0, 0), Part(0, 0), Part(13007, 93), High) // 60E6h Additional position encoder resolution, encoder increments
    (24807, 24807, Part(13100, 69), Part(3, 2), Optional, None, Part(0, 0), Part(0, 0), Part(0, 0), Part(13169, 104), High) // 60E7h Additional velocity encoder resolution, encoder increments per second
    (24808, 24808, Part(13273, 46), Part(3, 2), Optional, None, Part(0, 0), Part(0, 0), Part(0, 0), Part(13319, 87), High) // 60E8h Additional gear ratio, motor shaft revolutions
    (24809, 24809, Part(13406, 30), Part(3, 2), Optional, None, Part(0, 0), Part(0, 0), Part(0, 0), Part(13436, 66), High) // 60E9h Additional feed constant, feed
    (24810, 24810, Part(13502, 17), Part(0, 1), When(11), None, Part(0, 0), Part(110, 1), Part(9870, 9), Part(13519, 102), Medium) // 60EAh Commutation angle
    (24811, 24811, Part(13621, 57), Part(3, 2), Optional, None, Part(0, 0), Part(0, 0), Part(0, 0), Part(13678, 73), High) // 60EBh Additional position encoder resolution, motor revolutions
    (24812, 24812, Part(13751, 68), Part(3, 2), Optional, None, Part(0, 0), Part(0, 0), Part(0, 0), Part(13819, 84), High) // 60ECh Additional velocity encoder resolution, motor revolutions per second
    (24813, 24813, Part(13903, 48), Part(3, 2), Optional, None, Part(0, 0), Part(0, 0), Part(0, 0), Part(13951, 64), High) // 60EDh Additional gear ratio, driving shaft revolutions
    (24814, 24814, Part(14015, 51), Part(3, 2), Optional, None, Part(0, 0), Part(0, 0), Part(0, 0), Part(14066, 58), High) // 60EEh Additional feed constant, driving shaft revolutions
    (24818, 24818, Part(14386, 23), Part(0, 1), Optional, None, Part(0, 0), Part(111, 1), Part(0, 0), Part(14409, 107), High) // 60F2h Positioning option code
    (24820, 24820, Part(14516, 28), Part(0, 1), Optional, None, Part(0, 0), Part(31, 1), Part(0, 0), Part(14544, 52), High) // 60F4h Following error actual value
    (24822, 24822, Part(14596, 28), Part(0, 0), Optional, None, Part(0, 0), Part(0, 0), Part(0, 0), Part(14624, 66), High) // 60F6h Torque control parameter set
    (24823, 24823, Part(14690, 22), Part(0, 0), Optional, None, Part(0, 0), Part(0, 0), Part(0, 0), Part(14712, 60), High) // 60F7h Power stage parameters
    (24824, 24824, Part(14772, 12), Part(0, 1), Optional, None, Part(0, 0), Part(112, 1), Part(0, 0), Part(14784, 81), High) // 60F8h Max slippage
    (24825, 24825, Part(14865, 30), Part(0, 0), Optional, None, Part(0, 0), Part(0, 0), Part(0, 0), Part(14895, 68), High) // 60F9h Velocity control parameter set
    (24826, 24826, Part(14963, 14), Part(0, 1), Optional, None, Part(0, 0), Part(31, 1), Part(0, 0), Part(14977, 38), High) // 60FAh Control effort
    (24827, 24827, Part(15015, 30), Part(0, 0), Optional, None, Part(0, 0), Part(0, 0), Part(0, 0), Part(15045, 68), High) // 60FBh Position control parameter set
    (24828, 24828, Part(15113, 30), Part(0, 1), Optional, None, Part(0, 0), Part(31, 1), Part(0, 0), Part(15143, 51), High) // 60FCh Position demand internal value
    (24829, 24829, Part(15214, 14), Part(0, 1), Optional, None, Part(0, 0), Part(113, 1), Part(0, 0), Part(15228, 75), High) // 60FDh Digital inputs
    (24830, 24830, Part(15336, 15), Part(3, 2), Optional, None, Part(0, 0), Part(114, 3), Part(0, 0), Part(15351, 54), High) // 60FEh Digital outputs
    (24831, 24831, Part(15405, 15), Part(0, 1), When(2), None, Part(0, 0), Part(44, 1), Part(0, 0), Part(15420, 67), High) // 60FFh Target velocity
    (25602, 25602, Part(15821, 10), Part(0, 1), Optional, None, Part(0, 0), Part(117, 1), Part(0, 0), Part(15831, 22), High) // 6402h Motor type
    (25603, 25603, Part(15853, 22), Part(0, 1), Optional, None, Part(0, 0), Part(118, 1), Part(0, 0), Part(15875, 34), High) // 6403h Motor catalogue number
    (25604, 25604, Part(15909, 18), Part(0, 1), Optional, None, Part(0, 0), Part(118, 1), Part(0, 0), Part(15927, 30), High) // 6404h Motor manufacturer
    (25605, 25605, Part(15957, 28), Part(0, 1), Optional, None, Part(0, 0), Part(118, 1), Part(0, 0), Part(15985, 41), High) // 6405h HTTP motor catalogue address
    (25606, 25606, Part(16026, 22), Part(0, 1), Optional, None, Part(0, 0), Part(119, 1), Part(0, 0), Part(16048, 34), High) // 6406h Motor calibration date
    (25607, 25607, Part(16083, 20), Part(0, 1), Optional, None, Part(0, 0), Part(120, 1), Part(0, 0), Part(16103, 45), High) // 6407h Motor service period
    (25616, 25616, Part(16148, 10), Part(0, 0), Optional, None, Part(0, 0), Part(0, 0), Part(0, 0), Part(16158, 44), High) // 6410h Motor data
    (25858, 25858, Part(16202, 21), Part(0, 1), Optional, None, Part(0, 0), Part(121, 1), Part(16223, 59), Part(16282, 61), High) // 6502h Supported drive modes
    (25859, 25859, Part(16343, 22), Part(0, 1), Optional, None, Part(0, 0), Part(118, 1), Part(0, 0), Part(16365, 34), High) // 6503h Drive catalogue number
    (25860, 25860, Part(16399, 18), Part(0, 1), Optional, None, Part(0, 0), Part(118, 1), Part(0, 0), Part(16417, 30), High) // 6504h Drive manufacturer
    (25861, 25861, Part(16447, 28), Part(0, 1), Optional, None, Part(0, 0), Part(118, 1), Part(0, 0), Part(16475, 41), High) // 6505h HTTP drive catalogue address
    (25872, 25872, Part(16516, 10), Part(0, 0), Optional, None, Part(0, 0), Part(0, 0), Part(0, 0), Part(16526, 44), High) // 6510h Drive data
    (26622, 26622, Part(16570, 14), Part(0, 1), Optional, None, Part(0, 0), Part(0, 0), Part(0, 0), Part(16584, 50), High) // 67FEh Version number
    (26623, 26623, Part(16634, 18), Part(0, 1), Optional, None, Part(0, 0), Part(122, 1), Part(0, 0), Part(16652, 57), High) // 67FFh Single device type
);

static ENTRIES: &[EntryRow] = table!(EntryRow { first, last, mapping, need, name, data_types, access, values, default, unit, bits }:
    (0, 0, None, Optional, Part(0, 0), Part(0, 0), Part(0, 0), Part(0, 0), None, Part(0, 0), Part(0, 5))
    (0, 0, Some(No), Mandatory, Part(0, 0), Part(0, 1), Part(0, 1), Part(0, 1), None, Part(0, 0), Part(5, 1))
    (0, 0, Some(Tpdo), Mandatory, Part(0, 0), Part(1, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0))
    (0, 0, Some(Any), Mandatory, Part(0, 0), Part(1, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(6, 9))
    (0, 0, Some(Tpdo), Mandatory, Part(0, 0), Part(1, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(15, 15))
    (0, 0, Some(Any), Mandatory, Part(0, 0), Part(0, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0))
    (0, 0, Some(Tpdo), Mandatory, Part(0, 0), Part(0, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0))
    (0, 0, None, Mandatory, Part(0, 0), Part(0, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0))
    (0, 0, None, Mandatory, Part(1122, 27), Part(2, 1), Part(2, 2), Part(1, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, Part(1149, 22), Part(3, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // vl velocity min amount
    (2, 2, None, Mandatory, Part(1171, 22), Part(3, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // vl velocity max amount
    (0, 0, None, Mandatory, Part(1122, 27), Part(2, 1), Part(2, 2), Part(1, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, Part(1379, 11), Part(3, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Delta speed
    (2, 2, None, Mandatory, Part(1390, 10), Part(1, 1), Part(0, 1), Part(0, 0), None, Part(1400, 1), Part(0, 0)) // Delta time
    (0, 0, None, Mandatory, Part(1122, 27), Part(2, 1), Part(2, 2), Part(1, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, Part(1712, 29), Part(0, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // vl set-point factor numerator
    (2, 2, None, Mandatory, Part(1741, 31), Part(0, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // vl set-point factor denominator
    (0, 0, None, Mandatory, Part(1122, 27), Part(2, 1), Part(2, 2), Part(1, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, Part(1856, 29), Part(4, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // vl dimension factor numerator
    (2, 2, None, Mandatory, Part(1885, 31), Part(4, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // vl dimension factor denominator
    (0, 0, None, Mandatory, Part(0, 0), Part(2, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0))
    (0, 0, None, Mandatory, Part(0, 0), Part(3, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0))
    (0, 0, None, Mandatory, Part(0, 0), Part(3, 1), Part(0, 1), Part(0, 0), None, Part(2132, 2), Part(0, 0))
    (0, 0, None, Mandatory, Part(0, 0), Part(0, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0))
    (0, 0, Some(No), Mandatory, Part(0, 0), Part(0, 1), Part(0, 1), Part(2, 1), Some(0), Part(0, 0), Part(30, 1))
    (0, 0, Some(No), Mandatory, Part(0, 0), Part(0, 1), Part(0, 1), Part(3, 1), Some(1), Part(0, 0), Part(31, 1))
    (0, 0, Some(No), Mandatory, Part(0, 0), Part(0, 1), Part(0, 1), Part(3, 1), Some(2), Part(0, 0), Part(31, 1))
    (0, 0, Some(No), Mandatory, Part(0, 0), Part(0, 1), Part(0, 1), Part(4, 1), Some(2), Part(0, 0), Part(32, 1))
    (0, 0, Some(No), Mandatory, Part(0, 0), Part(0, 1), Part(0, 1), Part(4, 1), Some(0), Part(0, 0), Part(32, 1))
    (0, 0, Some(Any), Mandatory, Part(0, 0), Part(5, 1), Part(4, 2), Part(5, 2), None, Part(0, 0), Part(33, 1))
    (0, 0, Some(Tpdo), Mandatory, Part(0, 0), Part(5, 1), Part(1, 1), Part(5, 2), None, Part(0, 0), Part(33, 1))
    (0, 0, Some(Tpdo), Mandatory, Part(0, 0), Part(4, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0))
    (0, 0, Some(Any), Mandatory, Part(0, 0), Part(3, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0))
    (0, 0, None, Mandatory, Part(0, 0), Part(1, 1), Part(0, 1), Part(0, 0), None, Part(2132, 2), Part(0, 0))
    (0, 0, Some(No), Mandatory, Part(0, 0), Part(0, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(34, 1))
    (0, 0, None, Mandatory, Part(0, 0), Part(1, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0))
    (0, 0, Some(Any), Mandatory, Part(0, 0), Part(0, 1), Part(0, 1), Part(0, 0), None, Part(5486, 25), Part(0, 0))
    (0, 0, Some(Any), Mandatory, Part(0, 0), Part(1, 1), Part(0, 1), Part(0, 0), None, Part(5486, 25), Part(0, 0))
    (0, 0, None, Mandatory, Part(0, 0), Part(1, 1), Part(0, 1), Part(0, 0), None, Part(5645, 26), Part(0, 0))
    (0, 0, Some(Tpdo), Mandatory, Part(0, 0), Part(0, 1), Part(1, 1), Part(0, 0), None, Part(5486, 25), Part(0, 0))
    (0, 0, None, Mandatory, Part(0, 0), Part(3, 1), Part(6, 2), Part(0, 0), None, Part(5790, 2), Part(0, 0))
    (0, 0, None, Mandatory, Part(0, 0), Part(3, 1), Part(6, 2), Part(0, 0), None, Part(5876, 3), Part(0, 0))
    (0, 0, Some(Tpdo), Mandatory, Part(0, 0), Part(0, 1), Part(1, 1), Part(0, 0), None, Part(5645, 26), Part(0, 0))
    (0, 0, Some(Tpdo), Mandatory, Part(0, 0), Part(3, 1), Part(1, 1), Part(0, 0), None, Part(6036, 2), Part(0, 0))
    (0, 0, Some(Any), Mandatory, Part(0, 0), Part(4, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0))
    (0, 0, None, Mandatory, Part(1122, 27), Part(2, 1), Part(2, 2), Part(1, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, Part(6173, 24), Part(4, 1), Part(6, 2), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Min position range limit
    (2, 2, None, Mandatory, Part(6197, 24), Part(4, 1), Part(6, 2), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Max position range limit
    (0, 0, None, Mandatory, Part(1122, 27), Part(2, 1), Part(2, 2), Part(1, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, Part(6412, 18), Part(4, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Min position limit
    (2, 2, None, Mandatory, Part(6430, 18), Part(4, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Max position limit
    (0, 0, None, Mandatory, Part(0, 0), Part(2, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(35, 2))
    (0, 0, None, Mandatory, Part(0, 0), Part(3, 1), Part(0, 1), Part(0, 0), None, Part(6668, 3), Part(0, 0))
    (0, 0, Some(Any), Mandatory, Part(0, 0), Part(0, 1), Part(0, 1), Part(0, 1), None, Part(0, 0), Part(37, 1))
    (0, 0, Some(Any), Mandatory, Part(0, 0), Part(3, 1), Part(0, 1), Part(0, 0), None, Part(7171, 36), Part(0, 0))
    (0, 0, None, Mandatory, Part(0, 0), Part(0, 1), Part(0, 1), Part(3, 1), None, Part(0, 0), Part(38, 1))
    (0, 0, None, Mandatory, Part(0, 0), Part(5, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0))
    (0, 0, None, Mandatory, Part(1122, 27), Part(2, 1), Part(2, 2), Part(1, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, Part(7859, 18), Part(3, 1), Part(6, 2), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Encoder increments
    (2, 2, None, Mandatory, Part(7877, 17), Part(3, 1), Part(6, 2), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Motor revolutions
    (0, 0, None, Mandatory, Part(1122, 27), Part(2, 1), Part(2, 2), Part(1, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, Part(8013, 29), Part(3, 1), Part(6, 2), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Encoder increments per second
    (2, 2, None, Mandatory, Part(8042, 28), Part(3, 1), Part(6, 2), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Motor revolutions per second
    (0, 0, None, Mandatory, Part(1122, 27), Part(2, 1), Part(2, 2), Part(1, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, Part(7877, 17), Part(3, 1), Part(6, 2), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Motor revolutions
    (2, 2, None, Mandatory, Part(8198, 17), Part(3, 1), Part(6, 2), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Shaft revolutions
    (0, 0, None, Mandatory, Part(1122, 27), Part(2, 1), Part(2, 2), Part(1, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, Part(8295, 4), Part(3, 1), Part(6, 2), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Feed
    (2, 2, None, Mandatory, Part(8198, 17), Part(3, 1), Part(6, 2), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Shaft revolutions
    (0, 0, None, Mandatory, Part(1122, 27), Part(2, 1), Part(2, 2), Part(1, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, Part(8386, 9), Part(3, 1), Part(6, 2), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Numerator
    (2, 2, None, Mandatory, Part(8299, 13), Part(3, 1), Part(6, 2), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Feed constant
    (0, 0, None, Mandatory, Part(1122, 27), Part(2, 1), Part(2, 2), Part(1, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, Part(8386, 9), Part(3, 1), Part(6, 2), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Numerator
    (2, 2, None, Mandatory, Part(8477, 7), Part(3, 1), Part(6, 2), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Divisor
    (0, 0, Some(Any), Mandatory, Part(0, 0), Part(5, 1), Part(0, 1), Part(7, 4), None, Part(0, 0), Part(39, 1))
    (0, 0, None, Mandatory, Part(1122, 27), Part(2, 1), Part(2, 2), Part(1, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, Part(9388, 30), Part(3, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Speed during search for switch
    (2, 2, Some(Any), Mandatory, Part(9418, 28), Part(3, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Speed during search for zero
    (0, 0, None, Mandatory, Part(0, 0), Part(2, 1), Part(0, 1), Part(11, 4), None, Part(0, 0), Part(0, 0))
    (0, 0, None, Mandatory, Part(1122, 27), Part(2, 1), Part(2, 2), Part(15, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, Part(9721, 14), Part(3, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Profile jerk 1
    (2, 6, None, Optional, Part(9735, 19), Part(3, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Profile jerk 2 to 6
    (0, 0, None, Mandatory, Part(0, 0), Part(3, 1), Part(6, 2), Part(0, 0), None, Part(0, 0), Part(40, 3))
    (0, 0, Some(Any), Mandatory, Part(0, 0), Part(1, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(43, 12))
    (0, 0, Some(Tpdo), Mandatory, Part(0, 0), Part(1, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(55, 8))
    (0, 0, None, Mandatory, Part(0, 0), Part(0, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(63, 1))
    (0, 0, None, Mandatory, Part(1122, 27), Part(2, 1), Part(2, 2), Part(16, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, Part(11199, 11), Part(4, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Set-point 1
    (2, 254, Some(Any), Optional, Part(11210, 18), Part(4, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Set-point 2 to 254
    (0, 0, None, Mandatory, Part(1122, 27), Part(2, 1), Part(2, 2), Part(1, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, Part(11298, 31), Part(2, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Interpolation time period value
    (2, 2, None, Mandatory, Part(11329, 24), Part(5, 1), Part(0, 1), Part(17, 1), None, Part(0, 0), Part(0, 0)) // Interpolation time index
    (0, 0, None, Mandatory, Part(1122, 27), Part(2, 1), Part(2, 2), Part(18, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, Part(11561, 19), Part(3, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Maximum buffer size
    (2, 2, None, Mandatory, Part(11580, 18), Part(3, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Actual buffer size
    (3, 3, None, Mandatory, Part(11618, 19), Part(2, 1), Part(0, 1), Part(19, 2), None, Part(0, 0), Part(64, 1)) // Buffer organization
    (4, 4, None, Mandatory, Part(11637, 15), Part(1, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Buffer position
    (5, 5, None, Mandatory, Part(11652, 19), Part(2, 1), Part(8, 2), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Size of data record
    (6, 6, None, Mandatory, Part(11671, 12), Part(2, 1), Part(8, 2), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Buffer clear
    (0, 0, Some(Any), Mandatory, Part(0, 0), Part(6, 2), Part(0, 1), Part(0, 0), None, Part(5486, 25), Part(0, 0))
    (0, 0, Some(No), Mandatory, Part(1122, 27), Part(2, 1), Part(1, 1), Part(16, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, None, Mandatory, Part(12747, 24), Part(5, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Supported homing methods
    (2, 254, None, Optional, Part(12747, 24), Part(5, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Supported homing methods
    (0, 0, Some(No), Mandatory, Part(1122, 27), Part(2, 1), Part(1, 1), Part(16, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, Part(12820, 32), Part(4, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Additional position actual value
    (2, 254, Some(Tpdo), Optional, Part(12820, 32), Part(4, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Additional position actual value
    (0, 0, Some(No), Mandatory, Part(1122, 27), Part(2, 1), Part(1, 1), Part(16, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, Part(12886, 32), Part(4, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Additional velocity actual value
    (2, 254, Some(Tpdo), Optional, Part(12886, 32), Part(4, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Additional velocity actual value
    (0, 0, Some(Any), Mandatory, Part(0, 0), Part(1, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0))
    (0, 0, None, Mandatory, Part(0, 0), Part(1, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(65, 7))
    (0, 0, None, Mandatory, Part(0, 0), Part(4, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0))
    (0, 0, Some(Tpdo), Mandatory, Part(0, 0), Part(3, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(72, 5))
    (0, 0, None, Mandatory, Part(1122, 27), Part(2, 1), Part(2, 2), Part(21, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, Part(15312, 16), Part(3, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(77, 2)) // Physical outputs
    (2, 2, Some(Any), Optional, Part(15328, 8), Part(3, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(77, 2)) // Bit mask
    (0, 0, Some(No), Mandatory, Part(0, 0), Part(1, 1), Part(6, 2), Part(0, 0), None, Part(0, 0), Part(79, 1))
    (0, 0, Some(No), Mandatory, Part(0, 0), Part(8, 1), Part(6, 2), Part(0, 0), None, Part(0, 0), Part(0, 0))
    (0, 0, Some(No), Mandatory, Part(0, 0), Part(9, 1), Part(6, 2), Part(0, 0), None, Part(0, 0), Part(0, 0))
    (0, 0, Some(No), Mandatory, Part(0, 0), Part(3, 1), Part(6, 2), Part(0, 0), None, Part(16082, 1), Part(0, 0))
    (0, 0, None, Mandatory, Part(0, 0), Part(3, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(80, 11))
    (0, 0, Some(No), Mandatory, Part(0, 0), Part(3, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 5))
);

static BITS: &[BitRow] = table!(BitRow { first, last, name, values }:
    (16, 16, Part(0, 19), Part(0, 0)) // frequency converter
    (17, 17, Part(19, 11), Part(0, 0)) // servo drive
    (18, 18, Part(30, 13), Part(0, 0)) // stepper motor
    (22, 22, Part(43, 31), Part(0, 0)) // PDO mapping of the manufacturer
    (24, 31, Part(74, 19), Part(0, 0)) // of the manufacturer
    (0, 15, Part(155, 8), Part(0, 5)) // reaction
    (0, 0, Part(379, 9), Part(0, 0)) // switch on
    (1, 1, Part(388, 14), Part(0, 0)) // enable voltage
    (2, 2, Part(402, 14), Part(0, 0)) // quick stop off
    (3, 3, Part(416, 16), Part(0, 0)) // enable operation
    (4, 6, Part(432, 11), Part(0, 0)) // of the mode
    (7, 7, Part(443, 11), Part(0, 0)) // fault reset
    (8, 8, Part(454, 4), Part(0, 0)) // halt
    (9, 9, Part(432, 11), Part(0, 0)) // of the mode
    (11, 15, Part(74, 19), Part(0, 0)) // of the manufacturer
    (0, 6, Part(544, 5), Part(5, 24)) // state
    (0, 0, Part(614, 18), Part(0, 0)) // ready to switch on
    (1, 1, Part(632, 11), Part(0, 0)) // switched on
    (2, 2, Part(643, 17), Part(0, 0)) // operation enabled
    (3, 3, Part(588, 5), Part(0, 0)) // fault
    (4, 4, Part(678, 15), Part(0, 0)) // voltage enabled
    (5, 5, Part(402, 14), Part(0, 0)) // quick stop off
    (6, 6, Part(660, 18), Part(0, 0)) // switch on disabled
    (7, 7, Part(693, 7), Part(0, 0)) // warning
    (8, 8, Part(74, 19), Part(0, 0)) // of the manufacturer
    (9, 9, Part(700, 6), Part(0, 0)) // remote
    (10, 10, Part(706, 14), Part(0, 0)) // target reached
    (11, 11, Part(720, 21), Part(0, 0)) // internal limit active
    (12, 13, Part(432, 11), Part(0, 0)) // of the mode
    (14, 15, Part(74, 19), Part(0, 0)) // of the manufacturer
    (0, 15, Part(155, 8), Part(29, 10)) // reaction
    (0, 15, Part(155, 8), Part(39, 3)) // reaction
    (0, 15, Part(155, 8), Part(42, 6)) // reaction
    (0, 7, Part(3935, 4), Part(48, 12)) // mode
    (0, 15, Part(4902, 22), Part(60, 3)) // source of the velocity
    (6, 6, Part(6530, 17), Part(0, 0)) // velocity times -1
    (7, 7, Part(6547, 17), Part(0, 0)) // position times -1
    (0, 15, Part(7050, 5), Part(63, 5)) // shape
    (0, 15, Part(7050, 5), Part(68, 3)) // shape
    (0, 7, Part(8824, 6), Part(71, 18)) // method
    (8, 15, Part(9813, 11), Part(0, 0)) // denominator
    (16, 23, Part(9824, 9), Part(0, 0)) // numerator
    (24, 31, Part(9833, 21), Part(0, 0)) // prefix, a power of 10
    (0, 0, Part(10202, 16), Part(0, 0)) // touch probe 1 on
    (1, 1, Part(10218, 24), Part(0, 0)) // touch probe 1 continuous
    (2, 3, Part(10242, 20), Part(89, 3)) // touch probe 1 source
    (4, 4, Part(10285, 35), Part(0, 0)) // touch probe 1 samples positive edge
    (5, 5, Part(10320, 35), Part(0, 0)) // touch probe 1 samples negative edge
    (6, 7, Part(74, 19), Part(0, 0)) // of the manufacturer
    (8, 8, Part(10355, 16), Part(0, 0)) // touch probe 2 on
    (9, 9, Part(10371, 24), Part(0, 0)) // touch probe 2 continuous
    (10, 11, Part(10395, 20), Part(92, 3)) // touch probe 2 source
    (12, 12, Part(10422, 35), Part(0, 0)) // touch probe 2 samples positive edge
    (13, 13, Part(10457, 35), Part(0, 0)) // touch probe 2 samples negative edge
    (14, 15, Part(74, 19), Part(0, 0)) // of the manufacturer
    (0, 0, Part(10202, 16), Part(0, 0)) // touch probe 1 on
    (1, 1, Part(10549, 31), Part(0, 0)) // touch probe 1 has positive edge
    (2, 2, Part(10580, 31), Part(0, 0)) // touch probe 1 has negative edge
    (6, 7, Part(74, 19), Part(0, 0)) // of the manufacturer
    (8, 8, Part(10355, 16), Part(0, 0)) // touch probe 2 on
    (9, 9, Part(10611, 31), Part(0, 0)) // touch probe 2 has positive edge
    (10, 10, Part(10642, 31), Part(0, 0)) // touch probe 2 has negative edge
    (14, 15, Part(74, 19), Part(0, 0)) // of the manufacturer
    (0, 15, Part(11061, 13), Part(95, 2)) // interpolation
    (0, 7, Part(11598, 12), Part(97, 2)) // organization
    (0, 1, Part(14124, 11), Part(99, 3)) // relative to
    (2, 3, Part(14197, 6), Part(102, 2)) // change
    (4, 5, Part(14265, 20), Part(0, 0)) // request and response
    (6, 7, Part(14285, 11), Part(104, 4)) // rotary axis
    (8, 11, Part(11061, 13), Part(0, 0)) // interpolation
    (12, 14, Part(14378, 8), Part(0, 0)) // reserved
    (15, 15, Part(74, 19), Part(0, 0)) // of the manufacturer
    (0, 0, Part(9077, 21), Part(0, 0)) // negative limit switch
    (1, 1, Part(9098, 21), Part(0, 0)) // positive limit switch
    (2, 2, Part(15194, 11), Part(0, 0)) // home switch
    (3, 3, Part(15205, 9), Part(0, 0)) // interlock
    (16, 31, Part(74, 19), Part(0, 0)) // of the manufacturer
    (0, 0, Part(15303, 9), Part(0, 0)) // set brake
    (16, 31, Part(74, 19), Part(0, 0)) // of the manufacturer
    (0, 15, Part(15487, 5), Part(108, 13)) // motor
    (0, 0, Part(3946, 16), Part(0, 0)) // profile position
    (1, 1, Part(3962, 8), Part(0, 0)) // velocity
    (2, 2, Part(3970, 16), Part(0, 0)) // profile velocity
    (3, 3, Part(3986, 14), Part(0, 0)) // torque profile
    (5, 5, Part(4000, 6), Part(0, 0)) // homing
    (6, 6, Part(4006, 21), Part(0, 0)) // interpolated position
    (7, 7, Part(4027, 27), Part(0, 0)) // cyclic synchronous position
    (8, 8, Part(4054, 27), Part(0, 0)) // cyclic synchronous velocity
    (9, 9, Part(4081, 25), Part(0, 0)) // cyclic synchronous torque
    (10, 10, Part(4106, 48), Part(0, 0)) // cyclic synchronous torque with commutation angle
    (16, 31, Part(74, 19), Part(0, 0)) // of the manufacturer
);

static MEANINGS: &[MeaningRow] = table!(MeaningRow { first, last, text }:
    (0, 0, Part(163, 9)) // no action
    (1, 1, Part(172, 12)) // fault signal
    (2, 2, Part(184, 15)) // disable voltage
    (3, 3, Part(199, 10)) // quick stop
    (32768, 65535, Part(209, 21)) // manufacturer-specific
    (0, 0, Part(549, 22)) // not ready to switch on
    (7, 7, Part(571, 17)) // quick stop active
    (8, 8, Part(588, 5)) // fault
    (15, 15, Part(593, 21)) // fault reaction active
    (16, 16, Part(549, 22)) // not ready to switch on
    (23, 23, Part(571, 17)) // quick stop active
    (24, 24, Part(588, 5)) // fault
    (31, 31, Part(593, 21)) // fault reaction active
    (32, 32, Part(549, 22)) // not ready to switch on
    (33, 33, Part(614, 18)) // ready to switch on
    (35, 35, Part(632, 11)) // switched on
    (39, 39, Part(643, 17)) // operation enabled
    (40, 40, Part(588, 5)) // fault
    (47, 47, Part(593, 21)) // fault reaction active
    (48, 48, Part(549, 22)) // not ready to switch on
    (49, 49, Part(614, 18)) // ready to switch on
    (51, 51, Part(632, 11)) // switched on
    (55, 55, Part(643, 17)) // operation enabled
    (56, 56, Part(588, 5)) // fault
    (63, 63, Part(593, 21)) // fault reaction active
    (64, 64, Part(660, 18)) // switch on disabled
    (80, 80, Part(660, 18)) // switch on disabled
    (96, 96, Part(660, 18)) // switch on disabled
    (112, 112, Part(660, 18)) // switch on disabled
    (0, 0, Part(3128, 22)) // disable drive function
    (1, 1, Part(3150, 39)) // slow down ramp, then switch on disabled
    (2, 2, Part(3189, 40)) // quick stop ramp, then switch on disabled
    (3, 3, Part(3229, 38)) // current limit, then switch on disabled
    (4, 4, Part(3267, 38)) // voltage limit, then switch on disabled
    (5, 5, Part(3305, 41)) // slow down ramp, stay in quick stop active
    (6, 6, Part(3346, 42)) // quick stop ramp, stay in quick stop active
    (7, 7, Part(3388, 40)) // current limit, stay in quick stop active
    (8, 8, Part(3428, 40)) // voltage limit, stay in quick stop active
    (32768, 65535, Part(209, 21)) // manufacturer-specific
    (0, 0, Part(3128, 22)) // disable drive function
    (1, 1, Part(3536, 28)) // slow down ramp, then disable
    (32768, 65535, Part(209, 21)) // manufacturer-specific
    (0, 0, Part(3128, 22)) // disable drive function
    (1, 1, Part(3734, 14)) // slow down ramp
    (2, 2, Part(3748, 15)) // quick stop ramp
    (3, 3, Part(3763, 13)) // current limit
    (4, 4, Part(3776, 13)) // voltage limit
    (32768, 65535, Part(209, 21)) // manufacturer-specific
    (0, 0, Part(3939, 7)) // no mode
    (1, 1, Part(3946, 16)) // profile position
    (2, 2, Part(3962, 8)) // velocity
    (3, 3, Part(3970, 16)) // profile velocity
    (4, 4, Part(3986, 14)) // torque profile
    (6, 6, Part(4000, 6)) // homing
    (7, 7, Part(4006, 21)) // interpolated position
    (8, 8, Part(4027, 27)) // cyclic synchronous position
    (9, 9, Part(4054, 27)) // cyclic synchronous velocity
    (10, 10, Part(4081, 25)) // cyclic synchronous torque
    (11, 11, Part(4106, 48)) // cyclic synchronous torque with commutation angle
    (128, 255, Part(209, 21)) // manufacturer-specific
    (0, 0, Part(4924, 16)) // position encoder
    (1, 1, Part(4940, 16)) // velocity encoder
    (32768, 65535, Part(209, 21)) // manufacturer-specific
    (0, 0, Part(7055, 11)) // linear ramp
    (1, 1, Part(7066, 10)) // sin² ramp
    (2, 2, Part(7076, 14)) // jerk-free ramp
    (3, 3, Part(7090, 17)) // jerk-limited ramp
    (32768, 65535, Part(209, 21)) // manufacturer-specific
    (0, 0, Part(7055, 11)) // linear ramp
    (1, 1, Part(7066, 10)) // sin² ramp
    (32768, 65535, Part(209, 21)) // manufacturer-specific
    (0, 0, Part(8830, 9)) // no homing
    (1, 1, Part(8839, 37)) // negative limit switch and index pulse
    (2, 2, Part(8876, 37)) // positive limit switch and index pulse
    (3, 4, Part(8913, 36)) // positive home switch and index pulse
    (5, 6, Part(8949, 36)) // negative home switch and index pulse
    (7, 10, Part(8985, 46)) // home switch and index pulse, starting positive
    (11, 14, Part(9031, 46)) // home switch and index pulse, starting negative
    (17, 17, Part(9077, 21)) // negative limit switch
    (18, 18, Part(9098, 21)) // positive limit switch
    (19, 20, Part(9119, 20)) // positive home switch
    (21, 22, Part(9139, 20)) // negative home switch
    (23, 26, Part(9159, 30)) // home switch, starting positive
    (27, 30, Part(9189, 30)) // home switch, starting negative
    (33, 33, Part(9219, 33)) // index pulse in negative direction
    (34, 34, Part(9252, 33)) // index pulse in positive direction
    (35, 35, Part(9285, 28)) // current position (version 2)
    (37, 37, Part(9313, 16)) // current position
    (128, 255, Part(209, 21)) // manufacturer-specific
    (0, 0, Part(10262, 5)) // input
    (1, 1, Part(10267, 11)) // index pulse
    (2, 2, Part(10278, 7)) // 60D0h:1
    (0, 0, Part(10262, 5)) // input
    (1, 1, Part(10267, 11)) // index pulse
    (2, 2, Part(10415, 7)) // 60D0h:2
    (0, 0, Part(11074, 20)) // linear interpolation
    (32768, 65535, Part(209, 21)) // manufacturer-specific
    (0, 0, Part(11610, 4)) // FIFO
    (1, 1, Part(11614, 4)) // ring
    (0, 0, Part(14135, 20)) // last target position
    (1, 1, Part(14155, 21)) // position demand value
    (2, 2, Part(14176, 21)) // position actual value
    (0, 0, Part(14203, 7)) // at once
    (1, 1, Part(14210, 55)) // of the set-point at once, of the rest with the next one
    (0, 0, Part(14296, 40)) // within one revolution like a linear axis
    (1, 1, Part(14336, 15)) // always negative
    (2, 2, Part(14351, 15)) // always positive
    (3, 3, Part(14366, 12)) // shortest way
    (0, 0, Part(15492, 18)) // non-standard motor
    (1, 1, Part(15510, 24)) // phase modulated DC motor
    (2, 2, Part(15534, 29)) // frequency controlled DC motor
    (3, 3, Part(15563, 34)) // permanent magnet synchronous motor
    (4, 4, Part(15597, 38)) // frequency controlled synchronous motor
    (5, 5, Part(15635, 25)) // switched reluctance motor
    (6, 6, Part(15660, 27)) // wound rotor induction motor
    (7, 7, Part(15687, 29)) // squirrel cage induction motor
    (8, 8, Part(30, 13)) // stepper motor
    (9, 9, Part(15716, 24)) // micro-step stepper motor
    (10, 10, Part(15740, 43)) // brushless motor with sinusoidal commutation
    (11, 11, Part(15783, 38)) // brushless motor with block commutation
    (32768, 65535, Part(209, 21)) // manufacturer-specific
    (8464, 8464, Part(16709, 42)) // short circuit or earth leakage, input side
    (8480, 8480, Part(16751, 25)) // earth leakage, input side
    (8481, 8481, Part(16776, 23)) // earth leakage, phase L1
    (8482, 8482, Part(16799, 23)) // earth leakage, phase L2
    (8483, 8483, Part(16822, 23)) // earth leakage, phase L3
    (8496, 8496, Part(16845, 25)) // short circuit, input side
    (8497, 8497, Part(16870, 31)) // short circuit, phases L1 and L2
    (8498, 8498, Part(16901, 31)) // short circuit, phases L2 and L3
    (8499, 8499, Part(16932, 31)) // short circuit, phases L3 and L1
    (8721, 8721, Part(16963, 18)) // internal current 1
    (8722, 8722, Part(16981, 18)) // internal current 2
    (8723, 8723, Part(16999, 33)) // over-current in the ramp function
    (8724, 8724, Part(17032, 28)) // over-current in the sequence
    (8736, 8736, Part(17060, 37)) // continuous over-current in the device
    (8737, 8737, Part(17097, 39)) // continuous over-current 1 in the device
    (8738, 8738, Part(17136, 39)) // continuous over-current 2 in the device
    (8752, 8752, Part(17175, 44)) // short circuit or earth leakage in the device
    (8768, 8768, Part(17219, 27)) // earth leakage in the device
    (8784, 8784, Part(17246, 27)) // short circuit in the device
    (8976, 8976, Part(17273, 35)) // continuous over-current, motor side
    (8977, 8977, Part(17308, 37)) // continuous over-current 1, motor side
    (8978, 8978, Part(17345, 37)) // continuous over-current 2, motor side
    (8992, 8992, Part(17382, 42)) // short circuit or earth leakage, motor side
    (9008, 9008, Part(17424, 25)) // earth leakage, motor side
    (9009, 9009, Part(17449, 22)) // earth leakage, phase U
    (9010, 9010, Part(17471, 22)) // earth leakage, phase V
    (9011, 9011, Part(17493, 22)) // earth leakage, phase W
    (9024, 9024, Part(17515, 25)) // short circuit, motor side
    (9025, 9025, Part(17540, 29)) // short circuit, phases U and V
    (9026, 9026, Part(17569, 29)) // short circuit, phases V and W
    (9027, 9027, Part(17598, 29)) // short circuit, phases W and U
    (9040, 9040, Part(17627, 29)) // overload (I2t, thermal state)
    (9041, 9041, Part(17656, 38)) // overload (I2t, thermal state), warning
    (12560, 12560, Part(17694, 18)) // mains over-voltage
    (12561, 12561, Part(17712, 28)) // mains over-voltage, phase L1
    (12562, 12562, Part(17740, 28)) // mains over-voltage, phase L2
    (12563, 12563, Part(17768, 28)) // mains over-voltage, phase L3
    (12576, 12576, Part(17796, 19)) // mains under-voltage
    (12577, 12577, Part(17815, 29)) // mains under-voltage, phase L1
    (12578, 12578, Part(17844, 29)) // mains under-voltage, phase L2
    (12579, 12579, Part(17873, 29)) // mains under-voltage, phase L3
    (12592, 12592, Part(17902, 13)) // phase failure
    (12593, 12593, Part(17915, 17)) // phase failure, L1
    (12594, 12594, Part(17932, 17)) // phase failure, L2
    (12595, 12595, Part(17949, 17)) // phase failure, L3
    (12596, 12596, Part(17966, 14)) // phase sequence
    (12608, 12608, Part(17980, 15)) // mains frequency
    (12609, 12609, Part(17995, 24)) // mains frequency too high
    (12610, 12610, Part(18019, 23)) // mains frequency too low
    (12816, 12816, Part(18042, 20)) // DC link over-voltage
    (12817, 12817, Part(18062, 22)) // DC link over-voltage 1
    (12818, 12818, Part(18084, 22)) // DC link over-voltage 2
    (12832, 12832, Part(18106, 21)) // DC link under-voltage
    (12833, 12833, Part(18127, 23)) // DC link under-voltage 1
    (12834, 12834, Part(18150, 23)) // DC link under-voltage 2
    (12848, 12848, Part(18173, 10)) // load error
    (13072, 13072, Part(18183, 19)) // output over-voltage
    (13073, 13073, Part(18202, 28)) // output over-voltage, phase U
    (13074, 13074, Part(18230, 28)) // output over-voltage, phase V
    (13075, 13075, Part(18258, 28)) // output over-voltage, phase W
    (13088, 13088, Part(18286, 16)) // armature circuit
    (13089, 13089, Part(18302, 28)) // armature circuit interrupted
    (13104, 13104, Part(18330, 13)) // field circuit
    (13105, 13105, Part(18343, 25)) // field circuit interrupted
    (16656, 16656, Part(18368, 28)) // ambient temperature too high
    (16672, 16672, Part(18396, 27)) // ambient temperature too low
    (16688, 16688, Part(18423, 29)) // temperature of the supply air
    (16704, 16704, Part(18452, 29)) // temperature of the air outlet
    (16912, 16912, Part(18481, 27)) // device temperature too high
    (16928, 16928, Part(18508, 26)) // device temperature too low
    (17152, 17152, Part(18534, 24)) // temperature of the drive
    (17168, 17168, Part(18558, 33)) // temperature of the drive too high
    (17184, 17184, Part(18591, 32)) // temperature of the drive too low
    (17408, 17408, Part(18623, 25)) // temperature of the supply
    (17424, 17424, Part(18648, 34)) // temperature of the supply too high
    (17440, 17440, Part(18682, 33)) // temperature of the supply too low
    (20736, 20736, Part(18715, 6)) // supply
    (20752, 20752, Part(18721, 23)) // low voltage of a supply
    (20753, 20753, Part(18744, 30)) // low voltage of the 15 V supply
    (20754, 20754, Part(18774, 30)) // low voltage of the 24 V supply
    (20755, 20755, Part(18804, 29)) // low voltage of the 5 V supply
    (20756, 20761, Part(18833, 43)) // low voltage of a supply of the manufacturer
    (20768, 20768, Part(18876, 34)) // supply of the intermediate circuit
    (20992, 20992, Part(18910, 7)) // control
    (21008, 21008, Part(18917, 17)) // measuring circuit
    (21024, 21024, Part(18934, 17)) // computing circuit
    (21248, 21248, Part(18951, 14)) // operating unit
    (21504, 21504, Part(18965, 13)) // power section
    (21520, 21520, Part(18978, 13)) // output stages
    (21536, 21536, Part(18991, 7)) // chopper
    (21552, 21552, Part(18998, 12)) // input stages
    (21568, 21568, Part(19010, 8)) // contacts
    (21569, 21577, Part(19018, 27)) // contact of the manufacturer
    (21584, 21584, Part(19045, 5)) // fuses
    (21585, 21593, Part(19050, 24)) // fuse of the manufacturer
    (21760, 21760, Part(19074, 12)) // data storage
    (21776, 21776, Part(19086, 14)) // working memory
    (21792, 21792, Part(19100, 14)) // program memory
    (21808, 21808, Part(19114, 24)) // non-volatile data memory
    (24592, 24592, Part(19138, 25)) // software reset (watchdog)
    (25345, 25359, Part(19163, 11)) // data record
    (25360, 25360, Part(19174, 18)) // loss of parameters
    (25376, 25376, Part(19192, 15)) // parameter error
    (28928, 28928, Part(19207, 5)) // power
    (28944, 28944, Part(19212, 13)) // brake chopper
    (28945, 28945, Part(19225, 28)) // failure of the brake chopper
    (28946, 28946, Part(19253, 33)) // over-current of the brake chopper
    (28947, 28947, Part(19286, 39)) // protective circuit of the brake chopper
    (28960, 28960, Part(15487, 5)) // motor
    (28961, 28961, Part(19325, 13)) // motor blocked
    (28962, 28962, Part(19338, 32)) // motor error or wrong commutation
    (28963, 28963, Part(19370, 12)) // motor tilted
    (29184, 29184, Part(19382, 24)) // measuring circuit module
    (29440, 29440, Part(19406, 6)) // sensor
    (29441, 29441, Part(19412, 16)) // tachometer fault
    (29442, 29442, Part(19428, 32)) // wrong polarity of the tachometer
    (29443, 29443, Part(19460, 19)) // fault of resolver 1
    (29444, 29444, Part(19479, 19)) // fault of resolver 2
    (29445, 29445, Part(19498, 29)) // fault of incremental sensor 1
    (29446, 29446, Part(19527, 29)) // fault of incremental sensor 2
    (29447, 29447, Part(19556, 29)) // fault of incremental sensor 3
    (29456, 29456, Part(19585, 5)) // speed
    (29472, 29472, Part(19590, 8)) // position
    (29696, 29696, Part(19598, 24)) // computing circuit module
    (29952, 29952, Part(19622, 20)) // communication module
    (29968, 29968, Part(19642, 18)) // serial interface 1
    (29984, 29984, Part(19660, 18)) // serial interface 2
    (30208, 30208, Part(19678, 19)) // data storage module
    (33536, 33536, Part(19697, 14)) // torque control
    (33553, 33553, Part(19711, 15)) // torque too high
    (33554, 33554, Part(19726, 18)) // difficult start-up
    (33555, 33555, Part(19744, 20)) // torque at standstill
    (33569, 33569, Part(19764, 14)) // torque too low
    (33585, 33585, Part(19778, 12)) // torque fault
    (33792, 33792, Part(19790, 19)) // velocity controller
    (34048, 34048, Part(19809, 19)) // position controller
    (34304, 34304, Part(19828, 22)) // positioning controller
    (34321, 34321, Part(19850, 15)) // following error
    (34322, 34322, Part(19865, 15)) // reference limit
    (34560, 34560, Part(19880, 22)) // synchronous controller
    (34816, 34816, Part(19902, 18)) // winding controller
    (35072, 35072, Part(19920, 23)) // process data monitoring
    (35328, 35328, Part(19943, 18)) // control monitoring
    (61441, 61441, Part(19961, 12)) // deceleration
    (61442, 61442, Part(19973, 19)) // sub-synchronous run
    (61443, 61443, Part(19992, 16)) // stroke operation
    (61444, 61444, Part(18910, 7)) // control
);

static COMMANDS: &[CommandRow] = table!(CommandRow { name, mask }:
    (Part(20008, 8), Part(20016, 9)) // shutdown
    (Part(379, 9), Part(20025, 9)) // switch on
    (Part(416, 16), Part(20034, 9)) // enable operation
    (Part(20043, 17), Part(20025, 9)) // disable operation
    (Part(199, 10), Part(20060, 9)) // quick stop
    (Part(184, 15), Part(20069, 9)) // disable voltage
    (Part(20078, 25), Part(20103, 9)) // fault reset (bit 7 rises)
);

static TRANSITIONS: &[TransitionRow] = table!(TransitionRow { number, from, to, by }:
    (0, Part(20112, 5), Part(549, 22), Part(20117, 17)) // not ready to switch on
    (1, Part(549, 22), Part(660, 18), Part(20134, 22)) // switch on disabled
    (2, Part(660, 18), Part(614, 18), Part(20008, 8)) // ready to switch on
    (3, Part(614, 18), Part(632, 11), Part(379, 9)) // switched on
    (4, Part(632, 11), Part(643, 17), Part(416, 16)) // operation enabled
    (5, Part(643, 17), Part(632, 11), Part(20043, 17)) // switched on
    (6, Part(632, 11), Part(614, 18), Part(20008, 8)) // ready to switch on
    (7, Part(614, 18), Part(660, 18), Part(20156, 27)) // switch on disabled
    (8, Part(643, 17), Part(614, 18), Part(20008, 8)) // ready to switch on
    (9, Part(643, 17), Part(660, 18), Part(184, 15)) // switch on disabled
    (10, Part(632, 11), Part(660, 18), Part(20156, 27)) // switch on disabled
    (11, Part(643, 17), Part(571, 17), Part(199, 10)) // quick stop active
    (12, Part(571, 17), Part(660, 18), Part(20183, 53)) // switch on disabled
    (13, Part(20236, 9), Part(593, 21), Part(20245, 7)) // fault reaction active
    (14, Part(593, 21), Part(588, 5), Part(20252, 22)) // fault
    (15, Part(588, 5), Part(660, 18), Part(20078, 25)) // switch on disabled
    (16, Part(571, 17), Part(643, 17), Part(20274, 34)) // operation enabled
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
