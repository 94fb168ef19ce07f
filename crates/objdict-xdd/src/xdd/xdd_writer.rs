//! Writes elements of CiA 311 in the namespaces of each version. Each id of a document is an XML name and unique; each
//! reference resolves to an id.

use std::borrow::Cow;
use std::collections::HashSet;
use std::rc::Rc;

use super::element::{MAX_SLOTS, Marks, Occurrence, SchemaElement};
use super::profile_class::ProfileClass;
use super::schema::{TextKind, is_name, is_name_character};
use super::version::XddVersion;
use crate::xml::{Name, WriterMark, XmlWriter, n};

/// Writes an XML document of CiA 311: accepts names without prefixes and writes them as the version requires.
///
/// In version 1.1, local elements of the schema are in no namespace, and the others have the prefix that
/// their `ProfileBody` declares, as in CANopenEditor. In version 1.0 nothing has a prefix, and additions of
/// version 1.1 are not written.
///
/// Only content that the table allows is written: an invalid string is omitted, and so is an element without
/// its required content, up to the nearest optional element. The caller detects such losses by reading the
/// result back.
#[derive(Debug)]
pub(crate) struct XddWriter {
    writer: XmlWriter,
    version: XddVersion,
    body: Option<ProfileClass>,
    /// The start tags that are not written yet, outermost first.
    pending: Vec<StartTag>,
    /// The open elements whose start tags are written.
    open: Vec<OpenTag>,
    /// The number of open elements that are not written: the version does not support them, required
    /// content is missing, or they are inside such an element.
    skipped: usize,
    /// The marks of the written part, and the position of the element among those with the same name.
    pub(super) marks: Marks,
    pub(super) number: u32,
    ids: WrittenIds,
    /// Whether only content that the table allows is written; `false` in tests of single elements.
    is_checked: bool,
}

#[derive(Debug)]
struct StartTag {
    element: &'static SchemaElement,
    name: Cow<'static, str>,
    attributes: Vec<(Cow<'static, str>, String)>,
    text: Option<String>,
    needs_content: bool,
    /// The state of the ids before it.
    ids: (usize, usize),
}

/// An element whose start tag is written.
#[derive(Debug)]
struct OpenTag {
    element: &'static SchemaElement,
    /// The state of the document before it.
    mark: WriterMark,
    ids: (usize, usize),
    /// The number of children in each slot.
    counts: [u32; MAX_SLOTS],
}

/// The prefix of global elements in a body of version 1.1.
const fn prefix(body: ProfileClass) -> &'static str {
    body.pick("q1", "q2")
}

impl XddWriter {
    /// An empty document of a version. With `known`, only these ids are referred to.
    pub(crate) fn new(version: XddVersion, known: Option<HashSet<Rc<str>>>) -> Self {
        Self {
            writer: XmlWriter::new(),
            version,
            body: None,
            pending: Vec::new(),
            open: Vec::new(),
            skipped: 0,
            marks: Vec::new(),
            number: 1,
            ids: WrittenIds::new(known),
            is_checked: true,
        }
    }

    /// An empty document that accepts everything.
    #[cfg(test)]
    pub(crate) fn unchecked(version: XddVersion) -> Self {
        Self { is_checked: false, ..Self::new(version, None) }
    }

    /// The version of the document.
    pub(crate) fn version(&self) -> XddVersion {
        self.version
    }

    /// Opens the root, `ISO15745ProfileContainer`.
    pub(crate) fn open_container(&mut self, container: &'static SchemaElement) {
        self.open(container);
        self.declare("xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance");
        self.declare("xmlns", self.version.namespace());
    }

    /// Opens a `ProfileBody`; its own attributes follow. [`close_body`](Self::close_body) closes it.
    pub(crate) fn open_body(&mut self, body: ProfileClass, element: &'static SchemaElement) {
        self.open(element);
        match self.version {
            XddVersion::V1_0 => self.declare("xsi:type", body.type_name()),
            XddVersion::V1_1 => {
                self.declare(format!("xmlns:{}", prefix(body)), self.version.namespace());
                self.declare("xsi:type", &format!("{}:{}", prefix(body), body.type_name()));
                self.declare("xmlns", "");
            }
        }
        self.body = Some(body);
    }

