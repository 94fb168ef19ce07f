//! What a page asks for.

use objdict::diagnostic::Applicability;
use objdict::format::{self, Format, WriteOptions};
use objdict::lint::changes;
use objdict::model::{ClockTime, Date};
use objdict::scaffold::{FEATURES, Features, PROFILES, Wanted, scaffold};
use serde::Deserialize;
use serde_json::{Value, json};

use crate::Workbench;
use crate::answer::{Answer, Refusal, data};
use crate::document::{Document, FieldChange, TextEdit};
use crate::files::{self, Files, Made, Node};
use crate::{form, outline};

/// A request.
#[derive(Debug, Deserialize)]
#[serde(tag = "do", rename_all = "kebab-case", deny_unknown_fields)]
enum Request {
    /// Opens a file, whose bytes come beside it.
    Open {
        name: String,
    },
    /// Closes a document.
    Close {
        document: usize,
    },
    /// The text and what can be done with it.
    State {
        document: usize,
    },
    /// The text that it was opened with.
    Original {
        document: usize,
    },
    /// Objects and PDOs.
    Outline {
        document: usize,
    },
    /// An object as a form.
    Form {
        document: usize,
        index: u16,
    },
    /// The findings, with the fixes that are sound if they are asked for.
    Check {
        document: usize,
        #[serde(default)]
        fixes: bool,
    },
    /// Edits of the text.
    Edit {
        document: usize,
        edits: Vec<TextEdit>,
    },
    /// The text in another encoding.
    Encode {
        document: usize,
        encoding: String,
    },
    /// Changes of fields and entries.
    Change {
        document: usize,
        changes: Vec<FieldChange>,
    },
    /// A patch (docs/patches.md).
    Patch {
        document: usize,
        patch: String,
    },
    /// All fixes.
    FixAll {
        document: usize,
        #[serde(default)]
        r#unsafe: bool,
    },
    /// Objects as CiA 301 and the document of a profile describe them.
    AddObjects {
        document: usize,
        profile: u16,
        indexes: Vec<u16>,
    },
    /// The objects that these documents describe.
    ProfileObjects {
        document: usize,
        profile: u16,
    },
    Undo {
        document: usize,
    },
    Redo {
        document: usize,
    },
    /// The bytes of the file as it is now.
    Bytes {
        document: usize,
    },
    /// A file in the format of its name.
    Save {
        document: usize,
        name: String,
        node_id: Option<u8>,
        bit_rate: Option<u16>,
    },
    Generate {
        document: usize,
        target: String,
    },
    Docs {
        document: usize,
        form: String,
    },
    Dbc {
        document: usize,
        node_id: Option<u8>,
    },
    Concise {
        document: usize,
        node_id: Option<u8>,
        #[serde(default)]
        all: bool,
    },
    /// What changes from one document to another, and what that means.
    Compare {
        old: usize,
        new: usize,
    },
    /// The profiles of new devices.
    Profiles {},
    /// A new device, opened as an EDS.
    New(NewDevice),
}

/// What a page asks of a new device.
#[derive(Debug, Deserialize)]
struct NewDevice {
    name: String,
    profile: u16,
    vendor: String,
    vendor_id: u32,
    product: String,
    product_code: u32,
    /// Year, month and day: only the page knows it.
    date: (u16, u8, u8),
}

impl NewDevice {
    fn wanted(self) -> Wanted {
        let (year, month, day) = self.date;
        Wanted {
            profile: self.profile,
            features: Features::default(),
            file_name: self.name,
            author: self.vendor.clone(),
            vendor_name: self.vendor,
            vendor_id: self.vendor_id,
            product_name: self.product,
            product_code: self.product_code,
            revision: 0x1_0000,
            date: Date { day, month, year },
            time: ClockTime { hour: 0, minute: 0, second: 0, nanosecond: 0, utc_offset: None },
        }
    }
}

