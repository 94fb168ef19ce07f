use super::*;
use crate::layout::tests::record;
use crate::model::{Access, DataType, Entry, Object, ObjectType, Value};

/// A device with the PDO of a communication parameter: its COB-ID, and the mapped objects.
fn map(device: &mut Device, index: u16, cob_id: u64, mapped: &[u64]) {
    device.objects.insert(index, record(&[(0, Some(2)), (1, Some(cob_id)), (2, Some(255))]));
    let count = mapped.len() as u64;
    let subs: Vec<_> =
        [(0, Some(count))].into_iter().chain((1..).zip(mapped.iter().copied().map(Some))).collect();
    device.objects.insert(index + 0x200, record(&subs));
}

fn put(device: &mut Device, index: u16, name: &str, data_type: DataType) {
    let main = Entry {
        name: name.into(),
        object_type: Some(ObjectType::Var),
        data_type: Some(data_type),
        access: Some(Access::Rw),
        ..Entry::default()
    };
    device.objects.insert(index, Object { main, ..Object::default() });
}

/// A device with an entry of each kind of number.
fn device() -> Device {
    let mut device = Device::default();
    for (index, name, data_type) in [
        (0x2000, "Flag", DataType::BOOLEAN),
        (0x2001, "Level", DataType::INTEGER16),
        (0x2002, "Flow", DataType::REAL32),
        (0x2003, "Label", DataType::VISIBLE_STRING),
        (0x2004, "Clock", DataType::TIME_OF_DAY),
        (0x2005, "Volume", DataType::REAL64),
        (0x2006, "Word", DataType::UNSIGNED16),
    ] {
        put(&mut device, index, name, data_type);
    }
    device
}

fn node(device: &Device, node_id: u8) -> BusNode<'_> {
    BusNode { device, node_id, name: None, is_counterpart: false }
}

fn lines(dbc: &Dbc, start: &str) -> Vec<String> {
    let text: String = dbc.bytes.iter().map(|&byte| char::from(byte)).collect();
    text.split("\r\n").filter(|line| line.starts_with(start)).map(str::to_owned).collect()
}

/// The omissions of PDOs.
fn omitted(dbc: &Dbc) -> Vec<String> {
    let of_pdos = dbc.omissions.iter().filter(|omission| omission.place.part != Part::Device);
    let fate = |is_lost| if is_lost { "lost" } else { "left out" };
    of_pdos.map(|of| format!("{} {}: {}", fate(of.is_lost), of.place, of.reason)).collect()
}

#[test]
fn numbers_of_all_kinds_and_gaps() {
    let mut device = device();
    map(&mut device, 0x1800, 0x2012_3456, &[0x2000_0001, 0x0005_0007, 0x2001_0010, 0x2002_0020]);
    map(&mut device, 0x1801, 0x281, &[0x2005_0040]);
    map(&mut device, 0x1802, 0x381, &[0x2004_0030, 0x7000_0108]);
    let dbc = write(&[node(&device, 1)], DbcOptions::default());
    assert_eq!(
        lines(&dbc, "BO_ ")[1..],
        [
            "BO_ 641 Node_1_TPDO2: 8 Node_1",
            "BO_ 897 Node_1_TPDO3: 7 Node_1",
            "BO_ 1793 Node_1_heartbeat: 1 Node_1",
            "BO_ 2148676694 Node_1_TPDO1: 7 Node_1"
        ]
    );
    assert_eq!(
        lines(&dbc, " SG_ ")[2..],
        [
            " SG_ Volume : 0|64@1- (1,0) [0|0] \"\" Vector__XXX",
            " SG_ Clock_ms : 0|28@1+ (1,0) [0|0] \"ms\" Vector__XXX",
            " SG_ Clock_days : 32|16@1+ (1,0) [0|0] \"d\" Vector__XXX",
            " SG_ x7000_01 : 48|8@1+ (1,0) [0|0] \"\" Vector__XXX",
            " SG_ State : 0|7@1+ (1,0) [0|0] \"\" Vector__XXX",
            " SG_ Flag : 0|1@1+ (1,0) [0|0] \"\" Vector__XXX",
            " SG_ Level : 8|16@1- (1,0) [0|0] \"\" Vector__XXX",
            " SG_ Flow : 24|32@1- (1,0) [0|0] \"\" Vector__XXX",
        ]
    );
    assert_eq!(
        lines(&dbc, "SIG_VALTYPE_"),
        ["SIG_VALTYPE_ 641 Volume : 2;", "SIG_VALTYPE_ 2148676694 Flow : 1;"]
    );
    assert_eq!(omitted(&dbc), [""; 0]);
}

