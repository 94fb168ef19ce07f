use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{Facts, PdoFacts, rule};

rule! {
    "cia301/mapping-of-variable-length", Error, Pdo(check);
    summary: "a PDO maps an object without a fixed length",
    checks: "Whether the data type of each mapped object has a fixed length. An OCTET_STRING of 1 to 8 bytes and a text whose value has the mapped length can be mapped.",
    why: "The position of each object in the frame depends on the lengths of the objects before it. The device rejects the mapping, and tools reserve a wrong number of bytes.",
    example: "`[1600sub1]` with `DefaultValue=0x20000040`, and `DataType=0x0009` (VISIBLE_STRING) in `[2000]`",
    remedy: "Map another object, or describe the object with a type of fixed length.",
    source: "CiA 301 §7.4.7, §7.5.2.36",
}

fn check(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    for mapped in &pdo.mapped {
        let Some(data_type) = mapped.variable_type() else { continue };
        let message = say!("{} maps {}, a {} without a fixed length", pdo.pdo, mapped.object, data_type);
        let device = facts.device;
        let place = device.value_place(pdo.pdo.mapping_index(), mapped.slot);
        findings.push(Diagnostic::new(&RULE.info, place, message).help("map another object"));
    }
}
