//! The rules about the data types that a description defines.

use crate::diagnostic::{Diagnostic, Findings, counted, text_rules};
use crate::xml::{Attribute, Element, Name, n};

use super::number::Number;
use super::walk::Walk;

text_rules! {
    source: "CiA 311 annex A";

    "cia311/duplicate-enum-value" = DUPLICATE_ENUM_VALUE, Warning;
    summary: "two names of an enumeration have the same value",
    checks: "Whether the values of an `enum` are different; numbers are compared as numbers.",
    why: "Some tools show one name for the value, some the other.",
    example: r#"`<enumValue value="1">` and `<enumValue value="0x01">`"#,
    remedy: "Correct one of the values.",

    "cia311/wrong-enum-size" = WRONG_ENUM_SIZE, Warning;
    summary: "the size of an enumeration is wrong",
    checks: "Whether `size` of an `enum` is the number of its `enumValue` elements.",
    why: "A value was added or removed without updating the size; a value may be missing.",
    example: r#"`<enum size="2" …>` with three values"#,
    remedy: "Write the right number, or remove `size`.",

    "cia311/empty-subrange" = EMPTY_SUBRANGE, Error;
    summary: "an array has no elements",
    checks: "Whether `lowerLimit` of a `subrange` is not greater than `upperLimit`.",
    why: "No index is valid.",
    example: r#"`<subrange lowerLimit="8" upperLimit="1"/>`"#,
    remedy: "Swap the limits.",
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
    // sorting puts equal values side by side, in the order of the file
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
        let message = format!("the enumeration has {there}, but `size` is `{}`", size.value());
        let finding = Diagnostic::new(&WRONG_ENUM_SIZE, size.value_span(), message);
        findings.push(finding.help(format!("write `{count}` or remove `size`")));
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
            let message = format!("the lower limit {low} is above the upper limit {high}");
            let finding = Diagnostic::new(&EMPTY_SUBRANGE, low_at.value_span(), message);
            findings.push(finding.label(high_at.value_span(), "the upper limit").help("swap the limits"));
        }
    }
}
