// Generated from templates/rust/_meanings.rs by `cargo xtask templates`; do not edit.

#[allow(clippy::all, clippy::pedantic, reason = "generated")]
impl MeaningModules<'_> {
    pub(super) fn text(&self) -> String {
        let mut out = String::new();
        if !self.enums.is_empty() {
            out.push_str("/// Named values of entries.
#[allow(dead_code, unreachable_pub)]
#[rustfmt::skip]
pub mod enums {");
            for (index0, view) in (&self.enums).into_iter().enumerate() {
                if !(index0 == 0) {
                    out.push_str("
");
                }
                put!(out, "
    /// {}: values of {}.
    #[allow(clippy::enum_variant_names)]
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]{}
    #[repr({})]
    pub enum {} {{", crate::escape::code_span(&view.of.title), self::entries(&view.of.entries), self.derives, view.repr, view.name);
                for variant in &view.variants {
                    put!(out, "
        /// {}.
        {} = {},", crate::escape::code_span(&variant.label), variant.name, variant.number);
                }
                put!(out, "
    }}

    #[allow(clippy::too_many_lines, clippy::unnecessary_wraps)]
    impl {} {{", view.name);
                for alias in &view.aliases {
                    put!(out, "
        /// {}: the same value.
        pub const {}: Self = Self::{};", crate::escape::code_span(&alias.label), alias.name, alias.variant);
                }
                if !view.aliases.is_empty() {
                    out.push_str("
");
                }
                put!(out, "
        /// The value of the entry.
        #[must_use]
        pub const fn value(self) -> {} {{
            self as {}", view.type_, view.repr);
                if view.type_ == "bool" {
                    out.push_str(" != 0");
                }
                put!(out, "
        }}

        /// The name of a value; `None` if it has none.
        #[must_use]
        pub const fn from_value(value: {}) -> Option<Self> {{
            match value {{", view.type_);
                for variant in &view.variants {
                    put!(out, "
                {} => Some(Self::{}),", variant.pattern, variant.name);
                }
                if !view.is_complete {
                    out.push_str("
                _ => None,");
                }
                put!(out, "
            }}
        }}
    }}

    impl core::convert::TryFrom<{}> for {} {{
        type Error = super::Abort;

        fn try_from(value: {}) -> Result<Self, super::Abort> {{
            Self::from_value(value).ok_or(super::Abort::InvalidValue)
        }}
    }}", view.type_, view.name, view.type_);
            }
            out.push_str("
}");
            if !self.words.is_empty() {
                out.push_str("

");
            }
        }
        if !self.words.is_empty() {
            out.push_str("/// Bit fields of entries: `get` extracts the value, `with` returns the word with a new value.
#[allow(dead_code, unreachable_pub)]
#[allow(clippy::cast_lossless, clippy::cast_possible_truncation, clippy::cast_possible_wrap)]
#[allow(clippy::arithmetic_side_effects, clippy::cast_sign_loss, clippy::precedence)]
#[allow(clippy::unnecessary_cast)]
#[rustfmt::skip]
pub mod bits {");
            for (index0, view) in (&self.words).into_iter().enumerate() {
                if !(index0 == 0) {
                    out.push_str("
");
                }
                put!(out, "
    /// {}: {}.
    pub mod {} {{", crate::escape::code_span(&view.of.title), self::entries(&view.of.entries), view.of.name);
                for (index0, part) in (&view.parts).into_iter().enumerate() {
                    if !(index0 == 0) {
                        out.push_str("
");
                    }
                    put!(out, "
        /// {}: {}.
        pub mod {} {{
            /// The lowest bit.
            pub const SHIFT: u32 = {};
            /// The number of bits.
            pub const BITS: u32 = {};
            /// The mask of its bits in the word.
            pub const MASK: {} = {};

            /// Extracts its value from a word.
            #[must_use]
            pub const fn get(word: {}) -> {} {{
                {}
            }}

            /// Returns the word with a new value, of which only the lowest bits are used.
            #[must_use]
            pub const fn with(word: {}, value: {}) -> {} {{
                {}
            }}
        }}", crate::escape::code_span(&part.of.label), part.place, part.of.name, part.of.first, part.of.bits, part.unsigned, part.mask, part.word, part.type_, part.get, part.word, part.type_, part.word, part.with);
                }
                out.push_str("
    }");
            }
            out.push_str("
}");
        }
        out
    }
}
