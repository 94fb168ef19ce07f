#![doc = include_str!("../README.md")]
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
mod objects;
mod pdo;
#[cfg(feature = "embedded-storage")]
mod program;
mod rules;
mod sdo;
mod services;
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
pub use objects::ObjectSet;
pub use pdo::{Pdo, Pdos, Reception};
#[cfg(feature = "embedded-storage")]
pub use program::{ProgramRequest, ProgramState, WithProgram};
pub use rules::{Refusal, check_write};
pub use sdo::crc::crc;
pub use sdo::{SdoClient, SdoData, SdoServer, SdoStep};
#[cfg(feature = "critical-section")]
pub use shared::Shared;
pub use storage::{Grouped, LossReason, Storage, StorageLoss, Stored};
pub use sync::SyncProducer;
pub use table::Abort;
pub use watched::{Watchable, Watched};
