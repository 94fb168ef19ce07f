//! Networks: what they are, their links as edits, and all that is built of them.

use std::collections::BTreeMap;
use std::path::Path;
use std::rc::Rc;

use objdict::Language;
use objdict::diagnostic::Severity;
use objdict::format::network::{Build, BuiltFile, LinkEdit, NetworkFile, PathOptions, init};
use objdict::generate::{self, Target, generate};
use objdict::network::{DcfgenMode, LelyOptions, Link, LinkEnd, Overview, Timing, TimingOptions, graph};
use objdict::source::{Buffers, with_buffers};
use serde::Deserialize;
use serde_json::{Value, json};

use crate::answer::{Answer, BadRequest, data};
use crate::document::{self, EditedDocument};
use crate::files::{Files, PageFile};
use crate::outline::mappable;

/// The open files, which are read in place of a disk.
#[derive(Debug)]
pub(crate) struct OpenFiles(BTreeMap<String, Vec<u8>>);

impl OpenFiles {
    pub(crate) fn new<'d>(documents: impl Iterator<Item = &'d EditedDocument>) -> Rc<Self> {
        Rc::new(Self(documents.map(|document| (document.name().to_owned(), document.bytes())).collect()))
    }
}

impl Buffers for OpenFiles {
    /// The file of this path, else of its name: files are dropped on a page without their folders.
    fn bytes(&self, path: &Path) -> Option<Vec<u8>> {
        let name = path.file_name()?.to_str()?;
        let of_path = self.0.iter().find(|(open, _)| path.ends_with(open));
        let of_name = || {
            self.0.iter().find(|(open, _)| {
                Path::new(open)
                    .file_name()
                    .and_then(|open| open.to_str())
                    .is_some_and(|open| open.eq_ignore_ascii_case(name))
            })
        };
        of_path.or_else(of_name).map(|(_, bytes)| bytes.clone())
    }
}

/// A change of the links, with ends as the file spells them.
#[derive(Debug, Deserialize)]
#[serde(tag = "change", rename_all = "kebab-case", deny_unknown_fields)]
pub(crate) enum LinkChange {
    Add { from: String, to: String },
    Move { link: usize, end: usize, to: String },
    Remove { link: usize },
}

/// The network of a document, whose nodes are described by the other ones.
pub(crate) fn read(document: &EditedDocument, files: Rc<OpenFiles>) -> Result<NetworkFile, BadRequest> {
    if !document.is_network() {
        return Err(BadRequest::new(format_args!("`{}` is not a network", document.name())));
    }
    let source = document::source(document.name(), document.bytes())?;
    let folder = Path::new(document.name()).parent().unwrap_or(Path::new(""));
    let mut options = PathOptions { judge: Some(objdict::workspace::judge), ..PathOptions::default() };
    // what is open may be read, in whichever folder it is
    options.allowed.push(Path::new("").to_owned());
    Ok(with_buffers(files, || NetworkFile::read(source, folder, &options)))
}

/// The text of a network of the open descriptions.
pub(crate) fn start(files: Rc<OpenFiles>) -> Result<String, BadRequest> {
    let names: Vec<_> = files.0.keys().map(Into::into).collect();
    with_buffers(files, || init(&names, &PathOptions::default())).map_err(BadRequest::from)
}

/// All that a page shows of a network. Of a text that is no network there are only findings.
pub(crate) fn view(file: &NetworkFile) -> Answer {
    let report = document::network_report(file)?;
    let Ok(build) = file.build(DcfgenMode::Corrected) else { return Ok(format!("{{\"report\":{report}}}")) };
    let overview = build.overview("en");
    // without all nodes, the load and the times would be those of another network
    let has_all = file.missing.is_empty();
    let timing = build.timing(&TimingOptions::default(), Language::English).filter(|_| has_all);
    let shown = data(json!({
        "picture": graph::svg(&overview, |can_id| can_id.to_string()),
        "timing": timing.as_ref().map(timing_of),
        "sides": sides(file),
        "links": links(file),
        "missing": file.missing,
        "can_link": file.link_edits(LinkEdit::Add { from: "", to: "" }).is_some(),
    }))?;
    let rest = shown.strip_prefix('{').unwrap_or_default();
    Ok(format!("{{\"report\":{report},\"overview\":{},{rest}", data(overview)?))
}

/// What each node can send and receive.
fn sides(file: &NetworkFile) -> Value {
    let Some(network) = file.network() else { return Value::Null };
    // a link names a manager that the file does not describe without entries, and the lists have it first
    let mut nodes: Vec<_> = network.nodes.iter().enumerate().collect();
    nodes.sort_by_key(|(position, _)| !network.is_made(*position));
    let nodes = nodes.into_iter().map(|(position, node)| {
        let is_manager = network.is_made(position);
        json!({
            "node": node.name.value,
            "node_id": node.node_id.map(|id| id.value),
            "file": node.file.value,
            "is_manager": is_manager,
            "entries": if is_manager { json!([]) } else { json!(mappable(&node.device)) },
        })
    });
    nodes.collect()
}

