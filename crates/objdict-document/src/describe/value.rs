//! Values formatted for reading.

use crate::model::{DataType, Entry, Field, Value};

/// Formats the values of an entry: depends on its index and on the node-ID for formulas.
#[derive(Clone, Copy, Debug)]
pub struct ValueReader {
    /// The index of the object.
    pub index: u16,
    /// The node-ID, 1 to 127; without it formulas are not evaluated.
    pub node_id: Option<u8>,
}

impl ValueReader {
    /// A value in a table: for the node, if known.
    pub fn short(self, value: Option<&Value>, data_type: Option<DataType>) -> String {
        let Some(value) = value else { return String::new() };
        self.text(&self.resolve(value, data_type), data_type)
    }

    /// The value of a field in a table; an invalid value is in backticks.
    pub fn field(self, entry: &Entry, field: &Field, value: Option<&Value>) -> String {
        match (value, entry.invalid_values.iter().find(|invalid| invalid.field == *field)) {
            (None, Some(invalid)) => format!("`{}`?", invalid.text),
            _ => self.short(value, entry.data_type),
        }
    }

    /// The value for the node. A formula remains one if the node-ID is unknown or the result does not fit.
    pub fn resolve(self, value: &Value, data_type: Option<DataType>) -> Value {
        let resolved =
            self.node_id.zip(data_type).and_then(|(node, data_type)| value.resolve(data_type, node));
        resolved.unwrap_or_else(|| value.clone())
    }

    /// A value in full: a formula and its result, numbers in decimal and hex.
    pub fn long(self, value: &Value, data_type: Option<DataType>) -> String {
        let resolved = self.resolve(value, data_type);
        match (value, self.node_id) {
            (Value::NodeId(_), Some(node)) if resolved != *value => {
                format!("{value}, on node {node}: {}", both(&resolved))
            }
            (Value::NodeId(_), Some(node)) => format!("{value}, which does not fit on node {node}"),
            _ => both(&resolved),
        }
    }

    /// The bytes of an SDO transfer in hex, with a separator.
    pub fn bytes(self, value: &Value, data_type: Option<DataType>, between: &str) -> Option<String> {
        let bytes = self.resolve(value, data_type).to_bytes(data_type?)?;
        let digits: Vec<String> = bytes.iter().map(|byte| format!("{byte:02X}")).collect();
        Some(digits.join(between))
    }

    /// UNSIGNED32 in the communication area is mostly identifiers, COB-IDs and mappings, which are easier to
    /// read in hex.
    fn text(self, value: &Value, data_type: Option<DataType>) -> String {
        let is_communication = (0x1000..0x2000).contains(&self.index);
        match value {
            Value::Unsigned(number)
                if is_communication && *number > 9 && data_type == Some(DataType::UNSIGNED32) =>
            {
                format!("0x{number:X}")
            }
            Value::Text(text) if text.is_empty() => "\"\"".to_owned(),
            // fast path without the formatting machinery: most values are integers
            Value::Unsigned(number) => number.to_string(),
            Value::Signed(number) => number.to_string(),
            _ => value.to_string(),
        }
    }
}

fn both(value: &Value) -> String {
    match value {
        Value::Unsigned(number) if *number > 9 => format!("{number} (0x{number:X})"),
        Value::Text(text) => format!("\"{text}\""),
        _ => value.to_string(),
    }
}
