//! Named values.

use super::number;
use crate::model::{AllowedValues, DataType, EnumValue, Labels, TypeDefinition, TypeKind};

/// The named values of an entry.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Enumeration<'a> {
    /// The type that defines them; `None` if they are the allowed values of the entry.
    pub definition: Option<&'a TypeDefinition>,
    /// The data type of the values: BOOLEAN, INTEGERn or UNSIGNEDn.
    pub data_type: DataType,
    /// The values, in the order of the description; numbers may be repeated.
    pub values: Vec<NamedValue<'a>>,
    /// Texts that are not valid values: lower case, offending text in backticks, no full stop.
    pub defects: Vec<String>,
}

/// A value with its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NamedValue<'a> {
    /// The name, in the requested language if available; empty without one.
    pub name: &'a str,
    /// The value, within the range of the data type.
    pub number: i128,
}

impl<'a> Enumeration<'a> {
    /// The values of a type. A value without a number is the previous number plus one.
    pub(super) fn of_type(
        definition: &'a TypeDefinition,
        values: &'a [EnumValue],
        data_type: DataType,
        language: &str,
    ) -> Self {
        let mut found = Self { definition: Some(definition), ..Self::empty(data_type) };
        let mut next = Some(0);
        for value in values {
            let stated = value.value.as_deref();
            let number = stated.map_or(next, number);
            found.put(name_in(&value.labels, language), number, stated);
            next = number.map(|number| number + 1);
        }
        found
    }

    /// The single allowed values of an entry, if at least one has a name.
    pub(super) fn of_allowed(
        allowed: &'a AllowedValues,
        data_type: DataType,
        language: &str,
    ) -> Option<Self> {
        if allowed.values.iter().all(|value| name_in(&value.labels, language).is_empty()) {
            return None;
        }
        let mut found = Self::empty(data_type);
        for value in &allowed.values {
            found.put(name_in(&value.labels, language), number(&value.value), Some(&value.value));
        }
        Some(found)
    }

    fn empty(data_type: DataType) -> Self {
        let defects = match data_type.integer_range() {
            Some(_) => Vec::new(),
            None => vec![format!("values of {data_type} are not numbers and cannot have names")],
        };
        Self { definition: None, data_type, values: Vec::new(), defects }
    }

    fn put(&mut self, name: &'a str, number: Option<i128>, stated: Option<&str>) {
        let Some((low, high)) = self.data_type.integer_range() else { return };
        let number = number.map(|number| match self.data_type.kind() {
            // hex digits of two's complement
            TypeKind::Signed(bits) if is_hex(stated) && number > high && number < 1 << bits => {
                number - (1 << bits)
            }
            _ => number,
        });
        match number.filter(|number| (low..=high).contains(number)) {
            Some(number) => self.values.push(NamedValue { name, number }),
            None => {
                let text = stated
                    .map_or_else(|| number.map(|number| number.to_string()), |text| Some(text.to_owned()));
                let text = text.unwrap_or_default();
                self.defects.push(format!("`{text}` of `{name}` is not a valid {}", self.data_type));
            }
        }
    }
}

fn is_hex(stated: Option<&str>) -> bool {
    stated.is_some_and(|text| text.trim_ascii().starts_with("0x") || text.trim_ascii().starts_with("0X"))
}

/// The name from labels.
pub(super) fn name_in<'a>(labels: &'a Labels, language: &str) -> &'a str {
    labels.name_in(language).unwrap_or_default().trim_ascii()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::ScaledValue;

    #[test]
    fn a_value_without_number_is_one_more_than_the_one_before() {
        let value = |name: &str, number: Option<&str>| EnumValue {
            labels: Labels::name("en", name),
            value: number.map(Into::into),
        };
        let values = [
            value("a", None),
            value("b", Some("0x7F")),
            value("c", None),
            value("d", Some("?")),
            value("e", None),
        ];
        let definition = TypeDefinition::default();
        let found = Enumeration::of_type(&definition, &values, DataType::INTEGER8, "en");
        let numbers: Vec<_> = found.values.iter().map(|value| (value.name, value.number)).collect();
        assert_eq!(numbers, [("a", 0), ("b", 127)]);
        assert_eq!(
            found.defects,
            [
                "`128` of `c` is not a valid INTEGER8",
                "`?` of `d` is not a valid INTEGER8",
                "`` of `e` is not a valid INTEGER8"
            ]
        );
    }

    #[test]
    fn single_values_need_a_name_and_hex_may_be_negative() {
        let value = |name: &str, number: &str| ScaledValue {
            value: number.into(),
            labels: if name.is_empty() { Labels::default() } else { Labels::name("en", name) },
            ..ScaledValue::default()
        };
        let allowed =
            |values: &[ScaledValue]| AllowedValues { values: values.to_vec(), ..AllowedValues::default() };
        let plain = allowed(&[value("", "1"), value("", "2")]);
        assert_eq!(Enumeration::of_allowed(&plain, DataType::UNSIGNED8, "en"), None);
        let named = allowed(&[value("off", "0xFF"), value("", "2")]);
        let found = Enumeration::of_allowed(&named, DataType::INTEGER8, "en").unwrap();
        assert_eq!(found.values.iter().map(|value| value.number).collect::<Vec<_>>(), [-1, 2]);
        let found = Enumeration::of_allowed(&named, DataType::VISIBLE_STRING, "en").unwrap();
        assert_eq!((found.values.len(), found.defects.len()), (0, 1));
    }
}
