use crate::diagnostic::{Diagnostic, Findings};
use crate::model::{Compact, Device, Part, Place};
use crate::{rule, with_others};

rule! {
    "portability/compact-names", Warning, Device(check);
    summary: "a tool ignores the names of a compact object",
    checks: "Whether an object with `CompactSubObj` has a section `[xxxxName]` without a gap. The first one is shown with the others.",
    why: "CANopenEditor does not read the section and names the sub-indexes after the object, with a hex number appended.",
    example: "`[2000Name]`",
    remedy: "Describe the sub-indexes individually if their names matter.",
    source: "CANopenEditor of 2026",
}

fn check(device: &Device, findings: &mut Findings) {
    let mut places = device.objects.iter().filter_map(|(&index, object)| {
        let is_meant =
            object.compact.as_ref().is_some_and(|compact| !compact.names.is_empty() && !has_gap(compact));
        is_meant.then(|| Place::of(Part::CompactNames(index)))
    });
    let Some(first) = places.next() else { return };
    let finding = Diagnostic::new(&RULE.info, first, "not all tools read the names of a compact object")
        .help("describe the sub-indexes individually");
    findings.push(with_others(finding, places.map(|place| (place, "the same here"))));
}

/// Whether a name between 1 and the number of names is missing, which another rule reports.
fn has_gap(compact: &Compact) -> bool {
    (1..=compact.names.len()).any(|sub| compact.names.iter().all(|(named, _)| usize::from(*named) != sub))
}
