//! Texts that are not valid, but whose meaning is beyond doubt.

use super::{Quirks, value};
use crate::model::{Access, DataType, InvalidValue, Reason, Value, hex};

/// The unambiguous meaning of an invalid value or limit of an entry.
#[derive(Clone, Debug, PartialEq)]
pub enum Intended {
    /// No value: `0` for bytes, or a word such as `none`.
    Nothing,
    /// This value.
    Value(Value),
}

impl InvalidValue {
    /// The meaning of the value or limit of an entry of this type; `None` if it is ambiguous.
    pub fn intended(&self, data_type: DataType) -> Option<Intended> {
        let text = self.text.trim();
        let number = |number: i128| Value::from_integer(number, data_type).map(Intended::Value);
        match self.reason {
            // the application transfers a DOMAIN, and no tool interprets a string as its bytes
            Reason::NotHexBytes if data_type == DataType::DOMAIN => Some(Intended::Nothing),
            Reason::NotHexBytes if matches!(text, "0" | "0x0" | "\"\"") => Some(Intended::Nothing),
            Reason::NotHexBytes => {
                characters(text).map(|text| Intended::Value(Value::Bytes(text.as_bytes().into())))
            }
            // a digit 8 or 9 cannot be octal, so the number is decimal
            Reason::NotOctal => number(text.parse().ok()?),
            Reason::OutOfRange { .. } if data_type == DataType::BOOLEAN => {
                Some(Intended::Value(Value::Boolean(true)))
            }
            Reason::NotAFormula => {
                let formula = text.strip_prefix('$')?;
                let end = formula.find(|c: char| c != '_' && !c.is_ascii_alphabetic());
                let (name, offset) = formula.split_at(end.unwrap_or(formula.len()));
                let is_node_id = name.replace('_', "").to_ascii_uppercase().ends_with("NODEID");
                of_node_id(offset, data_type).filter(|_| is_node_id)
            }
            Reason::NotANumber if is_no_value(text) => Some(Intended::Nothing),
            // a script has replaced `$NODEID` by an empty string
            Reason::NotANumber if text.starts_with("\\+") => of_node_id(&text[1..], data_type),
            Reason::NotANumber => {
                let (whole, zeros) = text.split_once('.')?;
                let is_whole = !zeros.is_empty() && zeros.bytes().all(|digit| digit == b'0');
                if is_whole { number(whole.parse().ok()?) } else { None }
            }
            _ => None,
        }
    }

    /// The access type that the letters of the text spell or begin: `ro` for `(ro)` and `R`.
    pub fn intended_access(&self) -> Option<Access> {
        let letters: String = self.text.chars().filter(char::is_ascii_alphabetic).collect();
        Access::from_name(&letters).or(match &*letters.to_ascii_lowercase() {
            "r" | "read" | "readonly" => Some(Access::Ro),
            "w" | "write" | "writeonly" => Some(Access::Wo),
            "readwrite" | "wr" => Some(Access::Rw),
            "c" | "cons" | "constant" => Some(Access::Const),
            _ => None,
        })
    }
}

/// The formula of the node-ID plus the rest of the text.
fn of_node_id(offset: &str, data_type: DataType) -> Option<Intended> {
    let formula = format!("$NODEID{offset}");
    value(&formula, Some(data_type), &mut Quirks::default()).ok().map(Intended::Value)
}

/// Whether a text represents an unset value.
fn is_no_value(text: &str) -> bool {
    ["-", "no", "none", "n/a"].iter().any(|word| word.eq_ignore_ascii_case(text))
}

/// The characters of an OCTET_STRING that is obviously text: it is quoted and is not bytes without the quotes, or it
/// contains a letter that no byte notation uses. Template markers and words for an unset value do not qualify.
fn characters(text: &str) -> Option<&str> {
    const OPEN: [&str; 6] = ["null", "nil", "tbd", "todo", "unknown", "undefined"];
    let is_template = text.contains(['<', '>', '{', '}', '@', '$', '%', '[', ']']);
    if is_template || !text.bytes().all(|byte| matches!(byte, b' '..=b'~')) {
        return None;
    }
    let quoted = text.strip_prefix('"').and_then(|text| text.strip_suffix('"'));
    let is_letter = |c: char| matches!(c.to_ascii_lowercase(), 'g' | 'i'..='w' | 'y' | 'z');
    let is_open = is_no_value(text) || OPEN.iter().any(|word| word.eq_ignore_ascii_case(text));
    match quoted {
        Some(quoted) => Some(quoted).filter(|text| !text.contains('"') && hex::parse(text).is_none()),
        None => (text.contains(is_letter) && !text.contains(['"', '\'']) && !is_open).then_some(text),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Field;

    #[test]
    fn a_clear_text_has_a_meaning() {
        let meaning = |text: &str, data_type| {
            let reason = value(text, Some(data_type), &mut Quirks::default()).unwrap_err();
            InvalidValue { field: Field::DefaultValue, text: text.into(), reason }.intended(data_type)
        };
        let bytes = |bytes: &[u8]| Some(Intended::Value(Value::Bytes(bytes.into())));
        for (text, data_type, expected) in [
            ("0", DataType::DOMAIN, Some(Intended::Nothing)),
            ("@ABC", DataType::DOMAIN, Some(Intended::Nothing)),
            ("@ABC", DataType::OCTET_STRING, None),
            ("12345", DataType::OCTET_STRING, None),
            ("0x01, 0x02", DataType::OCTET_STRING, None),
            ("tbd", DataType::OCTET_STRING, None),
            ("\"12\"", DataType::OCTET_STRING, None),
            ("\"\"", DataType::OCTET_STRING, Some(Intended::Nothing)),
            ("\"12 a\"", DataType::OCTET_STRING, bytes(b"12 a")),
            ("Motor 1", DataType::OCTET_STRING, bytes(b"Motor 1")),
            ("None", DataType::UNSIGNED8, Some(Intended::Nothing)),
            ("5.00", DataType::INTEGER16, Some(Intended::Value(Value::Signed(5)))),
            ("5.5", DataType::INTEGER16, None),
            ("300.0", DataType::UNSIGNED8, None),
            ("09", DataType::UNSIGNED8, Some(Intended::Value(Value::Unsigned(9)))),
            ("3", DataType::BOOLEAN, Some(Intended::Value(Value::Boolean(true)))),
            ("$MY_NODE_ID+0x200", DataType::UNSIGNED32, Some(Intended::Value(Value::NodeId(0x200)))),
            ("$SPEED+1", DataType::UNSIGNED32, None),
            ("\\+384", DataType::UNSIGNED32, Some(Intended::Value(Value::NodeId(0x180)))),
            ("\\+", DataType::UNSIGNED32, None),
            ("\\384", DataType::UNSIGNED32, None),
            ("300", DataType::UNSIGNED8, None),
        ] {
            assert_eq!(meaning(text, data_type), expected, "{text}");
        }
    }

    #[test]
    fn an_access_type_is_known_by_its_letters() {
        for (text, expected) in [
            ("(ro)", Some(Access::Ro)),
            ("R", Some(Access::Ro)),
            ("RW ", Some(Access::Rw)),
            ("UNKNOWN", None),
        ] {
            let invalid =
                InvalidValue { field: Field::AccessType, text: text.into(), reason: Reason::UnknownWord };
            assert_eq!(invalid.intended_access(), expected, "{text}");
        }
    }
}
