use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{Facts, rule};

rule! {
    "cia304/srdo-length-exceeded", Error, Facts(check);
    summary: "an SRDO is longer than 64 bits",
    checks: "Whether the plain objects of an SRDO, and the inverted ones, are each at most 64 bits long in total.",
    why: "A CAN frame has eight data bytes.",
    example: "nine pairs of 8 bits in `[1381]`",
    remedy: "Remove objects, or move them to another SRDO.",
    source: "EN 50325-5 (CiA 304)",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    for srdo in &facts.srdos {
        let bits: u32 = srdo.pairs().map(|(plain, _)| u32::from(plain.1.bits)).sum();
        if bits > 64 {
            let place = facts.device.value_place(srdo.mapping_index(), 0);
            let message = say!("{} maps {} bits, more than the 64 bits of a CAN frame", srdo, bits);
            let finding = Diagnostic::new(&RULE.info, place, message);
            findings.push(finding.help("remove objects, or move them to another SRDO"));
        }
    }
}
