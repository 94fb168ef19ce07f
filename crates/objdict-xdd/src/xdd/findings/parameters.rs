//! The rules about parameters and their allowed values, and about data types that a description defines.

use std::cmp::Ordering;
use std::collections::HashMap;

use super::walk::Walk;
use crate::diagnostic::{Diagnostic, Findings, counted, text_rules};
use crate::literal::Quirks;
use crate::model::{DataType, Reason, SimpleType};
use crate::xdd::{fact, types};
use crate::xml::{Attribute, Element, Name, n};

text_rules! {
    source: "CiA 311 annex A";

    "cia311/value-not-allowed" = VALUE_NOT_ALLOWED, Warning;
    summary: "a parameter has a value outside its allowed values",
    checks: "A parameter's default and actual value must be among its `allowedValues` or the values of their template, if these list values or several ranges. They must also be on a `step` of the range. `cia306/value-outside-limits` checks a single range, which defines the limits of the entry.",
    why: "Tools that offer the allowed values cannot show the actual one; tools that check reject it.",
    example: r#"`<defaultValue value="3"/>` with the allowed values 0, 1 and 2"#,
    remedy: "Add the value to the allowed values, or use a different value.",

    "cia311/invalid-parameter-value" = INVALID_PARAMETER_VALUE, Error;
    summary: "a parameter's value does not match its data type",
    checks: "A parameter's default, actual and allowed values and the ends of its ranges must be values of the data type. This is the data type of the object that refers to the parameter, otherwise the parameter's own. `cia306/invalid-value` checks values that the object takes from the parameter because it has none of its own. Values with an offset or a multiplier are not checked.",
    why: "Tools that follow the parameter reject the file or show and write a different value.",
    example: r#"`<defaultValue value="abc"/>` of a parameter with `<UINT/>`"#,
    remedy: "Write a value of the data type.",

    "cia311/min-above-max" = MIN_ABOVE_MAX, Error;
    summary: "the lower end of a range is above the upper end",
    checks: "If both are numbers, `minValue` of a range must not be greater than `maxValue`. `cia306/low-limit-above-high` checks the single range of a parameter that one entry refers to, which defines the limits of the entry.",
    why: "No value is in the range.",
    example: r#"`<range><minValue value="10"/><maxValue value="1"/></range>`"#,
    remedy: "Swap the values.",

    "cia311/duplicate-property" = DUPLICATE_PROPERTY, Warning;
    summary: "a property is defined twice",
    checks: "All properties of a parameter must have different names.",
    why: "Some tools use the first value, some the last one.",
    example: r#"`<property name="CO_storageGroup" value="RAM"/>` and `<property name="CO_storageGroup" value="ROM"/>`"#,
    remedy: "Keep one of them.",

    "cia311/missing-condition" = MISSING_CONDITION, Note;
    summary: "a parameter has conditional support without a condition",
    checks: r#"A parameter with `support="conditional"` needs `conditionalSupport`."#,
    why: "Tools cannot determine when the device has the parameter.",
    example: r#"`<parameter uniqueID="P" support="conditional">` without `conditionalSupport`"#,
    remedy: "Add `conditionalSupport` with the parameters that it depends on, or write `mandatory` or `optional`.",

    "cia311/ambiguous-member" = AMBIGUOUS_MEMBER, Warning;
    summary: "a member of a variable has both an id and an index, or neither",
    checks: "`memberRef` must have either `uniqueIDRef`, for a member of a struct, or `index`, for an element of an array.",
    why: "The referenced part of the variable is ambiguous.",
    example: "`<memberRef/>`",
    remedy: "Write one of the two attributes.",

    "cia311/duplicate-enum-value" = DUPLICATE_ENUM_VALUE, Warning;
    summary: "two names of an enumeration have the same value",
    checks: "The values of an `enum` must be different; numbers are compared as numbers.",
    why: "Some tools show one name for the value, some the other.",
    example: r#"`<enumValue value="1">` and `<enumValue value="0x01">`"#,
    remedy: "Correct one of the values.",

    "cia311/wrong-enum-size" = WRONG_ENUM_SIZE, Warning;
    summary: "the size of an enumeration is wrong",
    checks: "`size` of an `enum` must be the number of its `enumValue` elements.",
    why: "A value was added or removed without updating the size; a value may be missing.",
    example: r#"`<enum size="2" …>` with three values"#,
    remedy: "Write the right number, or remove `size`.",

    "cia311/empty-subrange" = EMPTY_SUBRANGE, Error;
    summary: "an array has no elements",
    checks: "`lowerLimit` of a `subrange` must not be greater than `upperLimit`.",
    why: "No index is valid.",
    example: r#"`<subrange lowerLimit="8" upperLimit="1"/>`"#,
    remedy: "Swap the limits.",
}

