//! Limits: the stack has numbers for types with a range, and calls a function of the dictionary.

use crate::c_code::{number, number_type};
use crate::model::{DataType, TypeKind};
use crate::resolve::{Encoded, EntryPlan, ValueShape};

/// The types of the stack for numbers.
pub(super) const NUMBERS: [&str; 3] = ["UNS", "INTEGER", "REAL"];

/// The type number of 1003h sub-index 0, to which only 0 may be written.
const ERASED: u8 = 0x9F;

/// The numbers of types with a range.
const FIRST: u8 = 0x24;

/// A type with a range.
pub(super) struct TypeRange {
    pub(super) code: u8,
    data_type: DataType,
    limits: (Option<Encoded>, Option<Encoded>),
    /// How the number is read.
    pub(super) declaration: String,
    /// Conditions under which a value is too low or too high.
    pub(super) too_low: Option<String>,
    pub(super) too_high: Option<String>,
}

impl TypeRange {
    /// The macro of its number.
    pub(super) fn name(&self) -> String {
        format!("valueRange_{}", self.code)
    }

    pub(super) fn type_name(&self) -> String {
        self.data_type.to_string()
    }
}

/// The types with a range of a dictionary.
#[derive(Default)]
pub(super) struct TypeRanges {
    pub(super) list: Vec<TypeRange>,
    /// Whether numbers of 24 and of 40 to 56 bits are among them: signed and unsigned ones.
    pub(super) signed: bool,
    pub(super) unsigned: bool,
}

impl TypeRanges {
    /// The type of an entry with limits; `Ok(None)` if every value of its type is inside.
    ///
    /// # Errors
    /// If all numbers are in use.
    pub(super) fn claim(&mut self, resolved: &EntryPlan, node: &str) -> Result<Option<String>, ()> {
        let ValueShape::Word(data_type) = resolved.shape else { return Ok(None) };
        let limits = (resolved.low.clone(), resolved.high.clone());
        if let Some(known) =
            self.list.iter().find(|known| known.data_type == data_type && known.limits == limits)
        {
            return Ok(Some(known.name()));
        }
        let too_low = limits.0.as_ref().and_then(|low| condition(low, data_type, '<', node));
        let too_high = limits.1.as_ref().and_then(|high| condition(high, data_type, '>', node));
        if too_low.is_none() && too_high.is_none() {
            return Ok(None);
        }
        let used = u8::try_from(self.list.len()).map_err(|_| ())?;
        let code = FIRST.checked_add(used).ok_or(())?;
        let code = if code < ERASED { Some(code) } else { code.checked_add(1) }.ok_or(())?;
        let declaration = self.declaration(data_type, node);
        let range = TypeRange { code, data_type, limits, declaration, too_low, too_high };
        let name = range.name();
        self.list.push(range);
        Ok(Some(name))
    }

    fn declaration(&mut self, data_type: DataType, node: &str) -> String {
        if let Some(c_type) = number_type(data_type, NUMBERS) {
            return format!("{c_type} number;\n        memcpy(&number, value, sizeof number);");
        }
        let size = data_type.byte_length().unwrap_or(8);
        if matches!(data_type.kind(), TypeKind::Signed(_)) {
            self.signed = true;
            self.unsigned = true; // which the signed one calls
            format!("const INTEGER64 number = {node}_signed(value, {size}u);")
        } else {
            self.unsigned = true;
            format!("const UNS64 number = {node}_unsigned(value, {size}u);")
        }
    }
}

/// The condition under which `number` is outside of a limit; `None` if it never is.
fn condition(limit: &Encoded, data_type: DataType, operator: char, node: &str) -> Option<String> {
    let real = matches!(data_type.kind(), TypeKind::Real32 | TypeKind::Real64);
    let text = match *limit {
        Encoded::Word(word) => {
            let edge = data_type.integer_range().map(|(low, high)| if operator == '<' { low } else { high });
            let value = match data_type.kind() {
                TypeKind::Signed(_) => i128::from(word.cast_signed()),
                _ => i128::from(word),
            };
            if edge == Some(value) {
                return None;
            }
            number(word, data_type)? // an infinite limit
        }
        Encoded::Formula(offset) => {
            let wide = if matches!(data_type.kind(), TypeKind::Signed(_)) { "INTEGER64" } else { "UNS64" };
            let c_type = number_type(data_type, NUMBERS).unwrap_or_else(|| wide.to_owned());
            format!("({c_type})({} + {node}_bDeviceNodeId)", number(offset, data_type)?)
        }
        Encoded::Bytes(_) => return None,
    };
    // a NaN is outside any limits
    Some(match (real, operator) {
        (true, '<') => format!("!(number >= {text})"),
        (true, _) => format!("!(number <= {text})"),
        _ => format!("number {operator} {text}"),
    })
}
