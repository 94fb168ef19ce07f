//! Places to spans. Nothing is stored per datum: the place names its section and key, and the text is searched for
//! them when a finding is shown. A clean file pays nothing.

use std::hash::{BuildHasher, RandomState};

use super::section::SectionName;
use crate::format::ini::{Document, LineKind, Lines};
use crate::model::{Field, Part, Place};
use crate::source::Span;

/// The headers of a document, sorted by what they stand for.
#[derive(Debug)]
pub(crate) struct Locator {
    state: RandomState,
    /// Hash of the part, and where its header line starts.
    headers: Vec<(u32, u32)>,
}

impl Locator {
    pub(crate) fn new(document: &Document) -> Self {
        let state = RandomState::new();
        let mut headers = Vec::new();
        for line in document.lines() {
            if let LineKind::Section { name } = line.kind {
                let part = SectionName::parse(name.of(document.text())).part;
                headers.push((hash(&state, &part), line.span.start));
            }
        }
        headers.sort_unstable();
        Self { state, headers }
    }

    /// The span of a place: the value of its key where that is not empty, else the key; the name of its section where
    /// the key is missing. `None` for the device as a whole and for sections that are not there.
    pub(crate) fn locate(&self, document: &Document, place: &Place) -> Option<Span> {
        let text = document.text();
        let hash = hash(&self.state, &place.part);
        let from = self.headers.partition_point(|(other, _)| *other < hash);
        let mut header = None;
        for &(other, start) in &self.headers[from..] {
            if other != hash {
                break;
            }
            let mut lines = Lines::from(text, start);
            let Some(LineKind::Section { name }) = lines.next().map(|line| line.kind) else { continue };
            if SectionName::parse(name.of(text)).part != place.part {
                continue;
            }
            header.get_or_insert(name);
            let Some(field) = &place.field else { break };
            if let Some(span) = find_key(text, lines, field) {
                return Some(span);
            }
        }
        header.or_else(|| self.stand_in(document, &place.part))
    }

    /// An entry without a section of its own stands in its object's.
    fn stand_in(&self, document: &Document, part: &Part) -> Option<Span> {
        match *part {
            Part::Entry(index, _) => self.locate(document, &Place::object(index)),
            _ => None,
        }
    }
}

fn hash(state: &RandomState, part: &Part) -> u32 {
    state.hash_one(part) as u32
}

/// The value of a key, or the key where it has none, in the section whose entries come next.
fn find_key(text: &str, lines: Lines<'_>, field: &Field) -> Option<Span> {
    let name = field.name();
    for line in lines {
        match line.kind {
            LineKind::Section { .. } => return None,
            LineKind::Entry { key, value } if key.of(text).eq_ignore_ascii_case(&name) => {
                return Some(if value.is_empty() { key } else { value });
            }
            _ => {}
        }
    }
    None
}
