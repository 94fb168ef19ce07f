// Generated from templates/objdict-macros/objdict.c by `cargo xtask templates`; do not edit.

#[allow(clippy::all, clippy::pedantic, reason = "generated")]
impl ObjdictMacrosView<'_> {
    pub(super) fn source(&self) -> String {
        let mut out = String::new();
        put!(out, "/*
 * {}; do not edit.
 *
 * Object dictionary of {} by {}.
 */
#include \"objdict.h\"
", self.head.made_by, crate::escape::c_comment(&self.head.product), crate::escape::c_comment(&self.head.vendor));
        for variable in &self.variables {
            put!(out, "
{} = {};", variable.declaration(), variable.initializer);
        }
        out.push_str("

const OBJ_ENTRY gObjDict[NUM_OF_OBJ_ENTRIES] = {");
        for row in &self.rows {
            if row.single {
                put!(out, "
    SINGLE_OBJ(0x{}, {}, {}, {}), /* {} */", crate::escape::hex4(&row.index), row.length(), row.address, row.access(), crate::escape::c_comment(&row.entry.entry.name));
            }
            else {
                put!(out, "
    SUB_OBJ(0x{}, 0x{}, {}, {}, {}), /* {} */", crate::escape::hex4(&row.index), crate::escape::hex2(&row.entry.sub), row.length(), row.address, row.access(), crate::escape::c_comment(&row.entry.entry.name));
            }
        }
        out.push_str("
};");
        out
    }
}
