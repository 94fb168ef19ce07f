use crate::canopennode::Cause;
use crate::diagnostic::Findings;
use crate::model::Device;
use crate::{rule, stack};

rule! {
    "portability/service-object-missing", Warning, Device(check);
    summary: "an object is missing that a stack is built around",
    checks: "Whether the device has 1000h, 1001h, 1014h and 1017h, and 1006h beside 1005h; the count labels of the description (`CO_countLabel`) count too.",
    why: "CANopenNode is compiled with the objects of its services and stops the compiler where one of these is missing, although CiA 301 leaves most of them to the device.",
    example: "no `[1017]`",
    remedy: "Describe the object. A producer heartbeat time of 0 and an EMCY COB-ID with bit 31 set switch the services off.",
    source: "CANopen.c of CANopenNode 4",
}

fn check(device: &Device, findings: &mut Findings) {
    stack::unmet(&RULE.info, Cause::Missing, device, findings);
}
