//! The rules about objects: what stands twice, and what contradicts the parameter that it refers to.

use std::collections::HashMap;

use crate::diagnostic::{Diagnostic, Findings, RuleInfo, counted, text_rules};
use crate::model::{DataType, SimpleType};
use crate::xml::{Attribute, Element, Name, n};

use super::ids::Ids;
use super::number::Number;
use super::walk::Walk;

text_rules! {
    /// an object stands twice
    ///
    /// ## What it checks
    /// Whether each index occurs once in `CANopenObjectList`. The first object is read.
    ///
    /// ## Why it matters
    /// Some tools take the first one, some the last one, some refuse the file: the device has two dictionaries.
    ///
    /// ## Example
    /// Two `<CANopenObject index="1018" …>`
    ///
    /// ## How to mend
    /// Keep one of them.
    ///
    /// ## Source
    /// CiA 311 annex A
    DUPLICATE_OBJECT = "cia311/duplicate-object", Error;

    /// a sub-object stands twice
    ///
    /// ## What it checks
    /// Whether each sub-index occurs once in its object. The first sub-object is read.
    ///
    /// ## Why it matters
    /// Some tools take the first one, some the last one, some refuse the file.
    ///
    /// ## Example
    /// Two `<CANopenSubObject subIndex="01" …>` in one object
    ///
    /// ## How to mend
    /// Keep one of them, or give the other its own sub-index.
    ///
    /// ## Source
    /// CiA 311 annex A
    DUPLICATE_SUB_OBJECT = "cia311/duplicate-sub-object", Error;

    /// an object has another data type than its parameter
    ///
    /// ## What it checks
    /// Whether `dataType` of an object agrees with the simple type of the parameter that it refers to, where the data type has such a type. Those of 24, 40, 48 and 56 bits, times, DOMAIN and OCTET_STRING have none, so any will do.
    ///
    /// ## Why it matters
    /// Some tools take the data type of the object, some that of the parameter: they read another number of bytes from the device.
    ///
    /// ## Example
    /// `dataType="0006"` of an object whose parameter has `<UDINT/>`
    ///
    /// ## How to mend
    /// Correct one of the two, or leave out `dataType`.
    ///
    /// ## Source
    /// CiA 311 annex A
    CONTRADICTING_DATA_TYPE = "cia311/contradicting-data-type", Error;

    /// an object has another access type than its parameter
    ///
    /// ## What it checks
    /// Whether `accessType` of an object agrees with `access` of the parameter that it refers to, where both are there. `readWriteInput` and `readWriteOutput` are `rw`; `ro` and `const` may stand for each other.
    ///
    /// ## Why it matters
    /// Some tools take the one, some the other: they refuse to write a value that the device takes, or try to write one that it refuses.
    ///
    /// ## Example
    /// `accessType="ro"` of an object whose parameter has `access="readWrite"`
    ///
    /// ## How to mend
    /// Correct one of the two, or leave out `accessType`.
    ///
    /// ## Source
    /// CiA 311 annex A
    CONTRADICTING_ACCESS = "cia311/contradicting-access", Warning;

    /// an object has another default, limit or value than its parameter
    ///
    /// ## What it checks
    /// Whether `defaultValue`, `actualValue`, `lowLimit` and `highLimit` of an object are what the parameter says that it refers to, where both are there. Numbers are compared as numbers; limits only with a single range.
    ///
    /// ## Why it matters
    /// Some tools take the one, some the other.
    ///
    /// ## Example
    /// `defaultValue="1"` of an object whose parameter has `<defaultValue value="2"/>`
    ///
    /// ## How to mend
    /// Correct one of the two, or leave out that of the object.
    ///
    /// ## Source
    /// CiA 311 annex A
    CONTRADICTING_VALUE = "cia311/contradicting-value", Warning;

    /// the number of objects is wrong
    ///
    /// ## What it checks
    /// Whether `manufacturerObjects` is the number of objects from 2000h to 5FFFh, and `mandatoryObjects` and `optionalObjects` together that of the others, with or without the definitions of data types below 1000h. Which objects are mandatory depends on the device, so these two are counted together.
    ///
    /// ## Why it matters
    /// Someone added or removed objects by hand and did not count; perhaps one got lost.
    ///
    /// ## Example
    /// `mandatoryObjects="3" optionalObjects="10"` with twelve objects below 2000h and from 6000h on
    ///
    /// ## How to mend
    /// Write the right numbers, or leave the attributes out.
    ///
    /// ## Source
    /// CiA 311 annex A
    WRONG_OBJECT_COUNT = "cia311/wrong-object-count", Warning;

    /// the default bit rate is not among the supported ones
    ///
    /// ## What it checks
    /// Whether `defaultValue` of `baudRate` is one of its `supportedBaudRate`, where both are there.
    ///
    /// ## Why it matters
    /// Out of the box the device has a bit rate that no tool offers for it.
    ///
    /// ## Example
    /// `<baudRate defaultValue="1000 Kbps"><supportedBaudRate value="125 Kbps"/></baudRate>`
    ///
    /// ## How to mend
    /// Add the bit rate, or correct the default.
    ///
    /// ## Source
    /// CiA 311 annex A
    DEFAULT_BAUD_RATE_NOT_SUPPORTED = "cia311/default-baud-rate-not-supported", Warning;
}

