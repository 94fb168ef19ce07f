//! Profiles as tables.

use std::io::{self, Write};
use std::ops::RangeInclusive;

use crate::table::TextTable;
use objdict_model::diagnostic::plural;
use objdict_profile::{EntryFacts, Mapping, Need, ObjectFacts, Profile, Values};

/// The most characters that a cell of a large table shows; the page of one object shows all.
const CELL: usize = 44;

/// The most characters of a text on the page of one object.
const LINE: usize = 4000;

/// The documents, a line each.
pub(super) fn list<'a>(profiles: impl Iterator<Item = &'a Profile>, out: &mut dyn Write) -> io::Result<()> {
    let mut table = TextTable::new(["Profile", "Version", "Objects", "About"], usize::MAX);
    for profile in profiles {
        table.row([
            profile.document_number().to_owned(),
            profile.version.as_deref().unwrap_or_default().to_owned(),
            profile.objects().len().to_string(),
            profile.title.to_string(),
        ]);
    }
    table.write(out)
}

/// The objects of a profile, a line each.
pub(super) fn profile(profile: &Profile, out: &mut dyn Write) -> io::Result<()> {
    let version = profile.version.as_ref().map(|version| format!(" version {version}")).unwrap_or_default();
    writeln!(out, "{}{version}: {}", profile.document, profile.title)?;
    let objects = plural(profile.objects().len(), "object");
    match (profile.number, profile.repeats) {
        (None, _) => writeln!(out, "{objects}, for devices of any profile\n")?,
        (Some(number), true) => writeln!(
            out,
            "{objects}, for devices of profile {number}; further logical devices have theirs 800h apart\n"
        )?,
        (Some(number), false) => writeln!(out, "{objects}, for devices of profile {number}\n")?,
    }
    let headings = ["Index", "Name", "Object", "Type", "Need", "Access", "PDO", "Values", "Default"];
    let mut table = TextTable::new(headings, CELL);
    for facts in profile.objects() {
        let [data_type, access, mapping, values, default] = shared_cells(&facts);
        let object_type = facts.object_types.first().map(ToString::to_string).unwrap_or_default();
        let name = facts.name.to_owned();
        let need = need(facts.need);
        table.row([range(&facts), name, object_type, data_type, need, access, mapping, values, default]);
    }
    table.write(out)
}

/// One object with all that is known of it.
pub(super) fn object(profile: &Profile, facts: &ObjectFacts<'_>, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "{}  {} ({})\n", range(facts), facts.name, profile.document)?;
    if let Some(about) = facts.about {
        writeln!(out, "{about}\n")?;
    }
    let mut lines = TextTable::new(["", ""], LINE);
    let mut line = |name: &str, text: String| {
        if !text.is_empty() {
            lines.row([format!("  {name}"), text]);
        }
    };
    line(
        "object type",
        match facts.object_types {
            [required, others @ ..] if !others.is_empty() => {
                format!("{required}; {} is a warning", all(others))
            }
            types => all(types),
        },
    );
    line("need", if facts.need == Need::Optional { "optional".to_owned() } else { need(facts.need) });
    line("only", facts.only.map(ToString::to_string).unwrap_or_default());
    let as_many_as: Vec<String> = facts.as_many_as.iter().map(|index| format!("0x{index:04X}")).collect();
    line("as many as", as_many_as.join(", "));
    let value = facts.entries().next().filter(|entry| facts.entries().len() == 1 && entry.name.is_empty());
    if let Some(entry) = &value {
        let [data_type, access, mapping, values, default] = entry_cells(entry);
        for (name, text) in [
            ("data type", data_type),
            ("access", access),
            ("PDO mapping", mapping),
            ("values", values),
            ("default", default),
        ] {
            line(name, text);
        }
    }
    line("source", facts.source.unwrap_or_default().to_owned());
    lines.write(out)?;
    if value.is_none() && facts.entries().len() > 0 {
        writeln!(out)?;
        entries(facts, out)?;
    }
    bits(facts, out)
}

