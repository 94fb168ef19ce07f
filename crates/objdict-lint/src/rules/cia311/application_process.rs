//! The parameters of an application process: their types and values.

use std::collections::HashSet;

use crate::diagnostic::{Findings, Text, joined, say};
use crate::model::{BitStruct, Device, Meaning, Object, Place, TypeDefinition, TypeShape};
use crate::rule::rules;

rules! {
    source: "CiA 311 §6.4, annex A";

    "cia311/unfitting-type" = UNFITTING_TYPE, Warning, Device(unfitting_type);
    summary: "a type of the application process does not fit its entry",
    checks: "In a struct that divides a number into bit fields, the members must be inside the number and must not share bits. The values of an `enum` must be in the range of the data type. If the only `subrange` of an array begins at 0 or 1, it must end at the last sub-index. The rule reports one finding per type.",
    why: "Tools show a bit under two names or under none. Generated code does not read the bits that the device writes.",
    example: r#"`<varDeclaration start="4" size="5" …>` after `<varDeclaration start="2" size="3" …>` in one struct"#,
    remedy: "Correct `start` and `size` of the members, the values or the subrange, or correct the entry.",

    "cia311/value-without-name" = VALUE_WITHOUT_NAME, Warning, Device(value_without_name);
    summary: "a value is not in its enumeration",
    checks: "If the type of an entry is an `enum`, or a struct with members of such a type, its default and actual value must have a name in the enumeration. An enumeration with an invalid value is not compared.",
    why: "Tools that offer the names cannot show the value. When they write the device, they replace the value by a different one.",
    example: r#"`<defaultValue value="9"/>` of a parameter whose `enum` has the values 0 to 2"#,
    remedy: "Add the value to the enumeration, or correct it.",
}

fn unfitting_type(device: &Device, findings: &mut Findings) {
    if device.application.is_empty() {
        return;
    }
    let meanings = device.meanings();
    let mut seen = HashSet::new();
    let mut report = |definition: &TypeDefinition, place: Place, problem: Text| {
        if seen.insert(definition.unique_id.clone()) {
            let message = say!("the type `{}` does not fit: {}", &*definition.name, problem);
            findings.push(UNFITTING_TYPE.at(place, message).help("correct the type or the entry"));
        }
    };
    for (&index, object) in &device.objects {
        if let Some(definition) = meanings.type_of(&object.main)
            && let Some(problem) = other_end_of_array(object, definition)
        {
            report(definition, Place::object(index), problem);
        }
        for (sub, _) in object.entries() {
            let (definition, problem) = match meanings.of(index, sub) {
                Some(Meaning::BitStruct(word)) => (Some(word.definition), bit_field_defect(&word)),
                Some(Meaning::Enumeration(named)) => {
                    (named.definition, named.defects.first().cloned().map(Text::from))
                }
                None => continue,
            };
            if let (Some(definition), Some(problem)) = (definition, problem) {
                report(definition, device.value_place(index, sub), problem);
            }
        }
    }
}

/// The first problem of a number with bit fields.
fn bit_field_defect(word: &BitStruct<'_>) -> Option<Text> {
    let of_values = word.fields.iter().filter_map(|field| field.values.as_ref()?.defects.first());
    if let Some(defect) = word.defects.iter().chain(of_values).next() {
        return Some(defect.clone().into());
    }
    let mut taken: Vec<(&str, u64)> = Vec::new();
    for field in &word.fields {
        if let Some((other, mask)) = taken.iter().find(|(_, mask)| mask & field.mask() != 0) {
            let bit = (mask & field.mask()).trailing_zeros();
            return Some(say!("`{}` and `{}` share bit {}", *other, field.name, bit));
        }
        taken.push((field.name, field.mask()));
    }
    None
}

/// The difference between the ends of an array type and of its object.
fn other_end_of_array(object: &Object, definition: &TypeDefinition) -> Option<Text> {
    let TypeShape::Array { ranges, .. } = &definition.shape else { return None };
    let [range] = &**ranges else { return None };
    let (low, high) = (range.low.trim().parse::<i64>().ok()?, range.high.trim().parse::<i64>().ok()?);
    let last = object.highest_sub().filter(|_| object.object_type().has_subs())?;
    let is_other = (0..=1).contains(&low) && high != i64::from(last);
    is_other.then(|| say!("its elements end at {}, but the sub-indexes at {}", high, last))
}

fn value_without_name(device: &Device, findings: &mut Findings) {
    if device.application.is_empty() {
        return;
    }
    let meanings = device.meanings();
    for (&index, object) in &device.objects {
        for (sub, _) in object.entries() {
            let value = object.value(sub).and_then(|value| value.as_integer());
            let (Some(value), Some(Meaning::Enumeration(named))) = (value, meanings.of(index, sub)) else {
                continue;
            };
            // another rule compares single allowed values
            let Some(definition) = named.definition.filter(|_| named.defects.is_empty()) else { continue };
            if named.values.iter().any(|name| name.number == value) {
                continue;
            }
            let numbers = named.values.iter().take(8).map(|name| say!("`{}`", name.number));
            let message = say!("`{}` is not a value of the enumeration `{}`", value, &*definition.name);
            let finding = VALUE_WITHOUT_NAME.at(device.value_place(index, sub), message);
            findings.push(finding.help(say!("write one of {}, or add the value", joined(numbers, ", "))));
        }
    }
}
