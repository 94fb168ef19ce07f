//! Descriptions that are rewritten: with patches, in canonical order, or from scratch.
//!
//! `arranged` compares the devices before and after, because it moves text that the model does not contain.

use std::borrow::Cow;
use std::sync::OnceLock;

use super::{Description, stated_name};
use crate::input::DEFAULT_MAX_ENTRIES;
use crate::mention::Mention;
use crate::patch::{self, Patched};
use crate::text::TextEdits;
use crate::{Format, WriteOptions};
use objdict_model::diagnostic::{Change, Fix};
use objdict_model::model::{Commissioning, Device, DeviceKind};
use objdict_model::source::{EditError, Encoding, SourceFile, Span};

impl Description {
    /// The description with a patched device instead of the one in its text.
    pub(crate) fn with_patched(self, device: Device, patched: Patched) -> Self {
        Self { device, enabled: OnceLock::new(), patched: Some(Box::new(patched)), ..self }
    }

    /// The description with the patches that were given for another device of the file.
    pub(super) fn with_patches_of(self, other: &Self) -> Self {
        match &other.patched {
            Some(patched) => patch::apply(self, &patched.given),
            None => self,
        }
    }

    /// The applied patches; `None` if none matched.
    pub fn patched(&self) -> Option<&Patched> {
        self.patched.as_deref()
    }

    /// The description with its patches written into its text; `None` if none matched.
    ///
    /// # Errors
    /// When that text cannot be written in the encoding of the file.
    pub fn realised(&self) -> Result<Option<Self>, EditError> {
        if self.patched.is_none() {
            return Ok(None);
        }
        let original = if self.is_composed() { None } else { self.with_bytes(self.source().to_bytes()) };
        let original = original.ok_or_else(|| EditError::ReadOnly(self.source().name().to_owned()))?;
        patch::edited(&original, &self.device).map(Some)
    }

    /// Whether the text describes this device.
    pub(crate) fn describes(&self, device: &Device) -> bool {
        are_equal(&self.device, device)
    }

    /// Where a `device.toml` names its objects; `None` for another format.
    pub fn toml_mentions(&self) -> Option<Vec<Mention>> {
        self.text.mentions()
    }

    /// A new text in the same syntax, for a file that cannot be edited: one with several devices, or without a communication
    /// network profile.
    pub(super) fn rewritten(
        &self,
        file_name: &str,
        node: Option<&Commissioning>,
    ) -> Result<Vec<u8>, EditError> {
        let mut device = self.device.clone();
        if let Some(info) = &mut device.file_info {
            info.file_name = Some(file_name.to_owned());
        }
        if let Some(node) = node {
            device.kind = DeviceKind::Node;
            device.commissioning = Some(node.clone());
        }
        let kind = if node.is_some() { DeviceKind::Node } else { DeviceKind::Type };
        let format = Format::of(self.format.syntax(), kind);
        let max_losses = WriteOptions::max_losses_of(self.source().text().len(), DEFAULT_MAX_ENTRIES);
        let options = WriteOptions { embed: true, max_losses, ..WriteOptions::default() };
        Ok(crate::write(&device, format, &options)?.bytes)
    }

    /// One of the devices of the file.
    fn device_at(&self, number: usize) -> Cow<'_, Device> {
        if number == self.number {
            return Cow::Borrowed(&self.device);
        }
        Cow::Owned(self.sibling(number).map(|other| other.device).unwrap_or_default())
    }

    /// The bytes of this text in the canonical order and spelling. EDS and DCF: sections and keys in the order of CiA 306-1,
    /// with the comments that belong to them; keys, section names, hex numbers and formulas spelled alike. XDD and XDC: elements
    /// and attributes in the order of CiA 311, one element a line. What is read of it stays the same.
    ///
    /// # Errors
    /// When the text cannot be written in the encoding of the file, something else would be read of it, or it is XML that is not
    /// well-formed or has a document type.
    pub fn arranged(&self) -> Result<Vec<u8>, EditError> {
        if let Some(realised) = self.realised()? {
            return realised.arranged();
        }
        let source = self.source();
        if source.is_read_only() {
            return Err(EditError::ReadOnly(source.name().to_owned()));
        }
        let is_same = |text: &String| {
            let again = Self::read(SourceFile::from_text(source.name(), text.clone()), self.format);
            // a network has several devices
            (0..self.device_count())
                .all(|number| are_equal(&self.device_at(number), &again.device_at(number)))
        };
        let found = self.text.arranged(&self.device).find(is_same);
        let text = found.ok_or_else(|| EditError::OtherMeaning(source.name().to_owned()))?;
        source.encode(&text).map_err(EditError::from)
    }
}

/// Whether two devices are the same, but for the order of the sections that the model does not know.
fn are_equal(one: &Device, other: &Device) -> bool {
    let sorted = |device: &Device| {
        let mut device = device.clone();
        device.extra.sort_by_key(|section| section.name().to_ascii_lowercase());
        device
    };
    one == other || sorted(one) == sorted(other)
}

impl Description {
    /// The bytes of this text as the description of a node, called `file_name`: an EDS becomes a DCF. Only the text that
    /// must change does, so comments, order, spelling, line ends and encoding stay. `LastEDS` is the name that the text
    /// was read by, unless it is of a node already.
    ///
    /// # Errors
    /// When an edited text cannot be written in the encoding of the file.
    pub fn to_node(&self, file_name: &str, node: &Commissioning) -> Result<Vec<u8>, EditError> {
        self.of_node(file_name, Some(node))
    }

    /// The bytes of this text as the description of a device type, called `file_name`: without the node and the values
    /// that were configured for it. A DCF becomes an EDS.
    ///
    /// # Errors
    /// When an edited text cannot be written in the encoding of the file.
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

    /// The edits of the text that a fix makes, in its order: each span with its replacement. `None`
    /// where this format or this file cannot be changed so; the finding has no fix then. A fix that writes the text in
    /// another encoding is no edit of it either.
    pub fn edits(&self, fix: &Fix) -> Option<Vec<(Span, String)>> {
        self.placed(fix).filter(|edits| self.text.can_take(edits))
    }

    /// The edits of a fix, without the proof that the text can be read with them, which takes as long as to read it.
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

    /// The encoding that a fix writes the text in, where it does and the text can be written so.
    pub fn encoding_of(&self, fix: &Fix) -> Option<Encoding> {
        let [Change::Encode(encoding)] = fix.changes[..] else { return None };
        let can_be_written = !self.source().is_read_only() && encoding.encode(self.source().text()).is_ok();
        (can_be_written && encoding != self.source().encoding()).then_some(encoding)
    }

    /// Whether a fix can be made in this file.
    pub fn can_fix(&self, fix: &Fix) -> bool {
        self.encoding_of(fix).is_some() || self.placed(fix).is_some()
    }
}
