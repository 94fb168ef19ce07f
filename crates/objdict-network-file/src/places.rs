//! Labels that point into the descriptions of nodes.

use std::rc::Rc;

use super::NetworkFile;
use objdict_format::Description;
use objdict_model::diagnostic::{At, Diagnostic, Findings, SourceLabel};
use objdict_model::model::{Field, Part, Place};
use objdict_model::source::Span;

impl NetworkFile {
    /// The description of a node, by its position in the network; `None` for a JSON device.
    pub fn description(&self, node: usize) -> Option<&Description> {
        let node = self.network()?.nodes.get(node)?;
        self.descriptions.get(&node.file.value).map(Rc::as_ref)
    }

    /// The first node of each description that has a text.
    pub fn described_nodes(&self) -> impl Iterator<Item = usize> {
        let nodes = self.network().map_or(0, |network| network.nodes.len());
        (0..nodes).filter(|node| self.description(*node).is_some() && self.first_of_file(*node) == *node)
    }

    /// The first node with the same description.
    fn first_of_file(&self, node: usize) -> usize {
        let Some(network) = self.network() else { return node };
        let file = |node: usize| network.nodes.get(node).map(|node| &node.file.value);
        (0..node).find(|first| file(*first) == file(node)).unwrap_or(node)
    }

    /// Removes labels without a position: those in a JSON device, or for missing parts of the description.
    pub(super) fn with_places(&self, findings: Findings) -> Findings {
        findings.filter_map(|mut finding| {
            self.keep_places(&mut finding);
            Some(finding)
        })
    }

    /// Nodes may share a description, so one position may have several labels; only the first is kept.
    fn keep_places(&self, finding: &mut Diagnostic) {
        let mut seen = Vec::new();
        finding.labels.retain(|label| {
            let At::Node(node, place) = &label.at else { return true };
            let description = self.description(*node);
            let span = description.and_then(|description| description.locate(place));
            let Some((description, span)) = description.zip(span) else { return false };
            let at = (description.source().name(), span);
            let is_new = !seen.contains(&at);
            seen.push(at);
            is_new
        });
    }

    /// Converts a finding about a [made](Self::is_made) text to one about a node's description, with the first node of
    /// that description; `None` if it has no text.
    pub fn in_description(&self, finding: &Diagnostic) -> Option<(usize, Diagnostic)> {
        let mut labels = Vec::with_capacity(finding.labels.len());
        let points_into = |node: usize| {
            let is_in = move |label: &&SourceLabel| matches!(label.at, At::Node(other, _) if other == node);
            finding.labels.iter().find(is_in)
        };
        for label in &finding.labels {
            let At::Span(span) = label.at else { continue };
            let node = self.owner(span);
            if points_into(node).is_none() {
                labels.push(SourceLabel { at: At::Node(node, self.home(node)?), ..label.clone() });
            }
        }
        labels.extend(finding.labels.iter().filter(|label| matches!(label.at, At::Node(..))).cloned());
        let owner = finding.labels.iter().find_map(|label| match label.at {
            At::Span(span) => Some(self.owner(span)),
            _ => None,
        })?;
        self.description(owner)?;
        let first = labels.iter().position(|label| matches!(label.at, At::Node(node, _) if node == owner))?;
        let At::Node(_, place) = labels.remove(first).at else { return None };
        labels.insert(0, SourceLabel { at: place.into(), text: "".into() });
        Some((self.first_of_file(owner), Diagnostic { labels, ..finding.clone() }))
    }

    /// The node whose table contains a span; findings about the network belong to the first description.
    fn owner(&self, span: Span) -> usize {
        let nodes = self.network().into_iter().flat_map(|network| &network.nodes);
        nodes.take_while(|node| node.name.at.start <= span.start).count().saturating_sub(1)
    }

    /// The place in a description of its node, otherwise of its device.
    fn home(&self, node: usize) -> Option<Place> {
        let places = [
            Place::of(Part::Commissioning).field(Field::NodeId),
            Place::of(Part::DeviceInfo).field(Field::ProductName),
        ];
        let description = self.description(node)?;
        places
            .into_iter()
            .find(|place| description.locate(place).is_some())
            .or(Some(Place::of(Part::DeviceInfo)))
    }
}
