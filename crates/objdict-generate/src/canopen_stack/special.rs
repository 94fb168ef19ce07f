//! Objects for which canopen-stack has special types.

use crate::dictionary::ResolvedObject;
use crate::model::{DataType, PdoKind};
use crate::resolve::{EntryPlan, ValueShape};

pub(super) const STORE: u16 = 0x1010;
pub(super) const RESTORE: u16 = 0x1011;

/// A type of the stack for an entry of the communication profile.
#[derive(Clone, Copy)]
pub(super) struct Special {
    /// The macro of the type.
    pub(super) type_: &'static str,
    /// The data type that its functions expect.
    pub(super) wants: DataType,
    /// Its `DataField` field.
    pub(super) data: DataField,
}

/// The content of the `DataField` field of a special type.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum DataField {
    /// The value or its address, as for any number.
    Any,
    /// The address of the value: the type treats a value of 0 as a missing address.
    Address,
    /// The address of a value that the stack changes.
    Ram,
    /// A heartbeat consumer.
    Consumer,
    /// A parameter group.
    Group,
}

/// The special type of an entry.
pub(super) fn special(index: u16, sub: u8, writable: bool) -> Option<Special> {
    use DataType as T;
    let (type_, wants, data) = match (index, sub) {
        (0x1001, 0) => ("CO_TUNSIGNED8", T::UNSIGNED8, DataField::Ram),
        (0x1003, 0) => ("CO_TEMCY_HIST", T::UNSIGNED8, DataField::Ram),
        (0x1003, 1..=0xFE) => ("CO_TEMCY_HIST", T::UNSIGNED32, DataField::Ram),
        (0x1005, 0) => ("CO_TSYNC_ID", T::UNSIGNED32, DataField::Any),
        (0x1006, 0) => ("CO_TSYNC_CYCLE", T::UNSIGNED32, DataField::Any),
        (0x1010, 0) => ("CO_TPARA_STORE", T::UNSIGNED8, DataField::Any),
        (0x1010, 1..=0x7F) => ("CO_TPARA_STORE", T::UNSIGNED32, DataField::Group),
        (0x1011, 0) => ("CO_TPARA_RESTORE", T::UNSIGNED8, DataField::Any),
        (0x1011, 1..=0x7F) => ("CO_TPARA_RESTORE", T::UNSIGNED32, DataField::Group),
        (0x1014, 0) => ("CO_TEMCY_ID", T::UNSIGNED32, DataField::Any),
        (0x1016, 0) => ("CO_THB_CONS", T::UNSIGNED8, DataField::Any),
        (0x1016, 1..=0x7F) => ("CO_THB_CONS", T::UNSIGNED32, DataField::Consumer),
        (0x1017, 0) => ("CO_THB_PROD", T::UNSIGNED16, DataField::Address),
        // the client type would disable the server with the same number
        (0x1200..=0x127F, 1 | 2) if writable => ("CO_TSDO_ID", T::UNSIGNED32, DataField::Any),
        _ => return pdo(index, sub),
    };
    Some(Special { type_, wants, data })
}

fn pdo(index: u16, sub: u8) -> Option<Special> {
    let (type_, wants) = if let Some((kind, _)) = PdoKind::of_communication(index) {
        match sub {
            1 => ("CO_TPDO_ID", DataType::UNSIGNED32),
            2 => ("CO_TPDO_TYPE", DataType::UNSIGNED8),
            5 if kind == PdoKind::Tpdo => ("CO_TPDO_EVENT", DataType::UNSIGNED16),
            _ => return None,
        }
    } else {
        PdoKind::of_mapping(index)?;
        match sub {
            0 => ("CO_TPDO_NUM", DataType::UNSIGNED8),
            1..=64 => ("CO_TPDO_MAP", DataType::UNSIGNED32),
            _ => return None,
        }
    };
    Some(Special { type_, wants, data: DataField::Any })
}

/// Whether the data type of an entry matches its special type.
pub(super) fn fits(special: Special, resolved: &EntryPlan) -> bool {
    resolved.shape == ValueShape::Word(special.wants)
}

/// Whether the object can use its special types; some access the other sub-indexes without checking them, so all entries
/// must match.
pub(super) fn object_fits(object: &ResolvedObject<'_>) -> bool {
    !matches!(object.index, 0x1003 | 0x1010 | 0x1011 | 0x1016)
        || object.entries.iter().all(|entry| match special(object.index, entry.sub, false) {
            Some(special) => fits(special, &entry.resolved),
            None => entry.sub == 0xFF,
        }) && object.entries.first().is_some_and(|entry| entry.sub == 0)
            && (object.index != 0x1003 || object.entries.get(1).is_some_and(|entry| entry.sub == 1))
}
