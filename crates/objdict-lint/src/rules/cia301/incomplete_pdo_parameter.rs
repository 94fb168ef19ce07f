use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Part, Place};
use crate::{Facts, PdoFacts, rule};

rule! {
    "cia301/incomplete-pdo-parameter", Error, Pdo(check);
    summary: "a PDO communication parameter lacks the COB-ID or the transmission type",
    checks: "Whether each object from 1400h to 15FFh and from 1800h to 19FFh has sub-indexes 1 and 2.",
    why: "A manager cannot configure the PDO, and a tool cannot show when it is sent.",
    example: "`[1801]` with only `[1801sub0]` and `[1801sub1]`",
    remedy: "Describe the missing sub-index.",
    source: "CiA 301 §7.5.2.35, §7.5.2.37",
}

fn check(_: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let Some(object) = pdo.communication_record() else { return };
    let pdo = &pdo.pdo;
    let index = pdo.communication_index();
    for (sub, name) in [(1, "COB-ID"), (2, "transmission type")] {
        if !object.has(sub) {
            let message = say!("{} is missing sub-index {} ({}) of {:04X}h", pdo, sub, name, index);
            let finding = Diagnostic::new(&RULE.info, Place::object(index), message);
            findings.push(finding.help(say!("add `{}`", Part::Entry(index, sub))));
        }
    }
}
