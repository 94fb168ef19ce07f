{# CanOpenRsView::text #}
// {{ head.made_by }}; do not edit.
//
// Object dictionary of {{ head.product|code_span }} by {{ head.vendor|code_span }}, for the crate canopen-rs 0.6.
//
// Use the file as a module or with `include!`. Products rarely use all of it, so dead code is
// allowed; `unreachable_pub` depends on where it is included.

#[allow(unused_imports)]
use canopen_rs::{AccessType, Address, ByteString, Entry, ObjectDictionary, Value};
{%- if let Some(node_id) = node_id %}

/// The configured node-ID.
#[allow(dead_code, unreachable_pub)]
pub const NODE_ID: u8 = {{ node_id }};
{%- endif %}

/// The number of entries.
#[allow(dead_code, unreachable_pub)]
pub const ENTRY_COUNT: usize = {{ rows.len() }};

/// The dictionary for `node_id`, 1 to 127; only the lower seven bits are used.
#[must_use]
#[rustfmt::skip]
#[allow(dead_code, unreachable_pub)]
#[allow(clippy::approx_constant, clippy::cast_lossless, clippy::cast_possible_wrap, clippy::too_many_lines)]
pub fn {{ head.lower }}(node_id: u8) -> ObjectDictionary<ENTRY_COUNT> {
{%- if has_formulas %}
    let node_id = node_id & 0x7F;
{%- else %}
    let _ = node_id; // no value depends on it
{%- endif %}
    let mut od = ObjectDictionary::new();
{%- for row in rows %}
    put(&mut od, (0x{{ row.index|hex4 }}, 0x{{ row.sub|hex2 }}), AccessType::{{ row.access|capitalize }}, {{ row.value }}); // {{ row.name|code_span }}
{%- endfor %}
    od
}

fn put(
    od: &mut ObjectDictionary<ENTRY_COUNT>,
    (index, sub): (u16, u8),
    access: AccessType,
    value: Value,
) {
    let inserted = od.insert(Address::new(index, sub), Entry { value, access });
    debug_assert!(inserted.is_ok()); // there is room for exactly these entries
}
{%- if self.has_octets() %}

fn octets(bytes: &[u8]) -> ByteString {
    ByteString::from_bytes(bytes).unwrap_or_default() // none is too long
}
{%- endif %}

/// The addresses of the entries.
#[rustfmt::skip]
#[allow(dead_code, unreachable_pub)]
pub mod address {
    use super::Address;
{%- for row in rows %}

    /// {{ row.name|code_span }}.
    pub const {{ row.constant }}: Address = Address::new(0x{{ row.index|hex4 }}, 0x{{ row.sub|hex2 }});
{%- endfor %}
}
