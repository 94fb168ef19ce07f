use std::collections::{HashMap, HashSet};

use crate::diagnostic::{Change, Diagnostic, Findings, Fix, say};
use crate::model::{Device, Field, ObjectList, Part, Place};
use crate::{IndexSet, ListFixes, rule};

rule! {
    "cia306/object-listed-twice", Error, Device(check), fix Mixed;
    summary: "an object is listed twice",
    checks: "Whether each index is in one list only, and once.",
    why: "Some tools create two objects, others refuse the file.",
    example: "`0x1018` in `[MandatoryObjects]` and in `[OptionalObjects]`",
    remedy: "Remove it from the list that it does not belong to, renumber the following entries and update the count.",
    source: "CiA 306-1 §4.6.3.1",
}

fn check(device: &Device, findings: &mut Findings) {
    let mut seen = IndexSet::new();
    let mut listed = ObjectList::ALL.into_iter().flat_map(|list| device.lists.get(list));
    if listed.all(|&index| seen.insert(index)) {
        return;
    }
    let mut fixes = ListFixes::new();
    let mut first: HashMap<u16, (ObjectList, u32)> = HashMap::new();
    for list in ObjectList::ALL {
        for (number, &index) in (1..).zip(device.lists.get(list)) {
            let (other, at) = *first.entry(index).or_insert((list, number));
            if (other, at) == (list, number) {
                continue;
            }
            let place = |list, number| Place::of(Part::List(list)).field(Field::Item(number));
            let message = if other == list {
                say!("{:04X}h is listed twice in `{}`", index, list)
            } else {
                say!("{:04X}h is listed in `{}` and in `{}`", index, other, list)
            };
            let finding = Diagnostic::new(&RULE.info, place(list, number), message);
            let finding = finding.label(place(other, at), "first here");
            let wrong = if ObjectList::of(index) == Some(list) { other } else { list };
            let mut finding = match other == list {
                true => finding.help("remove one of the two entries"),
                false => finding.help(say!("remove it from `{}`", wrong)),
            };
            finding.fix = fixes.next(device.lists.get(list), || match other == list {
                true => once(device, list),
                false => elsewhere(device, wrong, index),
            });
            findings.push(finding);
        }
    }
}

/// Keeps each member of the list once.
fn once(device: &Device, list: ObjectList) -> Fix {
    let mut seen = HashSet::new();
    let members = device.lists.get(list).iter().copied().filter(|&index| seen.insert(index)).collect();
    Fix::safe("remove the repeated entries").with(Change::List(list, members))
}

/// Removes the object from the list that it does not belong to.
fn elsewhere(device: &Device, wrong: ObjectList, index: u16) -> Fix {
    let members = device.lists.get(wrong).iter().copied().filter(|&member| member != index).collect();
    Fix::risky(say!("remove it from `{}`", wrong)).with(Change::List(wrong, members))
}
