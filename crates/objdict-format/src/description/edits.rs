//! Descriptions with changes: as the description of a node or a type, with fixes.

use super::{Description, stated_name};
use crate::text::TextEdits;
use objdict_model::diagnostic::{Change, Fix};
use objdict_model::model::{Commissioning, DeviceKind};
use objdict_model::source::{EditError, Encoding, Span};

impl Description {
    /// Converts this text to the description of a node, in a file called `file_name`: an EDS becomes a DCF. Only the
    /// necessary text changes, so comments, order, spelling, line ends and encoding are kept. `LastEDS` is the name of
    /// the current file, unless it already describes a node.
    ///
    /// # Errors
    /// If an edited text cannot be written in the encoding of the file.
    pub fn to_node(&self, file_name: &str, node: &Commissioning) -> Result<Vec<u8>, EditError> {
        self.of_node(file_name, Some(node))
    }

    /// Converts this text to the description of a device type, in a file called `file_name`: without the node and its
    /// configured values. A DCF becomes an EDS.
    ///
    /// # Errors
    /// If an edited text cannot be written in the encoding of the file.
    pub fn to_type(&self, file_name: &str) -> Result<Vec<u8>, EditError> {
        self.of_node(file_name, None)
    }

    fn of_node(&self, file_name: &str, node: Option<&Commissioning>) -> Result<Vec<u8>, EditError> {
        #[cfg(feature = "full")]
        if !self.is_composed()
            && let Some(realised) = self.realised()?
        {
            return realised.of_node(file_name, node);
        }
        let last_eds = self.source().name().rsplit(['/', '\\']).next().map(stated_name);
        let last_eds = last_eds.as_deref().filter(|_| self.device.kind == DeviceKind::Type);
        let edited = self.text.of_node(file_name, node.map(|node| (node, last_eds)));
        #[cfg(feature = "full")]
        let edited = edited.or_else(|| Some(self.rewritten(file_name, node)));
        edited.unwrap_or_else(|| Err(EditError::ReadOnly(self.source().name().to_owned())))
    }

    /// The text edits of a fix, in text order: each span with its replacement. `None` if this format or file cannot be
    /// edited in this way; the finding then has no fix. A fix that changes the encoding is not an edit either.
    pub fn edits(&self, fix: &Fix) -> Option<Vec<(Span, String)>> {
        self.placed(fix).filter(|edits| self.text.can_take(edits))
    }

    /// The edits of a fix, without verifying that the edited text can be read, which takes as long as reading
    /// it.
    fn placed(&self, fix: &Fix) -> Option<TextEdits> {
        if self.source().is_read_only() || self.is_project() || self.is_composed() {
            return None;
        }
        let edits = self.text.edits(&self.device, &fix.changes)?;
        let text = self.source().text();
        let is_change = |(span, new): &&(Span, String)| span.of(text) != new;
        let is_sound = |(span, new): &(Span, String)| {
            text.get(span.start as usize..span.end as usize).is_some() && self.source().encode(new).is_ok()
        };
        let changes = edits.iter().any(|edit| is_change(&edit));
        (changes && edits.iter().all(is_sound)).then_some(edits)
    }

    /// The new encoding of a fix, if it changes the encoding and the text can be written in it.
    pub fn encoding_of(&self, fix: &Fix) -> Option<Encoding> {
        let [Change::Encode(encoding)] = fix.changes[..] else { return None };
        let can_be_written = !self.source().is_read_only() && encoding.encode(self.source().text()).is_ok();
        (can_be_written && encoding != self.source().encoding()).then_some(encoding)
    }

    /// Whether a fix can be applied to this file.
    pub fn can_fix(&self, fix: &Fix) -> bool {
        self.encoding_of(fix).is_some() || self.placed(fix).is_some()
    }
}
