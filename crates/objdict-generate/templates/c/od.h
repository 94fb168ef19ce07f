{# CView<'_>::header #}
/**
 * @file
 * {{ table.head.made_by }}; do not edit.
 *
 * Object dictionary of {{ table.head.product|doxygen }} by {{ table.head.vendor|doxygen }}.
 *
 * {{ lower }}_data_t contains the variable values, {{ lower }}_read() and {{ lower }}_write() implement SDO access.
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

/** A time of day since 1984-01-01, or a time difference. */
typedef struct {
    uint32_t milliseconds; /**< after midnight, 28 bits */
    uint16_t days;
} {{ lower }}_time_t;
{%- for group in groups %}

/** The storage group {{ group.group.name|doxygen }}. */
typedef struct {
{%- for field in group.fields %}
    {{ field.declaration }}; /**< {{ field.first.index|hex4 }}h sub-index {{ field.first.sub|hex2 }}h
    {%- if field.array %} to {{ field.last.sub|hex2 }}h{% endif %}, {{ field.first.access() }}: {{ field.first.name|doxygen }} */
{%- endfor %}
} {{ group.lower }}_t;
{%- endfor %}

/** The variable values; constants are in flash. */
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

/** A location in {{ lower }}_data_t (0: none, the value is in flash) or in the defaults and limits. */
typedef {{ shared.offset() }} {{ lower }}_offset_t;

/** An entry of the dictionary; functions return what it has in common with others. */
typedef struct {
    uint8_t sub;
    {{ shared.kind() }} kind; /**< its data type and flags in {{ lower }}_kinds */
    {{ lower }}_offset_t ram;
    {{ lower }}_offset_t rom;
} {{ lower }}_entry_t;

/** An object of the dictionary. */
typedef struct {
    uint16_t index;
    {{ shared.first() }} first; /**< the number of its first entry; its last one is before that of the next object */
} {{ lower }}_object_t;

/* Flags of an entry. */
#define {{ upper }}_READ 0x001u            /**< readable by SDO */
#define {{ upper }}_WRITE 0x002u           /**< writable by SDO */
#define {{ upper }}_TPDO 0x004u            /**< mappable to TPDOs */
#define {{ upper }}_RPDO 0x008u            /**< mappable to RPDOs */
#define {{ upper }}_LOW 0x010u             /**< has a low limit */
#define {{ upper }}_HIGH 0x020u            /**< has a high limit */
#define {{ upper }}_NODE_ID_DEFAULT 0x040u /**< the node-ID is added to the default */
#define {{ upper }}_LOW_NODE_ID 0x080u     /**< the node-ID is added to the low limit */
#define {{ upper }}_HIGH_NODE_ID 0x100u    /**< the node-ID is added to the high limit */
{%- if hooks %}
#define {{ upper }}_HOOK 0x200u            /**< {{ lower }}_before_read() and {{ lower }}_after_write() are called */
{%- endif %}

/** @name Data types, by their index in CiA 301.
    @{ */
{% include "_types.h" %}
/** @} */

/* Return codes of {{ lower }}_read() and {{ lower }}_write(): the abort codes of CiA 301. */
#define {{ upper }}_OK 0u
#define {{ upper }}_ABORT_OUT_OF_MEMORY 0x05040005u   /**< the buffer is shorter than the value */
#define {{ upper }}_ABORT_WRITE_ONLY 0x06010001u      /**< attempt to read a write-only entry */
#define {{ upper }}_ABORT_READ_ONLY 0x06010002u       /**< attempt to write a read-only entry */
#define {{ upper }}_ABORT_NO_OBJECT 0x06020000u       /**< there is no object with this index */
#define {{ upper }}_ABORT_LENGTH_MISMATCH 0x06070010u /**< the number of bytes does not match the data type */
#define {{ upper }}_ABORT_TOO_LONG 0x06070012u        /**< more bytes than the data type or the capacity */
#define {{ upper }}_ABORT_TOO_SHORT 0x06070013u       /**< fewer bytes than the data type */
#define {{ upper }}_ABORT_NO_SUB_INDEX 0x06090011u    /**< the object has no such sub-index */
#define {{ upper }}_ABORT_INVALID_VALUE 0x06090030u   /**< not valid for the data type */
#define {{ upper }}_ABORT_TOO_HIGH 0x06090031u        /**< above the high limit */
#define {{ upper }}_ABORT_TOO_LOW 0x06090032u         /**< below the low limit */
#define {{ upper }}_ABORT_CANNOT_STORE 0x08000020u    /**< no capacity for the data; the application must store them */
#define {{ upper }}_ABORT_NO_DATA 0x08000024u         /**< no data in the table; the application must provide them */
{%- if hooks %}
#define {{ upper }}_ABORT_INCOMPATIBLE 0x06040043u    /**< for hooks: the value contradicts others */
#define {{ upper }}_ABORT_HARDWARE 0x06060000u        /**< for hooks: the hardware failed */
#define {{ upper }}_ABORT_GENERAL 0x08000000u         /**< for hooks: any other error */
#define {{ upper }}_ABORT_LOCAL_CONTROL 0x08000021u   /**< for hooks: the device is controlled locally */
#define {{ upper }}_ABORT_DEVICE_STATE 0x08000022u    /**< for hooks: not in this state of the device */
{%- endif %}

/** The number of entries. */
#define {{ upper }}_ENTRY_COUNT {{ table.rows.len() }}u
/** All entries in ascending order of index and sub-index. */
extern const {{ lower }}_entry_t {{ lower }}_entries[{{ upper }}_ENTRY_COUNT];
/** Data types and flags of the entries: the type in the lowest five bits. */
extern const uint16_t {{ lower }}_kinds[{{ shared.kinds.len() }}];

/** The number of objects. */
#define {{ upper }}_OBJECT_COUNT {{ table.objects.len() }}u
/** All objects in ascending order of index. */
extern const {{ lower }}_object_t {{ lower }}_objects[{{ upper }}_OBJECT_COUNT];

/** Sets all values to the defaults for node_id, 1 to 127; only the lower seven bits are used. */
void {{ lower }}_init({{ lower }}_data_t *data, uint8_t node_id);

/** Finds the entry with an index and a sub-index by binary search; NULL if there is none. */
const {{ lower }}_entry_t *{{ lower }}_find(uint16_t index, uint8_t sub);

/** The index of the object that an entry belongs to, by binary search. */
uint16_t {{ lower }}_index(const {{ lower }}_entry_t *entry);

/** The data type of an entry, {{ upper }}_UNSIGNED32 and the like. */
uint8_t {{ lower }}_data_type(const {{ lower }}_entry_t *entry);

/** The flags of an entry, {{ upper }}_READ and the like. */
uint16_t {{ lower }}_flags(const {{ lower }}_entry_t *entry);

/** Maximum size of a value in an SDO transfer, in bytes. */
size_t {{ lower }}_size(const {{ lower }}_entry_t *entry);

/** The bytes of the default; for a formula, of the offset to the node-ID. */
const uint8_t *{{ lower }}_default(const {{ lower }}_entry_t *entry, size_t *length);
{% if names %}
#ifndef {{ upper }}_NO_NAMES
/** The name in the description, UTF-8. Linkers that remove unused data also remove the names if they are not used. */
const char *{{ lower }}_name(const {{ lower }}_entry_t *entry);
#endif
{% endif %}
#ifndef {{ upper }}_NO_LIMITS
/** The low limit for node_id as a number with the bits of the value; false if there is none. */
bool {{ lower }}_low_limit(const {{ lower }}_entry_t *entry, uint8_t node_id, uint64_t *limit);
/** The high limit, like the low one. */
bool {{ lower }}_high_limit(const {{ lower }}_entry_t *entry, uint8_t node_id, uint64_t *limit);
#endif
{%- if hooks %}

{% include "_hooks.h" %}
{%- endif %}

/** Reads a value into a buffer of size bytes, as transferred by an SDO upload. Returns {{ upper }}_OK and the number of bytes in
   *length, or the code to abort the upload with. */
uint32_t {{ lower }}_read({% if !hooks %}const {% endif %}{{ lower }}_data_t *data, uint16_t index, uint8_t sub, void *buffer, size_t size, size_t *length);

/** Writes a value transferred by an SDO download if the dictionary allows it. Returns {{ upper }}_OK, or the code to abort the
   download with and leaves the value unchanged. */
uint32_t {{ lower }}_write({{ lower }}_data_t *data, uint16_t index, uint8_t sub, const void *bytes, size_t length);
{%- if !groups.is_empty() %}

{% include "_stored.h" %}
{%- endif %}

#ifdef __cplusplus
}
#endif

#endif
