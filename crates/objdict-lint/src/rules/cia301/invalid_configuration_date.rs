use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::DeviceKind;
use crate::{Facts, rule};

/// Milliseconds of a day.
const DAY: i128 = 86_400_000;

rule! {
    "cia301/invalid-configuration-date", Warning, Facts(check);
    summary: "the configuration date is impossible",
    checks: "Whether 1020h, verify configuration, is 0 in an EDS, and in a DCF contains a time below 86400000 ms and a date with it.",
    why: "A manager that reads its own date from 1020h assumes that the device is configured and writes nothing. A new device with a date, or one with an impossible time, is never configured or is configured at every start.",
    example: "`[1020sub2]` with `ParameterValue=90000000`",
    remedy: "Write the days since 1984-01-01 to sub-index 1 and the milliseconds since midnight to sub-index 2; 0 to both in an EDS.",
    source: "CiA 301 §7.5.2.23",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let (Some(date), Some(time)) = (facts.number(0x1020, 1), facts.number(0x1020, 2)) else { return };
    let place = |sub| facts.device.value_place(0x1020, sub);
    let is_type = facts.device.kind == DeviceKind::Type;
    let finding = if is_type && (date, time) != (0, 0) {
        let message = say!(
            "the default configuration date is day {} at {} ms, but a new device is not configured",
            date,
            time
        );
        Diagnostic::new(&RULE.info, place(if date == 0 { 2 } else { 1 }), message)
            .help("write 0 to sub-indexes 1 and 2")
    } else if time >= DAY {
        let message = say!("{} ms since midnight is more than a day ({} ms)", time, DAY);
        Diagnostic::new(&RULE.info, place(2), message).help("write the milliseconds since midnight")
    } else if date == 0 && time != 0 {
        let message = "the configuration time is set without a date";
        Diagnostic::new(&RULE.info, place(1), message).help("write the days since 1984-01-01")
    } else {
        return;
    };
    findings.push(finding);
}
