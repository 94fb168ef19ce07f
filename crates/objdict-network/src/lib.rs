//! CANopen networks: nodes with their descriptions, the manager that boots them, and who says what to whom. Part of
//! [objdict](https://docs.rs/objdict); depend on that crate instead.
//!
//! A [`Network`] is what somebody wants; [`connect`] makes PDOs of its links, and [`slaves`] is what each node is told.

mod configured;
mod connect;
mod lely;
mod link;
mod network;
mod rules;
mod stream;

pub use connect::connect;
pub use lely::{LelyMaster, LelyOptions, configuration_file, lely_master};
pub use link::{Link, LinkEnd, LinkParameters, LinkedEntries, NoLinkEnd};
pub use network::*;
pub use rules::rules;
pub use stream::{Manner, PdoState, Slave, slaves};

use objdict_model::{diagnostic, literal, model, source};
use objdict_node::{configure, download};

/// What is wrong with a network.
pub fn check(network: &Network, findings: &mut diagnostic::Findings) {
    slaves(network, Manner::Repaired, findings);
}
