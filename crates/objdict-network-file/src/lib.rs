//! Networks: `network.toml`, `bus.yml` of dcfgen and ros2_canopen, and node lists.

mod boot;
mod bus_keys;
mod bus_yml;
mod effective;
mod init;
mod link_edits;
mod lock;
mod mentions;
mod network_keys;
mod network_toml;
mod outputs;
mod places;
mod rules;
pub mod schema;
mod stored;
mod topology;
mod types;

use std::collections::BTreeMap;
use std::env;
use std::path::{Path, PathBuf};
use std::rc::Rc;
use std::sync::Arc;

pub use self::boot::{BootFiles, InstallError, Installation, install};
pub use self::init::init;
pub use self::init::node_name;
pub use self::link_edits::LinkEdit;
pub use self::lock::{read_lock, write_lock};
pub use self::mentions::NodeMention;
pub use self::outputs::{Build, BuildError, BuildObjection, BuiltFile, ConfigurationTime, ConfiguredNode};
use self::rules::UNREADABLE_NODE;
pub use self::stored::unreadable_configurations;
pub use self::topology::location;
use objdict_format as format;
use objdict_format::identify::{ContentKind, identify_source};
use objdict_format::input::{FileKind, Input, MAX_DEVICES, ReadError, Reading, SourceCheck, of_text};
use objdict_format::patch::Patch;
use objdict_format::{Description, Format};
use objdict_keyed as keyed;
use objdict_keyed::rules::WRONG_TYPE;
use objdict_keyed::section::{KeyedTable, with_cuts, wrong};
use objdict_keyed::tree::{KeyedTree, Kind};
use objdict_model::diagnostic::{At, Diagnostic, Findings, RuleInfo, Severity, say};
use objdict_model::model::Device;
use objdict_model::source::{
    Folder, FolderError, MAX_TOML_SIZE, SourceError, SourceFile, SourceOptions, Span, absolute, shown,
};
use objdict_network as network;
use objdict_network::{
    Boot, Compiled, Network, NetworkLock, RequestedCobId, RequestedValue, Resolved, Said, Startup, resolve,
};

/// What rules report of nodes whose counterpart is missing.
const FOLLOWING: [&str; 6] = [
    "network/unknown-node",
    "network/unknown-node-id",
    "network/no-heartbeat-consumer",
    "network/rpdo-without-sender",
    "network/tpdo-without-receiver",
    "network/no-sync-sender",
];

/// Whether a file may be a network by its name.
pub fn may_be_network(path: &Path) -> bool {
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
    matches!(ending.as_deref(), Some("toml" | "yml" | "yaml" | "cpj"))
}

/// The rules about networks and their files.
pub fn rules() -> impl Iterator<Item = &'static RuleInfo> {
    rules::RULES.iter().copied().chain(network::rules())
}

/// A network with its file and the descriptions of its nodes.
#[derive(Debug)]
pub struct NetworkFile {
    /// The text.
    pub source: SourceFile,
    /// Whether the text is that of no file, but what [`init`] makes of descriptions.
    pub is_made: bool,
    /// What it says; `None` if it cannot be read at all.
    resolved: Option<Resolved>,
    /// The description of each node of [`Network::nodes`], by its path in the file; a device as JSON has none.
    pub descriptions: BTreeMap<String, Rc<Description>>,
    /// The files of the descriptions.
    pub files: Vec<PathBuf>,
    /// The problems of the text and of what follows from it.
    findings: Findings,
    /// How many of them, the first ones, are about the text.
    of_text: usize,
}

impl NetworkFile {
    /// Reads a network and the descriptions of its nodes.
    ///
    /// # Errors
    /// When the file cannot be opened. Descriptions that cannot be opened are findings.
    pub fn open(path: &Path, options: &PathOptions) -> Result<Self, SourceError> {
        let source = SourceFile::open(path, &SourceOptions { encoding: None, max_size: MAX_TOML_SIZE })?;
        Ok(Self::read(source, path.parent().unwrap_or(Path::new("")), options))
    }

