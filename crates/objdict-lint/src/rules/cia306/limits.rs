//! The limits of values.

use std::cmp::Ordering;

use crate::diagnostic::{Findings, Fix, Text, say, sub_index};
use crate::model::{Access, DataType, Entry, Field, ObjectType, Part, Place, TypeKind, Value};
use crate::rule::rules;
use crate::{EntryAt, stated};

rules! {
    source: "CiA 306-1 §4.6.3.2";

    "cia306/fixed-by-limits" = FIXED_BY_LIMITS, Note, Entry(fixed_by_limits);
    summary: "the limits of an entry allow only one value",
    checks: "Whether `LowLimit` and `HighLimit` differ in writable entries from 2000h on. Entries that `ObjFlags` excludes from downloads are commands and may have a single value.",
    why: "With only one allowed value, the entry is effectively a constant. Often a limit still has its initial value.",
    example: "`LowLimit=0` and `HighLimit=0` of an entry with `AccessType=rw`",
    remedy: "Correct the limits, or remove them.",

    "cia306/limits-on-text" = LIMITS_ON_TEXT, Warning, Entry(limits_on_text), fix Unsafe;
    summary: "a string has limits",
    checks: "Whether `LowLimit` and `HighLimit` are used with numbers only, not with VISIBLE_STRING, UNICODE_STRING, OCTET_STRING or DOMAIN.",
    why: "Strings have no defined order, so limits have no meaning. They may have been meant as lengths, or the data type is wrong.",
    example: "`DataType=0x0009` with `HighLimit=20`",
    remedy: "Remove the limits, or correct the data type.",

    "cia306/low-limit-above-high" = LOW_LIMIT_ABOVE_HIGH, Error, Entry(low_limit_above_high), fix Unsafe;
    summary: "the low limit is above the high limit",
    checks: "Whether `LowLimit` is at most `HighLimit`, both interpreted in the data type. Limits with `$NODEID` are evaluated for node-IDs 1 and 127, or for the node-ID of the DCF.",
    why: "No value is within such limits: tools refuse every value, or skip the check.",
    example: "`LowLimit=10` and `HighLimit=2`",
    remedy: "Swap the two. Write limits of signed types in decimal: `LowLimit=-128`.",

    "cia306/single-limit" = SINGLE_LIMIT, Note, Entry(single_limit);
    summary: "an entry has only one of the two limits",
    checks: "Whether `LowLimit` and `HighLimit` are both given, or neither. A low limit of 0 or above of a signed type, and a high limit of any type, leave the other end open.",
    why: "A single limit is allowed, but tools interpret the missing one differently: 0, the end of the type's range, or no limits at all.",
    example: "`HighLimit=100`, and no `LowLimit`",
    remedy: "Add the other limit.",

    "cia306/value-outside-limits" = VALUE_OUTSIDE_LIMITS, Error, Entry(value_outside_limits);
    summary: "a value is outside its limits",
    checks: "Whether `DefaultValue`, `ParameterValue` and the numbers of `[xxxxValue]` are between `LowLimit` and `HighLimit`. Formulas are evaluated for node-IDs 1 and 127, or for the node-ID of the DCF. 1010h and 1011h are not checked: their limits apply to the signature, not to the value that is read.",
    why: "The device rejects the value; a tool that restores it gets an abort.",
    example: "`DefaultValue=5` and `HighLimit=4`",
    remedy: "Correct the value or the limit.",
    source: "CiA 306-1 §4.6.3.2, §5.3.1",
}

fn fixed_by_limits(at: &EntryAt<'_>, findings: &mut Findings) {
    let (Some(low), Some(high)) = (&at.entry.low_limit, &at.entry.high_limit) else { return };
    let is_number = at.entry.data_type.is_some_and(DataType::is_numeric);
    let is_writable = at.entry.access.is_some_and(Access::is_writable);
    // a command such as `save` takes one value
    if !is_number || !is_writable || !at.holds_value() || at.entry.flags().refuses_write() {
        return;
    }
    let [node_id, _] = stated::node_ids(at.device);
    if stated::compare(low, high, node_id) != Some(Ordering::Equal) || at.index < 0x2000 {
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

fn low_limit_above_high(at: &EntryAt<'_>, findings: &mut Findings) {
    let (Some(low), Some(high)) = (&at.entry.low_limit, &at.entry.high_limit) else { return };
    let above = stated::first_node(low, high, Ordering::Greater, stated::node_ids(at.device)).is_some();
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
    let finding = finding.help("swap the limits, or correct one of them");
    // the larger one depends on the node-ID
    findings.push(if is_formula || is_negative_limit(low, high) { finding } else { finding.fix(fix) });
}

/// Whether the low limit is perhaps a negative number of 16 or 32 bits below the high one: `0xEC78`, with `0x1388` as the
/// high limit. Then the data type is wrong, not the order.
fn is_negative_limit(low: &Value, high: &Value) -> bool {
    let (Some(low), Some(high)) = (low.as_integer(), high.as_integer()) else { return false };
    [16, 32].into_iter().any(|bits| low >> (bits - 1) == 1 && low - (1_i128 << bits) <= high)
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

fn value_outside_limits(at: &EntryAt<'_>, findings: &mut Findings) {
    let entry = at.entry;
    if entry.low_limit.is_none() && entry.high_limit.is_none() {
        return;
    }
    let node_ids = stated::node_ids(at.device);
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

/// A limit that a value exceeds, and the node-ID for which it does.
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

/// Whether another rule reports the cause (contradictory limits, no value), or the limits are those of a
/// signature.
fn is_reported_elsewhere(at: &EntryAt<'_>) -> bool {
    let contradictory = match (&at.entry.low_limit, &at.entry.high_limit) {
        (Some(low), Some(high)) => {
            stated::first_node(low, high, Ordering::Greater, stated::node_ids(at.device)).is_some()
        }
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
    if is_reported_elsewhere(at) {
        return;
    }
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
