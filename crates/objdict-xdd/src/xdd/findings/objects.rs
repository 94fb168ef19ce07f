//! The rules about objects: duplicates, and contradictions between an object and its parameter.

use std::collections::HashMap;

use crate::diagnostic::{Diagnostic, Findings, Fix, RuleInfo, counted, say, text_rules};
use crate::model::{DataType, SimpleType};
use crate::xdd::types::agree;
use crate::xml::{Attribute, Element, Name, n};

use super::ids::Ids;
use super::parameters::{self, Number};
use super::walk::Walk;

text_rules! {
    source: "CiA 311 annex A";

    "cia311/duplicate-object" = DUPLICATE_OBJECT, Error, stops "*";
    summary: "an object is defined twice",
    checks: "Each index must occur only once in `CANopenObjectList`. The first object is used.",
    why: "Some tools use the first one, some the last one, some reject the file: the object dictionary is ambiguous.",
    example: r#"Two `<CANopenObject index="1018" …>`"#,
    remedy: "Keep one of them.",

    "cia311/duplicate-sub-object" = DUPLICATE_SUB_OBJECT, Error, stops "*";
    summary: "a sub-object is defined twice",
    checks: "Each sub-index must occur only once in its object. The first sub-object is used.",
    why: "Some tools use the first one, some the last one, some reject the file.",
    example: r#"Two `<CANopenSubObject subIndex="01" …>` in one object"#,
    remedy: "Keep one of them, or change the sub-index of the other.",

    "cia311/contradicting-data-type" = CONTRADICTING_DATA_TYPE, Error, stops "*";
    summary: "an object and its parameter have different data types",
    checks: "An object's `dataType` must match the simple type of its parameter, if there is a simple type for it. Types of 24, 40, 48 and 56 bits, times, DOMAIN and OCTET_STRING have none, so any type is accepted.",
    why: "Some tools use the object's data type, some the parameter's: they read a different number of bytes from the device.",
    example: r#"`dataType="0006"` of an object whose parameter has `<UDINT/>`"#,
    remedy: "Correct one of the two, or remove `dataType`.",

    "cia311/contradicting-access" = CONTRADICTING_ACCESS, Warning;
    summary: "an object and its parameter have different access types",
    checks: "If both are stated, an object's `accessType` must match `access` of its parameter. `readWriteInput` and `readWriteOutput` are `rw`; `ro` and `const` are equivalent.",
    why: "Some tools use the object's access type, some the parameter's: they do not write a writable entry or try to write a read-only one.",
    example: r#"`accessType="ro"` of an object whose parameter has `access="readWrite"`"#,
    remedy: "Correct one of the two, or remove `accessType`.",

    "cia311/contradicting-mapping" = CONTRADICTING_MAPPING, Warning, fix Unsafe;
    summary: "an object and its parameter name different PDO directions",
    checks: "If an object has `PDOmapping=\"RPDO\"`, its parameter must not have `access=\"readWriteInput\"`. If it has `TPDO`, the parameter must not have `readWriteOutput`. `PDOmapping` is used.",
    why: "A process input is sent in a TPDO, an output received in an RPDO. Some versions of CANopenEditor confuse the two in `access`; tools that follow it offer the entry for PDOs of the wrong direction.",
    example: r#"`PDOmapping="RPDO"` of an object whose parameter has `access="readWriteInput"`"#,
    remedy: "Write `readWriteOutput` for an RPDO and `readWriteInput` for a TPDO.",

    "cia311/contradicting-value" = CONTRADICTING_VALUE, Warning;
    summary: "an object and its parameter have different values, defaults or limits",
    checks: "If both are stated, an object's `defaultValue`, `actualValue`, `lowLimit` and `highLimit` must match its parameter. Numbers are compared as numbers; limits only if the parameter has a single range.",
    why: "Some tools use the object's value, some the parameter's.",
    example: r#"`defaultValue="1"` of an object whose parameter has `<defaultValue value="2"/>`"#,
    remedy: "Correct one of the two, or remove the object's value.",

    "cia311/contradicting-name" = CONTRADICTING_NAME, Note;
    summary: "an object and its parameter have different names",
    checks: "An object's `name` must be one of its parameter's labels, if the parameter has labels. Spaces and capital letters are ignored.",
    why: "Some tools show the object's name, some the parameter's: users of two tools look for one object under two names. Often the reference leads to the wrong parameter.",
    example: r#"`name="Speed"` of an object whose parameter has `<label lang="en">Torque</label>`"#,
    remedy: "Write the same name, or correct `uniqueIDRef`.",

    "cia311/wrong-object-count" = WRONG_OBJECT_COUNT, Warning;
    summary: "the number of objects is wrong",
    checks: "`manufacturerObjects` must be the number of objects from 2000h to 5FFFh. The total of `mandatoryObjects` and `optionalObjects` must be the number of the others, with or without data type definitions below 1000h. Only the total is checked because the mandatory objects depend on the device.",
    why: "Objects were added or removed without updating the count; an object may be missing.",
    example: r#"`mandatoryObjects="3" optionalObjects="10"` with twelve objects below 2000h and from 6000h on"#,
    remedy: "Write the right numbers, or remove the attributes.",

    "cia311/duplicate-baud-rate" = DUPLICATE_BAUD_RATE, Warning;
    summary: "a bit rate is listed twice",
    checks: "Each `supportedBaudRate` of a `baudRate` must occur only once.",
    why: "Usually the second one should be a different bit rate, which tools do not offer.",
    example: r#"Two `<supportedBaudRate value="250 Kbps"/>`"#,
    remedy: "Remove one of them, or correct it.",

    "cia311/default-baud-rate-not-supported" = DEFAULT_BAUD_RATE_NOT_SUPPORTED, Warning;
    summary: "the default bit rate is not supported",
    checks: "If both are stated, `defaultValue` of `baudRate` must be one of its `supportedBaudRate`.",
    why: "Tools do not offer the bit rate that the device uses by default.",
    example: r#"`<baudRate defaultValue="1000 Kbps"><supportedBaudRate value="125 Kbps"/></baudRate>`"#,
    remedy: "Add the bit rate, or correct the default.",
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
        duplicate_baud_rate(baud_rate, walk.findings);
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
            format!("{what} `{}` is defined twice; the first one is used", attribute.value().trim_ascii());
        let finding = Diagnostic::new(rule, attribute.value_span(), message);
        findings.push(finding.label(first.value_span(), "first here").help("keep one of the two"));
    } else {
        first.insert(number, attribute);
    }
}

