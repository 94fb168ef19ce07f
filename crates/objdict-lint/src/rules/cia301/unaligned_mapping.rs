use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::MappedObject;
use crate::{Facts, PdoFacts, rule};

rule! {
    "cia301/unaligned-mapping", Note, Pdo(check);
    summary: "a byte-sized object does not start at a byte boundary of its PDO",
    checks: "Whether each mapped object of 8 bits or more starts at a byte boundary of the frame.",
    why: "Most devices and masters copy whole bytes, and reject the mapping or read it incorrectly.",
    example: "`[1A00sub1]` with `DefaultValue=0x60200101` and `[1A00sub2]` with `DefaultValue=0x60000108`",
    remedy: "Map the single bits last, or fill the byte before.",
    source: "CiA 301 §7.5.2.36",
}

fn check(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let granularity = facts.device.device_info.as_ref().and_then(|info| info.granularity).unwrap_or(0);
    // with another granularity, `mapping-granularity` reports the object
    if granularity > 1 || !pdo.lengths_are_right() {
        return;
    }
    let mut placed = MappedObject::placed(&pdo.mapped, |mapped| mapped.object.bits);
    let unaligned = placed.find(|(start, mapped)| mapped.object.bits >= 8 && !start.is_multiple_of(8));
    let Some((start, mapped)) = unaligned else { return };
    let message = say!("{} maps {} at bit {}, which is not a byte boundary", pdo.pdo, mapped.object, start);
    let place = facts.device.value_place(pdo.pdo.mapping_index(), mapped.slot);
    let finding = Diagnostic::new(&RULE.info, place, message);
    findings.push(finding.help("map the single bits last, or fill the byte before"));
}
