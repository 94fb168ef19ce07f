//! The rules about namespaces: the version of a file, and the elements that are in the namespace of that
//! version.

use crate::diagnostic::{Diagnostic, Findings, counted, text_rules};
use crate::xdd::schema;
use crate::xdd::version::XddVersion;
use crate::xml::Element;

text_rules! {
    source: "CiA 311 annex A";

    "cia311/unknown-namespace" = UNKNOWN_NAMESPACE, Warning;
    summary: "the file is in no namespace of CiA 311",
    checks: "Whether the container is in `http://www.canopen.org/xml/1.0` or `http://www.canopen.org/xml/1.1`. The elements are read in any case.",
    why: "Tools that check the namespace, such as CANopenEditor, reject the file.",
    example: "`<ISO15745ProfileContainer>` without `xmlns`",
    remedy: r#"Add `xmlns="http://www.canopen.org/xml/1.1"`, and `xmlns=""` to the elements that version 1.1 keeps in no namespace."#,

    "cia311/element-form" = ELEMENT_FORM, Warning;
    summary: "elements are in a namespace where they must be in none, or vice versa",
    checks: "Whether the local elements of version 1.1, such as `ProfileHeader`, `CANopenObject` and `label`, are in no namespace, and all others in that of the file. In version 1.0 all elements are in the namespace. Only the first element is reported, with the number of others.",
    why: "Tools that check the namespace, such as CANopenEditor, ignore such elements with their content. Others check only the names.",
    example: r#"`<ProfileBody>` in a file of version 1.1 without `xmlns=""`"#,
    remedy: r#"Add `xmlns=""` to `ProfileHeader` and `ProfileBody`, and a prefix to the names of the global elements in them."#,
    source: "CiA 311 annex A (`elementFormDefault`)",

    "cia311/mixed-namespaces" = MIXED_NAMESPACES, Warning;
    summary: "an element and its container are in different namespaces",
    checks: "Whether all elements of CiA 311 are in the namespace of the container or in none. Only the first one is reported, with the number of others.",
    why: "Part of the file follows another version or standard, and tools that check the namespace ignore it.",
    example: r#"`xmlns:q1="http://www.canopen.org/xml/1.0"` in a file of version 1.1"#,
    remedy: "Declare one namespace in the whole file.",
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

    /// Whether an element is in the namespace of the container or in none, and so is meant as an element of
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
        let namespace = XddVersion::V1_1.namespace();
        let help =
            format!("add `xmlns=\"{namespace}\"`, and `xmlns=\"\"` to `ProfileHeader` and `ProfileBody`");
        Diagnostic::new(&UNKNOWN_NAMESPACE, self.container.name_span(), message).help(help)
    }

    fn wrong_form(&self, first: Element<'_>) -> Diagnostic {
        let name = first.name();
        let (is, belongs) = if first.namespace().is_some() {
            ("in the namespace", "in none")
        } else {
            ("in no namespace", "in that of the file")
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
        let mut message =
            format!("the namespace `{namespace}` of `{name}` differs from that of its container");
        if self.foreign.count > 1 {
            let others = counted(self.foreign.count - 1, "other element", "other elements");
            message.push_str(&format!("; also {others}"));
        }
        Diagnostic::new(&MIXED_NAMESPACES, first.name_span(), message)
            .label(self.container.name_span(), "the container")
            .help("declare one namespace in the whole file")
    }
}
