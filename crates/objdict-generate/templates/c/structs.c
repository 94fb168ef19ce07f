{# CView<'_>::structs_source #}
/*
 * {{ table.head.made_by }}; do not edit.
 *
 * Object dictionary of {{ table.head.product|c_comment }} by {{ table.head.vendor|c_comment }}.
 */
#include "{{ stem }}.h"
{%- let has_pointers = true %}
{%- let structs = self.structs() %}

#include <string.h>

/* Numbers used as defaults and limits, without duplicates. */
{%- for pool in structs.pools %}
static const {{ pool.c_type }} {{ pool.name }}[{{ pool.numbers.len() }}] = {
{%- for number in pool.numbers %}
    {{ number }},
{%- endfor %}
};
{%- endfor %}
{%- if !structs.blocks.is_empty() %}

/* Non-numeric defaults. */
{%- for block in structs.blocks %}
{{ block }}
{%- endfor %}
{%- endif %}

{{ lower }}_data_t {{ lower }}_data;

const {{ lower }}_entry_t {{ lower }}_entries[{{ upper }}_ENTRY_COUNT] = {
{%- for view in structs.rows %}
    {0x{{ view.row.index|hex4 }}u, 0x{{ view.row.sub|hex2 }}u, {{ upper }}_{{ view.type_ }}, {{ view.flags }}, {{ view.row.resolved.shape.size() }}u, {{ view.data }}, {{ view.low }}, {{ view.high }}, {{ view.default }}{% if names %}, {{ view.row.name|c_text }}{% endif %}},
{%- endfor %}
};

static uint32_t {{ lower }}_key(uint16_t index, uint8_t sub)
{
    return ((uint32_t)index << 8) | sub;
}

const {{ lower }}_entry_t *{{ lower }}_find(uint16_t index, uint8_t sub)
{
    const uint32_t key = {{ lower }}_key(index, sub);
    const {{ lower }}_entry_t *entry = {{ lower }}_entries;
    size_t count = {{ upper }}_ENTRY_COUNT;
    while (count > 1u) { /* ends at the last entry not greater than the key */
        const size_t half = count / 2u;
        if ({{ lower }}_key(entry[half].index, entry[half].sub) <= key) {
            entry += half;
        }
        count -= half;
    }
    return entry->index == index && entry->sub == sub ? entry : NULL;
}

/* Size of a value in {{ lower }}_data_t, in bytes. */
static size_t {{ lower }}_stored_size(const {{ lower }}_entry_t *entry)
{
{%- if self.has_time() %}
    if (entry->data_type == {{ upper }}_TIME_OF_DAY || entry->data_type == {{ upper }}_TIME_DIFFERENCE) {
        return sizeof({{ lower }}_time_t);
    }
{%- endif %}
    if (entry->data_type == {{ upper }}_BLOCK || entry->size <= 2u) {
        return entry->size;
    }
    return entry->size <= 4u ? 4u : 8u;
}

/* Adds the node-ID to an integer. */
static void {{ lower }}_add_node_id(void *data, size_t size, uint8_t node_id)
{
    if (size == 1u) {
        uint8_t number;
        (void)memcpy(&number, data, sizeof number);
        number = (uint8_t)(number + node_id);
        (void)memcpy(data, &number, sizeof number);
    } else if (size == 2u) {
        uint16_t number;
        (void)memcpy(&number, data, sizeof number);
        number = (uint16_t)(number + node_id);
        (void)memcpy(data, &number, sizeof number);
    } else if (size == 4u) {
        uint32_t number;
        (void)memcpy(&number, data, sizeof number);
        number += node_id;
        (void)memcpy(data, &number, sizeof number);
    } else {
        uint64_t number;
        (void)memcpy(&number, data, sizeof number);
        number += node_id;
        (void)memcpy(data, &number, sizeof number);
    }
}

void {{ lower }}_init(uint8_t node_id)
{
    const {{ lower }}_entry_t *entry;
    (void)memset(&{{ lower }}_data, 0, sizeof {{ lower }}_data);
    {{ lower }}_data.node_id = node_id & 0x7Fu;
    for (entry = {{ lower }}_entries; entry < {{ lower }}_entries + {{ upper }}_ENTRY_COUNT; entry++) {
        size_t size = {{ lower }}_stored_size(entry);
        if (entry->data == NULL || entry->data == entry->def) {
            continue; /* served by the application, or constant */
        }
{%- if self.has_bytes() %}
        if ((entry->data_type >= {{ upper }}_VISIBLE_STRING && entry->data_type <= {{ upper }}_UNICODE_STRING)
            || entry->data_type == {{ upper }}_DOMAIN) {
            uint16_t length;
            (void)memcpy(&length, entry->def, sizeof length);
            size = sizeof length + length;
        }
{%- endif %}
        (void)memcpy(entry->data, entry->def, size);
        if ((entry->flags & {{ upper }}_NODE_ID_DEFAULT) != 0u) {
            {{ lower }}_add_node_id(entry->data, size, {{ lower }}_data.node_id);
        }
    }
}
{%- if !groups.is_empty() %}

static size_t {{ lower }}_size(const {{ lower }}_entry_t *entry)
{
    return entry->size;
}

static uint8_t {{ lower }}_data_type(const {{ lower }}_entry_t *entry)
{
    return entry->data_type;
}

{% include "_number.c" %}

{% include "_field.c" %}

{% include "_stored.c" %}
{%- endif %}
