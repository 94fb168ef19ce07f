use crate::diagnostic::{Diagnostic, Findings, say, sub_index};
use crate::{Facts, rule};

rule! {
    "cia304/wrong-mapping-count", Error, Facts(check);
    summary: "the number of objects that an SRDO maps cannot be",
    checks: "Whether sub-index 0 of each SRDO mapping is an even number from 0 to 16, and whether each of the entries that it counts is described and names an object.",
    why: "Entries come in pairs, the plain object and the inverted one. A device refuses an odd number, and an entry without an object.",
    example: "`[1381sub0]` with `DefaultValue=3`",
    remedy: "Map the inverted object of each, and count both.",
    source: "EN 50325-5 (CiA 304)",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    for srdo in &facts.srdos {
        let (Some(count), Some(object)) = (srdo.mapped_count, srdo.mapping) else { continue };
        let index = srdo.mapping_index();
        let place = facts.device.value_place(index, 0);
        let finding = if count > 16 {
            let message = say!("{} maps `{}` objects, and 16 are the most", srdo, count);
            Diagnostic::new(&RULE.info, place, message).help("write 0, or an even number up to 16")
        } else if count % 2 == 1 {
            let message = say!("{} maps `{}` objects, which are no pairs", srdo, count);
            Diagnostic::new(&RULE.info, place, message).help("map the inverted object of each plain one")
        } else {
            let is_filled = |sub: u8| {
                srdo.slots
                    .iter()
                    .any(|slot| slot.sub == sub && slot.object.is_some_and(|object| !object.is_unused()))
            };
            let Some(sub) = (1..=count).find(|&sub| !is_filled(sub)) else { continue };
            let what = if object.has(sub) { "names no object" } else { "is not described" };
            let message = say!(
                "{} maps `{}` objects, but sub-index {} of {:04X}h {}",
                srdo,
                count,
                sub_index(sub),
                index,
                what
            );
            Diagnostic::new(&RULE.info, place, message)
                .help("describe the entry with its object, or count less")
        };
        findings.push(finding);
    }
}
