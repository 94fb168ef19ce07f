use crate::canopennode::Cause;
use crate::diagnostic::Findings;
use crate::model::Device;
use crate::{rule, stack};

rule! {
    "portability/no-error-history", Error, Device(check);
    summary: "a stack needs 1003h, error history",
    checks: "Whether the device has 1003h.",
    why: "CANopenNode keeps an error history unless configured otherwise (`CO_CONFIG_EM` without `CO_CONFIG_EM_HISTORY`). Without 1003h its start fails, without error information.",
    example: "no `[1003]`",
    remedy: "Describe 1003h as an ARRAY with at least one element, or configure the stack without the history.",
    source: "CO_EM_init of CANopenNode 4",
}

fn check(device: &Device, findings: &mut Findings) {
    stack::unmet(&RULE.info, Cause::NoHistory, device, findings);
}
