use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Field};
use crate::{rule, stated, with_others};

rule! {
    "portability/object-flags", Note, Device(check);
    summary: "`ObjFlags` is for tools that do not look at it",
    checks: "Whether an entry has an `ObjFlags` that is not 0. The first one is shown, others are named.",
    why: "dcf-tools accepts the key and writes what it must not write; python-canopen does not know it and writes files without it.",
    example: "`ObjFlags=1`, which refuses the entry to a download",
    remedy: "Check what the tool writes to these entries, or do not give them a value.",
    source: "dcf-tools 2.4.2, python-canopen 2.4.1",
}

fn check(device: &Device, findings: &mut Findings) {
    let mut places = stated::entries(device)
        .filter(|(_, entry)| entry.flags().0 != 0)
        .map(|(place, _)| place.field(Field::ObjFlags));
    let Some(first) = places.next() else { return };
    let finding =
        Diagnostic::new(&RULE.info, first, say!("`{ObjFlags}` says what a configuration tool must not do"))
            .help("check what the tool writes when it configures the device");
    findings.push(with_others(finding, places.map(|place| (place, "another one"))));
}
