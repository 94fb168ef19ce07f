//! The keys of an object or sub-index: mandatory and unsupported ones, names and flags.

use std::collections::HashMap;

use crate::diagnostic::{Argument, Findings, Fix, Severity, listing, listing_or, say, sub_index};
use crate::model::{Access, DataType, Device, Entry, Field, Object, ObjectType, Place};
use crate::rule::rules;
use crate::{EntryAt, profile, stated};

rules! {
    "cia306/command-without-flag" = COMMAND_WITHOUT_FLAG, Note, Object(command_without_flag), fix Unsafe;
    summary: "`ObjFlags` does not stop tools from writing a command",
    checks: "The writable entries of command objects (1010h store, 1011h restore, 1023h command, 1F25h, 1F50h and 1F51h program download) must have bit 0 of `ObjFlags` set, in the entry or in the object. Few real files set the flag: nearly half of them describe 1010h or 1011h, none with the flag. The finding is a note because tools that check the signature (`save`, `load`) before they write are safe without the flag.",
    why: "A tool that downloads a configuration writes every entry that has a value. The flag excludes entries that would store, restore or erase something.",
    example: "`[1010sub1]` without `ObjFlags=0x1`",
    remedy: "Write `ObjFlags=0x1` in the writable sub-indexes.",
    source: "CiA 306-1 §4.6.3.3",

    "cia306/duplicate-name" = DUPLICATE_NAME, Note, Object(duplicate_name);
    summary: "two sub-indexes of an object have the same name",
    checks: "The names of an object's sub-indexes must differ. Objects below 2000h are not checked because CiA 301 itself repeats names there. Only the first repetition in an object is shown.",
    why: "Users cannot distinguish the entries, libraries that look up entries by name return the first one, and code generators have to add numbers.",
    example: "`ParameterName=Gain` in `[2000sub1]` and in `[2000sub2]`",
    remedy: "Add a number or a word to the names.",
    source: "Not in a standard; python-canopen, for example, looks up entries by name",

    "cia306/invalid-object-flags" = INVALID_OBJECT_FLAGS, Warning, Entry(invalid_object_flags), fix Unsafe;
    summary: "`ObjFlags` has reserved bits",
    checks: "Only bits 0 (no download), 1 (no upload) and 2 (effective after a reset, added by CiA 311) may be set.",
    why: "The other bits are reserved: a later version may define them. The value may belong to a different key.",
    example: "`ObjFlags=0x8`",
    remedy: "Write the sum of 1 and 2, or remove the key.",
    source: "CiA 306-1 §4.6.3.3",

    "cia306/missing-key" = MISSING_KEY, Error,
        EntryOf(missing_key), fix Mixed, stops "*" at [DataType, AccessType];
    summary: "a key required by the object type is missing",
    checks: "A VAR, DEFTYPE or sub-index must have `DataType` and `AccessType`, and so must an ARRAY or RECORD with `CompactSubObj`. Any other ARRAY, RECORD or DEFSTRUCT must have `SubNumber`. An object with sub-indexes must have `ObjectType` (a missing object type means VAR). A `DOMAIN` needs none of these keys.",
    why: "Without data type and access, the value cannot be read or written. Tools make different assumptions or reject the file.",
    example: "A VAR without `AccessType`",
    remedy: "Add the key.",
    source: "CiA 306-1 §4.6.3.2, obligation table",

    "cia306/missing-name" = MISSING_NAME, Warning, Entry(missing_name);
    summary: "an object or sub-index has no name",
    checks: "Each section of an object or sub-index must have a non-empty `ParameterName`.",
    why: "Tools show the name. python-canopen and others reject a file without it; code generators have to invent one.",
    example: "`ParameterName=`",
    remedy: "Write the name from the standard or the manual.",
    source: "CiA 306-1 §4.6.3.2",

    "cia306/unsupported-key" = UNSUPPORTED_KEY, Warning, EntryOf(unsupported_key), fix Mixed;
    summary: "the object type does not support a key",
    checks: "An ARRAY, RECORD or DEFSTRUCT without `CompactSubObj` must not have keys of a value (`DataType`, `AccessType`, `DefaultValue`, `PDOMapping=1`, limits). A DOMAIN must not have limits or `PDOMapping=1`. A VAR, DEFTYPE or DOMAIN must not have `SubNumber`. `SubNumber=0` and `PDOMapping=0` are accepted. `CompactSubObj` of a VAR or DOMAIN is an error. CiA 311 allows `dataType` and `accessType` for every object.",
    why: "The key describes a value that does not exist. The object type may be wrong, or the key is in the wrong section.",
    example: "`[1018]` with `ObjectType=0x9` and `DataType=0x0023`",
    remedy: "Remove the key, move it to the sub-indexes, or correct `ObjectType`.",
    source: "CiA 306-1 §4.6.3.2, obligation table",
}

