use crate::diagnostic::{Diagnostic, Findings};
use crate::{Facts, rule};

rule! {
    "cia301/heartbeat-beside-guarding", Warning, Facts(check);
    summary: "heartbeat and life guarding are both enabled",
    checks: "Whether 1017h, the heartbeat time, is 0 if 100Ch, the guard time, and 100Dh, the life time factor, are not.",
    why: "A node supports only one of them at a time. With a heartbeat time it sends heartbeats and does not answer guarding requests, so life guarding reports a lost master.",
    example: "`[1017]` with `DefaultValue=1000`, `[100C]` with `DefaultValue=500` and `[100D]` with `DefaultValue=3`",
    remedy: "Write 0 to 100Ch and 100Dh.",
    source: "CiA 301 §7.2.8.2, §7.5.2.20",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let is_on = |index| facts.number(index, 0).is_some_and(|number| number > 0);
    if !is_on(0x1017) || !is_on(0x100C) || !is_on(0x100D) {
        return;
    }
    let place = |index| facts.device.value_place(index, 0);
    let message = "guard time and heartbeat time are both set, but a node uses only one of them";
    let finding = Diagnostic::new(&RULE.info, place(0x100C), message)
        .label(place(0x1017), "the heartbeat time")
        .label(place(0x100D), "the life time factor");
    findings.push(finding.help("write 0 to 100Ch and 100Dh, or to 1017h"));
}
