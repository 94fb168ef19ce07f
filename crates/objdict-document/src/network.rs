//! PDOs between the configured nodes of a network: matches CAN-IDs of TPDOs and RPDOs.

use std::collections::BTreeMap;

use super::page::Context;
use crate::describe::spelled;
use crate::model::{Commissioning, MappedObject, Pdo, PdoKind};

/// A configured node as part of a network.
#[derive(Clone, Debug)]
pub(crate) struct Node {
    /// 1 to 127.
    pub(crate) id: u8,
    /// The node name, else the product name.
    pub(crate) name: String,
    /// The link to its page.
    pub(crate) link: String,
    /// Identifies the network.
    network: (Option<u32>, String),
    pdos: Vec<End>,
}

/// A valid PDO of a node.
#[derive(Clone, Debug, PartialEq, Eq)]
struct End {
    kind: PdoKind,
    number: u16,
    /// Whether the CAN-ID has 29 bits, and the CAN-ID.
    can_id: (bool, u32),
    bits: u32,
    /// The names of the mapped objects.
    carried: Vec<String>,
}

impl Node {
    /// The node of a configured device; `None` for a device type.
    pub(super) fn new(context: &Context<'_>, device_name: &str, link: &str) -> Option<Self> {
        let device = context.device;
        let commissioning = device.commissioning.as_ref()?;
        let id = context.node_id?;
        let stated = |text: &Option<String>| {
            text.as_deref().map(str::trim).filter(|text| !text.is_empty()).map(str::to_owned)
        };
        Some(Self {
            id,
            name: stated(&commissioning.node_name).unwrap_or_else(|| device_name.to_owned()),
            link: link.to_owned(),
            network: network_of(commissioning),
            pdos: device.pdos().filter_map(|pdo| End::new(context, &pdo, id)).collect(),
        })
    }
}

fn network_of(commissioning: &Commissioning) -> (Option<u32>, String) {
    (commissioning.net_number, commissioning.network_name.as_deref().unwrap_or_default().trim().to_owned())
}

impl End {
    fn new(context: &Context<'_>, pdo: &Pdo<'_>, node_id: u8) -> Option<Self> {
        let cob_id = pdo.cob_id.filter(|cob_id| cob_id.is_valid())?;
        let name = |mapped: MappedObject| {
            if mapped.is_dummy() {
                return context.language.pick("unused", "unbenutzt").to_owned();
            }
            let entry = context.device.entry(mapped.index, mapped.sub);
            entry.map_or_else(|| mapped.to_string(), |entry| context.name(&entry).to_owned())
        };
        Some(Self {
            kind: pdo.kind,
            number: pdo.number,
            can_id: (cob_id.is_extended(), cob_id.can_id(node_id)),
            bits: pdo.bit_length(),
            carried: pdo.mapped().map(name).collect(),
        })
    }
}

/// The nodes with the same network number and name.
#[derive(Debug)]
pub(crate) struct Network<'a> {
    /// `2 line`; empty if not stated in any file.
    pub(crate) name: String,
    /// By node-ID.
    pub(crate) nodes: Vec<&'a Node>,
    /// By CAN-ID, base frames first.
    pub(crate) frames: Vec<Frame<'a>>,
}

impl Network<'_> {
    /// Duplicate node-IDs, which CANopen does not allow.
    pub(crate) fn doubled(&self) -> Vec<u8> {
        let pairs = self.nodes.windows(2).filter(|pair| pair[0].id == pair[1].id);
        let mut ids: Vec<u8> = pairs.map(|pair| pair[0].id).collect();
        ids.dedup();
        ids
    }
}

impl<'a> Network<'a> {
    /// The CAN-IDs of PDOs from one node to another.
    pub(crate) fn between(&self, from: &Node, to: &Node) -> Vec<String> {
        let has = |ports: &[Port<'a>], node: &Node| ports.iter().any(|port| std::ptr::eq(port.node, node));
        let frames =
            self.frames.iter().filter(|frame| has(&frame.senders, from) && has(&frame.receivers, to));
        frames.map(Frame::shown_can_id).collect()
    }
}

/// A CAN-ID used by PDOs.
#[derive(Debug)]
pub(crate) struct Frame<'a> {
    can_id: (bool, u32),
    pub(crate) senders: Vec<Port<'a>>,
    pub(crate) receivers: Vec<Port<'a>>,
}

/// A PDO of a node.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Port<'a> {
    pub(crate) node: &'a Node,
    end: &'a End,
}

impl<'a> Port<'a> {
    /// `TPDO 1`.
    pub(crate) fn pdo(&self) -> String {
        format!("{} {}", self.end.kind, self.end.number)
    }

