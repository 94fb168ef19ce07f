use std::collections::HashMap;

use crate::diagnostic::{Diagnostic, Findings, listing, say};
use crate::model::{Device, Entry, Field, ModulePart, Object, Part, Place};
use crate::rule;

rule! {
    "cia306/module-conflict", Error, Device(check);
    summary: "two modules describe the same object differently",
    checks: "Whether a fixed object or extension of several modules is identical in all of them: object type, data type, access, mapping, default, limits and flags, including sub-indexes. Names and `Count` may differ. Defaults of extensions of 1027h (module list) may differ too: they are the module numbers.",
    why: "The assembled device has the object only once, so only one description can be correct.",
    example: "`[M1SubExt6000]` with UNSIGNED8 and `[M2SubExt6000]` with UNSIGNED16",
    remedy: "Use the same description in all modules.",
    source: "CiA 306-1 §6.3",
}

/// 1027h: each element is a module number.
const MODULE_LIST: u16 = 0x1027;

fn check(device: &Device, findings: &mut Findings) {
    let Some(modules) = &device.modules else { return };
    let mut fixed: HashMap<u16, (u16, &Object)> = HashMap::new();
    let mut extensions: HashMap<u16, (u16, &Entry)> = HashMap::new();
    for (&number, module) in &modules.supported {
        for (&index, object) in &module.fixed {
            let (first, other) = *fixed.entry(index).or_insert((number, object));
            let (field, place) = (different_object(other, object), ModulePart::Fixed(index));
            report(index, (first, number), place, &field, findings);
        }
        for (&index, extension) in &module.extensions {
            let (first, other) = *extensions.entry(index).or_insert((number, &extension.entry));
            let mut fields = different_entry(other, &extension.entry);
            fields.retain(|field| index != MODULE_LIST || *field != Field::DefaultValue);
            report(index, (first, number), ModulePart::SubExt(index), &fields, findings);
        }
    }
}

fn different_object(first: &Object, second: &Object) -> Vec<Field> {
    let mut fields = different_entry(&first.main, &second.main);
    let subs = |object: &Object| object.subs.iter().map(|(sub, _)| sub).collect::<Vec<u8>>();
    if subs(first) != subs(second) {
        fields.push(Field::SubNumber);
    }
    for ((_, first), (_, second)) in first.subs.iter().zip(second.subs.iter()) {
        fields.extend(different_entry(first, second));
    }
    fields.sort_unstable();
    fields.dedup();
    fields
}

fn different_entry(first: &Entry, second: &Entry) -> Vec<Field> {
    let same = [
        (Field::ObjectType, first.object_type == second.object_type),
        (Field::DataType, first.data_type == second.data_type),
        (Field::AccessType, first.access == second.access),
        (Field::PdoMapping, first.is_mappable() == second.is_mappable()),
        (Field::DefaultValue, first.default == second.default),
        (Field::LowLimit, first.low_limit == second.low_limit),
        (Field::HighLimit, first.high_limit == second.high_limit),
        (Field::ObjFlags, first.flags() == second.flags()),
    ];
    same.into_iter().filter(|(_, same)| !same).map(|(field, _)| field).collect()
}

fn report(
    index: u16,
    (first, second): (u16, u16),
    part: ModulePart,
    fields: &[Field],
    findings: &mut Findings,
) {
    if fields.is_empty() {
        return;
    }
    let place = |number| Place::of(Part::Module(number, part));
    let message = say!("{:04X}h of modules {} and {} differs in {}", index, first, second, listing(fields));
    let finding =
        Diagnostic::new(&RULE.info, place(second), message).label(place(first), "the other description");
    findings.push(finding.help("use the same description in all modules"));
}
