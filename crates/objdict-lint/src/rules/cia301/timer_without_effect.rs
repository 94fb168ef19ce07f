use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::PdoKind;
use crate::{Facts, PdoFacts, rule};

rule! {
    "cia301/timer-without-effect", Note, Pdo(check);
    summary: "a PDO has a timer without effect",
    checks: "Whether the inhibit time and the event timer of each synchronous TPDO (types 0 to 240) and the inhibit time of each RPDO are 0. SYNC alone triggers a synchronous TPDO, and reception cannot be inhibited.",
    why: "The author expects the timer to work. Often the transmission type is wrong.",
    example: "`[1800sub2]` with `DefaultValue=1` and `[1800sub5]` with `DefaultValue=100`",
    remedy: "Write 0, or use transmission type 254 or 255.",
    source: "CiA 301 §7.5.2.35, §7.5.2.37",
}

fn check(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let pdo = &pdo.pdo;
    let is_cyclic = matches!(pdo.transmission_type, Some(0..=240)) && pdo.kind == PdoKind::Tpdo;
    let index = pdo.communication_index();
    let timers = [
        (3, "inhibit time", pdo.inhibit_time, is_cyclic || pdo.kind == PdoKind::Rpdo),
        (5, "event timer", pdo.event_timer, is_cyclic),
    ];
    let mut idle =
        timers.into_iter().filter(|(_, _, time, is_idle)| *is_idle && time.is_some_and(|time| time > 0));
    let Some((sub, name, Some(time), _)) = idle.next() else { return };
    let place = facts.device.value_place(index, sub);
    let finding = match pdo.transmission_type.filter(|_| is_cyclic) {
        Some(transmission_type) => {
            let message = say!("{} is synchronous, so its {} of `{}` has no effect", pdo, name, time);
            let reason = say!("transmission type {} is synchronous", transmission_type);
            let finding = Diagnostic::new(&RULE.info, place, message);
            let finding = finding.label(facts.device.value_place(index, 2), reason);
            finding.help("write 0, or use transmission type 254 or 255")
        }
        None => {
            let message = say!("the {} `{}` of {} has no effect", name, time, pdo);
            Diagnostic::new(&RULE.info, place, message).help("write 0: reception is not inhibited")
        }
    };
    findings.push(finding);
}
