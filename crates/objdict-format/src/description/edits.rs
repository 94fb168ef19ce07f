//! Descriptions with changes: as the description of a node or a type, in order, with fixes.
//!
//! `arranged` compares the devices before and after, because it moves text that the model does not contain.

#[cfg(feature = "full")]
use super::says_the_same;
#[cfg(any(feature = "full", not(feature = "xdd")))]
use super::stated_name;
use super::{Description, Text};
#[cfg(feature = "full")]
use crate::Format;
#[cfg(feature = "full")]
use crate::device_toml;
use objdict_eds::eds;
use objdict_model::diagnostic::{Change, Fix};
#[cfg(any(feature = "full", not(feature = "xdd")))]
use objdict_model::model::{Commissioning, DeviceKind};
#[cfg(any(feature = "full", not(feature = "xdd")))]
use objdict_model::source::EditError;
#[cfg(feature = "full")]
use objdict_model::source::SourceFile;
use objdict_model::source::{Encoding, Span};
#[cfg(feature = "xdd")]
use objdict_xdd::xdd;

impl Description {
    /// The bytes of this text as the description of a node, called `file_name`: an EDS becomes a DCF. Only the text that
    /// must change does, so comments, order, spelling, line ends and encoding stay. `LastEDS` is the name that the text
    /// was read by, unless it is of a node already.
    ///
    /// # Errors
    /// When an edited text cannot be written in the encoding of the file.
    #[cfg(any(feature = "full", not(feature = "xdd")))]
    pub fn to_node(&self, file_name: &str, node: &Commissioning) -> Result<Vec<u8>, EditError> {
        #[cfg(feature = "full")]
        if !self.is_composed()
            && let Some(realised) = self.realised()?
        {
            return realised.to_node(file_name, node);
        }
        let last_eds = self.source().name().rsplit(['/', '\\']).next().map(stated_name);
        let last_eds = last_eds.as_deref();
        let last_eds = last_eds.filter(|_| self.device.kind == DeviceKind::Type);
        match &self.text {
            Text::Ini(document, _) => eds::to_dcf(document, file_name, last_eds, node),
            #[cfg(feature = "xdd")]
            Text::Xml(tree, _) => {
                // in a malformed text a reader may look for the node in another place
                let edited = xdd::to_xdc(tree, file_name, node).filter(|edited| {
                    edited.as_ref().map_or(true, |bytes| self.can_become(bytes, Some(node)))
                });
                edited.unwrap_or_else(|| self.anew(file_name, Some(node)))
            }
            #[cfg(feature = "xdd")]
            Text::Objdictgen(..) => self.anew(file_name, Some(node)),
            #[cfg(feature = "full")]
            Text::Toml(document) => match device_toml::edits::to_node(document, file_name, node) {
                Some(edits) if !self.is_composed() => self.edited(&edits),
                _ => self.anew(file_name, Some(node)),
            },
        }
    }

    /// Whether an edited text is as valid as this one, and a reader finds the node in it, or none.
    #[cfg(feature = "full")]
    fn can_become(&self, bytes: &[u8], node: Option<&Commissioning>) -> bool {
        let mut options = objdict_model::source::SourceOptions::default();
        (options.encoding, options.max_size) = (Some(self.source().encoding()), u64::MAX);
        let source = SourceFile::from_bytes(self.source().name(), bytes.to_vec(), &options);
        let format = if node.is_some() { Format::Xdc } else { Format::Xdd };
        source.map(|source| Self::read(source, format)).is_ok_and(|read| {
            let node_id = |node: Option<&Commissioning>| node.and_then(|node| node.node_id);
            read.is_as_valid_as(self) && node_id(read.device.commissioning.as_ref()) == node_id(node)
        })
    }

    /// The bytes of this text as the description of a device type, called `file_name`: without the node and the values
    /// that were configured for it. A DCF becomes an EDS.
    ///
    /// # Errors
    /// When an edited text cannot be written in the encoding of the file.
    #[cfg(any(feature = "full", not(feature = "xdd")))]
    pub fn to_type(&self, file_name: &str) -> Result<Vec<u8>, EditError> {
        #[cfg(feature = "full")]
        if !self.is_composed()
            && let Some(realised) = self.realised()?
        {
            return realised.to_type(file_name);
        }
        match &self.text {
            Text::Ini(document, _) => eds::to_eds(document, file_name),
            #[cfg(feature = "xdd")]
            Text::Xml(tree, _) => {
                let edited = xdd::to_xdd(tree, file_name)
                    .filter(|edited| edited.as_ref().map_or(true, |bytes| self.can_become(bytes, None)));
                edited.unwrap_or_else(|| self.anew(file_name, None))
            }
            #[cfg(feature = "xdd")]
            Text::Objdictgen(..) => self.anew(file_name, None),
            #[cfg(feature = "full")]
            Text::Toml(document) => match device_toml::edits::to_type(document, file_name) {
                Some(edits) if !self.is_composed() => self.edited(&edits),
                _ => self.anew(file_name, None),
            },
        }
    }

