mod special;

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use objdict_eds::{eds, ini};
use proptest::prelude::*;

use super::connect;
use crate::configure::PdoName;
use crate::diagnostic::Findings;
use crate::model::{CobId, Device, DeviceKind, MappedObject, PdoKind};
use crate::source::{SourceFile, Span};
use crate::{Link, LinkEnd, LinkParameters, Network, Node, PdoRequest, RequestedCobId, Said};

/// Differences between a test device and the default: ten inputs (6000h), ten outputs (6200h) and four
/// analogue ones of each kind (6401h, 6411h).
#[derive(Clone, Debug)]
struct Kit {
    tpdos: u16,
    rpdos: u16,
    slots: u8,
    /// Mappings by index; others are empty.
    mapped: Vec<(u16, Vec<u32>)>,
    /// PDOs whose mapping or COB-ID (`1801`) is constant.
    fixed: Vec<u16>,
    /// Data types that are allowed as dummies.
    dummies: Vec<u16>,
}

impl Default for Kit {
    fn default() -> Self {
        Self { tpdos: 4, rpdos: 4, slots: 8, mapped: Vec::new(), fixed: Vec::new(), dummies: Vec::new() }
    }
}

impl Kit {
    fn device(&self) -> Device {
        let mut text = String::from("[DummyUsage]\n");
        for dummy in &self.dummies {
            writeln!(text, "Dummy{dummy:04X}=1").unwrap();
        }
        let arrays =
            [(0x6000, 5, "ro", 10), (0x6200, 5, "rww", 10), (0x6401, 3, "ro", 4), (0x6411, 3, "rww", 4)];
        for (index, data_type, access, count) in arrays {
            writeln!(
                text,
                "[{index:X}]\nParameterName=Array {index:X}\nObjectType=8\nDataType={data_type}\nAccessType={access}\nPDOMapping=1\nCompactSubObj={count}"
            )
            .unwrap();
        }
        for (index, name, data_type, access, mapping) in [
            (0x2000, "Serial word", 6, "ro", 1),
            (0x2001, "Speed", 8, "rww", 1),
            (0x2002, "Hidden", 5, "rw", 0),
            (0x2005, "Received word", 6, "rww", 1),
        ] {
            writeln!(text, "[{index:X}]\nParameterName={name}\nDataType={data_type}\nAccessType={access}\nPDOMapping={mapping}")
                .unwrap();
        }
        for (kind, count) in [(PdoKind::Tpdo, self.tpdos), (PdoKind::Rpdo, self.rpdos)] {
            (1..=count).for_each(|number| self.pdo(&mut text, PdoName { kind, number }));
        }
        let document = ini::Document::new(SourceFile::from_text("kit.eds", text));
        eds::read(&document, DeviceKind::Type).0
    }

    fn pdo(&self, text: &mut String, pdo: PdoName) {
        let communication = pdo.kind.communication_index(pdo.number).unwrap();
        let mapping = pdo.kind.mapping_index(pdo.number).unwrap();
        let cob_id = match pdo.kind.predefined_can_id(pdo.number) {
            Some(id) => format!("$NODEID+0x{id:X}"),
            None => "0x80000000".to_owned(),
        };
        let mapped = self.mapped.iter().find(|(index, _)| *index == mapping).map(|(_, mapped)| &**mapped);
        let mapped = mapped.unwrap_or_default();
        let mut sub = |index: u16, sub: u8, value: &str, data_type: u8, access: &str| {
            writeln!(
                text,
                "[{index:X}sub{sub:X}]\nParameterName=Sub {sub}\nDataType={data_type}\nAccessType={access}\nDefaultValue={value}"
            )
            .unwrap();
        };
        let access = |index| if self.fixed.contains(&index) { "const" } else { "rw" };
        sub(communication, 0, "5", 5, "const");
        sub(communication, 1, &cob_id, 7, access(communication));
        sub(communication, 2, "255", 5, "rw");
        sub(communication, 3, "0", 6, "rw");
        sub(communication, 5, "0", 6, "rw");
        sub(mapping, 0, &mapped.len().to_string(), 5, access(mapping));
        for slot in 1..=self.slots {
            let object = mapped.get(usize::from(slot) - 1).copied().unwrap_or(0);
            sub(mapping, slot, &format!("0x{object:08X}"), 7, access(mapping));
        }
        for (index, name) in [(communication, "communication"), (mapping, "mapping")] {
            writeln!(text, "[{index:X}]\nParameterName={} {name}\nObjectType=9", pdo.kind).unwrap();
        }
    }
}

