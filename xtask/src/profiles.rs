//! The documents of `crates/objdict-profile/data` as constants in Rust, so that no TOML is read to check a device.

use std::collections::BTreeMap;
use std::fmt::{Debug, Write};
use std::fs;
use std::path::Path;

use objdict::profile::Profile;
use objdict::profile::tables::{BitRow, CommandRow, EntryRow, MeaningRow, ObjectRow, SubList, TransitionRow};

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../crates/objdict-profile");

/// Writes the constants, or with `check_only` says which are not what the documents say.
pub(crate) fn run(check_only: bool) -> Result<(), String> {
    let data = Path::new(FOLDER).join("data");
    let files = fs::read_dir(&data).map_err(|error| format!("cannot read {}: {error}", data.display()))?;
    let mut files: Vec<_> = files.filter_map(|file| Some(file.ok()?.path())).collect();
    files.sort();
    let mut groups = Vec::new();
    for file in &files {
        let group = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let text = fs::read_to_string(file).map_err(|error| format!("{}: {error}", file.display()))?;
        let profile = Profile::from_toml(&text).map_err(|error| format!("{}: {error}", file.display()))?;
        save(&group, &constants(&group, &profile), check_only)?;
        groups.push(group);
    }
    save("mod", &list(&groups), check_only)
}

fn save(name: &str, text: &str, check_only: bool) -> Result<(), String> {
    let path = Path::new(FOLDER).join(format!("src/constants/{name}.rs"));
    if fs::read_to_string(&path).is_ok_and(|before| before == text) {
        return Ok(());
    }
    if check_only {
        return Err(format!("constants/{name}.rs is stale: run `cargo xtask profiles`"));
    }
    fs::write(&path, text).map_err(|error| format!("cannot write {}: {error}", path.display()))
}

/// The module that lists the documents: without the feature `catalogue` there is only the first.
fn list(groups: &[String]) -> String {
    let lines = |indent: &str, line: &dyn Fn(&str) -> String| -> String {
        let feature = format!("{indent}#[cfg(feature = \"catalogue\")]\n");
        let features = std::iter::once("").chain(std::iter::repeat(&*feature));
        groups
            .iter()
            .zip(features)
            .map(|(group, feature)| format!("{feature}{indent}{}\n", line(group)))
            .collect()
    };
    let modules = lines("", &|group| format!("#[rustfmt::skip]\nmod {group};"));
    let rows = lines("    ", &|group| format!("({}, &{group}::PROFILE),", group.trim_start_matches("cia")));
    format!(
        "//! The built-in documents, generated from `data` by `cargo xtask profiles`. If the table format changes, xtask\n\
         //! does not build with the old tables: remove them from this list for that run.\n\n\
         {modules}\nuse super::Profile;\n\n\
         /// The documents in ascending order of their numbers.\n\
         pub(super) static DOCUMENTS: &[(u16, &Profile)] = &[\n{rows}];\n"
    )
}

