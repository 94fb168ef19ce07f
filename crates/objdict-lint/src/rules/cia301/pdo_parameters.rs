//! The communication parameters of PDOs, their transmission types and timers.

use crate::diagnostic::{Findings, Fix, Severity, say};
use crate::model::{CobId, DataType, DeviceKind, Field, Part, PdoKind, Place};
use crate::rule::rules;
use crate::{Facts, PdoFacts, is_unstated, stated};

rules! {
    source: "CiA 301 §7.5.2.35, §7.5.2.37";

    "cia301/incomplete-pdo-parameter" = INCOMPLETE_PDO_PARAMETER, Error, Pdo(incomplete_pdo_parameter);
    summary: "a PDO communication parameter lacks the COB-ID or the transmission type",
    checks: "Each object from 1400h to 15FFh and from 1800h to 19FFh must have sub-indexes 1 and 2.",
    why: "A manager cannot configure the PDO, and a tool cannot show when it is sent.",
    example: "`[1801]` with only `[1801sub0]` and `[1801sub1]`",
    remedy: "Describe the missing sub-index.",

    "cia301/inhibit-above-event-timer" = INHIBIT_ABOVE_EVENT_TIMER, Warning, Pdo(inhibit_above_event_timer);
    summary: "the inhibit time of a TPDO is longer than its event timer",
    checks: "For each event-driven TPDO (types 254 and 255), the inhibit time in units of 100 µs must not be longer than the event timer in milliseconds. A value of 0 disables the timer.",
    why: "The event timer expires before the inhibit time allows a transmission. Often the inhibit time was written in milliseconds.",
    example: "`[1800sub3]` with `DefaultValue=5000` (500 ms) and `[1800sub5]` with `DefaultValue=100`",
    remedy: "Shorten the inhibit time, or extend the event timer.",
    source: "CiA 301 §7.5.2.37",

    "cia301/pdo-parameter-without-value" = PDO_PARAMETER_WITHOUT_VALUE, Note,
        Pdo(pdo_parameter_without_value);
    summary: "the COB-ID or transmission type of a PDO has no value",
    checks: "Sub-indexes 1 and 2 of each PDO communication parameter must have a value.",
    why: "The CAN-ID and the trigger of the PDO in a new device are unknown. A tool that restores the defaults omits this entry.",
    example: "`[1800sub2]` without `DefaultValue`",
    remedy: "Write the value that the device has after its defaults are restored.",

    "cia301/pdo-valid-by-default" = PDO_VALID_BY_DEFAULT, Warning, Facts(pdo_valid_by_default);
    summary: "a PDO without a predefined CAN-ID is valid by default",
    checks: "Bit 31 must be set in the default COB-ID of PDO 5 and above. The rule reports one finding per device, which lists every such PDO. A DCF is not checked: it holds the configuration of a node, and tools write the configured value as default.",
    why: "The predefined connection set has no CAN-ID for these PDOs. A PDO that is valid after a reset may use a different device's CAN-ID before a manager can configure it.",
    example: "`[1804sub1]` with `DefaultValue=$NODEID+0x1C0`",
    remedy: "Set bit 31: `$NODEID+0x800001C0`, or `0x80000000`.",
    source: "CiA 301 §7.5.2.35 table 67, §7.5.2.37 table 71",

    "cia301/pdo-without-mapping" = PDO_WITHOUT_MAPPING, Error, Pdo(pdo_without_mapping);
    summary: "a PDO has only one of its two objects",
    checks: "Each PDO communication parameter (1400h to 15FFh, 1800h to 19FFh) must have a mapping parameter 200h above it, and the reverse. A module may provide the other object.",
    why: "Without the mapping, the contents of the PDO are unknown. Without the communication parameter, its CAN-ID and trigger are unknown. `CompactPDO` allows both objects to be omitted, but not only one.",
    example: "`[1802]` without `[1A02]`",
    remedy: "Describe the other object, or remove this one.",
    source: "CiA 301 §7.5.2.35 to §7.5.2.38; CiA 306-1 §4.6.3.4.1",

    "cia301/reserved-pdo-sub-index" = RESERVED_PDO_SUB_INDEX, Warning,
        Facts(reserved_pdo_sub_index), fix Unsafe;
    summary: "a PDO communication parameter has the reserved sub-index 4",
    checks: "Reports objects from 1400h to 15FFh and from 1800h to 19FFh with sub-index 4. The rule reports one finding per device, which lists every such PDO. An UNSIGNED8, a compatibility entry of older devices, is a note: a quarter of the examined files have it, and it is harmless. A different data type is a warning, because the entry is probably meant for a different sub-index.",
    why: "CiA 301 reserves the sub-index; a device responds with an abort. An event timer in sub-index 4 instead of 5 has no effect.",
    example: "`[1800sub4]`",
    remedy: "Remove the section. The gap between 3 and 5 is correct, and sub-index 0 remains the highest sub-index.",
    source: "CiA 301 §7.4.8.1, §7.5.2.35, §7.5.2.37",

    "cia301/reserved-transmission-type" = RESERVED_TRANSMISSION_TYPE, Error, Pdo(reserved_transmission_type);
    summary: "a PDO has a reserved transmission type",
    checks: "The transmission type must not be 241 to 253 for an RPDO or 241 to 251 for a TPDO.",
    why: "A device rejects the value. 252 and 253 mean transmission on request, which does not apply to an RPDO.",
    example: "`[1400sub2]` with `DefaultValue=253`",
    remedy: "Write 255 or 254 for event-driven, 1 to 240 for every n-th SYNC, 0 for acyclic with SYNC.",
    source: "CiA 301 §7.5.2.35 table 68, §7.5.2.37 table 72",

    "cia301/rtr-only-pdo" = RTR_ONLY_PDO, Note, Pdo(rtr_only_pdo);
    summary: "a TPDO is sent only on request",
    checks: "Reports a valid TPDO that waits for a remote frame because of transmission type 252 or 253. A TPDO that also forbids remote frames has its own rule.",
    why: "CiA advises against remote frames: controllers of different vendors answer them differently or not at all, and CAN FD does not support them.",
    example: "`[1800sub2]` with `DefaultValue=253`",
    remedy: "Use 254 or 255 with an event timer, or a synchronous type.",
    source: "CiA 301 §7.5.2.37, table 72; CiA 801",

    "cia301/rtr-pdo-without-rtr" = RTR_PDO_WITHOUT_RTR, Warning, Pdo(rtr_pdo_without_rtr), fix Unsafe;
    summary: "a TPDO is sent only on request but forbids remote frames",
    checks: "The COB-ID of each TPDO with transmission type 252 or 253 must have bit 30 clear.",
    why: "Bit 30 forbids remote frames for the PDO, but these transmission types send it only on a remote frame: the PDO is never sent.",
    example: "`[1800sub1]` with `DefaultValue=$NODEID+0x40000180` and `[1800sub2]` with `DefaultValue=253`",
    remedy: "Use an event-driven or a synchronous type; CiA advises against remote frames.",
    source: "CiA 301 §7.5.2.37 tables 70 and 72",

    "cia301/timer-without-effect" = TIMER_WITHOUT_EFFECT, Note, Pdo(timer_without_effect);
    summary: "a PDO has a timer without effect",
    checks: "The inhibit time and event timer of each synchronous TPDO (types 0 to 240) must be 0. The inhibit time of each RPDO must be 0 too. Only SYNC triggers a synchronous TPDO, and reception cannot be inhibited.",
    why: "The author expects the timer to work. Often the transmission type is wrong.",
    example: "`[1800sub2]` with `DefaultValue=1` and `[1800sub5]` with `DefaultValue=100`",
    remedy: "Write 0, or use transmission type 254 or 255.",
}

