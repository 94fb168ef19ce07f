//! Objects beside what a document says of them.

use super::Against;
use crate::diagnostic::{Argument, Diagnostic, Findings, Fix, RuleInfo, Severity, Text, counted, say};
use crate::model::{DataType, Field, Object, ObjectType, Place};
use crate::profile::index_in;

/// The object type is another one.
pub(crate) fn wrong_object_type(rule: &'static RuleInfo, at: &Against<'_>, findings: &mut Findings) {
    let (object, index) = (at.object, at.index);
    let (expected, found) = (at.facts.object_type(), object.object_type());
    let is_right = object.orphan || !at.facts.states_type() || found == expected || found == ObjectType::Null;
    if is_right || type_is_reported_elsewhere(at) {
        return;
    }
    let message = say!("{} is of object type {}, {} makes it {}", at, found, at.applied.document(), expected);
    let finding = Diagnostic::new(rule, Place::object(index).field(Field::ObjectType), message);
    let finding = finding.help(say!(
        "write `{}`",
        Argument::setting(Field::ObjectType, format_args!("0x{:X}", expected.code()))
    ));
    let harmless = at.facts.object_types.contains(&found);
    findings.push(if harmless { finding.severity(Severity::Warning) } else { finding });
}

/// Whether other rules have it: no object type at all, sub-indexes of a VAR, a VAR of type DOMAIN.
fn type_is_reported_elsewhere(at: &Against<'_>) -> bool {
    let object = at.object;
    let is_var = object.object_type() == ObjectType::Var;
    let is_domain = object.main.data_type == Some(DataType::DOMAIN);
    object.main.misfits.get(&Field::ObjectType).is_some()
        || (is_var && (!object.subs.is_empty() || is_domain))
}

/// There is a sub-index that the document does not define. Any may be, where it defines none, or adds to what another
/// document says of the object, so that it does not say of what object type it is.
pub(crate) fn undefined_sub_index(rule: &'static RuleInfo, at: &Against<'_>, findings: &mut Findings) {
    // a VAR with sub-indexes is the matter of another rule
    let is_whole = at.facts.states_type() && at.facts.entries().len() > 0;
    if !at.has_its_shape() || !at.object.object_type().has_subs() || !is_whole {
        return;
    }
    let highest = at.facts.highest_sub();
    let undefined = at.object.subs.iter().filter(|&(sub, _)| sub != 0xFF && at.facts.entry(sub).is_none());
    for (sub, _) in undefined {
        let message = say!("{} has no sub-index {}, only up to {}", at, sub, highest);
        let finding = Diagnostic::new(rule, Place::entry(at.index, sub), message);
        findings.push(finding.help("describe what is your own from 2000h on"));
    }
    if let Some(compact) = at.object.compact.as_ref().filter(|compact| compact.count > highest) {
        let message = say!(
            "`{CompactSubObj}` gives {} {} sub-indexes, {} {}",
            at,
            compact.count,
            at.applied.document(),
            highest
        );
        let place = Place::object(at.index).field(Field::CompactSubObj);
        findings.push(Diagnostic::new(rule, place, message).help(say!("write at most {}", highest)));
    }
}

/// Sub-index 0 states a number that the document does not allow.
pub(crate) fn sub_0_out_of_range(rule: &'static RuleInfo, at: &Against<'_>, findings: &mut Findings) {
    if !at.has_its_shape() || !at.object.object_type().has_subs() {
        return;
    }
    let Some(facts) = at.facts.entry(0).filter(|facts| !facts.values.is_empty()) else { return };
    let Some(value) = at.object.value(0).and_then(|value| value.as_integer()) else { return };
    if facts.accepts_value(value) || sub_0_is_reported_elsewhere(at, value) {
        return;
    }
    let range = facts.values.first().map_or((0, 0), |range| (*range.start(), *range.end()));
    let message = match range {
        (low, high) if low == high => {
            say!("`{}` as highest sub-index of {}, which has always {}", value, at, low)
        }
        (low, high) => say!("`{}` as highest sub-index of {}, which takes {} to {}", value, at, low, high),
    };
    let finding = Diagnostic::new(rule, at.device.value_place(at.index, 0), message);
    findings.push(finding.help("describe the entries of the object, or leave the object out"));
}

/// Whether another rule has it: the sub-indexes are too many or too few, or others than sub-index 0 says.
fn sub_0_is_reported_elsewhere(at: &Against<'_>, value: i128) -> bool {
    let (object, facts) = (at.object, at.facts);
    let highest = object.highest_sub().unwrap_or(0);
    let differs = value != i128::from(highest)
        && object.subs.get(0).and_then(|entry| entry.access).is_some_and(|access| !access.is_writable());
    let has_rule = matches!(facts.first, 0x1018 | 0x1200..=0x12FF | 0x1400..=0x19FF | 0x1F00..=0x1F9F);
    let missing = facts.entries().any(|entry| entry.is_mandatory() && !object.has(entry.first));
    differs || highest > facts.highest_sub() || (has_rule && missing) || object.compact.is_some()
}

/// The object is there, though the document has it for other devices only.
pub(crate) fn misplaced_object(rule: &'static RuleInfo, at: &Against<'_>, findings: &mut Findings) {
    let Some(only) = at.facts.only.filter(|_| !at.object.orphan) else { return };
    if only.holds(at.device, at.applied.block) == Some(false) {
        let message = say!(
            "{} is for devices with `{}` only, says {}",
            at,
            Text::from(only.to_string()),
            at.applied.document()
        );
        let finding = Diagnostic::new(rule, Place::object(at.index), message);
        findings.push(finding.help("leave the object out, or correct what the device says of itself"));
    }
}

/// The object has another number of elements than those that it goes with.
pub(crate) fn different_channel_count(rule: &'static RuleInfo, at: &Against<'_>, findings: &mut Findings) {
    let facts = at.facts;
    if facts.as_many_as.is_empty() || !at.has_its_shape() || at.device.is_modular() {
        return;
    }
    let block = at.applied.block;
    let offset = at.index - index_in(block, facts.first);
    let others = facts.as_many_as.iter().map(|&index| index_in(block, index) + offset);
    let others: Vec<(u16, Option<u8>)> =
        others.filter_map(|index| Some((index, count(at.device.object(index)?)))).collect();
    let Some(own) = count(at.object) else { return };
    let is_alike = others.iter().any(|&(_, number)| number.is_none_or(|number| number == own));
    let Some(&(index, Some(number))) = others.first().filter(|_| !is_alike) else { return };
    let message =
        say!("{} has {}, {:04X}h has {}", at, counted(own.into(), "element", "elements"), index, number);
    let finding = Diagnostic::new(rule, at.device.value_place(at.index, 0), message);
    let finding =
        finding.label(at.device.value_place(index, 0), counted(number.into(), "element", "elements"));
    findings.push(finding.help(say!("describe {}", counted(number.into(), "element", "elements"))));
}

/// The number of elements, when sub-index 0 and the description agree about it. That there are none is the matter of
/// another rule.
fn count(object: &Object) -> Option<u8> {
    let number = object.value(0)?.as_integer()?;
    let highest = object.highest_sub()?;
    (number == i128::from(highest) && highest > 0 && !object.orphan).then_some(highest)
}

/// A fix that gives a field the value that the document demands. Somebody should look whether the device is so.
pub(super) fn set(place: Place, field: Field, value: String) -> Fix {
    Fix::risky(say!("write `{}`", Argument::setting(&field, &value))).set(place.field(field), value)
}
