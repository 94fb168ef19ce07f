//! Rewrites descriptions: with patches, in canonical order, or from scratch.
//!
//! `arranged` compares the devices before and after, because it moves text that the model does not contain.

use std::borrow::Cow;
use std::sync::OnceLock;

use super::Description;
use crate::input::DEFAULT_MAX_ENTRIES;
use crate::mention::Mention;
use crate::patch::{self, Patched};
use crate::{Format, WriteOptions};
use objdict_model::model::{Commissioning, Device, DeviceKind};
use objdict_model::source::{EditError, SourceFile};

impl Description {
    /// The description with a patched device instead of the one in its text.
    pub(crate) fn with_patched(self, device: Device, patched: Patched) -> Self {
        Self { device, enabled: OnceLock::new(), patched: Some(Box::new(patched)), ..self }
    }

    /// Applies the patches that were given for a different device of the file.
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
    /// If that text cannot be written in the encoding of the file.
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

    /// The references to objects in a `device.toml`; `None` for any other format.
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

    /// The bytes of this text in canonical order and spelling. EDS and DCF: sections and keys in the order of CiA
    /// 306-1, with their comments; consistent spelling of keys, section names, hex numbers and formulas. XDD and XDC:
    /// elements and attributes in the order of CiA 311, one element per line. The content remains the same.
    ///
    /// # Errors
    /// If the text cannot be written in the encoding of the file, its content would change, or it is XML that is not
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
            if text == source.text() {
                return true;
            }
            let again = Self::read(SourceFile::from_text(source.name(), text.clone()), self.format, None);
            // a network has several devices
            (0..self.device_count())
                .all(|number| are_equal(&self.device_at(number), &again.device_at(number)))
        };
        let name = || source.name().to_owned();
        let mut arranged = self.text.arranged(&self.device).ok_or_else(|| EditError::NotWritten(name()))?;
        let text = arranged.find(is_same).ok_or_else(|| EditError::OtherMeaning(name()))?;
        source.encode(&text).map_err(EditError::from)
    }
}

/// Whether two devices are equal, apart from the order of unknown sections.
fn are_equal(one: &Device, other: &Device) -> bool {
    let sorted = |device: &Device| {
        let mut device = device.clone();
        device.extra.sort_by_key(|section| section.name().to_ascii_lowercase());
        device
    };
    one == other || sorted(one) == sorted(other)
}
