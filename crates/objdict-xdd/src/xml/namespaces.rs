//! The namespaces of prefixes while elements are opened and closed.

use std::collections::HashMap;

use super::parts::NONE;

/// The namespace of the prefix `xml`, which needs no declaration.
pub(super) const XML: &str = "http://www.w3.org/XML/1998/namespace";

/// The namespace of the declarations themselves.
pub(super) const XMLNS: &str = "http://www.w3.org/2000/xmlns/";

/// The prefixes declared at the current position.
pub(super) struct Namespaces<'a> {
    /// The namespace of each prefix; the empty prefix has the default namespace.
    current: HashMap<&'a str, u32>,
    default: u32,
    /// The last prefix looked up, and its namespace: most elements have the same.
    last: Option<(&'a str, u32)>,
    /// The bindings that declarations replaced, to be restored at the end of their elements.
    hidden: Vec<(&'a str, Option<u32>)>,
    uris: Vec<Box<str>>,
    numbers: HashMap<Box<str>, u32>,
}

impl<'a> Namespaces<'a> {
    pub(super) fn new() -> Self {
        let mut namespaces = Self {
            current: HashMap::new(),
            default: NONE,
            last: None,
            hidden: Vec::new(),
            uris: Vec::new(),
            numbers: HashMap::new(),
        };
        let xml = namespaces.number(XML);
        namespaces.current.insert("xml", xml);
        namespaces
    }

    /// The namespace of a prefix, [`NONE`] for no namespace; `None` for an undeclared prefix.
    pub(super) fn of(&mut self, prefix: &'a str) -> Option<u32> {
        match self.last {
            _ if prefix.is_empty() => return Some(self.default),
            Some((last, number)) if last == prefix => return Some(number),
            _ => {}
        }
        let number = self.current.get(prefix).copied()?;
        self.last = Some((prefix, number));
        Some(number)
    }

    /// Adds a declaration; [`forget`](Self::forget) removes it.
    pub(super) fn declare(&mut self, prefix: &'a str, uri: &str) {
        self.last = None;
        let number = if uri.is_empty() { NONE } else { self.number(uri) };
        if prefix.is_empty() {
            self.hidden.push((prefix, Some(self.default)));
            self.default = number;
        } else {
            self.hidden.push((prefix, self.current.insert(prefix, number)));
        }
    }

    /// A mark for [`forget`](Self::forget).
    pub(super) fn mark(&self) -> usize {
        self.hidden.len()
    }

    /// Removes the declarations since `mark`.
    pub(super) fn forget(&mut self, mark: usize) {
        while self.hidden.len() > mark {
            self.last = None;
            match self.hidden.pop() {
                Some(("", before)) => self.default = before.unwrap_or(NONE),
                Some((prefix, Some(before))) => {
                    self.current.insert(prefix, before);
                }
                Some((prefix, None)) => {
                    self.current.remove(prefix);
                }
                None => {}
            }
        }
    }

    /// All URIs, by number.
    pub(super) fn into_uris(self) -> Vec<Box<str>> {
        self.uris
    }

    fn number(&mut self, uri: &str) -> u32 {
        if let Some(&number) = self.numbers.get(uri) {
            return number;
        }
        let number = self.uris.len() as u32;
        self.uris.push(uri.into());
        self.numbers.insert(uri.into(), number);
        number
    }
}
