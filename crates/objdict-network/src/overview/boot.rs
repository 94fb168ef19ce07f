//! The boot procedure of the manager as text.

use std::collections::BTreeMap;

use super::{ConfiguredNetwork, NodeRow};
use crate::Language;
use crate::compiled::Slave;
use crate::manager::numbers;
use crate::network::{Manager, Node, Startup};

/// The boot procedure of the manager.
#[derive(Clone, Debug, serde::Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct BootPlan {
    /// The name of the manager.
    pub manager: String,
    /// NMT startup (1F80h).
    pub startup: u32,
    /// The steps for all nodes, as text.
    pub general: Vec<String>,
    /// The steps for each node, by node-ID.
    pub nodes: Vec<BootStep>,
}

/// The manager's steps for a node.
#[derive(Clone, Debug, serde::Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct BootStep {
    /// The node-ID.
    pub node_id: u8,
    /// The name of the node.
    pub name: String,
    /// NMT slave assignment (1F81h).
    pub assignment: u32,
    /// Whether the network does not start without the node.
    pub is_mandatory: bool,
    /// The checks, downloads and monitoring of the manager, in this order, as text.
    pub steps: Vec<String>,
}

impl BootPlan {
    pub(super) fn new(manager: &Manager, view: ConfiguredNetwork<'_>, rows: &[NodeRow]) -> Self {
        let booted = rows.iter().filter(|row| !row.is_manager);
        let objects = ManagerObjects(numbers(view.compiled));
        let startup = objects.number(0x1F80, 0);
        let words = LanguageWords(view.language);
        let step = |row: &NodeRow| {
            let position = row.position;
            let node = &view.network.nodes[position];
            Some(words.step(&objects, node, view.compiled.node(position)?, row.downloads))
        };
        let nodes = booted.filter_map(step).collect();
        let general = words.general(Startup::from_number(startup), objects.number(0x1F89, 0));
        Self { manager: manager.name.value.clone(), startup, general, nodes }
    }
}

/// The values of the manager's objects, by index and sub-index.
struct ManagerObjects(BTreeMap<(u16, u8), u32>);

impl ManagerObjects {
    /// The number in an entry; 0 without one.
    fn number(&self, index: u16, sub: u8) -> u32 {
        self.0.get(&(index, sub)).copied().unwrap_or(0)
    }

    /// The time in milliseconds within which the heartbeat of a node is expected; 0: not monitored.
    fn consumer_time(&self, node_id: u8) -> u32 {
        let mut consumers = self.0.range((0x1016, 1)..=(0x1016, u8::MAX)).map(|(_, number)| number);
        consumers.find(|number| *number >> 16 == u32::from(node_id)).map_or(0, |number| number & 0xFFFF)
    }
}

/// The vocabulary of a language.
#[derive(Clone, Copy)]
struct LanguageWords(Language);

impl LanguageWords {
    fn said(self, english: impl Into<String>, german: impl Into<String>) -> String {
        match self.0 {
            Language::English => english.into(),
            Language::German => german.into(),
        }
    }

    fn general(self, startup: Startup, boot_time: u32) -> Vec<String> {
        let waits = match boot_time {
            0 => self.said(
                "waits for the mandatory nodes without a limit",
                "wartet unbegrenzt auf die notwendigen Knoten",
            ),
            time => self.said(
                format!("waits up to {time} ms for the mandatory nodes"),
                format!("wartet bis zu {time} ms auf die notwendigen Knoten"),
            ),
        };
        let (english, german) = match (startup.start_nodes, startup.start_all_nodes) {
            (false, _) => (
                "leaves the start of the nodes to the application",
                "überlässt das Starten der Knoten der Anwendung",
            ),
            (true, true) => ("starts all nodes with one command", "startet alle Knoten mit einem Kommando"),
            (true, false) => (
                "starts each node with a separate command",
                "startet jeden Knoten mit einem eigenen Kommando",
            ),
        };
        let starts = self.said(english, german);
        let (english, german) = match startup.start {
            true => ("becomes operational automatically", "geht von selbst in den Zustand Operational"),
            false => (
                "becomes operational when the application requests it",
                "geht in den Zustand Operational, wenn die Anwendung es verlangt",
            ),
        };
        let operates = self.said(english, german);
        let (english, german) = match (startup.reset_all_nodes, startup.stop_all_nodes) {
            (true, _) => (
                "resets all nodes when a mandatory node fails",
                "setzt alle Knoten zurück, wenn ein notwendiger Knoten ausfällt",
            ),
            (false, true) => (
                "stops all nodes when a mandatory node fails",
                "stoppt alle Knoten, wenn ein notwendiger Knoten ausfällt",
            ),
            (false, false) => (
                "handles a failed mandatory node like any other node",
                "behandelt einen notwendigen Knoten, der ausfällt, wie jeden anderen",
            ),
        };
        vec![waits, starts, operates, self.said(english, german)]
    }

