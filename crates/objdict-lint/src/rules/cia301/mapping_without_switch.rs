use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Access, Field, Object, Place};
use crate::{Facts, PdoFacts, rule};

rule! {
    "cia301/mapping-without-switch", Note, Pdo(check);
    summary: "a PDO mapping can be changed, but the PDO cannot be switched off",
    checks: "Whether the COB-ID of each PDO whose mapping can be written can be written too.",
    why: "A mapping may be changed only while bit 31 of the COB-ID is set. Where nobody can set it, devices refuse to change the mapping, or tools do not try.",
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
        say!("the COB-ID of {} is `{}`, so nobody can switch it off to change its mapping", pdo, fixed);
    let finding = Diagnostic::new(&RULE.info, at(pdo.communication_index(), 1), message)
        .label(at(pdo.mapping_index(), 0), "the mapping can be written");
    findings.push(finding.help("make the COB-ID `rw`, or the mapping `const`"));
}