    /// Closes the `ProfileBody`.
    pub(crate) fn close_body(&mut self) {
        self.body = None;
        self.close();
    }

    /// Opens an element. Its attributes and its text or elements follow.
    pub(crate) fn open(&mut self, element: &'static SchemaElement) {
        self.start(element, element.is_global, false);
    }

    /// Writes an element with only attributes.
    pub(crate) fn empty(&mut self, element: &'static SchemaElement, attributes: &[(Name, &str)]) {
        self.open(element);
        attributes.iter().for_each(|(name, text)| self.attribute(*name, text));
        self.close();
    }

    /// Opens an element at a position that the standard does not allow: it is not written.
    pub(crate) fn open_stray(&mut self, element: &'static SchemaElement) {
        if self.is_checked {
            self.skipped += 1;
        } else {
            self.start(element, element.is_global && self.body == Some(ProfileClass::Device), false);
        }
    }

    /// Opens an element that is written only if it gets attributes, a text or elements.
    pub(crate) fn open_unless_empty(&mut self, element: &'static SchemaElement) {
        self.start(element, element.is_global, true);
    }

    /// Adds an attribute to the element opened last, before any of its children, if its value is valid.
    pub(crate) fn attribute(&mut self, name: Name, value: &str) {
        if self.skipped > 0 || self.is_too_new(name) {
            return;
        }
        let known = self.pending.last().and_then(|start| start.element.attribute(name));
        let text = match known {
            Some((_, known)) if self.is_checked => match known.kind {
                _ if known.need == Occurrence::Stray => None,
                TextKind::Id => Some(self.ids.define(value)),
                TextKind::Reference(_) => self.ids.refer(value),
                kind => kind.accepts(value).then_some(Cow::Borrowed(value)),
            },
            _ => Some(Cow::Borrowed(value)),
        };
        if let Some(text) = text {
            self.declare(name.text(), &text);
        }
    }

    /// Applies the marks to the element opened last.
    pub(super) fn mark(&mut self, name: &str) {
        if let Some((_, mark)) = self.marks.iter().rev().find(|(marked, _)| **marked == *name) {
            self.attribute(n::readOnly, if *mark { "true" } else { "false" });
        }
    }

    /// Adds an attribute that CiA 311 does not define.
    fn declare(&mut self, name: impl Into<Cow<'static, str>>, value: &str) {
        if let Some(start) = self.pending.last_mut().filter(|_| self.skipped == 0) {
            start.attributes.push((name.into(), value.to_owned()));
        }
    }

    /// Sets the text of the element opened last, which then cannot have children.
    pub(crate) fn text(&mut self, text: &str) {
        if self.skipped > 0 {
            return;
        }
        if let Some(start) = self.pending.last_mut() {
            start.text.get_or_insert_default().push_str(text);
        }
    }

    /// Closes the element opened last.
    pub(crate) fn close(&mut self) {
        if self.skipped > 0 {
            self.skipped -= 1;
            return;
        }
        let Some(mut start) = self.pending.pop() else { return self.close_open() };
        if start.needs_content && start.attributes.is_empty() && start.text.is_none() {
            return;
        }
        if self.is_checked && !(start.complete(self.version) && start.is_whole()) {
            return self.ids.reset(start.ids);
        }
        self.write_pending();
        self.writer.text_element(&start.name, start.attributes(), start.text.as_deref().unwrap_or_default());
        self.count(start.element);
    }

    /// Closes the innermost element with children. It is discarded if a required child is missing.
    fn close_open(&mut self) {
        let Some(OpenTag { element, mark, ids, counts }) = self.open.pop() else { return };
        let lacks = element.content.iter().zip(counts).any(|(slot, count)| count < slot.least);
        if self.is_checked && lacks {
            self.writer.reset(mark);
            self.ids.reset(ids);
        } else {
            self.writer.close();
            self.count(element);
        }
    }

