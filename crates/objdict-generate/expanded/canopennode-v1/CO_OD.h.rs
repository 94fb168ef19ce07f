// Generated from templates/canopennode-v1/CO_OD.h by `cargo xtask templates`; do not edit.

#[allow(clippy::all, clippy::pedantic, reason = "generated")]
impl CanOpenNodeV1View<'_> {
    pub(super) fn header(&self) -> String {
        let mut out = String::new();
        put!(out, "/*
 * {}; do not edit.
 *
 * Object dictionary of {} by {}, for CANopenNode 1.3.
 */
#ifndef CO_OD_H
#define CO_OD_H

typedef bool_t BOOLEAN;
typedef uint8_t UNSIGNED8;
typedef uint16_t UNSIGNED16;
typedef uint32_t UNSIGNED32;
typedef uint64_t UNSIGNED64;
typedef int8_t INTEGER8;
typedef int16_t INTEGER16;
typedef int32_t INTEGER32;
typedef int64_t INTEGER64;
typedef float REAL32;
typedef double REAL64;
typedef char VISIBLE_STRING;
typedef unsigned char OCTET_STRING;

/* What the stack is compiled for. */
#define CO_NO_SYNC {}
#define CO_NO_TIME {}
#define CO_NO_EMERGENCY 1
#define CO_NO_SDO_SERVER {}
#define CO_NO_SDO_CLIENT {}
#define CO_NO_RPDO {}
#define CO_NO_TPDO {}
#define CO_NO_NMT_MASTER {}
#define CO_NO_TRACE 0
#define CO_NO_LSS_SERVER {}
#define CO_NO_LSS_CLIENT {}

#define CO_OD_NoOfElements {}

/* Records. */", self.head.made_by, crate::escape::c_comment(&self.head.product), crate::escape::c_comment(&self.head.vendor), self.has(0x1005), self.has(0x1012), self.plan.counts[0], self.plan.counts[1], self.plan.counts[2], self.plan.counts[4], self.is_master(), self.has_lss(), self.has_lss_master(), self.plan.rows.len());
        for record in &self.plan.types {
            put!(out, "
typedef struct {{ /* {}h */", crate::escape::hex4(&record.index));
            for member in &record.members {
                put!(out, "
    {};", member);
            }
            put!(out, "
}} {};", record.name);
        }
        out.push_str("

/* The indexes and sub-indexes of objects. */");
        for (name, value) in &self.plan.numbers {
            put!(out, "
#define {} {}", name, value);
        }
        out.push_str("

/* The first and the last word of each memory: other values mean that it has other contents. */
#define CO_OD_FIRST_LAST_WORD 0x55");
        for location in &ValueLocation::ALL {
            put!(out, "

struct sCO_OD_{} {{
    UNSIGNED32 FirstWord;", location.name());
            for variable in self.plan.of(location) {
                put!(out, "
    {}; /* {}h */", variable.declaration, crate::escape::hex4(&variable.index));
            }
            put!(out, "
    UNSIGNED32 LastWord;
}};
extern struct sCO_OD_{} CO_OD_{};", location.name(), location.name());
        }
        out.push_str("

/* The variables, their lengths, and the elements of arrays. */");
        for (name, value) in &self.plan.aliases {
            put!(out, "
#define {} {}", name, value);
        }
        if !self.plan.formulas.is_empty() {
            out.push_str("

/* Adds the node-ID to the values that are formulas and to which the stack does not add it. */
void CO_OD_applyNodeId(uint8_t nodeId);");
        }
        if let Some(first) = self.hooks.first() {
            put!(out, "

/*
 * Has the SDO server call the functions of the application, `CO_SDO_abortCode_t CO_OD_hook{}(CO_ODF_arg_t *ODF_arg)` and so on,
 * with `object` in `ODF_arg->object`: before an upload sends `ODF_arg->data`, and before a download writes it. Call it after
 * CO_CANopenInit() with `CO->SDO[0]`.
 */
void CO_OD_initHooks(void *SDO, void *object);", first);
        }
        out.push_str("

#endif");
        out
    }
}
