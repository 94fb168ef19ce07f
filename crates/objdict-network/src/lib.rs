//! CANopen networks: nodes with their descriptions, the manager that boots them, and who says what to whom. Part of
//! [objdict](https://docs.rs/objdict); depend on that crate instead.
//!
//! A [`Network`] is what somebody wants; [`compile`] makes it what each node is told ([`Compiled`]), with findings about what
//! does not fit. All outputs and checks are made of these two.

mod connect;
mod link;
mod network;
mod rules;

pub use connect::connect;
pub use link::{Link, LinkEnd, LinkParameters, LinkedEntries, NoLinkEnd};
pub use network::*;
pub use rules::RULES;

use objdict_model::{diagnostic, model, source};
use objdict_node::configure;
