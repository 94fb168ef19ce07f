//! The causes for which a stack does not serve a PDO.

/// Why a PDO is not served.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum PdoCause {
    /// Above the 255 that a byte counts. It counts for PDOs that are not valid too.
    Number,
    NoTransmissionType,
    NoCobId,
    RtrAllowed,
    Extended,
    NoCanId,
    /// The CAN-ID is 0, and there is something to send.
    OnNmt,
    /// Outside the CAN-IDs that the stack takes for PDOs.
    NotDispatched,
    /// An RPDO before it has the CAN-ID, valid or not.
    Taken,
    NoMapping,
    TooMany,
    /// So many, and so short, that the stack does not notice.
    Overrun,
    NoSlot,
    TooLong,
    Dummy,
    Missing,
    Bits,
    Direction,
    NotMappable,
    Short,
    /// Numbers of another length.
    Size,
    /// A length that the functions of the dictionary refuse: each other one when they write, a longer one when they read.
    Length,
    /// In flash, and the stack does not look at the access type when it writes.
    Constant,
    Empty,
    Reserved,
    /// Neither events nor SYNCs nor RTRs transmit it.
    NoTrigger,
    SyncStart,
}
