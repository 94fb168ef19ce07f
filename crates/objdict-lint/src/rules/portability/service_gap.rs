use crate::canopennode::Cause;
use crate::diagnostic::Findings;
use crate::model::Device;
use crate::{rule, stack};

rule! {
    "portability/service-gap", Warning, Device(check);
    summary: "the objects of a service do not follow each other",
    checks: "Whether SDO servers and clients, RPDOs and TPDOs are numbered from the first one without a gap, and each PDO has its mapping.",
    why: "CANopenNode takes as many objects of its list as there are, one after the other, from the first. Behind a gap it takes other objects for them; without the first one it does not compile.",
    example: "1800h and 1802h without 1801h",
    remedy: "Number the PDOs without a gap. One that is not used has bit 31 of its COB-ID set.",
    source: "CANopen.c of CANopenNode 4",
}

fn check(device: &Device, findings: &mut Findings) {
    stack::unmet(&RULE.info, Cause::Gap, device, findings);
}
