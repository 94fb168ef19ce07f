//! A device beside its description: answers of the node of a description, and of a LocalNode of python-canopen, are as described; what they
//! answer otherwise is found, and nothing else.

mod channels;
mod planted;
mod python;
mod schema;

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::path::Path;

use objdict::bus::{Abort, Dictionary, LiveDictionary, PowerOn};
use objdict::diagnostic::Severity;
use objdict::format::log::{LogOptions, LogReader};
use objdict::format::network::NetworkFile;
use objdict::format::{self, Description, Format, WriteOptions};
use objdict::model::{ClockTime, Date, Device};
use objdict::network::DcfgenMode;
use objdict::probe::{
    Conversation, Exchange, Judgement, ProbeOptions, ProbePlan, SdoAnswer, SdoRequest, judge, read_answers,
};
use objdict::scaffold::learn;
use objdict::source::{SourceFile, SourceOptions};
use objdict_device::{Frame, Node, Pdos, Received, SdoClient};

use crate::support;
use planted::{Difference, Otherwise};

const NODE: u8 = 5;

fn device(name: &str) -> Device {
    let path = support::fixtures().join(name);
    format::open(&path, &SourceOptions::default()).unwrap().device().clone()
}

fn plan(device: &Device, write: bool) -> ProbePlan {
    ProbePlan::new(device, NODE, &ProbeOptions { write, ..ProbeOptions::default() })
}

/// The node of a description, with a client and a recorder on its bus.
struct Bench<D> {
    node_id: u8,
    node: Node<D, 65536, 1, 0, 0, 0>,
    /// What the recorder wrote, as `candump -L`.
    log: String,
    now: u64,
}

impl<D: Dictionary> Bench<D> {
    fn new(node_id: u8, dictionary: D) -> Self {
        let mut node = Node::new(node_id, dictionary, Pdos::new([], []));
        node.boot(0);
        Self { node_id, node, log: String::new(), now: 0 }
    }

    fn record(&mut self, frame: &Frame) {
        self.now += 200;
        let data: String = frame.data().iter().map(|byte| format!("{byte:02X}")).collect();
        let (seconds, rest) = (self.now / 1_000_000, self.now % 1_000_000);
        writeln!(self.log, "({seconds:010}.{rest:06}) can0 {:03X}#{data}", frame.id()).unwrap();
    }

    /// One transfer, by blocks if that is asked for.
    fn transfer(&mut self, index: u16, sub: u8, request: &SdoRequest, in_blocks: bool) -> SdoAnswer {
        let mut client = SdoClient::new(self.node_id);
        let mut data = match request {
            SdoRequest::Upload => vec![0; 4096],
            SdoRequest::Download(bytes) => bytes.clone(),
        };
        let length = data.len();
        let mut step = match (request, in_blocks) {
            (SdoRequest::Upload, false) => client.upload(index, sub, self.now),
            (SdoRequest::Upload, true) => client.upload_block(index, sub, self.now),
            (SdoRequest::Download(_), false) => client.download(&mut data[..], index, sub, length, self.now),
            (SdoRequest::Download(_), true) => client.download_block(index, sub, length, self.now),
        };
        loop {
            let mut answers = Vec::new();
            if let Some(frame) = step.frame {
                self.record(&frame);
                if let Received::Answer(answer) = self.node.receive(&frame, self.now) {
                    answers.push(answer);
                }
            }
            answers.extend(
                std::iter::from_fn(|| self.node.poll(self.now))
                    .filter(|frame| frame.id() == 0x580 + u16::from(self.node_id)),
            );
            if let Some(end) = step.end {
                return match (end, request) {
                    (Ok(length), SdoRequest::Upload) => SdoAnswer::Bytes(data[..length].to_vec()),
                    (Ok(_), SdoRequest::Download(_)) => SdoAnswer::Done,
                    (Err(abort), _) => SdoAnswer::Abort(abort),
                };
            }
            let is_idle = answers.is_empty();
            for answer in answers {
                self.record(&answer);
                step = client.receive(&mut data[..], &answer, self.now);
            }
            if is_idle {
                step = client.poll(&mut data[..], self.now);
            }
        }
    }
}

