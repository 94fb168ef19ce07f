//! How the plain parts of the model are declared.

/// Declares a part of the model that is nothing but its fields. In JSON a field that says nothing is left out, and a
/// name that is not known is an error.
macro_rules! part {
    ($($(#[$about:meta])* pub struct $Name:ident { $($(#[$of_field:meta])* pub $field:ident: $Type:ty,)* })+) => {$(
        $(#[$about])*
        #[derive(Clone, Debug, Default, PartialEq, Eq)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
        pub struct $Name {
            $($(#[$of_field])* #[cfg_attr(feature = "serde", serde(skip_serializing_if = "crate::model::is_default"))] pub $field: $Type,)*
        }
    )+};
}
pub(super) use part;

/// Declares a set of words that a field may have, spelled as in the file.
macro_rules! words {
    ($($(#[$about:meta])* pub enum $Name:ident { $($(#[$of_word:meta])* $Word:ident = $text:literal,)+ })+) => {$(
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        pub enum $Name {
            $($(#[$of_word])* #[cfg_attr(feature = "serde", serde(rename = $text))] $Word,)+
        }

        impl $Name {
            /// Every word.
            pub const ALL: &'static [Self] = &[$(Self::$Word),+];

            /// The word as CiA 311 spells it.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$Word => $text,)+
                }
            }

            /// What a word stands for. Words are spelled exactly so.
            pub fn from_name(name: &str) -> Option<Self> {
                Self::ALL.iter().copied().find(|word| word.name() == name)
            }
        }
    )+};
}
pub(super) use words;
