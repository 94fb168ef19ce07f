//! Views of the MicroCANopen templates.

use super::image::{Image, ImageEntry};
use super::pdos::InitCall;
use super::replies::Reply;
use crate::dictionary::TableDictionary;
use crate::head::Head;
use crate::model::PdoKind;
use crate::resolve::Encoded;

/// What the files have.
pub(super) struct MicroCanOpenView<'a> {
    pub(super) head: Head,
    pub(super) dictionary: &'a TableDictionary<'a>,
    pub(super) image: Image<'a>,
    pub(super) calls: Vec<InitCall>,
    pub(super) replies: Vec<Reply>,
}

include!("../../expanded/microcanopen/mco.c.rs");
include!("../../expanded/microcanopen/pimg.h.rs");

impl MicroCanOpenView<'_> {
    /// In milliseconds.
    fn heartbeat(&self) -> u16 {
        let time = self.dictionary.device.entry(0x1017, 0).and_then(|entry| entry.value()?.as_integer());
        time.and_then(|time| u16::try_from(time).ok()).unwrap_or(0)
    }

    /// The macro of the node-ID.
    fn node_id(&self) -> String {
        format!("{}_NODE_ID", self.head.upper)
    }

    /// Bytes of the image with a non-zero initial value: offset and value.
    fn defaults(&self) -> Vec<(String, String)> {
        self.image.entries.iter().flat_map(|entry| entry.default_bytes(&self.node_id())).collect()
    }

    /// The entries by their offsets.
    fn placed(&self) -> Vec<&ImageEntry<'_>> {
        let mut entries: Vec<&ImageEntry<'_>> = self.image.entries.iter().collect();
        entries.sort_by_key(|entry| entry.offset);
        entries
    }
}

impl ImageEntry<'_> {
    fn place(&self) -> usize {
        self.offset.unwrap_or(0) // all are placed before they are shown
    }

    fn flags(&self) -> String {
        let (read, write) = self.entry.resolved.sdo();
        format!("{}{}{}", self.size, if read { " | ODRD" } else { "" }, if write { " | ODWR" } else { "" })
    }

    /// The bytes with a non-zero initial value.
    fn default_bytes(&self, node_id: &str) -> Vec<(String, String)> {
        let offset = |at: usize| match at {
            0 => format!("P_{}_OFF", self.name),
            _ => format!("P_{}_OFF + {at}", self.name),
        };
        match &self.entry.resolved.default {
            Encoded::Formula(base) => (0..self.size)
                .map(|at| (offset(at), format!("((0x{base:X}L + {node_id}) >> {}) & 0xFF", 8 * at)))
                .collect(),
            value => {
                let bytes = value.bytes_on(None, self.size).into_iter().enumerate();
                let bytes = bytes.filter(|(_, byte)| *byte != 0);
                bytes.map(|(at, byte)| (offset(at), format!("0x{byte:02X}"))).collect()
            }
        }
    }
}
