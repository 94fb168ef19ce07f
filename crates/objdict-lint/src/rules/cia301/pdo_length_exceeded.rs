use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{MappedObject, Pdo};
use crate::{Facts, PdoFacts, rule};

rule! {
    "cia301/pdo-length-exceeded", Error, Pdo(check);
    summary: "a PDO is longer than 64 bits",
    checks: "Whether the lengths of the mapped objects of a PDO add up to at most 64 bits. Missing objects and wrong lengths have their own rules.",
    why: "A CAN frame has eight data bytes. The device rejects the mapping with abort 0604 0042h when sub-index 0 is written.",
    example: "five UNSIGNED16 in `[1A00]`",
    remedy: "Move objects to another PDO.",
    source: "CiA 301 §7.5.2.36",
}

fn check(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let bits: u32 = pdo.mapped.iter().map(|mapped| u32::from(mapped.object.bits)).sum();
    if bits <= Pdo::FRAME_BITS || !pdo.lengths_are_right() {
        return;
    }
    let mut placed = MappedObject::placed(&pdo.mapped, |mapped| mapped.object.bits);
    let beyond =
        placed.find(|(first, mapped)| first + u32::from(mapped.object.bits) > Pdo::FRAME_BITS);
    let index = pdo.pdo.mapping_index();
    let place = facts.device.value_place(index, beyond.map_or(0, |(_, mapped)| mapped.slot));
    let message = say!("{} maps {} bits, {} more than a CAN frame holds", pdo.pdo, bits, bits - Pdo::FRAME_BITS);
    let finding = Diagnostic::new(&RULE.info, place, message);
    let finding = finding.label(facts.device.value_place(index, 0), "the number of mapped objects");
    findings.push(finding.help("move this object and the following ones to another PDO"));
}
