//! A description configured for a node: by edits of its text where that is possible.

use super::{Description, Format, Syntax, WriteOptions, eds};
use crate::configure::{Assignment, changes};
use crate::diagnostic::Fix;
use crate::model::{Commissioning, Device, DeviceKind, Part, Place};
use crate::source::{EditError, Edits, SourceFile, SourceOptions};

/// What a node is configured to be.
#[derive(Clone, Copy, Debug)]
pub struct NodeSettings<'a> {
    /// What is said of the node.
    pub node: &'a Commissioning,
    /// The dictionary with the modules that are plugged in ([`crate::modular::flatten`]); `None` for that of the
    /// description.
    pub plugged: Option<&'a Device>,
    /// The values ([`crate::configure::configure`]).
    pub assignments: &'a [Assignment],
}

/// A description that was configured.
#[derive(Clone, Debug)]
pub struct Configured {
    /// The bytes of the file.
    pub bytes: Vec<u8>,
    /// The device that they describe.
    pub device: Device,
    /// Whether the text was edited, so that comments, order and spelling are still there; otherwise it is a new one.
    pub is_edited: bool,
}

impl Description {
    /// This description as that of a node, called `file_name`, with the values: an EDS becomes a DCF, an XDD an XDC.
    ///
    /// # Errors
    /// When the text cannot be written in the encoding of the file.
    pub fn configured(&self, file_name: &str, settings: &NodeSettings<'_>) -> Result<Configured, EditError> {
        let mut device = settings.plugged.unwrap_or(self.device()).clone();
        device.assign(settings.assignments);
        device.kind = DeviceKind::Node;
        device.commissioning = Some(settings.node.clone());
        if let Some(info) = &mut device.file_info {
            info.file_name = Some(file_name.to_owned());
        }
        let edited =
            self.with_values(&device).map(|description| description.to_node(file_name, settings.node));
        if let Some(bytes) = edited.transpose()? {
            return Ok(Configured { bytes, device, is_edited: true });
        }
        let format = match self.format().syntax() {
            Syntax::Ini => Format::Dcf,
            Syntax::Xml => Format::Xdc,
        };
        let bytes =
            super::write(&device, format, &WriteOptions { carry: true, ..WriteOptions::default() }).bytes;
        Ok(Configured { bytes, device, is_edited: false })
    }

    /// The description with the objects and values of `device`; `None` where edits cannot make it of this text.
    fn with_values(&self, device: &Device) -> Option<Self> {
        let values = configured_values(self.device(), device);
        let has_values = |index| self.locate(&Place::of(Part::CompactValues(index))).is_some();
        let mut fix = Fix { changes: changes(self.device(), &values, has_values), ..Fix::safe("configure") };
        match self.format().syntax() {
            Syntax::Ini => fix.changes.extend(eds::additions(self.device(), device)?),
            Syntax::Xml if device.objects.len() != self.device().objects.len() => return None,
            Syntax::Xml => {}
        }
        if fix.changes.is_empty() {
            return self.again(&self.source().to_bytes());
        }
        let mut edits = Edits::new(self.source());
        for (span, text) in self.edits(&fix)? {
            edits.replace(span, text);
        }
        self.again(&edits.to_bytes().ok()?)
    }

    /// The same file with other bytes.
    fn again(&self, bytes: &[u8]) -> Option<Self> {
        let source = self.source();
        let mut options = SourceOptions::default();
        (options.encoding, options.max_size) = (Some(source.encoding()), u64::MAX);
        let source = SourceFile::from_bytes(source.name(), bytes.to_vec(), &options).ok()?;
        super::read(source, self.format()).select(self.number())
    }
}

/// The values that entries of `before` have in `after`, where they are configured otherwise.
fn configured_values(before: &Device, after: &Device) -> Vec<Assignment> {
    let mut values = Vec::new();
    for (&index, object) in &after.objects {
        let Some(old) = before.object(index) else { continue };
        for (sub, entry) in object.entries() {
            let Some(value) = entry.configured_value() else { continue };
            let is_new = old.entry(sub).is_some_and(|old| old.configured_value() != Some(value));
            if is_new {
                values.push(Assignment { index, sub, value: value.clone() });
            }
        }
    }
    values
}
