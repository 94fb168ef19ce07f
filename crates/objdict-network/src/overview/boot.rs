//! How the manager boots the network, in words.

use super::{NodeRow, View};
use crate::Language;
use crate::network::{Manager, Node};
use crate::stream::Slave;

/// What the manager does.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct BootPlan {
    /// The name of the manager.
    pub manager: String,
    /// NMT startup (1F80h).
    pub startup: u32,
    /// What it does for all nodes, in words.
    pub general: Vec<String>,
    /// What it does for each node, by node-ID.
    pub nodes: Vec<BootStep>,
}

/// What the manager does for a node.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct BootStep {
    /// The node-ID.
    pub node_id: u8,
    /// The name of the node.
    pub name: String,
    /// NMT slave assignment (1F81h).
    pub assignment: u32,
    /// Whether the network does not start without the node.
    pub is_mandatory: bool,
    /// What the manager checks, sends and monitors, in this order, in words.
    pub steps: Vec<String>,
}

impl BootPlan {
    pub(super) fn new(manager: &Manager, view: View<'_>, rows: &[NodeRow]) -> Self {
        let booted = rows.iter().filter(|row| !row.is_manager);
        let words = Words(view.language);
        let step = |row: &NodeRow| {
            let position = row.position?;
            let node = &view.network.nodes[position];
            Some(words.step(manager, node, view.slave(position)?, row.downloads))
        };
        let nodes = booted.filter_map(step).collect();
        Self {
            manager: manager.name.value.clone(),
            startup: manager.startup.to_number(),
            general: words.general(manager),
            nodes,
        }
    }
}

/// The words of a language.
#[derive(Clone, Copy)]
struct Words(Language);

impl Words {
    fn said(self, english: impl Into<String>, german: impl Into<String>) -> String {
        match self.0 {
            Language::English => english.into(),
            Language::German => german.into(),
        }
    }

    fn general(self, manager: &Manager) -> Vec<String> {
        let startup = manager.startup;
        let waits = match manager.boot_time.value {
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
            (true, true) => ("starts all nodes by one command", "startet alle Knoten mit einem Kommando"),
            (true, false) => {
                ("starts each node by its own command", "startet jeden Knoten mit einem eigenen Kommando")
            }
        };
        let starts = self.said(english, german);
        let (english, german) = match startup.start {
            true => ("becomes operational by itself", "geht von selbst in den Zustand Operational"),
            false => (
                "becomes operational when the application says so",
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
                "handles a mandatory node that fails like any other",
                "behandelt einen notwendigen Knoten, der ausfällt, wie jeden anderen",
            ),
        };
        vec![waits, starts, operates, self.said(english, german)]
    }

    fn step(self, manager: &Manager, node: &Node, slave: &Slave, downloads: usize) -> BootStep {
        let boot = &node.boot;
        let mut steps = match boot.boot {
            true => self.booting(node, slave, downloads),
            false => vec![self.said("does not start the node", "startet den Knoten nicht")],
        };
        if boot.boot && manager.startup.start_nodes {
            steps.push(self.said("starts the node", "startet den Knoten"));
        }
        steps.push(self.monitored(manager, node, slave));
        BootStep {
            node_id: slave.node_id,
            name: node.name.value.clone(),
            assignment: boot.to_number(slave.guard_time),
            is_mandatory: boot.mandatory,
            steps,
        }
    }

    /// What comes before the start.
    fn booting(self, node: &Node, slave: &Slave, downloads: usize) -> Vec<String> {
        let boot = &node.boot;
        let mut steps = vec![match boot.reset_communication {
            true => self.said("resets communication", "setzt die Kommunikation zurück"),
            false => self.said(
                "resets communication unless the node is operational",
                "setzt die Kommunikation zurück, wenn der Knoten nicht im Zustand Operational ist",
            ),
        }];
        steps.extend(self.checked(node, slave));
        if boot.software_version != 0 {
            let version = boot.software_version;
            steps.push(self.said(
                format!("checks the software version {version:08X}h"),
                format!("prüft die Softwareversion {version:08X}h"),
            ));
        }
        if let Some(file) = &boot.software_file {
            steps.push(self.said(
                format!("updates the software with `{file}`"),
                format!("aktualisiert die Software mit `{file}`"),
            ));
        }
        if boot.restore_configuration.value != 0 {
            let sub = boot.restore_configuration.value;
            steps.push(self.said(
                format!("restores the defaults by 1011h:{sub:02X}"),
                format!("stellt mit 1011h:{sub:02X} die Vorgabewerte wieder her"),
            ));
        }
        if downloads > 0 {
            let s = if downloads == 1 { "" } else { "s" };
            steps.push(self.said(
                format!("configures the node by {downloads} download{s}"),
                format!("konfiguriert den Knoten mit {downloads} Download{s}"),
            ));
        }
        steps
    }

    /// Which values of 1000h and 1018h must be those of the description (1F84h to 1F88h).
    fn checked(self, node: &Node, slave: &Slave) -> Option<String> {
        let names = [
            self.said("device type", "Gerätetyp"),
            self.said("vendor-ID", "Hersteller-ID"),
            self.said("product code", "Produktcode"),
            self.said("revision number", "Revisionsnummer"),
            self.said("serial number", "Seriennummer"),
        ];
        let [device_type, vendor, product, revision, serial] = slave.identity;
        // devices of other revisions are replacements, unless the network file says otherwise
        let revision = node.revision_number.map_or(0, |_| revision);
        let serial = node.serial_number.map_or(0, |_| serial);
        let numbers = [device_type, vendor, product, revision, serial];
        let stated = names.into_iter().zip(numbers).filter(|(_, number)| *number != 0);
        let words: Vec<String> = stated.map(|(name, number)| format!("{name} {number:08X}h")).collect();
        let checks = self.said("checks", "prüft");
        (!words.is_empty()).then(|| format!("{checks} {}", words.join(", ")))
    }

    fn monitored(self, manager: &Manager, node: &Node, slave: &Slave) -> String {
        let expected = match (slave.heartbeat, slave.guard_time) {
            (0, 0) => None,
            (0, time) => {
                let count = node.boot.retry_factor.value;
                return self.said(
                    format!("guards the node each {time} ms, {count} times"),
                    format!("überwacht den Knoten alle {time} ms (Guarding), {count}-mal"),
                );
            }
            (heartbeat, _) => node.heartbeat.consumer_time(heartbeat),
        };
        match expected.filter(|_| manager.monitors_nodes()) {
            Some(time) => self.said(
                format!("expects a heartbeat each {time} ms"),
                format!("erwartet alle {time} ms einen Heartbeat"),
            ),
            None => self.said("does not monitor the node", "überwacht den Knoten nicht"),
        }
    }
}