/// The exchanges of a recorded log.
fn recorded(log: &str) -> Vec<Exchange> {
    let mut reader = LogReader::new(log.as_bytes(), LogOptions::default());
    let mut conversation = Conversation::new(NODE);
    while let Some(frame) = reader.next_frame().unwrap() {
        conversation.take(&frame);
    }
    assert_eq!(reader.bad_count(), 0);
    conversation.into_exchanges()
}

#[test]
fn requests_without_the_bytes_that_mean_nothing_are_recorded() {
    let request = |bytes: &str| format!("(1.0) can0 {:03X}#{bytes}\n", 0x600 + u16::from(NODE));
    let response = |bytes: &str| format!("(1.1) can0 {:03X}#{bytes}\n", 0x580 + u16::from(NODE));
    let short = request("40001000")
        + &response("4300100091010800")
        + &request("40171000")
        + &response("4B17100000000000");
    let whole = short.replace("40001000\n", "4000100000000000\n").replace("40171000\n", "4017100000000000\n");
    assert_eq!(recorded(&short).len(), 2);
    assert_eq!(recorded(&short), recorded(&whole));
    // the index is incomplete
    assert!(recorded(&request("400010")).is_empty());
}

/// Asserts that recorded exchanges are those that were made; of a value that was refused before it was transferred, the length is
/// known.
fn assert_recorded(log: &str, made: &[Exchange]) {
    let recorded = recorded(log);
    assert_eq!(recorded.len(), made.len());
    for (recorded, made) in recorded.iter().zip(made) {
        match (&recorded.request, &made.request, &made.answer) {
            (SdoRequest::Download(bytes), SdoRequest::Download(sent), SdoAnswer::Abort(_))
                if bytes.iter().all(|byte| *byte == 0) =>
            {
                assert_eq!((bytes.len(), &recorded.answer), (sent.len(), &made.answer));
            }
            _ => assert_eq!(recorded, made),
        }
    }
}

/// What is found: the rule, index and sub-index.
fn found(judgement: &Judgement) -> BTreeSet<(&'static str, u16, u8)> {
    let rows = judgement.rows.iter();
    rows.filter_map(|row| Some((row.problem.as_ref()?.0.id, row.index, row.sub))).collect()
}

/// The exchanges with a node, as they were made and as they were recorded.
fn exchanges(device: &Device, dictionary: impl Dictionary, write: bool) -> Vec<Exchange> {
    let mut bench = Bench::new(NODE, dictionary);
    let made = plan(device, write).run(|index, sub, request| bench.transfer(index, sub, request, false));
    assert_recorded(&bench.log, &made);
    made
}

#[test]
fn the_node_of_a_description_is_as_described() {
    for name in [
        "eds/drive-402.eds",
        "eds/io-401.eds",
        "eds/all-types.eds",
        "eds/encoder-406.eds",
        "xdd/drive-402.xdd",
    ] {
        let device = device(name);
        for write in [false, true] {
            let exchanges = exchanges(&device, LiveDictionary::new(&device, NODE, PowerOn::Defaults), write);
            let judgement = judge(&device, NODE, &exchanges);
            assert_eq!(found(&judgement), BTreeSet::new(), "{name}");
            assert!(judgement.findings.is_empty() && judgement.unasked.is_empty());
            assert_eq!(judgement.passed(), exchanges.len());
            assert!(exchanges.len() > 30, "{name}: {}", exchanges.len());
        }
    }
}

/// What was written is as it was before.
#[test]
fn values_are_restored() {
    let device = device("eds/drive-402.eds");
    let mut bench = Bench::new(NODE, LiveDictionary::new(&device, NODE, PowerOn::Defaults));
    let mut written = BTreeSet::new();
    plan(&device, true).run(|index, sub, request| {
        let answer = bench.transfer(index, sub, request, false);
        if *request != SdoRequest::Upload && answer == SdoAnswer::Done {
            written.insert((index, sub));
        }
        answer
    });
    assert_eq!(
        bench.node.dictionary.present(&device),
        LiveDictionary::new(&device, NODE, PowerOn::Defaults).present(&device)
    );
    assert!(written.len() > 60, "{}", written.len());
    let is_left = |(index, _): &(u16, u8)| (0x1000..0x2000).contains(index) || *index == 0x6040;
    assert!(!written.iter().any(is_left), "{written:04X?}");
}

