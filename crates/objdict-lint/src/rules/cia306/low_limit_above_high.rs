use std::cmp::Ordering;

use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::model::{Field, Value};
use crate::{EntryAt, rule, stated};

rule! {
    "cia306/low-limit-above-high", Error, Entry(check), fix Unsafe;
    summary: "the low limit is above the high limit",
    checks: "Whether `LowLimit` is at most `HighLimit`, both read as the data type says. Limits with `$NODEID` are tried with the node-IDs 1 and 127, or with that of the DCF.",
    why: "No value is within such limits: tools refuse every one, or stop checking.",
    example: "`LowLimit=10` and `HighLimit=2`",
    remedy: "Exchange the two. Limits of a signed type are written in decimal: `LowLimit=-128`.",
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
    let fix = Fix::risky("exchange the two")
        .set(at.field(Field::LowLimit), high.to_string())
        .set(at.field(Field::HighLimit), low.to_string());
    let finding = finding.help("exchange the two, or correct the one that is wrong");
    // which one is larger depends on the node
    findings.push(if is_formula { finding } else { finding.fix(fix) });
}
