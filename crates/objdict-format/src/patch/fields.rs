//! The fields of a device by keyword: reading and setting them.

use serde_json::Value as Json;

use super::words::{FACTS, data_type, data_type_word, object_type};
use crate::compare::{Datum, DatumChange, apply};
use crate::device_toml::words::{map_word, mapping};
use objdict_keyed::tree::{KeyedTree, Kind, Pair};
use objdict_model::diagnostic::{Text, say};
use objdict_model::literal::{self, Quirks, Spelling};
use objdict_model::model::field_names::facts_of;
use objdict_model::model::{
    Access, AllowedValues, ApplicationProcess, DataType, DataTypeRef, Device, Entry, Field, LANGUAGE, Label,
    Labels, Object, Parameter, ParameterGroup, Part, PdoMapping, SimpleType, TypeDefinition, TypeShape, Unit,
    Value, VarDeclaration,
};
use objdict_model::source::Span;

/// The entry of a part; a compactly stored one has no separate entry.
pub(crate) fn entry<'a>(device: &'a Device, part: &Part) -> Option<&'a Entry> {
    match *part {
        Part::Object(index) => {
            device.object(index).filter(|object| !object.orphan).map(|object| &object.main)
        }
        Part::Entry(index, sub) => {
            let object = device.object(index)?;
            let single = || is_single(object, sub).then_some(&object.main);
            object.subs.get(sub).or_else(single)
        }
        _ => None,
    }
}

fn entry_mut<'a>(device: &'a mut Device, part: &Part) -> Option<&'a mut Entry> {
    match *part {
        Part::Object(index) => device.objects.get_mut(&index).map(|object| &mut object.main),
        Part::Entry(index, sub) => {
            let object = device.objects.get_mut(&index)?;
            match is_single(object, sub) {
                true => Some(&mut object.main),
                false => object.subs.get_mut(sub),
            }
        }
        _ => None,
    }
}

/// Whether the sub-index is the value of the object itself.
fn is_single(object: &Object, sub: u8) -> bool {
    let is_value = sub == 0 && object.compact.is_none() && !object.orphan;
    is_value && !object.object_type().has_subs() && object.subs.get(0).is_none()
}

/// The value of a field; `None` if it is not stated.
pub(crate) fn get(device: &Device, part: &Part, word: &str) -> Option<Kind> {
    if facts_of(part).is_some() {
        return kind_of(fact(device, &path_of(part, word)?)?);
    }
    let of_compact = match *part {
        Part::Entry(index, sub) => device.object(index)?.entry(sub),
        _ => None,
    };
    let entry = entry(device, part).or(of_compact.as_deref())?;
    let text = |text: &str| (!text.is_empty()).then(|| Kind::Text(text.to_owned()));
    let value = |field: Field, value: Option<&Value>| match entry.invalid_values.get(&field) {
        Some(invalid) => text(&invalid.text),
        None => value.map(kind_of_value),
    };
    let parameter = entry.parameter.as_deref();
    match word {
        "name" => text(&entry.name),
        "object-type" => entry.object_type.map(|kind| Kind::Text(kind.name().to_ascii_lowercase())),
        "type" => entry.data_type.map(|of| Kind::Text(data_type_word(of))),
        "access" => entry.access.map(|access| Kind::Text(access.name().to_owned())),
        "default" => value(Field::DefaultValue, entry.default.as_ref()),
        "value" => value(Field::ParameterValue, entry.configured_value()),
        "min" => value(Field::LowLimit, entry.low_limit.as_ref()),
        "max" => value(Field::HighLimit, entry.high_limit.as_ref()),
        "map" => entry.pdo_mapping.map(kind_of_mapping),
        "flags" => entry.flags.map(|flags| Kind::Integer(flags.0.into())),
        "denotation" => text(entry.configured.as_ref()?.denotation.as_deref()?),
        "unit" => text(parameter?.unit.as_ref()?.labels.name_in(LANGUAGE)?),
        "factor" => text(parameter?.multiplier.as_deref()?),
        "offset" => text(parameter?.offset.as_deref()?),
        "enum" => named_values(parameter?),
        "bits" => named_bits(device, parameter?),
        "description" => text(parameter?.labels.description_in(LANGUAGE)?),
        "group" => {
            let id = parameter_id(part, parameter);
            device.application.iter().find_map(|process| group_of(&process.groups, &id)).map(Kind::Text)
        }
        _ => None,
    }
}

