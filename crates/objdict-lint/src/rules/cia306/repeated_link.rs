use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Field, Object, Part, Place};
use crate::rule;

rule! {
    "cia306/repeated-link", Warning, Object(check);
    summary: "an object is linked twice",
    checks: "Whether each object is linked once.",
    why: "Tools that show linked objects as a group show the object twice.",
    example: "`1=0x6005` and `2=0x6005` in `[6000ObjectLinks]`",
    remedy: "Remove the link and decrease the count by one.",
    source: "CiA 306-1 §4.6.4",
}

fn check(_: &Device, index: u16, object: &Object, findings: &mut Findings) {
    if object.links.is_empty() {
        return;
    }
    let mut seen = std::collections::HashSet::new();
    for (at, &link) in object.links.iter().enumerate() {
        if seen.insert(link) {
            continue;
        }
        let message = say!("{:04X}h has two links to {:04X}h", index, link);
        let item = u32::try_from(at + 1).unwrap_or(u32::MAX);
        let place = Place::of(Part::Links(index)).field(Field::Item(item));
        findings.push(
            Diagnostic::new(&RULE.info, place, message).help("remove the link and decrease the count by one"),
        );
        return;
    }
}
