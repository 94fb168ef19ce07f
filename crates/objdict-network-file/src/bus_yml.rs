//! `bus.yml`: the networks of dcfgen and of ros2_canopen, which converts its files to the former.

use std::collections::BTreeMap;

use super::bus_keys::{MAPPING, MASTER, NODE, OPTIONS, PDO, SDO};
use super::rules::OVERRIDDEN_KEY;
use super::{NodeDescriptions, too_many};
use super::{boot_of, cob_id, requested_value, startup};
use objdict_keyed::rules::{MISSING_KEY, UNKNOWN_KEY, WRONG_TYPE};
use objdict_keyed::section::{KeyedTable, or_foreign, wrong};
use objdict_keyed::tree::{KeyedTree, Kind, Pair};
use objdict_keyed::yaml;
use objdict_model::diagnostic::{Diagnostic, Findings, misspelled, say};
use objdict_model::model::{Address, PdoKind};
use objdict_model::source::Span;
use objdict_network::{DownloadRequest, Heartbeat, Manager, Network, Node, PdoRequest, RequestedValue, Said};
use objdict_node::configure::PdoName;
use objdict_node::download::Order;

/// The keys of dcfgen that are not nodes.
const KEYS_OF_DCFGEN: [&str; 2] = ["options", "master"];

/// The keys of ros2_canopen that are not nodes.
const KEYS_OF_ROS: [&str; 4] = ["options", "master", "defaults", "nodes"];

/// Reads a network; `None` if the text is not YAML.
pub(super) fn read(
    text: &str,
    descriptions: &mut NodeDescriptions<'_>,
    findings: &mut Findings,
) -> Option<Network> {
    let tree = yaml::read(text, findings)?;
    let Some(entries) = tree.entries() else {
        let finding = Diagnostic::new(&WRONG_TYPE, tree.span, "the file has no keys");
        findings.push(finding.help("write `master` and the nodes, each with its keys below it"));
        return None;
    };
    let mut reader = BusReader { options: BusOptions::default(), descriptions, findings };
    if let Some(options) = tree.get("options") {
        reader.options(options);
    }
    let mut network = Network {
        run_time_folder: reader.options.folder.clone(),
        order: Order::Dcfgen,
        ..Network::default()
    };
    network.manager = match tree.get("master") {
        Some(master) => reader.manager(master, &mut network.bit_rate),
        None => {
            let finding = Diagnostic::new(&MISSING_KEY, Span::empty(0), "the network has no `master`");
            reader.findings.push(finding.help("add `master` with its `node_id`"));
            // without one, all PDOs would be reported too
            Some(Manager { name: Said::new("master".to_owned(), Span::empty(0)), ..Manager::default() })
        }
    };
    let nodes = match tree.get("nodes") {
        Some(_) => reader.ros_nodes(&tree),
        None => reader.nodes(entries),
    };
    if let Some(finding) = too_many(nodes.len(), Some(tree.span)) {
        reader.findings.push(finding);
        return None;
    }
    network.nodes = nodes.iter().filter_map(|entry| reader.node(entry)).collect();
    Some(network)
}

/// Options for all nodes.
struct BusOptions {
    folder: String,
    factor: f64,
    retry_factor: Option<Said<u8>>,
}

impl Default for BusOptions {
    fn default() -> Self {
        Self { folder: String::new(), factor: Heartbeat::DEFAULT_FACTOR, retry_factor: None }
    }
}

struct BusReader<'a, 'd> {
    options: BusOptions,
    descriptions: &'a mut NodeDescriptions<'d>,
    findings: &'a mut Findings,
}

impl BusReader<'_, '_> {
    fn options(&mut self, tree: &KeyedTree) {
        let findings = &mut *self.findings;
        let Some(section) = KeyedTable::shared("options", tree, OPTIONS, findings) else { return };
        if let Some(folder) = section.text("dcf_path", findings) {
            self.options.folder = self.descriptions.expanded(&folder.value);
        }
        if let Some(factor) = section.number("heartbeat_multiplier", findings) {
            self.options.factor = factor.value;
        }
        self.options.retry_factor = section.integer("retry_factor", findings);
    }

