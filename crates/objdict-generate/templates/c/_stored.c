/* The location of a storage group in {{ lower }}_data_t, and the start of its image. */
typedef struct {
    size_t first;
    size_t size;
    size_t image_size;
    uint32_t layout;
} {{ lower }}_kept_t;

/* Finds an entry's value in a group; false if the group does not contain it. */
static bool {{ lower }}_is_kept(const {{ lower }}_entry_t *entry, const {{ lower }}_kept_t *kept, size_t *at)
{
{%- if has_pointers %}
    const uintptr_t place = (uintptr_t)entry->data;
    const uintptr_t first = (uintptr_t)&{{ lower }}_data + kept->first;
    *at = (size_t)(place - first);
    return entry->data != NULL && place >= first && place - first < kept->size;
{%- else %}
    *at = (size_t)entry->ram - kept->first;
    return entry->ram >= kept->first && *at < kept->size;
{%- endif %}
}

/* The CRC of CiA 301: x^16 + x^12 + x^5 + 1, initial value 0. */
static uint16_t {{ lower }}_crc16(const uint8_t *bytes, size_t length)
{
    unsigned int crc = 0u;
    size_t at;
    for (at = 0u; at < length; at++) {
        unsigned int bit;
        crc ^= (unsigned int)bytes[at] << 8;
        for (bit = 0u; bit < 8u; bit++) {
            crc = ((crc << 1) ^ ((crc & 0x8000u) != 0u ? 0x1021u : 0u)) & 0xFFFFu;
        }
    }
    return (uint16_t)crc;
}

/* Writes the given number of bytes of a number; returns the position after them. */
static uint8_t *{{ lower }}_put(uint8_t *image, uint64_t number, size_t size)
{
    while (size > 0u) {
        size--;
        *image = (uint8_t)(number & 0xFFu);
        image++;
        number >>= 8;
    }
    return image;
}

static void {{ lower }}_save(const uint8_t *group, const {{ lower }}_kept_t *kept, uint8_t *image)
{
    uint8_t *next = {{ lower }}_put(image, kept->layout, sizeof kept->layout);
    const {{ lower }}_entry_t *entry;
    for (entry = {{ lower }}_entries; entry < {{ lower }}_entries + {{ upper }}_ENTRY_COUNT; entry++) {
        const size_t size = {{ lower }}_size(entry);
        size_t at;
        if (!{{ lower }}_is_kept(entry, kept, &at)) {
            continue;
        }
        if ({{ lower }}_number_size({{ lower }}_data_type(entry)) > 0u) {
            next = {{ lower }}_put(next, {{ lower }}_load(group + at, {{ lower }}_data_type(entry), size), size);
        } else if ({{ lower }}_data_type(entry) == {{ upper }}_BLOCK) {
            (void)memcpy(next, group + at, size);
            next += size;
        } else {
            uint16_t length;
            (void)memcpy(&length, group + at, sizeof length);
            if (length > size) {
                length = (uint16_t)size;
            }
            next = {{ lower }}_put(next, length, sizeof length);
            (void)memset(next, 0, size); /* unused bytes after the text */
            (void)memcpy(next, group + at + sizeof length, length);
            next += size;
        }
    }
    (void){{ lower }}_put(next, {{ lower }}_crc16(image, kept->image_size - 2u), 2u);
}

/* Checks the values of an image and copies them to a group unless that is NULL; false if one is not valid for its data type. */
static bool {{ lower }}_take(uint8_t *group, const {{ lower }}_kept_t *kept, const uint8_t *image)
{
    const uint8_t *next = image + sizeof kept->layout;
    const {{ lower }}_entry_t *entry;
    for (entry = {{ lower }}_entries; entry < {{ lower }}_entries + {{ upper }}_ENTRY_COUNT; entry++) {
        const size_t size = {{ lower }}_size(entry);
        size_t at;
        if (!{{ lower }}_is_kept(entry, kept, &at)) {
            continue;
        }
        if ({{ lower }}_number_size({{ lower }}_data_type(entry)) > 0u) {
            const uint64_t number = {{ lower }}_number({{ lower }}_data_type(entry), next, size);
            if ({{ lower }}_data_type(entry) == {{ upper }}_BOOLEAN && number > 1u) {
                return false;
            }
            if (group != NULL) {
                {{ lower }}_store(group + at, {{ lower }}_data_type(entry), size, number);
            }
        } else {
            size_t length = size;
            if ({{ lower }}_data_type(entry) != {{ upper }}_BLOCK) {
                length = (size_t)next[0] | ((size_t)next[1] << 8);
                next += 2;
            }
            if (length > size) {
                return false;
            }
            if (group != NULL) {
                {{ lower }}_store_bytes(group + at, entry, next, length);
            }
        }
        next += size;
    }
    return true;
}

static {{ lower }}_image_t {{ lower }}_load_image(uint8_t *group, const {{ lower }}_kept_t *kept, const uint8_t *image, size_t length)
{
    const size_t end = kept->image_size - 2u;
    uint8_t expected[4];
    if (length != kept->image_size) {
        return {{ upper }}_IMAGE_LENGTH;
    }
    (void){{ lower }}_put(expected, kept->layout, sizeof expected);
    if (memcmp(image, expected, sizeof expected) != 0) {
        return {{ upper }}_IMAGE_LAYOUT;
    }
    (void){{ lower }}_put(expected, {{ lower }}_crc16(image, end), 2u);
    if (memcmp(image + end, expected, 2u) != 0) {
        return {{ upper }}_IMAGE_CHECKSUM;
    }
    if (!{{ lower }}_take(NULL, kept, image)) {
        return {{ upper }}_IMAGE_VALUE;
    }
    (void){{ lower }}_take(group, kept, image);
    return {{ upper }}_IMAGE_OK;
}
{%- for group in groups %}

static const {{ lower }}_kept_t {{ group.lower }}_kept = {
    offsetof({{ lower }}_data_t, {{ group.group.field }}), sizeof({{ group.lower }}_t), {{ group.upper }}_IMAGE_SIZE, {{ group.layout }}u,
};

void {{ group.lower }}_save(const {{ group.lower }}_t *group, uint8_t image[{{ group.upper }}_IMAGE_SIZE])
{
    {{ lower }}_save((const uint8_t *)group, &{{ group.lower }}_kept, image);
}

{{ lower }}_image_t {{ group.lower }}_load({{ group.lower }}_t *group, const uint8_t *image, size_t length)
{
    return {{ lower }}_load_image((uint8_t *)group, &{{ group.lower }}_kept, image, length);
}
{%- endfor %}
