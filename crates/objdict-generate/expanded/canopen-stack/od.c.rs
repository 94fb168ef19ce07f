// Generated from templates/canopen-stack/od.c by `cargo xtask templates`; do not edit.

#[allow(clippy::all, clippy::pedantic, reason = "generated")]
impl CanOpenStackView<'_> {
    pub(super) fn source(&self) -> String {
        let mut out = String::new();
        put!(out, "/*
 * {}; do not edit.
 *
 * Object dictionary of {} by {}, for canopen-stack 4.4.
 * Values of more than 4 bytes and REAL64 are stored for a little-endian processor.
 */
#include \"{}.h\"", self.head.made_by, crate::escape::c_comment(&self.head.product), crate::escape::c_comment(&self.head.vendor), self.head.stem);
        if self.has(RowType::Block) || self.has(RowType::Bytes) {
            out.push_str("

#include <string.h>");
        }
        for (name, count, what, condition) in self.counts() {
            put!(out, "

#if CO_{}_N < {}_{}_N{}
#error \"the dictionary has {} {}: set CO_{}_N for the stack\"
#endif", name, self.head.upper, name, condition, count, what, name);
        }
        if self.has(RowType::Block) || self.has(RowType::Bytes) {
            put!(out, "

/* Number of bytes to copy from or to an object of size bytes, after the first offset bytes. */
static uint32_t {}_rest(uint32_t size, uint32_t offset, uint32_t wanted)
{{
    const uint32_t rest = offset < size ? size - offset : 0u;
    return wanted < rest ? wanted : rest;
}}", self.head.lower);
        }
        if self.has(RowType::Block) {
            put!(out, "

/* A value of fixed size. The stack asks for the size when a transfer starts, and not every transfer resets the
   offset, so this resets it. */
static uint32_t {}_block_size(struct CO_OBJ_T *obj, struct CO_NODE_T *node, uint32_t width)
{{
    CO_OBJ_DOM *const block = (CO_OBJ_DOM *)obj->Data;
    (void)node;
    (void)width;
    block->Offset = 0u;
    return block->Size;
}}

static CO_ERR {}_block_read(struct CO_OBJ_T *obj, struct CO_NODE_T *node, void *buffer, uint32_t size)
{{
    CO_OBJ_DOM *const block = (CO_OBJ_DOM *)obj->Data;
    const uint32_t count = {}_rest(block->Size, block->Offset, size);
    (void)node;
    memcpy(buffer, block->Start + block->Offset, count);
    block->Offset += count;
    return CO_ERR_NONE;
}}

static CO_ERR {}_block_write(struct CO_OBJ_T *obj, struct CO_NODE_T *node, void *buffer, uint32_t size)
{{
    CO_OBJ_DOM *const block = (CO_OBJ_DOM *)obj->Data;
    const uint32_t count = {}_rest(block->Size, block->Offset, size);
    (void)node;
    memcpy(block->Start + block->Offset, buffer, count);
    block->Offset += count;
    return CO_ERR_NONE;
}}

static CO_ERR {}_block_reset(struct CO_OBJ_T *obj, struct CO_NODE_T *node, uint32_t para)
{{
    (void)node;
    ((CO_OBJ_DOM *)obj->Data)->Offset = para;
    return CO_ERR_NONE;
}}

", self.head.lower, self.head.lower, self.head.lower, self.head.lower, self.head.lower, self.head.lower);
            if !self.shares(RowType::Block) {
                out.push_str("static ");
            }
            put!(out, "const CO_OBJ_TYPE {}_block = {{
    {}_block_size, NULL, {}_block_read, {}_block_write, {}_block_reset,
}};", self.head.lower, self.head.lower, self.head.lower, self.head.lower, self.head.lower);
        }
        if self.has(RowType::Bytes) {
            put!(out, "

/* A value of up to room bytes, such as a writable text. */
typedef struct {{
    uint32_t offset;
    uint32_t room;
    uint16_t *length;
    uint8_t *bytes;
}} {}_bytes_t;

/* Called when a transfer starts: the length of the value to read, or the writable part of width bytes. */
static uint32_t {}_bytes_size(struct CO_OBJ_T *obj, struct CO_NODE_T *node, uint32_t width)
{{
    {}_bytes_t *const value = ({}_bytes_t *)obj->Data;
    (void)node;
    value->offset = 0u;
    if (width == 0u) {{
        return *value->length;
    }}
    return width < value->room ? width : value->room;
}}

static CO_ERR {}_bytes_read(struct CO_OBJ_T *obj, struct CO_NODE_T *node, void *buffer, uint32_t size)
{{
    {}_bytes_t *const value = ({}_bytes_t *)obj->Data;
    const uint32_t count = {}_rest(*value->length, value->offset, size);
    (void)node;
    memcpy(buffer, value->bytes + value->offset, count);
    value->offset += count;
    return CO_ERR_NONE;
}}

static CO_ERR {}_bytes_write(struct CO_OBJ_T *obj, struct CO_NODE_T *node, void *buffer, uint32_t size)
{{
    {}_bytes_t *const value = ({}_bytes_t *)obj->Data;
    const uint32_t count = {}_rest(value->room, value->offset, size);
    (void)node;
    memcpy(value->bytes + value->offset, buffer, count);
    value->offset += count;
    *value->length = (uint16_t)value->offset;
    return count == size ? CO_ERR_NONE : CO_ERR_OBJ_SIZE;
}}

static CO_ERR {}_bytes_reset(struct CO_OBJ_T *obj, struct CO_NODE_T *node, uint32_t para)
{{
    (void)node;
    (({}_bytes_t *)obj->Data)->offset = para;
    return CO_ERR_NONE;
}}

", self.head.lower, self.head.lower, self.head.lower, self.head.lower, self.head.lower, self.head.lower, self.head.lower, self.head.lower, self.head.lower, self.head.lower, self.head.lower, self.head.lower, self.head.lower, self.head.lower);
            if !self.shares(RowType::Bytes) {
                out.push_str("static ");
            }
            put!(out, "const CO_OBJ_TYPE {}_bytes = {{
    {}_bytes_size, NULL, {}_bytes_read, {}_bytes_write, {}_bytes_reset,
}};", self.head.lower, self.head.lower, self.head.lower, self.head.lower, self.head.lower);
        }
        for group in &self.layout.groups {
            put!(out, "

/* The values of the storage group {}. */
{}_t {} = {{", crate::escape::c_comment(&group.name), group.variable, group.variable);
            for member in &group.members {
                put!(out, "
    .{} = {},", member.name, member.initializer);
            }
            put!(out, "
}};
const {}_t {}_defaults = {{", group.variable, group.variable);
            for member in &group.members {
                put!(out, "
    .{} = {},", member.name, member.initializer);
            }
            out.push_str("
};");
        }
        if !self.layout.variables.is_empty() {
            out.push_str("

/* The variable values. */");
            for member in &self.layout.variables {
                put!(out, "
{} = {};", layout::definition(member), member.initializer);
            }
        }
        if !self.layout.definitions.is_empty() {
            out.push_str("

/* Constants, and additional data for types of the stack. */");
            for definition in &self.layout.definitions {
                put!(out, "
static {} = {};", definition.declaration(), definition.initializer);
            }
        }
        if self.parameters.nothing {
            put!(out, "

static const uint8_t {}_nothing = 0u;", self.head.lower);
        }
        if !self.parameters.store.is_empty() {
            put!(out, "

/* Parameter groups stored by 1010h. */
static const CO_PARA {}_store[] = {{", self.head.lower);
            for line in &self.parameters.store {
                put!(out, "
    {}", line);
            }
            out.push_str("
};");
        }
        if !self.parameters.restore.is_empty() {
            put!(out, "

/* Parameter groups restored by 1011h. */
static const CO_PARA {}_restore[] = {{", self.head.lower);
            for line in &self.parameters.restore {
                put!(out, "
    {}", line);
            }
            out.push_str("
};");
        }
        put!(out, "

const CO_OBJ {}_objects[{}_LEN + 1u] = {{", self.head.lower, self.head.upper);
        for row in &self.rows {
            put!(out, "
    {{CO_KEY(0x{}, 0x{}, {}), {}, (CO_DATA){}}}, /* {} */", crate::escape::hex4(&row.index), crate::escape::hex2(&row.sub), row.flags, row.type_name(&self.head.lower), row.data, crate::escape::c_comment(&row.name));
        }
        out.push_str("
    CO_OBJ_DICT_ENDMARK
};");
        out
    }
}
