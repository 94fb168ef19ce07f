//! The meanings of values: description, unit, names of values and bits, as parts of the application process
//! (CiA 311).

use super::words::{key, quoted, type_word};
use objdict_keyed::rules::{OUT_OF_RANGE, WRONG_TYPE};
use objdict_keyed::section::KeyedTable;
use objdict_model::diagnostic::{Diagnostic, Findings, Severity, say};
use objdict_model::literal::written_number;
use objdict_model::model::{
    AllowedValues, ApplicationProcess, DataTypeRef, Device, Entry, LANGUAGE, Label, Labels, Parameter,
    SimpleType, TypeDefinition, TypeShape, Unit, Value, VarDeclaration,
};

/// Reads the meaning of an entry into its parameter.
pub(super) fn read(
    section: &KeyedTable<'_>,
    address: &str,
    entry: &mut Entry,
    application: &mut ApplicationProcess,
    findings: &mut Findings,
) {
    if let Some(text) = section.text("description", findings) {
        entry.parameter_mut().labels = Labels::description(LANGUAGE, &text.value);
    }
    if let Some(text) = section.text("unit", findings) {
        entry.parameter_mut().unit = Some(Unit::named(LANGUAGE, &text.value));
    }
    for name in ["factor", "offset"] {
        let Some(text) = section.text(name, findings) else { continue };
        if !text.value.parse::<f64>().is_ok_and(f64::is_finite) {
            let message = say!("`{}` is `{}`, which is not a number", name, text.value.as_str());
            let finding = Diagnostic::new(&WRONG_TYPE, text.at, message).severity(Severity::Warning);
            findings.push(finding.help("write a number, as in `0.1`"));
        }
        let parameter = entry.parameter_mut();
        let field = if name == "factor" { &mut parameter.multiplier } else { &mut parameter.offset };
        *field = Some(text.value.into());
    }
    if section.get("enum").is_some() {
        let values = section.named("enum", findings).iter();
        for value in values.clone() {
            let number = value.key.spelled();
            let negative = || number.parse().ok();
            let Some(of_type) = written_number(&number, u64::MAX).map(i128::from).or_else(negative) else {
                let message = say!("`{}` is not a number, and `enum` names values by number", number);
                findings.push(
                    Diagnostic::new(&WRONG_TYPE, value.key.span, message).help("write `number = \"name\"`"),
                );
                continue;
            };
            let Some(data_type) = entry.implied_type() else { continue };
            if data_type.is_integer() && Value::from_integer(of_type, data_type).is_none() {
                let message = say!(
                    "`enum` names {}, which is not a value of the type `{}`",
                    number,
                    type_word(data_type)
                );
                let finding =
                    Diagnostic::new(&OUT_OF_RANGE, value.key.span, message).severity(Severity::Warning);
                findings.push(finding.help("correct the number, or `type`"));
            }
        }
        let values = values.map(|value| (value.key.spelled(), value.value.spelled()));
        entry.parameter_mut().allowed_values = Some(AllowedValues::named(values));
    }
    if section.get("bits").is_some() {
        let members: Vec<VarDeclaration> = members(section, address, findings);
        set_bits(address, entry, members, application);
    }
}

/// Assigns the type of a bit word to an entry.
pub(crate) fn set_bits(
    address: &str,
    entry: &mut Entry,
    members: Vec<VarDeclaration>,
    application: &mut ApplicationProcess,
) {
    let id = bits_id(address);
    entry.parameter_mut().data_type = Some(DataTypeRef::Defined(id.as_str().into()));
    application.data_types.push(struct_of(&entry.name, &id, members));
}

fn members(section: &KeyedTable<'_>, address: &str, findings: &mut Findings) -> Vec<VarDeclaration> {
    let mut members = Vec::new();
    for bits in section.named("bits", findings) {
        let text = bits.key.spelled();
        match range(&text) {
            Some(range) => members.push(member(address, range, &bits.value.spelled())),
            None => {
                let finding = Diagnostic::new(&WRONG_TYPE, bits.key.span, say!("`{}` is not a bit", text));
                findings.push(finding.help("write the number of a bit, or a range such as `4-7`"));
            }
        }
    }
    members
}

/// The first and last bit.
fn range(text: &str) -> Option<(u8, u8)> {
    let (first, last) = text.split_once('-').unwrap_or((text, text));
    let (first, last) = (first.trim().parse().ok()?, last.trim().parse().ok()?);
    (first <= last && last < 64).then_some((first, last))
}