fn node(name: &str, node_id: u8, device: &Device) -> Node {
    let mut node = Node::default();
    node.name.value = name.to_owned();
    node.node_id = Some(Said::new(node_id, Span::default()));
    node.device = device.clone();
    node
}

fn link(from: &str, to: &[&str]) -> Link {
    let end = |text: &str| LinkEnd::parse(text, Span::default()).unwrap();
    Link {
        at: Span::new(1, 2),
        from: end(from),
        to: to.iter().copied().map(end).collect(),
        parameters: LinkParameters::default(),
        deadline: None,
    }
}

/// Nodes 1, 2, 3 … of these kits with the names a, b, c ….
fn network(kits: &[Kit], links: Vec<Link>) -> Network {
    let nodes = kits
        .iter()
        .zip(1_u8..)
        .map(|(kit, node_id)| node(&char::from(b'a' + node_id - 1).to_string(), node_id, &kit.device()));
    Network { nodes: nodes.collect(), links, ..Network::default() }
}

fn mapping(node: &Node, request: &PdoRequest) -> Vec<MappedObject> {
    let present = || node.device.pdo(request.pdo.kind, request.pdo.number).unwrap().mapped().collect();
    let Some(mapping) = &request.mapping else { return present() };
    let bits = |index, sub| match index {
        ..0x20 => crate::model::DataType(index).bit_length(),
        _ => objdict_node::download::transferred_type(&node.device, index, sub).unwrap().bit_length(),
    };
    let mapped = mapping.iter().map(|said| (said.value.index, said.value.sub.unwrap()));
    mapped.map(|(index, sub)| MappedObject { index, sub, bits: bits(index, sub).unwrap() }).collect()
}

fn cob_id(request: &PdoRequest) -> u32 {
    match request.cob_id.unwrap().value {
        RequestedCobId::Number(number) => number,
        RequestedCobId::Auto => panic!("links have numbers"),
    }
}

/// A line for each PDO that links configure: `a TPDO 1 181: 6000:1 6000:2`.
fn shown(network: &Network) -> Vec<String> {
    let lines = network.nodes.iter().flat_map(|node| {
        node.pdos.iter().map(move |request| {
            let mapped = mapping(node, request);
            let mapped = mapped.iter().map(|object| format!(" {:X}:{:X}", object.index, object.sub));
            let PdoName { kind, number } = request.pdo;
            format!(
                "{} {kind} {number} {:X}:{}",
                node.name.value,
                cob_id(request),
                mapped.collect::<String>()
            )
        })
    });
    lines.collect()
}

fn connected(kits: &[Kit], links: Vec<Link>) -> Vec<String> {
    let mut network = network(kits, links);
    let mut findings = Findings::new();
    connect(&mut network, &mut findings);
    assert_eq!(findings.iter().map(|finding| finding.message.to_string()).collect::<Vec<_>>(), [""; 0]);
    shown(&network)
}

fn found(kits: &[Kit], links: Vec<Link>) -> Vec<String> {
    let mut network = network(kits, links);
    let mut findings = Findings::new();
    connect(&mut network, &mut findings);
    findings.iter().map(|finding| format!("{}: {}", finding.rule.name(), finding.message)).collect()
}

#[test]
fn entries_fill_pdos_in_their_order() {
    assert_eq!(
        connected(&[Kit::default(), Kit::default()], vec![link("a.6000", &["b.6200"])]),
        [
            "a TPDO 1 181: 6000:1 6000:2 6000:3 6000:4 6000:5 6000:6 6000:7 6000:8",
            "a TPDO 2 281: 6000:9 6000:A",
            "b RPDO 1 181: 6200:1 6200:2 6200:3 6200:4 6200:5 6200:6 6200:7 6200:8",
            "b RPDO 2 281: 6200:9 6200:A",
        ]
    );
}

