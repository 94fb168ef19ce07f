use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Compact, Device, Part, Place};
use crate::{rule, with_others};

rule! {
    "portability/compact-storage", Warning, Device(check);
    summary: "a tool does not support `CompactSubObj` correctly",
    checks: "Whether an object has `CompactSubObj` without a section of names, values or denotations, which have their own rules. The first one is shown with the others.",
    why: "CANopenEditor creates the sub-indexes, but drops their default and mapping and uses the low limit as the high limit. python-canopen creates the sub-indexes of an ARRAY on access, without a value in sub-index 0, and none for a RECORD.",
    example: "`CompactSubObj=8`",
    remedy: "Describe the sub-indexes individually.",
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
        say!("not all tools support `{CompactSubObj}` as the standard defines it"),
    )
    .help("describe the sub-indexes individually");
    findings.push(with_others(finding, places.map(|place| (place, "the same here"))));
}

/// Whether the object has no sections for its sub-indexes.
fn is_plain(compact: &Compact) -> bool {
    compact.names.is_empty() && compact.values.is_empty() && compact.denotations.is_empty()
}
