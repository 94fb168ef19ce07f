/* Reads a number from a field. */
static uint64_t {{ lower }}_load(const uint8_t *field, uint8_t data_type, size_t size)
{
    uint64_t number = 0u;
    if ({{ lower }}_is_time(data_type)) {
        {{ lower }}_time_t time;
        (void)memcpy(&time, field, sizeof time);
        return (time.milliseconds & 0x0FFFFFFFu) | ((uint64_t)time.days << 32);
    }
    if (size == 1u) {
        number = *field;
    } else if (size == 2u) {
        uint16_t value;
        (void)memcpy(&value, field, sizeof value);
        number = value;
    } else if (size <= 4u) {
        uint32_t value;
        (void)memcpy(&value, field, sizeof value);
        number = value;
    } else {
        (void)memcpy(&number, field, sizeof number);
    }
    return number;
}

/* Writes a number to a field. */
static void {{ lower }}_store(uint8_t *field, uint8_t data_type, size_t size, uint64_t number)
{
    if ({{ lower }}_is_time(data_type)) {
        {{ lower }}_time_t time;
        (void)memset(&time, 0, sizeof time);
        time.milliseconds = (uint32_t)(number & 0x0FFFFFFFu);
        time.days = (uint16_t)((number >> 32) & 0xFFFFu);
        (void)memcpy(field, &time, sizeof time);
    } else if (size == 1u) {
        *field = (uint8_t)(number & 0xFFu);
    } else if (size == 2u) {
        const uint16_t value = (uint16_t)(number & 0xFFFFu);
        (void)memcpy(field, &value, sizeof value);
    } else if (size <= 4u) {
        const uint32_t value = (uint32_t)(number & 0xFFFFFFFFu);
        (void)memcpy(field, &value, sizeof value);
    } else {
        (void)memcpy(field, &number, sizeof number);
    }
}

/* Writes bytes to a field: after their length, or all bytes of a block. */
static void {{ lower }}_store_bytes(uint8_t *field, const {{ lower }}_entry_t *entry, const uint8_t *bytes, size_t length)
{
    if ({{ lower }}_data_type(entry) != {{ upper }}_BLOCK) {
        const uint16_t count = (uint16_t)length;
        (void)memcpy(field, &count, sizeof count);
        field += sizeof count;
        (void)memset(field, 0, {{ lower }}_size(entry));
    }
    if (length > 0u) {
        (void)memcpy(field, bytes, length);
    }
}
