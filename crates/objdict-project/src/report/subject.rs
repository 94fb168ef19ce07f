//! The subjects of findings.
//!
//! A label of a network may point into the description of a node (`At::Node`); `Subject::of_label` selects the
//! file.

use objdict_format::Description;
use objdict_model::diagnostic::At;
use objdict_model::source::{SourceFile, Span};
#[cfg(feature = "network")]
use objdict_network_file::NetworkFile;

/// The subject of a file's findings.
#[derive(Clone, Copy, Debug)]
pub enum Subject<'a> {
    /// A description.
    Description(&'a Description),
    /// A network; its findings have spans, and labels in the descriptions of its nodes.
    #[cfg(feature = "network")]
    Network(&'a NetworkFile),
    /// The description of a node in a network without a file; labels may also point into the descriptions of
    /// other nodes.
    #[cfg(feature = "network")]
    Node(&'a NetworkFile, usize),
    /// The text of a description without findings, which was not read because its result is known.
    Unchanged(&'a SourceFile),
    /// Any other text, such as the configuration; its findings have spans but no places.
    Text(&'a SourceFile),
}

impl<'a> Subject<'a> {
    /// The text.
    pub fn source(self) -> &'a SourceFile {
        match self {
            Self::Description(description) => description.source(),
            #[cfg(feature = "network")]
            Self::Network(network) => &network.source,
            #[cfg(feature = "network")]
            Self::Node(network, node) => {
                network.description(node).map_or(&network.source, Description::source)
            }
            Self::Unchanged(source) | Self::Text(source) => source,
        }
    }

    /// The subject that a label points into: the description of a node, for such a label in a network; the type
    /// description, for such a label of a configured node; otherwise this subject.
    #[must_use]
    pub fn of_label(self, at: &At) -> Self {
        match (self, at) {
            (Self::Description(description), At::Node(..)) => {
                description.origin().map_or(self, Self::Description)
            }
            #[cfg(feature = "network")]
            (Self::Network(network) | Self::Node(network, _), At::Node(node, _)) => {
                network.description(*node).map_or(self, Self::Description)
            }
            #[cfg(feature = "full")]
            (Self::Description(description), At::Patch(number, _)) => {
                let patch = description.patched().and_then(|patched| patched.patches.get(*number));
                patch.map_or(self, |patch| Self::Text(patch.source()))
            }
            _ => self.description().map_or(self, Self::Description),
        }
    }

    /// The span of a label in the text of [its subject](Self::of_label); the start of the text if it is elsewhere.
    pub fn span_of(self, at: &At) -> Span {
        match (self.of_label(at), at) {
            (Self::Description(description), at) => description.span_of(at),
            (_, At::Span(span) | At::Patch(_, span)) => *span,
            _ => Span::default(),
        }
    }

    /// The description; `None` for any other text.
    pub fn description(self) -> Option<&'a Description> {
        match self {
            Self::Description(description) => Some(description),
            #[cfg(feature = "network")]
            Self::Node(network, node) => network.description(node),
            _ => None,
        }
    }
}

impl<'a> From<&'a Description> for Subject<'a> {
    fn from(description: &'a Description) -> Self {
        Self::Description(description)
    }
}

impl<'a> From<&'a SourceFile> for Subject<'a> {
    fn from(source: &'a SourceFile) -> Self {
        Self::Text(source)
    }
}
