// Generated from templates/canopen-rs/od.rs by `cargo xtask templates`; do not edit.

#[allow(clippy::all, clippy::pedantic, reason = "generated")]
impl CanOpenRsView {
    pub(super) fn text(&self) -> String {
        let mut out = String::new();
        put!(out, "// {}; do not edit.
//
// Object dictionary of {} by {}, for the crate canopen-rs 0.6.
//
// Use the file as a module or with `include!`. Products rarely use all of it, so dead code is
// allowed; `unreachable_pub` depends on where it is included.

#[allow(unused_imports)]
use canopen_rs::{{AccessType, Address, ByteString, Entry, ObjectDictionary, Value}};", self.head.made_by, crate::escape::code_span(&self.head.product), crate::escape::code_span(&self.head.vendor));
        if let Some(node_id) = &self.node_id {
            put!(out, "

/// The configured node-ID.
#[allow(dead_code, unreachable_pub)]
pub const NODE_ID: u8 = {};", node_id);
        }
        put!(out, "

/// The number of entries.
#[allow(dead_code, unreachable_pub)]
pub const ENTRY_COUNT: usize = {};

/// The dictionary for `node_id`, 1 to 127; only the lower seven bits are used.
#[must_use]
#[rustfmt::skip]
#[allow(dead_code, unreachable_pub)]
#[allow(clippy::approx_constant, clippy::cast_lossless, clippy::cast_possible_wrap, clippy::too_many_lines)]
pub fn {}(node_id: u8) -> ObjectDictionary<ENTRY_COUNT> {{", self.rows.len(), self.head.lower);
        if self.has_formulas {
            out.push_str("
    let node_id = node_id & 0x7F;");
        }
        else {
            out.push_str("
    let _ = node_id; // no value depends on it");
        }
        out.push_str("
    let mut od = ObjectDictionary::new();");
        for row in &self.rows {
            put!(out, "
    put(&mut od, (0x{}, 0x{}), AccessType::{}, {}); // {}", crate::escape::hex4(&row.index), crate::escape::hex2(&row.sub), crate::escape::capitalize(&row.access), row.value, crate::escape::code_span(&row.name));
        }
        out.push_str("
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
}");
        if self.has_octets() {
            out.push_str("

fn octets(bytes: &[u8]) -> ByteString {
    ByteString::from_bytes(bytes).unwrap_or_default() // none is too long
}");
        }
        out.push_str("

/// The addresses of the entries.
#[rustfmt::skip]
#[allow(dead_code, unreachable_pub)]
pub mod address {
    use super::Address;");
        for row in &self.rows {
            put!(out, "

    /// {}.
    pub const {}: Address = Address::new(0x{}, 0x{});", crate::escape::code_span(&row.name), row.constant, crate::escape::hex4(&row.index), crate::escape::hex2(&row.sub));
        }
        out.push_str("
}");
        out
    }
}