    /// The bytes of the text with edits.
    #[cfg(feature = "full")]
    fn edited(&self, edits: &[(Span, String)]) -> Result<Vec<u8>, EditError> {
        let mut edited = objdict_model::source::Edits::new(self.source());
        edits.iter().for_each(|(span, text)| edited.replace(*span, text.clone()));
        edited.to_bytes()
    }

    /// A new text in the same syntax, where that of the file has no place for it: a file of several devices, or one
    /// without communication network profile.
    #[cfg(feature = "full")]
    fn anew(&self, file_name: &str, node: Option<&Commissioning>) -> Result<Vec<u8>, EditError> {
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
        let max_losses =
            crate::WriteOptions::max_losses_of(self.source().text().len(), crate::input::DEFAULT_MAX_ENTRIES);
        let options = crate::WriteOptions { embed: true, max_losses, ..crate::WriteOptions::default() };
        Ok(crate::write(&device, format, &options)?.bytes)
    }

    /// The bytes of this text in the canonical order and spelling. EDS and DCF: sections and keys in the order of CiA 306-1,
    /// with the comments that belong to them; keys, section names, hex numbers and formulas spelled alike. XDD and XDC: elements
    /// and attributes in the order of CiA 311, one element a line. What is read of it stays the same.
    ///
    /// # Errors
    /// When the text cannot be written in the encoding of the file, something else would be read of it, or it is XML that is not
    /// well-formed or has a document type.
    #[cfg(feature = "full")]
    pub fn arranged(&self) -> Result<Vec<u8>, EditError> {
        #[cfg(feature = "full")]
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
                .all(|number| says_the_same(&self.device_at(number), &again.device_at(number)))
        };
        let found = match &self.text {
            Text::Ini(document, _) => {
                let mut texts = eds::fmt::Extent::ALL
                    .into_iter()
                    .map(|extent| eds::fmt::arrange(document, &self.device, extent));
                texts.find(is_same)
            }
            #[cfg(feature = "xdd")]
            Text::Xml(tree, _) => {
                [true, false].into_iter().filter_map(|sorted| xdd::arrange(tree, sorted)).find(is_same)
            }
            #[cfg(feature = "xdd")]
            Text::Objdictgen(..) => None,
            #[cfg(feature = "full")]
            Text::Toml(document) => Some(device_toml::edits::arranged(document)).filter(is_same),
        };
        let text = found.ok_or_else(|| EditError::OtherMeaning(source.name().to_owned()))?;
        source.encode(&text).map_err(EditError::from)
    }

    /// The edits of the text that a fix makes, in its order: each span with its replacement. `None`
    /// where this format or this file cannot be changed so; the finding has no fix then. A fix that writes the text in
    /// another encoding is no edit of it either.
    pub fn edits(&self, fix: &Fix) -> Option<Vec<(Span, String)>> {
        let edits = self.placed(fix)?;
        #[cfg(feature = "full")]
        if let Text::Toml(document) = &self.text
            && !device_toml::edits::is_toml(document, &edits)
        {
            return None;
        }
        Some(edits)
    }

    /// The edits of a fix, without the proof that the text can be read with them, which takes as long as to read it.
    fn placed(&self, fix: &Fix) -> Option<Vec<(Span, String)>> {
        if self.source().is_read_only() || self.is_project() || self.is_composed() {
            return None;
        }
        let edits = match &self.text {
            Text::Ini(document, locator) => {
                let locator = locator.get_or_init(|| eds::Locator::new(document));
                eds::edits(document, locator, &self.device, &fix.changes)
            }
            #[cfg(feature = "xdd")]
            Text::Xml(tree, locator) => {
                let locator = locator.get_or_init(|| xdd::Locator::new(tree, self.number));
                xdd::edits(tree, locator, &fix.changes)
            }
            #[cfg(feature = "xdd")]
            Text::Objdictgen(..) => None,
            #[cfg(feature = "full")]
            Text::Toml(document) => device_toml::edits::edits(document, &self.device, &fix.changes),
        }?;
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
