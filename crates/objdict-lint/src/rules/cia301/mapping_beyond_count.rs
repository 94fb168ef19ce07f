use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{Facts, PdoFacts, rule};

rule! {
    "cia301/mapping-beyond-count", Warning, Pdo(check);
    summary: "a PDO mapping has entries that its sub-index 0 does not count",
    checks: "Whether the entries of a PDO mapping after the ones that sub-index 0 counts are 0 or empty. A mapping that counts 0 is switched off and may keep its entries.",
    why: "The objects look mapped and are not; often sub-index 0 was forgotten when an entry was added.",
    example: "`[1A00sub0]` with `DefaultValue=1`, and `[1A00sub2]` with `DefaultValue=0x60000208`",
    remedy: "Count the entry in sub-index 0, or write 0 into it.",
    source: "CiA 301 §7.5.2.36 table 69",
}

fn check(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let Some(count) = pdo.pdo.mapped_count.filter(|count| (1..=64).contains(count)) else { return };
    let index = pdo.pdo.mapping_index();
    let beyond = pdo.pdo.slots.iter().filter(|slot| slot.sub > count);
    let mut beyond = beyond.filter(|slot| slot.object.is_some_and(|object| !object.is_unused()));
    let Some(first) = beyond.next() else { return };
    let message = say!(
        "sub-index {} of {:04X}h names an object, and {} maps only `{}`",
        first.sub,
        index,
        pdo.pdo,
        count
    );
    let finding = Diagnostic::new(&RULE.info, facts.device.value_place(index, first.sub), message);
    let finding = finding.label(facts.device.value_place(index, 0), "the number of mapped objects");
    findings.push(finding.help("count it in sub-index 0, or write 0 here"));
}
