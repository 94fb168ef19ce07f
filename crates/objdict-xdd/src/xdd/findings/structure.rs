//! The rules about namespaces (the version of a file, and the elements that are in the namespace of that version), and about the
//! presence and order of elements and attributes.

use crate::diagnostic::{Diagnostic, Findings, Severity, counted, listing, text_rules};
use crate::source::Span;
use crate::xdd::schema::{self, Child, Occurrence};
use crate::xdd::version::XddVersion;
use crate::xml::{Attribute, Element, n};

text_rules! {
    source: "CiA 311 annex A";

    "cia311/missing-element" = MISSING_ELEMENT, Warning;
    summary: "an element is missing",
    checks: "Each element must contain its mandatory child elements of CiA 311. A missing element that makes the file useless, such as `ApplicationLayers` and `CANopenObjectList`, is an error. Others are a warning.",
    why: "Schema validation rejects the file.",
    example: "`<DeviceFunction/>` without `capabilities`",
    remedy: "Add the element.",

    // an object without an index, or an entry without a sub-index, is not read completely
    "cia311/missing-attribute" = MISSING_ATTRIBUTE, Warning,
        explains Object [
            "missing-key", "sub-number-mismatch", "missing-sub-0", "wrong-highest-sub-index", "wrong-mapping-count",
            "incomplete-pdo-parameter", "missing-name"
        ];
    summary: "an attribute is missing",
    checks: "Each element must have its mandatory attributes of CiA 311. A missing attribute that makes the element useless is an error, such as `index` and `name` of an object and `uniqueID` of a parameter. Others are a warning.",
    why: "Schema validation rejects the file; other tools assume zeros.",
    example: r#"`<CANopenGeneralFeatures nrOfRxPDO="4"/>` without `granularity`"#,
    remedy: "Add the attribute.",

    "cia311/unknown-element" = UNKNOWN_ELEMENT, Warning;
    summary: "an element is not defined here in CiA 311",
    checks: "Reports an element that CiA 311 does not define in this place. Elements in a namespace of their own are a note. Unknown elements are preserved.",
    why: "Schema validation rejects the file; other tools ignore the element with its content.",
    example: r#"`<defaultvalue value="1"/>` in `allowedValues`"#,
    remedy: "Check the spelling and the place. Use `property` for manufacturer-specific data of a parameter.",

    "cia311/unknown-attribute" = UNKNOWN_ATTRIBUTE, Warning;
    summary: "an attribute is not defined for its element",
    checks: "Reports an attribute that CiA 311 does not define for its element. Attributes with a prefix are not checked. Unknown attributes are preserved.",
    why: "Schema validation rejects the file; other tools ignore the attribute.",
    example: r#"`<CANopenObject index="1000" sub="0">`"#,
    remedy: "Check the spelling, or remove the attribute.",

    "cia311/misspelt-name" = MISSPELT_NAME, Warning;
    summary: "a name differs from the standard in case",
    checks: "Reports an unknown element or attribute that differs from a name of CiA 311 only in case. It is read as that name.",
    why: "XML is case-sensitive: other tools do not find the value. Some versions of CANopenEditor write `NodeID` for `nodeID`.",
    example: r#"`<deviceCommissioning NodeID="5">`"#,
    remedy: "Write the name as in the standard.",

    "cia311/wrong-order" = WRONG_ORDER, Warning;
    summary: "elements are in the wrong order",
    checks: "Child elements must be in the order of CiA 311. Only the first one out of order is reported.",
    why: "Schema validation rejects the file. Most tools still read it.",
    example: r#"`<defaultValue value="1"/>` before `<UINT/>`"#,
    remedy: "Move the element.",

    "cia311/repeated-element" = REPEATED_ELEMENT, Error;
    summary: "an element is defined twice",
    checks: "Elements that may occur once, such as the data type of a parameter, must not occur again. The first one is used.",
    why: "Some tools use the first one, some the last one, some reject the file.",
    example: "`<UINT/>` and `<UDINT/>` in one parameter",
    remedy: "Keep one of them.",

    "cia311/stray-text" = STRAY_TEXT, Warning;
    summary: "text is present where only elements are allowed",
    checks: "Reports text in an element that may contain only elements.",
    why: "Tools ignore the text. A tag around it may be missing, or it was intended as a comment.",
    example: r#"`<parameter uniqueID="P1">Speed<UINT/></parameter>`"#,
    remedy: "Move it into a `label` or `description`, or between `<!--` and `-->`.",

    "cia311/newer-version" = NEWER_VERSION, Warning;
    summary: "an element or attribute is not defined in version 1.0",
    checks: "A file in the namespace of version 1.0 must not have elements or attributes that were added in version 1.1.",
    why: "Tools for version 1.0 ignore them or reject the file.",
    example: "`<moduleManagement>` in `http://www.canopen.org/xml/1.0`",
    remedy: "Remove it, or change the namespace of the file to version 1.1.",

    "cia311/unknown-namespace" = UNKNOWN_NAMESPACE, Warning;
    summary: "the file is in no namespace of CiA 311",
    checks: "The container must be in `http://www.canopen.org/xml/1.0` or `http://www.canopen.org/xml/1.1`. The elements are read in any case.",
    why: "Tools that check the namespace, such as CANopenEditor, reject the file.",
    example: "`<ISO15745ProfileContainer>` without `xmlns`",
    remedy: r#"Write `xmlns="http://www.canopen.org/xml/1.0"` in the root element: in version 1.0 all elements are in the namespace. Version 1.1 keeps the local ones, such as `ProfileHeader` and `CANopenObject`, in none; write it with `objdict convert`."#,

    "cia311/element-form" = ELEMENT_FORM, Warning;
    summary: "elements are in a namespace where they must be in none, or vice versa",
    checks: "Local elements of version 1.1, such as `ProfileHeader`, `CANopenObject` and `label`, must be in no namespace. All others must be in the file's namespace. In version 1.0 all elements are in the namespace. Only the first element is reported, with the number of others.",
    why: "Tools that check the namespace, such as CANopenEditor, ignore such elements with their content. Others check only the names.",
    example: r#"`<ProfileBody>` in a file of version 1.1 without `xmlns=""`"#,
    remedy: r#"Add `xmlns=""` to `ProfileHeader` and `ProfileBody`, and a prefix to the names of the global elements in them."#,
    source: "CiA 311 annex A (`elementFormDefault`)",

    "cia311/mixed-namespaces" = MIXED_NAMESPACES, Warning;
    summary: "an element and its container are in different namespaces",
    checks: "All elements of CiA 311 must be in the namespace of the container or in none. Only the first one is reported, with the number of others.",
    why: "Part of the file follows a different version or standard, and tools that check the namespace ignore it.",
    example: r#"`xmlns:q1="http://www.canopen.org/xml/1.0"` in a file of version 1.1"#,
    remedy: "Declare one namespace in the whole file.",
}