/// All rules of this module.
pub(super) fn check(walk: &mut Walk<'_, '_>) {
    let lists = std::mem::take(&mut walk.object_lists);
    for list in lists {
        let mut first = HashMap::new();
        for object in list.children_named(n::CANopenObject) {
            twice(object, n::index, &DUPLICATE_OBJECT, &mut first, walk.findings);
            let mut first = HashMap::new();
            for sub in object.children_named(n::CANopenSubObject) {
                twice(sub, n::subIndex, &DUPLICATE_SUB_OBJECT, &mut first, walk.findings);
                against_parameter(sub, &walk.ids, walk.findings);
            }
            against_parameter(object, &walk.ids, walk.findings);
        }
        counts(list, walk.findings);
    }
    for baud_rate in walk.seen.of([n::baudRate]) {
        default_baud_rate(baud_rate, walk.findings);
    }
}

/// The number in hex digits.
fn hex(attribute: Attribute<'_>) -> Option<u16> {
    u16::from_str_radix(attribute.value().trim_ascii(), 16).ok()
}

fn twice<'a>(
    element: Element<'a>,
    name: Name,
    rule: &'static RuleInfo,
    first: &mut HashMap<u16, Attribute<'a>>,
    findings: &mut Findings,
) {
    let Some(attribute) = element.attribute(name) else { return };
    let Some(number) = hex(attribute) else { return };
    if let Some(first) = first.get(&number) {
        let what = if name == n::index { "object" } else { "sub-index" };
        let message =
            format!("{what} `{}` stands twice; the first one is read", attribute.value().trim_ascii());
        let finding = Diagnostic::new(rule, attribute.value_span(), message);
        findings.push(finding.label(first.value_span(), "first here").help("keep one of the two"));
    } else {
        first.insert(number, attribute);
    }
}

/// Compares an object with the parameter that it refers to.
fn against_parameter(object: Element<'_>, ids: &Ids<'_>, findings: &mut Findings) {
    let Some(reference) = object.attribute(n::uniqueIDRef) else { return };
    let parameter =
        ids.element(reference).filter(|element| matches!(element.tag(), n::parameter | n::varDeclaration));
    let Some(parameter) = parameter else { return };
    for attribute in object.attributes() {
        match attribute.tag() {
            n::dataType => data_type(object, attribute, parameter, findings),
            n::accessType => access(attribute, parameter, findings),
            n::defaultValue => value(attribute, parameter, parameter.child(n::defaultValue), findings),
            n::actualValue => value(attribute, parameter, parameter.child(n::actualValue), findings),
            n::lowLimit => value(attribute, parameter, single_range(parameter, n::minValue), findings),
            n::highLimit => value(attribute, parameter, single_range(parameter, n::maxValue), findings),
            _ => {}
        }
    }
}

