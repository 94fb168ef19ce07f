use std::collections::HashSet;

use crate::diagnostic::{Diagnostic, Findings, Text, say};
use crate::model::{BitStruct, Device, Meaning, Object, Place, TypeDefinition, TypeShape};
use crate::rule;

rule! {
    "cia311/unfitting-type", Warning, Device(check);
    summary: "a type of the application process does not fit the entry that has it",
    checks: "Whether the members of a struct that divides a number into bit fields are inside the number and do not share bits, the values of an `enum` are in the range of the data type, and the only `subrange` of an array that begins at 0 or 1 does not end behind the last sub-index. One finding for each type.",
    why: "Tools show a bit under two names, or none; generated code reads other bits than the device writes.",
    example: r#"`<varDeclaration start="4" size="5" …>` after `<varDeclaration start="2" size="3" …>` in one struct"#,
    remedy: "Correct `start` and `size` of the members, the values or the subrange, or the entry.",
    source: "CiA 311 §6.4, annex A",
}

fn check(device: &Device, findings: &mut Findings) {
    if device.application.is_empty() {
        return;
    }
    let meanings = device.meanings();
    let mut seen = HashSet::new();
    let mut report = |definition: &TypeDefinition, place: Place, problem: Text| {
        if seen.insert(definition.unique_id.clone()) {
            let message = say!("the type `{}` does not fit: {}", &*definition.name, problem);
            findings.push(Diagnostic::new(&RULE.info, place, message).help("correct the type or the entry"));
        }
    };
    for (&index, object) in &device.objects {
        if let Some(definition) = meanings.type_of(&object.main)
            && let Some(problem) = beyond(object, definition)
        {
            report(definition, Place::object(index), problem);
        }
        for (sub, _) in object.entries() {
            let (definition, problem) = match meanings.of(index, sub) {
                Some(Meaning::BitStruct(word)) => (Some(word.definition), defect(&word)),
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

/// The first problem of a word of bit fields.
fn defect(word: &BitStruct<'_>) -> Option<Text> {
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

/// How the type of an array exceeds its object.
fn beyond(object: &Object, definition: &TypeDefinition) -> Option<Text> {
    let TypeShape::Array { ranges, .. } = &definition.shape else { return None };
    let [range] = &**ranges else { return None };
    let (low, high) = (range.low.trim().parse::<i64>().ok()?, range.high.trim().parse::<i64>().ok()?);
    let last = object.highest_sub().filter(|_| object.object_type().has_subs())?;
    let is_beyond = (0..=1).contains(&low) && high > last.into();
    is_beyond.then(|| say!("its elements end at {}, the sub-indexes at {}", high, last))
}
