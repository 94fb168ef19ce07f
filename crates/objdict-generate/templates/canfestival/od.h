{# CanFestivalView<'_>::header #}
/*
 * {{ head.made_by }}; do not edit.
 *
 * Object dictionary of {{ head.product|c_comment }} by {{ head.vendor|c_comment }}, for CanFestival 3.
 */
#ifndef {{ head.upper }}_CANFESTIVAL_H
#define {{ head.upper }}_CANFESTIVAL_H

#include "data.h"

#ifdef __cplusplus
extern "C" {
#endif

UNS32 {{ head.lower }}_valueRangeTest(UNS8 typeValue, void *value);
#ifdef {{ head.upper }}_CALLBACK_IN_ROW
const indextable *{{ head.lower }}_scanIndexOD(CO_Data *d, UNS16 wIndex, UNS32 *errorCode);
#else
const indextable *{{ head.lower }}_scanIndexOD(UNS16 wIndex, UNS32 *errorCode, ODCallback_t **callbacks);
#endif

/* The state of the node, for the functions of the stack. */
extern CO_Data {{ head.lower }}_Data;
{%- if !plan.formulas.is_empty() %}

/* Adds the node-ID to all values that are formulas. Call it after setNodeId(), and before stored values are restored. */
void {{ head.lower }}_applyNodeId(UNS8 nodeId);
{%- endif %}

/* What a row without an entry refers to. */
extern UNS32 {{ head.lower }}_zero;

/* The variables. */
{%- for definition in plan.definitions %}
{%- if !definition.is_constant() %}
extern {{ definition.declaration() }}; /* {{ definition.described }} */
{%- endif %}
{%- endfor %}

#ifdef __cplusplus
}
#endif

#endif
