/*
 * {{ head.made_by }}; do not edit.
 *
 * The static device {{ head.product|c_comment }} by {{ head.vendor|c_comment }}, for Lely core 2.4.
 */
#include "{{ head.stem }}.h"

/* The members that the library has only where LELY_NO_CO_OBJ_NAME, _LIMITS and _DEFAULT are not set. */
#if LELY_NO_CO_OBJ_NAME
#define {{ head.upper }}_NAME(text)
#else
#define {{ head.upper }}_NAME(text) .name = text,
#endif
#if LELY_NO_CO_OBJ_LIMITS
#define {{ head.upper }}_MIN(...)
#define {{ head.upper }}_MAX(...)
#else
#define {{ head.upper }}_MIN(...) .min = {__VA_ARGS__},
#define {{ head.upper }}_MAX(...) .max = {__VA_ARGS__},
#endif
#if LELY_NO_CO_OBJ_DEFAULT
#define {{ head.upper }}_DEFAULT(...)
#else
#define {{ head.upper }}_DEFAULT(...) .def = {__VA_ARGS__},
#endif
{%- for object in objects %}

static const struct co_ssub {{ head.lower }}_{{ object.index|hex4 }}[] = {
{%- for row in object.rows %}
    {
        {{ head.upper }}_NAME({{ row.name }})
        .subidx = 0x{{ row.sub|hex2 }}u,
        .type = CO_DEFTYPE_{{ row.data_type }},
{%- if let Some((low, high)) = row.limits %}
        {{ head.upper }}_MIN({{ low }}) {{ head.upper }}_MAX({{ high }})
{%- endif %}
        {{ head.upper }}_DEFAULT({{ row.default }})
        .val = { {{- row.value -}} },
        .access = CO_ACCESS_{{ row.access }}, .pdo_mapping = {{ row.mapping }}, .flags = {{ row.flags }},
    },
{%- endfor %}
};
{%- endfor %}

static const struct co_sobj {{ head.lower }}_objects[] = {
{%- for object in objects %}
    { {{- head.upper }}_NAME({{ object.name }}) .idx = 0x{{ object.index|hex4 }}u, .code = {{ object.code }}, .nsub = {{ object.rows.len() }}u, .subs = {{ head.lower }}_{{ object.index|hex4 }}},
{%- endfor %}
};

const struct co_sdev {{ head.lower }}_sdev = {
{%- for (member, value) in head.members %}
    .{{ member }} = {{ value }},
{%- endfor %}
    .nobj = {{ objects.len() }}u,
    .objs = {{ head.lower }}_objects,
};