#[test]
fn links_with_the_same_nodes_and_parameters_share_a_pdo() {
    let cyclic = |from, to| Link {
        parameters: LinkParameters { transmission: Some(1), ..LinkParameters::default() },
        ..link(from, &[to])
    };
    let kits = [Kit::default(), Kit::default(), Kit::default()];
    let links = vec![
        link("a.6000:1-2", &["b.6200:1-2"]),
        link("a.6401:1", &["c.6411:1"]),
        cyclic("a.6000:4", "b.6200:4"),
        link("a.Array 6401:2", &["b.Array 6411:2"]),
    ];
    assert_eq!(
        connected(&kits, links),
        [
            "a TPDO 1 181: 6000:1 6000:2 6401:2",
            "a TPDO 2 281: 6401:1",
            "a TPDO 3 381: 6000:4",
            "b RPDO 1 181: 6200:1 6200:2 6411:2",
            "b RPDO 2 381: 6200:4",
            "c RPDO 1 281: 6411:1",
        ]
    );
}

#[test]
fn an_entry_is_sent_once_and_gaps_have_dummies() {
    let with_dummies = Kit { dummies: vec![5, 6], ..Kit::default() };
    let links = || {
        vec![
            link("a.6000:1-5", &["b.6200:1-5"]),
            link("a.6000:1", &["c.6200:1"]),
            link("a.6000:5", &["c.6200:5"]),
        ]
    };
    assert_eq!(
        connected(&[Kit::default(), Kit::default(), with_dummies], links()),
        [
            "a TPDO 1 181: 6000:1 6000:2 6000:3 6000:4 6000:5",
            "b RPDO 1 181: 6200:1 6200:2 6200:3 6200:4 6200:5",
            "c RPDO 1 181: 6200:1 6:0 5:0 6200:5",
        ]
    );
    // without dummies, the consumer gets a separate PDO
    assert_eq!(
        connected(&[Kit::default(), Kit::default(), Kit::default()], links())[1..],
        [
            "a TPDO 2 281: 6000:1 6000:5",
            "b RPDO 1 181: 6200:1 6200:2 6200:3 6200:4 6200:5",
            "c RPDO 1 281: 6200:1 6200:5"
        ]
    );
}

#[test]
fn the_rest_of_a_frame_has_dummies_where_there_is_room() {
    let links = || vec![link("a.6000:1-5", &["b.6200:1-5"]), link("a.6000:1-2", &["c.6200:1-2"])];
    let consumer = |slots, dummies| {
        let kit = Kit { slots, dummies, ..Kit::default() };
        connected(&[Kit::default(), Kit::default(), kit], links()).pop().unwrap()
    };
    assert_eq!(consumer(8, vec![5, 6]), "c RPDO 1 181: 6200:1 6200:2 6:0 5:0");
    assert_eq!(consumer(4, vec![5, 6]), "c RPDO 1 181: 6200:1 6200:2 6:0 5:0");
    assert_eq!(consumer(3, vec![5, 6]), "c RPDO 1 181: 6200:1 6200:2");
    assert_eq!(consumer(8, Vec::new()), "c RPDO 1 181: 6200:1 6200:2");
}

#[test]
fn pdos_that_carry_an_entry_by_default_come_first_and_others_stay() {
    let mapped = Kit {
        mapped: vec![(0x1A00, vec![0x6401_0110]), (0x1A02, vec![0x6000_0108, 0x6000_0208])],
        ..Kit::default()
    };
    let kits = [mapped, Kit::default(), Kit::default()];
    let links = [("a.6000:1", "b.6200:1"), ("a.2000", "c.2005"), ("a.6401:2", "b.6411:2")];
    let links = |count| links[..count].iter().map(|(from, to)| link(from, &[to])).collect::<Vec<_>>();
    assert_eq!(connected(&kits, links(1)), ["a TPDO 3 381: 6000:1", "b RPDO 1 381: 6200:1"]);
    // TPDO 2 maps nothing, TPDO 1 is not needed
    assert_eq!(
        connected(&kits, links(2)),
        ["a TPDO 3 381: 6000:1", "a TPDO 2 281: 2000:0", "b RPDO 1 381: 6200:1", "c RPDO 1 281: 2005:0"]
    );
    let with_last: Vec<_> = connected(&kits, links(3));
    assert_eq!(with_last[0], "a TPDO 3 381: 6000:1 6401:2", "the PDO of the same nodes has room");
}

