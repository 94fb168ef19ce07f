use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Access, Field, Place};
use crate::{Facts, PdoFacts, is_unstated, rule};

rule! {
    "cia301/mapping-without-count", Warning, Pdo(check);
    summary: "the number of mapped objects of a PDO is not stated",
    checks: "Whether sub-index 0 of each read-only PDO mapping has a value.",
    why: "Tools take the contents of such a PDO from the description. Without the number of objects they cannot show it.",
    example: "`[1A00sub0]` with `AccessType=const` and no `DefaultValue`",
    remedy: "Write the number of mapped objects.",
    source: "CiA 301 §7.5.2.36, §7.5.2.38",
}

fn check(_: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let pdo = &pdo.pdo;
    let Some(object) = pdo.mapping.filter(|object| !object.orphan && is_unstated(object, 0)) else { return };
    let Some(entry) =
        object.subs.get(0).filter(|entry| entry.access.is_some_and(|access| !Access::is_writable(access)))
    else {
        return;
    };
    if entry.data_type.is_none() {
        return;
    }
    let place = Place::entry(pdo.mapping_index(), 0).field(Field::DefaultValue);
    let message = say!("the mapping of {} is fixed, but its number of objects is not stated", pdo);
    let finding = Diagnostic::new(&RULE.info, place, message);
    findings.push(finding.help("write the number of mapped objects"));
}
