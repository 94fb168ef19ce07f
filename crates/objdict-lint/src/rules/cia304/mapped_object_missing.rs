use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{Facts, Target, rule};

rule! {
    "cia304/mapped-object-missing", Error, Facts(check);
    summary: "an SRDO maps an object that does not exist",
    checks: "Whether each object that an SRDO maps is described. Fillers, and objects that modules bring, are left alone.",
    why: "The device refuses the mapping, or the description lacks a part of the safety function.",
    example: "`[1381sub1]` with `DefaultValue=0x61000108`, and no `[6100]`",
    remedy: "Describe the object, or map the one that was meant.",
    source: "EN 50325-5 (CiA 304)",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    for srdo in &facts.srdos {
        for (sub, mapped) in srdo.mapped() {
            let what = match Target::of(facts.device, mapped) {
                Target::NoObject => "and there is no such object",
                Target::NoEntry => "and the object has no such sub-index",
                Target::Count => "which is a number of entries",
                _ => continue,
            };
            let message = say!("{} maps {:04X}h:{:02X}, {}", srdo, mapped.index, mapped.sub, what);
            let place = facts.device.value_place(srdo.mapping_index(), sub);
            let finding = Diagnostic::new(&RULE.info, place, message);
            findings.push(finding.help("describe the object, or map the one that was meant"));
        }
    }
}