    fn step(self, objects: &ManagerObjects, node: &Node, slave: &Slave, downloads: usize) -> BootStep {
        let assignment = objects.number(0x1F81, slave.node_id);
        let boots = assignment & 1 << 2 != 0;
        let mut steps = match boots {
            true => self.booting(objects, node, slave, downloads),
            false => vec![self.said("does not start the node", "startet den Knoten nicht")],
        };
        if boots && Startup::from_number(objects.number(0x1F80, 0)).start_nodes {
            steps.push(self.said("starts the node", "startet den Knoten"));
        }
        steps.push(self.monitored(assignment, objects.consumer_time(slave.node_id)));
        BootStep {
            node_id: slave.node_id,
            name: node.name.value.clone(),
            assignment,
            is_mandatory: assignment & 1 << 3 != 0,
            steps,
        }
    }

    /// The steps before the start.
    fn booting(self, objects: &ManagerObjects, node: &Node, slave: &Slave, downloads: usize) -> Vec<String> {
        let assigned = |bit: u32| objects.number(0x1F81, slave.node_id) & 1 << bit != 0;
        let mut steps = vec![match assigned(4) {
            false => self.said("resets communication", "setzt die Kommunikation zurück"),
            true => self.said(
                "resets communication unless the node is operational",
                "setzt die Kommunikation zurück, wenn der Knoten nicht im Zustand Operational ist",
            ),
        }];
        steps.extend(self.checked(objects, slave.node_id));
        if assigned(5) {
            let version = objects.number(0x1F55, slave.node_id);
            steps.push(self.said(
                format!("checks the software version {version:08X}h"),
                format!("prüft die Softwareversion {version:08X}h"),
            ));
        }
        if let Some(file) = &node.boot.software_file {
            steps.push(self.said(
                format!("updates the software with `{file}`"),
                format!("aktualisiert die Software mit `{file}`"),
            ));
        }
        if assigned(7) {
            let sub = objects.number(0x1F8A, slave.node_id);
            steps.push(self.said(
                format!("restores the defaults with 1011h:{sub:02X}"),
                format!("stellt mit 1011h:{sub:02X} die Vorgabewerte wieder her"),
            ));
        }
        if downloads > 0 {
            let s = if downloads == 1 { "" } else { "s" };
            steps.push(self.said(
                format!("configures the node with {downloads} download{s}"),
                format!("konfiguriert den Knoten mit {downloads} Download{s}"),
            ));
        }
        steps
    }

    /// The expected values of 1000h and 1018h (1F84h to 1F88h).
    fn checked(self, objects: &ManagerObjects, node_id: u8) -> Option<String> {
        let names = [
            self.said("device type", "Gerätetyp"),
            self.said("vendor-ID", "Hersteller-ID"),
            self.said("product code", "Produktcode"),
            self.said("revision number", "Revisionsnummer"),
            self.said("serial number", "Seriennummer"),
        ];
        let numbers = (0x1F84..).map(|index| objects.number(index, node_id));
        let stated = names.into_iter().zip(numbers).filter(|(_, number)| *number != 0);
        let words: Vec<String> = stated.map(|(name, number)| format!("{name} {number:08X}h")).collect();
        let checks = self.said("checks", "prüft");
        (!words.is_empty()).then(|| format!("{checks} {}", words.join(", ")))
    }

    fn monitored(self, assignment: u32, consumer_time: u32) -> String {
        let (guard_time, count) = (assignment >> 16, assignment >> 8 & 0xFF);
        match (consumer_time, guard_time) {
            (0, 0) => self.said("does not monitor the node", "überwacht den Knoten nicht"),
            (0, time) => self.said(
                format!("guards the node every {time} ms, {count} times"),
                format!("überwacht den Knoten alle {time} ms (Guarding), {count}-mal"),
            ),
            (time, _) => self.said(
                format!("expects a heartbeat every {time} ms"),
                format!("erwartet alle {time} ms einen Heartbeat"),
            ),
        }
    }
}
