use crate::canopennode::Cause;
use crate::diagnostic::Findings;
use crate::model::Device;
use crate::{rule, stack};

rule! {
    "portability/service-gap", Warning, Device(check);
    summary: "the objects of a service are not consecutive",
    checks: "Whether SDO servers and clients, RPDOs and TPDOs are numbered from the first one without a gap, and each PDO has its mapping.",
    why: "CANopenNode takes consecutive entries of its object list, starting at the first. After a gap it uses the wrong objects; without the first one it does not compile.",
    example: "1800h and 1802h without 1801h",
    remedy: "Number the PDOs without a gap. Set bit 31 of the COB-ID of unused PDOs (not valid).",
    source: "CANopen.c of CANopenNode 4",
}

fn check(device: &Device, findings: &mut Findings) {
    stack::unmet(&RULE.info, Cause::Gap, device, findings);
}
