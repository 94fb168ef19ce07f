//! Heartbeat, node guarding and life guarding.

use std::collections::BTreeMap;

use crate::diagnostic::{Findings, Severity, Text, say, sub_index};
use crate::model::{Access, Device, Object, Place, Value};
use crate::rule::rules;
use crate::{Facts, stated};

rules! {
    "cia301/heartbeat-beside-guarding" = HEARTBEAT_BESIDE_GUARDING, Warning, Facts(heartbeat_beside_guarding);
    summary: "heartbeat and life guarding are both enabled",
    checks: "At least one of 100Ch (guard time), 100Dh (life time factor) and 1017h (heartbeat time) must be 0.",
    why: "A node supports only one of them at a time. If the heartbeat time is set, the node sends heartbeats and does not respond to guarding requests, so life guarding reports a lost master.",
    example: "`[1017]` with `DefaultValue=1000`, `[100C]` with `DefaultValue=500` and `[100D]` with `DefaultValue=3`",
    remedy: "To use the heartbeat, write 0 to 100Ch and 100Dh. To use guarding, write 0 to 1017h.",
    source: "CiA 301 §7.2.8.2, §7.5.2.20",

    "cia301/heartbeat-switched-off" = HEARTBEAT_SWITCHED_OFF, Warning, Device(heartbeat_switched_off);
    summary: "no other node can detect the loss of the device",
    checks: "A device without node guarding (100Ch and 100Dh not both greater than 0) must have a heartbeat. 1017h must not be constantly 0, and a configuration must not change it from a different default to 0.",
    why: "With a heartbeat time of 0 the device sends no heartbeat, and a master never notices that it has failed.",
    example: "`[1017]` with `AccessType=ro` and `DefaultValue=0`",
    remedy: "Write a heartbeat time, or make 1017h writable.",
    source: "CiA 301 §7.5.2.20",

    "cia301/incomplete-life-guarding" = INCOMPLETE_LIFE_GUARDING, Warning, Facts(incomplete_life_guarding);
    summary: "life guarding has only one of its two values",
    checks: "100Ch (guard time) and 100Dh (life time factor) must be both 0 or both greater than 0. If a heartbeat time is set, they have no effect and are not checked.",
    why: "The node life time is the product of the two. If one is 0, the node does not monitor its master although the other value suggests it.",
    example: "`[100C]` with `DefaultValue=500` and `[100D]` with `DefaultValue=0`",
    remedy: "Write both values, or 0 to both.",
    source: "CiA 301 §7.5.2.11, §7.5.2.12",

    "cia301/incomplete-node-guarding" = INCOMPLETE_NODE_GUARDING, Error, Device(incomplete_node_guarding);
    summary: "one of the two node guarding objects is missing",
    checks: "100Ch (guard time) and 100Dh (life time factor) must be both described or both absent.",
    why: "The node life time is the product of the two. A device with only one of them cannot detect the loss of its master.",
    example: "`[100C]` without `[100D]`",
    remedy: "Add the missing object, or remove both and use the heartbeat.",
    source: "CiA 301 §7.5.2.11, §7.5.2.12",

    "cia301/invalid-consumer-heartbeat" = INVALID_CONSUMER_HEARTBEAT, Error,
        Device(invalid_consumer_heartbeat);
    summary: "a heartbeat consumer entry cannot monitor a node",
    checks: "Each value of 1016h with a time must have a node-ID from 1 to 127 and a clear upper byte. It must not monitor the node of the DCF itself or a node of an earlier entry. A node-ID without a time is a warning.",
    why: "A device rejects such a value with an abort or monitors no node. Often the node-ID is missing and the value is only the time.",
    example: "`[1016sub1]` with `DefaultValue=750`",
    remedy: "Write the node-ID to bits 16 to 23: `0x000702EE` monitors node 7 with 750 ms.",
    source: "CiA 301 §7.5.2.19",

    "cia301/no-error-control" = NO_ERROR_CONTROL, Error, Device(no_error_control);
    summary: "the device has neither a heartbeat nor node guarding",
    checks: "The device must have 1017h (producer heartbeat time) or one of 100Ch and 100Dh (node guarding).",
    why: "CiA 301 requires one of the two. Without it, the loss of the device is not detected.",
    example: "a device with only 1000h, 1001h and 1018h",
    remedy: "Add 1017h, a writable UNSIGNED16; CiA recommends the heartbeat.",
    source: "CiA 301 §7.5.2.11, §7.5.2.12, §7.5.2.20",

    "cia301/short-heartbeat-time" = SHORT_HEARTBEAT_TIME, Warning, Device(short_heartbeat_time);
    summary: "a heartbeat time is shorter than 10 ms",
    checks: "The heartbeat time 1017h and the consumer times in 1016h must be 0 or at least 10 ms, configured or by default.",
    why: "The unit is a millisecond, but such values are mostly meant in seconds. The heartbeats of a few nodes fill the bus, and a consumer reports a lost node with the first delay.",
    example: "`[1017]` with `DefaultValue=1`",
    remedy: "Write the time in milliseconds, such as 1000 for one second.",
    source: "CiA 301 §7.5.2.19, §7.5.2.20",
}