    /// Whether a file is read as a network: a node list, or what no other format knows.
    ///
    /// # Errors
    /// When it cannot be opened.
    pub fn is_network(path: &Path) -> Result<bool, SourceError> {
        let source = SourceFile::open(path, &SourceOptions::default())?;
        let kind = identify_source(&source).kind.file();
        Ok(kind.is_none_or(|kind| kind == FileKind::Cpj))
    }

    /// The network of the nodes that these files describe: what [`init`] makes of them.
    ///
    /// # Errors
    /// When a file cannot be read, or describes no device.
    pub fn of_descriptions(paths: &[PathBuf], options: &PathOptions) -> Result<Self, ReadError> {
        let source = SourceFile::from_text("network.toml", init(paths, options)?);
        let options =
            PathOptions { patches: options.patches.clone(), judge: options.judge, ..PathOptions::default() };
        Ok(Self::read_from(source, None, &options))
    }

    /// Reads a network from its text; paths of descriptions are relative to `folder`.
    pub fn read(source: SourceFile, folder: &Path, options: &PathOptions) -> Self {
        Self::read_from(source, Some(options.folder(folder)), options)
    }

    fn read_from(source: SourceFile, folder: Option<Folder>, options: &PathOptions) -> Self {
        let variables = &options.variables;
        let mut descriptions = NodeDescriptions {
            folder,
            variables,
            read: BTreeMap::new(),
            several: BTreeMap::new(),
            patches: &options.patches,
            judge: options.judge,
            files: Vec::new(),
        };
        let is_made = descriptions.folder.is_none();
        let mut findings = Findings::new();
        let network = match identify_source(&source).kind {
            ContentKind::NodeList => topology::read(&source, &mut descriptions, &mut findings),
            _ if keyed::toml::is_toml(source.text()) => {
                network_toml::read(source.text(), &mut descriptions, &mut findings)
            }
            _ => {
                let network = bus_yml::read(source.text(), &mut descriptions, &mut findings);
                findings = with_cuts(findings);
                network
            }
        };
        let of_text = findings.len();
        let resolved = network.map(|network| {
            let mut network = if is_made { network.as_described() } else { network };
            network.lock.clone_from(&options.lock);
            stored::read(&mut network, &mut findings);
            resolve(network, made_device, &mut findings)
        });
        let files = std::mem::take(&mut descriptions.files);
        let descriptions = descriptions
            .read
            .into_iter()
            .filter_map(|(name, read)| match read? {
                ReadDescription::Description(description) => Some((name, description)),
                ReadDescription::Device(_) => None,
            })
            .collect();
        Self { source, is_made, resolved, descriptions, files, findings, of_text }
    }

    /// What the file says, with what follows from it; `None` if it cannot be read at all.
    pub fn network(&self) -> Option<&Network> {
        self.resolved.as_ref().map(Resolved::network)
    }

    /// The configurations of the nodes.
    pub fn compiled(&self) -> Option<&Compiled> {
        self.resolved.as_ref().map(Resolved::compiled)
    }

    /// The network with the configurations of its nodes.
    pub fn into_resolved(self) -> Option<Resolved> {
        self.resolved
    }

    /// The errors of the text, with which the network is not what its author wrote: keys and values that mean nothing, descriptions that
    /// cannot be read.
    pub fn text_errors(&self) -> impl Iterator<Item = &Diagnostic> {
        self.findings.iter().take(self.of_text).filter(|finding| finding.severity == Severity::Error)
    }

    /// Whether an error of the text leaves out the manager or a node, so that others miss it.
    fn lacks_nodes(&self) -> bool {
        let has_all = self.network().is_none_or(|network| {
            let has_manager = network.manager.as_ref().is_none_or(|manager| manager.node_id.is_some());
            let has_nodes = network.nodes.iter().all(|node| node.node_id.is_some());
            has_manager && has_nodes && !network.lacks_manager
        });
        self.text_errors().any(|error| !has_all || error.rule.id == UNREADABLE_NODE.id)
    }

