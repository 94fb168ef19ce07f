//! Content before the root: the XML declaration and the document type.

use std::collections::HashMap;
use std::collections::hash_map::Entry;

use super::chars::{is_blank, is_name};
use super::expand::{Entities, Entity, EntityReference, MAX_EXPANSION, reference};
use super::tag::{RawAttribute, Steps, TagStep};
use crate::source::{Encoding, Span};

/// The content of an XML declaration.
#[derive(Debug, Default)]
pub(super) struct Declaration {
    /// The value of `encoding`.
    pub(super) encoding: Option<Span>,
    /// An error, with its position.
    pub(super) defect: Option<(Span, String)>,
}

/// Reads the declaration at `span`, `<?xml … ?>`.
pub(super) fn declaration(text: &str, span: Span) -> Declaration {
    let mut declaration = Declaration::default();
    let mut steps = Steps::declaration(text, span.start as usize + "<?xml".len());
    let mut order = ["version", "encoding", "standalone"].iter();
    let mut is_first = true;
    loop {
        let defect = match steps.next() {
            TagStep::Attribute(attribute) => {
                let name = attribute.name.of(text);
                if name == "encoding" {
                    declaration.encoding.get_or_insert(attribute.value);
                }
                let is_missed = is_first && name != "version";
                is_first = false;
                if order.any(|known| *known == name) && !is_missed {
                    value_defect(text, attribute)
                } else {
                    Some((attribute.name, format!("`{name}` is not allowed here in an XML declaration")))
                }
            }
            TagStep::MissingValue(name) => Some((name, format!("`{}` has no value", name.of(text)))),
            TagStep::MissingBlank(at) => Some((Span::empty(at), "a space is missing".to_owned())),
            TagStep::Junk(junk) => Some((junk, format!("unexpected `{}`", junk.of(text)))),
            TagStep::Unclosed(at) => {
                Some((Span::new(span.start, at), "the XML declaration has no `?>`".to_owned()))
            }
            TagStep::End(_) if is_first => Some((span, "the XML declaration has no `version`".to_owned())),
            TagStep::End(_) => return declaration,
        };
        let is_end = matches!(defect, Some((Span { start, .. }, _)) if start == span.start);
        declaration.defect = declaration.defect.take().or(defect);
        if is_end {
            return declaration;
        }
    }
}

fn value_defect(text: &str, attribute: RawAttribute) -> Option<(Span, String)> {
    let (name, value) = (attribute.name.of(text), attribute.value.of(text));
    let is_good = match name {
        _ if attribute.flaw.is_some() => false,
        "version" => value
            .strip_prefix("1.")
            .is_some_and(|minor| !minor.is_empty() && minor.bytes().all(|byte| byte.is_ascii_digit())),
        "standalone" => matches!(value, "yes" | "no"),
        _ => {
            let is_part = |byte: u8| byte.is_ascii_alphanumeric() || matches!(byte, b'.' | b'_' | b'-');
            value.bytes().next().is_some_and(|byte| byte.is_ascii_alphabetic()) && value.bytes().all(is_part)
        }
    };
    (!is_good).then(|| (attribute.value, format!("`{value}` is not a valid `{name}` of an XML declaration")))
}

/// The reason why the declared encoding cannot be correct; `None` if it can.
pub(super) fn encoding_defect(declared: Option<&str>, actual: Encoding, text: &str) -> Option<String> {
    let is_utf8 = matches!(actual, Encoding::Utf8 | Encoding::Utf8Bom);
    let is_utf16 = matches!(actual, Encoding::Utf16Le | Encoding::Utf16Be);
    let Some(declared) = declared else {
        let is_default = is_utf8 || is_utf16;
        return (!is_default)
            .then(|| format!("the file declares no encoding, which means UTF-8, but is in {actual}"));
    };
    let agrees = match declared.to_ascii_lowercase().as_str() {
        "utf-8" | "utf8" => is_utf8,
        "utf-16" | "utf16" | "unicode" => is_utf16,
        "utf-16le" => actual == Encoding::Utf16Le,
        "utf-16be" => actual == Encoding::Utf16Be,
        "iso-8859-1" | "latin1" | "latin-1" | "windows-1252" | "cp1252" => {
            actual == Encoding::Windows1252 || actual == Encoding::Utf8 && text.is_ascii()
        }
        "cp850" | "ibm850" => actual == Encoding::Cp850 || actual == Encoding::Utf8 && text.is_ascii(),
        // for other names, only ASCII text is safe, because almost all encodings contain ASCII
        _ => actual == Encoding::Utf8 && text.is_ascii(),
    };
    (!agrees).then(|| format!("the file declares the encoding `{declared}`, but is read as {actual}"))
}