/// A document as Rust: what the rows derive from `Debug` is how they are written.
fn constants(group: &str, profile: &Profile) -> String {
    let mut text = format!(
        "// Generated from `data/{group}.toml` by `cargo xtask profiles`: edit that file.\n\n\
         #![allow(unused_imports, reason = \"not every document has facts of every kind\")]\n\n\
         use std::borrow::Cow;\n\n\
         use crate::model::{{Access, Access::*, DataType, ObjectType, ObjectType::*, Value, Value::*}};\n\
         use crate::tables::{{NeedRow::*, Term::*, *}};\n\
         use crate::{{Condition, Confidence::*, Mapping::*, Profile}};\n\n\
         pub(super) static PROFILE: Profile = Profile {{\n    group: {group:?},\n    \
         document: Cow::Borrowed({:?}),\n    title: Cow::Borrowed({:?}),\n",
        profile.document, profile.title
    );
    let _ = match &profile.version {
        Some(version) => writeln!(text, "    version: Some(Cow::Borrowed({version:?})),"),
        None => writeln!(text, "    version: None,"),
    };
    let _ = writeln!(text, "    number: {:?},\n    repeats: {},", profile.number, profile.repeats);
    text += "    tables: Tables {\n";
    for field in [
        "objects",
        "entries",
        "bits",
        "meanings",
        "conditions",
        "object_types",
        "data_types",
        "access",
        "values",
        "defaults",
        "indexes",
        "commands",
        "transitions",
        "texts",
    ] {
        let _ = writeln!(text, "        {field}: Cow::Borrowed({}),", field.to_uppercase());
    }
    let _ = writeln!(
        text,
        "        errors: {:?},\n        machine: {:?},",
        profile.tables.errors, profile.tables.machine
    );
    text += "    },\n};\n";
    let tables = &profile.tables;
    let name = |part: SubList| part.of_text(&tables.texts).to_owned();
    let object = |row: &ObjectRow| format!("{:04X}h {}", row.first, name(row.name));
    rows(&mut text, "OBJECTS: &[ObjectRow]", &tables.objects, object);
    rows(&mut text, "ENTRIES: &[EntryRow]", &tables.entries, |row: &EntryRow| name(row.name));
    rows(&mut text, "BITS: &[BitRow]", &tables.bits, |row: &BitRow| name(row.name));
    rows(&mut text, "MEANINGS: &[MeaningRow]", &tables.meanings, |row: &MeaningRow| name(row.text));
    rows(&mut text, "COMMANDS: &[CommandRow]", &tables.commands, |row: &CommandRow| name(row.name));
    rows(&mut text, "TRANSITIONS: &[TransitionRow]", &tables.transitions, |row: &TransitionRow| name(row.to));
    text += "\nstatic CONDITIONS: &[Condition] = &[\n";
    for condition in &*tables.conditions {
        let (shown, terms) = (condition.to_string(), condition.terms());
        let _ = writeln!(text, "    Condition::constant({shown:?}, &{terms:?}),");
    }
    text += "];\n";
    line(&mut text, "OBJECT_TYPES: &[ObjectType]", &tables.object_types);
    line(&mut text, "DATA_TYPES: &[DataType]", &tables.data_types);
    line(&mut text, "ACCESS: &[Access]", &tables.access);
    line(&mut text, "VALUES: &[std::ops::RangeInclusive<i128>]", &tables.values);
    line(&mut text, "DEFAULTS: &[Value]", &tables.defaults);
    line(&mut text, "INDEXES: &[u16]", &tables.indexes);
    texts(&mut text, profile);
    text
}

/// A table with a row a line, and what the row is about behind it. The fields are named once, in front of them.
fn rows<T: Debug>(text: &mut String, head: &str, rows: &[T], about: impl Fn(&T) -> String) {
    let Some(first) = rows.first().map(|row| format!("{row:?}")) else {
        return line(text, head, rows);
    };
    let (row, fields) = fields_of(&first);
    let names: Vec<String> = fields.into_iter().map(|(name, _)| name).collect();
    let _ = writeln!(text, "\nstatic {head} = table!({row} {{ {} }}:", names.join(", "));
    for row in rows {
        let values: Vec<String> =
            fields_of(&format!("{row:?}")).1.into_iter().map(|(_, value)| value).collect();
        let line = format!("({}) // {}", values.join(", "), about(row));
        let _ = writeln!(text, "    {}", line.trim_end_matches([' ', '/']));
    }
    text.push_str(");\n");
}

/// The name and the fields of a row, as `Debug` writes them.
fn fields_of(row: &str) -> (&str, Vec<(String, String)>) {
    let (name, fields) = row.trim_end_matches(" }").split_once(" { ").unwrap_or((row, ""));
    let mut named: Vec<(String, String)> = Vec::new();
    for part in fields.split(", ") {
        match (part.split_once(": "), named.last_mut()) {
            (Some((field, value)), _) => named.push((field.to_owned(), value.to_owned())),
            (None, Some((_, value))) => *value += &format!(", {part}"),
            (None, None) => {}
        }
    }
    (name, named)
}

/// A table of small items.
fn line<T: Debug>(text: &mut String, head: &str, items: &[T]) {
    let _ = writeln!(text, "\nstatic {head} = &{items:?};");
}

/// The texts, some a line.
fn texts(text: &mut String, profile: &Profile) {
    let tables = &profile.tables;
    let objects = tables.objects.iter().flat_map(|row| [row.name, row.source, row.about]);
    let others = tables
        .entries
        .iter()
        .flat_map(|row| [row.name, row.unit])
        .chain(tables.bits.iter().map(|row| row.name));
    let parts = objects.chain(others).chain(tables.meanings.iter().map(|row| row.text));
    let parts = parts.chain(tables.commands.iter().flat_map(|row| [row.name, row.mask]));
    let parts = parts.chain(tables.transitions.iter().flat_map(|row| [row.from, row.to, row.by]));
    let parts: BTreeMap<u32, SubList> = parts.filter(|part| part.1 > 0).map(|part| (part.0, part)).collect();
    text.push_str("\nstatic TEXTS: &str = concat!(");
    let mut width = usize::MAX;
    for part in parts.into_values() {
        let literal = format!(" {:?},", part.of_text(&tables.texts));
        width = width.saturating_add(literal.len());
        if width > 110 {
            text.push_str("\n   ");
            width = literal.len();
        }
        text.push_str(&literal);
    }
    text.push_str("\n);\n");
}
