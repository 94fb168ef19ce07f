//! The texts of values.

use crate::literal::{self, Spelling};
use crate::model::{DataType, Entry, Field, Value};
use crate::xml::n;

/// The attribute that refers to the parameter of an entry. Among the unknown keys of an entry, it refers to
/// a parameter of others.
pub(super) const REFERENCE: &str = n::uniqueIDRef.text();

/// The text of a value, or the invalid text. CiA 311 knows no default of a DOMAIN.
pub(super) fn value_text(index: u16, entry: &Entry, value: Option<&Value>, field: &Field) -> Option<String> {
    let is_domain = entry.implied_type() == Some(DataType::DOMAIN);
    match value {
        _ if is_domain && *field == Field::DefaultValue => None,
        Some(value) => Some(print(index, entry.data_type, value)),
        None => entry.invalid_values.get(field).map(|invalid| invalid.text.to_string()),
    }
}

/// COB-IDs, mappings and other communication parameters are printed in hex, as in an EDS, and the bytes of an
/// OCTET_STRING with blanks between them, without which CANopenEditor reads only the first. XML preserves blanks, so a string needs quotes only if it is empty or contains quotes.
fn print(index: u16, data_type: Option<DataType>, value: &Value) -> String {
    match value {
        Value::Text(text) if !text.is_empty() && !is_quoted(text) => text.to_string(),
        Value::Bytes(bytes) if data_type == Some(DataType::OCTET_STRING) && !bytes.is_empty() => {
            let bytes: Vec<String> = bytes.iter().map(|byte| format!("{byte:02X}")).collect();
            bytes.join(" ")
        }
        _ => {
            let hex = (0x1000..=0x1FFF).contains(&index) && data_type == Some(DataType::UNSIGNED32);
            literal::print(value, Spelling { hex, ..Spelling::default() })
        }
    }
}

fn is_quoted(text: &str) -> bool {
    text.len() > 1 && text.starts_with('"') && text.ends_with('"')
}