/// The content of a document type.
#[derive(Debug, Default)]
pub(super) struct DocumentType {
    pub(super) entities: Entities,
    /// The error in it.
    pub(super) defect: Option<String>,
}

/// The maximum length of an entity in bytes.
const MAX_ENTITY: usize = 1 << 16;

/// The maximum depth of entities within entities.
const MAX_NESTING: usize = 16;

/// The declared entities of a document type: name and literal value, `None` for an external entity.
#[derive(Default)]
struct Declared<'a> {
    order: Vec<&'a str>,
    values: HashMap<&'a str, Option<&'a str>>,
}

/// Reads a document type, `<!DOCTYPE … >`: only its internal entities.
pub(super) fn document_type(text: &str) -> DocumentType {
    let mut declared = Declared::default();
    let defect = Scan { text, at: 0 }.read(&mut declared).err();
    let mut resolver = EntityResolver { declared: &declared, entities: Entities::default(), size: 0 };
    for name in &declared.order {
        resolver.resolve(name, 0);
    }
    DocumentType { entities: resolver.entities, defect }
}

/// Resolves the references in entities, each entity once.
struct EntityResolver<'a> {
    declared: &'a Declared<'a>,
    entities: Entities,
    /// The total size of all entities so far, in bytes.
    size: usize,
}

impl EntityResolver<'_> {
    fn resolve(&mut self, name: &str, depth: usize) -> Entity {
        if let Some(entity) = self.entities.declared.get(name) {
            return entity.clone();
        }
        // an entity that is found again during its own resolution contains itself
        self.entities.declared.insert(name.into(), Entity::Unread("it contains itself"));
        let entity = match self.expanded(name, depth) {
            Ok(text) => Entity::Text(text.into()),
            Err(reason) => Entity::Unread(reason),
        };
        if let Entity::Text(text) = &entity {
            self.size += text.len();
        }
        self.entities.declared.insert(name.into(), entity.clone());
        entity
    }

    fn expanded(&mut self, name: &str, depth: usize) -> Result<String, &'static str> {
        if depth > MAX_NESTING {
            return Err("its nesting is too deep");
        }
        let mut rest = match self.declared.values.get(name) {
            Some(Some(value)) => *value,
            Some(None) => return Err("external files are not read"),
            None => return Err("it refers to an entity that is not declared"),
        };
        let mut text = String::new();
        while let Some(at) = memchr::memchr2(b'&', b'<', rest.as_bytes()) {
            text.push_str(&rest[..at]);
            rest = &rest[at..];
            let length =
                if rest.starts_with('<') { return Err(MARKUP) } else { self.push(rest, depth, &mut text)? };
            rest = &rest[length..];
            if text.len() > MAX_ENTITY || self.size + text.len() > MAX_EXPANSION {
                return Err(TOO_LONG);
            }
        }
        text.push_str(rest);
        if text.len() > MAX_ENTITY || self.size + text.len() > MAX_EXPANSION {
            Err(TOO_LONG)
        } else {
            Ok(text)
        }
    }

    /// Appends the value of the reference at the start of `rest` to `text`.
    fn push(&mut self, rest: &str, depth: usize, text: &mut String) -> Result<usize, &'static str> {
        let (reference, length) = reference(rest);
        let is_number = rest.starts_with("&#");
        match reference {
            EntityReference::Character('<' | '&') if is_number => return Err(MARKUP),
            EntityReference::Character(character) => text.push(character),
            EntityReference::Entity(inner) => match self.resolve(inner, depth + 1) {
                Entity::Text(inner) => text.push_str(&inner),
                Entity::Unread(reason) => return Err(reason),
            },
            EntityReference::BadNumber | EntityReference::Lone => {
                return Err("it contains an invalid reference");
            }
        }
        Ok(length)
    }
}

