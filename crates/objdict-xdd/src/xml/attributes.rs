//! The attributes of a start tag: parsing, names, namespaces.

use std::collections::HashMap;
use std::ops::Range;

use super::build::{MAX_NAME, TreeBuilder};
use super::chars::{is_blank, plain_name_length, plain_value_length, prefix_length};
use super::findings::{self as rules, shown};
use super::names::Name;
use super::namespaces::{XML, XMLNS};
use super::parts::{AttributeRecord, DECLARES, NONE};
use super::tag::{Flaw, RawAttribute, Steps, TagStep};
use crate::diagnostic::Diagnostic;
use crate::source::Span;

/// The maximum number of attributes of an element.
const MAX_ATTRIBUTES: usize = 256;

/// Above this number, a hash table finds the duplicates.
const FEW: usize = 16;

impl<'a> TreeBuilder<'a, '_> {
    /// Fast path for almost all tags: reads the attributes from `at` on if all are well-formed, have CiA 311
    /// names without prefix and values without references. Returns the end of the tag and whether it is
    /// `<a/>`; `None` if nothing was read.
    pub(super) fn plain_attributes(&mut self, at: usize) -> Option<(usize, bool)> {
        let first = self.parts.attributes.len();
        let found = self.plain_attributes_behind(first, at);
        if found.is_none() {
            self.parts.attributes.truncate(first);
        }
        found
    }

    fn plain_attributes_behind(&mut self, first: usize, mut at: usize) -> Option<(usize, bool)> {
        let bytes = self.text.as_bytes();
        loop {
            let before = at;
            while is_blank(*bytes.get(at)?) {
                at += 1;
            }
            match bytes[at..] {
                [b'>', ..] => return Some((at + 1, false)),
                [b'/', b'>', ..] => return Some((at + 2, true)),
                _ if at == before || self.parts.attributes.len() >= first + MAX_ATTRIBUTES => return None,
                _ => {}
            }
            let length = plain_name_length(&bytes[at..]);
            let tag = Name::of_bytes(&bytes[at..at + length]);
            let (name, value) = (at, at + length + 2);
            let &[b'=', quote @ (b'"' | b'\'')] = bytes.get(at + length..value)? else { return None };
            let mut end = value;
            let mut is_plain = true;
            loop {
                end += plain_value_length(bytes.get(end..)?);
                match *bytes.get(end)? {
                    byte if byte == quote => break,
                    b'<' | b'&' => return None,
                    byte => is_plain &= !matches!(byte, b'\t' | b'\n' | b'\r'),
                }
                end += 1;
            }
            let is_known = self.parts.attributes[first..].iter().any(|known| known.tag == tag);
            if tag == Name::OTHER || is_known {
                return None;
            }
            self.parts.attributes.push(AttributeRecord {
                name: name as u32,
                value: value as u32,
                value_end: end as u32,
                name_length: length as u16,
                prefix_length: 0,
                tag,
                is_plain,
            });
            at = end + 1;
        }
    }

    /// Collects the attributes of the tag with this name. Returns the end of the tag and whether it is
    /// `<a/>`.
    pub(super) fn tag(&mut self, name: Range<usize>, is_read: bool) -> (usize, bool) {
        let text = self.text;
        let mut steps = Steps::tag(text, name.end);
        let mut count = 0;
        self.raw.clear();
        loop {
            let step = steps.next();
            match step {
                TagStep::End(end) => {
                    let is_empty = text.as_bytes().get(end as usize - 2) == Some(&b'/');
                    return (end as usize, is_empty);
                }
                TagStep::Unclosed(end) => {
                    if is_read {
                        let span = Self::span(name.start - 1, name.end);
                        self.defect(&rules::UNCLOSED_TAG, span, |_| {
                            format!("the start tag `<{}` has no `>`", shown(&text[name.clone()]))
                        });
                    }
                    return (end as usize, false);
                }
                _ if !is_read => {}
                TagStep::Attribute(attribute) => {
                    count += 1;
                    if count <= MAX_ATTRIBUTES {
                        self.flaw(attribute);
                        self.raw.push(attribute);
                    } else if count == MAX_ATTRIBUTES + 1 {
                        let message = format!("an element has more than {MAX_ATTRIBUTES} attributes");
                        self.limit(attribute.name.start as usize, message);
                    }
                }
                TagStep::MissingValue(name) => {
                    self.defect(&rules::MISSING_VALUE, name, |name| {
                        format!("the attribute `{name}` has no value")
                    });
                }
                TagStep::MissingBlank(at) => {
                    self.defect(&rules::MISSING_BLANK, Span::empty(at), |_| "a space is missing".to_owned());
                }
                TagStep::Junk(junk) => {
                    self.defect(&rules::JUNK_IN_TAG, junk, |junk| format!("unexpected `{junk}` in a tag"));
                }
            }
        }
    }

    fn flaw(&mut self, attribute: RawAttribute) {
        let name = attribute.name.of(self.text);
        let of = |what: &str| format!("the value of `{}` {what}", shown(name));
        match attribute.flaw {
            None => {}
            Some(Flaw::Unquoted) => {
                self.defect(&rules::UNQUOTED_VALUE, attribute.value, |_| of("has no quotes"));
            }
            Some(Flaw::Unclosed) => {
                let span = Span::new(attribute.value.start - 1, attribute.value.end);
                self.defect(&rules::UNCLOSED_VALUE, span, |_| of("has no closing quote"));
            }
            Some(Flaw::LessThan(at)) => {
                self.report(&rules::LESS_THAN_IN_VALUE, || {
                    Diagnostic::new(&rules::LESS_THAN_IN_VALUE, Span::new(at, at + 1), of("contains `<`"))
                        .help("write `&lt;`")
                });
            }
        }
    }

    /// Adds the collected attributes to the newest element, which has this name, and resolves their
    /// namespaces.
    pub(super) fn attributes(&mut self, name: Range<usize>) {
        let text = self.text;
        let first = self.parts.attributes.len();
        let is_many = self.raw.len() > FEW;
        let mut names = is_many.then(HashMap::new);
        let raw = std::mem::take(&mut self.raw);
        for (number, attribute) in raw.iter().enumerate() {
            let name = attribute.name.of(text);
            let known = match &mut names {
                Some(names) => names.insert(name, attribute.name),
                None => raw[..number].iter().map(|other| other.name).find(|other| {
                    // most names differ in length, which is cheap to check
                    other.len() == attribute.name.len() && other.of(text) == name
                }),
            };
            if let Some(known) = known {
                self.duplicate(attribute.name, known);
            } else if name.len() > MAX_NAME {
                self.limit(attribute.name.start as usize, format!("a name has more than {MAX_NAME} bytes"));
            } else {
                self.attribute(*attribute);
            }
        }
        self.raw = raw;
        self.name_element(name);
        self.check_prefixes(first);
    }

    /// Resolves the name and the namespace of the newest element, whose attributes are already added.
    pub(super) fn name_element(&mut self, name: Range<usize>) {
        let (element_prefix, tag) = self.prefix_of(Self::span(name.start, name.end));
        let namespace = self.namespace_of(Self::span(name.start, name.end), element_prefix);
        if let Some(record) = self.parts.elements.last_mut() {
            record.prefix_length = element_prefix as u16;
            record.namespace = namespace;
            record.tag = tag;
        }
    }

    fn duplicate(&mut self, name: Span, known: Span) {
        let text = self.text;
        self.report(&rules::DUPLICATE_ATTRIBUTE, || {
            let message = format!("the element already has the attribute `{}`", shown(name.of(text)));
            Diagnostic::new(&rules::DUPLICATE_ATTRIBUTE, name, message).label(known, "first here")
        });
    }

    fn attribute(&mut self, attribute: RawAttribute) {
        let text = self.text;
        let name = attribute.name.of(text);
        let value = attribute.value.of(text);
        if self.has_references {
            for at in memchr::memchr_iter(b'&', value.as_bytes()) {
                self.check_reference(attribute.value.start as usize + at);
            }
        }
        let (length, tag) = self.prefix_of(attribute.name);
        let is_known = tag != Name::OTHER && length == 0;
        let declares = !is_known && (name == "xmlns" || name.starts_with("xmlns:") && length > 0);
        if declares {
            self.declare(attribute);
        }
        self.parts.attributes.push(AttributeRecord {
            name: attribute.name.start,
            value: attribute.value.start,
            value_end: attribute.value.end,
            name_length: name.len() as u16,
            prefix_length: length as u16 | if declares { DECLARES } else { 0 },
            tag,
            is_plain: value.bytes().all(|byte| !matches!(byte, b'&' | b'\t' | b'\n' | b'\r')),
        });
    }

    /// The length of the prefix with its colon, and the name after it.
    fn prefix_of(&mut self, name: Span) -> (usize, Name) {
        let text = name.of(self.text);
        let tag = Name::of(text);
        if tag != Name::OTHER {
            return (0, tag);
        }
        let length = prefix_length(text);
        if length.is_none() {
            self.defect(&rules::BAD_NAME, name, |name| format!("`{name}` is not a valid XML name"));
        }
        match length {
            None | Some(0) => (0, Name::OTHER),
            Some(length) => (length, Name::of(&text[length..])),
        }
    }

    /// Adds a namespace declaration, unless Namespaces in XML forbids it.
    fn declare(&mut self, attribute: RawAttribute) {
        let text = self.text;
        let prefix = attribute.name.of(text).strip_prefix("xmlns:").unwrap_or_default();
        let uri = self.parts.entities.value(attribute.value.of(text)).into_owned();
        let is_allowed = match (prefix, uri.as_str()) {
            ("xmlns", _) | (_, XMLNS) => false,
            ("xml", uri) => uri == XML,
            (_, XML) => false,
            (prefix, uri) => prefix.is_empty() || !uri.is_empty(),
        };
        if is_allowed {
            self.namespaces.declare(prefix, &uri);
        } else {
            let what = if prefix.is_empty() { "xmlns" } else { prefix };
            let span = Span::new(attribute.name.start, attribute.value.end);
            self.defect(&rules::BAD_NAMESPACE, span, |_| match uri.is_empty() {
                true => format!("the prefix `{}` is declared without a namespace", shown(what)),
                false => format!("`{}` cannot be declared as `{}`", shown(what), shown(&uri)),
            });
        }
    }

    /// The namespace of the name of an element or attribute.
    fn namespace_of(&mut self, name: Span, prefix_length: usize) -> u32 {
        let text = self.text;
        let prefix = &name.of(text)[..prefix_length.saturating_sub(1)];
        let found = self.namespaces.of(prefix);
        if found.is_none() {
            let span = Span::new(name.start, name.start + prefix.len() as u32);
            self.defect(&rules::UNBOUND_PREFIX, span, |prefix| {
                format!("the prefix `{prefix}` is not declared")
            });
        }
        found.unwrap_or(NONE)
    }

    /// Resolves the prefixes of the attributes from `first` on, and reports those that have the same
    /// expanded name.
    fn check_prefixes(&mut self, first: usize) {
        let mut seen = None;
        for number in first..self.parts.attributes.len() {
            let record = self.parts.attributes[number];
            let length = record.prefix_length;
            if length == 0 || length & DECLARES != 0 {
                continue;
            }
            let name = Span::new(record.name, record.name + u32::from(record.name_length));
            let namespace = self.namespace_of(name, usize::from(length));
            let local = &name.of(self.text)[usize::from(length)..];
            if namespace == NONE {
                continue;
            }
            if let Some(known) = seen.get_or_insert_with(HashMap::new).insert((namespace, local), name) {
                self.duplicate(name, known);
            }
        }
    }
}
