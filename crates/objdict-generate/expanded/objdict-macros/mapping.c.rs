// Generated from templates/objdict-macros/mapping.c by `cargo xtask templates`; do not edit.

#[allow(clippy::all, clippy::pedantic, reason = "generated")]
impl ObjdictMacrosView<'_> {
    pub(super) fn mapping(&self) -> String {
        let mut out = String::new();
        put!(out, "/*
 * {}; do not edit.
 *
 * PDO mapping of {} by {}.
 */
#include \"objdict.h\"", self.head.made_by, crate::escape::c_comment(&self.head.product), crate::escape::c_comment(&self.head.vendor));
        let rpdos = self.of(PdoKind::Rpdo);
        if !rpdos.is_empty() {
            out.push_str("

const PDO_MAP gRpdoMap[NUM_OF_RPDOS] = {");
            for pdo in rpdos {
                put!(out, "
    {{ /* RPDO {} */
        NUM_OF_MAP_ENTRIES({}),
        {{", pdo.number, pdo.entries.len());
                for entry in &pdo.entries {
                    put!(out, "
            {},", entry);
                }
                for _ in 0..pdo.unused() {
                    out.push_str("
            VOID_MAP_ENTRY,");
                }
                out.push_str("
        },
    },");
            }
            out.push_str("
};");
        }
        let tpdos = self.of(PdoKind::Tpdo);
        if !tpdos.is_empty() {
            out.push_str("

const PDO_MAP gTpdoMap[NUM_OF_TPDOS] = {");
            for pdo in tpdos {
                put!(out, "
    {{ /* TPDO {} */
        NUM_OF_MAP_ENTRIES({}),
        {{", pdo.number, pdo.entries.len());
                for entry in &pdo.entries {
                    put!(out, "
            {},", entry);
                }
                for _ in 0..pdo.unused() {
                    out.push_str("
            VOID_MAP_ENTRY,");
                }
                out.push_str("
        },
    },");
            }
            out.push_str("
};");
        }
        out
    }
}