fn entries(facts: &ObjectFacts<'_>, out: &mut dyn Write) -> io::Result<()> {
    let headings = ["Sub", "Name", "Type", "Need", "Access", "PDO", "Values", "Default"];
    let mut table = TextTable::new(headings, LINE);
    for entry in facts.entries() {
        let [data_type, access, mapping, values, default] = entry_cells(&entry);
        let (name, need) = (entry.name.to_owned(), need(entry.need));
        table.row([subs(&entry), name, data_type, need, access, mapping, values, default]);
    }
    table.write(out)
}

fn bits(facts: &ObjectFacts<'_>, out: &mut dyn Write) -> io::Result<()> {
    let mut table = TextTable::new(["Sub", "Bits", "Name", "Value", "Meaning"], LINE);
    let mut any = false;
    for entry in facts.entries() {
        let mut sub = if facts.entries().len() > 1 { subs(&entry) } else { String::new() };
        for field in entry.bits() {
            any = true;
            let bits = span(&(field.first..=field.last));
            let mut names = [std::mem::take(&mut sub), bits, field.name.to_owned()];
            for (values, meaning) in field.masked() {
                let [sub, bits, name] = std::mem::take(&mut names);
                let values = match values {
                    Values::Mask(mask) => mask,
                    Values::Range(values) => span(&values),
                };
                table.row([sub, bits, name, values, meaning.to_owned()]);
            }
            if field.meanings().len() == 0 {
                let [sub, bits, name] = names;
                table.row([sub, bits, name, String::new(), String::new()]);
            }
        }
    }
    if any {
        writeln!(out)?;
        table.write(out)?;
    }
    Ok(())
}

/// Type, access, mapping, values and default of an object's value, or of its sub-indexes but 0 where they are alike.
fn shared_cells(facts: &ObjectFacts<'_>) -> [String; 5] {
    let is_single = facts.entries().len() == 1;
    let entries = facts.entries().filter(|entry| is_single || entry.first > 0);
    let mut cells = entries.map(|entry| entry_cells(&entry));
    let first = cells.next().unwrap_or_default();
    cells.fold(first, |shared, cells| {
        let mut cells = cells.into_iter();
        shared.map(|shared| cells.next().filter(|cell| *cell == shared).unwrap_or_default())
    })
}

fn entry_cells(entry: &EntryFacts<'_>) -> [String; 5] {
    let mapping = match entry.mapping {
        None => "",
        Some(Mapping::No) => "no",
        Some(Mapping::Tpdo) => "TPDO",
        Some(Mapping::Rpdo) => "RPDO",
        Some(Mapping::Any) => "yes",
    };
    let values: Vec<String> = entry.values.iter().map(span).collect();
    [
        all(entry.data_types),
        all(entry.access),
        mapping.to_owned(),
        values.join(", "),
        entry.default.map(ToString::to_string).unwrap_or_default(),
    ]
}

/// What a document accepts, the right one first.
fn all<T: ToString>(items: &[T]) -> String {
    let items: Vec<String> = items.iter().map(ToString::to_string).collect();
    items.join(" or ")
}

fn need(need: Need<'_>) -> String {
    match need {
        Need::Optional => String::new(),
        Need::Mandatory => "mandatory".to_owned(),
        Need::When(condition) => format!("if {condition}"),
    }
}

fn range(facts: &ObjectFacts<'_>) -> String {
    match (facts.first, facts.last) {
        (first, last) if first == last => format!("0x{first:04X}"),
        (first, last) => format!("0x{first:04X}..0x{last:04X}"),
    }
}

fn subs(entry: &EntryFacts<'_>) -> String {
    match (entry.first, entry.last) {
        (first, last) if first == last => format!("{first:X}"),
        (first, last) => format!("{first:X}..{last:X}"),
    }
}

fn span<T: PartialEq + std::fmt::Display>(range: &RangeInclusive<T>) -> String {
    match (range.start(), range.end()) {
        (first, last) if first == last => first.to_string(),
        (first, last) => format!("{first}..{last}"),
    }
}
