//! Networks in time: what the analysis says of those in the fixtures.

use objdict::Language;
use objdict::bus::{Conditions, EventKind, boot};
use objdict::format::network::NetworkFile;
use objdict::network::{
    BootTimes, DcfgenMode, DeadlineKind, MessageId, NodeBootTime, TimedMessage, Timing, TimingOptions,
    timeline,
};
use roxmltree::Document;

use crate::{links, network};

fn timing(file: &NetworkFile, options: &TimingOptions) -> Timing {
    file.build(DcfgenMode::Corrected).unwrap().timing(options, Language::English).unwrap()
}

fn of(name: &str, options: &TimingOptions) -> Timing {
    timing(&network::open(name), options)
}

fn message(timing: &Timing, can_id: u32) -> &TimedMessage {
    timing.messages.iter().find(|message| message.can_id.number == can_id).unwrap()
}

/// The responses of CAN-IDs in units of 10 µs.
fn responses(timing: &Timing, can_ids: &[u32]) -> Vec<Option<u64>> {
    can_ids.iter().map(|can_id| message(timing, *can_id).response.map(|time| time / 10_000)).collect()
}

#[test]
fn the_islands_of_the_book_have_the_published_responses() {
    let can_ids = [0x080, 0x18B, 0x20B, 0x28B, 0x30B, 0x381, 0x401, 0x481, 0x501, 0x70B, 0x70C];
    let quiet = of("islands.toml", &TimingOptions { sdo: false, ..TimingOptions::default() });
    let expected = [128, 340, 264, 468, 416, 468, 672, 620, 800, 724, 724];
    assert_eq!(responses(&quiet, &can_ids), expected.map(Some));
    assert_eq!(quiet.sync.unwrap().needed, Some(6_720_000));

    let timing = of("islands.toml", &TimingOptions::default());
    let expected = [152, 388, 288, 516, 440, 492, 728, 652, 880];
    assert_eq!(responses(&timing, &can_ids[..9]), expected.map(Some));
    assert_eq!(timing.sync.unwrap().needed, Some(7_280_000));
    assert_eq!([timing.load.average_percent(125), timing.load.worst_percent(125)], [9761, 11_686]);
    assert!(timing.is_met(&TimingOptions::default()) && timing.fits_from() == Some(50));
    let left = timing.nodes.iter().find(|share| share.of.node == "left").unwrap();
    assert_eq!((left.load.worst + 50) / 100, 39_742);
    // 31 entries with 2 frames of 135 bits each
    let boot = timing.boot.unwrap();
    let node = &boot.nodes[0];
    assert_eq!((node.bus, node.total), (31 * 270 * 8000, 31 * 270 * 8000 + 31_000_000));
    assert!(boot.limit == 0 && !boot.is_late(node));
    // the time of the responses counts
    let is_late = |limit| {
        let node = NodeBootTime { is_mandatory: true, ..node.clone() };
        BootTimes { limit, nodes: Vec::new() }.is_late(&node)
    };
    assert!(is_late(node.total - 1) && !is_late(node.total));
}

#[test]
fn what_may_come_at_any_time_has_an_inhibit_time_that_is_enough() {
    let timing = of("chapter4.toml", &TimingOptions::default());
    let unbounded: Vec<u32> = timing.unbounded().map(|message| message.can_id.number).collect();
    assert_eq!(unbounded, [0x18D, 0x20B, 0x30B, 0x381]);
    let allowing = TimingOptions { allow_unbounded: true, ..TimingOptions::default() };
    assert!(!timing.is_met(&TimingOptions::default()) && timing.is_met(&allowing));
    let below = message(&timing, 0x28B);
    assert_eq!((below.response, below.unbounded_by.map(|id| id.number)), (None, Some(0x18D)));
    assert!(message(&timing, 0x18B).response.is_some() && !below.is_missed());

    let tenths = timing.inhibit_time.unwrap();
    let with = |tenths: u16| {
        let event_distance = Some(u64::from(tenths) * 100_000);
        of("chapter4.toml", &TimingOptions { event_distance, ..TimingOptions::default() })
    };
    let (enough, short) = (with(tenths), with(tenths - 1));
    let is_in_time = |timing: &Timing| {
        let is_sent = |can_id: &u32| {
            let message = message(timing, *can_id);
            message.response.is_some_and(|time| time <= message.period.unwrap())
        };
        timing.is_met(&TimingOptions::default()) && unbounded.iter().all(is_sent)
    };
    assert!(is_in_time(&enough) && !is_in_time(&short));
}

