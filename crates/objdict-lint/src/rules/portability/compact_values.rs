use crate::diagnostic::{Diagnostic, Findings};
use crate::model::{Device, Part, Place};
use crate::{rule, with_others};

rule! {
    "portability/compact-values", Warning, Device(check);
    summary: "values of a compact object are lost to a tool",
    checks: "Whether an object with `CompactSubObj` has a section `[xxxxValue]`. The first one is shown, others are named.",
    why: "python-canopen and CANopenEditor do not read the section: they know the default and nothing of what is configured.",
    example: "`[2000Value]`",
    remedy: "Describe the sub-indexes one by one, each with its `ParameterValue`.",
    source: "python-canopen 2.4.1, CANopenEditor of 2026",
}

fn check(device: &Device, findings: &mut Findings) {
    let mut places = device.objects.iter().filter_map(|(&index, object)| {
        let is_meant = object.compact.as_ref().is_some_and(|compact| !compact.values.is_empty());
        is_meant.then(|| Place::of(Part::CompactValues(index)))
    });
    let Some(first) = places.next() else { return };
    let finding =
        Diagnostic::new(&RULE.info, first, "the values of these sub-indexes are not known to all tools")
            .help("describe the sub-indexes one by one");
    findings.push(with_others(finding, places.map(|place| (place, "the same here"))));
}
