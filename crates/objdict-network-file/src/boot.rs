//! A network at power-on, as its manager and its nodes see it: from its built files.
//!
//! The manager knows only the bytes of the built files, never the network in memory, so a simulated boot tests
//! the files.

use std::borrow::Cow;
use std::path::Path;

use objdict_bus::{Configurations, Plant, PlantNode, PowerOn};

use super::rules::UNREADABLE_NODE;
use super::{Build, BuildError, BuiltFile, NetworkFile};
use objdict_format::input::{FileKind, Input, ReadError, Reading};
use objdict_model::model::{Assignment, Device, Entry, Value};
use objdict_network::{DcfgenMode, LelyOptions, Network, Node, answered};
use objdict_node::download::{ConciseDcf, Order};

/// The bit rate in kbit/s of a network that does not state one.
const BIT_RATE: u16 = 125;

const CONCISE_DCF: u16 = 0x1F22;
const NMT_STARTUP: u16 = 0x1F80;
const SOFTWARE: u16 = 0x1F56;

/// The files that boot a network.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum BootFiles {
    /// The DCFs of the nodes and the manager.
    Dcf,
    /// The files of Lely's master; the nodes are their descriptions.
    Lely,
}

/// A network ready for power-on.
#[derive(Clone, Debug)]
pub struct Installation {
    /// The network.
    pub plant: Plant,
    /// Assumptions and omitted nodes: sentences in lower case without a full stop.
    pub notes: Vec<String>,
}

/// The reason why files are not a network that can be simulated from power-on.
#[derive(Debug)]
#[non_exhaustive]
pub enum InstallError {
    /// The network cannot be built.
    Build(BuildError),
    /// A file cannot be read.
    Read(ReadError),
    /// No file describes a manager.
    NoManager,
    /// Several files describe a manager.
    Managers(String, String),
    /// A manager or a node has no node-ID.
    NoNodeId(String),
    /// The network file contains a node that cannot be read, so the network would be incomplete.
    UnreadNode {
        /// The node and the reason.
        message: String,
        /// How to fix it.
        help: Option<String>,
    },
    /// Two nodes have the same node-ID.
    NodeIds(String, String, u8),
    /// A file with downloads is malformed.
    Downloads(String, objdict_node::download::DecodeError),
}

objdict_model::error_messages! { InstallError:
    from BuildError as Build
    from ReadError as Read
{
    Self::Build(error) => "{error}";
    Self::Read(error) => "{error}";
    Self::NoManager =>
        "no file describes a manager: a device with 1F80h bit 0, or a DCF with `CANopenManager=1`";
    Self::Managers(one, other) => "`{one}` and `{other}` both describe a manager";
    Self::NoNodeId(name) => "`{name}` has no node-ID";
    Self::UnreadNode { message, .. } => "{message}";
    Self::NodeIds(one, other, node_id) => "`{one}` and `{other}` both have the node-ID {node_id}";
    Self::Downloads(name, error) => "`{name}`: {error}";
} }

impl InstallError {
    /// How to fix it, if known.
    pub fn help(&self) -> Option<String> {
        match self {
            Self::Read(error) => error.help(),
            Self::NoManager => {
                Some("build the network with `--target dcf`, `manager`, `cpj` or `lely`".to_owned())
            }
            Self::UnreadNode { help, .. } => help.clone(),
            _ => None,
        }
    }
}

impl NetworkFile {
    /// The files of Lely's master for a network in the order of dcfgen, DCFs for others.
    pub fn boot_files(&self) -> BootFiles {
        let is_dcfgen = self.network().is_some_and(|network| network.order == Order::Dcfgen);
        if is_dcfgen { BootFiles::Lely } else { BootFiles::Dcf }
    }