    /// The problems of the text and of the network that it describes, in the order of the text; errors in keys come first. What
    /// only follows from a node that the text leaves out is none.
    pub fn check(&self) -> Findings {
        let mut findings = self.findings.clone();
        if let Some(resolved) = &self.resolved {
            network::check(resolved.network(), resolved.compiled(), &mut findings);
            effective::check(resolved.network(), resolved.compiled(), &mut findings);
        }
        let lacks_nodes = self.lacks_nodes();
        let mut position = 0;
        let mut findings = findings.filter_map(|finding| {
            position += 1;
            let follows = lacks_nodes && position > self.of_text && FOLLOWING.contains(&finding.rule.id);
            (!follows).then_some(finding)
        });
        findings.sort_by_key(|finding| {
            let start = match finding.labels.first().map(|label| &label.at) {
                Some(At::Span(span)) => span.start,
                _ => 0,
            };
            (!finding.is_key_error(), start)
        });
        self.with_places(findings)
    }
}

/// The device of a description that is made.
fn made_device(text: String) -> Device {
    format::read(SourceFile::from_text("master.dcf", text), Format::Dcf).device().clone()
}

/// The finding about more nodes than a network can have: none of them is read.
fn too_many(count: usize, at: Option<Span>) -> Option<Diagnostic> {
    let message = say!("the file has {} nodes, but a network has at most {}", count, MAX_DEVICES);
    let finding = Diagnostic::new(&WRONG_TYPE, at.unwrap_or_default(), message).help("remove nodes");
    (count > MAX_DEVICES).then_some(finding)
}

/// One of the descriptions in a file, of which the first was read.
fn of_number(first: &Rc<Description>, number: usize) -> Rc<Description> {
    let other = (number != first.number()).then(|| first.sibling(number)).flatten();
    other.map_or_else(|| Rc::clone(first), Rc::new)
}

/// How the paths in a network file are read.
#[derive(Clone, Debug, Default)]
pub struct PathOptions {
    /// What replaces `@NAME@`, `$NAME` and `${NAME}`; a value that is a folder is allowed as well.
    pub variables: BTreeMap<String, String>,
    /// Folders that descriptions may be read from, beside those of [`Folder`].
    pub allowed: Vec<PathBuf>,
    /// Patches of the descriptions.
    pub patches: Vec<Arc<Patch>>,
    /// Which findings refuse a `device.toml`, if they are errors; `None` for the errors in its text.
    pub judge: Option<SourceCheck>,
    /// The PDOs of an earlier build, which keep their CAN-IDs and numbers.
    pub lock: NetworkLock,
}

impl PathOptions {
    fn folder(&self, folder: &Path) -> Folder {
        let values = self.variables.values().map(Path::new).filter(|value| value.is_dir());
        self.allowed.iter().map(PathBuf::as_path).chain(values).fold(Folder::new(folder), Folder::allow)
    }
}

/// The descriptions of nodes, each read once.
struct NodeDescriptions<'v> {
    /// The folder of the network file; `None` where the paths are those of arguments.
    folder: Option<Folder>,
    variables: &'v BTreeMap<String, String>,
    /// What was read of each path; `None` after a failure.
    read: BTreeMap<String, Option<ReadDescription>>,
    /// The files with several devices, which nodes name by their numbers.
    several: BTreeMap<PathBuf, Rc<Description>>,
    patches: &'v [Arc<Patch>],
    judge: Option<SourceCheck>,
    files: Vec<PathBuf>,
}

#[derive(Clone)]
enum ReadDescription {
    Description(Rc<Description>),
    /// Of a device as JSON.
    Device(Rc<Device>),
}

impl ReadDescription {
    fn device(&self) -> &Device {
        match self {
            Self::Description(description) => description.device(),
            Self::Device(device) => device,
        }
    }
}

