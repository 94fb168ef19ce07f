//! Values as texts of attributes and elements.

use std::borrow::Cow;

use crate::model::{Date, LedColor, LedColors, LedOn, LedType, ParameterAccess, Support};

/// A value with a string notation.
pub(crate) trait TextForm: Sized {
    /// Parses a string; `None` if it is not valid.
    fn parse(text: &str) -> Option<Self>;

    /// The string notation of the value.
    fn print(&self) -> Cow<'_, str>;
}

impl TextForm for Box<str> {
    fn parse(text: &str) -> Option<Self> {
        Some(text.into())
    }

    fn print(&self) -> Cow<'_, str> {
        Cow::Borrowed(self)
    }
}

/// `xsd:boolean`.
impl TextForm for bool {
    fn parse(text: &str) -> Option<Self> {
        match collapsed(text) {
            "true" | "1" => Some(true),
            "false" | "0" => Some(false),
            _ => None,
        }
    }

    fn print(&self) -> Cow<'_, str> {
        Cow::Borrowed(if *self { "true" } else { "false" })
    }
}

/// `xsd:date` without a time zone.
impl TextForm for Date {
    fn parse(text: &str) -> Option<Self> {
        Self::from_iso(collapsed(text))
    }

    fn print(&self) -> Cow<'_, str> {
        Cow::Owned(self.to_iso())
    }
}

/// Numbers such as `xsd:unsignedByte`.
macro_rules! numbers {
    ($($Number:ty)+) => {$(
        impl TextForm for $Number {
            fn parse(text: &str) -> Option<Self> {
                collapsed(text).parse().ok()
            }

            fn print(&self) -> Cow<'_, str> {
                Cow::Owned(self.to_string())
            }
        }
    )+};
}

numbers! { u8 u32 }

/// The keywords of a schema enumeration.
macro_rules! words {
    ($($Words:ty)+) => {$(
        impl TextForm for $Words {
            fn parse(text: &str) -> Option<Self> {
                Self::from_name(collapsed(text))
            }

            fn print(&self) -> Cow<'_, str> {
                Cow::Borrowed(self.name())
            }
        }
    )+};
}

words! { LedColor LedColors LedOn LedType ParameterAccess Support }

/// The string without surrounding whitespace, which is not significant in values of XML Schema.
pub(super) fn collapsed(text: &str) -> &str {
    text.trim_matches([' ', '\t', '\n', '\r'])
}