/// All rules of this module.
pub(super) fn check(walk: &mut Walk<'_, '_>) {
    for parameter in walk.seen.of([n::parameter]) {
        condition(parameter, walk.findings);
        let allowed = parameter.child(n::allowedValues);
        if let Some(allowed) = allowed {
            let are_limits = is_single_range(allowed) && walk.ids.belongs_to_entry(parameter);
            if !are_limits {
                ranges(allowed, walk.findings);
            }
            let template = allowed.attribute(n::templateIDRef).and_then(|id| walk.ids.element(id));
            values(parameter, template.unwrap_or(allowed), walk.findings);
        }
        properties(parameter, walk.findings);
    }
    for element in walk.seen.of([n::parameterTemplate]).chain(walk.seen.of([n::varDeclaration])) {
        if let Some(allowed) = element.child(n::allowedValues) {
            ranges(allowed, walk.findings);
            values(element, allowed, walk.findings);
        }
        properties(element, walk.findings);
    }
    let all = walk.seen.of([n::parameter]).chain(walk.seen.of([n::parameterTemplate, n::varDeclaration]));
    for element in all.filter(|element| !walk.ids.belongs_to_entry(*element)) {
        // entries inherit the values of a parameter that they share
        let is_taken = walk.ids.uses(element) > 0;
        if let Some(data_type) = own_type(element) {
            fit(element, data_type, |_| is_taken, walk.findings);
        }
    }
    for template in walk.seen.of([n::allowedValuesTemplate]) {
        ranges(template, walk.findings);
    }
    for member in walk.seen.of([n::memberRef]) {
        member_ref(member, walk.findings);
    }
}

/// The data type of a parameter without an object.
pub(super) fn own_type(parameter: Element<'_>) -> Option<DataType> {
    let simple = parameter.children().find_map(|child| SimpleType::from_name(child.tag().text()))?;
    Some(types::data_type(simple, None)).filter(|_| simple != SimpleType::Bitstring)
}

/// Reports values of a parameter that do not fit the data type, except those that an entry inherits.
pub(super) fn fit(
    parameter: Element<'_>,
    data_type: DataType,
    is_taken: impl Fn(Name) -> bool,
    findings: &mut Findings,
) {
    let allowed = parameter.child(n::allowedValues);
    let range =
        allowed.filter(|allowed| is_single_range(*allowed)).and_then(|allowed| allowed.child(n::range));
    let single = |name, end| (range.and_then(|range| range.child(end)), is_taken(name));
    let own = |name| (parameter.child(name), is_taken(name));
    let stated = [
        own(n::defaultValue),
        own(n::actualValue),
        single(n::lowLimit, n::minValue),
        single(n::highLimit, n::maxValue),
    ];
    let stated = stated.into_iter().filter(|(_, is_taken)| !is_taken).filter_map(|(value, _)| value);
    let others = allowed.filter(|_| range.is_none());
    let values = others.into_iter().flat_map(|allowed| allowed.children_named(n::value));
    let ranges = others.into_iter().flat_map(|allowed| allowed.children_named(n::range));
    let ends = ranges.flat_map(|range| [range.child(n::minValue), range.child(n::maxValue)]).flatten();
    for value in stated.chain(values).chain(ends).filter(|value| !is_scaled(*value)) {
        let Some(attribute) = value.attribute(n::value) else { continue };
        let text = attribute.value();
        let Some(text) = fact::stated_text(&text, Some(data_type)) else { continue };
        let message = match fact::read_value(text, Some(data_type), &mut Quirks::default()) {
            Ok(_) => continue,
            Err(Reason::OutOfRange { low, high }) => {
                format!("`{text}` is out of range for {data_type} ({low} to {high})")
            }
            Err(_) => format!("`{text}` is not a valid {data_type}"),
        };
        let finding = Diagnostic::new(&INVALID_PARAMETER_VALUE, attribute.value_span(), message);
        findings.push(finding.help("write a value of the data type, or correct the data type"));
    }
}

fn is_scaled(value: Element<'_>) -> bool {
    value.attribute(n::offset).is_some() || value.attribute(n::multiplier).is_some()
}

fn is_single_range(allowed: Element<'_>) -> bool {
    let mut children = allowed.children();
    children.next().is_some_and(|child| child.tag() == n::range) && children.next().is_none()
}