fn data_type(object: Element<'_>, attribute: Attribute<'_>, parameter: Element<'_>, findings: &mut Findings) {
    // what the type of an ARRAY or RECORD is that of, tools do not agree about
    if object.child(n::CANopenSubObject).is_some() {
        return;
    }
    let simple =
        parameter.children().find_map(|child| Some((child, SimpleType::from_name(child.tag().text())?)));
    let (Some(data_type), Some((element, simple))) = (hex(attribute).map(DataType), simple) else { return };
    if agree(data_type, simple) {
        return;
    }
    let message = format!(
        "`{}` is {data_type}, and the parameter is of type `{}`",
        attribute.value().trim_ascii(),
        element.name()
    );
    let finding = Diagnostic::new(&CONTRADICTING_DATA_TYPE, attribute.value_span(), message);
    findings.push(finding.label(element.name_span(), "the parameter's").help("correct one of the two"));
}

/// Whether values of a data type may be called by a simple type.
fn agree(data_type: DataType, simple: SimpleType) -> bool {
    let exact: &[SimpleType] = match data_type {
        DataType::BOOLEAN => &[SimpleType::Bool],
        DataType::INTEGER8 => &[SimpleType::Sint, SimpleType::Byte],
        DataType::INTEGER16 => &[SimpleType::Int, SimpleType::Word],
        DataType::INTEGER32 => &[SimpleType::Dint, SimpleType::Dword],
        DataType::INTEGER64 => &[SimpleType::Lint, SimpleType::Lword],
        DataType::UNSIGNED8 => &[SimpleType::Usint, SimpleType::Byte, SimpleType::Char],
        DataType::UNSIGNED16 => &[SimpleType::Uint, SimpleType::Word],
        DataType::UNSIGNED32 => &[SimpleType::Udint, SimpleType::Dword],
        DataType::UNSIGNED64 => &[SimpleType::Ulint, SimpleType::Lword],
        DataType::REAL32 => &[SimpleType::Real],
        DataType::REAL64 => &[SimpleType::Lreal],
        DataType::VISIBLE_STRING => &[SimpleType::String, SimpleType::Char],
        DataType::UNICODE_STRING => &[SimpleType::Wstring, SimpleType::String],
        // none is exact
        _ => return true,
    };
    simple == SimpleType::Bitstring || exact.contains(&simple)
}

fn access(attribute: Attribute<'_>, parameter: Element<'_>, findings: &mut Findings) {
    let Some(other) = parameter.attribute(n::access) else { return };
    let (stated, of_parameter) = (attribute.value(), other.value());
    let (stated, of_parameter) = (stated.trim_ascii(), of_parameter.trim_ascii());
    let right: &[&str] = match of_parameter {
        "const" | "read" => &["ro", "const"],
        "write" => &["wo"],
        "readWrite" | "readWriteInput" | "readWriteOutput" => &["rw"],
        "noAccess" => &[],
        _ => return,
    };
    if right.contains(&stated) || !matches!(stated, "ro" | "wo" | "rw" | "const") {
        return;
    }
    let message = format!("`{stated}` here, and `{of_parameter}` at the parameter");
    let finding = Diagnostic::new(&CONTRADICTING_ACCESS, attribute.value_span(), message);
    let help = match right {
        [] => "correct one of the two, or leave out `accessType`".to_owned(),
        [right, ..] => format!("write `{right}`, correct the parameter, or leave out `accessType`"),
    };
    findings.push(finding.label(other.value_span(), "the parameter's").help(help));
}

/// An end of the range of a parameter that has one range and nothing else.
fn single_range<'a>(parameter: Element<'a>, end: Name) -> Option<Element<'a>> {
    let mut allowed = parameter.child(n::allowedValues)?.children();
    let range = allowed.next().filter(|range| range.tag() == n::range)?;
    if allowed.next().is_some() {
        return None;
    }
    range.child(end)
}

