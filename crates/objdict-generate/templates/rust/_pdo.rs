/// The default mapping of PDOs: one struct per PDO with its fields in frame order.
{% if options.feature_gates -%}
#[cfg(feature = "od-pdo")]
{% endif -%}
#[allow(dead_code, unreachable_pub, unused_imports)]
#[allow(clippy::arithmetic_side_effects, clippy::indexing_slicing)]
#[allow(clippy::derive_partial_eq_without_eq)]
pub mod pdo {
    use super::table::{first, pack, unpack};
    use super::Data;
{% for frame in frames %}
    /// {{ frame.frame.title }} (`0x{{ frame.frame.communication_index|hex4 }}`, `0x{{ frame.frame.mapping_index|hex4 }}`).
    #[allow(clippy::struct_excessive_bools)]
    #[derive(Clone, Copy, Debug, PartialEq)]{{ derives("    ") }}
    pub struct {{ frame.frame.name|capitalize }} {
{%- for field in frame.fields %}
        /// `0x{{ field.row.index|hex4 }}` sub-index `0x{{ field.row.sub|hex2 }}`: {{ field.row.name|code_span }}.
        pub {{ field.field.name }}: {{ field.type_ }},
{%- endfor %}
    }

    #[rustfmt::skip]
    #[allow(clippy::cast_lossless)]
    impl {{ frame.frame.name|capitalize }} {
        /// Length of a frame in bytes.
        pub const LENGTH: usize = {{ frame.frame.length }};
{%- if let Some(transmission_type) = frame.frame.transmission_type %}

        /// The default transmission type.
        pub const TRANSMISSION_TYPE: u8 = {{ transmission_type }};
{%- endif %}
{%- if let Some(cob_id) = frame.cob_id %}

        /// The default COB-ID, including the flags in its upper bits.
        #[must_use]
        pub const fn cob_id({% if !frame.frame.depends_on_node_id() %}_{% endif %}node_id: u8) -> u32 {
            {{ cob_id }}
        }
{%- endif %}

        /// Reads the present values from the dictionary.
        #[must_use]
        pub fn load(data: &Data) -> Self {
            Self {
{%- for field in frame.fields %}
                {{ field.field.name }}: {{ field.load }},
{%- endfor %}
            }
        }

        /// Writes the values to the dictionary without checking limits; constants are unchanged.
        pub fn store(&self, {% if !frame.writes_data %}_{% endif %}data: &mut Data) {
{%- for field in frame.fields %}
{%- if let Some(store) = field.store %}
            {{ store }};
{%- endif %}
{%- endfor %}
        }

        /// Packs the values into a frame.
        #[must_use]
        pub fn pack(&self) -> [u8; {{ frame.frame.length }}] {
            let frame = {% for field in frame.fields %}
{%- if !loop.first %}
                | {% endif %}pack::<{{ field.type_ }}>(self.{{ field.field.name }}, {{ field.field.first }}, {{ field.field.bits }})
{%- endfor %};
            let bytes = frame.to_le_bytes();
            core::array::from_fn(|at| bytes[at])
        }

        /// Unpacks the values of a frame.
        #[must_use]
        pub fn unpack(frame: [u8; {{ frame.frame.length }}]) -> Self {
            let frame = frame.iter().rev().fold(0, |frame, &byte| (frame << 8) | u64::from(byte));
            Self {
{%- for field in frame.fields %}
                {{ field.field.name }}: unpack(frame, {{ field.field.first }}, {{ field.field.bits }}, {{ field.field.is_signed() }}),
{%- endfor %}
            }
        }
    }
{%- if options.runtime %}

    impl objdict_device::Pdo for {{ frame.frame.name|capitalize }} {
        type Data = Data;
        const INDEX: u16 = 0x{{ frame.frame.communication_index|hex4 }};
        const LENGTH: usize = {{ frame.frame.length }};

        fn load(data: &Data) -> Self {
            Self::load(data)
        }

        fn store(&self, data: &mut Data) {
            Self::store(self, data);
        }

        fn to_bytes(&self) -> [u8; 8] {
            first(&self.pack())
        }

        fn from_bytes(bytes: [u8; 8]) -> Self {
            Self::unpack(first(&bytes))
        }
    }
{%- endif %}
{% endfor -%}
}
