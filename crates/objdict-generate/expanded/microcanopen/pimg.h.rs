// Generated from templates/microcanopen/pimg.h by `cargo xtask templates`; do not edit.

#[allow(clippy::all, clippy::pedantic, reason = "generated")]
impl MicroCanOpenView<'_> {
    pub(super) fn header(&self) -> String {
        let mut out = String::new();
        put!(out, "/*
 * {}; do not edit.
 *
 * Process image of {} by {}, for MicroCANopen.
 */
#ifndef {}_PIMG_H
#define {}_PIMG_H

#include \"mco.h\"

/* The node-ID in SDO replies that depend on it. */
#ifndef {}_NODE_ID
#define {}_NODE_ID {}
#endif

/* Heartbeat time in milliseconds, for MCO_Init(). */
#define {}_HEARTBEAT {}

/* Offsets in the process image; values are little-endian. */", self.head.made_by, crate::escape::c_comment(&self.head.product), crate::escape::c_comment(&self.head.vendor), self.head.upper, self.head.upper, self.head.upper, self.head.upper, self.dictionary.node_id.unwrap_or(1), self.head.upper, self.heartbeat());
        for entry in self.placed() {
            put!(out, "
#define P_{}_OFF {} /* {}h sub-index {}h, {} byte", entry.name, entry.place(), crate::escape::hex4(&entry.index), crate::escape::hex2(&entry.entry.sub), entry.size);
            if entry.size != 1 {
                out.push_str("s");
            }
            put!(out, ": {} */", crate::escape::c_comment(&entry.entry.entry.name));
        }
        out.push_str("

/* Size of the process image in bytes, at least one. */
#define PROCIMG_SIZE ");
        if self.image.size > 0 {
            put!(out, "{}", self.image.size);
        }
        else {
            out.push_str("1");
        }
        put!(out, "

/* Sets the process image to the defaults of the description. */
void {}_init_image(void);

/* Initialises the PDOs; call it in MCOUSER_ResetCommunication() after MCO_Init(). */
void {}_init_pdos(void);

#endif", self.head.lower, self.head.lower);
        out
    }
}
