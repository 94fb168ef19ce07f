//! The meaning of a frame: its service, its node, and the step of an SDO transfer.

use objdict_network::Service;

/// A frame as sent on the bus.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RawFrame<'f> {
    /// The CAN-ID.
    pub can_id: u32,
    /// Whether it has 29 bits.
    pub is_extended: bool,
    /// Whether it is a remote frame.
    pub is_remote: bool,
    /// The data.
    pub data: &'f [u8],
}

objdict_model::named! {
    /// The purpose of a frame.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum FrameKind {
        /// A command of the NMT master.
        Nmt = "nmt",
        /// SYNC.
        Sync = "sync",
        /// TIME.
        Time = "time",
        /// EMCY.
        Emcy = "emcy",
        /// A PDO, or a request for one.
        Pdo = "pdo",
        /// An SDO.
        Sdo = "sdo",
        /// A heartbeat.
        Heartbeat = "heartbeat",
        /// The boot-up message.
        BootUp = "boot-up",
        /// Node guarding.
        Guarding = "guarding",
        /// LSS (CiA 305).
        Lss = "lss",
        /// An unknown service.
        Unknown = "unknown",
    }
}

/// A decoded frame, without its text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct DecodedFrame {
    /// Its purpose.
    pub kind: FrameKind,
    /// The service; `None` for a CAN-ID that no node uses.
    pub service: Option<Service>,
    /// The node that sends it or, of NMT commands, SDO requests and RPDOs, that it is for.
    pub node_id: Option<u8>,
    /// The step of an SDO transfer.
    pub sdo: Option<SdoFrame>,
    /// The position of the user of the CAN-ID.
    pub(super) user: usize,
}

impl DecodedFrame {
    /// A frame of no service, as one of CAN FD.
    pub const UNKNOWN: Self = Self::new(FrameKind::Unknown, None, None);

    pub(super) const fn new(kind: FrameKind, service: Option<Service>, node_id: Option<u8>) -> Self {
        Self { kind, service, node_id, sdo: None, user: 0 }
    }

    /// Whether no known node uses the CAN-ID, so that the service comes from the predefined connection set.
    pub const fn is_predefined(&self) -> bool {
        self.user == usize::MAX
    }
}

/// A frame of an SDO transfer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct SdoFrame {
    /// Index and sub-index; `None` if the log begins in the middle of the transfer.
    pub entry: Option<(u16, u8)>,
    /// The step of the transfer.
    pub step: TransferStep,
    /// The SDO channel of the node, 1 for the default one.
    pub channel: u16,
    /// Whether the client sends it.
    pub is_request: bool,
}

/// A step of an SDO transfer (CiA 301 §7.2.4.3).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum TransferStep {
    /// The client requests a value.
    Read,
    /// The client sends a value in one frame.
    Write,
    /// The client will send a value of this size, if stated.
    WriteStart(Option<u32>),
    /// The server expects the value.
    Expected,
    /// The server has accepted the value.
    Written,
    /// The server sends the value in one frame.
    Value,
    /// The server will send a value of this size, if stated.
    ValueStart(Option<u32>),
    /// The client requests the next segment.
    NextSegment,
    /// This many bytes of the value.
    Segment(u8),
    /// The last bytes of the value.
    LastSegment,
    /// The server has accepted a segment.
    Accepted,
    /// A segment of a transfer whose start is not in the log.
    Stray,
    /// The client or the server aborts, with an abort code.
    Abort(u32),
    /// The client requests a value in blocks.
    BlockRead,
    /// The client starts the upload of blocks.
    BlockStart,
    /// A segment of a block, with its number, and whether it is the last one of the value.
    BlockSegment(u8, bool),
    /// A block was received up to the segment of this number.
    BlockAccepted(u8),
    /// The last block was sent, so the value is complete.
    BlockEnd,
    /// The transfer of blocks is over.
    BlockDone,
    /// The frame does not have 8 bytes.
    Malformed,
    /// A command that CiA 301 does not define.
    Unknown(u8),
}

impl TransferStep {
    /// Whether the value is complete with this frame.
    pub const fn has_value(self) -> bool {
        matches!(self, Self::Write | Self::Value | Self::LastSegment | Self::BlockEnd)
    }
}
