use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Access, Field, Object, Place};
use crate::{Facts, PdoFacts, rule};

rule! {
    "cia301/mixed-mapping-access", Warning, Pdo(check);
    summary: "a PDO mapping can be changed in part only",
    checks: "Whether sub-index 0 and the entries of a PDO mapping can all be written, or none of them.",
    why: "To change an entry, sub-index 0 has to be set to 0 first and to the new number last. With a constant sub-index 0 the entries cannot be changed, whatever their access type says; with constant entries there is nothing to count.",
    example: "`[1A00sub0]` with `AccessType=ro`, and `[1A00sub1]` with `AccessType=rw`",
    remedy: "Give all sub-indexes the access that the device has: `rw` for a mapping that can be changed, else `const` or `ro`.",
    source: "CiA 301 §7.5.2.36",
}

fn check(_: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let Some(object) = pdo.pdo.mapping.filter(|object| object.compact.is_none()) else { return };
    let index = pdo.pdo.mapping_index();
    let Some(count) = writable(object, 0) else { return };
    let mut entries = (1..=64).filter_map(|sub| Some((sub, writable(object, sub)?)));
    let Some((sub, _)) = entries.find(|&(_, entry)| entry != count) else { return };
    let message = if count {
        say!("sub-index {} of {:04X}h cannot be written, though the number of mapped objects can", sub, index)
    } else {
        say!("sub-index {} of {:04X}h can be written, though the number of mapped objects cannot", sub, index)
    };
    let finding = Diagnostic::new(&RULE.info, Place::entry(index, sub).field(Field::AccessType), message);
    let finding =
        finding.label(Place::entry(index, 0).field(Field::AccessType), "the number of mapped objects");
    findings.push(finding.help("make all of them `rw`, or all of them `const`"));
}

fn writable(object: &Object, sub: u8) -> Option<bool> {
    object.subs.get(sub)?.access.map(Access::is_writable)
}
