use crate::diagnostic::{Diagnostic, Findings};
use crate::model::{Device, Part, Place};
use crate::{rule, with_others};

rule! {
    "portability/type-definition", Warning, Device(check);
    summary: "the file defines data types",
    checks: "Whether there are objects below 1000h, which define types. The first one is shown, others are named.",
    why: "dcf-tools knows no section for them and refuses the file; python-canopen skips them, and takes what is of such a type for a DOMAIN.",
    example: "`[40]` with `ObjectType=0x5`",
    remedy: "Use static types, and remove the definitions.",
    source: "dcf-tools 2.4.2, python-canopen 2.4.1",
}

fn check(device: &Device, findings: &mut Findings) {
    let mut places = device.objects.iter().filter_map(|(&index, object)| {
        let is_meant = index < 0x1000 && !object.orphan;
        is_meant.then(|| Place::of(Part::Object(index)))
    });
    let Some(first) = places.next() else { return };
    let finding =
        Diagnostic::new(&RULE.info, first, "data types that the file defines are unknown to some tools")
            .help("use static types, and remove the definition");
    findings.push(with_others(finding, places.map(|place| (place, "the same here"))));
}
