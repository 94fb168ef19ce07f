/*
 * Made by objdict {{ version }}; do not edit.
 *
 * Object dictionary of {{ table.product|c_comment }} by {{ table.vendor|c_comment }}.
 */
#include "od.h"

#include <string.h>

/* The values are kept in these types. */
typedef char od_bool_has_1_byte[sizeof(bool) == 1 ? 1 : -1];
{%- if real32 %}
typedef char od_float_has_4_bytes[sizeof(float) == 4 ? 1 : -1];
{%- endif %}
{%- if real64 %}
typedef char od_double_has_8_bytes[sizeof(double) == 8 ? 1 : -1];
{%- endif %}

#define OD_RAM(field) ((od_offset_t)offsetof(od_data_t, field))

const od_entry_t od_entries[OD_ENTRY_COUNT] = {
{%- for view in rows %}
    {0x{{ "{:04X}"|format(view.row.index) }}u, 0x{{ "{:02X}"|format(view.row.sub) }}u, OD_{{ view.type_ }}, {{ view.flags }}, {{ view.ram }}, {{ view.row.rom }}u}, /* {{ view.row.name|c_comment }} */
{%- endfor %}
};

/* Defaults and limits. Of a number: the default, then the low and the high limit if there are any. Of anything else: the
   greatest length, the length of the default and the default. */
#define OD_ROM_SIZE {{ table.rom.len() }}u
static const uint8_t od_rom[OD_ROM_SIZE] = {
{%- for line in rom %}
    {{ line }},
{%- endfor %}
};

static uint32_t od_key(uint16_t index, uint8_t sub)
{
    return ((uint32_t)index << 8) | sub;
}

/* Finds an entry, or tells what is missing. */
static uint32_t od_lookup(uint16_t index, uint8_t sub, const od_entry_t **found)
{
    const uint32_t key = od_key(index, sub);
    const od_entry_t *entry = od_entries;
    size_t count = OD_ENTRY_COUNT;
    while (count > 1u) { /* ends at the last entry that is not greater */
        const size_t half = count / 2u;
        if (od_key(entry[half].index, entry[half].sub) <= key) {
            entry += half;
        }
        count -= half;
    }
    if (entry->index == index && entry->sub == sub) {
        *found = entry;
        return OD_OK;
    }
    if (entry->index != index && entry + 1 < od_entries + OD_ENTRY_COUNT) {
        entry++; /* the object may begin behind */
    }
    return entry->index == index ? OD_ABORT_NO_SUB_INDEX : OD_ABORT_NO_OBJECT;
}

const od_entry_t *od_find(uint16_t index, uint8_t sub)
{
    const od_entry_t *entry = NULL;
    return od_lookup(index, sub, &entry) == OD_OK ? entry : NULL;
}

/* Bytes of a number of this data type; 0 for a type whose values are no numbers. */
static size_t od_number_size(uint8_t data_type)
{
    switch (data_type) {
    case OD_BOOLEAN:
    case OD_INTEGER8:
    case OD_UNSIGNED8:
        return 1u;
    case OD_INTEGER16:
    case OD_UNSIGNED16:
        return 2u;
    case OD_INTEGER24:
    case OD_UNSIGNED24:
        return 3u;
    case OD_INTEGER32:
    case OD_UNSIGNED32:
    case OD_REAL32:
        return 4u;
    case OD_INTEGER40:
    case OD_UNSIGNED40:
        return 5u;
    case OD_INTEGER48:
    case OD_UNSIGNED48:
    case OD_TIME_OF_DAY:
    case OD_TIME_DIFFERENCE:
        return 6u;
    case OD_INTEGER56:
    case OD_UNSIGNED56:
        return 7u;
    case OD_INTEGER64:
    case OD_UNSIGNED64:
    case OD_REAL64:
        return 8u;
    default:
        return 0u;
    }
}

static bool od_is_time(uint8_t data_type)
{
    return data_type == OD_TIME_OF_DAY || data_type == OD_TIME_DIFFERENCE;
}

static bool od_is_signed(uint8_t data_type)
{
    return (data_type >= OD_INTEGER8 && data_type <= OD_INTEGER32) || data_type == OD_INTEGER24
        || (data_type >= OD_INTEGER40 && data_type <= OD_INTEGER64);
}

/* The number of at most eight bytes; the sign goes on to the left. */
static uint64_t od_number(uint8_t data_type, const uint8_t *bytes, size_t size)
{
    uint64_t number = od_is_signed(data_type) && (bytes[size - 1u] & 0x80u) != 0u ? UINT64_MAX : 0u;
    while (size > 0u) {
        size--;
        number = (number << 8) | bytes[size];
    }
    return number;
}

