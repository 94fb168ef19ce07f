//! The core of a CANopen device for firmware: no standard library, no allocation, no `unsafe`, no dependency.
//!
//! `objdict generate --target rust` writes the dictionary of a device as a table. [`table`] is the code that
//! serves such a table; it is the same for every device. The other modules serve any [`Dictionary`]: SDO servers, PDOs
//! whose mapping changes at run time, NMT state and heartbeat. Each takes frames and the time, and returns frames: driver, clock and
//! main loop belong to the application.
//!
//! This is a core to attach to a driver, not a complete stack: there is no SDO client, no SYNC or TIME producer, no LSS, no
//! node guarding, no remote frame and no 29-bit identifier.

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