/// Reports an unknown attribute; a known one whose name differs only in case is suggested.
pub(super) fn unknown_attribute(
    element: Element<'_>,
    schema: &'static schema::SchemaElement,
    attribute: Attribute<'_>,
    findings: &mut Findings,
) -> Option<(usize, &'static schema::SchemaAttribute)> {
    let is_meant = |known: &schema::SchemaAttribute| {
        known.need != Occurrence::Stray && known.name.text().eq_ignore_ascii_case(attribute.name())
    };
    let meant = schema.attributes.iter().enumerate().find(|(_, known)| is_meant(known));
    let meant = meant.filter(|(_, known)| element.attribute(known.name).is_none());
    let (name, at) = (attribute.name(), attribute.name_span());
    findings.push(match meant {
        Some((_, meant)) => misspelt(at, name, meant.name.text()),
        None => Diagnostic::new(
            &UNKNOWN_ATTRIBUTE,
            at,
            format!("unknown attribute `{name}` of `{}`", element.name()),
        )
        .help("check the spelling or remove the attribute; schema validation rejects it"),
    });
    meant
}

/// Reports an unknown child; a known one whose name differs only in case is suggested.
pub(super) fn unknown_element(
    parent: Element<'_>,
    schema: &'static schema::SchemaElement,
    child: Element<'_>,
    is_ours: bool,
    findings: &mut Findings,
) -> Option<(usize, &'static schema::SchemaElement)> {
    let (name, at) = (child.name(), child.name_span());
    let slots = schema.content.iter().enumerate().filter(|(_, slot)| slot.need != Occurrence::Stray);
    let mut known = slots.flat_map(|(number, slot)| slot.of.iter().map(move |element| (number, *element)));
    let meant = known.find(|(_, element)| element.name.text().eq_ignore_ascii_case(name));
    findings.push(match meant {
        Some((_, meant)) => misspelt(at, name, meant.name.text()),
        None => {
            Diagnostic::new(&UNKNOWN_ELEMENT, at, format!("unknown element `{name}` in `{}`", parent.name()))
                .severity(if is_ours { Severity::Warning } else { Severity::Note })
                .help("check the spelling and the place; schema validation rejects it")
        }
    });
    meant
}

