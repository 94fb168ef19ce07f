use crate::diagnostic::{Change, Diagnostic, Findings, Fix, Severity, say};
use crate::model::{Device, Field, ObjectList, Part, Place};
use crate::{IndexSet, ListFixes, rule, with_members};

rule! {
    "cia306/wrong-object-list", Warning, Device(check), fix Safe;
    summary: "an object is in the wrong list",
    checks: "Whether 1000h, 1001h and 1018h are in `[MandatoryObjects]`, 2000h to 5FFFh in `[ManufacturerObjects]`, and all other objects in neither. Objects from 6000h on may be mandatory, depending on the device profile. A mandatory object in another list is an error.",
    why: "Tools derive the category of an object from its list: they refuse a device whose mandatory objects are optional, and require optional objects that are listed as mandatory.",
    example: "`0x2001` in `[OptionalObjects]`",
    remedy: "Move the entry, and update the count of both lists.",
    source: "CiA 306-1 §4.6.3.1",
}

fn check(device: &Device, findings: &mut Findings) {
    let [mandatory, optional, manufacturer] =
        ObjectList::ALL.map(|list| device.lists.get(list).iter().copied().collect::<IndexSet>());
    let is_in = |index, list| match list {
        ObjectList::Mandatory => mandatory.contains(index),
        ObjectList::Optional => optional.contains(index),
        ObjectList::Manufacturer => manufacturer.contains(index),
    };
    let mut fixes = ListFixes::new();
    for list in ObjectList::ALL {
        for (number, &index) in (1..).zip(device.lists.get(list)) {
            let right = right_list(index, list);
            // another rule reports an object that is also in the right list
            if right != list && !is_in(index, right) {
                let place = Place::of(Part::List(list)).field(Field::Item(number));
                let message = say!("{:04X}h is in `{}`, but belongs in `{!}`", index, list, right);
                let mut finding =
                    Diagnostic::new(&RULE.info, place, message).help(say!("move it to `{}`", right));
                let members = device.lists.get(list);
                finding.fix = fixes.next(members, || moved(device, list, right, &is_in));
                let missed = right == ObjectList::Mandatory;
                findings.push(if missed { finding.severity(Severity::Error) } else { finding });
            }
        }
    }
}

/// Moves all misplaced objects from one list to another.
fn moved(device: &Device, from: ObjectList, to: ObjectList, is_in: &impl Fn(u16, ObjectList) -> bool) -> Fix {
    let belongs = |index: &u16| right_list(*index, from) == to && !is_in(*index, to);
    let (wrong, right): (Vec<u16>, Vec<u16>) =
        device.lists.get(from).iter().partition(|index| belongs(index));
    let members = with_members(device.lists.get(to), wrong);
    let fix = Fix::safe(say!("move all misplaced objects to `{}`", to));
    fix.with(Change::List(from, right)).with(Change::List(to, members))
}

/// The list that an index belongs to; the current one if that is also correct.
fn right_list(index: u16, is: ObjectList) -> ObjectList {
    match index {
        0x1000 | 0x1001 | 0x1018 => ObjectList::Mandatory,
        0x2000..=0x5FFF => ObjectList::Manufacturer,
        0x6000.. if is == ObjectList::Mandatory => is,
        0..=0xFFF => is,
        _ => ObjectList::Optional,
    }
}
