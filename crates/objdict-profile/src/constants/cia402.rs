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

static OBJECTS: &[ObjectRow] = &[
    ObjectRow { first: 4096, last: 4096, name: Part(93, 11), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 1), source: Part(0, 0), about: Part(104, 51), confidence: High }, // 1000h Device type
    ObjectRow { first: 24583, last: 24583, name: Part(230, 28), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(1, 1), source: Part(0, 0), about: Part(258, 62), confidence: High }, // 6007h Abort connection option code
    ObjectRow { first: 24639, last: 24639, name: Part(320, 10), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(2, 1), source: Part(0, 0), about: Part(330, 49), confidence: High }, // 603Fh Error code
    ObjectRow { first: 24640, last: 24640, name: Part(458, 11), object_types: Part(0, 1), need: Mandatory, only: None, as_many_as: Part(0, 0), entries: Part(3, 1), source: Part(0, 0), about: Part(469, 75), confidence: High }, // 6040h Controlword
    ObjectRow { first: 24641, last: 24641, name: Part(741, 10), object_types: Part(0, 1), need: Mandatory, only: None, as_many_as: Part(0, 0), entries: Part(4, 1), source: Part(0, 0), about: Part(751, 68), confidence: High }, // 6041h Statusword
    ObjectRow { first: 24642, last: 24642, name: Part(819, 18), object_types: Part(0, 1), need: When(0), only: None, as_many_as: Part(0, 0), entries: Part(5, 1), source: Part(0, 0), about: Part(837, 45), confidence: High }, // 6042h vl target velocity
    ObjectRow { first: 24643, last: 24643, name: Part(882, 18), object_types: Part(0, 1), need: When(0), only: None, as_many_as: Part(0, 0), entries: Part(6, 1), source: Part(0, 0), about: Part(900, 53), confidence: High }, // 6043h vl velocity demand
    ObjectRow { first: 24644, last: 24644, name: Part(953, 24), object_types: Part(0, 1), need: When(0), only: None, as_many_as: Part(0, 0), entries: Part(6, 1), source: Part(0, 0), about: Part(977, 59), confidence: High }, // 6044h vl velocity actual value
    ObjectRow { first: 24645, last: 24645, name: Part(1036, 23), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(7, 1), source: Part(0, 0), about: Part(1059, 63), confidence: High }, // 6045h vl manipulated velocity
    ObjectRow { first: 24646, last: 24646, name: Part(1193, 26), object_types: Part(1, 1), need: When(0), only: None, as_many_as: Part(0, 0), entries: Part(8, 3), source: Part(0, 0), about: Part(1219, 71), confidence: High }, // 6046h vl velocity min max amount
    ObjectRow { first: 24647, last: 24647, name: Part(1290, 19), object_types: Part(1, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0), about: Part(1309, 70), confidence: High }, // 6047h vl velocity min max
    ObjectRow { first: 24648, last: 24648, name: Part(1401, 24), object_types: Part(2, 1), need: When(0), only: None, as_many_as: Part(0, 0), entries: Part(11, 3), source: Part(0, 0), about: Part(1425, 81), confidence: High }, // 6048h vl velocity acceleration
    ObjectRow { first: 24649, last: 24649, name: Part(1506, 24), object_types: Part(2, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(11, 3), source: Part(0, 0), about: Part(1530, 81), confidence: High }, // 6049h vl velocity deceleration
    ObjectRow { first: 24650, last: 24650, name: Part(1611, 22), object_types: Part(2, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(11, 3), source: Part(0, 0), about: Part(1633, 79), confidence: High }, // 604Ah vl velocity quick stop
    ObjectRow { first: 24651, last: 24651, name: Part(1772, 19), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(14, 3), source: Part(0, 0), about: Part(1791, 65), confidence: High }, // 604Bh vl set-point factor
    ObjectRow { first: 24652, last: 24652, name: Part(1916, 19), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(17, 3), source: Part(0, 0), about: Part(1935, 76), confidence: High }, // 604Ch vl dimension factor
    ObjectRow { first: 24653, last: 24653, name: Part(2011, 14), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(20, 1), source: Part(0, 0), about: Part(2025, 33), confidence: High }, // 604Dh vl pole number
    ObjectRow { first: 24654, last: 24654, name: Part(2058, 21), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(21, 1), source: Part(0, 0), about: Part(2079, 53), confidence: High }, // 604Eh vl velocity reference
    ObjectRow { first: 24655, last: 24655, name: Part(2134, 21), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(22, 1), source: Part(0, 0), about: Part(2155, 76), confidence: High }, // 604Fh vl ramp function time
    ObjectRow { first: 24656, last: 24656, name: Part(2231, 17), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(22, 1), source: Part(0, 0), about: Part(2248, 76), confidence: High }, // 6050h vl slow down time
    ObjectRow { first: 24657, last: 24657, name: Part(2324, 18), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(22, 1), source: Part(0, 0), about: Part(2342, 74), confidence: High }, // 6051h vl quick stop time
    ObjectRow { first: 24658, last: 24658, name: Part(2416, 21), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(23, 1), source: Part(0, 0), about: Part(2437, 55), confidence: High }, // 6052h vl nominal percentage
    ObjectRow { first: 24659, last: 24659, name: Part(2492, 20), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(6, 1), source: Part(0, 0), about: Part(2512, 50), confidence: High }, // 6053h vl percentage demand
    ObjectRow { first: 24660, last: 24660, name: Part(2562, 20), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(6, 1), source: Part(0, 0), about: Part(2582, 44), confidence: High }, // 6054h vl actual percentage
    ObjectRow { first: 24661, last: 24661, name: Part(2626, 25), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(6, 1), source: Part(0, 0), about: Part(2651, 47), confidence: High }, // 6055h vl manipulated percentage
    ObjectRow { first: 24662, last: 24662, name: Part(2698, 32), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0), about: Part(2730, 77), confidence: High }, // 6056h vl velocity motor min max amount
    ObjectRow { first: 24663, last: 24663, name: Part(2807, 25), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0), about: Part(2832, 76), confidence: High }, // 6057h vl velocity motor min max
    ObjectRow { first: 24664, last: 24664, name: Part(2908, 33), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0), about: Part(2941, 81), confidence: High }, // 6058h vl frequency motor min max amount
    ObjectRow { first: 24665, last: 24665, name: Part(3022, 26), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0), about: Part(3048, 80), confidence: High }, // 6059h vl frequency motor min max
    ObjectRow { first: 24666, last: 24666, name: Part(3468, 22), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(24, 1), source: Part(0, 0), about: Part(3490, 46), confidence: High }, // 605Ah Quick stop option code
    ObjectRow { first: 24667, last: 24667, name: Part(3564, 20), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(25, 1), source: Part(0, 0), about: Part(3584, 64), confidence: High }, // 605Bh Shutdown option code
    ObjectRow { first: 24668, last: 24668, name: Part(3648, 29), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(26, 1), source: Part(0, 0), about: Part(3677, 57), confidence: High }, // 605Ch Disable operation option code
    ObjectRow { first: 24669, last: 24669, name: Part(3789, 16), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(27, 1), source: Part(0, 0), about: Part(3805, 64), confidence: High }, // 605Dh Halt option code
    ObjectRow { first: 24670, last: 24670, name: Part(3869, 26), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(28, 1), source: Part(0, 0), about: Part(3895, 40), confidence: High }, // 605Eh Fault reaction option code
    ObjectRow { first: 24672, last: 24672, name: Part(4154, 18), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(29, 1), source: Part(0, 0), about: Part(4172, 30), confidence: High }, // 6060h Modes of operation
    ObjectRow { first: 24673, last: 24673, name: Part(4202, 26), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(30, 1), source: Part(0, 0), about: Part(4228, 37), confidence: High }, // 6061h Modes of operation display
    ObjectRow { first: 24674, last: 24674, name: Part(4265, 21), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(31, 1), source: Part(0, 0), about: Part(4286, 49), confidence: High }, // 6062h Position demand value
    ObjectRow { first: 24675, last: 24675, name: Part(4335, 30), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(31, 1), source: Part(0, 0), about: Part(4365, 49), confidence: High }, // 6063h Position actual internal value
    ObjectRow { first: 24676, last: 24676, name: Part(4414, 21), object_types: Part(0, 1), need: When(1), only: None, as_many_as: Part(0, 0), entries: Part(31, 1), source: Part(0, 0), about: Part(4435, 44), confidence: High }, // 6064h Position actual value
    ObjectRow { first: 24677, last: 24677, name: Part(4479, 22), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(32, 1), source: Part(0, 0), about: Part(4501, 85), confidence: High }, // 6065h Following error window
    ObjectRow { first: 24678, last: 24678, name: Part(4586, 24), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(33, 1), source: Part(0, 0), about: Part(4610, 59), confidence: High }, // 6066h Following error time out
    ObjectRow { first: 24679, last: 24679, name: Part(4669, 15), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(21, 1), source: Part(0, 0), about: Part(4684, 65), confidence: High }, // 6067h Position window
    ObjectRow { first: 24680, last: 24680, name: Part(4749, 20), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(33, 1), source: Part(0, 0), about: Part(4769, 72), confidence: High }, // 6068h Position window time
    ObjectRow { first: 24681, last: 24681, name: Part(4841, 28), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(31, 1), source: Part(0, 0), about: Part(4869, 33), confidence: High }, // 6069h Velocity sensor actual value
    ObjectRow { first: 24682, last: 24682, name: Part(4956, 21), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(34, 1), source: Part(0, 0), about: Part(4977, 46), confidence: High }, // 606Ah Sensor selection code
    ObjectRow { first: 24683, last: 24683, name: Part(5023, 21), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(31, 1), source: Part(0, 0), about: Part(5044, 46), confidence: High }, // 606Bh Velocity demand value
    ObjectRow { first: 24684, last: 24684, name: Part(5090, 21), object_types: Part(0, 1), need: When(2), only: None, as_many_as: Part(0, 0), entries: Part(31, 1), source: Part(0, 0), about: Part(5111, 17), confidence: High }, // 606Ch Velocity actual value
    ObjectRow { first: 24685, last: 24685, name: Part(5128, 15), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(35, 1), source: Part(0, 0), about: Part(5143, 71), confidence: High }, // 606Dh Velocity window
    ObjectRow { first: 24686, last: 24686, name: Part(5214, 20), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(33, 1), source: Part(0, 0), about: Part(5234, 81), confidence: High }, // 606Eh Velocity window time
    ObjectRow { first: 24687, last: 24687, name: Part(5315, 18), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(35, 1), source: Part(0, 0), about: Part(5333, 49), confidence: High }, // 606Fh Velocity threshold
    ObjectRow { first: 24688, last: 24688, name: Part(5382, 23), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(33, 1), source: Part(0, 0), about: Part(5405, 81), confidence: High }, // 6070h Velocity threshold time
    ObjectRow { first: 24689, last: 24689, name: Part(5511, 13), object_types: Part(0, 1), need: When(3), only: None, as_many_as: Part(0, 0), entries: Part(36, 1), source: Part(0, 0), about: Part(5524, 64), confidence: High }, // 6071h Target torque
    ObjectRow { first: 24690, last: 24690, name: Part(5588, 10), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(37, 1), source: Part(0, 0), about: Part(5598, 47), confidence: High }, // 6072h Max torque
    ObjectRow { first: 24691, last: 24691, name: Part(5671, 11), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(38, 1), source: Part(0, 0), about: Part(5682, 48), confidence: High }, // 6073h Max current
    ObjectRow { first: 24692, last: 24692, name: Part(5730, 13), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(39, 1), source: Part(0, 0), about: Part(5743, 47), confidence: High }, // 6074h Torque demand
    ObjectRow { first: 24693, last: 24693, name: Part(5792, 19), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(40, 1), source: Part(0, 0), about: Part(5811, 65), confidence: High }, // 6075h Motor rated current
    ObjectRow { first: 24694, last: 24694, name: Part(5879, 18), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(41, 1), source: Part(0, 0), about: Part(5897, 63), confidence: High }, // 6076h Motor rated torque
    ObjectRow { first: 24695, last: 24695, name: Part(5960, 19), object_types: Part(0, 1), need: When(4), only: None, as_many_as: Part(0, 0), entries: Part(39, 1), source: Part(0, 0), about: Part(5979, 18), confidence: High }, // 6077h Torque actual value
    ObjectRow { first: 24696, last: 24696, name: Part(5997, 20), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(42, 1), source: Part(0, 0), about: Part(6017, 19), confidence: High }, // 6078h Current actual value
    ObjectRow { first: 24697, last: 24697, name: Part(6038, 23), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(43, 1), source: Part(0, 0), about: Part(6061, 27), confidence: High }, // 6079h DC link circuit voltage
    ObjectRow { first: 24698, last: 24698, name: Part(6088, 15), object_types: Part(0, 1), need: When(5), only: None, as_many_as: Part(0, 0), entries: Part(44, 1), source: Part(0, 0), about: Part(6103, 70), confidence: High }, // 607Ah Target position
    ObjectRow { first: 24699, last: 24699, name: Part(6221, 20), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(45, 3), source: Part(0, 0), about: Part(6241, 75), confidence: High }, // 607Bh Position range limit
    ObjectRow { first: 24700, last: 24700, name: Part(6316, 11), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(44, 1), source: Part(0, 0), about: Part(6327, 85), confidence: High }, // 607Ch Home offset
    ObjectRow { first: 24701, last: 24701, name: Part(6448, 23), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(48, 3), source: Part(0, 0), about: Part(6471, 59), confidence: High }, // 607Dh Software position limit
    ObjectRow { first: 24702, last: 24702, name: Part(6564, 8), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(51, 1), source: Part(0, 0), about: Part(6572, 36), confidence: High }, // 607Eh Polarity
    ObjectRow { first: 24703, last: 24703, name: Part(6608, 20), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(21, 1), source: Part(0, 0), about: Part(6628, 40), confidence: High }, // 607Fh Max profile velocity
    ObjectRow { first: 24704, last: 24704, name: Part(6671, 15), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(52, 1), source: Part(0, 0), about: Part(6686, 42), confidence: High }, // 6080h Max motor speed
    ObjectRow { first: 24705, last: 24705, name: Part(6728, 16), object_types: Part(0, 1), need: When(6), only: None, as_many_as: Part(0, 0), entries: Part(32, 1), source: Part(0, 0), about: Part(6744, 54), confidence: High }, // 6081h Profile velocity
    ObjectRow { first: 24706, last: 24706, name: Part(6798, 12), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(21, 1), source: Part(0, 0), about: Part(6810, 66), confidence: High }, // 6082h End velocity
    ObjectRow { first: 24707, last: 24707, name: Part(6876, 20), object_types: Part(0, 1), need: When(7), only: None, as_many_as: Part(0, 0), entries: Part(32, 1), source: Part(0, 0), about: Part(6896, 39), confidence: High }, // 6083h Profile acceleration
    ObjectRow { first: 24708, last: 24708, name: Part(6935, 20), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(32, 1), source: Part(0, 0), about: Part(6955, 39), confidence: High }, // 6084h Profile deceleration
    ObjectRow { first: 24709, last: 24709, name: Part(6994, 23), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(32, 1), source: Part(0, 0), about: Part(7017, 33), confidence: High }, // 6085h Quick stop deceleration
    ObjectRow { first: 24710, last: 24710, name: Part(7107, 19), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(53, 1), source: Part(0, 0), about: Part(7126, 45), confidence: High }, // 6086h Motion profile type
    ObjectRow { first: 24711, last: 24711, name: Part(7207, 12), object_types: Part(0, 1), need: When(8), only: None, as_many_as: Part(0, 0), entries: Part(54, 1), source: Part(0, 0), about: Part(7219, 51), confidence: High }, // 6087h Torque slope
    ObjectRow { first: 24712, last: 24712, name: Part(7270, 19), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(55, 1), source: Part(0, 0), about: Part(7289, 29), confidence: High }, // 6088h Torque profile type
    ObjectRow { first: 24713, last: 24713, name: Part(7318, 23), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(56, 1), source: Part(7341, 9), about: Part(7350, 69), confidence: Medium }, // 6089h Position notation index
    ObjectRow { first: 24714, last: 24714, name: Part(7419, 24), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(20, 1), source: Part(7341, 9), about: Part(7443, 58), confidence: Medium }, // 608Ah Position dimension index
    ObjectRow { first: 24715, last: 24715, name: Part(7501, 23), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(56, 1), source: Part(7341, 9), about: Part(7524, 66), confidence: Medium }, // 608Bh Velocity notation index
    ObjectRow { first: 24716, last: 24716, name: Part(7590, 24), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(20, 1), source: Part(7341, 9), about: Part(7614, 55), confidence: Medium }, // 608Ch Velocity dimension index
    ObjectRow { first: 24717, last: 24717, name: Part(7669, 27), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(56, 1), source: Part(7341, 9), about: Part(7696, 73), confidence: Medium }, // 608Dh Acceleration notation index
    ObjectRow { first: 24718, last: 24718, name: Part(7769, 28), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(20, 1), source: Part(7341, 9), about: Part(7797, 62), confidence: Medium }, // 608Eh Acceleration dimension index
    ObjectRow { first: 24719, last: 24719, name: Part(7894, 27), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(57, 3), source: Part(0, 0), about: Part(7921, 92), confidence: High }, // 608Fh Position encoder resolution
    ObjectRow { first: 24720, last: 24720, name: Part(8070, 27), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(60, 3), source: Part(0, 0), about: Part(8097, 101), confidence: High }, // 6090h Velocity encoder resolution
    ObjectRow { first: 24721, last: 24721, name: Part(8215, 10), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(63, 3), source: Part(0, 0), about: Part(8225, 70), confidence: High }, // 6091h Gear ratio
    ObjectRow { first: 24722, last: 24722, name: Part(8299, 13), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(66, 3), source: Part(0, 0), about: Part(8312, 74), confidence: High }, // 6092h Feed constant
    ObjectRow { first: 24723, last: 24723, name: Part(8395, 15), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(69, 3), source: Part(0, 0), about: Part(8410, 67), confidence: High }, // 6093h Position factor
    ObjectRow { first: 24724, last: 24724, name: Part(8484, 23), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(72, 3), source: Part(0, 0), about: Part(8507, 76), confidence: High }, // 6094h Velocity encoder factor
    ObjectRow { first: 24725, last: 24725, name: Part(8583, 17), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(72, 3), source: Part(0, 0), about: Part(8600, 55), confidence: High }, // 6095h Velocity factor 1
    ObjectRow { first: 24726, last: 24726, name: Part(8655, 15), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(72, 3), source: Part(0, 0), about: Part(8670, 64), confidence: High }, // 6096h Velocity factor
    ObjectRow { first: 24727, last: 24727, name: Part(8734, 19), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(72, 3), source: Part(0, 0), about: Part(8753, 71), confidence: High }, // 6097h Acceleration factor
    ObjectRow { first: 24728, last: 24728, name: Part(9329, 13), object_types: Part(0, 1), need: When(9), only: None, as_many_as: Part(0, 0), entries: Part(75, 1), source: Part(0, 0), about: Part(9342, 46), confidence: High }, // 6098h Homing method
    ObjectRow { first: 24729, last: 24729, name: Part(9446, 13), object_types: Part(3, 2), need: When(9), only: None, as_many_as: Part(0, 0), entries: Part(76, 3), source: Part(0, 0), about: Part(9459, 61), confidence: High }, // 6099h Homing speeds
    ObjectRow { first: 24730, last: 24730, name: Part(9520, 19), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(32, 1), source: Part(0, 0), about: Part(9539, 44), confidence: High }, // 609Ah Homing acceleration
    ObjectRow { first: 24738, last: 24738, name: Part(9583, 11), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(72, 3), source: Part(0, 0), about: Part(9594, 62), confidence: High }, // 60A2h Jerk factor
    ObjectRow { first: 24739, last: 24739, name: Part(9656, 16), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(79, 1), source: Part(0, 0), about: Part(9672, 49), confidence: High }, // 60A3h Profile jerk use
    ObjectRow { first: 24740, last: 24740, name: Part(9754, 12), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(80, 3), source: Part(0, 0), about: Part(9766, 47), confidence: High }, // 60A4h Profile jerk
    ObjectRow { first: 24744, last: 24744, name: Part(9854, 16), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(83, 1), source: Part(9870, 9), about: Part(9879, 22), confidence: Medium }, // 60A8h SI unit position
    ObjectRow { first: 24745, last: 24745, name: Part(9901, 16), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(83, 1), source: Part(9870, 9), about: Part(9917, 19), confidence: Medium }, // 60A9h SI unit velocity
    ObjectRow { first: 24746, last: 24746, name: Part(9936, 20), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(83, 1), source: Part(9870, 9), about: Part(9956, 26), confidence: Medium }, // 60AAh SI unit acceleration
    ObjectRow { first: 24747, last: 24747, name: Part(9982, 12), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(83, 1), source: Part(9870, 9), about: Part(9994, 17), confidence: Medium }, // 60ABh SI unit jerk
    ObjectRow { first: 24752, last: 24752, name: Part(10011, 15), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(44, 1), source: Part(0, 0), about: Part(10026, 51), confidence: High }, // 60B0h Position offset
    ObjectRow { first: 24753, last: 24753, name: Part(10077, 15), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(44, 1), source: Part(0, 0), about: Part(10092, 48), confidence: High }, // 60B1h Velocity offset
    ObjectRow { first: 24754, last: 24754, name: Part(10140, 13), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(36, 1), source: Part(0, 0), about: Part(10153, 49), confidence: High }, // 60B2h Torque offset
    ObjectRow { first: 24760, last: 24760, name: Part(10492, 20), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(84, 1), source: Part(0, 0), about: Part(10512, 37), confidence: High }, // 60B8h Touch probe function
    ObjectRow { first: 24761, last: 24761, name: Part(10673, 18), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(85, 1), source: Part(0, 0), about: Part(10691, 64), confidence: High }, // 60B9h Touch probe status
    ObjectRow { first: 24762, last: 24762, name: Part(10755, 27), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(31, 1), source: Part(0, 0), about: Part(10782, 49), confidence: High }, // 60BAh Touch probe 1 positive edge
    ObjectRow { first: 24763, last: 24763, name: Part(10831, 27), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(31, 1), source: Part(0, 0), about: Part(10858, 50), confidence: High }, // 60BBh Touch probe 1 negative edge
    ObjectRow { first: 24764, last: 24764, name: Part(10908, 27), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(31, 1), source: Part(0, 0), about: Part(10935, 49), confidence: High }, // 60BCh Touch probe 2 positive edge
    ObjectRow { first: 24765, last: 24765, name: Part(10984, 27), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(31, 1), source: Part(0, 0), about: Part(11011, 50), confidence: High }, // 60BDh Touch probe 2 negative edge
    ObjectRow { first: 24768, last: 24768, name: Part(11094, 29), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(86, 1), source: Part(0, 0), about: Part(11123, 76), confidence: High }, // 60C0h Interpolation sub mode select
    ObjectRow { first: 24769, last: 24769, name: Part(11228, 25), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(87, 3), source: Part(0, 0), about: Part(11253, 45), confidence: High }, // 60C1h Interpolation data record
    ObjectRow { first: 24770, last: 24770, name: Part(11353, 25), object_types: Part(2, 1), need: When(10), only: None, as_many_as: Part(0, 0), entries: Part(90, 3), source: Part(0, 0), about: Part(11378, 76), confidence: High }, // 60C2h Interpolation time period
    ObjectRow { first: 24771, last: 24771, name: Part(11454, 29), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0), about: Part(11483, 78), confidence: High }, // 60C3h Interpolation sync definition
    ObjectRow { first: 24772, last: 24772, name: Part(11683, 32), object_types: Part(2, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(93, 7), source: Part(0, 0), about: Part(11715, 72), confidence: High }, // 60C4h Interpolation data configuration
    ObjectRow { first: 24773, last: 24773, name: Part(11787, 16), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(21, 1), source: Part(0, 0), about: Part(11803, 41), confidence: High }, // 60C5h Max acceleration
    ObjectRow { first: 24774, last: 24774, name: Part(11844, 16), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(21, 1), source: Part(0, 0), about: Part(11860, 41), confidence: High }, // 60C6h Max deceleration
    ObjectRow { first: 24784, last: 24784, name: Part(11901, 18), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0), about: Part(11919, 48), confidence: High }, // 60D0h Touch probe source
    ObjectRow { first: 24785, last: 24785, name: Part(11967, 39), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0), about: Part(12006, 45), confidence: High }, // 60D1h Touch probe time stamp 1 positive value
    ObjectRow { first: 24786, last: 24786, name: Part(12051, 39), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0), about: Part(12090, 46), confidence: High }, // 60D2h Touch probe time stamp 1 negative value
    ObjectRow { first: 24787, last: 24787, name: Part(12136, 39), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0), about: Part(12175, 45), confidence: High }, // 60D3h Touch probe time stamp 2 positive value
    ObjectRow { first: 24788, last: 24788, name: Part(12220, 39), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0), about: Part(12259, 46), confidence: High }, // 60D4h Touch probe time stamp 2 negative value
    ObjectRow { first: 24789, last: 24789, name: Part(12305, 35), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0), about: Part(12340, 41), confidence: High }, // 60D5h Touch probe 1 positive edge counter
    ObjectRow { first: 24790, last: 24790, name: Part(12381, 35), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0), about: Part(12416, 42), confidence: High }, // 60D6h Touch probe 1 negative edge counter
    ObjectRow { first: 24791, last: 24791, name: Part(12458, 35), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0), about: Part(12493, 41), confidence: High }, // 60D7h Touch probe 2 positive edge counter
    ObjectRow { first: 24792, last: 24792, name: Part(12534, 35), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0), about: Part(12569, 42), confidence: High }, // 60D8h Touch probe 2 negative edge counter
    ObjectRow { first: 24800, last: 24800, name: Part(12611, 27), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(100, 1), source: Part(9870, 9), about: Part(12638, 41), confidence: Medium }, // 60E0h Positive torque limit value
    ObjectRow { first: 24801, last: 24801, name: Part(12679, 27), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(100, 1), source: Part(9870, 9), about: Part(12706, 41), confidence: Medium }, // 60E1h Negative torque limit value
    ObjectRow { first: 24803, last: 24803, name: Part(12747, 24), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(101, 3), source: Part(9870, 9), about: Part(12771, 49), confidence: Medium }, // 60E3h Supported homing methods
    ObjectRow { first: 24804, last: 24804, name: Part(12820, 32), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(104, 3), source: Part(9870, 9), about: Part(12852, 34), confidence: Medium }, // 60E4h Additional position actual value
    ObjectRow { first: 24805, last: 24805, name: Part(12886, 32), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(107, 3), source: Part(9870, 9), about: Part(12918, 31), confidence: Medium }, // 60E5h Additional velocity actual value
    ObjectRow { first: 24806, last: 24806, name: Part(12949, 58), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0), about: Part(13007, 93), confidence: High }, // 60E6h Additional position encoder resolution, encoder increments
    ObjectRow { first: 24807, last: 24807, name: Part(13100, 69), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0), about: Part(13169, 104), confidence: High }, // 60E7h Additional velocity encoder resolution, encoder increments per second
    ObjectRow { first: 24808, last: 24808, name: Part(13273, 46), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0), about: Part(13319, 87), confidence: High }, // 60E8h Additional gear ratio, motor shaft revolutions
    ObjectRow { first: 24809, last: 24809, name: Part(13406, 30), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0), about: Part(13436, 66), confidence: High }, // 60E9h Additional feed constant, feed
    ObjectRow { first: 24810, last: 24810, name: Part(13502, 17), object_types: Part(0, 1), need: When(11), only: None, as_many_as: Part(0, 0), entries: Part(110, 1), source: Part(9870, 9), about: Part(13519, 102), confidence: Medium }, // 60EAh Commutation angle
    ObjectRow { first: 24811, last: 24811, name: Part(13621, 57), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0), about: Part(13678, 73), confidence: High }, // 60EBh Additional position encoder resolution, motor revolutions
    ObjectRow { first: 24812, last: 24812, name: Part(13751, 68), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0), about: Part(13819, 84), confidence: High }, // 60ECh Additional velocity encoder resolution, motor revolutions per second
    ObjectRow { first: 24813, last: 24813, name: Part(13903, 48), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0), about: Part(13951, 64), confidence: High }, // 60EDh Additional gear ratio, driving shaft revolutions
    ObjectRow { first: 24814, last: 24814, name: Part(14015, 51), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0), about: Part(14066, 58), confidence: High }, // 60EEh Additional feed constant, driving shaft revolutions
    ObjectRow { first: 24818, last: 24818, name: Part(14386, 23), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(111, 1), source: Part(0, 0), about: Part(14409, 107), confidence: High }, // 60F2h Positioning option code
    ObjectRow { first: 24820, last: 24820, name: Part(14516, 28), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(31, 1), source: Part(0, 0), about: Part(14544, 52), confidence: High }, // 60F4h Following error actual value
    ObjectRow { first: 24822, last: 24822, name: Part(14596, 28), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0), about: Part(14624, 66), confidence: High }, // 60F6h Torque control parameter set
    ObjectRow { first: 24823, last: 24823, name: Part(14690, 22), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0), about: Part(14712, 60), confidence: High }, // 60F7h Power stage parameters
    ObjectRow { first: 24824, last: 24824, name: Part(14772, 12), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(112, 1), source: Part(0, 0), about: Part(14784, 81), confidence: High }, // 60F8h Max slippage
    ObjectRow { first: 24825, last: 24825, name: Part(14865, 30), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0), about: Part(14895, 68), confidence: High }, // 60F9h Velocity control parameter set
    ObjectRow { first: 24826, last: 24826, name: Part(14963, 14), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(31, 1), source: Part(0, 0), about: Part(14977, 38), confidence: High }, // 60FAh Control effort
    ObjectRow { first: 24827, last: 24827, name: Part(15015, 30), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0), about: Part(15045, 68), confidence: High }, // 60FBh Position control parameter set
    ObjectRow { first: 24828, last: 24828, name: Part(15113, 30), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(31, 1), source: Part(0, 0), about: Part(15143, 51), confidence: High }, // 60FCh Position demand internal value
    ObjectRow { first: 24829, last: 24829, name: Part(15214, 14), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(113, 1), source: Part(0, 0), about: Part(15228, 75), confidence: High }, // 60FDh Digital inputs
    ObjectRow { first: 24830, last: 24830, name: Part(15336, 15), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(114, 3), source: Part(0, 0), about: Part(15351, 54), confidence: High }, // 60FEh Digital outputs
    ObjectRow { first: 24831, last: 24831, name: Part(15405, 15), object_types: Part(0, 1), need: When(2), only: None, as_many_as: Part(0, 0), entries: Part(44, 1), source: Part(0, 0), about: Part(15420, 67), confidence: High }, // 60FFh Target velocity
    ObjectRow { first: 25602, last: 25602, name: Part(15821, 10), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(117, 1), source: Part(0, 0), about: Part(15831, 22), confidence: High }, // 6402h Motor type
    ObjectRow { first: 25603, last: 25603, name: Part(15853, 22), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(118, 1), source: Part(0, 0), about: Part(15875, 34), confidence: High }, // 6403h Motor catalogue number
    ObjectRow { first: 25604, last: 25604, name: Part(15909, 18), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(118, 1), source: Part(0, 0), about: Part(15927, 30), confidence: High }, // 6404h Motor manufacturer
    ObjectRow { first: 25605, last: 25605, name: Part(15957, 28), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(118, 1), source: Part(0, 0), about: Part(15985, 41), confidence: High }, // 6405h HTTP motor catalogue address
    ObjectRow { first: 25606, last: 25606, name: Part(16026, 22), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(119, 1), source: Part(0, 0), about: Part(16048, 34), confidence: High }, // 6406h Motor calibration date
    ObjectRow { first: 25607, last: 25607, name: Part(16083, 20), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(120, 1), source: Part(0, 0), about: Part(16103, 45), confidence: High }, // 6407h Motor service period
    ObjectRow { first: 25616, last: 25616, name: Part(16148, 10), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0), about: Part(16158, 44), confidence: High }, // 6410h Motor data
    ObjectRow { first: 25858, last: 25858, name: Part(16202, 21), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(121, 1), source: Part(16223, 59), about: Part(16282, 61), confidence: High }, // 6502h Supported drive modes
    ObjectRow { first: 25859, last: 25859, name: Part(16343, 22), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(118, 1), source: Part(0, 0), about: Part(16365, 34), confidence: High }, // 6503h Drive catalogue number
    ObjectRow { first: 25860, last: 25860, name: Part(16399, 18), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(118, 1), source: Part(0, 0), about: Part(16417, 30), confidence: High }, // 6504h Drive manufacturer
    ObjectRow { first: 25861, last: 25861, name: Part(16447, 28), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(118, 1), source: Part(0, 0), about: Part(16475, 41), confidence: High }, // 6505h HTTP drive catalogue address
    ObjectRow { first: 25872, last: 25872, name: Part(16516, 10), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0), about: Part(16526, 44), confidence: High }, // 6510h Drive data
    ObjectRow { first: 26622, last: 26622, name: Part(16570, 14), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0), about: Part(16584, 50), confidence: High }, // 67FEh Version number
    ObjectRow { first: 26623, last: 26623, name: Part(16634, 18), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(122, 1), source: Part(0, 0), about: Part(16652, 57), confidence: High }, // 67FFh Single device type
];