#[test]
fn what_a_signal_cannot_hold_is_reported() {
    let mut device = device();
    map(&mut device, 0x1400, 0x8000_0201, &[0x2001_0010]);
    map(&mut device, 0x1401, 0x301, &[]);
    map(&mut device, 0x1402, 0x601, &[0x2001_0010]);
    map(&mut device, 0x1800, 0x181, &[0x2003_0020, 0x2001_0010, 0x2002_0010, 0x2006_0010]);
    device.objects.insert(0x1A01, record(&[(0, Some(1)), (1, Some(0x2001_0010))]));
    let dbc = write(&[node(&device, 1)], DbcOptions::default());
    assert_eq!(
        omitted(&dbc),
        [
            "left out 0x1400sub1: the PDO is not valid (bit 31 of its COB-ID)",
            "left out 0x1601sub0: nothing is mapped",
            "lost 0x1402sub1: CAN-ID 0x601 is used by default SDO, client to server",
            "lost 0x1801sub1: the COB-ID of the PDO is not stated",
            "lost 0x1A00sub1: 2003h:00, 32 bits: a signal holds a number, but this is a string or bytes",
            "lost 0x1A00sub3: 2002h:00, 16 bits: a part of a REAL is not a number",
            "lost 0x1A00sub4: 2006h:00, 16 bits: it ends beyond the 64 bits of a frame",
        ]
    );
}

#[test]
fn senders_and_receivers_share_a_message() {
    let (mut sender, mut receiver) = (device(), device());
    map(&mut sender, 0x1800, 0x181, &[0x2001_0010, 0x2006_0010, 0x2001_0010]);
    map(&mut receiver, 0x1400, 0x181, &[0x2001_0010, 0x0006_0010, 0x2006_0010]);
    let dbc = write(&[node(&receiver, 2), node(&sender, 1)], DbcOptions::default());
    let signals = lines(&dbc, " SG_ ");
    assert_eq!(
        signals[2..5],
        [
            " SG_ Level : 0|16@1- (1,0) [0|0] \"\" Node_2",
            " SG_ Word : 16|16@1+ (1,0) [0|0] \"\" Vector__XXX",
            " SG_ Level_2001_00 : 32|16@1- (1,0) [0|0] \"\" Node_2",
        ]
    );
    let reason = "2006h:00, 16 bits: the frame has the signals of TPDO 1 of Node 1 (1800h, 1A00h)";
    assert_eq!(omitted(&dbc), [format!("lost 0x1600sub3: {reason}")]);
}

/// Synchronous PDOs have the cycle of the SYNC that their node listens to; times with a fraction of a millisecond are reported.
#[test]
fn synchronous_pdos_are_cyclic() {
    let number = |value: u64| record(&[(0, Some(value))]);
    let with_types = |first: u64, second: u64| {
        let mut device = device();
        for (position, transmission) in (0..).zip([first, second]) {
            let cob_id = 0x181 + 0x100 * u64::from(position);
            map(&mut device, 0x1800 + position, cob_id, &[0x2001_0010]);
            let communication = device.objects.get_mut(&(0x1800 + position)).unwrap();
            communication.subs.get_mut(2).unwrap().default = Some(Value::Unsigned(transmission));
        }
        device
    };
    let mut producer = Device::default();
    producer.objects.insert(0x1005, number(0x4000_0080));
    for (period, cycles, missing) in [
        (10_000, ["128 10", "385 10", "641 2400"], &[][..]),
        (
            2500,
            ["385 10", "641 600", ""],
            &["lost 0x1006sub0: GenMsgCycleTime has whole milliseconds, and the time is 2500 µs"],
        ),
    ] {
        producer.objects.insert(0x1006, number(period));
        let consumer = if period == 2500 { with_types(4, 240) } else { with_types(1, 240) };
        let dbc = write(&[node(&consumer, 1), node(&producer, 2)], DbcOptions::default());
        let found = lines(&dbc, "BA_ \"GenMsgCycleTime\"");
        let expected = cycles.iter().filter(|cycle| !cycle.is_empty());
        let expected: Vec<String> =
            expected.map(|cycle| format!("BA_ \"GenMsgCycleTime\" BO_ {cycle};")).collect();
        assert_eq!((found, omitted(&dbc)), (expected, missing.iter().map(ToString::to_string).collect()));
    }
    // acyclic, and on a different SYNC
    let mut consumer = with_types(0, 1);
    consumer.objects.insert(0x1005, number(0x90));
    let dbc = write(&[node(&consumer, 1), node(&producer, 2)], DbcOptions::default());
    assert_eq!(lines(&dbc, "BA_ \"GenMsgCycleTime\""), [""; 0]);
}

