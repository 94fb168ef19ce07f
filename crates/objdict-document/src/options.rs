//! The options of documentation.

use crate::Language;

/// Options of the documentation.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The title (default: product name).
    pub title: Option<String>,
    /// The node-ID for COB-IDs, 1 to 127 (default: that of the configured node, if any).
    pub node_id: Option<u8>,
    /// The language of names and descriptions, if the description has several (RFC 5646, such as `de`).
    /// Headings and sentences use it if objdict supports it ([`Language::of_tag`]), else English.
    pub language: Option<String>,
    /// The address of a workbench, the page that edits descriptions (default: no link to one). It is a URL of HTTP or a path.
    pub workbench: Option<String>,
}

impl Options {
    /// The language of headings and sentences.
    pub fn own_language(&self) -> Language {
        self.language.as_deref().and_then(Language::of_tag).unwrap_or_default()
    }

    /// The language of description texts.
    pub(crate) fn tag(&self) -> &str {
        self.language.as_deref().unwrap_or("en")
    }
}
