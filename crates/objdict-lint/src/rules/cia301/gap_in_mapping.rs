use crate::diagnostic::{Diagnostic, Findings, say, sub_index};
use crate::model::{Part, Place};
use crate::{Facts, PdoFacts, rule};

rule! {
    "cia301/gap-in-mapping", Note, Pdo(check);
    summary: "the sub-indexes of a PDO mapping have a gap",
    checks: "Whether the described sub-indexes of each PDO mapping beyond those in use are consecutive. A gap among those in use has its own rule.",
    why: "Objects are mapped in consecutive sub-indexes, so the sub-indexes after a gap cannot be used.",
    example: "`[1A00sub1]` and `[1A00sub3]` without `[1A00sub2]`",
    remedy: "Describe the missing sub-index, or remove those after the gap.",
    source: "CiA 301 §7.5.2.36, table 69",
}

fn check(_: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let pdo = &pdo.pdo;
    let mut expected = 1..=64u8;
    let Some(slot) = pdo.slots.iter().find(|slot| expected.next() != Some(slot.sub)) else { return };
    let missing = pdo.slots.iter().take_while(|other| other.sub < slot.sub).count();
    let missing = u8::try_from(missing + 1).unwrap_or(u8::MAX);
    let counts = pdo.mapped_count.is_some_and(|count| (missing..=64).contains(&count));
    if counts || pdo.is_multiplexed() {
        return;
    }
    let index = pdo.mapping_index();
    let message =
        say!("{:04X}h has sub-index {} but no sub-index {}", index, sub_index(slot.sub), sub_index(missing));
    let finding = Diagnostic::new(&RULE.info, Place::entry(index, slot.sub), message);
    findings.push(
        finding.help(say!("add `{}`, or remove the sub-indexes after it", Part::Entry(index, missing))),
    );
}