fn heartbeat_beside_guarding(facts: &Facts<'_>, findings: &mut Findings) {
    let is_on = |index| facts.number(index, 0).is_some_and(|number| number > 0);
    if !is_on(0x1017) || !is_on(0x100C) || !is_on(0x100D) {
        return;
    }
    let place = |index| facts.device.value_place(index, 0);
    let message = "guard time and heartbeat time are both set, but a node uses only one of them";
    let finding = HEARTBEAT_BESIDE_GUARDING
        .at(place(0x100C), message)
        .label(place(0x1017), "the heartbeat time")
        .label(place(0x100D), "the life time factor");
    findings.push(finding.help("write 0 to 100Ch and 100Dh, or to 1017h"));
}

fn heartbeat_switched_off(device: &Device, findings: &mut Findings) {
    let Some(object) = device.object(0x1017).filter(|object| !object.object_type().has_subs()) else {
        return;
    };
    let entry = &object.main;
    let is = |value: Option<&Value>, zero: bool| {
        value.and_then(Value::as_integer).is_some_and(|number| (number == 0) == zero)
    };
    let is_constant = matches!(entry.access, Some(Access::Ro | Access::Const)) && is(entry.value(), true);
    let is_configured = is(entry.configured_value(), true) && is(entry.default.as_ref(), false);
    let is_guarded = [0x100C, 0x100D].into_iter().all(|index| is(device.value(index, 0).as_deref(), false));
    if is_guarded || !is_constant && !is_configured {
        return;
    }
    let message = if is_constant {
        say!("the heartbeat time is a constant `0`, so the device sends no heartbeat")
    } else {
        say!("the configuration disables the heartbeat, but the device has no node guarding")
    };
    let finding = HEARTBEAT_SWITCHED_OFF.at(device.value_place(0x1017, 0), message);
    findings.push(finding.help("write a heartbeat time in milliseconds"));
}

fn incomplete_life_guarding(facts: &Facts<'_>, findings: &mut Findings) {
    let (Some(time), Some(factor)) = (facts.number(0x100C, 0), facts.number(0x100D, 0)) else { return };
    let has_heartbeat = facts.number(0x1017, 0).is_some_and(|time| time > 0);
    if has_heartbeat || (time == 0) == (factor == 0) {
        return;
    }
    let (set, zero) = if time == 0 { (0x100D, 0x100C) } else { (0x100C, 0x100D) };
    let message = say!(
        "the guard time is {} ms and the life time factor is {}, so life guarding is disabled",
        time,
        factor
    );
    let finding = INCOMPLETE_LIFE_GUARDING
        .at(facts.device.value_place(zero, 0), message)
        .label(facts.device.value_place(set, 0), "this value is set");
    findings.push(finding.help("set both 100Ch and 100Dh, or write 0 to both"));
}

fn incomplete_node_guarding(device: &Device, findings: &mut Findings) {
    let names = [(0x100C, "guard time"), (0x100D, "life time factor")];
    for ((index, name), (other, other_name)) in [(names[0], names[1]), (names[1], names[0])] {
        if device.objects.contains_key(&index) && !stated::is_there(device, other) {
            let message =
                say!("{:04X}h ({}) is described without {:04X}h ({})", index, name, other, other_name);
            let finding = INCOMPLETE_NODE_GUARDING.at(Place::object(index), message);
            findings.push(finding.help(say!("add {:04X}h, or remove {:04X}h", other, index)));
        }
    }
}