fn incomplete_pdo_parameter(_: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let Some(object) = pdo.communication_record() else { return };
    let pdo = &pdo.pdo;
    let index = pdo.communication_index();
    for (sub, name) in [(1, "COB-ID"), (2, "transmission type")] {
        if !object.has(sub) {
            let message = say!("{} is missing sub-index {} ({}) of {:04X}h", pdo, sub, name, index);
            let finding = INCOMPLETE_PDO_PARAMETER.at(Place::object(index), message);
            findings.push(finding.help(say!("add `{}`", Part::Entry(index, sub))));
        }
    }
}

fn pdo_parameter_without_value(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let Some(object) = pdo.communication_record() else { return };
    let pdo = &pdo.pdo;
    let index = pdo.communication_index();
    for (sub, name) in [(1, "COB-ID"), (2, "transmission type")] {
        let has_type = object.subs.get(sub).is_none_or(|entry| entry.data_type.is_some());
        if has_type && is_unstated(object, sub) {
            let message = say!("the {} of {} has no value", name, pdo);
            let finding = PDO_PARAMETER_WITHOUT_VALUE.at(facts.device.value_place(index, sub), message);
            findings.push(finding.help("write the value that the device has after restoring defaults"));
            return;
        }
    }
}

fn pdo_valid_by_default(facts: &Facts<'_>, findings: &mut Findings) {
    let device = facts.device;
    let is_type = device.kind == DeviceKind::Type;
    let on = facts.pdos.iter().filter_map(|of_pdo| {
        let pdo = &of_pdo.pdo;
        let entry = pdo.communication?.subs.get(1)?;
        let cob_id = of_pdo.cob_id().filter(|cob_id| cob_id.cob_id.is_valid() && cob_id.wrong_bits() == 0)?;
        // another rule reports a restricted CAN-ID
        let is_looked_at = pdo.number > 4 && is_type && !facts.is_restricted(&cob_id);
        (is_looked_at && entry.configured_value().is_none()).then_some((pdo, cob_id.cob_id))
    });
    for (pdo, cob_id) in on {
        let message =
            say!("`{}` makes {} valid by default, although it has no predefined CAN-ID", cob_id, pdo);
        let finding = PDO_VALID_BY_DEFAULT.at(device.value_place(pdo.communication_index(), 1), message);
        findings.push(finding.help(say!("set bit 31: `{}`", cob_id.disabled())));
    }
}

