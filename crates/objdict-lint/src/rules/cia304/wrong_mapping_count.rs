use crate::diagnostic::{Diagnostic, Findings, say, sub_index};
use crate::{Facts, rule};

rule! {
    "cia304/wrong-mapping-count", Error, Facts(check);
    summary: "the number of mapped objects of an SRDO is not valid",
    checks: "Whether sub-index 0 of each SRDO mapping is an even number from 0 to 16, and whether each counted entry is described and contains an object.",
    why: "Entries are pairs of a plain and an inverted object. A device rejects an odd number and an entry without an object.",
    example: "`[1381sub0]` with `DefaultValue=3`",
    remedy: "Map the inverted object of each plain one, and count both.",
    source: "EN 50325-5 (CiA 304)",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    for srdo in &facts.srdos {
        let (Some(count), Some(object)) = (srdo.mapped_count, srdo.mapping) else { continue };
        let index = srdo.mapping_index();
        let place = facts.device.value_place(index, 0);
        let finding = if count > 16 {
            let message = say!("{} maps `{}` objects, but 16 is the maximum", srdo, count);
            Diagnostic::new(&RULE.info, place, message).help("write 0, or an even number up to 16")
        } else if count % 2 == 1 {
            let message = say!("{} maps `{}` objects, an odd number", srdo, count);
            Diagnostic::new(&RULE.info, place, message).help("map the inverted object of each plain one")
        } else {
            let is_filled = |sub: u8| {
                srdo.slots
                    .iter()
                    .any(|slot| slot.sub == sub && slot.object.is_some_and(|object| !object.is_unused()))
            };
            let Some(sub) = (1..=count).find(|&sub| !is_filled(sub)) else { continue };
            let what = if object.has(sub) { "is empty" } else { "is not described" };
            let message = say!(
                "{} maps `{}` objects, but sub-index {} of {:04X}h {}",
                srdo,
                count,
                sub_index(sub),
                index,
                what
            );
            Diagnostic::new(&RULE.info, place, message)
                .help("describe the entry with its object, or write a smaller number")
        };
        findings.push(finding);
    }
}
