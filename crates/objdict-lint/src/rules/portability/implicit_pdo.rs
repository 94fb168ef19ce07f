use crate::diagnostic::{Diagnostic, Findings, counted, say};
use crate::model::{Device, Field, Part, PdoKind, Place};
use crate::rule;

rule! {
    "portability/implicit-pdo", Note, Device(check);
    summary: "a PDO is only implied by `CompactPDO`",
    checks: "Whether `CompactPDO` and the PDO counts in `[DeviceInfo]` imply PDOs without objects in the file.",
    why: "python-canopen and CANopenEditor ignore `CompactPDO` (CANopenEditor unless the file has modules), so they do not know these PDOs.",
    example: "`NrOfTXPDO=2` and `CompactPDO=0x13` without `[1800]` and `[1801]`",
    remedy: "Describe the objects of the PDOs, for example with `objdict convert`.",
    source: "python-canopen 2.4.1, CANopenEditor of 2026",
}

fn check(device: &Device, findings: &mut Findings) {
    let implicit = device.implicit_pdos();
    if implicit.is_empty() {
        return;
    }
    let rpdos = implicit.iter().filter(|(kind, _)| *kind == PdoKind::Rpdo).count();
    let message = match (rpdos, implicit.len() - rpdos) {
        (0, tpdos) => say!("`{CompactPDO}` implies {}", counted(tpdos, "TPDO", "TPDOs")),
        (rpdos, 0) => say!("`{CompactPDO}` implies {}", counted(rpdos, "RPDO", "RPDOs")),
        (rpdos, tpdos) => say!(
            "`{CompactPDO}` implies {} and {}",
            counted(rpdos, "RPDO", "RPDOs"),
            counted(tpdos, "TPDO", "TPDOs")
        ),
    };
    let place = Place::of(Part::DeviceInfo).field(Field::CompactPdo);
    findings.push(Diagnostic::new(&RULE.info, place, message).help("describe the objects of these PDOs"));
}
