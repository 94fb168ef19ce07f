use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Access, Field, Object, Place};
use crate::{Facts, PdoFacts, rule};

rule! {
    "cia301/mapping-without-valid-bit", Note, Pdo(check);
    summary: "a PDO mapping is writable, but its COB-ID is not",
    checks: "Whether the COB-ID of each PDO with a writable mapping is writable too.",
    why: "A mapping may only be changed while the PDO is not valid (bit 31 of the COB-ID set). If the bit cannot be written, devices reject a change of the mapping, or tools do not attempt it.",
    example: "`[1800sub1]` with `AccessType=const` and `[1A00sub0]` with `AccessType=rw`",
    remedy: "Make the COB-ID `rw`, or the mapping `const`.",
    source: "CiA 301 §7.5.2.36, §7.5.2.38",
}

fn check(_: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let pdo = &pdo.pdo;
    let access = |object: Option<&Object>, sub| object?.subs.get(sub)?.access;
    let writable = |sub| access(pdo.mapping, sub).is_some_and(Access::is_writable);
    let fixed = access(pdo.communication, 1).filter(|access| !access.is_writable());
    let Some(fixed) = fixed.filter(|_| writable(0) && writable(1)) else { return };
    let at = |index, sub| Place::entry(index, sub).field(Field::AccessType);
    let message =
        say!("the COB-ID of {} is `{}`, so it cannot be disabled to change its mapping", pdo, fixed);
    let finding = Diagnostic::new(&RULE.info, at(pdo.communication_index(), 1), message)
        .label(at(pdo.mapping_index(), 0), "the mapping is writable");
    findings.push(finding.help("make the COB-ID `rw`, or the mapping `const`"));
}
