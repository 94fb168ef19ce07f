// Generated from `data/cia402.toml` by `cargo xtask profiles`: edit that file.

#![allow(unused_imports, reason = "not every document has facts of every kind")]

use std::borrow::Cow;

use crate::model::{Access, Access::*, DataType, ObjectType, ObjectType::*, Value, Value::*};
use crate::tables::{NeedRow::*, Term::*, *};
use crate::{Condition, Mapping::*, Profile};

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
        texts: Cow::Borrowed(TEXTS),
    },
};

static OBJECTS: &[ObjectRow] = &[
    ObjectRow { first: 4096, last: 4096, name: Part(93, 11), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 1), source: Part(0, 0) }, // 1000h Device type
    ObjectRow { first: 24583, last: 24583, name: Part(179, 28), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(1, 1), source: Part(0, 0) }, // 6007h Abort connection option code
    ObjectRow { first: 24639, last: 24639, name: Part(207, 10), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(2, 1), source: Part(0, 0) }, // 603Fh Error code
    ObjectRow { first: 24640, last: 24640, name: Part(296, 11), object_types: Part(0, 1), need: Mandatory, only: None, as_many_as: Part(0, 0), entries: Part(3, 1), source: Part(0, 0) }, // 6040h Controlword
    ObjectRow { first: 24641, last: 24641, name: Part(504, 10), object_types: Part(0, 1), need: Mandatory, only: None, as_many_as: Part(0, 0), entries: Part(4, 1), source: Part(0, 0) }, // 6041h Statusword
    ObjectRow { first: 24642, last: 24642, name: Part(514, 18), object_types: Part(0, 1), need: When(0), only: None, as_many_as: Part(0, 0), entries: Part(5, 1), source: Part(0, 0) }, // 6042h vl target velocity
    ObjectRow { first: 24643, last: 24643, name: Part(532, 18), object_types: Part(0, 1), need: When(0), only: None, as_many_as: Part(0, 0), entries: Part(6, 1), source: Part(0, 0) }, // 6043h vl velocity demand
    ObjectRow { first: 24644, last: 24644, name: Part(550, 24), object_types: Part(0, 1), need: When(0), only: None, as_many_as: Part(0, 0), entries: Part(6, 1), source: Part(0, 0) }, // 6044h vl velocity actual value
    ObjectRow { first: 24645, last: 24645, name: Part(574, 23), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(7, 1), source: Part(0, 0) }, // 6045h vl manipulated velocity
    ObjectRow { first: 24646, last: 24646, name: Part(668, 26), object_types: Part(1, 1), need: When(0), only: None, as_many_as: Part(0, 0), entries: Part(8, 3), source: Part(0, 0) }, // 6046h vl velocity min max amount
    ObjectRow { first: 24647, last: 24647, name: Part(694, 19), object_types: Part(1, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0) }, // 6047h vl velocity min max
    ObjectRow { first: 24648, last: 24648, name: Part(734, 24), object_types: Part(2, 1), need: When(0), only: None, as_many_as: Part(0, 0), entries: Part(11, 3), source: Part(0, 0) }, // 6048h vl velocity acceleration
    ObjectRow { first: 24649, last: 24649, name: Part(758, 24), object_types: Part(2, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(11, 3), source: Part(0, 0) }, // 6049h vl velocity deceleration
    ObjectRow { first: 24650, last: 24650, name: Part(782, 22), object_types: Part(2, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(11, 3), source: Part(0, 0) }, // 604Ah vl velocity quick stop
    ObjectRow { first: 24651, last: 24651, name: Part(864, 19), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(14, 3), source: Part(0, 0) }, // 604Bh vl set-point factor
    ObjectRow { first: 24652, last: 24652, name: Part(943, 19), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(17, 3), source: Part(0, 0) }, // 604Ch vl dimension factor
    ObjectRow { first: 24653, last: 24653, name: Part(962, 14), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(20, 1), source: Part(0, 0) }, // 604Dh vl pole number
    ObjectRow { first: 24654, last: 24654, name: Part(976, 21), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(21, 1), source: Part(0, 0) }, // 604Eh vl velocity reference
    ObjectRow { first: 24655, last: 24655, name: Part(997, 21), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(21, 1), source: Part(0, 0) }, // 604Fh vl ramp function time
    ObjectRow { first: 24656, last: 24656, name: Part(1018, 17), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(21, 1), source: Part(0, 0) }, // 6050h vl slow down time
    ObjectRow { first: 24657, last: 24657, name: Part(1035, 18), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(21, 1), source: Part(0, 0) }, // 6051h vl quick stop time
    ObjectRow { first: 24658, last: 24658, name: Part(1053, 21), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(22, 1), source: Part(0, 0) }, // 6052h vl nominal percentage
    ObjectRow { first: 24659, last: 24659, name: Part(1074, 20), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(6, 1), source: Part(0, 0) }, // 6053h vl percentage demand
    ObjectRow { first: 24660, last: 24660, name: Part(1094, 20), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(6, 1), source: Part(0, 0) }, // 6054h vl actual percentage
    ObjectRow { first: 24661, last: 24661, name: Part(1114, 25), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(6, 1), source: Part(0, 0) }, // 6055h vl manipulated percentage
    ObjectRow { first: 24662, last: 24662, name: Part(1139, 32), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0) }, // 6056h vl velocity motor min max amount
    ObjectRow { first: 24663, last: 24663, name: Part(1171, 25), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0) }, // 6057h vl velocity motor min max
    ObjectRow { first: 24664, last: 24664, name: Part(1196, 33), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0) }, // 6058h vl frequency motor min max amount
    ObjectRow { first: 24665, last: 24665, name: Part(1229, 26), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0) }, // 6059h vl frequency motor min max
    ObjectRow { first: 24666, last: 24666, name: Part(1595, 22), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(23, 1), source: Part(0, 0) }, // 605Ah Quick stop option code
    ObjectRow { first: 24667, last: 24667, name: Part(1645, 20), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(24, 1), source: Part(0, 0) }, // 605Bh Shutdown option code
    ObjectRow { first: 24668, last: 24668, name: Part(1665, 29), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(25, 1), source: Part(0, 0) }, // 605Ch Disable operation option code
    ObjectRow { first: 24669, last: 24669, name: Part(1749, 16), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(26, 1), source: Part(0, 0) }, // 605Dh Halt option code
    ObjectRow { first: 24670, last: 24670, name: Part(1765, 26), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(27, 1), source: Part(0, 0) }, // 605Eh Fault reaction option code
    ObjectRow { first: 24672, last: 24672, name: Part(2010, 18), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(28, 1), source: Part(0, 0) }, // 6060h Modes of operation
    ObjectRow { first: 24673, last: 24673, name: Part(2028, 26), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(29, 1), source: Part(0, 0) }, // 6061h Modes of operation display
    ObjectRow { first: 24674, last: 24674, name: Part(2054, 21), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(30, 1), source: Part(0, 0) }, // 6062h Position demand value
    ObjectRow { first: 24675, last: 24675, name: Part(2075, 30), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(30, 1), source: Part(0, 0) }, // 6063h Position actual internal value
    ObjectRow { first: 24676, last: 24676, name: Part(2105, 21), object_types: Part(0, 1), need: When(1), only: None, as_many_as: Part(0, 0), entries: Part(30, 1), source: Part(0, 0) }, // 6064h Position actual value
    ObjectRow { first: 24677, last: 24677, name: Part(2126, 22), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(31, 1), source: Part(0, 0) }, // 6065h Following error window
    ObjectRow { first: 24678, last: 24678, name: Part(2148, 24), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(32, 1), source: Part(0, 0) }, // 6066h Following error time out
    ObjectRow { first: 24679, last: 24679, name: Part(2172, 15), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(21, 1), source: Part(0, 0) }, // 6067h Position window
    ObjectRow { first: 24680, last: 24680, name: Part(2187, 20), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(32, 1), source: Part(0, 0) }, // 6068h Position window time
    ObjectRow { first: 24681, last: 24681, name: Part(2207, 28), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(30, 1), source: Part(0, 0) }, // 6069h Velocity sensor actual value
    ObjectRow { first: 24682, last: 24682, name: Part(2289, 21), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(33, 1), source: Part(0, 0) }, // 606Ah Sensor selection code
    ObjectRow { first: 24683, last: 24683, name: Part(2310, 21), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(30, 1), source: Part(0, 0) }, // 606Bh Velocity demand value
    ObjectRow { first: 24684, last: 24684, name: Part(2331, 21), object_types: Part(0, 1), need: When(2), only: None, as_many_as: Part(0, 0), entries: Part(30, 1), source: Part(0, 0) }, // 606Ch Velocity actual value
    ObjectRow { first: 24685, last: 24685, name: Part(2352, 15), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(32, 1), source: Part(0, 0) }, // 606Dh Velocity window
    ObjectRow { first: 24686, last: 24686, name: Part(2367, 20), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(32, 1), source: Part(0, 0) }, // 606Eh Velocity window time
    ObjectRow { first: 24687, last: 24687, name: Part(2387, 18), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(32, 1), source: Part(0, 0) }, // 606Fh Velocity threshold
    ObjectRow { first: 24688, last: 24688, name: Part(2405, 23), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(32, 1), source: Part(0, 0) }, // 6070h Velocity threshold time
    ObjectRow { first: 24689, last: 24689, name: Part(2428, 13), object_types: Part(0, 1), need: When(3), only: None, as_many_as: Part(0, 0), entries: Part(5, 1), source: Part(0, 0) }, // 6071h Target torque
    ObjectRow { first: 24690, last: 24690, name: Part(2441, 10), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(34, 1), source: Part(0, 0) }, // 6072h Max torque
    ObjectRow { first: 24691, last: 24691, name: Part(2451, 11), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(32, 1), source: Part(0, 0) }, // 6073h Max current
    ObjectRow { first: 24692, last: 24692, name: Part(2462, 13), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(6, 1), source: Part(0, 0) }, // 6074h Torque demand
    ObjectRow { first: 24693, last: 24693, name: Part(2475, 19), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(35, 1), source: Part(0, 0) }, // 6075h Motor rated current
    ObjectRow { first: 24694, last: 24694, name: Part(2494, 18), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(35, 1), source: Part(0, 0) }, // 6076h Motor rated torque
    ObjectRow { first: 24695, last: 24695, name: Part(2512, 19), object_types: Part(0, 1), need: When(3), only: None, as_many_as: Part(0, 0), entries: Part(6, 1), source: Part(0, 0) }, // 6077h Torque actual value
    ObjectRow { first: 24696, last: 24696, name: Part(2531, 20), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(6, 1), source: Part(0, 0) }, // 6078h Current actual value
    ObjectRow { first: 24697, last: 24697, name: Part(2551, 23), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(36, 1), source: Part(0, 0) }, // 6079h DC link circuit voltage
    ObjectRow { first: 24698, last: 24698, name: Part(2574, 15), object_types: Part(0, 1), need: When(4), only: None, as_many_as: Part(0, 0), entries: Part(37, 1), source: Part(0, 0) }, // 607Ah Target position
    ObjectRow { first: 24699, last: 24699, name: Part(2637, 20), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(38, 3), source: Part(0, 0) }, // 607Bh Position range limit
    ObjectRow { first: 24700, last: 24700, name: Part(2657, 11), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(37, 1), source: Part(0, 0) }, // 607Ch Home offset
    ObjectRow { first: 24701, last: 24701, name: Part(2704, 23), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(41, 3), source: Part(0, 0) }, // 607Dh Software position limit
    ObjectRow { first: 24702, last: 24702, name: Part(2761, 8), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(44, 1), source: Part(0, 0) }, // 607Eh Polarity
    ObjectRow { first: 24703, last: 24703, name: Part(2769, 20), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(21, 1), source: Part(0, 0) }, // 607Fh Max profile velocity
    ObjectRow { first: 24704, last: 24704, name: Part(2789, 15), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(21, 1), source: Part(0, 0) }, // 6080h Max motor speed
    ObjectRow { first: 24705, last: 24705, name: Part(2804, 16), object_types: Part(0, 1), need: When(5), only: None, as_many_as: Part(0, 0), entries: Part(31, 1), source: Part(0, 0) }, // 6081h Profile velocity
    ObjectRow { first: 24706, last: 24706, name: Part(2820, 12), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(21, 1), source: Part(0, 0) }, // 6082h End velocity
    ObjectRow { first: 24707, last: 24707, name: Part(2832, 20), object_types: Part(0, 1), need: When(6), only: None, as_many_as: Part(0, 0), entries: Part(31, 1), source: Part(0, 0) }, // 6083h Profile acceleration
    ObjectRow { first: 24708, last: 24708, name: Part(2852, 20), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(31, 1), source: Part(0, 0) }, // 6084h Profile deceleration
    ObjectRow { first: 24709, last: 24709, name: Part(2872, 23), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(31, 1), source: Part(0, 0) }, // 6085h Quick stop deceleration
    ObjectRow { first: 24710, last: 24710, name: Part(2952, 19), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(45, 1), source: Part(0, 0) }, // 6086h Motion profile type
    ObjectRow { first: 24711, last: 24711, name: Part(2971, 12), object_types: Part(0, 1), need: When(7), only: None, as_many_as: Part(0, 0), entries: Part(31, 1), source: Part(0, 0) }, // 6087h Torque slope
    ObjectRow { first: 24712, last: 24712, name: Part(2983, 19), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(46, 1), source: Part(0, 0) }, // 6088h Torque profile type
    ObjectRow { first: 24713, last: 24713, name: Part(3002, 23), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(47, 1), source: Part(3025, 9) }, // 6089h Position notation index
    ObjectRow { first: 24714, last: 24714, name: Part(3034, 24), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(20, 1), source: Part(3025, 9) }, // 608Ah Position dimension index
    ObjectRow { first: 24715, last: 24715, name: Part(3058, 23), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(47, 1), source: Part(3025, 9) }, // 608Bh Velocity notation index
    ObjectRow { first: 24716, last: 24716, name: Part(3081, 24), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(20, 1), source: Part(3025, 9) }, // 608Ch Velocity dimension index
    ObjectRow { first: 24717, last: 24717, name: Part(3105, 27), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(47, 1), source: Part(3025, 9) }, // 608Dh Acceleration notation index
    ObjectRow { first: 24718, last: 24718, name: Part(3132, 28), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(20, 1), source: Part(3025, 9) }, // 608Eh Acceleration dimension index
    ObjectRow { first: 24719, last: 24719, name: Part(3195, 27), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(48, 3), source: Part(0, 0) }, // 608Fh Position encoder resolution
    ObjectRow { first: 24720, last: 24720, name: Part(3279, 27), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(51, 3), source: Part(0, 0) }, // 6090h Velocity encoder resolution
    ObjectRow { first: 24721, last: 24721, name: Part(3323, 10), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(54, 3), source: Part(0, 0) }, // 6091h Gear ratio
    ObjectRow { first: 24722, last: 24722, name: Part(3337, 13), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(57, 3), source: Part(0, 0) }, // 6092h Feed constant
    ObjectRow { first: 24723, last: 24723, name: Part(3359, 15), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(60, 3), source: Part(0, 0) }, // 6093h Position factor
    ObjectRow { first: 24724, last: 24724, name: Part(3381, 23), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(63, 3), source: Part(0, 0) }, // 6094h Velocity encoder factor
    ObjectRow { first: 24725, last: 24725, name: Part(3404, 17), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(63, 3), source: Part(0, 0) }, // 6095h Velocity factor 1
    ObjectRow { first: 24726, last: 24726, name: Part(3421, 15), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(63, 3), source: Part(0, 0) }, // 6096h Velocity factor
    ObjectRow { first: 24727, last: 24727, name: Part(3436, 19), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(63, 3), source: Part(0, 0) }, // 6097h Acceleration factor
    ObjectRow { first: 24728, last: 24728, name: Part(3960, 13), object_types: Part(0, 1), need: When(8), only: None, as_many_as: Part(0, 0), entries: Part(66, 1), source: Part(0, 0) }, // 6098h Homing method
    ObjectRow { first: 24729, last: 24729, name: Part(4031, 13), object_types: Part(3, 2), need: When(8), only: None, as_many_as: Part(0, 0), entries: Part(67, 3), source: Part(0, 0) }, // 6099h Homing speeds
    ObjectRow { first: 24730, last: 24730, name: Part(4044, 19), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(31, 1), source: Part(0, 0) }, // 609Ah Homing acceleration
    ObjectRow { first: 24738, last: 24738, name: Part(4063, 11), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(63, 3), source: Part(0, 0) }, // 60A2h Jerk factor
    ObjectRow { first: 24739, last: 24739, name: Part(4074, 16), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(70, 1), source: Part(0, 0) }, // 60A3h Profile jerk use
    ObjectRow { first: 24740, last: 24740, name: Part(4123, 12), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(71, 3), source: Part(0, 0) }, // 60A4h Profile jerk
    ObjectRow { first: 24744, last: 24744, name: Part(4176, 16), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(74, 1), source: Part(4192, 9) }, // 60A8h SI unit position
    ObjectRow { first: 24745, last: 24745, name: Part(4201, 16), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(74, 1), source: Part(4192, 9) }, // 60A9h SI unit velocity
    ObjectRow { first: 24746, last: 24746, name: Part(4217, 20), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(74, 1), source: Part(4192, 9) }, // 60AAh SI unit acceleration
    ObjectRow { first: 24747, last: 24747, name: Part(4237, 12), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(74, 1), source: Part(4192, 9) }, // 60ABh SI unit jerk
    ObjectRow { first: 24752, last: 24752, name: Part(4249, 15), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(37, 1), source: Part(0, 0) }, // 60B0h Position offset
    ObjectRow { first: 24753, last: 24753, name: Part(4264, 15), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(37, 1), source: Part(0, 0) }, // 60B1h Velocity offset
    ObjectRow { first: 24754, last: 24754, name: Part(4279, 13), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(5, 1), source: Part(0, 0) }, // 60B2h Torque offset
    ObjectRow { first: 24760, last: 24760, name: Part(4582, 20), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(75, 1), source: Part(0, 0) }, // 60B8h Touch probe function
    ObjectRow { first: 24761, last: 24761, name: Part(4726, 18), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(76, 1), source: Part(0, 0) }, // 60B9h Touch probe status
    ObjectRow { first: 24762, last: 24762, name: Part(4744, 27), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(30, 1), source: Part(0, 0) }, // 60BAh Touch probe 1 positive edge
    ObjectRow { first: 24763, last: 24763, name: Part(4771, 27), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(30, 1), source: Part(0, 0) }, // 60BBh Touch probe 1 negative edge
    ObjectRow { first: 24764, last: 24764, name: Part(4798, 27), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(30, 1), source: Part(0, 0) }, // 60BCh Touch probe 2 positive edge
    ObjectRow { first: 24765, last: 24765, name: Part(4825, 27), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(30, 1), source: Part(0, 0) }, // 60BDh Touch probe 2 negative edge
    ObjectRow { first: 24768, last: 24768, name: Part(4885, 29), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(77, 1), source: Part(0, 0) }, // 60C0h Interpolation sub mode select
    ObjectRow { first: 24769, last: 24769, name: Part(4943, 25), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(78, 3), source: Part(0, 0) }, // 60C1h Interpolation data record
    ObjectRow { first: 24770, last: 24770, name: Part(5023, 25), object_types: Part(2, 1), need: When(9), only: None, as_many_as: Part(0, 0), entries: Part(81, 3), source: Part(0, 0) }, // 60C2h Interpolation time period
    ObjectRow { first: 24771, last: 24771, name: Part(5048, 29), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0) }, // 60C3h Interpolation sync definition
    ObjectRow { first: 24772, last: 24772, name: Part(5199, 32), object_types: Part(2, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(84, 7), source: Part(0, 0) }, // 60C4h Interpolation data configuration
    ObjectRow { first: 24773, last: 24773, name: Part(5231, 16), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(21, 1), source: Part(0, 0) }, // 60C5h Max acceleration
    ObjectRow { first: 24774, last: 24774, name: Part(5247, 16), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(21, 1), source: Part(0, 0) }, // 60C6h Max deceleration
    ObjectRow { first: 24784, last: 24784, name: Part(5263, 18), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0) }, // 60D0h Touch probe source
    ObjectRow { first: 24785, last: 24785, name: Part(5281, 39), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0) }, // 60D1h Touch probe time stamp 1 positive value
    ObjectRow { first: 24786, last: 24786, name: Part(5320, 39), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0) }, // 60D2h Touch probe time stamp 1 negative value
    ObjectRow { first: 24787, last: 24787, name: Part(5359, 39), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0) }, // 60D3h Touch probe time stamp 2 positive value
    ObjectRow { first: 24788, last: 24788, name: Part(5398, 39), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0) }, // 60D4h Touch probe time stamp 2 negative value
    ObjectRow { first: 24789, last: 24789, name: Part(5437, 35), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0) }, // 60D5h Touch probe 1 positive edge counter
    ObjectRow { first: 24790, last: 24790, name: Part(5472, 35), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0) }, // 60D6h Touch probe 1 negative edge counter
    ObjectRow { first: 24791, last: 24791, name: Part(5507, 35), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0) }, // 60D7h Touch probe 2 positive edge counter
    ObjectRow { first: 24792, last: 24792, name: Part(5542, 35), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0) }, // 60D8h Touch probe 2 negative edge counter
    ObjectRow { first: 24800, last: 24800, name: Part(5577, 27), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(91, 1), source: Part(4192, 9) }, // 60E0h Positive torque limit value
    ObjectRow { first: 24801, last: 24801, name: Part(5604, 27), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(91, 1), source: Part(4192, 9) }, // 60E1h Negative torque limit value
    ObjectRow { first: 24803, last: 24803, name: Part(5631, 24), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(92, 3), source: Part(4192, 9) }, // 60E3h Supported homing methods
    ObjectRow { first: 24804, last: 24804, name: Part(5655, 32), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(95, 3), source: Part(4192, 9) }, // 60E4h Additional position actual value
    ObjectRow { first: 24805, last: 24805, name: Part(5687, 32), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(98, 3), source: Part(4192, 9) }, // 60E5h Additional velocity actual value
    ObjectRow { first: 24806, last: 24806, name: Part(5719, 58), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0) }, // 60E6h Additional position encoder resolution, encoder increments
    ObjectRow { first: 24807, last: 24807, name: Part(5777, 69), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0) }, // 60E7h Additional velocity encoder resolution, encoder increments per second
    ObjectRow { first: 24808, last: 24808, name: Part(5846, 46), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0) }, // 60E8h Additional gear ratio, motor shaft revolutions
    ObjectRow { first: 24809, last: 24809, name: Part(5892, 30), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0) }, // 60E9h Additional feed constant, feed
    ObjectRow { first: 24811, last: 24811, name: Part(5922, 57), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0) }, // 60EBh Additional position encoder resolution, motor revolutions
    ObjectRow { first: 24812, last: 24812, name: Part(5979, 68), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0) }, // 60ECh Additional velocity encoder resolution, motor revolutions per second
    ObjectRow { first: 24813, last: 24813, name: Part(6047, 48), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0) }, // 60EDh Additional gear ratio, driving shaft revolutions
    ObjectRow { first: 24814, last: 24814, name: Part(6095, 51), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0) }, // 60EEh Additional feed constant, driving shaft revolutions
    ObjectRow { first: 24818, last: 24818, name: Part(6408, 23), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(101, 1), source: Part(0, 0) }, // 60F2h Positioning option code
    ObjectRow { first: 24820, last: 24820, name: Part(6431, 28), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(30, 1), source: Part(0, 0) }, // 60F4h Following error actual value
    ObjectRow { first: 24822, last: 24822, name: Part(6459, 28), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0) }, // 60F6h Torque control parameter set
    ObjectRow { first: 24823, last: 24823, name: Part(6487, 22), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0) }, // 60F7h Power stage parameters
    ObjectRow { first: 24824, last: 24824, name: Part(6509, 12), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(102, 1), source: Part(0, 0) }, // 60F8h Max slippage
    ObjectRow { first: 24825, last: 24825, name: Part(6521, 30), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0) }, // 60F9h Velocity control parameter set
    ObjectRow { first: 24826, last: 24826, name: Part(6551, 14), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(30, 1), source: Part(0, 0) }, // 60FAh Control effort
    ObjectRow { first: 24827, last: 24827, name: Part(6565, 30), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0) }, // 60FBh Position control parameter set
    ObjectRow { first: 24828, last: 24828, name: Part(6595, 30), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(30, 1), source: Part(0, 0) }, // 60FCh Position demand internal value
    ObjectRow { first: 24829, last: 24829, name: Part(6645, 14), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(103, 1), source: Part(0, 0) }, // 60FDh Digital inputs
    ObjectRow { first: 24830, last: 24830, name: Part(6692, 15), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(104, 3), source: Part(0, 0) }, // 60FEh Digital outputs
    ObjectRow { first: 24831, last: 24831, name: Part(6707, 15), object_types: Part(0, 1), need: When(10), only: None, as_many_as: Part(0, 0), entries: Part(37, 1), source: Part(0, 0) }, // 60FFh Target velocity
    ObjectRow { first: 25602, last: 25602, name: Part(7056, 10), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(107, 1), source: Part(0, 0) }, // 6402h Motor type
    ObjectRow { first: 25603, last: 25603, name: Part(7066, 22), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(108, 1), source: Part(0, 0) }, // 6403h Motor catalogue number
    ObjectRow { first: 25604, last: 25604, name: Part(7088, 18), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(108, 1), source: Part(0, 0) }, // 6404h Motor manufacturer
    ObjectRow { first: 25605, last: 25605, name: Part(7106, 28), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(108, 1), source: Part(0, 0) }, // 6405h HTTP motor catalogue address
    ObjectRow { first: 25606, last: 25606, name: Part(7134, 22), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(109, 1), source: Part(0, 0) }, // 6406h Motor calibration date
    ObjectRow { first: 25607, last: 25607, name: Part(7156, 20), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(110, 1), source: Part(0, 0) }, // 6407h Motor service period
    ObjectRow { first: 25616, last: 25616, name: Part(7176, 10), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0) }, // 6410h Motor data
    ObjectRow { first: 25858, last: 25858, name: Part(7186, 21), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(111, 1), source: Part(7207, 59) }, // 6502h Supported drive modes
    ObjectRow { first: 25859, last: 25859, name: Part(7266, 22), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(108, 1), source: Part(0, 0) }, // 6503h Drive catalogue number
    ObjectRow { first: 25860, last: 25860, name: Part(7288, 18), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(108, 1), source: Part(0, 0) }, // 6504h Drive manufacturer
    ObjectRow { first: 25861, last: 25861, name: Part(7306, 28), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(108, 1), source: Part(0, 0) }, // 6505h HTTP drive catalogue address
    ObjectRow { first: 25872, last: 25872, name: Part(7334, 10), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0) }, // 6510h Drive data
    ObjectRow { first: 26622, last: 26622, name: Part(7344, 14), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(0, 0) }, // 67FEh Version number
    ObjectRow { first: 26623, last: 26623, name: Part(7358, 18), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(112, 1), source: Part(0, 0) }, // 67FFh Single device type
];

