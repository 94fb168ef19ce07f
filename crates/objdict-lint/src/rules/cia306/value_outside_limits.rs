use std::cmp::Ordering;

use crate::diagnostic::{Diagnostic, Findings, Text, say, sub_index};
use crate::model::{Entry, Field, Part, Place, Value};
use crate::{EntryAt, rule, stated};

rule! {
    "cia306/value-outside-limits", Error, Entry(check);
    summary: "a value is outside its limits",
    checks: "Whether `DefaultValue`, `ParameterValue` and the numbers of `[xxxxValue]` are between `LowLimit` and `HighLimit`. Formulas are evaluated for node-IDs 1 and 127, or for the node-ID of the DCF. 1010h and 1011h are not checked: their limits apply to the signature, not to the value that is read.",
    why: "The device rejects the value; a tool that restores it gets an abort.",
    example: "`DefaultValue=5` and `HighLimit=4`",
    remedy: "Correct the value or the limit.",
    source: "CiA 306-1 §4.6.3.2, §5.3.1",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    let entry = at.entry;
    if entry.low_limit.is_none() && entry.high_limit.is_none() {
        return;
    }
    let node_ids = stated::node_ids(at.device);
    if let Some(value) = &entry.default
        && let Some(exceeded) = exceeded(entry, value, node_ids)
    {
        report(at, at.field(Field::DefaultValue), &say!("`{DefaultValue}`"), value, exceeded, findings);
    }
    if let Some(value) = entry.configured_value()
        && let Some(exceeded) = exceeded(entry, value, node_ids)
    {
        report(at, at.field(Field::ParameterValue), &say!("`{ParameterValue}`"), value, exceeded, findings);
    }
    let compact = at.object.compact.as_ref().filter(|_| at.sub.is_none());
    for (sub, value) in compact.iter().flat_map(|compact| &compact.values) {
        if let Some(exceeded) = exceeded(entry, value, node_ids) {
            let place = Place::of(Part::CompactValues(at.index)).field(Field::Item(u32::from(*sub)));
            let what = say!("the value of sub-index {}", sub_index(*sub));
            report(at, place, &what, value, exceeded, findings);
        }
    }
}

/// A limit that a value exceeds, and the node-ID for which it does.
struct Exceeded<'a> {
    field: Field,
    limit: &'a Value,
    node_id: u8,
}

/// The limit that a value exceeds.
fn exceeded<'a>(entry: &'a Entry, value: &Value, node_ids: [u8; 2]) -> Option<Exceeded<'a>> {
    let beyond = |limit: &Option<Value>, order| stated::first_node(value, limit.as_ref()?, order, node_ids);
    let below = beyond(&entry.low_limit, Ordering::Less);
    let above = || beyond(&entry.high_limit, Ordering::Greater);
    let (field, limit, node_id) = match below {
        Some(node_id) => (Field::LowLimit, entry.low_limit.as_ref()?, node_id),
        None => (Field::HighLimit, entry.high_limit.as_ref()?, above()?),
    };
    Some(Exceeded { field, limit, node_id })
}

/// Whether another rule reports the cause (contradictory limits, no value), or the limits are those of a
/// signature.
fn is_explained(at: &EntryAt<'_>) -> bool {
    let contradictory = match (&at.entry.low_limit, &at.entry.high_limit) {
        (Some(low), Some(high)) => {
            stated::first_node(low, high, Ordering::Greater, stated::node_ids(at.device)).is_some()
        }
        _ => false,
    };
    contradictory || !at.holds_value() || matches!(at.index, 0x1010 | 0x1011)
}

fn report(
    at: &EntryAt<'_>,
    place: Place,
    what: &Text,
    value: &Value,
    exceeded: Exceeded<'_>,
    findings: &mut Findings,
) {
    if is_explained(at) {
        return;
    }
    let Exceeded { field, limit, node_id } = exceeded;
    // the value of a formula for that node-ID
    let number = |value: &Value| match (value, value.integer_for(node_id)) {
        (Value::NodeId(_), Some(number)) => say!("{} on node {}", number, node_id),
        _ => say!("{:h}", value),
    };
    let message = say!("{} is {}, but `{}` is {}", what, number(value), field, number(limit));
    let finding = Diagnostic::new(&RULE.info, place, message).label(at.field(field), "the limit");
    findings.push(finding.help("correct the value or the limit"));
}
