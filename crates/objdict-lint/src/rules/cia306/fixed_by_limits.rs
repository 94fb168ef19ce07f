use std::cmp::Ordering;

use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Access, DataType, Field};
use crate::{EntryAt, rule, stated};

rule! {
    "cia306/fixed-by-limits", Note, Entry(check);
    summary: "the limits of an entry allow only one value",
    checks: "Whether `LowLimit` and `HighLimit` differ in writable entries from 2000h on. Entries that `ObjFlags` excludes from downloads are commands and may have a single value.",
    why: "With only one allowed value, the entry is effectively a constant. Often a limit still has its initial value.",
    example: "`LowLimit=0` and `HighLimit=0` of an entry with `AccessType=rw`",
    remedy: "Correct the limits, or remove them.",
    source: "CiA 306-1 §4.6.3.2",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
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
    let finding = Diagnostic::new(&RULE.info, at.field(Field::HighLimit), message);
    let finding = finding.label(at.field(Field::LowLimit), "the other limit");
    findings.push(finding.help("correct the limits, or remove them"));
}
