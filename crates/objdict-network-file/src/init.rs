//! Creates a first `network.toml` from the descriptions of its nodes.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

use super::PathOptions;
use super::topology::{is_manager, location};
use objdict_format::input::{Input, MAX_DEVICES, ReadError, Reading};
use objdict_model::json::quoted;
use objdict_model::model::{BaudRates, Device, MappedObject, NodeList, PdoKind};
use objdict_model::source::{Folder, Span};
use objdict_network::{DcfgenMode, Network, Node, PdoState, Said, Slave, compile};

/// The maximum number of PDOs of a node listed in a comment.
const MAX_PDOS: usize = 8;

/// Creates a `network.toml` for the nodes of some descriptions: EDS, DCF, XDD, XDC, JSON, files with several devices
/// (`.nxdd`, `.nxdc`), and node lists. It contains the node-IDs, the bit rate and the manager that they state, free
/// node-IDs for the others, and comments about possible additions. Paths are kept as given.
///
/// # Errors
/// If a file cannot be read, or does not describe a device.
pub fn init(paths: &[PathBuf], options: &PathOptions) -> Result<String, ReadError> {
    let mut start = NetworkStart::default();
    for path in paths {
        start.add(path, options)?;
        let count = start.nodes.len();
        if count > MAX_DEVICES {
            return Err(ReadError::TooManyDevices { name: path.display().to_string(), count });
        }
    }
    Ok(start.text())
}

/// A name as a key and as the end of a link can have it.
pub fn node_name(name: &str) -> String {
    let is_word = |character: char| character.is_ascii_alphanumeric();
    let words = name.split(|character| !is_word(character)).filter(|word| !word.is_empty());
    let name = words.map(str::to_ascii_lowercase).collect::<Vec<_>>().join("_");
    // a key of digits would be a number
    match name.bytes().all(|byte| byte.is_ascii_digit()) {
        true if name.is_empty() => "node".to_owned(),
        true => format!("node_{name}"),
        false => name,
    }
}

/// Properties of the network.
#[derive(Default)]
struct NetworkStart {
    name: Option<String>,
    nodes: Vec<Node>,
    names: BTreeSet<String>,
}

impl NetworkStart {
    fn add(&mut self, path: &Path, options: &PathOptions) -> Result<(), ReadError> {
        let shown = path.display().to_string();
        let reading = Reading { patches: options.patches.clone(), is_node: true, ..Reading::default() };
        match reading.open(path)? {
            (_, Input::Device(device)) => self.node(shown, *device, None),
            (_, Input::Description(description)) => {
                let mut description = *description;
                let count = description.device_count();
                for device in (1..=count).map(NonZeroUsize::new) {
                    description = Reading { device, ..Reading::default() }.select(&shown, description)?;
                    let number = device.filter(|_| count > 1).map(|number| format!("#{number}"));
                    let file = shown.clone() + &number.unwrap_or_default();
                    self.node(file, description.device().clone(), None);
                }
            }
            (_, Input::NodeList(list)) => {
                self.list(&options.folder(path.parent().unwrap_or(Path::new(""))), list)?;
            }
            (kind, Input::Concise(_)) => return Err(ReadError::NoDevice { name: shown, kind }),
        }
        Ok(())
    }

    fn list(&mut self, folder: &Folder, list: NodeList) -> Result<(), ReadError> {
        for topology in list.networks {
            for listed in topology.nodes.iter().filter(|node| node.present) {
                let path = folder.resolve(&location(Some(folder), &topology, listed))?;
                let device = match Reading::default().open(&path)? {
                    (_, Input::Device(device)) => *device,
                    (_, Input::Description(description)) => description.device().clone(),
                    (kind, _) => {
                        return Err(ReadError::NoDevice { name: path.display().to_string(), kind });
                    }
                };
                self.node(path.display().to_string(), device, Some((listed.id, listed.name.clone())));
            }
            self.name = self.name.take().or(topology.name);
        }
        Ok(())
    }

    fn node(&mut self, file: String, device: Device, listed: Option<(u8, Option<String>)>) {
        let (listed_id, listed_name) = listed.unzip();
        let commissioning = device.commissioning.as_ref();
        let stated = |name: Option<&String>| name.filter(|name| !name.trim().is_empty()).cloned();
        let name = listed_name.flatten().or_else(|| stated(commissioning?.node_name.as_ref()));
        let stem = Path::new(&file).file_stem().map(|stem| stem.to_string_lossy().into_owned());
        let name = self.unused(&name.or(stem).unwrap_or_default());
        self.name = self.name.take().or_else(|| stated(commissioning?.network_name.as_ref()));
        let node_id = listed_id.or(device.node_id());
        self.nodes.push(Node {
            name: Said::new(name, Span::empty(0)),
            file: Said::new(file, Span::empty(0)),
            node_id: node_id.map(|node_id| Said::new(node_id, Span::empty(0))),
            device,
            ..Node::default()
        });
    }

    /// A unique name that is valid as a key and at the end of a link.
    fn unused(&mut self, name: &str) -> String {
        let name = node_name(name);
        let numbered = (2..).map(|number| format!("{name}_{number}"));
        let unused = std::iter::once(name.clone()).chain(numbered).find(|name| !self.names.contains(name));
        let unused = unused.unwrap_or(name);
        self.names.insert(unused.clone());
        unused
    }