fn bits_id(address: &str) -> String {
    format!("UID_BITS_{address}")
}

fn struct_of(name: &str, id: &str, members: Vec<VarDeclaration>) -> TypeDefinition {
    let shape = TypeShape::Struct { members };
    TypeDefinition { name: name.into(), unique_id: id.into(), labels: Labels::default(), shape }
}

pub(crate) fn member(address: &str, (first, last): (u8, u8), name: &str) -> VarDeclaration {
    let is_single = first == last;
    let simple = if is_single { SimpleType::Bool } else { SimpleType::Bitstring };
    VarDeclaration {
        name: name.into(),
        unique_id: format!("UID_BIT_{address}_{first}").into(),
        data_type: Some(DataTypeRef::Simple(simple)),
        start: Some(first.to_string().into()),
        size: (!is_single).then(|| (last - first + 1).to_string().into()),
        ..VarDeclaration::default()
    }
}

/// The keys for the meaning of an entry, if it can be expressed.
pub(super) fn keys(device: &Device, address: &str, entry: &Entry) -> Vec<(&'static str, String)> {
    let Some(parameter) = &entry.parameter else { return Vec::new() };
    let mut keys = Vec::new();
    if let [Label::Description { lang, text, uri: None }] = parameter.labels.0.as_slice()
        && **lang == *LANGUAGE
    {
        keys.push(("description", quoted(text)));
    }
    if let Some(unit) = &parameter.unit
        && let Some(name) = unit.labels.name_in(LANGUAGE)
    {
        keys.push(("unit", quoted(name)));
    }
    keys.extend(parameter.multiplier.as_deref().map(|text| ("factor", number(text))));
    keys.extend(parameter.offset.as_deref().map(|text| ("offset", number(text))));
    keys.extend(names_of_values(parameter).map(|table| ("enum", table)));
    keys.extend(names_of_bits(device, address, entry, parameter).map(|table| ("bits", table)));
    keys
}

/// A number that TOML reads back with the same digits, otherwise a string.
fn number(text: &str) -> String {
    let is_same = text.parse::<i64>().is_ok_and(|number| number.to_string() == text)
        || text.parse::<f64>().is_ok_and(|number| number.is_finite() && format!("{number:?}") == text);
    if is_same { text.to_owned() } else { quoted(text) }
}

fn names_of_values(parameter: &Parameter) -> Option<String> {
    let allowed = parameter.allowed_values.as_ref()?;
    let named = allowed
        .values
        .iter()
        .map(|value| (&*value.value, value.labels.name_in(LANGUAGE).unwrap_or_default()));
    if allowed.values.is_empty() || AllowedValues::named(named).values != allowed.values {
        return None;
    }
    table(
        allowed
            .values
            .iter()
            .map(|value| (&*value.value, value.labels.name_in(LANGUAGE).unwrap_or_default())),
    )
}

fn names_of_bits(device: &Device, address: &str, entry: &Entry, parameter: &Parameter) -> Option<String> {
    let id = bits_id(address);
    match &parameter.data_type {
        Some(DataTypeRef::Defined(defined)) if **defined == *id => {}
        _ => return None,
    }
    let process: &ApplicationProcess = device.application.first()?;
    let definition = process.data_types.iter().find(|definition| *definition.unique_id == *id)?;
    let TypeShape::Struct { members } = &definition.shape else { return None };
    let bits: Option<Vec<(String, &str)>> = members
        .iter()
        .map(|found| {
            let first: u8 = found.start.as_deref()?.parse().ok()?;
            let size: u8 = found.size.as_deref().unwrap_or("1").parse().ok()?;
            let last = first.checked_add(size.checked_sub(1)?)?;
            let text = if first == last { first.to_string() } else { format!("{first}-{last}") };
            (member(address, (first, last), &found.name) == *found).then_some((text, &*found.name))
        })
        .collect();
    let bits = bits.filter(|_| *definition == struct_of(&entry.name, &id, members.clone()))?;
    table(bits.iter().map(|(bit, name)| (bit.as_str(), *name)))
}

/// A table of names by number; `None` if a number is repeated.
fn table<'a>(names: impl Iterator<Item = (&'a str, &'a str)>) -> Option<String> {
    let mut seen = std::collections::BTreeSet::new();
    let mut items = Vec::new();
    for (number, name) in names {
        if !seen.insert(number) {
            return None;
        }
        items.push(format!("{} = {}", key(number), quoted(name)));
    }
    Some(format!("{{ {} }}", items.join(", ")))
}
