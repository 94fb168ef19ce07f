use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, Findings, Severity, Text, say};
use crate::model::Device;
use crate::rule;

rule! {
    "cia301/invalid-consumer-heartbeat", Error, Device(check);
    summary: "a heartbeat consumer entry cannot monitor a node",
    checks: "Whether each value of 1016h with a time has a node-ID from 1 to 127, has its upper byte clear, does not monitor the node of the DCF itself, and does not monitor a node of an earlier entry. A node-ID without a time is a warning.",
    why: "A device rejects such a value with an abort, or monitors no node. Often the node-ID is missing and the value is only the time.",
    example: "`[1016sub1]` with `DefaultValue=750`",
    remedy: "Write the node-ID to bits 16 to 23: `0x000702EE` monitors node 7 with 750 ms.",
    source: "CiA 301 §7.5.2.19",
}

fn check(device: &Device, findings: &mut Findings) {
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
            |message: Text, help: Text| Diagnostic::new(&RULE.info, place.clone(), message).help(help);
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
                "write the node-ID of another node, or 0 to disable the entry".into(),
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
