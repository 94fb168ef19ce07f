//! What a page asks for.

use std::collections::BTreeMap;

use objdict::diagnostic::{Applicability, Tool};
use objdict::format::identify::{ContentKind, identify};
use objdict::format::network::NetworkFile;
use objdict::format::{self, Format, WriteOptions};
use objdict::lint::{Options, changes};
use objdict::model::{ClockTime, Date, Object};
use objdict::scaffold::{FeatureValue, Features, Wanted, scaffold};
use objdict::traffic::Descriptions;
use objdict_lsp::LanguageQuestion;
use serde::Deserialize;
use serde_json::json;

use crate::answer::{Answer, BadRequest, data};
use crate::document::{EditedDocument, FieldChange, TextEdit};
use crate::files::{self, CompactStorage, Files, Made, PageFile, RequestedNode};
use crate::log::{Filter, Log};
use crate::network::{LinkChange, OpenFiles};
use crate::{Open, Workbench, form, log, network, node, outline, profiles};

/// A request.
#[derive(Debug, Deserialize)]
#[serde(tag = "do", rename_all = "kebab-case", deny_unknown_fields)]
enum PageRequest {
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
    /// The fields of the file, of the device and of the node that it is.
    Facts {
        document: usize,
    },
    /// The entries that a configuration may set.
    Settings {
        document: usize,
    },
    /// New objects, as JSON of the model (docs/json.md).
    Insert {
        document: usize,
        objects: Vec<(u16, Object)>,
    },
    /// Objects of another document.
    Copy {
        document: usize,
        from: usize,
        indexes: Vec<u16>,
    },
    /// A question to the language server about a text: `hover` and `completion` at a position, or `tokens`.
    Language {
        document: usize,
        about: LanguageQuestion,
    },
    /// The findings, with the fixes that are sound if they are asked for.
    Check {
        document: usize,
        #[serde(default)]
        fixes: bool,
        /// Whether each place is a separate finding, as in `check --format json`; otherwise findings of one cause are joined.
        #[serde(default)]
        places: bool,
        /// The tools whose reactions count, as with `--compat`.
        #[serde(default)]
        tools: Vec<String>,
    },
    /// The tools whose reactions are known.
    Tools {},
    /// Edits of the text.
    Edit {
        document: usize,
        revision: usize,
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
    /// A patch (docs/guides/patches.md).
    Patch {
        document: usize,
        patch: String,
    },
    /// All fixes.
    FixAll {
        document: usize,
        #[serde(default)]
        r#unsafe: bool,
        #[serde(default)]
        tools: Vec<String>,
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
        /// Compact storage of an EDS or DCF that is written anew: kept, or a section for each entry.
        storage: Option<CompactStorage>,
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
    /// The modules of a coupler.
    Modules {
        document: usize,
    },
    /// A description as that of a node, opened as a DCF or XDC.
    Configure {
        document: usize,
        node: node::WantedNode,
    },
    /// Nodes, messages, links, load and findings of a network.
    Network {
        document: usize,
    },
    /// A `network.toml` of the open descriptions.
    NewNetwork {},
    /// A link of a network changed.
    Link {
        document: usize,
        link: LinkChange,
    },
    /// All files of a network.
    Build {
        document: usize,
    },
    /// The frames of a log with the descriptions of other documents.
    Decode {
        document: usize,
        with: Vec<usize>,
        /// The signals that are drawn; the first ones that change if none is named.
        #[serde(default)]
        plots: Vec<String>,
    },
    /// Some of these frames.
    Frames {
        document: usize,
        #[serde(default)]
        filter: Filter,
        #[serde(default)]
        first: usize,
        count: usize,
        line: Option<u64>,
    },
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
    /// Features by their words.
    #[serde(default)]
    features: BTreeMap<String, FeatureChoice>,
}

/// The value of a feature.
#[derive(Debug, Deserialize)]
#[serde(untagged)]
enum FeatureChoice {
    Flag(bool),
    Number(i64),
    Name(String),
    Names(Vec<String>),
}

impl NewDevice {
    fn wanted(self) -> Result<Wanted, BadRequest> {
        let (year, month, day) = self.date;
        let mut features = Features::default();
        for (word, choice) in self.features {
            let value = match choice {
                FeatureChoice::Flag(flag) => FeatureValue::Flag(flag),
                FeatureChoice::Number(number) => FeatureValue::Number(number),
                FeatureChoice::Name(name) => FeatureValue::Name(name),
                FeatureChoice::Names(names) => FeatureValue::Names(names),
            };
            features.set(&word, &value).map_err(BadRequest::new)?;
        }
        Ok(Wanted {
            profile: self.profile,
            features,
            file_name: self.name,
            author: self.vendor.clone(),
            vendor_name: self.vendor,
            vendor_id: self.vendor_id,
            product_name: self.product,
            product_code: self.product_code,
            revision: 0x1_0000,
            date: Date { day, month, year },
            time: ClockTime { hour: 0, minute: 0, second: 0, nanosecond: 0, utc_offset: None },
        })
    }
}

impl Workbench {
    pub(crate) fn answer(&mut self, request: &str, bytes: Vec<u8>) -> Answer {
        let request: PageRequest = serde_json::from_str(request).map_err(BadRequest::new)?;
        match request {
            PageRequest::Open { name } => self.open(&name, bytes),
            PageRequest::Close { document } => {
                self.documents.get_mut(document).map(Option::take);
                data(())
            }
            PageRequest::State { document } => match self.opened(document)? {
                Open::Text(text) => data(text.state()),
                Open::Log(log) => data(log.state()),
            },
            PageRequest::Original { document } => data(self.document(document)?.original_text()?),
            PageRequest::Outline { document } => {
                data(outline::outline(self.document(document)?.description()?))
            }
            PageRequest::Form { document, index } => {
                let form = form::form(self.document(document)?.description()?, index);
                data(
                    form.ok_or_else(|| {
                        BadRequest::new(format_args!("the device has no object {index:04X}h"))
                    })?,
                )
            }
            PageRequest::Facts { document } => data(form::facts(self.document(document)?.description()?)),
            PageRequest::Settings { document } => {
                data(form::settings(self.document(document)?.description()?))
            }
            PageRequest::Insert { document, objects } => {
                self.change(document, |document| document.insert(objects))
            }
            PageRequest::Copy { document, from, indexes } => {
                let objects = &self.document(from)?.device()?.objects;
                let chosen = indexes.iter().filter_map(|index| Some((*index, objects.get(index)?.clone())));
                let chosen: Vec<(u16, Object)> = chosen.collect();
                self.change(document, |document| document.insert(chosen))
            }
            PageRequest::Language { document, about } => self.language(document, &about),
            PageRequest::Check { document, fixes, places, tools } => {
                self.document(document)?.report(fixes, places, &options(&tools)?)
            }
            PageRequest::Tools {} => data(Tool::ALL.into_iter().map(Tool::name).collect::<Vec<_>>()),
            PageRequest::Edit { document, revision, edits } => {
                self.change(document, |document| document.edit(revision, edits))
            }
            PageRequest::Encode { document, encoding } => {
                self.change(document, |document| document.encode(&encoding))
            }
            PageRequest::Change { document, changes } => {
                self.change(document, |document| document.change(&changes))
            }
            PageRequest::Patch { document, patch } => {
                self.change(document, |document| document.patch(&patch))
            }
            PageRequest::FixAll { document, r#unsafe, tools } => {
                let safety = if r#unsafe { Applicability::Unsafe } else { Applicability::Safe };
                let options = options(&tools)?;
                self.change(document, |document| document.fix_all(safety, &options))
            }
            PageRequest::AddObjects { document, profile, indexes } => {
                self.change(document, |document| document.add_objects(profile, &indexes))
            }
            PageRequest::ProfileObjects { document, profile } => {
                let device = self.document(document)?.device()?;
                data(profiles::objects(profile, |index| device.objects.contains_key(&index)))
            }
            PageRequest::Undo { document } => self.change(document, EditedDocument::undo),
            PageRequest::Redo { document } => self.change(document, EditedDocument::redo),
            PageRequest::Bytes { document } => {
                let document = self.document(document)?;
                let file = files::PageFile { name: document.name().to_owned(), bytes: document.bytes() };
                self.made(Ok((vec![file], Vec::new())))
            }
            PageRequest::Save { document, name, node_id, bit_rate, storage } => {
                let document = self.document(document)?;
                let made = match document.is_network() {
                    true => Ok((vec![PageFile { name, bytes: document.bytes() }], Vec::new())),
                    false => files::save(
                        document.description()?,
                        &name,
                        RequestedNode { node_id, bit_rate },
                        storage,
                    ),
                };
                self.made(made)
            }
            PageRequest::Generate { document, target } => {
                let made = files::tables(self.document(document)?.description()?, &target);
                self.made(made)
            }
            PageRequest::Docs { document, form } => {
                let made = files::page(self.document(document)?.description()?, &form);
                self.made(made)
            }
            PageRequest::Dbc { document, node_id } => {
                let node = RequestedNode { node_id, bit_rate: None };
                let made = files::dbc(self.document(document)?.description()?, node);
                self.made(made)
            }
            PageRequest::Concise { document, node_id, all } => {
                let node = RequestedNode { node_id, bit_rate: None };
                let made = files::concise(self.document(document)?.description()?, node, all);
                self.made(made)
            }
            PageRequest::Compare { old, new } => self.compare(old, new),
            PageRequest::Profiles {} => data(profiles::list()),
            PageRequest::New(new) => self.start(&new.wanted()?),
            PageRequest::Modules { document } => data(node::modules(self.document(document)?.device()?)),
            PageRequest::Configure { document, node } => {
                let (file, notes) = node::configured(self.document(document)?.description()?, &node)?;
                let document = EditedDocument::open(&file.name, file.bytes)?;
                self.insert(Open::Text(Box::new(document)), notes)
            }
            request => self.answer_about_buses(request),
        }
    }

    /// Requests about networks and logs, which are about several documents.
    fn answer_about_buses(&mut self, request: PageRequest) -> Answer {
        match request {
            PageRequest::Network { document } => network::view(&self.network(document)?),
            PageRequest::NewNetwork {} => {
                let described = self.texts().filter(|document| !document.is_network());
                let text = network::start(OpenFiles::new(described))?;
                self.insert(
                    Open::Text(Box::new(EditedDocument::network("network.toml", text.into_bytes())?)),
                    Vec::new(),
                )
            }
            PageRequest::Link { document, link } => {
                let bytes = network::linked(&self.network(document)?, &link)?;
                self.change(document, |document| document.replace(bytes))
            }
            PageRequest::Build { document } => {
                let made = network::build(&self.network(document)?);
                self.made(made)
            }
            PageRequest::Decode { document, with, plots } => {
                let mut descriptions = Descriptions::default();
                for number in with {
                    let other = self.document(number)?;
                    match other.is_network() {
                        true => descriptions.add_network(&self.network(number)?),
                        false => log::describe(&mut descriptions, other.device()?, other.name()),
                    }
                }
                self.log(document)?.decode(&descriptions, &plots)
            }
            PageRequest::Frames { document, filter, first, count, line } => {
                data(self.log(document)?.rows(&filter, first, count, line))
            }
            _ => Err(BadRequest::new("the request is not known")),
        }
    }

    /// Answers as the language server does, with all texts that are open as its files.
    fn language(&mut self, number: usize, question: &LanguageQuestion) -> Answer {
        let name = self.document(number)?.name().to_owned();
        let texts = self.texts().map(|document| (document.name(), document.source().text()));
        let texts: Vec<(String, String)> =
            texts.map(|(name, text)| (name.to_owned(), text.to_owned())).collect();
        data(self.language.answer(&name, texts, question))
    }

    /// The texts that are open.
    fn texts(&self) -> impl Iterator<Item = &EditedDocument> {
        self.documents.iter().flatten().filter_map(|open| match open {
            Open::Text(document) => Some(&**document),
            Open::Log(_) => None,
        })
    }

    fn network(&self, number: usize) -> Result<NetworkFile, BadRequest> {
        network::read(self.document(number)?, OpenFiles::new(self.texts()))
    }

    fn log(&mut self, number: usize) -> Result<&mut Log, BadRequest> {
        match self.documents.get_mut(number).and_then(Option::as_mut) {
            Some(Open::Log(log)) => Ok(log),
            _ => Err(BadRequest::new("the document is not a log")),
        }
    }

    fn open(&mut self, name: &str, bytes: Vec<u8>) -> Answer {
        let identified = identify(name, &bytes).kind;
        // one that nothing is known of yet is read by its name, and its mistakes are findings
        let ending = name.rsplit('.').next().unwrap_or_default().to_ascii_lowercase();
        let is_called = ["toml", "yml", "yaml", "cpj"].contains(&ending.as_str());
        let is_network = identified.is_network() || identified == ContentKind::Unknown && is_called;
        let log = || (identified == ContentKind::Unknown).then(|| Log::open(name, &bytes))?;
        let opened = match (is_network, log()) {
            (true, _) => Open::Text(Box::new(EditedDocument::network(name, bytes)?)),
            (false, Some(log)) => Open::Log(Box::new(log)),
            (false, None) => Open::Text(Box::new(EditedDocument::open(name, bytes)?)),
        };
        self.insert(opened, Vec::new())
    }

    /// Keeps what was opened, and says what it is, with notes about it.
    fn insert(&mut self, opened: Open, notes: Vec<String>) -> Answer {
        let number = self.documents.iter().position(Option::is_none).unwrap_or(self.documents.len());
        if number == self.documents.len() {
            self.documents.push(None);
        }
        let state = match &opened {
            Open::Text(document) => data(document.state())?,
            Open::Log(log) => data(log.state())?,
        };
        self.documents[number] = Some(opened);
        Ok(format!("{{\"document\":{number},\"state\":{state},\"notes\":{}}}", data(notes)?))
    }

    fn opened(&self, number: usize) -> Result<&Open, BadRequest> {
        let open = self.documents.get(number).and_then(Option::as_ref);
        open.ok_or_else(|| BadRequest::new("the document is not open"))
    }

    fn document(&self, number: usize) -> Result<&EditedDocument, BadRequest> {
        match self.opened(number)? {
            Open::Text(document) => Ok(document),
            Open::Log(log) => Err(is_log(log)),
        }
    }

    /// Changes a document, and says what it is now.
    fn change(
        &mut self,
        number: usize,
        change: impl FnOnce(&mut EditedDocument) -> Result<(), BadRequest>,
    ) -> Answer {
        match self.documents.get_mut(number).and_then(Option::as_mut) {
            Some(Open::Text(document)) => {
                change(document)?;
                data(document.state())
            }
            Some(Open::Log(log)) => Err(is_log(log)),
            None => Err(BadRequest::new("the document is not open")),
        }
    }

    fn made(&mut self, files: Files) -> Answer {
        let (files, notes) = files?;
        let made = Made { files: files.iter().map(|file| file.name.clone()).collect(), notes };
        self.files = files;
        data(made)
    }

    fn compare(&self, old: usize, new: usize) -> Answer {
        let (old, new) = (self.document(old)?.device()?, self.document(new)?.device()?);
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
        data(rows.collect::<Vec<_>>())
    }

    fn start(&mut self, wanted: &Wanted) -> Answer {
        let device = scaffold(wanted).map_err(|error| BadRequest::new(&error).help(error.help()))?;
        let written =
            format::write(&device, Format::Eds, &WriteOptions::default()).map_err(BadRequest::new)?;
        self.open(&wanted.file_name, written.bytes)
    }
}

fn is_log(log: &Log) -> BadRequest {
    BadRequest::new(format_args!("`{}` is a log, which is not edited", log.name()))
}

/// What is checked with the reactions of tools.
fn options(tools: &[String]) -> Result<Options, BadRequest> {
    let tool = |name: &String| {
        Tool::named(name)
            .ok_or_else(|| BadRequest::new(format_args!("the reactions of `{name}` are not known")))
    };
    let tools = tools.iter().map(tool).collect::<Result<_, _>>()?;
    Ok(Options { tools, ..Options::default() })
}
