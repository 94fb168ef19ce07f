//! Configures a description for a node, by edits of its text if possible.

use super::input::DEFAULT_MAX_ENTRIES;
use super::{Description, Format, Syntax, WriteOptions, embedded};
use crate::compare::Datum;
use objdict_eds::eds;
use objdict_model::diagnostic::{Change, Fix};
use objdict_model::literal::{self, Spelling};
use objdict_model::model::{
    Assignment, Commissioning, Device, DeviceKind, ExplicitDownload, Field, Part, Place,
};
use objdict_model::source::{EditError, Edits};

/// The configuration of a node.
#[derive(Clone, Copy, Debug)]
pub struct NodeSettings<'a> {
    /// The commissioning of the node.
    pub node: &'a Commissioning,
    /// The dictionary with the connected modules ([`objdict_node::coupler::flatten`]); `None` uses the description's.
    pub plugged: Option<&'a Device>,
    /// The values ([`objdict_node::configure::configure`]).
    pub assignments: &'a [Assignment],
    /// The explicit downloads ([`objdict_node::configure::configuration`]), which replace those of the description;
    /// empty keeps them.
    pub downloads: &'a [ExplicitDownload],
}

/// A description that was configured.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct ConfiguredFile {
    /// The bytes of the file.
    pub bytes: Vec<u8>,
    /// The device that they describe.
    pub device: Device,
    /// Whether the text was edited, so that comments, order and spelling are kept; otherwise it is new.
    pub is_edited: bool,
}

impl Description {
    /// Converts this description to that of a node with the values, in a file called `file_name`: an EDS
    /// becomes a DCF, an XDD an XDC.
    ///
    /// # Errors
    /// If the text cannot be written in the encoding of the file, or is not valid.
    pub fn configured(
        &self,
        file_name: &str,
        settings: &NodeSettings<'_>,
    ) -> Result<ConfiguredFile, EditError> {
        if let Some(realised) = self.realised()? {
            return realised.configured(file_name, settings);
        }
        let mut device = settings.plugged.unwrap_or(self.device()).clone();
        device.assign(settings.assignments);
        if !settings.downloads.is_empty() {
            device.downloads = settings.downloads.to_vec();
        }
        device.kind = DeviceKind::Node;
        device.commissioning = Some(settings.node.clone());
        if let Some(info) = &mut device.file_info {
            info.file_name = Some(file_name.to_owned());
        }
        let edited = self.with_values(&device);
        let edited =
            edited.filter(|edited| edited.is_as_valid_as(self) && has_values_of(edited.device(), &device));
        let edited = edited.map(|description| description.to_node(file_name, settings.node));
        if let Some(bytes) = edited.transpose()? {
            return Ok(ConfiguredFile { bytes, device, is_edited: true });
        }
        let format = Format::of(self.format().syntax(), DeviceKind::Node);
        let max_losses = WriteOptions::max_losses_of(self.source().text().len(), DEFAULT_MAX_ENTRIES);
        let options = WriteOptions { embed: true, max_losses, ..WriteOptions::default() };
        let bytes = super::write(&device, format, &options)?.bytes;
        Ok(ConfiguredFile { bytes, device, is_edited: false })
    }

    /// The bytes of this text with the additional objects of `device`; `None` if edits cannot add them.
    pub fn with_objects(&self, device: &Device) -> Option<Vec<u8>> {
        if let Some(realised) = self.realised().ok()? {
            return realised.with_objects(device);
        }
        if let Some(tree) = self.tree() {
            return objdict_xdd::xdd::with_objects(tree, device)?.ok();
        }
        Some(self.with_values(device)?.source().to_bytes())
    }

    /// The description with the objects and values of `device`; `None` if edits cannot produce it.
    fn with_values(&self, device: &Device) -> Option<Self> {
        let values = self.device().reconfigured(device);
        let has_values = |index| self.locate(&Place::of(Part::CompactValues(index))).is_some();
        let mut fix = Fix { changes: changes(self.device(), &values, has_values), ..Fix::safe("configure") };
        match self.format().syntax() {
            Syntax::Ini => fix.changes.extend(eds::additions(self.device(), device)?),
            Syntax::Xml if device.downloads != self.device().downloads => return None,
            Syntax::Xml if device.objects.len() != self.device().objects.len() => return None,
            Syntax::Xml | Syntax::Toml => {}
        }
        let mut edits = Edits::new(self.source());
        if !fix.changes.is_empty() {
            for (span, text) in self.edits(&fix)? {
                edits.replace(span, text);
            }
        }
        if device.downloads != self.device().downloads {
            let downloads = (!device.downloads.is_empty()).then_some(&device.downloads);
            embedded::edit_lines(
                &mut edits,
                "/downloads",
                downloads.and_then(|all| serde_json::to_value(all).ok()).map(Datum::from),
            );
        }
        if edits.is_empty() {
            return self.with_bytes(self.source().to_bytes());
        }
        self.with_bytes(edits.to_bytes().ok()?)
    }
}

/// Whether `device` has the value of each entry of `wanted`.
fn has_values_of(device: &Device, wanted: &Device) -> bool {
    wanted.objects.iter().all(|(&index, object)| {
        let read = device.object(index);
        object.entries().all(|(sub, entry)| {
            read.is_some_and(|read| read.has(sub) && read.value(sub).as_deref() == entry.value())
        })
    })
}

/// The string for a value, spelled as in `ParameterValue`.
fn text_of(assignment: &Assignment) -> String {
    let hex = is_code(assignment.index, assignment.sub);
    literal::print(&assignment.value, Spelling { hex, ..Spelling::default() })
}

/// Whether people read the number in hex: COB-IDs, mapped objects, heartbeat consumers.
const fn is_code(index: u16, sub: u8) -> bool {
    match index {
        0x1005 | 0x1012 | 0x1014 => true,
        0x1016 | 0x1028 | 0x1600..=0x17FF | 0x1A00..=0x1BFF => sub > 0,
        0x1200..=0x12FF => matches!(sub, 1 | 2),
        0x1400..=0x15FF | 0x1800..=0x19FF => sub == 1,
        _ => false,
    }
}

/// The changes that add values to a text: `ParameterValue` of each entry, and for compactly stored ones a line in the
/// section with their values, which exists if `has_values`.
fn changes(device: &Device, assignments: &[Assignment], has_values: impl Fn(u16) -> bool) -> Vec<Change> {
    let mut changes = Vec::new();
    let mut added: Vec<(u16, Vec<(Field, String)>)> = Vec::new();
    for assignment in assignments {
        let Assignment { index, sub, .. } = *assignment;
        let Some(object) = device.object(index) else { continue };
        let is_described = object.subs.get(sub).is_some();
        let is_compact = !is_described && object.compact.is_some() && sub > 0;
        if is_compact && !has_values(index) {
            let item = (Field::Item(sub.into()), text_of(assignment));
            match added.last_mut().filter(|(other, _)| *other == index) {
                Some((_, items)) => items.push(item),
                None => added.push((index, vec![item])),
            }
            continue;
        }
        let place = match is_described || is_compact {
            true => Place::entry(index, sub),
            false => Place::object(index),
        };
        changes.push(Change::Set(place.field(Field::ParameterValue), text_of(assignment)));
    }
    for (index, items) in added {
        let mut fields = vec![(Field::NrOfEntries, items.len().to_string())];
        fields.extend(items);
        changes.push(Change::Add(Part::CompactValues(index), fields));
    }
    changes
}
