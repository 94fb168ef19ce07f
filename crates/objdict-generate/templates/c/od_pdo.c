{# PdoFiles<'_>::source #}
/*
 * {{ table.head.made_by }}; do not edit.
 */
#include "{{ stem }}_pdo.h"

#include <string.h>

#ifndef {{ upper }}_NO_PDO

/* The lowest bits of a number, 1 to 64. */
static uint64_t {{ lower }}_lowest(uint64_t number, unsigned bits)
{
    const unsigned unused = 64u - bits;
    return number & (UINT64_MAX >> unused);
}

/* Converts a frame to a number; the first byte is the lowest. */
static uint64_t {{ lower }}_from_frame(const uint8_t *frame, size_t length)
{
    uint64_t number = 0u;
    while (length > 0u) {
        length--;
        number = (number << 8) | frame[length];
    }
    return number;
}

static void {{ lower }}_to_frame(uint64_t number, uint8_t *frame, size_t length)
{
    size_t at;
    for (at = 0u; at < length; at++) {
        frame[at] = (uint8_t)(number & 0xFFu);
        number >>= 8;
    }
}
{%- if self.uses_signs() %}

/* Converts the given number of bits to a signed number. */
static int64_t {{ lower }}_signed(uint64_t number, unsigned bits)
{
    const uint64_t lowest = {{ lower }}_lowest(UINT64_MAX, bits);
    if (number > (lowest >> 1)) {
        const uint64_t below = lowest - number;
        return -(int64_t)below - 1;
    }
    return (int64_t)number;
}
{%- endif %}
{%- if self.uses(TypeKind::Real32) %}

static uint64_t {{ lower }}_from_real32(float value)
{
    uint32_t bits;
    (void)memcpy(&bits, &value, sizeof bits);
    return bits;
}

static float {{ lower }}_to_real32(uint64_t number)
{
    const uint32_t bits = (uint32_t)number;
    float value;
    (void)memcpy(&value, &bits, sizeof value);
    return value;
}
{%- endif %}
{%- if self.uses(TypeKind::Real64) %}

static uint64_t {{ lower }}_from_real64(double value)
{
    uint64_t bits;
    (void)memcpy(&bits, &value, sizeof bits);
    return bits;
}

static double {{ lower }}_to_real64(uint64_t number)
{
    double value;
    (void)memcpy(&value, &number, sizeof value);
    return value;
}
{%- endif %}
{%- if self.uses(TypeKind::TimeOfDay) || self.uses(TypeKind::TimeDifference) %}

static uint64_t {{ lower }}_from_time({{ lower }}_time_t value)
{
    return (value.milliseconds & 0x0FFFFFFFu) | ((uint64_t)value.days << 32);
}

static {{ lower }}_time_t {{ lower }}_to_time(uint64_t number)
{
    {{ lower }}_time_t value;
    value.milliseconds = (uint32_t)(number & 0x0FFFFFFFu);
    value.days = (uint16_t)((number >> 32) & 0xFFFFu);
    return value;
}
{%- endif %}
{%- for frame in frames %}

/* {{ frame.frame.title }} */

void {{ frame.type_name }}_load(const {{ lower }}_data_t *data, {{ frame.type_name }}_t *pdo)
{
{%- if !frame.reads_data %}
    (void)data;
{%- endif %}
    (void)memset(pdo, 0, sizeof *pdo);
{%- for field in frame.fields %}
    {{ field.load }};
{%- endfor %}
}

void {{ frame.type_name }}_store(const {{ frame.type_name }}_t *pdo, {{ lower }}_data_t *data)
{
{%- if !frame.writes_data %}
    (void)pdo;
    (void)data;
{%- endif %}
{%- for field in frame.fields %}
{%- for line in field.store %}
    {{ line }};
{%- endfor %}
{%- endfor %}
}

void {{ frame.type_name }}_pack(const {{ frame.type_name }}_t *pdo, uint8_t frame[{{ frame.frame.length }}])
{
    uint64_t number = 0u;
{%- for field in frame.fields %}
    number |= {{ lower }}_lowest({{ field.pack }}, {{ field.field.bits }}u) << {{ field.field.first }};
{%- endfor %}
    {{ lower }}_to_frame(number, frame, {{ frame.frame.length }}u);
}

void {{ frame.type_name }}_unpack(const uint8_t frame[{{ frame.frame.length }}], {{ frame.type_name }}_t *pdo)
{
    const uint64_t number = {{ lower }}_from_frame(frame, {{ frame.frame.length }}u);
{%- for field in frame.fields %}
    {{ field.unpack }};
{%- endfor %}
}
{%- endfor %}

#endif
