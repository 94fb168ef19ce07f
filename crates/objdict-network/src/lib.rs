//! CANopen networks: nodes with their descriptions, the manager that boots them, and the communication between
//! them. Part of `objdict`; depend on that crate instead.
//!
//! A [`Network`] is the requested state; [`resolve`] creates PDOs from its links, and [`compile`] the
//! downloads of each node.

mod check;
mod compile;
mod compiled;
mod connect;
mod effective;
mod files;
pub mod graph;
mod identity;
mod identity_level;
mod lely;
mod link;
mod lock;
mod manager;
mod messages;
mod names;
mod network;
mod origin;
mod overview;
mod resolve;
mod rules;
mod timing;
mod traffic;
mod unlinked;
mod watch;

pub use check::check;
pub use compile::compile;
pub use compiled::{Compiled, DcfgenMode, PdoState, Slave};
pub use effective::switched_on;
pub use identity::answered;
pub use identity_level::IdentityLevel;
pub use lely::{LelyMaster, LelyOptions, configuration_file, lely_master, mirrored_numbers};
pub use link::{Link, LinkEnd, LinkParameters, LinkedEntries, NoLinkEnd};
pub use lock::{LockedPdo, NetworkLock};
pub use messages::{Message, MessageId, Messages, Party, Service};
pub use names::named_manager;
pub use network::*;
pub use overview::{
    BootPlan, BootStep, CarriedEntry, DownloadRow, End, LinkRow, MappedEntry, MessageRow, NodeRow, Overview,
    UnlinkedEnd, UnlinkedRow,
};
pub use resolve::{Resolved, resolve};
pub use rules::rules;
pub use timing::{
    BootTimes, DeadlineKind, Load, LoadShare, NodeBootTime, RateRow, Remedy, SyncTime, TimedMessage, Timing,
    TimingOptions, TrafficKind, timeline,
};
pub use traffic::Uncounted;

use objdict_model::{Language, diagnostic, literal, model, source};
use objdict_node::{configure, download};