fn pdo_without_mapping(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let pdo = &pdo.pdo;
    let (communication, mapping) = (pdo.communication_index(), pdo.mapping_index());
    let (there, what, missing, other) = match (pdo.communication, pdo.mapping) {
        (Some(_), None) => (communication, "a communication parameter", mapping, "mapping parameter"),
        (None, Some(_)) => (mapping, "a mapping parameter", communication, "communication parameter"),
        _ => return,
    };
    let device = facts.device;
    let mut modules = device.modules.iter().flat_map(|modules| modules.supported.values());
    if device.lists.contains(missing) || modules.any(|module| module.fixed.contains_key(&missing)) {
        return;
    }
    let message = say!("{} has {} ({:04X}h), but no {} ({:04X}h)", pdo, what, there, other, missing);
    let finding = PDO_WITHOUT_MAPPING.at(Place::object(there), message);
    findings.push(finding.help(say!("add {:04X}h, or remove {:04X}h", missing, there)));
}

fn reserved_pdo_sub_index(facts: &Facts<'_>, findings: &mut Findings) {
    let pdos = facts.pdos.iter().map(|facts| &facts.pdo);
    for (pdo, object, entry) in pdos.filter_map(|pdo| {
        let object = pdo.communication?;
        Some((pdo, object, object.subs.get(4)?))
    }) {
        let index = pdo.communication_index();
        let message = say!("{} has the reserved sub-index 4 in {:04X}h", pdo, index);
        let finding = RESERVED_PDO_SUB_INDEX.at(Place::entry(index, 4), message);
        let finding = finding.help(say!("remove the {section}; the event timer is sub-index 5"));
        let is_compatible = entry.data_type == Some(DataType::UNSIGNED8);
        let finding = if is_compatible { finding.severity(Severity::Note) } else { finding };
        let described = stated::described_subs(object).saturating_sub(1);
        let number = Place::object(index).field(Field::SubNumber);
        let fix = Fix::risky(say!("remove the {section}"));
        let mut fix = fix.remove(Place::entry(index, 4)).set(number, described.to_string());
        if object.highest_sub() == Some(4) {
            let below = object.subs.iter().map(|(sub, _)| sub).filter(|&sub| sub < 4);
            let count = Place::entry(index, 0).field(Field::DefaultValue);
            fix = fix.set(count, below.max().unwrap_or_default().to_string());
        }
        findings.push(finding.fix(fix));
    }
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
            "use a different transmission type, or clear bit 30: `{}0x{:X}`",
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
    let low_limit = facts.device.entry(index, sub).and_then(|entry| entry.low_limit.as_ref()?.as_integer());
    let lower = low_limit.filter(|&limit| limit > 0).map_or("".into(), |_| say!(" and lower `{LowLimit}`"));
    let finding = match pdo.transmission_type.filter(|_| is_cyclic) {
        Some(transmission_type) => {
            let message = say!("{} is synchronous, so its {} of `{}` has no effect", pdo, name, time);
            let reason = say!("transmission type {} is synchronous", transmission_type);
            let finding = TIMER_WITHOUT_EFFECT.at(place, message);
            let finding = finding.label(facts.device.value_place(index, 2), reason);
            finding.help(say!("write 0{}, or use transmission type 254 or 255", lower))
        }
        None => {
            let message = say!("the {} `{}` of {} has no effect", name, time, pdo);
            TIMER_WITHOUT_EFFECT.at(place, message).help(say!("write 0{}: reception is not inhibited", lower))
        }
    };
    findings.push(finding);
}
