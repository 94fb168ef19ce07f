//! Macros that declare the plain parts of the model.

/// Declares a part of the model that consists only of fields. In JSON, empty fields are omitted unless `always()`, and
/// unknown names are errors. A part that is read `from` a different type is checked by it.
macro_rules! part {
    ($(#[$about:meta])* pub struct $Name:ident from $Form:literal $fields:tt) => {
        part! { @$Name [serde(try_from = $Form)] $(#[$about])* #[cfg_attr(feature = "schema", schemars(!try_from))] $fields }
    };
    ($($(#[$about:meta])* pub struct $Name:ident $fields:tt)+) => {
        $(part! { @$Name [serde(default, deny_unknown_fields)] $(#[$about])* $fields })+
    };
    (@$Name:ident [$reading:meta] $(#[$about:meta])* {
        $($(#[$of_field:meta])* $(always $always:tt)? pub $field:ident: $Type:ty,)*
    }) => {
        #[derive(Clone, Debug, Default, PartialEq, Eq)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
        #[cfg_attr(feature = "serde", $reading)]
        $(#[$about])*
        pub struct $Name {
            $(
                $(#[$of_field])*
                #[cfg_attr(
                    all(feature = "serde", not(any($(all $always)?))),
                    serde(skip_serializing_if = "crate::model::is_default")
                )]
                pub $field: $Type,
            )*
        }
    };
}
pub(super) use part;

/// Declares the keywords of a field, spelled as in the file, which is case-sensitive.
macro_rules! words {
    ($($(#[$about:meta])* pub enum $Name:ident { $($(#[$of_word:meta])* $Word:ident = $text:literal,)+ })+) => {$(
        $crate::named! {
            $(#[$about])*
            #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
            #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
            #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
            pub enum $Name {
                $($(#[$of_word])* #[cfg_attr(feature = "serde", serde(rename = $text))] $Word = $text,)+
            }
        }

        impl $Name {
            /// The variant for a word.
            pub fn from_name(name: &str) -> Option<Self> {
                Self::ALL.into_iter().find(|word| word.name() == name)
            }
        }
    )+};
}
pub(super) use words;