    /// Builds files of the network in memory and reads them.
    ///
    /// # Errors
    /// If they cannot be built, or are not a network.
    pub fn install(&self, files: BootFiles) -> Result<Installation, InstallError> {
        if let Some(unread) = self.findings.iter().find(|finding| finding.rule.id == UNREADABLE_NODE.id) {
            let help = unread.help.as_ref().map(ToString::to_string);
            return Err(InstallError::UnreadNode { message: unread.message.to_string(), help });
        }
        if let Some((_, node)) =
            self.network().into_iter().flat_map(Network::slaves).find(|(_, node)| node.node_id.is_none())
        {
            return Err(InstallError::NoNodeId(node.name.value.clone()));
        }
        let build = self.build(DcfgenMode::Corrected)?;
        install(&files.of(&build)?, Some(self))
    }
}

impl NetworkFile {
    /// The nodes of the network without its manager, as they are when they are switched on.
    pub fn plant_nodes(&self) -> Vec<PlantNode> {
        let Some(network) = self.network() else { return Vec::new() };
        let node = |node: &Node| {
            let mut plant = switched_on(network, node, node.node_id?.value);
            let identity = (1..=4).filter_map(|sub| {
                let number = answered(&plant.device, sub, plant.node_id)?;
                Some(Assignment { index: 0x1018, sub, value: Value::Unsigned(number.into()) })
            });
            let identity: Vec<Assignment> = identity.collect();
            plant.device.assign(&identity);
            Some(plant)
        };
        network.slaves().filter_map(|(_, described)| node(described)).collect()
    }

    /// The bit rate of the network in kbit/s, else 125.
    pub fn bit_rate(&self) -> u16 {
        let stated = self.network().and_then(|network| network.bit_rate.as_ref());
        stated.map(|rate| rate.value).filter(|rate| *rate != 0).unwrap_or(BIT_RATE)
    }
}

impl BootFiles {
    fn of(self, build: &Build<'_>) -> Result<Vec<BuiltFile>, BuildError> {
        match self {
            Self::Dcf => build.dcfs(),
            Self::Lely => build.lely(&LelyOptions::default()),
        }
    }
}

/// Reads the files of a network: the manager's DCF with the files that it refers to, and the DCFs of the nodes. Nodes
/// without a DCF are read from the network file.
///
/// # Errors
/// If a file cannot be read, or if none or several describe a manager.
pub fn install(files: &[BuiltFile], network: Option<&NetworkFile>) -> Result<Installation, InstallError> {
    let mut described = described(files)?;
    let manager = described.remove(manager_among(&described)?);
    let mut notes = Vec::new();
    let nodes = nodes(described, network, &manager, &mut notes)?;
    let bit_rate = bit_rate(&manager.device, network).unwrap_or_else(|| {
        notes.push(format!("no bit rate specified, so {BIT_RATE} kbit/s is used"));
        BIT_RATE
    });
    let (nodes, foreign): (Vec<_>, Vec<_>) =
        nodes.into_iter().partition(|node| own_rate(&node.device).is_none_or(|rate| rate == bit_rate));
    for node in foreign {
        let rate = own_rate(&node.device).unwrap_or_default();
        notes.push(format!(
            "`{}` is set to {rate} kbit/s, but the bus to {bit_rate}, so it is omitted",
            node.name
        ));
    }
    let manager = configured(manager, files)?;
    let nodes = nodes.into_iter().map(|node| with_identity(node, &manager.device)).collect();
    let configurations = configurations(&manager.device, files);
    Ok(Installation { plant: Plant { bit_rate, manager, configurations, nodes }, notes })
}

/// A description among the files.
pub(super) struct DescribedFile {
    /// The name of the file.
    file: String,
    pub(super) device: Device,
}

impl DescribedFile {
    fn name(&self) -> String {
        let stated = self.device.commissioning.as_ref().and_then(|node| node.node_name.clone());
        let stem = Path::new(&self.file).file_stem().unwrap_or_default();
        stated.filter(|name| !name.is_empty()).unwrap_or_else(|| stem.to_string_lossy().into_owned())
    }
}

