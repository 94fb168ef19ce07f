use super::*;
use crate::Language;
use crate::model::{Device, Value};

fn of(index: u16, sub: u8, value: &Value, node_id: Option<u8>) -> String {
    Decoder::english(&Device::default(), node_id).of(index, sub, value).unwrap_or_default()
}

fn german(index: u16, sub: u8, number: u64) -> String {
    let device = Device::default();
    let decoder = Decoder { language: Language::German, ..Decoder::english(&device, Some(5)) };
    decoder.of(index, sub, &Value::Unsigned(number)).unwrap_or_default()
}

#[test]
fn cob_ids_say_what_they_do() {
    assert_eq!(of(0x1400, 1, &Value::NodeId(0x200), Some(5)), "CAN-ID 0x205, 11 bits, valid");
    assert_eq!(of(0x1400, 1, &Value::NodeId(0x8000_0200), None), "CAN-ID $NODEID+0x200, 11 bits, not valid");
    assert_eq!(
        of(0x1801, 1, &Value::Unsigned(0x4000_0285), None),
        "CAN-ID 0x285, 11 bits, valid, no remote frames"
    );
    assert_eq!(of(0x1005, 0, &Value::Unsigned(0x4000_0080), None), "CAN-ID 0x080, 11 bits, produces SYNC");
    assert_eq!(of(0x1012, 0, &Value::Unsigned(0x8000_0100), None), "CAN-ID 0x100, 11 bits, consumes TIME");
    assert_eq!(of(0x1200, 1, &Value::Unsigned(0x2001_0000), None), "CAN-ID 0x00010000, 29 bits, valid");
    assert_eq!(
        of(0x1280, 2, &Value::Unsigned(0xC000_0583), None),
        "CAN-ID 0x583, 11 bits, not valid, assigned dynamically"
    );
    assert_eq!(of(0x1028, 3, &Value::Unsigned(0x83), None), "EMCY of node 3: CAN-ID 0x083, 11 bits, valid");
}

#[test]
fn mappings_say_what_they_carry() {
    assert_eq!(of(0x1A00, 1, &Value::Unsigned(0x0005_0008), None), "8 bits unused (dummy UNSIGNED8)");
    assert_eq!(of(0x1A00, 2, &Value::Unsigned(0), None), "");
    let missing = of(0x1600, 1, &Value::Unsigned(0x6040_0010), None);
    assert_eq!(missing, "0x6040sub0, which the description lacks, 16 bits");
    assert_eq!(of(0x1600, 0, &Value::Unsigned(0xFF), None), "MPDO that names its destination");
    assert_eq!(of(0x1600, 0, &Value::Unsigned(8), None), "");
    assert_eq!(of(0x1FA0, 1, &Value::Unsigned(0x0460_0001), None), "0x6000sub1 and the next 3");
}

#[test]
fn times_have_units() {
    assert_eq!(of(0x1800, 3, &Value::Unsigned(105), None), "10.5 ms");
    assert_eq!(of(0x1800, 3, &Value::Unsigned(0), None), "off");
    assert_eq!(of(0x1016, 2, &Value::Unsigned(0x0003_01F4), None), "node 3, 500 ms");
    assert_eq!(of(0x1020, 1, &Value::Unsigned(15_341), None), "2026-01-01");
    assert_eq!(
        of(0x1000, 0, &Value::Unsigned(0x0002_0192), None),
        "device profile CiA 402 (drives), additional information 0x0002"
    );
}

#[test]
fn only_documents_of_cia_are_called_so() {
    let says = |number| of(0x1000, 0, &Value::Unsigned(number), None);
    assert_eq!(says(0x1BF), "device profile CiA 447, additional information 0x0000");
    for number in [256, 301, 4660, 20500] {
        let words = format!("profile number {number} (not a CiA profile), additional information 0x0000");
        assert_eq!(says(number), words);
    }
    assert_eq!(german(0x1000, 0, 256), "Profilnummer 256 (kein Profil von CiA), Zusatzinformation 0x0000");
}

#[test]
fn errors_have_names() {
    assert_eq!(of(0x1001, 0, &Value::Unsigned(0x11), None), "generic error, communication");
    assert_eq!(
        of(0x1003, 1, &Value::Unsigned(0x0005_8130), None),
        "0x8130 (heartbeat or guarding lost), additional information 0x0005"
    );
    let names =
        [0x2110, 0x2910, 0x9001, 0xFF01, 0xA000].map(|code| of(0x1003, 1, &Value::Unsigned(code), None));
    let names = names.map(|name| name.split(['(', ')']).nth(1).unwrap_or_default().to_owned());
    assert_eq!(names, ["current, input side", "current", "external error", "of the device", "reserved"]);
    assert_eq!(of(0x1029, 1, &Value::Unsigned(2), None), "the device stops");
}

#[test]
fn a_drive_has_error_codes_of_its_own() {
    let mut drive = Device::default();
    drive.objects.get_or_insert_with(0x1000, Default::default).main.default = Some(Value::Unsigned(402));
    let of = |index, sub, number| {
        Decoder::english(&drive, None).of(index, sub, &Value::Unsigned(number)).unwrap_or_default()
    };
    assert_eq!(of(0x603F, 0, 0x2310), "continuous over-current, motor side");
    assert_eq!(of(0x603F, 0, 0x8130), "heartbeat or guarding lost");
    assert_eq!(of(0x1003, 1, 0x8611), "0x8611 (following error), additional information 0x0000");
}

#[test]
fn capabilities_and_signatures_are_distinguished() {
    assert_eq!(of(0x1010, 1, &Value::Unsigned(3), None), "stores on command and automatically");
    assert_eq!(of(0x1010, 1, &Value::Unsigned(0x6576_6173), None), "signature `save`");
    assert_eq!(of(0x1011, 2, &Value::Unsigned(0), None), "does not restore defaults");
}

#[test]
fn german_sentences() {
    assert_eq!(german(0x1801, 1, 0x4000_0285), "CAN-ID 0x285, 11 Bit, gültig, keine Remote-Frames");
    assert_eq!(german(0x1800, 2, 10), "synchron, mit jedem 10. SYNC");
    assert_eq!(german(0x1015, 0, 105), "10,5 ms");
    assert_eq!(german(0x1017, 0, 0), "aus");
    assert_eq!(german(0x1018, 3, 0x0001_0002), "Hauptrevision 1, Nebenrevision 2");
    assert_eq!(german(0x1000, 0, 0x0001_0191), "Geräteprofil CiA 401 (E/A-Module), Zusatzinformation 0x0001");
}
