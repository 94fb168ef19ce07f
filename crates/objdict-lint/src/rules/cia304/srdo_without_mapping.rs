use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::Place;
use crate::{Facts, rule, stated};

rule! {
    "cia304/srdo-without-mapping", Error, Facts(check);
    summary: "an SRDO has one of its two objects only",
    checks: "Whether a mapping (1381h to 13C0h) belongs to each communication parameter of an SRDO (1301h to 1340h), and the other way round.",
    why: "The one says when and under which identifiers the SRDO is sent, the other what it carries. A safety configuration needs both for its checksum.",
    example: "`[1301]`, and no `[1381]`",
    remedy: "Add the other object.",
    source: "EN 50325-5 (CiA 304)",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    for srdo in &facts.srdos {
        let (there, missing, what) = match (srdo.communication, srdo.mapping) {
            (Some(_), None) => (srdo.communication_index(), srdo.mapping_index(), "mapping"),
            (None, Some(_)) => (srdo.mapping_index(), srdo.communication_index(), "communication parameter"),
            _ => continue,
        };
        if stated::is_there(facts.device, missing) {
            continue;
        }
        let message = say!("{} has {:04X}h, and no {:04X}h for its {}", srdo, there, missing, what);
        let finding = Diagnostic::new(&RULE.info, Place::object(there), message);
        findings.push(finding.help(say!("add {:04X}h, or remove {:04X}h", missing, there)));
    }
}
