//! Adds objects to the text of an XDD or XDC, by edits that keep the rest of it.

use super::layout::{Layout, with_subs};
use super::write::write;
use super::{XddVersion, fact};
use crate::diagnostic::Findings;
use crate::model::Device;
use crate::source::{EditError, SourceFile};
use crate::xml::{Element, Tree, XmlEditor, n};

/// The bytes of `tree`, whose root is the container, with those objects of `device` that it lacks. `None` for a text without
/// a list of objects.
pub fn with_objects(tree: &Tree, device: &Device) -> Option<Result<Vec<u8>, EditError>> {
    let (list, objects) = object_list(tree)?;
    let complete = parsed(write(device, XddVersion::default()));
    let complete = parsed(without_references(&complete)?.ok()?);
    let (new_list, new) = object_list(&complete)?;
    let prefix = objects.first().map_or(list, |(_, object)| *object).prefix();
    let mut editor = XmlEditor::new(tree);
    let counts =
        new_list.attributes().filter(|count| list.attributes().any(|old| old.name() == count.name()));
    for count in counts {
        editor.set_attribute(list, count.name(), &count.value());
    }
    for (index, element) in new {
        if objects.iter().any(|(present, _)| *present == index) {
            continue;
        }
        let behind =
            objects.iter().filter(|(present, _)| *present < index).max_by_key(|(present, _)| *present);
        let xml = with_prefix(&outdented(element.span().of(complete.text())), prefix);
        editor.insert_child(list, behind.map(|(_, element)| *element), &xml);
    }
    Some(editor.to_bytes())
}

fn parsed(text: String) -> Tree {
    Tree::new(SourceFile::from_text("", text), &mut Findings::new())
}

/// The list of objects, and its objects with valid indexes.
fn object_list(tree: &Tree) -> Option<(Element<'_>, Vec<(u32, Element<'_>)>)> {
    let layout = Layout::of_document(tree)?;
    let index = |object: Element<'_>| fact::hex(object.attribute(n::index)?.value().trim(), 4);
    let objects: Vec<_> = layout.objects().filter_map(|object| Some((index(object)?, object))).collect();
    let list = layout.objects().next()?.parent()?;
    Some((list, objects))
}

/// The text without the references of objects to parameters, which are in another profile of the file.
fn without_references(tree: &Tree) -> Option<Result<String, EditError>> {
    let mut editor = XmlEditor::new(tree);
    for element in Layout::of_document(tree)?.objects().flat_map(with_subs) {
        editor.remove_attribute(element, n::uniqueIDRef.text());
    }
    Some(editor.text())
}

/// An element without the indentation of its last line.
fn outdented(xml: &str) -> String {
    let last = xml.lines().last().unwrap_or_default();
    let indent = &last[..last.len() - last.trim_start().len()];
    let lines = xml.lines().map(|line| line.strip_prefix(indent).unwrap_or(line));
    lines.collect::<Vec<_>>().join("\n")
}

/// The elements with a prefix; no value contains a `<`.
fn with_prefix(xml: &str, prefix: &str) -> String {
    if prefix.is_empty() {
        return xml.to_owned();
    }
    xml.replace("<CANopen", &format!("<{prefix}:CANopen"))
        .replace("</CANopen", &format!("</{prefix}:CANopen"))
}
