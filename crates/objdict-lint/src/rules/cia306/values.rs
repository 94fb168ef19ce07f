//! Defaults and other values with their limits.

use std::cmp::Ordering;

use crate::diagnostic::{Argument, Findings, Fix, Severity, Text, joined, say, sub_index};
use crate::literal::iec_number;
use crate::model::{
    Access, DataType, Device, Entry, Field, InvalidValue, ObjectType, Part, Place, Reason, TypeKind, Value,
};
use crate::profile::{self, EntryFacts, MAX_BLOCKS};
use crate::rule::rules;
use crate::{EntryAt, respell, stated};

rules! {
    source: "CiA 306-1 §4.6.3.2";

    "cia306/fixed-by-limits" = FIXED_BY_LIMITS, Note, EntryOf(fixed_by_limits);
    summary: "the limits of an entry allow only one value",
    checks: "`LowLimit` and `HighLimit` must differ in writable entries from 2000h on. Entries that `ObjFlags` excludes from downloads are commands and may have a single value. So may enumerations of a document, such as 6086h (motion profile type), whose default is that value: the device supports one of the defined choices.",
    why: "With only one allowed value, the entry is effectively a constant. Often a limit still has its initial value.",
    example: "`LowLimit=0` and `HighLimit=0` of an entry with `AccessType=rw`",
    remedy: "Correct the limits, or remove them.",

    "cia306/formula-out-of-range" = FORMULA_OUT_OF_RANGE, Error, EntryOf(formula_out_of_range);
    summary: "a formula exceeds the range of its data type",
    checks: "`$NODEID` plus the number must fit the data type for every node-ID from 1 to 127. In a DCF, this must be true of the node-ID of the node.",
    why: "On some nodes the value is truncated, which gives a wrong COB-ID or node-ID.",
    example: "`DefaultValue=$NODEID+0x90` of an UNSIGNED8",
    remedy: "Choose a larger data type, or correct the number.",
    source: "CiA 306-1 §4.3",

    "cia306/invalid-value" = INVALID_VALUE, Error, Device(invalid_value), fix Mixed,
        stops "*" at [ObjectType, DataType, AccessType, DefaultValue, ParameterValue, CompactSubObj];
    summary: "a value is not valid for its key",
    checks: "Numbers must be valid and within the range of their type or key. Defaults and limits must be valid for their data type. Access types, object types, dates and times must be defined in the standard. Invalid dates and times are only warnings; for dates and times that only differ in spelling, see `cia306/date-spelling`. In real files most findings are unknown access types (`R`), other number notations (`0000h`), words instead of numbers, and strings as the default of a DOMAIN or OCTET_STRING. Tools read each of them differently.",
    why: "Tools reject the file, drop the value or truncate it: 300 in an UNSIGNED8 becomes 44.",
    example: "`DefaultValue=300` of an UNSIGNED8",
    remedy: "Write a valid value, or correct the data type.",
    source: "CiA 306-1 §4.3, §4.6.3.2",

    "cia306/limits-on-text" = LIMITS_ON_TEXT, Warning, Entry(limits_on_text), fix Unsafe;
    summary: "a string has limits",
    checks: "`LowLimit` and `HighLimit` must be used with numbers only, not with VISIBLE_STRING, UNICODE_STRING, OCTET_STRING or DOMAIN.",
    why: "Strings have no defined order, so limits are meaningless. They may have been meant as lengths, or the data type is wrong.",
    example: "`DataType=0x0009` with `HighLimit=20`",
    remedy: "Remove the limits, or correct the data type.",

    "cia306/low-limit-above-high" = LOW_LIMIT_ABOVE_HIGH, Error, EntryOf(low_limit_above_high), fix Unsafe;
    summary: "the low limit is above the high limit",
    checks: "`LowLimit` must be at most `HighLimit`, both interpreted in the data type. Limits with `$NODEID` are evaluated for node-IDs 1 and 127, or for the node-ID of the DCF.",
    why: "No value is within such limits: tools reject every value or skip the check.",
    example: "`LowLimit=10` and `HighLimit=2`",
    remedy: "Swap the two. Write limits of signed types in decimal: `LowLimit=-128`.",

    "cia306/missing-constant" = MISSING_CONSTANT, Note, Entry(missing_constant);
    summary: "a constant has no value",
    checks: "Entries with access `const` must have a `DefaultValue`. Strings 1008h to 100Ah and identity 1018h are not checked, because several versions of a device often share one description. DOMAINs are not checked either. Sub-index 0 has its own rule.",
    why: "Tools know a constant without reading it from the device. Code generated from the description contains 0 instead.",
    example: "`AccessType=const` without `DefaultValue`",
    remedy: "Write the value, or `AccessType=ro` for a value that differs between devices.",

    "cia306/single-limit" = SINGLE_LIMIT, Note, Entry(single_limit);
    summary: "an entry has only one of the two limits",
    checks: "`LowLimit` and `HighLimit` must be both given or both missing. A low limit of 0 or above of a signed type and a high limit of any type leave the other end open.",
    why: "A single limit is allowed, but tools interpret the missing one differently: 0, the end of the type's range, or no limits at all.",
    example: "`HighLimit=100`, and no `LowLimit`",
    remedy: "Add the other limit.",

    "cia306/value-outside-limits" = VALUE_OUTSIDE_LIMITS, Error, EntryOf(value_outside_limits);
    summary: "a value is outside its limits",
    checks: "`DefaultValue`, `ParameterValue` and the numbers of `[xxxxValue]` must be between `LowLimit` and `HighLimit`. Formulas are evaluated for node-IDs 1 and 127, or for the node-ID of the DCF. 1010h and 1011h are not checked: their limits apply to the signature, not to the value that is read.",
    why: "The device rejects the value; a tool that restores it gets an abort.",
    example: "`DefaultValue=5` and `HighLimit=4`",
    remedy: "Correct the value or the limit.",
    source: "CiA 306-1 §4.6.3.2, §5.3.1",

    "cia306/write-only-default" = WRITE_ONLY_DEFAULT, Note, EntryOf(write_only_default);
    summary: "a write-only entry has a default",
    checks: "Reports entries with `AccessType=wo` and a `DefaultValue` other than 0. Settings that a device profile defines as `wo`, such as 60C4h sub-index 5 (size of data record), may have one.",
    why: "The entry cannot be read back, so tools fail when they restore or compare defaults. Mostly the entry is a command, and writing its default would execute the command.",
    example: "`AccessType=wo` and `DefaultValue=1`",
    remedy: "Remove the value, or correct the access type.",
}

