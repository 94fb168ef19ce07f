use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::PdoKind;
use crate::{Facts, PdoFacts, rule};

rule! {
    "cia301/inhibit-above-event-timer", Warning, Pdo(check);
    summary: "the inhibit time of a TPDO is longer than its event timer",
    checks: "Whether the inhibit time of each event-driven TPDO (types 254 and 255), in units of 100 µs, is not longer than its event timer, in milliseconds. A value of 0 disables the timer.",
    why: "The event timer expires before the inhibit time allows a transmission. Often the inhibit time was written in milliseconds.",
    example: "`[1800sub3]` with `DefaultValue=5000` (500 ms) and `[1800sub5]` with `DefaultValue=100`",
    remedy: "Shorten the inhibit time, or extend the event timer.",
    source: "CiA 301 §7.5.2.37",
}

fn check(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let pdo = &pdo.pdo;
    let (Some(inhibit), Some(event)) = (pdo.inhibit_time, pdo.event_timer) else { return };
    let is_longer = u32::from(inhibit) > u32::from(event) * 10;
    if pdo.kind == PdoKind::Rpdo || !pdo.is_event_driven() || event == 0 || !is_longer {
        return;
    }
    let index = pdo.communication_index();
    let (whole, tenth) = (inhibit / 10, inhibit % 10);
    let message = say!(
        "the inhibit time of {} is {}.{} ms (`{}`), longer than its event timer of {} ms",
        pdo,
        whole,
        tenth,
        inhibit,
        event
    );
    let finding = Diagnostic::new(&RULE.info, facts.device.value_place(index, 3), message)
        .label(facts.device.value_place(index, 5), "the event timer");
    findings
        .push(finding.help("shorten the inhibit time (unit 100 µs), or extend the event timer (unit 1 ms)"));
}
