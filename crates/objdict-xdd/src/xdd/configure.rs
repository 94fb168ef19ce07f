//! Conversion between XDD and XDC by edits of the text, so that comments, order, spelling, line ends and
//! encoding are kept.

use super::defaults;
use super::layout::{Layout, with_subs};
use super::schema::network::DEVICE_COMMISSIONING;
use super::shape::facts;
use crate::model::Commissioning;
use crate::source::EditError;
use crate::xml::{Element, Name, Tree, XmlEditor, escaped_value, n};

/// The bytes of `tree` as an XDC with the name `file_name` for the node `node`; the values of `node` replace
/// those of the text. `None` if the file has no place for them: without a communication network profile, and
/// in a project with several devices.
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

/// The bytes of `tree` as an XDD with the name `file_name`: without the node and its configured values.
/// `None` for a project with several devices.
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

/// Inserts the node into `NetworkManagement` after the features, or `NetworkManagement` with the node at the
/// end of the body. The new elements get the prefix of their neighbours and thus the same namespace.
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
