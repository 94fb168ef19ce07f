use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, Fix, RuleInfo, Severity, say};
use crate::model::{DeviceKind, MappedObject, PdoKind};
use crate::{Facts, PdoFacts, Target, rule};

rule! {
    "cia406/wrong-default-mapping", Error, Applied(check), fix Unsafe;
    summary: "a TPDO of an encoder does not carry the position",
    checks: "Whether TPDO 1 and TPDO 2 of an EDS carry the position and nothing else: 6004h with 32 bits, 6008h with 64 bits in encoders of high precision, 6020h sub-index 1 in those with several sensors. Further objects after the position are a warning. TPDO 2 is not checked if there is a TPDO 3, which was the synchronous one before edition 3. PDOs with invalid entries are not checked.",
    why: "Encoders are interchangeable because the position is in the first four bytes of TPDO 1.",
    example: "`[1A00sub1]` with `DefaultValue=0x65030010`",
    remedy: "Write `0x60040020`, in the description and in the device.",
    source: "CiA 406 (1A00h, 1A01h)",
}

/// The object with the position, in its different formats.
const POSITIONS: [MappedObject; 3] = [
    MappedObject { index: 0x6004, sub: 0, bits: 32 },
    MappedObject { index: 0x6008, sub: 0, bits: 64 },
    MappedObject { index: 0x6020, sub: 1, bits: 32 },
];

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    if device.kind != DeviceKind::Type || applied.block > 0 || device.profile() == Some(0xFFFF) {
        return;
    }
    let numbers = if device.objects.contains_key(&0x1802) { 1..=1 } else { 1..=2 };
    let pdos = facts.pdos.iter();
    for pdo in pdos.filter(|pdo| pdo.pdo.kind == PdoKind::Tpdo && numbers.contains(&pdo.pdo.number)) {
        let Some(first) = pdo.mapped.first().filter(|_| is_readable(pdo)) else { continue };
        let right = POSITIONS.contains(&first.object);
        if right && pdo.mapped.len() == 1 {
            continue;
        }
        let index = pdo.pdo.mapping_index();
        if right {
            let message = say!("{} maps more than the position", pdo.pdo);
            let place = device.value_place(index, pdo.mapped.get(1).map_or(0, |second| second.slot));
            let finding = Diagnostic::new(rule, place, message).severity(Severity::Warning);
            let fix = Fix::risky("map the position only").set(device.value_place(index, 0), "1");
            findings.push(finding.help("map other values into other TPDOs").fix(fix));
            continue;
        }
        let MappedObject { index: found, sub, bits } = first.object;
        let message = match POSITIONS.iter().find(|right| (right.index, right.sub) == (found, sub)) {
            Some(right) => say!(
                "{} maps {} bits of {:04X}h:{:02X}, CiA 406 maps {}",
                pdo.pdo,
                bits,
                found,
                sub,
                right.bits
            ),
            None => say!("{} maps {:04X}h:{:02X} first, not the position", pdo.pdo, found, sub),
        };
        let finding = Diagnostic::new(rule, device.value_place(index, first.slot), message);
        let (is_there, number) = match device.object(0x6004) {
            Some(_) => (true, "0x60040020"),
            None => (device.objects.contains_key(&0x6020), "0x60200120"),
        };
        let finding = finding.help(say!("write `{}` and 1 as number of mapped objects", number));
        let fix = Fix::risky("map the position").set(device.value_place(index, 0), "1");
        let fix = fix.set(device.value_place(index, first.slot), number);
        findings.push(if is_there { finding.fix(fix) } else { finding });
    }
}

/// Whether the mapping is stated and not reported by another rule.
fn is_readable(pdo: &PdoFacts<'_>) -> bool {
    let fits = |target: &Target<'_>| match target {
        Target::Entry(entry) => entry.is_mappable() && entry.fits_pdo(pdo.pdo.kind),
        _ => false,
    };
    pdo.lengths_are_right() && pdo.mapped.iter().all(|mapped| fits(&mapped.target))
}
