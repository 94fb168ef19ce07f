//! Networks that boot, and networks that do not.

mod acceptance;
mod plant;

use objdict_bus::{Abort, Cut, Dictionary, EventKind, LiveDictionary, Milestone, NmtState, PowerOn};
use objdict_model::model::Access;

use objdict_device::Pdos;
use plant::{MILLISECOND, Network, device, failure, frames, milestones, node_rows, outcome};

#[test]
fn a_node_is_checked_configured_and_started() {
    let run = Network::new(&[5]).configured(5, &[(0x1017, 0, 2, 0), (0x1400, 2, 1, 254)]).boot();
    assert!(run.is_booted());
    let expected = [
        "701 00",               // the manager
        "000 8200",             // all nodes restart
        "705 00",               // the node is back
        "605 4000100000000000", // 1000h
        "585 4300100091010000",
        "605 4018100100000000", // 1018h:01
        "585 43181001F9030000",
        "605 2B17100000000000", // the configuration
        "585 6017100000000000",
        "605 2F001402FE000000",
        "585 6000140200000000",
        "000 0105", // the start
        "080",
        "185 55",
    ];
    assert_eq!(frames(&run)[..expected.len()], expected);
    let node = outcome(&run, 5);
    assert_eq!((node.state, node.downloads, node.emergencies), (Some(NmtState::Operational), 2, 0));
    assert!(node.booted < node.operational && node.operational == run.operational);
    // thirteen frames, a reset and four answers after 1 ms each
    let time = run.operational.unwrap();
    assert!((14 * MILLISECOND..16 * MILLISECOND).contains(&time), "{time}");
    let device = node.device.as_ref().unwrap();
    assert_eq!(device.value(0x1400, 2).and_then(|value| value.as_integer()), Some(254));
}

#[test]
fn the_bit_rate_makes_the_time() {
    let boot = |rate| {
        let mut network = Network::new(&[5, 6, 7]);
        (network.bit_rate, network.conditions.response) = (rate, 0);
        network.boot().operational.unwrap()
    };
    let (slow, fast) = (boot(125), boot(1000));
    // all of it is time on the wire, but for the remainder of the millisecond in which nothing is sent
    assert!((slow / 8).abs_diff(fast) < MILLISECOND, "{slow} {fast}");
}

#[test]
fn the_lowest_can_id_wins() {
    let run = Network::new(&[7, 5, 6]).boot();
    let ids: Vec<String> =
        frames(&run).into_iter().filter(|frame| frame.starts_with("70") && frame.ends_with("00")).collect();
    assert_eq!(ids, ["701 00", "705 00", "706 00", "707 00"]);
}

#[test]
fn a_node_of_another_kind_is_not_started() {
    for (object, value, status, words) in [
        (0x1F84, 0x192, 'C', "has 1000:00 = 00000191h, but the manager expects 00000192h (1F84h)"),
        (0x1F85, 0x360, 'D', "has 1018:01 = 000003F9h, but the manager expects 00000360h (1F85h)"),
        (0x1F86, 8, 'M', "has 1018:02 = 00000007h, but the manager expects 00000008h (1F86h)"),
        (0x1F87, 1, 'N', "has 1018:03 = 00010000h, but the manager expects 00000001h (1F87h)"),
        (0x1F88, 1, 'O', "has 1018:04 = 00000063h, but the manager expects 00000001h (1F88h)"),
    ] {
        let run = Network::new(&[5, 6]).with_manager(&[(object, 5, value)]).boot();
        assert!(!run.is_booted() && run.operational.is_none());
        assert_eq!(failure(&run, 5), (status, words.to_owned()));
        assert_eq!(outcome(&run, 5).state, Some(NmtState::PreOperational));
        assert_eq!(outcome(&run, 6).state, Some(NmtState::Operational));
    }
}

#[test]
fn a_refused_download_ends_the_boot() {
    let downloads = [(0x1017, 0, 2, 100), (0x1000, 0, 4, 0), (0x1400, 2, 1, 254)];
    let run = Network::new(&[5]).configured(5, &downloads).boot();
    let words = "refuses download 2, 1000:00: SDO abort 06010002h: attempt to write a read-only entry";
    assert_eq!(failure(&run, 5), ('J', words.to_owned()));
    assert_eq!(outcome(&run, 5).downloads, 1);
    assert!(!frames(&run).iter().any(|frame| frame == "000 0105"));
}

