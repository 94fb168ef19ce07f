use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Part, Place};
use crate::{rule, with_others};

rule! {
    "portability/object-links", Error, Device(check);
    summary: "a tool does not know object links",
    checks: "Whether an object has a section `[xxxxObjectLinks]`. The first one is shown with the others.",
    why: "dcf-tools refuses a file with unknown sections; python-canopen and CANopenEditor write files without the section.",
    example: "`[2000ObjectLinks]`",
    remedy: "Use a copy without the section for the tool: the section only groups objects.",
    source: "dcf-tools 2.4.2, python-canopen 2.4.1, CANopenEditor of 2026",
}

fn check(device: &Device, findings: &mut Findings) {
    let mut places = device.objects.iter().filter_map(|(&index, object)| {
        let is_meant = !object.links.is_empty();
        is_meant.then(|| Place::of(Part::Links(index)))
    });
    let Some(first) = places.next() else { return };
    let finding = Diagnostic::new(&RULE.info, first, "some tools do not know object links")
        .help(say!("use a copy without the {section} for the tool"));
    findings.push(with_others(finding, places.map(|place| (place, "the same here"))));
}
