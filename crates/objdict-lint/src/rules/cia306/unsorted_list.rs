use crate::diagnostic::{Change, Diagnostic, Findings, Fix, say};
use crate::model::{Device, Field, ObjectList, Part, Place};
use crate::rule;

rule! {
    "cia306/unsorted-list", Note, Device(check), fix Safe;
    summary: "an object list is not in ascending order",
    checks: "Whether the indexes of `[MandatoryObjects]`, `[OptionalObjects]` and `[ManufacturerObjects]` are in ascending order. An index that is listed twice has its own finding.",
    why: "Readers look up objects in the list, and line-by-line comparisons show moved objects as changes.",
    example: "`1=0x1017` and `2=0x1005` in `[OptionalObjects]`",
    remedy: "Sort the list, for example with `objdict fmt`.",
    source: "Not in a standard",
}

fn check(device: &Device, findings: &mut Findings) {
    for list in ObjectList::ALL {
        let indexes = device.lists.get(list);
        let Some(at) = indexes.windows(2).position(|pair| pair[0] > pair[1]) else { continue };
        let mut sorted = indexes.to_vec();
        sorted.sort_unstable();
        if sorted.windows(2).any(|pair| pair[0] == pair[1]) {
            continue;
        }
        let (Some(first), Some(second)) = (indexes.get(at), indexes.get(at + 1)) else { continue };
        let message = say!("`{}` lists {:04X}h after {:04X}h", list, second, first);
        let item = u32::try_from(at + 2).unwrap_or(u32::MAX);
        let place = Place::of(Part::List(list)).field(Field::Item(item));
        let fix = Fix::safe("sort the list").with(Change::List(list, sorted));
        findings.push(Diagnostic::new(&RULE.info, place, message).help("sort the list").fix(fix));
    }
}