#[test]
fn a_mapping_of_a_valid_pdo_is_refused_as_by_a_generated_node() {
    let run = Network::new(&[5]).configured(5, &[(0x1A00, 0, 1, 0)]).boot();
    let words = "refuses download 1, 1A00:00: SDO abort 06010000h: unsupported access";
    assert_eq!(failure(&run, 5), ('J', words.to_owned()));
}

#[test]
fn a_configuration_that_cannot_be_read_is_not_sent() {
    let mut network = Network::new(&[5]);
    network.configurations.insert(5, Err("at byte 0: cut".to_owned()));
    let words = "has no valid configuration: at byte 0: cut";
    assert_eq!(failure(&network.boot(), 5), ('J', words.to_owned()));
}

#[test]
fn a_missing_node_keeps_the_network_waiting_only_if_it_is_mandatory() {
    let mut network = Network::new(&[5, 6]);
    network.nodes.remove(0);
    let run = network.boot();
    let missing = outcome(&run, 5);
    assert!(!run.is_booted() && missing.state.is_none() && missing.milestone.is_none());
    assert_eq!(outcome(&run, 6).state, Some(NmtState::Operational));
    assert_eq!(outcome(&run, 1).state, Some(NmtState::Operational));

    let run = network.with_manager(&[(0x1F81, 5, 0x0D), (0x1F89, 0, 3000)]).boot();
    assert_eq!(failure(&run, 5), ('B', "does not respond".to_owned()));
    // asked after 0.5 s and again a second after each time that it did not answer
    assert_eq!(frames(&run).iter().filter(|frame| *frame == "605 4000100000000000").count(), 3);
    assert_eq!(outcome(&run, 6).state, Some(NmtState::Operational));
    assert_eq!(outcome(&run, 1).state, Some(NmtState::PreOperational));
    assert_eq!(run.cut, None);
}

#[test]
fn without_a_boot_time_the_simulation_has_an_end() {
    let mut network = Network::new(&[5]).with_manager(&[(0x1F81, 5, 0x0D)]);
    network.nodes.clear();
    let run = network.boot();
    assert_eq!((run.cut, run.is_booted()), (Some(Cut::Time), false));
    assert!(run.end <= 60_000 * MILLISECOND);
    network.conditions.frames = 10;
    let run = network.boot();
    assert_eq!((run.cut, run.frames().count()), (Some(Cut::Frames), 10));
}

#[test]
fn a_node_that_must_not_be_reset_has_to_say_its_state() {
    const KEPT: u32 = 0x15;
    let network = |heartbeat| {
        let network = Network::new(&[5, 6]).with_node(5, &[(0x1017, 0, heartbeat)]);
        network.with_manager(&[(0x1F81, 5, KEPT), (0x1016, 1, 0x0005_01F4)])
    };
    let words = "sends no heartbeat within 500 ms (1016h), so the manager does not know whether it is operational (1F81h bit 4)";
    assert_eq!(failure(&network(0).boot(), 5), ('E', words.to_owned()));

    let run = network(100).boot();
    assert!(run.is_booted());
    let frames = frames(&run);
    // only the other node is reset at the start, and this one when it has said that it is not operational
    let resets: Vec<&String> = frames.iter().filter(|frame| frame.starts_with("000 82")).collect();
    assert_eq!(resets, ["000 8206", "000 8205"]);
}

#[test]
fn a_guarded_node_answers_to_requests() {
    let guarded = [(0x100C, 0, 16, Access::Rw, 0), (0x100D, 0, 8, Access::Rw, 0)];
    let assignment = 0x15 | 2 << 8 | 50 << 16;
    let network = Network::new(&[5]).with_entries(5, &guarded).with_manager(&[(0x1F81, 5, assignment)]);
    let mut network = network.configured(5, &[(0x100C, 0, 2, 50), (0x100D, 0, 1, 2)]);
    network.conditions.after = 200 * MILLISECOND;
    let run = network.boot();
    assert!(run.is_booted());
    let guarding: Vec<String> = frames(&run).into_iter().filter(|frame| frame.starts_with("705")).collect();
    // looked at, reset, and then guarded with an alternating bit
    assert_eq!(guarding[..6], ["705 R", "705 7F", "705 00", "705 R", "705 05", "705 R"]);
    assert_eq!(guarding[6], "705 85");

    let silent = Network::new(&[5]).with_manager(&[(0x1F81, 5, assignment)]).boot();
    assert_eq!(failure(&silent, 5).0, 'F');
}

