//! Compares two devices value by value and turns one into the other.
//!
//! The values of a difference are counted before their JSON is created, so malicious files cannot exhaust memory.
//!
//! A value is named by its path in the JSON of the model (docs/reference/json.md), as a JSON pointer (RFC 6901):
//! `/objects/0x1018/subs/0x01/default`. Equal objects are never converted to JSON, so comparing equal devices is
//! cheap.

mod apply;
mod place;

use std::borrow::Cow;
use std::io::{self, Write};

use crate::model::{Device, Extra, ExtraSection, Place};
pub use apply::{DatumChange, apply, overlay};
use serde::de::IgnoredAny;
use serde::{Serialize, Serializer};
use serde_json::{Map, Value};

/// A value that differs between two devices.
#[derive(Clone, Debug, PartialEq)]
pub struct DatumDifference {
    /// The location: a JSON pointer into the JSON of the device.
    pub path: String,
    /// The value in the left device; `None` if missing.
    pub left: Option<Datum>,
    /// The value in the right device; `None` if missing.
    pub right: Option<Datum>,
}

impl DatumDifference {
    /// The address of the value in the model.
    pub fn place(&self) -> Place {
        place::of(&self.path)
    }
}

/// The differences between two devices, in the order of the model. The order of unknown sections does not
/// matter.
///
/// ```
/// # mod objdict { pub use objdict_model::{compare, model}; }
/// use objdict::compare::differences;
/// use objdict::model::{Device, Entry, Object};
///
/// let named = |name: &str| {
///     let main = Entry { name: name.into(), ..Entry::default() };
///     let mut device = Device::default();
///     device.objects.insert(0x2000, Object { main, ..Object::default() });
///     device
/// };
/// let found = differences(&named("Speed"), &named("Velocity"));
/// assert_eq!(found[0].path, "/objects/0x2000/name");
/// assert_eq!(found[0].place().to_string(), "0x2000 / ParameterName");
/// ```
pub fn differences(left: &Device, right: &Device) -> Vec<DatumDifference> {
    let mut found = Vec::new();
    // without a limit, the count never exceeds it
    let _ = each_difference(left, right, usize::MAX, &mut |difference| found.push(difference));
    found
}

/// Devices differ in more values than allowed.
#[derive(Clone, Copy, Debug)]
pub struct TooMany {
    /// The number of items.
    pub count: usize,
    /// How many are allowed.
    pub limit: usize,
}

/// Calls `found` for each of the [`differences`]: their values may be much more than the devices.
///
/// # Errors
/// If the differences, or one differing part, contain more values than the limit; the JSON of such a part is
/// not created.
pub fn each_difference(
    left: &Device,
    right: &Device,
    limit: usize,
    found: &mut dyn FnMut(DatumDifference),
) -> Result<(), TooMany> {
    if left == right {
        return Ok(());
    }
    let mut comparison = Comparison { path: String::new(), count: 0, limit, found };
    comparison.frames(left, right);
    comparison.extra(left, right);
    comparison.path.push_str("/objects");
    let indexes: std::collections::BTreeSet<u16> =
        left.objects.keys().chain(right.objects.keys()).copied().collect();
    for index in indexes {
        comparison.part(&format!("0x{index:04X}"), &left.object(index), &right.object(index));
    }
    let count = comparison.count;
    if count > limit { Err(TooMany { count, limit }) } else { Ok(()) }
}

/// A comparison of two devices.
struct Comparison<'a> {
    /// The path of the current part.
    path: String,
    /// The number of differing values so far; each difference adds [`DIFFERENCE`].
    count: usize,
    limit: usize,
    found: &'a mut dyn FnMut(DatumDifference),
}

/// A part that only one device has is not converted to a tree if it has more values.
const MAX_TREE: usize = 1000;

/// A part of both devices is not compared value by value if it has more values, unless it belongs to an
/// object.
const MAX_TREES: usize = 20_000;

/// The cost of a path in addition to its values.
const DIFFERENCE: usize = 2;