/* A number that is ordered as the values of the data type are; false for a REAL that is not a number. */
static bool od_order(uint8_t data_type, uint64_t number, uint64_t *order)
{
    const uint64_t sign = (uint64_t)1u << 63;
    uint64_t infinity = (uint64_t)0x7FF00000u << 32;
    uint64_t magnitude;
    if (data_type != OD_REAL32 && data_type != OD_REAL64) {
        *order = od_is_signed(data_type) ? number ^ sign : number;
        return true;
    }
    if (data_type == OD_REAL32) {
        number <<= 32;
        infinity = (uint64_t)0x7F800000u << 32;
    }
    magnitude = number & ~sign;
    *order = (number & sign) == 0u ? sign + magnitude : sign - magnitude;
    return magnitude <= infinity;
}

/* One of the two lengths in front of a default that is no number. */
static size_t od_head(const od_entry_t *entry, size_t skip)
{
    const uint8_t *head = &od_rom[entry->rom + skip];
    return (size_t)head[0] | ((size_t)head[1] << 8);
}

/* The number of a block of bytes in flash; the node-ID is added where the flag says so. */
static uint64_t od_rom_number(const od_entry_t *entry, size_t block, unsigned int flag, uint8_t node_id)
{
    const size_t size = od_number_size(entry->data_type);
    const uint64_t number = od_number(entry->data_type, &od_rom[entry->rom + block * size], size);
    return (entry->flags & flag) == 0u ? number : number + (node_id & 0x7Fu);
}

size_t od_size(const od_entry_t *entry)
{
    const size_t size = od_number_size(entry->data_type);
    return size == 0u ? od_head(entry, 0u) : size;
}

const uint8_t *od_default(const od_entry_t *entry, size_t *length)
{
    const size_t size = od_number_size(entry->data_type);
    *length = size == 0u ? od_head(entry, 2u) : size;
    return od_rom + entry->rom + (size == 0u ? 4u : 0u); /* may be the end of od_rom when there are no bytes */
}

bool od_low_limit(const od_entry_t *entry, uint8_t node_id, uint64_t *limit)
{
    if ((entry->flags & OD_LOW) == 0u) {
        return false;
    }
    *limit = od_rom_number(entry, 1u, OD_LOW_NODE_ID, node_id);
    return true;
}

bool od_high_limit(const od_entry_t *entry, uint8_t node_id, uint64_t *limit)
{
    if ((entry->flags & OD_HIGH) == 0u) {
        return false;
    }
    *limit = od_rom_number(entry, (entry->flags & OD_LOW) == 0u ? 1u : 2u, OD_HIGH_NODE_ID, node_id);
    return true;
}

/* The number that a field holds. */
static uint64_t od_load(const uint8_t *field, uint8_t data_type, size_t size)
{
    uint64_t number = 0u;
    if (od_is_time(data_type)) {
        od_time_t time;
        memcpy(&time, field, sizeof time);
        return (time.milliseconds & 0x0FFFFFFFu) | ((uint64_t)time.days << 32);
    }
    if (size == 1u) {
        number = *field;
    } else if (size == 2u) {
        uint16_t value;
        memcpy(&value, field, sizeof value);
        number = value;
    } else if (size <= 4u) {
        uint32_t value;
        memcpy(&value, field, sizeof value);
        number = value;
    } else {
        memcpy(&number, field, sizeof number);
    }
    return number;
}

/* Puts a number into a field. */
static void od_store(uint8_t *field, uint8_t data_type, size_t size, uint64_t number)
{
    if (od_is_time(data_type)) {
        od_time_t time;
        memset(&time, 0, sizeof time);
        time.milliseconds = (uint32_t)(number & 0x0FFFFFFFu);
        time.days = (uint16_t)((number >> 32) & 0xFFFFu);
        memcpy(field, &time, sizeof time);
    } else if (size == 1u) {
        *field = (uint8_t)(number & 0xFFu);
    } else if (size == 2u) {
        const uint16_t value = (uint16_t)(number & 0xFFFFu);
        memcpy(field, &value, sizeof value);
    } else if (size <= 4u) {
        const uint32_t value = (uint32_t)(number & 0xFFFFFFFFu);
        memcpy(field, &value, sizeof value);
    } else {
        memcpy(field, &number, sizeof number);
    }
}

/* Puts bytes into a field: behind their number, or all bytes of a block. */
static void od_store_bytes(uint8_t *field, const od_entry_t *entry, const uint8_t *bytes, size_t length)
{
    if (entry->data_type != OD_BLOCK) {
        const uint16_t count = (uint16_t)length;
        memcpy(field, &count, sizeof count);
        field += sizeof count;
        memset(field, 0, od_size(entry));
    }
    if (length > 0u) {
        memcpy(field, bytes, length);
    }
}

