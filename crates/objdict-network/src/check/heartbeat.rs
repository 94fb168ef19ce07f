//! Monitoring.

use super::Check;
use crate::diagnostic::{Diagnostic, say};
use crate::rules::{SHORT_HEARTBEAT_TIME, SILENT_NODE};
use crate::source::Span;

/// A heartbeat is late by the frames that wait before it, so a consumer waits half a period longer at least.
const LEAST_FACTOR: f64 = 1.5;

impl Check<'_, '_> {
    /// The consumer heartbeat times of nodes and manager against the producers.
    pub(super) fn heartbeats(&mut self) {
        let mut consumers: Vec<(String, Span, u8, u16)> = Vec::new();
        for slave in self.compiled.nodes() {
            let node = &self.network.nodes[slave.node];
            let at = node.heartbeat.consumer.map_or(node.name.at, |consumer| consumer.at);
            for consumer in slave.device.services().heartbeat_consumers {
                consumers.push((node.name.value.clone(), at, consumer.node_id, consumer.time));
            }
        }
        if let Some(manager) = self.network.manager.as_ref().filter(|manager| manager.monitors_nodes()) {
            for slave in self.compiled.slaves.iter().filter(|slave| slave.heartbeat != 0) {
                let node = &self.network.nodes[slave.node];
                let at = node.heartbeat.producer.map_or(node.name.at, |producer| producer.at);
                let time = node.heartbeat.consumer_time(slave.heartbeat);
                consumers.extend(time.map(|time| (manager.name.value.clone(), at, slave.node_id, time)));
            }
        }
        for (consumer, at, node_id, time) in consumers {
            match self.producer(node_id) {
                None => {
                    let message =
                        say!("`{}` monitors node {}, which is not in the network", consumer, node_id);
                    let finding = Diagnostic::new(&SILENT_NODE, at, message);
                    self.findings.push(finding.help("free the sub-index of 1016h, or add the node"));
                }
                Some((producer, 0)) => {
                    let message = say!("`{}` monitors `{}`, which sends no heartbeat", consumer, producer);
                    let finding = Diagnostic::new(&SILENT_NODE, at, message);
                    self.findings.push(finding.help("set the producer heartbeat time of the node (1017h)"));
                }
                Some((producer, period)) if f64::from(time) < f64::from(period) * LEAST_FACTOR => {
                    let message = say!(
                        "`{}` gives `{}` up after {} ms, but a heartbeat comes each {} ms",
                        consumer,
                        producer,
                        time,
                        period
                    );
                    let finding = Diagnostic::new(&SHORT_HEARTBEAT_TIME, at, message);
                    self.findings
                        .push(finding.help("wait 1.5 to 3 times as long as the producer heartbeat time"));
                }
                Some(_) => {}
            }
        }
    }
}