static ENTRIES: &[EntryRow] = &[
    EntryRow { first: 0, last: 0, mapping: None, need: Optional, name: Part(0, 0), data_types: Part(0, 0), access: Part(0, 0), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 5) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, unit: Part(0, 0), bits: Part(5, 1) },
    EntryRow { first: 0, last: 0, mapping: Some(Tpdo), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(6, 9) },
    EntryRow { first: 0, last: 0, mapping: Some(Tpdo), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(15, 15) },
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(Tpdo), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(1122, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1149, 22), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // vl velocity min amount
    EntryRow { first: 2, last: 2, mapping: None, need: Mandatory, name: Part(1171, 22), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // vl velocity max amount
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(1122, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1379, 11), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Delta speed
    EntryRow { first: 2, last: 2, mapping: None, need: Mandatory, name: Part(1390, 10), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(1400, 1), bits: Part(0, 0) }, // Delta time
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(1122, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1712, 29), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // vl set-point factor numerator
    EntryRow { first: 2, last: 2, mapping: None, need: Mandatory, name: Part(1741, 31), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // vl set-point factor denominator
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(1122, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(1856, 29), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // vl dimension factor numerator
    EntryRow { first: 2, last: 2, mapping: None, need: Mandatory, name: Part(1885, 31), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // vl dimension factor denominator
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(2, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(2132, 2), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: Some(0), unit: Part(0, 0), bits: Part(30, 1) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(3, 1), default: Some(1), unit: Part(0, 0), bits: Part(31, 1) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(3, 1), default: Some(2), unit: Part(0, 0), bits: Part(31, 1) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(4, 1), default: Some(2), unit: Part(0, 0), bits: Part(32, 1) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(4, 1), default: Some(0), unit: Part(0, 0), bits: Part(32, 1) },
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(5, 1), access: Part(4, 2), values: Part(5, 2), default: None, unit: Part(0, 0), bits: Part(33, 1) },
    EntryRow { first: 0, last: 0, mapping: Some(Tpdo), need: Mandatory, name: Part(0, 0), data_types: Part(5, 1), access: Part(1, 1), values: Part(5, 2), default: None, unit: Part(0, 0), bits: Part(33, 1) },
    EntryRow { first: 0, last: 0, mapping: Some(Tpdo), need: Mandatory, name: Part(0, 0), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(2132, 2), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(34, 1) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(5486, 25), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(5486, 25), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(5645, 26), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(Tpdo), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(5486, 25), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(3, 1), access: Part(6, 2), values: Part(0, 0), default: None, unit: Part(5790, 2), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(3, 1), access: Part(6, 2), values: Part(0, 0), default: None, unit: Part(5876, 3), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(Tpdo), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(5645, 26), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(Tpdo), need: Mandatory, name: Part(0, 0), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(6036, 2), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(1122, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(6173, 24), data_types: Part(4, 1), access: Part(6, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Min position range limit
    EntryRow { first: 2, last: 2, mapping: None, need: Mandatory, name: Part(6197, 24), data_types: Part(4, 1), access: Part(6, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Max position range limit
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(1122, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(6412, 18), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Min position limit
    EntryRow { first: 2, last: 2, mapping: None, need: Mandatory, name: Part(6430, 18), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Max position limit
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(2, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(35, 2) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(6668, 3), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, unit: Part(0, 0), bits: Part(37, 1) },
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(7171, 36), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(3, 1), default: None, unit: Part(0, 0), bits: Part(38, 1) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(5, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(1122, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(7859, 18), data_types: Part(3, 1), access: Part(6, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Encoder increments
    EntryRow { first: 2, last: 2, mapping: None, need: Mandatory, name: Part(7877, 17), data_types: Part(3, 1), access: Part(6, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Motor revolutions
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(1122, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(8013, 29), data_types: Part(3, 1), access: Part(6, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Encoder increments per second
    EntryRow { first: 2, last: 2, mapping: None, need: Mandatory, name: Part(8042, 28), data_types: Part(3, 1), access: Part(6, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Motor revolutions per second
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(1122, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(7877, 17), data_types: Part(3, 1), access: Part(6, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Motor revolutions
    EntryRow { first: 2, last: 2, mapping: None, need: Mandatory, name: Part(8198, 17), data_types: Part(3, 1), access: Part(6, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Shaft revolutions
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(1122, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(8295, 4), data_types: Part(3, 1), access: Part(6, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Feed
    EntryRow { first: 2, last: 2, mapping: None, need: Mandatory, name: Part(8198, 17), data_types: Part(3, 1), access: Part(6, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Shaft revolutions
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(1122, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(8386, 9), data_types: Part(3, 1), access: Part(6, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Numerator
    EntryRow { first: 2, last: 2, mapping: None, need: Mandatory, name: Part(8299, 13), data_types: Part(3, 1), access: Part(6, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Feed constant
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(1122, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(8386, 9), data_types: Part(3, 1), access: Part(6, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Numerator
    EntryRow { first: 2, last: 2, mapping: None, need: Mandatory, name: Part(8477, 7), data_types: Part(3, 1), access: Part(6, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Divisor
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(5, 1), access: Part(0, 1), values: Part(7, 4), default: None, unit: Part(0, 0), bits: Part(39, 1) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(1122, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(9388, 30), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Speed during search for switch
    EntryRow { first: 2, last: 2, mapping: Some(Any), need: Mandatory, name: Part(9418, 28), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Speed during search for zero
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(2, 1), access: Part(0, 1), values: Part(11, 4), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(1122, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(15, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(9721, 14), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Profile jerk 1
    EntryRow { first: 2, last: 6, mapping: None, need: Optional, name: Part(9735, 19), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Profile jerk 2 to 6
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(3, 1), access: Part(6, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(40, 3) },
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(43, 12) },
    EntryRow { first: 0, last: 0, mapping: Some(Tpdo), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(55, 8) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(63, 1) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(1122, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(16, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(11199, 11), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Set-point 1
    EntryRow { first: 2, last: 254, mapping: Some(Any), need: Optional, name: Part(11210, 18), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Set-point 2 to 254
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(1122, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(11298, 31), data_types: Part(2, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Interpolation time period value
    EntryRow { first: 2, last: 2, mapping: None, need: Mandatory, name: Part(11329, 24), data_types: Part(5, 1), access: Part(0, 1), values: Part(17, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Interpolation time index
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(1122, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(18, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(11561, 19), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Maximum buffer size
    EntryRow { first: 2, last: 2, mapping: None, need: Mandatory, name: Part(11580, 18), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Actual buffer size
    EntryRow { first: 3, last: 3, mapping: None, need: Mandatory, name: Part(11618, 19), data_types: Part(2, 1), access: Part(0, 1), values: Part(19, 2), default: None, unit: Part(0, 0), bits: Part(64, 1) }, // Buffer organization
    EntryRow { first: 4, last: 4, mapping: None, need: Mandatory, name: Part(11637, 15), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Buffer position
    EntryRow { first: 5, last: 5, mapping: None, need: Mandatory, name: Part(11652, 19), data_types: Part(2, 1), access: Part(8, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Size of data record
    EntryRow { first: 6, last: 6, mapping: None, need: Mandatory, name: Part(11671, 12), data_types: Part(2, 1), access: Part(8, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Buffer clear
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(6, 2), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(5486, 25), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(1122, 27), data_types: Part(2, 1), access: Part(1, 1), values: Part(16, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(12747, 24), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Supported homing methods
    EntryRow { first: 2, last: 254, mapping: None, need: Optional, name: Part(12747, 24), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Supported homing methods
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(1122, 27), data_types: Part(2, 1), access: Part(1, 1), values: Part(16, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(12820, 32), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Additional position actual value
    EntryRow { first: 2, last: 254, mapping: Some(Tpdo), need: Optional, name: Part(12820, 32), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Additional position actual value
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(1122, 27), data_types: Part(2, 1), access: Part(1, 1), values: Part(16, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(12886, 32), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Additional velocity actual value
    EntryRow { first: 2, last: 254, mapping: Some(Tpdo), need: Optional, name: Part(12886, 32), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Additional velocity actual value
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(65, 7) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(Tpdo), need: Mandatory, name: Part(0, 0), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(72, 5) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(1122, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(21, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(15312, 16), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(77, 2) }, // Physical outputs
    EntryRow { first: 2, last: 2, mapping: Some(Any), need: Optional, name: Part(15328, 8), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(77, 2) }, // Bit mask
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(6, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(79, 1) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(8, 1), access: Part(6, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(9, 1), access: Part(6, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(3, 1), access: Part(6, 2), values: Part(0, 0), default: None, unit: Part(16082, 1), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(80, 11) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 5) },
];

static BITS: &[BitRow] = &[
    BitRow { first: 16, last: 16, name: Part(0, 19), values: Part(0, 0) }, // frequency converter
    BitRow { first: 17, last: 17, name: Part(19, 11), values: Part(0, 0) }, // servo drive
    BitRow { first: 18, last: 18, name: Part(30, 13), values: Part(0, 0) }, // stepper motor
    BitRow { first: 22, last: 22, name: Part(43, 31), values: Part(0, 0) }, // PDO mapping of the manufacturer
    BitRow { first: 24, last: 31, name: Part(74, 19), values: Part(0, 0) }, // of the manufacturer
    BitRow { first: 0, last: 15, name: Part(155, 8), values: Part(0, 5) }, // reaction
    BitRow { first: 0, last: 0, name: Part(379, 9), values: Part(0, 0) }, // switch on
    BitRow { first: 1, last: 1, name: Part(388, 14), values: Part(0, 0) }, // enable voltage
    BitRow { first: 2, last: 2, name: Part(402, 14), values: Part(0, 0) }, // quick stop off
    BitRow { first: 3, last: 3, name: Part(416, 16), values: Part(0, 0) }, // enable operation
    BitRow { first: 4, last: 6, name: Part(432, 11), values: Part(0, 0) }, // of the mode
    BitRow { first: 7, last: 7, name: Part(443, 11), values: Part(0, 0) }, // fault reset
    BitRow { first: 8, last: 8, name: Part(454, 4), values: Part(0, 0) }, // halt
    BitRow { first: 9, last: 9, name: Part(432, 11), values: Part(0, 0) }, // of the mode
    BitRow { first: 11, last: 15, name: Part(74, 19), values: Part(0, 0) }, // of the manufacturer
    BitRow { first: 0, last: 6, name: Part(544, 5), values: Part(5, 24) }, // state
    BitRow { first: 0, last: 0, name: Part(614, 18), values: Part(0, 0) }, // ready to switch on
    BitRow { first: 1, last: 1, name: Part(632, 11), values: Part(0, 0) }, // switched on
    BitRow { first: 2, last: 2, name: Part(643, 17), values: Part(0, 0) }, // operation enabled
    BitRow { first: 3, last: 3, name: Part(588, 5), values: Part(0, 0) }, // fault
    BitRow { first: 4, last: 4, name: Part(678, 15), values: Part(0, 0) }, // voltage enabled
    BitRow { first: 5, last: 5, name: Part(402, 14), values: Part(0, 0) }, // quick stop off
    BitRow { first: 6, last: 6, name: Part(660, 18), values: Part(0, 0) }, // switch on disabled
    BitRow { first: 7, last: 7, name: Part(693, 7), values: Part(0, 0) }, // warning
    BitRow { first: 8, last: 8, name: Part(74, 19), values: Part(0, 0) }, // of the manufacturer
    BitRow { first: 9, last: 9, name: Part(700, 6), values: Part(0, 0) }, // remote
    BitRow { first: 10, last: 10, name: Part(706, 14), values: Part(0, 0) }, // target reached
    BitRow { first: 11, last: 11, name: Part(720, 21), values: Part(0, 0) }, // internal limit active
    BitRow { first: 12, last: 13, name: Part(432, 11), values: Part(0, 0) }, // of the mode
    BitRow { first: 14, last: 15, name: Part(74, 19), values: Part(0, 0) }, // of the manufacturer
    BitRow { first: 0, last: 15, name: Part(155, 8), values: Part(29, 10) }, // reaction
    BitRow { first: 0, last: 15, name: Part(155, 8), values: Part(39, 3) }, // reaction
    BitRow { first: 0, last: 15, name: Part(155, 8), values: Part(42, 6) }, // reaction
    BitRow { first: 0, last: 7, name: Part(3935, 4), values: Part(48, 12) }, // mode
    BitRow { first: 0, last: 15, name: Part(4902, 22), values: Part(60, 3) }, // source of the velocity
    BitRow { first: 6, last: 6, name: Part(6530, 17), values: Part(0, 0) }, // velocity times -1
    BitRow { first: 7, last: 7, name: Part(6547, 17), values: Part(0, 0) }, // position times -1
    BitRow { first: 0, last: 15, name: Part(7050, 5), values: Part(63, 5) }, // shape
    BitRow { first: 0, last: 15, name: Part(7050, 5), values: Part(68, 3) }, // shape
    BitRow { first: 0, last: 7, name: Part(8824, 6), values: Part(71, 18) }, // method
    BitRow { first: 8, last: 15, name: Part(9813, 11), values: Part(0, 0) }, // denominator
    BitRow { first: 16, last: 23, name: Part(9824, 9), values: Part(0, 0) }, // numerator
    BitRow { first: 24, last: 31, name: Part(9833, 21), values: Part(0, 0) }, // prefix, a power of 10
    BitRow { first: 0, last: 0, name: Part(10202, 16), values: Part(0, 0) }, // touch probe 1 on
    BitRow { first: 1, last: 1, name: Part(10218, 24), values: Part(0, 0) }, // touch probe 1 continuous
    BitRow { first: 2, last: 3, name: Part(10242, 20), values: Part(89, 3) }, // touch probe 1 source
    BitRow { first: 4, last: 4, name: Part(10285, 35), values: Part(0, 0) }, // touch probe 1 samples positive edge
    BitRow { first: 5, last: 5, name: Part(10320, 35), values: Part(0, 0) }, // touch probe 1 samples negative edge
    BitRow { first: 6, last: 7, name: Part(74, 19), values: Part(0, 0) }, // of the manufacturer
    BitRow { first: 8, last: 8, name: Part(10355, 16), values: Part(0, 0) }, // touch probe 2 on
    BitRow { first: 9, last: 9, name: Part(10371, 24), values: Part(0, 0) }, // touch probe 2 continuous
    BitRow { first: 10, last: 11, name: Part(10395, 20), values: Part(92, 3) }, // touch probe 2 source
    BitRow { first: 12, last: 12, name: Part(10422, 35), values: Part(0, 0) }, // touch probe 2 samples positive edge
    BitRow { first: 13, last: 13, name: Part(10457, 35), values: Part(0, 0) }, // touch probe 2 samples negative edge
    BitRow { first: 14, last: 15, name: Part(74, 19), values: Part(0, 0) }, // of the manufacturer
    BitRow { first: 0, last: 0, name: Part(10202, 16), values: Part(0, 0) }, // touch probe 1 on
    BitRow { first: 1, last: 1, name: Part(10549, 31), values: Part(0, 0) }, // touch probe 1 has positive edge
    BitRow { first: 2, last: 2, name: Part(10580, 31), values: Part(0, 0) }, // touch probe 1 has negative edge
    BitRow { first: 6, last: 7, name: Part(74, 19), values: Part(0, 0) }, // of the manufacturer
    BitRow { first: 8, last: 8, name: Part(10355, 16), values: Part(0, 0) }, // touch probe 2 on
    BitRow { first: 9, last: 9, name: Part(10611, 31), values: Part(0, 0) }, // touch probe 2 has positive edge
    BitRow { first: 10, last: 10, name: Part(10642, 31), values: Part(0, 0) }, // touch probe 2 has negative edge
    BitRow { first: 14, last: 15, name: Part(74, 19), values: Part(0, 0) }, // of the manufacturer
    BitRow { first: 0, last: 15, name: Part(11061, 13), values: Part(95, 2) }, // interpolation
    BitRow { first: 0, last: 7, name: Part(11598, 12), values: Part(97, 2) }, // organization
    BitRow { first: 0, last: 1, name: Part(14124, 11), values: Part(99, 3) }, // relative to
    BitRow { first: 2, last: 3, name: Part(14197, 6), values: Part(102, 2) }, // change
    BitRow { first: 4, last: 5, name: Part(14265, 20), values: Part(0, 0) }, // request and response
    BitRow { first: 6, last: 7, name: Part(14285, 11), values: Part(104, 4) }, // rotary axis
    BitRow { first: 8, last: 11, name: Part(11061, 13), values: Part(0, 0) }, // interpolation
    BitRow { first: 12, last: 14, name: Part(14378, 8), values: Part(0, 0) }, // reserved
    BitRow { first: 15, last: 15, name: Part(74, 19), values: Part(0, 0) }, // of the manufacturer
    BitRow { first: 0, last: 0, name: Part(9077, 21), values: Part(0, 0) }, // negative limit switch
    BitRow { first: 1, last: 1, name: Part(9098, 21), values: Part(0, 0) }, // positive limit switch
    BitRow { first: 2, last: 2, name: Part(15194, 11), values: Part(0, 0) }, // home switch
    BitRow { first: 3, last: 3, name: Part(15205, 9), values: Part(0, 0) }, // interlock
    BitRow { first: 16, last: 31, name: Part(74, 19), values: Part(0, 0) }, // of the manufacturer
    BitRow { first: 0, last: 0, name: Part(15303, 9), values: Part(0, 0) }, // set brake
    BitRow { first: 16, last: 31, name: Part(74, 19), values: Part(0, 0) }, // of the manufacturer
    BitRow { first: 0, last: 15, name: Part(15487, 5), values: Part(108, 13) }, // motor
    BitRow { first: 0, last: 0, name: Part(3946, 16), values: Part(0, 0) }, // profile position
    BitRow { first: 1, last: 1, name: Part(3962, 8), values: Part(0, 0) }, // velocity
    BitRow { first: 2, last: 2, name: Part(3970, 16), values: Part(0, 0) }, // profile velocity
    BitRow { first: 3, last: 3, name: Part(3986, 14), values: Part(0, 0) }, // torque profile
    BitRow { first: 5, last: 5, name: Part(4000, 6), values: Part(0, 0) }, // homing
    BitRow { first: 6, last: 6, name: Part(4006, 21), values: Part(0, 0) }, // interpolated position
    BitRow { first: 7, last: 7, name: Part(4027, 27), values: Part(0, 0) }, // cyclic synchronous position
    BitRow { first: 8, last: 8, name: Part(4054, 27), values: Part(0, 0) }, // cyclic synchronous velocity
    BitRow { first: 9, last: 9, name: Part(4081, 25), values: Part(0, 0) }, // cyclic synchronous torque
    BitRow { first: 10, last: 10, name: Part(4106, 48), values: Part(0, 0) }, // cyclic synchronous torque with commutation angle
    BitRow { first: 16, last: 31, name: Part(74, 19), values: Part(0, 0) }, // of the manufacturer
];

static MEANINGS: &[MeaningRow] = &[
    MeaningRow { first: 0, last: 0, text: Part(163, 9) }, // no action
    MeaningRow { first: 1, last: 1, text: Part(172, 12) }, // fault signal
    MeaningRow { first: 2, last: 2, text: Part(184, 15) }, // disable voltage
    MeaningRow { first: 3, last: 3, text: Part(199, 10) }, // quick stop
    MeaningRow { first: 32768, last: 65535, text: Part(209, 21) }, // manufacturer-specific
    MeaningRow { first: 0, last: 0, text: Part(549, 22) }, // not ready to switch on
    MeaningRow { first: 7, last: 7, text: Part(571, 17) }, // quick stop active
    MeaningRow { first: 8, last: 8, text: Part(588, 5) }, // fault
    MeaningRow { first: 15, last: 15, text: Part(593, 21) }, // fault reaction active
    MeaningRow { first: 16, last: 16, text: Part(549, 22) }, // not ready to switch on
    MeaningRow { first: 23, last: 23, text: Part(571, 17) }, // quick stop active
    MeaningRow { first: 24, last: 24, text: Part(588, 5) }, // fault
    MeaningRow { first: 31, last: 31, text: Part(593, 21) }, // fault reaction active
    MeaningRow { first: 32, last: 32, text: Part(549, 22) }, // not ready to switch on
    MeaningRow { first: 33, last: 33, text: Part(614, 18) }, // ready to switch on
    MeaningRow { first: 35, last: 35, text: Part(632, 11) }, // switched on
    MeaningRow { first: 39, last: 39, text: Part(643, 17) }, // operation enabled
    MeaningRow { first: 40, last: 40, text: Part(588, 5) }, // fault
    MeaningRow { first: 47, last: 47, text: Part(593, 21) }, // fault reaction active
    MeaningRow { first: 48, last: 48, text: Part(549, 22) }, // not ready to switch on
    MeaningRow { first: 49, last: 49, text: Part(614, 18) }, // ready to switch on
    MeaningRow { first: 51, last: 51, text: Part(632, 11) }, // switched on
    MeaningRow { first: 55, last: 55, text: Part(643, 17) }, // operation enabled
    MeaningRow { first: 56, last: 56, text: Part(588, 5) }, // fault
    MeaningRow { first: 63, last: 63, text: Part(593, 21) }, // fault reaction active
    MeaningRow { first: 64, last: 64, text: Part(660, 18) }, // switch on disabled
    MeaningRow { first: 80, last: 80, text: Part(660, 18) }, // switch on disabled
    MeaningRow { first: 96, last: 96, text: Part(660, 18) }, // switch on disabled
    MeaningRow { first: 112, last: 112, text: Part(660, 18) }, // switch on disabled
    MeaningRow { first: 0, last: 0, text: Part(3128, 22) }, // disable drive function
    MeaningRow { first: 1, last: 1, text: Part(3150, 39) }, // slow down ramp, then switch on disabled
    MeaningRow { first: 2, last: 2, text: Part(3189, 40) }, // quick stop ramp, then switch on disabled
    MeaningRow { first: 3, last: 3, text: Part(3229, 38) }, // current limit, then switch on disabled
    MeaningRow { first: 4, last: 4, text: Part(3267, 38) }, // voltage limit, then switch on disabled
    MeaningRow { first: 5, last: 5, text: Part(3305, 41) }, // slow down ramp, stay in quick stop active
    MeaningRow { first: 6, last: 6, text: Part(3346, 42) }, // quick stop ramp, stay in quick stop active
    MeaningRow { first: 7, last: 7, text: Part(3388, 40) }, // current limit, stay in quick stop active
    MeaningRow { first: 8, last: 8, text: Part(3428, 40) }, // voltage limit, stay in quick stop active
    MeaningRow { first: 32768, last: 65535, text: Part(209, 21) }, // manufacturer-specific
    MeaningRow { first: 0, last: 0, text: Part(3128, 22) }, // disable drive function
    MeaningRow { first: 1, last: 1, text: Part(3536, 28) }, // slow down ramp, then disable
    MeaningRow { first: 32768, last: 65535, text: Part(209, 21) }, // manufacturer-specific
    MeaningRow { first: 0, last: 0, text: Part(3128, 22) }, // disable drive function
    MeaningRow { first: 1, last: 1, text: Part(3734, 14) }, // slow down ramp
    MeaningRow { first: 2, last: 2, text: Part(3748, 15) }, // quick stop ramp
    MeaningRow { first: 3, last: 3, text: Part(3763, 13) }, // current limit
    MeaningRow { first: 4, last: 4, text: Part(3776, 13) }, // voltage limit
    MeaningRow { first: 32768, last: 65535, text: Part(209, 21) }, // manufacturer-specific
    MeaningRow { first: 0, last: 0, text: Part(3939, 7) }, // no mode
    MeaningRow { first: 1, last: 1, text: Part(3946, 16) }, // profile position
    MeaningRow { first: 2, last: 2, text: Part(3962, 8) }, // velocity
    MeaningRow { first: 3, last: 3, text: Part(3970, 16) }, // profile velocity
    MeaningRow { first: 4, last: 4, text: Part(3986, 14) }, // torque profile
    MeaningRow { first: 6, last: 6, text: Part(4000, 6) }, // homing
    MeaningRow { first: 7, last: 7, text: Part(4006, 21) }, // interpolated position
    MeaningRow { first: 8, last: 8, text: Part(4027, 27) }, // cyclic synchronous position
    MeaningRow { first: 9, last: 9, text: Part(4054, 27) }, // cyclic synchronous velocity
    MeaningRow { first: 10, last: 10, text: Part(4081, 25) }, // cyclic synchronous torque
    MeaningRow { first: 11, last: 11, text: Part(4106, 48) }, // cyclic synchronous torque with commutation angle
    MeaningRow { first: 128, last: 255, text: Part(209, 21) }, // manufacturer-specific
    MeaningRow { first: 0, last: 0, text: Part(4924, 16) }, // position encoder
    MeaningRow { first: 1, last: 1, text: Part(4940, 16) }, // velocity encoder
    MeaningRow { first: 32768, last: 65535, text: Part(209, 21) }, // manufacturer-specific
    MeaningRow { first: 0, last: 0, text: Part(7055, 11) }, // linear ramp
    MeaningRow { first: 1, last: 1, text: Part(7066, 10) }, // sin² ramp
    MeaningRow { first: 2, last: 2, text: Part(7076, 14) }, // jerk-free ramp
    MeaningRow { first: 3, last: 3, text: Part(7090, 17) }, // jerk-limited ramp
    MeaningRow { first: 32768, last: 65535, text: Part(209, 21) }, // manufacturer-specific
    MeaningRow { first: 0, last: 0, text: Part(7055, 11) }, // linear ramp
    MeaningRow { first: 1, last: 1, text: Part(7066, 10) }, // sin² ramp
    MeaningRow { first: 32768, last: 65535, text: Part(209, 21) }, // manufacturer-specific
    MeaningRow { first: 0, last: 0, text: Part(8830, 9) }, // no homing
    MeaningRow { first: 1, last: 1, text: Part(8839, 37) }, // negative limit switch and index pulse
    MeaningRow { first: 2, last: 2, text: Part(8876, 37) }, // positive limit switch and index pulse
    MeaningRow { first: 3, last: 4, text: Part(8913, 36) }, // positive home switch and index pulse
    MeaningRow { first: 5, last: 6, text: Part(8949, 36) }, // negative home switch and index pulse
    MeaningRow { first: 7, last: 10, text: Part(8985, 46) }, // home switch and index pulse, starting positive
    MeaningRow { first: 11, last: 14, text: Part(9031, 46) }, // home switch and index pulse, starting negative
    MeaningRow { first: 17, last: 17, text: Part(9077, 21) }, // negative limit switch
    MeaningRow { first: 18, last: 18, text: Part(9098, 21) }, // positive limit switch
    MeaningRow { first: 19, last: 20, text: Part(9119, 20) }, // positive home switch
    MeaningRow { first: 21, last: 22, text: Part(9139, 20) }, // negative home switch
    MeaningRow { first: 23, last: 26, text: Part(9159, 30) }, // home switch, starting positive
    MeaningRow { first: 27, last: 30, text: Part(9189, 30) }, // home switch, starting negative
    MeaningRow { first: 33, last: 33, text: Part(9219, 33) }, // index pulse in negative direction
    MeaningRow { first: 34, last: 34, text: Part(9252, 33) }, // index pulse in positive direction
    MeaningRow { first: 35, last: 35, text: Part(9285, 28) }, // current position (version 2)
    MeaningRow { first: 37, last: 37, text: Part(9313, 16) }, // current position
    MeaningRow { first: 128, last: 255, text: Part(209, 21) }, // manufacturer-specific
    MeaningRow { first: 0, last: 0, text: Part(10262, 5) }, // input
    MeaningRow { first: 1, last: 1, text: Part(10267, 11) }, // index pulse
    MeaningRow { first: 2, last: 2, text: Part(10278, 7) }, // 60D0h:1
    MeaningRow { first: 0, last: 0, text: Part(10262, 5) }, // input
    MeaningRow { first: 1, last: 1, text: Part(10267, 11) }, // index pulse
    MeaningRow { first: 2, last: 2, text: Part(10415, 7) }, // 60D0h:2
    MeaningRow { first: 0, last: 0, text: Part(11074, 20) }, // linear interpolation
    MeaningRow { first: 32768, last: 65535, text: Part(209, 21) }, // manufacturer-specific
    MeaningRow { first: 0, last: 0, text: Part(11610, 4) }, // FIFO
    MeaningRow { first: 1, last: 1, text: Part(11614, 4) }, // ring
    MeaningRow { first: 0, last: 0, text: Part(14135, 20) }, // last target position
    MeaningRow { first: 1, last: 1, text: Part(14155, 21) }, // position demand value
    MeaningRow { first: 2, last: 2, text: Part(14176, 21) }, // position actual value
    MeaningRow { first: 0, last: 0, text: Part(14203, 7) }, // at once
    MeaningRow { first: 1, last: 1, text: Part(14210, 55) }, // of the set-point at once, of the rest with the next one
    MeaningRow { first: 0, last: 0, text: Part(14296, 40) }, // within one revolution like a linear axis
    MeaningRow { first: 1, last: 1, text: Part(14336, 15) }, // always negative
    MeaningRow { first: 2, last: 2, text: Part(14351, 15) }, // always positive
    MeaningRow { first: 3, last: 3, text: Part(14366, 12) }, // shortest way
    MeaningRow { first: 0, last: 0, text: Part(15492, 18) }, // non-standard motor
    MeaningRow { first: 1, last: 1, text: Part(15510, 24) }, // phase modulated DC motor
    MeaningRow { first: 2, last: 2, text: Part(15534, 29) }, // frequency controlled DC motor
    MeaningRow { first: 3, last: 3, text: Part(15563, 34) }, // permanent magnet synchronous motor
    MeaningRow { first: 4, last: 4, text: Part(15597, 38) }, // frequency controlled synchronous motor
    MeaningRow { first: 5, last: 5, text: Part(15635, 25) }, // switched reluctance motor
    MeaningRow { first: 6, last: 6, text: Part(15660, 27) }, // wound rotor induction motor
    MeaningRow { first: 7, last: 7, text: Part(15687, 29) }, // squirrel cage induction motor
    MeaningRow { first: 8, last: 8, text: Part(30, 13) }, // stepper motor
    MeaningRow { first: 9, last: 9, text: Part(15716, 24) }, // micro-step stepper motor
    MeaningRow { first: 10, last: 10, text: Part(15740, 43) }, // brushless motor with sinusoidal commutation
    MeaningRow { first: 11, last: 11, text: Part(15783, 38) }, // brushless motor with block commutation
    MeaningRow { first: 32768, last: 65535, text: Part(209, 21) }, // manufacturer-specific
    MeaningRow { first: 8464, last: 8464, text: Part(16709, 42) }, // short circuit or earth leakage, input side
    MeaningRow { first: 8480, last: 8480, text: Part(16751, 25) }, // earth leakage, input side
    MeaningRow { first: 8481, last: 8481, text: Part(16776, 23) }, // earth leakage, phase L1
    MeaningRow { first: 8482, last: 8482, text: Part(16799, 23) }, // earth leakage, phase L2
    MeaningRow { first: 8483, last: 8483, text: Part(16822, 23) }, // earth leakage, phase L3
    MeaningRow { first: 8496, last: 8496, text: Part(16845, 25) }, // short circuit, input side
    MeaningRow { first: 8497, last: 8497, text: Part(16870, 31) }, // short circuit, phases L1 and L2
    MeaningRow { first: 8498, last: 8498, text: Part(16901, 31) }, // short circuit, phases L2 and L3
    MeaningRow { first: 8499, last: 8499, text: Part(16932, 31) }, // short circuit, phases L3 and L1
    MeaningRow { first: 8721, last: 8721, text: Part(16963, 18) }, // internal current 1
    MeaningRow { first: 8722, last: 8722, text: Part(16981, 18) }, // internal current 2
    MeaningRow { first: 8723, last: 8723, text: Part(16999, 33) }, // over-current in the ramp function
    MeaningRow { first: 8724, last: 8724, text: Part(17032, 28) }, // over-current in the sequence
    MeaningRow { first: 8736, last: 8736, text: Part(17060, 37) }, // continuous over-current in the device
    MeaningRow { first: 8737, last: 8737, text: Part(17097, 39) }, // continuous over-current 1 in the device
    MeaningRow { first: 8738, last: 8738, text: Part(17136, 39) }, // continuous over-current 2 in the device
    MeaningRow { first: 8752, last: 8752, text: Part(17175, 44) }, // short circuit or earth leakage in the device
    MeaningRow { first: 8768, last: 8768, text: Part(17219, 27) }, // earth leakage in the device
    MeaningRow { first: 8784, last: 8784, text: Part(17246, 27) }, // short circuit in the device
    MeaningRow { first: 8976, last: 8976, text: Part(17273, 35) }, // continuous over-current, motor side
    MeaningRow { first: 8977, last: 8977, text: Part(17308, 37) }, // continuous over-current 1, motor side
    MeaningRow { first: 8978, last: 8978, text: Part(17345, 37) }, // continuous over-current 2, motor side
    MeaningRow { first: 8992, last: 8992, text: Part(17382, 42) }, // short circuit or earth leakage, motor side
    MeaningRow { first: 9008, last: 9008, text: Part(17424, 25) }, // earth leakage, motor side
    MeaningRow { first: 9009, last: 9009, text: Part(17449, 22) }, // earth leakage, phase U
    MeaningRow { first: 9010, last: 9010, text: Part(17471, 22) }, // earth leakage, phase V
    MeaningRow { first: 9011, last: 9011, text: Part(17493, 22) }, // earth leakage, phase W
    MeaningRow { first: 9024, last: 9024, text: Part(17515, 25) }, // short circuit, motor side
    MeaningRow { first: 9025, last: 9025, text: Part(17540, 29) }, // short circuit, phases U and V
    MeaningRow { first: 9026, last: 9026, text: Part(17569, 29) }, // short circuit, phases V and W
    MeaningRow { first: 9027, last: 9027, text: Part(17598, 29) }, // short circuit, phases W and U
    MeaningRow { first: 9040, last: 9040, text: Part(17627, 29) }, // overload (I2t, thermal state)
    MeaningRow { first: 9041, last: 9041, text: Part(17656, 38) }, // overload (I2t, thermal state), warning
    MeaningRow { first: 12560, last: 12560, text: Part(17694, 18) }, // mains over-voltage
    MeaningRow { first: 12561, last: 12561, text: Part(17712, 28) }, // mains over-voltage, phase L1
    MeaningRow { first: 12562, last: 12562, text: Part(17740, 28) }, // mains over-voltage, phase L2
    MeaningRow { first: 12563, last: 12563, text: Part(17768, 28) }, // mains over-voltage, phase L3
    MeaningRow { first: 12576, last: 12576, text: Part(17796, 19) }, // mains under-voltage
    MeaningRow { first: 12577, last: 12577, text: Part(17815, 29) }, // mains under-voltage, phase L1
    MeaningRow { first: 12578, last: 12578, text: Part(17844, 29) }, // mains under-voltage, phase L2
    MeaningRow { first: 12579, last: 12579, text: Part(17873, 29) }, // mains under-voltage, phase L3
    MeaningRow { first: 12592, last: 12592, text: Part(17902, 13) }, // phase failure
    MeaningRow { first: 12593, last: 12593, text: Part(17915, 17) }, // phase failure, L1
    MeaningRow { first: 12594, last: 12594, text: Part(17932, 17) }, // phase failure, L2
    MeaningRow { first: 12595, last: 12595, text: Part(17949, 17) }, // phase failure, L3
    MeaningRow { first: 12596, last: 12596, text: Part(17966, 14) }, // phase sequence
    MeaningRow { first: 12608, last: 12608, text: Part(17980, 15) }, // mains frequency
    MeaningRow { first: 12609, last: 12609, text: Part(17995, 24) }, // mains frequency too high
    MeaningRow { first: 12610, last: 12610, text: Part(18019, 23) }, // mains frequency too low
    MeaningRow { first: 12816, last: 12816, text: Part(18042, 20) }, // DC link over-voltage
    MeaningRow { first: 12817, last: 12817, text: Part(18062, 22) }, // DC link over-voltage 1
    MeaningRow { first: 12818, last: 12818, text: Part(18084, 22) }, // DC link over-voltage 2
    MeaningRow { first: 12832, last: 12832, text: Part(18106, 21) }, // DC link under-voltage
    MeaningRow { first: 12833, last: 12833, text: Part(18127, 23) }, // DC link under-voltage 1
    MeaningRow { first: 12834, last: 12834, text: Part(18150, 23) }, // DC link under-voltage 2
    MeaningRow { first: 12848, last: 12848, text: Part(18173, 10) }, // load error
    MeaningRow { first: 13072, last: 13072, text: Part(18183, 19) }, // output over-voltage
    MeaningRow { first: 13073, last: 13073, text: Part(18202, 28) }, // output over-voltage, phase U
    MeaningRow { first: 13074, last: 13074, text: Part(18230, 28) }, // output over-voltage, phase V
    MeaningRow { first: 13075, last: 13075, text: Part(18258, 28) }, // output over-voltage, phase W
    MeaningRow { first: 13088, last: 13088, text: Part(18286, 16) }, // armature circuit
    MeaningRow { first: 13089, last: 13089, text: Part(18302, 28) }, // armature circuit interrupted
    MeaningRow { first: 13104, last: 13104, text: Part(18330, 13) }, // field circuit
    MeaningRow { first: 13105, last: 13105, text: Part(18343, 25) }, // field circuit interrupted
    MeaningRow { first: 16656, last: 16656, text: Part(18368, 28) }, // ambient temperature too high
    MeaningRow { first: 16672, last: 16672, text: Part(18396, 27) }, // ambient temperature too low
    MeaningRow { first: 16688, last: 16688, text: Part(18423, 29) }, // temperature of the supply air
    MeaningRow { first: 16704, last: 16704, text: Part(18452, 29) }, // temperature of the air outlet
    MeaningRow { first: 16912, last: 16912, text: Part(18481, 27) }, // device temperature too high
    MeaningRow { first: 16928, last: 16928, text: Part(18508, 26) }, // device temperature too low
    MeaningRow { first: 17152, last: 17152, text: Part(18534, 24) }, // temperature of the drive
    MeaningRow { first: 17168, last: 17168, text: Part(18558, 33) }, // temperature of the drive too high
    MeaningRow { first: 17184, last: 17184, text: Part(18591, 32) }, // temperature of the drive too low
    MeaningRow { first: 17408, last: 17408, text: Part(18623, 25) }, // temperature of the supply
    MeaningRow { first: 17424, last: 17424, text: Part(18648, 34) }, // temperature of the supply too high
    MeaningRow { first: 17440, last: 17440, text: Part(18682, 33) }, // temperature of the supply too low
    MeaningRow { first: 20736, last: 20736, text: Part(18715, 6) }, // supply
    MeaningRow { first: 20752, last: 20752, text: Part(18721, 23) }, // low voltage of a supply
    MeaningRow { first: 20753, last: 20753, text: Part(18744, 30) }, // low voltage of the 15 V supply
    MeaningRow { first: 20754, last: 20754, text: Part(18774, 30) }, // low voltage of the 24 V supply
    MeaningRow { first: 20755, last: 20755, text: Part(18804, 29) }, // low voltage of the 5 V supply
    MeaningRow { first: 20756, last: 20761, text: Part(18833, 43) }, // low voltage of a supply of the manufacturer
    MeaningRow { first: 20768, last: 20768, text: Part(18876, 34) }, // supply of the intermediate circuit
    MeaningRow { first: 20992, last: 20992, text: Part(18910, 7) }, // control
    MeaningRow { first: 21008, last: 21008, text: Part(18917, 17) }, // measuring circuit
    MeaningRow { first: 21024, last: 21024, text: Part(18934, 17) }, // computing circuit
    MeaningRow { first: 21248, last: 21248, text: Part(18951, 14) }, // operating unit
    MeaningRow { first: 21504, last: 21504, text: Part(18965, 13) }, // power section
    MeaningRow { first: 21520, last: 21520, text: Part(18978, 13) }, // output stages
    MeaningRow { first: 21536, last: 21536, text: Part(18991, 7) }, // chopper
    MeaningRow { first: 21552, last: 21552, text: Part(18998, 12) }, // input stages
    MeaningRow { first: 21568, last: 21568, text: Part(19010, 8) }, // contacts
    MeaningRow { first: 21569, last: 21577, text: Part(19018, 27) }, // contact of the manufacturer
    MeaningRow { first: 21584, last: 21584, text: Part(19045, 5) }, // fuses
    MeaningRow { first: 21585, last: 21593, text: Part(19050, 24) }, // fuse of the manufacturer
    MeaningRow { first: 21760, last: 21760, text: Part(19074, 12) }, // data storage
    MeaningRow { first: 21776, last: 21776, text: Part(19086, 14) }, // working memory
    MeaningRow { first: 21792, last: 21792, text: Part(19100, 14) }, // program memory
    MeaningRow { first: 21808, last: 21808, text: Part(19114, 24) }, // non-volatile data memory
    MeaningRow { first: 24592, last: 24592, text: Part(19138, 25) }, // software reset (watchdog)
    MeaningRow { first: 25345, last: 25359, text: Part(19163, 11) }, // data record
    MeaningRow { first: 25360, last: 25360, text: Part(19174, 18) }, // loss of parameters
    MeaningRow { first: 25376, last: 25376, text: Part(19192, 15) }, // parameter error
    MeaningRow { first: 28928, last: 28928, text: Part(19207, 5) }, // power
    MeaningRow { first: 28944, last: 28944, text: Part(19212, 13) }, // brake chopper
    MeaningRow { first: 28945, last: 28945, text: Part(19225, 28) }, // failure of the brake chopper
    MeaningRow { first: 28946, last: 28946, text: Part(19253, 33) }, // over-current of the brake chopper
    MeaningRow { first: 28947, last: 28947, text: Part(19286, 39) }, // protective circuit of the brake chopper
    MeaningRow { first: 28960, last: 28960, text: Part(15487, 5) }, // motor
    MeaningRow { first: 28961, last: 28961, text: Part(19325, 13) }, // motor blocked
    MeaningRow { first: 28962, last: 28962, text: Part(19338, 32) }, // motor error or wrong commutation
    MeaningRow { first: 28963, last: 28963, text: Part(19370, 12) }, // motor tilted
    MeaningRow { first: 29184, last: 29184, text: Part(19382, 24) }, // measuring circuit module
    MeaningRow { first: 29440, last: 29440, text: Part(19406, 6) }, // sensor
    MeaningRow { first: 29441, last: 29441, text: Part(19412, 16) }, // tachometer fault
    MeaningRow { first: 29442, last: 29442, text: Part(19428, 32) }, // wrong polarity of the tachometer
    MeaningRow { first: 29443, last: 29443, text: Part(19460, 19) }, // fault of resolver 1
    MeaningRow { first: 29444, last: 29444, text: Part(19479, 19) }, // fault of resolver 2
    MeaningRow { first: 29445, last: 29445, text: Part(19498, 29) }, // fault of incremental sensor 1
    MeaningRow { first: 29446, last: 29446, text: Part(19527, 29) }, // fault of incremental sensor 2
    MeaningRow { first: 29447, last: 29447, text: Part(19556, 29) }, // fault of incremental sensor 3
    MeaningRow { first: 29456, last: 29456, text: Part(19585, 5) }, // speed
    MeaningRow { first: 29472, last: 29472, text: Part(19590, 8) }, // position
    MeaningRow { first: 29696, last: 29696, text: Part(19598, 24) }, // computing circuit module
    MeaningRow { first: 29952, last: 29952, text: Part(19622, 20) }, // communication module
    MeaningRow { first: 29968, last: 29968, text: Part(19642, 18) }, // serial interface 1
    MeaningRow { first: 29984, last: 29984, text: Part(19660, 18) }, // serial interface 2
    MeaningRow { first: 30208, last: 30208, text: Part(19678, 19) }, // data storage module
    MeaningRow { first: 33536, last: 33536, text: Part(19697, 14) }, // torque control
    MeaningRow { first: 33553, last: 33553, text: Part(19711, 15) }, // torque too high
    MeaningRow { first: 33554, last: 33554, text: Part(19726, 18) }, // difficult start-up
    MeaningRow { first: 33555, last: 33555, text: Part(19744, 20) }, // torque at standstill
    MeaningRow { first: 33569, last: 33569, text: Part(19764, 14) }, // torque too low
    MeaningRow { first: 33585, last: 33585, text: Part(19778, 12) }, // torque fault
    MeaningRow { first: 33792, last: 33792, text: Part(19790, 19) }, // velocity controller
    MeaningRow { first: 34048, last: 34048, text: Part(19809, 19) }, // position controller
    MeaningRow { first: 34304, last: 34304, text: Part(19828, 22) }, // positioning controller
    MeaningRow { first: 34321, last: 34321, text: Part(19850, 15) }, // following error
    MeaningRow { first: 34322, last: 34322, text: Part(19865, 15) }, // reference limit
    MeaningRow { first: 34560, last: 34560, text: Part(19880, 22) }, // synchronous controller
    MeaningRow { first: 34816, last: 34816, text: Part(19902, 18) }, // winding controller
    MeaningRow { first: 35072, last: 35072, text: Part(19920, 23) }, // process data monitoring
    MeaningRow { first: 35328, last: 35328, text: Part(19943, 18) }, // control monitoring
    MeaningRow { first: 61441, last: 61441, text: Part(19961, 12) }, // deceleration
    MeaningRow { first: 61442, last: 61442, text: Part(19973, 19) }, // sub-synchronous run
    MeaningRow { first: 61443, last: 61443, text: Part(19992, 16) }, // stroke operation
    MeaningRow { first: 61444, last: 61444, text: Part(18910, 7) }, // control
];

static COMMANDS: &[CommandRow] = &[
    CommandRow { name: Part(20008, 8), mask: Part(20016, 9) }, // shutdown
    CommandRow { name: Part(379, 9), mask: Part(20025, 9) }, // switch on
    CommandRow { name: Part(416, 16), mask: Part(20034, 9) }, // enable operation
    CommandRow { name: Part(20043, 17), mask: Part(20025, 9) }, // disable operation
    CommandRow { name: Part(199, 10), mask: Part(20060, 9) }, // quick stop
    CommandRow { name: Part(184, 15), mask: Part(20069, 9) }, // disable voltage
    CommandRow { name: Part(20078, 25), mask: Part(20103, 9) }, // fault reset (bit 7 rises)
];

static TRANSITIONS: &[TransitionRow] = &[
    TransitionRow { number: 0, from: Part(20112, 5), to: Part(549, 22), by: Part(20117, 17) }, // not ready to switch on
    TransitionRow { number: 1, from: Part(549, 22), to: Part(660, 18), by: Part(20134, 22) }, // switch on disabled
    TransitionRow { number: 2, from: Part(660, 18), to: Part(614, 18), by: Part(20008, 8) }, // ready to switch on
    TransitionRow { number: 3, from: Part(614, 18), to: Part(632, 11), by: Part(379, 9) }, // switched on
    TransitionRow { number: 4, from: Part(632, 11), to: Part(643, 17), by: Part(416, 16) }, // operation enabled
    TransitionRow { number: 5, from: Part(643, 17), to: Part(632, 11), by: Part(20043, 17) }, // switched on
    TransitionRow { number: 6, from: Part(632, 11), to: Part(614, 18), by: Part(20008, 8) }, // ready to switch on
    TransitionRow { number: 7, from: Part(614, 18), to: Part(660, 18), by: Part(20156, 27) }, // switch on disabled
    TransitionRow { number: 8, from: Part(643, 17), to: Part(614, 18), by: Part(20008, 8) }, // ready to switch on
    TransitionRow { number: 9, from: Part(643, 17), to: Part(660, 18), by: Part(184, 15) }, // switch on disabled
    TransitionRow { number: 10, from: Part(632, 11), to: Part(660, 18), by: Part(20156, 27) }, // switch on disabled
    TransitionRow { number: 11, from: Part(643, 17), to: Part(571, 17), by: Part(199, 10) }, // quick stop active
    TransitionRow { number: 12, from: Part(571, 17), to: Part(660, 18), by: Part(20183, 53) }, // switch on disabled
    TransitionRow { number: 13, from: Part(20236, 9), to: Part(593, 21), by: Part(20245, 7) }, // fault reaction active
    TransitionRow { number: 14, from: Part(593, 21), to: Part(588, 5), by: Part(20252, 22) }, // fault
    TransitionRow { number: 15, from: Part(588, 5), to: Part(660, 18), by: Part(20078, 25) }, // switch on disabled
    TransitionRow { number: 16, from: Part(571, 17), to: Part(643, 17), by: Part(20274, 34) }, // operation enabled
];

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
