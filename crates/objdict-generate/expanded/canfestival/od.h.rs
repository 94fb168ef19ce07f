// Generated from templates/canfestival/od.h by `cargo xtask templates`; do not edit.

#[allow(clippy::all, clippy::pedantic, reason = "generated")]
impl CanFestivalView<'_> {
    pub(super) fn header(&self) -> String {
        let mut out = String::new();
        put!(out, "/*
 * {}; do not edit.
 *
 * Object dictionary of {} by {}, for CanFestival 3.
 */
#ifndef {}_CANFESTIVAL_H
#define {}_CANFESTIVAL_H

#include \"data.h\"

#ifdef __cplusplus
extern \"C\" {{
#endif

UNS32 {}_valueRangeTest(UNS8 typeValue, void *value);
#ifdef {}_CALLBACK_IN_ROW
const indextable *{}_scanIndexOD(CO_Data *d, UNS16 wIndex, UNS32 *errorCode);
#else
const indextable *{}_scanIndexOD(UNS16 wIndex, UNS32 *errorCode, ODCallback_t **callbacks);
#endif

/* The state of the node, for the functions of the stack. */
extern CO_Data {}_Data;", self.head.made_by, crate::escape::c_comment(&self.head.product), crate::escape::c_comment(&self.head.vendor), self.head.upper, self.head.upper, self.head.lower, self.head.upper, self.head.lower, self.head.lower, self.head.lower);
        if !self.plan.formulas.is_empty() {
            put!(out, "

/* Adds the node-ID to all values that are formulas. Call it after setNodeId(), and before stored values are restored. */
void {}_applyNodeId(UNS8 nodeId);", self.head.lower);
        }
        put!(out, "

/* What a row without an entry refers to. */
extern UNS32 {}_zero;

/* The variables. */", self.head.lower);
        for definition in &self.plan.definitions {
            if !definition.is_constant() {
                put!(out, "
extern {}; /* {} */", definition.declaration(), definition.described);
            }
        }
        out.push_str("

#ifdef __cplusplus
}
#endif

#endif");
        out
    }
}
