use crate::diagnostic::{Change, Diagnostic, Findings, Fix, Severity, say};
use crate::model::{Device, Field, ObjectList, Part, Place};
use crate::{IndexSet, ListFixes, rule, with_members};

rule! {
    "cia306/wrong-object-list", Warning, Device(check), fix Safe;
    summary: "an object stands in the wrong list",
    checks: "Whether 1000h, 1001h and 1018h are in `[MandatoryObjects]`, 2000h to 5FFFh in `[ManufacturerObjects]`, and everything else in neither. Objects from 6000h on may be mandatory, as a device profile says. A mandatory object in another list is an error.",
    why: "Tools take the list for what the object is: they refuse a device whose mandatory objects are optional, and check an optional one as if every device had it.",
    example: "`0x2001` in `[OptionalObjects]`",
    remedy: "Move the entry, and write the new count of both lists.",
    source: "CiA 306-1 §4.6.3.1",
}

fn check(device: &Device, findings: &mut Findings) {
    let [mandatory, optional, manufacturer] =
        ObjectList::ALL.map(|list| device.lists.get(list).iter().copied().collect::<IndexSet>());
    let stands_in = |index, list| match list {
        ObjectList::Mandatory => mandatory.contains(index),
        ObjectList::Optional => optional.contains(index),
        ObjectList::Manufacturer => manufacturer.contains(index),
    };
    let mut fixes = ListFixes::new();
    for list in ObjectList::ALL {
        for (number, &index) in (1..).zip(device.lists.get(list)) {
            let right = right_list(index, list);
            // what stands in the right list too is listed twice, which is another finding
            if right != list && !stands_in(index, right) {
                let place = Place::of(Part::List(list)).field(Field::Item(number));
                let message = say!("{:04X}h stands in `{}`, but belongs into `{}`", index, list, right);
                let mut finding =
                    Diagnostic::new(&RULE.info, place, message).help(say!("move it to `{}`", right));
                let members = device.lists.get(list);
                finding.fix = fixes.next(members, || moved(device, list, right, &stands_in));
                let missed = right == ObjectList::Mandatory;
                findings.push(if missed { finding.severity(Severity::Error) } else { finding });
            }
        }
    }
}

/// All that belongs from one list into another.
fn moved(
    device: &Device,
    from: ObjectList,
    to: ObjectList,
    stands_in: &impl Fn(u16, ObjectList) -> bool,
) -> Fix {
    let belongs = |index: &u16| right_list(*index, from) == to && !stands_in(*index, to);
    let (wrong, right): (Vec<u16>, Vec<u16>) =
        device.lists.get(from).iter().partition(|index| belongs(index));
    let members = with_members(device.lists.get(to), wrong);
    let fix = Fix::safe(say!("move to `{}` what belongs there", to));
    fix.with(Change::List(from, right)).with(Change::List(to, members))
}

/// The list that an index belongs into; the one where it is, when that is as good.
fn right_list(index: u16, is: ObjectList) -> ObjectList {
    match index {
        0x1000 | 0x1001 | 0x1018 => ObjectList::Mandatory,
        0x2000..=0x5FFF => ObjectList::Manufacturer,
        0x6000.. if is == ObjectList::Mandatory => is,
        0..=0xFFF => is,
        _ => ObjectList::Optional,
    }
}
