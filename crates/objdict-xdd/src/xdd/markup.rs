//! Writing elements of CiA 311 in the namespaces of its versions.

use super::version::XddVersion;
use crate::xml::XmlWriter;

/// Whose `ProfileBody` it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Body {
    /// That of the device profile.
    Device,
    /// That of the communication network profile.
    Network,
}

/// Writes an XML document of CiA 311: names without prefixes go in, and come out as the version demands.
///
/// In version 1.1 the elements that a schema declares inside others are in no namespace, and the others have the prefix
/// that the `ProfileBody` around them declares, as CANopenEditor writes it. In version 1.0 nothing has a prefix, and what
/// version 1.1 added is not written.
#[derive(Debug)]
pub(crate) struct Markup {
    writer: XmlWriter,
    version: XddVersion,
    body: Option<Body>,
    /// The start tags that are not written yet, each inside the one before.
    pending: Vec<Start>,
    /// The names of the open elements whose start tags are written.
    open: Vec<String>,
    /// How many elements are open that the version does not have, or that stand in one of those.
    skipped: usize,
}

#[derive(Debug)]
struct Start {
    name: String,
    attributes: Vec<(String, String)>,
    text: Option<String>,
    needs_content: bool,
}

/// Declared inside other elements by the schema of the device profile, so in no namespace.
const LOCAL_IN_DEVICE: &[&str] = &[
    "ExternalProfileHandle",
    "ProfileIdentification",
    "ProfileLocation",
    "ProfileRevision",
    "LEDstateRef",
    "category",
    "connectedModule",
    "connectedModuleList",
    "description",
    "descriptionRef",
    "label",
    "labelRef",
    "maxValue",
    "minValue",
    "moduleInterface",
    "step",
];

/// What the schema of the communication network profile does not declare inside other elements.
const GLOBAL_IN_NETWORK: &[&str] = &[
    "CANopenObjectList",
    "buildDate",
    "deviceFamily",
    "productID",
    "specificationRevision",
    "vendorID",
    "version",
];

/// What version 1.1 added: elements and attributes, each behind the element that it stands in.
const SINCE_1_1: &[(&str, &[&str])] = &[
    ("ApplicationLayers", &["moduleManagement"]),
    ("CANopenObject", &["rangeSelector"]),
    ("CANopenSubObject", &["rangeSelector"]),
    ("DeviceManager", &["moduleManagement"]),
    (
        "varDeclaration",
        &[
            "start",
            "signed",
            "offset",
            "multiplier",
            "conditionalSupport",
            "defaultValue",
            "allowedValues",
            "unit",
        ],
    ),
];

impl Body {
    const fn type_name(self) -> &'static str {
        match self {
            Self::Device => "ProfileBody_Device_CANopen",
            Self::Network => "ProfileBody_CommunicationNetwork_CANopen",
        }
    }

    const fn prefix(self) -> &'static str {
        match self {
            Self::Device => "q1",
            Self::Network => "q2",
        }
    }

    /// Whether an element in it is in the namespace.
    pub(super) fn declares_globally(self, name: &str) -> bool {
        match self {
            Self::Device => {
                !LOCAL_IN_DEVICE.contains(&name) && crate::model::SimpleType::from_name(name).is_none()
            }
            Self::Network => GLOBAL_IN_NETWORK.contains(&name),
        }
    }
}

impl Markup {
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

    /// The version that it is written in.
    pub(crate) fn version(&self) -> XddVersion {
        self.version
    }

    /// Begins the root, `ISO15745ProfileContainer`.
    pub(crate) fn open_container(&mut self) {
        self.open("ISO15745ProfileContainer");
        self.attribute("xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance");
        self.attribute("xmlns", self.version.namespace());
    }

    /// Begins a `ProfileBody`; its own attributes follow. It ends by [`close_body`](Self::close_body).
    pub(crate) fn open_body(&mut self, body: Body) {
        self.open("ProfileBody");
        match self.version {
            XddVersion::V1_0 => self.attribute("xsi:type", body.type_name()),
            XddVersion::V1_1 => {
                self.attribute(&format!("xmlns:{}", body.prefix()), self.version.namespace());
                self.attribute("xsi:type", &format!("{}:{}", body.prefix(), body.type_name()));
                self.attribute("xmlns", "");
            }
        }
        self.body = Some(body);
    }

    /// Ends the `ProfileBody`.
    pub(crate) fn close_body(&mut self) {
        self.body = None;
        self.close();
    }

