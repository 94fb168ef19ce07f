use crate::diagnostic::{Change, Diagnostic, Findings, Fix};
use crate::lint::{list_of, rule, stated, sub_0, with_members};
use crate::model::{Device, Field, Object, Part, Place};

rule! {
    /// a sub-index belongs to no object
    ///
    /// ## What it checks
    /// Whether each sub-index has the section of its object.
    ///
    /// ## Why it matters
    /// Object type and name are missing; many tools refuse the file.
    ///
    /// ## Example
    /// `[2001sub1]` without `[2001]`
    ///
    /// ## How to mend
    /// Describe the object, or remove its sub-indexes.
    ///
    /// ## Source
    /// CiA 306-1 §4.6.3.2
    "cia306/sub-without-object", Error, Object(check), fix Unsafe
}

fn check(device: &Device, index: u16, object: &Object, findings: &mut Findings) {
    if !object.orphan {
        return;
    }
    let Some((sub, _)) = object.subs.iter().next() else { return };
    let message = format!("sub-indexes of {index:04X}h are described, the object is not");
    let finding = Diagnostic::new(&RULE.info, Place::entry(index, sub), message);
    let title = format!("add a section `[{index:X}]` with name, object type and `SubNumber`");
    let fix = Fix::risky(title.clone());
    let (fix, described) = match object.subs.get(0) {
        Some(_) => (fix, stated::described_subs(object)),
        None => (fix.with(sub_0(index, object)), stated::described_subs(object) + 1),
    };
    let keys = [
        (Field::ParameterName, format!("Object {index:04X}h")),
        (Field::ObjectType, "0x9".to_owned()),
        (Field::SubNumber, described.to_string()),
    ];
    let fix = fix.with(Change::Add(Part::Object(index), keys.to_vec()));
    let is_listed = device.lists.iter().any(|(_, listed)| listed == index);
    let list = list_of(index).filter(|&list| !is_listed && !device.lists.get(list).is_empty());
    let fix = match list {
        Some(list) => fix.with(Change::List(list, with_members(device.lists.get(list), [index]))),
        None => fix,
    };
    findings.push(finding.help(title).fix(fix));
}
