use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Field};
use crate::{rule, stated, with_others};

rule! {
    "portability/parameter-reference", Note, Device(check);
    summary: "a tool drops a reference designator",
    checks: "Whether an entry of a DCF has a `ParamRefd`. The first one is shown with the others.",
    why: "python-canopen and CANopenEditor write files without the key.",
    example: "`ParamRefd=-A1.X3`",
    remedy: "Keep the original file, and do not edit it with the tool.",
    source: "python-canopen 2.4.1, CANopenEditor of 2026",
}

fn check(device: &Device, findings: &mut Findings) {
    let mut places = stated::entries(device)
        .filter(|(_, entry)| {
            entry.configured.as_ref().is_some_and(|configured| configured.reference_designator.is_some())
        })
        .map(|(place, _)| place.field(Field::ParamRefd));
    let Some(first) = places.next() else { return };
    let finding = Diagnostic::new(&RULE.info, first, say!("not all tools read `{ParamRefd}`"))
        .help("keep the original file");
    findings.push(with_others(finding, places.map(|place| (place, "another one"))));
}
