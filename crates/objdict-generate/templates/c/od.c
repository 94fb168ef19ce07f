{# CView<'_>::source #}
/*
 * {{ table.head.made_by }}; do not edit.
 *
 * Object dictionary of {{ table.head.product|c_comment }} by {{ table.head.vendor|c_comment }}.
 */
#include "{{ stem }}.h"
{%- let has_pointers = false %}

#include <string.h>

/* The types of the values. */
typedef char {{ lower }}_bool_has_1_byte[sizeof(bool) == 1 ? 1 : -1];
{%- if table.keeps(DataType::REAL32) %}
typedef char {{ lower }}_float_has_4_bytes[sizeof(float) == 4 ? 1 : -1];
{%- endif %}
{%- if table.keeps(DataType::REAL64) %}
typedef char {{ lower }}_double_has_8_bytes[sizeof(double) == 8 ? 1 : -1];
{%- endif %}

#define {{ upper }}_RAM(field) (({{ lower }}_offset_t)offsetof({{ lower }}_data_t, field))

const {{ lower }}_entry_t {{ lower }}_entries[{{ upper }}_ENTRY_COUNT] = {
{%- for (row, kind) in table.rows.iter().zip(shared.kind_of.iter()) %}
    {0x{{ row.sub|hex2 }}u, {{ kind }}u, {% if let Some(slot) = row.slot %}{{ upper }}_RAM({{ table.place(slot) }}){% else %}0u{% endif %}, {{ row.rom }}u}, /* {{ row.index|hex4 }}h: {{ row.name|c_comment }} */
{%- endfor %}
};

const uint16_t {{ lower }}_kinds[{{ shared.kinds.len() }}] = {
{%- for (data_type, flags) in shared.kinds %}
    (({{ flags }}) << 5) | {{ upper }}_{{ data_type }},
{%- endfor %}
};

const {{ lower }}_object_t {{ lower }}_objects[{{ upper }}_OBJECT_COUNT] = {
{%- for object in table.objects %}
    {0x{{ object.index|hex4 }}u, {{ object.rows.start }}u}, /* {{ object.name|c_comment }} */
{%- endfor %}
};

/* Defaults and limits. For a number: the default, then the low and the high limit if stated. For other types: the
   capacity, the length of the default and the default. */
#define {{ upper }}_ROM_SIZE {{ table.rom.len() }}u
static const uint8_t {{ lower }}_rom[{{ upper }}_ROM_SIZE] = {
{%- for line in self.rom() %}
    {{ line }},
{%- endfor %}
};

/* Finds an entry, or returns what is missing. */
static uint32_t {{ lower }}_lookup(uint16_t index, uint8_t sub, const {{ lower }}_entry_t **found)
{
    const {{ lower }}_entry_t *entry;
    size_t object = 0u;
    size_t count = {{ upper }}_OBJECT_COUNT;
    while (count > 1u) { /* ends at the last object not greater than the index */
        const size_t half = count / 2u;
        if ({{ lower }}_objects[object + half].index <= index) {
            object += half;
        }
        count -= half;
    }
    if ({{ lower }}_objects[object].index != index) {
        return {{ upper }}_ABORT_NO_OBJECT;
    }
    entry = &{{ lower }}_entries[{{ lower }}_objects[object].first];
    count = (object + 1u < {{ upper }}_OBJECT_COUNT ? {{ lower }}_objects[object + 1u].first : {{ upper }}_ENTRY_COUNT) - {{ lower }}_objects[object].first;
    while (count > 1u) { /* ends at its last entry not greater than the sub-index */
        const size_t half = count / 2u;
        if (entry[half].sub <= sub) {
            entry += half;
        }
        count -= half;
    }
    *found = entry;
    return entry->sub == sub ? {{ upper }}_OK : {{ upper }}_ABORT_NO_SUB_INDEX;
}

const {{ lower }}_entry_t *{{ lower }}_find(uint16_t index, uint8_t sub)
{
    const {{ lower }}_entry_t *entry = NULL;
    return {{ lower }}_lookup(index, sub, &entry) == {{ upper }}_OK ? entry : NULL;
}

uint16_t {{ lower }}_index(const {{ lower }}_entry_t *entry)
{
    size_t object = 0u;
    size_t count = {{ upper }}_OBJECT_COUNT;
    while (count > 1u) { /* ends at the last object that does not start after the entry */
        const size_t half = count / 2u;
        if (&{{ lower }}_entries[{{ lower }}_objects[object + half].first] <= entry) {
            object += half;
        }
        count -= half;
    }
    return {{ lower }}_objects[object].index;
}

uint8_t {{ lower }}_data_type(const {{ lower }}_entry_t *entry)
{
    return (uint8_t)({{ lower }}_kinds[entry->kind] & 0x1Fu);
}

uint16_t {{ lower }}_flags(const {{ lower }}_entry_t *entry)
{
    return (uint16_t)({{ lower }}_kinds[entry->kind] >> 5);
}

{% include "_number.c" %}

#ifndef {{ upper }}_NO_LIMITS
/* Converts a value to a number with the same order; false for NaN. */
static bool {{ lower }}_order(uint8_t data_type, uint64_t number, uint64_t *order)
{
    const uint64_t sign = (uint64_t)1u << 63;
    uint64_t infinity = (uint64_t)0x7FF00000u << 32;
    uint64_t magnitude;
    if (data_type != {{ upper }}_REAL32 && data_type != {{ upper }}_REAL64) {
        *order = {{ lower }}_is_signed(data_type) ? number ^ sign : number;
        return true;
    }
    if (data_type == {{ upper }}_REAL32) {
        number <<= 32;
        infinity = (uint64_t)0x7F800000u << 32;
    }
    magnitude = number & ~sign;
    *order = (number & sign) == 0u ? sign + magnitude : sign - magnitude;
    return magnitude <= infinity;
}
#endif

/* One of the two lengths before a non-numeric default. */
static size_t {{ lower }}_head(const {{ lower }}_entry_t *entry, size_t skip)
{
    const uint8_t *head = &{{ lower }}_rom[entry->rom + skip];
    return (size_t)head[0] | ((size_t)head[1] << 8);
}

/* Reads a number from flash and adds the node-ID if the flag is set. */
static uint64_t {{ lower }}_rom_number(const {{ lower }}_entry_t *entry, size_t block, unsigned int flag, uint8_t node_id)
{
    const size_t size = {{ lower }}_number_size({{ lower }}_data_type(entry));
    const uint64_t number = {{ lower }}_number({{ lower }}_data_type(entry), &{{ lower }}_rom[entry->rom + block * size], size);
    return ({{ lower }}_flags(entry) & flag) == 0u ? number : number + (node_id & 0x7Fu);
}

size_t {{ lower }}_size(const {{ lower }}_entry_t *entry)
{
    const size_t size = {{ lower }}_number_size({{ lower }}_data_type(entry));
    return size == 0u ? {{ lower }}_head(entry, 0u) : size;
}

const uint8_t *{{ lower }}_default(const {{ lower }}_entry_t *entry, size_t *length)
{
    const size_t size = {{ lower }}_number_size({{ lower }}_data_type(entry));
    *length = size == 0u ? {{ lower }}_head(entry, 2u) : size;
    return {{ lower }}_rom + entry->rom + (size == 0u ? 4u : 0u); /* can be the end of {{ lower }}_rom if the default is empty */
}

#ifndef {{ upper }}_NO_LIMITS
bool {{ lower }}_low_limit(const {{ lower }}_entry_t *entry, uint8_t node_id, uint64_t *limit)
{
    if (({{ lower }}_flags(entry) & {{ upper }}_LOW) == 0u) {
        return false;
    }
    *limit = {{ lower }}_rom_number(entry, 1u, {{ upper }}_LOW_NODE_ID, node_id);
    return true;
}

bool {{ lower }}_high_limit(const {{ lower }}_entry_t *entry, uint8_t node_id, uint64_t *limit)
{
    if (({{ lower }}_flags(entry) & {{ upper }}_HIGH) == 0u) {
        return false;
    }
    *limit = {{ lower }}_rom_number(entry, ({{ lower }}_flags(entry) & {{ upper }}_LOW) == 0u ? 1u : 2u, {{ upper }}_HIGH_NODE_ID, node_id);
    return true;
}
#endif

{% include "_field.c" %}

void {{ lower }}_init({{ lower }}_data_t *data, uint8_t node_id)
{
    uint8_t *const ram = (uint8_t *)data;
    const {{ lower }}_entry_t *entry;
    (void)memset(data, 0, sizeof *data);
    data->node_id = node_id & 0x7Fu;
    for (entry = {{ lower }}_entries; entry < {{ lower }}_entries + {{ upper }}_ENTRY_COUNT; entry++) {
        const size_t size = {{ lower }}_number_size({{ lower }}_data_type(entry));
        if (entry->ram == 0u) {
            continue;
        }
        if (size > 0u) {
            const uint64_t number = {{ lower }}_rom_number(entry, 0u, {{ upper }}_NODE_ID_DEFAULT, node_id);
            {{ lower }}_store(ram + entry->ram, {{ lower }}_data_type(entry), size, number);
        } else {
            size_t length;
            const uint8_t *bytes = {{ lower }}_default(entry, &length);
            {{ lower }}_store_bytes(ram + entry->ram, entry, bytes, length);
        }
    }
}
{%- if hooks %}

{% include "_hooks.c" %}
{%- endif %}

uint32_t {{ lower }}_read({% if !hooks %}const {% endif %}{{ lower }}_data_t *data, uint16_t index, uint8_t sub, void *buffer, size_t size, size_t *length)
{
    const {{ lower }}_entry_t *entry = NULL;
    const uint32_t missing = {{ lower }}_lookup(index, sub, &entry);
    uint8_t data_type;
    const uint8_t *field;
    const uint8_t *bytes;
    uint8_t number_bytes[8];
    size_t count;
    if (missing != {{ upper }}_OK) {
        return missing;
    }
    data_type = {{ lower }}_data_type(entry);
    if (({{ lower }}_flags(entry) & {{ upper }}_READ) == 0u) {
        return {{ upper }}_ABORT_WRITE_ONLY;
    }
{%- if hooks %}
    if (({{ lower }}_flags(entry) & {{ upper }}_HOOK) != 0u) {
        const uint32_t answer = {{ lower }}_before_read(data, index, sub);
        if (answer != {{ upper }}_OK) {
            return answer;
        }
    }
{%- endif %}
    field = (const uint8_t *)data + entry->ram;
    count = {{ lower }}_number_size(data_type);
    if (count > 0u) {
        uint64_t number = entry->ram == 0u ? {{ lower }}_rom_number(entry, 0u, {{ upper }}_NODE_ID_DEFAULT, data->node_id)
                                           : {{ lower }}_load(field, data_type, count);
        size_t at;
        for (at = 0u; at < sizeof number_bytes; at++) {
            number_bytes[at] = (uint8_t)(number & 0xFFu);
            number >>= 8;
        }
        bytes = number_bytes;
    } else if (entry->ram == 0u) {
        if (data_type == {{ upper }}_DOMAIN && {{ lower }}_size(entry) == 0u) {
            return {{ upper }}_ABORT_NO_DATA;
        }
        bytes = {{ lower }}_default(entry, &count);
    } else if (data_type == {{ upper }}_BLOCK) {
        bytes = field;
        count = {{ lower }}_size(entry);
    } else {
        uint16_t filled;
        (void)memcpy(&filled, field, sizeof filled);
        bytes = field + sizeof filled;
        count = filled < {{ lower }}_size(entry) ? filled : {{ lower }}_size(entry);
    }
    if (count > size) {
        return {{ upper }}_ABORT_OUT_OF_MEMORY;
    }
    if (count > 0u) {
        (void)memcpy(buffer, bytes, count);
    }
    *length = count;
    return {{ upper }}_OK;
}

static uint32_t {{ lower }}_check_length(const {{ lower }}_entry_t *entry, size_t length)
{
    const uint8_t data_type = {{ lower }}_data_type(entry);
    const size_t capacity = {{ lower }}_size(entry);
    const bool exact = {{ lower }}_number_size(data_type) > 0u || data_type == {{ upper }}_BLOCK;
    if (length > capacity) {
        return {{ upper }}_ABORT_TOO_LONG;
    }
    if (exact && length < capacity) {
        return {{ upper }}_ABORT_TOO_SHORT;
    }
    if (data_type == {{ upper }}_UNICODE_STRING && (length & 1u) != 0u) {
        return {{ upper }}_ABORT_LENGTH_MISMATCH;
    }
    return {{ upper }}_OK;
}

#ifndef {{ upper }}_NO_LIMITS
static uint32_t {{ lower }}_check_limits(const {{ lower }}_entry_t *entry, uint64_t number, uint8_t node_id)
{
    const uint8_t data_type = {{ lower }}_data_type(entry);
    uint64_t value;
    uint64_t limit = 0u;
    if (({{ lower }}_flags(entry) & ({{ upper }}_LOW | {{ upper }}_HIGH)) == 0u) {
        return {{ upper }}_OK;
    }
    if (!{{ lower }}_order(data_type, number, &value)) {
        return {{ upper }}_ABORT_INVALID_VALUE;
    }
    if ({{ lower }}_low_limit(entry, node_id, &limit) && {{ lower }}_order(data_type, limit, &limit) && value < limit) {
        return {{ upper }}_ABORT_TOO_LOW;
    }
    if ({{ lower }}_high_limit(entry, node_id, &limit) && {{ lower }}_order(data_type, limit, &limit) && value > limit) {
        return {{ upper }}_ABORT_TOO_HIGH;
    }
    return {{ upper }}_OK;
}
#endif

static uint32_t {{ lower }}_check_value(const {{ lower }}_entry_t *entry, uint64_t number, uint8_t node_id)
{
    if ({{ lower }}_data_type(entry) == {{ upper }}_BOOLEAN && number > 1u) {
        return {{ upper }}_ABORT_INVALID_VALUE;
    }
#ifdef {{ upper }}_NO_LIMITS
    (void)node_id;
    return {{ upper }}_OK;
#else
    return {{ lower }}_check_limits(entry, number, node_id);
#endif
}

uint32_t {{ lower }}_write({{ lower }}_data_t *data, uint16_t index, uint8_t sub, const void *bytes, size_t length)
{
    const {{ lower }}_entry_t *entry = NULL;
    uint32_t answer = {{ lower }}_lookup(index, sub, &entry);
    size_t size;
    uint8_t data_type;
    uint8_t *field;
{%- if hooks %}
    uint8_t old[{{ hooks::room(table) }}];
{%- endif %}
    if (answer != {{ upper }}_OK) {
        return answer;
    }
    if (({{ lower }}_flags(entry) & {{ upper }}_WRITE) == 0u) {
        return {{ upper }}_ABORT_READ_ONLY;
    }
    if (entry->ram == 0u) {
        return {{ upper }}_ABORT_CANNOT_STORE;
    }
    answer = {{ lower }}_check_length(entry, length);
    if (answer != {{ upper }}_OK) {
        return answer;
    }
    field = (uint8_t *)data + entry->ram;
{%- if hooks %}
    if (({{ lower }}_flags(entry) & {{ upper }}_HOOK) != 0u) {
        (void)memcpy(old, field, {{ lower }}_kept_size(entry));
    }
{%- endif %}
    data_type = {{ lower }}_data_type(entry);
    size = {{ lower }}_number_size(data_type);
    if (size > 0u) {
        const uint64_t number = {{ lower }}_number(data_type, (const uint8_t *)bytes, size);
        answer = {{ lower }}_check_value(entry, number, data->node_id);
        if (answer == {{ upper }}_OK) {
            {{ lower }}_store(field, data_type, size, number);
        }
    } else {
        {{ lower }}_store_bytes(field, entry, (const uint8_t *)bytes, length);
    }
{%- if hooks %}
    if (answer == {{ upper }}_OK && ({{ lower }}_flags(entry) & {{ upper }}_HOOK) != 0u) {
        answer = {{ lower }}_after_write(data, index, sub);
        if (answer != {{ upper }}_OK) {
            (void)memcpy(field, old, {{ lower }}_kept_size(entry));
        }
    }
{%- endif %}
    return answer;
}
{%- if !groups.is_empty() %}

{% include "_stored.c" %}
{%- endif %}
{%- if names %}

#ifndef {{ upper }}_NO_NAMES
static const char *const {{ lower }}_names[{{ upper }}_ENTRY_COUNT] = {
{%- for row in table.rows %}
    {{ row.name|c_text }},
{%- endfor %}
};

const char *{{ lower }}_name(const {{ lower }}_entry_t *entry)
{
    return {{ lower }}_names[entry - {{ lower }}_entries];
}
#endif
{%- endif %}
