use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::model::{Field, Place};
use crate::{Facts, PdoFacts, Target, rule};

rule! {
    "cia301/mapped-object-not-mappable", Error, Pdo(check), fix Unsafe;
    summary: "a PDO maps an object that is not mappable",
    checks: "Whether each mapped entry has `PDOMapping` set.",
    why: "Either the object is mappable and no tool offers it, or it is not and the default mapping is wrong.",
    example: "`[1A00sub1]` with `DefaultValue=0x60000108`, and `[6000sub1]` with `PDOMapping=0`",
    remedy: "Write `PDOMapping=1` at the object, or map another one.",
    source: "CiA 301 §7.5.2.36; CiA 306-1 §4.6.3.2",
}

fn check(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    for mapped in &pdo.mapped {
        let Target::Entry(entry) = &mapped.target else { continue };
        // another rule reports a type without a fixed length
        let is_variable = mapped.variable_type().is_some();
        if entry.is_mappable() || is_variable || entry.invalid_values.get(&Field::PdoMapping).is_some() {
            continue;
        }
        let (index, sub) = (mapped.object.index, mapped.object.sub);
        let message = say!("{} maps {:04X}h:{:02X}, which is not mappable", pdo.pdo, index, sub);
        let place = facts.device.value_place(pdo.pdo.mapping_index(), mapped.slot);
        let finding = Diagnostic::new(&RULE.info, place, message);
        let is_single = facts.device.object(index).is_some_and(|object| object.subs.get(sub).is_none());
        let target = if is_single { Place::object(index) } else { Place::entry(index, sub) };
        let fix = Fix::risky(say!("write `{PDOMapping=1}` for the object"))
            .set(target.clone().field(Field::PdoMapping), "1");
        let finding = finding.label(target.field(Field::PdoMapping), "not mappable").fix(fix);
        findings.push(finding.help(say!("write `{PDOMapping=1}` for the object, or map another object")));
    }
}