const MARKUP: &str = "it contains markup";
const TOO_LONG: &str = "it expands to too much text";

/// A position in a document type.
struct Scan<'a> {
    text: &'a str,
    at: usize,
}

impl<'a> Scan<'a> {
    fn read(&mut self, declared: &mut Declared<'a>) -> Result<(), String> {
        self.expect("<!DOCTYPE")?;
        self.blank()?;
        self.name()?;
        if self.skip_blanks() && (self.rest().starts_with("SYSTEM") || self.rest().starts_with("PUBLIC")) {
            self.external_id()?;
            self.skip_blanks();
        }
        if self.rest().starts_with('[') {
            self.at += 1;
            self.subset(declared)?;
            self.skip_blanks();
        }
        self.expect(">")
    }

    /// Reads up to the `]` at the end of the internal subset.
    fn subset(&mut self, declared: &mut Declared<'a>) -> Result<(), String> {
        loop {
            self.skip_blanks();
            let rest = self.rest();
            if rest.starts_with(']') {
                self.at += 1;
                return Ok(());
            } else if rest.starts_with("<!--") {
                self.skip_to("-->")?;
            } else if rest.starts_with("<?") {
                self.skip_to("?>")?;
            } else if rest.starts_with("<!ENTITY") {
                self.at += "<!ENTITY".len();
                self.entity(declared)?;
            } else if ["<!ELEMENT", "<!ATTLIST", "<!NOTATION"].iter().any(|known| rest.starts_with(known)) {
                self.skip_declaration()?;
            } else if rest.starts_with('%') {
                self.skip_to(";")?;
            } else {
                return Err(self.unexpected());
            }
        }
    }

    fn entity(&mut self, declared: &mut Declared<'a>) -> Result<(), String> {
        self.blank()?;
        if self.rest().starts_with('%') {
            return self.skip_declaration();
        }
        let name = self.name()?;
        self.blank()?;
        let value = if self.rest().starts_with(['"', '\'']) {
            Some(self.literal()?)
        } else {
            self.external_id()?;
            if self.skip_blanks() && self.rest().starts_with("NDATA") {
                self.at += "NDATA".len();
                self.blank()?;
                self.name()?;
            }
            None
        };
        self.skip_blanks();
        self.expect(">")?;
        // the first declaration is used (XML 1.0 §4.2)
        if let Entry::Vacant(entry) = declared.values.entry(name) {
            entry.insert(value);
            declared.order.push(name);
        }
        Ok(())
    }

    fn external_id(&mut self) -> Result<(), String> {
        let is_public = self.rest().starts_with("PUBLIC");
        if !is_public && !self.rest().starts_with("SYSTEM") {
            return Err(self.unexpected());
        }
        self.at += "PUBLIC".len();
        for _ in 0..1 + usize::from(is_public) {
            self.blank()?;
            self.literal()?;
        }
        Ok(())
    }

