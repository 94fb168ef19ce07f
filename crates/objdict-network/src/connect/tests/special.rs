//! Obstacles of PDOs, managers without a description, and PDOs that no link uses.

use super::{Kit, connect, link, network, shown};
use crate::configure::{PdoName, Setting};
use crate::diagnostic::{At, Findings};
use crate::model::PdoKind;
use crate::source::Span;
use crate::{Link, LinkParameters, Manager, Network, PdoRequest, Said, UnusedPdos};

/// The obstacle of each remaining PDO, with the help.
fn reasons(kits: &[Kit], links: Vec<Link>) -> (Vec<String>, String) {
    let mut network = network(kits, links);
    let mut findings = Findings::new();
    connect(&mut network, &mut findings);
    let of_pdo = findings.iter().find(|finding| finding.rule.id == "network/fixed-pdo");
    let Some(finding) = of_pdo else { panic!("{:?}", shown(&network)) };
    let labels = finding.labels.iter().skip(1).map(|label| match &label.at {
        At::Node(_, place) => format!("{place}: {}", label.text),
        at => panic!("{at:?}"),
    });
    (labels.collect(), finding.help.as_ref().unwrap().to_string())
}

#[test]
fn findings_say_what_is_against_each_pdo() {
    let parameters = |change: fn(&mut LinkParameters)| {
        let mut parameters = LinkParameters::default();
        change(&mut parameters);
        parameters
    };
    let inputs = (1..=4).map(|sub| 0x6000_0008 | sub << 8).collect::<Vec<u32>>();
    let constant = Kit { mapped: vec![(0x1A00, inputs)], fixed: vec![0x1A00], tpdos: 1, ..Kit::default() };
    let narrow = Kit { slots: 2, rpdos: 2, ..Kit::default() };
    let without_mapping = Kit { fixed: vec![0x1A00], tpdos: 1, ..Kit::default() };
    let locked = Kit { fixed: vec![0x1800], tpdos: 1, ..Kit::default() };
    let with_can_id = Kit { mapped: vec![(0x1A00, vec![0x6000_0108])], ..locked.clone() };
    let invalid = Kit { fixed: vec![0x1804], tpdos: 5, ..Kit::default() };
    let four = || link("a.6000:1-4", &["b.6200:1-4"]);
    let one = || link("a.6000:1", &["b.6200:1"]);
    let linked = |change| Link { parameters: parameters(change), ..one() };
    // links of different types do not share a PDO
    let taking = |count: u8| -> Vec<Link> {
        let one = |number| Link {
            parameters: LinkParameters { transmission: Some(number), ..LinkParameters::default() },
            ..link(&format!("a.6000:{number}"), &["c.6200:1"])
        };
        (1..=count).map(one).collect()
    };
    /// Nodes, links, the obstacle of each PDO, and the help.
    type Row<'a> = (Vec<Kit>, Vec<Link>, &'a [&'a str], &'a str);
    let rows: Vec<Row<'_>> = vec![
        (
            vec![constant.clone(), narrow],
            vec![four()],
            &["0x1600: room for 2 of 4 entries", "0x1601: room for 2 of 4 entries"],
            "link fewer entries (RPDO 1, RPDO 2: room for 2 of 4 entries)",
        ),
        (
            vec![constant, Kit { dummies: vec![6], rpdos: 1, ..Kit::default() }],
            vec![link("a.6000:2-3", &["b.6200:2-3"])],
            &["DummyUsage: no dummy fills a gap of 8 bits"],
            "let the consumer receive the entries of the gap too (RPDO 1: no dummy fills a gap of 8 bits)",
        ),
        (
            vec![without_mapping, Kit::default()],
            vec![one()],
            &["0x1A00: the mapping is constant"],
            "link the entries that the PDO carries by default (TPDO 1: the mapping is constant)",
        ),
        (
            vec![locked, Kit::default()],
            vec![one()],
            &["0x1800sub1 / DefaultValue: the COB-ID is constant, so the mapping cannot change"],
            "link the entries that the PDO carries by default (TPDO 1: the COB-ID is constant, so the mapping cannot change)",
        ),
        (
            vec![with_can_id, Kit::default()],
            vec![linked(|of| of.can_id = Some(0x1A1))],
            &["0x1800sub1 / DefaultValue: the CAN-ID 181h is constant"],
            "link it with this CAN-ID (TPDO 1: the CAN-ID 181h is constant)",
        ),
        (
            vec![invalid, Kit::default(), Kit::default()],
            taking(4).into_iter().chain([link("a.6000:9", &["b.6200:1"])]).collect(),
            &["0x1804sub1 / DefaultValue: not valid, and the COB-ID is constant"],
            "transfer them by SDO instead (TPDO 5: not valid, and the COB-ID is constant)",
        ),
    ];
    for (kits, links, labels, help) in rows {
        assert_eq!(
            reasons(&kits, links),
            (labels.iter().map(ToString::to_string).collect(), help.to_owned())
        );
    }
}

/// Like `connect`, with a manager that has no description.
fn with_manager(kits: &[Kit], links: Vec<Link>) -> (Network, Vec<String>) {
    let mut network = network(kits, links);
    let name = Said::new("plc".to_owned(), Span::default());
    network.manager = Some(Manager { name, ..Manager::default() });
    let mut findings = Findings::new();
    connect(&mut network, &mut findings);
    let found = findings.iter().map(|finding| format!("{}: {}", finding.rule.name(), finding.message));
    let found = found.collect();
    (network, found)
}

