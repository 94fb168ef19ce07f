//! Node types of `network.toml`: keys that several nodes have in common.

use super::network_keys::{NODE, PDO};
use super::rules::UNKNOWN_TYPE;
use objdict_keyed::section::{self, wrong};
use objdict_keyed::tree::{KeyedTree, Kind, Pair};
use objdict_model::diagnostic::{Diagnostic, Findings, nearest, say};

/// The key with the name of a node's or type's type.
const USE: &str = "use";

/// A node with the keys of its type, and of the type that this one uses. The node's own keys take precedence; tables
/// are merged key by key, and other values are replaced.
pub(super) fn with_type(node: &Pair, types: &[Pair], findings: &mut Findings) -> Pair {
    let mut value = node.value.clone();
    let mut names = Vec::new();
    let mut used = node.value.get(USE);
    while let Some(tree) = used {
        let name = match &*tree.kind {
            Kind::Text(_) | Kind::Integer(_) | Kind::Float(_) => tree.spelled(),
            _ => {
                findings.push(wrong(USE, tree, "a string").help("write the name of a type in quotes"));
                break;
            }
        };
        let finding = |message, help| Diagnostic::new(&UNKNOWN_TYPE, tree.span, message).help(help);
        let Some(found) = types.iter().find(|entry| entry.key.spelled() == name) else {
            let known: Vec<String> = types.iter().map(|entry| entry.key.spelled()).collect();
            let help = match nearest(&name, known.iter().map(String::as_str)) {
                Some(meant) => say!("did you mean `{}`?", meant),
                None => say!("add `[type.{}]` with the keys that its nodes have in common", name),
            };
            findings.push(finding(say!("unknown type `{}`", name), help));
            break;
        };
        if names.contains(&name) {
            let help = say!("remove one `use` from the cycle");
            findings.push(finding(say!("the type `{}` uses itself", name), help));
            break;
        }
        names.push(name);
        value = value.on(&known(&found.value), &|key| section::present_name(PDO, key).to_owned());
        used = found.value.get(USE);
    }
    Pair { key: node.key.clone(), value }
}

/// The keys of a type that a node may have; others are reported for the type.
fn known(kind: &KeyedTree) -> KeyedTree {
    let is_known = |entry: &&Pair| NODE.iter().any(|key| key.name == entry.key.spelled());
    let entries = kind.entries().unwrap_or_default().iter().filter(is_known).cloned();
    KeyedTree::new(kind.span, Kind::Map(entries.collect()))
}