#[test]
fn commands_are_written_only_if_they_are_named() {
    let device = device("eds/drive-402.eds");
    let objects = |also: &[u16]| {
        let also = also.iter().map(|&index| index..=index).collect();
        let plan = ProbePlan::new(&device, NODE, &ProbeOptions { write: true, also });
        let table = plan.table();
        let written =
            table.lines().filter(|line| line.contains(",rw,write,") || line.contains(",rww,write,"));
        written.map(|line| u16::from_str_radix(&line[2..6], 16).unwrap()).collect::<BTreeSet<u16>>()
    };
    let plain = objects(&[]);
    assert!(plain.contains(&0x6081) && plain.contains(&0x1017));
    assert!(plain.is_disjoint(&BTreeSet::from([0x1003, 0x1010, 0x1011, 0x6040])), "{plain:04X?}");
    let named = objects(&[0x6040, 0x1010]);
    assert_eq!(named.difference(&plain).collect::<Vec<_>>(), [&0x1010, &0x6040]);
}

/// Block transfers are recorded alike.
#[test]
fn values_by_blocks_are_read_from_a_log() {
    let device = device("eds/all-types.eds");
    let mut bench = Bench::new(NODE, LiveDictionary::new(&device, NODE, PowerOn::Defaults));
    let made = plan(&device, true).run(|index, sub, request| bench.transfer(index, sub, request, true));
    assert_recorded(&bench.log, &made);
    assert_eq!(found(&judge(&device, NODE, &made)), BTreeSet::new());
}

#[test]
fn planted_differences_are_found_and_nothing_else() {
    let device = device(planted::FIXTURE);
    let all = planted::all();
    assert!(all.len() >= 40, "{}", all.len());
    for difference in &all {
        let node = Otherwise::new(
            LiveDictionary::new(&device, NODE, PowerOn::Defaults),
            std::slice::from_ref(difference),
        );
        let judgement = judge(&device, NODE, &exchanges(&device, node, true));
        assert_eq!(found(&judgement), difference.expected(), "{difference:?}");
        assert_eq!(judgement.findings.len(), difference.rules.len(), "{difference:?}");
    }
    // all at once
    let node = Otherwise::new(LiveDictionary::new(&device, NODE, PowerOn::Defaults), &all);
    let judgement = judge(&device, NODE, &exchanges(&device, node, true));
    assert_eq!(found(&judgement), all.iter().flat_map(Difference::expected).collect());
}

#[test]
fn a_node_that_is_not_there_does_not_answer() {
    let device = device("eds/encoder-406.eds");
    let exchanges = recorded(&plan(&device, false).candump(50));
    assert_eq!(exchanges.len(), plan(&device, false).len());
    let judgement = judge(&device, NODE, &exchanges);
    assert!(
        judgement
            .rows
            .iter()
            .all(|row| row.problem.as_ref().is_some_and(|(rule, _)| rule.id == "probe/no-answer"))
    );
}

/// A replay of the log gets the answers of a node, without those of more than four bytes, of which it gets the sizes.
#[test]
fn the_log_for_canplayer_asks_for_every_value() {
    let device = device("eds/drive-402.eds");
    let mut bench = Bench::new(NODE, LiveDictionary::new(&device, NODE, PowerOn::Defaults));
    let mut requests =
        LogReader::new(plan(&device, false).candump(50).into_bytes().leak() as &[u8], LogOptions::default());
    while let Some(request) = requests.next_frame().unwrap() {
        let frame = Frame::new(request.can_id as u16, request.data()).unwrap();
        bench.record(&frame);
        if let Received::Answer(answer) = bench.node.receive(&frame, bench.now) {
            bench.record(&answer);
        }
    }
    let judgement = judge(&device, NODE, &recorded(&bench.log));
    assert_eq!(found(&judgement), BTreeSet::new());
    assert!(judgement.unasked.is_empty());
}

