use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::model::{Access, Field};
use crate::{EntryAt, rule, stated};

rule! {
    "cia306/access-without-mapping", Warning, Entry(check), fix Unsafe;
    summary: "the access type names a PDO direction, but the entry is not mappable",
    checks: "Whether entries with access `rwr` or `rww` have `PDOMapping=1`.",
    why: "`rwr` and `rww` are `rw` with the PDO direction that the entry can be mapped to. One of the two keys is wrong, and tools may not offer the entry for mapping.",
    example: "`AccessType=rww` and `PDOMapping=0`",
    remedy: "Write `PDOMapping=1`, or `AccessType=rw`.",
    source: "CiA 306-1 §4.6.3.2",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    let entry = at.entry;
    let Some(access @ (Access::Rwr | Access::Rww)) = entry.access else { return };
    if entry.is_mappable() || !at.holds_value() || stated::is_invalid(entry, &Field::PdoMapping) {
        return;
    }
    let pdo = if access == Access::Rwr { "a TPDO" } else { "an RPDO" };
    let message = say!("`{}` allows mapping to {}, but the entry is not mappable", access, pdo);
    let finding = Diagnostic::new(&RULE.info, at.field(Field::AccessType), message)
        .label(at.field(Field::PdoMapping), "not mappable");
    let fix = Fix::risky(say!("write `{AccessType=rw}`")).set(at.field(Field::AccessType), "rw");
    findings.push(finding.help(say!("write `{PDOMapping=1}`, or `{AccessType=rw}`")).fix(fix));
}
