//! The process image.

use crate::Note;
use crate::dictionary::{ResolvedEntry, TableDictionary};
use crate::model::{Part, Place};
use crate::names::NameScope;
use crate::resolve::ValueShape;
use crate::variables::claim;

/// The longest value in one SDO frame.
pub(super) const LONGEST: usize = 4;

/// Number of possible start offsets of a PDO in the stack.
const REACH: usize = 256;

/// The image and its entries.
pub(super) struct Image<'a> {
    /// By index and sub-index.
    pub(super) entries: Vec<ImageEntry<'a>>,
    /// Size in bytes.
    pub(super) size: usize,
}

/// An entry in the image.
pub(super) struct ImageEntry<'a> {
    pub(super) index: u16,
    pub(super) entry: &'a ResolvedEntry<'a>,
    /// The suffix of the offset macro.
    pub(super) name: String,
    pub(super) size: usize,
    /// `None` until it is placed.
    pub(super) offset: Option<usize>,
}

/// Whether the stack handles an entry itself: error register and heartbeat time.
pub(super) fn is_of_the_stack(index: u16, sub: u8) -> bool {
    matches!((index, sub), (0x1001 | 0x1017, 0))
}

/// Whether an entry belongs to the process image: it can change and is not a communication parameter.
fn belongs(index: u16, entry: &ResolvedEntry<'_>) -> bool {
    let resolved = &entry.resolved;
    let length = resolved.shape.size();
    let fixed = !matches!(resolved.shape, ValueShape::Bytes(..));
    index >= 0x2000 && !resolved.constant && fixed && (1..=LONGEST).contains(&length)
}

impl<'a> Image<'a> {
    /// Collects the entries of the image without placing them.
    pub(super) fn new(dictionary: &'a TableDictionary<'a>, prefix: &str, notes: &mut Vec<Note>) -> Self {
        let (mut entries, mut wanted) = (Vec::new(), Vec::new());
        for object in &dictionary.objects {
            for (number, entry) in object.entries.iter().enumerate() {
                let place = Place::entry(object.index, entry.sub);
                let resolved = &entry.resolved;
                if !belongs(object.index, entry) {
                    continue;
                }
                if resolved.limit().is_some() {
                    notes.push(Note::new(place.clone(), "the stack does not enforce limits"));
                }
                if resolved.default.is_formula() {
                    let text = "the node-ID is added once, when the image is initialised, as `OD_NODE_ID`";
                    let text = text.replace("OD", &prefix.to_ascii_uppercase());
                    notes.push(Note::new(place, text));
                }
                wanted.push((object, Some(number)));
                entries.push(ImageEntry {
                    index: object.index,
                    entry,
                    name: String::new(),
                    size: resolved.shape.size(),
                    offset: None,
                });
            }
        }
        for (entry, name) in entries.iter_mut().zip(claim(&mut NameScope::of_constants(""), prefix, &wanted))
        {
            entry.name = name.to_ascii_uppercase();
        }
        Self { entries, size: 0 }
    }

    /// The position of an entry; `None` if it is not in the image.
    pub(super) fn find(&self, index: u16, sub: u8) -> Option<usize> {
        self.entries.binary_search_by_key(&(index, sub), |entry| (entry.index, entry.entry.sub)).ok()
    }

    /// Places all remaining entries consecutively.
    pub(super) fn place_the_rest(&mut self) {
        for entry in &mut self.entries {
            if entry.offset.is_none() {
                entry.offset = Some(self.size);
                self.size += entry.size;
            }
        }
    }

    /// Notes an image that exceeds the limit of the stack.
    pub(super) fn check(&self, notes: &mut Vec<Note>) {
        if self.size > REACH {
            let text = format!(
                "the process image has {} bytes; offsets reach {REACH} in MicroCANopen and further in MicroCANopen Plus",
                self.size
            );
            notes.push(Note::new(Part::Device, text));
        }
    }
}