/// The description of the answers, in which `check` finds no error.
fn learned(exchanges: &[Exchange]) -> Description {
    let (date, time) = (Date::new(2026, 11, 26).unwrap(), ClockTime::new(12, 0).unwrap());
    let learned = learn(exchanges, Some(NODE), "learned.eds", date, time).unwrap();
    let bytes = format::write(&learned, Format::Eds, &WriteOptions::default()).unwrap().bytes;
    let source = SourceFile::from_bytes("learned.eds", bytes, &SourceOptions::default()).unwrap();
    let description = format::read(source, Format::Eds);
    let findings = objdict::check(&description);
    let errors: Vec<_> = findings.iter().filter(|finding| finding.severity == Severity::Error).collect();
    assert!(errors.is_empty(), "{errors:#?}");
    description
}

#[test]
fn an_unknown_device_is_described_by_its_answers() {
    for name in [
        "eds/drive-402.eds",
        "eds/io-401.eds",
        "eds/all-types.eds",
        "eds/encoder-406.eds",
        "xdd/drive-402.xdd",
    ] {
        let device = device(name);
        let exchanges = exchanges(&device, LiveDictionary::new(&device, NODE, PowerOn::Defaults), false);
        let description = learned(&exchanges);
        // the answers are as the new description says
        assert_eq!(found(&judge(description.device(), NODE, &exchanges)), BTreeSet::new(), "{name}");
    }
}

/// A bench that dumps numbers and texts says the same as the script.
#[test]
fn answers_of_a_bench_are_numbers_and_texts() {
    let device = device("eds/encoder-406.eds");
    let answers =
        "index;sub;value\n1000;0;0x00020196\n1018;0;4\n1018;1;1\n6000;0;0\n1008;0;abort 08000020\n9999;0;1\n";
    let judgement = judge(&device, NODE, &read_answers(answers).unwrap());
    let rows: Vec<_> = judgement
        .rows
        .iter()
        .map(|row| (row.index, row.problem.as_ref().map(|(rule, _)| rule.name())))
        .collect();
    assert_eq!(
        rows,
        [
            (0x1000, None),
            (0x1018, None),
            (0x1018, Some("other-value")),
            (0x6000, None),
            (0x1008, Some("not-readable")),
            (0x9999, Some("undescribed")),
        ]
    );
}

/// The description of an abort code in a message.
#[test]
fn messages_name_the_entry_and_the_reason() {
    let device = device("eds/encoder-406.eds");
    let exchange =
        |answer| Exchange { reset: None, index: 0x1018, sub: 1, request: SdoRequest::Upload, answer };
    let message = |answer| {
        judge(&device, NODE, &[exchange(answer)])
            .findings
            .iter()
            .map(|finding| finding.message.to_string())
            .collect::<Vec<_>>()
    };
    assert_eq!(
        message(SdoAnswer::Abort(Abort::NoSubIndex)),
        ["the device lacks 1018h sub-index 1: it responds with 06090011h: the object has no such sub-index"]
    );
    assert_eq!(message(SdoAnswer::Length(Some(2))), ["1018h sub-index 1 has 2 bytes, and UNSIGNED32 has 4"]);
    assert_eq!(message(SdoAnswer::Silence), ["no response to a request for 1018h sub-index 1"]);
}

/// The recorded boot of docs/guides/probe.md: the island of the book, which was not configured as its DCF says. `INSTA_UPDATE=always` writes it.
#[test]
fn the_log_of_the_book_is_that_of_its_node() {
    let file =
        NetworkFile::open(&support::fixtures().join("network/chapter4.toml"), &Default::default()).unwrap();
    let files = file.build(DcfgenMode::Corrected).unwrap().dcfs().unwrap();
    let dcf = files.iter().find(|file| file.name == "left.dcf").unwrap();
    let source = SourceFile::from_bytes("left.dcf", dcf.bytes.clone(), &SourceOptions::default()).unwrap();
    let device = format::read(source, Format::Dcf).device().clone();
    let node_id = device.node_id().unwrap();
    let node =
        Otherwise::new(LiveDictionary::new(&device, node_id, PowerOn::Configured), &planted::of_island());
    let mut bench = Bench::new(node_id, node);
    let plan = ProbePlan::new(&device, node_id, &ProbeOptions::default());
    plan.run(|index, sub, request| bench.transfer(index, sub, request, false));
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/probe/left.log");
    if std::env::var("INSTA_UPDATE").is_ok_and(|update| update == "always") {
        std::fs::write(&path, &bench.log).unwrap();
    }
    assert_eq!(std::fs::read_to_string(path).unwrap(), bench.log);
}
