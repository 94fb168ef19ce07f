//! The elements of an XDD or XDC, or of a project of another program.

use std::sync::{Arc, OnceLock};

use crate::objdictgen;
use crate::text::{DescriptionText, NodeOfType, ReadText, TextEdits, is_as_valid, restored};
use objdict_model::diagnostic::{Change, Findings};
use objdict_model::model::{Commissioning, Device, DeviceKind, Place};
use objdict_model::source::{EditError, SourceFile, Span};
use objdict_xdd::xdd::{self, ElementLocator};
use objdict_xdd::xml::Tree;

/// Elements of one of the described devices, with its locator, which is created on demand.
#[derive(Debug)]
struct XmlText {
    tree: Arc<Tree>,
    /// The number of the device's profile container.
    number: usize,
    kind: DeviceKind,
    locator: OnceLock<ElementLocator>,
}

/// Reads elements.
pub(super) fn read(source: SourceFile, kind: DeviceKind) -> ReadText {
    let mut damage = Findings::new();
    let tree = Tree::new(source, &mut damage);
    if objdictgen::is_project(&tree) {
        let (text, device, findings) = objdictgen::read(tree);
        // each project has one
        damage = damage.filter_map(|found| (found.rule.id != "xml/document-type").then_some(found));
        damage.append(findings);
        let (device, findings) = restored((device, damage));
        return (text, device, findings);
    }
    let tree = Arc::new(tree);
    #[cfg(feature = "esi")]
    if tree.root().is_some_and(|root| root.name() == "EtherCATInfo") {
        let (text, device, findings) = crate::esi::read(tree, 0, kind);
        damage.append(findings);
        return (text, device, damage);
    }
    let (text, device, findings) = XmlText::read(&tree, 0, kind);
    damage.append(findings);
    (text, device, damage)
}

impl XmlText {
    fn read(tree: &Arc<Tree>, number: usize, kind: DeviceKind) -> ReadText {
        let (device, findings) = restored(xdd::read(tree, number, kind));
        let text = Self { tree: Arc::clone(tree), number, kind, locator: OnceLock::new() };
        (Box::new(text), device, findings)
    }

    fn locator(&self) -> &ElementLocator {
        self.locator.get_or_init(|| ElementLocator::new(&self.tree, self.number))
    }

    /// Whether an edited text is as valid as this one, and a reader finds the given node in it: in a malformed text it
    /// may look in a different place.
    fn can_become(&self, bytes: &[u8], node: Option<&Commissioning>) -> bool {
        let source = self.source().with_bytes(bytes.to_vec());
        let kind = if node.is_some() { DeviceKind::Node } else { DeviceKind::Type };
        source.map(|source| read(source, kind)).is_ok_and(|(text, device, _)| {
            let node_id = |node: Option<&Commissioning>| node.and_then(|node| node.node_id);
            is_as_valid(&*text, self) && node_id(device.commissioning.as_ref()) == node_id(node)
        })
    }
}

impl DescriptionText for XmlText {
    fn source(&self) -> &SourceFile {
        self.tree.source()
    }

    fn tree(&self) -> Option<&Tree> {
        Some(&self.tree)
    }

    fn locate(&self, place: &Place) -> Option<Span> {
        self.locator().locate(&self.tree, place)
    }

    fn place_at(&self, at: u32) -> Option<Place> {
        self.locator().place_at(&self.tree, at)
    }

    fn objects(&self) -> Vec<(u16, Span)> {
        self.locator().objects(&self.tree)
    }

    fn device_count(&self) -> usize {
        xdd::containers(&self.tree).len().max(1)
    }

    fn sibling(&self, number: usize) -> Option<ReadText> {
        let is_there = number < xdd::containers(&self.tree).len();
        is_there.then(|| Self::read(&self.tree, number, self.kind))
    }

    fn is_project(&self) -> bool {
        xdd::is_project(&self.tree)
    }

    fn is_network(&self) -> bool {
        xdd::is_network(&self.tree)
    }

    fn violations(&self) -> Findings {
        xdd::findings::violations(&self.tree)
    }

    fn findings(&self) -> Findings {
        let mut findings = Findings::new();
        if self.number == 0 {
            xdd::findings::check(&self.tree, &mut findings);
        }
        findings
    }

    fn edits(&self, _: &Device, changes: &[Change]) -> Option<TextEdits> {
        xdd::edits(&self.tree, self.locator(), changes)
    }

    fn of_node(&self, file_name: &str, node: Option<NodeOfType<'_>>) -> Option<Result<Vec<u8>, EditError>> {
        let node = node.map(|(node, _)| node);
        let edited = match node {
            Some(node) => xdd::to_xdc(&self.tree, file_name, node),
            None => xdd::to_xdd(&self.tree, file_name),
        };
        edited.filter(|edited| edited.as_ref().map_or(true, |bytes| self.can_become(bytes, node)))
    }

    #[cfg(feature = "full")]
    fn arranged<'a>(&'a self, _: &'a Device) -> Option<Box<dyn Iterator<Item = String> + 'a>> {
        Some(Box::new([true, false].into_iter().filter_map(|sorted| xdd::arrange(&self.tree, sorted))))
    }
}
