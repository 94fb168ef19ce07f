//! The manager's information about the nodes: the values of its objects (CiA 301, CiA 302-2).
//!
//! These values are computed once, for checks, boot plans and built files.

use std::collections::BTreeMap;

use crate::compiled::{Compiled, DcfgenMode, Slave};
use crate::diagnostic::{Diagnostic, say};
use crate::download::Order;
use crate::identity::number;
use crate::model::{Access, Assignment, Compact, DataType, Device, Entry, Object, ObjectType, Value};
use crate::network::{Boot, Manager, Network, Startup};
use crate::rules::CONTRADICTION;
use crate::source::Span;

/// As many nodes as a network has.
const NODES: u8 = 127;

const CONSUMERS: u16 = 0x1016;

const EMERGENCIES: u16 = 0x1028;

const REQUEST_NMT: u16 = 0x1F82;

/// The manager's information about the nodes, by node-ID.
#[derive(Clone, Copy)]
pub(crate) struct Knowledge<'a> {
    pub(crate) network: &'a Network,
    pub(crate) manager: &'a Manager,
    pub(crate) slaves: &'a [Slave],
    pub(crate) mode: DcfgenMode,
}

/// An object of the manager about the nodes.
struct NodeListObject {
    index: u16,
    name: &'static str,
    data_type: DataType,
    access: Access,
    /// By sub-index; one value at 0 for a VAR.
    values: Vec<(u8, u32)>,
}

impl<'a> Knowledge<'a> {
    fn each(self, number: impl Fn(&'a Slave) -> Option<u32>) -> Vec<(u8, u32)> {
        self.slaves.iter().filter_map(|slave| Some((slave.node_id, number(slave)?))).collect()
    }

    fn boot(self, slave: &Slave) -> &'a Boot {
        &self.network.nodes[slave.node].boot
    }

    /// 1016h: the consumer heartbeat times with their nodes, in the order of the nodes.
    pub(crate) fn heartbeats(self) -> impl Iterator<Item = u32> {
        let monitored = self.slaves.iter().filter(|slave| slave.heartbeat != 0);
        monitored.filter_map(move |slave| {
            let heartbeat = &self.network.nodes[slave.node].heartbeat;
            let time = match (heartbeat.consumer_time(slave.heartbeat), self.mode) {
                (Some(time), _) => u32::from(time),
                // the remaining bits of a time that overflows
                (None, DcfgenMode::Exact) => {
                    (f64::from(slave.heartbeat) * heartbeat.factor) as u64 as u32 & 0xFFFF
                }
                (None, DcfgenMode::Corrected) => return None,
            };
            Some(u32::from(slave.node_id) << 16 | time)
        })
    }

    /// 1028h: the COB-IDs of EMCY.
    pub(crate) fn emergencies(self) -> Vec<(u8, u32)> {
        self.each(|slave| slave.emcy)
    }

    /// 1F81h: how each node is booted. dcfgen states the retry factor without guarding too.
    pub(crate) fn assignments(self) -> Vec<(u8, u32)> {
        let stated = |boot: &Boot| match self.network.order {
            Order::Dcfgen => u32::from(boot.retry_factor.value) << 8,
            Order::Safe => 0,
        };
        let assigned = |boot: &Boot, slave: &Slave| boot.to_number(slave.guard_time) | stated(boot);
        self.each(|slave| Some(assigned(self.boot(slave), slave)))
    }

    /// 1F84h to 1F88h: device type, vendor-ID, product code, revision number or serial number, if stated.
    pub(crate) fn identities(self, position: usize) -> Vec<(u8, u32)> {
        self.each(|slave| Some(slave.identity[position]).filter(|number| *number != 0))
    }

    /// 1F8Ah: the defaults to restore before the configuration.
    pub(crate) fn restored(self) -> Vec<(u8, u32)> {
        self.each(|slave| Some(self.boot(slave).restore_configuration.value.into()).filter(|sub| *sub != 0))
    }

    /// 1F55h: the expected software.
    pub(crate) fn software(self) -> Vec<(u8, u32)> {
        self.each(|slave| Some(self.boot(slave).software_version.value).filter(|version| *version != 0))
    }

