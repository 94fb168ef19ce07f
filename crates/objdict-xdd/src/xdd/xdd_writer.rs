//! Writes elements of CiA 311 in the namespaces of each version.

use std::borrow::Cow;

use super::layout::ProfileClass;
use super::schema::{CONTAINER, Element};
use super::version::XddVersion;
use crate::xml::{Name, XmlWriter, n};

/// Writes an XML document of CiA 311: takes names without prefixes and writes them as the version requires.
///
/// In version 1.1, local elements of the schema are in no namespace, and the others have the prefix that the
/// `ProfileBody` around them declares, as in CANopenEditor. In version 1.0 nothing has a prefix, and
/// additions of version 1.1 are not written.
#[derive(Debug)]
pub(crate) struct XddWriter {
    writer: XmlWriter,
    version: XddVersion,
    body: Option<ProfileClass>,
    /// The start tags that are not written yet, from the outermost to the innermost.
    pending: Vec<Start>,
    /// The open elements whose start tags are written.
    open: Vec<&'static Element>,
    /// The number of open elements that the version does not have, or that are inside such an element.
    skipped: usize,
}

#[derive(Debug)]
struct Start {
    element: &'static Element,
    name: Cow<'static, str>,
    attributes: Vec<(Cow<'static, str>, String)>,
    text: Option<String>,
    needs_content: bool,
}

/// The prefix of global elements in a body of version 1.1.
const fn prefix(body: ProfileClass) -> &'static str {
    match body {
        ProfileClass::Device => "q1",
        ProfileClass::Network => "q2",
    }
}

impl XddWriter {
    /// An empty document of a version.
    pub(crate) fn new(version: XddVersion) -> Self {
        Self {
            writer: XmlWriter::new(),
            version,
            body: None,
            pending: Vec::new(),
            open: Vec::new(),
            skipped: 0,
        }
    }

    /// The version of the document.
    pub(crate) fn version(&self) -> XddVersion {
        self.version
    }

    /// Opens the root, `ISO15745ProfileContainer`.
    pub(crate) fn open_container(&mut self) {
        self.open(&CONTAINER);
        self.declare("xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance");
        self.declare("xmlns", self.version.namespace());
    }

    /// Opens a `ProfileBody`; its own attributes follow. [`close_body`](Self::close_body) closes it.
    pub(crate) fn open_body(&mut self, body: ProfileClass) {
        self.open(body.body());
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
    pub(crate) fn open(&mut self, element: &'static Element) {
        self.start(element, element.is_global, false);
    }

    /// Opens an element at a place that the standard does not define: in no namespace.
    pub(crate) fn open_local(&mut self, element: &'static Element) {
        self.start(element, element.is_global && self.body == Some(ProfileClass::Device), false);
    }

    /// Opens an element that is only written if it gets attributes, a text or elements.
    pub(crate) fn open_unless_empty(&mut self, element: &'static Element) {
        self.start(element, element.is_global, true);
    }

    /// Adds an attribute to the element opened last, before any of its children.
    pub(crate) fn attribute(&mut self, name: Name, value: &str) {
        if !self.is_too_new(name) {
            self.declare(name.text(), value);
        }
    }

    /// Adds an attribute that CiA 311 does not define.
    fn declare(&mut self, name: impl Into<Cow<'static, str>>, value: &str) {
        if let Some(start) = self.pending.last_mut().filter(|_| self.skipped == 0) {
            start.attributes.push((name.into(), value.to_owned()));
        }
    }

    /// Sets the text of the element opened last, which must not get children then.
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
        let Some(start) = self.pending.pop() else {
            if self.open.pop().is_some() {
                self.writer.close();
            }
            return;
        };
        if start.needs_content && start.attributes.is_empty() && start.text.is_none() {
            return;
        }
        self.write_pending();
        self.writer.text_element(&start.name, &start.attributes(), start.text.as_deref().unwrap_or_default());
    }

    /// The document. Closes all open elements.
    pub(crate) fn finish(mut self) -> String {
        while self.skipped > 0 || !self.pending.is_empty() || !self.open.is_empty() {
            self.close();
        }
        self.writer.finish()
    }

    /// Whether the version does not have an element or attribute in the innermost open element.
    fn is_too_new(&self, name: Name) -> bool {
        let parent = self.pending.last().map(|start| start.element).or(self.open.last().copied());
        self.version == XddVersion::V1_0 && parent.is_some_and(|parent| parent.newer.contains(&name))
    }

    fn start(&mut self, element: &'static Element, is_global: bool, needs_content: bool) {
        if self.skipped > 0 || self.is_too_new(element.name) {
            self.skipped += 1;
            return;
        }
        let name = element.name.text();
        let name = match self.body {
            Some(body) if self.version == XddVersion::V1_1 && is_global => {
                Cow::Owned(format!("{}:{name}", prefix(body)))
            }
            _ => Cow::Borrowed(name),
        };
        self.pending.push(Start { element, name, attributes: Vec::new(), text: None, needs_content });
        // the header and its content are in no namespace
        if element.name == n::ProfileHeader && self.version == XddVersion::V1_1 {
            self.declare("xmlns", "");
        }
    }

    /// Writes the pending start tags before content of their elements.
    fn write_pending(&mut self) {
        for start in self.pending.drain(..) {
            self.writer.open(&start.name, &start.attributes());
            self.open.push(start.element);
        }
    }
}

impl Start {
    fn attributes(&self) -> Vec<(&str, &str)> {
        self.attributes.iter().map(|(name, value)| (&**name, value.as_str())).collect()
    }
}