pub(super) fn described(files: &[BuiltFile]) -> Result<Vec<DescribedFile>, ReadError> {
    let mut described = Vec::new();
    for BuiltFile { name, bytes } in files {
        let kind = FileKind::of(Path::new(name));
        if !kind.is_some_and(|kind| kind.format().is_some() || kind == FileKind::Json) {
            continue;
        }
        let device = match Reading::default().read_one(name, bytes.clone())?.1 {
            Input::Description(description) => description.device().clone(),
            Input::Device(device) => *device,
            _ => continue,
        };
        described.push(DescribedFile { file: name.clone(), device });
    }
    Ok(described)
}

pub(super) fn manager_among(described: &[DescribedFile]) -> Result<usize, InstallError> {
    let is_manager = |device: &Device| {
        let startup = device.value(NMT_STARTUP, 0).and_then(|value| value.as_integer());
        let is_stated = device.commissioning.as_ref().and_then(|node| node.manager);
        is_stated.unwrap_or_else(|| startup.is_some_and(|startup| startup & 1 == 1))
    };
    let mut managers = described.iter().enumerate().filter(|(_, described)| is_manager(&described.device));
    match (managers.next(), managers.next()) {
        (Some((at, _)), None) => Ok(at),
        (Some((_, first)), Some((_, second))) => {
            Err(InstallError::Managers(first.file.clone(), second.file.clone()))
        }
        (None, _) => Err(InstallError::NoManager),
    }
}

/// The nodes except the manager, each with its own node-ID.
fn nodes(
    described: Vec<DescribedFile>,
    network: Option<&NetworkFile>,
    manager: &DescribedFile,
    notes: &mut Vec<String>,
) -> Result<Vec<PlantNode>, InstallError> {
    let network = network.and_then(NetworkFile::network);
    let request = |node_id: u8| {
        let mut nodes = network.into_iter().flat_map(|network| &network.nodes);
        nodes.find(|node| node.node_id.is_some_and(|said| said.value == node_id))
    };
    let of_file = |described: DescribedFile| match described.device.node_id() {
        None => {
            let note = format!("`{}` has no node-ID, so it is omitted", described.file);
            Err(note)
        }
        Some(node_id) => Ok(PlantNode {
            name: described.name(),
            node_id,
            power_on: PowerOn::Defaults,
            must_boot: request(node_id).map(|node| node.boot.boot),
            device: described.device,
        }),
    };
    let of_network = |network: &Network, node: &Node| {
        let must_boot = Some(node.boot.boot);
        Some(PlantNode { must_boot, ..switched_on(network, node, node.node_id?.value) })
    };
    let mut nodes: Vec<PlantNode> = Vec::new();
    for node in described.into_iter().map(of_file) {
        match node {
            Ok(node) => nodes.push(node),
            Err(note) => notes.push(note),
        }
    }
    if nodes.is_empty() {
        let described = network
            .into_iter()
            .flat_map(|network| network.slaves().filter_map(move |(_, node)| of_network(network, node)));
        nodes = described.collect();
    }
    nodes.sort_by_key(|node| node.node_id);
    let own = manager.device.node_id();
    let pairs = nodes.windows(2).filter(|pair| pair[0].node_id == pair[1].node_id);
    let mut clashes = pairs.map(|pair| (pair[0].name.clone(), pair[1].name.clone(), pair[0].node_id));
    let with_manager = nodes.iter().find(|node| Some(node.node_id) == own);
    let with_manager = with_manager.map(|node| (node.name.clone(), manager.name(), node.node_id));
    match clashes.next().or(with_manager) {
        Some((first, second, node_id)) => Err(InstallError::NodeIds(first, second, node_id)),
        None => Ok(nodes),
    }
}

/// A node of a network file, with the values that it has before the manager configures it.
pub(super) fn switched_on(network: &Network, node: &Node, node_id: u8) -> PlantNode {
    let (power_on, device) = match objdict_network::switched_on(network, node) {
        Cow::Owned(configured) => (PowerOn::Configured, configured),
        Cow::Borrowed(device) => (PowerOn::Defaults, device.clone()),
    };
    PlantNode { name: node.name.value.clone(), node_id, device, power_on, must_boot: None }
}

