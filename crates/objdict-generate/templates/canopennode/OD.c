{%- let od = prefix.as_str() -%}
/*
 * {{ head.made_by }}; do not edit.
 *
 * Object dictionary of {{ head.product|c_comment }} by {{ head.vendor|c_comment }} for CANopenNode 4.
 */
#define OD_DEFINITION
#include "301/CO_ODinterface.h"
#include "{{ od }}.h"
{%- if self.has_math() %}

#include <math.h>
{%- endif %}
{%- if limits.is_some() %}

#include <string.h>
{%- endif %}

#if CO_VERSION_MAJOR < 4
#error this object dictionary is for CANopenNode 4
#endif

/* Values by storage group. Formulas do not include the node-ID. */
{%- for group in groups %}
{{ od }}_ATTR_{{ group.name }} {{ od }}_{{ group.name }}_t {{ od }}_{{ group.name }} = {
{%- for field in group.fields %}
    {{ field.initialiser }},
{%- endfor %}
};
{% endfor %}
/* Object descriptors. */
typedef struct {
{%- for object in objects %}
    OD_obj_{{ object.kind().1 }}_t o_{{ object.name() }}{{ object.dimension() }};
{%- endfor %}
} ODObjs_t;

static CO_PROGMEM ODObjs_t ODObjs = {
{%- for object in objects %}
    .o_{{ object.name() }} = {
    {%- for line in object.lines(od) %}
        {{ line }},
    {%- endfor %}
    },
{%- endfor %}
};

/* All objects, by index. */
static {{ od }}_ATTR_OD OD_entry_t ODList[] = {
{%- for object in objects %}
    {0x{{ object.index|hex4 }}, 0x{{ "{:02X}"|format(object.members().count()) }}, ODT_{{ object.kind().0 }}, &ODObjs.o_{{ object.name() }}, NULL},
{%- endfor %}
    {0x0000, 0x00, 0, NULL, NULL}
};

static OD_t _{{ od }} = {
    (sizeof(ODList) / sizeof(ODList[0])) - 1,
    &ODList[0]
};

OD_t *{{ od }} = &_{{ od }};
{%- if self.sets_bytes() %}

/* Sets a value stored as bytes. */
static void setBytes(uint8_t *bytes, uint8_t length, uint64_t value)
{
    for (uint8_t i = 0; i < length; i++) {
        bytes[i] = (uint8_t)(value & 0xFFU);
        value >>= 8;
    }
}
{%- endif %}

void {{ od }}_applyNodeId(uint8_t nodeId)
{
{%- if applied.is_empty() %}
    (void)nodeId;
{%- else %}
    const uint32_t id = nodeId & 0x7FU;
{%- for statement in applied %}
    {{ statement }}
{%- endfor %}
{%- endif %}
}
{%- if !hooks.is_empty() %}

static OD_extension_t hookExtensions[{{ hooks.len() }}] = {
{%- for hook in hooks %}
    {.read = {% if hook.is_read %}{{ od }}_read_H{{ hook.index|hex4 }}{% else %}OD_readOriginal{% endif %},
     .write = {% if hook.is_written %}{{ od }}_write_H{{ hook.index|hex4 }}{% else %}OD_writeOriginal{% endif %}},
{%- endfor %}
};

void {{ od }}_initHooks(void *object)
{
{%- for hook in hooks %}
    hookExtensions[{{ loop.index0 }}].object = object;
    (void)OD_extension_init(&ODList[{{ hook.position }}], &hookExtensions[{{ loop.index0 }}]);
{%- endfor %}
}
{%- endif %}
{%- if let Some(limits) = self.limits %}
{% include "canopennode/limits.c" %}
{%- endif %}