    fn heartbeat(&mut self, section: &KeyedTable<'_>) -> Heartbeat {
        let findings = &mut *self.findings;
        Heartbeat {
            producer: section.integer("heartbeat_producer", findings),
            factor: section
                .number("heartbeat_multiplier", findings)
                .map_or(self.options.factor, |factor| factor.value),
            consumer: section.flag("heartbeat_consumer", findings),
            watched: Vec::new(),
        }
    }

    fn manager(&mut self, tree: &KeyedTree, bit_rate: &mut Option<Said<u16>>) -> Option<Manager> {
        let section = KeyedTable::shared("master", tree, MASTER, self.findings)?;
        let heartbeat = self.heartbeat(&section);
        let error_behavior = section
            .numbers("error_behavior", self.findings)
            .into_iter()
            .map(|(sub, value)| (sub, value.value))
            .collect();
        let findings = &mut *self.findings;
        *bit_rate = section.integer("baudrate", findings);
        section.required("master", "node_id", findings);
        let number = |name: &str, findings: &mut Findings| {
            section.integer(name, findings).map_or(0, |number| number.value)
        };
        Some(Manager {
            name: Said::new("master".to_owned(), section.span()),
            node_id: section.integer("node_id", findings),
            node: None,
            is_made: false,
            identity: ["vendor_id", "product_code", "revision_number"].map(|name| number(name, findings)),
            serial_number: number("serial_number", findings),
            sync_period: section.integer("sync_period", findings).unwrap_or_default(),
            sync_window: section.integer("sync_window", findings).unwrap_or_default(),
            sync_overflow: section.integer("sync_overflow", findings).unwrap_or_default(),
            time_cob_id: section.integer("time_cob_id", findings),
            emcy_inhibit_time: section.integer("emcy_inhibit_time", findings).map_or(0, |time| time.value),
            nmt_inhibit_time: section.integer("nmt_inhibit_time", findings).map_or(0, |time| time.value),
            heartbeat,
            error_behavior,
            startup: startup(&section, "_", findings),
            boot_time: section.integer("boot_time", findings).unwrap_or_default(),
        })
    }

    /// The nodes of ros2_canopen, as dcfgen receives them: ordered by name, with the keys of `defaults`. For a
    /// file of dcfgen, all keys except two, and except those that begin with a dot.
    fn nodes(&mut self, entries: &[Pair]) -> Vec<Pair> {
        let mut nodes = Vec::new();
        for entry in entries {
            let name = entry.key.spelled();
            if KEYS_OF_DCFGEN.contains(&&*name) || name.starts_with('.') {
                continue;
            }
            // a node has a description
            let meant = misspelled(&name, KEYS_OF_DCFGEN).filter(|_| entry.value.get("dcf").is_none());
            let Some(meant) = meant else {
                nodes.push(entry.clone());
                continue;
            };
            let message = say!("`{}` is not a node, because it has no `dcf`", name);
            let finding = Diagnostic::new(&UNKNOWN_KEY, entry.key.span, message);
            self.findings.push(finding.help(say!("did you mean `{}`?", meant)));
        }
        nodes
    }

