use crate::diagnostic::{Diagnostic, Findings};
use crate::model::{Access, DataType, Device, Entry, Field};
use crate::{rule, stated, with_others};

rule! {
    "portability/long-value", Note, Device(check);
    summary: "a configured value has more than four bytes",
    checks: "Whether a writable entry with a default or configured value has a type of more than four bytes or of variable length. The first one is shown with the others.",
    why: "CODESYS configures entries of up to four bytes by SDO; the application must write longer ones.",
    example: "A writable UNSIGNED64 with a default",
    remedy: "Write the entry from the application, or split it into entries of four bytes.",
    source: "Manual of CODESYS, tab `SDOs` of a CANopen remote device",
}

fn check(device: &Device, findings: &mut Findings) {
    let mut places = stated::entries(device).filter(|(_, entry)| is_long(entry)).map(|(place, entry)| {
        let field =
            if entry.configured_value().is_some() { Field::ParameterValue } else { Field::DefaultValue };
        place.field(field)
    });
    let Some(first) = places.next() else { return };
    let finding = Diagnostic::new(&RULE.info, first, "the value has more than four bytes")
        .help("write the entry from the application");
    findings.push(with_others(finding, places.map(|place| (place, "another one"))));
}

fn is_long(entry: &Entry) -> bool {
    let is_short = entry.data_type.and_then(DataType::byte_length).is_some_and(|bytes| bytes <= 4);
    entry.value().is_some() && entry.access.is_some_and(Access::is_writable) && !is_short
}
