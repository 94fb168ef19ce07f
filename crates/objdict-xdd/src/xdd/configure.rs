//! XDD to XDC and back, by edits of the text: comments, order, spelling, line ends and encoding stay.

use super::defaults;
use super::layout::{CONTAINER, Layout, below};
use super::read::SUB;
use crate::model::Commissioning;
use crate::source::EditError;
use crate::xml::{Editor, Element, Tree, escaped_value};

/// The bytes of `tree` as an XDC called `file_name` for the node `node`; what the node says replaces what the text says of
/// it. `None` where there is no place for it: without a communication network profile, and in a project of several devices.
pub fn to_xdc(tree: &Tree, file_name: &str, node: &Commissioning) -> Option<Result<Vec<u8>, EditError>> {
    let layout = layout(tree)?;
    let body = layout.network?.body;
    let mut editor = Editor::new(tree);
    rename(&layout, file_name, &mut editor);
    let management = body.child("NetworkManagement");
    match management.and_then(|management| management.child("deviceCommissioning")) {
        Some(element) => {
            for (name, value) in settings(node) {
                // CANopenEditor writes the second
                let is_other = name == "nodeID" && element.attribute("NodeID").is_some();
                editor.set_attribute(element, if is_other { "NodeID" } else { name }, &value);
            }
        }
        None => insert(body, management, node, &mut editor),
    }
    Some(editor.to_bytes())
}

/// The bytes of `tree` as an XDD called `file_name`: without the node and what was configured for it. `None` for a project
/// of several devices.
pub fn to_xdd(tree: &Tree, file_name: &str) -> Option<Result<Vec<u8>, EditError>> {
    let layout = layout(tree)?;
    let mut editor = Editor::new(tree);
    rename(&layout, file_name, &mut editor);
    let management = layout.network.and_then(|network| network.body.child("NetworkManagement"));
    for node in management.iter().flat_map(|management| management.children_named("deviceCommissioning")) {
        editor.remove_element(node);
    }
    for object in layout.objects() {
        for element in std::iter::once(object).chain(object.children_named(SUB)) {
            editor.remove_attribute(element, "actualValue");
            editor.remove_attribute(element, "denotation");
        }
    }
    for parameter in parameters(&layout) {
        let configured = |child: &Element<'_>| matches!(child.name(), "actualValue" | "denotation");
        parameter.children().filter(configured).for_each(|child| editor.remove_element(child));
    }
    Some(editor.to_bytes())
}

/// The description that is all of the file.
fn layout(tree: &Tree) -> Option<Layout<'_>> {
    let root = tree.root().filter(|root| root.name() == CONTAINER)?;
    Some(Layout::of_container(root))
}

fn rename<'a>(layout: &Layout<'a>, file_name: &str, editor: &mut Editor<'a>) {
    for profile in [layout.device, layout.network].into_iter().flatten() {
        editor.set_attribute(profile.body, "fileName", file_name);
    }
}

/// The parameters and their templates.
fn parameters<'a>(layout: &Layout<'a>) -> impl Iterator<Item = Element<'a>> {
    let processes =
        layout.device.into_iter().flat_map(|device| device.body.children_named("ApplicationProcess"));
    processes.flat_map(|process| {
        let of = |list: &[&str], name: &'static str| {
            below(process, list).into_iter().flat_map(move |list| list.children_named(name))
        };
        of(&["parameterList"], "parameter").chain(of(&["templateList"], "parameterTemplate"))
    })
}

/// Puts the node into `NetworkManagement`, behind the features, or with that behind everything else of the body. The new
/// elements have the prefix of their neighbours, so they are in the same namespace.
fn insert<'a>(
    body: Element<'a>,
    management: Option<Element<'a>>,
    node: &Commissioning,
    editor: &mut Editor<'a>,
) {
    let settings: String =
        settings(node).iter().map(|(name, value)| format!(" {name}=\"{}\"", escaped_value(value))).collect();
    let last = |element: Element<'a>, names: [&str; 2]| {
        element.children().filter(|child| names.contains(&child.name())).last()
    };
    let tag = |neighbour: Option<Element<'a>>, name: &str| match neighbour.map(Element::prefix) {
        None | Some("") => name.to_owned(),
        Some(prefix) => format!("{prefix}:{name}"),
    };
    match management {
        Some(management) => {
            let behind = last(management, ["CANopenGeneralFeatures", "CANopenMasterFeatures"]);
            let name = tag(behind.or(Some(management)), "deviceCommissioning");
            editor.insert_child(management, behind, &format!("<{name}{settings}/>"));
        }
        None => {
            let behind = last(body, ["ApplicationLayers", "TransportLayers"]);
            let names = ["NetworkManagement", "CANopenGeneralFeatures", "deviceCommissioning"];
            let [management, features, commissioning] = names.map(|name| tag(behind, name));
            let granularity = defaults::NUMBER;
            let xml = format!(
                "<{management}>\n  <{features} granularity=\"{granularity}\"/>\n  <{commissioning}{settings}/>\n</{management}>"
            );
            editor.insert_child(body, behind, &xml);
        }
    }
}

/// The attributes of `deviceCommissioning`, all of which the standard demands.
fn settings(node: &Commissioning) -> [(&'static str, String); 6] {
    let text = |text: &Option<String>| text.clone().unwrap_or_else(|| defaults::NAME.to_owned());
    let or = |text: Option<String>, nothing: &str| text.unwrap_or_else(|| nothing.to_owned());
    let bit_rate = node.baud_rate.map(|kbit| format!("{kbit} Kbps"));
    [
        ("nodeID", or(node.node_id.map(|id| id.to_string()), defaults::NUMBER)),
        ("nodeName", text(&node.node_name)),
        ("actualBaudRate", bit_rate.unwrap_or_default()),
        ("networkNumber", or(node.net_number.map(|number| number.to_string()), defaults::NUMBER)),
        ("networkName", text(&node.network_name)),
        ("CANopenManager", or(node.manager.map(|is| is.to_string()), defaults::FLAG)),
    ]
}
