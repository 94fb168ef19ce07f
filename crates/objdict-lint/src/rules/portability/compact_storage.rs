use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Compact, Device, Part, Place};
use crate::{rule, with_others};

rule! {
    "portability/compact-storage", Warning, Device(check);
    summary: "`CompactSubObj` is not understood by a tool",
    checks: "Whether an object has `CompactSubObj`, without a section of names, values or denotations: other rules speak of those. The first one is shown, others are named.",
    why: "CANopenEditor makes the sub-indexes, but loses their default and mapping, and gives them the low limit as the high one. python-canopen makes those of an ARRAY when they are asked for, without a value in sub-index 0, and none of a RECORD.",
    example: "`CompactSubObj=8`",
    remedy: "Describe the sub-indexes one by one.",
    source: "python-canopen 2.4.1, CANopenEditor of 2026",
}

fn check(device: &Device, findings: &mut Findings) {
    let mut places = device.objects.iter().filter_map(|(&index, object)| {
        let is_meant = object.compact.as_ref().is_some_and(|compact| is_plain(compact))
            && object.main.configured_value().is_none();
        is_meant.then(|| Place::of(Part::Object(index)))
    });
    let Some(first) = places.next() else { return };
    let finding = Diagnostic::new(
        &RULE.info,
        first,
        say!("`{CompactSubObj}` is not understood as the standard has it by all tools"),
    )
    .help("describe the sub-indexes one by one");
    findings.push(with_others(finding, places.map(|place| (place, "the same here"))));
}

/// Without sections of its own.
fn is_plain(compact: &Compact) -> bool {
    compact.names.is_empty() && compact.values.is_empty() && compact.denotations.is_empty()
}
