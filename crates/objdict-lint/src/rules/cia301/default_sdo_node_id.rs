use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::model::{Device, Field, Place};
use crate::rule;

rule! {
    "cia301/default-sdo-node-id", Warning, Device(check), fix Unsafe;
    summary: "the default SDO names a client",
    checks: "Whether 1200h, the default SDO, is without sub-index 3, the node-ID of the client.",
    why: "The default SDO belongs to whoever manages the network; its identifiers say the rest. CiA 301 gives the entry to additional channels only, and a conformance test refuses it.",
    example: "`[1200sub3]`",
    remedy: "Remove the sub-index, and count one less in `SubNumber` and sub-index 0.",
    source: "CiA 301 §7.5.2.33",
}

fn check(device: &Device, findings: &mut Findings) {
    let index = 0x1200;
    let Some(object) = device.object(index).filter(|object| object.subs.get(3).is_some()) else { return };
    if object.compact.is_some() {
        return;
    }
    let message = "1200h has sub-index 3, and the default SDO has no client of its own";
    let finding = Diagnostic::new(&RULE.info, Place::entry(index, 3), message);
    let finding = finding.help(say!("remove `{[1200sub3]}`"));
    let is_whole = object.sub_number == Some(4) && object.highest_sub() == Some(3) && object.subs.len() == 4;
    findings.push(if is_whole {
        let fix = Fix::risky("remove sub-index 3, and count the others")
            .remove(Place::entry(index, 3))
            .set(Place::object(index).field(Field::SubNumber), "3")
            .set(Place::entry(index, 0).field(Field::DefaultValue), "2");
        finding.fix(fix)
    } else {
        finding
    });
}
