//! The transmission types and timers of PDOs.

use crate::diagnostic::{Findings, Fix, say};
use crate::model::{CobId, PdoKind};
use crate::rule::rules;
use crate::{Facts, PdoFacts};

rules! {
    "cia301/inhibit-above-event-timer" = INHIBIT_ABOVE_EVENT_TIMER, Warning, Pdo(inhibit_above_event_timer);
    summary: "the inhibit time of a TPDO is longer than its event timer",
    checks: "Whether the inhibit time of each event-driven TPDO (types 254 and 255), in units of 100 µs, is not longer than its event timer, in milliseconds. A value of 0 disables the timer.",
    why: "The event timer expires before the inhibit time allows a transmission. Often the inhibit time was written in milliseconds.",
    example: "`[1800sub3]` with `DefaultValue=5000` (500 ms) and `[1800sub5]` with `DefaultValue=100`",
    remedy: "Shorten the inhibit time, or extend the event timer.",
    source: "CiA 301 §7.5.2.37",

    "cia301/reserved-transmission-type" = RESERVED_TRANSMISSION_TYPE, Error, Pdo(reserved_transmission_type);
    summary: "a PDO has a reserved transmission type",
    checks: "Whether the transmission type of an RPDO is outside 241 to 253, and that of a TPDO outside 241 to 251.",
    why: "A device rejects the value. 252 and 253 mean transmission on request, which does not apply to an RPDO.",
    example: "`[1400sub2]` with `DefaultValue=253`",
    remedy: "Write 255 or 254 for event-driven, 1 to 240 for every n-th SYNC, 0 for acyclic with SYNC.",
    source: "CiA 301 §7.5.2.35 table 68, §7.5.2.37 table 72",

    "cia301/rtr-only-pdo" = RTR_ONLY_PDO, Note, Pdo(rtr_only_pdo);
    summary: "a TPDO is sent only on request",
    checks: "Whether a valid TPDO has transmission type 252 or 253, with which it waits for a remote frame. A TPDO that also forbids remote frames has its own rule.",
    why: "CiA advises against remote frames: controllers of different vendors answer them differently or not at all, and CAN FD has none.",
    example: "`[1800sub2]` with `DefaultValue=253`",
    remedy: "Use 254 or 255 with an event timer, or a synchronous type.",
    source: "CiA 301 §7.5.2.37, table 72; CiA 801",

    "cia301/rtr-pdo-without-rtr" = RTR_PDO_WITHOUT_RTR, Warning, Pdo(rtr_pdo_without_rtr), fix Unsafe;
    summary: "a TPDO is sent only on request but forbids remote frames",
    checks: "Whether the COB-ID of each TPDO with transmission type 252 or 253 has bit 30 clear.",
    why: "Bit 30 forbids remote frames for the PDO, but these transmission types send it only on a remote frame: the PDO is never sent.",
    example: "`[1800sub1]` with `DefaultValue=$NODEID+0x40000180` and `[1800sub2]` with `DefaultValue=253`",
    remedy: "Use an event-driven or a synchronous type; CiA advises against remote frames.",
    source: "CiA 301 §7.5.2.37 tables 70 and 72",

    "cia301/timer-without-effect" = TIMER_WITHOUT_EFFECT, Note, Pdo(timer_without_effect);
    summary: "a PDO has a timer without effect",
    checks: "Whether the inhibit time and the event timer of each synchronous TPDO (types 0 to 240) and the inhibit time of each RPDO are 0. SYNC alone triggers a synchronous TPDO, and reception cannot be inhibited.",
    why: "The author expects the timer to work. Often the transmission type is wrong.",
    example: "`[1800sub2]` with `DefaultValue=1` and `[1800sub5]` with `DefaultValue=100`",
    remedy: "Write 0, or use transmission type 254 or 255.",
    source: "CiA 301 §7.5.2.35, §7.5.2.37",
}

fn inhibit_above_event_timer(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
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
    let finding = INHIBIT_ABOVE_EVENT_TIMER
        .at(facts.device.value_place(index, 3), message)
        .label(facts.device.value_place(index, 5), "the event timer");
    findings
        .push(finding.help("shorten the inhibit time (unit 100 µs), or extend the event timer (unit 1 ms)"));
}

fn reserved_transmission_type(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let pdo = &pdo.pdo;
    let highest = match pdo.kind {
        PdoKind::Rpdo => 253,
        PdoKind::Tpdo => 251,
    };
    let reserved =
        pdo.transmission_type.filter(|transmission_type| (241..=highest).contains(transmission_type));
    if let Some(transmission_type) = reserved {
        let message = say!("transmission type `{}` of {} is reserved", transmission_type, pdo);
        let place = facts.device.value_place(pdo.communication_index(), 2);
        let finding = RESERVED_TRANSMISSION_TYPE.at(place, message);
        findings.push(finding.help("write 254 or 255 for event-driven, 0 to 240 for synchronous"));
    }
}

fn rtr_only_pdo(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let pdo = &pdo.pdo;
    let Some(transmission_type @ (252 | 253)) = pdo.transmission_type else { return };
    let allows_rtr = pdo.cob_id.is_some_and(|cob_id| cob_id.is_valid() && !cob_id.bit_30());
    if pdo.kind != PdoKind::Tpdo || !allows_rtr {
        return;
    }
    let message = say!(
        "{} has transmission type `{}` and is sent only in response to remote frames",
        pdo,
        transmission_type
    );
    let place = facts.device.value_place(pdo.communication_index(), 2);
    let finding = RTR_ONLY_PDO.at(place, message);
    findings.push(finding.help("use 254 or 255 with an event timer, or a synchronous type"));
}

fn rtr_pdo_without_rtr(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let pdo = &pdo.pdo;
    let on_request = pdo.transmission_type.filter(|transmission_type| matches!(transmission_type, 252 | 253));
    let (Some(transmission_type), Some(cob_id)) = (on_request, pdo.cob_id) else { return };
    if pdo.kind == PdoKind::Tpdo && cob_id.is_valid() && cob_id.bit_30() {
        let index = pdo.communication_index();
        let message = say!(
            "{} is sent only on request (transmission type `{}`), but bit 30 of `{}` forbids remote frames",
            pdo,
            transmission_type,
            cob_id
        );
        let finding = RTR_PDO_WITHOUT_RTR
            .at(facts.device.value_place(index, 2), message)
            .label(facts.device.value_place(index, 1), "bit 30: no RTR allowed");
        let flags = if cob_id.depends_on_node_id() { "$NODEID+" } else { "" };
        let number = cob_id.number() & !CobId::BIT_30;
        let fix = Fix::risky("clear bit 30")
            .set(facts.device.value_place(index, 1), format!("{flags}0x{number:X}"));
        let finding = finding.fix(fix);
        findings.push(finding.help(say!(
            "use another transmission type, or clear bit 30: `{}0x{:X}`",
            flags,
            number
        )));
    }
}

fn timer_without_effect(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
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
            let finding = TIMER_WITHOUT_EFFECT.at(place, message);
            let finding = finding.label(facts.device.value_place(index, 2), reason);
            finding.help("write 0, or use transmission type 254 or 255")
        }
        None => {
            let message = say!("the {} `{}` of {} has no effect", name, time, pdo);
            TIMER_WITHOUT_EFFECT.at(place, message).help("write 0: reception is not inhibited")
        }
    };
    findings.push(finding);
}
