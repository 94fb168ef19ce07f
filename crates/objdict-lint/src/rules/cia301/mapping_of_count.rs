use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::Place;
use crate::{Facts, PdoFacts, Target, rule};

rule! {
    "cia301/mapping-of-count", Error, Pdo(check);
    summary: "a PDO maps the number of entries instead of an entry",
    checks: "Whether a mapping entry with sub-index 0 refers to a VAR. Sub-index 0 of an ARRAY or RECORD is the number of entries.",
    why: "The PDO transmits a constant. Often the sub-indexes were counted from 0, and the last one is not mapped.",
    example: "`[1A01sub1]` with `DefaultValue=0x64010010` for the ARRAY 6401h",
    remedy: "Start with sub-index 1: `0x64010110`.",
    source: "CiA 301 §7.4.7.2, §7.5.2.36",
}

fn check(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    for mapped in pdo.mapped.iter().filter(|mapped| matches!(mapped.target, Target::Count)) {
        let index = mapped.object.index;
        let message = say!("{} maps {:04X}h:00, the number of entries of an array or record", pdo.pdo, index);
        let place = facts.device.value_place(pdo.pdo.mapping_index(), mapped.slot);
        let finding = Diagnostic::new(&RULE.info, place, message);
        let finding = finding.label(Place::object(index), "the values are in sub-index 1 and above");
        findings.push(finding.help("map a sub-index above 0"));
    }
}
