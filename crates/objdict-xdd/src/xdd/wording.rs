//! Findings about the model, adapted to an XDD: selects the findings that apply, and replaces the terms of
//! CiA 306 by those of CiA 311. The rules of the model use its terms, sections and keys; the author of an
//! XDD looks for attributes.

use std::collections::HashSet;

use super::defaults::written_access;
use super::schema::{
    self, DEVICE_BODY, DEVICE_COMMISSIONING, GENERAL_FEATURES, MASTER_FEATURES, OBJECT, SchemaAttribute,
    SchemaElement,
};
use crate::diagnostic::{At, Diagnostic, Findings, Notion, Severity, Vocabulary, say};
use crate::model::{Access, DataType, Field};
use crate::source::Span;
use crate::xdd::types::simple_type;
use crate::xml::{Name, n};

/// Rules that check the notation of an EDS against CiA 306. The corresponding rules for an XDD are in the
/// group `cia311`.
const OF_EDS: [&str; 7] = [
    "cia306/eds-version",
    "cia306/missing-device-info-key",
    "cia306/missing-file-info-key",
    "cia306/missing-last-eds",
    "cia306/missing-node-name",
    "cia306/missing-section",
    "cia306/unsorted-list",
];

/// Keys whose name in CiA 311 cannot be derived from the schema.
const NAMES: [(&str, Name); 4] = [
    ("BaudRate_x", n::supportedBaudRate),
    ("[DeviceInfo]", n::baudRate),
    ("[DeviceComissioning]", n::deviceCommissioning),
    ("[DynamicChannels]", n::dynamicChannels),
];

/// The terms of CiA 311 for parts of an EDS.
const WORDS: [(&str, &str); 10] = [
    ("section", "element"),
    ("a section", "an element"),
    ("sections", "elements"),
    ("a key", "an attribute"),
    ("the key", "the attribute"),
    ("the keys", "the attributes"),
    ("DCF", "XDC"),
    ("a DCF", "an XDC"),
    (".dcf", ".xdc"),
    ("EDS", "XDD"),
];

/// The term of CiA 311 for a term of CiA 306.
pub fn words(notion: &Notion<'_>) -> Option<String> {
    match *notion {
        Notion::Key(key) => rate(key).or_else(|| own(key)).or_else(|| Some(What::of(key)?.name().to_owned())),
        Notion::Setting(key, value) => rate(key).or_else(|| Some(What::of(key)?.with(value))),
        Notion::ValueOf(key, value) => What::of(key)?.spelled(value),
        Notion::Section(name) => section(name).or_else(|| own(&format!("[{name}]"))),
        Notion::Word(word) => WORDS.iter().find(|(eds, _)| *eds == word).map(|(_, xdd)| (*xdd).to_owned()),
    }
}

/// Like `words`, for an entry whose parameter states the access.
fn words_of_parameter(notion: &Notion<'_>) -> Option<String> {
    let access = |value: &str| Access::from_name(value).map(|access| written_access(access).name());
    match *notion {
        Notion::Key("AccessType") => Some("access".to_owned()),
        Notion::Setting("AccessType", value) => Some(format!("access=\"{}\"", access(value).unwrap_or("…"))),
        Notion::ValueOf("AccessType", value) => access(value).map(ToOwned::to_owned),
        _ => words(notion),
    }
}

/// The name of a limit that the parameter states.
fn range(notion: &Notion<'_>) -> Option<String> {
    match *notion {
        Notion::Key("LowLimit") => Some("minValue".to_owned()),
        Notion::Key("HighLimit") => Some("maxValue".to_owned()),
        _ => None,
    }
}

/// Like `words`, for an entry whose parameter has an element for the data type.
fn words_of_element(notion: &Notion<'_>) -> Option<String> {
    match *notion {
        Notion::Setting("DataType", value) => {
            let code = u16::from_str_radix(value.strip_prefix("0x")?, 16).ok()?;
            Some(format!("<{} />", simple_type(DataType(code)).name()))
        }
        _ => words(notion),
    }
}

/// The special name of a key.
fn own(key: &str) -> Option<String> {
    NAMES.iter().find(|(known, _)| *known == key).map(|(_, name)| name.text().to_owned())
}

/// The counterpart of an EDS key in an XDD.
struct What {
    field: &'static Field,
    form: KeyForm,
}