#[test]
fn fixed_mappings_are_respected() {
    let inputs = (1..=4).map(|sub| 0x6000_0008 | sub << 8).collect::<Vec<u32>>();
    let outputs = (1..=2).map(|sub| 0x6200_0008 | sub << 8).collect::<Vec<u32>>();
    let sender =
        Kit { mapped: vec![(0x1A01, inputs)], fixed: vec![0x1A00, 0x1A01, 0x1A02, 0x1A03], ..Kit::default() };
    let receiver = Kit {
        mapped: vec![(0x1602, outputs)],
        fixed: vec![0x1600, 0x1601, 0x1602],
        rpdos: 3,
        ..Kit::default()
    };
    let with_dummies = Kit { dummies: vec![5], ..Kit::default() };
    assert_eq!(
        connected(&[sender.clone(), with_dummies], vec![link("a.6000:2-3", &["b.6200:1-2"])]),
        ["a TPDO 2 281: 6000:1 6000:2 6000:3 6000:4", "b RPDO 1 281: 5:0 6200:1 6200:2 5:0"]
    );
    assert_eq!(
        connected(&[sender.clone(), receiver.clone()], vec![link("a.6000:1-2", &["b.6200:1-2"])]),
        ["a TPDO 2 281: 6000:1 6000:2 6000:3 6000:4", "b RPDO 3 281: 6200:1 6200:2"]
    );
    // the producer follows the consumer, and the other finds no PDO there
    assert_eq!(
        connected(&[Kit::default(), receiver.clone()], vec![link("a.6000:1-2", &["b.6200:1-2"])]),
        ["a TPDO 1 181: 6000:1 6000:2", "b RPDO 3 181: 6200:1 6200:2"]
    );
    assert_eq!(
        found(&[Kit::default(), receiver], vec![link("a.6000:1-3", &["b.6200:1-3"])]),
        ["fixed-pdo: no RPDO of `b` can be configured to carry `6200:3` as linked"]
    );
    assert_eq!(
        found(&[sender, Kit::default()], vec![link("a.6000:2-3", &["b.6200:1-2"])]),
        ["fixed-pdo: no RPDO of `b` can be configured to carry `6200:1` as linked"]
    );
}

#[test]
fn fixed_cob_ids_are_respected() {
    let mapped = vec![(0x1600, vec![0x6200_0108]), (0x1A00, vec![0x6000_0108])];
    let kit = Kit { mapped, tpdos: 1, rpdos: 1, ..Kit::default() };
    let fixed = |index| Kit { fixed: vec![index], ..kit.clone() };
    let links = || vec![link("a.6000:1", &["b.6200:1"])];
    assert_eq!(connected(&[Kit::default(), fixed(0x1400)], links()), ["a TPDO 1 202: 6000:1"]);
    assert_eq!(
        found(&[fixed(0x1800), fixed(0x1400)], links()),
        ["fixed-pdo: no RPDO of `b` can be configured to carry `6200:1` as linked"]
    );
    let demanded = |can_id| {
        let parameters = LinkParameters { can_id: Some(can_id), ..LinkParameters::default() };
        vec![Link { parameters, ..link("a.6000:1", &["b.6200:1"]) }]
    };
    assert_eq!(connected(&[fixed(0x1800), Kit::default()], demanded(0x181)), ["b RPDO 1 181: 6200:1"]);
    assert_eq!(
        found(&[fixed(0x1800), Kit::default()], demanded(0x182)),
        ["fixed-pdo: no TPDO of `a` can be configured to carry `6000:1` as linked"]
    );
}

/// A PDO that cannot be disabled keeps its mapping and its inhibit time.
#[test]
fn a_constant_cob_id_keeps_the_mapping() {
    let fixed = |index| Kit { fixed: vec![index], tpdos: 1, rpdos: 1, ..Kit::default() };
    let links = || vec![link("a.6000:1", &["b.6200:1"])];
    let refused = |node, pdo, entry| {
        vec![format!("fixed-pdo: no {pdo} of `{node}` can be configured to carry `{entry}` as linked")]
    };
    assert_eq!(found(&[Kit::default(), fixed(0x1400)], links()), refused("b", "RPDO", "6200:1"));
    assert_eq!(found(&[fixed(0x1800), Kit::default()], links()), refused("a", "TPDO", "6000:1"));
    let mapped = Kit { mapped: vec![(0x1A00, vec![0x6000_0108])], ..fixed(0x1800) };
    let parameters = LinkParameters { inhibit_time: Some(10), ..LinkParameters::default() };
    let slow = vec![Link { parameters, ..link("a.6000:1", &["b.6200:1"]) }];
    assert_eq!(found(&[mapped, Kit::default()], slow), refused("a", "TPDO", "6000:1"));
}

