{# CanOpenStackView<'_>::header #}
/*
 * {{ head.made_by }}; do not edit.
 *
 * Object dictionary of {{ head.product|c_comment }} by {{ head.vendor|c_comment }}, for canopen-stack 4.4.
 */
#ifndef {{ head.upper }}_CANOPEN_STACK_H
#define {{ head.upper }}_CANOPEN_STACK_H

#include "co_core.h"

#ifdef __cplusplus
extern "C" {
#endif
{%- if let Some(node_id) = dictionary.node_id %}

/* The configured node-ID. */
#define {{ head.upper }}_NODE_ID {{ node_id }}u
{%- endif %}

/* Minimum configuration of the stack: CO_SSDO_N and so on, up to the highest number in use. */
{%- for (name, count, what, _) in self.counts() %}
#define {{ head.upper }}_{{ name }}_N {{ count }} /* {{ what }} */
{%- endfor %}

/* The dictionary: the rows by key, followed by the end mark. */
#define {{ head.upper }}_LEN {{ rows.len() }}u
extern const CO_OBJ {{ head.lower }}_objects[{{ head.upper }}_LEN + 1u];
{%- for group in layout.groups %}

/* The values of the storage group {{ group.name|c_comment }}. */
typedef struct {
{%- for member in group.members %}
    {{ member.declaration() }}; /* {{ layout::place(member) }}: {{ member.described|c_comment }} */
{%- endfor %}
} {{ group.variable }}_t;
extern {{ group.variable }}_t {{ group.variable }};
extern const {{ group.variable }}_t {{ group.variable }}_defaults;
{%- endfor %}
{%- if !layout.variables.is_empty() %}

/* The variable values. */
{%- for member in layout.variables %}
{%- if let Some(structure) = layout::own_type(member) %}
typedef {{ structure }} {{ member.name }}_t;
{%- endif %}
extern {{ layout::definition(member) }}; /* {{ layout::place(member) }}: {{ member.described|c_comment }} */
{%- endfor %}
{%- endif %}
{%- if self.shares(RowType::Block) || self.shares(RowType::Bytes) %}

/* Types of this file that those below replace. */
{%- if self.shares(RowType::Block) %}
extern const CO_OBJ_TYPE {{ head.lower }}_block;
{%- endif %}
{%- if self.shares(RowType::Bytes) %}
extern const CO_OBJ_TYPE {{ head.lower }}_bytes;
{%- endif %}
{%- endif %}
{%- if !hooks.is_empty() %}

/*
 * Types that the application defines, each in place of those beside it, whose functions it can call:
 * `(CO_TUNSIGNED16)->Write(obj, node, buffer, size)`. `CO_GET_SUB(obj->Key)` is the sub-index.
 */
{%- for hook in hooks %}
extern const CO_OBJ_TYPE {{ head.lower }}_{{ hook.name() }}; /* {{ hook.replaced.join(", ") }} */
{%- endfor %}
{%- endif %}

#ifdef __cplusplus
}
#endif

#endif
