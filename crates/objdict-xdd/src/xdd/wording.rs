//! Findings about the model in the words of CiA 311. The rules of the model speak of sections and keys, for these are what
//! its fields are called; who has an XDD before him looks for attributes.

use std::borrow::Cow;
use std::collections::HashSet;

use crate::diagnostic::{At, Diagnostic, Findings, Severity};
use crate::model::Field;
use crate::source::Span;

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

/// Keys that are attributes or elements of another name, with what they are called.
const NAMES: [(&str, Name); 43] = [
    ("ParameterName", Name::Attribute("name")),
    ("ObjectType", Name::Decimal("objectType")),
    ("DataType", Name::Hex("dataType")),
    ("AccessType", Name::Attribute("accessType")),
    ("DefaultValue", Name::Attribute("defaultValue")),
    ("LowLimit", Name::Attribute("lowLimit")),
    ("HighLimit", Name::Attribute("highLimit")),
    ("PDOMapping", Name::Attribute("PDOmapping")),
    ("ObjFlags", Name::Hex("objFlags")),
    ("SubNumber", Name::Attribute("subNumber")),
    ("ParameterValue", Name::Attribute("actualValue")),
    ("Denotation", Name::Attribute("denotation")),
    ("FileName", Name::Attribute("fileName")),
    ("FileVersion", Name::Attribute("fileVersion")),
    ("CreationDate", Name::Attribute("fileCreationDate")),
    ("CreationTime", Name::Attribute("fileCreationTime")),
    ("CreatedBy", Name::Attribute("fileCreator")),
    ("ModificationDate", Name::Attribute("fileModificationDate")),
    ("ModificationTime", Name::Attribute("fileModificationTime")),
    ("ModifiedBy", Name::Attribute("fileModifiedBy")),
    ("VendorName", Name::Element("vendorName")),
    ("VendorNumber", Name::Element("vendorID")),
    ("ProductName", Name::Element("productName")),
    ("ProductNumber", Name::Element("productID")),
    ("OrderCode", Name::Element("orderNumber")),
    ("SimpleBootUpMaster", Name::Flag("bootUpMaster")),
    ("SimpleBootUpSlave", Name::Flag("bootUpSlave")),
    ("Granularity", Name::Attribute("granularity")),
    ("DynamicChannelsSupported", Name::Attribute("dynamicChannels")),
    ("GroupMessaging", Name::Flag("groupMessaging")),
    ("NrOfRXPDO", Name::Attribute("nrOfRxPDO")),
    ("NrOfTXPDO", Name::Attribute("nrOfTxPDO")),
    ("LSS_Supported", Name::Flag("layerSettingServiceSlave")),
    ("BaudRate_x", Name::Attribute("supportedBaudRate")),
    ("NodeID", Name::Attribute("nodeID")),
    ("NodeName", Name::Attribute("nodeName")),
    ("Baudrate", Name::Attribute("actualBaudRate")),
    ("NetNumber", Name::Attribute("networkNumber")),
    ("NetworkName", Name::Attribute("networkName")),
    ("CANopenManager", Name::Flag("CANopenManager")),
    ("[DeviceInfo]", Name::Attribute("baudRate")),
    ("[DeviceComissioning]", Name::Attribute("deviceCommissioning")),
    ("[DynamicChannels]", Name::Attribute("dynamicChannels")),
];

/// What a key is in an XDD.
#[derive(Clone, Copy)]
enum Name {
    /// An attribute with the same text.
    Attribute(&'static str),
    /// A number in decimal.
    Decimal(&'static str),
    /// A number of four hex digits.
    Hex(&'static str),
    /// `true` or `false`.
    Flag(&'static str),
    /// An element with the text in it.
    Element(&'static str),
}

impl Name {
    fn name(self) -> &'static str {
        match self {
            Self::Attribute(name)
            | Self::Decimal(name)
            | Self::Hex(name)
            | Self::Flag(name)
            | Self::Element(name) => name,
        }
    }

    /// The name with a value, which an EDS would write so.
    fn with(self, value: &str) -> String {
        let name = self.name();
        let number = value.strip_prefix("0x").and_then(|digits| u32::from_str_radix(digits, 16).ok());
        match (self, value, number) {
            (Self::Attribute("accessType"), "rwr", _) => "access=\"readWriteInput\"".to_owned(),
            (Self::Attribute("accessType"), "rww", _) => "access=\"readWriteOutput\"".to_owned(),
            (Self::Attribute("PDOmapping"), "0", _) => format!("{name}=\"no\""),
            (Self::Attribute("PDOmapping"), "1", _) => format!("{name}=\"optional\""),
            (Self::Flag(_), "0" | "1", _) => format!("{name}=\"{}\"", value == "1"),
            (Self::Decimal(_), _, Some(number)) => format!("{name}=\"{number}\""),
            (Self::Hex(_), _, Some(number)) => format!("{name}=\"{number:04X}\""),
            (Self::Element(_), ..) => format!("<{name}>{value}</{name}>"),
            (_, "", _) => format!("{name}=\"…\""),
            _ => format!("{name}=\"{value}\""),
        }
    }
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
    match (NAMES.iter().find(|(name, _)| *name == key), value) {
        (Some((_, name)), Some(value)) => name.with(value),
        (Some((_, name)), None) => name.name().to_owned(),
        (None, _) => section(text).unwrap_or_else(|| text.to_owned()),
    }
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

    #[test]
    fn every_key_is_one() {
        for (key, _) in NAMES {
            let is_field = Field::NAMED.iter().any(|(name, _)| *name == key);
            assert!(is_field || key.starts_with('[') || key == "BaudRate_x", "{key}");
        }
    }
}
