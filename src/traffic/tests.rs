use std::path::Path;

use super::*;
use crate::format::log::LogOptions;
use crate::format::open;

fn logs(texts: &[&'static str]) -> MergedLogs<&'static [u8]> {
    let log = |text: &&'static str| NamedLog::new("log".to_owned(), text.as_bytes(), LogOptions::default());
    MergedLogs(texts.iter().map(log).collect())
}

/// Descriptions of the drive of the fixtures (vendor 3F9h, product 402h), so many, without a node-ID.
fn drives(count: usize) -> Descriptions {
    let path = Path::new("fixtures/eds/drive-402.eds");
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
    assert_eq!(notes, ["`1.eds` describes node 5, by its answers to 1000h and 1018h"]);
    assert_eq!(names, ["drive-402", "node 7"]);
    let (notes, names) = found(&drives(1), "(1.0) can0 585#4318100102040000\n");
    assert_eq!(notes, ["`1.eds` does not describe node 5, whose identity (1000h, 1018h) is another one"]);
    assert_eq!(names, ["node 5", "node 7"]);
}

#[test]
fn heartbeats_that_are_late() {
    let none = Descriptions::default();
    let mut buses = Buses::new(&[], &none);
    // node 5 says that its heartbeat comes each 100 ms
    let mut logs =
        logs(&["(0.0) can0 605#4017100000000000\n(0.01) can0 585#4B17100064000000\n(0.1) can0 705#05\n\
        (0.2) can0 705#05\n(0.4) can0 705#05\n(0.45) can0 705#00\n(0.9) can0 705#05\n(1.2) can0 080#\n"]);
    let mut sums = BusSums::new(Some(125));
    while let Some((log, frame)) = logs.next_frame().unwrap() {
        let at = buses.of(log, &frame, &logs);
        let decoded = buses.all[at].decode(&frame);
        sums.add(&decoded, &frame, &buses.all[at]);
    }
    let report = sums.report(&buses.all[0]);
    let texts: Vec<_> = report.lost_heartbeats.iter().map(|event| &*event.text).collect();
    let expected = [
        "node 5: no heartbeat for 200.000 ms, limit 150.000 ms",
        "node 5: no heartbeat for 300.000 ms, limit 150.000 ms, until the end of the log",
    ];
    assert_eq!(texts, expected);
    assert_eq!((report.frames, report.undescribed), (8, vec![5]));
}
