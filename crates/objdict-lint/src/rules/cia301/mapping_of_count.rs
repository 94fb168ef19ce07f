use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::Place;
use crate::{Facts, PdoFacts, Target, rule};

rule! {
    "cia301/mapping-of-count", Error, Pdo(check);
    summary: "a PDO maps the number of entries instead of an entry",
    checks: "Whether a mapping entry that names sub-index 0 names a VAR. Sub-index 0 of an ARRAY or RECORD is a count.",
    why: "The PDO carries a constant. Mostly the sub-indexes were counted from 0, and the last one is missing.",
    example: "`[1A01sub1]` with `DefaultValue=0x64010010`, and 6401h is an ARRAY",
    remedy: "Begin with sub-index 1: `0x64010110`.",
    source: "CiA 301 §7.4.7.2, §7.5.2.36",
}

fn check(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    for mapped in pdo.mapped.iter().filter(|mapped| matches!(mapped.target, Target::Count)) {
        let index = mapped.object.index;
        let message = say!("{} maps {:04X}h:00, which is the number of its entries", pdo.pdo, index);
        let place = facts.device.value_place(pdo.pdo.mapping_index(), mapped.slot);
        let finding = Diagnostic::new(&RULE.info, place, message);
        let finding = finding.label(Place::object(index), "the values are in sub-indexes 1 and above");
        findings.push(finding.help("map a sub-index from 1 on"));
    }
}