    fn literal(&mut self) -> Result<&'a str, String> {
        let rest = self.rest();
        let quote = rest.bytes().next().filter(|byte| matches!(byte, b'"' | b'\''));
        let Some(quote) = quote else { return Err(self.unexpected()) };
        let Some(length) = memchr::memchr(quote, &rest.as_bytes()[1..]) else {
            return Err(self.unexpected());
        };
        self.at += length + 2;
        Ok(&rest[1..=length])
    }

    fn skip_declaration(&mut self) -> Result<(), String> {
        while let Some(length) = memchr::memchr3(b'>', b'"', b'\'', self.rest().as_bytes()) {
            self.at += length;
            if self.rest().starts_with('>') {
                self.at += 1;
                return Ok(());
            }
            self.literal()?;
        }
        Err(self.unexpected())
    }

    fn rest(&self) -> &'a str {
        self.text.get(self.at..).unwrap_or_default()
    }

    fn skip_blanks(&mut self) -> bool {
        let length = self.rest().bytes().take_while(|&byte| is_blank(byte)).count();
        self.at += length;
        length > 0
    }

    fn blank(&mut self) -> Result<(), String> {
        if self.skip_blanks() { Ok(()) } else { Err(self.unexpected()) }
    }

    fn name(&mut self) -> Result<&'a str, String> {
        let rest = self.rest();
        let is_end = |character: char| {
            character.is_ascii()
                && (is_blank(character as u8) || matches!(character, '[' | '>' | '"' | '\'' | '<'))
        };
        let name = &rest[..rest.find(is_end).unwrap_or(rest.len())];
        if !name.split(':').all(is_name) {
            return Err(self.unexpected());
        }
        self.at += name.len();
        Ok(name)
    }

    fn expect(&mut self, expected: &str) -> Result<(), String> {
        if !self.rest().starts_with(expected) {
            return Err(self.unexpected());
        }
        self.at += expected.len();
        Ok(())
    }

    fn skip_to(&mut self, mark: &str) -> Result<(), String> {
        match memchr::memmem::find(self.rest().as_bytes(), mark.as_bytes()) {
            Some(length) => {
                self.at += length + mark.len();
                Ok(())
            }
            None => Err(self.unexpected()),
        }
    }

    fn unexpected(&self) -> String {
        let shown: String =
            self.rest().chars().take(20).take_while(|character| !character.is_control()).collect();
        match shown.is_empty() {
            true => "the document type is malformed".to_owned(),
            false => format!("the document type is malformed at `{shown}`"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn entity(subset: &str, name: &str) -> Option<Entity> {
        let read = document_type(&format!("<!DOCTYPE a [{subset}]>"));
        assert_eq!(read.defect, None);
        read.entities.declared.get(name).cloned()
    }

    #[test]
    fn entities_are_replaced_in_entities() {
        let subset = "<!ENTITY a 'x&b;&#65;'><!-- > --><!ENTITY b \"y\"><!ENTITY b 'z'><!ELEMENT a ANY>";
        assert_eq!(entity(subset, "a"), Some(Entity::Text("xyA".into())));
    }

    #[test]
    fn what_is_not_text_is_not_read() {
        let is_unread = |subset: &str| matches!(entity(subset, "a"), Some(Entity::Unread(_)));
        assert!(is_unread("<!ENTITY a SYSTEM 'file:///etc/passwd'>"));
        assert!(is_unread("<!ENTITY a '<b/>'>"));
        assert!(is_unread("<!ENTITY a '&#60;b/>'>"));
        assert!(is_unread("<!ENTITY a '&b;'><!ENTITY b '&a;'>"));
        assert!(is_unread("<!ENTITY a '&b;'>"));
    }

    #[test]
    fn laughter_is_limited() {
        let mut subset = "<!ENTITY l0 'lol lol lol lol'>".to_owned();
        for level in 1..16 {
            let inner = format!("&l{};", level - 1).repeat(10);
            subset.push_str(&format!("<!ENTITY l{level} '{inner}'>"));
        }
        assert_eq!(entity(&subset, "l15"), Some(Entity::Unread(TOO_LONG)));
    }

    #[test]
    fn encodings_agree() {
        let defect = |declared, actual, text| encoding_defect(declared, actual, text).is_some();
        assert!(!defect(Some("UTF-8"), Encoding::Utf8Bom, "°"));
        assert!(!defect(Some("iso-8859-1"), Encoding::Utf8, "a"));
        assert!(defect(Some("iso-8859-1"), Encoding::Utf8, "°"));
        assert!(defect(Some("utf-16"), Encoding::Utf8, "a"));
        assert!(defect(Some("utf-8"), Encoding::Windows1252, "°"));
        assert!(defect(None, Encoding::Windows1252, "°"));
        assert!(!defect(None, Encoding::Utf16Le, "°"));
    }
}
