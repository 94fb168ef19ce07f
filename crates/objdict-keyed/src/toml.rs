//! TOML as a tree, in text order.

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeInteger, DeTable, DeValue};

use super::rules::{DUPLICATE_KEY, INVALID_TOML};
use super::tree::{KeyedTree, Kind, Pair};
use objdict_model::diagnostic::{Diagnostic, Findings};
use objdict_model::source::Span;

/// Whether a text is TOML rather than YAML: its first line is a header, or a key with `=`.
pub fn is_toml(text: &str) -> bool {
    let lines = text.lines().map(str::trim_start).filter(|line| !line.is_empty() && !line.starts_with('#'));
    let is_toml = |line: &str| {
        line.starts_with('[') || line.find('=').is_some_and(|at| !line[..at].contains([':', '{', '-']))
    };
    lines.take(1).any(is_toml)
}

/// Reads a text; `None` with a finding if it is not TOML.
pub fn read(text: &str, findings: &mut Findings) -> Option<KeyedTree> {
    let (table, errors) = DeTable::parse_recoverable(text);
    let is_duplicate = |error: &toml::de::Error| error.message().contains("duplicate key");
    let (duplicates, broken): (Vec<_>, Vec<_>) = errors.iter().partition(|error| is_duplicate(error));
    // errors after the first syntax error are consequences of it
    for error in duplicates.into_iter().chain(broken.into_iter().take(1)) {
        let span = error.span().map_or(Span::empty(0), |range| span_of(&range));
        let message = error.message().lines().next().unwrap_or("this is not valid TOML").to_owned();
        let (rule, help) = match is_duplicate(error) {
            true => (&DUPLICATE_KEY, "remove or rename one of the two"),
            false => (&INVALID_TOML, "write `name = value`, with strings in quotes and lists in brackets"),
        };
        findings.push(Diagnostic::new(rule, span, message).help(help));
    }
    errors.is_empty().then(|| KeyedTree::new(Span::empty(0), map(table.into_inner())))
}

/// Consumes the parser's table piece by piece, so that the text is not in memory twice.
fn map(table: DeTable<'_>) -> Kind {
    let entries = table.into_iter().map(|(key, value)| Pair { key: key_of(&key), value: tree(value) });
    let mut entries: Vec<Pair> = entries.collect();
    entries.sort_by_key(|entry| entry.key.span.start);
    Kind::Map(entries)
}

/// TOML keys are strings; those of digits become numbers, as in YAML.
fn key_of(key: &Spanned<std::borrow::Cow<'_, str>>) -> KeyedTree {
    let text = &**key.get_ref();
    let is_number = !text.starts_with('0') && text.bytes().all(|byte| byte.is_ascii_digit());
    let number = Some(text).filter(|_| is_number);
    let kind = number.and_then(|text| text.parse().ok()).map(Kind::Integer);
    KeyedTree::new(span_of(&key.span()), kind.unwrap_or_else(|| Kind::Text(text.to_owned())))
}

fn tree(value: Spanned<DeValue<'_>>) -> KeyedTree {
    let span = span_of(&value.span());
    let kind = match value.into_inner() {
        DeValue::String(text) => Kind::Text(text.into_owned()),
        DeValue::Integer(number) => integer(&number),
        DeValue::Float(number) => Kind::Float(number.as_str().parse().unwrap_or(f64::NAN)),
        DeValue::Boolean(flag) => Kind::Bool(flag),
        DeValue::Datetime(time) => Kind::Text(time.to_string()),
        DeValue::Array(items) => Kind::List(items.into_iter().map(tree).collect()),
        DeValue::Table(table) => map(table),
    };
    KeyedTree::new(span, kind)
}

fn integer(number: &DeInteger<'_>) -> Kind {
    match i128::from_str_radix(number.as_str(), number.radix()) {
        Ok(number) => Kind::Integer(number),
        // too long for any object
        Err(_) => Kind::Text(number.to_string()),
    }
}

fn span_of(range: &Range<usize>) -> Span {
    let offset = |at: usize| u32::try_from(at).unwrap_or(u32::MAX);
    Span::new(offset(range.start), offset(range.end))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_line_says_which_format_it_is() {
        for text in ["[bus]\n", "\n# a\n  [[link]]\n", "node.a.file = 'x: y'\n", "bus = { name = 'a' }"] {
            assert!(is_toml(text), "{text}");
        }
        for text in ["", "master:\n", "---\na: [x=1]", "{a: 1}", "a: b=c", "- a=b", "nodes:\n  x=1"] {
            assert!(!is_toml(text), "{text}");
        }
    }

    #[test]
    fn a_tree_has_the_order_and_the_places_of_the_text() {
        let text = "z = 0x10\n[a]\n1 = 'ä'\n[[b]]\nc = [true, 1_000.5]\n";
        let tree = read(text, &mut Findings::new()).unwrap();
        let keys: Vec<_> = tree.entries().unwrap().iter().map(|entry| entry.key.span.of(text)).collect();
        assert_eq!(keys, ["z", "a", "b"]);
        assert_eq!(tree.get("z").unwrap().spelled(), "16");
        let numbered = &tree.get("a").and_then(KeyedTree::entries).unwrap()[0];
        assert!(matches!(*numbered.key.kind, Kind::Integer(1)));
        assert_eq!(numbered.value.span.of(text), "'ä'");
        for (text, rule) in
            [("a = 1\na = 2", "key-defined-twice"), ("[a", "invalid-toml"), ("a: 1", "invalid-toml")]
        {
            let mut findings = Findings::new();
            assert!(read(text, &mut findings).is_none());
            assert_eq!(findings.iter().next().unwrap().rule.name(), rule, "{text}");
        }
    }
}
