//! Filters of the engine whose results can be far larger than what they are made of, with a limit. Steps do not count what one
//! filter does.

use minijinja::value::{Rest, ValueKind, ValueOrKwargs};
use minijinja::{Environment, Error, State, Value, filters};

use super::LONGEST;
use super::filters::wrong;

/// How many bytes a filter makes of its arguments at the most, of which the first is what it is applied to.
type Bound = fn(&[Value]) -> usize;

pub(super) fn add(environment: &mut Environment<'_>) {
    let bounded: [(&str, Value, Bound); 6] = [
        ("batch", Value::from_function(filters::batch), rows),
        ("format", Value::from_function(filters::format), formatted),
        ("indent", Value::from_function(filters::indent), indented),
        ("join", Value::from_function(filters::join), joined),
        ("replace", Value::from_function(filters::replace), replaced),
        ("slice", Value::from_function(filters::slice), rows),
    ];
    for (name, filter, bound) in bounded {
        let limited =
            move |state: &mut State<'_, '_>, arguments: Rest<ValueOrKwargs>| -> Result<Value, Error> {
                let arguments: Vec<Value> = arguments.0.into_iter().map(Value::from).collect();
                if bound(&arguments) > LONGEST {
                    return Err(wrong(format!("`{name}` would make more than {LONGEST} bytes")));
                }
                filter.call(state, &arguments)
            };
        environment.add_filter(name, limited);
    }
}

fn text(value: Option<&Value>) -> &str {
    value.and_then(Value::as_str).unwrap_or_default()
}

fn length(value: &Value) -> usize {
    value.as_str().map_or(32, str::len)
}

/// The largest number among arguments, named ones too.
fn largest(arguments: &[Value]) -> usize {
    let of = |value: &Value| value.as_usize().unwrap_or_default();
    let named = |value: &Value| {
        let keys = value.try_iter().into_iter().flatten();
        keys.filter_map(|key| value.get_item(&key).ok()).map(|value| of(&value)).max().unwrap_or_default()
    };
    let largest = |value: &Value| if value.kind() == ValueKind::Map { named(value) } else { of(value) };
    arguments.iter().skip(1).map(largest).max().unwrap_or_default()
}

fn rows(arguments: &[Value]) -> usize {
    largest(arguments).saturating_mul(size_of::<Value>())
}

/// Each field of the format can have each argument, and the widths that the format or an argument says.
fn formatted(arguments: &[Value]) -> usize {
    let format = text(arguments.first());
    let widths =
        format.split(|character: char| !character.is_ascii_digit()).filter(|width| !width.is_empty());
    let widths = widths.map(|width| width.parse().unwrap_or(usize::MAX)).fold(0, usize::saturating_add);
    let stated = if format.contains('*') { largest(arguments) } else { 0 };
    let given = arguments.iter().skip(1).map(length).fold(stated, usize::saturating_add);
    format.matches('%').count().saturating_mul(given).saturating_add(widths)
}

fn indented(arguments: &[Value]) -> usize {
    (text(arguments.first()).lines().count() + 1).saturating_mul(largest(arguments))
}

fn joined(arguments: &[Value]) -> usize {
    let between = text(arguments.get(1)).len();
    let items = arguments.first().and_then(|list| list.try_iter().ok());
    items.into_iter().flatten().map(|item| length(&item) + between).fold(0, usize::saturating_add)
}

fn replaced(arguments: &[Value]) -> usize {
    let (text, from, to) = (text(arguments.first()), text(arguments.get(1)), text(arguments.get(2)));
    text.matches(from).count().saturating_mul(to.len())
}
