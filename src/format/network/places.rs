//! Labels that point into the descriptions of nodes.

use std::rc::Rc;

use super::NetworkFile;
use crate::diagnostic::{At, Diagnostic, Findings};
use crate::format::Description;

impl NetworkFile {
    /// The description of a node, by its position in the network; `None` for a device as JSON.
    pub fn description(&self, node: usize) -> Option<&Description> {
        let node = self.network.as_ref()?.nodes.get(node)?;
        self.descriptions.get(&node.file.value).map(Rc::as_ref)
    }

    /// The findings without labels that point nowhere: into a device as JSON, or to what the description does not have.
    pub(super) fn with_places(&self, findings: Findings) -> Findings {
        findings.filter_map(|mut finding| {
            self.keep_places(&mut finding);
            Some(finding)
        })
    }

    /// Nodes may share a description, so one place may have several labels, of which the first is kept.
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
}