/// Adds an identity and a software version to a node: from its description, as in [`answered`], otherwise the
/// values that the manager expects.
fn with_identity(mut node: PlantNode, manager: &Device) -> PlantNode {
    let expected = |index: u16| {
        let number = manager.value(index, node.node_id)?.as_integer()?;
        u32::try_from(number).ok().filter(|number| *number != 0)
    };
    let device = &node.device;
    let identity = (1..=4_u8).map(|sub| {
        let number = answered(device, sub, node.node_id).or_else(|| expected(0x1F84 + u16::from(sub)));
        (0x1018, sub, number)
    });
    let software = device.value(SOFTWARE, 1).and_then(|value| value.as_integer()).filter(|own| *own != 0);
    let software = if software.is_none() { expected(0x1F55) } else { None };
    let values: Vec<Assignment> = identity
        .chain([(SOFTWARE, 1, software)])
        .filter_map(|(index, sub, number)| {
            Some(Assignment { index, sub, value: Value::Unsigned(number?.into()) })
        })
        .collect();
    node.device.assign(&values);
    node
}

/// The bit rate that a description is set to.
fn own_rate(device: &Device) -> Option<u16> {
    device.commissioning.as_ref()?.baud_rate.filter(|rate| *rate != 0)
}

fn bit_rate(manager: &Device, network: Option<&NetworkFile>) -> Option<u16> {
    let of_network = || Some(network?.network()?.bit_rate?.value);
    own_rate(manager).or_else(of_network).filter(|rate| *rate != 0)
}

/// The manager with the downloads that Lely's master applies to itself: `master.bin` next to `master.dcf`.
pub(super) fn configured(manager: DescribedFile, files: &[BuiltFile]) -> Result<PlantNode, InstallError> {
    let node_id = manager.device.node_id().ok_or_else(|| InstallError::NoNodeId(manager.file.clone()))?;
    let beside = Path::new(&manager.file).with_extension("bin");
    let own = files.iter().find(|file| Path::new(&file.name) == beside);
    let (name, mut device) = (manager.name(), manager.device);
    if let Some(own) = own {
        let downloads = ConciseDcf::parse(&own.bytes)
            .map_err(|error| InstallError::Downloads(own.name.clone(), error))?;
        take(&mut device, &downloads);
    }
    let name = if name.is_empty() { "manager".to_owned() } else { name };
    Ok(PlantNode { name, node_id, device, power_on: PowerOn::Configured, must_boot: None })
}

/// Applies the values of downloads to a device.
pub(super) fn take(device: &mut Device, downloads: &ConciseDcf) {
    for download in &downloads.0 {
        if let Some(value) = download.value(device) {
            device.assign(&[Assignment { index: download.index, sub: download.sub, value }]);
        }
    }
}

/// The concise DCFs of the nodes: from the manager, or from files that it refers to.
pub(super) fn configurations(manager: &Device, files: &[BuiltFile]) -> Configurations {
    let mut configurations = Configurations::new();
    let Some(object) = manager.object(CONCISE_DCF) else { return configurations };
    for (node_id, entry) in object.entries().filter(|(sub, _)| (1..=127).contains(sub)) {
        if let Some(stream) = stream(&entry, files) {
            let downloads = stream.and_then(|stream| {
                ConciseDcf::parse(&stream).map(|concise| concise.0).map_err(|error| error.to_string())
            });
            configurations.insert(node_id, downloads);
        }
    }
    configurations
}

/// The bytes of a concise DCF; `None` if there is none.
fn stream(entry: &Entry, files: &[BuiltFile]) -> Option<Result<Vec<u8>, String>> {
    let named = entry.configured.as_ref().and_then(|configured| configured.upload_file.as_deref());
    match (named, entry.value()) {
        (Some(path), _) => {
            let name = path.rsplit(['/', '\\']).next().unwrap_or(path);
            let file = files.iter().find(|file| file.name == name);
            Some(file.map(|file| file.bytes.clone()).ok_or_else(|| format!("`{name}` (1F22h) is missing")))
        }
        (None, Some(Value::Bytes(bytes))) if !bytes.is_empty() => Some(Ok(bytes.to_vec())),
        _ => None,
    }
}