    fn text(mut self) -> String {
        let assumed = self.assume_node_ids();
        let mut text = String::from("[bus]\n");
        if let Some(name) = &self.name {
            let _ = writeln!(text, "name = {}", quoted(name));
        }
        self.bit_rate(&mut text);
        match self.nodes.iter().find(|node| is_manager(node)) {
            // it monitors the nodes in its configuration
            Some(node) => {
                let _ = writeln!(
                    text,
                    "manager = {}\n\n[manager]\nwatches-nodes = false",
                    quoted(&node.name.value)
                );
            }
            None => self.possible_manager(&mut text),
        }
        let network = Network { nodes: self.nodes, ..Network::default() };
        let compiled = compile(&network, DcfgenMode::Corrected);
        for (position, node) in network.nodes.iter().enumerate() {
            let slave = compiled.slaves.iter().find(|slave| slave.node == position);
            described(&mut text, node, assumed.contains(&position), slave);
        }
        text.push_str("\n# [[link]]\n# from = \"NODE.6000:1-5\"\n# to = \"NODE.5200:1-5\"\n");
        text
    }

    /// Assigns free node-IDs to the nodes without one; returns their positions.
    fn assume_node_ids(&mut self) -> BTreeSet<usize> {
        let mut taken: BTreeSet<u8> =
            self.nodes.iter().filter_map(|node| node.node_id).map(|node_id| node_id.value).collect();
        let mut assumed = BTreeSet::new();
        for (position, node) in self.nodes.iter_mut().enumerate().filter(|(_, node)| node.node_id.is_none()) {
            let Some(free) = (1..=127).find(|node_id| !taken.contains(node_id)) else { break };
            taken.insert(free);
            assumed.insert(position);
            node.node_id = Some(Said::new(free, Span::empty(0)));
        }
        assumed
    }

    fn bit_rate(&self, text: &mut String) {
        let stated = |node: &Node| node.device.commissioning.as_ref()?.baud_rate.filter(|rate| *rate != 0);
        if let Some(rate) = self.nodes.iter().find_map(stated) {
            let _ = writeln!(text, "bit-rate = {rate}");
            return;
        }
        let is_refused = |rate: u16| {
            self.nodes.iter().any(|node| {
                node.device.device_info.as_ref().is_some_and(|info| info.baud_rates.get(rate) == Some(false))
            })
        };
        let rates = BaudRates::DEFINED.into_iter().filter(|rate| !is_refused(*rate));
        let rates: Vec<String> = rates.map(|rate| rate.to_string()).collect();
        if let Some(last) = rates.last() {
            let _ = writeln!(text, "# bit-rate = {last}  # supported by all nodes: {}", rates.join(", "));
        }
    }

    fn possible_manager(&self, text: &mut String) {
        let can_boot = |node: &&Node| node.device.object(0x1F81).is_some();
        match self.nodes.iter().find(can_boot) {
            Some(node) => {
                let _ = writeln!(text, "# manager = {}", quoted(&node.name.value));
            }
            None => text.push_str("\n# a manager without a description\n# [manager]\n# id = 127\n"),
        }
    }
}

fn described(text: &mut String, node: &Node, is_assumed: bool, slave: Option<&Slave>) {
    let _ = writeln!(text, "\n[node.{}]\nfile = {}", node.name.value, quoted(&node.file.value));
    if let Some(node_id) = node.node_id {
        let remark = if is_assumed { "  # free, the file states none" } else { "" };
        let _ = writeln!(text, "id = {}{remark}", node_id.value);
    }
    let Some(slave) = slave else { return };
    if slave.heartbeat == 0 && node.device.object(0x1017).is_some() {
        text.push_str("# heartbeat = \"1s\"\n");
    }
    let mapped = |pdo: &&PdoState| pdo.is_enabled && !pdo.mapping.is_empty();
    for kind in [PdoKind::Tpdo, PdoKind::Rpdo] {
        for state in slave.pdos.iter().filter(|state| state.pdo.kind == kind).filter(mapped).take(MAX_PDOS) {
            let _ = writeln!(text, "# {}: {}", state.pdo, entries(state.mapping.values()));
        }
    }
}

/// The entries as the end of a link has them: `6000:1-5, 6041`.
fn entries<'a>(mapped: impl Iterator<Item = &'a MappedObject>) -> String {
    let mut runs: Vec<(u16, u8, u8)> = Vec::new();
    for object in mapped.filter(|object| !object.is_dummy()) {
        match runs.last_mut() {
            Some((index, _, last)) if *index == object.index && last.checked_add(1) == Some(object.sub) => {
                *last = object.sub;
            }
            _ => runs.push((object.index, object.sub, object.sub)),
        }
    }
    let shown = runs.into_iter().map(|run| match run {
        (index, 0, 0) => format!("{index:04X}"),
        (index, first, last) if first == last => format!("{index:04X}:{first:X}"),
        (index, first, last) => format!("{index:04X}:{first:X}-{last:X}"),
    });
    shown.collect::<Vec<_>>().join(", ")
}
