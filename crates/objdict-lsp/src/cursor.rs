//! Where the cursor is in TOML or YAML, also in a text that is not finished: tables, keys and the value around it.

use objdict_model::source::Span;

/// Where the cursor is.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Cursor {
    /// The keys of the tables around it; items of lists have none.
    pub(super) path: Vec<String>,
    /// The keys that the innermost table has.
    pub(super) present: Vec<String>,
    pub(super) spot: CursorSpot,
}

/// What is written there.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum CursorSpot {
    /// The header of a table of TOML.
    Header(Span),
    /// A key.
    Key(Span),
    /// The value of a key, without its quotes.
    Value { key: String, span: Span, is_quoted: bool },
}

impl Cursor {
    /// Where an offset is in TOML.
    pub(super) fn in_toml(text: &str, offset: u32) -> Option<Self> {
        let at = offset as usize;
        let start = text.get(..at)?.rfind('\n').map_or(0, |end| end + 1);
        let end = text[at..].find(['\n', '\r']).map_or(text.len(), |end| at + end);
        let before = &text[start..at];
        if before.trim_start().starts_with('[') && !before.contains('=') {
            let span = Span::new(start as u32, end as u32);
            return Some(Self { path: Vec::new(), present: Vec::new(), spot: CursorSpot::Header(span) });
        }
        let (mut path, present) = table_around(text, start, end);
        let mut cursor = before;
        let mut present = present;
        // tables between braces
        while let Some((key, value)) = split_at_equals(cursor) {
            let Some(brace) = open_brace(value) else { break };
            path.extend(keys(key));
            let inner = &value[brace + 1..];
            let items = split_outside(inner, ',');
            present =
                items.iter().filter_map(|item| Some(split_at_equals(item)?.0.trim().to_owned())).collect();
            cursor = items.last().copied().unwrap_or_default();
        }
        let spot = match split_at_equals(cursor) {
            Some((key, value)) => {
                let mut names = keys(key);
                let key = names.pop()?;
                path.extend(names);
                value_spot(text, key, value, at)
            }
            None => {
                let typed = cursor.trim_start();
                let mut names = keys(typed);
                if let Some((_, last)) = typed.rsplit_once('.').filter(|_| !typed.contains('"')) {
                    names.pop();
                    path.extend(names);
                    CursorSpot::Key(Span::new(offset - last.len() as u32, offset))
                } else {
                    CursorSpot::Key(Span::new(offset - typed.len() as u32, offset))
                }
            }
        };
        Some(Self { path, present, spot })
    }

    /// Where an offset is in YAML of blocks.
    pub(super) fn in_yaml(text: &str, offset: u32) -> Option<Self> {
        let at = offset as usize;
        let start = text.get(..at)?.rfind('\n').map_or(0, |end| end + 1);
        let before = &text[start..at];
        let line = YamlLine::of(before);
        let (mut path, mut present) = (Vec::new(), Vec::new());
        let (mut depth, mut is_item) = (line.indent, line.dash.is_some());
        if let Some(dash) = line.dash {
            depth = dash;
        }
        for above in text[..start].lines().rev().filter(|line| !line.trim().is_empty()) {
            let above = YamlLine::of(above);
            let Some(key) = above.key else { continue };
            if path.is_empty() && !is_item && above.indent == line.indent {
                present.push(key.to_owned());
                if let Some(dash) = above.dash {
                    (depth, is_item) = (dash, true);
                }
            } else if above.indent < depth || is_item && above.indent <= depth && above.dash.is_none() {
                path.push(key.to_owned());
                is_item = above.dash.is_some();
                depth = above.dash.unwrap_or(above.indent);
            }
        }
        path.reverse();
        let typed = line.rest;
        let spot = match typed.split_once(':') {
            Some((key, value)) => value_spot(text, key.trim().to_owned(), value, at),
            None => CursorSpot::Key(Span::new(offset - typed.len() as u32, offset)),
        };
        Some(Self { path, present, spot })
    }
}

/// A line of YAML.
struct YamlLine<'a> {
    /// The column of its key.
    indent: usize,
    /// The column of the dash of an item.
    dash: Option<usize>,
    key: Option<&'a str>,
    rest: &'a str,
}

impl<'a> YamlLine<'a> {
    fn of(line: &'a str) -> Self {
        let bare = line.trim_start();
        let mut indent = line.len() - bare.len();
        let inner = bare.strip_prefix('-').filter(|rest| rest.is_empty() || rest.starts_with(' '));
        let dash = inner.map(|_| indent);
        let rest = inner.map_or(bare, str::trim_start);
        indent += bare.len() - rest.len();
        let key = rest.split_once(':').map(|(key, _)| key.trim()).filter(|key| !key.starts_with('#'));
        Self { indent, dash, key, rest }
    }
}

