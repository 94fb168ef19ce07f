{# CanFestivalView<'_>::source #}
/*
 * {{ head.made_by }}; do not edit.
 *
 * Object dictionary of {{ head.product|c_comment }} by {{ head.vendor|c_comment }}, for CanFestival 3.
 * Numbers of 24 and of 40 to 56 bits and times are bytes, for a little-endian processor.
 *
 * With {{ head.upper }}_CALLBACK_IN_ROW it is for forks of the stack whose rows have a callback.
 */
#include "{{ head.stem }}.h"

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#ifdef {{ head.upper }}_CALLBACK_IN_ROW
#define {{ head.upper }}_ROW(access, type, size, object) {access, type, size, (void *)(object), NULL}
#define {{ head.upper }}_ROWS static subindex
#else
#define {{ head.upper }}_ROW(access, type, size, object) {access, type, size, (void *)(object)}
#define {{ head.upper }}_ROWS static const subindex
#endif

/* The variables. */
{%- for definition in plan.definitions %}
{% if definition.is_constant() %}static {% endif %}{{ definition.declaration() }} = {{ definition.initializer }}; /* {{ definition.described }} */
{%- endfor %}

UNS32 {{ head.lower }}_zero = 0u;

/* The node-ID. */
UNS8 {{ head.lower }}_bDeviceNodeId = {{ dictionary.node_id.unwrap_or(0) }}u;
const UNS8 {{ head.lower }}_iam_a_slave = {{ self.is_slave() }}u;
TIMER_HANDLE {{ head.lower }}_heartBeatTimers[{{ plan.consumers }}] = {
{%- for _ in 0..plan.consumers %}
    TIMER_NONE,
{%- endfor %}
};
{%- if plan.ranges.unsigned %}

static UNS64 {{ head.lower }}_unsigned(const void *value, unsigned size)
{
    UNS64 number = 0u;
    while (size > 0u) {
        size--;
        number = (number << 8) | ((const UNS8 *)value)[size];
    }
    return number;
}
{%- endif %}
{%- if plan.ranges.signed %}

static INTEGER64 {{ head.lower }}_signed(const void *value, unsigned size)
{
    const UNS64 sign = UINT64_C(1) << (8u * size - 1u);
    return (INTEGER64)(({{ head.lower }}_unsigned(value, size) ^ sign) - sign);
}
{%- endif %}

/* Limits: types of the dictionary that the stack has no numbers for. The abort codes are those of CiA 301. */
#define valueRange_EMC 0x9F
{%- for range in plan.ranges.list %}
#define {{ range.name() }} 0x{{ range.code|hex2 }}
{%- endfor %}

UNS32 {{ head.lower }}_valueRangeTest(UNS8 typeValue, void *value)
{
    switch (typeValue) {
    case valueRange_EMC:
        return *(UNS8 *)value == 0u ? 0u : 0x06090030u;
{%- for range in plan.ranges.list %}
    case {{ range.name() }}: { /* {{ range.type_name() }} */
        {{ range.declaration }}
{%- if let Some(condition) = range.too_low %}
        if ({{ condition }}) {
            return 0x06090032u;
        }
{%- endif %}
{%- if let Some(condition) = range.too_high %}
        if ({{ condition }}) {
            return 0x06090031u;
        }
{%- endif %}
        return 0u;
    }
{%- endfor %}
    default:
        return 0u;
    }
}
{%- for object in plan.objects %}

/* {{ object.index|hex4 }}h: {{ object.name|c_comment }} */
{%- if object.callbacks %}
#ifndef {{ head.upper }}_CALLBACK_IN_ROW
static ODCallback_t {{ head.lower }}_Index{{ object.index|hex4 }}_callbacks[{{ object.rows.len() }}] = {NULL};
#endif
{%- endif %}
{{ head.upper }}_ROWS {{ head.lower }}_Index{{ object.index|hex4 }}[{{ object.rows.len() }}] = {
{%- for row in object.rows %}
    {{ head.upper }}_ROW({{ row.access }}, {{ row.data_type }}, {{ row.size }}u, &{{ row.object }}),
{%- endfor %}
};
{%- endfor %}
{%- if slots.has(ListSlot::Server) %}

/* The SDO server, which a node also has without 1200h. */
static UNS32 {{ head.lower }}_serverCobIds[2] = {0x{{ self.server_cob_id(0x600) }}u, 0x{{ self.server_cob_id(0x580) }}u};
{{ head.upper }}_ROWS {{ head.lower }}_server[3] = {
    {{ head.upper }}_ROW(RO, uint8, 1u, &{{ head.lower }}_zero),
    {{ head.upper }}_ROW(RO, uint32, 4u, &{{ head.lower }}_serverCobIds[0]),
    {{ head.upper }}_ROW(RO, uint32, 4u, &{{ head.lower }}_serverCobIds[1]),
};
{%- endif %}
{%- if slots.has(ListSlot::NoPdo) %}

/* The parameters of a mapping without any: a PDO that is not valid. */
static UNS32 {{ head.lower }}_noCobId = 0x80000000u;
{{ head.upper }}_ROWS {{ head.lower }}_noPdo[6] = {
    {{ head.upper }}_ROW(RO, uint8, 1u, &{{ head.lower }}_zero),
    {{ head.upper }}_ROW(RO, uint32, 4u, &{{ head.lower }}_noCobId),
    {{ head.upper }}_ROW(RO, uint8, 1u, &{{ head.lower }}_zero),
    {{ head.upper }}_ROW(RO, uint16, 2u, &{{ head.lower }}_zero),
    {{ head.upper }}_ROW(RO, uint8, 1u, &{{ head.lower }}_zero),
    {{ head.upper }}_ROW(RO, uint16, 2u, &{{ head.lower }}_zero),
};
{%- endif %}
{%- if slots.has(ListSlot::NoMapping) %}

/* The mapping of a PDO without any. */
{{ head.upper }}_ROWS {{ head.lower }}_noMapping[2] = {
    {{ head.upper }}_ROW(RO, uint8, 1u, &{{ head.lower }}_zero),
    {{ head.upper }}_ROW(RO, uint32, 4u, &{{ head.lower }}_zero),
};
{%- endif %}

const indextable {{ head.lower }}_objdict[] = {
{%- for slot in slots.list %}
{%- match slot %}
{%- when ListSlot::Object(number) %}
{%- let object = plan.objects[*number] %}
    {(subindex *){{ head.lower }}_Index{{ object.index|hex4 }}, {{ object.rows.len() }}u, 0x{{ object.index|hex4 }}u},
{%- when ListSlot::Nothing %}
    {NULL, 0u, 0u},
{%- when ListSlot::NoPdo %}
    {(subindex *){{ head.lower }}_noPdo, 6u, 0u},
{%- when ListSlot::Server %}
    {(subindex *){{ head.lower }}_server, 3u, 0u},
{%- when ListSlot::NoMapping %}
    {(subindex *){{ head.lower }}_noMapping, 2u, 0u},
{%- endmatch %}
{%- endfor %}
};

#ifdef {{ head.upper }}_CALLBACK_IN_ROW
#define {{ head.upper }}_CALLBACKS(array)
const indextable *{{ head.lower }}_scanIndexOD(CO_Data *d, UNS16 wIndex, UNS32 *errorCode)
#else
#define {{ head.upper }}_CALLBACKS(array) *callbacks = array;
const indextable *{{ head.lower }}_scanIndexOD(UNS16 wIndex, UNS32 *errorCode, ODCallback_t **callbacks)
#endif
{
    int i;
#ifdef {{ head.upper }}_CALLBACK_IN_ROW
    (void)d;
#else
    *callbacks = NULL;
#endif
    switch (wIndex) {
{%- for (position, number) in self.positions() %}
{%- let object = plan.objects[number] %}
    case 0x{{ object.index|hex4 }}: i = {{ position }};{% if object.callbacks %} {{ head.upper }}_CALLBACKS({{ head.lower }}_Index{{ object.index|hex4 }}_callbacks){% endif %} break;
{%- endfor %}
    default:
        *errorCode = OD_NO_SUCH_OBJECT;
        return NULL;
    }
    *errorCode = OD_SUCCESSFUL;
    return &{{ head.lower }}_objdict[i];
}

/* The TPDOs. */
s_PDO_status {{ head.lower }}_PDO_status[{{ slots.transmitted() }}] = {
{%- for _ in 0..slots.transmitted() %}
    s_PDO_status_Initializer,
{%- endfor %}
};

/* SDO servers and clients, RPDOs and their mappings, TPDOs and their mappings. */
const quick_index {{ head.lower }}_firstIndex = { {%- for position in slots.first %}{% if !loop.first %}, {% endif %}{{ position }}u{% endfor -%} };
const quick_index {{ head.lower }}_lastIndex = { {%- for position in slots.last %}{% if !loop.first %}, {% endif %}{{ position }}u{% endfor -%} };
const UNS16 {{ head.lower }}_ObjdictSize = sizeof({{ head.lower }}_objdict) / sizeof({{ head.lower }}_objdict[0]);

CO_Data {{ head.lower }}_Data = CANOPEN_NODE_DATA_INITIALIZER({{ head.lower }});
{%- if !plan.formulas.is_empty() %}
{%- if self.stores_bytes() %}

static void {{ head.lower }}_store(UNS8 *bytes, UNS64 number, unsigned size)
{
    unsigned at;
    for (at = 0u; at < size; at++) {
        bytes[at] = (UNS8)(number >> (8u * at));
    }
}
{%- endif %}

void {{ head.lower }}_applyNodeId(UNS8 nodeId)
{
{%- for formula in plan.formulas %}
    {{ formula }}
{%- endfor %}
}
{%- endif %}
