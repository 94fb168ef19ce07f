use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{Facts, PdoFacts, rule};

rule! {
    "cia301/mapping-beyond-count", Note, Pdo(check);
    summary: "a PDO mapping has more entries than its sub-index 0 counts",
    checks: "Whether the entries of a PDO mapping above the number in sub-index 0 are 0 or empty. A mapping with 0 objects is disabled and may keep its entries.",
    why: "The entries seem to be mapped but are not. Often sub-index 0 was not increased with a new entry.",
    example: "`[1A00sub0]` with `DefaultValue=1`, and `[1A00sub2]` with `DefaultValue=0x60000208`",
    remedy: "Increase sub-index 0, or write 0 to the entry.",
    source: "CiA 301 §7.5.2.36 table 69",
}

fn check(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let Some(count) = pdo.pdo.mapped_count.filter(|count| (1..=64).contains(count)) else { return };
    let index = pdo.pdo.mapping_index();
    let beyond = pdo.pdo.slots.iter().filter(|slot| slot.sub > count);
    let mut beyond = beyond.filter(|slot| slot.object.is_some_and(|object| !object.is_unused()));
    let Some(first) = beyond.next() else { return };
    let message = say!(
        "sub-index {} of {:04X}h contains an object, but {} maps only `{}`",
        first.sub,
        index,
        pdo.pdo,
        count
    );
    let finding = Diagnostic::new(&RULE.info, facts.device.value_place(index, first.sub), message);
    let finding = finding.label(facts.device.value_place(index, 0), "the number of mapped objects");
    findings.push(finding.help("increase sub-index 0, or write 0 here"));
}
