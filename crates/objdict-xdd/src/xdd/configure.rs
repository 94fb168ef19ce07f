//! Conversion between XDD and XDC, and insertion of objects, by edits of the text, so that comments, order, spelling,
//! line ends and encoding are kept.

use super::layout::{Layout, with_subs};
use super::schema::network::DEVICE_COMMISSIONING;
use super::shape::facts;
use super::write::write;
use super::{XddVersion, defaults, fact};
use crate::diagnostic::Findings;
use crate::model::{Commissioning, Device};
use crate::source::{EditError, SourceFile};
use crate::xml::{Element, Name, Tree, XmlEditor, escaped_value, n};

/// Converts `tree` to an XDC named `file_name` for the node `node`, whose values replace those of the text.
/// `None` if the file cannot contain them: without a communication network profile, or in a project with
/// several devices.
pub fn to_xdc(tree: &Tree, file_name: &str, node: &Commissioning) -> Option<Result<Vec<u8>, EditError>> {
    let layout = Layout::of_document(tree)?;
    let body = layout.network?.body;
    let mut editor = XmlEditor::new(tree);
    rename(&layout, file_name, &mut editor);
    let management = body.child(n::NetworkManagement);
    match management.and_then(|management| management.child(n::deviceCommissioning)) {
        Some(element) => {
            for (name, value) in facts::texts(node, &DEVICE_COMMISSIONING, true) {
                // CANopenEditor writes `NodeID`
                let is_other = name == n::nodeID && element.attribute(n::NodeID).is_some();
                let name = if is_other { n::NodeID } else { name };
                editor.set_attribute(element, name.text(), &value);
            }
        }
        None => insert(body, management, node, &mut editor),
    }
    Some(editor.to_bytes())
}

/// Converts `tree` to an XDD named `file_name`, without the node and its configured values. `None` for
/// a project with several devices.
pub fn to_xdd(tree: &Tree, file_name: &str) -> Option<Result<Vec<u8>, EditError>> {
    let layout = Layout::of_document(tree)?;
    let mut editor = XmlEditor::new(tree);
    rename(&layout, file_name, &mut editor);
    let management = layout.network.and_then(|network| network.body.child(n::NetworkManagement));
    for node in management.iter().flat_map(|management| management.children_named(n::deviceCommissioning)) {
        editor.remove_element(node);
    }
    for element in layout.objects().flat_map(with_subs) {
        editor.remove_attribute(element, n::actualValue.text());
        editor.remove_attribute(element, n::denotation.text());
    }
    for parameter in parameters(&layout) {
        let configured = |child: &Element<'_>| matches!(child.tag(), n::actualValue | n::denotation);
        parameter.children().filter(configured).for_each(|child| editor.remove_element(child));
    }
    Some(editor.to_bytes())
}

fn rename<'a>(layout: &Layout<'a>, file_name: &str, editor: &mut XmlEditor<'a>) {
    for profile in [layout.device, layout.network].into_iter().flatten() {
        editor.set_attribute(profile.body, n::fileName.text(), file_name);
    }
}

/// The parameters and their templates.
fn parameters<'a>(layout: &Layout<'a>) -> impl Iterator<Item = Element<'a>> {
    let processes =
        layout.device.into_iter().flat_map(|device| device.body.children_named(n::ApplicationProcess));
    processes.flat_map(|process| {
        let of = |list: Name, name: Name| {
            process.child(list).into_iter().flat_map(move |list| list.children_named(name))
        };
        of(n::parameterList, n::parameter).chain(of(n::templateList, n::parameterTemplate))
    })
}

/// Inserts the node into `NetworkManagement` after the features, or a `NetworkManagement` with the node at
/// the end of the body. The new elements get the prefix of their siblings and thus the same namespace.
fn insert<'a>(
    body: Element<'a>,
    management: Option<Element<'a>>,
    node: &Commissioning,
    editor: &mut XmlEditor<'a>,
) {
    let settings = facts::texts(node, &DEVICE_COMMISSIONING, true).into_iter();
    let settings: String =
        settings.map(|(name, value)| format!(" {}=\"{}\"", name.text(), escaped_value(&value))).collect();
    let last = |element: Element<'a>, names: [Name; 2]| {
        element.children().filter(|child| names.contains(&child.tag())).last()
    };
    let tag = |neighbour: Option<Element<'a>>, name: Name| match neighbour.map(Element::prefix) {
        None | Some("") => name.text().to_owned(),
        Some(prefix) => format!("{prefix}:{}", name.text()),
    };
    match management {
        Some(management) => {
            let behind = last(management, [n::CANopenGeneralFeatures, n::CANopenMasterFeatures]);
            let name = tag(behind.or(Some(management)), n::deviceCommissioning);
            editor.insert_child(management, behind, &format!("<{name}{settings}/>"));
        }
        None => {
            let behind = last(body, [n::ApplicationLayers, n::TransportLayers]);
            let names = [n::NetworkManagement, n::CANopenGeneralFeatures, n::deviceCommissioning];
            let [management, features, commissioning] = names.map(|name| tag(behind, name));
            let granularity = defaults::NUMBER;
            let xml = format!(
                "<{management}>\n  <{features} granularity=\"{granularity}\"/>\n  <{commissioning}{settings}/>\n</{management}>"
            );
            editor.insert_child(body, behind, &xml);
        }
    }
}

/// Adds the objects of `device` that `tree`, whose root is the container, lacks. `None` for a text without a list of
/// objects.
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

/// The text without references from objects to parameters, which are in a different profile of the file.
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

/// The elements with a prefix; values must not contain `<`.
fn with_prefix(xml: &str, prefix: &str) -> String {
    if prefix.is_empty() {
        return xml.to_owned();
    }
    xml.replace("<CANopen", &format!("<{prefix}:CANopen"))
        .replace("</CANopen", &format!("</{prefix}:CANopen"))
}
