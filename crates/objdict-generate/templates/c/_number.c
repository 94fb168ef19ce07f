/* Size of a number of this data type, in bytes; 0 for other types. */
static size_t {{ lower }}_number_size(uint8_t data_type)
{
    switch (data_type) {
    case {{ upper }}_BOOLEAN:
    case {{ upper }}_INTEGER8:
    case {{ upper }}_UNSIGNED8:
        return 1u;
    case {{ upper }}_INTEGER16:
    case {{ upper }}_UNSIGNED16:
        return 2u;
    case {{ upper }}_INTEGER24:
    case {{ upper }}_UNSIGNED24:
        return 3u;
    case {{ upper }}_INTEGER32:
    case {{ upper }}_UNSIGNED32:
    case {{ upper }}_REAL32:
        return 4u;
    case {{ upper }}_INTEGER40:
    case {{ upper }}_UNSIGNED40:
        return 5u;
    case {{ upper }}_INTEGER48:
    case {{ upper }}_UNSIGNED48:
    case {{ upper }}_TIME_OF_DAY:
    case {{ upper }}_TIME_DIFFERENCE:
        return 6u;
    case {{ upper }}_INTEGER56:
    case {{ upper }}_UNSIGNED56:
        return 7u;
    case {{ upper }}_INTEGER64:
    case {{ upper }}_UNSIGNED64:
    case {{ upper }}_REAL64:
        return 8u;
    default:
        return 0u;
    }
}

static bool {{ lower }}_is_time(uint8_t data_type)
{
    return data_type == {{ upper }}_TIME_OF_DAY || data_type == {{ upper }}_TIME_DIFFERENCE;
}

static bool {{ lower }}_is_signed(uint8_t data_type)
{
    return (data_type >= {{ upper }}_INTEGER8 && data_type <= {{ upper }}_INTEGER32) || data_type == {{ upper }}_INTEGER24
        || (data_type >= {{ upper }}_INTEGER40 && data_type <= {{ upper }}_INTEGER64);
}

/* Converts at most eight bytes to a number, with sign extension. */
static uint64_t {{ lower }}_number(uint8_t data_type, const uint8_t *bytes, size_t size)
{
    uint64_t number = {{ lower }}_is_signed(data_type) && (bytes[size - 1u] & 0x80u) != 0u ? UINT64_MAX : 0u;
    while (size > 0u) {
        size--;
        number = (number << 8) | bytes[size];
    }
    return number;
}
