//! `network.toml`: networks in the format of objdict.

use super::network_keys::{BUS, LINK, MANAGER, NETWORK, NODE, PDO, SDO};
use super::rules::UNREADABLE_NODE;
use super::types::with_type;
use super::{NodeDescriptions, too_many};
use super::{boot_of, cob_id, requested_value, startup};
use objdict_keyed::notation::NO_TRANSMISSION;
use objdict_keyed::rules::{MISSING_KEY, WRONG_TYPE};
use objdict_keyed::section::{self, KeyedTable, integer, wrong};
use objdict_keyed::toml;
use objdict_keyed::tree::{KeyedTree, Kind, Pair};
use objdict_model::diagnostic::{Diagnostic, Findings, Text, say};
use objdict_model::model::{Address, Device, PdoKind};
use objdict_model::source::Span;
use objdict_network::{
    DownloadRequest, Heartbeat, IdentityLevel, Link, LinkEnd, LinkParameters, LinkedEntries, Manager,
    Network, Node, PdoRequest, Said, UnusedPdos, Watch, WatchTime, named_manager,
};
use objdict_node::configure::{PdoName, Setting, nanoseconds, transmission_type};
use objdict_node::coupler::flatten;

/// Reads a network; `None` if the text is not TOML.
pub(super) fn read(
    text: &str,
    descriptions: &mut NodeDescriptions<'_>,
    findings: &mut Findings,
) -> Option<Network> {
    let tree = toml::read(text, findings)?;
    let section = KeyedTable::new("the network", &tree, NETWORK, findings)?;
    let mut reader = NetworkReader { descriptions, findings };
    let nodes = reader.nodes(&section)?;
    let mut network = Network { nodes, links: reader.links(&section), ..Network::default() };
    reader.bus(&section, &mut network);
    section::check("the network", &tree, NETWORK, findings);
    Some(network)
}

struct NetworkReader<'a, 'd> {
    descriptions: &'a mut NodeDescriptions<'d>,
    findings: &'a mut Findings,
}

impl NetworkReader<'_, '_> {
    /// `[bus]` and `[manager]`.
    fn bus(&mut self, root: &KeyedTable<'_>, network: &mut Network) {
        let empty = KeyedTree::new(Span::empty(0), Kind::Map(Vec::new()));
        let bus = root.get("bus").unwrap_or(&empty);
        let Some(bus) = KeyedTable::new("bus", bus, BUS, self.findings) else { return };
        let findings = &mut *self.findings;
        network.name = bus.text("name", findings).map(|name| name.value);
        network.bit_rate = bus.integer("bit-rate", findings);
        network.identity = identity(&bus, findings);
        network.unused_pdos = unused_pdos(&bus, findings);
        network.run_time_folder = self.folder(&bus).unwrap_or_default();
        let named = bus.text("manager", self.findings);
        let settings = root.get("manager");
        let has_id = settings.is_some_and(|settings| settings.get("id").is_some());
        let node = match &named {
            // a node with an unreadable description has its own finding
            Some(named) if is_unread(root, &network.nodes, &named.value) => None,
            Some(named) => named_manager(named, has_id, &network.nodes, self.findings),
            None => {
                if let Some(settings) = settings.filter(|_| !has_id) {
                    let start = Span::empty(settings.span.start);
                    let finding = Diagnostic::new(&MISSING_KEY, start, "`manager` has no key `id`");
                    self.findings.push(finding.help("add `id`, or name a node as `manager` of `bus`"));
                }
                None
            }
        };
        let mut manager = match (settings, node) {
            (Some(settings), _) => self.manager(settings, node.map(|at| &network.nodes[at])),
            (None, Some(at)) => self.manager(&empty, Some(&network.nodes[at])),
            (None, None) => None,
        };
        if let Some(manager) = &mut manager {
            manager.node = node;
            if let Some(named) = &named {
                manager.name.clone_from(named);
            }
        }
        network.lacks_manager = manager.is_none() && (settings.is_some() || named.is_some());
        self.sync(&bus, manager.as_mut(), network.lacks_manager);
        network.manager = manager;
    }

