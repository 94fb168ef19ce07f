use crate::diagnostic::{Diagnostic, Findings};
use crate::model::{Access, DataType, Device, Entry, Field};
use crate::{rule, stated, with_others};

rule! {
    "portability/long-value", Note, Device(check);
    summary: "a value to be configured is longer than four bytes",
    checks: "Whether an entry that can be written has a default or configured value and a type of more than four bytes, or of any length. The first one is shown, others are named.",
    why: "CODESYS lists entries of up to four bytes for the configuration of a node by SDO; longer ones must be written by the application.",
    example: "A writable UNSIGNED64 with a default",
    remedy: "Let the application write the entry, or split it into entries of four bytes.",
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
        .help("let the application write it");
    findings.push(with_others(finding, places.map(|place| (place, "another one"))));
}

fn is_long(entry: &Entry) -> bool {
    let is_short = entry.data_type.and_then(DataType::byte_length).is_some_and(|bytes| bytes <= 4);
    entry.value().is_some() && entry.access.is_some_and(Access::is_writable) && !is_short
}
