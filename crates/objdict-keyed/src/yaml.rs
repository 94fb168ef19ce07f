//! YAML 1.1 as in PyYAML, because authors of `bus.yml` test their files with it: `010` is 8, `on` is true, and `1e3` is
//! a string.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::sync::Arc;

use saphyr_parser::{Event, Parser, ScalarStyle, Tag};

use crate::rules::DUPLICATE_KEY;
use crate::rules::INVALID_YAML;
use crate::tree::{KeyedTree, Kind, Pair};
use objdict_model::diagnostic::{Diagnostic, Findings, say};
use objdict_model::source::Span;

/// The maximum depth of lists and maps.
const MAX_DEPTH: usize = 64;

/// Reads a text of one document; `None` with a finding if it is not YAML or has a second document.
pub fn read(text: &str, findings: &mut Findings) -> Option<KeyedTree> {
    let mut builder =
        YamlBuilder { offsets: offsets(text), anchors: BTreeMap::new(), open: Vec::new(), findings };
    let mut document = None;
    for event in Parser::new_from_str(text) {
        let (event, span) = match event {
            Ok(event) => event,
            Err(error) => {
                let at = builder.offset(error.marker().index());
                let help = "indent with spaces, and quote strings that begin with one of `@%*&!|>{[`";
                builder.findings.push(
                    Diagnostic::new(&INVALID_YAML, Span::empty(at), error.info().to_owned()).help(help),
                );
                return None;
            }
        };
        let span = Span::new(builder.offset(span.start.index()), builder.offset(span.end.index()));
        if document.is_some() && matches!(event, Event::DocumentStart(_)) {
            let finding = Diagnostic::new(&INVALID_YAML, span, "a second document begins here")
                .help("remove the line `---`, or move the lines after it to a separate file");
            builder.findings.push(finding);
            return None;
        }
        match builder.take(event, span) {
            Ok(tree) => document = document.or(tree),
            Err(finding) => {
                builder.findings.push(*finding);
                return None;
            }
        }
    }
    document.or_else(|| Some(KeyedTree::new(Span::empty(0), Kind::Null)))
}

/// The byte offset of each character; empty if every character is a single byte.
fn offsets(text: &str) -> Vec<u32> {
    if text.is_ascii() {
        return Vec::new();
    }
    let starts = text.char_indices().map(|(offset, _)| offset).chain([text.len()]);
    starts.map(|offset| u32::try_from(offset).unwrap_or(u32::MAX)).collect()
}

/// A list or map that has not ended yet.
struct OpenCollection {
    start: u32,
    anchor: usize,
    items: Vec<KeyedTree>,
    is_map: bool,
}

struct YamlBuilder<'f> {
    offsets: Vec<u32>,
    anchors: BTreeMap<usize, Arc<Kind>>,
    open: Vec<OpenCollection>,
    findings: &'f mut Findings,
}

