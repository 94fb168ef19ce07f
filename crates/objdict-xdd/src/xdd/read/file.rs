//! The headers of the profiles, and what their bodies say of the file.

use super::{Reader, Text};
use crate::model::{ClockTime, Date, DeviceClass, Field, FileInfo, Misfits, ProfileHeader, Reason};
use crate::xdd::defaults;
use crate::xdd::layout::Profile;
use crate::xdd::leftovers::Leftovers;
use crate::xdd::shape::{ProfileClass, read_header};
use crate::xml::Element;

impl<'a> Reader<'a> {
    /// The headers of both profiles; those that would be written anyway say nothing.
    pub(super) fn headers(&mut self) {
        let header = |profile: Option<Profile<'a>>| profile.and_then(|profile| profile.header);
        let (device, network) = (header(self.layout.device), header(self.layout.network));
        self.device.headers.device = device.and_then(|element| self.header(element, ProfileClass::Device));
        self.device.headers.network = network.and_then(|element| self.header(element, ProfileClass::Network));
    }

    fn header(&mut self, element: Element<'a>, class: ProfileClass) -> Option<ProfileHeader> {
        let header = read_header(element, class, &mut self.leftovers);
        let says_nothing = header == defaults::header(class) || header == ProfileHeader::default();
        Some(header).filter(|_| !says_nothing)
    }

    /// What the bodies say of the file. Of the communication network profile only what differs is kept.
    pub(super) fn files(&mut self) {
        let mut info = |profile: Option<Profile<'a>>| {
            profile.map(|profile| file_info(profile.body, &mut self.leftovers))
        };
        let (device, network) = (info(self.layout.device), info(self.layout.network));
        match (device, network) {
            (Some(device), Some(network)) => {
                let difference = difference(network, &device);
                let says_something = difference != FileInfo::default();
                self.device.headers.network_file = Some(Box::new(difference)).filter(|_| says_something);
                self.device.file_info = Some(device);
            }
            (device, network) => self.device.file_info = device.or(network),
        }
    }
}

/// The attributes of a body about the file.
fn file_info<'a>(body: Element<'a>, leftovers: &mut Leftovers<'a>) -> FileInfo {
    let mut info = FileInfo::default();
    for attribute in body.attributes() {
        let text = Text::of(attribute);
        let stated = |nothing: &str| Some(text.trimmed()).filter(|text| *text != nothing).map(str::to_owned);
        let misfits = &mut info.misfits;
        match attribute.name() {
            "fileName" => info.file_name = stated(defaults::FILE_NAME),
            "fileCreator" => info.created_by = stated(defaults::NOT_STATED),
            "fileCreationDate" => {
                let date = date(&text, Field::CreationDate, misfits);
                info.creation_date = date.filter(|date| *date != defaults::DATE);
            }
            "fileCreationTime" => info.creation_time = time(&text, Field::CreationTime, misfits),
            "fileModifiedBy" => info.modified_by = Some(text.trimmed().to_owned()),
            "fileModificationDate" => info.modification_date = date(&text, Field::ModificationDate, misfits),
            "fileModificationTime" => info.modification_time = time(&text, Field::ModificationTime, misfits),
            "fileVersion" => version(&text, &mut info),
            "supportedLanguages" => {
                info.languages = text.text.split_ascii_whitespace().map(Into::into).collect();
            }
            "deviceClass" => {
                let field = Field::Named("deviceClass".into());
                info.device_class = text.word(field, DeviceClass::from_name, misfits);
            }
            "formatName" if text.trimmed() == "CANopen" => {}
            "formatVersion" if text.trimmed() == "1.0" => {}
            // says which profile this is
            "type" => {}
            _ => leftovers.attribute(body, attribute),
        }
    }
    info
}

fn date(text: &Text<'_>, field: Field, misfits: &mut Misfits) -> Option<Date> {
    // a time zone behind the date is allowed, and says nothing
    let plain = text.trimmed().get(..10).unwrap_or(text.trimmed());
    let date = if text.is_blank() { return None } else { Date::from_iso(plain) };
    if date.is_none() {
        text.misfit(field, Reason::NotADate, misfits);
    }
    date
}

fn time(text: &Text<'_>, field: Field, misfits: &mut Misfits) -> Option<ClockTime> {
    if text.is_blank() {
        return None;
    }
    let time = ClockTime::from_iso(text.trimmed());
    if time.is_none() {
        text.misfit(field, Reason::NotAClockTime, misfits);
    }
    time
}

/// `version.revision`, or the version alone.
fn version(text: &Text<'_>, info: &mut FileInfo) {
    let number = |text: &str| if text.is_empty() { Some(None) } else { plain_u8(text).map(Some) };
    let (version, revision) = match text.trimmed().split_once('.') {
        Some((version, revision)) => (number(version), plain_u8(revision).map(Some)),
        None => (number(text.trimmed()), Some(None)),
    };
    match (version, revision) {
        (Some(version), Some(revision)) => (info.file_version, info.file_revision) = (version, revision),
        _ => text.misfit(Field::FileVersion, Reason::NotANumber, &mut info.misfits),
    }
}

/// A number up to 255 as it is written back.
fn plain_u8(text: &str) -> Option<u8> {
    let number: u8 = text.parse().ok()?;
    (number.to_string() == text).then_some(number)
}

/// What the network profile says of the file and the device profile does not.
fn difference(network: FileInfo, device: &FileInfo) -> FileInfo {
    fn other<T: PartialEq>(network: Option<T>, device: &Option<T>) -> Option<T> {
        network.filter(|network| device.as_ref() != Some(network))
    }
    FileInfo {
        file_name: other(network.file_name, &device.file_name),
        file_version: other(network.file_version, &device.file_version),
        file_revision: other(network.file_revision, &device.file_revision),
        creation_time: other(network.creation_time, &device.creation_time),
        creation_date: other(network.creation_date, &device.creation_date),
        created_by: other(network.created_by, &device.created_by),
        modification_time: other(network.modification_time, &device.modification_time),
        modification_date: other(network.modification_date, &device.modification_date),
        modified_by: other(network.modified_by, &device.modified_by),
        languages: if network.languages == device.languages { Vec::new() } else { network.languages },
        device_class: other(network.device_class, &device.device_class),
        misfits: if network.misfits == device.misfits { Misfits::default() } else { network.misfits },
        ..FileInfo::default()
    }
}