#[test]
fn a_node_that_stops_answering_is_reset() {
    let guarded = [(0x100C, 0, 16, Access::Rw, 0), (0x100D, 0, 8, Access::Rw, 0)];
    // heartbeat takes the place of guarding when it is written
    let network =
        Network::new(&[5]).with_entries(5, &guarded).with_manager(&[(0x1F81, 5, 5 | 2 << 8 | 20 << 16)]);
    let mut network = network.configured(5, &[(0x100C, 0, 2, 20), (0x1017, 0, 2, 5000)]);
    network.conditions.after = 1000 * MILLISECOND;
    let run = network.boot();
    let found = milestones(&run);
    assert_eq!(found[..3], [(5, &Milestone::Booted), (5, &Milestone::Lost), (5, &Milestone::Booted)]);
    assert!(frames(&run).iter().any(|frame| frame == "000 8105"));
}

#[test]
fn a_monitored_node_must_send_heartbeats() {
    let network = |time| {
        Network::new(&[5]).with_manager(&[(0x1016, 1, 0x0005_0096)]).configured(5, &[(0x1017, 0, 2, time)])
    };
    let run = network(100).boot();
    assert!(run.is_booted() && frames(&run).iter().any(|frame| frame == "705 05"));
    assert_eq!(failure(&network(0).boot(), 5), ('K', "sends no heartbeat within 150 ms (1016h)".to_owned()));
    // each heartbeat comes after the consumer time
    let mut late = network(149);
    late.conditions.after = 2000 * MILLISECOND;
    assert!(late.boot().is_booted());
    let mut late = network(160);
    late.conditions.limit = 3000 * MILLISECOND;
    assert!(!late.boot().is_booted());
}

#[test]
fn a_node_that_the_manager_does_not_boot_stays_pre_operational() {
    let run = Network::new(&[5, 6]).with_manager(&[(0x1F81, 6, 1)]).boot();
    assert!(run.is_booted());
    assert_eq!(outcome(&run, 6).state, Some(NmtState::PreOperational));
    assert!(!outcome(&run, 6).must_boot && !frames(&run).iter().any(|frame| frame.starts_with("606")));

    // one that is in no list was forgotten
    let run = Network::new(&[5, 6]).with_manager(&[(0x1F81, 6, 0)]).boot();
    assert!(!run.is_booted() && outcome(&run, 6).assignment.is_none());
}

#[test]
fn a_manager_that_is_none_boots_nothing() {
    let run = Network::new(&[5]).with_manager(&[(0x1F80, 0, 0)]).boot();
    assert!(!run.is_booted());
    assert!(frames(&run).iter().all(|frame| frame == "701 00" || frame == "080"));
}

#[test]
fn one_command_starts_all_nodes() {
    let mandatory = [(0x1F80, 0, 3), (0x1F81, 5, 0x0D), (0x1F81, 6, 0x0D)];
    let run = Network::new(&[5, 6]).with_manager(&mandatory).boot();
    assert!(run.is_booted());
    let commands = |run: &objdict_bus::Run| -> Vec<String> {
        frames(run).into_iter().filter(|frame| frame.starts_with("000")).collect()
    };
    assert_eq!(commands(&run), ["000 8200", "000 0100"]);

    // one that boots later is started alone
    let run = Network::new(&[5, 6])
        .with_manager(&[(0x1F80, 0, 3), (0x1F81, 5, 0x0D)])
        .configured(6, &[(0x1017, 0, 2, 0); 4])
        .boot();
    assert_eq!(commands(&run), ["000 8200", "000 0105", "000 0106"]);
}

#[test]
fn the_application_may_start_the_nodes() {
    for startup in [0x09, 0x07] {
        let run = Network::new(&[5]).with_manager(&[(0x1F80, 0, startup)]).boot();
        assert!(run.is_booted() && run.waits_for_application, "{startup:X}");
        assert_eq!(outcome(&run, 5).state, Some(NmtState::PreOperational));
        assert!(outcome(&run, 5).booted.is_some() && run.operational.is_none());
    }
    // each node is started although the manager itself waits
    let run = Network::new(&[5]).with_manager(&[(0x1F80, 0, 5)]).boot();
    assert_eq!(
        (outcome(&run, 1).state, outcome(&run, 5).state),
        (Some(NmtState::PreOperational), Some(NmtState::Operational))
    );
}

