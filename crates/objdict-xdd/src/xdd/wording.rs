//! Findings about the model in the words of CiA 311. The rules of the model speak of sections and keys, for these are what
//! its fields are called; who has an XDD before him looks for attributes.

use std::borrow::Cow;
use std::collections::HashSet;

use super::schema::{self, DEVICE_BODY, DEVICE_COMMISSIONING, GENERAL_FEATURES, MASTER_FEATURES, OBJECT};
use crate::diagnostic::{At, Diagnostic, Findings, Severity};
use crate::model::Field;
use crate::source::Span;
use crate::xml::{Name, n};

/// Rules that hold the form of an EDS against CiA 306. What an XDD must state instead, rules of the group `cia311` say.
const OF_EDS: [&str; 6] = [
    "cia306/eds-version",
    "cia306/missing-device-info-key",
    "cia306/missing-file-info-key",
    "cia306/missing-last-eds",
    "cia306/missing-section",
    "cia306/unsorted-list",
];

/// Rules in whose texts EDS and DCF are the kinds of file, and nothing else.
const OF_KINDS: [&str; 2] = ["cia306/configuration-in-eds", "cia306/missing-commissioning"];

/// What is called by a word of its own.
const NAMES: [(&str, Name); 4] = [
    ("BaudRate_x", n::supportedBaudRate),
    ("[DeviceInfo]", n::baudRate),
    ("[DeviceComissioning]", n::deviceCommissioning),
    ("[DynamicChannels]", n::dynamicChannels),
];

/// What a key of an EDS is in an XDD, with a value that an EDS would write so.
fn named(key: &str, value: Option<&str>) -> Option<String> {
    if let Some((_, name)) = NAMES.iter().find(|(known, _)| *known == key) {
        return Some(match value {
            Some(value) => format!("{}=\"{value}\"", name.text()),
            None => name.text().to_owned(),
        });
    }
    let field = Field::NAMED.iter().find(|(known, _)| *known == key).map(|(_, field)| field)?;
    if let Some(element) = schema::identity_element(field) {
        let name = element.name.text();
        return Some(value.map_or_else(|| name.to_owned(), |value| format!("<{name}>{value}</{name}>")));
    }
    let tables = [&OBJECT, &DEVICE_BODY, &GENERAL_FEATURES, &MASTER_FEATURES, &DEVICE_COMMISSIONING];
    let attribute = tables.into_iter().find_map(|element| element.attribute_of(field))?;
    let name = attribute.name.text();
    Some(match (field, value) {
        (_, None) => name.to_owned(),
        (_, Some("")) => format!("{name}=\"…\""),
        (Field::AccessType, Some("rwr")) => "access=\"readWriteInput\"".to_owned(),
        (Field::AccessType, Some("rww")) => "access=\"readWriteOutput\"".to_owned(),
        (_, Some(value)) => {
            let spelled = attribute.spelled(value).unwrap_or_else(|| value.to_owned());
            format!("{name}=\"{spelled}\"")
        }
    })
}

/// The findings about an XDD: without those about what only an EDS has, and what is said of a place already by a rule of
/// CiA 311; the others in its words.
pub fn of_xdd(findings: Findings, span_of: impl Fn(&At) -> Span) -> Findings {
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
                // any text will do
                Some(Field::FileVersion) => return None,
                Some(Field::VendorNumber | Field::ProductNumber) => finding.severity = Severity::Warning,
                _ => {}
            }
        }
        Some(reworded(finding))
    })
}

/// The field that a finding is about.
fn field(finding: &Diagnostic) -> Option<&Field> {
    match &finding.labels.first()?.at {
        At::Place(place) => place.field.as_ref(),
        At::Span(_) => None,
    }
}

/// Whether the number of sub-indexes is missing, which an XDD may leave out.
fn asks_for_count(finding: &Diagnostic) -> bool {
    finding.rule.id == "cia306/missing-key" && field(finding) == Some(&Field::SubNumber)
}

