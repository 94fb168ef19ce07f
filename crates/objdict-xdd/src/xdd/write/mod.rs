//! The canonical XDD and XDC of a device that has no source text: both profiles, complete as the schema of CiA 311 demands,
//! and in its order. What the standard demands and the model does not have is in [`defaults`](super::defaults).

mod attributes;
mod device;
mod network;
mod objects;
mod parameters;
mod types;

use self::parameters::EntryParameters;
use super::defaults;
use super::markup::{Body, Markup};
use super::shape::{ProfileClass, write_header};
use super::version::XddVersion;
use crate::model::{Date, Device, Field, FileInfo};

/// The canonical text of a device in a version of CiA 311, in UTF-8. What is configured for a node is written; of a device
/// without it ([`Device::unconfigured`]) the text is an XDD.
pub fn write(device: &Device, version: XddVersion) -> String {
    let device = device.expanded();
    let parameters = EntryParameters::of(&device);
    let writer = Writer { device: &device, parameters: &parameters };
    let mut out = Markup::new(version);
    out.open_container();
    writer.profile(ProfileClass::Device, &mut out);
    writer.profile(ProfileClass::Network, &mut out);
    out.close();
    out.finish()
}

/// A device being written.
struct Writer<'a> {
    device: &'a Device,
    parameters: &'a EntryParameters,
}

impl Writer<'_> {
    fn profile(&self, class: ProfileClass, out: &mut Markup) {
        let headers = &self.device.headers;
        let (header, body) = match class {
            ProfileClass::Device => (&headers.device, Body::Device),
            ProfileClass::Network => (&headers.network, Body::Network),
        };
        out.open("ISO15745Profile");
        write_header(&header.clone().unwrap_or_else(|| defaults::header(class)), class, out);
        out.open_body(body);
        self.file_attributes(class, out);
        match class {
            ProfileClass::Device => self.device_body(out),
            ProfileClass::Network => self.network_body(out),
        }
        out.close_body();
        out.close();
    }

    /// What a body says of its file.
    fn file_attributes(&self, class: ProfileClass, out: &mut Markup) {
        let unknown = FileInfo::default();
        let info = self.device.file_info.as_ref().unwrap_or(&unknown);
        let of_network = self.device.headers.network_file.as_deref();
        let network = of_network.filter(|_| class == ProfileClass::Network).unwrap_or(&unknown);
        let misfit = |field: Field| {
            let stated = network.misfits.get(&field).or_else(|| info.misfits.get(&field));
            stated.map(|misfit| misfit.text.to_string())
        };
        let text = |own: &Option<String>, shared: &Option<String>| own.clone().or_else(|| shared.clone());
        let date = |own: Option<Date>, shared: Option<Date>, field: Field| {
            own.or(shared).map(Date::to_iso).or_else(|| misfit(field))
        };
        let time =
            |own: Option<crate::model::ClockTime>, shared: Option<crate::model::ClockTime>, field: Field| {
                own.or(shared).map(|time| time.to_iso(true)).or_else(|| misfit(field))
            };
        let mut put = |name: &str, text: Option<String>| {
            if let Some(text) = text {
                out.attribute(name, &text);
            }
        };
        put("formatName", Some("CANopen".to_owned()));
        put("formatVersion", Some("1.0".to_owned()));
        let file_name = text(&network.file_name, &info.file_name);
        put("fileName", Some(file_name.unwrap_or_else(|| defaults::FILE_NAME.to_owned())));
        let creator = text(&network.created_by, &info.created_by);
        put("fileCreator", Some(creator.unwrap_or_else(|| defaults::NOT_STATED.to_owned())));
        let created = date(network.creation_date, info.creation_date, Field::CreationDate);
        put("fileCreationDate", Some(created.unwrap_or_else(|| defaults::DATE.to_iso())));
        put("fileCreationTime", time(network.creation_time, info.creation_time, Field::CreationTime));
        put("fileModifiedBy", text(&network.modified_by, &info.modified_by));
        let field = Field::ModificationDate;
        put("fileModificationDate", date(network.modification_date, info.modification_date, field));
        let field = Field::ModificationTime;
        put("fileModificationTime", time(network.modification_time, info.modification_time, field));
        put("fileVersion", Some(misfit(Field::FileVersion).unwrap_or_else(|| version(network, info))));
        let languages = if network.languages.is_empty() { &info.languages } else { &network.languages };
        put("supportedLanguages", Some(languages.join(" ")).filter(|languages| !languages.is_empty()));
        if class == ProfileClass::Device {
            let class = info.device_class.map(|class| class.name().to_owned());
            put("deviceClass", class.or_else(|| misfit(Field::Named("deviceClass".into()))));
        }
    }
}

/// `version.revision`, or the version alone.
fn version(network: &FileInfo, info: &FileInfo) -> String {
    let version = network.file_version.or(info.file_version).map(|version| version.to_string());
    let revision = network.file_revision.or(info.file_revision);
    let version = version.unwrap_or_default();
    revision.map_or(version.clone(), |revision| format!("{version}.{revision}"))
}