#[test]
fn a_node_restores_its_defaults_first() {
    let stored = [(0x1011, 0, 8, Access::Const, 1), (0x1011, 1, 32, Access::Rw, 1)];
    let network = Network::new(&[5]).with_entries(5, &stored);
    let run =
        network.with_manager(&[(0x1F81, 5, 0x85), (0x1F8A, 5, 1)]).configured(5, &[(0x1017, 0, 2, 0)]).boot();
    assert!(run.is_booted());
    let frames = frames(&run);
    let at =
        |text: &str| frames.iter().position(|frame| frame == text).unwrap_or_else(|| panic!("no {text}"));
    let (load, reset) = (at("605 231110016C6F6164"), at("000 8105"));
    assert!(load < reset && reset < at("605 2B17100000000000"));
    assert_eq!(frames[reset + 1], "705 00");

    let run = Network::new(&[5]).with_manager(&[(0x1F81, 5, 0x85), (0x1F8A, 5, 1)]).boot();
    let words =
        "refuses to restore its defaults, 1011:01: SDO abort 06020000h: there is no object with this index";
    assert_eq!(failure(&run, 5), ('J', words.to_owned()));
}

#[test]
fn a_node_that_kept_its_configuration_is_not_configured_again() {
    let verification = |date| {
        [
            (0x1020, 0, 8, Access::Const, 2),
            (0x1020, 1, 32, Access::Rw, date),
            (0x1020, 2, 32, Access::Rw, 41_400_000),
        ]
    };
    let boot = |date| {
        let network =
            Network::new(&[5]).with_entries(5, &verification(date)).configured(5, &[(0x1017, 0, 2, 7)]);
        network.with_manager(&[(0x1F26, 5, 15_666), (0x1F27, 5, 41_400_000)]).boot()
    };
    let [kept, other] = [15_666, 15_665].map(boot);
    assert!(kept.is_booted() && other.is_booted());
    assert_eq!((outcome(&kept, 5).downloads, outcome(&other, 5).downloads), (0, 1));
}

#[test]
fn software_is_checked() {
    let software = [(0x1F56, 0, 8, Access::Const, 1), (0x1F56, 1, 32, Access::Ro, 0x1234)];
    let boot = |expected| {
        let network = Network::new(&[5]).with_entries(5, &software);
        network.with_manager(&[(0x1F81, 5, 0x25), (0x1F55, 5, expected)]).boot()
    };
    assert!(boot(0x1234).is_booted());
    assert_eq!(failure(&boot(0), 5).0, 'G');
    let words = "has 1F56:01 = 00001234h, but the manager expects 00001235h (1F55h)";
    assert_eq!(failure(&boot(0x1235), 5), ('H', words.to_owned()));
}

/// The inhibit time of NMT commands holds the start of the second node back longer than boot-up messages are waited for.
#[test]
fn a_command_that_is_planned_is_waited_for() {
    let network = Network::new(&[5, 6]).with_manager(&[(0x102A, 0, 20_000)]);
    assert!(network.boot().is_booted());
}

#[test]
fn two_nodes_must_not_send_one_can_id() {
    let run =
        Network::new(&[5, 6]).configured(6, &[(0x1800, 1, 4, 0x8000_0186), (0x1800, 1, 4, 0x185)]).boot();
    assert!(!run.is_booted() && run.operational.is_some());
    let conflict = run.events.iter().find_map(|event| match event.kind {
        EventKind::TwoSenders { id, senders } => Some((id, senders.map(|at| run.nodes[at].node_id))),
        _ => None,
    });
    assert_eq!(conflict, Some((0x185, [5, 6])));
}

