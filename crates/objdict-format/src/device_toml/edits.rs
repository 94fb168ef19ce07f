//! Edits of the text: changed values of existing keys, and added or removed keys.

use super::facts;
use super::keys::{DEVICE, FILE, NODE};
use super::places::{KeyPlaces, KeySpan, keys_of};
use super::words::{key, quoted, spelled, subs, type_word};
use crate::text::TextEdits;
use objdict_keyed::section::{Key, Shape};
use objdict_keyed::toml;
use objdict_model::diagnostic::{Change, Findings};
use objdict_model::literal;
use objdict_model::model::{Commissioning, DataType, Device, Entry, Field, ObjectType, Part, Place, Value};
use objdict_model::source::Span;

/// Creates edits of a text.
pub(super) struct TomlEditor<'a> {
    pub text: &'a str,
    pub places: &'a KeyPlaces,
}

impl TomlEditor<'_> {
    /// The edits for changes of a device; `None` if one cannot be expressed. The edited text may not be valid TOML;
    /// [`is_toml`](Self::is_toml) tests it.
    pub(super) fn edits(&self, device: &Device, changes: &[Change]) -> Option<TextEdits> {
        let mut edits = TextEdits::new();
        let each: Option<Vec<TextEdits>> = changes.iter().map(|change| self.change(device, change)).collect();
        for (span, new) in each?.concat() {
            match edits.iter_mut().find(|(known, _)| *known == span && span.start == span.end) {
                // keys added at one position are merged into one edit, because adjacent edits are rejected
                Some((_, before)) => before.push_str(&new),
                None => edits.push((span, new)),
            }
        }
        Some(edits)
    }

    /// The edits that convert a text to the description of a node in a file of this name.
    pub(super) fn to_node(&self, file_name: &str, node: &Commissioning) -> Option<TextEdits> {
        let node_path = ["node".to_owned()];
        let mut edits = self.remove(&node_path).unwrap_or_default();
        let mut block = format!("[node]\n{}\n\n", facts::lines(node, NODE, &[]).join("\n"));
        if self.places.at(&["file".to_owned()]).is_some() {
            edits.extend(self.set(&["file".to_owned()], "file-name", &quoted(file_name))?);
        } else {
            block = format!("[file]\nfile-name = {}\n\n{block}", quoted(file_name));
        }
        let at = self.places.at(&node_path).map(|spot| self.line(spot.key.start).start);
        edits.push((Span::empty(at.unwrap_or_else(|| self.first_table_of_objects())), block));
        self.is_toml(&edits).then_some(edits)
    }

    /// The edits that remove the configuration for a node.
    pub(super) fn to_type(&self, file_name: &str) -> Option<TextEdits> {
        let mut edits = self.remove(&["node".to_owned()]).unwrap_or_default();
        if self.places.at(&["file".to_owned(), "file-name".to_owned()]).is_some() {
            edits.extend(self.set(&["file".to_owned()], "file-name", &quoted(file_name))?);
        }
        let object = ["object".to_owned()];
        let is_configured = |rest: &[String]| {
            let names = ["value", "values", "denotation", "denotations", "upload-file", "download-file"];
            rest.last().is_some_and(|name| names.contains(&name.as_str())) && matches!(rest.len(), 2 | 4)
        };
        for (rest, _) in self.places.below(&object).filter(|(rest, _)| is_configured(rest)) {
            edits.extend(self.remove(&[object.as_slice(), rest].concat())?);
        }
        self.is_toml(&edits).then_some(edits)
    }

    /// Whether the edited text is valid TOML, and no edits overlap.
    pub(super) fn is_toml(&self, edits: &TextEdits) -> bool {
        let mut sorted: Vec<&(Span, String)> = edits.iter().collect();
        sorted.sort_by_key(|(span, _)| (span.start, span.end));
        let mut text = String::with_capacity(self.text.len());
        let mut end = 0;
        for (span, new) in sorted {
            let Some(before) = self.text.get(end..span.start as usize) else { return false };
            text.push_str(before);
            text.push_str(new);
            end = span.end as usize;
        }
        text.push_str(self.text.get(end..).unwrap_or_default());
        toml::read(&text, &mut Findings::new()).is_some()
    }

    /// The text without trailing spaces and repeated empty lines, except in multi-line strings.
    pub(super) fn arranged(&self) -> String {
        let long: Vec<Span> = self.places.long_values(self.text);
        let mut arranged = String::with_capacity(self.text.len());
        let (mut at, mut empty) = (0u32, true);
        for line in self.text.split_inclusive('\n') {
            let end = at + line.len() as u32;
            let is_within = long.iter().any(|span| span.start < end && at < span.end);
            let trimmed = line.trim_end();
            if is_within {
                arranged.push_str(line);
                empty = false;
            } else if !(trimmed.is_empty() && empty) {
                arranged.push_str(trimmed.trim_start());
                arranged.push('\n');
                empty = trimmed.is_empty();
            }
            at = end;
        }
        let length = arranged.trim_end().len();
        arranged.truncate(length);
        arranged.push('\n');
        arranged
    }

    fn change(&self, device: &Device, change: &Change) -> Option<TextEdits> {
        match change {
            Change::Replace(span, new) => Some(vec![(*span, new.clone())]),
            Change::Set(place, text) => {
                let field = place.field.as_ref()?;
                let (name, value) = stated(device, &place.part, field, text)?;
                self.set(&self.path(&place.part)?, &name, &value)
            }
            Change::Remove(Place { part, field: Some(field) }) => {
                let path = self.path(part)?;
                let mut keys = keys_of(part, field).into_iter().map(|key| [path.clone(), vec![key]].concat());
                self.remove(&keys.find(|path| self.places.at(path).is_some())?)
            }
            Change::Remove(Place { part, field: None }) => self.remove(&self.path(part)?),
            Change::Add(part, fields) => {
                let pairs: Option<Vec<String>> = fields
                    .iter()
                    .map(|(field, text)| {
                        let (name, value) = stated_of(added(fields), part, field, text)?;
                        Some(format!("{name} = {value}"))
                    })
                    .collect();
                let mut path = self.path(part)?;
                let name = path.pop()?;
                self.set(&path, &name, &format!("{{ {} }}", pairs?.join(", ")))
            }
            Change::Comment(span, text) => {
                let line = self.line(span.start);
                Some(vec![(Span::empty(line.start), format!("# {text}\n"))])
            }
            Change::RemoveLine(span) => Some(vec![(self.line(span.start), String::new())]),
            _ => None,
        }
    }

    /// The path of a part; `None` for a part in a range, which has no separate key.
    fn path(&self, part: &Part) -> Option<Vec<String>> {
        let path = self.places.path_of(part);
        let is_range = |key: &String| subs(key).is_some_and(|(first, last)| first != last);
        let has_keys = path.first().is_some_and(|first| first != "format" && first != "raw");
        (has_keys && !path.get(3).is_some_and(is_range)).then_some(path)
    }

    /// The line at a byte, with its end.
    fn line(&self, at: u32) -> Span {
        let at = at as usize;
        let start = self.text[..at].rfind('\n').map_or(0, |end| end + 1);
        let end = self.text[at..].find('\n').map_or(self.text.len(), |length| at + length + 1);
        Span::new(start as u32, end as u32)
    }

    /// The position for a table about the whole device: before the tables of its objects.
    fn first_table_of_objects(&self) -> u32 {
        const TABLES: [&str; 6] = ["[features", "[defaults", "[rpdo.", "[tpdo.", "[lists", "[object"];
        let mut at = 0;
        for line in self.text.split_inclusive('\n') {
            if TABLES.iter().any(|table| line.trim_start().starts_with(table)) {
                return at;
            }
            at += line.len() as u32;
        }
        at
    }

    /// Sets a key of a table, adding it if missing.
    fn set(&self, table: &[String], name: &str, value: &str) -> Option<TextEdits> {
        let path = [table, &[name.to_owned()]].concat();
        if let Some(spot) = self.places.at(&path) {
            return (!spot.is_table).then(|| vec![(spot.value, value.to_owned())]);
        }
        // the deepest existing table; dotted keys in braces have no line for a new one
        let at = |length: usize| self.places.at(&table[..length]);
        let has_braces = |spot: KeySpan| spot.value.of(self.text).starts_with('{');
        let known = (1..=table.len()).rev().find(|&length| at(length).is_some_and(has_braces));
        let known = known.or_else(|| (1..=table.len()).rev().find(|&length| at(length).is_some()));
        let rest = |length: usize| path[length..].iter().map(|name| key(name)).collect::<Vec<_>>().join(".");
        let Some(length) = known else {
            let header = table.iter().map(|name| key(name)).collect::<Vec<_>>().join(".");
            let block = format!("{}[{header}]\n{} = {value}\n", self.gap(), key(name));
            return Some(vec![(Span::empty(self.text.len() as u32), block)]);
        };
        let parent = &table[..length];
        let spot = self.places.at(parent)?;
        let line = format!("{} = {value}", rest(length));
        self.insert(parent, spot, &line)
    }

    fn gap(&self) -> &'static str {
        if self.text.is_empty() || self.text.ends_with("\n\n") {
            ""
        } else if self.text.ends_with('\n') {
            "\n"
        } else {
            "\n\n"
        }
    }

    /// Adds a key to a table, in the table's notation.
    fn insert(&self, table: &[String], spot: KeySpan, line: &str) -> Option<TextEdits> {
        let value = spot.value.of(self.text);
        if value.starts_with('{') && value.ends_with('}') {
            let inner = value[1..value.len() - 1].trim_end();
            let at = spot.value.start + 1 + inner.len() as u32;
            let text = if inner.trim().is_empty() { format!(" {line} ") } else { format!(", {line}") };
            return Some(vec![(Span::empty(at), text)]);
        }
        let key_line = self.line(spot.key.start);
        let is_header = key_line.of(self.text).trim_start().starts_with('[');
        let own = table.last().map(|name| key(name)).unwrap_or_default();
        // `[object.2000]` is the header of 2000, but only a name prefix for `object`
        let is_own_header = is_header
            && key_line
                .of(self.text)
                .split(']')
                .next()
                .is_some_and(|header| header.trim_end().ends_with(&own));
        if is_own_header {
            let text = if key_line.of(self.text).ends_with('\n') {
                format!("{line}\n")
            } else {
                format!("\n{line}\n")
            };
            return Some(vec![(Span::empty(key_line.end), text)]);
        }
        if is_header {
            let header = table.iter().map(|name| key(name)).collect::<Vec<_>>().join(".");
            let (name, value) = line.split_once(" = ")?;
            let (tables, name) = name
                .rsplit_once('.')
                .map_or((String::new(), name), |(tables, name)| (format!(".{tables}"), name));
            let block = format!("{}[{header}{tables}]\n{name} = {value}\n", self.gap());
            return Some(vec![(Span::empty(self.text.len() as u32), block)]);
        }
        // dotted keys: a line with the same prefix after the last of them
        let (rest, last) = self
            .places
            .below(table)
            .filter(|(rest, _)| rest.len() == 1)
            .max_by_key(|(_, spot)| spot.key.start)?;
        let start = self.line(last.key.start).start;
        let prefix = self.text.get(start as usize..last.key.start as usize)?.to_owned();
        let end = self.places.below(&[table, rest].concat()).map(|(_, spot)| spot.value.end).max();
        let end = self.line(end.unwrap_or(last.value.end).max(last.value.end)).end;
        let before = if self.text[..end as usize].ends_with('\n') { "" } else { "\n" };
        Some(vec![(Span::empty(end), format!("{before}{prefix}{line}\n"))])
    }

    /// Removes a key, including nested ones.
    fn remove(&self, path: &[String]) -> Option<TextEdits> {
        let spot = self.places.at(path)?;
        let line = self.line(spot.key.start);
        let text = line.of(self.text);
        if text.trim_start().starts_with('[') {
            // a table with its header, up to the next one
            let after = &self.text[line.end as usize..];
            let length = after.split_inclusive('\n').take_while(|line| !line.trim_start().starts_with('['));
            let length: usize = length.map(str::len).sum();
            return Some(vec![(Span::new(line.start, line.end + length as u32), String::new())]);
        }
        let is_table_of_lines = spot.is_table && !spot.value.of(self.text).starts_with('{');
        if is_table_of_lines {
            let mut lines: Vec<Span> = self
                .places
                .below(path)
                .filter(|(_, spot)| !spot.is_table || spot.value.of(self.text).starts_with('{'))
                .map(|(_, spot)| self.line(spot.key.start))
                .collect();
            lines.sort_by_key(|line| line.start);
            lines.dedup();
            return Some(lines.into_iter().map(|line| (line, String::new())).collect());
        }
        let mut within = (1..path.len()).rev().filter_map(|length| self.places.at(&path[..length]));
        let inline = within.find(|parent| {
            parent.is_table
                && parent.value.start < spot.key.start
                && spot.value.end <= parent.value.end
                && parent.value.of(self.text).starts_with('{')
        });
        match inline {
            None => Some(vec![(Span::new(line.start, self.line(spot.value.end).end), String::new())]),
            Some(_) => Some(vec![(self.with_comma(spot), String::new())]),
        }
    }

    /// A pair in braces with its separating comma.
    fn with_comma(&self, spot: KeySpan) -> Span {
        // the key may be dotted: its first word
        let before = self.text[..spot.key.start as usize].rfind([',', '{']).unwrap_or_default();
        let behind = &self.text[spot.value.end as usize..];
        let blanks = behind.len() - behind.trim_start().len();
        match (&self.text[before..=before], behind[blanks..].starts_with(',')) {
            (",", _) => Span::new(before as u32, spot.value.end),
            (_, true) => {
                let rest = &behind[blanks + 1..];
                let more = rest.len() - rest.trim_start().len();
                Span::new(spot.key.start, spot.value.end + (blanks + 1 + more) as u32)
            }
            _ => Span::new(before as u32 + 1, spot.value.end),
        }
    }
}

