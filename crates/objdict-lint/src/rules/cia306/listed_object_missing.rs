use crate::diagnostic::{Change, Diagnostic, Findings, Fix, Text, counted, say};
use crate::model::{Device, Field, ObjectList, Part, Place};
use crate::{ListFixes, rule};

rule! {
    "cia306/listed-object-missing", Error, Device(check), fix Mixed, explains Section ["unknown-key"];
    summary: "a list contains an object that is not described",
    checks: "Whether each index of the three lists has its section. `CompactPDO` makes no exception: implied PDOs are not listed.",
    why: "Most readers stop at such a list entry, or show an object without name and type.",
    example: "`4=0x2000` in a list, and no `[2000]`",
    remedy: "Describe the object, or remove its list entry and update the count.",
    source: "CiA 306-1 §4.6.3.1",
}

fn check(device: &Device, findings: &mut Findings) {
    if device.objects.is_empty() {
        return nothing_described(device, findings);
    }
    let mut fixes = ListFixes::new();
    for list in ObjectList::ALL {
        let described =
            || device.lists.get(list).iter().copied().filter(|index| device.objects.contains_key(index));
        for (number, index) in (1..).zip(device.lists.get(list)) {
            if !device.objects.contains_key(index) {
                let place = Place::of(Part::List(list)).field(Field::Item(number));
                let message =
                    say!("{:04X}h is listed, but {section} `{}` is missing", index, Part::Object(*index));
                let finding = Diagnostic::new(&RULE.info, place, message);
                let mut finding = finding.help(help(device, *index));
                finding.fix = fixes.next(device.lists.get(list), || {
                    let fix = Fix::risky("remove all list entries without a description");
                    fix.with(Change::List(list, described().collect()))
                });
                findings.push(finding);
            }
        }
    }
}

/// A hex index without `0x` is read as decimal: `1017` is 03F9h.
fn help(device: &Device, index: u16) -> Text {
    match u16::from_str_radix(&index.to_string(), 16) {
        Ok(meant) if meant >= 0x1000 && index < 0x1000 || device.objects.contains_key(&meant) => {
            say!("did you mean `0x{:04X}`? otherwise describe the object, or remove its list entry", meant)
        }
        _ => "describe the object, or remove its list entry".into(),
    }
}

/// One finding for a file that consists of lists only.
fn nothing_described(device: &Device, findings: &mut Findings) {
    let mut listed = device.lists.iter();
    let Some((list, _)) = listed.next() else { return };
    let objects = counted(1 + listed.count(), "object is", "objects are");
    let message = say!("{} listed, but none is described", objects);
    let finding = Diagnostic::new(&RULE.info, Place::of(Part::List(list)), message);
    findings.push(finding.help(say!("add {a section} such as `{[1000]}` for each object")));
}