    fn objects(self) -> Vec<NodeListObject> {
        let known = |index, name, values| NodeListObject {
            index,
            name,
            data_type: DataType::UNSIGNED32,
            access: Access::Rw,
            values,
        };
        let stated = |number: u32| if number == 0 { Vec::new() } else { vec![(0, number)] };
        let bytes = |known: NodeListObject| NodeListObject { data_type: DataType::UNSIGNED8, ..known };
        let mut objects = vec![
            known(EMERGENCIES, "Emergency consumer object", self.emergencies()),
            NodeListObject { access: Access::Wo, ..known(0x1F25, "Configuration request", Vec::new()) },
            known(0x1F55, "Expected software identification", self.software()),
            known(0x1F80, "NMT startup", vec![(0, self.manager.startup.to_number())]),
            known(0x1F81, "NMT slave assignment", self.assignments()),
            bytes(known(REQUEST_NMT, "Request NMT", Vec::new())),
            known(0x1F84, "Device type identification", self.identities(0)),
            known(0x1F85, "Vendor identification", self.identities(1)),
            known(0x1F86, "Product code", self.identities(2)),
            known(0x1F87, "Revision number", self.identities(3)),
            known(0x1F88, "Serial number", self.identities(4)),
            known(0x1F89, "Boot time", stated(self.manager.boot_time.value)),
            bytes(known(0x1F8A, "Restore configuration", self.restored())),
            NodeListObject {
                data_type: DataType::UNSIGNED16,
                ..known(0x102A, "NMT inhibit time", stated(self.manager.nmt_inhibit_time.into()))
            },
        ];
        if self.manager.monitors_nodes() {
            let consumers = (1..).zip(self.heartbeats()).collect();
            objects.push(known(CONSUMERS, "Consumer heartbeat time", consumers));
        }
        objects
    }
}

impl NodeListObject {
    const fn is_variable(&self) -> bool {
        matches!(self.index, 0x102A | 0x1F80 | 0x1F89)
    }

    /// The object with the values, for a dictionary without it.
    fn object(&self) -> Object {
        let value = |number: u32| Value::Unsigned(number.into());
        let mut main = Entry {
            name: self.name.into(),
            object_type: Some(if self.is_variable() { ObjectType::Var } else { ObjectType::Array }),
            data_type: Some(self.data_type),
            access: Some(self.access),
            ..Entry::default()
        };
        if self.is_variable() {
            main.configured_mut().value = self.values.first().map(|(_, number)| value(*number));
            return Object { main, ..Object::default() };
        }
        if self.index == EMERGENCIES {
            // not valid: 0 would be the CAN-ID of NMT
            main.default = Some(value(1 << 31));
        }
        // a command has a sub-index for all nodes (CiA 302-2)
        let count = NODES + u8::from(matches!(self.index, 0x1F25 | REQUEST_NMT));
        let mut values: Vec<(u8, Value)> =
            self.values.iter().map(|(sub, number)| (*sub, value(*number))).collect();
        values.sort_by_key(|(sub, _)| *sub);
        let compact = Some(Box::new(Compact { count, values, ..Compact::default() }));
        let object = Object { main, compact, ..Object::default() };
        if self.index == REQUEST_NMT { with_command(&object) } else { object }
    }
}

/// A list of nodes whose last sub-index is a write-only command for all nodes.
pub(crate) fn with_command(object: &Object) -> Object {
    let mut object = object.expanded().into_owned();
    if let Some(all) = object.subs.get_mut(NODES + 1) {
        all.access = Some(Access::Wo);
    }
    object
}

/// Adds the values that depend on the nodes to a described manager. Values of its own DCF are kept in a network that is
/// as described.
pub(crate) fn complete(network: &Network, compiled: &mut Compiled) {
    let Compiled { slaves, manager: own, findings } = compiled;
    let Some((manager, own)) = network.manager.as_ref().zip(own.as_mut()) else { return };
    let knowledge = Knowledge { network, manager, slaves, mode: DcfgenMode::Corrected };
    for known in knowledge.objects() {
        let index = known.index;
        if own.device.object(index).is_none() {
            // objects without values are added only for completeness
            own.device.objects.insert(index, known.object());
            own.device.lists.add(index);
            continue;
        }
        let values = if index == CONSUMERS { placed(&own.device, &known.values) } else { known.values };
        for (sub, wanted) in values {
            let present = number(&own.device, index, sub, own.node_id);
            let node_id = if index == CONSUMERS { (wanted >> 16) as u8 } else { sub };
            let node = slaves.iter().find(|slave| slave.node_id == node_id);
            let node = node.map(|slave| &network.nodes[slave.node]);
            let at = match node.and_then(|node| node.heartbeat.producer).filter(|_| index == CONSUMERS) {
                Some(heartbeat) => heartbeat.at,
                None => node.map_or(manager.name.at, |node| node.name.at),
            };
            if let Some(said) = own.said(index, sub).filter(|_| present != Some(wanted)) {
                findings.push(contradiction(network, own, (index, sub), (present, wanted), (said, at)));
                continue;
            }
            let is_configured =
                || own.device.entry(index, sub).is_some_and(|entry| entry.configured_value().is_some());
            if network.is_as_described && is_configured() {
                continue;
            }
            own.device.assign(&[Assignment { index, sub, value: Value::Unsigned(wanted.into()) }]);
            own.origins.insert((index, sub), at);
        }
    }
}