#[test]
fn a_late_message_has_a_remedy() {
    let slow = of("islands.toml", &TimingOptions { bit_rate: Some(20), ..TimingOptions::default() });
    assert!(!slow.is_met(&TimingOptions::default()));
    let remedy = &slow.remedies[0];
    let late = &slow.messages[remedy.message];
    assert_eq!((late.can_id.number, late.is_missed()), (0x401, true));
    let before = MessageId { is_extended: false, number: 0x28B };
    assert_eq!((remedy.bit_rate, remedy.before), (Some(50), Some(before)));
    // SDO transfers without an end may leave no time to heartbeats, which is no matter of their deadlines
    let heartbeat = message(&slow, 0x70B);
    assert!(heartbeat.response.is_none() && heartbeat.waits_for_sdo && !heartbeat.is_missed());
}

#[test]
fn deadlines_are_those_of_receivers() {
    let heartbeat = |watch: &str| {
        let text = format!(
            "[bus]\nbit-rate = 125\nmanager = 'n0'\n[node.n0]\nfile = 'island.eds'\nid = 1\n[node.n1]\nfile = 'island.eds'\nid = 2\n\
            heartbeat = '300ms'\nwatch = '{watch}'\n"
        );
        message(&timing(&links::open("receivers", &text), &TimingOptions::default()), 0x702).deadline
    };
    // of 450 ms, 300 ms pass until the next heartbeat is due
    assert_eq!(heartbeat("1.5x"), Some((150_000_000, DeadlineKind::Receiver)));
    assert_eq!(heartbeat("3x"), Some((300_000_000, DeadlineKind::Period)));
    // the next heartbeat is late in any case
    assert_eq!(heartbeat("1x"), Some((0, DeadlineKind::Receiver)));
    assert_eq!(heartbeat("0.5x"), Some((0, DeadlineKind::Receiver)));
}

#[test]
fn a_simulated_network_sends_what_the_analysis_knows() {
    for name in ["chapter4.toml", "islands.toml", "worked.yml", "cell.yml"] {
        let file = network::open(name);
        let timing = timing(&file, &TimingOptions::default());
        let installation = file.install(file.boot_files()).unwrap();
        let conditions = Conditions { after: 1_000_000_000, ..Conditions::default() };
        let run = boot(&installation.plant, &conditions);
        let mut frames = 0;
        for event in &run.events {
            let EventKind::Frame { frame, .. } = &event.kind else { continue };
            let known =
                timing.messages.iter().filter(|message| message.can_id.number == u32::from(frame.id()));
            let fits = |message: &TimedMessage| {
                let least = if message.bytes == frame.data().len() as u64 { message.bits[0] } else { 0 };
                (least..=message.bits[1]).contains(&u64::from(frame.bits()))
            };
            assert!(known.clone().any(fits), "{name}: {frame:?} at {}", event.time);
            frames += 1;
        }
        assert!(frames > 50, "{name}: {frames} frames");
    }
}

#[test]
fn pictures_show_each_node_and_no_frame_over_another() {
    for nodes in [2, 127] {
        let bus = "[bus]\nname = 'a <b>'\nbit-rate = 1000\nsync = '10ms'\nmanager = 'n0'\n".to_owned();
        let file = links::open(&format!("timeline{nodes}"), &(bus + &links::many(nodes)));
        let timing = timing(&file, &TimingOptions::default());
        let svg = timeline::svg(&timing, |can_id| can_id.to_string());
        assert!(svg.len() < 200_000, "{}", svg.len());
        let document = Document::parse(&svg).unwrap();
        let mut frames: Vec<(f64, f64)> = Vec::new();
        for bar in document.descendants().filter(|node| node.has_tag_name("rect") && node.has_attribute("x"))
        {
            let number = |name: &str| bar.attribute(name).unwrap().parse::<f64>().unwrap();
            frames.push((number("x"), number("x") + number("width")));
        }
        frames.sort_by(|one, other| one.partial_cmp(other).unwrap());
        assert!(frames.len() > nodes && frames.windows(2).all(|pair| pair[0].1 <= pair[1].0 + 0.02));
        assert_eq!(svg.matches("class=\"lane\"").count(), nodes);
    }
}