/// A link with a CAN-ID becomes one PDO.
#[test]
fn a_link_with_a_can_id_is_not_split() {
    let narrow = Kit { slots: 2, ..Kit::default() };
    let parameters = LinkParameters { can_id: Some(0x285), ..LinkParameters::default() };
    let links = vec![Link { parameters, ..link("a.6000:1-4", &["b.6200:1-4"]) }];
    assert_eq!(
        found(&[narrow, Kit::default()], links),
        ["link-too-long: TPDO 1 of `a` carries 2 of 4 entries that are linked with the CAN-ID 285h"]
    );
}

#[test]
fn can_ids_come_from_both_nodes_and_then_from_the_free_ranges() {
    let many = Kit { tpdos: 6, rpdos: 6, ..Kit::default() };
    let links: Vec<Link> = (1..=6)
        .map(|sub| Link {
            parameters: LinkParameters { event_timer: Some(sub), ..LinkParameters::default() },
            ..link(&format!("a.6000:{sub}"), &[&format!("b.6200:{sub}")])
        })
        .collect();
    let ids = |kits: &[Kit]| {
        let mut network = network(kits, links.clone());
        // the network file configures TPDO 1 of `a`, and sends other data with the CAN-ID of TPDO 2
        let pdo = PdoName { kind: PdoKind::Tpdo, number: 1 };
        let said = |id| Some(Said::new(RequestedCobId::Number(id), Span::default()));
        network.nodes[0]
            .pdos
            .push(PdoRequest { cob_id: said(0x281), ..PdoRequest::new(pdo, Span::default()) });
        connect(&mut network, &mut Findings::new());
        let requests = network.nodes[0].pdos.iter().skip(1);
        requests.map(|request| (request.pdo.number, cob_id(request))).collect::<Vec<_>>()
    };
    // TPDO 2 uses the CAN-ID of RPDO 1 of `b`, TPDO 5 that of its RPDO 4, TPDO 6 a free one; the sixth link
    // has no PDO
    assert_eq!(ids(&[many.clone(), many]), [(2, 0x202), (3, 0x381), (4, 0x481), (5, 0x502), (6, 0x680)]);
}

#[test]
fn bit_30_belongs_to_the_producer() {
    let mut network = network(&[Kit::default(), Kit::default()], vec![link("a.6000:1", &["b.6200:1"])]);
    for node in &mut network.nodes {
        for (index, cob_id) in [(0x1400, 0x4000_0200), (0x1800, 0x4000_0180)] {
            let entry = node.device.objects.get_mut(&index).unwrap().subs.get_mut(1).unwrap();
            entry.default = Some(CobId::per_node(cob_id).unwrap().to_value());
        }
    }
    connect(&mut network, &mut Findings::new());
    assert_eq!(shown(&network), ["a TPDO 1 40000181: 6000:1", "b RPDO 1 181: 6200:1"]);
}

#[test]
fn parameters_reach_both_nodes() {
    let parameters = LinkParameters {
        transmission: Some(252),
        inhibit_time: Some(50),
        event_timer: Some(100),
        can_id: Some(0x1_8000),
    };
    let deadline = Some(Said::new(300, Span::default()));
    let links = vec![Link { parameters, deadline, ..link("a.6000:1", &["b.6200:1"]) }];
    let mut network = network(&[Kit::default(), Kit::default()], links);
    connect(&mut network, &mut Findings::new());
    let value = |said: Option<Said<u16>>| said.map(|said| said.value);
    let [sent, received] = [&network.nodes[0].pdos[0], &network.nodes[1].pdos[0]];
    assert_eq!((cob_id(sent), cob_id(received)), (0x2001_8000, 0x2001_8000));
    assert_eq!(sent.transmission.unwrap().value, 252);
    assert_eq!(received.transmission.unwrap().value, 255, "an RPDO has no type for requests");
    assert_eq!(
        (value(sent.inhibit_time), value(sent.event_timer), value(sent.deadline)),
        (Some(50), Some(100), None)
    );
    assert_eq!((value(received.event_timer), value(received.deadline)), (None, Some(300)));
}

