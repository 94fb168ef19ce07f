//! Values that an EDS has too, between attributes and the fields of a part.

use super::{AttributePlace, Shape};
use crate::diagnostic::Findings;
use crate::xdd::defaults::Placeholders;
use crate::xdd::element::SchemaAttribute;
use crate::xdd::fact::{PlacedText, SharedFields};
use crate::xml::{Name, n};

/// Passes a string to the field of the named attribute; `false` if there is none.
pub(crate) fn take<P: SharedFields>(
    part: &mut P,
    shape: &'static Shape<P>,
    name: Name,
    text: &PlacedText<'_>,
    placeholders: Placeholders,
    findings: &mut Findings,
) -> bool {
    let known = shape.attribute(name).map(|(number, known)| (known, &shape.values[number]));
    known.is_some_and(|(known, at)| take_at(part, known, at, text, placeholders, findings))
}

/// Passes a string to the field of an attribute; `false` if it has none.
pub(crate) fn take_at<P: SharedFields>(
    part: &mut P,
    known: &SchemaAttribute,
    at: &AttributePlace<P>,
    text: &PlacedText<'_>,
    placeholders: Placeholders,
    findings: &mut Findings,
) -> bool {
    let AttributePlace::Fact(field) = at else { return false };
    let is_placeholder = |nothing| text.text == nothing || text.trimmed() == nothing;
    let is_unstated = placeholders.are_dropped() && known.unstated.is_some_and(is_placeholder);
    if !is_unstated
        && let Some(fact) = (field.get_mut)(part)
        && let Err(reason) = fact.take(text, known, findings)
        && let Some(field) = known.field()
    {
        part.invalid_values_mut().push(field, &text.text, reason);
    }
    true
}

/// The string of an attribute with a field: its value, otherwise the invalid string.
pub(crate) fn text<P: SharedFields>(
    part: &P,
    known: &SchemaAttribute,
    at: &AttributePlace<P>,
) -> Option<String> {
    let AttributePlace::Fact(field) = at else { return None };
    let value = || (field.get)(part).and_then(|fact| fact.text(known));
    let invalid = || Some(part.invalid_values().get(&known.field()?)?.text.to_string());
    match known.name {
        // the revision of an EDS and the data type of the parameter can be set in addition to an invalid
        // string
        n::fileVersion | n::dataType => invalid().or_else(value),
        _ => value().or_else(invalid),
    }
}

/// The attributes of an element that have fields, in order; a required one without a value gets its
/// placeholder.
pub(crate) fn texts<P: SharedFields>(
    part: &P,
    shape: &'static Shape<P>,
    is_demanded: bool,
) -> Vec<(Name, String)> {
    let attributes = shape.attributes.iter().zip(shape.values);
    let text_of = |(known, at): (&SchemaAttribute, &AttributePlace<P>)| {
        let unstated = || known.unstated.filter(|_| is_demanded).map(str::to_owned);
        Some((known.name, text(part, known, at).or_else(unstated)?))
    };
    attributes.filter_map(text_of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Field, FileInfo, Reason};
    use crate::xdd::schema::container::DEVICE_BODY;

    #[test]
    fn a_version_that_is_none_is_written_as_it_is() {
        let mut info = FileInfo { file_revision: Some(0), ..FileInfo::default() };
        let version =
            |info: &FileInfo| texts(info, &DEVICE_BODY, false).into_iter().next().map(|(_, text)| text);
        assert_eq!(version(&info).as_deref(), Some(".0"));
        info.invalid_values.push(Field::FileVersion, "3.0", Reason::NotANumber);
        assert_eq!(version(&info).as_deref(), Some("3.0"));
    }
}
