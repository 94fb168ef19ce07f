//! The target `zencan`: the device configuration in TOML from which the crate zencan-build 0.0.5 generates a
//! node.
//!
//! zencan creates some objects itself and handles sub-index 0 differently. So the SDO answers are computed
//! together with the output (`answers`) and compared with the description at the end; each difference becomes
//! a note.

mod answers;
mod fixed;
mod object;
mod pdo;
mod value;

use super::dictionary::TableDictionary;
use super::notes::{in_order, once_per_object};
use super::{GenerateError, Generated, Note, Options, render};
use crate::model::{CobId, Device, Place};
use answers::Answers;
use fixed::DeviceSettings;
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
    Ok(Generated { files: vec![file], notes: once_per_object(in_order(notes)) })
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
        let stores = dictionary.objects.iter().any(|object| object.index == fixed::STORE);
        Self { dictionary, options, stores, answers: Answers::default(), notes: Vec::new() }
    }

    fn config(&mut self) -> ZencanConfig {
        let dictionary = self.dictionary;
        let mut written = Vec::new();
        for object in &dictionary.objects {
            if fixed::is_made_by_zencan(object.index) {
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

    /// Notes which values are assumed to be stored.
    fn persistence(&mut self) {
        if self.stores && self.options.groups.is_empty() {
            let text = "entries that SDOs can write and PDOs cannot map are stored (`persist`), unless the description states a storage group";
            let help = "select the stored objects with `--group`; the group `RAM` is not stored";
            self.notes.push(Note::new(Place::object(fixed::STORE), text).help(help));
        }
    }
}
