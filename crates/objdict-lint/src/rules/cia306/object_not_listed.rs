use crate::diagnostic::{Change, Diagnostic, Findings, Fix, say};
use crate::model::{Device, ObjectList, Place};
use crate::{IndexSet, ListFixes, rule, with_members};

rule! {
    "cia306/object-not-listed", Error, Device(check), fix Safe;
    summary: "an object is described, but not listed",
    checks: "Whether each object from 1000h on is in one of the lists. Data type definitions need not be. A missing list has its own finding.",
    why: "Readers that rely on the lists, such as Lely and most C tools, do not see the object.",
    example: "`[2000]`, and `SupportedObjects=0` in `[ManufacturerObjects]`",
    remedy: "Add the index to the list of its range and update the count, or remove the section.",
    source: "CiA 306-1 §4.6.3.1",
}

fn check(device: &Device, findings: &mut Findings) {
    let lists = &device.lists;
    let listed: IndexSet = lists.iter().map(|(_, index)| index).collect();
    let objects = device.objects.range(0x1000..).filter(|(_, object)| !object.orphan);
    let unlisted: Vec<u16> =
        objects.map(|(&index, _)| index).filter(|&index| !listed.contains(index)).collect();
    let mut fixes = ListFixes::new();
    // another rule reports a missing list
    for list in ObjectList::ALL.into_iter().filter(|&list| lists.has(list)) {
        let others = unlisted.iter().copied().filter(|&index| ObjectList::of(index) == Some(list));
        let all = with_members(lists.get(list), others.clone());
        for index in others {
            let message = say!("{:04X}h is described, but not in any object list", index);
            let finding = Diagnostic::new(&RULE.info, Place::object(index), message);
            let mut finding = finding.help(say!("add `0x{:04X}` to `{}`", index, list));
            finding.fix = fixes.next(&all, || {
                let fix = Fix::safe(say!("add all described objects to `{}`", list));
                fix.with(Change::List(list, all.clone()))
            });
            findings.push(finding);
        }
    }
}
