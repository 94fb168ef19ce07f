use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::model::{Device, Field, Object, Part, Place};
use crate::rule;

rule! {
    "cia306/link-to-missing-object", Warning, Object(check), fix Unsafe;
    summary: "a link refers to a missing object",
    checks: "Whether each index in `[xxxxObjectLinks]` is described, and object xxxx as well.",
    why: "Tools show linked objects as a group; the group is incomplete.",
    example: "`1=0x6999` in `[2000ObjectLinks]`, and no `[6999]`",
    remedy: "Correct the index, or remove the link and update the count.",
    source: "CiA 306-1 §4.6.4",
}

fn check(device: &Device, index: u16, object: &Object, findings: &mut Findings) {
    if object.links.is_empty() {
        return;
    }
    let section = Place::of(Part::Links(index));
    if object.orphan && object.subs.is_empty() {
        let message = say!("links of {:04X}h are described, but the object is missing", index);
        let fix = Fix::risky(say!("remove the {section}")).remove(section.clone());
        let finding = Diagnostic::new(&RULE.info, section, message).fix(fix);
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
        let finding = Diagnostic::new(&RULE.info, place, message).fix(fix);
        findings.push(finding.help("correct the index, or remove the link"));
    }
}
