{# CanOpenNodeV1View<'_>::source #}
/*
 * {{ head.made_by }}; do not edit.
 *
 * Object dictionary of {{ head.product|c_comment }} by {{ head.vendor|c_comment }}, for CANopenNode 1.3.
 */
#include "CO_driver.h"
#include "CO_OD.h"
#include "CO_SDO.h"
{%- for location in ValueLocation::ALL %}

struct sCO_OD_{{ location.name() }} CO_OD_{{ location.name() }} = {
    CO_OD_FIRST_LAST_WORD,
{%- for variable in plan.of(location) %}
    {{ variable.initializer }}, /* {{ variable.index|hex4 }}h */
{%- endfor %}
    CO_OD_FIRST_LAST_WORD,
};
{%- endfor %}

/* What a sub-index without an entry refers to: not constant, as the stack declares the data of all rows. */
UNSIGNED8 CO_OD_noEntry = 0u;

/* The rows of records, by sub-index. */
{%- for object in plan.rows %}
{%- if !object.record.is_empty() %}
const CO_OD_entryRecord_t OD_record{{ plan.hex(object.index) }}[{{ object.record.len() }}] = {
{%- for row in object.record %}
    {(void *){{ row.data }}, 0x{{ row.attribute|hex4 }}, {{ row.length }}},
{%- endfor %}
};
{%- endif %}
{%- endfor %}

const CO_OD_entry_t CO_OD[CO_OD_NoOfElements] = {
{%- for object in plan.rows %}
    {0x{{ object.index|hex4 }}, {{ object.max_sub }}, 0x{{ object.row.attribute|hex4 }}, {{ object.row.length }}, (void *){{ object.row.data }}}, /* {{ object.described|c_comment }} */
{%- endfor %}
};
{%- if !plan.formulas.is_empty() %}
{%- if self.stores_bytes() %}

static void CO_OD_store(UNSIGNED8 *bytes, UNSIGNED64 number, unsigned size)
{
    unsigned at;
    for (at = 0u; at < size; at++) {
        bytes[at] = (UNSIGNED8)(number >> (8u * at));
    }
}
{%- endif %}

void CO_OD_applyNodeId(uint8_t nodeId)
{
{%- for formula in plan.formulas %}
    {{ formula }}
{%- endfor %}
}
{%- endif %}
{%- if !hooks.is_empty() %}
{% for index in hooks %}
CO_SDO_abortCode_t CO_OD_hook{{ index }}(CO_ODF_arg_t *ODF_arg);
{%- endfor %}

void CO_OD_initHooks(void *SDO, void *object)
{
{%- for index in hooks %}
    CO_OD_configure((CO_SDO_t *)SDO, 0x{{ index }}u, CO_OD_hook{{ index }}, object, 0, 0u);
{%- endfor %}
}
{%- endif %}
