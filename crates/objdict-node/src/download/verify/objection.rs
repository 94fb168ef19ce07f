//! Objections to a download.

use objdict_device::Abort;

use crate::model::{DataType, MappedObject, PdoKind, Place, Value};

/// A problem of a download.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Objection {
    /// Number of the download, counted from 1.
    pub number: usize,
    /// Offset of the download in the stream (its index).
    pub offset: usize,
    /// Index of the object.
    pub index: u16,
    /// Sub-index of the entry.
    pub sub: u8,
    /// The place as used in reports.
    pub place: Place,
    /// The kind of the problem.
    pub kind: ObjectionKind,
}

/// SDO abort code (CiA 301 §7.2.4.3.17).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct AbortCode(pub u32);

/// The kinds of problems.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ObjectionKind {
    /// The dictionary has no such object.
    NoObject,
    /// The object has no such sub-index.
    NoSubIndex,
    /// The access type allows no write.
    NotWritable,
    /// `ObjFlags` bit 0: a configuration tool must not write the entry.
    RefusesDownload,
    /// The number of bytes does not match the data type.
    Length {
        /// The data type.
        data_type: DataType,
        /// The size of the data type.
        expected: usize,
        /// The size of the download.
        found: usize,
    },
    /// The bytes are not valid for the data type.
    NoValue(DataType),
    /// Below `LowLimit`.
    BelowLimit {
        /// The value.
        value: Value,
        /// The limit.
        limit: Value,
    },
    /// Above `HighLimit`.
    AboveLimit {
        /// The value.
        value: Value,
        /// The limit.
        limit: Value,
    },
    /// The value is not defined in CiA 301 for this entry.
    Undefined(&'static str),
    /// The CAN-ID belongs to a service that cannot be configured.
    RestrictedCanId {
        /// The CAN-ID.
        can_id: u32,
        /// The service.
        owner: &'static str,
    },
    /// The identifier, bits 0 to 29, may change only while the service is not valid.
    InUse {
        /// The present COB-ID.
        present: u32,
        /// How to mark it not valid.
        how: &'static str,
    },
    /// The write marks the service as not valid and changes its identifier at the same time; some devices
    /// reject it.
    RenamedWhileSwitchedOff {
        /// The present COB-ID.
        present: u32,
    },
    /// A PDO and SYNC would have the same CAN-ID.
    SharedWithSync {
        /// The CAN-ID.
        can_id: u32,
    },
    /// The inhibit time and the SYNC start value of a PDO may change only while bit 31 of its COB-ID is set.
    PdoIsValid(PdoKind, u16),
    /// The mapping of a PDO may change only while bit 31 of its COB-ID is set.
    MappingIsValid(PdoKind, u16),
    /// A mapping may change only while its sub-index 0 is 0.
    MappingInUse,
    /// The mapped object does not exist, or PDOs of this kind cannot map it.
    NotMappable(MappedObject, PdoKind),
    /// The mapping states a different length from the entry's.
    MappedLength {
        /// The mapping entry.
        mapped: MappedObject,
        /// Length of the entry in bits.
        bits: u32,
    },
    /// More than 64 bits, or more than 64 objects, are mapped.
    PdoTooLong {
        /// The number of bits.
        bits: u32,
    },
    /// A sub-index within the number of mapped objects is empty.
    NothingMapped {
        /// The sub-index.
        sub: u8,
    },
    /// The number of mapped objects includes a sub-index that the mapping does not have.
    NoMappingEntry {
        /// The sub-index.
        sub: u8,
    },
    /// A different entry of 1016h already monitors the node.
    WatchedTwice {
        /// The node.
        node_id: u8,
        /// The sub-index that monitors it.
        sub: u8,
    },
    /// An entry of 1016h has a time but no node-ID from 1 to 127, so it is not in use.
    WatchesNobody {
        /// The value instead of the node-ID.
        node_id: u8,
        /// The time in milliseconds.
        time: u16,
    },
    /// The counter overflow (1019h) may change only while the period (1006h) is 0.
    PeriodRuns,
    /// 1010h expects `save`, 1011h `load`.
    Signature {
        /// The expected signature.
        expected: &'static str,
    },
    /// Heartbeat and node guarding are both active.
    TwoErrorControls,
    /// The write follows 1010h, so it is not stored.
    NotStored,
    /// The write clears the verify configuration (1020h) that an earlier one wrote.
    ClearsVerification,
}

