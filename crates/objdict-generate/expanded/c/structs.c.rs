// Generated from templates/c/structs.c by `cargo xtask templates`; do not edit.

#[allow(clippy::all, clippy::pedantic, reason = "generated")]
impl CView<'_> {
    pub(super) fn structs_source(&self) -> String {
        let mut out = String::new();
        put!(out, "/*
 * {}; do not edit.
 *
 * Object dictionary of {} by {}.
 */
#include \"{}.h\"", self.table.head.made_by, crate::escape::c_comment(&self.table.head.product), crate::escape::c_comment(&self.table.head.vendor), self.stem);
        let has_pointers = true;
        let structs = self.structs();
        out.push_str("

#include <string.h>

/* Numbers used as defaults and limits, without duplicates. */");
        for pool in &structs.pools {
            put!(out, "
static const {} {}[{}] = {{", pool.c_type, pool.name, pool.numbers.len());
            for number in &pool.numbers {
                put!(out, "
    {},", number);
            }
            out.push_str("
};");
        }
        if !structs.blocks.is_empty() {
            out.push_str("

/* Non-numeric defaults. */");
            for block in &structs.blocks {
                put!(out, "
{}", block);
            }
        }
        put!(out, "

{}_data_t {}_data;

const {}_entry_t {}_entries[{}_ENTRY_COUNT] = {{", self.lower, self.lower, self.lower, self.lower, self.upper);
        for view in &structs.rows {
            put!(out, "
    {{0x{}u, 0x{}u, {}_{}, {}, {}u, {}, {}, {}, {}", crate::escape::hex4(&view.row.index), crate::escape::hex2(&view.row.sub), self.upper, view.type_, view.flags, view.row.resolved.shape.size(), view.data, view.low, view.high, view.default);
            if self.names {
                put!(out, ", {}", crate::escape::c_text(&view.row.name));
            }
            out.push_str("},");
        }
        put!(out, "
}};

static uint32_t {}_key(uint16_t index, uint8_t sub)
{{
    return ((uint32_t)index << 8) | sub;
}}

const {}_entry_t *{}_find(uint16_t index, uint8_t sub)
{{
    const uint32_t key = {}_key(index, sub);
    const {}_entry_t *entry = {}_entries;
    size_t count = {}_ENTRY_COUNT;
    while (count > 1u) {{ /* ends at the last entry not greater than the key */
        const size_t half = count / 2u;
        if ({}_key(entry[half].index, entry[half].sub) <= key) {{
            entry += half;
        }}
        count -= half;
    }}
    return entry->index == index && entry->sub == sub ? entry : NULL;
}}

/* Size of a value in {}_data_t, in bytes. */
static size_t {}_stored_size(const {}_entry_t *entry)
{{", self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.upper, self.lower, self.lower, self.lower, self.lower);
        if self.has_time() {
            put!(out, "
    if (entry->data_type == {}_TIME_OF_DAY || entry->data_type == {}_TIME_DIFFERENCE) {{
        return sizeof({}_time_t);
    }}", self.upper, self.upper, self.lower);
        }
        put!(out, "
    if (entry->data_type == {}_BLOCK || entry->size <= 2u) {{
        return entry->size;
    }}
    return entry->size <= 4u ? 4u : 8u;
}}

/* Adds the node-ID to an integer. */
static void {}_add_node_id(void *data, size_t size, uint8_t node_id)
{{
    if (size == 1u) {{
        uint8_t number;
        (void)memcpy(&number, data, sizeof number);
        number = (uint8_t)(number + node_id);
        (void)memcpy(data, &number, sizeof number);
    }} else if (size == 2u) {{
        uint16_t number;
        (void)memcpy(&number, data, sizeof number);
        number = (uint16_t)(number + node_id);
        (void)memcpy(data, &number, sizeof number);
    }} else if (size == 4u) {{
        uint32_t number;
        (void)memcpy(&number, data, sizeof number);
        number += node_id;
        (void)memcpy(data, &number, sizeof number);
    }} else {{
        uint64_t number;
        (void)memcpy(&number, data, sizeof number);
        number += node_id;
        (void)memcpy(data, &number, sizeof number);
    }}
}}

void {}_init(uint8_t node_id)
{{
    const {}_entry_t *entry;
    (void)memset(&{}_data, 0, sizeof {}_data);
    {}_data.node_id = node_id & 0x7Fu;
    for (entry = {}_entries; entry < {}_entries + {}_ENTRY_COUNT; entry++) {{
        size_t size = {}_stored_size(entry);
        if (entry->data == NULL || entry->data == entry->def) {{
            continue; /* served by the application, or constant */
        }}", self.upper, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.upper, self.lower);
        if self.has_bytes() {
            put!(out, "
        if ((entry->data_type >= {}_VISIBLE_STRING && entry->data_type <= {}_UNICODE_STRING)
            || entry->data_type == {}_DOMAIN) {{
            uint16_t length;
            (void)memcpy(&length, entry->def, sizeof length);
            size = sizeof length + length;
        }}", self.upper, self.upper, self.upper);
        }
        put!(out, "
        (void)memcpy(entry->data, entry->def, size);
        if ((entry->flags & {}_NODE_ID_DEFAULT) != 0u) {{
            {}_add_node_id(entry->data, size, {}_data.node_id);
        }}
    }}
}}", self.upper, self.lower, self.lower);
        if !self.groups.is_empty() {
            put!(out, "

static size_t {}_size(const {}_entry_t *entry)
{{
    return entry->size;
}}

static uint8_t {}_data_type(const {}_entry_t *entry)
{{
    return entry->data_type;
}}

/* Size of a number of this data type, in bytes; 0 for other types. */
static size_t {}_number_size(uint8_t data_type)
{{
    switch (data_type) {{
    case {}_BOOLEAN:
    case {}_INTEGER8:
    case {}_UNSIGNED8:
        return 1u;
    case {}_INTEGER16:
    case {}_UNSIGNED16:
        return 2u;
    case {}_INTEGER24:
    case {}_UNSIGNED24:
        return 3u;
    case {}_INTEGER32:
    case {}_UNSIGNED32:
    case {}_REAL32:
        return 4u;
    case {}_INTEGER40:
    case {}_UNSIGNED40:
        return 5u;
    case {}_INTEGER48:
    case {}_UNSIGNED48:
    case {}_TIME_OF_DAY:
    case {}_TIME_DIFFERENCE:
        return 6u;
    case {}_INTEGER56:
    case {}_UNSIGNED56:
        return 7u;
    case {}_INTEGER64:
    case {}_UNSIGNED64:
    case {}_REAL64:
        return 8u;
    default:
        return 0u;
    }}
}}

static bool {}_is_time(uint8_t data_type)
{{
    return data_type == {}_TIME_OF_DAY || data_type == {}_TIME_DIFFERENCE;
}}

static bool {}_is_signed(uint8_t data_type)
{{
    return (data_type >= {}_INTEGER8 && data_type <= {}_INTEGER32) || data_type == {}_INTEGER24
        || (data_type >= {}_INTEGER40 && data_type <= {}_INTEGER64);
}}

/* Converts at most eight bytes to a number, with sign extension. */
static uint64_t {}_number(uint8_t data_type, const uint8_t *bytes, size_t size)
{{
    uint64_t number = {}_is_signed(data_type) && (bytes[size - 1u] & 0x80u) != 0u ? UINT64_MAX : 0u;
    while (size > 0u) {{
        size--;
        number = (number << 8) | bytes[size];
    }}
    return number;
}}

/* Reads a number from a field. */
static uint64_t {}_load(const uint8_t *field, uint8_t data_type, size_t size)
{{
    uint64_t number = 0u;
    if ({}_is_time(data_type)) {{
        {}_time_t time;
        (void)memcpy(&time, field, sizeof time);
        return (time.milliseconds & 0x0FFFFFFFu) | ((uint64_t)time.days << 32);
    }}
    if (size == 1u) {{
        number = *field;
    }} else if (size == 2u) {{
        uint16_t value;
        (void)memcpy(&value, field, sizeof value);
        number = value;
    }} else if (size <= 4u) {{
        uint32_t value;
        (void)memcpy(&value, field, sizeof value);
        number = value;
    }} else {{
        (void)memcpy(&number, field, sizeof number);
    }}
    return number;
}}

/* Writes a number to a field. */
static void {}_store(uint8_t *field, uint8_t data_type, size_t size, uint64_t number)
{{
    if ({}_is_time(data_type)) {{
        {}_time_t time;
        (void)memset(&time, 0, sizeof time);
        time.milliseconds = (uint32_t)(number & 0x0FFFFFFFu);
        time.days = (uint16_t)((number >> 32) & 0xFFFFu);
        (void)memcpy(field, &time, sizeof time);
    }} else if (size == 1u) {{
        *field = (uint8_t)(number & 0xFFu);
    }} else if (size == 2u) {{
        const uint16_t value = (uint16_t)(number & 0xFFFFu);
        (void)memcpy(field, &value, sizeof value);
    }} else if (size <= 4u) {{
        const uint32_t value = (uint32_t)(number & 0xFFFFFFFFu);
        (void)memcpy(field, &value, sizeof value);
    }} else {{
        (void)memcpy(field, &number, sizeof number);
    }}
}}

/* Writes bytes to a field: after their length, or all bytes of a block. */
static void {}_store_bytes(uint8_t *field, const {}_entry_t *entry, const uint8_t *bytes, size_t length)
{{
    if ({}_data_type(entry) != {}_BLOCK) {{
        const uint16_t count = (uint16_t)length;
        (void)memcpy(field, &count, sizeof count);
        field += sizeof count;
        (void)memset(field, 0, {}_size(entry));
    }}
    if (length > 0u) {{
        (void)memcpy(field, bytes, length);
    }}
}}

/* The location of a storage group in {}_data_t, and the start of its image. */
typedef struct {{
    size_t first;
    size_t size;
    size_t image_size;
    uint32_t layout;
}} {}_kept_t;

/* Finds an entry's value in a group; false if the group does not contain it. */
static bool {}_is_kept(const {}_entry_t *entry, const {}_kept_t *kept, size_t *at)
{{", self.lower, self.lower, self.lower, self.lower, self.lower, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.lower, self.upper, self.upper, self.lower, self.upper, self.upper, self.upper, self.upper, self.upper, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.upper, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower);
            if has_pointers {
                put!(out, "
    const uintptr_t place = (uintptr_t)entry->data;
    const uintptr_t first = (uintptr_t)&{}_data + kept->first;
    *at = (size_t)(place - first);
    return entry->data != NULL && place >= first && place - first < kept->size;", self.lower);
            }
            else {
                out.push_str("
    *at = (size_t)entry->ram - kept->first;
    return entry->ram >= kept->first && *at < kept->size;");
            }
            put!(out, "
}}

/* The CRC of CiA 301: x^16 + x^12 + x^5 + 1, initial value 0. */
static uint16_t {}_crc16(const uint8_t *bytes, size_t length)
{{
    unsigned int crc = 0u;
    size_t at;
    for (at = 0u; at < length; at++) {{
        unsigned int bit;
        crc ^= (unsigned int)bytes[at] << 8;
        for (bit = 0u; bit < 8u; bit++) {{
            crc = ((crc << 1) ^ ((crc & 0x8000u) != 0u ? 0x1021u : 0u)) & 0xFFFFu;
        }}
    }}
    return (uint16_t)crc;
}}

/* Writes the given number of bytes of a number; returns the position after them. */
static uint8_t *{}_put(uint8_t *image, uint64_t number, size_t size)
{{
    while (size > 0u) {{
        size--;
        *image = (uint8_t)(number & 0xFFu);
        image++;
        number >>= 8;
    }}
    return image;
}}

static void {}_save(const uint8_t *group, const {}_kept_t *kept, uint8_t *image)
{{
    uint8_t *next = {}_put(image, kept->layout, sizeof kept->layout);
    const {}_entry_t *entry;
    for (entry = {}_entries; entry < {}_entries + {}_ENTRY_COUNT; entry++) {{
        const size_t size = {}_size(entry);
        size_t at;
        if (!{}_is_kept(entry, kept, &at)) {{
            continue;
        }}
        if ({}_number_size({}_data_type(entry)) > 0u) {{
            next = {}_put(next, {}_load(group + at, {}_data_type(entry), size), size);
        }} else if ({}_data_type(entry) == {}_BLOCK) {{
            (void)memcpy(next, group + at, size);
            next += size;
        }} else {{
            uint16_t length;
            (void)memcpy(&length, group + at, sizeof length);
            if (length > size) {{
                length = (uint16_t)size;
            }}
            next = {}_put(next, length, sizeof length);
            (void)memset(next, 0, size); /* unused bytes after the text */
            (void)memcpy(next, group + at + sizeof length, length);
            next += size;
        }}
    }}
    (void){}_put(next, {}_crc16(image, kept->image_size - 2u), 2u);
}}

/* Checks the values of an image and copies them to a group unless that is NULL; false if one is not valid for its data type. */
static bool {}_take(uint8_t *group, const {}_kept_t *kept, const uint8_t *image)
{{
    const uint8_t *next = image + sizeof kept->layout;
    const {}_entry_t *entry;
    for (entry = {}_entries; entry < {}_entries + {}_ENTRY_COUNT; entry++) {{
        const size_t size = {}_size(entry);
        size_t at;
        if (!{}_is_kept(entry, kept, &at)) {{
            continue;
        }}
        if ({}_number_size({}_data_type(entry)) > 0u) {{
            const uint64_t number = {}_number({}_data_type(entry), next, size);
            if ({}_data_type(entry) == {}_BOOLEAN && number > 1u) {{
                return false;
            }}
            if (group != NULL) {{
                {}_store(group + at, {}_data_type(entry), size, number);
            }}
        }} else {{
            size_t length = size;
            if ({}_data_type(entry) != {}_BLOCK) {{
                length = (size_t)next[0] | ((size_t)next[1] << 8);
                next += 2;
            }}
            if (length > size) {{
                return false;
            }}
            if (group != NULL) {{
                {}_store_bytes(group + at, entry, next, length);
            }}
        }}
        next += size;
    }}
    return true;
}}

static {}_image_t {}_load_image(uint8_t *group, const {}_kept_t *kept, const uint8_t *image, size_t length)
{{
    const size_t end = kept->image_size - 2u;
    uint8_t expected[4];
    if (length != kept->image_size) {{
        return {}_IMAGE_LENGTH;
    }}
    (void){}_put(expected, kept->layout, sizeof expected);
    if (memcmp(image, expected, sizeof expected) != 0) {{
        return {}_IMAGE_LAYOUT;
    }}
    (void){}_put(expected, {}_crc16(image, end), 2u);
    if (memcmp(image + end, expected, 2u) != 0) {{
        return {}_IMAGE_CHECKSUM;
    }}
    if (!{}_take(NULL, kept, image)) {{
        return {}_IMAGE_VALUE;
    }}
    (void){}_take(group, kept, image);
    return {}_IMAGE_OK;
}}", self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.upper, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.upper, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.upper, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.upper, self.lower, self.lower, self.lower, self.upper, self.lower, self.lower, self.lower, self.lower, self.upper, self.lower, self.upper, self.lower, self.lower, self.upper, self.lower, self.upper, self.lower, self.upper);
            for group in &self.groups {
                put!(out, "

static const {}_kept_t {}_kept = {{
    offsetof({}_data_t, {}), sizeof({}_t), {}_IMAGE_SIZE, {}u,
}};

void {}_save(const {}_t *group, uint8_t image[{}_IMAGE_SIZE])
{{
    {}_save((const uint8_t *)group, &{}_kept, image);
}}

{}_image_t {}_load({}_t *group, const uint8_t *image, size_t length)
{{
    return {}_load_image((uint8_t *)group, &{}_kept, image, length);
}}", self.lower, group.lower, self.lower, group.group.field, group.lower, group.upper, group.layout, group.lower, group.lower, group.upper, self.lower, group.lower, self.lower, group.lower, group.lower, self.lower, group.lower);
            }
        }
        out
    }
}
