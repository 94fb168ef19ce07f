use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{Facts, rule};

rule! {
    "cia301/sync-window-above-period", Error, Facts(check);
    summary: "the window for synchronous PDOs is longer than the SYNC period",
    checks: "Whether 1007h, the synchronous window length, is at most 1006h, the communication cycle period. Both count in microseconds; 0 means that there is none.",
    why: "Synchronous PDOs have to be sent inside the window that SYNC opens. A window that outlasts the period never closes, and a device refuses it.",
    example: "`[1006]` with `DefaultValue=1000` and `[1007]` with `DefaultValue=5000`",
    remedy: "Shorten the window, or lengthen the period.",
    source: "CiA 301 §7.5.2.6, §7.5.2.7",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let (Some(period), Some(window)) = (facts.number(0x1006, 0), facts.number(0x1007, 0)) else { return };
    if period == 0 || window <= period {
        return;
    }
    let message = say!("the synchronous window is {} µs long, and SYNC comes every {} µs", window, period);
    let finding = Diagnostic::new(&RULE.info, facts.device.value_place(0x1007, 0), message)
        .label(facts.device.value_place(0x1006, 0), "the period of SYNC");
    findings.push(finding.help("shorten the window, or lengthen the period"));
}