#[test]
fn an_rpdo_that_is_too_short_is_an_emergency() {
    // RPDO 1 of node 6 wants two bytes of the TPDO of node 5, which has one
    let longer = [(0x6200, 2, 8, Access::Rww, 0)];
    let downloads = [(0x1400, 1, 4, 0x8000_0206), (0x1600, 0, 1, 0), (0x1600, 1, 4, 0x6200_0108)];
    let network = Network::new(&[5, 6])
        .with_entries(6, &longer)
        .with_entries(6, &[(0x1600, 2, 32, Access::Rw, 0)])
        .with_node(6, &[(0x6200, 0, 2)]);
    let mut downloads = downloads.to_vec();
    downloads.extend([(0x1600, 2, 4, 0x6200_0208), (0x1600, 0, 1, 2), (0x1400, 1, 4, 0x185)]);
    let run = network.configured(6, &downloads).boot();
    assert!(!run.is_booted() && run.operational.is_some());
    assert!(outcome(&run, 6).errors > 0);
    assert!(frames(&run).iter().any(|frame| frame == "086 1082110100000000"));
}

#[test]
fn a_node_that_misses_the_manager_reports_it() {
    // the manager has no heartbeat after the first one, which is its state after the start
    let network = Network::new(&[5]).configured(5, &[(0x1016, 1, 4, 0x0001_0032)]);
    let mut network = network.with_manager(&[(0x1017, 0, 200)]);
    network.conditions.after = 1000 * MILLISECOND;
    network.conditions.limit = 2000 * MILLISECOND;
    let run = network.boot();
    assert!(frames(&run).iter().any(|frame| frame == "085 3081110100000000"));
    assert_eq!(outcome(&run, 5).state, Some(NmtState::PreOperational));
    assert!(!run.is_booted());
}

#[test]
fn commands_keep_their_distance() {
    let run = Network::new(&[5, 6]).with_manager(&[(0x102A, 0, 200)]).boot();
    let commands = run.frames().filter(|(_, _, frame)| frame.id() == 0).map(|(time, ..)| time);
    let commands: Vec<u64> = commands.collect();
    assert_eq!(commands.len(), 3);
    assert!(commands.windows(2).all(|pair| pair[1] - pair[0] >= 19 * MILLISECOND), "{commands:?}");
}

#[test]
fn a_run_is_the_same_every_time() {
    let network = Network::new(&[5, 6, 7]).configured(6, &[(0x1017, 0, 2, 10)]);
    let [first, second] = [network.boot(), network.boot()];
    assert_eq!(format!("{:?}", first.events), format!("{:?}", second.events));
}

/// CiA 301 §7.5.2.17: bits 0 to 29 of 1014h change only while bit 31 is set.
#[test]
fn an_identifier_changes_only_while_its_service_is_not_valid() {
    let mut dictionary = LiveDictionary::new(&device(&node_rows(5)), 5, PowerOn::Defaults);
    let mut pdos = Pdos::<0, 0>::new([], []);
    let mut dictionary = pdos.guard(&mut dictionary);
    let mut write = |cob_id: u32| dictionary.write(0x1014, 0, &cob_id.to_le_bytes()).map_err(Abort::code);
    assert_eq!(write(0x86), Err(0x0609_0030));
    assert_eq!([0x8000_0085, 0x8000_0086, 0x86].map(&mut write), [Ok(()); 3]);
    assert_eq!(write(0x8000_0086), Ok(()));
    assert_eq!(write(0x701), Err(0x0609_0030));
}

#[test]
fn what_is_stored_survives_a_reset() {
    let mut rows = node_rows(5);
    rows.extend([
        (0x1010, 0, 8, Access::Const, 1),
        (0x1010, 1, 32, Access::Rw, 1),
        (0x1020, 0, 8, Access::Const, 2),
        (0x1020, 1, 32, Access::Rw, 0),
        (0x1020, 2, 32, Access::Rw, 0),
    ]);
    let mut dictionary = LiveDictionary::new(&device(&rows), 5, PowerOn::Defaults);
    let mut pdos = Pdos::<0, 0>::new([], []);
    let mut dictionary = pdos.guard(&mut dictionary);
    assert_eq!(dictionary.write(0x1010, 1, b"evas").map_err(Abort::code), Err(0x0800_0020));
    dictionary.write(0x1020, 1, &[1, 0, 0, 0]).unwrap();
    dictionary.write(0x1010, 1, b"save").unwrap();
    assert_eq!((dictionary.number(0x1010, 1), dictionary.number(0x1020, 1)), (Ok(1), Ok(1)));
}