#[test]
fn what_cannot_be_linked_is_reported() {
    let can_id = |id, from| {
        let parameters = LinkParameters { can_id: Some(id), ..LinkParameters::default() };
        Link { parameters, ..link(from, &["b.6200:1-A"]) }
    };
    let few = Kit { tpdos: 1, rpdos: 1, ..Kit::default() };
    for (links, expected) in [
        (vec![link("x.6000:1", &["b.6200:1"])], "unknown-node: unknown node `x`"),
        (vec![link("a.6001:1", &["b.6200:1"])], "unknown-entry: `a` has no entry `6001:1`"),
        (vec![link("a.6000:B", &["b.6200:1"])], "unknown-entry: `a` has no entry `6000:B`"),
        (vec![link("a.Inputs", &["b.6200:1"])], "unknown-entry: `a` has no entry `Inputs`"),
        (vec![link("a.Array", &["b.6200:1"])], "unknown-entry: `Array` names several entries of `a`"),
        (vec![link("a.6200:1", &["b.6200:1"])], "link-direction: `a` cannot send `6200:1`"),
        (vec![link("a.6000:1", &["b.6000:1"])], "link-direction: `b` cannot receive `6000:1`"),
        (vec![link("a.2002", &["b.6200:1"])], "link-direction: no PDO of `a` can carry `2002:0`"),
        (vec![link("a.6000:1", &["a.6200:1"])], "link-direction: `a` is linked to itself"),
        (vec![link("a.6000:1-5", &["b.6200:1-4"])], "link-mismatch: 5 entries are linked to 4"),
        (vec![link("a.6000:1", &["b.6411:1"])], "link-mismatch: `6000:1` has 8 bits, but `6411:1` has 16"),
        (vec![link("a.2000", &["b.6411:1"])], "link-type: `2000:0` is UNSIGNED16, `6411:1` is INTEGER16"),
        (
            vec![can_id(0x300, "a.6000")],
            "link-too-long: 80 bits are linked with one CAN-ID, but a PDO has at most 64",
        ),
        (
            vec![
                link("a.6000:1", &["b.6200:1"]),
                link("b.6000:1", &["a.6200:1"]),
                link("a.6000:2", &["c.6200:1"]),
            ],
            "no-free-pdo: `a` has no TPDO left for `6000:2`",
        ),
        (
            vec![link("a.6000:1", &["b.6200:1"]), link("c.6000:1", &["b.6200:2"])],
            "no-free-pdo: `b` has no RPDO left for `6200:2`",
        ),
    ] {
        assert_eq!(found(&[few.clone(), few.clone(), few.clone()], links), [expected]);
    }
}

/// Any kit, with entries that may or may not be mappable.
fn kits() -> impl Strategy<Value = Vec<Kit>> {
    let dummies = prop::sample::subsequence(vec![1, 5, 6, 7], 0..=4);
    let fixed = prop::sample::subsequence(vec![0x1400, 0x1600, 0x1601, 0x1800, 0x1A00], 0..=2);
    let kit = (4..9_u16, 6..13_u16, 2..9_u8, dummies, fixed, any::<bool>());
    let kit = kit.prop_map(|(tpdos, rpdos, slots, dummies, fixed, is_mapped)| {
        // a PDO that already matches the link, with a constant COB-ID, is not configured
        let is_mapped = is_mapped && !fixed.contains(&0x1800);
        let mapped = vec![(0x1A00, vec![0x6000_0108, 0x6000_0208]), (0x1601, vec![0x6200_0108])];
        Kit { tpdos, rpdos, slots, dummies, fixed, mapped: if is_mapped { mapped } else { Vec::new() } }
    });
    prop::collection::vec(kit, 2..6)
}

/// A link of up to four inputs to outputs: producer, consumers, sub-indexes, transmission type.
type Drawn = (usize, Vec<usize>, u8, u8, u8, Option<u8>);

fn drawn() -> impl Strategy<Value = Vec<Drawn>> {
    let nodes = prop::collection::vec(0..6_usize, 1..3);
    prop::collection::vec((0..6_usize, nodes, 1..8_u8, 1..8_u8, 0..3_u8, prop::option::of(0..2_u8)), 1..9)
}