    fn ros_nodes(&mut self, tree: &KeyedTree) -> Vec<Pair> {
        for entry in tree.entries().unwrap_or_default() {
            let name = entry.key.spelled();
            if !KEYS_OF_ROS.contains(&&*name) {
                let message = say!("`{}` next to `nodes` is not a node", name);
                let finding = Diagnostic::new(&UNKNOWN_KEY, entry.key.span, message);
                let finding = or_foreign(finding, &name, KEYS_OF_ROS);
                self.findings.push(finding.help("move it below `nodes`, or correct it"));
            }
        }
        let nodes = tree.get("nodes").and_then(KeyedTree::entries);
        let Some(nodes) = nodes else {
            if let Some(nodes) = tree.get("nodes") {
                self.findings.push(
                    wrong("nodes", nodes, "a table of keys").help("write each node by its name below it"),
                );
            }
            return Vec::new();
        };
        let defaults = tree.get("defaults").and_then(KeyedTree::entries).unwrap_or_default();
        let mut nodes: Vec<Pair> = nodes.iter().map(|node| self.with_defaults(node, defaults)).collect();
        nodes.sort_by_key(|entry| entry.key.spelled());
        nodes
    }

    fn with_defaults(&mut self, node: &Pair, defaults: &[Pair]) -> Pair {
        let Some(own) = node.value.entries() else { return node.clone() };
        let mut entries: BTreeMap<String, Pair> =
            own.iter().map(|entry| (entry.key.spelled(), entry.clone())).collect();
        for default in defaults {
            let name = default.key.spelled();
            let former = entries.insert(name.clone(), default.clone());
            let Some(former) = former.filter(|former| !is_same(&former.value, &default.value)) else {
                continue;
            };
            let message = say!("`{}` of `{}` is overridden by `defaults`", name, node.key.spelled());
            self.findings.push(
                Diagnostic::new(&OVERRIDDEN_KEY, former.key.span, message)
                    .label(default.key.span, "the value that applies")
                    .help(say!("move `{}` from `defaults` to the nodes", name)),
            );
        }
        let entries =
            entries.into_values().map(|entry| Pair { value: sorted(&entry.value), ..entry }).collect();
        Pair { key: node.key.clone(), value: KeyedTree::new(node.value.span, Kind::Map(entries)) }
    }

    fn node(&mut self, entry: &Pair) -> Option<Node> {
        let name = entry.key.spelled();
        let section = KeyedTable::shared(&name, &entry.value, NODE, self.findings)?;
        let heartbeat = self.heartbeat(&section);
        let error_behavior = section.numbers("error_behavior", self.findings);
        let pdos = PdoKind::ALL.into_iter().flat_map(|kind| self.pdos(&section, kind)).collect();
        let downloads = self.downloads(&section);
        section.required(&name, "dcf", self.findings)?;
        let file = section.text("dcf", self.findings)?;
        let device = self.descriptions.read(&name, &file, self.findings)?;
        let findings = &mut *self.findings;
        let described = device.node_id().map(|node_id| Said::new(node_id, file.at));
        let mut node = Node {
            name: Said::new(name, entry.key.span),
            // a node-ID that is out of range is reported, not replaced
            node_id: match section.get("node_id") {
                Some(_) => Some(section.integer("node_id", findings)?),
                None => described,
            },
            heartbeat,
            guarding: (
                section.integer("guard_time", findings),
                section.integer("life_time_factor", findings),
            ),
            time_cob_id: section.integer("time_cob_id", findings),
            error_behavior,
            pdos,
            downloads,
            revision_number: section.integer("revision_number", findings),
            serial_number: section.integer("serial_number", findings),
            boot: boot_of(&section, "_", "restore_configuration", findings),
            run_time_folder: section
                .text("dcf_path", findings)
                .map(|folder| self.descriptions.expanded(&folder.value)),
            file,
            device,
            ..Node::default()
        };
        if let (None, Some(retry_factor)) = (section.get("retry_factor"), self.options.retry_factor) {
            node.boot.retry_factor = retry_factor;
        }
        node.boot.software_file.take_if(|file| file.is_empty());
        Some(node)
    }

    fn pdos(&mut self, section: &KeyedTable<'_>, kind: PdoKind) -> Vec<PdoRequest> {
        let name = kind.name().to_ascii_lowercase();
        let numbered = section.numbered(&name, self.findings);
        numbered.into_iter().filter_map(|(number, tree)| self.pdo(kind, number, &tree)).collect()
    }