    /// Counts a written child of the innermost element.
    fn count(&mut self, child: &'static SchemaElement) {
        if let Some(OpenTag { element, counts, .. }) = self.open.last_mut()
            && let Some((number, _)) = element.slot(child.name, 0)
        {
            counts[number] += 1;
        }
    }

    /// The number of children with this name in the innermost element; for a choice, of all its names.
    pub(crate) fn count_of(&self, name: Name) -> u32 {
        match self.open.last().filter(|_| self.pending.is_empty()) {
            Some(open) => open.element.slot(name, 0).map_or(0, |(number, _)| open.counts[number]),
            None => 0,
        }
    }

    /// Closes all open elements and returns the document. If a reference is dangling, also returns the ids for
    /// writing it again.
    pub(crate) fn finish(mut self) -> (String, Option<HashSet<Rc<str>>>) {
        while self.skipped > 0 || !self.pending.is_empty() || !self.open.is_empty() {
            self.close();
        }
        (self.writer.finish(), self.ids.into_known())
    }

    /// Whether the version does not have an element or attribute in the innermost open element.
    fn is_too_new(&self, name: Name) -> bool {
        let open = self.open.last().map(|open| open.element);
        let parent = self.pending.last().map(|start| start.element).or(open);
        self.version == XddVersion::V1_0 && parent.is_some_and(|parent| parent.newer.contains(&name))
    }

    fn start(&mut self, element: &'static SchemaElement, is_global: bool, needs_content: bool) {
        if self.skipped > 0 || self.is_too_new(element.name) || self.is_checked && self.is_full(element) {
            self.skipped += 1;
            return;
        }
        // the attributes of the element around it are all there
        if self.is_checked
            && let Some(mut around) = self.pending.pop()
        {
            if !around.complete(self.version) {
                self.ids.reset(around.ids);
                self.skipped += 2;
                return;
            }
            self.pending.push(around);
        }
        let name = element.name.text();
        let name = match self.body {
            Some(body) if self.version == XddVersion::V1_1 && is_global => {
                Cow::Owned([prefix(body), ":", name].concat())
            }
            _ => Cow::Borrowed(name),
        };
        let ids = self.ids.mark();
        self.pending.push(StartTag { element, name, attributes: Vec::new(), text: None, needs_content, ids });
        // the header and its content are in no namespace
        if element.name == n::ProfileHeader && self.version == XddVersion::V1_1 {
            self.declare("xmlns", "");
        }
    }

    /// Writes the pending start tags before content of their elements.
    fn write_pending(&mut self) {
        for start in self.pending.drain(..) {
            let mark = self.writer.mark();
            self.writer.open(&start.name, start.attributes());
            self.open.push(OpenTag { element: start.element, mark, ids: start.ids, counts: [0; MAX_SLOTS] });
        }
    }

    /// Whether the innermost element accepts no further child of this name.
    fn is_full(&self, child: &SchemaElement) -> bool {
        let Some(open) = self.open.last().filter(|_| self.pending.is_empty()) else { return false };
        let slot = open.element.slot(child.name, 0);
        slot.is_some_and(|(number, known)| open.counts[number] >= open.element.content[number].most_of(known))
    }
}

impl StartTag {
    /// Adds placeholders for missing attributes; `false` if one has none.
    fn complete(&mut self, version: XddVersion) -> bool {
        for known in self.element.attributes {
            let is_demanded = matches!(known.need, Occurrence::Required | Occurrence::Key)
                && !(version == XddVersion::V1_0 && self.element.newer.contains(&known.name));
            if is_demanded && !self.attributes.iter().any(|(name, _)| *name == known.name.text()) {
                let Some(text) = known.placeholder() else { return false };
                self.attributes.push((known.name.text().into(), text.to_owned()));
            }
        }
        true
    }

    /// Whether the element, which has no children, needs none and its text is valid.
    fn is_whole(&self) -> bool {
        let takes = |kind: TextKind| kind.accepts(self.text.as_deref().unwrap_or_default());
        self.element.content.iter().all(|slot| slot.least == 0)
            && self.element.text.is_none_or(|text| takes(text.kind))
    }

