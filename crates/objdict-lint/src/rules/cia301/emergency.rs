//! EMCY and the reaction of the device to errors.

use crate::diagnostic::{Findings, Fix, Severity, say, sub_index};
use crate::model::{Device, DeviceKind, PdoKind, Place};
use crate::rule::rules;
use crate::{CobIdService, Facts, stated};

rules! {
    "cia301/default-error-register" = DEFAULT_ERROR_REGISTER, Warning, Device(default_error_register);
    summary: "the description specifies an error as default",
    checks: "In an EDS, the defaults of 1001h (error register) and of 1003h sub-index 0 (number of errors in the history) must be 0.",
    why: "The default is the value after power-on without a fault. A tool that compares the device with its description reports a difference on a healthy device.",
    example: "`[1001]` with `DefaultValue=1`",
    remedy: "Write 0.",
    source: "CiA 301 §7.5.2.2, §7.5.2.4",

    "cia301/emergency-consumer-of-other-node" = EMERGENCY_CONSUMER_OF_OTHER_NODE, Warning,
        Facts(emergency_consumer_of_other_node);
    summary: "an EMCY consumer entry uses the COB-ID of a different node or service",
    checks: "Each valid COB-ID of 1028h between 81h and FFh must be 80h plus its sub-index, which is the node-ID of the producer. No entry may use a PDO CAN-ID of the predefined connection set. No entry of a DCF may refer to the node itself.",
    why: "The device attributes an error to the wrong node.",
    example: "`[1028sub5]` with `DefaultValue=0x86`",
    remedy: "Write 80h plus the sub-index, or set bit 31 to disable the entry.",
    source: "CiA 301 §7.5.2.31",

    "cia301/emergency-disabled" = EMERGENCY_DISABLED, Warning, Facts(emergency_disabled), fix Unsafe;
    summary: "the EMCY object is not valid by default although the device supports it",
    checks: "In an EDS with 1015h (inhibit time EMCY), bit 31 of 1014h must be clear.",
    why: "Bit 31 marks EMCY as not valid, so no error of the device reaches the network. For SYNC and TIME the bit has a different meaning, so it is easily set by mistake.",
    example: "`[1014]` with `DefaultValue=$NODEID+0x80000080`",
    remedy: "Clear bit 31: `$NODEID+0x80`.",
    source: "CiA 301 §7.5.2.17",

    "cia301/emergency-without-cob-id" = EMERGENCY_WITHOUT_COB_ID, Warning, Device(emergency_without_cob_id);
    summary: "the device has an EMCY object but no COB-ID for EMCY",
    checks: "A device with 1015h (inhibit time EMCY) must have 1014h, the COB-ID of EMCY. With only 1003h (pre-defined error field) the finding is a note, because a device may record errors without sending EMCY.",
    why: "The description shows that the device sends EMCY but not its CAN-ID.",
    example: "`[1015]` without `[1014]`",
    remedy: "Add 1014h with the default `$NODEID+0x80`.",
    source: "CiA 301 §7.5.2.17, §7.5.2.18",

    "cia301/invalid-error-behavior" = INVALID_ERROR_BEHAVIOR, Error, Device(invalid_error_behavior);
    summary: "an error behavior has a reserved value",
    checks: "Each value of 1029h must be 0 (change to pre-operational), 1 (no change), 2 (change to stopped) or manufacturer-specific, from 128 on.",
    why: "A device rejects the value, and a manager does not know how the device reacts to a communication error.",
    example: "`[1029sub1]` with `DefaultValue=3`",
    remedy: "Write the behavior of the device.",
    source: "CiA 301 §7.5.2.32",
}

fn default_error_register(device: &Device, findings: &mut Findings) {
    if device.kind != DeviceKind::Type {
        return;
    }
    for (index, what) in [(0x1001, "the error register"), (0x1003, "the number of errors")] {
        let is_compact = device.object(index).is_some_and(|object| object.compact.is_some());
        let value = device.value(index, 0).and_then(|value| value.as_integer());
        // sub-index 0 of a compactly stored history is the number of its entries
        let Some(value) = value.filter(|&value| value != 0 && !is_compact) else { continue };
        let message = say!("the default of {} is `{}` instead of 0", what, value);
        findings.push(DEFAULT_ERROR_REGISTER.at(device.value_place(index, 0), message).help("write 0"));
    }
}