fn condition(parameter: Element<'_>, findings: &mut Findings) {
    let Some(support) = parameter.attribute(n::support) else { return };
    // the condition can be in a template
    let has_condition =
        parameter.child(n::conditionalSupport).is_some() || parameter.attribute(n::templateIDRef).is_some();
    if support.value().trim_ascii() == "conditional" && !has_condition {
        let message = "the parameter has conditional support, but no condition";
        let finding = Diagnostic::new(&MISSING_CONDITION, support.value_span(), message);
        findings
            .push(finding.help("add `conditionalSupport` with the ids of the parameters that it depends on"));
    }
}

fn properties(parameter: Element<'_>, findings: &mut Findings) {
    let mut properties =
        parameter.children_named(n::property).filter_map(|property| property.attribute(n::name)).peekable();
    let Some(first) = properties.next() else { return };
    if properties.peek().is_none() {
        return;
    }
    let mut before = HashMap::from([(first.value(), first)]);
    for name in properties {
        if let Some(first) = before.get(&name.value()) {
            let message = format!("the parameter has the property `{}` twice", name.value());
            let finding = Diagnostic::new(&DUPLICATE_PROPERTY, name.value_span(), message);
            findings.push(finding.label(first.value_span(), "first here").help("keep one of the two"));
        } else {
            before.insert(name.value(), name);
        }
    }
}

/// The value of a child without its own scaling.
fn number(element: Element<'_>) -> Option<(Attribute<'_>, Number)> {
    let attribute = element.attribute(n::value).filter(|_| !is_scaled(element))?;
    Some((attribute, Number::parse(&attribute.value())?))
}

fn ends(range: Element<'_>) -> Option<[(Attribute<'_>, Number); 2]> {
    Some([number(range.child(n::minValue)?)?, number(range.child(n::maxValue)?)?])
}

fn ranges(allowed: Element<'_>, findings: &mut Findings) {
    for range in allowed.children_named(n::range) {
        let Some([(low_at, low), (high_at, high)]) = ends(range) else { continue };
        if low.compare(&high) == Some(Ordering::Greater) {
            let message = format!(
                "the lower end `{}` of the range is above the upper end `{}`",
                low_at.value(),
                high_at.value()
            );
            let finding = Diagnostic::new(&MIN_ABOVE_MAX, low_at.value_span(), message);
            findings.push(finding.label(high_at.value_span(), "the upper end").help("swap the values"));
        }
    }
}

fn values(parameter: Element<'_>, allowed: Element<'_>, findings: &mut Findings) {
    if is_single_range(allowed) || allowed.attribute(n::templateIDRef).is_some() {
        return;
    }
    let singles: Option<Vec<Number>> =
        allowed.children_named(n::value).map(|value| number(value).map(|(_, number)| number)).collect();
    let ranges: Option<Vec<_>> = allowed
        .children_named(n::range)
        .map(|range| {
            let step = range.child(n::step).and_then(number).map(|(_, step)| step);
            ends(range).map(|[(_, low), (_, high)]| (low, high, step))
        })
        .collect();
    // a value that cannot be compared may be allowed
    let (Some(singles), Some(ranges)) = (singles, ranges) else { return };
    if singles.is_empty() && ranges.is_empty() {
        return;
    }
    for name in [n::defaultValue, n::actualValue] {
        let Some((attribute, value)) = parameter.child(name).and_then(number) else { continue };
        let orders = singles.iter().chain(ranges.iter().flat_map(|(low, high, _)| [low, high]));
        let mut orders = orders.map(|other| value.compare(other));
        // the hex digits may represent a negative number
        if orders.any(|order| order.is_none()) || is_bits(&attribute.value(), &singles, &ranges) {
            continue;
        }
        let is_between_steps = |low: &Number, step: &Option<Number>| {
            let numbers = (&value, low, step);
            matches!(numbers, (Number::Integer(value), Number::Integer(low), Some(Number::Integer(step @ 1..)))
                if value.wrapping_sub(*low) % step != 0)
        };
        let is_within = |(low, high, step): &(Number, Number, Option<Number>)| {
            value.compare(low) != Some(Ordering::Less)
                && value.compare(high) != Some(Ordering::Greater)
                && !is_between_steps(low, step)
        };
        if !singles.iter().any(|single| single.is_same(&value)) && !ranges.iter().any(is_within) {
            let message =
                format!("`{}` is `{}`, which is not an allowed value", name.text(), attribute.value());
            let finding = Diagnostic::new(&VALUE_NOT_ALLOWED, attribute.value_span(), message);
            let finding = finding.label(allowed.name_span(), "the allowed values");
            findings.push(finding.help("add the value to the allowed values or use a different one"));
        }
    }
}

