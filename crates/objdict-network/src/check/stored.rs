//! The configurations in the manager's description.

use super::NetworkCheck;
use crate::compiled::Slave;
use crate::diagnostic::{At, Diagnostic, say};
use crate::download::{Download, remaining};
use crate::effective::before;
use crate::identity::number;
use crate::model::{Value, hex};
use crate::network::{Node, Stored};
use crate::rules::{CONFIGURATION_DATE, OTHER_CONFIGURATION, REFUSED_CONFIGURATION};

impl NetworkCheck<'_, '_> {
    pub(super) fn stored_configurations(&mut self) {
        for slave in &self.compiled.slaves {
            let node = &self.network.nodes[slave.node];
            for stored in &node.stored {
                self.refused_configuration(slave, node, stored);
                if self.network.is_as_described {
                    self.other_configuration(slave, node, stored);
                }
            }
            self.configuration_date(slave);
        }
    }

    /// The name of the manager, and the place of a node's configuration in its description.
    fn holder(&self, slave: &Slave, index: u16) -> Option<(&str, At)> {
        let own = self.network.manager.as_ref()?.node?;
        let manager = &self.network.nodes[own];
        Some((&manager.name.value, At::Node(own, manager.device.value_place(index, slave.node_id))))
    }

    fn refused_configuration(&mut self, slave: &Slave, node: &Node, stored: &Stored) {
        let Some((manager, place)) = self.holder(slave, stored.index) else { return };
        let verification = stored.downloads.verify(&node.device, Some(slave.node_id));
        let findings: Vec<Diagnostic> = verification
            .aborts()
            .map(|objection| {
                let message = say!(
                    "`{}` rejects download {} in {:04X}h:{:02X} of `{}`, to {:04X}h:{:02X}: {}",
                    node.name.value,
                    objection.number,
                    stored.index,
                    slave.node_id,
                    manager,
                    objection.index,
                    objection.sub,
                    objection.kind.to_string()
                );
                Diagnostic::new(&REFUSED_CONFIGURATION, node.file.at, message)
                    .label(place.clone(), "the configuration")
                    .help("rebuild the manager's DCF: `objdict network build --target manager`")
                    .understood()
            })
            .collect();
        findings.into_iter().for_each(|finding| self.findings.push(finding));
    }

    /// Compares the manager's downloads with the DCF of the node.
    fn other_configuration(&mut self, slave: &Slave, node: &Node, stored: &Stored) {
        let Some((manager, place)) = self.holder(slave, stored.index) else { return };
        let device = before(node, slave.node_id);
        let mut findings = Vec::new();
        let downloads = stored.downloads.0.iter().zip(remaining(&stored.downloads.0));
        for (download, _) in downloads.filter(|(_, remains)| *remains) {
            let Download { index, sub, ref data } = *download;
            let number = |value: &Value| value.integer_for(slave.node_id);
            let Some(sent) = download.assignment(&device).map(|assignment| assignment.value) else {
                continue;
            };
            let Some(own) = device.object(index).and_then(|object| Some(object.value(sub)?.into_owned()))
            else {
                continue;
            };
            if own == sent || number(&own).is_some() && number(&own) == number(&sent) {
                continue;
            }
            let shown = |value: &Value| match number(value) {
                Some(number) if data.len() == 4 => format!("{number:X}h"),
                Some(number) => number.to_string(),
                None => hex::print(data).to_string(),
            };
            let message = say!(
                "{:04X}h:{:02X} of `{}` sets {:04X}h:{:02X} of `{}` to {}, but its own description has {}",
                stored.index,
                slave.node_id,
                manager,
                index,
                sub,
                node.name.value,
                shown(&sent),
                shown(&own)
            );
            let finding = Diagnostic::new(&OTHER_CONFIGURATION, node.file.at, message)
                .label(place.clone(), "the configuration")
                .label(At::Node(slave.node, device.value_place(index, sub)), "the value of the node")
                .help("rebuild the DCFs of node and manager: `objdict network build --target dcf`");
            findings.push(finding.understood());
        }
        findings.into_iter().for_each(|finding| self.findings.push(finding));
    }

    /// 1F26h and 1F27h against 1020h.
    fn configuration_date(&mut self, slave: &Slave) {
        let Some(manager) = &self.compiled.manager else { return };
        let node = &self.network.nodes[slave.node];
        for (index, sub, what) in [(0x1F26, 1, "date"), (0x1F27, 2, "time")] {
            let expected = number(&manager.device, index, slave.node_id, slave.node_id).unwrap_or(0);
            let is = number(&slave.device, 0x1020, sub, slave.node_id);
            let Some(is) = is.filter(|is| expected != 0 && *is != expected) else { continue };
            let message = say!(
                "the manager expects the configuration {} {} of `{}`, which has {}",
                what,
                expected,
                node.name.value,
                is
            );
            let finding = Diagnostic::new(&CONFIGURATION_DATE, node.file.at, message)
                .label_each(manager.origin(self.network, index, slave.node_id), "the expected number")
                .label_each(slave.origin(self.network, 0x1020, sub), "the number of the node");
            self.findings.push(finding.help("rebuild both with `--configured-at`"));
        }
    }
}
