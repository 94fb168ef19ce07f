// Generated from templates/canopennode/OD.h by `cargo xtask templates`; do not edit.

#[allow(clippy::all, clippy::pedantic, reason = "generated")]
impl CanOpenNodeView<'_> {
    pub(super) fn header(&self) -> String {
        let mut out = String::new();
        let od = self.prefix.as_str();
        put!(out, "/*
 * {}; do not edit.
 *
 * Object dictionary of {} by {} for CANopenNode 4.
 */
#ifndef {}_H
#define {}_H

#include \"301/CO_ODinterface.h\"

#ifdef __cplusplus
extern \"C\" {{
#endif

/* Number of objects per service of the stack. */", self.head.made_by, crate::escape::c_comment(&self.head.product), crate::escape::c_comment(&self.head.vendor), od, od);
        for (label, count) in self.counters.iter() {
            put!(out, "
#define {}_CNT_{} {}", od, label, count);
        }
        out.push_str("

/* Number of elements per array. */");
        for object in &self.objects {
            if let Some(count) = &object.count {
                put!(out, "
#define {}_CNT_ARR_{} {}", od, crate::escape::hex4(&object.index), count);
            }
        }
        out.push_str("

/* Values by storage group. */");
        for group in &self.groups {
            out.push_str("
typedef struct {");
            for field in &group.fields {
                put!(out, "
    {};", field.declaration);
            }
            put!(out, "
}} {}_{}_t;

#ifndef {}_ATTR_{}
#define {}_ATTR_{}
#endif
extern {}_ATTR_{} {}_{}_t {}_{};
", od, group.name, od, group.name, od, group.name, od, group.name, od, group.name, od, group.name);
        }
        put!(out, "
#ifndef {}_ATTR_OD
#define {}_ATTR_OD
#endif
extern {}_ATTR_OD OD_t *{};

/* Entries of the list, by index. */", od, od, od, od);
        for (index0, object) in (&self.objects).into_iter().enumerate() {
            put!(out, "
#define {}_ENTRY_H{} (&{}->list[{}])", od, crate::escape::hex4(&object.index), od, index0);
        }
        out.push_str("

/* Entries of the list, by index and name. */");
        for (index0, object) in (&self.objects).into_iter().enumerate() {
            if !object.cname.is_empty() {
                put!(out, "
#define {}_ENTRY_H{} (&{}->list[{}])", od, object.name(), od, index0);
            }
        }
        if !self.has_consumers() {
            put!(out, "

/* The stack also refers to these without heartbeat consumers. */
#define {}_CNT_ARR_1016 0
#define {}_ENTRY_H1016 NULL", od, od);
        }
        put!(out, "

/* Adds the node-ID, of which only the lower seven bits are used, to formulas that the stack does not evaluate. Call this when the
   node-ID is known, before CO_CANopenInit(), and again when it changes; restore stored values afterwards. */
void {}_applyNodeId(uint8_t nodeId);", od);
        if let Some(first) = self.hooks.first() {
            put!(out, "

/* Hooks: the application defines these functions, and {}_initHooks() attaches them before CO_CANopenInit()", od);
            if self.limits.is_some() {
                put!(out, " and {}_initLimits()", od);
            }
            put!(out, ".
   stream->subIndex is the entry, stream->object the argument of {}_initHooks(). A function that changes nothing calls
   OD_readOriginal() or ", od);
            if self.limits.is_some() {
                put!(out, "{}_writeLimited()", od);
            }
            else {
                out.push_str("OD_writeOriginal()");
            }
            put!(out, ":

   ODR_t {}_write_H{}(OD_stream_t *stream, const void *buf, OD_size_t count, OD_size_t *countWritten)
   {{
       const ODR_t answer = ", od, crate::escape::hex4(&first.index));
            if self.limits.is_some() {
                put!(out, "{}_writeLimited", od);
            }
            else {
                out.push_str("OD_writeOriginal");
            }
            put!(out, "(stream, buf, count, countWritten);
       if (answer == ODR_OK) {{
           use the new value
       }}
       return answer;
   }} */
void {}_initHooks(void *object);", od);
            for hook in &self.hooks {
                if hook.is_read {
                    put!(out, "
ODR_t {}_read_H{}(OD_stream_t *stream, void *buf, OD_size_t count, OD_size_t *countRead);", od, crate::escape::hex4(&hook.index));
                }
                if hook.is_written {
                    put!(out, "
ODR_t {}_write_H{}(OD_stream_t *stream, const void *buf, OD_size_t count, OD_size_t *countWritten);", od, crate::escape::hex4(&hook.index));
                }
            }
        }
        if self.limits.is_some() {
            put!(out, "

/* Adds an extension that enforces limits to each object with limits and without an extension. The node-ID is for limits
   that are formulas. */
void {}_initLimits(uint8_t nodeId);

/* Writes a value if it is within its limits: for extensions of the application. */
ODR_t {}_writeLimited(OD_stream_t *stream, const void *buf, OD_size_t count, OD_size_t *countWritten);", od, od);
        }
        put!(out, "

/* The configuration of the stack for several object dictionaries. */
#ifdef CO_MULTIPLE_OD
#define {}_INIT_CONFIG(config) {{ \\", od);
        for (member, value) in self.config() {
            put!(out, "
    (config).{} = {}; \\", member, value);
        }
        out.push_str("
}
#endif

#ifdef __cplusplus
}
#endif

#endif");
        out
    }
}