/// A manager without a description sends the messages that nodes receive, and vice versa.
#[test]
fn a_counterpart_has_the_other_side() {
    let (mut drive, mut manager) = (device(), device());
    map(&mut drive, 0x1400, 0x201, &[0x2001_0010]);
    map(&mut drive, 0x1800, 0x181, &[0x2006_0010]);
    map(&mut manager, 0x1400, 0x181, &[0x2200_0110]);
    map(&mut manager, 0x1800, 0x201, &[0x2000_0110]);
    map(&mut manager, 0x1801, 0x301, &[0x2000_0110]);
    let timed = [(0, Some(5)), (1, Some(0x201)), (2, Some(255)), (5, Some(20))];
    manager.objects.insert(0x1800, record(&timed));
    let counterpart = BusNode { name: Some("plc"), is_counterpart: true, ..node(&manager, 2) };
    let dbc = write(&[node(&drive, 1), counterpart], DbcOptions { sdo: true, bits: false });
    let messages = lines(&dbc, "BO_ ");
    let pdos: Vec<_> = messages.iter().filter(|line| line.contains("PDO")).collect();
    assert_eq!(pdos, ["BO_ 385 Node_1_TPDO1: 2 Node_1", "BO_ 513 plc_TPDO1: 2 plc"]);
    let signals = lines(&dbc, " SG_ ");
    assert!(signals.contains(&" SG_ Word : 0|16@1+ (1,0) [0|0] \"\" plc".to_owned()), "{signals:#?}");
    assert!(signals.contains(&" SG_ Level : 0|16@1- (1,0) [0|0] \"\" Node_1".to_owned()), "{signals:#?}");
    assert_eq!(lines(&dbc, "BA_ \"GenMsgCycleTime\""), ["BA_ \"GenMsgCycleTime\" BO_ 513 20;"]);
    assert_eq!(omitted(&dbc), [""; 0]);
    assert!(!messages.iter().any(|line| line.contains("plc_SDO")), "{messages:#?}");
}

#[test]
fn words_can_be_bits_and_sdos_are_multiplexed() {
    let mut device = Device::default();
    let mut device_type = record(&[]);
    device_type.main = Entry { default: Some(Value::Unsigned(402)), ..Entry::default() };
    device.objects.insert(0x1000, device_type);
    device.objects.get_mut(&0x1000).unwrap().main.data_type = Some(DataType::UNSIGNED32);
    put(&mut device, 0x6040, "Controlword", DataType::UNSIGNED16);
    map(&mut device, 0x1400, 0x201, &[0x6040_0010]);
    let dbc = write(&[node(&device, 1)], DbcOptions { sdo: true, bits: true });
    let signals = lines(&dbc, " SG_ ");
    let has = |signal: &str| signals.iter().any(|line| line.starts_with(signal));
    assert!(has(" SG_ Controlword_fault_reset : 7|1@1+ (1,0) [0|0] \"\" Node_1"), "{signals:#?}");
    assert!(has(" SG_ Controlword_of_the_mode : 4|3@1+") && has(" SG_ Controlword_of_the_mode_9 : 9|1@1+"));
    for (name, command) in [("request", 1), ("response", 2)] {
        assert!(has(&format!(" SG_ Entry m{command}M : 8|24@1+")), "{name}: {signals:#?}");
    }
    assert!(has(" SG_ Controlword m24640 : 32|16@1+") && has(" SG_ Abort_code m4 : 32|32@1+"));
    // the request is 601h, and the word is readable and writable
    let selected = |id: u32| -> Vec<String> {
        let of_word = ["Entry", "Entry_without_value", "Abort_code", "Data", "Controlword"];
        let name = |line: &String| of_word.contains(&line.split(' ').nth(2).unwrap());
        lines(&dbc, &format!("SG_MUL_VAL_ {id} ")).into_iter().filter(name).collect()
    };
    for (id, commands) in [(0x601, ["1-1", "2-2", "0-0, 3-3, 5-6"]), (0x581, ["2-2", "3-3", "0-0, 1-1, 5-6"])]
    {
        let [with_value, without_value, others] = commands;
        assert_eq!(
            selected(id),
            [
                format!("SG_MUL_VAL_ {id} Entry Command {with_value};"),
                format!("SG_MUL_VAL_ {id} Entry_without_value Command {without_value}, 4-4;"),
                format!("SG_MUL_VAL_ {id} Abort_code Command 4-4;"),
                format!("SG_MUL_VAL_ {id} Data Command {others};"),
                format!("SG_MUL_VAL_ {id} Controlword Entry 24640-24640;"),
            ]
        );
    }
    let codes = lines(&dbc, "VAL_ 1409 Abort_code");
    assert!(codes[0].contains(r#" 100728834 "attempt to write a read-only entry" "#), "{codes:?}");
    assert_eq!(codes[0].matches('"').count() / 2, 31, "all codes of CiA 301");
}

#[test]
fn nodes_of_one_name_have_their_node_id_in_it() {
    let device = device();
    let pump = |node_id| BusNode { name: Some("pump"), ..node(&device, node_id) };
    let dbc = write(&[pump(2), pump(1)], DbcOptions::default());
    assert_eq!(
        lines(&dbc, "BO_ ")[1..],
        ["BO_ 1793 pump_1_heartbeat: 1 pump_1", "BO_ 1794 pump_heartbeat: 1 pump"]
    );
}
