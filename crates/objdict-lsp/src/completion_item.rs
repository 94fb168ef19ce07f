//! Items of a completion, and the entries that a PDO can carry as items.

use super::file::CheckedFile;
use super::protocol::{CompletionItem, CompletionItemKind, TextEdit};
use objdict_model::model::{DataType, Device, MappedObject, PdoKind};
use objdict_model::source::Span;

pub(super) fn item(
    file: &CheckedFile,
    span: Span,
    label: &str,
    new_text: String,
    kind: CompletionItemKind,
) -> CompletionItem {
    let edit = TextEdit { range: file.positions().range(span), new_text };
    CompletionItem { label: label.to_owned(), kind, text_edit: Some(edit), ..CompletionItem::default() }
}

/// The entries that a PDO of a direction can carry.
pub(super) fn mappable(device: &Device, kind: PdoKind) -> impl Iterator<Item = MappedObject> {
    device.objects.iter().flat_map(move |(&index, object)| {
        let fitting = object.entries().filter(move |(_, entry)| entry.is_mappable() && entry.fits_pdo(kind));
        fitting.filter_map(move |(sub, entry)| {
            let bits = entry.implied_type().and_then(DataType::bit_length)?;
            Some(MappedObject { index, sub, bits })
        })
    })
}
