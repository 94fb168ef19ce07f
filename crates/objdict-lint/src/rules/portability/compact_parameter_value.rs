use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Part, Place};
use crate::{rule, with_others};

rule! {
    "portability/compact-parameter-value", Warning, Device(check);
    summary: "a compact object has one configured value for all",
    checks: "Whether an object with `CompactSubObj` has a `ParameterValue`, and no section `[xxxxValue]`. The first one is shown, others are named.",
    why: "dcf-tools takes the presence of the key for its value, and crashes.",
    example: "`CompactSubObj=8` and `ParameterValue=1`",
    remedy: "Write the value of each sub-index into `[xxxxValue]`.",
    source: "dcf-tools 2.4.2",
}

fn check(device: &Device, findings: &mut Findings) {
    let mut places = device.objects.iter().filter_map(|(&index, object)| {
        let is_meant = object.compact.as_ref().is_some_and(|compact| compact.values.is_empty())
            && object.main.configured_value().is_some();
        is_meant.then(|| Place::of(Part::Object(index)))
    });
    let Some(first) = places.next() else { return };
    let finding = Diagnostic::new(
        &RULE.info,
        first,
        say!("`{ParameterValue}` of a compact object configures all its sub-indexes"),
    )
    .help(say!("write the values into `{[xxxxValue]}`"));
    findings.push(with_others(finding, places.map(|place| (place, "the same here"))));
}
