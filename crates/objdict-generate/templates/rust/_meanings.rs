{# MeaningModules<'_>::text #}
{% if !enums.is_empty() -%}
/// Named values of entries.
#[allow(dead_code, unreachable_pub)]
#[rustfmt::skip]
pub mod enums {
{%- for view in enums %}
{%- if !loop.first %}
{% endif %}
    /// {{ view.of.title|code_span }}: values of {{ self::entries(&view.of.entries) }}.
    #[allow(clippy::enum_variant_names)]
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]{{ derives }}
    #[repr({{ view.repr }})]
    pub enum {{ view.name }} {
{%- for variant in view.variants %}
        /// {{ variant.label|code_span }}.
        {{ variant.name }} = {{ variant.number }},
{%- endfor %}
    }

    #[allow(clippy::too_many_lines, clippy::unnecessary_wraps)]
    impl {{ view.name }} {
{%- for alias in view.aliases %}
        /// {{ alias.label|code_span }}: the same value.
        pub const {{ alias.name }}: Self = Self::{{ alias.variant }};
{%- endfor %}
{%- if !view.aliases.is_empty() %}
{% endif %}
        /// The value of the entry.
        #[must_use]
        pub const fn value(self) -> {{ view.type_ }} {
            self as {{ view.repr }}{% if view.type_ == "bool" %} != 0{% endif %}
        }

        /// The name of a value; `None` if it has none.
        #[must_use]
        pub const fn from_value(value: {{ view.type_ }}) -> Option<Self> {
            match value {
{%- for variant in view.variants %}
                {{ variant.pattern }} => Some(Self::{{ variant.name }}),
{%- endfor %}
{%- if !view.is_complete %}
                _ => None,
{%- endif %}
            }
        }
    }

    impl core::convert::TryFrom<{{ view.type_ }}> for {{ view.name }} {
        type Error = super::Abort;

        fn try_from(value: {{ view.type_ }}) -> Result<Self, super::Abort> {
            Self::from_value(value).ok_or(super::Abort::InvalidValue)
        }
    }
{%- endfor %}
}
{%- if !words.is_empty() %}

{% endif %}
{%- endif %}
{%- if !words.is_empty() -%}
/// Bit fields of entries: `get` extracts the value, `with` returns the word with a new value.
#[allow(dead_code, unreachable_pub)]
#[allow(clippy::cast_lossless, clippy::cast_possible_truncation, clippy::cast_possible_wrap)]
#[allow(clippy::arithmetic_side_effects, clippy::cast_sign_loss, clippy::precedence)]
#[allow(clippy::unnecessary_cast)]
#[rustfmt::skip]
pub mod bits {
{%- for view in words %}
{%- if !loop.first %}
{% endif %}
    /// {{ view.of.title|code_span }}: {{ self::entries(&view.of.entries) }}.
    pub mod {{ view.of.name }} {
{%- for part in view.parts %}
{%- if !loop.first %}
{% endif %}
        /// {{ part.of.label|code_span }}: {{ part.place }}.
        pub mod {{ part.of.name }} {
            /// The lowest bit.
            pub const SHIFT: u32 = {{ part.of.first }};
            /// The number of bits.
            pub const BITS: u32 = {{ part.of.bits }};
            /// The mask of its bits in the word.
            pub const MASK: {{ part.unsigned }} = {{ part.mask }};

            /// Extracts its value from a word.
            #[must_use]
            pub const fn get(word: {{ part.word }}) -> {{ part.type_ }} {
                {{ part.get }}
            }

            /// Returns the word with a new value, of which only the lowest bits are used.
            #[must_use]
            pub const fn with(word: {{ part.word }}, value: {{ part.type_ }}) -> {{ part.word }} {
                {{ part.with }}
            }
        }
{%- endfor %}
    }
{%- endfor %}
}
{%- endif %}