    fn pdo(&mut self, kind: PdoKind, number: i128, tree: &Said<&KeyedTree>) -> Option<PdoRequest> {
        let pdo = PdoName { kind, number: u16::try_from(number).ok()? };
        let findings = &mut *self.findings;
        let section = KeyedTable::shared(&pdo.to_string(), tree.value, PDO, findings)?;
        let mapping = section.list("mapping", findings).map(|items| {
            items
                .iter()
                .filter_map(|item| address("mapping", item, MAPPING, findings).map(|(at, _)| at))
                .collect()
        });
        Some(PdoRequest {
            enabled: section.flag("enabled", findings).is_none_or(|enabled| enabled.value),
            cob_id: cob_id(&section, "cob_id", findings),
            transmission: section.integer("transmission", findings),
            inhibit_time: section.integer("inhibit_time", findings),
            event_timer: section.integer("event_timer", findings),
            deadline: section.integer("event_deadline", findings),
            sync_start: section.integer("sync_start", findings),
            mapping,
            ..PdoRequest::new(pdo, tree.at)
        })
    }

    fn downloads(&mut self, section: &KeyedTable<'_>) -> Vec<Said<DownloadRequest>> {
        let items = section.list("sdo", self.findings).unwrap_or_default();
        items.iter().filter_map(|item| self.download(item)).collect()
    }

    fn download(&mut self, item: &KeyedTree) -> Option<Said<DownloadRequest>> {
        let (Said { value: Address { index, sub }, .. }, section) = address("sdo", item, SDO, self.findings)?;
        let tree = section.get("value");
        let value = match tree {
            Some(tree) => requested_value(tree, self.findings)?,
            None => RequestedValue::Integer(0),
        };
        let at = tree.map_or(item.span, |tree| tree.span);
        Some(Said::new(DownloadRequest { index, sub: sub.unwrap_or(0), value }, at))
    }
}

/// The entry that an item of a list names.
fn address<'t>(
    name: &str,
    item: &'t KeyedTree,
    keys: &'static [objdict_keyed::section::Key],
    findings: &mut Findings,
) -> Option<(Said<Address>, KeyedTable<'t>)> {
    let section = KeyedTable::shared(name, item, keys, findings)?;
    section.required(name, "index", findings)?;
    let index = section.integer("index", findings)?.value;
    let sub = match section.get("sub_index") {
        Some(_) => section.integer("sub_index", findings)?.value,
        None => 0,
    };
    Some((Said::new(Address { index, sub: Some(sub) }, item.span), section))
}

/// Whether two values are equal, regardless of their positions.
fn is_same(a: &KeyedTree, b: &KeyedTree) -> bool {
    match (&*a.kind, &*b.kind) {
        (Kind::List(a), Kind::List(b)) => a.len() == b.len() && a.iter().zip(b).all(|(a, b)| is_same(a, b)),
        (Kind::Map(a), Kind::Map(b)) => {
            let has = |entry: &Pair| {
                let name = entry.key.spelled();
                b.iter().any(|other| other.key.spelled() == name && is_same(&entry.value, &other.value))
            };
            a.len() == b.len() && a.iter().all(has)
        }
        (Kind::List(_) | Kind::Map(_), _) | (_, Kind::List(_) | Kind::Map(_)) => false,
        _ => a.spelled() == b.spelled(),
    }
}

/// A map by number, ordered by its numbers, as written by ros2_canopen.
fn sorted(tree: &KeyedTree) -> KeyedTree {
    let Some(entries) = tree.entries() else { return tree.clone() };
    let mut entries = entries.to_vec();
    entries.sort_by_key(|entry| match *entry.key.kind {
        Kind::Integer(number) => number,
        _ => i128::MAX,
    });
    KeyedTree::new(tree.span, Kind::Map(entries))
}