impl ObjectionKind {
    /// Whether devices reject the download. Otherwise some or all accept it, but it is probably a mistake.
    pub const fn is_refusal(&self) -> bool {
        !matches!(
            self,
            Self::RenamedWhileSwitchedOff { .. }
                | Self::WatchesNobody { .. }
                | Self::TwoErrorControls
                | Self::NotStored
                | Self::ClearsVerification
        )
    }

    /// The abort code of the device; `None` for downloads that it accepts, and for rules that apply only to
    /// tools.
    pub const fn abort(&self) -> Option<AbortCode> {
        let abort = match self {
            Self::NoObject => Abort::NoObject,
            Self::NoSubIndex => Abort::NoSubIndex,
            Self::NotWritable => Abort::ReadOnly,
            Self::Length { expected, found, .. } if *found > *expected => Abort::TooLong,
            Self::Length { .. } => Abort::TooShort,
            Self::AboveLimit { .. } => Abort::TooHigh,
            Self::BelowLimit { .. } => Abort::TooLow,
            Self::NoValue(DataType::UNICODE_STRING) => Abort::LengthMismatch,
            Self::NoValue(_)
            | Self::Undefined(_)
            | Self::RestrictedCanId { .. }
            | Self::SharedWithSync { .. }
            | Self::InUse { .. }
            | Self::RenamedWhileSwitchedOff { .. }
            | Self::PdoIsValid(..) => Abort::InvalidValue,
            Self::MappingIsValid(..) | Self::MappingInUse => Abort::UnsupportedAccess,
            Self::PeriodRuns => Abort::DeviceState,
            Self::NotMappable(..) | Self::MappedLength { .. } | Self::NothingMapped { .. } => {
                Abort::NotMappable
            }
            Self::NoMappingEntry { .. } | Self::PdoTooLong { .. } => Abort::PdoTooLong,
            Self::WatchedTwice { .. } => Abort::Incompatible,
            Self::Signature { .. } => Abort::CannotStore,
            Self::RefusesDownload
            | Self::WatchesNobody { .. }
            | Self::TwoErrorControls
            | Self::NotStored
            | Self::ClearsVerification => return None,
        };
        Some(AbortCode(abort.code()))
    }

    /// How to fix it.
    pub fn help(&self) -> Option<String> {
        let text = match self {
            Self::InUse { how, .. } => return Some(format!("{how} first")),
            Self::RenamedWhileSwitchedOff { present } => {
                return Some(format!("set bit 31 without changing the identifier of `0x{present:X}`"));
            }
            Self::PdoIsValid(kind, number) | Self::MappingIsValid(kind, number) => {
                return Some(format!("set bit 31 of the COB-ID of {kind} {number} first"));
            }
            Self::MappingInUse => "write 0 to sub-index 0 first",
            Self::PeriodRuns => "write 0 to 1006h first",
            Self::WatchedTwice { sub, .. } => {
                return Some(format!("write 0 to sub-index {sub:X}h of 1016h first"));
            }
            Self::WatchesNobody { time, .. } => {
                return Some(format!("write the node-ID from 1 to 127 before the time: `0x00nn{time:04X}`"));
            }
            Self::NotStored => "write 1010h last",
            Self::ClearsVerification => "write 1020h after all other entries",
            Self::TwoErrorControls => "write 0 first to the unused one",
            _ => return None,
        };
        Some(text.to_owned())
    }
}

