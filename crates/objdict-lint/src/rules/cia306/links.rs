//! Object links.

use crate::diagnostic::{Findings, Fix, say};
use crate::model::{Device, Field, Object, Part, Place};
use crate::rule::rules;

rules! {
    source: "CiA 306-1 §4.6.4";

    "cia306/link-to-missing-object" = LINK_TO_MISSING_OBJECT, Warning,
        Object(link_to_missing_object), fix Unsafe;
    summary: "a link refers to a missing object",
    checks: "Whether each index in `[xxxxObjectLinks]` is described, and object xxxx as well.",
    why: "Tools show linked objects as a group; the group is incomplete.",
    example: "`1=0x6999` in `[2000ObjectLinks]`, and no `[6999]`",
    remedy: "Correct the index, or remove the link and update the count.",

    "cia306/repeated-link" = REPEATED_LINK, Warning, Object(repeated_link);
    summary: "an object is linked twice",
    checks: "Whether each object is linked once.",
    why: "Tools that show linked objects as a group show the object twice.",
    example: "`1=0x6005` and `2=0x6005` in `[6000ObjectLinks]`",
    remedy: "Remove the link and decrease the count by one.",
}

fn link_to_missing_object(device: &Device, index: u16, object: &Object, findings: &mut Findings) {
    if object.links.is_empty() {
        return;
    }
    let section = Place::of(Part::Links(index));
    if object.orphan && object.subs.is_empty() {
        let message = say!("links of {:04X}h are described, but the object is missing", index);
        let fix = Fix::risky(say!("remove the {section}")).remove(section.clone());
        let finding = LINK_TO_MISSING_OBJECT.at(section, message).fix(fix);
        findings.push(
            finding.help(say!("describe the object in `{}`, or remove the {section}", Part::Object(index))),
        );
        return;
    }
    let described = |index: &u16| device.object(*index).is_some_and(|object| !object.orphan);
    for (number, link) in (1..).zip(&object.links).filter(|(_, link)| !described(link)) {
        let message = say!("{:04X}h links to {:04X}h, which is not described", index, link);
        let place = section.clone().field(Field::Item(number));
        let fix = Fix::risky("remove the link").remove(place.clone());
        let finding = LINK_TO_MISSING_OBJECT.at(place, message).fix(fix);
        findings.push(finding.help("correct the index, or remove the link"));
    }
}

fn repeated_link(_: &Device, index: u16, object: &Object, findings: &mut Findings) {
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
        findings.push(REPEATED_LINK.at(place, message).help("remove the link and decrease the count by one"));
        return;
    }
}
