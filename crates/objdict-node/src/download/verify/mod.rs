//! Checks whether a node accepts a configuration. The downloads are applied to the dictionary one by one, as
//! a device does (CiA 301 §7.5.2, CiA 302-3).
//!
//! `objdict-device` decides which writes are rejected; this module explains the reason. Products, simulated nodes
//! and checks therefore share one table of rules.

mod node;
mod objection;
mod services;

use self::node::{AcceptingNode, node_place};
pub use self::objection::{AbortCode, Objection, ObjectionKind};
use super::{ConciseDcf, Download};
use crate::model::{Device, Place};

/// The result of checking a configuration.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Verification {
    /// Downloads that a node rejects or that are probably mistakes, in order of transmission.
    pub objections: Vec<Objection>,
    /// Entries whose default needs the missing node-ID. Checks that depend on their present value were
    /// skipped.
    pub unknown: Vec<Place>,
}

impl Verification {
    /// The downloads that a node rejects.
    pub fn refusals(&self) -> impl Iterator<Item = &Objection> {
        self.objections.iter().filter(|objection| objection.kind.is_refusal())
    }

    /// The downloads that a node aborts: rejected ones, except those that only tools must not write.
    pub fn aborts(&self) -> impl Iterator<Item = &Objection> {
        self.refusals().filter(|objection| objection.kind.abort().is_some())
    }

    /// Whether a node accepts every download.
    pub fn is_accepted(&self) -> bool {
        self.refusals().next().is_none()
    }
}

impl ConciseDcf {
    /// Applies the downloads to the dictionary of `device`, starting from the defaults for `node_id` or else
    /// for the commissioned node-ID.
    ///
    /// Access, sizes and limits are taken from the description. A rejected write changes nothing, so if a
    /// stream does not mark a PDO as not valid first, every write that fails for this reason is reported. Each
    /// download is checked by the rules of nodes ([`objdict_device::check_write`]); where devices differ,
    /// [`ObjectionKind::is_refusal`] is false.
    pub fn verify(&self, device: &Device, node_id: Option<u8>) -> Verification {
        let device = &*device.with_implicit_pdos();
        let mut node = AcceptingNode::new(device, node_id.or_else(|| device.node_id()));
        let mut objections = Vec::new();
        for (position, (offset, download)) in self.with_offsets().enumerate() {
            let mut object = |kind| {
                let Download { index, sub, .. } = *download;
                let place = node_place(device, index, sub);
                objections.push(Objection { number: position + 1, offset, index, sub, place, kind });
            };
            match node.take(download) {
                Ok(None) => {}
                Ok(Some(doubt)) => object(doubt),
                Err(refusal) => object(refusal),
            }
        }
        Verification { objections, unknown: node.into_unknown() }
    }
}
