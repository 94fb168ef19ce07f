use std::ops::RangeInclusive;

use crate::diagnostic::{Diagnostic, Findings, Severity, Text, say};
use crate::model::{Device, Object, Place};
use crate::profile;
use crate::rule;

rule! {
    "cia301/obsolete-object", Note, Object(check);
    summary: "an object of an old edition of CiA 301",
    checks: "Whether the description has 1004h, 100Bh, 100Eh or 100Fh, which are reserved since version 4 of CiA 301. The finding is a warning if 1004h contradicts the description: its upper half was the number of RPDOs, its lower half the number of TPDOs.",
    why: "The objects are harmless but unused: 1018h, 1200h and the PDO parameters provide the same information. A master that reads wrong numbers in 1004h expects other PDOs.",
    example: "`[100B]`, the node-ID",
    remedy: "Omit the object in new devices.",
    source: "CiA 301 annex A, list of objects; CiA 301 version 3.0",
}

fn check(device: &Device, index: u16, object: &Object, findings: &mut Findings) {
    let Some(purpose) = profile::obsolete(index) else { return };
    let message = say!("{:04X}h ({}) is obsolete since version 4 of CiA 301", index, purpose);
    let contradiction = if index == 0x1004 { wrong_numbers(device, object) } else { None };
    let finding = match contradiction {
        Some(contradiction) => {
            let message = say!("{}; {}", message, contradiction);
            Diagnostic::new(&RULE.info, Place::object(index), message).severity(Severity::Warning)
        }
        None => Diagnostic::new(&RULE.info, Place::object(index), message),
    };
    findings.push(finding.help("remove the object unless an old tool needs it"));
}

/// How the numbers of PDOs in 1004h differ from the description; PDOs that `CompactPDO` implies are not described.
fn wrong_numbers(device: &Device, object: &Object) -> Option<Text> {
    let compact = device.device_info.as_ref().and_then(|info| info.compact_pdo);
    let stated = object.subs.get(0).unwrap_or(&object.main).value()?.as_integer()?;
    let count = |range: RangeInclusive<u16>| {
        i128::try_from(device.objects.range(range).filter(|(_, object)| !object.orphan).count()).ok()
    };
    let (rpdos, tpdos) = (count(0x1400..=0x15FF)?, count(0x1800..=0x19FF)?);
    let is_wrong = stated != rpdos << 16 | tpdos && compact.is_none_or(|mask| mask == 0);
    is_wrong.then(|| {
        say!(
            "its value states {} RPDOs and {} TPDOs, but {} and {} are described",
            stated >> 16,
            stated & 0xFFFF,
            rpdos,
            tpdos
        )
    })
}
