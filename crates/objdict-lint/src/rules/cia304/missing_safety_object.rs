use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::Place;
use crate::{Facts, rule, stated};

rule! {
    "cia304/missing-safety-object", Error, Facts(check);
    summary: "a device with SRDOs lacks the objects that protect their configuration",
    checks: "Whether a device with SRDOs has 13FEh, the validity of the configuration, and 13FFh, its checksums.",
    why: "A configuration tool writes the checksums and then marks the configuration valid. Without these objects the device can never transmit or accept an SRDO.",
    example: "`[1301]` and `[1381]` without `[13FF]`",
    remedy: "Add 13FEh, an UNSIGNED8, and 13FFh, an ARRAY of UNSIGNED16 with an element for each SRDO.",
    source: "EN 50325-5 (CiA 304)",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let Some(first) = facts.srdos.first() else { return };
    let place = match first.communication {
        Some(_) => Place::object(first.communication_index()),
        None => Place::object(first.mapping_index()),
    };
    for (index, name) in [(0x13FE, "configuration valid"), (0x13FF, "safety configuration checksum")] {
        if !stated::is_there(facts.device, index) {
            let message = say!("the device has SRDOs but no {:04X}h ({})", index, name);
            findings
                .push(Diagnostic::new(&RULE.info, place.clone(), message).help(say!("add {:04X}h", index)));
        }
    }
}
