//! Findings for the requirements of stacks.

use crate::diagnostic::{Diagnostic, Findings, RuleInfo};
use crate::model::Device;
use objdict_model::canopennode::{self, Cause};

/// Reports the requirements of one kind that a device does not meet.
pub(crate) fn unmet(rule: &'static RuleInfo, cause: Cause, device: &Device, findings: &mut Findings) {
    for unmet in canopennode::unmet(device).into_iter().filter(|unmet| unmet.cause == cause) {
        findings.push(Diagnostic::new(rule, unmet.place, unmet.message).help(unmet.help));
    }
}
