//! The one manager of a network, and the nodes that it boots.

use super::NetworkCheck;
use crate::diagnostic::{At, Diagnostic, Severity, say};
use crate::identity::number;
use crate::model::{Device, Field, Part, Place};
use crate::network::Said;
use crate::rules::{ABSENT_SLAVE, CONTRADICTION, DUPLICATE_MANAGER, MANDATORY_NOT_BOOTED};

/// 1F80h: the node takes part in the election of a manager.
const FLYING: i128 = 1 << 5;

/// 1F81h: the node is a slave.
const SLAVE: u32 = 1;

/// 1F81h: the manager configures and starts the node.
const BOOTED: u32 = 1 << 2;

/// 1F81h: the network does not start without the node.
const MANDATORY: u32 = 1 << 3;

impl NetworkCheck<'_, '_> {
    pub(super) fn managers(&mut self) {
        let Some(manager) = &self.network.manager else { return };
        for slave in &self.compiled.slaves {
            let node = &self.network.nodes[slave.node];
            let commissioning = node.device.commissioning.as_ref();
            let is_manager = commissioning.is_some_and(|node| node.manager == Some(true));
            if !is_manager || is_flying(&slave.device) {
                continue;
            }
            let message = say!("`{}` is a manager in addition to `{}`", node.name.value, manager.name.value);
            let place = Place::of(Part::Commissioning).field(Field::CanOpenManager);
            let places = [Some(slave.node), manager.node].into_iter().flatten();
            let places = places.map(|node| At::Node(node, place.clone()));
            let finding =
                Diagnostic::new(&DUPLICATE_MANAGER, node.file.at, message).label_each(places, "the manager");
            self.findings.push(finding.help("write `CANopenManager=0` in its DCF").understood());
        }
    }

    pub(super) fn assigned_slaves(&mut self) {
        let Some(own) = &self.compiled.manager else { return };
        let Some(assigned) = own.device.object(0x1F81) else { return };
        let manager = &self.network.nodes[own.node];
        for (sub, _) in assigned.entries().filter(|(sub, _)| (1..=127).contains(sub)) {
            let number = number(&own.device, 0x1F81, sub, own.node_id).unwrap_or(0);
            let is_there = self.compiled.nodes().any(|slave| slave.node_id == sub);
            if number & SLAVE == 0 || is_there {
                continue;
            }
            let message =
                say!("1F81h of `{}` assigns node {}, which is not in the network", manager.name.value, sub);
            let finding = Diagnostic::new(&ABSENT_SLAVE, manager.name.at, message)
                .label_each(own.origin(self.network, 0x1F81, sub), "the assigned node");
            let is_missed = number & (MANDATORY | BOOTED) != 0;
            let finding = if is_missed { finding.severity(Severity::Error) } else { finding };
            self.findings
                .push(finding.help(say!("describe the node, or set 1F81h:{:02X} to 0", sub)).understood());
        }
    }

    /// The common content of the two tables of a described manager.
    pub(super) fn own_tables(&mut self) {
        let Some(manager) = &self.network.manager else { return };
        let Some(node) = manager.node.map(|node| &self.network.nodes[node]) else { return };
        let number = |said: Said<u8>| Said::new(u16::from(said.value), said.at);
        let (id, own_id) = (manager.node_id.map(number), node.node_id.map(number));
        let pairs = [
            ("node-ID", id, own_id),
            ("heartbeat time", manager.heartbeat.producer, node.heartbeat.producer),
        ];
        for (what, said, own) in pairs {
            let Some((said, own)) = said.zip(own).filter(|(said, own)| said.value != own.value) else {
                continue;
            };
            let message =
                say!("the manager's {} is {}, but `{}` has {}", what, said.value, node.name.value, own.value);
            let finding = Diagnostic::new(&CONTRADICTION, said.at, message).label(own.at, "the other value");
            self.findings.push(finding.help("remove one of the two"));
        }
    }

    /// Nodes that the network cannot do without, but that the manager does not boot.
    pub(super) fn unbooted(&mut self) {
        let Some(manager) = &self.network.manager else { return };
        for slave in &self.compiled.slaves {
            let node = &self.network.nodes[slave.node];
            if !node.boot.mandatory || node.boot.boot {
                continue;
            }
            let message =
                say!("`{}` is mandatory, but `{}` does not boot it", node.name.value, manager.name.value);
            // only in this case the boot follows from 1F81h, and not vice versa
            let described = self.compiled.manager.as_ref().filter(|_| self.network.is_as_described);
            let origin = described.and_then(|own| own.origin(self.network, 0x1F81, slave.node_id));
            let finding = Diagnostic::new(&MANDATORY_NOT_BOOTED, node.name.at, message)
                .label_each(origin, "the assigned node");
            self.findings.push(finding.help("let the manager boot the node, or omit `mandatory`"));
        }
    }
}

fn is_flying(device: &Device) -> bool {
    let startup = device.object(0x1F80).and_then(|object| object.value(0)?.as_integer());
    startup.is_some_and(|number| number & FLYING != 0)
}
