//! The XML of gnosis, in which objdictgen stores Python objects: `<val type="numeric" value="4096" />`.

use std::borrow::Cow;
use std::cell::OnceCell;
use std::collections::HashMap;

use objdict_xdd::xml::{Element, ElementId, Tree};

/// The root of a project.
const ROOT: &str = "PyObject";

/// The content of an element.
pub(super) enum PickleDatum<'a> {
    Nothing,
    Bool(bool),
    /// A number, as written.
    Number(Cow<'a, str>),
    Text(Cow<'a, str>),
    List(Element<'a>),
    Map(Element<'a>),
}

/// A tree whose elements may refer to others.
pub(super) struct Pickle<'a> {
    tree: &'a Tree,
    /// The elements by id, collected when the first reference is resolved.
    ids: OnceCell<HashMap<Cow<'a, str>, ElementId>>,
}

/// Whether a tree is a project.
pub(crate) fn is_project(tree: &Tree) -> bool {
    tree.root().is_some_and(|root| root.name() == ROOT)
}

impl<'a> Pickle<'a> {
    pub(super) fn new(tree: &'a Tree) -> Self {
        Self { tree, ids: OnceCell::new() }
    }

    /// The attributes of the stored object: their names and elements.
    pub(super) fn attributes(&self) -> impl Iterator<Item = (Cow<'a, str>, Element<'a>)> {
        let children = self.tree.root().into_iter().flat_map(|root| root.children_named("attr"));
        children.filter_map(|child| Some((child.attribute("name")?.value(), child)))
    }

    /// The content of an element, or of the one that it refers to; `None` for types that objdictgen does not
    /// write.
    pub(super) fn datum(&self, element: Element<'a>) -> Option<PickleDatum<'a>> {
        let element = match element.attribute("refid") {
            Some(id) => self.tree.element(*self.ids().get(&*id.value())?),
            None => element,
        };
        let text = || match element.attribute("value") {
            Some(value) => unescaped(value.value()),
            None => element.text(),
        };
        Some(match &*element.attribute("type")?.value() {
            "None" => PickleDatum::Nothing,
            "True" => PickleDatum::Bool(true),
            "False" => PickleDatum::Bool(false),
            "numeric" => PickleDatum::Number(text()),
            "string" | "bytes" => PickleDatum::Text(text()),
            "list" | "tuple" => PickleDatum::List(element),
            "dict" => PickleDatum::Map(element),
            _ => return None,
        })
    }

    fn ids(&self) -> &HashMap<Cow<'a, str>, ElementId> {
        self.ids.get_or_init(|| {
            let elements = self.tree.root().into_iter().flat_map(Element::descendants);
            elements.filter_map(|element| Some((element.attribute("id")?.value(), element.id()))).collect()
        })
    }

    /// The keys and values of a map.
    pub(super) fn entries(
        &self,
        map: Element<'a>,
    ) -> impl Iterator<Item = (PickleDatum<'a>, Element<'a>)> + '_ {
        map.children_named("entry")
            .filter_map(|entry| Some((self.datum(entry.child("key")?)?, entry.child("val")?)))
    }

    /// The values of a map whose keys are names.
    pub(super) fn fields(&self, map: Element<'a>) -> impl Iterator<Item = (Cow<'a, str>, Element<'a>)> + '_ {
        self.entries(map).filter_map(|(key, value)| match key {
            PickleDatum::Text(key) => Some((key, value)),
            _ => None,
        })
    }

    /// The values of a map whose keys are indexes or sub-indexes.
    pub(super) fn numbered(&self, map: Element<'a>) -> impl Iterator<Item = (u16, Element<'a>)> + '_ {
        self.entries(map).filter_map(|(key, value)| match key {
            PickleDatum::Number(key) => Some((u16::try_from(integer(&key)?).ok()?, value)),
            _ => None,
        })
    }

    /// The number in an element.
    pub(super) fn number(&self, element: Element<'a>) -> Option<i64> {
        match self.datum(element)? {
            PickleDatum::Number(text) => integer(&text),
            PickleDatum::Bool(value) => Some(value.into()),
            _ => None,
        }
    }

    pub(super) fn flag(&self, element: Element<'a>) -> Option<bool> {
        self.number(element).map(|number| number != 0)
    }

    pub(super) fn text(&self, element: Element<'a>) -> Option<Cow<'a, str>> {
        match self.datum(element)? {
            PickleDatum::Text(text) => Some(text),
            _ => None,
        }
    }
}

/// A number without Python-specific syntax: the `L` of a long integer.
pub(super) fn plain_number(text: &str) -> &str {
    text.trim().trim_end_matches(['l', 'L'])
}

/// A whole number.
pub(super) fn integer(text: &str) -> Option<i64> {
    let text = plain_number(text);
    let digits = text.trim_start_matches(['+', '-']);
    let number = match digits.strip_prefix("0x").or_else(|| digits.strip_prefix("0X")) {
        Some(digits) => i64::from_str_radix(digits, 16).ok()?,
        None => digits.parse().ok()?,
    };
    if text.starts_with('-') { number.checked_neg() } else { Some(number) }
}

/// A string in an attribute, in which Python escapes non-ASCII characters.
fn unescaped(text: Cow<'_, str>) -> Cow<'_, str> {
    if !text.contains('\\') {
        return text;
    }
    let mut plain = String::with_capacity(text.len());
    let mut rest = &*text;
    while let Some(at) = rest.find('\\') {
        plain.push_str(&rest[..at]);
        rest = &rest[at + 1..];
        let (character, length) = escaped(rest).unwrap_or(('\\', 0));
        plain.push(character);
        rest = &rest[length..];
    }
    Cow::Owned(plain + rest)
}

/// The character of an escape after its `\`, and the length of the escape.
fn escaped(text: &str) -> Option<(char, usize)> {
    let kind = text.chars().next()?;
    let digits = match kind {
        'x' => 2,
        'u' => 4,
        'U' => 8,
        '\\' | '\'' | '"' => return Some((kind, 1)),
        'n' => return Some(('\n', 1)),
        'r' => return Some(('\r', 1)),
        't' => return Some(('\t', 1)),
        _ => return None,
    };
    let number = u32::from_str_radix(text.get(1..=digits)?, 16).ok()?;
    Some((char::from_u32(number)?, digits + 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn escapes_and_numbers_of_python() {
        assert_eq!(unescaped("a\\x00\\u2713\\\\b\\".into()), "a\0\u{2713}\\b\\");
        assert_eq!(unescaped("\\q\\x0".into()), "\\q\\x0");
        assert_eq!(
            (integer("4096L"), integer("-0x10"), integer("1.5"), integer("")),
            (Some(4096), Some(-16), None, None)
        );
    }
}
