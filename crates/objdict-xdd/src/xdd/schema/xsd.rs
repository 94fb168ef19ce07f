//! Generates an XML Schema of the structure from the table, for validators. It does not depend on the schema
//! of CiA 311.

use std::fmt::Write;

use super::{CONTAINER, Child, EXTERNAL_NETWORK_BODY, Occurrence, SchemaAttribute, SchemaElement, TextKind};
use crate::xdd::profile_class::ProfileClass;
use crate::xdd::schema::{BAUD_RATES, MANY};
use crate::xdd::version::XddVersion;
use crate::xml::{Name, n};

/// The schema of the documents of a version.
pub fn xsd(version: XddVersion) -> String {
    let mut out = Xsd { version, text: String::new(), elements: Vec::new() };
    let uri = version.namespace();
    out.line(0, "<?xml version=\"1.0\" encoding=\"utf-8\"?>");
    out.line(
        0,
        &format!("<!-- The structure of CiA 311, version {}, from the table of objdict. -->", version.name()),
    );
    out.line(
        0,
        &format!("<xs:schema xmlns:xs=\"http://www.w3.org/2001/XMLSchema\" xmlns:t=\"{uri}\" targetNamespace=\"{uri}\">"),
    );
    let container = out.type_of(&CONTAINER);
    out.line(1, &format!("<xs:element name=\"{}\" type=\"t:{container}\"/>", CONTAINER.name.text()));
    out.line(1, "<xs:complexType name=\"ProfileBody\" abstract=\"true\"/>");
    for class in ProfileClass::ALL {
        out.body(class);
    }
    let mut next = 0;
    while let Some(&element) = out.elements.get(next) {
        let name = out.type_of(element);
        match element.text.map(|text| simple(text.kind)) {
            // an element with such a text has no attributes
            Some(Simple::Own(own)) => {
                out.line(1, &format!("<xs:simpleType name=\"{name}\">{own}</xs:simpleType>"));
            }
            _ => {
                out.line(1, &format!("<xs:complexType name=\"{name}\">"));
                out.content(element);
                out.line(1, "</xs:complexType>");
            }
        }
        next += 1;
    }
    out.line(0, "</xs:schema>");
    out.text
}

/// The schema under construction.
struct Xsd {
    version: XddVersion,
    text: String,
    /// The elements with a type, in numerical order.
    elements: Vec<&'static SchemaElement>,
}

impl Xsd {
    fn line(&mut self, depth: usize, text: &str) {
        // writing to a `String` never fails
        let _ = writeln!(self.text, "{:1$}{text}", "", 2 * depth);
    }

    /// The name of the type of an element.
    fn type_of(&mut self, element: &'static SchemaElement) -> String {
        let known = self.elements.iter().position(|known| std::ptr::eq(*known, element));
        let number = known.unwrap_or_else(|| {
            self.elements.push(element);
            self.elements.len() - 1
        });
        format!("{}.{number}", element.name.text())
    }

    /// The type that `xsi:type` of a body names.
    fn body(&mut self, class: ProfileClass) {
        self.line(1, &format!("<xs:complexType name=\"{}\">", class.type_name()));
        self.line(2, "<xs:complexContent><xs:extension base=\"t:ProfileBody\">");
        let body = class.body();
        self.line(2, "<xs:choice>");
        self.sequence(body);
        if class == ProfileClass::Network {
            self.sequence(&EXTERNAL_NETWORK_BODY);
        }
        self.line(2, "</xs:choice>");
        self.attributes(body);
        self.line(2, "</xs:extension></xs:complexContent>");
        self.line(1, "</xs:complexType>");
    }

    fn content(&mut self, element: &'static SchemaElement) {
        match element.text {
            Some(text) => {
                let Simple::Named(base) = simple(text.kind) else { return };
                self.line(2, "<xs:simpleContent>");
                self.line(3, &format!("<xs:extension base=\"{base}\">"));
                self.attributes(element);
                self.line(3, "</xs:extension>");
                self.line(2, "</xs:simpleContent>");
            }
            None => {
                self.sequence(element);
                self.attributes(element);
            }
        }
    }

    fn is_newer(&self, element: &SchemaElement, name: Name) -> bool {
        self.version == XddVersion::V1_0 && element.newer.contains(&name)
    }

    fn sequence(&mut self, element: &'static SchemaElement) {
        self.line(2, "<xs:sequence>");
        for slot in element.content.iter().filter(|slot| slot.need != Occurrence::Stray) {
            let of: Vec<_> =
                slot.of.iter().copied().filter(|child| !self.is_newer(element, child.name)).collect();
            match of[..] {
                [] => {}
                [child] => self.child(child, slot.least, slot.most, 3),
                _ => {
                    self.line(3, &format!("<xs:choice{}>", occurs(slot.least, slot.most)));
                    of.into_iter().for_each(|child| self.alternative(slot, child));
                    self.line(3, "</xs:choice>");
                }
            }
        }
        self.line(2, "</xs:sequence>");
    }