fn links(drawn: &[Drawn], nodes: usize) -> Vec<Link> {
    let name = |node: usize| char::from(b'a' + u8::try_from(node % nodes).unwrap());
    let links = drawn.iter().map(|(from, to, sub, to_sub, more, transmission)| {
        let to: Vec<String> = to
            .iter()
            .filter(|to| **to % nodes != from % nodes)
            .map(|to| format!("{}.6200:{to_sub:X}-{:X}", name(*to), to_sub + more))
            .collect();
        let to: Vec<&str> = to.iter().map(String::as_str).collect();
        let parameters = LinkParameters { transmission: *transmission, ..LinkParameters::default() };
        Link { parameters, ..link(&format!("{}.6000:{sub:X}-{:X}", name(*from), sub + more), &to) }
    });
    links.filter(|link| !link.to.is_empty()).collect()
}

/// The sub-indexes of a link end with a range.
fn subs(end: &LinkEnd) -> std::ops::RangeInclusive<u8> {
    end.entries.clone().and_then(|entries| entries.subs).unwrap()
}

/// The positions of a node's entry in PDOs: COB-ID without flags and first bit.
fn positions(node: &Node, kind: PdoKind, index: u16) -> BTreeMap<u8, BTreeSet<(u32, u32)>> {
    let mut positions: BTreeMap<u8, BTreeSet<(u32, u32)>> = BTreeMap::new();
    for request in node.pdos.iter().filter(|request| request.pdo.kind == kind) {
        let mut bit = 0;
        for object in mapping(node, request) {
            if object.index == index {
                positions.entry(object.sub).or_default().insert((cob_id(request) & 0x3FFF_FFFF, bit));
            }
            bit += u32::from(object.bits);
        }
        assert!(bit <= 64);
    }
    positions
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 256, ..ProptestConfig::default() })]

    #[test]
    fn linked_entries_are_at_the_same_bits(kits in kits(), drawn in drawn()) {
        let mut network = network(&kits, links(&drawn, kits.len()));
        let mut findings = Findings::new();
        connect(&mut network, &mut findings);
        let of = |name: &str| network.nodes.iter().find(|node| node.name.value == name).unwrap();
        let mut senders = BTreeMap::new();
        for node in &network.nodes {
            let names: BTreeSet<_> = node.pdos.iter().map(|request| request.pdo).collect();
            prop_assert_eq!(names.len(), node.pdos.len(), "a PDO is used once");
            for request in node.pdos.iter().filter(|request| request.pdo.kind == PdoKind::Tpdo) {
                let sender = (&node.name.value, request.pdo);
                prop_assert_eq!(senders.insert(cob_id(request) & 0x3FFF_FFFF, sender), None);
            }
        }
        if !findings.is_empty() {
            return Ok(());
        }
        for link in &network.links {
            let sent = positions(of(&link.from.node), PdoKind::Tpdo, 0x6000);
            for to in &link.to {
                let received = positions(of(&to.node), PdoKind::Rpdo, 0x6200);
                let pairs = subs(&link.from).zip(subs(to));
                for (from, to) in pairs {
                    prop_assert!(!sent[&from].is_disjoint(&received[&to]), "{from} to {to}: {:?}", shown(&network));
                }
            }
        }
    }

    #[test]
    fn a_node_at_the_end_changes_no_other(kits in kits(), first in drawn(), more in drawn()) {
        let old = kits.len() - 1;
        let links_of_old = links(&first, old.max(1));
        let mut before = network(&kits[..old], links_of_old.clone());
        let last = char::from(b'a' + u8::try_from(old).unwrap()).to_string();
        let of_new = links(&more, kits.len()).into_iter();
        let of_new = of_new.filter(|link| link.from.node == last || link.to.iter().all(|to| to.node == last));
        let mut after = network(&kits, links_of_old.into_iter().chain(of_new).collect());
        connect(&mut before, &mut Findings::new());
        connect(&mut after, &mut Findings::new());
        let kept: BTreeSet<String> = shown(&after).into_iter().collect();
        for line in shown(&before) {
            prop_assert!(kept.contains(&line), "{line} is not in {kept:?}");
        }
    }
}
