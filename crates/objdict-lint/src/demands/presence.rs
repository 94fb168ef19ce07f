//! Objects and sub-indexes that are missing, or that are defined only for other devices.

use super::{Against, Applied};
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, Text, counted, say};
use crate::model::{Device, Object, ObjectType, Part, Place};
use crate::profile::{Need, index_in};
use crate::{Facts, channels, stated};

/// Reports missing objects that the document requires.
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
        if is_for_lacking_channels(facts.need, device, applied.block) {
            continue;
        }
        let condition = condition(facts.need, device, applied.block);
        let document = applied.document();
        let message =
            say!("{:04X}h ({}) is missing; {} requires it{}", index, facts.name, document, condition);
        let device_type = || Place::object(crate::profile::device_type_index(device, applied.block));
        let place = cause(facts.need, device, applied.block).unwrap_or_else(device_type);
        let finding = Diagnostic::new(rule, place, message)
            .severity(rule.severity.min(super::highest_severity(facts.confidence)))
            .help(help_for_missing(device, facts.need, index));
        findings.push(finding);
    }
}

/// The help for a missing object. CiA 401 requires the default PDOs only for a device without its own mapping, which
/// bit 23 of its device type states.
fn help_for_missing(device: &Device, need: Need<'_>, index: u16) -> Text {
    let is_mapping = matches!(index, 0x1600..=0x17FF | 0x1A00..=0x1BFF) && !is_there(device, index - 0x200);
    let add = match is_mapping {
        true => say!("add the objects: `{}` and `{}`", Part::Object(index - 0x200), Part::Object(index)),
        false => say!("add the object: `{}`", Part::Object(index)),
    };
    let device_type = device.value(0x1000, 0).and_then(|value| Some(value.as_integer()? | 1 << 23));
    let is_of_default = matches!(need, Need::When(condition) if condition.tests_bit(0x1000, 23));
    match device_type.filter(|_| is_of_default) {
        Some(own) => {
            say!("{}; or write `0x{:08X}` to 1000h (bit 23) if the PDOs are mapped differently", add, own)
        }
        None => add,
    }
}

/// Whether the requirement is about channels that only the device type states, for which there is a separate
/// rule.
fn is_for_lacking_channels(need: Need<'_>, device: &Device, block: u8) -> bool {
    let Need::When(condition) = need else { return false };
    channels::only_stated(device, block).any(|kind| condition.tests_bit(0x1000, kind.bit))
}

/// Whether an object is described, reported as missing elsewhere, or possibly provided by a module.
pub(crate) fn is_there(device: &Device, index: u16) -> bool {
    device.is_modular() || stated::is_there(device, index)
}

/// The condition of a requirement, as the end of a message.
fn condition(need: Need<'_>, device: &Device, block: u8) -> Text {
    match need {
        Need::When(condition) => say!(" when {}", Text::from(condition.in_words(device, block))),
        Need::Mandatory | Need::Optional => Text::default(),
    }
}

/// The place of the value or object that causes a requirement.
fn cause(need: Need<'_>, device: &Device, block: u8) -> Option<Place> {
    let Need::When(condition) = need else { return None };
    let (index, sub) = condition.causes(device, block).next()?;
    Some(sub.map_or(Place::object(index), |sub| device.value_place(index, sub)))
}

/// Reports missing sub-indexes that the document requires.
pub(crate) fn missing_entry(rule: &'static RuleInfo, at: &Against<'_>, findings: &mut Findings) {
    let is_structured = stated::object_type(at.object).is_some_and(ObjectType::has_subs);
    if !is_structured || !at.has_its_shape() || at.device.is_modular() {
        return;
    }
    // sub-index 0 has its own rule
    let missing = at.facts.entries().filter(|facts| facts.first > 0 && !at.object.has(facts.first));
    for facts in missing.filter(|facts| facts.need.is_there(at.device, at.applied.block)) {
        let condition = condition(facts.need, at.device, at.applied.block);
        let (sub, document) = (facts.first, at.applied.document());
        let name = if facts.name.is_empty() { Text::default() } else { say!(" ({})", facts.name) };
        let message =
            say!("{} is missing sub-index {}{}; {} requires it{}", at, sub, name, document, condition);
        let finding = Diagnostic::new(rule, Place::object(at.index), message);
        findings.push(finding.help(say!("add `{}`", Part::Entry(at.index, sub))));
    }
}

/// Reports a described object that the document defines only for other devices.
pub(crate) fn misplaced_object(rule: &'static RuleInfo, at: &Against<'_>, findings: &mut Findings) {
    let Some(only) = at.facts.only.filter(|_| !at.object.orphan) else { return };
    if only.holds(at.device, at.applied.block) == Some(false) {
        let message = say!(
            "{} defines {} only for devices where {}",
            at.applied.document(),
            at,
            Text::from(only.in_words(at.device, at.applied.block))
        );
        let finding = Diagnostic::new(rule, Place::object(at.index), message);
        findings.push(finding.help("remove the object, or correct the entry that the condition refers to"));
    }
}

/// Reports an object with a different number of elements than the objects it belongs to.
pub(crate) fn different_channel_count(rule: &'static RuleInfo, at: &Against<'_>, findings: &mut Findings) {
    if at.facts.as_many_as.is_empty() || !at.has_its_shape() || at.device.is_modular() {
        return;
    }
    let others: Vec<(u16, Option<u8>)> =
        at.counterparts().filter_map(|index| Some((index, count(at.device.object(index)?)))).collect();
    let Some(own) = count(at.object) else { return };
    let is_alike = others.iter().any(|&(_, number)| number.is_none_or(|number| number == own));
    let Some(&(index, Some(number))) = others.first().filter(|_| !is_alike) else { return };
    let message =
        say!("{} has {}, but {:04X}h has {}", at, counted(own.into(), "element", "elements"), index, number);
    let finding = Diagnostic::new(rule, at.device.value_place(at.index, 0), message);
    let finding =
        finding.label(at.device.value_place(index, 0), counted(number.into(), "element", "elements"));
    findings.push(finding.help(say!("describe {}", counted(number.into(), "element", "elements"))));
}

/// The number of elements if sub-index 0 and the description agree. Another rule reports a missing number.
fn count(object: &Object) -> Option<u8> {
    let number = object.value(0)?.as_integer()?;
    let highest = object.highest_sub()?;
    (number == i128::from(highest) && highest > 0 && !object.orphan).then_some(highest)
}