enum KeyForm {
    Element(&'static SchemaElement),
    Attribute(&'static SchemaAttribute),
}

impl What {
    fn of(key: &str) -> Option<Self> {
        let (_, field) = Field::NAMED.iter().find(|(known, _)| *known == key)?;
        let tables = [&OBJECT, &DEVICE_BODY, &GENERAL_FEATURES, &MASTER_FEATURES, &DEVICE_COMMISSIONING];
        let attribute = || tables.into_iter().find_map(|element| element.attribute_of(field));
        let element = schema::identity_element(field).map(KeyForm::Element);
        Some(Self { field, form: element.or_else(|| attribute().map(KeyForm::Attribute))? })
    }

    fn name(&self) -> &'static str {
        match self.form {
            KeyForm::Element(element) => element.name.text(),
            KeyForm::Attribute(attribute) => attribute.name.text(),
        }
    }

    /// The XDD spelling of a value in EDS spelling; `None` if both are the same.
    fn spelled(&self, value: &str) -> Option<String> {
        match (self.field, &self.form, value) {
            (Field::AccessType, _, "rwr") => Some("readWriteInput".to_owned()),
            (Field::AccessType, _, "rww") => Some("readWriteOutput".to_owned()),
            (Field::Baudrate, _, rate) => Some(format!("{rate} Kbps")),
            (_, KeyForm::Attribute(attribute), value) => attribute.spelled(value),
            (_, KeyForm::Element(_), _) => None,
        }
    }

    /// The name with a value, from the spelling of an EDS.
    fn with(&self, value: &str) -> String {
        let spelled = self.spelled(value);
        let (name, spelled) = (self.name(), spelled.as_deref().unwrap_or(value));
        match (self.field, &self.form, value) {
            (_, KeyForm::Element(_), _) => format!("<{name}>{spelled}</{name}>"),
            (_, _, "") => format!("{name}=\"…\""),
            // an attribute of the parameter
            (Field::AccessType, _, "rwr" | "rww") => format!("access=\"{spelled}\""),
            _ => format!("{name}=\"{spelled}\""),
        }
    }
}

/// The element of a supported bit rate, for a key such as `BaudRate_125`.
fn rate(key: &str) -> Option<String> {
    let rate = key.strip_prefix("BaudRate_").filter(|rate| rate.bytes().all(|byte| byte.is_ascii_digit()))?;
    Some(format!("<supportedBaudRate value=\"{rate} Kbps\"/>"))
}

/// The element for the section of an object: `1018` or `1018sub1`.
fn section(name: &str) -> Option<String> {
    let is_hex = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_hexdigit());
    match name.split_once("sub") {
        Some((index, sub)) if is_hex(index) && is_hex(sub) => {
            Some(format!("<CANopenSubObject subIndex=\"{sub:0>2}\">"))
        }
        None if is_hex(name) => Some(format!("<CANopenObject index=\"{name:0>4}\">")),
        _ => None,
    }
}

/// The findings about an XDD in the terms of CiA 311, without those that apply only to an EDS, and without
/// those at a place for which a rule of CiA 311 already has a finding.
pub fn of_xdd(findings: Findings, text: &str, span_of: impl Fn(&At) -> Span) -> Findings {
    let span = |finding: &Diagnostic| finding.labels.first().map(|label| span_of(&label.at));
    let of_structure = findings.iter().filter(|finding| finding.rule.group() == "cia311");
    let spoken: HashSet<Span> = of_structure.filter_map(span).filter(|span| !span.is_empty()).collect();
    findings.filter_map(|mut finding| {
        let group = finding.rule.group();
        if matches!(group, "cia311" | "xml") {
            return Some(finding);
        }
        let is_spoken = || span(&finding).is_some_and(|span| spoken.contains(&span));
        let is_doubled =
            matches!(finding.rule.id, "cia306/invalid-value" | "cia306/dummy-type") && is_spoken();
        if OF_EDS.contains(&finding.rule.id) || asks_for_count(&finding) || is_doubled {
            return None;
        }
        if finding.rule.id == "cia306/invalid-value" {
            match field(&finding) {
                // any text is valid
                Some(Field::FileVersion) => return None,
                Some(Field::VendorNumber | Field::ProductNumber) => finding.severity = Severity::Warning,
                _ => {}
            }
        }
        let written = || {
            let name = span(&finding)?.of(text).trim_matches(['"', '\'']);
            Some(text.matches(&format!("fileName=\"{name}\"")).count())
        };
        if finding.rule.id == "cia306/file-name" && written() > Some(1) {
            finding.help = finding.help.take().map(|help| say!("{} in both profiles", help));
        }
        // access, data type and limits of an entry may come from its parameter
        let is_at = |field: Field, attribute: &str| {
            let At::Place(place) = &finding.labels.first()?.at else { return None };
            let start = span_of(&At::Place(place.clone().field(field))).start as usize;
            Some(text.get(..start)?.trim_end_matches(['"', '\'']).ends_with(attribute))
        };
        let has_range = [Field::LowLimit, Field::HighLimit]
            .iter()
            .any(|limit| is_at(limit.clone(), " value=") == Some(true));
        let words: Vocabulary = match field(&finding) {
            Some(Field::DataType) if is_at(Field::DataType, "dataType=") == Some(false) => words_of_element,
            _ => match (is_at(Field::AccessType, "access=") == Some(true), has_range) {
                (true, true) => |notion| range(notion).or_else(|| words_of_parameter(notion)),
                (true, false) => words_of_parameter,
                (false, true) => |notion| range(notion).or_else(|| words(notion)),
                (false, false) => words,
            },
        };
        let finding = finding.in_words(words);
        // the element denotes all data types without a simple type, so it does not contradict them
        let is_bits = |text: &str| text.contains("BITSTRING");
        let is_spoken = finding.rule.name() == "wrong-data-type"
            && span(&finding).is_some_and(|span| is_bits(span.of(text)))
            && finding.help.as_ref().is_some_and(|help| is_bits(&help.shown()));
        (!is_spoken).then_some(finding)
    })
}