/// The table that a line of TOML is in, and the keys of its other lines.
fn table_around(text: &str, start: usize, end: usize) -> (Vec<String>, Vec<String>) {
    let is_header = |line: &&str| line.trim_start().starts_with('[') && split_at_equals(line).is_none();
    let above: Vec<&str> = text[..start].lines().rev().collect();
    let header = above.iter().position(&is_header);
    let path =
        header.map(|number| above[number].trim().trim_matches(['[', ']'])).map(keys).unwrap_or_default();
    let below = text[end..].lines().skip(1).take_while(|line| !is_header(line));
    let lines = above.iter().take(header.unwrap_or(above.len())).copied().chain(below);
    let first = |line: &str| keys(split_at_equals(line)?.0).into_iter().next();
    (path, lines.filter_map(first).collect())
}

/// The keys of `a."b.c".d`.
fn keys(path: &str) -> Vec<String> {
    let keys = split_outside(path, '.').into_iter();
    keys.map(|key| key.trim().trim_matches(['"', '\'']).to_owned()).collect()
}

/// The parts of a text between marks that are outside of quotes, braces and brackets.
fn split_outside(text: &str, mark: char) -> Vec<&str> {
    let (mut parts, mut start, mut quote, mut depth) = (Vec::new(), 0, None, 0_i32);
    for (at, c) in text.char_indices() {
        match (quote, c) {
            (Some(open), c) if c == open => quote = None,
            (Some(_), _) => {}
            (None, '"' | '\'') => quote = Some(c),
            (None, '{' | '[') => depth += 1,
            (None, '}' | ']') => depth -= 1,
            (None, c) if c == mark && depth == 0 => {
                parts.push(&text[start..at]);
                start = at + c.len_utf8();
            }
            _ => {}
        }
    }
    parts.push(&text[start..]);
    parts
}

fn split_at_equals(text: &str) -> Option<(&str, &str)> {
    let key = *split_outside(text, '=').first()?;
    text.get(key.len() + 1..).map(|value| (key, value))
}

/// The place of a brace that is not closed.
fn open_brace(value: &str) -> Option<usize> {
    let at = value.find('{').filter(|at| value[..*at].trim().is_empty())?;
    // a part behind it would be outside of the braces
    (split_outside(&value[at..], '}').len() == 1
        && value[at..].matches('{').count() > value[at..].matches('}').count())
    .then_some(at)
}

/// What is written of a value, up to the cursor, and behind it up to its quote.
fn value_spot(text: &str, key: String, value: &str, at: usize) -> CursorSpot {
    let quotes: Vec<usize> = value.match_indices(['"', '\'']).map(|(at, _)| at).collect();
    if let (Some(last), true) = (quotes.last(), quotes.len() % 2 == 1) {
        let start = at - (value.len() - last - 1);
        let line = text[at..].split(['\n', '\r']).next().unwrap_or_default();
        let end = line.find(['"', '\'']).map_or(at, |end| at + end);
        return CursorSpot::Value { key, span: Span::new(start as u32, end as u32), is_quoted: true };
    }
    let typed = value.rsplit(['[', ',', ' ']).next().unwrap_or_default();
    let span = Span::new((at - typed.len()) as u32, at as u32);
    CursorSpot::Value { key, span, is_quoted: false }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(text: &str, of: fn(&str, u32) -> Option<Cursor>) -> (String, String, CursorSpot) {
        let offset = text.find('‸').unwrap();
        let cursor = of(&text.replace('‸', ""), offset as u32).unwrap();
        (cursor.path.join("/"), cursor.present.join(" "), cursor.spot)
    }

    #[test]
    fn toml_has_tables_keys_and_values() {
        let (path, present, spot) =
            at("[node.\"a.b\"]\nid = 1\n‸\nfile = 'x'\n[link]\nfrom = 1", Cursor::in_toml);
        assert_eq!((&*path, &*present), ("node/a.b", "id file"));
        assert_eq!(spot, CursorSpot::Key(Span::empty(20)));
        let (path, _, spot) = at("[[link]]\nto = [\"a.1\", \"b‸\"]", Cursor::in_toml);
        assert_eq!(path, "link");
        assert_eq!(spot, CursorSpot::Value { key: "to".into(), span: Span::new(23, 24), is_quoted: true });
        let (path, present, _) = at("[object]\n2000 = { name = \"a, b\", ty‸", Cursor::in_toml);
        assert_eq!((&*path, &*present), ("object/2000", "name"));
        let (path, ..) = at("node.a.fi‸", Cursor::in_toml);
        assert_eq!(path, "node/a");
        assert_eq!(at("[no‸de]", Cursor::in_toml).2, CursorSpot::Header(Span::new(0, 6)));
    }

    #[test]
    fn yaml_has_blocks_and_items() {
        let text = "master:\n  node_id: 1\nservo:\n  dcf: a.eds\n  sdo:\n    - index: 1\n      ‸";
        let (path, present, _) = at(text, Cursor::in_yaml);
        assert_eq!((&*path, &*present), ("servo/sdo", "index"));
        let (path, present, _) = at("master:\n  node_id: 1\nservo:\n  dcf: a\n  ‸", Cursor::in_yaml);
        assert_eq!((&*path, &*present), ("servo", "dcf"));
        let (path, _, spot) = at("servo:\n  tpdo:\n    1:\n      enabled: t‸", Cursor::in_yaml);
        assert_eq!(path, "servo/tpdo/1");
        assert!(matches!(spot, CursorSpot::Value { key, .. } if key == "enabled"));
    }
}
