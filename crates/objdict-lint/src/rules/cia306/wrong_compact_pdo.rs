use crate::diagnostic::{Diagnostic, Findings, Fix, Severity, Text, say, series};
use crate::model::{Device, Field, Part, Place};
use crate::rule;

rule! {
    "cia306/wrong-compact-pdo", Warning, Device(check), fix Mixed;
    summary: "`CompactPDO` has an invalid mask",
    checks: "Whether `CompactPDO` has bits 0 and 1 (COB-ID and transmission type, present in every PDO), no bits 6 and 7 (sub-indexes 7 and 8 do not exist) and no bit 3 (sub-index 4 is reserved; used by many masters, so a note), and whether the device has PDOs.",
    why: "Tools create the communication records of all implied PDOs from this mask.",
    example: "`CompactPDO=0x1`",
    remedy: "Add 01h and 02h, 04h for an inhibit time, 10h for an event timer, 20h for a SYNC start value. Write 0 for a device without implied PDOs.",
    source: "CiA 306-1 §4.6.3.4.1, CiA 301 §7.4.8.1",
}

const MANDATORY: u8 = 0x03;
const POSSIBLE: u8 = 0x37;

fn check(device: &Device, findings: &mut Findings) {
    let Some(info) = &device.device_info else { return };
    let Some(mask) = info.compact_pdo.filter(|&mask| mask != 0) else { return };
    let place = Place::of(Part::DeviceInfo).field(Field::CompactPdo);
    let corrected = (mask & POSSIBLE) | MANDATORY;
    if info.rpdo_count == Some(0) && info.tpdo_count == Some(0) {
        let fix = Fix::safe(say!("write `{CompactPDO=0}`")).set(place.clone(), "0");
        let finding = Diagnostic::new(
            &RULE.info,
            place,
            say!("`{CompactPDO}` is {:#04x}, but the device has no PDO", mask),
        )
        .label(Place::of(Part::DeviceInfo).field(Field::NrOfRxPdo), "no RPDO")
        .label(Place::of(Part::DeviceInfo).field(Field::NrOfTxPdo), "no TPDO");
        findings.push(finding.help(say!("write `{CompactPDO=0}` or remove {the key}")).fix(fix));
    } else if corrected != mask {
        let message = match mask & MANDATORY {
            MANDATORY => say!("a PDO has no {}", subs(mask & !POSSIBLE)),
            present => say!("every PDO has {}", subs(MANDATORY & !present)),
        };
        let title = say!("write `CompactPDO={:#04x}`", corrected);
        let fix = Fix::risky(title.clone()).set(place.clone(), format!("{corrected:#04x}"));
        let only_sub_4 = mask ^ corrected == 1 << 3;
        let finding =
            Diagnostic::new(&RULE.info, place, say!("`{CompactPDO}` is {:#04x}, but {}", mask, message))
                .severity(if only_sub_4 { Severity::Note } else { Severity::Warning });
        findings.push(finding.help(title).fix(fix));
    }
}

/// The sub-indexes of the bits of a mask.
fn subs(mask: u8) -> Text {
    let subs = (0..8).filter(|bit| mask >> bit & 1 != 0).map(|bit| bit + 1);
    let word = if mask.is_power_of_two() { "sub-index" } else { "sub-indexes" };
    say!("{} {}", word, series(subs))
}