    fn folder(&mut self, section: &KeyedTable<'_>) -> Option<String> {
        let folder = section.text("run-time-folder", self.findings)?;
        Some(self.descriptions.expanded(&folder.value))
    }

    fn sync(&mut self, bus: &KeyedTable<'_>, manager: Option<&mut Manager>, lacks_manager: bool) {
        let findings = &mut *self.findings;
        let period = bus.time("sync", findings);
        let window = bus.time("sync-window", findings);
        let overflow = bus.integer("sync-overflow", findings);
        match (manager, period) {
            (Some(manager), period) => {
                manager.sync_period = period.unwrap_or_default();
                manager.sync_window = window.unwrap_or_default();
                manager.sync_overflow = overflow.unwrap_or_default();
            }
            // an unreadable manager has its own finding
            (None, Some(period)) if !lacks_manager => {
                let finding =
                    Diagnostic::new(&MISSING_KEY, period.at, "`sync` needs a manager, which sends it");
                findings.push(finding.help("add `manager` with the name of a node"));
            }
            (None, _) => {}
        }
    }

    /// The manager; properties missing in its table are taken from its description.
    fn manager(&mut self, tree: &KeyedTree, node: Option<&Node>) -> Option<Manager> {
        let section = KeyedTable::new("manager", tree, MANAGER, self.findings)?;
        let mut heartbeat = self.heartbeat(&section, "watches-nodes");
        if let Some(node) = node {
            heartbeat.producer = heartbeat.producer.or(node.heartbeat.producer);
            heartbeat.watched.clone_from(&node.heartbeat.watched);
        }
        let error_behavior = section.numbers("error-behavior", self.findings);
        let error_behavior = error_behavior.into_iter().map(|(sub, value)| (sub, value.value)).collect();
        let findings = &mut *self.findings;
        let identity = node.map(|node| node.device.identity()).unwrap_or_default();
        let number = |name: &str, described: Option<u32>, findings: &mut Findings| {
            section.integer(name, findings).map(|number| number.value).or(described).unwrap_or(0)
        };
        Some(Manager {
            name: Said::new("manager".to_owned(), section.span()),
            node_id: section.integer("id", findings).or(node.and_then(|node| node.node_id)),
            node: None,
            identity: [
                number("vendor-id", identity.vendor_id, findings),
                number("product-code", identity.product_code, findings),
                number("revision-number", identity.revision_number, findings),
            ],
            serial_number: number("serial-number", identity.serial_number, findings),
            time_cob_id: section.integer("time-cob-id", findings),
            emcy_inhibit_time: section.time("emcy-inhibit", findings).map_or(0, |time| time.value),
            nmt_inhibit_time: section.time("nmt-inhibit", findings).map_or(0, |time| time.value),
            heartbeat,
            error_behavior,
            startup: startup(&section, "-", findings),
            boot_time: section.time("boot-time", findings).unwrap_or_default(),
            ..Manager::default()
        })
    }

    fn heartbeat(&mut self, section: &KeyedTable<'_>, consumer: &str) -> Heartbeat {
        let factor =
            section.parsed("watch", factor, ["a factor", "write a factor, as in `1.5x`"], self.findings);
        Heartbeat {
            producer: section.time("heartbeat", self.findings),
            factor: factor.map_or(Heartbeat::DEFAULT_FACTOR, |factor| factor.value),
            consumer: section.flag(consumer, self.findings),
            watched: Vec::new(),
        }
    }

