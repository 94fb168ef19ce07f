//! The fields of a device that people name in files: a row for each, with its name in every vocabulary. Paths of JSON, keys of
//! `device.toml` and the words of patches are looked up here; names of CiA 311 are in its schema.

use super::field::OTHER;
pub use super::field::{COMMISSIONING, DEVICE, ENTRY, FILE, FieldRow};
use super::{Field, Part};

/// The rows of a part of facts about the description; `None` for another part.
pub fn facts_of(part: &Part) -> Option<&'static [FieldRow]> {
    match part {
        Part::FileInfo => Some(FILE),
        Part::DeviceInfo => Some(DEVICE),
        Part::Commissioning => Some(COMMISSIONING),
        _ => None,
    }
}

/// The rows of a part: of facts, else those of an entry.
fn rows_of(part: &Part) -> impl Iterator<Item = &'static FieldRow> {
    let (rows, more) = facts_of(part).map_or((ENTRY, OTHER), |facts| (facts, &[]));
    rows.iter().chain(more)
}

/// The field of a part at a path of JSON. Of a value the path goes on to its kind, which says nothing more.
pub fn at_json(part: &Part, path: &str) -> Option<Field> {
    let is_it = |row: &&FieldRow| {
        path.strip_prefix(row.json).is_some_and(|rest| rest.is_empty() || rest.starts_with('/'))
    };
    rows_of(part).find(is_it).map(FieldRow::field)
}

/// The key of a field of a part.
pub fn key_of(part: &Part, field: &Field) -> Option<&'static str> {
    rows_of(part).find(|row| row.eds == field.name()).map(|row| row.key).filter(|key| !key.is_empty())
}
