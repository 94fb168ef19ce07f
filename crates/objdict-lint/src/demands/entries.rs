//! Entries beside what a document says of them.

use super::objects::set;
use super::{Against, Expected};
use crate::diagnostic::{Argument, Diagnostic, Findings, RuleInfo, joined, say, series};
use crate::model::{Access, DataType, Field, TypeKind, Value};
use crate::profile::Mapping;
use crate::{stated, with_others};

/// The data type is another one. Sub-index 0 is the matter of a rule of its own.
pub(crate) fn wrong_data_type(rule: &'static RuleInfo, at: &Expected<'_>, findings: &mut Findings) {
    let wrong = at.entry.data_type.filter(|&data_type| !at.counts() && !at.facts.accepts_type(data_type));
    // a type that does not exist, or that no entry can have, is reported as that
    let exists = |data_type: &DataType| match data_type.kind() {
        TypeKind::Reserved | TypeKind::Structure => false,
        TypeKind::Defined => at.against.device.objects.contains_key(&data_type.0),
        _ => true,
    };
    let Some(data_type) = wrong.filter(exists) else { return };
    let types = joined(at.facts.data_types, " or ");
    let document = at.document();
    let message = say!("`{}` as data type of {}, {} makes it {}", data_type, at, document, types);
    let finding = Diagnostic::new(rule, at.place().field(Field::DataType), message);
    let code = format!("0x{:04X}", at.facts.data_types.first().map_or(0, |data_type| data_type.0));
    let finding = finding.help(say!("write `{}`", Argument::setting(Field::DataType, &code)));
    findings.push(finding.fix(set(at.place(), Field::DataType, code)));
}

/// The access type is another one.
pub(crate) fn wrong_access(rule: &'static RuleInfo, at: &Expected<'_>, findings: &mut Findings) {
    let wrong = at.entry.access.filter(|&access| !at.facts.accepts_access(access));
    // what a compactly stored object says of all its sub-indexes may be meant for sub-index 0
    let for_sub_0 = |access: &Access| {
        let facts = at.against.facts.entry(0);
        at.sub.is_none()
            && at.against.object.compact.is_some()
            && facts.is_some_and(|facts| facts.accepts_access(*access))
    };
    let Some(access) = wrong.filter(|access| !for_sub_0(access)) else { return };
    let allowed = joined(at.facts.access.iter().map(|access| say!("`{}`", access)), " or ");
    let document = at.document();
    let message = say!("`{}` as access type of {}, {} makes it {}", access, at, document, allowed);
    let finding = Diagnostic::new(rule, at.place().field(Field::AccessType), message);
    let first = at.facts.access.first().map_or("ro", |access| access.name());
    let finding = finding.help(say!("write `{}`", Argument::setting(Field::AccessType, first)));
    findings.push(finding.fix(set(at.place(), Field::AccessType, first.to_owned())));
}

/// Entries are marked as mappable that no PDO may carry, or not where a PDO has to be able to carry them.
pub(crate) fn wrong_mapping(rule: &'static RuleInfo, at: &Against<'_>, findings: &mut Findings) {
    let marked = at.entries().filter(|at| at.entry.is_mappable() && at.facts.mapping == Some(Mapping::No));
    // sub-index 0 of an ARRAY or RECORD does no harm, nobody maps it;
    let marked = marked.filter(|at| !at.counts());
    // constants and texts are never mappable, which is a rule of its own
    let marked = marked.filter(|at| {
        let length = at.entry.data_type.and_then(DataType::bit_length);
        at.entry.access != Some(Access::Const) && length.is_some()
    });
    let mut places = marked.map(|at| at.place().field(Field::PdoMapping)).peekable();
    let Some(first) = places.next() else { return };
    let others: Vec<_> = places.collect();
    let message = say!("{} is marked as mappable, {} lets no PDO carry it", at, at.applied.document());
    let mut fix = crate::diagnostic::Fix::risky(say!("write `{PDOMapping=0}`")).set(first.clone(), "0");
    for place in &others {
        fix = fix.set(place.clone(), "0");
    }
    let finding = Diagnostic::new(rule, first, message).help(say!("write `{PDOMapping=0}`")).fix(fix);
    findings.push(with_others(finding, others.into_iter().map(|place| (place, "here too"))));
}

/// The value is one that the document does not allow. Sub-index 0 is the matter of a rule of its own.
pub(crate) fn wrong_value(rule: &'static RuleInfo, at: &Expected<'_>, findings: &mut Findings) {
    let Some(value) = at.entry.value().filter(|_| !at.counts() && !at.facts.values.is_empty()) else {
        return;
    };
    let [node_id, _] = stated::node_ids(at.against.device);
    let Some(number) = value.integer_for(node_id).filter(|&number| !at.facts.accepts_value(number)) else {
        return;
    };
    let ranges = at.facts.values.iter().map(|range| match (range.start(), range.end()) {
        (low, high) if low == high => say!("{}", low),
        (low, high) => say!("{} to {}", low, high),
    });
    let message = say!("`{}` as value of {}, {} allows {}", number, at, at.document(), series(ranges));
    findings.push(Diagnostic::new(rule, at.place().field(at.value_field()), message));
}

/// The default is another one.
pub(crate) fn wrong_default(rule: &'static RuleInfo, at: &Expected<'_>, findings: &mut Findings) {
    let (Some(expected), Some(found)) = (at.facts.default, &at.entry.default) else { return };
    // a value that is not even allowed is reported as that
    let is_allowed = found.as_integer().is_none_or(|number| at.facts.accepts_value(number));
    if at.counts() || is_equal(expected, found) || !is_allowed {
        return;
    }
    let Some(text) = text(expected) else { return };
    let found = super::entries::text(found).unwrap_or_default();
    let message = say!("`{}` as default of {}, {} has `{}`", found, at, at.document(), text);
    let finding = Diagnostic::new(rule, at.place().field(Field::DefaultValue), message);
    let finding = finding.help(say!("write `{}`", Argument::setting(Field::DefaultValue, &text)));
    findings.push(finding.fix(set(at.place(), Field::DefaultValue, text)));
}

/// Whether two values are the same number or text, whatever their types.
fn is_equal(left: &Value, right: &Value) -> bool {
    match (left, right) {
        (Value::NodeId(left), Value::NodeId(right)) => left == right,
        (Value::Text(left), Value::Text(right)) => left == right,
        _ => left.as_real() == right.as_real(),
    }
}

/// A value in the spelling of CiA 306-1; `None` for what no document has as default.
fn text(value: &Value) -> Option<String> {
    Some(match value {
        Value::NodeId(offset) => format!("$NODEID+0x{offset:X}"),
        Value::Text(text) => text.to_string(),
        Value::Unsigned(number) if *number > 9 => format!("0x{number:X}"),
        value => value
            .as_integer()
            .map(|number| number.to_string())
            .or(value.as_real().map(|real| real.to_string()))?,
    })
}