    /// An element of a choice.
    fn alternative(&mut self, slot: &Child, child: &'static SchemaElement) {
        let most = if slot.most == MANY { 1 } else { slot.most_of(child) };
        self.child(child, 1, most, 4);
    }

    fn child(&mut self, child: &'static SchemaElement, least: u32, most: u32, depth: usize) {
        let name = child.name.text();
        let kind = if child.name == n::ProfileBody { "ProfileBody".to_owned() } else { self.type_of(child) };
        let is_qualified = child.is_global || self.version == XddVersion::V1_0;
        let form = if is_qualified { "qualified" } else { "unqualified" };
        let occurs = occurs(least, most);
        self.line(depth, &format!("<xs:element name=\"{name}\" type=\"t:{kind}\" form=\"{form}\"{occurs}/>"));
    }

    fn attributes(&mut self, element: &'static SchemaElement) {
        let defined = |attribute: &&SchemaAttribute| attribute.need != Occurrence::Stray;
        for attribute in element.attributes.iter().filter(defined) {
            if self.is_newer(element, attribute.name) {
                continue;
            }
            let name = attribute.name.text();
            let is_required = matches!(attribute.need, Occurrence::Required | Occurrence::Key);
            let need = if is_required { " use=\"required\"" } else { "" };
            match simple(attribute.kind) {
                Simple::Named(kind) => {
                    self.line(3, &format!("<xs:attribute name=\"{name}\" type=\"{kind}\"{need}/>"));
                }
                Simple::Own(own) => {
                    self.line(3, &format!("<xs:attribute name=\"{name}\"{need}>"));
                    self.line(4, &format!("<xs:simpleType>{own}</xs:simpleType>"));
                    self.line(3, "</xs:attribute>");
                }
            }
        }
    }
}

fn occurs(least: u32, most: u32) -> String {
    let most = if most == MANY { "unbounded".to_owned() } else { most.to_string() };
    match (least, most.as_str()) {
        (1, "1") => String::new(),
        (least, most) => format!(" minOccurs=\"{least}\" maxOccurs=\"{most}\""),
    }
}

/// A simple type.
enum Simple {
    /// One of XML Schema.
    Named(&'static str),
    /// The content of its definition.
    Own(String),
}

fn simple(kind: TextKind) -> Simple {
    let own = |base: &str, facets: String| {
        Simple::Own(format!("<xs:restriction base=\"xs:{base}\">{facets}</xs:restriction>"))
    };
    let words =
        |words: &[&str]| words.iter().map(|word| format!("<xs:enumeration value=\"{word}\"/>")).collect();
    let list =
        |item: String| Simple::Own(format!("<xs:list><xs:simpleType>{item}</xs:simpleType></xs:list>"));
    let restriction = |facets: String| format!("<xs:restriction base=\"xs:token\">{facets}</xs:restriction>");
    match kind {
        TextKind::Text | TextKind::Rate | TextKind::Decimal => Simple::Named("xs:string"),
        TextKind::Boolean => Simple::Named("xs:boolean"),
        TextKind::Number(low, high) => {
            let high = if high == i128::MAX {
                String::new()
            } else {
                format!("<xs:maxInclusive value=\"{high}\"/>")
            };
            own("integer", format!("<xs:minInclusive value=\"{low}\"/>{high}"))
        }
        TextKind::Hex(1, most) => own("token", format!("<xs:pattern value=\"[0-9a-fA-F]{{1,{most}}}\"/>")),
        TextKind::Hex(least, most) => {
            let pairs = format!("([0-9a-fA-F]{{2}}){{{},{}}}", least / 2, most / 2);
            own("token", format!("<xs:pattern value=\"{pairs}\"/>"))
        }
        TextKind::Date => Simple::Named("xs:date"),
        TextKind::Time => Simple::Named("xs:time"),
        TextKind::Word(known) => own("token", words(known)),
        TextKind::Words(known) => list(restriction(words(known))),
        TextKind::BaudRate => own("string", words(&BAUD_RATES)),
        TextKind::Dummy => own("token", "<xs:pattern value=\"Dummy000[1-7]=[01]\"/>".to_owned()),
        TextKind::Id => Simple::Named("xs:ID"),
        TextKind::Reference(_) => Simple::Named("xs:IDREF"),
        TextKind::Name => Simple::Named("xs:NCName"),
        TextKind::Names => list("<xs:restriction base=\"xs:NMTOKEN\"/>".to_owned()),
        TextKind::Language => Simple::Named("xs:language"),
        TextKind::Languages => list("<xs:restriction base=\"xs:language\"/>".to_owned()),
    }
}