fn formula_out_of_range(device: &Device, at: &EntryAt<'_>, findings: &mut Findings) {
    let entry = at.entry;
    let Some(data_type) = entry.data_type else { return };
    let fields = [
        (&Field::DefaultValue, entry.default.as_ref()),
        (&Field::LowLimit, entry.low_limit.as_ref()),
        (&Field::HighLimit, entry.high_limit.as_ref()),
        (&Field::ParameterValue, entry.configured_value()),
    ];
    for (field, value) in fields {
        if let Some(value @ Value::NodeId(_)) = value {
            check_formula(device, at, data_type, field, value, findings);
        }
    }
}

fn check_formula(
    device: &Device,
    at: &EntryAt<'_>,
    data_type: DataType,
    field: &Field,
    value: &Value,
    findings: &mut Findings,
) {
    let Some((_, highest)) = data_type.integer_range() else { return };
    let [_, node_id] = stated::node_ids(device);
    let Some(result) = value.integer_for(node_id).filter(|&result| result > highest) else { return };
    let message = say!(
        "`{}` is {} on node {}, but the maximum of {} is {}",
        value,
        result,
        node_id,
        data_type,
        highest
    );
    let finding = FORMULA_OUT_OF_RANGE
        .at(at.field(field.clone()), message)
        .label(at.field(Field::DataType), "the type");
    findings.push(finding.help("choose a larger data type, or correct the number"));
}

fn invalid_value(device: &Device, findings: &mut Findings) {
    for (part, invalid_values) in device.invalid_values() {
        for invalid in invalid_values.iter() {
            let data_type = device.data_type_of(&part, &invalid.field);
            let place = Place::of(part.clone()).field(invalid.field.clone());
            let fix = respell(invalid, data_type, place.clone());
            let finding = INVALID_VALUE.at(place, invalid_value_message(invalid, data_type));
            let is_date = matches!(invalid.reason, Reason::NotADate | Reason::NotAClockTime);
            // tools do not depend on dates
            let severity = if is_date { Severity::Warning } else { Severity::Error };
            let finding = finding.severity(severity).help(invalid_value_help(invalid, data_type));
            let finding = match fix {
                Some(fix) => finding.fix(fix),
                None => finding,
            };
            findings.push(if is_understood(invalid, data_type) { finding.understood() } else { finding });
        }
    }
}

