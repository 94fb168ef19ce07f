use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::DeviceKind;
use crate::{Facts, rule};

/// Milliseconds of a day.
const DAY: i128 = 86_400_000;

rule! {
    "cia301/invalid-configuration-date", Warning, Facts(check);
    summary: "the date of the configuration cannot be",
    checks: "Whether 1020h, verify configuration, holds 0 in an EDS, and in a DCF a time below 86400000 milliseconds of the day, with a date beside it.",
    why: "A manager that finds its own date in 1020h takes the device for configured and writes nothing. A new device with a date, or an impossible time, is never configured, or at every start.",
    example: "`[1020sub2]` with `ParameterValue=90000000`",
    remedy: "Write days since 1984-01-01 into sub-index 1 and milliseconds since midnight into sub-index 2; 0 in an EDS.",
    source: "CiA 301 §7.5.2.23",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let (Some(date), Some(time)) = (facts.number(0x1020, 1), facts.number(0x1020, 2)) else { return };
    let place = |sub| facts.device.value_place(0x1020, sub);
    let is_type = facts.device.kind == DeviceKind::Type;
    let finding = if time >= DAY {
        let message = say!("`{}` ms is later than midnight, {} ms", time, DAY);
        Diagnostic::new(&RULE.info, place(2), message).help("write the milliseconds since midnight")
    } else if is_type && (date, time) != (0, 0) {
        let message = say!("a new device was configured on day `{}`", date);
        Diagnostic::new(&RULE.info, place(if date == 0 { 2 } else { 1 }), message).help("write 0 into both")
    } else if date == 0 && time != 0 {
        let message = "the configuration has a time of day and no date";
        Diagnostic::new(&RULE.info, place(1), message).help("write the days since 1984-01-01")
    } else {
        return;
    };
    findings.push(finding);
}
