use crate::diagnostic::{Diagnostic, Findings};
use crate::model::{Device, Part, Place};
use crate::{rule, with_others};

rule! {
    "portability/type-definition", Error, Device(check);
    summary: "the file defines data types",
    checks: "Whether the file has objects below 1000h, which define types. The first one is shown with the others.",
    why: "dcf-tools does not support such sections and refuses the file; python-canopen skips them and treats entries of these types as DOMAIN.",
    example: "`[40]` with `ObjectType=0x5`",
    remedy: "Use standard types, and remove the definitions.",
    source: "dcf-tools 2.4.2, python-canopen 2.4.1",
}

fn check(device: &Device, findings: &mut Findings) {
    let mut places = device.objects.iter().filter_map(|(&index, object)| {
        let is_meant = index < 0x1000 && !object.orphan;
        is_meant.then(|| Place::of(Part::Object(index)))
    });
    let Some(first) = places.next() else { return };
    let finding = Diagnostic::new(&RULE.info, first, "some tools do not know data types defined in the file")
        .help("use standard types, and remove the definition");
    findings.push(with_others(finding, places.map(|place| (place, "the same here"))));
}
