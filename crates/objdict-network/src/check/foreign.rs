//! DCFs created for a different node or network.

use super::NetworkCheck;
use crate::compiled::{Slave, indexes};
use crate::diagnostic::{At, Diagnostic, Severity, say};
use crate::model::{CobId, Field, Part, Place};
use crate::rules::{OTHER_NET_NUMBER, OTHER_NODE_ID};

/// The maximum number of COB-IDs in a finding.
const SHOWN: usize = 4;

impl NetworkCheck<'_, '_> {
    pub(super) fn foreign_descriptions(&mut self) {
        for slave in self.compiled.nodes() {
            self.other_node_id(slave);
        }
        self.net_numbers();
    }

    /// If the network file states the node-ID itself, the DCF may still be suitable.
    fn other_node_id(&mut self, slave: &Slave) {
        let node = &self.network.nodes[slave.node];
        let Some(made_for) = node.device.node_id().filter(|stated| *stated != slave.node_id) else { return };
        let message = say!(
            "`{}` is node {}, but its DCF was created for node {}",
            node.name.value,
            slave.node_id,
            made_for
        );
        let place = Place::of(Part::Commissioning).field(Field::NodeId);
        let at = node.node_id.map_or(node.file.at, |node_id| node_id.at);
        let severity = if at == node.file.at { Severity::Error } else { Severity::Warning };
        let literal = self.literal_can_ids(slave, made_for);
        let finding = Diagnostic::new(&OTHER_NODE_ID, at, message)
            .severity(severity)
            .label(At::Node(slave.node, place), "the node-ID")
            .label_each(literal.into_iter().take(SHOWN), say!("a CAN-ID of node {}", made_for));
        self.findings.push(finding.help("use the EDS, or the DCF of the node").understood());
    }

    /// The COB-IDs of EMCY and PDOs that a description states as numbers of the node that it was made for.
    fn literal_can_ids(&self, slave: &Slave, made_for: u8) -> Vec<At> {
        let pdos = slave.pdos.iter().map(|state| (indexes(state.pdo).0, 1));
        let is_of_other = |&(index, sub): &(u16, u8)| {
            let number = || slave.device.object(index)?.value(sub)?.as_integer();
            number().is_some_and(|number| {
                number & i128::from(CobId::BIT_31) == 0 && number & 0x7F == i128::from(made_for)
            })
        };
        let literal = [(0x1014, 0)].into_iter().chain(pdos).filter(is_of_other);
        literal.filter_map(|(index, sub)| slave.origin(self.network, index, sub)).collect()
    }

    /// Compares `NetNumber` of the DCFs with the first stated one.
    fn net_numbers(&mut self) {
        let place = |node| At::Node(node, Place::of(Part::Commissioning).field(Field::NetNumber));
        let numbers = self.network.nodes.iter().enumerate().filter_map(|(at, node)| {
            let number = node.device.commissioning.as_ref()?.net_number?;
            Some((at, node, number))
        });
        let mut numbers = numbers.filter(|(_, _, number)| *number != 0);
        let Some((first_at, first, number)) = numbers.next() else { return };
        for (at, node, other) in numbers.filter(|(_, _, other)| *other != number) {
            let message = say!(
                "the DCF of `{}` was created for network {}, but the DCF of `{}` for network {}",
                node.name.value,
                other,
                first.name.value,
                number
            );
            let finding = Diagnostic::new(&OTHER_NET_NUMBER, node.file.at, message)
                .label(place(at), "the number of its network")
                .label(place(first_at), "the number of the other network");
            self.findings
                .push(finding.help("use the DCFs of one network, or correct `NetNumber`").understood());
        }
    }
}
