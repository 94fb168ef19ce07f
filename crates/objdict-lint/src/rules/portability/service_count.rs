use crate::canopennode::Cause;
use crate::diagnostic::Findings;
use crate::model::Device;
use crate::{rule, stack};

rule! {
    "portability/service-count", Warning, Device(check);
    summary: "there are too many objects for a service of a stack",
    checks: "Whether no more objects belong to a service than CANopenNode has room for, which it tells by their indexes or count labels (`CO_countLabel`): one of most, 64 SRDOs, 128 SDOs of a kind, 255 PDOs of a kind. 1016h has 1 to 127 elements.",
    why: "CANopenNode stops the compiler; PDOs beyond 255 are not there, for it counts them in a byte.",
    example: "1016h with 128 elements",
    remedy: "Describe fewer of them, or leave the count label to one object.",
    source: "CANopen.c of CANopenNode 4",
}

fn check(device: &Device, findings: &mut Findings) {
    stack::unmet(&RULE.info, Cause::Count, device, findings);
}
