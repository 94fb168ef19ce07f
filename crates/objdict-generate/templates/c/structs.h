{# CView<'_>::structs_header #}
/**
 * @file
 * {{ table.head.made_by }}; do not edit.
 *
 * Object dictionary of {{ table.head.product|doxygen }} by {{ table.head.vendor|doxygen }}.
 *
 * {{ lower }}_entries is an array of structures, one per entry; {{ lower }}_data contains the variable values.
 */
#ifndef {{ upper }}_H
#define {{ upper }}_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif
{%- if let Some(node_id) = table.node_id %}

/** The configured node-ID. */
#define {{ upper }}_NODE_ID {{ node_id }}u
{%- endif %}

/* Indexes of objects and sub-indexes of their entries. */
{%- for view in objects %}

/** {{ view.object.index|hex4 }}h: {{ view.object.name|doxygen }} */
#define {{ upper }}_{{ view.name }} 0x{{ view.object.index|hex4 }}u
{%- for (name, row) in view.entries %}
#define {{ upper }}_{{ name }} 0x{{ row.sub|hex2 }}u /**< {{ row.name|doxygen }} */
{%- endfor %}
{%- endfor %}

{% include "_defaults.h" %}
{%- if let Some(meanings) = meanings %}

{{ meanings.text() }}
{%- endif %}

{%- if self.has_time() || !groups.is_empty() %}
/** A time of day since 1984-01-01, or a time difference. */
typedef struct {
    uint32_t milliseconds; /**< after midnight, 28 bits */
    uint16_t days;
} {{ lower }}_time_t;
{%- endif %}
{%- for group in groups %}

/** The storage group {{ group.group.name|doxygen }}. */
typedef struct {
{%- for field in group.fields %}
    {{ field.declaration }}; /**< {{ field.first.index|hex4 }}h sub-index {{ field.first.sub|hex2 }}h
    {%- if field.array %} to {{ field.last.sub|hex2 }}h{% endif %}, {{ field.first.access() }}: {{ field.first.name|doxygen }} */
{%- endfor %}
} {{ group.lower }}_t;
{%- endfor %}

/** The variable values; constants are in flash. A string, octet string or DOMAIN is preceded by its length. */
typedef struct {
    uint8_t node_id; /**< set by {{ lower }}_init() */
{%- for member in fields %}
{%- match member %}
{%- when MemberView::Field(field) %}
    {{ field.declaration }}; /**< {{ field.first.index|hex4 }}h sub-index {{ field.first.sub|hex2 }}h
    {%- if field.array %} to {{ field.last.sub|hex2 }}h{% endif %}, {{ field.first.access() }}: {{ field.first.name|doxygen }} */
{%- when MemberView::Group(group) %}
    {{ group.lower }}_t {{ group.group.field }}; /**< the storage group {{ group.group.name|doxygen }} */
{%- endmatch %}
{%- endfor %}
} {{ lower }}_data_t;
extern {{ lower }}_data_t {{ lower }}_data;

/** An entry of the dictionary. data, low, high and def point to the C type of the data type as in
   {{ lower }}_data_t; an integer of 24 to 56 bits uses the next larger type. */
typedef struct {
    uint16_t index;
    uint8_t sub;
    uint8_t data_type; /**< {{ upper }}_UNSIGNED32 and the like */
    uint8_t flags;     /**< {{ upper }}_READ and the like */
    uint16_t size;     /**< maximum size of a value in an SDO transfer, in bytes */
    void *data;        /**< the value; for a constant, its default in flash. NULL: the application must provide it */
    const void *low;   /**< limits; NULL if there are none */
    const void *high;
    const void *def;   /**< the default */
{%- if names %}
    const char *name; /**< the name in the description, UTF-8 */
{%- endif %}
} {{ lower }}_entry_t;

/* Flags of an entry. */
#define {{ upper }}_READ 0x01u            /**< readable by SDO */
#define {{ upper }}_WRITE 0x02u           /**< writable by SDO */
#define {{ upper }}_TPDO 0x04u            /**< mappable to TPDOs */
#define {{ upper }}_RPDO 0x08u            /**< mappable to RPDOs */
#define {{ upper }}_NODE_ID_DEFAULT 0x10u /**< the node-ID must be added to the default */
#define {{ upper }}_LOW_NODE_ID 0x20u     /**< the node-ID is to be added to the low limit */
#define {{ upper }}_HIGH_NODE_ID 0x40u    /**< the node-ID is to be added to the high limit */
{%- if hooks %}
#define {{ upper }}_HOOK 0x80u           /**< selected with --hook: the application handles reads and writes */
{%- endif %}

/* Data types, by their index in CiA 301. */
{% include "_types.h" %}

/** All entries in ascending order of index and sub-index. */
#define {{ upper }}_ENTRY_COUNT {{ table.rows.len() }}u
extern const {{ lower }}_entry_t {{ lower }}_entries[{{ upper }}_ENTRY_COUNT];

/** Finds the entry with an index and a sub-index by binary search; NULL if there is none. */
const {{ lower }}_entry_t *{{ lower }}_find(uint16_t index, uint8_t sub);

/** Sets all values to the defaults for node_id, 1 to 127; only the lower seven bits are used. */
void {{ lower }}_init(uint8_t node_id);
{%- if !groups.is_empty() %}

{% include "_stored.h" %}
{%- endif %}

#ifdef __cplusplus
}
#endif

#endif