/// Compares an object with the parameter it refers to.
fn against_parameter(object: Element<'_>, ids: &Ids<'_>, findings: &mut Findings) {
    let Some(reference) = object.attribute(n::uniqueIDRef) else { return };
    let parameter =
        ids.element(reference).filter(|element| matches!(element.tag(), n::parameter | n::varDeclaration));
    let Some(parameter) = parameter else { return };
    let stated = object.attribute(n::dataType).and_then(hex).map(DataType);
    let of_value = stated.or_else(|| parameters::own_type(parameter));
    let is_value = object.child(n::CANopenSubObject).is_none() && ids.belongs_to_entry(parameter);
    if let Some(data_type) = of_value.filter(|_| is_value) {
        parameters::fit(parameter, data_type, |name| object.attribute(name).is_none(), findings);
    }
    for attribute in object.attributes() {
        match attribute.tag() {
            n::dataType => data_type(object, attribute, parameter, findings),
            n::accessType => access(attribute, parameter, findings),
            n::PDOmapping => mapping(attribute, parameter, findings),
            n::defaultValue => value(attribute, parameter, parameter.child(n::defaultValue), findings),
            n::actualValue => value(attribute, parameter, parameter.child(n::actualValue), findings),
            n::lowLimit => value(attribute, parameter, single_range(parameter, n::minValue), findings),
            n::name => label(attribute, parameter, findings),
            n::highLimit => value(attribute, parameter, single_range(parameter, n::maxValue), findings),
            _ => {}
        }
    }
}

fn data_type(object: Element<'_>, attribute: Attribute<'_>, parameter: Element<'_>, findings: &mut Findings) {
    // tools disagree about the data type of an ARRAY or RECORD
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
        "`{}` is {data_type}, but the type of the parameter is `{}`",
        attribute.value().trim_ascii(),
        element.name()
    );
    let finding = Diagnostic::new(&CONTRADICTING_DATA_TYPE, attribute.value_span(), message);
    findings.push(finding.label(element.name_span(), "the parameter").help("correct one of the two"));
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
    let message = say!("the access type is `{}` here, but `{!}` in the parameter", stated, of_parameter);
    let finding = Diagnostic::new(&CONTRADICTING_ACCESS, attribute.value_span(), message);
    let help = match right {
        [] => "correct one of the two or remove `accessType`".to_owned(),
        [right, ..] => format!("write `{right}`, correct the parameter or remove `accessType`"),
    };
    findings.push(finding.label(other.value_span(), "the parameter").help(help));
}

