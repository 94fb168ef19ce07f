use crate::canopennode::Cause;
use crate::diagnostic::Findings;
use crate::model::Device;
use crate::{rule, stack};

rule! {
    "portability/service-object-missing", Error, Device(check);
    summary: "an object required by a stack is missing",
    checks: "Whether the device has 1000h, 1001h, 1014h and 1017h, and also 1006h if it has 1005h, counted by the count labels of the description (`CO_countLabel`) too.",
    why: "CANopenNode is compiled with the objects of its services and does not compile if one of them is missing, although most of them are optional in CiA 301.",
    example: "no `[1017]`",
    remedy: "Describe the object. A producer heartbeat time of 0 and an EMCY COB-ID with bit 31 set (not valid) disable the services.",
    source: "CANopen.c of CANopenNode 4",
}

fn check(device: &Device, findings: &mut Findings) {
    stack::unmet(&RULE.info, Cause::Missing, device, findings);
}