fn misspelt(at: Span, name: &str, meant: &str) -> Diagnostic {
    let message = format!("`{name}` is spelled `{meant}` in the standard");
    Diagnostic::new(&MISSPELT_NAME, at, message).help(format!("write `{meant}`"))
}

pub(super) fn missing_attribute(element: Element<'_>, attribute: &schema::SchemaAttribute) -> Diagnostic {
    let message = format!("`{}` lacks the attribute `{}`", element.name(), attribute.name.text());
    Diagnostic::new(&MISSING_ATTRIBUTE, element.name_span(), message)
        .severity(severity(attribute.need))
        .help(format!("add `{}=\"…\"`", attribute.name.text()))
}

fn severity(need: Occurrence) -> Severity {
    if need == Occurrence::Key { Severity::Error } else { Severity::Warning }
}

pub(super) fn missing_element(element: Element<'_>, slot: &Child, count: u32) -> Diagnostic {
    let parent = element.name();
    let names = slot.of.iter().map(|element| element.name.text());
    let (message, help) = match (slot.of, count) {
        ([one], 0) => {
            (format!("`{parent}` lacks `{}`", one.name.text()), format!("add `{}`", one.name.text()))
        }
        ([one], _) => {
            let message =
                format!("`{parent}` has {count} `{}`, but needs at least {}", one.name.text(), slot.least);
            (message, format!("add another `{}`", one.name.text()))
        }
        ([first, ..], _) if first.name == n::label => {
            (format!("`{parent}` has neither a label nor a description"), "add a `label`".to_owned())
        }
        ([_, _, _, _, _, ..], _) => (
            format!("`{parent}` has no data type"),
            "add a simple type such as `UINT`, or `dataTypeIDRef`".to_owned(),
        ),
        _ => (format!("`{parent}` needs one of {}", listing(names)), "add one of them".to_owned()),
    };
    Diagnostic::new(&MISSING_ELEMENT, element.name_span(), message).severity(severity(slot.need)).help(help)
}

/// `child` belongs before `last`.
pub(super) fn wrong_order(parent: Element<'_>, child: Element<'_>, last: Option<Element<'_>>) -> Diagnostic {
    let last_name = last.map_or("", Element::name);
    let message = format!("in `{}`, `{}` must precede `{last_name}`", parent.name(), child.name());
    let finding = Diagnostic::new(&WRONG_ORDER, child.name_span(), message);
    let finding = match last {
        Some(last) => finding.label(last.name_span(), "precedes it"),
        None => finding,
    };
    finding.help(format!("move `{}` up", child.name()))
}

pub(super) fn repeated_element(parent: Element<'_>, child: Element<'_>, first: Element<'_>) -> Diagnostic {
    let (parent, name, first_name) = (parent.name(), child.name(), first.name());
    let message = if name == first_name {
        format!("`{parent}` may contain only one `{name}`; the first one is used")
    } else {
        format!("`{parent}` already has `{first_name}`, so `{name}` is not allowed")
    };
    Diagnostic::new(&REPEATED_ELEMENT, child.name_span(), message)
        .label(first.name_span(), "first here")
        .help("keep one of the two")
}

pub(super) fn stray_text(element: Element<'_>, at: Span) -> Diagnostic {
    let text = at.of(element.tree().text());
    let text = match text.char_indices().nth(40) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    };
    let message = format!("`{}` must not contain text, but contains `{text}`", element.name());
    Diagnostic::new(&STRAY_TEXT, at, message)
        .help("move it into a `label` or `description`, or make it a comment")
}

/// Reports that version 1.0 does not support `what`.
pub(super) fn newer(at: Span, what: &str) -> Diagnostic {
    Diagnostic::new(&NEWER_VERSION, at, format!("version 1.0 has no {what}"))
        .help("remove it or change the namespace of the file to version 1.1")
}