/// Whether tables contain the meaning of the text.
fn is_understood(invalid: &InvalidValue, data_type: Option<DataType>) -> bool {
    match invalid.field {
        Field::AccessType => invalid.intended_access().is_some(),
        Field::DefaultValue => data_type.and_then(|data_type| invalid.intended(data_type)).is_some(),
        Field::CompactSubObj => invalid.text.trim() == "255", // read as 254
        _ => false,
    }
}

fn invalid_value_message(invalid: &InvalidValue, data_type: Option<DataType>) -> Text {
    let InvalidValue { field, text, reason } = invalid;
    let what = match data_type {
        Some(data_type) => say!("`{}` of type {}", field, data_type),
        None => say!("`{}`", field),
    };
    match reason {
        Reason::OutOfRange { low, high } => {
            say!("`{}` is out of range for {} ({} to {})", text, what, low, high)
        }
        Reason::NotANumber => say!("`{}` is not a number, but {} needs one", text, what),
        Reason::NotOctal => {
            say!("`{}` is not a number: a leading zero means octal, which has no digits 8 and 9", text)
        }
        Reason::NotReal => say!("`{}` is not a valid number for {}", text, what),
        Reason::NotHexBytes => {
            say!("`{}` is not a sequence of hex digit pairs, but {} needs one", text, what)
        }
        Reason::NotATime => say!("`{}` is not a time, but {} needs one", text, what),
        Reason::NotAFormula => say!("`{}` is not a formula of the form `$NODEID+number`", text),
        Reason::FormulaForType => say!("`{}` is a formula, but {} is not an integer", text, what),
        Reason::UnknownWord => say!("`{}` is not a valid {}", text, what),
        Reason::NotADate => say!("`{}` is not a date of the form `mm-dd-yyyy`", text),
        Reason::NotAClockTime => say!("`{}` is not a time of the form `hh:mmAM` or `hh:mmPM`", text),
        Reason::Malformed => say!("`{}` does not have the form required by {}", text, what),
    }
}

fn invalid_value_help(invalid: &InvalidValue, data_type: Option<DataType>) -> Text {
    if let Some(number) = iec_number(&invalid.text, &invalid.reason) {
        return say!("write `{}` if this is IEC 61131 notation", number);
    }
    match (&invalid.field, &invalid.reason) {
        (Field::AccessType, _) => match invalid.intended_access() {
            Some(access) => say!("did you mean `{}`? write one of {}", access, access_names()),
            None => say!("write one of the access types {}", access_names()),
        },
        (Field::ObjectType, _) => say!(
            "write one of the object types: {ObjectType:0x0} NULL, {ObjectType:0x2} DOMAIN, {ObjectType:0x5} DEFTYPE, {ObjectType:0x6} DEFSTRUCT, {ObjectType:0x7} VAR, {ObjectType:0x8} ARRAY, {ObjectType:0x9} RECORD"
        ),
        (Field::Count, _) => "write the number of sub-indexes, or `0;` and a number of bits".into(),
        (_, Reason::NotADate) => {
            "write month and day with two digits, the year with four: `01-31-2026`".into()
        }
        (_, Reason::NotAClockTime) => "write hour (01 to 12) and minute with two digits: `09:45AM`".into(),
        (_, Reason::NotAFormula) => {
            "write `$NODEID`, or `$NODEID+` and a number; other operators are not supported".into()
        }
        (_, Reason::NotHexBytes) => "write exactly two hex digits per byte: `01A105`".into(),
        (_, Reason::NotATime) => "write days and milliseconds, separated by a space".into(),
        (_, Reason::NotOctal) => "remove the leading zeros".into(),
        (Field::Baudrate, Reason::OutOfRange { .. } | Reason::NotANumber) => {
            "write the bit rate in kbit/s: 10, 20, 50, 125, 250, 500, 800 or 1000".into()
        }
        (_, Reason::OutOfRange { .. }) if data_type.is_some() => {
            "write a value that fits, or choose a larger data type".into()
        }
        (_, Reason::OutOfRange { low: 0, high: 1 }) => "write 0 or 1".into(),
        (_, Reason::OutOfRange { low, high }) => say!("write a number from {} to {}", low, high),
        (field, Reason::NotANumber) if data_type.is_none() => match switch_number(&invalid.text) {
            Some(number) => say!("write `{}`", Argument::setting(field, number)),
            None => "write a number in decimal or hex, such as `10` or `0xA`".into(),
        },
        _ => say!("write a valid value, or leave {the key} empty"),
    }
}

