//! The rules about the data types that a description defines.

use crate::diagnostic::{Diagnostic, Findings, counted, text_rules};
use crate::xml::{Attribute, Element, Name, n};

use super::number::Number;
use super::walk::Walk;

text_rules! {
    /// two names of an enumeration have the same value
    ///
    /// ## What it checks
    /// Whether the values of an `enum` differ; numbers are compared as numbers.
    ///
    /// ## Why it matters
    /// Tools show one name or the other for the value.
    ///
    /// ## Example
    /// `<enumValue value="1">` and `<enumValue value="0x01">`
    ///
    /// ## How to mend
    /// Correct one of the values.
    ///
    /// ## Source
    /// CiA 311 annex A
    DUPLICATE_ENUM_VALUE = "cia311/duplicate-enum-value", Warning;

    /// an enumeration has another number of values than it says
    ///
    /// ## What it checks
    /// Whether `size` of an `enum` is the number of its `enumValue`.
    ///
    /// ## Why it matters
    /// A value was added or removed without counting; perhaps one got lost.
    ///
    /// ## Example
    /// `<enum size="2" …>` with three values
    ///
    /// ## How to mend
    /// Write the right number, or leave out `size`.
    ///
    /// ## Source
    /// CiA 311 annex A
    WRONG_ENUM_SIZE = "cia311/wrong-enum-size", Warning;

    /// an array has no elements
    ///
    /// ## What it checks
    /// Whether `lowerLimit` of a `subrange` is not greater than `upperLimit`.
    ///
    /// ## Why it matters
    /// There is no index that fits.
    ///
    /// ## Example
    /// `<subrange lowerLimit="8" upperLimit="1"/>`
    ///
    /// ## How to mend
    /// Exchange the two.
    ///
    /// ## Source
    /// CiA 311 annex A
    EMPTY_SUBRANGE = "cia311/empty-subrange", Error;
}

/// All rules of this module.
pub(super) fn check(walk: &mut Walk<'_, '_>) {
    for data_type in walk.seen.data_types() {
        match data_type.tag() {
            n::r#enum => enumeration(data_type, walk.findings),
            n::array => array(data_type, walk.findings),
            _ => {}
        }
    }
}

fn enumeration(data_type: Element<'_>, findings: &mut Findings) {
    let mut count = 0;
    let mut values: Vec<(Attribute<'_>, Number)> = Vec::new();
    for value in data_type.children_named(n::enumValue) {
        count += 1;
        let Some(attribute) = value.attribute(n::value) else { continue };
        let Some(Number::Integer(number)) = Number::parse(&attribute.value()) else { continue };
        values.push((attribute, Number::Integer(number)));
    }
    // equal ones side by side, in the order of the file
    values.sort_by(|(_, a), (_, b)| a.compare(b).unwrap_or(std::cmp::Ordering::Equal));
    for pair in values.windows(2) {
        let [(first, a), (second, b)] = pair else { continue };
        if a.is_same(b) {
            let message = format!("the enumeration has the value `{}` twice", second.value());
            let finding = Diagnostic::new(&DUPLICATE_ENUM_VALUE, second.value_span(), message);
            findings.push(finding.label(first.value_span(), "also here").help("correct one of the two"));
        }
    }
    let Some(size) = data_type.attribute(n::size) else { return };
    let Some(Number::Integer(stated)) = Number::parse(&size.value()) else { return };
    if stated != count {
        let there = counted(usize::try_from(count).unwrap_or_default(), "value", "values");
        let message = format!("the enumeration has {there}, not `{}`", size.value());
        let finding = Diagnostic::new(&WRONG_ENUM_SIZE, size.value_span(), message);
        findings.push(finding.help(format!("write `{count}`, or leave out `size`")));
    }
}

fn array(data_type: Element<'_>, findings: &mut Findings) {
    for range in data_type.children_named(n::subrange) {
        let number = |name: Name| {
            let attribute = range.attribute(name)?;
            Some((attribute, attribute.value().trim_ascii().parse::<i64>().ok()?))
        };
        let (Some((low_at, low)), Some((high_at, high))) = (number(n::lowerLimit), number(n::upperLimit))
        else {
            continue;
        };
        if low > high {
            let message = format!("the indexes start at {low} and end at {high}");
            let finding = Diagnostic::new(&EMPTY_SUBRANGE, low_at.value_span(), message);
            findings.push(finding.label(high_at.value_span(), "the upper limit").help("exchange the two"));
        }
    }
}
