use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{Facts, rule};

rule! {
    "cia301/incomplete-life-guarding", Warning, Facts(check);
    summary: "life guarding has only one of its two values",
    checks: "Whether 100Ch, the guard time, and 100Dh, the life time factor, are both 0 or both greater than 0. With a heartbeat time they have no effect and are not checked.",
    why: "The node life time is the product of the two. If one is 0, the node does not monitor its master although the other value suggests it.",
    example: "`[100C]` with `DefaultValue=500` and `[100D]` with `DefaultValue=0`",
    remedy: "Write both values, or 0 to both.",
    source: "CiA 301 §7.5.2.11, §7.5.2.12",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let (Some(time), Some(factor)) = (facts.number(0x100C, 0), facts.number(0x100D, 0)) else { return };
    let has_heartbeat = facts.number(0x1017, 0).is_some_and(|time| time > 0);
    if has_heartbeat || (time == 0) == (factor == 0) {
        return;
    }
    let (set, zero) = if time == 0 { (0x100D, 0x100C) } else { (0x100C, 0x100D) };
    let message =
        say!("the guard time is {} ms and the life time factor is {}, so life guarding is off", time, factor);
    let finding = Diagnostic::new(&RULE.info, facts.device.value_place(zero, 0), message)
        .label(facts.device.value_place(set, 0), "this value is set");
    findings.push(finding.help("set both 100Ch and 100Dh, or write 0 to both"));
}