impl YamlBuilder<'_> {
    fn offset(&self, characters: usize) -> u32 {
        match self.offsets.last() {
            None => u32::try_from(characters).unwrap_or(u32::MAX),
            Some(&end) => self.offsets.get(characters).copied().unwrap_or(end),
        }
    }

    /// Processes the next event; returns the document at its end.
    fn take(&mut self, event: Event<'_>, span: Span) -> Result<Option<KeyedTree>, Box<Diagnostic>> {
        match event {
            Event::Scalar(text, style, anchor, tag) => {
                Ok(self.complete(anchor, scalar(text, style, tag.as_deref()), span))
            }
            Event::Alias(anchor) => match self.anchors.get(&anchor) {
                Some(kind) => {
                    let tree = KeyedTree { span, kind: Arc::clone(kind) };
                    Ok(self.place(tree))
                }
                None => Err(Box::new(
                    Diagnostic::new(&INVALID_YAML, span, "the anchor contains itself")
                        .help("use an anchor only after its end"),
                )),
            },
            Event::SequenceStart(anchor, _) | Event::MappingStart(anchor, _) => {
                if self.open.len() == MAX_DEPTH {
                    let message = say!("lists and maps are nested more than {} deep", MAX_DEPTH);
                    return Err(Box::new(Diagnostic::new(&INVALID_YAML, span, message).help("flatten them")));
                }
                let is_map = matches!(event, Event::MappingStart(..));
                self.open.push(OpenCollection { start: span.start, anchor, items: Vec::new(), is_map });
                Ok(None)
            }
            Event::SequenceEnd | Event::MappingEnd => {
                let Some(open) = self.open.pop() else { return Ok(None) };
                // the end of a block has no length and is at the start of the next token
                let last = open.items.last().map_or(open.start, |last| last.span.end.max(open.start));
                let end = if span.is_empty() { last } else { span.end };
                let kind = if open.is_map { self.map(open.items) } else { Kind::List(open.items) };
                Ok(self.complete(open.anchor, kind, Span::new(open.start, end)))
            }
            _ => Ok(None),
        }
    }

    fn complete(&mut self, anchor: usize, kind: Kind, span: Span) -> Option<KeyedTree> {
        let tree = KeyedTree::new(span, kind);
        if anchor > 0 {
            self.anchors.insert(anchor, Arc::clone(&tree.kind));
        }
        self.place(tree)
    }

    /// Adds a value to the open collection; returns the document itself.
    fn place(&mut self, tree: KeyedTree) -> Option<KeyedTree> {
        match self.open.last_mut() {
            Some(open) => {
                open.items.push(tree);
                None
            }
            None => Some(tree),
        }
    }

    /// The entries of a map: merged ones (`<<`) first, then its own, which override them; the last of two
    /// equal keys is used.
    fn map(&mut self, items: Vec<KeyedTree>) -> Kind {
        let mut merged = Vec::new();
        let mut own = Vec::new();
        let mut items = items.into_iter();
        while let (Some(key), Some(value)) = (items.next(), items.next()) {
            if key.text() != Some("<<") {
                own.push(Pair { key, value });
                continue;
            }
            match &*value.kind {
                Kind::Map(entries) => merged.extend(entries.iter().cloned()),
                Kind::List(maps) => {
                    merged.extend(maps.iter().rev().filter_map(KeyedTree::entries).flatten().cloned());
                }
                _ => {}
            }
        }
        let mut entries: Vec<Pair> = Vec::with_capacity(merged.len() + own.len());
        let mut places: BTreeMap<String, (usize, bool)> = BTreeMap::new();
        for (entry, is_own) in
            merged.into_iter().map(|entry| (entry, false)).chain(own.into_iter().map(|entry| (entry, true)))
        {
            let name = entry.key.spelled();
            match places.get(&name) {
                Some(&(place, was_own)) => {
                    if is_own && was_own {
                        self.defined_twice(&entries[place].key, &entry.key);
                    }
                    entries[place].value = entry.value;
                    if is_own {
                        entries[place].key = entry.key;
                        places.insert(name, (place, true));
                    }
                }
                None => {
                    places.insert(name, (entries.len(), is_own));
                    entries.push(entry);
                }
            }
        }
        Kind::Map(entries)
    }

    fn defined_twice(&mut self, first: &KeyedTree, second: &KeyedTree) {
        let message = say!("`{}` is defined twice", second.spelled());
        self.findings.push(
            Diagnostic::new(&DUPLICATE_KEY, second.span, message)
                .label(first.span, "first defined here")
                .help("remove one of the two; the last one applies")
                .understood(),
        );
    }
}

/// The value of a scalar.
fn scalar(text: Cow<'_, str>, style: ScalarStyle, tag: Option<&Tag>) -> Kind {
    let is_text = style != ScalarStyle::Plain
        || tag.is_some_and(|tag| tag.is_yaml_core_schema() && tag.suffix == "str");
    if is_text {
        return Kind::Text(text.into_owned());
    }
    match &*text {
        "" | "~" | "null" | "Null" | "NULL" => Kind::Null,
        "yes" | "Yes" | "YES" | "true" | "True" | "TRUE" | "on" | "On" | "ON" => Kind::Bool(true),
        "no" | "No" | "NO" | "false" | "False" | "FALSE" | "off" | "Off" | "OFF" => Kind::Bool(false),
        plain => match integer(plain) {
            Some(number) => Kind::Integer(number),
            None => float(plain).map_or_else(|| Kind::Text(text.into_owned()), Kind::Float),
        },
    }
}

/// A whole number; `None` also if it exceeds 128 bits.
fn integer(text: &str) -> Option<i128> {
    let (is_negative, digits) = signed(text);
    let radix = |digits: &str, radix| {
        let digits = digits.replace('_', "");
        // a sign would be read a second time
        let number = i128::from_str_radix(&digits, radix).ok().filter(|_| !digits.starts_with(['+', '-']))?;
        Some(if is_negative { -number } else { number })
    };
    if let Some(digits) = digits.strip_prefix("0b") {
        return radix(digits, 2);
    }
    if let Some(digits) = digits.strip_prefix("0x") {
        return radix(digits, 16);
    }
    match digits.strip_prefix('0') {
        Some("") => Some(0),
        Some(rest) => {
            rest.starts_with(|c: char| c.is_ascii_digit() || c == '_').then(|| radix(rest, 8)).flatten()
        }
        None if digits.contains(':') => {
            sexagesimal(digits).map(|number| if is_negative { -number } else { number })
        }
        None => digits.starts_with(|c: char| c.is_ascii_digit()).then(|| radix(digits, 10)).flatten(),
    }
}

