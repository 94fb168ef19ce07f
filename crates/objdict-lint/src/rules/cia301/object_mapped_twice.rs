use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{Facts, PdoFacts, Target, rule};

rule! {
    "cia301/object-mapped-twice", Warning, Pdo(check);
    summary: "a PDO maps the same object twice",
    checks: "Whether the mapping of a PDO contains each object only once. Dummy entries may be repeated. The same object in two PDOs is common, for example in CiA 402, and is not checked.",
    why: "Often a copied line was not changed: one object is transferred twice, and another one is missing.",
    example: "`[1A00sub1]` and `[1A00sub2]`, both with `DefaultValue=0x60000108`",
    remedy: "Map the intended object.",
    source: "CiA 301 §7.5.2.36",
}

fn check(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let mut seen = BTreeMap::new();
    for mapped in pdo.mapped.iter().filter(|mapped| !matches!(mapped.target, Target::Dummy)) {
        let object = mapped.object;
        let place = |slot| facts.device.value_place(pdo.pdo.mapping_index(), slot);
        match seen.get(&(object.index, object.sub)) {
            Some(&first) => {
                let message = say!("{} maps {:04X}h:{:02X} twice", pdo.pdo, object.index, object.sub);
                let finding = Diagnostic::new(&RULE.info, place(mapped.slot), message);
                findings
                    .push(finding.label(place(first), "first mapped here").help("map the intended object"));
            }
            None => {
                seen.insert((object.index, object.sub), mapped.slot);
            }
        }
    }
}