fn invalid_consumer_heartbeat(device: &Device, findings: &mut Findings) {
    let Some(object) = device.object(0x1016) else { return };
    let mut watched: BTreeMap<u32, u8> = BTreeMap::new();
    for sub in 1..=127 {
        let value = object.value(sub).and_then(|value| value.as_integer());
        let Some(value) = value.and_then(|value| u32::try_from(value).ok()) else { continue };
        let (node, time) = (value >> 16 & 0xFF, value & 0xFFFF);
        if value == 0 {
            continue;
        }
        let place = device.value_place(0x1016, sub);
        let finding =
            |message: Text, help: Text| INVALID_CONSUMER_HEARTBEAT.at(place.clone(), message).help(help);
        if value >> 24 != 0 {
            let message = say!("`0x{:08X}` in 1016h sub-index {} has bits above the node-ID set", value, sub);
            findings.push(finding(message, say!("did you mean `0x{:08X}`?", value & 0x00FF_FFFF)));
        } else if time == 0 {
            let message =
                say!("1016h sub-index {} names node {}, but a time of 0 ms does not monitor it", sub, node);
            let help = "write the time to bits 0 to 15, or 0 to disable the entry";
            findings.push(finding(message, help.into()).severity(Severity::Warning));
        } else if node == 0 || node > 127 {
            let message = say!(
                "1016h sub-index {} has a time of {} ms, but `{}` is not a valid node-ID",
                sub,
                time,
                node
            );
            let help = say!("write a node-ID from 1 to 127 to bits 16 to 23: `0x00nn{:04X}`", time);
            findings.push(finding(message, help));
        } else if device.node_id().is_some_and(|own| u32::from(own) == node) {
            let message = say!("1016h sub-index {} makes node {} monitor itself", sub, node);
            findings.push(finding(
                message,
                "write the node-ID of a different node, or 0 to disable the entry".into(),
            ));
        } else if let Some(&first) = watched.get(&node) {
            let message = say!("1016h sub-indexes {} and {} both monitor node {}", first, sub, node);
            let twice = finding(message, "write 0 to one of them".into());
            findings.push(twice.label(device.value_place(0x1016, first), "first entry for this node"));
        } else {
            watched.insert(node, sub);
        }
    }
}

/// The shortest heartbeat time in milliseconds that is not reported.
const SHORTEST_HEARTBEAT: i128 = 10;

fn short_heartbeat_time(device: &Device, findings: &mut Findings) {
    for index in [0x1016, 0x1017] {
        // another rule reports a wrong object type
        let is_right = |object: &&Object| object.object_type().has_subs() == (index == 0x1016);
        let Some(object) = device.object(index).filter(is_right) else { continue };
        for (sub, _) in object.entries().filter(|&(sub, _)| (sub > 0) == (index == 0x1016)) {
            let Some(value) = object.value(sub).and_then(|value| value.as_integer()) else { continue };
            // another rule reports a time without a node
            let is_of_node = index == 0x1017 || (1..=127).contains(&(value >> 16));
            let time = value & 0xFFFF;
            if !(1..SHORTEST_HEARTBEAT).contains(&time) || !is_of_node {
                continue;
            }
            let message = match index {
                0x1017 => say!("the device sends a heartbeat every {} ms", time),
                _ => say!("1016h sub-index {} expects a heartbeat every {} ms", sub_index(sub), time),
            };
            let finding = SHORT_HEARTBEAT_TIME.at(device.value_place(index, sub), message);
            findings.push(finding.help("write the time in milliseconds, such as 1000 for one second"));
        }
    }
}

fn no_error_control(device: &Device, findings: &mut Findings) {
    // another rule reports a fragment: a file without any communication object
    if [0x1017, 0x100C, 0x100D].into_iter().any(|index| stated::is_there(device, index))
        || device.objects.range(0x1000..0x2000).next().is_none()
    {
        return;
    }
    let message =
        "the device has no error control: neither a heartbeat (1017h) nor node guarding (100Ch, 100Dh)";
    findings.push(NO_ERROR_CONTROL.at(Place::device(), message).help("add 1017h (producer heartbeat time)"));
}