impl NodeDescriptions<'_> {
    /// The device that a node is described by.
    fn read(&mut self, node: &str, file: &Said<String>, findings: &mut Findings) -> Option<Device> {
        if !self.read.contains_key(&file.value) {
            let read = self.open(&file.value);
            if let Err((reason, help)) = &read {
                let message = format!("the description of `{node}`: {reason}");
                findings.push(Diagnostic::new(&UNREADABLE_NODE, file.at, message).help(*help));
            }
            self.read.insert(file.value.clone(), read.ok());
        }
        self.read.get(&file.value)?.as_ref().map(|read| read.device().clone())
    }

    /// The error and its help, if it cannot be read.
    fn open(&mut self, file: &str) -> Result<ReadDescription, (String, &'static str)> {
        const WRONG: &str =
            "correct the path: it is relative to the network file, else to the working directory";
        let name = self.expanded(file);
        let (name, which, path) = match (self.path(&name), selected(&name)) {
            (Err(_), (path, which @ Some(_))) => (path, which, self.path(path)),
            (path, _) => (name.as_str(), None, path),
        };
        let device = which.and_then(|which| which.parse().ok());
        let variant = which.filter(|_| device.is_none()).map(str::to_owned);
        let path = path.map_err(|error| match error {
            FolderError::Unreadable(SourceError::Io { error, .. }) => {
                (format!("cannot read `{name}`: {error}"), WRONG)
            }
            error => (error.to_string(), error.help().unwrap_or(WRONG)),
        })?;
        self.files.push(path.clone());
        let (patches, judge) = (self.patches.to_vec(), self.judge.or(Some(of_text)));
        let reading = Reading { device, variant, patches, judge, is_node: true, ..Reading::default() };
        let refused = |error: ReadError| match error {
            ReadError::SeveralDevices { .. } => {
                (format!("{error}; choose one by number, as in `{name}#1`"), WRONG)
            }
            ReadError::NoSuchVariant { .. } => {
                let known = error.help().unwrap_or_default();
                (format!("{error}; {known}"), "write the number of a device, or a variant, after `#`")
            }
            ReadError::Faulty { name, .. } => {
                (format!("`{name}` has errors"), "correct them: `objdict check` shows them in its text")
            }
            // a finding has one line
            error @ ReadError::NotPatched { .. } => (
                error.to_string().replacen('\n', ": ", 1).replace('\n', "; "),
                "correct the patches: `objdict patch check` compares them with files",
            ),
            error => (error.to_string(), WRONG),
        };
        if let Some(first) = self.several.get(&path) {
            let number = reading.number(&shown(&path), first.device_count()).map_err(refused)?;
            return Ok(ReadDescription::Description(of_number(first, number)));
        }
        match reading.open(&path).map_err(refused)? {
            (_, Input::Description(first)) => {
                let count = first.device_count();
                let number = reading.number(&shown(&path), count).map_err(refused)?;
                let first = Rc::new(*first);
                if count > 1 {
                    self.several.insert(path, Rc::clone(&first));
                }
                Ok(ReadDescription::Description(of_number(&first, number)))
            }
            (_, Input::Device(device)) => Ok(ReadDescription::Device(Rc::new(*device))),
            (kind, _) => Err((format!("`{}` is a {}, not a description", shown(&path), kind.name()), WRONG)),
        }
    }

    /// A file beside that of the network, else in the working directory.
    fn path(&self, name: &str) -> Result<PathBuf, FolderError> {
        let Some(folder) = &self.folder else {
            let failed = |error| SourceError::Io { path: name.to_owned(), error };
            std::fs::metadata(name).map_err(failed)?;
            return Ok(name.into());
        };
        folder.resolve(name).or_else(|error| {
            let here = Path::new(name).is_relative().then(|| absolute(Path::new(name)));
            let here = here.filter(|here| here.to_str().is_some_and(|here| folder.resolve(here).is_ok()));
            here.map(|_| name.into()).ok_or(error)
        })
    }

    /// A text with the values of its variables; one that is not known stays as it is.
    fn expanded(&self, text: &str) -> String {
        let value = |name: &str| self.variables.get(name).cloned().or_else(|| env::var(name).ok());
        let mut expanded = String::with_capacity(text.len());
        let mut rest = text;
        while let Some(start) = rest.find(['@', '$']) {
            expanded.push_str(&rest[..start]);
            rest = &rest[start..];
            let (name, length) = variable(rest);
            match value(name).filter(|_| length > 0) {
                Some(value) => expanded.push_str(&value),
                None => expanded.push_str(&rest[..length.max(1)]),
            }
            rest = &rest[length.max(1)..];
        }
        expanded + rest
    }
}

