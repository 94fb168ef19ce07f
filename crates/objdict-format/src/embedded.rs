//! Content that a format does not support, embedded where every format has space: comment lines in an EDS or DCF,
//! properties of parameters and characteristics of the device in an XDD or XDC (docs/reference/formats.md).
//!
//! Embedded content is exactly the difference between a device and the result of reading it back. Each item states
//! the expected value at its place, so that later edits are not undone.

use crate::compare::{Datum, DatumChange, apply};
use objdict_model::diagnostic::{Diagnostic, Findings, say, text_rules};
use objdict_model::model::{
    Characteristic, CharacteristicsList, Device, DeviceFunction, EMBEDDED_COMMENT, EMBEDDED_SECTION, Entry,
    Extra, ExtraSection, Field, Labels, Object, Part, Place, Property,
};
use objdict_model::source::{Edits, Span};

/// The prefix of the path in the name of a property.
const PREFIX: &str = "objdict:";

/// The longest line with its line end: shorter than 255 characters (CiA 306-1 §4.2).
const MAX_LINE: usize = 250;

/// The minimum length of a value after a long path.
const MIN_VALUE: usize = 60;

/// The storage for embedded content in a format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Carrier {
    /// In a section with a key for each item, written as comment lines in an EDS.
    Lines,
    /// In properties of parameters, and in characteristics for content outside objects.
    Properties,
}

text_rules! {
    "objdict/stale-embedded-data" = STALE_EMBEDDED_DATA, Note;
    summary: "embedded data belong to a part that has changed since",
    checks: "A conversion embeds data in comment lines `; objdict-embed: …` or in properties `objdict:…`. These data must still belong to the file: each item identifies the value that it replaces.",
    why: "A conversion uses such items for content that the format cannot represent. If a tool changes the part that an item belongs to, the item is ignored so that the change is not undone; converting back does not restore the old value.",
    example: "`/objects/0x2000/subs=nothing instead of 1a2b3c4d` after a sub-index of 2000h was edited",
    remedy: "Remove the item, or convert the file again.",
    source: "objdict, docs/reference/formats.md",
}

/// Restores embedded content in a device. Items that no longer match the device are kept and reported.
pub(super) fn restore(mut device: Device, mut findings: Findings) -> (Device, Findings) {
    let changes = extract(&mut device);
    for change in put_back(&mut device, changes) {
        let message = say!("the embedded `{}` belongs to a part that has changed since", change.path);
        let place = Place::of(Part::Section(EMBEDDED_SECTION.into()))
            .field(Field::Named(change.path.as_str().into()));
        let finding = Diagnostic::new(&STALE_EMBEDDED_DATA, place, message);
        findings.push(finding.help("remove the item, or convert the file again"));
    }
    (device, findings)
}

/// Applies [extracted](extract) changes to a device. Changes that no longer match are kept in it, and returned.
pub(super) fn put_back(device: &mut Device, changes: Vec<DatumChange>) -> Vec<DatumChange> {
    let refused = if changes.is_empty() { changes } else { apply(device, changes) };
    if !refused.is_empty() {
        embed(device, &refused, Carrier::Lines);
    }
    refused
}

/// Embeds changes in a device, where the format has space.
pub(super) fn embed(device: &mut Device, changes: &[DatumChange], room: Carrier) {
    match room {
        Carrier::Lines => {
            let mut entries = Extra::default();
            changes.iter().flat_map(lines).for_each(|(key, piece)| entries.push(&key, &piece));
            device.extra.push(ExtraSection::new(EMBEDDED_SECTION, &entries));
        }
        Carrier::Properties => {
            let mut characteristics = Vec::new();
            for change in changes {
                match entry_of(device, &change.path) {
                    Some(entry) => {
                        let (name, value) = (format!("{PREFIX}{}", change.path), print(change));
                        let property = Property { name: name.into(), value: value.into() };
                        entry.parameter_mut().properties.push(property);
                    }
                    None => characteristics.push(Characteristic {
                        name: Labels::name("en", &change.path),
                        contents: vec![Labels::name("en", &print(change))],
                    }),
                }
            }
            if !characteristics.is_empty() {
                let list =
                    CharacteristicsList { category: Labels::name("en", EMBEDDED_SECTION), characteristics };
                if device.functions.is_empty() {
                    device.functions.push(DeviceFunction::default());
                }
                device.functions[0].characteristics.push(list);
            }
        }
    }
}

/// The keys and values of the lines of a change.
fn lines(change: &DatumChange) -> Vec<(String, String)> {
    let pieces = pieces(&print(change), room_behind(&change.path)).into_iter().enumerate();
    let line = |(number, piece)| match number {
        0 => (change.path.clone(), piece),
        number => (format!("{}#{number}", change.path), piece),
    };
    pieces.map(line).collect()
}

/// The edits that set or remove the value at a path in the comment lines of an EDS or DCF.
pub(super) fn edit_lines(edits: &mut Edits<'_>, path: &str, datum: Option<Datum>) {
    remove_lines(edits, |key| key == path);
    if let Some(after) = datum {
        add_lines(edits, &[DatumChange { path: path.to_owned(), before: None, after: Some(after) }]);
    }
}