fn mapping(attribute: Attribute<'_>, parameter: Element<'_>, findings: &mut Findings) {
    let Some(access) = parameter.attribute(n::access) else { return };
    let (stated, other) = (attribute.value(), access.value());
    let right = match (stated.trim_ascii(), other.trim_ascii()) {
        ("RPDO", "readWriteInput") => "readWriteOutput",
        ("TPDO", "readWriteOutput") => "readWriteInput",
        _ => return,
    };
    let (stated, other) = (stated.trim_ascii(), other.trim_ascii());
    let message = say!(
        "`access` of the parameter is `{!}`, but `PDOmapping` of the object is `{!}`, which is used",
        other,
        stated
    );
    let fix = Fix::risky(format!("write `{right}`")).replace(access.value_span(), right);
    let finding = Diagnostic::new(&CONTRADICTING_MAPPING, access.value_span(), message);
    findings
        .push(finding.label(attribute.value_span(), "the object").help(format!("write `{right}`")).fix(fix));
}

/// A limit of a parameter whose allowed values are a single range.
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
        // a number and a string may differ only in spelling
        (Some(_), None) | (None, Some(_)) => return,
        (None, None) => spelling(stated) == spelling(text),
    };
    if is_same {
        return;
    }
    let message =
        say!("`{!}` is `{}` here, but `{}` in the `{!}`", attribute.name(), stated, text, parameter.name());
    let finding = Diagnostic::new(&CONTRADICTING_VALUE, attribute.value_span(), message);
    let help = format!("correct one of the two or remove `{}`", attribute.name());
    findings.push(finding.label(other.value_span(), "the parameter").help(help));
}

fn label(attribute: Attribute<'_>, parameter: Element<'_>, findings: &mut Findings) {
    let name = attribute.value();
    let labels: Vec<_> = parameter.children_named(n::label).collect();
    let Some(first) = labels.first().filter(|_| !name.trim_ascii().is_empty()) else { return };
    if labels.iter().any(|label| spelling(&label.text()) == spelling(&name)) {
        return;
    }
    let message =
        say!("`name` is `{}` here, but `{}` in the parameter", name.trim_ascii(), first.text().trim_ascii());
    let finding = Diagnostic::new(&CONTRADICTING_NAME, attribute.value_span(), message);
    let help = "write the same name, or correct `uniqueIDRef`";
    findings.push(finding.label(first.text_span(), "the parameter").help(help));
}

/// A string normalised for comparison: without spaces and capital letters.
fn spelling(text: &str) -> String {
    text.split_ascii_whitespace().collect::<String>().to_ascii_lowercase()
}

fn counts(list: Element<'_>, findings: &mut Findings) {
    let indexes = list.children_named(n::CANopenObject).filter_map(|object| hex(object.attribute(n::index)?));
    let (ours, others): (Vec<u16>, Vec<u16>) = indexes.partition(|index| (0x2000..0x6000).contains(index));
    // an EDS does not list the definitions of data types, so some tools omit them from the count
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
            format!("`manufacturerObjects` is {stated}, but the list has {there} from 2000h to 5FFFh");
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
            "`mandatoryObjects` is {mandatory} and `optionalObjects` {optional}, but the list has {} outside 2000h to 5FFFh",
            counted(others.len(), "object", "objects")
        );
        let finding = Diagnostic::new(&WRONG_OBJECT_COUNT, second.value_span(), message);
        let finding = finding.label(attribute.value_span(), "the mandatory objects");
        findings.push(match others.len().checked_sub(mandatory) {
            Some(right) => {
                finding.help(format!("write `optionalObjects=\"{right}\"` if {mandatory} are mandatory"))
            }
            None => finding.help("recount the objects"),
        });
    }
}

fn duplicate_baud_rate(baud_rate: Element<'_>, findings: &mut Findings) {
    let mut first = HashMap::new();
    let rates = baud_rate.children_named(n::supportedBaudRate).filter_map(|rate| rate.attribute(n::value));
    for rate in rates {
        let value = rate.value();
        let Some(before) = first.insert(value.trim_ascii().to_owned(), rate) else { continue };
        let message = format!("the bit rate `{}` is listed twice", value.trim_ascii());
        let finding = Diagnostic::new(&DUPLICATE_BAUD_RATE, rate.value_span(), message);
        findings.push(
            finding.label(before.value_span(), "also here").help("remove one of the two, or correct it"),
        );
    }
}

fn default_baud_rate(baud_rate: Element<'_>, findings: &mut Findings) {
    let Some(default) = baud_rate.attribute(n::defaultValue) else { return };
    let mut supported =
        baud_rate.children_named(n::supportedBaudRate).filter_map(|rate| rate.attribute(n::value)).peekable();
    let value = default.value();
    if supported.peek().is_some() && !supported.any(|rate| rate.value().trim_ascii() == value.trim_ascii()) {
        let message = format!("the default bit rate `{value}` is not supported");
        let finding = Diagnostic::new(&DEFAULT_BAUD_RATE_NOT_SUPPORTED, default.value_span(), message);
        findings.push(
            finding.help(format!("add `<supportedBaudRate value=\"{value}\"/>` or correct the default")),
        );
    }
}