/// The field of a finding.
fn field(finding: &Diagnostic) -> Option<&Field> {
    match &finding.labels.first()?.at {
        At::Place(place) => place.field.as_ref(),
        At::Span(_) | At::Node(..) | At::Patch(..) => None,
    }
}

/// Whether a finding reports a missing number of sub-indexes, which is optional in an XDD.
fn asks_for_count(finding: &Diagnostic) -> bool {
    finding.rule.id == "cia306/missing-key" && field(finding) == Some(&Field::SubNumber)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::{RuleInfo, say};
    use crate::model::{Part, PdoMapping, Place};

    #[test]
    fn keys_become_attributes() {
        for (eds, xdd) in [
            (say!("write `{SubNumber=5}`"), "write `subNumber=\"5\"`"),
            (say!("a VAR needs `{DataType}` and `{AccessType}`"), "a VAR needs `dataType` and `accessType`"),
            (
                say!("write `{PDOMapping=1}`, or `{AccessType=rww}`"),
                "write `PDOmapping=\"optional\"`, or `access=\"readWriteOutput\"`",
            ),
            (
                say!("write `{ObjectType=0x9}` or `{ObjectType:0x8}`, and `{ObjFlags=0x1}`"),
                "write `objectType=\"9\"` or `8`, and `objFlags=\"0001\"`",
            ),
            (
                say!("add `{[1018sub1]}` with `{DataType=0x0007}`"),
                "add `<CANopenSubObject subIndex=\"01\">` with `dataType=\"0007\"`",
            ),
            (
                say!("add {a section} `{}`", Part::Object(0xA00)),
                "add an element `<CANopenObject index=\"0A00\">`",
            ),
            (
                say!("write `{BaudRate_125=1}` or `{VendorNumber=0x59}`"),
                "write `<supportedBaudRate value=\"125 Kbps\"/>` or `<vendorID>0x59</vendorID>`",
            ),
            (
                say!("`{LSS_Supported}` is {LSS_Supported:0}: write `{LSS_Supported=1}`, remove {the key}"),
                "`layerSettingServiceSlave` is false: write `layerSettingServiceSlave=\"true\"`, remove the attribute",
            ),
            (say!("write `{ParameterName=}` and a name"), "write `name=\"…\"` and a name"),
            (
                say!("`{}` is `{}`; EDS", "RevisionNumber", "PDOMapping"),
                "`RevisionNumber` is `PDOMapping`; EDS",
            ),
            (say!("`{PDOMapping}` is {}", PdoMapping::Tpdo), "`PDOmapping` is TPDO"),
            (say!("`{Denotation}` belongs into {a DCF}"), "`denotation` belongs into an XDC"),
        ] {
            assert_eq!(eds.in_words(words), xdd);
        }
    }

    /// CANopenEditor writes DOMAIN and OCTET_STRING alike.
    #[test]
    fn an_element_for_all_types_is_not_a_wrong_one() {
        static RULE: RuleInfo = RuleInfo::bare("cia302/wrong-data-type", Severity::Warning);
        let is_found = |text: &str| {
            let place = Place::entry(0x1F50, 1).field(Field::DataType);
            let finding = Diagnostic::new(&RULE, place, "message").help(say!("write `{DataType=0x000F}`"));
            let mut findings = Findings::new();
            findings.push(finding);
            !of_xdd(findings, text, |_| Span::new(0, text.len() as u32)).is_empty()
        };
        assert!(is_found("<UDINT/>") && !is_found("<BITSTRING/>"));
    }

    #[test]
    fn every_word_has_one() {
        assert!(crate::diagnostic::WORDS.iter().all(|word| words(&Notion::Word(word)).is_some()));
    }
}
