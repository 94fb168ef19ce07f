//! Nodes that monitor the heartbeat of others.

use crate::configure::Setting;
use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Object, Place};
use crate::network::{Heartbeat, Network, Node, Said, Watch, WatchTime};
use crate::origin::because;
use crate::rules::NO_HEARTBEAT_CONSUMER;

/// Makes settings of the nodes that a node [watches](Heartbeat::watched). One that cannot be monitored is a finding.
pub fn watch(network: &mut Network, findings: &mut Findings) {
    let mut settings = Vec::new();
    for (position, node) in network.nodes.iter().enumerate() {
        let mut free = free(node);
        for said in &node.heartbeat.watched {
            let mut place = None;
            let setting = consumer(network, &said.value).and_then(|number| {
                place = Some(Place::object(0x1016));
                let sub = free.next().ok_or("1016h has no free sub-index")?;
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
        network.nodes[position].settings.push(setting);
    }
}

/// The free sub-indexes of 1016h. The first one is for the manager, if the node monitors it.
fn free(node: &Node) -> impl Iterator<Item = u8> + use<> {
    let consumers = node.device.services().heartbeat_consumers;
    let highest = node.device.object(0x1016).and_then(Object::highest_sub).unwrap_or(0).min(127);
    let is_free = move |sub: &u8| consumers.iter().all(|consumer| consumer.sub != *sub);
    let taken = node.heartbeat.consumer.is_some_and(|consumer| consumer.value);
    (1..=highest).filter(is_free).skip(taken.into())
}

/// The value of 1016h.
fn consumer(network: &Network, watch: &Watch) -> Result<u32, &'static str> {
    let node = network.nodes.iter().find(|node| node.name.value == watch.node);
    let manager = network.manager.as_ref().filter(|manager| manager.name.value == watch.node);
    let (node_id, producer) = match (node, manager) {
        (Some(node), _) => (node.node_id, producer(node)),
        (None, Some(manager)) => (manager.node_id, manager.heartbeat.producer.map(|time| time.value)),
        (None, None) => return Err("there is no such node"),
    };
    let node_id = node_id.ok_or("its node-ID is not known")?.value;
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

/// The producer heartbeat time in milliseconds: that of the network file, else that of the description.
fn producer(node: &Node) -> Option<u16> {
    node.heartbeat.producer.map(|time| time.value).or_else(|| node.device.services().heartbeat_time)
}