fn signed(text: &str) -> (bool, &str) {
    match text.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    }
}

/// `1:30` is 90.
fn sexagesimal(text: &str) -> Option<i128> {
    text.split(':').enumerate().try_fold(0_i128, |sum, (position, digits)| {
        let digits = digits.replace('_', "");
        let is_digits = !digits.is_empty() && digits.bytes().all(|digit| digit.is_ascii_digit());
        let number: i128 =
            digits.parse().ok().filter(|&number| is_digits && (position == 0 || number < 60))?;
        sum.checked_mul(60)?.checked_add(number)
    })
}

/// A number with a decimal point; without a point (`1e3`) it is a string.
fn float(text: &str) -> Option<f64> {
    let (_, digits) = signed(text);
    match digits {
        ".inf" | ".Inf" | ".INF" => {
            return Some(if text.starts_with('-') { f64::NEG_INFINITY } else { f64::INFINITY });
        }
        ".nan" | ".NaN" | ".NAN" => return Some(f64::NAN),
        _ => {}
    }
    let (_, behind) = digits.split_once('.')?;
    // an exponent has a sign
    let exponent = behind.split_once(['e', 'E']);
    if exponent.is_some_and(|(_, exponent)| !exponent.starts_with(['+', '-']))
        || !digits.starts_with(|c: char| c.is_ascii_digit() || c == '.')
    {
        return None;
    }
    text.replace('_', "").parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tree(text: &str) -> KeyedTree {
        let mut findings = Findings::new();
        read(text, &mut findings).filter(|_| findings.is_empty()).unwrap()
    }

    #[test]
    fn scalars_are_those_of_pyyaml() {
        let shown = |text: &str| format!("{:?}", tree(text).kind);
        for (text, expected) in [
            ("010", "Integer(8)"),
            ("0b11", "Integer(3)"),
            ("-0x1F", "Integer(-31)"),
            ("1_000", "Integer(1000)"),
            ("1:30", "Integer(90)"),
            ("0", "Integer(0)"),
            ("09", "Text(\"09\")"),
            ("0o17", "Text(\"0o17\")"),
            ("1e3", "Text(\"1e3\")"),
            ("1.5e3", "Text(\"1.5e3\")"),
            ("1.5e+3", "Float(1500.0)"),
            (".5", "Float(0.5)"),
            ("10.", "Float(10.0)"),
            ("-", "List([KeyedTree { span: Span { start: 1, end: 1 }, kind: Null }])"),
            ("y", "Text(\"y\")"),
            ("on", "Bool(true)"),
            ("No", "Bool(false)"),
            ("'10'", "Text(\"10\")"),
            ("!!str 10", "Text(\"10\")"),
            ("~", "Null"),
            ("1.2.3", "Text(\"1.2.3\")"),
            ("+.inf", "Float(inf)"),
        ] {
            assert_eq!(shown(text), expected, "{text}");
        }
    }

    #[test]
    fn own_keys_override_merged_ones_and_keep_their_place() {
        let tree = tree("a: &a {x: 1, y: 2}\nb: {z: 0, <<: *a, y: 3}\n");
        let entries = tree.get("b").and_then(KeyedTree::entries).unwrap();
        let shown: Vec<String> = entries
            .iter()
            .map(|entry| format!("{}={}", entry.key.spelled(), entry.value.spelled()))
            .collect();
        assert_eq!(shown, ["x=1", "y=3", "z=0"]);
    }

    #[test]
    fn places_are_bytes() {
        let text = "ä: 'ö'\nb: 1\n";
        let tree = tree(text);
        let entries = tree.entries().unwrap();
        assert_eq!(entries[1].key.span.of(text), "b");
        assert_eq!(entries[0].value.span.of(text), "'ö'");
    }

    #[test]
    fn what_cannot_be_read_is_reported() {
        let deep = "[".repeat(100_000);
        for text in ["a: [1", "a: 1\na: 2", "a: 1\n---\nb: 2", "&a [*a]", "@x", &deep] {
            let mut findings = Findings::new();
            read(text, &mut findings);
            assert_eq!(findings.len(), 1, "{text:.20}");
        }
        // ten anchors of ten aliases each are ten values, not ten thousand million
        let bomb: String = (1..10)
            .map(|n| format!("a{n}: &a{n} [{}]\n", vec![format!("*a{}", n - 1); 10].join(", ")))
            .collect();
        tree(&format!("a0: &a0 1\n{bomb}"));
    }
}
