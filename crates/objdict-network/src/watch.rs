//! Nodes that monitor the heartbeat of others.

use crate::compile::compile;
use crate::compiled::{Compiled, DcfgenMode};
use crate::configure::Setting;
use crate::diagnostic::{Diagnostic, Findings, Severity, say};
use crate::model::{Device, Object, Place};
use crate::names::unknown_node;
use crate::network::{Heartbeat, Network, Said, Watch, WatchTime};
use crate::origin::because;
use crate::rules::{NO_HEARTBEAT_CONSUMER, SILENT_NODE};
use crate::source::Span;

/// Makes settings of the nodes that a node [watches](Heartbeat::watched). One that cannot be monitored is a finding.
pub(crate) fn watch(network: &mut Network, findings: &mut Findings) {
    if network.nodes.iter().all(|node| node.heartbeat.watched.is_empty()) {
        return;
    }
    let compiled = compile(network, DcfgenMode::Corrected);
    let manager = network.manager.as_ref();
    let mut settings = Vec::new();
    for (position, node) in network.nodes.iter().enumerate() {
        let slave = compiled.node(position);
        let device = slave.map_or(&node.device, |slave| &slave.device);
        let mut free = free(device);
        for said in &node.heartbeat.watched {
            if said.value.node == node.name.value {
                findings.push(monitors_itself(said.at, &node.name.value));
                continue;
            }
            let names =
                network.nodes.iter().map(|node| &node.name).chain(manager.map(|manager| &manager.name));
            if names.clone().all(|name| name.value != said.value.node) {
                let message = say!("unknown node `{}`, which `{}` watches", said.value.node, node.name.value);
                let names = names.map(|name| &*name.value);
                findings.push(unknown_node(said.at, &said.value.node, message, names));
                continue;
            }
            let mut place = None;
            let setting = consumer(network, &compiled, &said.value).and_then(|number| {
                place = Some(Place::object(0x1016));
                // two entries of a node must not monitor the same node
                let consumers = device.services().heartbeat_consumers;
                let own = consumers.iter().find(|consumer| u32::from(consumer.node_id) == number >> 16);
                let sub = own.map(|own| own.sub).or_else(|| free.next());
                let sub = sub.ok_or("1016h has no free sub-index")?;
                Setting::value(&format!("1016:{sub:X}={number}")).map_err(|_| "1016h cannot be written")
            });
            match setting {
                Ok(setting) => settings.push((position, Said::new(setting, said.at))),
                Err(reason) => {
                    let message =
                        say!("`{}` cannot watch `{}`: {}", node.name.value, said.value.node, reason);
                    let finding = Diagnostic::new(&NO_HEARTBEAT_CONSUMER, said.at, message)
                        .help("watch a node that has a node-ID and a `heartbeat`");
                    findings.push(because(finding, position, place));
                }
            }
        }
    }
    for (position, setting) in settings {
        network.nodes[position].implied.push(setting);
    }
}

/// A node that monitors its own heartbeat, which it does not receive.
pub(crate) fn monitors_itself(at: Span, name: &str) -> Diagnostic {
    let message = say!("`{}` monitors itself, but a node does not receive its own heartbeat", name);
    let finding = Diagnostic::new(&SILENT_NODE, at, message).severity(Severity::Error);
    finding.help("monitor a different node").understood()
}

/// The free sub-indexes of 1016h.
fn free(device: &Device) -> impl Iterator<Item = u8> + use<> {
    let consumers = device.services().heartbeat_consumers;
    let highest = device.object(0x1016).and_then(Object::highest_sub).unwrap_or(0).min(127);
    (1..=highest).filter(move |sub| consumers.iter().all(|consumer| consumer.sub != *sub))
}

/// The value of 1016h.
fn consumer(network: &Network, compiled: &Compiled, watch: &Watch) -> Result<u32, &'static str> {
    let position = network.nodes.iter().position(|node| node.name.value == watch.node);
    let manager = network.manager.as_ref().filter(|manager| manager.name.value == watch.node);
    let (node_id, producer) = match (position, manager) {
        (Some(position), _) => {
            let slave = compiled.node(position);
            (slave.map(|slave| slave.node_id), slave.map(|slave| slave.heartbeat))
        }
        (None, Some(manager)) => {
            let producer = manager.heartbeat.producer.map(|time| time.value);
            (manager.node_id.map(|node_id| node_id.value), producer)
        }
        (None, None) => return Err("there is no such node"),
    };
    let node_id = node_id.ok_or("its node-ID is not known")?;
    let milliseconds = match watch.time {
        WatchTime::Milliseconds(milliseconds) => milliseconds,
        WatchTime::Times(factor) => {
            let producer = producer.filter(|time| *time != 0).ok_or("it has no heartbeat time")?;
            let consumer = Heartbeat { factor, ..Heartbeat::default() };
            consumer.consumer_time(producer).ok_or("the time is longer than 65535 ms")?
        }
    };
    Ok(u32::from(node_id) << 16 | u32::from(milliseconds))
}