/// Sets a field, or removes its value.
///
/// # Errors
/// The reason why the value is not valid there.
pub(crate) fn set(
    device: &mut Device,
    part: &Part,
    word: &str,
    value: Option<&KeyedTree>,
) -> Result<(), Text> {
    if facts_of(part).is_some() {
        let path = path_of(part, word).ok_or_else(|| say!("unknown field `{}`", word))?;
        return set_fact(device, &path, value);
    }
    match word {
        "group" => return set_group(device, part, value),
        "bits" => return set_bits(device, part, value),
        _ => {}
    }
    let Some(entry) = entry_mut(device, part) else { return set_compact(device, part, word, value) };
    let text = value.map(KeyedTree::spelled);
    let boxed = || text.as_deref().map(Box::<str>::from);
    let is =
        |what: &str| say!("`{}` is not {}", text.clone().unwrap_or_default(), Text::from(what.to_owned()));
    match word {
        "name" => entry.name = boxed().unwrap_or_default(),
        "object-type" => {
            entry.object_type = parsed(&text, object_type).ok_or_else(|| is("an object type"))?;
        }
        "type" => {
            entry.data_type = parsed(&text, data_type).ok_or_else(|| is("a data type"))?;
            return retype(entry);
        }
        "access" => entry.access = parsed(&text, Access::from_name).ok_or_else(|| is("an access type"))?,
        "default" | "value" | "min" | "max" => return set_value(entry, word, value),
        "map" => {
            entry.pdo_mapping =
                value.map(|value| mapping_of(value).ok_or_else(|| is("a PDO mapping"))).transpose()?;
        }
        "flags" => {
            let number =
                |text: &str| literal::written_number(text, u32::MAX.into()).map(|flags| flags as u32);
            entry.flags = parsed(&text, number)
                .ok_or_else(|| is("a number of 32 bits"))?
                .map(objdict_model::model::ObjFlags);
        }
        "denotation" => {
            entry.configured_mut().denotation = boxed();
            entry
                .configured
                .take_if(|configured| **configured == objdict_model::model::Configured::default());
        }
        _ => {
            set_parameter(entry.parameter_mut(), word, value, boxed())?;
            entry.parameter.take_if(|parameter| **parameter == Parameter::default());
        }
    }
    let field = match word {
        "object-type" => Field::ObjectType,
        "access" => Field::AccessType,
        "map" => Field::PdoMapping,
        "flags" => Field::ObjFlags,
        _ => return Ok(()),
    };
    entry.invalid_values.retain(|invalid| invalid.field != field);
    Ok(())
}

/// `None` for an invalid string, `Some(None)` for a missing one.
fn parsed<T>(text: &Option<String>, parse: impl Fn(&str) -> Option<T>) -> Option<Option<T>> {
    match text {
        Some(text) => parse(text.trim()).map(Some),
        None => Some(None),
    }
}

