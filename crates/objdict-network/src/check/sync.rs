//! SYNC: the nodes that wait for it, its counter, and its window.

use super::NetworkCheck;
use super::reserved::is_reserved_overflow;
use crate::compiled::{PdoState, Slave, indexes};
use crate::diagnostic::{Diagnostic, Severity, Text, say, series};
use crate::messages::{MessageId, Party, Service};
use crate::model::PdoKind;
use crate::rules::{NO_SYNC_SENDER, SYNC_COUNTER, SYNC_WINDOW};
use crate::traffic::Sync;

/// The maximum number of PDOs in a message.
const MAX_NAMED: usize = 4;

impl<'n> NetworkCheck<'n, '_> {
    pub(super) fn sync(&mut self) {
        self.waiting();
        let Some(sync) = self.traffic.sync() else { return };
        let pdos = self.traffic.sent();
        let synchronous: Vec<_> = pdos.into_iter().filter(|(_, state)| state.is_synchronous()).collect();
        let mut users: Vec<&Slave> = synchronous.iter().map(|(slave, _)| *slave).collect();
        users.dedup_by_key(|slave| slave.node);
        self.counters(&sync);
        if !self.windows(&sync, &users) {
            self.burst(&sync);
        }
    }

    /// PDOs that wait for SYNC, which no node sends, or not with this CAN-ID: one finding per node.
    fn waiting(&mut self) {
        let (compiled, messages) = (self.compiled, self.messages);
        let senders: Vec<(MessageId, &Party)> = messages
            .0
            .iter()
            .flat_map(|(can_id, message)| message.senders.iter().map(|party| (*can_id, party)))
            .filter(|(_, party)| party.service == Service::Sync)
            .collect();
        for slave in compiled.nodes() {
            let is_waiting = |state: &&PdoState| state.is_active() && state.is_synchronous();
            let mut waiting: Vec<&PdoState> = slave.pdos.iter().filter(is_waiting).collect();
            let own = slave.sync_can_id();
            let is_heard = senders.iter().any(|(can_id, _)| own.is_none_or(|own| own == *can_id));
            if is_heard || waiting.is_empty() && senders.is_empty() {
                continue;
            }
            waiting.sort_by_key(|state| !self.is_needed(slave, state));
            let other = senders.first().zip(own.filter(|own| own.number != 0 || !waiting.is_empty()));
            let finding = match other {
                Some((sender, own)) => self.other_can_id(slave, &waiting, own, *sender),
                // waiting PDOs are reported for the nodes with their counterparts
                None if waiting.is_empty() || self.network.is_made(slave.node) => continue,
                None => self.no_sync(slave, &waiting),
            };
            let types =
                waiting.iter().filter_map(|state| slave.origin(self.network, indexes(state.pdo).0, 2));
            self.findings.push(finding.label_each(types, "the transmission type").understood());
        }
    }

    /// Whether the network needs a PDO: its file configures the PDO, or a different described node has the
    /// counterpart.
    pub(super) fn is_needed(&self, slave: &Slave, state: &PdoState) -> bool {
        let (communication, mapping) = indexes(state.pdo);
        let node = &self.network.nodes[slave.node];
        let entries = || (1..=6).map(|sub| (communication, sub)).chain([(mapping, 0)]);
        if node.pdos.iter().any(|request| request.pdo == state.pdo)
            || entries().any(|(index, sub)| slave.said(index, sub).is_some())
        {
            return true;
        }
        let is_configured = || entries().any(|(index, sub)| slave.is_configured(self.network, index, sub));
        // a network without a manager may be a part of a larger one, whose other nodes may send SYNC
        self.network.manager.is_some() && (is_configured() || self.has_other_side(slave, state))
    }

    fn has_other_side(&self, slave: &Slave, state: &PdoState) -> bool {
        let Some(message) = self.messages.0.get(&state.can_id()) else { return false };
        let others = match state.pdo.kind {
            PdoKind::Tpdo => &message.receivers,
            PdoKind::Rpdo => &message.senders,
        };
        others.iter().any(|party| party.node != slave.node && matches!(party.service, Service::Pdo(_)))
    }

    fn no_sync(&self, slave: &Slave, waiting: &[&PdoState]) -> Diagnostic {
        let node = &self.network.nodes[slave.node];
        let message = match waiting {
            [_] => say!("{} of `{}` waits for SYNC, which no node sends", named(waiting), node.name.value),
            _ => say!("{} of `{}` wait for SYNC, which no node sends", named(waiting), node.name.value),
        };
        let first = waiting[0];
        let request = node.pdos.iter().find(|request| request.pdo == first.pdo).map(|request| request.at);
        let said = slave.said(indexes(first.pdo).0, 2).or(request);
        let finding = Diagnostic::new(&NO_SYNC_SENDER, said.unwrap_or(node.name.at), message)
            .help("set the manager's SYNC period, or use an event-driven transmission type");
        // the nodes boot nevertheless
        finding.severity(Severity::Warning)
    }

    fn other_can_id(
        &self,
        slave: &Slave,
        waiting: &[&PdoState],
        own: MessageId,
        (can_id, sender): (MessageId, &Party),
    ) -> Diagnostic {
        let name = &self.network.nodes[slave.node].name;
        let message = say!(
            "`{}` expects SYNC on {}, but `{}` sends it on {}",
            name.value,
            own.to_string(),
            self.name(sender),
            can_id.to_string()
        );
        let said = slave.said(0x1005, 0);
        let finding = Diagnostic::new(&NO_SYNC_SENDER, said.unwrap_or(name.at), message)
            .label(sender.at, "who sends SYNC")
            .label_each(slave.origin(self.network, 0x1005, 0), "the CAN-ID of SYNC")
            .label_each(self.can_id_origin(can_id, sender), "the CAN-ID of SYNC")
            .help("set 1005h of both to the same CAN-ID");
        let is_configured = || slave.is_configured(self.network, 0x1005, 0);
        // without a synchronous PDO, no node waits for SYNC yet
        let is_sure = waiting.first().is_some_and(|first| is_configured() || self.is_needed(slave, first));
        if is_sure { finding } else { finding.severity(Severity::Warning) }
    }

    /// Checks 1019h of the nodes that receive SYNC: a SYNC of unexpected length causes an EMCY even if no PDO
    /// waits for it.
    fn counters(&mut self, sync: &Sync) {
        let compiled = self.compiled;
        let sender = self.compiled.node(sync.node);
        let is_hearing = |slave: &&Slave| slave.node != sync.node && slave.sync_can_id() == Some(sync.can_id);
        for slave in compiled.nodes().filter(is_hearing) {
            // a node without 1019h expects no counter
            let overflow = slave.services().sync_counter_overflow.unwrap_or(0);
            if overflow == sync.overflow
                || is_reserved_overflow(overflow)
                || is_reserved_overflow(sync.overflow)
            {
                continue;
            }
            let node = &self.network.nodes[slave.node];
            let message = say!(
                "`{}` expects SYNC with the counter overflow {}, but it is {}",
                node.name.value,
                overflow,
                sync.overflow
            );
            let of_sender = sender.and_then(|sender| sender.origin(self.network, 0x1019, 0));
            let finding = Diagnostic::new(&SYNC_COUNTER, node.name.at, message)
                .label(sync.at, "who sends SYNC")
                .label_each(slave.origin(self.network, 0x1019, 0), "the overflow value")
                .label_each(of_sender, "the overflow value of the sender");
            let finding = finding.help(match slave.device.object(0x1019) {
                Some(_) => "set 1019h to the same value in all nodes",
                None => "send SYNC without a counter: the node has no 1019h",
            });
            self.findings.push(finding.understood());
        }
    }

    /// Windows that are longer than the SYNC period; returns whether the sender's is.
    fn windows(&mut self, sync: &Sync, users: &[&Slave]) -> bool {
        let message = |window: u64, name: &str| -> Text {
            say!(
                "the synchronous window length of `{}` is {} µs, longer than the communication cycle period of {} µs",
                name,
                window,
                sync.period
            )
        };
        let sender = Party { node: sync.node, service: Service::Sync, at: sync.at };
        let mut findings = Vec::new();
        let is_too_long = sync.window.value > sync.period;
        if is_too_long {
            let finding =
                Diagnostic::new(&SYNC_WINDOW, sync.window.at, message(sync.window.value, self.name(&sender)));
            let origins = self.compiled.node(sync.node).map(|sender| {
                [0x1007, 0x1006].map(|index| sender.origin(self.network, index, 0)).into_iter().flatten()
            });
            findings.push(
                finding
                    .severity(Severity::Error)
                    .label(sync.at, "who sends SYNC")
                    .label_each(origins.into_iter().flatten(), "in the description"),
            );
        }
        for slave in users.iter().filter(|slave| slave.node != sync.node) {
            let window = slave.services().synchronous_window.unwrap_or(0).into();
            // a long default is equivalent to none
            if window <= sync.period || !slave.is_configured(self.network, 0x1007, 0) {
                continue;
            }
            let name = &self.network.nodes[slave.node].name;
            let at = slave.said(0x1007, 0).unwrap_or(name.at);
            let finding = Diagnostic::new(&SYNC_WINDOW, at, message(window, &name.value))
                .label(sync.at, "who sends SYNC")
                .label_each(slave.origin(self.network, 0x1007, 0), "the synchronous window length");
            findings.push(finding.severity(Severity::Error));
        }
        for finding in findings {
            self.findings.push(finding.help("shorten the window, or write 0 for none").understood());
        }
        is_too_long
    }

    /// Whether SYNC and the messages it triggers fit into the window or the period.
    fn burst(&mut self, sync: &Sync) {
        // with types above 1, PDOs may still coincide in one cycle
        let time = (self.schedule.bits_of_cycle() * 1000).div_ceil(self.bit_rate().into());
        let (limit, what, at, index) = match sync.window.value {
            0 => (sync.period, "communication cycle period", sync.at, 0x1006),
            window => (window, "synchronous window length", sync.window.at, 0x1007),
        };
        if time > limit {
            let message = say!(
                "SYNC and the synchronous PDOs take up to {} µs, but the {} is {} µs",
                time,
                what,
                limit
            );
            let sender = self.compiled.node(sync.node);
            let origin = sender.and_then(|sender| sender.origin(self.network, index, 0));
            let finding = Diagnostic::new(&SYNC_WINDOW, at, message).label_each(origin, say!("the {}", what));
            self.findings.push(finding.help("lengthen it, or send PDOs less often"));
        }
    }
}

/// `TPDO 1`, `TPDO 1 and RPDO 1`, or a number if there are many.
fn named(pdos: &[&PdoState]) -> Text {
    match pdos.len() {
        0..=MAX_NAMED => say!("{}", series(pdos.iter().map(|state| Service::Pdo(state.pdo).to_string()))),
        count => say!("{} PDOs", count),
    }
}
