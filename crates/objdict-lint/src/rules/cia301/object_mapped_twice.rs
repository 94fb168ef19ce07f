use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{Facts, PdoFacts, Target, rule};

rule! {
    "cia301/object-mapped-twice", Warning, Pdo(check);
    summary: "a PDO maps the same object twice",
    checks: "Whether each object stands once in the mapping of a PDO. Fillers may stand there as often as needed. The same object in two PDOs is usual, in CiA 402 for one, and is not looked at.",
    why: "Mostly a copied line was not changed: an object is sent twice, or written twice, and another one is left out.",
    example: "`[1A00sub1]` and `[1A00sub2]`, both with `DefaultValue=0x60000108`",
    remedy: "Map the object that was meant.",
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
                findings.push(
                    finding.label(place(first), "the first time").help("map the object that was meant"),
                );
            }
            None => {
                seen.insert((object.index, object.sub), mapped.slot);
            }
        }
    }
}