/// How the elements of a container use namespaces.
pub(super) struct Forms<'a> {
    container: Element<'a>,
    version: Option<XddVersion>,
    wrong_form: NamespaceTally<'a>,
    foreign: NamespaceTally<'a>,
}

/// The first of a group of elements, and their number.
#[derive(Default)]
struct NamespaceTally<'a> {
    first: Option<Element<'a>>,
    count: usize,
}

impl<'a> NamespaceTally<'a> {
    fn take(&mut self, element: Element<'a>) {
        self.first.get_or_insert(element);
        self.count += 1;
    }
}

impl<'a> Forms<'a> {
    pub(super) fn new(container: Element<'a>) -> Self {
        let version = container.namespace().and_then(XddVersion::from_namespace);
        Self { container, version, wrong_form: NamespaceTally::default(), foreign: NamespaceTally::default() }
    }

    /// Whether the file is of version 1.0.
    pub(super) fn is_version_1_0(&self) -> bool {
        self.version == Some(XddVersion::V1_0)
    }

    /// Whether an element is in the container's namespace or in none, and so is intended as an element of
    /// CiA 311.
    pub(super) fn is_ours(&self, element: Element<'_>) -> bool {
        let namespace = element.namespace();
        namespace.is_none() || namespace == self.container.namespace()
    }

    /// Records the namespace of an element of the schema.
    pub(super) fn look_at(&mut self, element: Element<'a>, schema: &schema::SchemaElement) {
        let Some(version) = self.version else { return };
        let belongs_in = version == XddVersion::V1_0 || schema.is_global;
        match element.namespace() {
            None if belongs_in => self.wrong_form.take(element),
            Some(_) if !self.is_ours(element) => self.foreign.take(element),
            Some(_) if !belongs_in => self.wrong_form.take(element),
            _ => {}
        }
    }

    /// Reports the findings.
    pub(super) fn report(&self, findings: &mut Findings) {
        if self.version.is_none() {
            findings.push(self.unknown());
        }
        if let Some(first) = self.wrong_form.first {
            findings.push(self.wrong_form(first));
        }
        if let Some(first) = self.foreign.first {
            findings.push(self.mixed(first));
        }
    }

    fn unknown(&self) -> Diagnostic {
        let message = match self.container.namespace() {
            None => "the file is in no namespace".to_owned(),
            Some(namespace) => format!("`{namespace}` is not a namespace of CiA 311"),
        };
        // version 1.0, where all elements are in the namespace; in 1.1 each local element would have to leave it
        let namespace = XddVersion::V1_0.namespace();
        let help = format!("write `xmlns=\"{namespace}\"` in the root element");
        Diagnostic::new(&UNKNOWN_NAMESPACE, self.container.name_span(), message).help(help)
    }

    fn wrong_form(&self, first: Element<'_>) -> Diagnostic {
        let name = first.name();
        let (is, belongs) = if first.namespace().is_some() {
            ("in the namespace", "in none")
        } else {
            ("in no namespace", "in the file's namespace")
        };
        let message = match self.wrong_form.count {
            1 => format!("`{name}` is {is}, but must be {belongs}"),
            count => {
                let others = counted(count - 1, "other element", "other elements");
                format!("`{name}` is {is}, but must be {belongs}; also {others}")
            }
        };
        let namespace = self.version.unwrap_or_default().namespace();
        let help = match (self.version, first.namespace()) {
            (Some(XddVersion::V1_0), _) => format!("in version 1.0 every element must be in `{namespace}`"),
            (_, Some(_)) => {
                "in version 1.1 only global elements are in the namespace: add `xmlns=\"\"` here".to_owned()
            }
            (_, None) => format!("declare a prefix for `{namespace}` and add it to the name"),
        };
        Diagnostic::new(&ELEMENT_FORM, first.name_span(), message).help(help)
    }

    fn mixed(&self, first: Element<'_>) -> Diagnostic {
        let (name, namespace) = (first.name(), first.namespace().unwrap_or_default());
        let mut message = format!("the namespace `{namespace}` of `{name}` differs from its container's");
        if self.foreign.count > 1 {
            let others = counted(self.foreign.count - 1, "other element", "other elements");
            message.push_str(&format!("; also {others}"));
        }
        Diagnostic::new(&MIXED_NAMESPACES, first.name_span(), message)
            .label(self.container.name_span(), "the container")
            .help("declare one namespace in the whole file")
    }
}
