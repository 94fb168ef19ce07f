use crate::demands::Against;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::model::{Part, Place};
use crate::rule;

rule! {
    "cia301/incomplete-sdo-parameter", Error, Against(check);
    summary: "an SDO parameter lacks a sub-index",
    checks: "Whether each SDO server (1200h to 127Fh) has sub-indexes 1 and 2, the COB-IDs of both directions, and each SDO client (1280h to 12FFh) also has sub-index 3, the node-ID of its server.",
    why: "An SDO channel needs both identifiers, and a client needs the node-ID of its server.",
    example: "`[1280]` with only sub-indexes 0 to 2",
    remedy: "Describe the missing sub-index.",
    source: "CiA 301 §7.5.2.33, §7.5.2.34",
}

fn check(rule: &'static RuleInfo, at: &Against<'_>, findings: &mut Findings) {
    let (index, object) = (at.index, at.object);
    if !(0x1200..=0x12FF).contains(&index) || object.orphan || !object.object_type().has_subs() {
        return;
    }
    let needed = at.facts.entries().filter(|entry| entry.is_mandatory() && entry.first > 0);
    for entry in needed.filter(|entry| !object.has(entry.first)) {
        let (sub, name) = (entry.first, entry.name);
        let message = say!("{} is missing sub-index {} ({})", at, sub, name);
        let finding = Diagnostic::new(rule, Place::object(index), message);
        findings.push(finding.help(say!("add `{}`", Part::Entry(index, sub))));
    }
}
