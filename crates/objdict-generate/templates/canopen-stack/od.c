{# CanOpenStackView<'_>::source #}
/*
 * {{ head.made_by }}; do not edit.
 *
 * Object dictionary of {{ head.product|c_comment }} by {{ head.vendor|c_comment }}, for canopen-stack 4.4.
 * Values of more than 4 bytes and REAL64 are stored for a little-endian processor.
 */
#include "{{ head.stem }}.h"
{%- if self.has(RowType::Block) || self.has(RowType::Bytes) %}

#include <string.h>
{%- endif %}
{%- for (name, count, what, condition) in self.counts() %}

#if CO_{{ name }}_N < {{ head.upper }}_{{ name }}_N{{ condition }}
#error "the dictionary has {{ count }} {{ what }}: set CO_{{ name }}_N for the stack"
#endif
{%- endfor %}
{%- if self.has(RowType::Block) || self.has(RowType::Bytes) %}

/* Number of bytes to copy from or to an object of size bytes, after the first offset bytes. */
static uint32_t {{ head.lower }}_rest(uint32_t size, uint32_t offset, uint32_t wanted)
{
    const uint32_t rest = offset < size ? size - offset : 0u;
    return wanted < rest ? wanted : rest;
}
{%- endif %}
{%- if self.has(RowType::Block) %}

/* A value of fixed size. The stack asks for the size when a transfer starts, and not every transfer resets the
   offset, so this resets it. */
static uint32_t {{ head.lower }}_block_size(struct CO_OBJ_T *obj, struct CO_NODE_T *node, uint32_t width)
{
    CO_OBJ_DOM *const block = (CO_OBJ_DOM *)obj->Data;
    (void)node;
    (void)width;
    block->Offset = 0u;
    return block->Size;
}

static CO_ERR {{ head.lower }}_block_read(struct CO_OBJ_T *obj, struct CO_NODE_T *node, void *buffer, uint32_t size)
{
    CO_OBJ_DOM *const block = (CO_OBJ_DOM *)obj->Data;
    const uint32_t count = {{ head.lower }}_rest(block->Size, block->Offset, size);
    (void)node;
    memcpy(buffer, block->Start + block->Offset, count);
    block->Offset += count;
    return CO_ERR_NONE;
}

static CO_ERR {{ head.lower }}_block_write(struct CO_OBJ_T *obj, struct CO_NODE_T *node, void *buffer, uint32_t size)
{
    CO_OBJ_DOM *const block = (CO_OBJ_DOM *)obj->Data;
    const uint32_t count = {{ head.lower }}_rest(block->Size, block->Offset, size);
    (void)node;
    memcpy(block->Start + block->Offset, buffer, count);
    block->Offset += count;
    return CO_ERR_NONE;
}

static CO_ERR {{ head.lower }}_block_reset(struct CO_OBJ_T *obj, struct CO_NODE_T *node, uint32_t para)
{
    (void)node;
    ((CO_OBJ_DOM *)obj->Data)->Offset = para;
    return CO_ERR_NONE;
}

{% if !self.shares(RowType::Block) %}static {% endif %}const CO_OBJ_TYPE {{ head.lower }}_block = {
    {{ head.lower }}_block_size, NULL, {{ head.lower }}_block_read, {{ head.lower }}_block_write, {{ head.lower }}_block_reset,
};
{%- endif %}
{%- if self.has(RowType::Bytes) %}

/* A value of up to room bytes, such as a writable text. */
typedef struct {
    uint32_t offset;
    uint32_t room;
    uint16_t *length;
    uint8_t *bytes;
} {{ head.lower }}_bytes_t;

/* Called when a transfer starts: the length of the value to read, or the writable part of width bytes. */
static uint32_t {{ head.lower }}_bytes_size(struct CO_OBJ_T *obj, struct CO_NODE_T *node, uint32_t width)
{
    {{ head.lower }}_bytes_t *const value = ({{ head.lower }}_bytes_t *)obj->Data;
    (void)node;
    value->offset = 0u;
    if (width == 0u) {
        return *value->length;
    }
    return width < value->room ? width : value->room;
}

static CO_ERR {{ head.lower }}_bytes_read(struct CO_OBJ_T *obj, struct CO_NODE_T *node, void *buffer, uint32_t size)
{
    {{ head.lower }}_bytes_t *const value = ({{ head.lower }}_bytes_t *)obj->Data;
    const uint32_t count = {{ head.lower }}_rest(*value->length, value->offset, size);
    (void)node;
    memcpy(buffer, value->bytes + value->offset, count);
    value->offset += count;
    return CO_ERR_NONE;
}

static CO_ERR {{ head.lower }}_bytes_write(struct CO_OBJ_T *obj, struct CO_NODE_T *node, void *buffer, uint32_t size)
{
    {{ head.lower }}_bytes_t *const value = ({{ head.lower }}_bytes_t *)obj->Data;
    const uint32_t count = {{ head.lower }}_rest(value->room, value->offset, size);
    (void)node;
    memcpy(value->bytes + value->offset, buffer, count);
    value->offset += count;
    *value->length = (uint16_t)value->offset;
    return count == size ? CO_ERR_NONE : CO_ERR_OBJ_SIZE;
}

static CO_ERR {{ head.lower }}_bytes_reset(struct CO_OBJ_T *obj, struct CO_NODE_T *node, uint32_t para)
{
    (void)node;
    (({{ head.lower }}_bytes_t *)obj->Data)->offset = para;
    return CO_ERR_NONE;
}

{% if !self.shares(RowType::Bytes) %}static {% endif %}const CO_OBJ_TYPE {{ head.lower }}_bytes = {
    {{ head.lower }}_bytes_size, NULL, {{ head.lower }}_bytes_read, {{ head.lower }}_bytes_write, {{ head.lower }}_bytes_reset,
};
{%- endif %}
{%- for group in layout.groups %}

/* The values of the storage group {{ group.name|c_comment }}. */
{{ group.variable }}_t {{ group.variable }} = {
{%- for member in group.members %}
    .{{ member.name }} = {{ member.initializer }},
{%- endfor %}
};
const {{ group.variable }}_t {{ group.variable }}_defaults = {
{%- for member in group.members %}
    .{{ member.name }} = {{ member.initializer }},
{%- endfor %}
};
{%- endfor %}
{%- if !layout.variables.is_empty() %}

/* The variable values. */
{%- for member in layout.variables %}
{{ layout::definition(member) }} = {{ member.initializer }};
{%- endfor %}
{%- endif %}
{%- if !layout.definitions.is_empty() %}

/* Constants, and additional data for types of the stack. */
{%- for definition in layout.definitions %}
static {{ definition.declaration() }} = {{ definition.initializer }};
{%- endfor %}
{%- endif %}
{%- if parameters.nothing %}

static const uint8_t {{ head.lower }}_nothing = 0u;
{%- endif %}
{%- if !parameters.store.is_empty() %}

/* Parameter groups stored by 1010h. */
static const CO_PARA {{ head.lower }}_store[] = {
{%- for line in parameters.store %}
    {{ line }}
{%- endfor %}
};
{%- endif %}
{%- if !parameters.restore.is_empty() %}

/* Parameter groups restored by 1011h. */
static const CO_PARA {{ head.lower }}_restore[] = {
{%- for line in parameters.restore %}
    {{ line }}
{%- endfor %}
};
{%- endif %}

const CO_OBJ {{ head.lower }}_objects[{{ head.upper }}_LEN + 1u] = {
{%- for row in rows %}
    {CO_KEY(0x{{ row.index|hex4 }}, 0x{{ row.sub|hex2 }}, {{ row.flags }}), {{ row.type_name(&head.lower) }}, (CO_DATA){{ row.data }}}, /* {{ row.name|c_comment }} */
{%- endfor %}
    CO_OBJ_DICT_ENDMARK
};
