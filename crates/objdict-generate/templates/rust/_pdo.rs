/// The default mapping of PDOs: one struct per PDO with its fields in frame order.
{% if gates -%}
#[cfg(feature = "od-pdo")]
{% endif -%}
#[allow(dead_code, unreachable_pub)]
pub mod pdo {
{%- for frame in frames %}
    /// {{ frame.frame.title }} (`0x{{ frame.frame.communication_index|hex4 }}`, `0x{{ frame.frame.mapping_index|hex4 }}`).
    #[allow(clippy::struct_excessive_bools)]
    #[derive(Clone, Copy, Debug, PartialEq)]{{ derives("    ") }}
    pub struct {{ frame.type_name }} {
{%- for field in frame.fields %}
        /// `0x{{ field.row.index|hex4 }}` sub-index `0x{{ field.row.sub|hex2 }}`: {{ field.row.name|code_span }}.
        pub {{ field.field.name }}: {{ field.type_ }},
{%- endfor %}
    }

    #[rustfmt::skip]
    #[allow(clippy::approx_constant, clippy::cast_lossless)]
    impl {{ frame.type_name }} {
        /// Length of a frame in bytes.
        pub const LENGTH: usize = {{ frame.frame.length }};
{%- if let Some(transmission_type) = frame.frame.transmission_type %}

        /// The default transmission type.
        pub const TRANSMISSION_TYPE: u8 = {{ transmission_type }};
{%- endif %}
{%- if let Some(cob_id) = frame.cob_id %}

        /// The default COB-ID, including the flags in its upper bits.
        #[must_use]
        pub const fn cob_id({% if !frame.depends_on_node_id %}_{% endif %}node_id: u8) -> u32 {
            {{ cob_id }}
        }
{%- endif %}

        /// Reads the present values from the dictionary.
        #[must_use]
        pub fn load({% if !frame.reads_data %}_{% endif %}data: &super::Data) -> Self {
            Self {
{%- for field in frame.fields %}
                {{ field.field.name }}: {{ field.load }},
{%- endfor %}
            }
        }

        /// Writes the values to the dictionary without checking limits; constants are unchanged.
        pub fn store(&self, {% if !frame.writes_data %}_{% endif %}data: &mut super::Data) {
{%- for field in frame.fields %}
{%- if let Some(place) = field.place %}
            {{ place }} = {{ field.store }};
{%- endif %}
{%- endfor %}
        }

        /// Packs the values into a frame.
        #[must_use]
        pub fn pack(&self) -> [u8; {{ frame.frame.length }}] {
            let frame = {% for field in frame.fields %}
{%- if !loop.first %}
                | {% endif %}put(&self.{{ field.field.name }}, {{ field.field.first }}, {{ field.field.bits }})
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
                {{ field.field.name }}: take({{ field.zero }}, frame, {{ field.field.first }}, {{ field.field.bits }}, {{ field.field.is_signed() }}),
{%- endfor %}
            }
        }
    }
{% endfor %}
    /// Shifts a value to its position in a frame: its lowest `bits` bits, 1 to 64, from bit `first` on.
    fn put(value: &impl super::Field, first: u32, bits: u32) -> u64 {
        let shift = |number: u64, &byte: &u8| (number << 8) | u64::from(byte);
        let number = match value.load() {
            super::Value::Number(number) => u64::from_le_bytes(number),
            super::Value::Bytes(bytes) => bytes.iter().rev().fold(0, shift),
        };
        (number & (u64::MAX >> (64 - bits))) << first
    }

    /// Extracts a value from a frame in the type of `value`, with sign extension.
    fn take<T: super::Field>(mut value: T, frame: u64, first: u32, bits: u32, signed: bool) -> T {
        let lowest = u64::MAX >> (64 - bits);
        let number = (frame >> first) & lowest;
        let negative = signed && number > lowest >> 1;
        let number = if negative { number | !lowest } else { number };
        let bytes = number.to_le_bytes();
        let length = match value.load() {
            super::Value::Number(_) => None,
            super::Value::Bytes(bytes) => Some(bytes.len().min(8)),
        };
        value.store(match length {
            None => super::Value::Number(bytes),
            Some(length) => super::Value::Bytes(&bytes[..length]),
        });
        value
    }
}
