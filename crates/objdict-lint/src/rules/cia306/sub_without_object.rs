use crate::diagnostic::{Change, Diagnostic, Findings, Fix, Text, say};
use crate::model::{Device, Field, Object, ObjectList, Part, Place};
use crate::{IndexSet, ListFixes, rule, stated, sub_0, with_members};

rule! {
    "cia306/sub-without-object", Error, Device(check), fix Unsafe;
    summary: "a sub-index has no object",
    checks: "Whether the object of each sub-index has a section.",
    why: "Object type and name are missing; many tools refuse the file.",
    example: "`[2001sub1]` without `[2001]`",
    remedy: "Describe the object, or remove its sub-indexes.",
    source: "CiA 306-1 §4.6.3.2",
}

fn check(device: &Device, findings: &mut Findings) {
    let mut orphans = device.objects.iter().filter(|(_, object)| object.orphan).peekable();
    if orphans.peek().is_none() {
        return;
    }
    let listed: IndexSet = device.lists.iter().map(|(_, index)| index).collect();
    let mut fixes = ListFixes::new();
    for (&index, object) in orphans {
        let Some((sub, _)) = object.subs.iter().next() else { continue };
        let message = say!("sub-indexes of {:04X}h are described, but the object is missing", index);
        let finding = Diagnostic::new(&RULE.info, Place::entry(index, sub), message);
        let title =
            say!("add {a section} `{}` with name, object type and `{SubNumber}`", Part::Object(index));
        let mut finding = finding.help(title.clone());
        let list = ObjectList::of(index).filter(|&list| !listed.contains(index) && device.lists.has(list));
        finding.fix = match list {
            Some(list) => {
                let members = device.lists.get(list);
                fixes.next(members, || {
                    let others = with_members(members, [index]);
                    section(title, index, object).with(Change::List(list, others))
                })
            }
            None => Some(section(title, index, object)),
        };
        findings.push(finding);
    }
}

/// The missing section of the object, with sub-index 0 if that is also missing.
fn section(title: Text, index: u16, object: &Object) -> Fix {
    let fix = Fix::risky(title);
    let (fix, described) = match object.subs.get(0) {
        Some(_) => (fix, stated::described_subs(object)),
        None => (fix.with(sub_0(index, object)), stated::described_subs(object) + 1),
    };
    let keys = [
        (Field::ParameterName, format!("Object {index:04X}h")),
        (Field::ObjectType, "0x9".to_owned()),
        (Field::SubNumber, described.to_string()),
    ];
    fix.with(Change::Add(Part::Object(index), keys.to_vec()))
}