fn set_parameter(
    parameter: &mut Parameter,
    word: &str,
    value: Option<&KeyedTree>,
    text: Option<Box<str>>,
) -> Result<(), Text> {
    match word {
        "unit" => {
            parameter.unit = text.as_deref().map(|name| Unit::named(LANGUAGE, name));
        }
        "factor" | "offset" => {
            if let Some(number) = text.as_deref().filter(|number| number.parse::<f64>().is_err()) {
                return Err(say!("`{}` is not a number", number));
            }
            *(if word == "factor" { &mut parameter.multiplier } else { &mut parameter.offset }) = text;
        }
        "description" => {
            parameter.labels.0.retain(|label| !matches!(label, Label::Description { .. }));
            let label = |text| Label::Description { lang: LANGUAGE.into(), text, uri: None };
            parameter.labels.0.extend(text.map(label));
        }
        "enum" => {
            let values = value.map_or(Ok(Vec::new()), |value| pairs(word, value))?;
            let values = values.iter().map(|(name, number)| (number.as_str(), name));
            parameter.allowed_values.get_or_insert_default().values = AllowedValues::named(values).values;
            parameter.allowed_values.take_if(|allowed| *allowed == AllowedValues::default());
        }
        word => return Err(say!("unknown field `{}`", word)),
    }
    Ok(())
}

/// The names in a table with their values.
fn pairs(word: &str, value: &KeyedTree) -> Result<Vec<(String, String)>, Text> {
    let entries = value.entries().ok_or_else(|| say!("`{}` is a table of names and numbers", word))?;
    Ok(entries.iter().map(|Pair { key, value }| (key.spelled(), value.spelled())).collect())
}

/// Sets a name or value of a compactly stored entry, for which there are lists.
fn set_compact(device: &mut Device, part: &Part, word: &str, value: Option<&KeyedTree>) -> Result<(), Text> {
    fn put<T>(list: &mut Vec<(u8, T)>, sub: u8, item: Option<T>) {
        list.retain(|(other, _)| *other != sub);
        list.extend(item.map(|item| (sub, item)));
        list.sort_by_key(|(sub, _)| *sub);
    }
    let missing = || say!("`{}` does not exist", part.to_string());
    let Part::Entry(index, sub) = *part else { return Err(missing()) };
    let object = device.objects.get_mut(&index).ok_or_else(missing)?;
    let data_type = object.main.implied_type();
    let compact = object.compact.as_mut().filter(|compact| (1..=compact.count).contains(&sub));
    let compact = compact.ok_or_else(missing)?;
    let text = value.map(|value| value.spelled().into());
    match word {
        "name" => put(&mut compact.names, sub, text),
        "denotation" => put(&mut compact.denotations, sub, text),
        "value" => {
            let value = value.map(|value| value_of(value, data_type)).transpose()?;
            put(&mut compact.values, sub, value);
        }
        word => {
            return Err(say!(
                "`{}` is stored compactly, so it shares its `{}` with `{}`",
                part.to_string(),
                word,
                Part::Object(index).to_string()
            ));
        }
    }
    Ok(())
}

/// The value that a tree is, for an entry of this type.
fn value_of(tree: &KeyedTree, data_type: Option<DataType>) -> Result<Value, Text> {
    let text = match &*tree.kind {
        Kind::Bool(flag) => u8::from(*flag).to_string(),
        Kind::List(_) | Kind::Map(_) | Kind::Null => return Err(say!("{} is not a value", tree.kind_name())),
        _ => tree.spelled(),
    };
    let no_type = || say!("a value needs a data type: set `type` too");
    let data_type = data_type.ok_or_else(no_type)?;
    // an EDS has empty strings in quotes
    let text = if text.is_empty() { "\"\"".to_owned() } else { text };
    literal::written(&text, data_type).map_err(|wrong| match wrong.help {
        Some(_) => wrong.message.into(),
        None => say!("`{}` is not a valid `{}`", text, data_type_word(data_type)),
    })
}

fn set_value(entry: &mut Entry, word: &str, value: Option<&KeyedTree>) -> Result<(), Text> {
    let value = value.map(|value| value_of(value, entry.implied_type())).transpose()?;
    let field = match word {
        "default" => {
            entry.default = value;
            Field::DefaultValue
        }
        "min" => {
            entry.low_limit = value;
            Field::LowLimit
        }
        "max" => {
            entry.high_limit = value;
            Field::HighLimit
        }
        _ => {
            entry.configured_mut().value = value;
            entry
                .configured
                .take_if(|configured| **configured == objdict_model::model::Configured::default());
            Field::ParameterValue
        }
    };
    entry.invalid_values.retain(|invalid| invalid.field != field);
    Ok(())
}

