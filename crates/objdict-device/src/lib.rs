//! The core of a CANopen device for firmware: no standard library, no allocation, no `unsafe`, no dependency.
//!
//! `objdict generate --target rust` writes the dictionary of a device as a table. [`table`] is the code that
//! serves such a table; it is the same for every device. [`Node`] and the other modules serve any [`Dictionary`]: SDO servers, PDOs
//! whose mapping changes at run time, SYNC, NMT, heartbeats, emergency messages and stored values; beside it, there are an LSS slave and
//! an SDO client. Each takes frames and the time, and returns frames: driver, clock and main loop belong to the application.
//!
//! ```
//! use objdict_device::table::{Data, Entry, READ, Table, UNSIGNED16, UNSIGNED32, WRITE};
//! use objdict_device::{Frame, Node, Pdos, Received};
//!
//! // as the generator writes it: the device type is in flash, the heartbeat time behind the node-ID in RAM
//! #[derive(Clone, Copy, Debug, PartialEq)]
//! struct Od;
//!
//! impl Table for Od {
//!     const ENTRIES: &'static [Entry<Self>] = &[
//!         Entry::new(0x1000, 0, UNSIGNED32, READ, 0, 0),
//!         Entry::new(0x1017, 0, UNSIGNED16, READ | WRITE, 1, 4),
//!     ];
//!     const ROM: &'static [u8] = &[0x91, 0x01, 0x02, 0x00, 100, 0];
//! }
//!
//! // node 5 with one SDO server for values of at most 64 bytes, no PDO and no node to monitor
//! let mut node = Node::<_, 64, 1, 0, 0, 0>::new(5, Data::<Od, 3>::new(5), Pdos::new([], []));
//! assert_eq!(Some(node.boot(0)), Frame::new(0x705, &[0]));
//!
//! // a master reads the device type
//! let request = Frame::new(0x605, &[0x40, 0x00, 0x10, 0x00, 0, 0, 0, 0]).unwrap();
//! let answer = Frame::new(0x585, &[0x43, 0x00, 0x10, 0x00, 0x91, 0x01, 0x02, 0x00]).unwrap();
//! assert_eq!(node.receive(&request, 1_000), Received::Answer(answer));
//!
//! // the heartbeat is due after 100 ms
//! assert_eq!(node.poll(99_999), None);
//! assert_eq!(node.poll(100_000), Frame::new(0x705, &[0x7F]));
//! ```
//!
//! This is a core to attach to a driver, not a complete stack: there is no TIME, no node guarding, no remote frame and no
//! 29-bit identifier.

#![no_std]
#![allow(clippy::cast_possible_truncation, reason = "values are cut to the width of their field in a frame")]

mod clock;
mod dictionary;
mod errors;
#[cfg(feature = "embedded-storage")]
mod flash;
mod frame;
mod guard;
mod heartbeat;
mod lss;
mod nmt;
mod node;
mod pdo;
#[cfg(feature = "embedded-storage")]
mod program;
mod rules;
mod sdo;
#[cfg(feature = "critical-section")]
mod shared;
#[cfg(feature = "source")]
pub mod source;
mod storage;
mod sync;
pub mod table;
mod watched;

pub use dictionary::{Attributes, Dictionary, Place, Scope};
pub use errors::{Errors, error_code};
#[cfg(feature = "embedded-storage")]
pub use flash::{FlashStorage, Region};
pub use frame::Frame;
pub use guard::Guarded;
pub use heartbeat::{Heartbeat, HeartbeatConsumer};
pub use lss::{LssReceived, LssSlave, LssStoreError};
pub use nmt::{Nmt, NmtCommand, NmtState};
pub use node::{Node, Received};
pub use pdo::{Pdo, Pdos, Reception};
#[cfg(feature = "embedded-storage")]
pub use program::{ProgramRequest, ProgramState, WithProgram};
pub use sdo::{SdoClient, SdoData, SdoServer, SdoStep};
#[cfg(feature = "critical-section")]
pub use shared::Shared;
pub use storage::{Grouped, Storage, Stored};
pub use sync::SyncProducer;
pub use table::Abort;
pub use watched::Watched;