/// The key and the TOML value of a field with a CiA 306 string.
fn stated(device: &Device, part: &Part, field: &Field, text: &str) -> Option<(String, String)> {
    let data_type = match part {
        Part::Object(index) => device.object(*index).map(|object| &object.main).and_then(Entry::implied_type),
        Part::Entry(index, sub) => device.entry(*index, *sub).and_then(|entry| entry.implied_type()),
        Part::CompactValues(index) => device.object(*index).and_then(|object| object.main.data_type),
        _ => None,
    };
    stated_of(data_type, part, field, text)
}

/// The data type among the fields of an added part.
fn added(fields: &[(Field, String)]) -> Option<DataType> {
    let text = fields.iter().find(|(field, _)| *field == Field::DataType).map(|(_, text)| text)?;
    integer(text).and_then(|code| u16::try_from(code).ok()).map(DataType)
}

fn integer(text: &str) -> Option<i128> {
    literal::integer(text, i64::MIN, u64::MAX, &mut literal::Quirks::default()).ok()
}

/// Like `stated`, for a value of a data type.
pub(super) fn stated_of(
    data_type: Option<DataType>,
    part: &Part,
    field: &Field,
    text: &str,
) -> Option<(String, String)> {
    let table: Option<&[Key]> = match part {
        Part::FileInfo => Some(FILE),
        Part::DeviceInfo => Some(DEVICE),
        Part::Commissioning => Some(NODE),
        _ => None,
    };
    let name = keys_of(part, field).into_iter().next()?;
    if let Some(keys) = table {
        let known = keys.iter().find(|known| known.name == name)?;
        return Some((name, fact(known, text)?));
    }
    if matches!(part, Part::CompactNames(_) | Part::CompactDenotations(_)) {
        return Some((name, quoted(text)));
    }
    if matches!(part, Part::CompactValues(_)) {
        return Some((name, value(text, data_type)?));
    }
    let text = match field {
        Field::ParameterName | Field::Denotation | Field::UploadFile | Field::DownloadFile => quoted(text),
        Field::AccessType => quoted(&text.to_ascii_lowercase()),
        Field::PdoMapping => quoted(if integer(text)? == 0 { "no" } else { "optional" }),
        Field::ObjFlags | Field::SubNumber => integer(text)?.to_string(),
        Field::DataType => {
            return Some((
                "type".to_owned(),
                quoted(&type_word(DataType(u16::try_from(integer(text)?).ok()?))),
            ));
        }
        Field::ObjectType => {
            let code = ObjectType::from_code(u8::try_from(integer(text)?).ok()?)?;
            quoted(&code.name().to_ascii_lowercase())
        }
        Field::DefaultValue | Field::LowLimit | Field::HighLimit | Field::ParameterValue => {
            value(text, data_type)?
        }
        _ => return None,
    };
    Some((name, text))
}

fn value(text: &str, data_type: Option<DataType>) -> Option<String> {
    let value: Value = literal::value(text, data_type, &mut literal::Quirks::default()).ok()?;
    spelled(&value, matches!(text.get(..2), Some("0x" | "0X")))
}

/// The TOML for a field with a string.
fn fact(known: &Key, text: &str) -> Option<String> {
    Some(match (known.name, &known.shape) {
        ("bit-rates" | "languages" | "communication-entities" | "extra" | "unstated", _) => return None,
        ("creation-date" | "modification-date", _) => quoted(&literal::date(text)?.0.to_iso()),
        ("creation-time" | "modification-time", _) => quoted(&literal::clock_time(text)?.to_iso(false)),
        (_, Shape::Flag) => (integer(text)? != 0).to_string(),
        (_, Shape::Integer(..)) => {
            let number = integer(text)?;
            if text.starts_with("0x") { format!("0x{number:X}") } else { number.to_string() }
        }
        _ => quoted(text),
    })
}
