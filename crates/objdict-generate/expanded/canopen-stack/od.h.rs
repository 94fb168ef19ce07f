// Generated from templates/canopen-stack/od.h by `cargo xtask templates`; do not edit.

#[allow(clippy::all, clippy::pedantic, reason = "generated")]
impl CanOpenStackView<'_> {
    pub(super) fn header(&self) -> String {
        let mut out = String::new();
        put!(out, "/*
 * {}; do not edit.
 *
 * Object dictionary of {} by {}, for canopen-stack 4.4.
 */
#ifndef {}_CANOPEN_STACK_H
#define {}_CANOPEN_STACK_H

#include \"co_core.h\"

#ifdef __cplusplus
extern \"C\" {{
#endif", self.head.made_by, crate::escape::c_comment(&self.head.product), crate::escape::c_comment(&self.head.vendor), self.head.upper, self.head.upper);
        if let Some(node_id) = &self.dictionary.node_id {
            put!(out, "

/* The configured node-ID. */
#define {}_NODE_ID {}u", self.head.upper, node_id);
        }
        out.push_str("

/* Minimum configuration of the stack: CO_SSDO_N and so on, up to the highest number in use. */");
        for (name, count, what, _) in self.counts() {
            put!(out, "
#define {}_{}_N {} /* {} */", self.head.upper, name, count, what);
        }
        put!(out, "

/* The dictionary: the rows by key, followed by the end mark. */
#define {}_LEN {}u
extern const CO_OBJ {}_objects[{}_LEN + 1u];", self.head.upper, self.rows.len(), self.head.lower, self.head.upper);
        for group in &self.layout.groups {
            put!(out, "

/* The values of the storage group {}. */
typedef struct {{", crate::escape::c_comment(&group.name));
            for member in &group.members {
                put!(out, "
    {}; /* {}: {} */", member.declaration(), layout::place(member), crate::escape::c_comment(&member.described));
            }
            put!(out, "
}} {}_t;
extern {}_t {};
extern const {}_t {}_defaults;", group.variable, group.variable, group.variable, group.variable, group.variable);
        }
        if !self.layout.variables.is_empty() {
            out.push_str("

/* The variable values. */");
            for member in &self.layout.variables {
                if let Some(structure) = layout::own_type(member) {
                    put!(out, "
typedef {} {}_t;", structure, member.name);
                }
                put!(out, "
extern {}; /* {}: {} */", layout::definition(member), layout::place(member), crate::escape::c_comment(&member.described));
            }
        }
        if self.shares(RowType::Block) || self.shares(RowType::Bytes) {
            out.push_str("

/* Types of this file that those below replace. */");
            if self.shares(RowType::Block) {
                put!(out, "
extern const CO_OBJ_TYPE {}_block;", self.head.lower);
            }
            if self.shares(RowType::Bytes) {
                put!(out, "
extern const CO_OBJ_TYPE {}_bytes;", self.head.lower);
            }
        }
        if !self.hooks.is_empty() {
            out.push_str("

/*
 * Types that the application defines, each in place of those beside it, whose functions it can call:
 * `(CO_TUNSIGNED16)->Write(obj, node, buffer, size)`. `CO_GET_SUB(obj->Key)` is the sub-index.
 */");
            for hook in &self.hooks {
                put!(out, "
extern const CO_OBJ_TYPE {}_{}; /* {} */", self.head.lower, hook.name(), hook.replaced.join(", "));
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