/// The number for a word such as `yes` or `no`.
fn switch_number(word: &str) -> Option<u8> {
    let is = |words: [&str; 3]| words.iter().any(|other| other.eq_ignore_ascii_case(word));
    let (yes, no) = (is(["true", "yes", "on"]), is(["false", "no", "off"]));
    (yes || no).then_some(yes.into())
}

fn access_names() -> Argument {
    joined(Access::ALL.map(|access| say!("`{}`", access)), ", ")
}

fn missing_constant(at: &EntryAt<'_>, findings: &mut Findings) {
    let entry = at.entry;
    if entry.access != Some(Access::Const) || entry.value().is_some() || !at.holds_value() {
        return;
    }
    let varies = matches!(at.index, 0x1000 | 0x1008..=0x100A | 0x1018);
    let count = at.sub == Some(0) && at.object.object_type().has_subs();
    let values =
        at.sub.is_none() && at.object.compact.as_ref().is_some_and(|compact| !compact.values.is_empty());
    let domain = at.object_type() == Some(ObjectType::Domain)
        || entry.data_type.is_none_or(|data_type| data_type.kind() == TypeKind::Domain);
    if varies || count || values || domain || !entry.invalid_values.is_empty() {
        return;
    }
    let finding = MISSING_CONSTANT
        .at(at.field(Field::DefaultValue), "the constant has no value")
        .label(at.field(Field::AccessType), "a constant");
    findings.push(
        finding
            .help(say!("write `{DefaultValue}`, or `{AccessType=ro}` if the value differs between devices")),
    );
}

fn write_only_default(device: &Device, at: &EntryAt<'_>, findings: &mut Findings) {
    if at.entry.access != Some(Access::Wo) || !at.holds_value() || at.entry.is_mappable() {
        return;
    }
    let Some(default) = at.entry.default.as_ref().filter(|value| !is_zero_or_empty(value)) else { return };
    // CiA 402 defines settings that cannot be read; the other entries of documents that are `wo` are commands
    let facts = facts_of(device, at).filter(|facts| facts.access.contains(&Access::Wo));
    if facts.is_some_and(|facts| is_choice(&facts) || facts.name == "Size of data record") {
        return;
    }
    let message = match default {
        Value::Text(text) => say!("`{DefaultValue}` is `{}`, but the entry is write-only", text),
        value => say!("`{DefaultValue}` is {:h}, but the entry is write-only", value),
    };
    let finding = WRITE_ONLY_DEFAULT.at(at.field(Field::DefaultValue), message);
    let finding = finding.label(at.field(Field::AccessType), "write only");
    findings.push(finding.help(say!("remove the value, or correct `{AccessType}`")));
}

/// Whether a document defines the meanings of an entry's values.
fn is_choice(facts: &EntryFacts<'_>) -> bool {
    facts.bits().any(|bits| bits.meanings().len() > 0)
}

fn is_zero_or_empty(value: &Value) -> bool {
    match value {
        Value::Text(text) | Value::Raw(text) => text.is_empty(),
        Value::Bytes(bytes) => bytes.iter().all(|&byte| byte == 0),
        _ => value.as_real() == Some(0.0),
    }
}

fn fixed_by_limits(device: &Device, at: &EntryAt<'_>, findings: &mut Findings) {
    let (Some(low), Some(high)) = (&at.entry.low_limit, &at.entry.high_limit) else { return };
    let is_number = at.entry.data_type.is_some_and(DataType::is_numeric);
    let is_writable = at.entry.access.is_some_and(Access::is_writable);
    // a command such as `save` accepts one value
    if !is_number || !is_writable || !at.holds_value() || at.entry.flags().refuses_write() {
        return;
    }
    let [node_id, _] = stated::node_ids(device);
    if stated::compare(low, high, node_id) != Some(Ordering::Equal) || at.index < 0x2000 {
        return;
    }
    // a device may support only one of the choices that its profile defines
    if at.entry.default.as_ref() == Some(low) && facts_of(device, at).as_ref().is_some_and(is_choice) {
        return;
    }
    let message = say!("the entry is writable, but its limits allow only {:h}", low);
    let finding = FIXED_BY_LIMITS.at(at.field(Field::HighLimit), message);
    let finding = finding.label(at.field(Field::LowLimit), "the other limit");
    findings.push(finding.help("correct the limits, or remove them"));
}