/// The values of an entry as its new type reads their texts.
fn retype(entry: &mut Entry) -> Result<(), Text> {
    entry.invalid_values.retain(|invalid| invalid.field != Field::DataType);
    let data_type = entry.implied_type();
    let Entry { default, low_limit, high_limit, configured, invalid_values, .. } = entry;
    let configured = configured.as_deref_mut().map(|configured| &mut configured.value);
    let slots = [
        (Field::DefaultValue, Some(default)),
        (Field::LowLimit, Some(low_limit)),
        (Field::HighLimit, Some(high_limit)),
        (Field::ParameterValue, configured),
    ];
    for (field, slot) in slots {
        let Some(slot) = slot else { continue };
        let invalid = invalid_values.get(&field).map(|invalid| invalid.text.to_string());
        let printed = slot.as_ref().map(|value| literal::print(value, Spelling::default()));
        let Some(text) = invalid.or(printed) else { continue };
        invalid_values.retain(|invalid| invalid.field != field);
        match literal::value_in_line(&text, data_type, &mut Quirks::default()) {
            Ok(value) => *slot = Some(value),
            Err(reason) => {
                *slot = None;
                invalid_values.push(field, &text, reason);
            }
        }
    }
    Ok(())
}

fn kind_of_value(value: &Value) -> Kind {
    match value {
        Value::Boolean(flag) => Kind::Bool(*flag),
        Value::Signed(_) | Value::Unsigned(_) => value.as_integer().map_or(Kind::Null, Kind::Integer),
        Value::Text(text) => Kind::Text(text.to_string()),
        _ => Kind::Text(literal::print(value, Spelling::default())),
    }
}

fn kind_of_mapping(mapping: PdoMapping) -> Kind {
    match mapping {
        PdoMapping::No => Kind::Bool(false),
        PdoMapping::Optional => Kind::Bool(true),
        one_way => Kind::Text(map_word(one_way)),
    }
}

fn mapping_of(tree: &KeyedTree) -> Option<PdoMapping> {
    match &*tree.spelled() {
        "false" | "0" => Some(PdoMapping::No),
        "true" | "1" => Some(PdoMapping::Optional),
        word => mapping(word),
    }
}

/// A map without a position in a text.
fn map(entries: impl Iterator<Item = (String, Kind)>) -> Option<Kind> {
    let tree = |kind| KeyedTree::new(Span::default(), kind);
    let entries: Vec<Pair> =
        entries.map(|(key, value)| Pair { key: tree(Kind::Text(key)), value: tree(value) }).collect();
    (!entries.is_empty()).then_some(Kind::Map(entries))
}

fn number_or_text(text: &str) -> Kind {
    text.parse().map_or_else(|_| Kind::Text(text.to_owned()), Kind::Integer)
}

fn named_values(parameter: &Parameter) -> Option<Kind> {
    let values = &parameter.allowed_values.as_ref()?.values;
    let named = values.iter().filter_map(|value| Some((value.labels.name_in(LANGUAGE)?, &value.value)));
    map(named.map(|(name, value)| (name.to_owned(), number_or_text(value))))
}

fn named_bits(device: &Device, parameter: &Parameter) -> Option<Kind> {
    let Some(DataTypeRef::Defined(id)) = &parameter.data_type else { return None };
    let types = device.application.iter().flat_map(|process| &process.data_types);
    let TypeShape::Struct { members } = &types.into_iter().find(|of| of.unique_id == *id)?.shape else {
        return None;
    };
    map(members.iter().filter_map(|member| {
        let first: u32 = member.start.as_deref()?.parse().ok()?;
        let size: u32 = member.size.as_deref().map_or(Some(1), |size| size.parse().ok())?;
        let bits = match size {
            1 => Kind::Integer(first.into()),
            _ => Kind::Text(format!("{first}-{}", first.checked_add(size)?.checked_sub(1)?)),
        };
        Some((member.name.to_string(), bits))
    }))
}

