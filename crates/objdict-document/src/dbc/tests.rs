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
            "lost 0x1402sub1: CAN-ID 0x601 is that of default SDO, client to server",
            "lost 0x1801sub1: the COB-ID of the PDO is not stated",
            "lost 0x1A00sub1: 2003h:00, 32 bits: a signal holds a number, and this is a text or bytes",
            "lost 0x1A00sub3: 2002h:00, 16 bits: a part of a REAL is not a number",
            "lost 0x1A00sub4: 2006h:00, 16 bits: it ends behind the 64 bits of a frame",
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
    let reason = "2006h:00, 16 bits: the signals of the frame are those of TPDO 1 of Node 1 (1800h, 1A00h)";
    assert_eq!(omitted(&dbc), [format!("lost 0x1600sub3: {reason}")]);
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
    assert!(has(" SG_ Entry M : 8|24@1+") && has(" SG_ Controlword m24640 : 32|16@1+"));
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
