//! How the manager boots the network, in words.

use super::{NodeRow, View};
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
        let step = |row: &NodeRow| {
            let position = row.position?;
            let node = &view.network.nodes[position];
            Some(step(manager, node, view.slave(position)?, row.downloads))
        };
        let nodes = booted.filter_map(step).collect();
        Self {
            manager: manager.name.value.clone(),
            startup: manager.startup.to_number(),
            general: general(manager),
            nodes,
        }
    }
}

fn general(manager: &Manager) -> Vec<String> {
    let startup = manager.startup;
    let mut words = vec![match manager.boot_time.value {
        0 => "waits for the mandatory nodes without a limit".to_owned(),
        time => format!("waits up to {time} ms for the mandatory nodes"),
    }];
    words.push(
        match (startup.start_nodes, startup.start_all_nodes) {
            (false, _) => "leaves the start of the nodes to the application",
            (true, true) => "starts all nodes by one command",
            (true, false) => "starts each node by its own command",
        }
        .to_owned(),
    );
    words.push(
        match startup.start {
            true => "becomes operational by itself",
            false => "becomes operational when the application says so",
        }
        .to_owned(),
    );
    words.push(
        match (startup.reset_all_nodes, startup.stop_all_nodes) {
            (true, _) => "resets all nodes when a mandatory node fails",
            (false, true) => "stops all nodes when a mandatory node fails",
            (false, false) => "handles a mandatory node that fails like any other",
        }
        .to_owned(),
    );
    words
}

fn step(manager: &Manager, node: &Node, slave: &Slave, downloads: usize) -> BootStep {
    let boot = &node.boot;
    let mut steps = Vec::new();
    if boot.boot {
        steps.push(match boot.reset_communication {
            true => "resets communication".to_owned(),
            false => "resets communication unless the node is operational".to_owned(),
        });
        steps.extend(checked(node, slave));
        if boot.software_version != 0 {
            steps.push(format!("checks the software version {:08X}h", boot.software_version));
        }
        if let Some(file) = &boot.software_file {
            steps.push(format!("updates the software with `{file}`"));
        }
        if boot.restore_configuration.value != 0 {
            steps.push(format!("restores the defaults by 1011h:{:02X}", boot.restore_configuration.value));
        }
        match downloads {
            0 => {}
            1 => steps.push("configures the node by 1 download".to_owned()),
            count => steps.push(format!("configures the node by {count} downloads")),
        }
        if manager.startup.start_nodes {
            steps.push("starts the node".to_owned());
        }
    } else {
        steps.push("does not start the node".to_owned());
    }
    steps.push(monitored(manager, node, slave));
    BootStep {
        node_id: slave.node_id,
        name: node.name.value.clone(),
        assignment: boot.to_number(slave.guard_time),
        is_mandatory: boot.mandatory,
        steps,
    }
}

/// Which values of 1000h and 1018h must be those of the description (1F84h to 1F88h).
fn checked(node: &Node, slave: &Slave) -> Option<String> {
    let names = ["device type", "vendor-ID", "product code", "revision number", "serial number"];
    let [device_type, vendor, product, revision, serial] = slave.identity;
    // devices of other revisions are replacements, unless the network file says otherwise
    let revision = node.revision_number.map_or(0, |_| revision);
    let serial = node.serial_number.map_or(0, |_| serial);
    let numbers = [device_type, vendor, product, revision, serial];
    let stated = names.into_iter().zip(numbers).filter(|(_, number)| *number != 0);
    let words: Vec<String> = stated.map(|(name, number)| format!("{name} {number:08X}h")).collect();
    (!words.is_empty()).then(|| format!("checks {}", words.join(", ")))
}

fn monitored(manager: &Manager, node: &Node, slave: &Slave) -> String {
    match (slave.heartbeat, slave.guard_time) {
        (0, 0) => "does not monitor the node".to_owned(),
        (0, time) => format!("guards the node each {time} ms, {} times", node.boot.retry_factor.value),
        (heartbeat, _) => match node.heartbeat.consumer_time(heartbeat) {
            Some(time) if manager.monitors_nodes() => format!("expects a heartbeat each {time} ms"),
            _ => "does not monitor the node".to_owned(),
        },
    }
}
