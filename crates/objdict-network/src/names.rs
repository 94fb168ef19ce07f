//! Finds nodes by name.

use crate::diagnostic::{Diagnostic, Findings, Text, misspelled, nearest, say};
use crate::network::{Node, Said};
use crate::rules::UNKNOWN_NODE;
use crate::source::Span;

/// The position of the node that is named as the manager in the network file. `None` for a manager without a
/// description, which has its own node-ID and a name that is not similar to a node's; other unknown names are findings.
pub fn named_manager(
    named: &Said<String>,
    has_node_id: bool,
    nodes: &[Node],
    findings: &mut Findings,
) -> Option<usize> {
    let position = |name: &str| nodes.iter().position(|node| node.name.value == name);
    if let Some(node) = position(&named.value) {
        return Some(node);
    }
    let names = nodes.iter().map(|node| &*node.name.value);
    let meant = misspelled(&named.value, names).filter(|name| !are_counted(name, &named.value));
    let help = match meant {
        Some(name) => say!("write `{}`, or give the manager a more distinct name", name),
        None if has_node_id => return None,
        None => say!("describe it, or add `manager` with its `id`"),
    };
    let message = say!("unknown node `{}` as manager", named.value);
    findings.push(Diagnostic::new(&UNKNOWN_NODE, named.at, message).help(help));
    // with its own node-ID, there is a manager in any case
    meant.filter(|_| !has_node_id).and_then(position)
}

/// Whether names differ like those of similar devices: `plc1` and `plc2`, `plc_a` and `plc_b`.
fn are_counted(a: &str, b: &str) -> bool {
    let letters = |text: &str| text.replace(|letter: char| letter.is_ascii_digit(), "");
    let without_last = |text: &str| text.char_indices().last().map(|(last, _)| text[..last].to_owned());
    letters(a) == letters(b) || !a.eq_ignore_ascii_case(b) && without_last(a) == without_last(b)
}

/// An unknown node name, with a suggestion.
pub(crate) fn unknown_node<'a>(
    at: Span,
    name: &str,
    message: Text,
    names: impl IntoIterator<Item = &'a str>,
) -> Diagnostic {
    let finding = Diagnostic::new(&UNKNOWN_NODE, at, message);
    match nearest(name, names) {
        Some(name) => finding.help(say!("write `{}`, or describe the node", name)),
        None => finding.help("describe the node, or write the name of one that is described"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_misspelled_manager_is_no_other_device() {
        let node = |name: &str| Node { name: Said::new(name.to_owned(), Span::default()), ..Node::default() };
        let nodes = ["plc", "drive1", "axis_a"].map(node);
        let named = |name: &str, has_id| {
            let mut findings = Findings::new();
            let named = Said::new(name.to_owned(), Span::default());
            (named_manager(&named, has_id, &nodes, &mut findings), findings.iter().count())
        };
        assert_eq!(named("plc", false), (Some(0), 0));
        assert_eq!(named("pcl", false), (Some(0), 1));
        assert_eq!(named("pcl", true), (None, 1));
        assert_eq!(named("PLC", true), (None, 1));
        for other in ["drive2", "axis_b", "plc2", "master"] {
            assert_eq!(named(other, true), (None, 0), "{other}");
            assert_eq!(named(other, false), (None, 1), "{other}");
        }
    }
}