    /// Number of bits.
    pub(crate) fn bits(&self) -> u32 {
        self.end.bits
    }

    /// The names of the mapped objects.
    pub(crate) fn carried(&self) -> &'a [String] {
        &self.end.carried
    }
}

impl Frame<'_> {
    /// `0x185`; eight digits for an extended frame.
    pub(crate) fn shown_can_id(&self) -> String {
        let (is_extended, can_id) = self.can_id;
        spelled(can_id, is_extended)
    }

    /// The PDOs whose contents are shown: the TPDOs, or the RPDOs if there is no sender.
    pub(crate) fn content(&self) -> &[Port<'_>] {
        if self.senders.is_empty() { &self.receivers } else { &self.senders }
    }

    /// Whether several nodes send it, which CANopen does not allow.
    pub(crate) fn is_sent_twice(&self) -> bool {
        self.senders.len() > 1
    }

    /// Whether a receiver maps more bits than are sent and therefore ignores the PDO.
    pub(crate) fn is_too_short(&self, receiver: &Port<'_>) -> bool {
        self.senders.iter().any(|sender| sender.end.bits < receiver.end.bits)
    }
}

/// The networks with several of the nodes.
pub(crate) fn networks(nodes: &[Node]) -> Vec<Network<'_>> {
    let mut by_network: BTreeMap<&(Option<u32>, String), Vec<&Node>> = BTreeMap::new();
    for node in nodes {
        by_network.entry(&node.network).or_default().push(node);
    }
    let several = by_network.into_iter().filter(|(_, nodes)| nodes.len() > 1);
    several
        .map(|((number, name), mut nodes)| {
            nodes.sort_by_key(|node| node.id);
            let name = number.map(|number| number.to_string()).into_iter().chain([name.clone()]);
            let name: Vec<String> = name.filter(|part| !part.is_empty()).collect();
            Network { name: name.join(" "), frames: frames(&nodes), nodes }
        })
        .collect()
}

fn frames<'a>(nodes: &[&'a Node]) -> Vec<Frame<'a>> {
    let mut frames: BTreeMap<(bool, u32), Frame<'a>> = BTreeMap::new();
    for &node in nodes {
        for end in &node.pdos {
            let frame = frames.entry(end.can_id).or_insert_with(|| Frame {
                can_id: end.can_id,
                senders: Vec::new(),
                receivers: Vec::new(),
            });
            let ports = match end.kind {
                PdoKind::Tpdo => &mut frame.senders,
                PdoKind::Rpdo => &mut frame.receivers,
            };
            ports.push(Port { node, end });
        }
    }
    frames.into_values().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn node(id: u8, pdos: &[(PdoKind, u32, u32)]) -> Node {
        let end = |(number, &(kind, can_id, bits)): (u16, &(PdoKind, u32, u32))| End {
            kind,
            number,
            can_id: (false, can_id),
            bits,
            carried: Vec::new(),
        };
        Node {
            id,
            name: format!("node {id}"),
            link: String::new(),
            network: (Some(1), "line".to_owned()),
            pdos: (1..).zip(pdos).map(end).collect(),
        }
    }

    #[test]
    fn senders_meet_receivers() {
        use PdoKind::{Rpdo, Tpdo};
        let nodes = [
            node(5, &[(Tpdo, 0x185, 16), (Rpdo, 0x205, 8)]),
            node(1, &[(Rpdo, 0x185, 24), (Tpdo, 0x205, 8)]),
            node(9, &[(Tpdo, 0x205, 8)]),
        ];
        let networks = networks(&nodes);
        let [network] = networks.as_slice() else { panic!("{networks:?}") };
        assert_eq!(network.name, "1 line");
        assert_eq!(network.nodes.iter().map(|node| node.id).collect::<Vec<_>>(), [1, 5, 9]);
        let [first, second] = network.frames.as_slice() else { panic!("{:?}", network.frames) };
        assert_eq!((first.shown_can_id(), first.senders[0].node.id), ("0x185".to_owned(), 5));
        assert_eq!(network.between(&nodes[0], &nodes[1]), ["0x185"]);
        assert_eq!(network.between(&nodes[1], &nodes[2]), [""; 0]);
        assert!(first.is_too_short(&first.receivers[0]) && !first.is_sent_twice());
        assert!(second.is_sent_twice() && !second.is_too_short(&second.receivers[0]));
        assert_eq!(super::networks(&nodes[..1]).len(), 0);
        assert_eq!(network.doubled(), [0; 0]);
        let again = [node(5, &[]), node(5, &[]), node(5, &[]), node(6, &[])];
        assert_eq!(super::networks(&again)[0].doubled(), [5]);
    }
}
