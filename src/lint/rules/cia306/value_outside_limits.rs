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

/// The limit that a value is beyond.
fn exceeded<'a>(entry: &'a Entry, value: &Value, node_ids: [u8; 2]) -> Option<(Field, &'a Value)> {
    let beyond = |limit: &Value, order| {
        node_ids.iter().any(|&node_id| stated::compare(value, limit, node_id) == Some(order))
    };
    let low = entry.low_limit.as_ref().filter(|low| beyond(low, Ordering::Less));
    let high = entry.high_limit.as_ref().filter(|high| beyond(high, Ordering::Greater));
    low.map(|low| (Field::LowLimit, low)).or(high.map(|high| (Field::HighLimit, high)))
}

fn report(
    at: &EntryAt<'_>,
    place: Place,
    what: &str,
    value: &Value,
    (limit_field, limit): (Field, &Value),
    findings: &mut Findings,
) {
    let message = format!("{what} is {value}, but `{limit_field}` is {limit}");
    let finding = Diagnostic::new(&RULE.info, place, message).label(at.field(limit_field), "the limit");
    findings.push(finding.help("correct the value or the limit"));
}