/// `4`, or `4-6`: the first bit and the number of bits.
fn bit_range(text: &str) -> Option<(u8, u8)> {
    let (first, last) = text.split_once('-').unwrap_or((text, text));
    let (first, last) = (first.trim().parse().ok()?, last.trim().parse().ok()?);
    (first <= last && last < 64).then_some((first, last - first + 1))
}

fn set_bits(device: &mut Device, part: &Part, value: Option<&KeyedTree>) -> Result<(), Text> {
    let mut members = Vec::new();
    for (name, bits) in value.map_or(Ok(Vec::new()), |value| pairs("bits", value))? {
        let (first, size) = bit_range(&bits)
            .ok_or_else(|| say!("`{}` is not a bit such as `4`, or bits such as `4-6`", bits))?;
        members.push(VarDeclaration {
            name: name.as_str().into(),
            labels: Labels::name(LANGUAGE, &name),
            data_type: Some(DataTypeRef::Simple(if size == 1 {
                SimpleType::Bool
            } else {
                SimpleType::Bitstring
            })),
            start: Some(first.to_string().into()),
            size: (size > 1).then(|| size.to_string().into()),
            ..VarDeclaration::default()
        });
    }
    let id = format!("BITS_{}", part.to_string().trim_start_matches("0x"));
    let missing = || say!("`{}` has no description of its own", part.to_string());
    let entry = entry_mut(device, part).ok_or_else(missing)?;
    let old = match &entry.parameter_mut().data_type {
        Some(DataTypeRef::Defined(id)) => Some(id.clone()),
        _ => None,
    };
    entry.parameter_mut().data_type = (!members.is_empty()).then(|| DataTypeRef::Defined(id.as_str().into()));
    entry.parameter.take_if(|parameter| **parameter == Parameter::default());
    let process = process_mut(device);
    process.data_types.retain(|of| {
        *of.unique_id != *id && (old.as_ref() != Some(&of.unique_id) || !id_is_made(&of.unique_id))
    });
    if !members.is_empty() {
        process.data_types.push(TypeDefinition {
            name: id.as_str().into(),
            unique_id: id.as_str().into(),
            labels: Labels::default(),
            shape: TypeShape::Struct { members },
        });
    }
    without_empty_process(device);
    Ok(())
}

/// Whether [`set_bits`] created a type, which then belongs to one entry.
fn id_is_made(id: &str) -> bool {
    id.starts_with("BITS_")
}

/// The application process of a device, which is created if missing.
fn process_mut(device: &mut Device) -> &mut ApplicationProcess {
    if device.application.is_empty() {
        device.application.push(ApplicationProcess::default());
    }
    &mut device.application[0]
}

fn without_empty_process(device: &mut Device) {
    device.application.retain(|process| *process != ApplicationProcess::default());
}

/// The id with which groups refer to the parameter of a part.
fn parameter_id(part: &Part, parameter: Option<&Parameter>) -> String {
    let usual = match *part {
        Part::Object(index) => Parameter::usual_id(index, None),
        Part::Entry(index, sub) => Parameter::usual_id(index, Some(sub)),
        _ => String::new(),
    };
    parameter.map(|parameter| parameter.unique_id.to_string()).filter(|id| !id.is_empty()).unwrap_or(usual)
}

fn group_of(groups: &[ParameterGroup], id: &str) -> Option<String> {
    groups.iter().find_map(|group| {
        let name = group.labels.name_in(LANGUAGE).unwrap_or_default();
        if group.parameters.iter().any(|parameter| **parameter == *id) {
            return Some(name.to_owned());
        }
        group_of(&group.groups, id).map(|inner| format!("{name}/{inner}"))
    })
}

