{%- if limits.is_empty() %}
void {{ od }}_initLimits(uint8_t nodeId)
{
    (void)nodeId;
}

ODR_t {{ od }}_writeLimited(OD_stream_t *stream, const void *buf, OD_size_t count, OD_size_t *countWritten)
{
    return OD_writeOriginal(stream, buf, count, countWritten);
}
{%- else %}
/* The kind of a limited value and its limits. */
#define LIMIT_LOW 0x01U
#define LIMIT_HIGH 0x02U
#define LIMIT_LOW_NODE_ID 0x04U  /* the node-ID is added */
#define LIMIT_HIGH_NODE_ID 0x08U /* the node-ID is added */
#define LIMIT_SIGNED 0x10U
#define LIMIT_REAL 0x20U
#define LIMIT_BYTES 0x40U /* stored as bytes, the lowest first */

/* Limits as 64-bit numbers; a REAL as its bits. */
typedef struct {
    uint64_t low;
    uint64_t high;
    uint16_t index;
    uint16_t object; /* position in the list */
    uint8_t subIndex;
    uint8_t length;
    uint8_t flags;
} Limit_t;

static CO_PROGMEM Limit_t limits[] = {
{%- for row in limits %}
    { {{- row.row }}},
{%- endfor %}
};

static uint8_t limitNodeId;
static OD_extension_t limitExtensions[{{ limits::objects(limits) }}];

/* Converts a value to a number, with sign extension. */
static uint64_t limitedValue(CO_PROGMEM Limit_t *limit, const void *buf)
{
    uint64_t value = 0;
    if ((limit->flags & LIMIT_BYTES) != 0U || limit->length == 1U) {
        const uint8_t *bytes = (const uint8_t *)buf;
        for (uint8_t i = limit->length; i > 0U; i--) {
            value = (value << 8) | bytes[i - 1U];
        }
    } else if (limit->length == 2U) {
        uint16_t number;
        (void)memcpy(&number, buf, sizeof(number));
        value = number;
    } else if (limit->length == 4U) {
        uint32_t number;
        (void)memcpy(&number, buf, sizeof(number));
        value = number;
    } else {
        (void)memcpy(&value, buf, sizeof(value));
    }
    if ((limit->flags & LIMIT_SIGNED) != 0U) {
        const uint64_t sign = 1ULL << (8U * limit->length - 1U);
        value = (value ^ sign) - sign;
    }
    return value;
}
{%- if limits::has_real(limits) %}

/* Converts the bits of a value to a number. */
static float64_t realNumber(CO_PROGMEM Limit_t *limit, uint64_t bits)
{
    float64_t number;
    if (limit->length == 4U) {
        const uint32_t half = (uint32_t)bits;
        float32_t single;
        (void)memcpy(&single, &half, sizeof(single));
        return (float64_t)single;
    }
    (void)memcpy(&number, &bits, sizeof(number));
    return number;
}
{%- endif %}

/* Whether the first number is less than the second. */
static bool_t isLess(CO_PROGMEM Limit_t *limit, uint64_t first, uint64_t second)
{
    /* inverting the sign bit makes signed numbers comparable as unsigned */
    const uint64_t bias = (limit->flags & LIMIT_SIGNED) != 0U ? 1ULL << 63 : 0U;
{%- if limits::has_real(limits) %}
    if ((limit->flags & LIMIT_REAL) != 0U) {
        return realNumber(limit, first) < realNumber(limit, second);
    }
{%- endif %}
    return (first ^ bias) < (second ^ bias);
}

static ODR_t checkLimit(CO_PROGMEM Limit_t *limit, const void *buf, OD_size_t count)
{
    const uint64_t low = limit->low + ((limit->flags & LIMIT_LOW_NODE_ID) != 0U ? limitNodeId : 0U);
    const uint64_t high = limit->high + ((limit->flags & LIMIT_HIGH_NODE_ID) != 0U ? limitNodeId : 0U);
    uint64_t value;
    if (count != limit->length) {
        return ODR_TYPE_MISMATCH;
    }
    value = limitedValue(limit, buf);
{%- if limits::has_real(limits) %}
    if ((limit->flags & LIMIT_REAL) != 0U) {
        const float64_t number = realNumber(limit, value);
        if (!(number <= 0.0) && !(number >= 0.0)) {
            return ODR_INVALID_VALUE; /* not a number */
        }
    }
{%- endif %}
    if ((limit->flags & LIMIT_LOW) != 0U && isLess(limit, value, low)) {
        return ODR_VALUE_LOW;
    }
    if ((limit->flags & LIMIT_HIGH) != 0U && isLess(limit, high, value)) {
        return ODR_VALUE_HIGH;
    }
    return ODR_OK;
}

static uint32_t limitKey(uint16_t index, uint8_t subIndex)
{
    return ((uint32_t)index << 8) | subIndex;
}

/* Finds the limits of an entry by binary search; NULL if it has none. */
static CO_PROGMEM Limit_t *findLimit(uint16_t index, uint8_t subIndex)
{
    const uint32_t key = limitKey(index, subIndex);
    CO_PROGMEM Limit_t *limit = limits;
    size_t count = sizeof(limits) / sizeof(limits[0]);
    while (count > 1U) { /* ends at the last row not greater than the key */
        const size_t half = count / 2U;
        if (limitKey(limit[half].index, limit[half].subIndex) <= key) {
            limit += half;
        }
        count -= half;
    }
    return limitKey(limit->index, limit->subIndex) == key ? limit : NULL;
}

ODR_t {{ od }}_writeLimited(OD_stream_t *stream, const void *buf, OD_size_t count, OD_size_t *countWritten)
{
    if (stream != NULL && buf != NULL) {
        CO_PROGMEM Limit_t *limit = findLimit(stream->index, stream->subIndex);
        const ODR_t answer = limit != NULL ? checkLimit(limit, buf, count) : ODR_OK;
        if (answer != ODR_OK) {
            return answer;
        }
    }
    return OD_writeOriginal(stream, buf, count, countWritten);
}

void {{ od }}_initLimits(uint8_t nodeId)
{
    OD_extension_t *extension = limitExtensions;
    limitNodeId = (uint8_t)(nodeId & 0x7FU);
    for (size_t i = 0; i < sizeof(limits) / sizeof(limits[0]); i++) {
        OD_entry_t *entry = &ODList[limits[i].object];
        if (i > 0U && limits[i].object != limits[i - 1U].object) {
            extension++;
        }
        if (entry->extension == NULL) {
            extension->object = NULL;
            extension->read = OD_readOriginal;
            extension->write = {{ od }}_writeLimited;
            (void)OD_extension_init(entry, extension);
        }
    }
}
{%- endif %}