    fn watched(&mut self, section: &KeyedTable<'_>) -> Vec<Said<Watch>> {
        let mut watched = Vec::new();
        for Pair { key, value } in section.named("watches", self.findings) {
            let text = value.spelled();
            let milliseconds = || {
                let time = nanoseconds(&text).filter(|time| time.is_multiple_of(1_000_000))?;
                u16::try_from(time / 1_000_000).ok().map(WatchTime::Milliseconds)
            };
            match factor(&text).map(WatchTime::Times).or_else(milliseconds) {
                Some(time) => watched.push(Said::new(Watch { node: key.spelled(), time }, value.span)),
                None => self.ill_typed(
                    value.span,
                    &say!("`{}` is `{}`, neither a factor nor a time", key.spelled(), text),
                    "write a factor or a time, as in `1.5x` or `500ms`",
                ),
            }
        }
        watched
    }

    fn ill_typed(&mut self, at: Span, message: &Text, help: &'static str) {
        self.findings.push(Diagnostic::new(&WRONG_TYPE, at, message.clone()).help(help));
    }

    /// The nodes; `None` if there are too many.
    fn nodes(&mut self, root: &KeyedTable<'_>) -> Option<Vec<Node>> {
        let types = root.named("type", self.findings);
        for kind in types {
            let name = format!("type {}", kind.key.spelled());
            let Some(section) = KeyedTable::new(&name, &kind.value, NODE, self.findings) else { continue };
            // types that no node uses are also checked
            self.heartbeat(&section, "watches-manager");
            self.watched(&section);
            self.downloads(&section);
            PdoKind::ALL.into_iter().for_each(|kind| drop(self.pdos(&section, kind)));
        }
        let nodes = root.named("node", self.findings);
        if let Some(finding) = too_many(nodes.len(), nodes.last().map(|entry| entry.key.span)) {
            self.findings.push(finding);
            return None;
        }
        Some(nodes.iter().filter_map(|entry| self.node_with_type(entry, types)).collect())
    }

    /// A node; problems of its type are reported for the first node that uses it.
    fn node_with_type(&mut self, entry: &Pair, types: &[Pair]) -> Option<Node> {
        let mut found = Findings::new();
        let entry = with_type(entry, types, &mut found);
        let node = NetworkReader { descriptions: &mut *self.descriptions, findings: &mut found }.node(&entry);
        for finding in found.into_vec() {
            let is_same = |other: &Diagnostic| {
                (other.rule.id, &other.labels, other.message.shown())
                    == (finding.rule.id, &finding.labels, finding.message.shown())
            };
            if !self.findings.iter().any(is_same) {
                self.findings.push(finding);
            }
        }
        node
    }

    fn node(&mut self, entry: &Pair) -> Option<Node> {
        let name = entry.key.spelled();
        let section = KeyedTable::new(&name, &entry.value, NODE, self.findings)?;
        let mut heartbeat = self.heartbeat(&section, "watches-manager");
        heartbeat.watched = self.watched(&section);
        let error_behavior = section.numbers("error-behavior", self.findings);
        let pdos = PdoKind::ALL.into_iter().flat_map(|kind| self.pdos(&section, kind)).collect();
        let settings = self.settings(&section);
        let downloads = self.downloads(&section);
        let boot = boot_of(&section, "-", "restore", self.findings);
        let run_time_folder = self.folder(&section);
        section.required(&name, "file", self.findings)?;
        let file = section.text("file", self.findings)?;
        let device = self.descriptions.read(&name, &file, self.findings)?;
        let device = self.with_modules(&section, device)?;
        let findings = &mut *self.findings;
        let described = device.node_id().map(|node_id| Said::new(node_id, file.at));
        Some(Node {
            name: Said::new(name, entry.key.span),
            node_id: section.integer("id", findings).or(described),
            heartbeat,
            guarding: (section.time("guard-time", findings), section.integer("life-time-factor", findings)),
            time_cob_id: section.integer("time-cob-id", findings),
            error_behavior,
            pdos,
            unused_pdos: unused_pdos(&section, findings),
            settings,
            downloads,
            boot,
            identity: identity(&section, findings),
            revision_number: section.integer("revision-number", findings),
            serial_number: section.integer("serial-number", findings),
            run_time_folder,
            file,
            device,
            ..Node::default()
        })
    }