/// A path and which device of that file: its number, counted from 1 (`plant.nxdc#2`), or the name of a variant
/// (`family.toml#io8`).
fn selected(name: &str) -> (&str, Option<&str>) {
    name.rsplit_once('#').map_or((name, None), |(path, which)| (path, Some(which)))
}

/// The name of the variable that a text begins with, and the length of both with what marks it; 0 if it is none.
fn variable(text: &str) -> (&str, usize) {
    let named = |start: usize, ending: &str| {
        let rest = text.get(start..).unwrap_or_default();
        let length = rest.bytes().take_while(|byte| byte.is_ascii_alphanumeric() || *byte == b'_').count();
        let is_complete = length > 0 && rest[length..].starts_with(ending);
        (&rest[..length], if is_complete { start + length + ending.len() } else { 0 })
    };
    match text.as_bytes() {
        [b'@', ..] => named(1, "@"),
        [b'$', b'{', ..] => named(2, "}"),
        _ => named(1, ""),
    }
}

/// The COB-ID of a PDO.
fn cob_id(section: &KeyedTable<'_>, key: &str, findings: &mut Findings) -> Option<Said<RequestedCobId>> {
    if let Some(tree) = section.get(key).filter(|tree| tree.text() == Some("auto")) {
        return Some(Said::new(RequestedCobId::Auto, tree.span));
    }
    section.integer(key, findings).map(|id| Said::new(RequestedCobId::Number(id.value), id.at))
}

/// How the manager boots a node. `between` separates the words of a key; `restore` is the key for 1F8Ah.
fn boot_of(section: &KeyedTable<'_>, between: &str, restore: &str, findings: &mut Findings) -> Boot {
    let default = Boot::default();
    let key = |words: &str| words.replace(' ', between);
    let mut flag = |words, default| section.flag(&key(words), findings).map_or(default, |flag| flag.value);
    Boot {
        boot: flag("boot", default.boot),
        mandatory: flag("mandatory", default.mandatory),
        reset_communication: flag("reset communication", default.reset_communication),
        retry_factor: section.integer(&key("retry factor"), findings).unwrap_or(default.retry_factor),
        software_file: section.text(&key("software file"), findings).map(|file| file.value),
        software_version: section.integer(&key("software version"), findings).unwrap_or_default(),
        restore_configuration: section.integer(restore, findings).unwrap_or_default(),
    }
}

/// How the manager starts. `between` separates the words of a key.
fn startup(section: &KeyedTable<'_>, between: &str, findings: &mut Findings) -> Startup {
    let mut flag = |key: &str, default| {
        section.flag(&key.replace(' ', between), findings).map_or(default, |flag| flag.value)
    };
    Startup {
        start: flag("start", true),
        start_nodes: flag("start nodes", true),
        start_all_nodes: flag("start all nodes", false),
        reset_all_nodes: flag("reset all nodes", false),
        stop_all_nodes: flag("stop all nodes", false),
    }
}

/// The value of an entry; a list, a map or nothing is a finding.
fn requested_value(tree: &KeyedTree, findings: &mut Findings) -> Option<RequestedValue> {
    Some(match &*tree.kind {
        Kind::Integer(number) => RequestedValue::Integer(*number),
        Kind::Bool(flag) => RequestedValue::Integer((*flag).into()),
        Kind::Float(number) => RequestedValue::Real(*number),
        Kind::Text(text) => RequestedValue::Text(text.clone()),
        Kind::Null | Kind::List(_) | Kind::Map(_) => {
            let finding = wrong("value", tree, "a number");
            findings.push(finding.help("write a number, or a string in quotes"));
            return None;
        }
    })
}