fn emergency_consumer_of_other_node(facts: &Facts<'_>, findings: &mut Findings) {
    let consumers = facts.cob_ids.iter().filter(|cob_id| cob_id.service == CobIdService::EmcyConsumer);
    for consumer in consumers.filter(|consumer| consumer.is_in_use() && consumer.wrong_bits() == 0) {
        if consumer.cob_id.depends_on_node_id() && facts.device.node_id().is_none() {
            continue;
        }
        let can_id = consumer.cob_id.can_id(*facts.node_ids().start());
        let node = u32::from(consumer.sub);
        let is_of_pdo = (0x181..0x580).contains(&can_id) && can_id & 0x7F != 0 && !facts.is_shared(consumer);
        if consumer.cob_id.is_extended() || !(is_of_pdo || (0x81..=0xFF).contains(&can_id)) {
            continue;
        }
        let message = if is_of_pdo {
            let kind = if can_id & 0x80 == 0 { PdoKind::Rpdo } else { PdoKind::Tpdo };
            let number = (can_id - 0x80) >> 8;
            say!(
                "sub-index {} of 1028h is for an EMCY, but `{}` belongs to {} {} of node {}",
                sub_index(consumer.sub),
                consumer.cob_id,
                kind,
                number,
                can_id & 0x7F
            )
        } else if can_id != 0x80 + node {
            let sub = sub_index(consumer.sub);
            say!(
                "sub-index {} of 1028h is for node {}, but `{}` is the EMCY of node {}",
                sub,
                node,
                consumer.cob_id,
                can_id - 0x80
            )
        } else if facts.device.node_id() == Some(consumer.sub) {
            say!("sub-index {} of 1028h makes node {} consume its own EMCY", sub_index(consumer.sub), node)
        } else {
            continue;
        };
        let place = facts.device.value_place(consumer.index, consumer.sub);
        let finding = EMERGENCY_CONSUMER_OF_OTHER_NODE.at(place, message);
        let is_own = facts.device.node_id() == Some(consumer.sub) && can_id == 0x80 + node;
        findings.push(match is_own {
            true => finding.help("set bit 31 to disable the entry"),
            false => finding.help("write 80h plus the sub-index, or set bit 31 to disable the entry"),
        });
    }
}

fn emergency_disabled(facts: &Facts<'_>, findings: &mut Findings) {
    let device = facts.device;
    let emcy = facts.cob_ids.iter().find(|cob_id| cob_id.service == CobIdService::Emcy);
    let Some(emcy) = emcy.filter(|emcy| !emcy.cob_id.is_valid() && device.objects.contains_key(&0x1015))
    else {
        return;
    };
    // a configuration may disable EMCY on purpose
    if device.object(0x1014).is_some_and(|object| object.main.configured_value().is_some()) {
        return;
    }
    let message = say!("bit 31 of `{}` marks EMCY as not valid", emcy.cob_id);
    let place = device.value_place(0x1014, 0);
    let fix = Fix::risky("write `$NODEID+0x80`").set(place.clone(), "$NODEID+0x80");
    let finding = EMERGENCY_DISABLED.at(place, message);
    // without a valid node-ID, the formula has no value on the node
    let commissioning = device.commissioning.as_ref();
    let has_value = commissioning.is_none_or(|node| matches!(node.node_id, Some(1..=127)));
    let finding = if has_value { finding.fix(fix) } else { finding };
    let finding = finding.label(Place::object(0x1015), "the inhibit time of EMCY");
    findings.push(finding.help("clear bit 31: `$NODEID+0x80`"));
}

fn emergency_without_cob_id(device: &Device, findings: &mut Findings) {
    if stated::is_there(device, 0x1014) {
        return;
    }
    let help = "add 1014h (UNSIGNED32) with the default `$NODEID+0x80`";
    if device.objects.contains_key(&0x1015) {
        let message = "1015h (inhibit time EMCY) is described without 1014h (COB-ID EMCY)";
        findings.push(EMERGENCY_WITHOUT_COB_ID.at(Place::object(0x1015), message).help(help));
    } else if device.objects.contains_key(&0x1003) {
        let message = "1003h (pre-defined error field) is described without 1014h (COB-ID EMCY)";
        let finding = EMERGENCY_WITHOUT_COB_ID.at(Place::object(0x1003), message).help(help);
        findings.push(finding.severity(Severity::Note));
    }
}

fn invalid_error_behavior(device: &Device, findings: &mut Findings) {
    let Some(object) = device.object(0x1029) else { return };
    for sub in 1..=254 {
        let value = object.value(sub).and_then(|value| value.as_integer());
        let Some(value) = value.filter(|value| (3..128).contains(value)) else { continue };
        let message = say!("error behavior `{}` in sub-index {} of 1029h is reserved", value, sub_index(sub));
        let finding = INVALID_ERROR_BEHAVIOR.at(device.value_place(0x1029, sub), message);
        findings.push(finding.help("write 0 for pre-operational, 1 for no change or 2 for stopped"));
        if object.compact.is_some() {
            return; // all sub-indexes share one value
        }
    }
}
