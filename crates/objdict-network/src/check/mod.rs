//! Inconsistencies in a network.

mod boot;
mod can_ids;
mod foreign;
mod heartbeat;
mod managers;
mod pdos;
mod replay;
mod reserved;
mod stored;
mod sync;
mod timing;

use crate::compiled::Compiled;
use crate::diagnostic::{At, Findings};
use crate::messages::{MessageId, Messages, Party};
use crate::network::Network;
use crate::timing::{Schedule, TimingOptions};
use crate::traffic::Traffic;

/// Reports the problems of a network: of the configurations, and between nodes.
pub fn check(network: &Network, compiled: &Compiled, findings: &mut Findings) {
    findings.append(compiled.findings.clone());
    let messages = Messages::new(network, compiled);
    let traffic = Traffic { network, compiled, messages: &messages };
    let schedule = Schedule::new(traffic, TimingOptions::default());
    let mut check =
        NetworkCheck { network, compiled, traffic, schedule: &schedule, messages: &messages, findings };
    check.nodes();
    check.can_ids();
    check.unlinked();
    check.pdo_lengths();
    check.sync();
    check.reserved();
    check.times();
    check.load();
    check.deadlines();
    check.heartbeats();
    check.monitored_twice();
    check.managers();
    check.assigned_slaves();
    check.own_tables();
    check.unbooted();
    check.identities();
    check.software();
    check.foreign_descriptions();
    check.without_device_type();
    check.boot_time();
    check.kept_alive();
    check.restored();
    check.stored_configurations();
    check.downloads();
}

struct NetworkCheck<'n, 'f> {
    network: &'n Network,
    compiled: &'n Compiled,
    traffic: Traffic<'n>,
    schedule: &'n Schedule,
    messages: &'n Messages,
    findings: &'f mut Findings,
}

impl<'n> NetworkCheck<'n, '_> {
    /// The name of who sends or receives.
    fn name(&self, party: &Party) -> &'n str {
        &self.network.nodes[party.node].name.value
    }

    /// `TPDO 1 of drive`.
    fn described(&self, party: &Party) -> String {
        format!("{} of `{}`", party.service, self.name(party))
    }

    /// The bit rate in kbit/s; if unknown, the fastest, so that timing checks report least.
    fn bit_rate(&self) -> u16 {
        self.network.bit_rate.map_or(1000, |rate| rate.value.max(1))
    }

    /// The place of a party's CAN-ID in the description.
    fn can_id_origin(&self, can_id: MessageId, party: &Party) -> Option<At> {
        self.compiled.node(party.node)?.can_id_origin(self.network, can_id, party.service)
    }

    /// The owner of a node-ID: its name, its producer heartbeat time, and the place of that in its
    /// description.
    fn producer(&self, node_id: u8) -> Option<(&'n str, u16, Option<At>)> {
        let slave = self.compiled.nodes().find(|slave| slave.node_id == node_id)?;
        let name = &self.network.nodes[slave.node].name.value;
        Some((name, slave.heartbeat, slave.origin(self.network, 0x1017, 0)))
    }
}
