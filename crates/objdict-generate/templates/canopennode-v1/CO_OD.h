{# CanOpenNodeV1View<'_>::header #}
/*
 * {{ head.made_by }}; do not edit.
 *
 * Object dictionary of {{ head.product|c_comment }} by {{ head.vendor|c_comment }}, for CANopenNode 1.3.
 */
#ifndef CO_OD_H
#define CO_OD_H

typedef bool_t BOOLEAN;
typedef uint8_t UNSIGNED8;
typedef uint16_t UNSIGNED16;
typedef uint32_t UNSIGNED32;
typedef uint64_t UNSIGNED64;
typedef int8_t INTEGER8;
typedef int16_t INTEGER16;
typedef int32_t INTEGER32;
typedef int64_t INTEGER64;
typedef float REAL32;
typedef double REAL64;
typedef char VISIBLE_STRING;
typedef unsigned char OCTET_STRING;

/* What the stack is compiled for. */
#define CO_NO_SYNC {{ self.has(0x1005) }}
#define CO_NO_TIME {{ self.has(0x1012) }}
#define CO_NO_EMERGENCY 1
#define CO_NO_SDO_SERVER {{ plan.counts[0] }}
#define CO_NO_SDO_CLIENT {{ plan.counts[1] }}
#define CO_NO_RPDO {{ plan.counts[2] }}
#define CO_NO_TPDO {{ plan.counts[4] }}
#define CO_NO_NMT_MASTER {{ self.is_master() }}
#define CO_NO_TRACE 0
#define CO_NO_LSS_SERVER {{ self.has_lss() }}
#define CO_NO_LSS_CLIENT {{ self.has_lss_master() }}

#define CO_OD_NoOfElements {{ plan.rows.len() }}

/* Records. */
{%- for record in plan.types %}
typedef struct { /* {{ record.index|hex4 }}h */
{%- for member in record.members %}
    {{ member }};
{%- endfor %}
} {{ record.name }};
{%- endfor %}

/* The indexes and sub-indexes of objects. */
{%- for (name, value) in plan.numbers %}
#define {{ name }} {{ value }}
{%- endfor %}

/* The first and the last word of each memory: other values mean that it has other contents. */
#define CO_OD_FIRST_LAST_WORD 0x55
{%- for location in ValueLocation::ALL %}

struct sCO_OD_{{ location.name() }} {
    UNSIGNED32 FirstWord;
{%- for variable in plan.of(location) %}
    {{ variable.declaration }}; /* {{ variable.index|hex4 }}h */
{%- endfor %}
    UNSIGNED32 LastWord;
};
extern struct sCO_OD_{{ location.name() }} CO_OD_{{ location.name() }};
{%- endfor %}

/* The variables, their lengths, and the elements of arrays. */
{%- for (name, value) in plan.aliases %}
#define {{ name }} {{ value }}
{%- endfor %}
{%- if !plan.formulas.is_empty() %}

/* Adds the node-ID to the values that are formulas and to which the stack does not add it. */
void CO_OD_applyNodeId(uint8_t nodeId);
{%- endif %}
{%- if let Some(first) = hooks.first() %}

/*
 * Has the SDO server call the functions of the application, `CO_SDO_abortCode_t CO_OD_hook{{ first }}(CO_ODF_arg_t *ODF_arg)` and so on,
 * with `object` in `ODF_arg->object`: before an upload sends `ODF_arg->data`, and before a download writes it. Call it after
 * CO_CANopenInit() with `CO->SDO[0]`.
 */
void CO_OD_initHooks(void *SDO, void *object);
{%- endif %}

#endif
