{# CanOpenNodeView<'_>::source #}
{%- let od = prefix.as_str() -%}
/*
 * {{ head.made_by }}; do not edit.
 *
 * Object dictionary of {{ head.product|c_comment }} by {{ head.vendor|c_comment }} for CANopenNode 4.
 */
#define OD_DEFINITION
#include "301/CO_ODinterface.h"
#include "{{ head.stem }}.h"
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
{%- match object.layout %}
{%- when ObjectLayout::Var(_) %}
    OD_obj_var_t o_{{ object.name() }};
{%- when ObjectLayout::Array(_, _) %}
    OD_obj_array_t o_{{ object.name() }};
{%- when ObjectLayout::Record(members) %}
    OD_obj_record_t o_{{ object.name() }}[{{ members.len() }}];
{%- endmatch %}
{%- endfor %}
} ODObjs_t;

static CO_PROGMEM ODObjs_t ODObjs = {
{%- for object in objects %}
    .o_{{ object.name() }} = {
    {%- match object.layout %}
    {%- when ObjectLayout::Var(member) %}
        .dataOrig = {{ object.address(member, od) }},
        .attribute = {{ member.storage.attribute }},
        .dataLength = {{ member.storage.length }},
    {%- when ObjectLayout::Array(sub0, elements) %}
    {%- let storage = elements[0].storage %}
        .dataOrig0 = {{ object.address(sub0, od) }},
        .dataOrig = {{ object.address(&elements[0], od) }},
        .attribute0 = {{ sub0.storage.attribute }},
        .attribute = {{ storage.attribute }},
        .dataElementLength = {{ storage.length }},
        .dataElementSizeof = {% if let Some(type_) = storage.type_ %}sizeof({{ type_ }}{{ storage.dimension() }}){% else %}0{% endif %},
    {%- when ObjectLayout::Record(members) %}
    {%- for member in members %}
        {.dataOrig = {{ object.address(member, od) }}, .subIndex = {{ member.entry.sub }}, .attribute = {{ member.storage.attribute }}, .dataLength = {{ member.storage.length }}},
    {%- endfor %}
    {%- endmatch %}
    },
{%- endfor %}
};

/* All objects, by index. */
static {{ od }}_ATTR_OD OD_entry_t ODList[] = {
{%- for object in objects %}
    {0x{{ object.index|hex4 }}, 0x{{ "{:02X}"|format(object.members().count()) }}, ODT_{{ object.kind() }}, &ODObjs.o_{{ object.name() }}, NULL},
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
