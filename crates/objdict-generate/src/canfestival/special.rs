//! Objects that the stack reads through pointers: the type that it assumes for each entry.

use crate::dictionary::{ResolvedEntry, ResolvedObject};
use crate::model::{DataType, ObjectType};
use crate::resolve::{Encoded, ValueShape};

const U8: DataType = DataType::UNSIGNED8;
const U16: DataType = DataType::UNSIGNED16;
const U32: DataType = DataType::UNSIGNED32;

/// The single values with the stack's variable names and types; 1014h is 80h plus the node-ID by default.
pub(super) const VALUES: [(u16, DataType); 7] =
    [(0x1001, U8), (0x1005, U32), (0x1006, U32), (0x100C, U16), (0x100D, U8), (0x1014, U32), (0x1017, U16)];

/// Lists of UNSIGNED32 whose number the stack stores: error history and heartbeat consumers.
pub(super) const LISTS: [u16; 2] = [0x1003, 0x1016];

/// The objects that the stack finds by their positions.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Family {
    SdoServer,
    SdoClient,
    Rpdo,
    RpdoMapping,
    Tpdo,
    TpdoMapping,
}

impl Family {
    pub(super) const ALL: [Self; 6] =
        [Self::SdoServer, Self::SdoClient, Self::Rpdo, Self::RpdoMapping, Self::Tpdo, Self::TpdoMapping];

    /// The family of an index.
    pub(super) fn of(index: u16) -> Option<Self> {
        Some(match index {
            0x1200..=0x127F => Self::SdoServer,
            0x1280..=0x12FF => Self::SdoClient,
            0x1400..=0x15FF => Self::Rpdo,
            0x1600..=0x17FF => Self::RpdoMapping,
            0x1800..=0x19FF => Self::Tpdo,
            0x1A00..=0x1BFF => Self::TpdoMapping,
            _ => return None,
        })
    }

    /// The type that the stack expects at a sub-index, and whether it needs the entry.
    fn expects(self, sub: u8) -> Option<(DataType, bool)> {
        Some(match (self, sub) {
            (Self::SdoServer | Self::SdoClient, 1 | 2) | (Self::Rpdo | Self::Tpdo, 1) => (U32, true),
            (Self::SdoClient, 3) | (Self::Rpdo | Self::Tpdo, 2) => (U8, true),
            (Self::Rpdo | Self::Tpdo, 3 | 5) => (U16, false),
            (Self::RpdoMapping | Self::TpdoMapping, 0) => (U8, true),
            (Self::RpdoMapping | Self::TpdoMapping, 1..=64) => (U32, false),
            _ => return None,
        })
    }

    /// The number of rows that the stack reads without checking their number.
    pub(super) fn rows(self) -> usize {
        match self {
            Self::SdoServer => 3,
            Self::SdoClient => 4,
            Self::Rpdo | Self::Tpdo => 6,
            // an empty mapping is read, too
            Self::RpdoMapping | Self::TpdoMapping => 2,
        }
    }
}

/// The stack's unmet expectation of an object; `None` if it can use the object.
pub(super) fn misfit(object: &ResolvedObject<'_>) -> Option<&'static str> {
    let index = object.index;
    let is = |entry: &ResolvedEntry<'_>, data_type| entry.resolved.shape == ValueShape::Word(data_type);
    let at = |sub: u8| object.entries.iter().find(|entry| entry.sub == sub);
    if let Some(&(_, data_type)) = VALUES.iter().find(|(value, _)| *value == index) {
        let fits = object.is_single() && object.entries.iter().all(|entry| is(entry, data_type));
        return (!fits).then_some("a single value of the type of CiA 301");
    }
    if LISTS.contains(&index) {
        let count = at(0).filter(|entry| is(entry, U8));
        let elements = object.entries.iter().skip(1);
        let alike =
            elements.clone().zip(1_u16..).all(|(entry, sub)| u16::from(entry.sub) == sub && is(entry, U32));
        let given = count.and_then(|entry| match entry.resolved.default {
            Encoded::Word(count) => usize::try_from(count).ok(),
            _ => None,
        });
        let fits = alike && elements.len() > 0 && given.is_some_and(|given| given <= elements.len());
        return (!fits).then_some("a count and UNSIGNED32 entries without gaps");
    }
    let family = Family::of(index)?;
    let expected = (0..=64).filter_map(|sub| Some((sub, family.expects(sub)?)));
    let fits = |(sub, (data_type, needed)): (u8, (DataType, bool))| match at(sub) {
        Some(entry) => is(entry, data_type),
        None => !needed,
    };
    let has_subs = object.object.object_type() != ObjectType::Var || object.entries.len() > 1;
    (!has_subs || !expected.into_iter().all(fits)).then_some("the entries of CiA 301")
}
