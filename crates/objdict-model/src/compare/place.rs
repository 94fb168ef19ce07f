//! Converts paths in the JSON of the model to addresses in the device.

use crate::model::field_names::at_json;
use crate::model::{Field, ModulePart, ObjectList, Part, Place};

/// The address of a path.
pub(super) fn of(path: &str) -> Place {
    let mut steps = path.split('/').skip(1);
    let first = steps.next().unwrap_or_default();
    let rest: Vec<&str> = steps.collect();
    let whole = |part: Part| with_field(part, &rest);
    match first {
        "file_info" => known(Part::FileInfo, &rest),
        "device_info" => known(Part::DeviceInfo, &rest),
        "dummy_usage" => whole(Part::DummyUsage),
        "comments" => whole(Part::Comments),
        "commissioning" => known(Part::Commissioning, &rest),
        "downloads" => named(Part::Commissioning, &[&[first], rest.as_slice()].concat()),
        "lists" => list(&rest),
        "objects" => object(&rest, &Part::Object, &Part::Entry),
        "modules" => modules(&rest),
        "dynamic_channels" => whole(Part::DynamicChannels),
        "tools" => whole(Part::Tools),
        "headers" => whole(Part::Headers),
        "identity" => whole(Part::Identity),
        "network_identity" => whole(Part::NetworkIdentity),
        "manager" => whole(Part::Manager),
        "functions" => whole(Part::Functions),
        "application" => whole(Part::Application),
        "module_objects" => whole(Part::ModuleObjects),
        _ => named(Part::Device, &[&[first], rest.as_slice()].concat()),
    }
}

/// The place of the field that the steps of a path lead to.
fn with_field(part: Part, steps: &[&str]) -> Place {
    match steps {
        [] => Place::of(part),
        [name] => match field(name) {
            Some(field) => Place::of(part).field(field),
            None => named(part, steps),
        },
        _ => named(part, steps),
    }
}

/// A field that has no name but its path.
fn named(part: Part, steps: &[&str]) -> Place {
    let name = steps.join("/").replace("~1", "/").replace("~0", "~");
    if name.is_empty() { Place::of(part) } else { Place::of(part).field(Field::Named(name.into())) }
}

fn number<T>(digits: &str, from_hex: fn(&str, u32) -> Result<T, std::num::ParseIntError>) -> Option<T> {
    from_hex(digits.strip_prefix("0x")?, 16).ok()
}

fn object(steps: &[&str], object: &dyn Fn(u16) -> Part, entry: &dyn Fn(u16, u8) -> Part) -> Place {
    let Some((index, rest)) = steps.split_first() else { return Place::device() };
    let Some(index) = number(index, u16::from_str_radix) else { return named(Part::Device, steps) };
    match rest {
        ["subs", sub, rest @ ..] => match number(sub, u8::from_str_radix) {
            Some(sub) => entry_field(entry(index, sub), rest),
            None => named(object(index), rest),
        },
        ["compact", "names", ..] => compact(Part::CompactNames(index), &rest[2..]),
        ["compact", "values", ..] => compact(Part::CompactValues(index), &rest[2..]),
        ["compact", "denotations", ..] => compact(Part::CompactDenotations(index), &rest[2..]),
        ["compact", "count"] | ["compact"] => Place::of(object(index)).field(Field::CompactSubObj),
        ["links", ..] => Place::of(Part::Links(index)),
        rest => entry_field(object(index), rest),
    }
}

fn compact(part: Part, steps: &[&str]) -> Place {
    match steps {
        [sub, ..] => match number(sub, u8::from_str_radix) {
            Some(sub) => Place::of(part).field(Field::Item(sub.into())),
            None => named(part, steps),
        },
        [] => Place::of(part),
    }
}

/// A field with a row in the table of names, otherwise one with that name.
fn known(part: Part, steps: &[&str]) -> Place {
    match at_json(&part, &steps.join("/")) {
        Some(field) => Place::of(part).field(field),
        None => with_field(part, steps),
    }
}

/// A field of an entry.
fn entry_field(part: Part, steps: &[&str]) -> Place {
    match at_json(&part, &steps.join("/")) {
        Some(field) => Place::of(part).field(field),
        None => named(part, steps),
    }
}

fn list(steps: &[&str]) -> Place {
    let list = match steps.first() {
        Some(&"mandatory") => ObjectList::Mandatory,
        Some(&"optional") => ObjectList::Optional,
        Some(&"manufacturer") => ObjectList::Manufacturer,
        _ => return named(Part::Device, steps),
    };
    let item = steps.get(1).and_then(|position| position.parse::<u32>().ok());
    let place = Place::of(Part::List(list));
    // items are counted from 1
    item.and_then(|item| item.checked_add(1)).map_or(place.clone(), |item| place.field(Field::Item(item)))
}

fn modules(steps: &[&str]) -> Place {
    match steps {
        ["connected", rest @ ..] => named(Part::ConnectedModules, rest),
        ["supported", number, rest @ ..] => match number.parse() {
            Ok(number) => module(number, rest),
            Err(_) => named(Part::SupportedModules, steps),
        },
        _ => named(Part::SupportedModules, steps),
    }
}

fn module(number: u16, steps: &[&str]) -> Place {
    let part = |part: ModulePart| Part::Module(number, part);
    match steps {
        ["comments", rest @ ..] => named(part(ModulePart::Comments), rest),
        ["fixed_list", rest @ ..] => named(part(ModulePart::FixedObjects), rest),
        ["fixed", rest @ ..] => object(rest, &|index| part(ModulePart::Fixed(index)), &|index, sub| {
            part(ModulePart::FixedEntry(index, sub))
        }),
        ["extension_list", rest @ ..] => named(part(ModulePart::SubExtends), rest),
        ["extensions", rest @ ..] => object(rest, &|index| part(ModulePart::SubExt(index)), &|index, _| {
            part(ModulePart::SubExt(index))
        }),
        rest => with_field(part(ModulePart::Info), rest),
    }
}

/// The field with this name in JSON, ignoring case and underscores: `file_version`, `FileVersion`.
fn field(name: &str) -> Option<Field> {
    let squeezed = name.replace('_', "");
    let same = |text: &str| text.replace('_', "").eq_ignore_ascii_case(&squeezed);
    Field::NAMED.iter().find(|(text, _)| same(text)).map(|(_, field)| field.clone())
}