fn reworded(mut finding: Diagnostic) -> Diagnostic {
    // names of objects stand in it as they are
    if finding.rule.id == "cia306/duplicate-name" || finding.rule.group() == "naming" {
        return finding;
    }
    let is_of_kinds = OF_KINDS.contains(&finding.rule.id);
    finding.message = text(&finding.message, is_of_kinds);
    for label in &mut finding.labels {
        label.text = Cow::Owned(text(&label.text, is_of_kinds));
    }
    if let Some(help) = &finding.help {
        let help = match finding.rule.id {
            // there are no lists of objects to name it in
            "cia301/missing-mandatory-object" => help.split(" and name").next().unwrap_or_default(),
            _ => help,
        };
        finding.help = Some(Cow::Owned(text(help, is_of_kinds)));
    }
    finding
}

/// A text with the keys that stand in it in backticks as XDD calls them.
fn text(text: &str, is_of_kinds: bool) -> String {
    let mut parts = text.split('`');
    let mut result = words(parts.next().unwrap_or_default(), is_of_kinds);
    for (number, part) in parts.enumerate() {
        result.push('`');
        result.push_str(&if number % 2 == 0 { code(part) } else { words(part, is_of_kinds) });
    }
    result
}

fn words(text: &str, is_of_kinds: bool) -> String {
    let text = text.replace("a section", "an element").replace("section", "element");
    let text = text.replace("the key", "the attribute");
    if is_of_kinds { text.replace("a DCF", "an XDC").replace(".dcf", ".xdc") } else { text }
}

fn code(text: &str) -> String {
    let (key, value) = text.split_once('=').map_or((text, None), |(key, value)| (key, Some(value)));
    if let Some(rate) =
        key.strip_prefix("BaudRate_").filter(|rate| rate.bytes().all(|byte| byte.is_ascii_digit()))
    {
        return format!("<supportedBaudRate value=\"{rate} Kbps\"/>");
    }
    named(key, value).or_else(|| section(text)).unwrap_or_else(|| text.to_owned())
}

/// The element that is the section of an object: `[1018]` or `[1018sub1]`.
fn section(text: &str) -> Option<String> {
    let name = text.strip_prefix('[')?.strip_suffix(']')?;
    let is_hex = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_hexdigit());
    match name.split_once("sub") {
        Some((index, sub)) if is_hex(index) && is_hex(sub) => {
            Some(format!("<CANopenSubObject subIndex=\"{sub:0>2}\">"))
        }
        None if is_hex(name) => Some(format!("<CANopenObject index=\"{name:0>4}\">")),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_become_attributes() {
        for (eds, xdd) in [
            ("write `SubNumber=5`", "write `subNumber=\"5\"`"),
            ("a VAR needs `DataType` and `AccessType`", "a VAR needs `dataType` and `accessType`"),
            (
                "write `PDOMapping=1`, or `AccessType=rww`",
                "write `PDOmapping=\"optional\"`, or `access=\"readWriteOutput\"`",
            ),
            ("write `ObjectType=0x9` and `ObjFlags=0x1`", "write `objectType=\"9\"` and `objFlags=\"0001\"`"),
            (
                "add `[1018sub1]` with `DataType=0x0007`",
                "add `<CANopenSubObject subIndex=\"01\">` with `dataType=\"0007\"`",
            ),
            ("add a section `[A00]`", "add an element `<CANopenObject index=\"0A00\">`"),
            (
                "write `BaudRate_125=1` or `VendorNumber=0x59`",
                "write `<supportedBaudRate value=\"125 Kbps\"/>` or `<vendorID>0x59</vendorID>`",
            ),
            (
                "write `LSS_Supported=1`, remove the key",
                "write `layerSettingServiceSlave=\"true\"`, remove the attribute",
            ),
            ("write `ParameterName=` and a name", "write `name=\"…\"` and a name"),
            ("`RevisionNumber` is `0x1=2`; EDS", "`RevisionNumber` is `0x1=2`; EDS"),
        ] {
            assert_eq!(text(eds, false), xdd);
        }
        assert_eq!(text("`Denotation` belongs into a DCF", true), "`denotation` belongs into an XDC");
    }
}