/// The links as the text has them.
fn links(file: &NetworkFile) -> Value {
    let end = |end: &LinkEnd| {
        let entries = end.entries.as_ref().map(|entries| format!(".{entries}")).unwrap_or_default();
        format!("{}{entries}", end.node)
    };
    let row = |link: &Link| {
        let line = file.source.line_column(link.at.start).line;
        json!({ "from": end(&link.from), "to": link.to.iter().map(end).collect::<Vec<_>>(), "line": line })
    };
    file.network().into_iter().flat_map(|network| &network.links).map(row).collect()
}

/// How loaded the bus is, in thousandths of a percent, and how late messages may be, in nanoseconds.
fn timing_of(timing: &Timing) -> Value {
    let rates = timing.rates.iter().map(|row| {
        json!({ "bit_rate": row.bit_rate, "worst": row.load.worst_percent(row.bit_rate), "fits": row.fits() })
    });
    let messages = timing.messages.iter().map(|message| {
        json!({
            "can_id": message.can_id.to_string(),
            "name": message.name,
            "sender": message.sender.node,
            "period": message.period,
            "response": message.response,
            "deadline": message.deadline.as_ref().map(|(time, _)| time),
            "is_missed": message.is_missed(),
            "is_unbounded": message.is_unbounded,
        })
    });
    json!({
        "bit_rate": timing.bit_rate,
        "average": timing.load.average_percent(timing.bit_rate),
        "worst": timing.load.worst_percent(timing.bit_rate),
        "is_met": timing.is_met(&TimingOptions::default()),
        "rates": rates.collect::<Vec<_>>(),
        "messages": messages.collect::<Vec<_>>(),
    })
}

/// The bytes of the text with a link changed.
pub(crate) fn linked(file: &NetworkFile, change: &LinkChange) -> Result<Vec<u8>, BadRequest> {
    let edit = match change {
        LinkChange::Add { from, to } => LinkEdit::Add { from, to },
        LinkChange::Move { link, end, to } => LinkEdit::Move { link: *link, end: *end, to },
        LinkChange::Remove { link } => LinkEdit::Remove { link: *link },
    };
    let edits = file.link_edits(edit).ok_or_else(|| {
        BadRequest::new("the text has no place for this link").help(
            "links are tables `[[link]]` of a network.toml; change other files in the text, or make a network.toml of the descriptions",
        )
    })?;
    edits.to_bytes().map_err(BadRequest::new)
}

/// A target of `objdict network build`, by its name.
type Making = fn(&Build<'_>) -> Result<Vec<BuiltFile>, BadRequest>;

const TARGETS: [(&str, Making); 8] = [
    ("lely", |build| {
        build.lely(&LelyOptions { mode: DcfgenMode::Corrected, remote_pdos: false }).map_err(BadRequest::new)
    }),
    ("concise", |build| build.concise().map_err(BadRequest::new)),
    ("dcf", |build| build.dcfs().map_err(BadRequest::new)),
    ("manager", |build| build.manager().map(|file| vec![file]).map_err(BadRequest::new)),
    ("busyml", |build| build.bus_yml().map_err(BadRequest::new)),
    ("cpj", |build| build.node_list().map_err(BadRequest::new)),
    ("c", |build| tables(build, "c")),
    ("rust", |build| tables(build, "rust")),
];

/// The tables of the manager for its own firmware.
fn tables(build: &Build<'_>, target: &str) -> Result<Vec<BuiltFile>, BadRequest> {
    let device = build.manager_device().map_err(BadRequest::new)?;
    let target = Target::named(target).map_err(BadRequest::new)?;
    let options = generate::Options { node_id: device.node_id(), ..generate::Options::default() };
    let made = generate(&device, target, &options).map_err(BadRequest::new)?;
    Ok(made.files.into_iter().map(|file| BuiltFile { name: file.path, bytes: file.contents }).collect())
}

/// What `objdict network build` makes for each target, in a folder of its name, and the picture. A target that the network has no files
/// for is a note.
pub(crate) fn build(file: &NetworkFile) -> Files {
    let errors = file.check().iter().filter(|finding| finding.severity == Severity::Error).count();
    if errors > 0 {
        let message = format!(
            "the network has {errors} error{}, so nothing is built",
            if errors == 1 { "" } else { "s" }
        );
        return Err(BadRequest::new(message).help("correct the errors first"));
    }
    let build = file.build(DcfgenMode::Corrected).map_err(BadRequest::new)?;
    let (mut files, mut notes) = (Vec::new(), Vec::new());
    for (folder, make) in TARGETS {
        match make(&build) {
            Ok(made) => files.extend(
                made.into_iter()
                    .map(|BuiltFile { name, bytes }| PageFile { name: format!("{folder}/{name}"), bytes }),
            ),
            Err(refusal) => notes.push(format!("{folder}: {}", refusal.message)),
        }
    }
    let overview: Overview = build.overview("en");
    let picture = graph::svg(&overview, |can_id| can_id.to_string()) + "\n";
    files.push(PageFile { name: "network.svg".to_owned(), bytes: picture.into_bytes() });
    files.push(PageFile { name: "network.dot".to_owned(), bytes: graph::dot(&overview).into_bytes() });
    Ok((files, notes))
}