fn value(
    attribute: Attribute<'_>,
    parameter: Element<'_>,
    of_parameter: Option<Element<'_>>,
    findings: &mut Findings,
) {
    let Some(other) = of_parameter.and_then(|element| element.attribute(n::value)) else { return };
    let (stated, text) = (attribute.value(), other.value());
    let (stated, text) = (stated.trim_ascii(), text.trim_ascii());
    let is_same = match (Number::parse(stated), Number::parse(text)) {
        (Some(a), Some(b)) => a.is_same(&b),
        // a number against a text may be a matter of spelling
        (Some(_), None) | (None, Some(_)) => return,
        (None, None) => spelling(stated) == spelling(text),
    };
    if is_same {
        return;
    }
    let message =
        format!("`{}` is `{stated}` here, and `{text}` at the `{}`", attribute.name(), parameter.name());
    let finding = Diagnostic::new(&CONTRADICTING_VALUE, attribute.value_span(), message);
    let help = format!("correct one of the two, or leave out `{}`", attribute.name());
    findings.push(finding.label(other.value_span(), "the parameter's").help(help));
}

/// A text without what people write in one way or another: blanks and capital letters.
fn spelling(text: &str) -> String {
    text.split_ascii_whitespace().collect::<String>().to_ascii_lowercase()
}

fn counts(list: Element<'_>, findings: &mut Findings) {
    let indexes = list.children_named(n::CANopenObject).filter_map(|object| hex(object.attribute(n::index)?));
    let (ours, others): (Vec<u16>, Vec<u16>) = indexes.partition(|index| (0x2000..0x6000).contains(index));
    // an EDS has the definitions of data types in no list, so some do not count them
    let definitions = others.iter().filter(|&&index| index < 0x1000).count();
    let number = |name: Name| {
        let attribute = list.attribute(name)?;
        Some((attribute, attribute.value().trim_ascii().parse::<usize>().ok()?))
    };
    if let Some((attribute, stated)) =
        number(n::manufacturerObjects).filter(|&(_, stated)| stated != ours.len())
    {
        let there = counted(ours.len(), "object", "objects");
        let message =
            format!("`manufacturerObjects` is {stated}, and from 2000h to 5FFFh the list has {there}");
        let finding = Diagnostic::new(&WRONG_OBJECT_COUNT, attribute.value_span(), message);
        findings.push(finding.help(format!("write `{}`", ours.len())));
    }
    let (Some((attribute, mandatory)), Some((second, optional))) =
        (number(n::mandatoryObjects), number(n::optionalObjects))
    else {
        return;
    };
    let stated = mandatory.saturating_add(optional);
    if stated != others.len() && stated != others.len() - definitions {
        let message = format!(
            "`mandatoryObjects` is {mandatory}, `optionalObjects` {optional}, and outside 2000h to 5FFFh the list has {}",
            counted(others.len(), "object", "objects")
        );
        let finding = Diagnostic::new(&WRONG_OBJECT_COUNT, second.value_span(), message);
        let finding = finding.label(attribute.value_span(), "the mandatory ones");
        findings.push(match others.len().checked_sub(mandatory) {
            Some(right) => finding.help(format!("write `{right}`, if {mandatory} are mandatory")),
            None => finding.help("count the objects again"),
        });
    }
}

fn default_baud_rate(baud_rate: Element<'_>, findings: &mut Findings) {
    let Some(default) = baud_rate.attribute(n::defaultValue) else { return };
    let mut supported =
        baud_rate.children_named(n::supportedBaudRate).filter_map(|rate| rate.attribute(n::value)).peekable();
    let value = default.value();
    if supported.peek().is_some() && !supported.any(|rate| rate.value().trim_ascii() == value.trim_ascii()) {
        let message = format!("the default `{value}` is not among the supported bit rates");
        let finding = Diagnostic::new(&DEFAULT_BAUD_RATE_NOT_SUPPORTED, default.value_span(), message);
        findings.push(
            finding.help(format!("add `<supportedBaudRate value=\"{value}\"/>`, or correct the default")),
        );
    }
}