/// Whether the hex digits may be the bits of a negative number, which cannot be compared.
fn is_bits(text: &str, singles: &[Number], ranges: &[(Number, Number, Option<Number>)]) -> bool {
    let is_negative = |number: &Number| matches!(number, Number::Integer(number) if *number < 0);
    let is_hex = text.trim_ascii_start().to_ascii_lowercase().starts_with("0x");
    is_hex && (singles.iter().any(is_negative) || ranges.iter().any(|(low, ..)| is_negative(low)))
}

fn member_ref(member: Element<'_>, findings: &mut Findings) {
    let (id, index) = (member.attribute(n::uniqueIDRef), member.attribute(n::index));
    let message = match (id, index) {
        (Some(_), Some(_)) => "the member has both an id and an index",
        (None, None) => "the member has neither an id nor an index",
        _ => return,
    };
    let finding = Diagnostic::new(&AMBIGUOUS_MEMBER, member.name_span(), message);
    findings.push(
        finding.help("write `uniqueIDRef` for a member of a struct, `index` for an element of an array"),
    );
}

/// All rules of this module.
pub(super) fn check_types(walk: &mut Walk<'_, '_>) {
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
    // stable sorting keeps equal values adjacent and in file order
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

/// A number in decimal or hex, with or without a fraction, or relative to the node-ID.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Number {
    Integer(i128),
    /// `$NODEID+…`
    OfNode(i128),
    Real(f64),
}

impl Number {
    pub(super) fn parse(text: &str) -> Option<Self> {
        let text = text.trim_ascii();
        if let Some(rest) =
            text.get(..7).filter(|word| word.eq_ignore_ascii_case("$NODEID")).map(|_| &text[7..])
        {
            let rest = rest.trim_ascii_start();
            return match rest.strip_prefix('+') {
                Some(offset) => integer(offset.trim_ascii_start()).map(Self::OfNode),
                None => rest.is_empty().then_some(Self::OfNode(0)),
            };
        }
        let looks_like_number =
            text.starts_with(|first: char| first.is_ascii_digit() || matches!(first, '+' | '-' | '.'));
        let real = || text.parse().ok().filter(|real: &f64| real.is_finite() && looks_like_number);
        integer(text).map(Self::Integer).or_else(|| real().map(Self::Real))
    }

    pub(super) fn is_same(&self, other: &Self) -> bool {
        self.compare(other) == Some(Ordering::Equal)
    }

    /// `None` if the result depends on the node-ID.
    pub(super) fn compare(&self, other: &Self) -> Option<Ordering> {
        match (self, other) {
            (Self::Integer(a), Self::Integer(b)) | (Self::OfNode(a), Self::OfNode(b)) => Some(a.cmp(b)),
            (Self::OfNode(_), _) | (_, Self::OfNode(_)) => None,
            _ => self.as_real().partial_cmp(&other.as_real()),
        }
    }

    fn as_real(&self) -> f64 {
        match *self {
            Self::Integer(number) | Self::OfNode(number) => number as f64,
            Self::Real(number) => number,
        }
    }
}

fn integer(text: &str) -> Option<i128> {
    let (is_negative, digits) = match text.strip_prefix('-') {
        Some(digits) => (true, digits),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    };
    let number = match digits.strip_prefix("0x").or_else(|| digits.strip_prefix("0X")) {
        Some(hex) if hex.bytes().all(|byte| byte.is_ascii_hexdigit()) => {
            i128::from_str_radix(hex, 16).ok()?
        }
        None if !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit()) => {
            digits.parse().ok()?
        }
        _ => return None,
    };
    Some(if is_negative { -number } else { number })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn is_same(a: &str, b: &str) -> bool {
        Number::parse(a).unwrap_or(Number::Real(0.5)).is_same(&Number::parse(b).unwrap_or(Number::Real(0.25)))
    }

    #[test]
    fn spellings_of_a_number_are_the_same() {
        assert!(
            is_same("0x10", "16") && is_same("1.0", "1") && is_same("-0x1", "-1") && is_same("0X0a", "+10")
        );
        assert!(is_same("$NODEID+0x180", "$NodeId + 384") && is_same("$NODEID", "$NODEID+0"));
        assert!(!is_same("$NODEID+0x180", "0x180") && !is_same("1", "2") && !is_same("1.5", "1"));
        for text in ["", "-", "0x", "inf", "NaN", "abc", "$NODEID+x", "12 34", "é"] {
            assert_eq!(Number::parse(text), None, "{text}");
        }
    }
}