    fn with_modules(&mut self, section: &KeyedTable<'_>, device: Device) -> Option<Device> {
        let Some(items) = section.list("modules", self.findings) else { return Some(device) };
        let numbers = items.iter().filter_map(|item| integer("modules", item, (1, 0xFFFF), self.findings));
        let numbers: Vec<u16> = numbers.filter_map(|number| u16::try_from(number).ok()).collect();
        match flatten(&device, &numbers) {
            Ok(plugged) => Some(plugged),
            Err(problems) => {
                let at = section.get("modules").map_or(section.span(), |tree| tree.span);
                for problem in problems {
                    let finding = Diagnostic::new(&UNREADABLE_NODE, at, problem.to_string());
                    self.findings.push(finding.help("`objdict modules` lists the modules of a coupler"));
                }
                None
            }
        }
    }

    fn settings(&mut self, section: &KeyedTable<'_>) -> Vec<Said<Setting>> {
        let mut settings = Vec::new();
        for Pair { key, value } in section.named("set", self.findings) {
            let setting = match &*value.kind {
                Kind::Null | Kind::List(_) | Kind::Map(_) => {
                    self.findings.push(wrong("set", value, "a value").help("write a number or a string"));
                    continue;
                }
                Kind::Bool(flag) => Setting::value(&format!("{}={}", key.spelled(), u8::from(*flag))),
                _ => Setting::value(&format!("{}={}", key.spelled(), value.spelled())),
            };
            match setting {
                Ok(setting) => settings.push(Said::new(setting, value.span)),
                Err(error) => self.ill_typed(
                    key.span,
                    &error.to_string().into(),
                    "write the address of an entry and its value, as in `\"1800:2\" = 1`",
                ),
            }
        }
        settings
    }

    fn pdos(&mut self, section: &KeyedTable<'_>, kind: PdoKind) -> Vec<PdoRequest> {
        let numbered = section.numbered(&kind.name().to_ascii_lowercase(), self.findings);
        numbered.into_iter().filter_map(|(number, tree)| self.pdo(kind, number, &tree)).collect()
    }

    fn pdo(&mut self, kind: PdoKind, number: i128, tree: &Said<&KeyedTree>) -> Option<PdoRequest> {
        let pdo = PdoName { kind, number: u16::try_from(number).ok()? };
        let section = KeyedTable::new(&pdo.to_string(), tree.value, PDO, self.findings)?;
        let transmission = section.parsed("transmission", transmission_type, NO_TRANSMISSION, self.findings);
        let mapping = section.get("map").map(|_| self.mapping(&section));
        let findings = &mut *self.findings;
        Some(PdoRequest {
            enabled: section.flag("enabled", findings).is_none_or(|enabled| enabled.value),
            cob_id: cob_id(&section, "cob-id", findings),
            transmission,
            inhibit_time: section.time("inhibit", findings),
            event_timer: section.time("event-timer", findings),
            deadline: section.time("deadline", findings),
            sync_start: section.integer("sync-start", findings),
            mapping,
            ..PdoRequest::new(pdo, tree.at)
        })
    }

    fn mapping(&mut self, section: &KeyedTable<'_>) -> Vec<Said<Address>> {
        let mut mapping = Vec::new();
        for text in section.texts("map", self.findings) {
            match text.value.parse::<LinkedEntries>().ok().and_then(|entries| entries.addresses()) {
                Some(addresses) => mapping.extend(addresses.map(|address| Said::new(address, text.at))),
                None => self.ill_typed(
                    text.at,
                    &say!("`{}` is not the address of entries", text.value),
                    "write an index and sub-indexes, as in `6000:1-5` or `6041`",
                ),
            }
        }
        mapping
    }