fn set_group(device: &mut Device, part: &Part, value: Option<&KeyedTree>) -> Result<(), Text> {
    fn leave(groups: &mut Vec<ParameterGroup>, id: &str) {
        for group in groups.iter_mut() {
            group.parameters.retain(|parameter| **parameter != *id);
            leave(&mut group.groups, id);
        }
        groups.retain(|group| !group.groups.is_empty() || !group.parameters.is_empty());
    }
    let missing = || say!("`{}` has no description of its own", part.to_string());
    let id = parameter_id(part, entry(device, part).ok_or_else(missing)?.parameter.as_deref());
    device.application.iter_mut().for_each(|process| leave(&mut process.groups, &id));
    if let Some(path) = value.map(KeyedTree::spelled) {
        let mut groups = &mut process_mut(device).groups;
        let mut steps = path.split('/').peekable();
        let mut unique_id = "GROUP".to_owned();
        while let Some(name) = steps.next() {
            let known = groups.iter().position(|group| group.labels.name_in(LANGUAGE) == Some(name));
            unique_id.push('_');
            unique_id.extend(name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }));
            let at = known.unwrap_or_else(|| {
                let unique_id = unique_id.as_str().into();
                groups.push(ParameterGroup {
                    unique_id,
                    labels: Labels::name(LANGUAGE, name),
                    ..ParameterGroup::default()
                });
                groups.len() - 1
            });
            if steps.peek().is_none() {
                groups[at].parameters.push(id.as_str().into());
            }
            groups = &mut groups[at].groups;
        }
    }
    without_empty_process(device);
    Ok(())
}

/// The JSON path of a property in the model, by its name in CiA 306.
fn path_of(part: &Part, name: &str) -> Option<String> {
    let (.., root) = FACTS.iter().find(|(_, of, _)| of == part)?;
    let row = facts_of(part)?.iter().find(|row| row.eds.eq_ignore_ascii_case(name))?;
    Some(format!("{root}/{}", row.json))
}

/// A property of a part, by its JSON path in the model.
fn fact(device: &Device, path: &str) -> Option<Json> {
    let (part, inner) = path.strip_prefix('/')?.split_once('/')?;
    let part = match part {
        "file_info" => serde_json::to_value(device.file_info.as_ref()?),
        "device_info" => serde_json::to_value(device.device_info.as_ref()?),
        _ => serde_json::to_value(device.commissioning.as_ref()?),
    };
    part.ok()?.pointer(&format!("/{inner}")).cloned()
}

fn kind_of(json: Json) -> Option<Kind> {
    match json {
        Json::Bool(flag) => Some(Kind::Bool(flag)),
        Json::Number(number) => number.as_u64().map(|number| Kind::Integer(number.into())),
        Json::String(text) => Some(Kind::Text(text)),
        Json::Null | Json::Array(_) | Json::Object(_) => None,
    }
}

fn set_fact(device: &mut Device, path: &str, value: Option<&KeyedTree>) -> Result<(), Text> {
    let before = fact(device, path).map(|before| Datum::from(before).fingerprint());
    let json = value.map(|value| match &*value.kind {
        Kind::Bool(flag) => Ok(Json::from(*flag)),
        Kind::Integer(number) => {
            u64::try_from(*number).map(Json::from).map_err(|_| say!("`{}` is below 0", *number))
        }
        _ => Ok(Json::from(value.spelled())),
    });
    let after = json.transpose()?.map(Datum::from);
    let change = DatumChange { path: path.to_owned(), before, after };
    match apply(device, vec![change]).is_empty() {
        true => Ok(()),
        false => Err(say!("`{}` is not a valid value", value.map(KeyedTree::spelled).unwrap_or_default())),
    }
}
