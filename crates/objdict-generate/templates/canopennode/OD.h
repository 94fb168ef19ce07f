{# CanOpenNodeView<'_>::header #}
{%- let od = prefix.as_str() -%}
/*
 * {{ head.made_by }}; do not edit.
 *
 * Object dictionary of {{ head.product|c_comment }} by {{ head.vendor|c_comment }} for CANopenNode 4.
 */
#ifndef {{ od }}_H
#define {{ od }}_H

#include "301/CO_ODinterface.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Number of objects per service of the stack. */
{%- for (label, count) in counters.iter() %}
#define {{ od }}_CNT_{{ label }} {{ count }}
{%- endfor %}

/* Number of elements per array. */
{%- for object in objects %}
{%- if let Some(count) = object.count %}
#define {{ od }}_CNT_ARR_{{ object.index|hex4 }} {{ count }}
{%- endif %}
{%- endfor %}

/* Values by storage group. */
{%- for group in groups %}
typedef struct {
{%- for field in group.fields %}
    {{ field.declaration }};
{%- endfor %}
} {{ od }}_{{ group.name }}_t;

#ifndef {{ od }}_ATTR_{{ group.name }}
#define {{ od }}_ATTR_{{ group.name }}
#endif
extern {{ od }}_ATTR_{{ group.name }} {{ od }}_{{ group.name }}_t {{ od }}_{{ group.name }};
{% endfor %}
#ifndef {{ od }}_ATTR_OD
#define {{ od }}_ATTR_OD
#endif
extern {{ od }}_ATTR_OD OD_t *{{ od }};

/* Entries of the list, by index. */
{%- for object in objects %}
#define {{ od }}_ENTRY_H{{ object.index|hex4 }} (&{{ od }}->list[{{ loop.index0 }}])
{%- endfor %}

/* Entries of the list, by index and name. */
{%- for object in objects %}
{%- if !object.cname.is_empty() %}
#define {{ od }}_ENTRY_H{{ object.name() }} (&{{ od }}->list[{{ loop.index0 }}])
{%- endif %}
{%- endfor %}
{%- if !self.has_consumers() %}

/* The stack also refers to these without heartbeat consumers. */
#define {{ od }}_CNT_ARR_1016 0
#define {{ od }}_ENTRY_H1016 NULL
{%- endif %}

/* Adds the node-ID, of which only the lower seven bits are used, to formulas that the stack does not evaluate. Call this when the
   node-ID is known, before CO_CANopenInit(), and again when it changes; restore stored values afterwards. */
void {{ od }}_applyNodeId(uint8_t nodeId);
{%- if let Some(first) = hooks.first() %}

/* Hooks: the application defines these functions, and {{ od }}_initHooks() attaches them before CO_CANopenInit(){% if limits.is_some() %} and {{ od }}_initLimits(){% endif %}.
   stream->subIndex is the entry, stream->object the argument of {{ od }}_initHooks(). A function that changes nothing calls
   OD_readOriginal() or {% if limits.is_some() %}{{ od }}_writeLimited(){% else %}OD_writeOriginal(){% endif %}:

   ODR_t {{ od }}_write_H{{ first.index|hex4 }}(OD_stream_t *stream, const void *buf, OD_size_t count, OD_size_t *countWritten)
   {
       const ODR_t answer = {% if limits.is_some() %}{{ od }}_writeLimited{% else %}OD_writeOriginal{% endif %}(stream, buf, count, countWritten);
       if (answer == ODR_OK) {
           use the new value
       }
       return answer;
   } */
void {{ od }}_initHooks(void *object);
{%- for hook in hooks %}
{%- if hook.is_read %}
ODR_t {{ od }}_read_H{{ hook.index|hex4 }}(OD_stream_t *stream, void *buf, OD_size_t count, OD_size_t *countRead);
{%- endif %}
{%- if hook.is_written %}
ODR_t {{ od }}_write_H{{ hook.index|hex4 }}(OD_stream_t *stream, const void *buf, OD_size_t count, OD_size_t *countWritten);
{%- endif %}
{%- endfor %}
{%- endif %}
{%- if limits.is_some() %}

/* Adds an extension that enforces limits to each object with limits and without an extension. The node-ID is for limits
   that are formulas. */
void {{ od }}_initLimits(uint8_t nodeId);

/* Writes a value if it is within its limits: for extensions of the application. */
ODR_t {{ od }}_writeLimited(OD_stream_t *stream, const void *buf, OD_size_t count, OD_size_t *countWritten);
{%- endif %}

/* The configuration of the stack for several object dictionaries. */
#ifdef CO_MULTIPLE_OD
#define {{ od }}_INIT_CONFIG(config) { \
{%- for (member, value) in self.config() %}
    (config).{{ member }} = {{ value }}; \
{%- endfor %}
}
#endif

#ifdef __cplusplus
}
#endif

#endif
