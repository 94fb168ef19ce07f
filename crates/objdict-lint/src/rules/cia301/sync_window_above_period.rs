use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{Facts, rule};

rule! {
    "cia301/sync-window-above-period", Error, Facts(check);
    summary: "the synchronous window is longer than the SYNC period",
    checks: "Whether 1007h, the synchronous window length, is at most 1006h, the communication cycle period. Both are in microseconds; 0 disables them.",
    why: "Synchronous PDOs are sent within the window after SYNC. A window longer than the period never ends, and a device rejects it.",
    example: "`[1006]` with `DefaultValue=1000` and `[1007]` with `DefaultValue=5000`",
    remedy: "Shorten the window, or extend the period.",
    source: "CiA 301 §7.5.2.6, §7.5.2.7",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let (Some(period), Some(window)) = (facts.number(0x1006, 0), facts.number(0x1007, 0)) else { return };
    if period == 0 || window <= period {
        return;
    }
    let message =
        say!("the synchronous window of {} µs is longer than the SYNC period of {} µs", window, period);
    let finding = Diagnostic::new(&RULE.info, facts.device.value_place(0x1007, 0), message)
        .label(facts.device.value_place(0x1006, 0), "the SYNC period");
    findings.push(finding.help("shorten the window, or extend the period"));
}
