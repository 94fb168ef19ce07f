use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Part, Place};
use crate::{rule, with_others};

rule! {
    "portability/object-links", Warning, Device(check);
    summary: "object links are unknown to a tool",
    checks: "Whether an object has a section `[xxxxObjectLinks]`. The first one is shown, others are named.",
    why: "dcf-tools refuses a file with a section that it does not know; python-canopen and CANopenEditor write files without it.",
    example: "`[2000ObjectLinks]`",
    remedy: "Give the tool a copy without the section: it only says what belongs together.",
    source: "dcf-tools 2.4.2, python-canopen 2.4.1, CANopenEditor of 2026",
}

fn check(device: &Device, findings: &mut Findings) {
    let mut places = device.objects.iter().filter_map(|(&index, object)| {
        let is_meant = !object.links.is_empty();
        is_meant.then(|| Place::of(Part::Links(index)))
    });
    let Some(first) = places.next() else { return };
    let finding = Diagnostic::new(&RULE.info, first, "object links are unknown to some tools")
        .help(say!("give the tool a copy without the {section}"));
    findings.push(with_others(finding, places.map(|place| (place, "the same here"))));
}
