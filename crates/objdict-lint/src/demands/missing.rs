//! What a document demands and the device does not have.

use super::{Against, Applied};
use crate::diagnostic::{Diagnostic, Findings, RuleInfo};
use crate::model::{Device, ObjectType, Place};
use crate::profile::{Need, index_in};
use crate::{Facts, stated};

/// Objects that the document demands are missing.
pub(crate) fn missing_object(
    rule: &'static RuleInfo,
    facts: &Facts<'_>,
    applied: &Applied<'_>,
    findings: &mut Findings,
) {
    let device = facts.device;
    for facts in applied.profile.objects() {
        let index = index_in(applied.block, facts.first);
        let is_communication = applied.block > 0 && index == facts.first;
        if is_communication || !facts.is_demanded(device, applied.block) || is_there(device, index) {
            continue;
        }
        let why = why(facts.need);
        let message =
            format!("{index:04X}h ({}) is missing, {} demands it{why}", facts.name, applied.document());
        let place = Place::object(crate::profile::device_type_index(device, applied.block));
        findings.push(
            Diagnostic::new(rule, place, message).help(format!("describe the object: `[{index:04X}]`")),
        );
    }
}

/// Whether an object is described, or another rule says that it should be, or something else may bring it.
pub(crate) fn is_there(device: &Device, index: u16) -> bool {
    device.is_modular() || stated::is_there(device, index)
}

/// Why something is demanded, as the end of a message.
fn why(need: Need<'_>) -> String {
    match need {
        Need::When(condition) => format!(" when `{condition}`"),
        Need::Mandatory | Need::Optional => String::new(),
    }
}

/// Sub-indexes that the document demands are missing.
pub(crate) fn missing_entry(rule: &'static RuleInfo, at: &Against<'_>, findings: &mut Findings) {
    let is_structured = at.stated_type().is_some_and(ObjectType::has_subs);
    if !is_structured || !at.has_its_shape() || at.device.is_modular() {
        return;
    }
    // sub-index 0 is the matter of a rule of its own
    let missing = at.facts.entries().filter(|facts| facts.first > 0 && !at.object.has(facts.first));
    for facts in missing.filter(|facts| facts.need.is_there(at.device, at.applied.block)) {
        let why = why(facts.need);
        let (sub, document) = (facts.first, at.applied.document());
        let name = if facts.name.is_empty() { String::new() } else { format!(" ({})", facts.name) };
        let message = format!("{at} has no sub-index {sub}{name}, {document} demands it{why}");
        let finding = Diagnostic::new(rule, Place::object(at.index), message);
        findings.push(finding.help(format!("add `[{:X}sub{sub:X}]`", at.index)));
    }
}
