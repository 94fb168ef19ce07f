use crate::diagnostic::{Diagnostic, Findings, Fix, Severity, say};
use crate::model::{DataType, Field, MappedObject, Place};
use crate::{Facts, PdoFacts, Target, rule};

rule! {
    // canopen-stack takes the length of the object, so that what follows is at another place of the frame
    "cia301/wrong-mapping-length", Error, Pdo(check), fix Unsafe, stops "canopen-stack";
    summary: "the length in a PDO mapping differs from the length of the object",
    checks: "Whether the last two digits of each mapping entry, the length in bits, match the data type of the object. Objects of variable length are not checked. A BOOLEAN with 8 bits is a warning: devices that map only whole bytes do this, such as those with CANopenNode.",
    why: "The device rejects the mapping with an abort; a receiver reads the following objects from the wrong position of the frame.",
    example: "`[1A00sub1]` with `DefaultValue=0x60000110`, where `[6000sub1]` is UNSIGNED8",
    remedy: "Write the length of the data type in hexadecimal: 08, 10, 20, 40 for 8, 16, 32 and 64 bits.",
    source: "CiA 301 §7.5.2.36",
}

fn check(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    for mapped in &pdo.mapped {
        let (Some(bits), Target::Entry(entry)) = (mapped.wrong_length(), &mapped.target) else { continue };
        let MappedObject { index, sub, bits: stated } = mapped.object;
        let data_type = entry.data_type.map(|data_type| data_type.to_string()).unwrap_or_default();
        let unit = if stated == 1 { "bit" } else { "bits" };
        let message = say!(
            "{} maps {} {} of {:04X}h:{:02X}, whose length is {} ({})",
            pdo.pdo,
            stated,
            unit,
            index,
            sub,
            bits,
            data_type
        );
        let place = facts.device.value_place(pdo.pdo.mapping_index(), mapped.slot);
        let is_single = facts.device.object(index).is_some_and(|object| object.subs.get(sub).is_none());
        let target = if is_single { Place::object(index) } else { Place::entry(index, sub) };
        let finding = Diagnostic::new(&RULE.info, place.clone(), message);
        let finding = finding.label(target.field(Field::DataType), "the data type");
        let right = MappedObject { bits, ..mapped.object };
        let right = format!("0x{:08X}", right.to_number());
        let title = say!("write `{}`", right);
        let finding = finding.help(title.clone()).fix(Fix::risky(title).set(place, right));
        let whole_byte = entry.data_type == Some(DataType::BOOLEAN) && stated == 8;
        findings.push(if whole_byte { finding.severity(Severity::Warning) } else { finding });
    }
}
