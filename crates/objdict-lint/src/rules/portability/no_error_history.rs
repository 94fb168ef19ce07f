use crate::canopennode::Cause;
use crate::diagnostic::Findings;
use crate::model::Device;
use crate::{rule, stack};

rule! {
    "portability/no-error-history", Warning, Device(check);
    summary: "there is no error history for a stack that keeps one",
    checks: "Whether the device has 1003h.",
    why: "CANopenNode keeps a history of errors unless it is configured otherwise (`CO_CONFIG_EM` without `CO_CONFIG_EM_HISTORY`). Without 1003h its start then fails, and no error information says why.",
    example: "no `[1003]`",
    remedy: "Describe the object as an ARRAY of at least one element, or configure the stack without the history.",
    source: "CO_EM_init of CANopenNode 4",
}

fn check(device: &Device, findings: &mut Findings) {
    stack::unmet(&RULE.info, Cause::NoHistory, device, findings);
}
