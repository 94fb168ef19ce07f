use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::Place;
use crate::{Facts, rule, stated};

rule! {
    "cia304/srdo-without-mapping", Error, Facts(check);
    summary: "an SRDO has only one of its two objects",
    checks: "Whether each communication parameter of an SRDO (1301h to 1340h) has a mapping parameter (1381h to 13C0h), and the reverse.",
    why: "The communication parameter defines when and with which identifiers the SRDO is sent, the mapping its contents. The checksum of the safety configuration covers both.",
    example: "`[1301]` without `[1381]`",
    remedy: "Add the missing object.",
    source: "EN 50325-5 (CiA 304)",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    for srdo in &facts.srdos {
        let (there, missing, what) = match (srdo.communication, srdo.mapping) {
            (Some(_), None) => (srdo.communication_index(), srdo.mapping_index(), "mapping parameter"),
            (None, Some(_)) => (srdo.mapping_index(), srdo.communication_index(), "communication parameter"),
            _ => continue,
        };
        if stated::is_there(facts.device, missing) {
            continue;
        }
        let message = say!("{} has {:04X}h but no {:04X}h ({})", srdo, there, missing, what);
        let finding = Diagnostic::new(&RULE.info, Place::object(there), message);
        findings.push(finding.help(say!("add {:04X}h, or remove {:04X}h", missing, there)));
    }
}
