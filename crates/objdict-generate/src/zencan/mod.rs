//! The target `zencan`: the device configuration in TOML from which the crate zencan-build 0.0.5 generates a
//! node.
//!
//! zencan creates some objects itself and handles sub-index 0 differently. So the SDO answers are computed
//! together with the output (`answers`) and compared with the description at the end; each difference becomes
//! a note.

mod answers;
mod object;
mod pdo;
mod value;

use self::value::text_of;
use super::dictionary::TableDictionary;
use super::notes::{in_order, once_per_device};
use super::{GenerateError, Generated, Note, Options, render};
use crate::model::{Access, CobId, Device, Place};
use crate::resolve::Encoded;
use answers::{Answers, EntryAnswer, Held};
use object::{ObjectContent, ZencanObjectView};
use pdo::ZencanPdo;

pub(super) fn make(device: &Device, options: &Options) -> Result<Generated, GenerateError> {
    // a DOMAIN needs no capacity and no note about it: the application provides it
    let room = Options { domain_capacity: 1, ..options.clone() };
    let dictionary = TableDictionary::new(device, &room)?;
    let mut maker = ConfigMaker::new(&dictionary, &room);
    let config = maker.config();
    let mut notes = std::mem::take(&mut maker.notes);
    notes.extend(maker.answers.differences(&dictionary));
    notes.extend(dictionary.notes.iter().cloned());
    let file = render(format!("{}.toml", options.file_stem), config.text());
    Ok(Generated { files: vec![file], notes: once_per_device(in_order(notes)) })
}

/// The file.
struct ZencanConfig {
    made_by: String,
    settings: DeviceSettings,
    stores: bool,
    /// The numbers of RPDOs and TPDOs.
    counts: [u16; 2],
    pdos: Vec<ZencanPdo>,
    objects: Vec<ZencanObjectView>,
}

include!("../../expanded/zencan/device.toml.rs");

/// Builds a configuration, the SDO answers of zencan, and notes.
struct ConfigMaker<'a> {
    dictionary: &'a TableDictionary<'a>,
    options: &'a Options,
    /// Whether the device can store its values.
    stores: bool,
    answers: Answers,
    notes: Vec<Note>,
}

impl<'a> ConfigMaker<'a> {
    fn new(dictionary: &'a TableDictionary<'a>, options: &'a Options) -> Self {
        let stores = dictionary.objects.iter().any(|object| object.index == STORE);
        Self { dictionary, options, stores, answers: Answers::default(), notes: Vec::new() }
    }

    fn config(&mut self) -> ZencanConfig {
        let dictionary = self.dictionary;
        let mut written = Vec::new();
        for object in &dictionary.objects {
            if is_made_by_zencan(object.index) {
                continue;
            }
            if answers::is_reserved(object.index) {
                self.note(Place::object(object.index), "zencan reserves the index; the object is omitted");
                continue;
            }
            if (0x1000..=0x1FFF).contains(&object.index) {
                let text = "a plain value: zencan does not support the service of the object";
                self.note(Place::object(object.index), text);
            }
            written.push(self.object(object));
        }
        let settings = self.settings();
        let (counts, pdos) = self.pdos();
        self.persistence();
        ZencanConfig {
            made_by: self.options.made_by(),
            settings,
            stores: self.stores,
            counts,
            pdos,
            objects: written,
        }
    }

    fn note(&mut self, place: impl Into<Place>, text: impl Into<String>) {
        self.notes.push(Note::new(place, text));
    }

    /// Notes values that are assumed to be stored.
    fn persistence(&mut self) {
        if self.stores && self.options.groups.is_empty() {
            let text = "entries that SDOs can write and PDOs cannot map are stored (`persist`), unless the description states a storage group";
            let help = "select the stored objects with `--group`; the group `RAM` is not stored";
            self.notes.push(Note::new(Place::object(STORE), text).help(help));
        }
    }
}

/// The settings of the device.
struct DeviceSettings {
    /// The device name, and the hardware and software versions.
    texts: [String; 3],
    /// In milliseconds.
    heartbeat_period: u64,
    /// Vendor-ID, product code and revision number.
    identity: [u64; 3],
}

/// The index of the object that stores values.
const STORE: u16 = 0x1010;

/// Whether zencan creates the object from a setting.
fn is_made_by_zencan(index: u16) -> bool {
    matches!(index, 0x1000 | 0x1001 | 0x1008..=0x100A | STORE | 0x1017 | 0x1018 | 0x1400..=0x1BFF)
}

impl ConfigMaker<'_> {
    /// The settings of the device; records the objects that zencan creates from them.
    fn settings(&mut self) -> DeviceSettings {
        self.number(0x1000, 0, 4, 0); // zencan does not support a device type
        self.number(0x1001, 0, 1, 0);
        let [device_name, hardware_version, software_version] =
            [0x1008, 0x1009, 0x100A].map(|index| self.name(index));
        let device_name = device_name.unwrap_or_else(|| self.product_name());
        let texts = [device_name, hardware_version.unwrap_or_default(), software_version.unwrap_or_default()];
        for (index, text) in (0x1008..).zip(&texts) {
            let held = Held::Bytes(text.as_bytes().to_vec());
            self.answers.put(
                index,
                0,
                EntryAnswer { held, ..EntryAnswer::number(Access::Const, text.len(), 0) },
            );
        }
        let heartbeat_period = self.described(0x1017, 0, u64::from(u16::MAX));
        self.number(0x1017, 0, 2, heartbeat_period);
        let identity = [1, 2, 3].map(|sub| self.described(0x1018, sub, u64::from(u32::MAX)));
        for (sub, number) in (1..).zip(identity.into_iter().chain([0])) {
            self.number(0x1018, sub, 4, number); // the application sets the serial number
        }
        self.number(0x1018, 0, 1, 4);
        if self.stores {
            self.number(STORE, 0, 1, 1);
            self.note(Place::entry(STORE, 0), "zencan 0.0.5 aborts the upload of the entry");
            let answer = EntryAnswer { held: Held::Served, ..EntryAnswer::number(Access::Rw, 4, 0) };
            self.answers.put(STORE, 1, answer);
        }
        DeviceSettings { texts, heartbeat_period, identity }
    }

    fn number(&mut self, index: u16, sub: u8, size: usize, number: u64) {
        self.answers.put(index, sub, EntryAnswer::number(Access::Const, size, number));
    }

    /// The default of an entry.
    fn datum(&self, index: u16, sub: u8) -> Option<&Encoded> {
        Some(&self.dictionary.entry(index, sub)?.resolved.default)
    }

    /// The number of an entry; 0 if it is missing or too large.
    fn described(&self, index: u16, sub: u8, most: u64) -> u64 {
        match self.datum(index, sub) {
            Some(Encoded::Word(number)) if *number <= most => *number,
            _ => 0,
        }
    }

    /// The string of an object; `None` without the object, empty if it is not a string.
    fn name(&self, index: u16) -> Option<String> {
        match self.datum(index, 0)? {
            Encoded::Bytes(bytes) => {
                Some(text_of(bytes).filter(|text| !text.contains('\0')).unwrap_or_default())
            }
            Encoded::Word(_) | Encoded::Formula(_) => Some(String::new()),
        }
    }

    fn product_name(&self) -> String {
        let info = self.dictionary.device.device_info.as_ref();
        let name = info.and_then(|info| info.product_name.clone()).unwrap_or_default();
        name.replace('\0', "")
    }
}
