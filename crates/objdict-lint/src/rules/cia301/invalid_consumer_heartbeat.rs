use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, Findings, Text, say};
use crate::model::Device;
use crate::rule;

rule! {
    "cia301/invalid-consumer-heartbeat", Error, Device(check);
    summary: "an entry of the heartbeat consumer cannot watch a node",
    checks: "Whether each value of 1016h that has a time names a node from 1 to 127, has its upper byte clear, does not name the node of the DCF itself, and does not watch a node that an entry before it watches.",
    why: "A device answers such a value with an abort, or watches nobody. Mostly the node-ID was forgotten, and the value is just the time.",
    example: "`[1016sub1]` with `DefaultValue=750`",
    remedy: "Write the node-ID into bits 16 to 23: `0x000702EE` watches node 7 for 750 ms.",
    source: "CiA 301 §7.5.2.19",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(object) = device.object(0x1016) else { return };
    let mut watched: BTreeMap<u32, u8> = BTreeMap::new();
    for sub in 1..=127 {
        let value = object.value(sub).and_then(|value| value.as_integer());
        let Some(value) = value.and_then(|value| u32::try_from(value).ok()) else { continue };
        let (node, time) = (value >> 16 & 0xFF, value & 0xFFFF);
        if value == 0 || (time == 0 && value >> 24 == 0) {
            continue;
        }
        let place = device.value_place(0x1016, sub);
        let finding =
            |message: Text, help: Text| Diagnostic::new(&RULE.info, place.clone(), message).help(help);
        if value >> 24 != 0 {
            let message = say!("`0x{:08X}` of 1016h sub-index {} has bits above the node-ID set", value, sub);
            findings.push(finding(message, say!("did you mean `0x{:08X}`?", value & 0x00FF_FFFF)));
        } else if node == 0 || node > 127 {
            let message =
                say!("1016h sub-index {} watches for {} ms, but `{}` is no node-ID", sub, time, node);
            let help = say!("write the node-ID from 1 to 127 before the time: `0x00nn{:04X}`", time);
            findings.push(finding(message, help));
        } else if device.node_id().is_some_and(|own| u32::from(own) == node) {
            let message = say!("1016h sub-index {} makes node {} watch itself", sub, node);
            findings.push(finding(message, "write the node-ID of another node, or 0 for none".into()));
        } else if let Some(&first) = watched.get(&node) {
            let message = say!("1016h sub-indexes {} and {} both watch node {}", first, sub, node);
            let twice = finding(message, "keep one of them, and write 0 into the other".into());
            findings.push(twice.label(device.value_place(0x1016, first), "the first one"));
        } else {
            watched.insert(node, sub);
        }
    }
}