/// The edits that remove the comment lines of an EDS or DCF with data of these paths.
pub(super) fn remove_lines(edits: &mut Edits<'_>, is_removed: impl Fn(&str) -> bool) {
    let text = edits.source().text();
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        let key = line.trim_start().strip_prefix(';').and_then(|line| line.strip_prefix(EMBEDDED_COMMENT));
        let key = key.and_then(|line| line.split('=').next()).and_then(|key| key.split('#').next());
        let end = start + line.len();
        if key.is_some_and(|key| is_removed(key.trim())) {
            edits.replace(Span::new(start as u32, end as u32), "");
        }
        start = end;
    }
}

/// The edits that add changes as comment lines at the end of an EDS or DCF.
pub(super) fn add_lines(edits: &mut Edits<'_>, changes: &[DatumChange]) {
    let text = edits.source().text();
    let line_end = if text.contains("\r\n") { "\r\n" } else { "\n" };
    let mut added = if text.is_empty() || text.ends_with('\n') { String::new() } else { line_end.to_owned() };
    for (key, piece) in changes.iter().flat_map(lines) {
        added.push_str(&format!(";{EMBEDDED_COMMENT}{key}={piece}{line_end}"));
    }
    edits.replace(Span::empty(text.len() as u32), added);
}

/// Extracts embedded changes from a device. Unreadable ones are kept.
pub(super) fn extract(device: &mut Device) -> Vec<DatumChange> {
    let mut changes = Vec::new();
    device.extra.retain(|section| {
        let ours = section.name() == EMBEDDED_SECTION;
        !(ours && from_section(section.entries()).map(|found| changes.extend(found)).is_some())
    });
    for function in &mut device.functions {
        function.characteristics.retain(|list| {
            let ours = list.category.names().any(|(_, name)| name == EMBEDDED_SECTION);
            !(ours && from_characteristics(list).map(|found| changes.extend(found)).is_some())
        });
    }
    // the one created as their container
    device.functions.retain(|function| changes.is_empty() || *function != DeviceFunction::default());
    let has_property = |entry: &Entry| {
        let mut properties = entry.parameter.iter().flat_map(|parameter| &parameter.properties);
        properties.any(|property| property.name.starts_with(PREFIX))
    };
    let has_any = |object: &Object| {
        has_property(&object.main) || object.subs.iter().any(|(_, entry)| has_property(entry))
    };
    let carriers = device.objects.iter().filter(|(_, object)| has_any(object)).map(|(index, _)| *index);
    for index in carriers.collect::<Vec<_>>() {
        let Some(object) = device.objects.get_mut(&index) else { continue };
        from_properties(&mut object.main, (index, None), &mut changes);
        for (sub, entry) in object.subs.iter_mut() {
            from_properties(entry, (index, Some(sub)), &mut changes);
        }
    }
    changes
}

fn from_section<'a>(entries: impl Iterator<Item = (&'a str, &'a str)>) -> Option<Vec<DatumChange>> {
    let mut texts: Vec<(&str, String)> = Vec::new();
    for (key, value) in entries {
        match (key.rsplit_once('#'), texts.last_mut()) {
            (Some((path, number)), Some((last, text))) if *last == path && number.parse::<u32>().is_ok() => {
                text.push_str(value);
            }
            _ => texts.push((key, value.to_owned())),
        }
    }
    texts.iter().map(|(path, text)| parse(path, text)).collect()
}

fn from_characteristics(list: &CharacteristicsList) -> Option<Vec<DatumChange>> {
    fn only(labels: &Labels) -> Option<&str> {
        labels.names().next().map(|(_, name)| name)
    }
    let changes = list.characteristics.iter().map(|characteristic| {
        let [content] = characteristic.contents.as_slice() else { return None };
        parse(only(&characteristic.name)?, only(content)?)
    });
    changes.collect()
}

fn from_properties(entry: &mut Entry, (index, sub): (u16, Option<u8>), changes: &mut Vec<DatumChange>) {
    let Some(parameter) = &mut entry.parameter else { return };
    let before = changes.len();
    parameter.properties.retain(|property| {
        let path = property.name.strip_prefix(PREFIX);
        let change = path.and_then(|path| parse(path, &property.value));
        let stays = change.is_none();
        changes.extend(change);
        stays
    });
    if changes.len() > before && parameter.is_implied(index, sub) {
        entry.parameter = None;
    }
}

/// The entry that a path refers to.
fn entry_of<'a>(device: &'a mut Device, path: &str) -> Option<&'a mut Entry> {
    let number = |text: &str| u16::from_str_radix(text.strip_prefix("0x")?, 16).ok();
    let mut steps = path.strip_prefix("/objects/")?.split('/');
    let object = device.objects.get_mut(&number(steps.next()?)?)?;
    let sub = match (steps.next(), steps.next()) {
        (Some("subs"), Some(sub)) => number(sub).and_then(|sub| u8::try_from(sub).ok()),
        _ => None,
    };
    match sub {
        Some(sub) if object.subs.get(sub).is_some() => object.subs.get_mut(sub),
        _ => Some(&mut object.main),
    }
}

