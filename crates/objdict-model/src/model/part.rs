//! Macros that declare the plain parts of the model.

/// Declares a part of the model that consists only of fields. In JSON, empty fields are omitted and unknown
/// names are errors.
macro_rules! part {
    ($($(#[$about:meta])* pub struct $Name:ident { $($(#[$of_field:meta])* pub $field:ident: $Type:ty,)* })+) => {$(
        $(#[$about])*
        #[derive(Clone, Debug, Default, PartialEq, Eq)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
        #[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
        pub struct $Name {
            $($(#[$of_field])* #[cfg_attr(feature = "serde", serde(skip_serializing_if = "crate::model::is_default"))] pub $field: $Type,)*
        }
    )+};
}
pub(super) use part;

/// Declares the words that a field can have, spelled as in the file.
macro_rules! words {
    ($($(#[$about:meta])* pub enum $Name:ident { $($(#[$of_word:meta])* $Word:ident = $text:literal,)+ })+) => {$(
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
        pub enum $Name {
            $($(#[$of_word])* #[cfg_attr(feature = "serde", serde(rename = $text))] $Word,)+
        }

        impl $Name {
            /// Every word.
            pub const ALL: &'static [Self] = &[$(Self::$Word),+];

            /// The word in the spelling of CiA 311.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$Word => $text,)+
                }
            }

            /// The variant for a word, which is case-sensitive.
            pub fn from_name(name: &str) -> Option<Self> {
                Self::ALL.iter().copied().find(|word| word.name() == name)
            }
        }
    )+};
}
pub(super) use words;
