/* Marks a definition as weak. */
#ifndef {{ upper }}_WEAK
#if defined(__GNUC__) || defined(__clang__) || defined(__ARMCC_VERSION)
#define {{ upper }}_WEAK __attribute__((weak))
#elif defined(__IAR_SYSTEMS_ICC__)
#define {{ upper }}_WEAK __weak
#endif
#endif

#ifdef {{ upper }}_WEAK
{{ upper }}_WEAK uint32_t {{ lower }}_before_read({{ lower }}_data_t *data, uint16_t index, uint8_t sub)
{
    (void)data;
    (void)index;
    (void)sub;
    return {{ upper }}_OK;
}

{{ upper }}_WEAK uint32_t {{ lower }}_after_write({{ lower }}_data_t *data, uint16_t index, uint8_t sub)
{
    (void)data;
    (void)index;
    (void)sub;
    return {{ upper }}_OK;
}
#endif

/* Size of an entry's value in {{ lower }}_data_t, in bytes. */
static size_t {{ lower }}_kept_size(const {{ lower }}_entry_t *entry)
{
    const size_t size = {{ lower }}_number_size({{ lower }}_data_type(entry));
    if ({{ lower }}_is_time({{ lower }}_data_type(entry))) {
        return sizeof({{ lower }}_time_t);
    }
    if (size > 2u) {
        return size <= 4u ? 4u : 8u;
    }
    if (size > 0u) {
        return size;
    }
    return {{ lower }}_size(entry) + ({{ lower }}_data_type(entry) == {{ upper }}_BLOCK ? 0u : 2u);
}
