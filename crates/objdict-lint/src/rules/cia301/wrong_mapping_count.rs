use crate::diagnostic::{Diagnostic, Findings, Fix, Text, say};
use crate::model::Object;
use crate::{Facts, PdoFacts, is_unstated, rule};

rule! {
    "cia301/wrong-mapping-count", Error, Pdo(check), fix Unsafe;
    summary: "the number of mapped objects is out of range or greater than the number of entries",
    checks: "Whether sub-index 0 of each PDO mapping is 0 to 64, or 254 or 255 for a multiplexed PDO, and whether each counted entry is described and contains an object.",
    why: "A device rejects a number greater than its entries. Tools show a frame with gaps.",
    example: "`[1A00sub0]` with `DefaultValue=3`, without `[1A00sub3]`",
    remedy: "Write the number of entries in use, counted from sub-index 1 without gaps.",
    source: "CiA 301 §7.5.2.36 table 69",
}

fn check(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let (Some(count), Some(object)) = (pdo.pdo.mapped_count, pdo.pdo.mapping) else { return };
    let index = pdo.pdo.mapping_index();
    let place = facts.device.value_place(index, 0);
    let finding = |message: Text| Diagnostic::new(&RULE.info, place.clone(), message);
    if (65..=253).contains(&count) {
        let finding = finding(say!(
            "the number of mapped objects of {} is `{}`, which is not from 0 to 64",
            pdo.pdo,
            count
        ));
        findings
            .push(finding.help("write the number of entries in use; 254 and 255 are for multiplexed PDOs"));
        return;
    }
    if count > 64 || object.orphan || !object.object_type().has_subs() {
        return;
    }
    let is_empty = |sub: u8| is_unstated(object, sub) || mapped_number(object, sub) == Some(0);
    let Some(sub) = (1..=count).find(|&sub| !object.has(sub) || is_empty(sub)) else { return };
    let message = say!("{} maps `{}` objects", pdo.pdo, count);
    let finding = if object.has(sub) {
        let finding = finding(say!("{}, but sub-index {} of {:04X}h is empty", message, sub, index));
        finding.label(facts.device.value_place(index, sub), "the first entry without an object")
    } else {
        finding(say!("{}, but {:04X}h has no sub-index {}", message, index, sub))
    };
    let title = say!("write the number of entries in use: `{}`", sub - 1);
    let fix = Fix::risky(title.clone()).set(place.clone(), (sub - 1).to_string());
    findings.push(finding.help(title).fix(fix));
}

fn mapped_number(object: &Object, sub: u8) -> Option<i128> {
    object.value(sub)?.as_integer()
}
