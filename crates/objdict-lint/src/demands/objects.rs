//! Objects, compared with a document.

use super::Against;
use crate::diagnostic::{Argument, Diagnostic, Findings, Fix, RuleInfo, Severity, say};
use crate::model::{DataType, Field, ObjectType, Place};

/// Reports a different object type.
pub(crate) fn wrong_object_type(rule: &'static RuleInfo, at: &Against<'_>, findings: &mut Findings) {
    let (object, index) = (at.object, at.index);
    let (expected, found) = (at.facts.object_type(), object.object_type());
    let is_right = object.orphan || !at.facts.states_type() || found == expected || found == ObjectType::Null;
    if is_right || type_is_reported_elsewhere(at) {
        return;
    }
    let message = say!("{} has object type {}; {} requires {!}", at, found, at.applied.document(), expected);
    let finding = Diagnostic::new(rule, Place::object(index).field(Field::ObjectType), message);
    let setting = Argument::setting(Field::ObjectType, format_args!("0x{:X}", expected.code()));
    let finding = finding.help(match (found.has_subs(), expected.has_subs()) {
        (true, false) => say!("describe a single value, with `{}` and without sub-indexes", setting),
        (false, true) if object.compact.is_none() => {
            say!("describe the sub-indexes, and write `{}`", setting)
        }
        _ => say!("write `{}`", setting),
    });
    let harmless = at.facts.object_types.contains(&found);
    findings.push(if harmless { finding.severity(Severity::Warning) } else { finding });
}

/// Whether another rule reports the object type: it is missing, or the object is a VAR with sub-indexes or
/// of type DOMAIN.
fn type_is_reported_elsewhere(at: &Against<'_>) -> bool {
    let object = at.object;
    let is_var = object.object_type() == ObjectType::Var;
    let is_domain = object.main.data_type == Some(DataType::DOMAIN);
    object.main.invalid_values.get(&Field::ObjectType).is_some()
        || (is_var && (!object.subs.is_empty() || is_domain))
}

/// Reports sub-indexes that the document does not define. Any sub-index is allowed if the document defines
/// none, or if it does not state the object type because it only extends another document.
pub(crate) fn undefined_sub_index(rule: &'static RuleInfo, at: &Against<'_>, findings: &mut Findings) {
    // another rule reports a VAR with sub-indexes
    let is_whole = at.facts.states_type() && at.facts.entries().len() > 0;
    if !at.has_its_shape() || !at.object.object_type().has_subs() || !is_whole {
        return;
    }
    let highest = at.facts.highest_sub();
    let undefined = at.object.subs.iter().filter(|&(sub, _)| sub != 0xFF && at.facts.entry(sub).is_none());
    for (sub, _) in undefined {
        let message = say!(
            "{} does not define sub-index {} of {}; the highest is {}",
            at.applied.document(),
            sub,
            at,
            highest
        );
        let finding = Diagnostic::new(rule, Place::entry(at.index, sub), message);
        findings.push(finding.help("move vendor-specific entries to 2000h to 5FFFh"));
    }
    if let Some(compact) = at.object.compact.as_ref().filter(|compact| compact.count > highest) {
        let message = say!(
            "`{CompactSubObj}` gives {} {} sub-indexes; {} defines {!}",
            at,
            compact.count,
            at.applied.document(),
            highest
        );
        let place = Place::object(at.index).field(Field::CompactSubObj);
        findings.push(Diagnostic::new(rule, place, message).help(say!("write at most {}", highest)));
    }
}

/// Reports a highest sub-index that the document does not allow.
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
    let document = at.applied.document();
    let message = match range {
        (low, high) if low == high => {
            say!("the highest sub-index of {} is `{}`; {} requires {!}", at, value, document, low)
        }
        (low, high) => {
            say!(
                "the highest sub-index of {} is `{}`; {} requires {!} to {!}",
                at,
                value,
                document,
                low,
                high
            )
        }
    };
    let finding = Diagnostic::new(rule, at.device.value_place(at.index, 0), message);
    findings.push(match range {
        (low, high) if low == high && at.object.compact.is_some() => {
            finding.help(say!("write `{}`", Argument::setting(Field::CompactSubObj, low)))
        }
        _ => finding.help("describe the object's entries, or remove the object"),
    });
}

/// Whether another rule reports the object: too many or too few sub-indexes, or a wrong sub-index 0.
fn sub_0_is_reported_elsewhere(at: &Against<'_>, value: i128) -> bool {
    let (object, facts) = (at.object, at.facts);
    let highest = object.highest_sub().unwrap_or(0);
    let differs = value != i128::from(highest)
        && object.subs.get(0).and_then(|entry| entry.access).is_some_and(|access| !access.is_writable());
    let has_rule = matches!(facts.first, 0x1018 | 0x1200..=0x12FF | 0x1400..=0x19FF | 0x1F00..=0x1F9F);
    let missing = facts.entries().any(|entry| entry.is_mandatory() && !object.has(entry.first));
    // compact storage cannot describe an entry for all nodes with a different access type
    let is_whole = highest > 1
        && object.compact.is_some()
        && matches!((facts.entry(highest), facts.entry(highest + 1)), (Some(last), Some(next)) if last.first != next.first);
    differs || highest > facts.highest_sub() || (has_rule && missing) || is_whole
}

/// A fix that writes the value that the document requires. It may not match the device, so the user must
/// check it.
pub(super) fn set(place: Place, field: Field, value: String) -> Fix {
    Fix::risky(say!("write `{}`", Argument::setting(&field, &value))).set(place.field(field), value)
}
