// Generated from templates/microcanopen/mco.c by `cargo xtask templates`; do not edit.

#[allow(clippy::all, clippy::pedantic, reason = "generated")]
impl MicroCanOpenView<'_> {
    pub(super) fn source(&self) -> String {
        let mut out = String::new();
        put!(out, "/*
 * {}; do not edit.
 *
 * Tables of {} by {}, for MicroCANopen.
 */
#include \"{}_pimg.h\"

/* The variable values, which PDOs may map. */
UNSIGNED8 gProcImg[PROCIMG_SIZE];

/* Replies to SDO requests, 8 bytes each, with an end mark. */
UNSIGNED8 MEM_CONST SDOResponseTable[] = {{", self.head.made_by, crate::escape::c_comment(&self.head.product), crate::escape::c_comment(&self.head.vendor), self.head.stem);
        for reply in &self.replies {
            put!(out, "
    {}, /* {} */", reply.row, crate::escape::c_comment(&reply.described));
        }
        out.push_str("
    SDOREPLY(0xFFFF, 0xFF, 0xFF, 0xFFFFFFFFL)
};

/* Entries of the process image, with an end mark. */
OD_PROCESS_DATA_ENTRY MEM_CONST gODProcTable[] = {");
        for entry in &self.image.entries {
            put!(out, "
    ODENTRY(0x{}, 0x{}, {}, P_{}_OFF),", crate::escape::hex4(&entry.index), crate::escape::hex2(&entry.entry.sub), entry.flags(), entry.name);
        }
        put!(out, "
    ODENTRY(0xFFFF, 0xFF, 0xFF, 0xFF)
}};

/* Sets the process image to the defaults of the description. */
void {}_init_image(void)
{{
    unsigned at;
    for (at = 0; at < PROCIMG_SIZE; at++) {{
        gProcImg[at] = 0;
    }}", self.head.lower);
        for (offset, value) in self.defaults() {
            put!(out, "
    gProcImg[{}] = {};", offset, value);
        }
        put!(out, "
}}

/* Initialises the PDOs; call it in MCOUSER_ResetCommunication() after MCO_Init(). */
void {}_init_pdos(void)
{{", self.head.lower);
        for call in &self.calls {
            put!(out, "
    MCO_Init{}({}, ", call.kind, call.number);
            if let Some((id, is_added)) = &call.can_id {
                put!(out, "0x{:03X}", id);
                if *is_added {
                    put!(out, " + {}", self.node_id());
                }
            }
            else {
                out.push_str("0");
            }
            if call.kind == PdoKind::Tpdo {
                put!(out, ", {}, {}", call.event, call.inhibit);
            }
            put!(out, ", {}, {});", call.length, call.offset);
        }
        out.push_str("
}");
        out
    }
}
