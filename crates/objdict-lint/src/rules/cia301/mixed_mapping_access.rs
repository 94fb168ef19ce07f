use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Access, Field, Object, Place};
use crate::{Facts, PdoFacts, rule};

rule! {
    "cia301/mixed-mapping-access", Warning, Pdo(check);
    summary: "a PDO mapping is only partly writable",
    checks: "Whether sub-index 0 and the entries of a PDO mapping are all writable or all read-only.",
    why: "To change an entry, a tool first writes 0 to sub-index 0 and finally the new number. If sub-index 0 is constant, the entries cannot be changed in spite of their access type; if the entries are constant, the number has no use.",
    example: "`[1A00sub0]` with `AccessType=ro`, and `[1A00sub1]` with `AccessType=rw`",
    remedy: "Use the access of the device for all sub-indexes: `rw` for a changeable mapping, otherwise `const` or `ro`.",
    source: "CiA 301 §7.5.2.36",
}

fn check(_: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let Some(object) = pdo.pdo.mapping.filter(|object| object.compact.is_none()) else { return };
    let index = pdo.pdo.mapping_index();
    let Some(count) = writable(object, 0) else { return };
    let mut entries = (1..=64).filter_map(|sub| Some((sub, writable(object, sub)?)));
    let Some((sub, _)) = entries.find(|&(_, entry)| entry != count) else { return };
    let message = if count {
        say!("sub-index {} of {:04X}h is read-only, but the number of mapped objects is writable", sub, index)
    } else {
        say!("sub-index {} of {:04X}h is writable, but the number of mapped objects is read-only", sub, index)
    };
    let finding = Diagnostic::new(&RULE.info, Place::entry(index, sub).field(Field::AccessType), message);
    let finding =
        finding.label(Place::entry(index, 0).field(Field::AccessType), "the number of mapped objects");
    findings.push(finding.help("make all sub-indexes `rw`, or all of them `const`"));
}

fn writable(object: &Object, sub: u8) -> Option<bool> {
    object.subs.get(sub)?.access.map(Access::is_writable)
}
