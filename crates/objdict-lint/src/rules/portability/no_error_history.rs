use crate::canopennode::Cause;
use crate::diagnostic::Findings;
use crate::model::Device;
use crate::{rule, stack};

rule! {
    /// there is no error history for a stack that keeps one
    ///
    /// ## What it checks
    /// Whether the device has 1003h.
    ///
    /// ## Why it matters
    /// CANopenNode keeps a history of errors unless it is configured otherwise (`CO_CONFIG_EM` without `CO_CONFIG_EM_HISTORY`). Without 1003h its start then fails, and no error information says why.
    ///
    /// ## Example
    /// no `[1003]`
    ///
    /// ## How to mend
    /// Describe the object as an ARRAY of at least one element, or configure the stack without the history.
    ///
    /// ## Source
    /// CO_EM_init of CANopenNode 4
    "portability/no-error-history", Warning, Device(check)
}

fn check(device: &Device, findings: &mut Findings) {
    stack::unmet(&RULE.info, Cause::NoHistory, device, findings);
}