fn command_without_flag(index: u16, object: &Object, findings: &mut Findings) {
    let command = match index {
        0x1010 => "stores parameters",
        0x1011 => "restores default parameters",
        0x1023 => "executes a command",
        0x1F25 => "makes a node update its configuration",
        0x1F50 | 0x1F51 => "loads or starts a program",
        _ => return,
    };
    if object.orphan
        || object.main.flags().refuses_write()
        || stated::is_invalid(&object.main, &Field::ObjFlags)
    {
        return;
    }
    let places = unguarded_entries(index, object);
    let Some((place, _)) = places.first().cloned() else { return };
    let message =
        say!("writing {:04X}h {}, but `{ObjFlags}` does not stop tools from writing it", index, command);
    let finding = COMMAND_WITHOUT_FLAG.at(place, message);
    let parts = places.iter().map(|(place, _)| place.part.clone());
    let title = match places.len() {
        1..=4 => say!("write `{ObjFlags=0x1}` in {}", listing(parts)),
        _ => say!("write `{ObjFlags=0x1}` in its writable entries"),
    };
    let fix = places.into_iter().fold(Fix::risky(title.clone()), |fix, (place, flags)| {
        fix.set(place.field(Field::ObjFlags), format!("0x{:X}", flags | 1))
    });
    findings.push(finding.help(title).fix(fix));
}

/// The writable entries without the flag, with their current flags.
fn unguarded_entries(index: u16, object: &Object) -> Vec<(Place, u32)> {
    let is_unguarded = |entry: &Entry| {
        entry.access.is_some_and(Access::is_writable)
            && !entry.flags().refuses_write()
            && !stated::is_invalid(entry, &Field::ObjFlags)
    };
    let subs = object.subs.iter().filter(|&(sub, entry)| sub > 0 && is_unguarded(entry));
    let places: Vec<_> = subs.map(|(sub, entry)| (Place::entry(index, sub), entry.flags().0)).collect();
    if places.is_empty() && is_unguarded(&object.main) {
        return vec![(Place::object(index), object.main.flags().0)];
    }
    places
}

fn duplicate_name(index: u16, object: &Object, findings: &mut Findings) {
    let Some((first, second)) = Some(object).filter(|_| index >= 0x2000).and_then(repeated_name) else {
        return;
    };
    let name = object.subs.get(second).map_or("", |entry| &entry.name);
    let message =
        say!("sub-indexes {} and {} are both called `{}`", sub_index(first), sub_index(second), name);
    let place = |sub| Place::entry(index, sub).field(Field::ParameterName);
    let finding = DUPLICATE_NAME.at(place(second), message).label(place(first), "first here");
    findings.push(finding.help("add a number or a word to the names"));
}

/// The first two sub-indexes with the same non-empty name.
fn repeated_name(object: &Object) -> Option<(u8, u8)> {
    /// Up to this many names, comparing pairs is faster than hashing.
    const FEW: usize = 10;
    let subs = &object.subs;
    if subs.len() <= FEW {
        return subs.iter().enumerate().find_map(|(at, (second, entry))| {
            let same = |other: &(u8, &Entry)| other.1.name == entry.name && !entry.name.is_empty();
            subs.iter().take(at).find(same).map(|(first, _)| (first, second))
        });
    }
    let mut seen: HashMap<&str, u8> = HashMap::with_capacity(subs.len());
    subs.iter().filter(|(_, entry)| !entry.name.is_empty()).find_map(|(second, entry)| {
        let first = *seen.entry(&entry.name).or_insert(second);
        (first != second).then_some((first, second))
    })
}

fn invalid_object_flags(at: &EntryAt<'_>, findings: &mut Findings) {
    let Some(flags) = at.entry.flags.filter(|flags| flags.0 > 7) else { return };
    let message = say!(
        "`{ObjFlags}` is {}, but only bits 0 to 2 are defined",
        Argument::value_of(Field::ObjFlags, format_args!("{:#x}", flags.0))
    );
    let finding = INVALID_OBJECT_FLAGS.at(at.field(Field::ObjFlags), message);
    let known = flags.0 & 7;
    findings.push(if known == 0 {
        let fix = Fix::risky(say!("remove {the key}")).remove(at.field(Field::ObjFlags));
        finding.help(say!("remove {the key}")).fix(fix)
    } else {
        let title = say!("write `{}`", Argument::setting(Field::ObjFlags, format_args!("{known:#x}")));
        let fix = Fix::risky(title.clone()).set(at.field(Field::ObjFlags), format!("{known:#x}"));
        finding.help(title).fix(fix)
    });
}

