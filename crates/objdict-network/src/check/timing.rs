//! PDO timing and bus load.

use super::NetworkCheck;
use crate::compiled::{PdoState, Slave, indexes};
use crate::diagnostic::{Diagnostic, Severity, say};
use crate::messages::Message;
use crate::model::PdoKind;
use crate::network::Said;
use crate::rules::{BUS_LOAD, LATE_MESSAGE, PDO_TIMES};
use crate::timing::{DeadlineKind, TrafficKind};

/// The highest bit rate of CiA 301 in kbit/s.
const FASTEST: u16 = 1000;

impl<'n> NetworkCheck<'n, '_> {
    /// Inhibit time, event timer and deadline.
    pub(super) fn times(&mut self) {
        for (slave, state) in self.traffic.sent() {
            let node = &self.network.nodes[slave.node];
            let at = slave.stated(self.network, state.pdo).unwrap_or(node.name.at);
            let (communication, _) = indexes(state.pdo);
            let (inhibit, timer) = (u32::from(state.inhibit_time), u32::from(state.event_timer) * 10);
            if state.pdo.kind == PdoKind::Tpdo && timer != 0 && timer < inhibit {
                let message = say!(
                    "the event timer of {} {} of `{}` is {} ms, shorter than its inhibit time of {} times 100 µs",
                    state.pdo.kind,
                    state.pdo.number,
                    node.name.value,
                    state.event_timer,
                    state.inhibit_time
                );
                let finding = Diagnostic::new(&PDO_TIMES, at, message)
                    .label_each(slave.origin(self.network, communication, 5), "the event timer")
                    .label_each(slave.origin(self.network, communication, 3), "the inhibit time");
                self.findings.push(finding.help("lengthen the event timer"));
            }
            let message = self.messages.0.get(&state.can_id());
            let sender = message.and_then(|message| self.sender_of(message));
            let Some((sender, sent)) =
                sender.filter(|_| state.pdo.kind == PdoKind::Rpdo && state.deadline != 0)
            else {
                continue;
            };
            if sent.event_timer != 0 && sent.event_timer >= state.deadline {
                let message = say!(
                    "{} {} of `{}` times out after {} ms, but is sent every {} ms",
                    state.pdo.kind,
                    state.pdo.number,
                    node.name.value,
                    state.deadline,
                    sent.event_timer
                );
                let timer = sender.origin(self.network, indexes(sent.pdo).0, 5);
                let finding = Diagnostic::new(&PDO_TIMES, at, message)
                    .label_each(slave.origin(self.network, communication, 5), "the deadline")
                    .label_each(timer, "the event timer of the sender");
                let finding = finding.help("lengthen the receiver's deadline");
                self.findings.push(finding.severity(Severity::Error).understood());
            }
        }
    }

    fn sender_of(&self, message: &Message) -> Option<(&'n Slave, &'n PdoState)> {
        message
            .senders
            .iter()
            .find_map(|party| Some((self.compiled.node(party.node)?, self.compiled.pdo(party)?)))
    }

    /// The share of the bit rate that is used all the time.
    pub(super) fn load(&mut self) {
        // without a bit rate, only load that exceeds the fastest bus is reported
        let manager = self.network.manager.as_ref();
        let fastest = manager.map(|manager| Said::new(FASTEST, manager.name.at));
        let Some(rate) = self.network.bit_rate.or(fastest) else { return };
        let percent = self.schedule.load_at(rate.value) / 10;
        if percent > if self.network.bit_rate.is_some() { 80 } else { 100 } {
            let severity = if percent > 100 { Severity::Error } else { Severity::Warning };
            let message = say!("cyclic messages use {} % of {} kbit/s", percent, rate.value);
            let finding = Diagnostic::new(&BUS_LOAD, rate.at, message).severity(severity).understood();
            self.findings
                .push(finding.help("lengthen periods, map entries together, or increase the bit rate"));
        }
    }
    /// Messages that others delay beyond their deadlines.
    pub(super) fn deadlines(&mut self) {
        let Some(rate) = self.network.bit_rate else { return };
        // that the synchronous PDOs do not fit into their time is reported once
        let late = self.schedule.late(rate.value.max(1)).into_iter();
        let late = late.filter_map(|(frame, response)| match (frame.kind, frame.deadline?) {
            (TrafficKind::SynchronousPdo, (_, DeadlineKind::SyncWindow | DeadlineKind::Period)) => None,
            // inconsistent times, which are reported elsewhere
            (_, (0, DeadlineKind::Receiver)) => None,
            (_, (deadline, _)) => Some((frame, response.div_ceil(1000), deadline / 1000)),
        });
        let late: Vec<_> = late.collect();
        let Some((first, response, deadline)) = late.first() else { return };
        let what = self.described(&first.sender);
        let id = first.id.to_string();
        let rate = rate.value;
        let message = match late.len() {
            1 => {
                say!(
                    "{} ({}) may take {} µs at {} kbit/s, but its deadline is {} µs",
                    what,
                    id,
                    response,
                    rate,
                    deadline
                )
            }
            count => say!(
                "{} ({}) may take {} µs at {} kbit/s, but its deadline is {} µs; {} more may be late",
                what,
                id,
                response,
                rate,
                deadline,
                count - 1
            ),
        };
        let finding = Diagnostic::new(&LATE_MESSAGE, first.sender.at, message);
        self.findings.push(finding.help("run `objdict network timing` for causes and remedies"));
    }
}
