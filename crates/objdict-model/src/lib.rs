//! The foundation of objdict: texts with positions, findings as data, and the typed dictionary of a device.
//! Part of `objdict`, which is the crate to depend on.
//!
//! Value spelling (`literal`) is here because EDS, XDD, settings and the text of concise DCF share it;
//! `canopennode` is here because the rules and the generator share it. All of these depend on no other
//! common crate.

/// Implements `Display` with a message per pattern, for one or several types:
/// `Note: { Self { place } => "at {place}"; }`.
#[doc(hidden)]
#[macro_export]
macro_rules! messages {
    ($($Type:ty: { $($(#[$condition:meta])* $pattern:pat => $message:literal $(, $value:expr)*;)+ })+) => {$(
        impl ::std::fmt::Display for $Type {
            fn fmt(&self, f: &mut ::std::fmt::Formatter<'_>) -> ::std::fmt::Result {
                match self {
                    $($(#[$condition])* $pattern => ::std::write!(f, $message $(, $value)*),)+
                }
            }
        }
    )+};
}

/// Implements `Display` like [`messages!`], `Error` for an error, and `From` for the types that variants
/// wrap.
#[doc(hidden)]
#[macro_export]
macro_rules! error_messages {
    ($error:ident: $($(#[$when:meta])* from $wrapped:ty as $variant:ident)* {
        $($(#[$condition:meta])* $pattern:pat => $message:literal $(, $value:expr)*;)+
    }) => {
        $crate::messages! { $error: { $($(#[$condition])* $pattern => $message $(, $value)*;)+ } }

        impl ::std::error::Error for $error {}

        $($(#[$when])* impl From<$wrapped> for $error {
            fn from(error: $wrapped) -> Self {
                Self::$variant(error)
            }
        })*
    };
}

#[macro_use]
mod named;

pub mod canopennode;
#[cfg(feature = "json")]
pub mod compare;
pub mod diagnostic;
mod format;
#[cfg(feature = "json")]
pub mod json;
mod language;
pub mod literal;
pub mod model;
pub mod source;

pub use format::{Format, Syntax};
pub use language::Language;
