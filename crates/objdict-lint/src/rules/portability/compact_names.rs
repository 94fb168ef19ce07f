use crate::diagnostic::{Diagnostic, Findings};
use crate::model::{Compact, Device, Part, Place};
use crate::{rule, with_others};

rule! {
    "portability/compact-names", Warning, Device(check);
    summary: "names of a compact object are lost to a tool",
    checks: "Whether an object with `CompactSubObj` has a section `[xxxxName]` without a gap. The first one is shown, others are named.",
    why: "CANopenEditor does not read the section: its sub-indexes have the name of the object with a number in hex behind it.",
    example: "`[2000Name]`",
    remedy: "Describe the sub-indexes one by one where their names matter.",
    source: "CANopenEditor of 2026",
}

fn check(device: &Device, findings: &mut Findings) {
    let mut places = device.objects.iter().filter_map(|(&index, object)| {
        let is_meant =
            object.compact.as_ref().is_some_and(|compact| !compact.names.is_empty() && !has_gap(compact));
        is_meant.then(|| Place::of(Part::CompactNames(index)))
    });
    let Some(first) = places.next() else { return };
    let finding =
        Diagnostic::new(&RULE.info, first, "the names of these sub-indexes are not known to all tools")
            .help("describe the sub-indexes one by one");
    findings.push(with_others(finding, places.map(|place| (place, "the same here"))));
}

/// Whether not all names from 1 to as many as there are stand there, of which another rule speaks.
fn has_gap(compact: &Compact) -> bool {
    (1..=compact.names.len()).any(|sub| compact.names.iter().all(|(named, _)| usize::from(*named) != sub))
}
