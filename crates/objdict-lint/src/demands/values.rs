//! Values, compared with a document.

use super::Expected;
use super::entries::is_other_object;
use super::objects::set;
use crate::diagnostic::{Argument, Diagnostic, Findings, RuleInfo, say, series_or};
use crate::model::{Field, Value};
use crate::stated;

/// Reports a value that the document does not allow. Sub-index 0 has its own rule.
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
        (low, high) => say!("from {} to {}", low, high),
    });
    let message = say!("{} does not allow {:h} for {}", at.document(), number, at);
    let finding = Diagnostic::new(rule, at.place().field(at.value_field()), message);
    let is_range = at.facts.values.iter().any(|range| range.start() != range.end());
    findings.push(finding.help(match is_range {
        true => say!("write a value {}", series_or(ranges)),
        false => say!("write {}", series_or(ranges)),
    }));
}

/// Reports a different default.
pub(crate) fn wrong_default(rule: &'static RuleInfo, at: &Expected<'_>, findings: &mut Findings) {
    let (Some(expected), Some(found)) = (at.facts.default, &at.entry.default) else { return };
    // another rule reports a value that the document does not allow
    let is_allowed = found.as_integer().is_none_or(|number| at.facts.accepts_value(number));
    if at.counts() || is_equal(expected, found) || !is_allowed || is_other_object(at) {
        return;
    }
    let Some(text) = text(expected) else { return };
    let found = self::text(found).unwrap_or_else(|| found.to_string());
    let message = match found.as_str() {
        "" => say!("the default of {} is empty; {} defines `{!}`", at, at.document(), text),
        found => say!("the default of {} is `{}`; {} defines `{!}`", at, found, at.document(), text),
    };
    let finding = Diagnostic::new(rule, at.place().field(Field::DefaultValue), message);
    let finding = finding.help(say!("write `{}`", Argument::setting(Field::DefaultValue, &text)));
    findings.push(finding.fix(set(at.place(), Field::DefaultValue, text)));
}

/// Whether two values are the same number or string, independent of their types.
fn is_equal(left: &Value, right: &Value) -> bool {
    match (left, right) {
        (Value::NodeId(left), Value::NodeId(right)) => left == right,
        (Value::Text(left), Value::Text(right)) => left == right,
        _ => left.as_real() == right.as_real(),
    }
}

/// A value in the spelling of CiA 306-1; `None` for types without a default in any document.
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