fn missing_key(device: &Device, at: &EntryAt<'_>, findings: &mut Findings) {
    match at.object_type() {
        Some(ObjectType::Var | ObjectType::DefType) => check_value_keys(device, at, "VAR", findings),
        Some(ObjectType::Domain | ObjectType::Null) => {}
        Some(_) if at.sub.is_some() => {}
        Some(object_type) if at.object.compact.is_some() => {
            check_value_keys(device, at, object_type.name(), findings);
        }
        Some(object_type) => check_sub_number(at, object_type, findings),
        None => check_object_type_key(at, findings),
    }
}

fn check_value_keys(device: &Device, at: &EntryAt<'_>, kind: &str, findings: &mut Findings) {
    let entry = at.entry;
    // in an XDD, a parameter may define the access
    let has_access = entry.access.is_some()
        || entry.parameter.as_ref().is_some_and(|parameter| parameter.access.is_some());
    if entry.data_type.is_some() && has_access {
        return;
    }
    // sub-index 0 describes the value of such a VAR
    if at.sub.is_none() && at.object.compact.is_none() && at.object.subs.get(0).is_some() {
        return;
    }
    let stated = [(Field::DataType, entry.data_type.is_some()), (Field::AccessType, has_access)];
    let missing: Vec<Field> = stated
        .into_iter()
        .filter(|(field, stated)| !stated && !stated::is_invalid(entry, field))
        .map(|(field, _)| field)
        .collect();
    let Some(first) = missing.first() else { return };
    let kind = match (at.sub, entry.object_type) {
        (Some(_), _) => "a sub-index".into(),
        (None, Some(ObjectType::DefType)) => "a DEFTYPE".into(),
        (None, _) if at.object.compact.is_some() => say!("an object with `{CompactSubObj}`"),
        _ if kind == "VAR" => "a VAR".into(),
        _ => say!("{}", kind),
    };
    let message = say!("{} needs {}", kind, listing(&missing));
    let mut finding = MISSING_KEY.at(at.field(first.clone()), message);
    let data_type = type_of_count(at).or_else(|| profile::data_type(device, at.index, at.sub));
    let access = profile::access(device, at.index, at.sub);
    if missing == [Field::DataType]
        && let Some(data_type) = data_type
    {
        let text = format!("0x{:04X}", data_type.0);
        let title = say!("write `{}`", Argument::setting(Field::DataType, &text));
        finding = finding.fix(Fix::safe(title).set(at.field(Field::DataType), text));
    }
    let is_known = |field: &Field| match field {
        Field::DataType => data_type.is_some(),
        _ => access.is_some(),
    };
    if missing.iter().all(is_known) {
        finding = finding.understood();
    }
    findings.push(finding.help(match missing.as_slice() {
        [Field::DataType] => say!("add `{DataType}` with the type of the value"),
        [Field::AccessType] => say!("add `{AccessType}`, such as `{AccessType=rw}`"),
        _ => {
            say!("add `{DataType}` with the type of the value, and `{AccessType}`, such as `{AccessType=rw}`")
        }
    }));
}

/// The type of sub-index 0 of a structure.
fn type_of_count(at: &EntryAt<'_>) -> Option<DataType> {
    let is_count = at.sub == Some(0) && stated::object_type(at.object).is_some_and(ObjectType::has_subs);
    DataType::of_sub_0(at.index).filter(|_| is_count)
}

fn check_sub_number(at: &EntryAt<'_>, object_type: ObjectType, findings: &mut Findings) {
    if at.object.sub_number.is_some() || stated::is_invalid(at.entry, &Field::SubNumber) {
        return;
    }
    let described = stated::described_subs(at.object);
    let article = if object_type == ObjectType::Array { "an" } else { "a" };
    let message = say!("{} {} needs `{SubNumber}`", article, object_type);
    let finding = MISSING_KEY.at(at.field(Field::SubNumber), message);
    findings.push(if described > 0 {
        let title = say!("add `{}`", Argument::setting(Field::SubNumber, described));
        let fix = Fix::safe(title.clone()).set(at.field(Field::SubNumber), described.to_string());
        finding.help(title).fix(fix)
    } else {
        finding.help(say!("describe the sub-indexes and write their number, or add `{CompactSubObj}`"))
    });
}