void od_init(od_data_t *data, uint8_t node_id)
{
    uint8_t *const ram = (uint8_t *)data;
    const od_entry_t *entry;
    memset(data, 0, sizeof *data);
    data->node_id = node_id & 0x7Fu;
    for (entry = od_entries; entry < od_entries + OD_ENTRY_COUNT; entry++) {
        const size_t size = od_number_size(entry->data_type);
        if (entry->ram == 0u) {
            continue;
        }
        if (size > 0u) {
            const uint64_t number = od_rom_number(entry, 0u, OD_NODE_ID_DEFAULT, node_id);
            od_store(ram + entry->ram, entry->data_type, size, number);
        } else {
            size_t length;
            const uint8_t *bytes = od_default(entry, &length);
            od_store_bytes(ram + entry->ram, entry, bytes, length);
        }
    }
}

uint32_t od_read(const od_data_t *data, uint16_t index, uint8_t sub, void *buffer, size_t size, size_t *length)
{
    const od_entry_t *entry = NULL;
    const uint32_t missing = od_lookup(index, sub, &entry);
    const uint8_t *field;
    const uint8_t *bytes;
    uint8_t number_bytes[8];
    size_t count;
    if (missing != OD_OK) {
        return missing;
    }
    if ((entry->flags & OD_READ) == 0u) {
        return OD_ABORT_WRITE_ONLY;
    }
    field = (const uint8_t *)data + entry->ram;
    count = od_number_size(entry->data_type);
    if (count > 0u) {
        uint64_t number = entry->ram == 0u ? od_rom_number(entry, 0u, OD_NODE_ID_DEFAULT, data->node_id)
                                           : od_load(field, entry->data_type, count);
        size_t at;
        for (at = 0u; at < sizeof number_bytes; at++) {
            number_bytes[at] = (uint8_t)(number & 0xFFu);
            number >>= 8;
        }
        bytes = number_bytes;
    } else if (entry->ram == 0u) {
        if (entry->data_type == OD_DOMAIN && od_size(entry) == 0u) {
            return OD_ABORT_NO_DATA;
        }
        bytes = od_default(entry, &count);
    } else if (entry->data_type == OD_BLOCK) {
        bytes = field;
        count = od_size(entry);
    } else {
        uint16_t filled;
        memcpy(&filled, field, sizeof filled);
        bytes = field + sizeof filled;
        count = filled < od_size(entry) ? filled : od_size(entry);
    }
    if (count > size) {
        return OD_ABORT_OUT_OF_MEMORY;
    }
    if (count > 0u) {
        memcpy(buffer, bytes, count);
    }
    *length = count;
    return OD_OK;
}

static uint32_t od_check_length(const od_entry_t *entry, size_t length)
{
    const bool exact = od_number_size(entry->data_type) > 0u || entry->data_type == OD_BLOCK;
    if (length > od_size(entry)) {
        return OD_ABORT_TOO_LONG;
    }
    if (exact && length < od_size(entry)) {
        return OD_ABORT_TOO_SHORT;
    }
    if (entry->data_type == OD_UNICODE_STRING && (length & 1u) != 0u) {
        return OD_ABORT_LENGTH_MISMATCH;
    }
    return OD_OK;
}

static uint32_t od_check_value(const od_entry_t *entry, uint64_t number, uint8_t node_id)
{
    uint64_t value;
    uint64_t limit = 0u;
    if (entry->data_type == OD_BOOLEAN && number > 1u) {
        return OD_ABORT_INVALID_VALUE;
    }
    if ((entry->flags & (OD_LOW | OD_HIGH)) == 0u) {
        return OD_OK;
    }
    if (!od_order(entry->data_type, number, &value)) {
        return OD_ABORT_INVALID_VALUE;
    }
    if (od_low_limit(entry, node_id, &limit) && od_order(entry->data_type, limit, &limit) && value < limit) {
        return OD_ABORT_TOO_LOW;
    }
    if (od_high_limit(entry, node_id, &limit) && od_order(entry->data_type, limit, &limit) && value > limit) {
        return OD_ABORT_TOO_HIGH;
    }
    return OD_OK;
}

uint32_t od_write(od_data_t *data, uint16_t index, uint8_t sub, const void *bytes, size_t length)
{
    const od_entry_t *entry = NULL;
    uint32_t answer = od_lookup(index, sub, &entry);
    size_t size;
    uint8_t *field;
    if (answer != OD_OK) {
        return answer;
    }
    if ((entry->flags & OD_WRITE) == 0u) {
        return OD_ABORT_READ_ONLY;
    }
    if (entry->ram == 0u) {
        return OD_ABORT_CANNOT_STORE;
    }
    answer = od_check_length(entry, length);
    if (answer != OD_OK) {
        return answer;
    }
    field = (uint8_t *)data + entry->ram;
    size = od_number_size(entry->data_type);
    if (size > 0u) {
        const uint64_t number = od_number(entry->data_type, (const uint8_t *)bytes, size);
        answer = od_check_value(entry, number, data->node_id);
        if (answer == OD_OK) {
            od_store(field, entry->data_type, size, number);
        }
    } else {
        od_store_bytes(field, entry, (const uint8_t *)bytes, length);
    }
    return answer;
}
