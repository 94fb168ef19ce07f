use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Part, Place};
use crate::{rule, with_others};

rule! {
    "portability/compact-denotations", Error, Device(check);
    summary: "a tool does not know the denotations of a compact object",
    checks: "Whether an object with `CompactSubObj` has a section `[xxxxDenotation]`. The first one is shown with the others.",
    why: "dcf-tools knows `[xxxxName]` and `[xxxxValue]`, but not this section, and refuses the file.",
    example: "`[2000Denotation]`",
    remedy: "Use `[xxxxName]`, or describe the sub-indexes individually.",
    source: "dcf-tools 2.4.2, python-canopen 2.4.1, CANopenEditor of 2026",
}

fn check(device: &Device, findings: &mut Findings) {
    let mut places = device.objects.iter().filter_map(|(&index, object)| {
        let is_meant = object.compact.as_ref().is_some_and(|compact| !compact.denotations.is_empty());
        is_meant.then(|| Place::of(Part::CompactDenotations(index)))
    });
    let Some(first) = places.next() else { return };
    let finding =
        Diagnostic::new(&RULE.info, first, "not all tools read the denotations of a compact object")
            .help(say!("use `{[xxxxName]}`, or describe the sub-indexes individually"));
    findings.push(with_others(finding, places.map(|place| (place, "the same here"))));
}