/// The string for a change: the value as ISO 646 JSON, `instead of` the fingerprint of the old value.
fn print(change: &DatumChange) -> String {
    let mut text = change.after.as_ref().map_or("nothing".to_owned(), |after| ascii(after.text()));
    if let Some(before) = change.before {
        text.push_str(&format!(" instead of {before:08x}"));
    }
    text
}

/// Parses a change; `None` if it is not one.
fn parse(path: &str, text: &str) -> Option<DatumChange> {
    if !path.starts_with('/') {
        return None;
    }
    let (after, rest) = match text.strip_prefix("nothing") {
        Some(rest) => (None, rest),
        None => {
            let (value, rest) = Datum::prefix(text)?;
            (Some(value), rest)
        }
    };
    let before = match rest {
        "" => None,
        rest => Some(u32::from_str_radix(rest.strip_prefix(" instead of ")?, 16).ok()?),
    };
    Some(DatumChange { path: path.to_owned(), before, after })
}

/// JSON in printable characters of ISO 646.
fn ascii(json: &str) -> String {
    let mut text = String::with_capacity(json.len());
    for c in json.chars() {
        if matches!(c, ' '..='~') {
            text.push(c);
        } else {
            for unit in c.encode_utf16(&mut [0; 2]) {
                text.push_str(&format!("\\u{unit:04x}"));
            }
        }
    }
    text
}

/// The maximum length of a value after its path, with the number of the piece, escaped spaces, and
/// ` instead of 01234567`.
const fn room_behind(path: &str) -> usize {
    let taken =
        EMBEDDED_COMMENT.len() + path.len() + ";#000=".len() + "\\u0020\\u0020 instead of 01234567\r\n".len();
    let room = MAX_LINE.saturating_sub(taken);
    if room < MIN_VALUE { MIN_VALUE } else { room }
}

/// Splits a text into pieces that fit on a line. A trailing space would be lost, so it is written as a JSON escape; it
/// is always inside quotes or in ` instead of `, which is never split.
fn pieces(text: &str, room: usize) -> Vec<String> {
    let (json, suffix) = match text.rfind(" instead of ") {
        Some(at) if text.len() - at == " instead of 01234567".len() => text.split_at(at),
        _ => (text, ""),
    };
    let mut pieces = Vec::new();
    let mut rest = json;
    while rest.len() > room {
        // an escape such as `\u00e4` is never split: pieces are joined before they are parsed, and some
        // INI readers join a line that ends with a backslash to the next one
        let is_escape = |at: &usize| rest.as_bytes()[at - 1] == b'\\';
        let end = (1..=room).rev().find(|at| !is_escape(at)).unwrap_or(room);
        let (piece, behind) = rest.split_at(end);
        pieces.push(piece.to_owned());
        rest = behind;
    }
    pieces.push(rest.to_owned());
    for piece in &mut pieces {
        if let Some(inner) = piece.strip_prefix(' ') {
            *piece = format!("\\u0020{inner}");
        }
        if let Some(inner) = piece.strip_suffix(' ') {
            *piece = format!("{inner}\\u0020");
        }
    }
    if let Some(last) = pieces.last_mut() {
        last.push_str(suffix);
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::{Value, json};

    fn change(path: &str, before: Option<u32>, after: Option<Value>) -> DatumChange {
        DatumChange { path: path.to_owned(), before, after: after.map(Datum::from) }
    }

    #[test]
    fn changes_survive_their_text() {
        let long = "wide   text, Übertemperatur \u{1F600} instead of 01234567 ".repeat(40);
        let changes = [
            change("/file_info/eds_version", None, Some(json!("4.0"))),
            change("/lists/mandatory", Some(0xDEAD_BEEF), Some(json!(["0x1000"]))),
            change("/objects/0x2000/subs", Some(7), None),
            change("/comments", None, Some(json!([long, " "]))),
        ];
        for room in [Carrier::Lines, Carrier::Properties] {
            let mut device = Device::default();
            embed(&mut device, &changes, room);
            assert_eq!(extract(&mut device), changes, "{room:?}");
            assert_eq!(device, Device::default(), "{room:?}");
        }
    }

    #[test]
    fn lines_stay_short_and_keep_their_blanks() {
        let value = change("/comments", None, Some(json!([" ".repeat(1000)])));
        let mut device = Device::default();
        embed(&mut device, std::slice::from_ref(&value), Carrier::Lines);
        for (key, value) in device.extra[0].entries() {
            let line = format!(";{EMBEDDED_COMMENT}{key}={value}\r\n");
            assert!(line.len() < 255 && value.trim() == value, "{line}");
        }
        assert_eq!(extract(&mut device), [value]);
    }

    #[test]
    fn what_is_not_ours_stays() {
        let mut entries = Extra::default();
        entries.push("/comments", "no JSON");
        let mut device =
            Device { extra: vec![ExtraSection::new(EMBEDDED_SECTION, &entries)], ..Device::default() };
        assert_eq!(extract(&mut device), []);
        assert_eq!(device.extra.len(), 1);
    }
}
