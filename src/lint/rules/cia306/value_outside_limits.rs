use std::cmp::Ordering;

use crate::diagnostic::{Diagnostic, Findings};
use crate::lint::{EntryAt, rule, stated};
use crate::model::{Entry, Field, Part, Place, Value};

rule! {
    /// a value lies outside its limits
    ///
    /// ## What it checks
    /// Whether `DefaultValue`, `ParameterValue` and the numbers of `[xxxxValue]` are between `LowLimit` and `HighLimit`. Formulas are tried with the node-IDs 1 and 127, or with that of the DCF. 1010h and 1011h are left alone: their limits are those of the signature that is written, and what is read is something else.
    ///
    /// ## Why it matters
    /// The device refuses the value when it is written; a tool that restores it gets an abort.
    ///
    /// ## Example
    /// `DefaultValue=5` and `HighLimit=4`
    ///
    /// ## How to mend
    /// Correct the value or the limit.
    ///
    /// ## Source
    /// CiA 306-1 §4.6.3.2, §5.3.1
    "cia306/value-outside-limits", Error, Entry(check)
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    let entry = at.entry;
    if entry.low_limit.is_none() && entry.high_limit.is_none() {
        return;
    }
    let node_ids = stated::node_ids(at.device);
    let signature = matches!(at.index, 0x1010 | 0x1011);
    if signature || !at.holds_value() || contradictory(entry, node_ids) {
        return;
    }
    let values =
        [(Field::DefaultValue, &entry.default.as_ref()), (Field::ParameterValue, &entry.configured_value())];
    for (field, value) in values {
        let Some(value) = value else { continue };
        if let Some(exceeded) = exceeded(entry, value, node_ids) {
            let what = format!("`{field}`");
            report(at, at.field(field), &what, value, exceeded, findings);
        }
    }
    let compact = at.object.compact.as_ref().filter(|_| at.sub.is_none());
    for (sub, value) in compact.iter().flat_map(|compact| &compact.values) {
        if let Some(exceeded) = exceeded(entry, value, node_ids) {
            let place = Place::of(Part::CompactValues(at.index)).field(Field::Item(u32::from(*sub)));
            report(at, place, &format!("the value of sub-index {sub}"), value, exceeded, findings);
        }
    }
}

/// Whether no value is within the limits, which is a finding of its own.
fn contradictory(entry: &Entry, node_ids: [u8; 2]) -> bool {
    let (Some(low), Some(high)) = (&entry.low_limit, &entry.high_limit) else { return false };
    node_ids.iter().any(|&node_id| stated::compare(low, high, node_id) == Some(Ordering::Greater))
}

/// A limit that a value is beyond, and on which node.
struct Exceeded<'a> {
    field: Field,
    limit: &'a Value,
    node_id: u8,
}

/// The limit that a value is beyond.
fn exceeded<'a>(entry: &'a Entry, value: &Value, node_ids: [u8; 2]) -> Option<Exceeded<'a>> {
    let beyond = |field: Field, limit: Option<&'a Value>, order| {
        let limit = limit?;
        let node_id =
            node_ids.into_iter().find(|&node_id| stated::compare(value, limit, node_id) == Some(order))?;
        Some(Exceeded { field, limit, node_id })
    };
    beyond(Field::LowLimit, entry.low_limit.as_ref(), Ordering::Less)
        .or_else(|| beyond(Field::HighLimit, entry.high_limit.as_ref(), Ordering::Greater))
}

fn report(
    at: &EntryAt<'_>,
    place: Place,
    what: &str,
    value: &Value,
    exceeded: Exceeded<'_>,
    findings: &mut Findings,
) {
    let Exceeded { field, limit, node_id } = exceeded;
    // what a formula is on that node
    let number = |value: &Value| match (value, value.integer_for(node_id)) {
        (Value::NodeId(_), Some(number)) => format!("{number} on node {node_id}"),
        _ => value.to_string(),
    };
    let message = format!("{what} is {}, but `{field}` is {}", number(value), number(limit));
    let finding = Diagnostic::new(&RULE.info, place, message).label(at.field(field), "the limit");
    findings.push(finding.help("correct the value or the limit"));
}
