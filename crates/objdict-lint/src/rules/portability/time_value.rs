use crate::diagnostic::{Diagnostic, Findings};
use crate::model::{Device, Entry, Field, Value};
use crate::{rule, stated, with_others};

rule! {
    "portability/time-value", Warning, Device(check);
    summary: "a time of day or a duration has a value",
    checks: "Whether an entry of type TIME_OF_DAY or TIME_DIFFERENCE has a default or configured value. The first one is shown with the others.",
    why: "python-canopen does not know these types and reads an integer: the space between days and milliseconds is removed, and `1 2` becomes 12.",
    example: "`DefaultValue=1 0x36EE80` of a TIME_OF_DAY",
    remedy: "Remove the value if 0 is acceptable.",
    source: "python-canopen 2.4.1",
}

fn check(device: &Device, findings: &mut Findings) {
    let mut places = stated::entries(device).filter_map(|(place, entry)| Some(place.field(field_of(entry)?)));
    let Some(first) = places.next() else { return };
    let finding = Diagnostic::new(&RULE.info, first, "not all tools read times")
        .help("remove the value if 0 is acceptable");
    findings.push(with_others(finding, places.map(|place| (place, "another one"))));
}

fn field_of(entry: &Entry) -> Option<Field> {
    match (entry.configured_value(), &entry.default) {
        (Some(Value::Time(_)), _) => Some(Field::ParameterValue),
        (_, Some(Value::Time(_))) => Some(Field::DefaultValue),
        _ => None,
    }
}
