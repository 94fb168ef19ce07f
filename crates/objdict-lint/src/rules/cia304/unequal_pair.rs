use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{Facts, rule};

rule! {
    "cia304/unequal-pair", Error, Facts(check);
    summary: "the two objects of a pair in an SRDO have different lengths",
    checks: "Whether the inverted object of each mapped pair (even sub-index) has the length of the plain one (odd sub-index).",
    why: "The receiver compares the two frames bit by bit. After objects of different lengths it compares unrelated bits, and the device enters its safe state.",
    example: "`[1381sub1]` with `DefaultValue=0x61000108` and `[1381sub2]` with `DefaultValue=0x61010110`",
    remedy: "Map the matching inverted object.",
    source: "EN 50325-5 (CiA 304)",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    for srdo in &facts.srdos {
        for (plain, inverted) in srdo.pairs().filter(|(plain, inverted)| plain.1.bits != inverted.1.bits) {
            let place = |sub| facts.device.value_place(srdo.mapping_index(), sub);
            let message =
                say!("{} maps {} with the inverted object {} of another length", srdo, plain.1, inverted.1);
            let finding = Diagnostic::new(&RULE.info, place(inverted.0), message)
                .label(place(plain.0), "the plain object");
            findings.push(finding.help("map the matching inverted object"));
        }
    }
}
