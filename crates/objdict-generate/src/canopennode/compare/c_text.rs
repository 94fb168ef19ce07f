//! A minimal parser for the C of object dictionaries: types, macros with a value, and initialisers.

use std::collections::BTreeMap;

/// Braces in each other; the tables of CANopenNode have four.
const DEEPEST: usize = 16;

/// A piece of C.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Token<'t> {
    /// A name, a keyword or a number.
    Word(&'t str),
    /// A string or character literal with its quotes.
    Quoted(&'t str),
    /// Any other character.
    Mark(char),
}

/// The macros of a text without parameters, and the tokens outside directives.
pub(super) fn scan(text: &str) -> (BTreeMap<&str, &str>, Vec<Token<'_>>) {
    let (mut macros, mut tokens) = (BTreeMap::new(), Vec::new());
    let mut rest = text;
    let mut starts_line = true;
    while let Some(first) = rest.chars().next() {
        let length = match first {
            '\n' => {
                starts_line = true;
                1
            }
            _ if first.is_whitespace() => first.len_utf8(),
            '/' if rest.starts_with("//") => line_length(rest),
            '/' if rest.starts_with("/*") => rest[2..].find("*/").map_or(rest.len(), |at| at + 4),
            '#' if starts_line => {
                let line = &rest[..line_length(rest)];
                macros.extend(define(line));
                line.len()
            }
            '"' | '\'' => {
                let length = quoted_length(rest, first);
                tokens.push(Token::Quoted(&rest[..length]));
                length
            }
            _ if is_word(first) => {
                let length = rest.find(|c| !is_word(c) && c != '.').unwrap_or(rest.len());
                // a number may have a point, a name may not
                let length = match first.is_ascii_digit() {
                    true => length,
                    false => rest.find(|c| !is_word(c)).unwrap_or(rest.len()),
                };
                tokens.push(Token::Word(&rest[..length]));
                length
            }
            _ => {
                tokens.push(Token::Mark(first));
                first.len_utf8()
            }
        };
        starts_line = starts_line && (first.is_whitespace() || rest.starts_with("/*"));
        rest = &rest[length..];
    }
    (macros, tokens)
}

fn is_word(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_'
}

/// The length of a line including continuation lines, without the line end.
fn line_length(text: &str) -> usize {
    let mut from = 0;
    while let Some(at) = text[from..].find('\n') {
        let end = from + at;
        if !text[..end].trim_end_matches('\r').ends_with('\\') {
            return end;
        }
        from = end + 1;
    }
    text.len()
}

/// The length of a literal with both quotes.
fn quoted_length(text: &str, quote: char) -> usize {
    let mut is_escaped = false;
    for (at, c) in text.char_indices().skip(1) {
        match c {
            _ if is_escaped => is_escaped = false,
            '\\' => is_escaped = true,
            _ if c == quote => return at + 1,
            _ => {}
        }
    }
    text.len()
}

/// Name and value of `#define NAME value`.
fn define(line: &str) -> Option<(&str, &str)> {
    let rest = line.strip_prefix('#')?.trim_start().strip_prefix("define")?.trim_start();
    let end = rest.find(|c| !is_word(c)).unwrap_or(rest.len());
    let (name, value) = rest.split_at(end);
    let value = value.split("/*").next().unwrap_or_default();
    (!value.starts_with('(') && !name.is_empty()).then_some((name, value.trim()))
}

/// The content of an initialiser.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Initialiser<'t> {
    /// A value: its tokens.
    Value(Vec<Token<'t>>),
    /// Values in braces, each with the field that it is for, if it has one.
    List(Vec<(Option<&'t str>, Initialiser<'t>)>),
}

impl<'t> Token<'t> {
    /// The name, keyword or number.
    pub(super) const fn word(&self) -> Option<&'t str> {
        match self {
            Self::Word(word) => Some(word),
            Self::Quoted(_) | Self::Mark(_) => None,
        }
    }
}

impl<'t> Initialiser<'t> {
    /// The value of a field.
    pub(super) fn field(&self, name: &str) -> Option<&Self> {
        self.items().iter().find(|(field, _)| *field == Some(name)).map(|(_, value)| value)
    }

    /// The values in braces; empty for a single value.
    pub(super) fn items(&self) -> &[(Option<&'t str>, Self)] {
        match self {
            Self::List(items) => items,
            Self::Value(_) => &[],
        }
    }

    /// The words of a value.
    pub(super) fn words(&self) -> Vec<&'t str> {
        let Self::Value(tokens) = self else { return Vec::new() };
        tokens.iter().filter_map(Token::word).collect()
    }
}

/// Reads an initialiser from its first token on, and returns the tokens after it; `None` if it does not end
/// or is nested too deeply.
pub(super) fn initialiser<'a, 't>(
    tokens: &'a [Token<'t>],
    depth: usize,
) -> Option<(Initialiser<'t>, &'a [Token<'t>])> {
    let Some(mut rest) = tokens.strip_prefix(&[Token::Mark('{')]) else { return value(tokens) };
    let mut items = Vec::new();
    loop {
        if let Some(behind) = rest.strip_prefix(&[Token::Mark('}')]) {
            return Some((Initialiser::List(items), behind));
        }
        let field = match rest {
            [Token::Mark('.'), Token::Word(field), Token::Mark('='), behind @ ..] => {
                rest = behind;
                Some(*field)
            }
            _ => None,
        };
        let (item, behind) = (depth < DEEPEST).then(|| initialiser(rest, depth + 1)).flatten()?;
        items.push((field, item));
        rest = behind.strip_prefix(&[Token::Mark(',')]).unwrap_or(behind);
    }
}

/// Reads up to a comma or a brace that is in no parentheses.
fn value<'a, 't>(tokens: &'a [Token<'t>]) -> Option<(Initialiser<'t>, &'a [Token<'t>])> {
    let mut open = 0_usize;
    let is_end = |token: &Token<'_>| {
        match token {
            Token::Mark('(') => open += 1,
            Token::Mark(')') => open = open.saturating_sub(1),
            Token::Mark(',' | '}' | ';') => return open == 0,
            _ => {}
        }
        false
    };
    let end = tokens.iter().position(is_end).filter(|end| *end > 0)?;
    Some((Initialiser::Value(tokens[..end].to_vec()), &tokens[end..]))
}