fn limits_on_text(at: &EntryAt<'_>, findings: &mut Findings) {
    let entry = at.entry;
    let field = match (&entry.low_limit, &entry.high_limit) {
        (Some(_), _) => Field::LowLimit,
        (None, Some(_)) => Field::HighLimit,
        (None, None) => return,
    };
    let Some(data_type) = entry.data_type else { return };
    let is_text = matches!(
        data_type.kind(),
        TypeKind::VisibleString | TypeKind::UnicodeString | TypeKind::OctetString | TypeKind::Domain
    );
    // another rule reports these keys for DOMAIN objects, which do not support them
    if is_text && at.holds_value() && at.object_type() != Some(ObjectType::Domain) {
        let message = say!("`{}` has no meaning for a {}", field, data_type);
        let finding =
            LIMITS_ON_TEXT.at(at.field(field), message).label(at.field(Field::DataType), "not a number");
        let stated =
            [(Field::LowLimit, entry.low_limit.is_some()), (Field::HighLimit, entry.high_limit.is_some())];
        let stated = stated.into_iter().filter(|(_, stated)| *stated);
        let fix = stated.fold(Fix::risky("remove the limits"), |fix, (field, _)| fix.remove(at.field(field)));
        findings.push(finding.help("remove the limits").fix(fix));
    }
}

fn low_limit_above_high(device: &Device, at: &EntryAt<'_>, findings: &mut Findings) {
    let (Some(low), Some(high)) = (&at.entry.low_limit, &at.entry.high_limit) else { return };
    let above = stated::first_node(low, high, Ordering::Greater, stated::node_ids(device)).is_some();
    if !above || !at.holds_value() {
        return;
    }
    let message = say!("`{LowLimit}` is {}, but `{HighLimit}` is {}", low, high);
    let finding = LOW_LIMIT_ABOVE_HIGH
        .at(at.field(Field::LowLimit), message)
        .label(at.field(Field::HighLimit), "the high limit");
    let is_formula = [low, high].into_iter().any(|limit| matches!(limit, Value::NodeId(_)));
    let fix = Fix::risky("swap the limits")
        .set(at.field(Field::LowLimit), high.to_string())
        .set(at.field(Field::HighLimit), low.to_string());
    if let Some((number, bits)) = negative_limit(low, high) {
        let is_signed =
            at.entry.data_type.is_some_and(|data_type| matches!(data_type.kind(), TypeKind::Signed(_)));
        findings.push(match is_signed {
            true => {
                let title = say!("write `{}`, or the hex number with all digits of the type", number);
                let fix = Fix::risky(title.clone()).set(at.field(Field::LowLimit), number.to_string());
                finding.help(title).fix(fix)
            }
            false => finding.help(say!(
                "choose a signed data type if `{LowLimit}` means {} in {} bits, or correct one of the limits",
                number,
                bits
            )),
        });
        return;
    }
    let finding = finding.help("swap the limits, or correct one of them");
    // the larger one depends on the node-ID
    findings.push(if is_formula { finding } else { finding.fix(fix) });
}

/// The low limit as a negative number of 8, 16 or 32 bits that is below the high one, and its bits: `0xEC78`, with `0x1388` as
/// the high limit. Then the data type or the number of digits is wrong, not the order.
fn negative_limit(low: &Value, high: &Value) -> Option<(i128, u8)> {
    let (low, high) = (low.as_integer()?, high.as_integer()?);
    let negative = |bits: u8| (low - (1_i128 << bits), bits);
    [8, 16, 32].into_iter().filter(|bits| low >> (bits - 1) == 1).map(negative).find(|(low, _)| *low <= high)
}

fn single_limit(at: &EntryAt<'_>, findings: &mut Findings) {
    let entry = at.entry;
    let (stated, missing) = match (&entry.low_limit, &entry.high_limit) {
        (Some(_), None) => (Field::LowLimit, Field::HighLimit),
        (None, Some(_)) => (Field::HighLimit, Field::LowLimit),
        _ => return,
    };
    let is_number = entry.data_type.is_some_and(DataType::is_numeric);
    let is_domain = at.object_type() == Some(ObjectType::Domain);
    if !is_number || is_domain || !at.holds_value() || stated::is_invalid(entry, &missing) {
        return;
    }
    let message = say!("`{}` is set without `{}`", stated, missing);
    findings.push(SINGLE_LIMIT.at(at.field(stated), message).help(say!("add `{}`", missing)));
}

