//! A key of a section as read.

use super::keys::FieldKey;
use crate::model::Field;
use crate::source::Span;

/// A key with its value.
#[derive(Clone, Copy)]
pub(crate) struct Item<'a> {
    /// The field, if the key has a fixed name.
    pub key: Option<FieldKey>,
    /// The key as written.
    pub name: &'a str,
    /// The value as written.
    pub value: &'a str,
    /// The span of the key.
    pub name_at: Span,
    /// The span of the value.
    pub value_at: Span,
}

impl Item<'_> {
    /// The field, if the key has a fixed name.
    pub(crate) fn field(&self) -> Option<&'static Field> {
        self.key.map(FieldKey::field)
    }

    /// The number of a numbered key, such as `3` in `3=0x1018`.
    pub(crate) fn number(&self) -> Option<u32> {
        Field::item_number(self.name)
    }

    /// The number of a numbered key in hex, although the standard requires decimal: 15 for `0xF=Inlet`.
    pub(crate) fn hex_number(&self) -> Option<u32> {
        let digits = self.name.strip_prefix("0x").or_else(|| self.name.strip_prefix("0X"))?;
        u32::from_str_radix(digits, 16).ok()
    }
}