    fn downloads(&mut self, section: &KeyedTable<'_>) -> Vec<Said<DownloadRequest>> {
        let items = section.list("sdo", self.findings).unwrap_or_default();
        items.iter().filter_map(|item| self.download(item)).flatten().collect()
    }

    /// The downloads of an item, one for each value.
    fn download(&mut self, item: &KeyedTree) -> Option<Vec<Said<DownloadRequest>>> {
        let section = KeyedTable::new("sdo", item, SDO, self.findings)?;
        section.required("sdo", "entry", self.findings)?;
        let value = section.required("sdo", "value", self.findings)?;
        let expected =
            ["the address of an entry", "write an index and a sub-index, as in `6040` or `1800:2`"];
        let entry = section.parsed("entry", |text| text.parse::<Address>().ok(), expected, self.findings)?;
        let Address { index, sub } = entry.value;
        let values = match &*value.kind {
            Kind::List(values) => values,
            _ => std::slice::from_ref(value),
        };
        let downloads = values.iter().filter_map(|tree| {
            let value = requested_value(tree, self.findings)?;
            Some(Said::new(DownloadRequest { index, sub: sub.unwrap_or(0), value }, tree.span))
        });
        Some(downloads.collect())
    }

    fn links(&mut self, root: &KeyedTable<'_>) -> Vec<Link> {
        let items = root.list("link", self.findings).unwrap_or_default();
        items.iter().filter_map(|item| self.link(item)).collect()
    }

    fn link(&mut self, item: &KeyedTree) -> Option<Link> {
        let section = KeyedTable::new("link", item, LINK, self.findings)?;
        let from = section.text("from", self.findings);
        let from = from.and_then(|from| self.link_end(&from.value, from.at));
        let to = section.texts("to", self.findings).into_iter();
        let to: Vec<LinkEnd> = to.filter_map(|to| self.link_end(to.value, to.at)).collect();
        let transmission = section.parsed("transmission", transmission_type, NO_TRANSMISSION, self.findings);
        let findings = &mut *self.findings;
        let parameters = LinkParameters {
            transmission: transmission.map(|said| said.value),
            inhibit_time: section.time("inhibit", findings).map(|said| said.value),
            event_timer: section.time("event-timer", findings).map(|said| said.value),
            can_id: section.integer("can-id", findings).map(|said| said.value),
        };
        let deadline = section.time("deadline", findings);
        let from = from?;
        Some(Link { at: from.at, from, to, parameters, deadline })
    }

    fn link_end(&mut self, text: &str, at: Span) -> Option<LinkEnd> {
        let end = LinkEnd::parse(text, at);
        if let Err(error) = &end {
            let help = error.to_string();
            let finding = Diagnostic::new(&WRONG_TYPE, at, say!("`{}` is not a link end", text));
            self.findings.push(finding.help(help));
        }
        end.ok()
    }
}

fn identity(section: &KeyedTable<'_>, findings: &mut Findings) -> Option<IdentityLevel> {
    let word = section.word("identity", findings)?;
    IdentityLevel::ALL.into_iter().find(|level| level.word() == word.value)
}

fn unused_pdos(section: &KeyedTable<'_>, findings: &mut Findings) -> Option<Said<UnusedPdos>> {
    let word = section.word("unused-pdos", findings)?;
    Some(Said::new(if word.value == "off" { UnusedPdos::Off } else { UnusedPdos::Keep }, word.at))
}

/// Whether the file has a node of this name that cannot be read.
fn is_unread(root: &KeyedTable<'_>, nodes: &[Node], name: &str) -> bool {
    let is_there = root.get("node").is_some_and(|table| table.get(name).is_some());
    is_there && nodes.iter().all(|node| node.name.value != name)
}

/// The factor of `1.5x`.
fn factor(text: &str) -> Option<f64> {
    let factor: f64 = text.trim().strip_suffix('x')?.trim_end().parse().ok()?;
    (factor.is_finite() && factor > 0.0).then_some(factor)
}