    fn attributes(&self) -> impl Iterator<Item = (&str, &str)> {
        self.attributes.iter().map(|(name, value)| (&**name, value.as_str()))
    }
}

/// The ids and the references written so far.
#[derive(Debug, Default)]
pub(crate) struct WrittenIds {
    /// In document order.
    defined: Vec<Rc<str>>,
    set: HashSet<Rc<str>>,
    references: Vec<Rc<str>>,
    /// The valid targets of references; `None` allows any.
    known: Option<HashSet<Rc<str>>>,
}

impl WrittenIds {
    /// Starts without ids. With `known`, other references are not written.
    pub(crate) fn new(known: Option<HashSet<Rc<str>>>) -> Self {
        Self { known, ..Self::default() }
    }

    /// The id for an element: the string as a unique name.
    pub(crate) fn define<'t>(&mut self, text: &'t str) -> Cow<'t, str> {
        let name = name_of(text);
        let mut free = name.clone();
        let mut number = 1;
        while self.set.contains(&*free) {
            number += 1;
            free = Cow::Owned(format!("{name}_{number}"));
        }
        let id: Rc<str> = (*free).into();
        self.defined.push(Rc::clone(&id));
        self.set.insert(id);
        free
    }

    /// The id for a reference; `None` if no element has it.
    pub(crate) fn refer<'t>(&mut self, text: &'t str) -> Option<Cow<'t, str>> {
        let name = name_of(text);
        let leads = self.known.as_ref().is_none_or(|known| known.contains(&*name));
        if text.trim_ascii().is_empty() || !leads {
            return None;
        }
        self.references.push(self.set.get(&*name).map_or_else(|| (*name).into(), Rc::clone));
        Some(name)
    }

    /// A mark for [`reset`](Self::reset).
    pub(crate) fn mark(&self) -> (usize, usize) {
        (self.defined.len(), self.references.len())
    }

    /// Discards all ids and references after a mark.
    pub(crate) fn reset(&mut self, (defined, references): (usize, usize)) {
        for id in self.defined.drain(defined..) {
            self.set.remove(&id);
        }
        self.references.truncate(references);
    }

    /// The existing ids, if a reference is dangling.
    pub(crate) fn into_known(self) -> Option<HashSet<Rc<str>>> {
        let Self { set, references, known, .. } = self;
        if references.iter().all(|reference| set.contains(reference)) {
            return None;
        }
        // the set shrinks each round, so rewriting terminates
        Some(match known {
            Some(known) => set.into_iter().filter(|id| known.contains(id)).collect(),
            None => set,
        })
    }
}

/// Converts a string to an XML name: unchanged if it is one, and always the same name for the same string.
fn name_of(text: &str) -> Cow<'_, str> {
    let text = text.trim_ascii();
    if is_name(text) {
        return Cow::Borrowed(text);
    }
    let mut name = "ID_".to_owned();
    for character in text.chars() {
        match is_name_character(character) {
            true => name.push(character),
            false => name.push_str(&format!("_{:X}", u32::from(character))),
        }
    }
    Cow::Owned(name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_are_names_and_unique() {
        let mut ids = WrittenIds::default();
        for (text, expected) in [
            ("a", "a"),
            ("a", "a_2"),
            ("1000-1", "ID_1000-1"),
            ("a b", "ID_a_20b"),
            ("", "ID_"),
            ("", "ID__2"),
        ] {
            assert_eq!(ids.define(text), expected);
        }
        assert_eq!(ids.refer("1000-1").as_deref(), Some("ID_1000-1"));
        assert_eq!(ids.refer(" "), None);
        let mark = ids.mark();
        ids.define("b");
        ids.refer("b");
        ids.reset(mark);
        assert_eq!(ids.define("b"), "b");
        ids.refer("c");
        let known = ids.into_known().unwrap();
        assert!(known.contains("b") && !known.contains("c"));
        assert_eq!(WrittenIds::new(Some(known)).refer("c"), None);
    }
}
