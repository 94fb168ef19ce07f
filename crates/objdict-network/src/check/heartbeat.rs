//! Monitoring.

use super::NetworkCheck;
use crate::compiled::Slave;
use crate::diagnostic::{At, Diagnostic, Severity, say};
use crate::model::Place;
use crate::rules::{NO_HEARTBEAT_CONSUMER, SHORT_HEARTBEAT_TIME, SILENT_NODE};
use crate::source::Span;
use crate::watch::monitors_itself;

/// A heartbeat is late by the frames that wait before it, so a consumer waits half a period longer at least.
const LEAST_FACTOR: f64 = 1.5;

/// A node that monitors a different one.
struct Consumer<'n> {
    name: &'n str,
    own: Option<u8>,
    /// Whether the network file has the time.
    is_said: bool,
    at: Span,
    /// The place of the time in its description.
    origin: Option<At>,
    node_id: u8,
    milliseconds: u16,
    /// Whether it is the manager, which does not boot nodes whose heartbeat is missing.
    is_manager: bool,
}

impl<'n> NetworkCheck<'n, '_> {
    /// Sub-indexes of 1016h that monitor the same node, and nodes for which the described manager has no
    /// sub-index.
    pub(super) fn monitored_twice(&mut self) {
        let manager = self.network.manager.as_ref();
        for slave in self.compiled.nodes() {
            let consumers = &slave.services().heartbeat_consumers;
            let name = &self.network.nodes[slave.node].name;
            let mut has_twice = false;
            for (position, second) in consumers.iter().enumerate() {
                let mut before = consumers[..position].iter();
                let Some(first) = before.find(|first| first.node_id == second.node_id) else { continue };
                has_twice = true;
                let message = say!(
                    "1016h:{:02X} and 1016h:{:02X} of `{}` monitor node {}",
                    first.sub,
                    second.sub,
                    name.value,
                    second.node_id
                );
                let at = slave.said(0x1016, second.sub).unwrap_or(name.at);
                let origins = [first.sub, second.sub].map(|sub| slave.origin(self.network, 0x1016, sub));
                let finding = Diagnostic::new(&NO_HEARTBEAT_CONSUMER, at, message);
                let finding =
                    finding.label_each(origins.into_iter().flatten(), "the consumer heartbeat time");
                let finding = finding.help("monitor each node in one sub-index").understood();
                let is_said = slave.said(0x1016, second.sub).is_some();
                self.findings.push(if is_said { finding.severity(Severity::Error) } else { finding });
            }
            let Some(manager) = manager.filter(|manager| manager.node == Some(slave.node)) else { continue };
            if manager.monitors_nodes() || has_twice {
                let consumers: Vec<u8> = consumers.iter().map(|consumer| consumer.node_id).collect();
                self.unmonitored(slave, &consumers);
            }
        }
    }

    fn unmonitored(&mut self, manager: &Slave, consumers: &[u8]) {
        let slaves = self.compiled.slaves.iter();
        for slave in slaves.filter(|slave| slave.heartbeat != 0 && !consumers.contains(&slave.node_id)) {
            let node = &self.network.nodes[slave.node];
            // a time that does not fit is reported where it is calculated
            if node.heartbeat.consumer_time(slave.heartbeat).is_none() {
                continue;
            }
            let own = &self.network.nodes[manager.node].name.value;
            let message =
                say!("1016h of `{}` does not monitor `{}`, which sends a heartbeat", own, node.name.value);
            let at = node.heartbeat.producer.map_or(node.name.at, |producer| producer.at);
            let place = At::Node(manager.node, Place::object(0x1016));
            let finding =
                Diagnostic::new(&NO_HEARTBEAT_CONSUMER, at, message).label(place, "no sub-index is left");
            self.findings.push(finding.help("free a sub-index of 1016h").understood());
        }
    }

    /// The consumer heartbeat times of nodes and manager against the producers.
    pub(super) fn heartbeats(&mut self) {
        for consumer in self.consumers() {
            let Consumer { name, own, is_said, at, origin, node_id, milliseconds, is_manager } = consumer;
            if own == Some(node_id) {
                let finding = monitors_itself(at, name);
                self.findings.push(finding.label_each(origin, "the consumer heartbeat time"));
                continue;
            }
            let finding = |rule, message| {
                Diagnostic::new(rule, at, message).label_each(origin, "the consumer heartbeat time")
            };
            let finding = match self.producer(node_id) {
                None => {
                    let message = say!("`{}` monitors node {}, which is not in the network", name, node_id);
                    let finding =
                        finding(&SILENT_NODE, message).help("free the sub-index of 1016h, or add the node");
                    if is_said { finding.severity(Severity::Error).understood() } else { finding }
                }
                Some((producer, 0, place)) => {
                    let message = say!("`{}` monitors `{}`, which sends no heartbeat", name, producer);
                    let finding = finding(&SILENT_NODE, message)
                        .label_each(place, "the producer heartbeat time")
                        .help("set the node's producer heartbeat time (1017h)");
                    if is_manager { finding.severity(Severity::Error).understood() } else { finding }
                }
                Some((producer, period, place))
                    if f64::from(milliseconds) < f64::from(period) * LEAST_FACTOR =>
                {
                    let message = say!(
                        "`{}` considers `{}` lost after {} ms, but its heartbeat period is {} ms",
                        name,
                        producer,
                        milliseconds,
                        period
                    );
                    let finding = finding(&SHORT_HEARTBEAT_TIME, message)
                        .label_each(place, "the producer heartbeat time")
                        .help("wait 1.5 to 3 times as long as the producer heartbeat time");
                    let is_sure = milliseconds <= period;
                    if is_sure { finding.severity(Severity::Error).understood() } else { finding }
                }
                Some(_) => continue,
            };
            self.findings.push(finding);
        }
    }

    /// Whether a node is the manager and boots the given one.
    fn is_booted_by(&self, node: usize, node_id: u8) -> bool {
        let other = self.compiled.slaves.iter().find(|slave| slave.node_id == node_id);
        self.network.is_manager(node) && other.is_some_and(|other| self.network.nodes[other.node].boot.boot)
    }

    fn consumers(&self) -> Vec<Consumer<'n>> {
        let mut consumers = Vec::new();
        for slave in self.compiled.nodes() {
            let node = &self.network.nodes[slave.node];
            let request = node.heartbeat.consumer.map_or(node.name.at, |consumer| consumer.at);
            // a generated manager monitors itself only if a node has its node-ID
            let is_other = |node_id: u8| node_id != slave.node_id || !self.network.is_made(slave.node);
            let consumers_of = slave.services().heartbeat_consumers.iter();
            for consumer in consumers_of.filter(|consumer| is_other(consumer.node_id)) {
                let said = slave.said(0x1016, consumer.sub);
                consumers.push(Consumer {
                    name: &node.name.value,
                    own: Some(slave.node_id),
                    is_said: said.is_some(),
                    at: said.unwrap_or(request),
                    origin: slave.origin(self.network, 0x1016, consumer.sub),
                    node_id: consumer.node_id,
                    milliseconds: consumer.time,
                    is_manager: self.is_booted_by(slave.node, consumer.node_id),
                });
            }
        }
        consumers
    }
}
