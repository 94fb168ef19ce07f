//! The canonical XDD and XDC of a device without source text: both profiles, complete and in the order of
//! the CiA 311 schema. Placeholders for missing mandatory content are in `defaults`.

mod device;
mod network;
mod objects;
mod parameters;

use self::parameters::EntryParameters;
pub use self::parameters::print_value;
use super::profile_class::ProfileClass;
use super::schema::{CONTAINER, PROFILE};
use super::shape;
use super::version::XddVersion;
use super::xdd_writer::XddWriter;
use crate::model::{Device, FileInfo, InvalidValue};
use crate::xdd::shape::facts;
use crate::xml::n;

/// The canonical text of a device in a version of CiA 311, in UTF-8. A configuration for a node is included;
/// without one ([`Device::unconfigured`]) the text is an XDD.
pub fn write(device: &Device, version: XddVersion) -> String {
    let parameters = EntryParameters::of(device);
    let writer = Writer { device, parameters: &parameters };
    let mut known = None;
    loop {
        let mut out = XddWriter::new(version, known);
        out.open_container(&CONTAINER);
        writer.profile(ProfileClass::Device, &mut out);
        writer.profile(ProfileClass::Network, &mut out);
        out.close();
        match out.finish() {
            (text, None) => return text,
            // again, without the dangling references
            (_, ids) => known = ids,
        }
    }
}

/// A device during writing.
struct Writer<'a> {
    device: &'a Device,
    parameters: &'a EntryParameters,
}

impl Writer<'_> {
    fn profile(&self, class: ProfileClass, out: &mut XddWriter) {
        let headers = &self.device.headers;
        let header = class.pick(&headers.device, &headers.network);
        out.open(&PROFILE);
        shape::write(&header.clone().unwrap_or_else(|| class.unstated_header()), class.header(), out);
        out.open_body(class, class.body());
        out.attribute(n::formatName, "CANopen");
        out.attribute(n::formatVersion, "1.0");
        let file = self.file(class);
        facts::texts(&file, class.body(), true).iter().for_each(|(name, text)| out.attribute(*name, text));
        match class {
            ProfileClass::Device => self.device_body(out),
            ProfileClass::Network => self.network_body(out),
        }
        out.close_body();
        out.close();
    }

    /// The file attributes of a body.
    fn file(&self, class: ProfileClass) -> FileInfo {
        let device = self.device.file_info.clone().unwrap_or_default();
        let own = self.device.headers.network_file.as_deref().filter(|_| class == ProfileClass::Network);
        let Some(mut own) = own.cloned() else { return device };
        let unstated = FileInfo::default();
        macro_rules! complete {
            ($($field:ident)+) => {
                $(if own.$field == unstated.$field {
                    own.$field = device.$field;
                })+
            };
        }
        complete! { file_name file_version file_revision creation_time creation_date created_by modification_time modification_date
        modified_by languages }
        let is_missing = |invalid: &&InvalidValue| own.invalid_values.get(&invalid.field).is_none();
        let missing: Vec<_> = device.invalid_values.iter().filter(is_missing).cloned().collect();
        for InvalidValue { field, text, reason } in missing {
            own.invalid_values.push(field, &text, reason);
        }
        own
    }
}
