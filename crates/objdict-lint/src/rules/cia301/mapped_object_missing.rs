use crate::diagnostic::{Diagnostic, Findings, Severity, say};
use crate::model::Place;
use crate::{Facts, PdoFacts, Target, rule};

rule! {
    "cia301/mapped-object-missing", Error, Pdo(check);
    summary: "a PDO maps an object that does not exist",
    checks: "Whether each mapping entry in use refers to a described object and sub-index. Objects that a module or a dynamic channel may provide count as existing; on a modular device any other missing object is a note.",
    why: "The device rejects the mapping with an abort, and the PDO does not work. Tools cannot resolve the contents of the frame.",
    example: "`[1A00sub1]` with `DefaultValue=0x60000108`, without `[6000]`",
    remedy: "Describe the object, or map another one. The eight digits are index, sub-index and length.",
    source: "CiA 301 §7.5.2.36, §7.5.2.38; CiA 306-1 §6.2.2",
}

fn check(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    for mapped in pdo.mapped.iter().filter(|mapped| mapped.target.is_missing()) {
        let (object, index) = (mapped.object, pdo.pdo.mapping_index());
        let place = facts.device.value_place(index, mapped.slot);
        let finding = match mapped.target {
            Target::NoEntry => {
                let message = say!(
                    "{} maps {:04X}h:{:02X}, but the object has no such sub-index",
                    pdo.pdo,
                    object.index,
                    object.sub
                );
                let finding = Diagnostic::new(&RULE.info, place, message);
                let finding = finding.label(Place::object(object.index), "the object");
                finding.help("describe the sub-index, or map another one")
            }
            _ => {
                let message = say!(
                    "{} maps {:04X}h:{:02X}, but there is no such object",
                    pdo.pdo,
                    object.index,
                    object.sub
                );
                Diagnostic::new(&RULE.info, place, message).help("describe the object, or map another one")
            }
        };
        findings.push(if facts.device.is_modular() { finding.severity(Severity::Note) } else { finding });
    }
}
