use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Field};
use crate::{rule, stated, with_others};

rule! {
    "portability/object-flags", Note, Device(check);
    summary: "a tool ignores `ObjFlags`",
    checks: "Whether an entry has an `ObjFlags` other than 0. The first one is shown with the others.",
    why: "dcf-tools accepts the key and writes the excluded entries; python-canopen does not know the key and writes files without it.",
    example: "`ObjFlags=1`, which forbids the download of the entry",
    remedy: "Check the values that the tool writes to these entries, or remove the values.",
    source: "dcf-tools 2.4.2, python-canopen 2.4.1",
}

fn check(device: &Device, findings: &mut Findings) {
    let mut places = stated::entries(device)
        .filter(|(_, entry)| entry.flags().0 != 0)
        .map(|(place, _)| place.field(Field::ObjFlags));
    let Some(first) = places.next() else { return };
    let finding =
        Diagnostic::new(&RULE.info, first, say!("not all configuration tools observe `{ObjFlags}`"))
            .help("check the values that the tool writes to these entries");
    findings.push(with_others(finding, places.map(|place| (place, "another one"))));
}
