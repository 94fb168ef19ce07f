use std::path::Path;

use super::*;
use crate::log::LogOptions;
use objdict_format::open;
use objdict_model::diagnostic::At;

fn logs(texts: &[&'static str]) -> MergedLogs<&'static [u8]> {
    let log = |text: &&'static str| NamedLog::new("log".to_owned(), text.as_bytes(), LogOptions::default());
    MergedLogs(texts.iter().map(log).collect())
}

/// Descriptions of the drive of the fixtures (vendor 3F9h, product 402h), so many, without a node-ID.
fn drives(count: usize) -> Descriptions {
    let path = Path::new("../../fixtures/eds/drive-402.eds");
    let device = open(path, &Default::default()).unwrap().device().clone();
    let mut found = Descriptions::default();
    for number in 1..=count {
        found.add_device(device.clone(), None, path, format!("{number}.eds"));
    }
    found
}

/// What is said of the nodes of descriptions, and the names of the nodes 5 and 7 then.
fn found(descriptions: &Descriptions, log: &'static str) -> (Vec<String>, [String; 2]) {
    let mut buses = Buses::new(&[], descriptions);
    let notes = buses.find(&mut logs(&[log])).unwrap();
    (notes, [5, 7].map(|node_id| buses.all[0].reader.name(node_id)))
}

#[test]
fn logs_are_merged_by_their_times() {
    let mut logs = logs(&[
        "(1.0) can0 080#\n(3.0) can0 081#\n(4.0) can0 082#\n",
        "(2.0) can1 083#\n(3.0) can0 084#\nnothing\n",
    ]);
    let none = Descriptions::default();
    let mut buses = Buses::new(&[], &none);
    let mut order = Vec::new();
    while let Some((log, frame)) = logs.next_frame().unwrap() {
        let bus = buses.of(log, &frame, &logs);
        order.push((frame.can_id, log, buses.all[bus].channel.clone()));
    }
    let expected =
        [(0x80, 0, "can0"), (0x83, 1, "can1"), (0x81, 0, "can0"), (0x84, 1, "can0"), (0x82, 0, "can0")];
    assert_eq!(order, expected.map(|(can_id, log, channel)| (can_id, log, channel.to_owned())));
    assert_eq!((logs.0[1].reader.bad_count(), buses.all.len()), (1, 2));
}

#[test]
fn the_only_node_is_assumed() {
    let (notes, names) = found(&drives(1), "(1.0) can0 705#05\n(2.0) can0 187#00\n");
    assert_eq!(notes, ["`1.eds` is taken for node 5, the only one in the log without a description"]);
    assert_eq!(names, ["drive-402", "node 7"]);
    let (notes, names) = found(&drives(1), "(1.0) can0 705#05\n(2.0) can0 707#05\n");
    assert_eq!(
        notes,
        ["`1.eds` does not say which node it describes: the log has 5, 7; write `--with 5=1.eds`"]
    );
    assert_eq!(names, ["node 5", "node 7"]);
    let (notes, _) = found(&drives(2), "(1.0) can0 705#05\n");
    assert_eq!(notes, [""; 0]);
}

#[test]
fn nodes_are_found_by_their_answers() {
    let log = "(1.0) can0 705#05\n(1.1) can0 707#05\n(2.0) can0 587#4318100102040000\n\
        (2.1) can0 585#43181001F9030000\n(2.2) can0 585#4318100202040000\n";
    let (notes, names) = found(&drives(1), log);
    assert_eq!(notes, ["`1.eds` describes node 5, by its responses to 1000h and 1018h"]);
    assert_eq!(names, ["drive-402", "node 7"]);
    let (notes, names) = found(&drives(1), "(1.0) can0 585#4318100102040000\n");
    assert_eq!(notes, ["`1.eds` does not describe node 5, whose identity (1000h, 1018h) differs"]);
    assert_eq!(names, ["node 5", "node 7"]);
}

/// What a log says beside descriptions.
fn report(descriptions: &Descriptions, log: &'static str) -> BusReport {
    let mut buses = Buses::new(&[], descriptions);
    buses.find(&mut logs(&[log])).unwrap();
    let (mut logs, mut sums) = (logs(&[log]), BusSums::new(Some(125)));
    while let Some((log, frame)) = logs.next_frame().unwrap() {
        let at = buses.of(log, &frame, &logs);
        let decoded = buses.all[at].decode(&frame);
        sums.add(&decoded, &frame, logs.origin(log), &buses.all[at]);
    }
    sums.report(&buses.all[0])
}

/// The rules that a log is against, and what is said; so many drives are described.
fn against(drive_count: usize, log: &'static str) -> Vec<(&'static str, String)> {
    let (_, found) = findings(&[report(&drives(drive_count), log)], 0, "a.log".to_owned());
    found.iter().map(|finding| (finding.rule.id, finding.message.to_string())).collect()
}

#[test]
fn heartbeats_that_are_late() {
    // node 5 says that its heartbeat comes each 100 ms
    let report = report(
        &Descriptions::default(),
        "(0.0) can0 605#4017100000000000\n(0.01) can0 585#4B17100064000000\n(0.1) can0 705#05\n\
        (0.2) can0 705#05\n(0.4) can0 705#05\n(0.45) can0 705#00\n(0.9) can0 705#05\n(1.2) can0 080#\n",
    );
    let texts: Vec<_> = report.findings.iter().map(|event| &*event.text).collect();
    let expected = [
        "node 5: no heartbeat for 200.000 ms, limit 150.000 ms",
        "node 5: no heartbeat for 300.000 ms, limit 150.000 ms, until the end of the log",
    ];
    assert_eq!(texts, expected);
    assert_eq!((report.frames, &*report.undescribed), (8, &[5][..]));
    let reports = [report];
    let of_log = |log| findings(&reports, log, "a.log".to_owned());
    assert!(of_log(1).1.is_empty());
    // they are at the last heartbeat before, the fourth and the seventh line
    let (lines, found) = of_log(0);
    let places = found.iter().map(|finding| {
        let At::Span(span) = finding.labels[0].at else { unreachable!("a place in a log") };
        (finding.rule.id, lines.line_column(span.start).line, span.of(lines.text()))
    });
    let expected = [(4, "(0.2) can0 705#05"), (7, "(0.9) can0 705#05")];
    assert!(places.eq(expected.map(|(line, text)| ("traffic/late-heartbeat", line, text))));
}

/// A log that is against each rule, and one that differs in what is right.
#[test]
fn each_rule_has_a_log_that_is_against_it() {
    const SYNC: &str = "(0.0) can0 605#23071000D0070000\n(0.1) can0 585#6007100000000000\n\
        (0.2) can0 605#2F00180201000000\n(0.3) can0 585#6000180200000000\n(1.0) can0 080#\n";
    let after_sync = |pdo: &str| &*Box::leak(format!("{SYNC}{pdo}").into_boxed_str());
    let enabling = |status: &str| {
        let word = |at| if at < 20 { "310201" } else { status };
        let words: String =
            (10..32).map(|at| format!("({}.{}) can0 185#{}\n", at / 10, at % 10, word(at))).collect();
        &*Box::leak(format!("(0.9) can0 205#0F0001\n{words}").into_boxed_str())
    };
    let regular = |end: &str| {
        let pdos: String = (0..30).map(|at| format!("(1.{at:02}) can0 187#01\n")).collect();
        &*Box::leak(format!("{pdos}{end}").into_boxed_str())
    };
    let set_point = |status: &str| {
        let words: String = (10..22)
            .map(|at| {
                format!("({}.{}) can0 185#{}\n", at / 10, at % 10, if at < 12 { "370201" } else { status })
            })
            .collect();
        &*Box::leak(
            format!("(0.9) can0 205#0F0001\n{}", words.replace("(1.2)", "(1.15) can0 205#1F0001\n(1.2)"))
                .into_boxed_str(),
        )
    };
    let full = |count: u32| {
        let frames: String =
            (0..count).map(|at| format!("(1.{at:04}) can0 18EBFF05#0011223344556677\n")).collect();
        &*Box::leak((frames + "(1.2) can0 080#\n").into_boxed_str())
    };
    let heartbeats = |distances: [u32; 2]| {
        let mut at = 1000;
        let lines: String = (0..10)
            .map(|count: usize| {
                at += distances[count % 2];
                format!("({}.{:03}) can0 705#05\n", at / 1000, at % 1000)
            })
            .collect();
        &*Box::leak(lines.into_boxed_str())
    };
    let pause = |data: [&str; 2]| {
        let frames: String = (0..60)
            .map(|at| format!("({}.{:02}) can0 187#{}\n", 1 + at / 30 * 2, at % 30, data[at % 2]))
            .collect();
        &*Box::leak(frames.into_boxed_str())
    };
    let switches = |[first, second]: [u8; 2]| {
        let answer = |time: &str, inputs: u8| {
            format!("({time}) can0 605#40FD600000000000\n({time}5) can0 585#43FD6000{inputs:02X}000000\n")
        };
        &*Box::leak((answer("1.1", first) + &answer("1.2", second)).into_boxed_str())
    };
    let cases: [(&str, &str, &str); 42] = [
        ("traffic/pdo-length", "(1.0) can0 185#3702\n", "(1.0) can0 185#370201\n"),
        (
            "traffic/inhibit-time",
            "(1.0) can0 185#370201\n(1.009) can0 185#370201\n",
            // 5 % are tolerated
            "(1.0) can0 185#370201\n(1.0096) can0 185#370201\n",
        ),
        (
            "traffic/sync-window",
            after_sync("(1.003) can0 185#370201\n"),
            after_sync("(1.002) can0 185#370201\n"),
        ),
        (
            "traffic/late-heartbeat",
            "(1.0) can0 705#05\n(1.8) can0 705#05\n",
            "(1.0) can0 705#05\n(1.7) can0 705#05\n",
        ),
        (
            "traffic/sdo-size",
            "(1.0) can0 605#4017100000000000\n(1.1) can0 585#43171000F4010000\n",
            // that only two bytes count, the second one does not say
            "(1.0) can0 605#4017100000000000\n(1.1) can0 585#4B171000F4010000\n\
             (1.2) can0 605#22171000F4010000\n(1.3) can0 585#6017100000000000\n",
        ),
        (
            "traffic/sdo-size",
            "(1.0) can0 605#23171000F4010000\n(1.1) can0 585#6017100000000000\n",
            "(1.0) can0 605#23171000F4010000\n(1.1) can0 585#8017100010000706\n",
        ),
        (
            "traffic/sdo-access",
            "(1.0) can0 605#2300100092010000\n(1.1) can0 585#6000100000000000\n",
            "(1.0) can0 605#2300100092010000\n(1.1) can0 585#8000100002000106\n",
        ),
        (
            "traffic/sdo-limits",
            "(1.0) can0 605#4081600000000000\n(1.1) can0 585#4381600020A10700\n",
            "(1.0) can0 605#4081600000000000\n(1.1) can0 585#43816000E8030000\n",
        ),
        (
            "traffic/event-timer",
            "(0.0) can0 605#2B00180564000000\n(0.1) can0 585#6000180500000000\n\
             (1.0) can0 185#370201\n(1.151) can0 185#370201\n",
            // the node is stopped for a while
            "(0.0) can0 605#2B00180564000000\n(0.1) can0 585#6000180500000000\n\
             (1.0) can0 185#370201\n(1.1) can0 000#0205\n(1.2) can0 000#0105\n(1.21) can0 185#370201\n",
        ),
        (
            "traffic/repeated-pdo",
            after_sync("(1.001) can0 185#370201\n(1.0015) can0 185#370201\n"),
            after_sync("(1.001) can0 185#370201\n(1.02) can0 080#\n(1.0205) can0 185#370201\n"),
        ),
        (
            "traffic/sync-cycle",
            "(0.0) can0 605#23061000204E0000\n(0.1) can0 585#6006100000000000\n(1.0) can0 080#\n(1.031) can0 080#\n",
            "(0.0) can0 605#23061000204E0000\n(0.1) can0 585#6006100000000000\n(1.0) can0 080#\n(1.029) can0 080#\n",
        ),
        (
            "traffic/not-operational",
            "(1.0) can0 000#0106\n(1.1) can0 705#00\n(1.2) can0 185#370201\n(1.3) can0 185#370201\n",
            // the log has no commands: it may lack that one
            "(1.1) can0 705#00\n(1.2) can0 185#370201\n",
        ),
        (
            "traffic/not-operational",
            "(1.0) can0 000#0105\n(1.1) can0 705#7F\n(1.2) can0 185#370201\n",
            // what was to be sent when the node was stopped
            "(1.0) can0 000#0105\n(1.1) can0 000#8005\n(1.101) can0 185#370201\n",
        ),
        (
            "traffic/unexpected-boot-up",
            "(0.9) can0 705#7F\n(1.0) can0 000#0100\n(1.2) can0 705#00\n",
            "(0.9) can0 705#7F\n(1.0) can0 000#0100\n(1.1) can0 000#8105\n(1.2) can0 705#00\n",
        ),
        (
            "traffic/unanswered-request",
            "(0.9) can0 705#7F\n(1.0) can0 605#4018100100000000\n(1.1) can0 605#4018100100000000\n(1.2) can0 585#4318100102040000\n",
            // the log has requests alone
            "(0.9) can0 705#7F\n(1.0) can0 605#4018100100000000\n(1.1) can0 605#4018100100000000\n",
        ),
        (
            "traffic/unanswered-request",
            "(0.9) can0 705#7F\n(1.0) can0 605#4018100100000000\n(1.1) can0 585#4318100102040000\n(1.2) can0 605#4018100200000000\n(3.0) can0 080#\n",
            // the log ends before the answer; a scan asks for nodes that are not there
            "(1.0) can0 605#4018100100000000\n(1.1) can0 585#4318100102040000\n(1.2) can0 608#4018100200000000\n\
             (1.3) can0 609#4018100200000000\n(1.4) can0 60A#4018100200000000\n(1.5) can0 60B#4018100200000000\n\
             (3.0) can0 605#4018100200000000\n",
        ),
        (
            "traffic/broken-transfer",
            "(1.0) can0 605#4008100000000000\n(1.1) can0 585#4108100009000000\n(1.2) can0 605#6000000000000000\n\
             (1.3) can0 585#0053657276203132\n(1.4) can0 605#6000000000000000\n(1.5) can0 585#1B33340000000000\n",
            "(1.0) can0 605#4008100000000000\n(1.1) can0 585#4108100009000000\n(1.2) can0 605#6000000000000000\n\
             (1.3) can0 585#0053657276203132\n(1.4) can0 605#7000000000000000\n(1.5) can0 585#1B33340000000000\n",
        ),
        (
            // a block of three bytes with a checksum
            "traffic/broken-transfer",
            "(1.0) can0 605#C610210003000000\n(1.1) can0 585#A410210002000000\n(1.2) can0 605#8131323300000000\n\
             (1.3) can0 585#A201020000000000\n(1.4) can0 605#D1B3960000000000\n(1.5) can0 585#A100000000000000\n",
            "(1.0) can0 605#C610210003000000\n(1.1) can0 585#A410210002000000\n(1.2) can0 605#8131323300000000\n\
             (1.3) can0 585#A201020000000000\n(1.4) can0 605#D152970000000000\n(1.5) can0 585#A100000000000000\n",
        ),
        (
            "traffic/missing-node",
            "(1.0) can0 608#4018100200000000\n(1.1) can0 605#4018100100000000\n(1.2) can0 585#4318100102040000\n\
             (3.0) can0 080#\n",
            // the log ends before an answer could come
            "(1.0) can0 605#4018100100000000\n(1.1) can0 585#4318100102040000\n(2.9) can0 608#4018100200000000\n\
             (3.0) can0 080#\n",
        ),
        (
            "traffic/refused-write",
            "(1.0) can0 605#2B17100064000000\n(1.1) can0 585#8017100010000706\n",
            // reads may try what there is
            "(1.0) can0 605#4017100000000000\n(1.1) can0 585#8017100000000206\n",
        ),
        (
            "traffic/broken-transfer",
            "(1.0) can0 605#4017100000000000\n(1.1) can0 585#8017100000000405\n",
            "(1.0) can0 605#4017100000000000\n(1.1) can0 585#8017100001000405\n",
        ),
        ("traffic/emergency", "(1.0) can0 085#1032010000000000\n", "(1.0) can0 085#0000000000000000\n"),
        ("traffic/malformed-frame", "(1.0) can0 080#0102\n", "(1.0) can0 080#01\n"),
        ("traffic/error-frames", "(1.0) can0 20000008#0000000000000000\n", "(1.0) can0 080#\n"),
        ("traffic/bus-off", "(1.0) can0 20000040#0000000000000000\n", "(1.0) can0 080#\n"),
        (
            "traffic/repeated-boot",
            "(1.0) can0 707#00\n(2.0) can0 707#00\n(3.0) can0 707#00\n",
            // all are reset at first, and later one is
            "(1.0) can0 707#00\n(2.0) can0 000#8200\n(2.1) can0 707#00\n(3.0) can0 000#8107\n(3.1) can0 707#00\n",
        ),
        (
            "traffic/not-started",
            "(1.0) can0 707#00\n(1.1) can0 706#00\n(1.2) can0 000#0106\n(1.3) can0 707#7F\n(4.0) can0 080#\n",
            // it starts by itself
            "(1.0) can0 707#00\n(1.1) can0 706#00\n(1.2) can0 000#0106\n(1.3) can0 707#05\n(4.0) can0 080#\n",
        ),
        (
            "traffic/silent-node",
            regular("(3.0) can0 080#\n"),
            // a command stops it
            regular("(1.31) can0 000#0207\n(3.0) can0 080#\n"),
        ),
        (
            "traffic/silent-node",
            "(1.0) can0 707#R\n(1.01) can0 707#05\n(2.0) can0 707#R\n(3.0) can0 707#R\n(4.0) can0 707#R\n",
            // guarding that no answer shows
            "(2.0) can0 707#R\n(3.0) can0 707#R\n(4.0) can0 707#R\n",
        ),
        ("traffic/drive-fault", "(1.0) can0 185#180201\n", "(1.0) can0 185#370201\n"),
        (
            "traffic/quick-stop",
            "(0.9) can0 205#0F0001\n(1.0) can0 185#370201\n(1.05) can0 185#170201\n",
            // the controlword asks for it
            "(0.9) can0 205#0F0001\n(1.0) can0 185#370201\n(1.02) can0 205#0B0001\n(1.05) can0 185#170201\n",
        ),
        ("traffic/refused-transition", enabling("310201"), enabling("370201")),
        ("traffic/set-point", set_point("370201"), set_point("371201")),
        // of the mode 9 the bit says nothing
        ("traffic/motion-error", "(1.0) can0 185#372208\n", "(1.0) can0 185#372209\n"),
        ("traffic/internal-limit", "(1.0) can0 185#370A01\n", "(1.0) can0 185#370201\n"),
        // a switch that is active from the beginning may be one that opens
        ("traffic/limit-switch", switches([0, 2]), switches([2, 2])),
        ("traffic/shared-can-id", heartbeats([150, 350]), heartbeats([500, 500])),
        (
            "traffic/shared-can-id",
            "(0.0) can0 605#2301180185010000\n(0.1) can0 585#6001180100000000\n(1.0) can0 185#370201\n",
            "(0.0) can0 605#2301180185010080\n(0.1) can0 585#6001180100000000\n(1.0) can0 185#370201\n",
        ),
        ("traffic/load-peak", full(92), full(80)),
        (
            "traffic/rpdo-deadline",
            "(0.0) can0 605#2B00140564000000\n(0.1) can0 585#6000140500000000\n(1.0) can0 205#060001\n(1.11) can0 205#060001\n",
            "(0.0) can0 605#2B00140564000000\n(0.1) can0 585#6000140500000000\n(1.0) can0 205#060001\n(1.1) can0 205#060001\n",
        ),
        // what is sent on changes alone does not repeat its data
        ("traffic/silent-node", pause(["01", "01"]), pause(["01", "02"])),
        (
            "traffic/sdo-length",
            "(1.0) can0 605#40181001\n(1.1) can0 585#4318100102040000\n",
            "(1.0) can0 605#4018100100000000\n(1.1) can0 585#4318100102040000\n",
        ),
    ];
    // that of a network is in a test of its own, and the nodes that are silent together are found among the incidents
    let others = ["traffic/unknown-node", "traffic/interrupted-bus", "traffic/other-identity"];
    let has_case = |id: &str| others.contains(&id) || cases.iter().any(|case| case.0 == id);
    assert!(RULES.iter().all(|rule| has_case(rule.id)));
    for (rule, bad, good) in cases {
        // the drive has no window, and would be the node that is silent
        let drives =
            usize::from(!["traffic/sync-window", "traffic/silent-node", "traffic/load-peak"].contains(&rule));
        let mut found: Vec<_> = against(drives, bad).into_iter().map(|(id, _)| id).collect();
        // an incident may have several events
        found.dedup();
        assert_eq!(found, [rule], "{bad}");
        // what is right for one rule is a refusal for another
        let mut found = against(drives, good);
        found.retain(|(id, _)| *id == rule || *id != "traffic/refused-write");
        assert_eq!(found, [], "{rule}: {good}");
    }
}

/// What a network does not describe is not in it; of single descriptions nothing follows.
#[test]
fn nodes_that_a_network_does_not_have() {
    const LOG: &str = "(1.0) can0 1A3#0102\n(1.1) can0 1A3#0102\n(1.2) can0 60A#4018100100000000\n";
    let mut network = drives(1);
    network.nodes[0].node_id = Some(5);
    let rules = |descriptions: &Descriptions| {
        let events = report(descriptions, LOG).findings;
        events.into_iter().map(|event| event.text).collect::<Vec<_>>()
    };
    assert_eq!(rules(&network), [""; 0]);
    network.is_network = true;
    assert_eq!(rules(&network), ["node 35 is not in the network, but sends frames"]);
}

/// A node that is described by its node-ID, and answers as another device; of the revision the lower half is free.
#[test]
fn a_node_is_another_device_than_its_description() {
    let mut drive = drives(1);
    drive.nodes[0].node_id = Some(5);
    let texts = |log: &'static str| {
        report(&drive, log).findings.into_iter().map(|event| event.text).collect::<Vec<_>>()
    };
    let text = "drive-402: the vendor-ID is 12h, expected 3F9h: a different device";
    assert_eq!(texts("(1.0) can0 605#4018100100000000\n(1.1) can0 585#4318100112000000\n"), [text]);
    assert_eq!(texts("(1.0) can0 605#4018100100000000\n(1.1) can0 585#43181001F9030000\n"), [""; 0]);
}

/// A PDO that stops while its node goes on, and one that stops with SYNC or by a command.
#[test]
fn cyclic_pdos_that_stop() {
    let log = |pdo_end: u32, more: &str| {
        let beats = |at: u32| {
            if at.is_multiple_of(10) { format!("(1{at:03}.5) can0 707#05\n") } else { String::new() }
        };
        let pdo = |at: u32| if at < pdo_end { format!("(1{at:03}.6) can0 187#01\n") } else { String::new() };
        (0..90).map(|at| beats(at) + &pdo(at) + if at == pdo_end { more } else { "" }).collect::<String>()
    };
    let text =
        "node 7 TPDO 1: not sent for 40900.000 ms, before that every 1000.000 ms, until the end of the log"
            .to_owned();
    assert_eq!(said(&log(40, "")), [(IncidentState::Unresolved, text)]);
    assert_eq!(said(&log(40, "(1040.1) can0 000#0207\n")), []);
    assert_eq!(said(&log(90, "")), []);
}

#[test]
fn findings_are_bounded_and_counted() {
    let log: String =
        (0..250).map(|at| format!("({}.{:02}) can0 185#3702\n", at / 20, at % 20 * 5)).collect();
    let found = against(1, log.leak());
    assert_eq!(found.len(), 100);
    assert_eq!(found[0].1, "0.00: drive-402 TPDO 1 has 2 bytes; 3 are mapped");
    let last = "4.95: drive-402 TPDO 1 has 2 bytes; 3 are mapped (the rule finds 150 more of this node)";
    assert_eq!(found[99].1, last);
}

/// What went wrong in a log, in its order.
fn incidents_of(log: String) -> Vec<Incident> {
    incidents(&mut [report(&Descriptions::default(), log.leak())])
}

fn fixture(name: &str) -> String {
    std::fs::read_to_string(Path::new("../../fixtures/logs").join(name)).unwrap()
}

/// A node that never answers, one that falls silent, a refused setting, and two drives that recover from a fault.
#[test]
fn incidents_are_those_of_the_fixture() {
    let found = incidents_of(fixture("incidents.log"));
    let text = serde_json::to_string_pretty(&found).unwrap() + "\n";
    assert_eq!(text, fixture("incidents.json"), "{text}");
    assert_eq!(verdict(&found), "needs attention: 3 unresolved, 2 recovered");
}

/// Each fault that was planted in two logs is an incident, or the consequence of one.
#[test]
fn planted_faults_are_found() {
    use objdict_network_file::NetworkFile;
    let network = Path::new("../../fixtures/logs/planted.toml");
    let mut descriptions = Descriptions::default();
    descriptions.add_network(&NetworkFile::open(network, &Default::default()).unwrap());
    let lists = ["planted.log", "late.log"].map(|name| {
        let mut found = incidents(&mut [report(&descriptions, fixture(name).leak())]);
        // what is the same for each incident of a kind is in the other list
        let known =
            |incident: &mut Incident| (incident.state.name(), incident.kind.rule.id, incident.text.clone());
        found.iter_mut().map(known).collect::<Vec<_>>()
    });
    let text = serde_json::to_string_pretty(&lists).unwrap() + "\n";
    assert_eq!(text, fixture("planted.json"), "{text}");
    // the request without an answer, and the PDO directly after the boot-up, are consequences of the reset
    let found = report(&descriptions, fixture("planted.log").leak()).findings;
    let has = |rule: &str, line| {
        let mut own = found.iter().filter(|event| event.moment.line == line);
        own.any(|event| event.rule.is_some_and(|of| of.id == rule))
    };
    assert!(has("traffic/unanswered-request", 33) && has("traffic/not-operational", 38));
}

/// Numbers and fingerprints are the same in a log of another day, and of another length.
#[test]
fn incidents_are_known_again() {
    let log = fixture("incidents.log");
    let known = |log: String| {
        let found = incidents_of(log);
        found.into_iter().map(|incident| (incident.number, incident.fingerprint)).collect::<Vec<_>>()
    };
    let expected = known(log.clone());
    assert_eq!(expected.len(), 5);
    assert_eq!(known(log.replace("(17605", "(19605")), expected);
}

/// The states of what is found in a log, and what is said.
fn said(log: &str) -> Vec<(IncidentState, String)> {
    let found = incidents_of(log.to_owned());
    found.into_iter().map(|incident| (incident.state, incident.text)).collect()
}

/// One cause is one incident.
#[test]
fn consequences_belong_to_their_cause() {
    let heartbeats = |nodes: &[u8], from: u32, to: u32| {
        let times = (from..to).flat_map(|at| nodes.iter().map(move |node| (at, node)));
        times.map(|(at, node)| format!("({}.{}) can0 70{node}#05\n", at / 10, at % 10)).collect::<String>()
    };
    // the bus is cut, and node 4 reports it afterwards
    let cut = heartbeats(&[1, 2, 3], 10, 20) + "(3.0) can0 084#3081110000000000\n";
    assert_eq!(
        said(&cut),
        [(
            IncidentState::Unresolved,
            "nodes 1, 2, 3 are silent at the same time, with 1 consequence".to_owned()
        )]
    );
    let pause = heartbeats(&[1, 2], 10, 20) + &heartbeats(&[1, 2], 40, 50);
    let text = "nodes 1, 2 are silent at the same time; recovered after 2.100 s".to_owned();
    assert_eq!(said(&pause), [(IncidentState::Recovered, text)]);
    // a node that goes on is not silent because another one is
    let one = heartbeats(&[1, 2], 10, 20) + &heartbeats(&[2], 20, 40);
    let text = "node 1: no heartbeat for 2000.000 ms, limit 300.000 ms, until the end of the log".to_owned();
    assert_eq!(said(&one), [(IncidentState::Unresolved, text)]);
}

/// The frames that follow from a boot-up message in operation belong to it, and so do more boot-up messages.
#[test]
fn a_boot_up_takes_its_consequences() {
    let start = "(0.9) can0 705#05\n(1.0) can0 000#0105\n";
    let after = "(1.1) can0 705#00\n(1.15) can0 705#7F\n(1.2) can0 185#01\n(1.3) can0 085#1081110000000000\n";
    let text = "node 5 boots up during operation, without a command, with 2 consequences".to_owned();
    assert_eq!(said(&format!("{start}{after}")), [(IncidentState::Unresolved, text)]);
    let ends = format!("{start}(1.1) can0 705#00\n(1.2) can0 000#0105\n(1.3) can0 705#05\n");
    let text = "node 5 boots up during operation, without a command; recovered after 0.100 s".to_owned();
    assert_eq!(said(&ends), [(IncidentState::Recovered, text)]);
    let storm: String = (1..9).map(|at| format!("({at}.0) can0 705#00\n")).collect();
    let text = "node 5 boots repeatedly, 8 times".to_owned();
    assert_eq!(said(&storm), [(IncidentState::Unresolved, text)]);
}

/// A setting that is refused and then accepted is over.
#[test]
fn a_refused_setting_may_be_accepted_later() {
    let refused = "(1.0) can0 605#2B17100064000000\n(1.1) can0 585#8017100022000008\n";
    let accepted = "(2.0) can0 605#2B17100064000000\n(2.1) can0 585#6017100000000000\n";
    let states = |log: &str| said(log).into_iter().map(|(state, _)| state).collect::<Vec<_>>();
    assert_eq!(states(refused), [IncidentState::Unresolved]);
    assert_eq!(states(&format!("{refused}{accepted}")), [IncidentState::Recovered]);
}

/// What is right, or cannot be known, is no incident.
#[test]
fn a_healthy_log_has_no_incidents() {
    // one that ends with the commands that stop the nodes, and one that begins late
    let heartbeats: String = (10..20).map(|at| format!("({}.{}) can0 705#05\n", at / 10, at % 10)).collect();
    assert_eq!(said(&(heartbeats.clone() + "(2.0) can0 000#8100\n(2.3) can0 705#00\n(9.0) can0 080#\n")), []);
    assert_eq!(
        said("(1.0) can0 585#4318100102040000\n(1.1) can0 605#6000000000000000\n(3.0) can0 705#05\n"),
        []
    );
    assert_eq!(said(&fixture("worked.log")), []);
    // a node that is switched on after all were started
    assert_eq!(said("(1.0) can0 000#0100\n(1.1) can0 706#05\n(1.2) can0 705#00\n"), []);
}

/// Many warnings hide no error: the first incident of each kind and node is kept.
#[test]
fn an_error_behind_thousands_of_warnings_is_an_incident() {
    use crate::incident::{IncidentBook, Subject, numbered, with_consequences};
    use objdict_lint::recorded::traffic::{BUS_OFF, INHIBIT_TIME, MALFORMED_FRAME, REPEATED_PDO};
    let mut logs = logs(&["(1.0) can0 080#\n"]);
    let (log, frame) = logs.next_frame().unwrap().unwrap();
    let seen = crate::history::Seen::of(&frame, logs.origin(log));
    let mut book = IncidentBook::default();
    for rule in [&INHIBIT_TIME, &MALFORMED_FRAME, &REPEATED_PDO] {
        for (node, about) in (1..128).flat_map(|node| (0..30).map(move |about| (node, about))) {
            book.against(Subject::new(rule, node, about), seen.clone(), || "warning".to_owned());
        }
    }
    book.against(Subject::new(&BUS_OFF, 0, 0), seen, || "bus-off".to_owned());
    let found = numbered(with_consequences(&mut book, "can0"));
    assert!((4096..8000).contains(&found.len()), "{}", found.len());
    assert_eq!(found[0].state, IncidentState::Unresolved);
}
