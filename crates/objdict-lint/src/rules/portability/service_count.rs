use crate::canopennode::Cause;
use crate::diagnostic::Findings;
use crate::model::Device;
use crate::{rule, stack};

rule! {
    "portability/service-count", Error, Device(check);
    summary: "a stack does not support this number of objects",
    checks: "Whether the number of objects per service is within the limits of CANopenNode, which counts objects by index or count label (`CO_countLabel`): one for most services, 64 SRDOs, 128 SDO servers and 128 SDO clients, 255 RPDOs and 255 TPDOs. 1016h has 1 to 127 elements.",
    why: "CANopenNode does not compile; PDOs above 255 are ignored because the count is a byte.",
    example: "1016h with 128 elements",
    remedy: "Describe fewer objects, or use the count label for one object only.",
    source: "CANopen.c of CANopenNode 4",
}

fn check(device: &Device, findings: &mut Findings) {
    stack::unmet(&RULE.info, Cause::Count, device, findings);
}
