use crate::diagnostic::{Diagnostic, Findings};
use crate::model::{Device, Part, Place};
use crate::{rule, with_others};

rule! {
    "portability/compact-values", Warning, Device(check);
    summary: "a tool ignores the values of a compact object",
    checks: "Whether an object with `CompactSubObj` has a section `[xxxxValue]`. The first one is shown with the others.",
    why: "python-canopen and CANopenEditor do not read the section: they use the default instead of the configured values.",
    example: "`[2000Value]`",
    remedy: "Describe the sub-indexes individually, each with its `ParameterValue`.",
    source: "python-canopen 2.4.1, CANopenEditor of 2026",
}

fn check(device: &Device, findings: &mut Findings) {
    let mut places = device.objects.iter().filter_map(|(&index, object)| {
        let is_meant = object.compact.as_ref().is_some_and(|compact| !compact.values.is_empty());
        is_meant.then(|| Place::of(Part::CompactValues(index)))
    });
    let Some(first) = places.next() else { return };
    let finding = Diagnostic::new(&RULE.info, first, "not all tools read the values of a compact object")
        .help("describe the sub-indexes individually");
    findings.push(with_others(finding, places.map(|place| (place, "the same here"))));
}
