use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{Facts, rule};

rule! {
    "cia304/srdo-length-exceeded", Error, Facts(check);
    summary: "an SRDO carries more than 64 bits",
    checks: "Whether the plain objects that an SRDO maps, and the inverted ones, are at most 64 bits together.",
    why: "A frame has eight bytes.",
    example: "nine pairs of 8 bits in `[1381]`",
    remedy: "Take objects out, or put them into another SRDO.",
    source: "EN 50325-5 (CiA 304)",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    for srdo in &facts.srdos {
        let bits: u32 = srdo.pairs().map(|(plain, _)| u32::from(plain.1.bits)).sum();
        if bits > 64 {
            let place = facts.device.value_place(srdo.mapping_index(), 0);
            let message = say!("{} carries {} bits, and a frame has 64", srdo, bits);
            let finding = Diagnostic::new(&RULE.info, place, message);
            findings.push(finding.help("take objects out, or put them into another SRDO"));
        }
    }
}