fn value_outside_limits(device: &Device, at: &EntryAt<'_>, findings: &mut Findings) {
    let entry = at.entry;
    let node_ids = stated::node_ids(device);
    if entry.low_limit.is_none() && entry.high_limit.is_none() || is_reported_elsewhere(at, node_ids) {
        return;
    }
    if let Some(value) = &entry.default
        && let Some(exceeded) = exceeded_limit(entry, value, node_ids)
    {
        report_exceeded(
            at,
            at.field(Field::DefaultValue),
            &say!("`{DefaultValue}`"),
            value,
            exceeded,
            findings,
        );
    }
    if let Some(value) = entry.configured_value()
        && let Some(exceeded) = exceeded_limit(entry, value, node_ids)
    {
        report_exceeded(
            at,
            at.field(Field::ParameterValue),
            &say!("`{ParameterValue}`"),
            value,
            exceeded,
            findings,
        );
    }
    let compact = at.object.compact.as_ref().filter(|_| at.sub.is_none());
    for (sub, value) in compact.iter().flat_map(|compact| &compact.values) {
        if let Some(exceeded) = exceeded_limit(entry, value, node_ids) {
            let place = Place::of(Part::CompactValues(at.index)).field(Field::Item(u32::from(*sub)));
            let what = say!("the value of sub-index {}", sub_index(*sub));
            report_exceeded(at, place, &what, value, exceeded, findings);
        }
    }
}

/// A limit that a value exceeds, and the corresponding node-ID.
struct ExceededLimit<'a> {
    field: Field,
    limit: &'a Value,
    node_id: u8,
}

/// The limit that a value exceeds.
fn exceeded_limit<'a>(entry: &'a Entry, value: &Value, node_ids: [u8; 2]) -> Option<ExceededLimit<'a>> {
    let beyond = |limit: &Option<Value>, order| stated::first_node(value, limit.as_ref()?, order, node_ids);
    let below = beyond(&entry.low_limit, Ordering::Less);
    let above = || beyond(&entry.high_limit, Ordering::Greater);
    let (field, limit, node_id) = match below {
        Some(node_id) => (Field::LowLimit, entry.low_limit.as_ref()?, node_id),
        None => (Field::HighLimit, entry.high_limit.as_ref()?, above()?),
    };
    Some(ExceededLimit { field, limit, node_id })
}

/// Whether another rule reports the cause (contradictory limits, invalid value), or the limits belong to
/// a signature.
fn is_reported_elsewhere(at: &EntryAt<'_>, node_ids: [u8; 2]) -> bool {
    let contradictory = match (&at.entry.low_limit, &at.entry.high_limit) {
        (Some(low), Some(high)) => stated::first_node(low, high, Ordering::Greater, node_ids).is_some(),
        _ => false,
    };
    contradictory || !at.holds_value() || matches!(at.index, 0x1010 | 0x1011)
}

fn report_exceeded(
    at: &EntryAt<'_>,
    place: Place,
    what: &Text,
    value: &Value,
    exceeded: ExceededLimit<'_>,
    findings: &mut Findings,
) {
    let ExceededLimit { field, limit, node_id } = exceeded;
    // the value of a formula for that node-ID
    let number = |value: &Value| match (value, value.integer_for(node_id)) {
        (Value::NodeId(_), Some(number)) => say!("{} on node {}", number, node_id),
        _ => say!("{:h}", value),
    };
    let message = say!("{} is {}, but `{}` is {}", what, number(value), field, number(limit));
    let finding = VALUE_OUTSIDE_LIMITS.at(place, message).label(at.field(field), "the limit");
    findings.push(finding.help("correct the value or the limit"));
}

/// The definition of an entry in a document for all devices or in its device's profile; `None` if the object has a different
/// structure there.
fn facts_of(device: &Device, at: &EntryAt<'_>) -> Option<EntryFacts<'static>> {
    let documents = profile::for_all(device).chain(profile::of_device(device));
    let object = documents.into_iter().find_map(|profile| {
        let blocks = if profile.repeats { MAX_BLOCKS } else { 1 };
        (0..blocks).find_map(|block| profile.object_in(block, at.index))
    })?;
    let is_alike =
        !object.states_type() || at.object.object_type().has_subs() == object.object_type().has_subs();
    let shared = u8::from(at.object.compact.is_some());
    object.entry(at.sub.unwrap_or(shared)).filter(|_| is_alike)
}
