use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Part, Place};
use crate::{rule, with_others};

rule! {
    "portability/compact-parameter-value", Error, Device(check);
    summary: "a compact object has one configured value for all sub-indexes",
    checks: "Whether an object with `CompactSubObj` has a `ParameterValue`, but no section `[xxxxValue]`. The first one is shown with the others.",
    why: "dcf-tools does not read the value of the key correctly and crashes.",
    example: "`CompactSubObj=8` and `ParameterValue=1`",
    remedy: "Write the value of each sub-index in `[xxxxValue]`.",
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
        say!("`{ParameterValue}` of a compact object configures all sub-indexes"),
    )
    .help(say!("write the values in `{[xxxxValue]}`"));
    findings.push(with_others(finding, places.map(|place| (place, "the same here"))));
}