impl AbortCode {
    /// The description in CiA 301.
    pub const fn text(self) -> &'static str {
        match self.0 {
            0x0601_0000 => "unsupported access to an object",
            0x0601_0002 => "attempt to write a read only object",
            0x0602_0000 => "object does not exist in the object dictionary",
            0x0604_0041 => "object cannot be mapped to the PDO",
            0x0604_0042 => "number and length of the objects to be mapped would exceed PDO length",
            0x0604_0043 => "general parameter incompatibility",
            0x0607_0010 => "data type does not match, length of service parameter does not match",
            0x0607_0012 => "length of service parameter too high",
            0x0607_0013 => "length of service parameter too low",
            0x0609_0011 => "sub-index does not exist",
            0x0609_0030 => "invalid value for parameter",
            0x0609_0031 => "value of parameter written too high",
            0x0609_0032 => "value of parameter written too low",
            0x0800_0020 => "data cannot be transferred or stored to the application",
            0x0800_0022 => "data cannot be transferred because of the present device state",
            _ => "abort",
        }
    }
}

// an abort code as in documents of CiA: `0609 0030h`
objdict_model::messages! {
    AbortCode: { Self(code) => "{:04X} {:04X}h", code >> 16, code & 0xFFFF; }
    Objection: { Self { offset, number, place, kind, .. } => "at byte {offset}, download {number}: {place}: {kind}"; }
    ObjectionKind: {
        Self::NoObject => "the dictionary has no such object";
        Self::NoSubIndex => "the object has no such sub-index";
        Self::NotWritable => "its access type does not allow a write";
        Self::RefusesDownload => "ObjFlags bit 0 forbids the download";
        Self::Length { data_type, expected, found } => "{} of data, but {data_type} has {expected}", bytes(*found);
        Self::NoValue(data_type) => "the bytes are not a valid {data_type}";
        Self::BelowLimit { value, limit } => "`{value}` is below the low limit `{limit}`";
        Self::AboveLimit { value, limit } => "`{value}` is above the high limit `{limit}`";
        Self::Undefined(what) => "{what}";
        Self::RestrictedCanId { can_id, owner } => "the CAN-ID `0x{can_id:X}` is reserved: {owner}";
        Self::InUse { present, .. } => "the identifier changes while `0x{present:X}` is in use";
        Self::RenamedWhileSwitchedOff { present } =>
            "the write that marks `0x{present:X}` not valid also changes its identifier, which some devices reject";
        Self::SharedWithSync { can_id } => "SYNC and a PDO would share CAN-ID `0x{can_id:X}`";
        Self::PdoIsValid(kind, number) | Self::MappingIsValid(kind, number) =>
            "{kind} {number} is valid, so this cannot change";
        Self::MappingInUse => "sub-index 0 of the mapping is not 0, so this cannot change";
        Self::NotMappable(mapped, kind) => "no {kind} can carry `{mapped}`";
        Self::MappedLength { mapped, bits } => "`{mapped}` is mapped, but it has {bits}";
        Self::PdoTooLong { bits } => "{bits} bits are mapped, but a PDO has 64";
        Self::NothingMapped { sub } => "sub-index {sub:X}h maps nothing";
        Self::NoMappingEntry { sub } => "the mapping has no sub-index {sub:X}h";
        Self::WatchedTwice { node_id, sub } => "sub-index {sub:X}h already monitors node {node_id}";
        Self::WatchesNobody { node_id: 0, time } =>
            "the entry has a time of {time} ms but no node-ID, so it is not in use";
        Self::WatchesNobody { node_id, time } =>
            "the entry has a time of {time} ms, but `{node_id}` is not a node-ID, so it is not in use";
        Self::PeriodRuns => "the counter overflow cannot change while the period (1006h) is not 0";
        Self::Signature { expected } => "only the signature `{expected}` is valid";
        Self::TwoErrorControls => "heartbeat and node guarding would both be active";
        Self::NotStored => "the write follows 1010h, so it is not stored";
        Self::ClearsVerification => "the write clears the verify configuration (1020h) written earlier";
    }
}

fn bytes(count: usize) -> String {
    if count == 1 { "1 byte".to_owned() } else { format!("{count} bytes") }
}