impl Workbench {
    pub(crate) fn answer(&mut self, request: &str, bytes: Vec<u8>) -> Answer {
        let request: Request = serde_json::from_str(request).map_err(Refusal::new)?;
        match request {
            Request::Open { name } => self.open(&name, bytes),
            Request::Close { document } => {
                self.documents.get_mut(document).map(Option::take);
                Ok(Value::Null)
            }
            Request::State { document } => data(self.document(document)?.state()),
            Request::Original { document } => data(self.document(document)?.original_text()?),
            Request::Outline { document } => data(outline::outline(self.document(document)?.description())),
            Request::Form { document, index } => {
                let form = form::form(self.document(document)?.description(), index);
                data(form.ok_or_else(|| Refusal::new(format_args!("the device has no object {index:04X}h")))?)
            }
            Request::Check { document, fixes } => {
                let report = self.document(document)?.report(fixes)?;
                serde_json::from_str(&report).map_err(Refusal::new)
            }
            Request::Edit { document, edits } => self.change(document, |document| document.edit(edits)),
            Request::Encode { document, encoding } => {
                self.change(document, |document| document.encode(&encoding))
            }
            Request::Change { document, changes } => {
                self.change(document, |document| document.change(&changes))
            }
            Request::Patch { document, patch } => self.change(document, |document| document.patch(&patch)),
            Request::FixAll { document, r#unsafe } => {
                let safety = if r#unsafe { Applicability::Unsafe } else { Applicability::Safe };
                self.change(document, |document| document.fix_all(safety).map(|_| ()))
            }
            Request::AddObjects { document, profile, indexes } => {
                self.change(document, |document| document.add_objects(profile, &indexes))
            }
            Request::ProfileObjects { document, profile } => {
                let device = self.document(document)?.device();
                Ok(profile_objects(profile, |index| device.objects.contains_key(&index)))
            }
            Request::Undo { document } => self.change(document, Document::undo),
            Request::Redo { document } => self.change(document, Document::redo),
            Request::Bytes { document } => {
                let document = self.document(document)?;
                let file = files::File { name: document.name().to_owned(), bytes: document.bytes() };
                self.made(Ok((vec![file], Vec::new())))
            }
            Request::Save { document, name, node_id, bit_rate } => {
                let node = Node { node_id, bit_rate };
                let made = files::save(self.document(document)?.description(), &name, node);
                self.made(made)
            }
            Request::Generate { document, target } => {
                let made = files::tables(self.document(document)?.description(), &target);
                self.made(made)
            }
            Request::Docs { document, form } => {
                let made = files::page(self.document(document)?.description(), &form);
                self.made(made)
            }
            Request::Dbc { document, node_id } => {
                let node = Node { node_id, bit_rate: None };
                let made = files::dbc(self.document(document)?.description(), node);
                self.made(made)
            }
            Request::Concise { document, node_id, all } => {
                let node = Node { node_id, bit_rate: None };
                let made = files::concise(self.document(document)?.description(), node, all);
                self.made(made)
            }
            Request::Compare { old, new } => self.compare(old, new),
            Request::Profiles {} => Ok(profiles()),
            Request::New(new) => self.start(&new.wanted()),
        }
    }

    fn open(&mut self, name: &str, bytes: Vec<u8>) -> Answer {
        let document = Document::open(name, bytes)?;
        let number = self.documents.iter().position(Option::is_none).unwrap_or(self.documents.len());
        if number == self.documents.len() {
            self.documents.push(None);
        }
        let state = data(document.state())?;
        self.documents[number] = Some(document);
        Ok(json!({ "document": number, "state": state }))
    }

    fn document(&self, number: usize) -> Result<&Document, Refusal> {
        let document = self.documents.get(number).and_then(Option::as_ref);
        document.ok_or_else(|| Refusal::new("the document is not open"))
    }

    /// Changes a document, and says what it is now.
    fn change(&mut self, number: usize, change: impl FnOnce(&mut Document) -> Result<(), Refusal>) -> Answer {
        let document = self.documents.get_mut(number).and_then(Option::as_mut);
        let document = document.ok_or_else(|| Refusal::new("the document is not open"))?;
        change(document)?;
        data(document.state())
    }

    fn made(&mut self, files: Files) -> Answer {
        let (files, notes) = files?;
        let made = Made { files: files.iter().map(|file| file.name.clone()).collect(), notes };
        self.files = files;
        data(made)
    }

    fn compare(&self, old: usize, new: usize) -> Answer {
        let (old, new) = (self.document(old)?.device(), self.document(new)?.device());
        let changes = changes::compare(old, new);
        let rows = changes.iter().map(|change| {
            let effects = change.effects().map(|effect| {
                json!({ "audience": effect.audience.name(), "verdict": effect.verdict.name(), "reason": effect.reason })
            });
            json!({
                "rule": change.rule.info.id,
                "index": change.index,
                "sub": change.sub,
                "old": change.old,
                "new": change.new,
                "message": change.message.to_string(),
                "verdict": change.verdict().name(),
                "effects": effects.collect::<Vec<_>>(),
            })
        });
        Ok(rows.collect::<Vec<_>>().into())
    }

    fn start(&mut self, wanted: &Wanted) -> Answer {
        let device = scaffold(wanted).map_err(|error| Refusal::new(&error).help(error.help()))?;
        let written = format::write(&device, Format::Eds, &WriteOptions::default()).map_err(Refusal::new)?;
        self.open(&wanted.file_name, written.bytes)
    }
}

fn profiles() -> Value {
    let rows = PROFILES.iter().map(|&(number, ..)| {
        let profile = objdict::profile::of_number(number);
        let title =
            profile.map_or_else(|| "without a profile".to_owned(), |profile| profile.title.to_string());
        let features = FEATURES.iter().filter(|feature| feature.is_of(number)).map(|feature| feature.word);
        json!({ "number": number, "title": title, "features": features.collect::<Vec<_>>() })
    });
    rows.collect::<Vec<_>>().into()
}

/// Objects of a range are listed one by one up to so many.
const MAX_RANGE: usize = 8;

fn profile_objects(profile: u16, has: impl Fn(u16) -> bool) -> Value {
    let of_profile = objdict::profile::of_number(profile);
    let documents = objdict::profile::named("301").into_iter().chain(of_profile);
    let objects = documents.flat_map(objdict::profile::Profile::objects);
    let rows = objects.flat_map(|facts| {
        (facts.first..=facts.last).take(MAX_RANGE).map(move |index| (index, facts.name, facts.object_type()))
    });
    let rows: Vec<Value> = rows
        .map(|(index, name, kind)| json!({ "index": index, "name": name, "kind": kind.name(), "has": has(index) }))
        .collect();
    rows.into()
}