/// Reports a missing object type; another rule reports an invalid one.
fn check_object_type_key(at: &EntryAt<'_>, findings: &mut Findings) {
    let in_doubt = at.sub.is_none() && stated::is_structured(at.object);
    if !in_doubt || at.entry.object_type.is_some() || !at.entry.invalid_values.is_empty() {
        return;
    }
    let message =
        say!("an object with sub-indexes needs `{ObjectType}`; without `{ObjectType}` the object is a VAR");
    let finding = MISSING_KEY.at(at.field(Field::ObjectType), message);
    let fix = Fix::risky(say!("add `{ObjectType=0x9}`")).set(at.field(Field::ObjectType), "0x9");
    findings.push(
        finding.help(say!("add `{ObjectType=0x9}` for a RECORD, `{ObjectType=0x8}` for an ARRAY")).fix(fix),
    );
}

fn missing_name(at: &EntryAt<'_>, findings: &mut Findings) {
    if !at.entry.name.is_empty() {
        return;
    }
    let what = match at.sub {
        Some(sub) => say!("sub-index {} of {:04X}h", sub_index(sub), at.index),
        None => say!("{:04X}h", at.index),
    };
    let message = say!("{} has no name", what);
    let finding = MISSING_NAME.at(at.field(Field::ParameterName), message);
    findings.push(finding.help(say!("write `{ParameterName=}` and a name")));
}

fn unsupported_key(device: &Device, at: &EntryAt<'_>, findings: &mut Findings) {
    let Some(object_type) = at.object_type() else { return };
    let keys = match object_type {
        ObjectType::Var | ObjectType::DefType if at.sub.is_some() => return,
        ObjectType::Var | ObjectType::DefType => keys_of_structure(at),
        ObjectType::Domain => keys_of_structure(at).into_iter().chain(keys_of_number(at)).collect(),
        ObjectType::Null => return,
        _ if at.sub.is_some() || at.object.compact.is_some() => return,
        _ => keys_of_value(device, at),
    };
    let Some(first) = keys.first() else { return };
    let article = if object_type == ObjectType::Array { "an" } else { "a" };
    let message = say!("{} {} does not support {}", article, object_type, listing_or(&keys));
    let title = if keys.len() == 1 { say!("remove {the key}") } else { say!("remove {the keys}") };
    // keys that describe a value may be intended
    let fix = if keys == [Field::SubNumber] { Fix::safe(title) } else { Fix::risky(title) };
    let fix = keys.iter().fold(fix, |fix, field| fix.remove(at.field(field.clone())));
    let compact = keys.contains(&Field::CompactSubObj);
    let finding = UNSUPPORTED_KEY.at(at.field(first.clone()), message).severity(if compact {
        Severity::Error
    } else {
        Severity::Warning
    });
    let finding = finding.fix(fix);
    findings.push(if object_type.has_subs() {
        finding.help(match keys.len() {
            1 => say!("remove {the key}, or move it to the sub-indexes"),
            _ => say!("remove {the keys}, or move them to the sub-indexes"),
        })
    } else {
        finding.help(say!("remove {the key}, or correct `{ObjectType}`"))
    });
}

/// The keys that count sub-indexes. Another rule reports described sub-indexes.
fn keys_of_structure(at: &EntryAt<'_>) -> Vec<Field> {
    let object = at.object;
    let mut keys = Vec::new();
    if at.sub.is_some() || stated::described_subs(object) > usize::from(object.subs.get(0).is_some()) {
        return keys;
    }
    if object.sub_number.is_some_and(|number| number > 0) {
        keys.push(Field::SubNumber);
    }
    if object.compact.is_some() {
        keys.push(Field::CompactSubObj);
    }
    keys
}

fn keys_of_number(at: &EntryAt<'_>) -> Vec<Field> {
    let entry = at.entry;
    let stated = [
        (Field::PdoMapping, entry.is_mappable()),
        (Field::LowLimit, entry.low_limit.is_some()),
        (Field::HighLimit, entry.high_limit.is_some()),
    ];
    stated.into_iter().filter(|(_, stated)| *stated).map(|(field, _)| field).collect()
}

fn keys_of_value(device: &Device, at: &EntryAt<'_>) -> Vec<Field> {
    let entry = at.entry;
    // CiA 311 allows both attributes for every object type
    let is_eds = device.headers.network.is_none();
    let stated = [
        (Field::DataType, is_eds && entry.data_type.is_some()),
        (Field::AccessType, is_eds && entry.access.is_some()),
        (Field::DefaultValue, entry.default.is_some()),
        (Field::ParameterValue, entry.configured_value().is_some()),
    ];
    let mut keys: Vec<Field> =
        stated.into_iter().filter(|(_, stated)| *stated).map(|(field, _)| field).collect();
    keys.extend(keys_of_number(at));
    keys
}
