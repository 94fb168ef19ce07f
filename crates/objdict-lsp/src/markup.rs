//! What can be written in XDD and XDC: the words that CiA 311 has for an attribute.

use super::completion_item::item;
use super::file::CheckedFile;
use super::protocol::{CompletionItem, CompletionItemKind};
use objdict_model::model::DataType;
use objdict_xdd::xdd::words_of;
use objdict_xdd::xml::Tree;

/// The items in the value of an attribute.
pub(super) fn completion(file: &CheckedFile, tree: &Tree, offset: u32) -> Vec<CompletionItem> {
    let Some(element) = tree.element_at(offset) else { return Vec::new() };
    let is_here = |span: objdict_model::source::Span| span.start <= offset && offset <= span.end;
    let Some(attribute) = element.attributes().find(|attribute| is_here(attribute.value_span())) else {
        return Vec::new();
    };
    let span = attribute.value_span();
    let of = |label: &str, text: String| item(file, span, label, text, CompletionItemKind::VALUE);
    if attribute.name() == "dataType" {
        let known = DataType::STATIC.iter().map(|data_type| {
            let text = format!("{:04X}", data_type.0);
            of(&format!("{text} {}", data_type.name().unwrap_or_default()), text)
        });
        return known.collect();
    }
    words_of(element, attribute.name()).iter().map(|word| of(word, (*word).to_owned())).collect()
}
