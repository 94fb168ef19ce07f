//! Views of the MicroCANopen templates, with the SDO replies for values that are constant or that the stack cannot change.

use super::image::{Image, ImageEntry, LONGEST, is_of_the_stack};
use super::pdos::InitCall;
use crate::Note;
use crate::dictionary::{ResolvedEntry, TableDictionary};
use crate::head::Head;
use crate::model::{PdoKind, Place};
use crate::resolve::{Encoded, ValueShape};

/// The content of the files.
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

/// A row of the table.
pub(super) struct Reply {
    pub(super) index: u16,
    pub(super) row: String,
    pub(super) described: String,
}

/// The rows by index and sub-index.
pub(super) fn replies(dictionary: &TableDictionary<'_>, prefix: &str, notes: &mut Vec<Note>) -> Vec<Reply> {
    let mut replies = Vec::new();
    for (object, entry) in dictionary.entries() {
        if let Some(row) = reply(object.index, entry, prefix, notes) {
            replies.push(Reply { index: object.index, row, described: entry.entry.name.to_string() });
        }
    }
    replies
}

/// The row of an entry; `None` if there is none, with a note if one is needed.
fn reply(index: u16, entry: &ResolvedEntry<'_>, prefix: &str, notes: &mut Vec<Note>) -> Option<String> {
    let resolved = &entry.resolved;
    let sub = entry.sub;
    let mut say = |text: &str| notes.push(Note::new(Place::entry(index, sub), text));
    if is_of_the_stack(index, sub) {
        say("the stack serves the entry itself");
        return None;
    }
    let length = match &resolved.default {
        Encoded::Bytes(bytes) if matches!(resolved.shape, ValueShape::Bytes(..)) => bytes.len(),
        _ => resolved.shape.size(),
    };
    if !(1..=LONGEST).contains(&length) {
        let text = format!(
            "the value has {length} bytes, but the stack supports 1 to {LONGEST}; the entry is omitted"
        );
        say(&text);
        return None;
    }
    let fixed = !matches!(resolved.shape, ValueShape::Bytes(..));
    if index >= 0x2000 && fixed && !resolved.constant {
        return None; // in the process image
    }
    if !resolved.access.is_readable() {
        say("entries outside of the process image cannot be written; the entry is omitted");
        return None;
    }
    if resolved.access.is_writable() {
        say("entries outside of the process image cannot be written; an SDO reads the default");
    }
    let address = format!("0x{index:04X}, 0x{sub:02X}, {length}");
    Some(match &resolved.default {
        Encoded::Formula(offset) => {
            let node_id = format!("{}_NODE_ID", prefix.to_ascii_uppercase());
            say(&format!("the node-ID of the reply is the constant `{node_id}`"));
            format!("SDOREPLY({address}, (0x{offset:X}L + {node_id}))")
        }
        Encoded::Word(word) => {
            let bits = 64 - 8 * u32::try_from(length).unwrap_or(8);
            format!("SDOREPLY({address}, 0x{:X}L)", word & (u64::MAX >> bits))
        }
        Encoded::Bytes(bytes) => {
            let byte = |at: usize| bytes.get(at).copied().unwrap_or(0);
            let bytes: Vec<String> = (0..LONGEST).map(|at| format!("0x{:02X}", byte(at))).collect();
            format!("SDOREPLY4({address}, {})", bytes.join(", "))
        }
    })
}
