// Generated from templates/lely/sdev.h by `cargo xtask templates`; do not edit.

#[allow(clippy::all, clippy::pedantic, reason = "generated")]
impl LelyView<'_> {
    pub(super) fn header(&self) -> String {
        let mut out = String::new();
        put!(out, "/*
 * {}; do not edit.
 *
 * The static device {} by {}, for Lely core 2.4.
 */
#ifndef {}_SDEV_H
#define {}_SDEV_H

#include <lely/co/sdev.h>", self.head.made_by, crate::escape::c_comment(&self.head.product), crate::escape::c_comment(&self.head.vendor), self.head.upper, self.head.upper);
        if !self.hooks.is_empty() {
            out.push_str("
#include <lely/co/dev.h>
#include <lely/co/obj.h>");
        }
        put!(out, "

#ifdef __cplusplus
extern \"C\" {{
#endif

/* The argument of co_dev_create_from_sdev(). */
extern const struct co_sdev {}_sdev;

#if LELY_NO_MALLOC
/* In place of co_dev_create_from_sdev(): makes the one device in static memory; NULL for an invalid node-ID. Call it once. */
co_dev_t *{}_create(void);
#endif", self.head.lower, self.head.lower);
        if !self.hooks.is_empty() {
            out.push_str("

/*
 * Functions that the application defines. They take the value of `req` with co_sub_on_dn(), or provide it with co_sub_on_up(), and
 * return 0 or an abort code. A download calls them for each segment; co_sub_on_dn() returns 0 when the value is complete.
 */");
            for hook in &self.hooks {
                if !hook.written.is_empty() {
                    put!(out, "
co_unsigned32_t {}_hook{}_dn(co_sub_t *sub, struct co_sdo_req *req, void *data);", self.head.lower, crate::escape::hex4(&hook.index));
                }
                if !hook.read.is_empty() {
                    put!(out, "
co_unsigned32_t {}_hook{}_up(const co_sub_t *sub, struct co_sdo_req *req, void *data);", self.head.lower, crate::escape::hex4(&hook.index));
                }
            }
            put!(out, "

/* Has the library call them, with this `data`, for a device of the table. Call it once the device exists. */
void {}_init_hooks(co_dev_t *dev, void *data);", self.head.lower);
        }
        out.push_str("

#ifdef __cplusplus
}
#endif

#endif");
        out
    }
}