/// The values of the manager's objects about the nodes.
pub(crate) fn numbers(compiled: &Compiled) -> BTreeMap<(u16, u8), u32> {
    let Some(own) = &compiled.manager else { return BTreeMap::new() };
    let entries = [CONSUMERS, 0x1F55].into_iter().chain(0x1F80..=0x1F8A);
    let entries = entries.flat_map(|index| (0..=NODES).map(move |sub| (index, sub)));
    entries.filter_map(|at| Some((at, number(&own.device, at.0, at.1, own.node_id)?))).collect()
}

/// The sub-indexes of 1016h for these values: an existing entry for the node, otherwise the first free ones.
fn placed(device: &Device, consumers: &[(u8, u32)]) -> Vec<(u8, u32)> {
    let present = device.services().heartbeat_consumers;
    let mut free = (1..=NODES).filter(|sub| present.iter().all(|consumer| consumer.sub != *sub));
    let place = |&(_, wanted): &(u8, u32)| {
        let own = present.iter().find(|consumer| u32::from(consumer.node_id) == wanted >> 16);
        Some((own.map(|consumer| consumer.sub).or_else(|| free.next())?, wanted))
    };
    consumers.iter().filter_map(place).collect()
}

fn contradiction(
    network: &Network,
    own: &Slave,
    (index, sub): (u16, u8),
    (present, wanted): (Option<u32>, u32),
    (said, at): (Span, Span),
) -> Diagnostic {
    let name = &network.nodes[own.node].name.value;
    let message = say!(
        "{:04X}h:{:02X} of `{}` is set to {:X}h, but its network needs {:X}h",
        index,
        sub,
        name,
        present.unwrap_or(0),
        wanted
    );
    let finding = Diagnostic::new(&CONTRADICTION, said, message).label(at, "the value follows from here");
    finding.help("remove the setting; set the expected value with the keys of node or manager").understood()
}

impl Network {
    /// Lets the manager boot the nodes as in its own description, if it has one: the network consists of descriptions
    /// that are already configured.
    #[must_use]
    pub fn as_described(mut self) -> Self {
        self.is_as_described = true;
        let Some(manager) = &mut self.manager else { return self };
        let Some(own) = manager.node.map(|node| self.nodes[node].device.clone()) else { return self };
        let node_id = manager.node_id.map_or(0, |node_id| node_id.value);
        let stated = |index, sub| number(&own, index, sub, node_id);
        if let Some(number) = stated(0x1F80, 0) {
            manager.startup = Startup::from_number(number);
        }
        manager.boot_time.value = stated(0x1F89, 0).unwrap_or(0);
        let is_assigning = own.object(0x1F81).is_some();
        for node in &mut self.nodes {
            let Some(node_id) = node.node_id.filter(|_| is_assigning) else { continue };
            let number = stated(0x1F81, node_id.value).unwrap_or(0);
            let boot = &mut node.boot;
            boot.boot = number >> 2 & 1 != 0;
            boot.mandatory = number >> 3 & 1 != 0;
            boot.reset_communication = number >> 4 & 1 == 0;
            boot.retry_factor.value = (number >> 8) as u8;
            boot.software_version.value = stated(0x1F55, node_id.value).unwrap_or(0);
            let restored = stated(0x1F8A, node_id.value).and_then(|sub| u8::try_from(sub).ok());
            boot.restore_configuration.value = restored.unwrap_or(0);
        }
        self
    }
}
