//! What a document demands and the device does not have.

use super::{Against, Applied};
use crate::diagnostic::{Diagnostic, Findings, RuleInfo};
use crate::lint::Facts;
use crate::model::{Device, ObjectType, Place};
use crate::profile::{Need, index_in};

/// Objects that the document demands are missing.
pub(crate) fn missing_object(
    rule: &'static RuleInfo,
    facts: &Facts<'_>,
    applied: &Applied<'_>,
    findings: &mut Findings,
) {
    let device = facts.device;
    for facts in &applied.profile.objects {
        let index = index_in(applied.block, facts.first);
        let is_communication = applied.block > 0 && index == facts.first;
        if is_communication || facts.need == Need::Optional || is_there(device, index) {
            continue;
        }
        let Some(why) = why(&facts.need, device, applied.block) else { continue };
        let is_for_others =
            facts.only.as_ref().is_some_and(|only| only.holds(device, applied.block) != Some(true));
        if is_for_others {
            continue;
        }
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
    device.objects.contains_key(&index)
        || device.is_modular()
        || device.lists.iter().any(|(_, listed)| listed == index)
}

/// Why something is demanded, as the end of a message; `None` when it is not.
fn why(need: &Need, device: &Device, block: u8) -> Option<String> {
    match need {
        Need::Optional => None,
        Need::Mandatory => Some(String::new()),
        Need::When(condition) if condition.holds(device, block) == Some(true) => {
            Some(format!(" when `{condition}`"))
        }
        Need::When(_) => None,
    }
}

/// Sub-indexes that the document demands are missing.
pub(crate) fn missing_entry(rule: &'static RuleInfo, at: &Against<'_>, findings: &mut Findings) {
    let is_structured = at.stated_type().is_some_and(ObjectType::has_subs);
    if !is_structured || !at.has_its_shape() || at.device.is_modular() {
        return;
    }
    // sub-index 0 is the matter of a rule of its own
    for facts in at.facts.entries.iter().filter(|facts| facts.first > 0 && !at.object.has(facts.first)) {
        let Some(why) = why(&facts.need, at.device, at.applied.block) else { continue };
        let (sub, document) = (facts.first, at.applied.document());
        let name = if facts.name.is_empty() { String::new() } else { format!(" ({})", facts.name) };
        let message = format!("{at} has no sub-index {sub}{name}, {document} demands it{why}");
        let finding = Diagnostic::new(rule, Place::object(at.index), message);
        findings.push(finding.help(format!("add `[{:X}sub{sub:X}]`", at.index)));
    }
}
