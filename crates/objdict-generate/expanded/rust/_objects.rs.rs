// Generated from templates/rust/_objects.rs by `cargo xtask templates`; do not edit.

#[allow(clippy::all, clippy::pedantic, reason = "generated")]
impl ObjectModules<'_> {
    pub(super) fn text(&self) -> String {
        let mut out = String::new();
        for (index0, area) in (&self.areas).into_iter().enumerate() {
            if !(index0 == 0) {
                out.push_str("
");
            }
            put!(out, "#[allow(unused_imports, unreachable_pub)]
pub use self::{}::*;

/// {}: `0x{}` to `0x{}`.
#[allow(dead_code, unreachable_pub, unused_imports, clippy::wildcard_imports)]
#[rustfmt::skip]
pub mod {} {{
    use super::*;", area.name, area.title, crate::escape::hex4(&area.first), crate::escape::hex4(&area.last), area.name);
            for view in &area.objects {
                out.push_str("
");
                if view.object.single {
                    let handle = &view.handles[0];
                    put!(out, "
    /// `0x{}`: {}.
    pub const {}: Handle<{}, {}> = Handle::of(0x{}, 0x{});", crate::escape::hex4(&view.object.index), handle.doc, handle.name, handle.type_of(), self::access(handle.row), crate::escape::hex4(&view.object.index), crate::escape::hex2(&handle.row.sub));
                }
                else {
                    if let Some(array) = &view.array {
                        put!(out, "
    /// `0x{}`: {}, by sub-index.
    pub const {}: Array<{}, {}> = Array::of(0x{}, {});
", crate::escape::hex4(&view.object.index), crate::escape::code_span(&view.object.name), array.name, array.type_, array.access, crate::escape::hex4(&view.object.index), array.length);
                    }
                    put!(out, "
    /// `0x{}`: {}.
    pub mod {} {{
        use super::*;

        /// Index of the object.
        pub const INDEX: u16 = 0x{};", crate::escape::hex4(&view.object.index), crate::escape::code_span(&view.object.name), view.object.module, crate::escape::hex4(&view.object.index));
                    for handle in &view.handles {
                        put!(out, "
        /// Sub-index `0x{}`: {}.
        pub const {}: Handle<{}, {}> = Handle::of(INDEX, 0x{});", crate::escape::hex2(&handle.row.sub), handle.doc, handle.name, handle.type_of(), self::access(handle.row), crate::escape::hex2(&handle.row.sub));
                    }
                    out.push_str("
    }");
                }
            }
            out.push_str("
}
");
        }
        out
    }
}
