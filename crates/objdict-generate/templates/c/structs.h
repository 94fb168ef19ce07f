/**
 * @file
 * {{ plain.table.head.made_by }}; do not edit.
 *
 * Object dictionary of {{ plain.table.head.product|doxygen }} by {{ plain.table.head.vendor|doxygen }}.
 *
 * {{ plain.lower }}_entries is an array of structures, one per entry; {{ plain.lower }}_data contains the variable values.
 */
#ifndef {{ plain.upper }}_H
#define {{ plain.upper }}_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif
{%- if let Some(node_id) = plain.table.node_id %}

/** The configured node-ID. */
#define {{ plain.upper }}_NODE_ID {{ node_id }}u
{%- endif %}

/* Indexes of objects and sub-indexes of their entries. */
{%- for view in plain.objects %}

/** {{ view.object.index|hex4 }}h: {{ view.object.name|doxygen }} */
#define {{ plain.upper }}_{{ view.name }} 0x{{ view.object.index|hex4 }}u
{%- for (name, row) in view.entries %}
#define {{ plain.upper }}_{{ name }} 0x{{ row.sub|hex2 }}u /**< {{ row.name|doxygen }} */
{%- endfor %}
{%- endfor %}

{{ plain.defaults }}
{%- if let Some(meanings) = plain.meanings %}

{{ meanings }}
{%- endif %}

{%- if time || !plain.groups.is_empty() %}
/** A time of day since 1984-01-01, or a time difference. */
typedef struct {
    uint32_t milliseconds; /**< after midnight, 28 bits */
    uint16_t days;
} {{ plain.lower }}_time_t;
{%- endif %}
{%- for group in plain.groups %}

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
    uint8_t node_id; /**< set by {{ plain.lower }}_init() */
{%- for member in fields() %}
{%- match member %}
{%- when MemberView::Field(field) %}
    {{ field.declaration }}; /**< {{ field.first.index|hex4 }}h sub-index {{ field.first.sub|hex2 }}h
    {%- if field.array %} to {{ field.last.sub|hex2 }}h{% endif %}, {{ field.first.access() }}: {{ field.first.name|doxygen }} */
{%- when MemberView::Group(group) %}
    {{ group.lower }}_t {{ group.group.field }}; /**< the storage group {{ group.group.name|doxygen }} */
{%- endmatch %}
{%- endfor %}
} {{ plain.lower }}_data_t;
extern {{ plain.lower }}_data_t {{ plain.lower }}_data;

/** An entry of the dictionary. data, low, high and def point to the C type of the data type as in
   {{ plain.lower }}_data_t; an integer of 24 to 56 bits uses the next larger type. */
typedef struct {
    uint16_t index;
    uint8_t sub;
    uint8_t data_type; /**< {{ plain.upper }}_UNSIGNED32 and the like */
    uint8_t flags;     /**< {{ plain.upper }}_READ and the like */
    uint16_t size;     /**< maximum size of a value in an SDO transfer, in bytes */
    void *data;        /**< the value; for a constant, its default in flash. NULL: the application must provide it */
    const void *low;   /**< limits; NULL if there are none */
    const void *high;
    const void *def;   /**< the default */
{%- if names %}
    const char *name; /**< the name in the description, UTF-8 */
{%- endif %}
} {{ plain.lower }}_entry_t;

/* Flags of an entry. */
#define {{ plain.upper }}_READ 0x01u            /**< readable by SDO */
#define {{ plain.upper }}_WRITE 0x02u           /**< writable by SDO */
#define {{ plain.upper }}_TPDO 0x04u            /**< mappable to TPDOs */
#define {{ plain.upper }}_RPDO 0x08u            /**< mappable to RPDOs */
#define {{ plain.upper }}_NODE_ID_DEFAULT 0x10u /**< the node-ID must be added to the default */
#define {{ plain.upper }}_LOW_NODE_ID 0x20u     /**< the node-ID is to be added to the low limit */
#define {{ plain.upper }}_HIGH_NODE_ID 0x40u    /**< the node-ID is to be added to the high limit */
{%- if plain.hooks %}
#define {{ plain.upper }}_HOOK 0x80u           /**< selected with --hook: the application handles reads and writes */
{%- endif %}

/* Data types, by their index in CiA 301. */
#define {{ plain.upper }}_BLOCK 0x00u /**< a device-specific type */
#define {{ plain.upper }}_BOOLEAN 0x01u
#define {{ plain.upper }}_INTEGER8 0x02u
#define {{ plain.upper }}_INTEGER16 0x03u
#define {{ plain.upper }}_INTEGER32 0x04u
#define {{ plain.upper }}_UNSIGNED8 0x05u
#define {{ plain.upper }}_UNSIGNED16 0x06u
#define {{ plain.upper }}_UNSIGNED32 0x07u
#define {{ plain.upper }}_REAL32 0x08u
#define {{ plain.upper }}_VISIBLE_STRING 0x09u
#define {{ plain.upper }}_OCTET_STRING 0x0Au
#define {{ plain.upper }}_UNICODE_STRING 0x0Bu
#define {{ plain.upper }}_TIME_OF_DAY 0x0Cu
#define {{ plain.upper }}_TIME_DIFFERENCE 0x0Du
#define {{ plain.upper }}_DOMAIN 0x0Fu
#define {{ plain.upper }}_INTEGER24 0x10u
#define {{ plain.upper }}_REAL64 0x11u
#define {{ plain.upper }}_INTEGER40 0x12u
#define {{ plain.upper }}_INTEGER48 0x13u
#define {{ plain.upper }}_INTEGER56 0x14u
#define {{ plain.upper }}_INTEGER64 0x15u
#define {{ plain.upper }}_UNSIGNED24 0x16u
#define {{ plain.upper }}_UNSIGNED40 0x18u
#define {{ plain.upper }}_UNSIGNED48 0x19u
#define {{ plain.upper }}_UNSIGNED56 0x1Au
#define {{ plain.upper }}_UNSIGNED64 0x1Bu

/** All entries in ascending order of index and sub-index. */
#define {{ plain.upper }}_ENTRY_COUNT {{ plain.table.rows.len() }}u
extern const {{ plain.lower }}_entry_t {{ plain.lower }}_entries[{{ plain.upper }}_ENTRY_COUNT];

/** Finds the entry with an index and a sub-index by binary search; NULL if there is none. */
const {{ plain.lower }}_entry_t *{{ plain.lower }}_find(uint16_t index, uint8_t sub);

/** Sets all values to the defaults for node_id, 1 to 127; only the lower seven bits are used. */
void {{ plain.lower }}_init(uint8_t node_id);
{%- if !plain.groups.is_empty() %}
{%- let lower = plain.lower %}
{%- let upper = plain.upper.as_str() %}
{%- let groups = plain.groups.as_slice() %}

{% include "_stored.h" %}
{%- endif %}

#ifdef __cplusplus
}
#endif

#endif