impl Comparison<'_> {
    /// All parts of the devices except objects and unknown sections.
    fn frames(&mut self, left: &Device, right: &Device) {
        macro_rules! parts {
            ($($name:ident)*) => { $(self.part(stringify!($name), &left.$name, &right.$name);)* };
        }
        // in alphabetical order, as in JSON
        parts! { application commissioning comments device_info downloads dummy_usage dynamic_channels file_info functions headers identity }
        if left.kind != right.kind {
            let json = |device: &Device| Some(to_value(&device.kind).into());
            self.push("/kind".to_owned(), json(left), json(right));
        }
        parts! { lists manager module_objects modules network_identity tools }
    }

    /// A part of the devices, which the JSON omits if empty. Its JSON is created only if it differs.
    fn part<T: Serialize + PartialEq + Default>(&mut self, name: &str, left: &T, right: &T) {
        if left == right {
            return;
        }
        let is_present = |part: &&T| **part != T::default();
        let (left, right) = (Some(left).filter(is_present), Some(right).filter(is_present));
        let size = [left, right].into_iter().flatten().map(count).max().unwrap_or_default();
        if size > self.limit || self.count > self.limit {
            self.count += size;
            return;
        }
        let is_frame = self.path.is_empty();
        self.step(name, |comparison| match (left, right) {
            (Some(_), None) if size > MAX_TREE => comparison.whole(left, right, size),
            (Some(_), Some(_)) if size > MAX_TREES && is_frame => comparison.whole(left, right, size),
            _ => comparison.values(left.map(to_value), right.map(to_value)),
        });
    }

    /// A large part as one difference, without a tree of its JSON.
    fn whole<T: Serialize>(&mut self, left: Option<&T>, right: Option<&T>, size: usize) {
        self.count += DIFFERENCE + size;
        self.push(self.path.clone(), left.map(Datum::of), right.map(Datum::of));
    }

    /// Unknown sections: the differing ones if both devices have the same number, otherwise all as one string, because
    /// the JSON of a short section needs a hundred times its memory.
    fn extra(&mut self, left: &Device, right: &Device) {
        const MAX_SINGLE: usize = 1000;
        let (left, right) = (sorted_extra(left), sorted_extra(right));
        let differs = |(left, right): &(&&ExtraSection, &&ExtraSection)| left != right;
        let differing = || left.iter().zip(&right).enumerate().filter(|(_, pair)| differs(pair));
        if left.len() == right.len() && differing().count() <= MAX_SINGLE {
            self.step("extra", |comparison| {
                for (position, (left, right)) in differing() {
                    let (left, right) = (to_value(left), to_value(right));
                    comparison
                        .step(&position.to_string(), |comparison| comparison.values(Some(left), Some(right)));
                }
            });
        } else {
            let text = |sections: &[&ExtraSection]| {
                (!sections.is_empty()).then(|| Value::String(print(sections)).into())
            };
            self.push("/extra".to_owned(), text(&left), text(&right));
        }
    }

    /// Consumes the values, because copying a large one needs much memory.
    fn values(&mut self, left: Option<Value>, right: Option<Value>) {
        match (left, right) {
            (left, right) if left == right => {}
            (Some(Value::Object(left)), Some(Value::Object(right))) => self.maps(left, right),
            // lists of equal length are compared item by item; items of other lists cannot be matched
            (Some(Value::Array(left)), Some(Value::Array(right))) if left.len() == right.len() => {
                for (position, (left, right)) in left.into_iter().zip(right).enumerate() {
                    self.step(&position.to_string(), |comparison| {
                        comparison.values(Some(left), Some(right));
                    });
                }
            }
            (left, right) => {
                self.count += DIFFERENCE + [&left, &right].into_iter().flatten().map(count).sum::<usize>();
                self.push(self.path.clone(), left.map(Datum::from), right.map(Datum::from));
            }
        }
    }

    fn maps(&mut self, left: Map<String, Value>, mut right: Map<String, Value>) {
        for (key, value) in left {
            let other = right.remove(&key);
            self.step(&key, |comparison| comparison.values(Some(value), other));
        }
        for (key, value) in right {
            self.step(&key, |comparison| comparison.values(None, Some(value)));
        }
    }

    fn step(&mut self, key: &str, visit: impl FnOnce(&mut Self)) {
        let length = self.path.len();
        self.path.push('/');
        self.path.push_str(&key.replace('~', "~0").replace('/', "~1"));
        visit(self);
        self.path.truncate(length);
    }

    fn push(&mut self, path: String, left: Option<Datum>, right: Option<Datum>) {
        (self.found)(DatumDifference { path, left, right });
    }
}

/// The unknown sections, sorted, so that paths mean the same in both devices.
fn sorted_extra(device: &Device) -> Vec<&ExtraSection> {
    let mut sections: Vec<&ExtraSection> = device.extra.iter().collect();
    sections.sort_by_key(|section| section.name());
    sections
}

/// The JSON of a part of the model. Serialisation cannot fail, because all keys are strings.
fn to_value(part: &impl Serialize) -> Value {
    serde_json::to_value(part).unwrap_or_default()
}

/// From this size in bytes, a tree needs megabytes.
const LARGE: usize = 1 << 16;

/// The JSON of a value, stored as a string: as a tree, a short value needs twenty times the memory.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Datum(Box<str>);

impl Datum {
    /// The JSON of a part of the model. Serialisation cannot fail, because all keys are strings.
    fn of(part: &impl Serialize) -> Self {
        Self(serde_json::to_string(part).unwrap_or_default().into_boxed_str())
    }

    /// Parses the value at the start of `text`; returns it with the rest, or `None` if `text` does not begin
    /// with a value.
    pub fn prefix(text: &str) -> Option<(Self, &str)> {
        let mut values = serde_json::Deserializer::from_str(text).into_iter::<IgnoredAny>();
        values.next()?.ok()?;
        let (value, rest) = text.split_at(values.byte_offset());
        // one spelling, unless that needs much memory
        let value = Self(value.into());
        Some((if value.0.len() < LARGE { Self::from(value.value()) } else { value }, rest))
    }

