{# ObjdictMacrosView<'_>::source #}
/*
 * {{ head.made_by }}; do not edit.
 *
 * Object dictionary of {{ head.product|c_comment }} by {{ head.vendor|c_comment }}.
 */
#include "objdict.h"
{% for variable in variables %}
{{ variable.declaration() }} = {{ variable.initializer }};
{%- endfor %}

const OBJ_ENTRY gObjDict[NUM_OF_OBJ_ENTRIES] = {
{%- for row in rows %}
{%- if row.single %}
    SINGLE_OBJ(0x{{ row.index|hex4 }}, {{ row.length() }}, {{ row.address }}, {{ row.access() }}), /* {{ row.entry.entry.name|c_comment }} */
{%- else %}
    SUB_OBJ(0x{{ row.index|hex4 }}, 0x{{ row.entry.sub|hex2 }}, {{ row.length() }}, {{ row.address }}, {{ row.access() }}), /* {{ row.entry.entry.name|c_comment }} */
{%- endif %}
{%- endfor %}
};
