use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::model::{Device, Field, Place};
use crate::rule;

rule! {
    "cia301/default-sdo-node-id", Warning, Device(check), fix Unsafe;
    summary: "the default SDO specifies a client",
    checks: "Whether 1200h, the default SDO, has sub-index 3, the node-ID of the client.",
    why: "The default SDO is reserved for the network manager and has no specific client. CiA 301 defines the entry for additional channels only, and a conformance test rejects it.",
    example: "`[1200sub3]`",
    remedy: "Remove the sub-index, and reduce `SubNumber` and sub-index 0 by one.",
    source: "CiA 301 §7.5.2.33",
}

fn check(device: &Device, findings: &mut Findings) {
    let index = 0x1200;
    let Some(object) = device.object(index).filter(|object| object.subs.get(3).is_some()) else { return };
    if object.compact.is_some() {
        return;
    }
    let message = "1200h has sub-index 3, but the default SDO has no specific client";
    let finding = Diagnostic::new(&RULE.info, Place::entry(index, 3), message);
    let finding = finding.help(say!("remove `{[1200sub3]}`"));
    let is_whole = object.sub_number == Some(4) && object.highest_sub() == Some(3) && object.subs.len() == 4;
    findings.push(if is_whole {
        let fix = Fix::risky("remove sub-index 3 and update the number of entries")
            .remove(Place::entry(index, 3))
            .set(Place::object(index).field(Field::SubNumber), "3")
            .set(Place::entry(index, 0).field(Field::DefaultValue), "2");
        finding.fix(fix)
    } else {
        finding
    });
}
