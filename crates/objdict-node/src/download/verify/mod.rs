//! Whether a node accepts a configuration: the downloads are played against the dictionary, one after the other, as a
//! device takes them (CiA 301 §7.5.2, CiA 302-3).

mod node;
mod objection;
mod pdo;
mod services;

use self::node::Node;
pub use self::objection::{AbortCode, Objection, ObjectionKind};
use super::{ConciseDcf, Download};
use crate::model::{Device, Place};

/// What came of playing a configuration against a dictionary.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Verification {
    /// What a node refuses, and what it takes although it is hardly meant, in the order of the downloads.
    pub objections: Vec<Objection>,
    /// Entries with a default that depends on the node-ID, where nobody said which node it is: what depends on their
    /// present value was not looked at.
    pub unknown: Vec<Place>,
}

impl Verification {
    /// What a node refuses.
    pub fn refusals(&self) -> impl Iterator<Item = &Objection> {
        self.objections.iter().filter(|objection| objection.kind.is_refusal())
    }

    /// Whether a node takes every download.
    pub fn is_accepted(&self) -> bool {
        self.refusals().next().is_none()
    }
}

impl ConciseDcf {
    /// Plays the downloads against the dictionary of `device`, which has its defaults: those of the node `node_id`, else
    /// of the node that the description is for.
    ///
    /// Access, sizes and limits are those of the description. A write that is refused changes nothing, so a stream that
    /// forgets to switch a PDO off is told of every write that fails for it. Each download is judged by the strictest
    /// reading of CiA 301; where devices differ, [`ObjectionKind::is_refusal`] is false.
    pub fn verify(&self, device: &Device, node_id: Option<u8>) -> Verification {
        let mut node = Node::new(device, node_id.or_else(|| device.node_id()));
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

/// The place of an entry, as reports name it: the value of a VAR has no sub-index.
fn node_place(device: &Device, index: u16, sub: u8) -> Place {
    match device.object(index) {
        Some(object) if sub == 0 && !object.object_type().has_subs() => Place::object(index),
        _ => Place::entry(index, sub),
    }
}
