use crate::diagnostic::{Diagnostic, Findings, joined, say};
use crate::model::{Device, Meaning};
use crate::rule;

rule! {
    "cia311/value-without-name", Warning, Device(check);
    summary: "a value is not in its enumeration",
    checks: "Whether the default and the actual value of an entry whose type is an `enum`, or a struct with members of such a type, have a name in it. An enumeration with an invalid value is not compared.",
    why: "Tools that offer the names cannot show the value, and replace it by another one when they write the device.",
    example: r#"`<defaultValue value="9"/>` of a parameter whose `enum` has the values 0 to 2"#,
    remedy: "Add the value to the enumeration, or correct it.",
    source: "CiA 311 §6.4, annex A",
}

fn check(device: &Device, findings: &mut Findings) {
    if device.application.is_empty() {
        return;
    }
    let meanings = device.meanings();
    for (&index, object) in &device.objects {
        for (sub, _) in object.entries() {
            let value = object.value(sub).and_then(|value| value.as_integer());
            let (Some(value), Some(Meaning::Enumeration(named))) = (value, meanings.of(index, sub)) else {
                continue;
            };
            // another rule compares single allowed values
            let Some(definition) = named.definition.filter(|_| named.defects.is_empty()) else { continue };
            if named.values.iter().any(|name| name.number == value) {
                continue;
            }
            let numbers = named.values.iter().take(8).map(|name| say!("`{}`", name.number));
            let message = say!("`{}` is not a value of the enumeration `{}`", value, &*definition.name);
            let finding = Diagnostic::new(&RULE.info, device.value_place(index, sub), message);
            findings.push(finding.help(say!("write one of {}, or add the value", joined(numbers, ", "))));
        }
    }
}
