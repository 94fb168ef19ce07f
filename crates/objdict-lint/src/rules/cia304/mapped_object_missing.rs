use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{Facts, Target, rule};

rule! {
    "cia304/mapped-object-missing", Error, Facts(check);
    summary: "an SRDO maps an object that does not exist",
    checks: "Whether each object that an SRDO maps is described. Dummy entries and objects that modules may provide are not checked.",
    why: "The device rejects the mapping, or the description lacks a part of the safety function.",
    example: "`[1381sub1]` with `DefaultValue=0x61000108`, without `[6100]`",
    remedy: "Describe the object, or map the intended one.",
    source: "EN 50325-5 (CiA 304)",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    for srdo in &facts.srdos {
        for (sub, mapped) in srdo.mapped() {
            let what = match Target::of(facts.device, mapped) {
                Target::NoObject => "but there is no such object",
                Target::NoEntry => "but the object has no such sub-index",
                Target::Count => "the number of entries of an array or record",
                _ => continue,
            };
            let message = say!("{} maps {:04X}h:{:02X}, {}", srdo, mapped.index, mapped.sub, what);
            let place = facts.device.value_place(srdo.mapping_index(), sub);
            let finding = Diagnostic::new(&RULE.info, place, message);
            findings.push(finding.help("describe the object, or map the intended one"));
        }
    }
}