    /// Whether its tree would need much memory.
    fn is_large(&self) -> bool {
        self.0.len() >= LARGE
    }

    /// The value as a tree.
    pub fn value(&self) -> Value {
        serde_json::from_str(&self.0).unwrap_or_default()
    }

    /// The string, without spaces between its parts.
    pub fn text(&self) -> &str {
        &self.0
    }

    /// A hash that distinguishes values: 32-bit FNV-1a of the string.
    pub fn fingerprint(&self) -> u32 {
        self.0.bytes().fold(0x811C_9DC5, |hash, byte| (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193))
    }
}

impl From<&Value> for Datum {
    fn from(value: &Value) -> Self {
        Self(value.to_string().into())
    }
}

impl From<Value> for Datum {
    fn from(value: Value) -> Self {
        Self::from(&value)
    }
}

messages! { Datum: { Self(text) => "{text}"; } }

impl Serialize for Datum {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.value().serialize(serializer)
    }
}

#[cfg(feature = "schema")]
crate::inline_schemas! {
    // any part of a device
    Datum: |_| schemars::json_schema!({});
}

/// The number of values in the JSON of a part, counted without creating it.
fn count(datum: &impl Serialize) -> usize {
    struct Counter(usize);
    impl Write for Counter {
        fn write(&mut self, token: &[u8]) -> io::Result<usize> {
            // a value begins at these bytes; the first value of a list or object follows its bracket
            self.0 += usize::from(matches!(token, b"," | b"[" | b"{"));
            Ok(token.len())
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }
    let mut counter = Counter(1);
    // the counter never fails, and the keys of the model are strings
    let _ = serde_json::to_writer(&mut counter, datum);
    counter.0
}

/// Prints sections.
fn print(sections: &[&ExtraSection]) -> String {
    let mut text = String::new();
    for section in sections {
        text.push_str(&escaped(section.name()));
        text.push('\n');
        for (key, value) in section.entries() {
            [" ", key, "=", value, "\n"].into_iter().for_each(|part| text.push_str(part));
        }
    }
    text
}

/// Parses sections; `None` if [`print`] cannot have written them.
fn parse(text: &str) -> Option<Vec<ExtraSection>> {
    let mut sections: Vec<ExtraSection> = Vec::new();
    let mut lines = text.strip_suffix('\n')?.split('\n').peekable();
    while let Some(line) = lines.next() {
        let name = unescaped(line).filter(|_| !line.starts_with(' '))?;
        let mut entries = Extra::default();
        while let Some(entry) = lines.next_if(|line| line.starts_with(' ')) {
            let (key, value) = entry.get(1..)?.split_once('=')?;
            entries.push(key, value);
        }
        sections.push(ExtraSection::new(&name, &entries));
    }
    Some(sections)
}

/// Escapes a name to one line that does not start with a space.
fn escaped(name: &str) -> Cow<'_, str> {
    if !name.starts_with(' ') && !name.contains(['\\', '\n']) {
        return name.into();
    }
    let name = name.replace('\\', "\\\\").replace('\n', "\\n");
    let blanks = name.len() - name.trim_start_matches(' ').len();
    ["\\s".repeat(blanks).as_str(), &name[blanks..]].concat().into()
}

fn unescaped(line: &str) -> Option<Cow<'_, str>> {
    if !line.contains('\\') {
        return Some(line.into());
    }
    let mut name = String::with_capacity(line.len());
    let mut chars = line.chars();
    while let Some(c) = chars.next() {
        name.push(match c {
            '\\' => match chars.next()? {
                'n' => '\n',
                's' => ' ',
                '\\' => '\\',
                _ => return None,
            },
            c => c,
        });
    }
    Some(name.into())
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn values_are_counted_as_they_are_in_the_text() {
        assert_eq!(count(&json!(1)), 1);
        assert_eq!(count(&json!([1, 2])), 3);
        assert_eq!(count(&json!({ "a": [1, { "b": "c, [d" }], "e": 1 })), 6);
    }

    #[test]
    fn a_text_gives_the_sections_back() {
        let section = |name: &str, entries: &[(&str, &str)]| {
            let mut extra = Extra::default();
            entries.iter().for_each(|(key, value)| extra.push(key, value));
            ExtraSection::new(name, &extra)
        };
        let sections = [
            section("", &[]),
            section("", &[("", ""), (" a", " b=c ")]),
            section("  two\nlines\\n", &[("\\", "x")]),
            section("Vendor", &[("Key", "value"), ("Key", "")]),
        ];
        let text = print(&sections.iter().collect::<Vec<_>>());
        assert_eq!(parse(&text).unwrap(), sections, "{text}");
        assert!([" a=b\n", "a", "\\x\n", "a\n b\n"].iter().all(|text| parse(text).is_none()));
    }
}
