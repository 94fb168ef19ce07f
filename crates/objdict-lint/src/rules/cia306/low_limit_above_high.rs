use std::cmp::Ordering;

use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::model::{Field, Value};
use crate::{EntryAt, rule, stated};

rule! {
    "cia306/low-limit-above-high", Error, Entry(check), fix Unsafe;
    summary: "the low limit is above the high limit",
    checks: "Whether `LowLimit` is at most `HighLimit`, both interpreted in the data type. Limits with `$NODEID` are evaluated for node-IDs 1 and 127, or for the node-ID of the DCF.",
    why: "No value is within such limits: tools refuse every value, or skip the check.",
    example: "`LowLimit=10` and `HighLimit=2`",
    remedy: "Swap the two. Write limits of signed types in decimal: `LowLimit=-128`.",
    source: "CiA 306-1 §4.6.3.2",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    let (Some(low), Some(high)) = (&at.entry.low_limit, &at.entry.high_limit) else { return };
    let above = stated::first_node(low, high, Ordering::Greater, stated::node_ids(at.device)).is_some();
    if !above || !at.holds_value() {
        return;
    }
    let message = say!("`{LowLimit}` is {}, but `{HighLimit}` is {}", low, high);
    let finding = Diagnostic::new(&RULE.info, at.field(Field::LowLimit), message)
        .label(at.field(Field::HighLimit), "the high limit");
    let is_formula = [low, high].into_iter().any(|limit| matches!(limit, Value::NodeId(_)));
    let fix = Fix::risky("swap the limits")
        .set(at.field(Field::LowLimit), high.to_string())
        .set(at.field(Field::HighLimit), low.to_string());
    let finding = finding.help("swap the limits, or correct one of them");
    // the larger one depends on the node-ID
    findings.push(if is_formula || is_negative(low, high) { finding } else { finding.fix(fix) });
}

/// Whether the low limit is perhaps a negative number of 16 or 32 bits below the high one: `0xEC78`, with `0x1388` as the
/// high limit. Then the data type is wrong, not the order.
fn is_negative(low: &Value, high: &Value) -> bool {
    let (Some(low), Some(high)) = (low.as_integer(), high.as_integer()) else { return false };
    [16, 32].into_iter().any(|bits| low >> (bits - 1) == 1 && low - (1_i128 << bits) <= high)
}