#[test]
fn a_manager_without_a_description_has_the_other_side() {
    let timed = |from, to: &[&str]| Link {
        parameters: LinkParameters {
            transmission: Some(253),
            inhibit_time: Some(50),
            event_timer: Some(200),
            ..LinkParameters::default()
        },
        deadline: Some(Said::new(300, Span::default())),
        ..link(from, to)
    };
    let kits = [Kit { tpdos: 1, rpdos: 2, ..Kit::default() }, Kit::default()];
    let links = vec![
        timed("a.6000:1-2", &["plc"]),
        link("plc", &["a.6200:1-3", "b.6200:1-3"]),
        timed("plc", &["a.6411:1-2"]),
        link("plc", &["a.6200:3-4"]),
        // the manager receives the messages between nodes
        link("b.6000:1", &["plc", "a.6200:5"]),
    ];
    let (connected, found) = with_manager(&kits, links);
    assert_eq!(found, ["no-free-pdo: `a` has no RPDO left for `6200:5`"]);
    assert_eq!(
        shown(&connected),
        [
            "a RPDO 1 201: 6200:1 6200:2 6200:3 6200:4",
            "a RPDO 2 301: 6411:1 6411:2",
            "a TPDO 1 181: 6000:1 6000:2",
            "b RPDO 1 202: 6200:1 6200:2 6200:3",
        ]
    );
    let times = |request: &PdoRequest| {
        let time = |said: Option<Said<u16>>| said.map(|said| said.value);
        (
            request.transmission.map(|said| said.value),
            time(request.inhibit_time),
            time(request.event_timer),
            time(request.deadline),
        )
    };
    let pdos = &connected.nodes[0].pdos;
    assert_eq!(times(&pdos[0]), (None, None, None, None));
    // data from the manager is event-driven for the node
    assert_eq!(times(&pdos[1]), (Some(255), Some(50), Some(200), Some(300)));
    assert_eq!(times(&pdos[2]), (Some(253), Some(50), Some(200), Some(300)));
}

#[test]
fn ends_without_entries_are_those_of_a_manager_without_a_description() {
    let with_can_id = Link {
        parameters: LinkParameters { can_id: Some(0x300), ..LinkParameters::default() },
        ..link("plc", &["a.6200:1", "b.6200:1"])
    };
    for (link, expected) in [
        (link("plc", &["plc"]), "link-direction: `plc` is linked to itself"),
        (link("a", &["plc"]), "unknown-entry: the link has no entries of `a`"),
        (link("plc", &["a"]), "unknown-entry: the link has no entries of `a`"),
        (link("x", &["plc"]), "unknown-node: unknown node `x`"),
        (
            link("a.6000:1", &["plc.2000:1"]),
            "unknown-node: the manager `plc` has no description and so no entries",
        ),
        (with_can_id, "link-too-long: `plc` sends a PDO to each of 2 consumers"),
    ] {
        assert_eq!(with_manager(&[Kit::default(), Kit::default()], vec![link]).1, [expected]);
    }
}

#[test]
fn pdos_without_a_link_and_without_a_key_are_switched_off() {
    let kit = Kit { fixed: vec![0x1803], tpdos: 5, ..Kit::default() };
    let mut network = network(&[kit, Kit::default()], vec![link("a.6000:1", &["b.6200:1"])]);
    network.unused_pdos = Some(Said::new(UnusedPdos::Off, Span::new(7, 9)));
    network.nodes[1].unused_pdos = Some(Said::new(UnusedPdos::Keep, Span::default()));
    let set = Setting::value("1802:5=100").unwrap();
    network.nodes[0].settings.push(Said::new(set, Span::new(3, 4)));
    let rpdo = PdoName { kind: PdoKind::Rpdo, number: 3 };
    network.nodes[0].pdos.push(PdoRequest::new(rpdo, Span::new(5, 6)));
    let mut findings = Findings::new();
    connect(&mut network, &mut findings);
    let found: Vec<_> = findings.iter().map(|finding| finding.message.to_string()).collect();
    assert_eq!(found, ["`a` cannot switch off PDOs with a constant COB-ID: TPDO 4"]);
    let off = network.nodes[0].pdos.iter().filter(|request| !request.enabled);
    let off: Vec<_> = off.map(|request| format!("{} at {}", request.pdo, request.at.start)).collect();
    // TPDO 1 is linked, TPDO 3 has a setting and RPDO 3 a key; TPDO 5 is not valid
    assert_eq!(off, ["rpdo1 at 7", "rpdo2 at 7", "rpdo4 at 7", "tpdo2 at 7"]);
    assert!(network.nodes[1].pdos.iter().all(|request| request.enabled));
    let compiled = crate::compile(&network, crate::DcfgenMode::Corrected);
    let valid = compiled.slaves[0].pdos.iter().filter(|state| state.cob_id >> 31 == 0);
    assert_eq!(
        valid.map(|state| state.pdo.to_string()).collect::<Vec<_>>(),
        ["rpdo3", "tpdo1", "tpdo3", "tpdo4"]
    );
}
