use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Part, Place};
use crate::{Facts, rule};

const SUBS: [(u8, &str); 6] = [
    (1, "information direction"),
    (2, "refresh time or SCT"),
    (3, "SRVT"),
    (4, "transmission type"),
    (5, "COB-ID 1"),
    (6, "COB-ID 2"),
];

rule! {
    "cia304/incomplete-srdo-parameter", Error, Facts(check);
    summary: "an SRDO communication parameter lacks a sub-index",
    checks: "Whether each object from 1301h to 1340h has the sub-indexes 1 to 6.",
    why: "All of them are part of the safety configuration and its checksum, and none has an implicit value.",
    example: "`[1301]` with only sub-indexes 0 to 4",
    remedy: "Describe the missing sub-index.",
    source: "EN 50325-5 (CiA 304)",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    for srdo in &facts.srdos {
        let Some(object) =
            srdo.communication.filter(|object| !object.orphan && object.object_type().has_subs())
        else {
            continue;
        };
        let index = srdo.communication_index();
        for (sub, name) in SUBS.into_iter().filter(|(sub, _)| !object.has(*sub)) {
            let message = say!("{} is missing sub-index {} ({}) of {:04X}h", srdo, sub, name, index);
            let finding = Diagnostic::new(&RULE.info, Place::object(index), message);
            findings.push(finding.help(say!("add `{}`", Part::Entry(index, sub))));
        }
    }
}