    /// Begins an element. Its attributes and its text or elements follow, until it is closed.
    pub(crate) fn open(&mut self, name: &str) {
        self.start(name, false);
    }

    /// Begins an element that is written only if it gets attributes, a text or elements.
    pub(crate) fn open_unless_empty(&mut self, name: &str) {
        self.start(name, true);
    }

    /// Adds an attribute to the element that was opened last and has no elements yet.
    pub(crate) fn attribute(&mut self, name: &str, value: &str) {
        if self.skipped > 0 || self.is_too_new(name) {
            return;
        }
        if let Some(start) = self.pending.last_mut() {
            start.attributes.push((name.to_owned(), value.to_owned()));
        }
    }

    /// Gives a text to the element that was opened last. It must not get elements then.
    pub(crate) fn text(&mut self, text: &str) {
        if self.skipped > 0 {
            return;
        }
        if let Some(start) = self.pending.last_mut() {
            start.text.get_or_insert_default().push_str(text);
        }
    }

    /// Ends the element that was opened last.
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

    /// The document. Elements that are still open are closed.
    pub(crate) fn finish(mut self) -> String {
        while self.skipped > 0 || !self.pending.is_empty() || !self.open.is_empty() {
            self.close();
        }
        self.writer.finish()
    }

    /// Whether an element or attribute of the innermost open element is one that the version does not have.
    fn is_too_new(&self, name: &str) -> bool {
        let parent = self.pending.last().map(|start| &start.name).or(self.open.last());
        self.version == XddVersion::V1_0
            && SINCE_1_1
                .iter()
                .any(|(of, names)| parent.is_some_and(|parent| parent == of) && names.contains(&name))
    }

    fn start(&mut self, name: &str, needs_content: bool) {
        if self.skipped > 0 || self.is_too_new(name) {
            self.skipped += 1;
            return;
        }
        let is_header = name == "ProfileHeader";
        let name = match self.body {
            Some(body) if self.version == XddVersion::V1_1 && body.declares_globally(name) => {
                format!("{}:{name}", body.prefix())
            }
            _ => name.to_owned(),
        };
        self.pending.push(Start { name, attributes: Vec::new(), text: None, needs_content });
        // the header and all that is in it are in no namespace
        if is_header && self.version == XddVersion::V1_1 {
            self.attribute("xmlns", "");
        }
    }

    /// Writes the start tags that are left, as something stands in their elements.
    fn write_pending(&mut self) {
        for start in self.pending.drain(..) {
            self.writer.open(&start.name, &start.attributes());
            self.open.push(start.name);
        }
    }
}

impl Start {
    fn attributes(&self) -> Vec<(&str, &str)> {
        self.attributes.iter().map(|(name, value)| (name.as_str(), value.as_str())).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn document(version: XddVersion) -> String {
        let mut out = Markup::new(version);
        out.open_container();
        for (body, name) in [(Body::Device, "DeviceManager"), (Body::Network, "ApplicationLayers")] {
            out.open("ISO15745Profile");
            out.open("ProfileHeader");
            out.open("ProfileName");
            out.text("a < b");
            out.close();
            out.close();
            out.open_body(body);
            out.attribute("fileName", "\"a\".xdd");
            out.open(name);
            out.open("moduleManagement");
            out.open("interface");
            out.close();
            out.close();
            out.open_unless_empty("indicatorList");
            out.open_unless_empty("LEDList");
            out.close();
            out.close();
            out.open_unless_empty("CANopenObjectList");
            out.open_unless_empty("CANopenObject");
            out.attribute("index", "1000");
            out.close();
            out.close();
            out.close();
            out.close_body();
            out.close();
        }
        out.finish()
    }

    #[test]
    fn names_are_in_the_namespaces_of_the_version() {
        insta::assert_snapshot!("v1_1", document(XddVersion::V1_1));
        insta::assert_snapshot!("v1_0", document(XddVersion::V1_0));
    }

    #[test]
    fn what_is_open_at_the_end_is_closed() {
        let mut out = Markup::new(XddVersion::V1_0);
        out.open("a");
        out.open("b");
        out.close();
        out.open("c");
        out.attribute("d", "e");
        let text = out.finish();
        let body = text.split_once("?>").map_or("", |(_, body)| body);
        assert_eq!(body.split_whitespace().collect::<String>(), "<a><b/><cd=\"e\"/></a>");
    }
}