static ENTRIES: &[EntryRow] = &[
    EntryRow { first: 0, last: 0, mapping: None, need: Optional, name: Part(0, 0), data_types: Part(0, 0), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 5) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(5, 1) },
    EntryRow { first: 0, last: 0, mapping: Some(Tpdo), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(6, 9) },
    EntryRow { first: 0, last: 0, mapping: Some(Tpdo), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(15, 15) },
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(Tpdo), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(597, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(624, 22), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // vl velocity min amount
    EntryRow { first: 2, last: 2, mapping: None, need: Mandatory, name: Part(646, 22), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // vl velocity max amount
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(597, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(713, 11), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Delta speed
    EntryRow { first: 2, last: 2, mapping: None, need: Mandatory, name: Part(724, 10), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Delta time
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(597, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(804, 29), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // vl set-point factor numerator
    EntryRow { first: 2, last: 2, mapping: None, need: Mandatory, name: Part(833, 31), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // vl set-point factor denominator
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(597, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(883, 29), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // vl dimension factor numerator
    EntryRow { first: 2, last: 2, mapping: None, need: Mandatory, name: Part(912, 31), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // vl dimension factor denominator
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(2, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(2, 1), default: Some(0), bits: Part(30, 1) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(3, 1), default: Some(1), bits: Part(31, 1) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(3, 1), default: Some(2), bits: Part(31, 1) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(4, 1), default: Some(2), bits: Part(32, 1) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(4, 1), default: Some(0), bits: Part(32, 1) },
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(5, 1), access: Part(4, 2), values: Part(5, 2), default: None, bits: Part(33, 1) },
    EntryRow { first: 0, last: 0, mapping: Some(Tpdo), need: Mandatory, name: Part(0, 0), data_types: Part(5, 1), access: Part(1, 1), values: Part(5, 2), default: None, bits: Part(33, 1) },
    EntryRow { first: 0, last: 0, mapping: Some(Tpdo), need: Mandatory, name: Part(0, 0), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(34, 1) },
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(3, 1), access: Part(6, 2), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(Tpdo), need: Mandatory, name: Part(0, 0), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(597, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2589, 24), data_types: Part(4, 1), access: Part(6, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Min position range limit
    EntryRow { first: 2, last: 2, mapping: None, need: Mandatory, name: Part(2613, 24), data_types: Part(4, 1), access: Part(6, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Max position range limit
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(597, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(2668, 18), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Min position limit
    EntryRow { first: 2, last: 2, mapping: None, need: Mandatory, name: Part(2686, 18), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Max position limit
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(2, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(35, 2) },
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(37, 1) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(3, 1), default: None, bits: Part(38, 1) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(5, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(597, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(3160, 18), data_types: Part(3, 1), access: Part(6, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Encoder increments
    EntryRow { first: 2, last: 2, mapping: None, need: Mandatory, name: Part(3178, 17), data_types: Part(3, 1), access: Part(6, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Motor revolutions
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(597, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(3222, 29), data_types: Part(3, 1), access: Part(6, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Encoder increments per second
    EntryRow { first: 2, last: 2, mapping: None, need: Mandatory, name: Part(3251, 28), data_types: Part(3, 1), access: Part(6, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Motor revolutions per second
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(597, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(3178, 17), data_types: Part(3, 1), access: Part(6, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Motor revolutions
    EntryRow { first: 2, last: 2, mapping: None, need: Mandatory, name: Part(3306, 17), data_types: Part(3, 1), access: Part(6, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Shaft revolutions
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(597, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(3333, 4), data_types: Part(3, 1), access: Part(6, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Feed
    EntryRow { first: 2, last: 2, mapping: None, need: Mandatory, name: Part(3306, 17), data_types: Part(3, 1), access: Part(6, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Shaft revolutions
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(597, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(3350, 9), data_types: Part(3, 1), access: Part(6, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Numerator
    EntryRow { first: 2, last: 2, mapping: None, need: Mandatory, name: Part(3337, 13), data_types: Part(3, 1), access: Part(6, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Feed constant
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(597, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(3350, 9), data_types: Part(3, 1), access: Part(6, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Numerator
    EntryRow { first: 2, last: 2, mapping: None, need: Mandatory, name: Part(3374, 7), data_types: Part(3, 1), access: Part(6, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Divisor
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(5, 1), access: Part(0, 1), values: Part(7, 4), default: None, bits: Part(39, 1) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(597, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(3973, 30), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Speed during search for switch
    EntryRow { first: 2, last: 2, mapping: Some(Any), need: Mandatory, name: Part(4003, 28), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Speed during search for zero
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(2, 1), access: Part(0, 1), values: Part(11, 4), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(597, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(15, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(4090, 14), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Profile jerk 1
    EntryRow { first: 2, last: 6, mapping: None, need: Optional, name: Part(4104, 19), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Profile jerk 2 to 6
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(3, 1), access: Part(6, 2), values: Part(0, 0), default: None, bits: Part(40, 3) },
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(43, 12) },
    EntryRow { first: 0, last: 0, mapping: Some(Tpdo), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(55, 8) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(63, 1) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(597, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(16, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(4914, 11), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Set-point 1
    EntryRow { first: 2, last: 254, mapping: Some(Any), need: Optional, name: Part(4925, 18), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Set-point 2 to 254
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(597, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(4968, 31), data_types: Part(2, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Interpolation time period value
    EntryRow { first: 2, last: 2, mapping: None, need: Mandatory, name: Part(4999, 24), data_types: Part(5, 1), access: Part(0, 1), values: Part(17, 1), default: None, bits: Part(0, 0) }, // Interpolation time index
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(597, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(18, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(5077, 19), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Maximum buffer size
    EntryRow { first: 2, last: 2, mapping: None, need: Mandatory, name: Part(5096, 18), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Actual buffer size
    EntryRow { first: 3, last: 3, mapping: None, need: Mandatory, name: Part(5134, 19), data_types: Part(2, 1), access: Part(0, 1), values: Part(19, 2), default: None, bits: Part(64, 1) }, // Buffer organization
    EntryRow { first: 4, last: 4, mapping: None, need: Mandatory, name: Part(5153, 15), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Buffer position
    EntryRow { first: 5, last: 5, mapping: None, need: Mandatory, name: Part(5168, 19), data_types: Part(2, 1), access: Part(8, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Size of data record
    EntryRow { first: 6, last: 6, mapping: None, need: Mandatory, name: Part(5187, 12), data_types: Part(2, 1), access: Part(8, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Buffer clear
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(6, 2), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(597, 27), data_types: Part(2, 1), access: Part(1, 1), values: Part(16, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: None, need: Mandatory, name: Part(5631, 24), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Supported homing methods
    EntryRow { first: 2, last: 254, mapping: None, need: Optional, name: Part(5631, 24), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Supported homing methods
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(597, 27), data_types: Part(2, 1), access: Part(1, 1), values: Part(16, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(5655, 32), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Additional position actual value
    EntryRow { first: 2, last: 254, mapping: Some(Tpdo), need: Optional, name: Part(5655, 32), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Additional position actual value
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(597, 27), data_types: Part(2, 1), access: Part(1, 1), values: Part(16, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(5687, 32), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Additional velocity actual value
    EntryRow { first: 2, last: 254, mapping: Some(Tpdo), need: Optional, name: Part(5687, 32), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Additional velocity actual value
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(65, 7) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(Tpdo), need: Mandatory, name: Part(0, 0), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(72, 5) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(597, 27), data_types: Part(2, 1), access: Part(2, 2), values: Part(21, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(6668, 16), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(77, 2) }, // Physical outputs
    EntryRow { first: 2, last: 2, mapping: Some(Any), need: Optional, name: Part(6684, 8), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(77, 2) }, // Bit mask
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(6, 2), values: Part(0, 0), default: None, bits: Part(79, 1) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(8, 1), access: Part(6, 2), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(9, 1), access: Part(6, 2), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(3, 1), access: Part(6, 2), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: None, need: Mandatory, name: Part(0, 0), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(80, 11) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(3, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 5) },
];

static BITS: &[BitRow] = &[
    BitRow { first: 16, last: 16, name: Part(0, 19), values: Part(0, 0) }, // frequency converter
    BitRow { first: 17, last: 17, name: Part(19, 11), values: Part(0, 0) }, // servo drive
    BitRow { first: 18, last: 18, name: Part(30, 13), values: Part(0, 0) }, // stepper motor
    BitRow { first: 22, last: 22, name: Part(43, 31), values: Part(0, 0) }, // PDO mapping of the manufacturer
    BitRow { first: 24, last: 31, name: Part(74, 19), values: Part(0, 0) }, // of the manufacturer
    BitRow { first: 0, last: 15, name: Part(104, 8), values: Part(0, 5) }, // reaction
    BitRow { first: 0, last: 0, name: Part(217, 9), values: Part(0, 0) }, // switch on
    BitRow { first: 1, last: 1, name: Part(226, 14), values: Part(0, 0) }, // enable voltage
    BitRow { first: 2, last: 2, name: Part(240, 14), values: Part(0, 0) }, // quick stop off
    BitRow { first: 3, last: 3, name: Part(254, 16), values: Part(0, 0) }, // enable operation
    BitRow { first: 4, last: 6, name: Part(270, 11), values: Part(0, 0) }, // of the mode
    BitRow { first: 7, last: 7, name: Part(281, 11), values: Part(0, 0) }, // fault reset
    BitRow { first: 8, last: 8, name: Part(292, 4), values: Part(0, 0) }, // halt
    BitRow { first: 9, last: 9, name: Part(270, 11), values: Part(0, 0) }, // of the mode
    BitRow { first: 11, last: 15, name: Part(74, 19), values: Part(0, 0) }, // of the manufacturer
    BitRow { first: 0, last: 6, name: Part(307, 5), values: Part(5, 24) }, // state
    BitRow { first: 0, last: 0, name: Part(377, 18), values: Part(0, 0) }, // ready to switch on
    BitRow { first: 1, last: 1, name: Part(395, 11), values: Part(0, 0) }, // switched on
    BitRow { first: 2, last: 2, name: Part(406, 17), values: Part(0, 0) }, // operation enabled
    BitRow { first: 3, last: 3, name: Part(351, 5), values: Part(0, 0) }, // fault
    BitRow { first: 4, last: 4, name: Part(441, 15), values: Part(0, 0) }, // voltage enabled
    BitRow { first: 5, last: 5, name: Part(240, 14), values: Part(0, 0) }, // quick stop off
    BitRow { first: 6, last: 6, name: Part(423, 18), values: Part(0, 0) }, // switch on disabled
    BitRow { first: 7, last: 7, name: Part(456, 7), values: Part(0, 0) }, // warning
    BitRow { first: 8, last: 8, name: Part(74, 19), values: Part(0, 0) }, // of the manufacturer
    BitRow { first: 9, last: 9, name: Part(463, 6), values: Part(0, 0) }, // remote
    BitRow { first: 10, last: 10, name: Part(469, 14), values: Part(0, 0) }, // target reached
    BitRow { first: 11, last: 11, name: Part(483, 21), values: Part(0, 0) }, // internal limit active
    BitRow { first: 12, last: 13, name: Part(270, 11), values: Part(0, 0) }, // of the mode
    BitRow { first: 14, last: 15, name: Part(74, 19), values: Part(0, 0) }, // of the manufacturer
    BitRow { first: 0, last: 15, name: Part(104, 8), values: Part(29, 10) }, // reaction
    BitRow { first: 0, last: 15, name: Part(104, 8), values: Part(39, 3) }, // reaction
    BitRow { first: 0, last: 15, name: Part(104, 8), values: Part(42, 6) }, // reaction
    BitRow { first: 0, last: 7, name: Part(1791, 4), values: Part(48, 12) }, // mode
    BitRow { first: 0, last: 15, name: Part(2235, 22), values: Part(60, 3) }, // source of the velocity
    BitRow { first: 6, last: 6, name: Part(2727, 17), values: Part(0, 0) }, // velocity times -1
    BitRow { first: 7, last: 7, name: Part(2744, 17), values: Part(0, 0) }, // position times -1
    BitRow { first: 0, last: 15, name: Part(2895, 5), values: Part(63, 5) }, // shape
    BitRow { first: 0, last: 15, name: Part(2895, 5), values: Part(68, 3) }, // shape
    BitRow { first: 0, last: 7, name: Part(3455, 6), values: Part(71, 18) }, // method
    BitRow { first: 8, last: 15, name: Part(4135, 11), values: Part(0, 0) }, // denominator
    BitRow { first: 16, last: 23, name: Part(4146, 9), values: Part(0, 0) }, // numerator
    BitRow { first: 24, last: 31, name: Part(4155, 21), values: Part(0, 0) }, // prefix, a power of 10
    BitRow { first: 0, last: 0, name: Part(4292, 16), values: Part(0, 0) }, // touch probe 1 on
    BitRow { first: 1, last: 1, name: Part(4308, 24), values: Part(0, 0) }, // touch probe 1 continuous
    BitRow { first: 2, last: 3, name: Part(4332, 20), values: Part(89, 3) }, // touch probe 1 source
    BitRow { first: 4, last: 4, name: Part(4375, 35), values: Part(0, 0) }, // touch probe 1 samples positive edge
    BitRow { first: 5, last: 5, name: Part(4410, 35), values: Part(0, 0) }, // touch probe 1 samples negative edge
    BitRow { first: 6, last: 7, name: Part(74, 19), values: Part(0, 0) }, // of the manufacturer
    BitRow { first: 8, last: 8, name: Part(4445, 16), values: Part(0, 0) }, // touch probe 2 on
    BitRow { first: 9, last: 9, name: Part(4461, 24), values: Part(0, 0) }, // touch probe 2 continuous
    BitRow { first: 10, last: 11, name: Part(4485, 20), values: Part(92, 3) }, // touch probe 2 source
    BitRow { first: 12, last: 12, name: Part(4512, 35), values: Part(0, 0) }, // touch probe 2 samples positive edge
    BitRow { first: 13, last: 13, name: Part(4547, 35), values: Part(0, 0) }, // touch probe 2 samples negative edge
    BitRow { first: 14, last: 15, name: Part(74, 19), values: Part(0, 0) }, // of the manufacturer
    BitRow { first: 0, last: 0, name: Part(4292, 16), values: Part(0, 0) }, // touch probe 1 on
    BitRow { first: 1, last: 1, name: Part(4602, 31), values: Part(0, 0) }, // touch probe 1 has positive edge
    BitRow { first: 2, last: 2, name: Part(4633, 31), values: Part(0, 0) }, // touch probe 1 has negative edge
    BitRow { first: 6, last: 7, name: Part(74, 19), values: Part(0, 0) }, // of the manufacturer
    BitRow { first: 8, last: 8, name: Part(4445, 16), values: Part(0, 0) }, // touch probe 2 on
    BitRow { first: 9, last: 9, name: Part(4664, 31), values: Part(0, 0) }, // touch probe 2 has positive edge
    BitRow { first: 10, last: 10, name: Part(4695, 31), values: Part(0, 0) }, // touch probe 2 has negative edge
    BitRow { first: 14, last: 15, name: Part(74, 19), values: Part(0, 0) }, // of the manufacturer
    BitRow { first: 0, last: 15, name: Part(4852, 13), values: Part(95, 2) }, // interpolation
    BitRow { first: 0, last: 7, name: Part(5114, 12), values: Part(97, 2) }, // organization
    BitRow { first: 0, last: 1, name: Part(6146, 11), values: Part(99, 3) }, // relative to
    BitRow { first: 2, last: 3, name: Part(6219, 6), values: Part(102, 2) }, // change
    BitRow { first: 4, last: 5, name: Part(6287, 20), values: Part(0, 0) }, // request and response
    BitRow { first: 6, last: 7, name: Part(6307, 11), values: Part(104, 4) }, // rotary axis
    BitRow { first: 8, last: 11, name: Part(4852, 13), values: Part(0, 0) }, // interpolation
    BitRow { first: 12, last: 14, name: Part(6400, 8), values: Part(0, 0) }, // reserved
    BitRow { first: 15, last: 15, name: Part(74, 19), values: Part(0, 0) }, // of the manufacturer
    BitRow { first: 0, last: 0, name: Part(3708, 21), values: Part(0, 0) }, // negative limit switch
    BitRow { first: 1, last: 1, name: Part(3729, 21), values: Part(0, 0) }, // positive limit switch
    BitRow { first: 2, last: 2, name: Part(6625, 11), values: Part(0, 0) }, // home switch
    BitRow { first: 3, last: 3, name: Part(6636, 9), values: Part(0, 0) }, // interlock
    BitRow { first: 16, last: 31, name: Part(74, 19), values: Part(0, 0) }, // of the manufacturer
    BitRow { first: 0, last: 0, name: Part(6659, 9), values: Part(0, 0) }, // set brake
    BitRow { first: 16, last: 31, name: Part(74, 19), values: Part(0, 0) }, // of the manufacturer
    BitRow { first: 0, last: 15, name: Part(6722, 5), values: Part(108, 13) }, // motor
    BitRow { first: 0, last: 0, name: Part(1802, 16), values: Part(0, 0) }, // profile position
    BitRow { first: 1, last: 1, name: Part(1818, 8), values: Part(0, 0) }, // velocity
    BitRow { first: 2, last: 2, name: Part(1826, 16), values: Part(0, 0) }, // profile velocity
    BitRow { first: 3, last: 3, name: Part(1842, 14), values: Part(0, 0) }, // torque profile
    BitRow { first: 5, last: 5, name: Part(1856, 6), values: Part(0, 0) }, // homing
    BitRow { first: 6, last: 6, name: Part(1862, 21), values: Part(0, 0) }, // interpolated position
    BitRow { first: 7, last: 7, name: Part(1883, 27), values: Part(0, 0) }, // cyclic synchronous position
    BitRow { first: 8, last: 8, name: Part(1910, 27), values: Part(0, 0) }, // cyclic synchronous velocity
    BitRow { first: 9, last: 9, name: Part(1937, 25), values: Part(0, 0) }, // cyclic synchronous torque
    BitRow { first: 10, last: 10, name: Part(1962, 48), values: Part(0, 0) }, // cyclic synchronous torque with commutation angle
    BitRow { first: 16, last: 31, name: Part(74, 19), values: Part(0, 0) }, // of the manufacturer
];

static MEANINGS: &[MeaningRow] = &[
    MeaningRow { first: 0, last: 0, text: Part(112, 9) }, // no action
    MeaningRow { first: 1, last: 1, text: Part(121, 12) }, // fault signal
    MeaningRow { first: 2, last: 2, text: Part(133, 15) }, // disable voltage
    MeaningRow { first: 3, last: 3, text: Part(148, 10) }, // quick stop
    MeaningRow { first: 32768, last: 65535, text: Part(158, 21) }, // manufacturer-specific
    MeaningRow { first: 0, last: 0, text: Part(312, 22) }, // not ready to switch on
    MeaningRow { first: 7, last: 7, text: Part(334, 17) }, // quick stop active
    MeaningRow { first: 8, last: 8, text: Part(351, 5) }, // fault
    MeaningRow { first: 15, last: 15, text: Part(356, 21) }, // fault reaction active
    MeaningRow { first: 16, last: 16, text: Part(312, 22) }, // not ready to switch on
    MeaningRow { first: 23, last: 23, text: Part(334, 17) }, // quick stop active
    MeaningRow { first: 24, last: 24, text: Part(351, 5) }, // fault
    MeaningRow { first: 31, last: 31, text: Part(356, 21) }, // fault reaction active
    MeaningRow { first: 32, last: 32, text: Part(312, 22) }, // not ready to switch on
    MeaningRow { first: 33, last: 33, text: Part(377, 18) }, // ready to switch on
    MeaningRow { first: 35, last: 35, text: Part(395, 11) }, // switched on
    MeaningRow { first: 39, last: 39, text: Part(406, 17) }, // operation enabled
    MeaningRow { first: 40, last: 40, text: Part(351, 5) }, // fault
    MeaningRow { first: 47, last: 47, text: Part(356, 21) }, // fault reaction active
    MeaningRow { first: 48, last: 48, text: Part(312, 22) }, // not ready to switch on
    MeaningRow { first: 49, last: 49, text: Part(377, 18) }, // ready to switch on
    MeaningRow { first: 51, last: 51, text: Part(395, 11) }, // switched on
    MeaningRow { first: 55, last: 55, text: Part(406, 17) }, // operation enabled
    MeaningRow { first: 56, last: 56, text: Part(351, 5) }, // fault
    MeaningRow { first: 63, last: 63, text: Part(356, 21) }, // fault reaction active
    MeaningRow { first: 64, last: 64, text: Part(423, 18) }, // switch on disabled
    MeaningRow { first: 80, last: 80, text: Part(423, 18) }, // switch on disabled
    MeaningRow { first: 96, last: 96, text: Part(423, 18) }, // switch on disabled
    MeaningRow { first: 112, last: 112, text: Part(423, 18) }, // switch on disabled
    MeaningRow { first: 0, last: 0, text: Part(1255, 22) }, // disable drive function
    MeaningRow { first: 1, last: 1, text: Part(1277, 39) }, // slow down ramp, then switch on disabled
    MeaningRow { first: 2, last: 2, text: Part(1316, 40) }, // quick stop ramp, then switch on disabled
    MeaningRow { first: 3, last: 3, text: Part(1356, 38) }, // current limit, then switch on disabled
    MeaningRow { first: 4, last: 4, text: Part(1394, 38) }, // voltage limit, then switch on disabled
    MeaningRow { first: 5, last: 5, text: Part(1432, 41) }, // slow down ramp, stay in quick stop active
    MeaningRow { first: 6, last: 6, text: Part(1473, 42) }, // quick stop ramp, stay in quick stop active
    MeaningRow { first: 7, last: 7, text: Part(1515, 40) }, // current limit, stay in quick stop active
    MeaningRow { first: 8, last: 8, text: Part(1555, 40) }, // voltage limit, stay in quick stop active
    MeaningRow { first: 32768, last: 65535, text: Part(158, 21) }, // manufacturer-specific
    MeaningRow { first: 0, last: 0, text: Part(1255, 22) }, // disable drive function
    MeaningRow { first: 1, last: 1, text: Part(1617, 28) }, // slow down ramp, then disable
    MeaningRow { first: 32768, last: 65535, text: Part(158, 21) }, // manufacturer-specific
    MeaningRow { first: 0, last: 0, text: Part(1255, 22) }, // disable drive function
    MeaningRow { first: 1, last: 1, text: Part(1694, 14) }, // slow down ramp
    MeaningRow { first: 2, last: 2, text: Part(1708, 15) }, // quick stop ramp
    MeaningRow { first: 3, last: 3, text: Part(1723, 13) }, // current limit
    MeaningRow { first: 4, last: 4, text: Part(1736, 13) }, // voltage limit
    MeaningRow { first: 32768, last: 65535, text: Part(158, 21) }, // manufacturer-specific
    MeaningRow { first: 0, last: 0, text: Part(1795, 7) }, // no mode
    MeaningRow { first: 1, last: 1, text: Part(1802, 16) }, // profile position
    MeaningRow { first: 2, last: 2, text: Part(1818, 8) }, // velocity
    MeaningRow { first: 3, last: 3, text: Part(1826, 16) }, // profile velocity
    MeaningRow { first: 4, last: 4, text: Part(1842, 14) }, // torque profile
    MeaningRow { first: 6, last: 6, text: Part(1856, 6) }, // homing
    MeaningRow { first: 7, last: 7, text: Part(1862, 21) }, // interpolated position
    MeaningRow { first: 8, last: 8, text: Part(1883, 27) }, // cyclic synchronous position
    MeaningRow { first: 9, last: 9, text: Part(1910, 27) }, // cyclic synchronous velocity
    MeaningRow { first: 10, last: 10, text: Part(1937, 25) }, // cyclic synchronous torque
    MeaningRow { first: 11, last: 11, text: Part(1962, 48) }, // cyclic synchronous torque with commutation angle
    MeaningRow { first: 128, last: 255, text: Part(158, 21) }, // manufacturer-specific
    MeaningRow { first: 0, last: 0, text: Part(2257, 16) }, // position encoder
    MeaningRow { first: 1, last: 1, text: Part(2273, 16) }, // velocity encoder
    MeaningRow { first: 32768, last: 65535, text: Part(158, 21) }, // manufacturer-specific
    MeaningRow { first: 0, last: 0, text: Part(2900, 11) }, // linear ramp
    MeaningRow { first: 1, last: 1, text: Part(2911, 10) }, // sin² ramp
    MeaningRow { first: 2, last: 2, text: Part(2921, 14) }, // jerk-free ramp
    MeaningRow { first: 3, last: 3, text: Part(2935, 17) }, // jerk-limited ramp
    MeaningRow { first: 32768, last: 65535, text: Part(158, 21) }, // manufacturer-specific
    MeaningRow { first: 0, last: 0, text: Part(2900, 11) }, // linear ramp
    MeaningRow { first: 1, last: 1, text: Part(2911, 10) }, // sin² ramp
    MeaningRow { first: 32768, last: 65535, text: Part(158, 21) }, // manufacturer-specific
    MeaningRow { first: 0, last: 0, text: Part(3461, 9) }, // no homing
    MeaningRow { first: 1, last: 1, text: Part(3470, 37) }, // negative limit switch and index pulse
    MeaningRow { first: 2, last: 2, text: Part(3507, 37) }, // positive limit switch and index pulse
    MeaningRow { first: 3, last: 4, text: Part(3544, 36) }, // positive home switch and index pulse
    MeaningRow { first: 5, last: 6, text: Part(3580, 36) }, // negative home switch and index pulse
    MeaningRow { first: 7, last: 10, text: Part(3616, 46) }, // home switch and index pulse, starting positive
    MeaningRow { first: 11, last: 14, text: Part(3662, 46) }, // home switch and index pulse, starting negative
    MeaningRow { first: 17, last: 17, text: Part(3708, 21) }, // negative limit switch
    MeaningRow { first: 18, last: 18, text: Part(3729, 21) }, // positive limit switch
    MeaningRow { first: 19, last: 20, text: Part(3750, 20) }, // positive home switch
    MeaningRow { first: 21, last: 22, text: Part(3770, 20) }, // negative home switch
    MeaningRow { first: 23, last: 26, text: Part(3790, 30) }, // home switch, starting positive
    MeaningRow { first: 27, last: 30, text: Part(3820, 30) }, // home switch, starting negative
    MeaningRow { first: 33, last: 33, text: Part(3850, 33) }, // index pulse in negative direction
    MeaningRow { first: 34, last: 34, text: Part(3883, 33) }, // index pulse in positive direction
    MeaningRow { first: 35, last: 35, text: Part(3916, 28) }, // current position (version 2)
    MeaningRow { first: 37, last: 37, text: Part(3944, 16) }, // current position
    MeaningRow { first: 128, last: 255, text: Part(158, 21) }, // manufacturer-specific
    MeaningRow { first: 0, last: 0, text: Part(4352, 5) }, // input
    MeaningRow { first: 1, last: 1, text: Part(4357, 11) }, // index pulse
    MeaningRow { first: 2, last: 2, text: Part(4368, 7) }, // 60D0h:1
    MeaningRow { first: 0, last: 0, text: Part(4352, 5) }, // input
    MeaningRow { first: 1, last: 1, text: Part(4357, 11) }, // index pulse
    MeaningRow { first: 2, last: 2, text: Part(4505, 7) }, // 60D0h:2
    MeaningRow { first: 0, last: 0, text: Part(4865, 20) }, // linear interpolation
    MeaningRow { first: 32768, last: 65535, text: Part(158, 21) }, // manufacturer-specific
    MeaningRow { first: 0, last: 0, text: Part(5126, 4) }, // FIFO
    MeaningRow { first: 1, last: 1, text: Part(5130, 4) }, // ring
    MeaningRow { first: 0, last: 0, text: Part(6157, 20) }, // last target position
    MeaningRow { first: 1, last: 1, text: Part(6177, 21) }, // position demand value
    MeaningRow { first: 2, last: 2, text: Part(6198, 21) }, // position actual value
    MeaningRow { first: 0, last: 0, text: Part(6225, 7) }, // at once
    MeaningRow { first: 1, last: 1, text: Part(6232, 55) }, // of the set-point at once, of the rest with the next one
    MeaningRow { first: 0, last: 0, text: Part(6318, 40) }, // within one revolution like a linear axis
    MeaningRow { first: 1, last: 1, text: Part(6358, 15) }, // always negative
    MeaningRow { first: 2, last: 2, text: Part(6373, 15) }, // always positive
    MeaningRow { first: 3, last: 3, text: Part(6388, 12) }, // shortest way
    MeaningRow { first: 0, last: 0, text: Part(6727, 18) }, // non-standard motor
    MeaningRow { first: 1, last: 1, text: Part(6745, 24) }, // phase modulated DC motor
    MeaningRow { first: 2, last: 2, text: Part(6769, 29) }, // frequency controlled DC motor
    MeaningRow { first: 3, last: 3, text: Part(6798, 34) }, // permanent magnet synchronous motor
    MeaningRow { first: 4, last: 4, text: Part(6832, 38) }, // frequency controlled synchronous motor
    MeaningRow { first: 5, last: 5, text: Part(6870, 25) }, // switched reluctance motor
    MeaningRow { first: 6, last: 6, text: Part(6895, 27) }, // wound rotor induction motor
    MeaningRow { first: 7, last: 7, text: Part(6922, 29) }, // squirrel cage induction motor
    MeaningRow { first: 8, last: 8, text: Part(30, 13) }, // stepper motor
    MeaningRow { first: 9, last: 9, text: Part(6951, 24) }, // micro-step stepper motor
    MeaningRow { first: 10, last: 10, text: Part(6975, 43) }, // brushless motor with sinusoidal commutation
    MeaningRow { first: 11, last: 11, text: Part(7018, 38) }, // brushless motor with block commutation
    MeaningRow { first: 32768, last: 65535, text: Part(158, 21) }, // manufacturer-specific
];

static CONDITIONS: &[Condition] = &[
    Condition::constant("6502h[1]", &[BitsIn(25858, 0, [1, 1], 1), Range(1, 170141183460469231731687303715884105727)]),
    Condition::constant("6502h[0] or 6502h[6] or 6502h[7]", &[OneOf(3), BitsIn(25858, 0, [0, 0], 1), Range(1, 170141183460469231731687303715884105727), BitsIn(25858, 0, [6, 6], 1), Range(1, 170141183460469231731687303715884105727), BitsIn(25858, 0, [7, 7], 1), Range(1, 170141183460469231731687303715884105727)]),
    Condition::constant("6502h[2]", &[BitsIn(25858, 0, [2, 2], 1), Range(1, 170141183460469231731687303715884105727)]),
    Condition::constant("6502h[3] or 6502h[9]", &[OneOf(2), BitsIn(25858, 0, [3, 3], 1), Range(1, 170141183460469231731687303715884105727), BitsIn(25858, 0, [9, 9], 1), Range(1, 170141183460469231731687303715884105727)]),
    Condition::constant("6502h[0] or 6502h[7]", &[OneOf(2), BitsIn(25858, 0, [0, 0], 1), Range(1, 170141183460469231731687303715884105727), BitsIn(25858, 0, [7, 7], 1), Range(1, 170141183460469231731687303715884105727)]),
    Condition::constant("6502h[0]", &[BitsIn(25858, 0, [0, 0], 1), Range(1, 170141183460469231731687303715884105727)]),
    Condition::constant("6502h[0] or 6502h[2]", &[OneOf(2), BitsIn(25858, 0, [0, 0], 1), Range(1, 170141183460469231731687303715884105727), BitsIn(25858, 0, [2, 2], 1), Range(1, 170141183460469231731687303715884105727)]),
    Condition::constant("6502h[3]", &[BitsIn(25858, 0, [3, 3], 1), Range(1, 170141183460469231731687303715884105727)]),
    Condition::constant("6502h[5]", &[BitsIn(25858, 0, [5, 5], 1), Range(1, 170141183460469231731687303715884105727)]),
    Condition::constant("6502h[7] or 6502h[8] or 6502h[9]", &[OneOf(3), BitsIn(25858, 0, [7, 7], 1), Range(1, 170141183460469231731687303715884105727), BitsIn(25858, 0, [8, 8], 1), Range(1, 170141183460469231731687303715884105727), BitsIn(25858, 0, [9, 9], 1), Range(1, 170141183460469231731687303715884105727)]),
    Condition::constant("6502h[2] or 6502h[8]", &[OneOf(2), BitsIn(25858, 0, [2, 2], 1), Range(1, 170141183460469231731687303715884105727), BitsIn(25858, 0, [8, 8], 1), Range(1, 170141183460469231731687303715884105727)]),
];

static OBJECT_TYPES: &[ObjectType] = &[Var, Array, Record, Array, Record];

static DATA_TYPES: &[DataType] = &[DataType(3), DataType(6), DataType(5), DataType(7), DataType(4), DataType(2), DataType(6), DataType(3), DataType(9), DataType(12)];

static ACCESS: &[Access] = &[Rw, Ro, Const, Ro, Rw, Wo, Rw, Ro, Wo, Rw];

static VALUES: &[std::ops::RangeInclusive<i128>] = &[-32768..=3, 2..=2, -32768..=8, -32768..=1, -32768..=4, -128..=4, 6..=11, -128..=14, 17..=30, 33..=35, 37..=37, 1..=1, 2..=2, 4..=4, 6..=6, 1..=6, 1..=254, -128..=63, 6..=6, 0..=0, 1..=1, 1..=2];

static DEFAULTS: &[Value] = &[Signed(2), Signed(0), Signed(1)];

static INDEXES: &[u16] = &[];

static TEXTS: &str = concat!(
    "frequency converter", "servo drive", "stepper motor", "PDO mapping of the manufacturer",
    "of the manufacturer", "Device type", "reaction", "no action", "fault signal", "disable voltage",
    "quick stop", "manufacturer-specific", "Abort connection option code", "Error code", "switch on",
    "enable voltage", "quick stop off", "enable operation", "of the mode", "fault reset", "halt", "Controlword",
    "state", "not ready to switch on", "quick stop active", "fault", "fault reaction active",
    "ready to switch on", "switched on", "operation enabled", "switch on disabled", "voltage enabled", "warning",
    "remote", "target reached", "internal limit active", "Statusword", "vl target velocity",
    "vl velocity demand", "vl velocity actual value", "vl manipulated velocity", "Highest sub-index supported",
    "vl velocity min amount", "vl velocity max amount", "vl velocity min max amount", "vl velocity min max",
    "Delta speed", "Delta time", "vl velocity acceleration", "vl velocity deceleration",
    "vl velocity quick stop", "vl set-point factor numerator", "vl set-point factor denominator",
    "vl set-point factor", "vl dimension factor numerator", "vl dimension factor denominator",
    "vl dimension factor", "vl pole number", "vl velocity reference", "vl ramp function time",
    "vl slow down time", "vl quick stop time", "vl nominal percentage", "vl percentage demand",
    "vl actual percentage", "vl manipulated percentage", "vl velocity motor min max amount",
    "vl velocity motor min max", "vl frequency motor min max amount", "vl frequency motor min max",
    "disable drive function", "slow down ramp, then switch on disabled",
    "quick stop ramp, then switch on disabled", "current limit, then switch on disabled",
    "voltage limit, then switch on disabled", "slow down ramp, stay in quick stop active",
    "quick stop ramp, stay in quick stop active", "current limit, stay in quick stop active",
    "voltage limit, stay in quick stop active", "Quick stop option code", "slow down ramp, then disable",
    "Shutdown option code", "Disable operation option code", "slow down ramp", "quick stop ramp",
    "current limit", "voltage limit", "Halt option code", "Fault reaction option code", "mode", "no mode",
    "profile position", "velocity", "profile velocity", "torque profile", "homing", "interpolated position",
    "cyclic synchronous position", "cyclic synchronous velocity", "cyclic synchronous torque",
    "cyclic synchronous torque with commutation angle", "Modes of operation", "Modes of operation display",
    "Position demand value", "Position actual internal value", "Position actual value", "Following error window",
    "Following error time out", "Position window", "Position window time", "Velocity sensor actual value",
    "source of the velocity", "position encoder", "velocity encoder", "Sensor selection code",
    "Velocity demand value", "Velocity actual value", "Velocity window", "Velocity window time",
    "Velocity threshold", "Velocity threshold time", "Target torque", "Max torque", "Max current",
    "Torque demand", "Motor rated current", "Motor rated torque", "Torque actual value", "Current actual value",
    "DC link circuit voltage", "Target position", "Min position range limit", "Max position range limit",
    "Position range limit", "Home offset", "Min position limit", "Max position limit", "Software position limit",
    "velocity times -1", "position times -1", "Polarity", "Max profile velocity", "Max motor speed",
    "Profile velocity", "End velocity", "Profile acceleration", "Profile deceleration",
    "Quick stop deceleration", "shape", "linear ramp", "sin² ramp", "jerk-free ramp", "jerk-limited ramp",
    "Motion profile type", "Torque slope", "Torque profile type", "Position notation index", "version 2",
    "Position dimension index", "Velocity notation index", "Velocity dimension index",
    "Acceleration notation index", "Acceleration dimension index", "Encoder increments", "Motor revolutions",
    "Position encoder resolution", "Encoder increments per second", "Motor revolutions per second",
    "Velocity encoder resolution", "Shaft revolutions", "Gear ratio", "Feed", "Feed constant", "Numerator",
    "Position factor", "Divisor", "Velocity encoder factor", "Velocity factor 1", "Velocity factor",
    "Acceleration factor", "method", "no homing", "negative limit switch and index pulse",
    "positive limit switch and index pulse", "positive home switch and index pulse",
    "negative home switch and index pulse", "home switch and index pulse, starting positive",
    "home switch and index pulse, starting negative", "negative limit switch", "positive limit switch",
    "positive home switch", "negative home switch", "home switch, starting positive",
    "home switch, starting negative", "index pulse in negative direction", "index pulse in positive direction",
    "current position (version 2)", "current position", "Homing method", "Speed during search for switch",
    "Speed during search for zero", "Homing speeds", "Homing acceleration", "Jerk factor", "Profile jerk use",
    "Profile jerk 1", "Profile jerk 2 to 6", "Profile jerk", "denominator", "numerator", "prefix, a power of 10",
    "SI unit position", "version 4", "SI unit velocity", "SI unit acceleration", "SI unit jerk",
    "Position offset", "Velocity offset", "Torque offset", "touch probe 1 on", "touch probe 1 continuous",
    "touch probe 1 source", "input", "index pulse", "60D0h:1", "touch probe 1 samples positive edge",
    "touch probe 1 samples negative edge", "touch probe 2 on", "touch probe 2 continuous",
    "touch probe 2 source", "60D0h:2", "touch probe 2 samples positive edge",
    "touch probe 2 samples negative edge", "Touch probe function", "touch probe 1 has positive edge",
    "touch probe 1 has negative edge", "touch probe 2 has positive edge", "touch probe 2 has negative edge",
    "Touch probe status", "Touch probe 1 positive edge", "Touch probe 1 negative edge",
    "Touch probe 2 positive edge", "Touch probe 2 negative edge", "interpolation", "linear interpolation",
    "Interpolation sub mode select", "Set-point 1", "Set-point 2 to 254", "Interpolation data record",
    "Interpolation time period value", "Interpolation time index", "Interpolation time period",
    "Interpolation sync definition", "Maximum buffer size", "Actual buffer size", "organization", "FIFO", "ring",
    "Buffer organization", "Buffer position", "Size of data record", "Buffer clear",
    "Interpolation data configuration", "Max acceleration", "Max deceleration", "Touch probe source",
    "Touch probe time stamp 1 positive value", "Touch probe time stamp 1 negative value",
    "Touch probe time stamp 2 positive value", "Touch probe time stamp 2 negative value",
    "Touch probe 1 positive edge counter", "Touch probe 1 negative edge counter",
    "Touch probe 2 positive edge counter", "Touch probe 2 negative edge counter", "Positive torque limit value",
    "Negative torque limit value", "Supported homing methods", "Additional position actual value",
    "Additional velocity actual value", "Additional position encoder resolution, encoder increments",
    "Additional velocity encoder resolution, encoder increments per second",
    "Additional gear ratio, motor shaft revolutions", "Additional feed constant, feed",
    "Additional position encoder resolution, motor revolutions",
    "Additional velocity encoder resolution, motor revolutions per second",
    "Additional gear ratio, driving shaft revolutions", "Additional feed constant, driving shaft revolutions",
    "relative to", "last target position", "position demand value", "position actual value", "change", "at once",
    "of the set-point at once, of the rest with the next one", "request and response", "rotary axis",
    "within one revolution like a linear axis", "always negative", "always positive", "shortest way", "reserved",
    "Positioning option code", "Following error actual value", "Torque control parameter set",
    "Power stage parameters", "Max slippage", "Velocity control parameter set", "Control effort",
    "Position control parameter set", "Position demand internal value", "home switch", "interlock",
    "Digital inputs", "set brake", "Physical outputs", "Bit mask", "Digital outputs", "Target velocity", "motor",
    "non-standard motor", "phase modulated DC motor", "frequency controlled DC motor",
    "permanent magnet synchronous motor", "frequency controlled synchronous motor", "switched reluctance motor",
    "wound rotor induction motor", "squirrel cage induction motor", "micro-step stepper motor",
    "brushless motor with sinusoidal commutation", "brushless motor with block commutation", "Motor type",
    "Motor catalogue number", "Motor manufacturer", "HTTP motor catalogue address", "Motor calibration date",
    "Motor service period", "Motor data", "Supported drive modes",
    "mandatory from version 3 on; version 2 left it to the drive", "Drive catalogue number",
    "Drive manufacturer", "HTTP drive catalogue address", "Drive data", "Version number", "Single device type",
);
