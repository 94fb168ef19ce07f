// Generated from templates/c/od.c by `cargo xtask templates`; do not edit.

#[allow(clippy::all, clippy::pedantic, reason = "generated")]
impl CView<'_> {
    pub(super) fn source(&self) -> String {
        let mut out = String::new();
        put!(out, "/*
 * {}; do not edit.
 *
 * Object dictionary of {} by {}.
 */
#include \"{}.h\"", self.table.head.made_by, crate::escape::c_comment(&self.table.head.product), crate::escape::c_comment(&self.table.head.vendor), self.stem);
        let has_pointers = false;
        put!(out, "

#include <string.h>

/* The types of the values. */
typedef char {}_bool_has_1_byte[sizeof(bool) == 1 ? 1 : -1];", self.lower);
        if self.table.keeps(DataType::REAL32) {
            put!(out, "
typedef char {}_float_has_4_bytes[sizeof(float) == 4 ? 1 : -1];", self.lower);
        }
        if self.table.keeps(DataType::REAL64) {
            put!(out, "
typedef char {}_double_has_8_bytes[sizeof(double) == 8 ? 1 : -1];", self.lower);
        }
        put!(out, "

#define {}_RAM(field) (({}_offset_t)offsetof({}_data_t, field))

const {}_entry_t {}_entries[{}_ENTRY_COUNT] = {{", self.upper, self.lower, self.lower, self.lower, self.lower, self.upper);
        for (row, kind) in self.table.rows.iter().zip(self.shared.kind_of.iter()) {
            put!(out, "
    {{0x{}u, {}u, ", crate::escape::hex2(&row.sub), kind);
            if let Some(slot) = &row.slot {
                put!(out, "{}_RAM({})", self.upper, self.table.place(slot));
            }
            else {
                out.push_str("0u");
            }
            put!(out, ", {}u}}, /* {}h: {} */", row.rom, crate::escape::hex4(&row.index), crate::escape::c_comment(&row.name));
        }
        put!(out, "
}};

const uint16_t {}_kinds[{}] = {{", self.lower, self.shared.kinds.len());
        for (data_type, flags) in &self.shared.kinds {
            put!(out, "
    (({}) << 5) | {}_{},", flags, self.upper, data_type);
        }
        put!(out, "
}};

const {}_object_t {}_objects[{}_OBJECT_COUNT] = {{", self.lower, self.lower, self.upper);
        for object in &self.table.objects {
            put!(out, "
    {{0x{}u, {}u}}, /* {} */", crate::escape::hex4(&object.index), object.rows.start, crate::escape::c_comment(&object.name));
        }
        put!(out, "
}};

/* Defaults and limits. For a number: the default, then the low and the high limit if stated. For other types: the
   capacity, the length of the default and the default. */
#define {}_ROM_SIZE {}u
static const uint8_t {}_rom[{}_ROM_SIZE] = {{", self.upper, self.table.rom.len(), self.lower, self.upper);
        for line in self.rom() {
            put!(out, "
    {},", line);
        }
        put!(out, "
}};

/* Finds an entry, or returns what is missing. */
static uint32_t {}_lookup(uint16_t index, uint8_t sub, const {}_entry_t **found)
{{
    const {}_entry_t *entry;
    size_t object = 0u;
    size_t count = {}_OBJECT_COUNT;
    while (count > 1u) {{ /* ends at the last object not greater than the index */
        const size_t half = count / 2u;
        if ({}_objects[object + half].index <= index) {{
            object += half;
        }}
        count -= half;
    }}
    if ({}_objects[object].index != index) {{
        return {}_ABORT_NO_OBJECT;
    }}
    entry = &{}_entries[{}_objects[object].first];
    count = (object + 1u < {}_OBJECT_COUNT ? {}_objects[object + 1u].first : {}_ENTRY_COUNT) - {}_objects[object].first;
    while (count > 1u) {{ /* ends at its last entry not greater than the sub-index */
        const size_t half = count / 2u;
        if (entry[half].sub <= sub) {{
            entry += half;
        }}
        count -= half;
    }}
    *found = entry;
    return entry->sub == sub ? {}_OK : {}_ABORT_NO_SUB_INDEX;
}}

const {}_entry_t *{}_find(uint16_t index, uint8_t sub)
{{
    const {}_entry_t *entry = NULL;
    return {}_lookup(index, sub, &entry) == {}_OK ? entry : NULL;
}}

uint16_t {}_index(const {}_entry_t *entry)
{{
    size_t object = 0u;
    size_t count = {}_OBJECT_COUNT;
    while (count > 1u) {{ /* ends at the last object that does not start after the entry */
        const size_t half = count / 2u;
        if (&{}_entries[{}_objects[object + half].first] <= entry) {{
            object += half;
        }}
        count -= half;
    }}
    return {}_objects[object].index;
}}

uint8_t {}_data_type(const {}_entry_t *entry)
{{
    return (uint8_t)({}_kinds[entry->kind] & 0x1Fu);
}}

uint16_t {}_flags(const {}_entry_t *entry)
{{
    return (uint16_t)({}_kinds[entry->kind] >> 5);
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

#ifndef {}_NO_LIMITS
/* Converts a value to a number with the same order; false for NaN. */
static bool {}_order(uint8_t data_type, uint64_t number, uint64_t *order)
{{
    const uint64_t sign = (uint64_t)1u << 63;
    uint64_t infinity = (uint64_t)0x7FF00000u << 32;
    uint64_t magnitude;
    if (data_type != {}_REAL32 && data_type != {}_REAL64) {{
        *order = {}_is_signed(data_type) ? number ^ sign : number;
        return true;
    }}
    if (data_type == {}_REAL32) {{
        number <<= 32;
        infinity = (uint64_t)0x7F800000u << 32;
    }}
    magnitude = number & ~sign;
    *order = (number & sign) == 0u ? sign + magnitude : sign - magnitude;
    return magnitude <= infinity;
}}
#endif

/* One of the two lengths before a non-numeric default. */
static size_t {}_head(const {}_entry_t *entry, size_t skip)
{{
    const uint8_t *head = &{}_rom[entry->rom + skip];
    return (size_t)head[0] | ((size_t)head[1] << 8);
}}

/* Reads a number from flash and adds the node-ID if the flag is set. */
static uint64_t {}_rom_number(const {}_entry_t *entry, size_t block, unsigned int flag, uint8_t node_id)
{{
    const size_t size = {}_number_size({}_data_type(entry));
    const uint64_t number = {}_number({}_data_type(entry), &{}_rom[entry->rom + block * size], size);
    return ({}_flags(entry) & flag) == 0u ? number : number + (node_id & 0x7Fu);
}}

size_t {}_size(const {}_entry_t *entry)
{{
    const size_t size = {}_number_size({}_data_type(entry));
    return size == 0u ? {}_head(entry, 0u) : size;
}}

const uint8_t *{}_default(const {}_entry_t *entry, size_t *length)
{{
    const size_t size = {}_number_size({}_data_type(entry));
    *length = size == 0u ? {}_head(entry, 2u) : size;
    return {}_rom + entry->rom + (size == 0u ? 4u : 0u); /* can be the end of {}_rom if the default is empty */
}}

#ifndef {}_NO_LIMITS
bool {}_low_limit(const {}_entry_t *entry, uint8_t node_id, uint64_t *limit)
{{
    if (({}_flags(entry) & {}_LOW) == 0u) {{
        return false;
    }}
    *limit = {}_rom_number(entry, 1u, {}_LOW_NODE_ID, node_id);
    return true;
}}

bool {}_high_limit(const {}_entry_t *entry, uint8_t node_id, uint64_t *limit)
{{
    if (({}_flags(entry) & {}_HIGH) == 0u) {{
        return false;
    }}
    *limit = {}_rom_number(entry, ({}_flags(entry) & {}_LOW) == 0u ? 1u : 2u, {}_HIGH_NODE_ID, node_id);
    return true;
}}
#endif

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

void {}_init({}_data_t *data, uint8_t node_id)
{{
    uint8_t *const ram = (uint8_t *)data;
    const {}_entry_t *entry;
    (void)memset(data, 0, sizeof *data);
    data->node_id = node_id & 0x7Fu;
    for (entry = {}_entries; entry < {}_entries + {}_ENTRY_COUNT; entry++) {{
        const size_t size = {}_number_size({}_data_type(entry));
        if (entry->ram == 0u) {{
            continue;
        }}
        if (size > 0u) {{
            const uint64_t number = {}_rom_number(entry, 0u, {}_NODE_ID_DEFAULT, node_id);
            {}_store(ram + entry->ram, {}_data_type(entry), size, number);
        }} else {{
            size_t length;
            const uint8_t *bytes = {}_default(entry, &length);
            {}_store_bytes(ram + entry->ram, entry, bytes, length);
        }}
    }}
}}", self.lower, self.lower, self.lower, self.upper, self.lower, self.lower, self.upper, self.lower, self.lower, self.upper, self.lower, self.upper, self.lower, self.upper, self.upper, self.lower, self.lower, self.lower, self.lower, self.upper, self.lower, self.lower, self.upper, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.lower, self.upper, self.upper, self.lower, self.upper, self.upper, self.upper, self.upper, self.upper, self.lower, self.lower, self.upper, self.lower, self.upper, self.upper, self.lower, self.upper, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.upper, self.lower, self.lower, self.lower, self.upper, self.lower, self.upper, self.lower, self.lower, self.lower, self.upper, self.lower, self.lower, self.upper, self.upper, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.upper, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.upper, self.lower, self.lower, self.lower, self.upper, self.lower, self.lower, self.lower, self.lower);
        if self.hooks {
            put!(out, "

/* Marks a definition as weak. */
#ifndef {}_WEAK
#if defined(__GNUC__) || defined(__clang__) || defined(__ARMCC_VERSION)
#define {}_WEAK __attribute__((weak))
#elif defined(__IAR_SYSTEMS_ICC__)
#define {}_WEAK __weak
#endif
#endif

#ifdef {}_WEAK
{}_WEAK uint32_t {}_before_read({}_data_t *data, uint16_t index, uint8_t sub)
{{
    (void)data;
    (void)index;
    (void)sub;
    return {}_OK;
}}

{}_WEAK uint32_t {}_after_write({}_data_t *data, uint16_t index, uint8_t sub)
{{
    (void)data;
    (void)index;
    (void)sub;
    return {}_OK;
}}
#endif

/* Size of an entry's value in {}_data_t, in bytes. */
static size_t {}_kept_size(const {}_entry_t *entry)
{{
    const size_t size = {}_number_size({}_data_type(entry));
    if ({}_is_time({}_data_type(entry))) {{
        return sizeof({}_time_t);
    }}
    if (size > 2u) {{
        return size <= 4u ? 4u : 8u;
    }}
    if (size > 0u) {{
        return size;
    }}
    return {}_size(entry) + ({}_data_type(entry) == {}_BLOCK ? 0u : 2u);
}}", self.upper, self.upper, self.upper, self.upper, self.upper, self.lower, self.lower, self.upper, self.upper, self.lower, self.lower, self.upper, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.upper);
        }
        put!(out, "

uint32_t {}_read(", self.lower);
        if !self.hooks {
            out.push_str("const ");
        }
        put!(out, "{}_data_t *data, uint16_t index, uint8_t sub, void *buffer, size_t size, size_t *length)
{{
    const {}_entry_t *entry = NULL;
    const uint32_t missing = {}_lookup(index, sub, &entry);
    uint8_t data_type;
    const uint8_t *field;
    const uint8_t *bytes;
    uint8_t number_bytes[8];
    size_t count;
    if (missing != {}_OK) {{
        return missing;
    }}
    data_type = {}_data_type(entry);
    if (({}_flags(entry) & {}_READ) == 0u) {{
        return {}_ABORT_WRITE_ONLY;
    }}", self.lower, self.lower, self.lower, self.upper, self.lower, self.lower, self.upper, self.upper);
        if self.hooks {
            put!(out, "
    if (({}_flags(entry) & {}_HOOK) != 0u) {{
        const uint32_t answer = {}_before_read(data, index, sub);
        if (answer != {}_OK) {{
            return answer;
        }}
    }}", self.lower, self.upper, self.lower, self.upper);
        }
        put!(out, "
    field = (const uint8_t *)data + entry->ram;
    count = {}_number_size(data_type);
    if (count > 0u) {{
        uint64_t number = entry->ram == 0u ? {}_rom_number(entry, 0u, {}_NODE_ID_DEFAULT, data->node_id)
                                           : {}_load(field, data_type, count);
        size_t at;
        for (at = 0u; at < sizeof number_bytes; at++) {{
            number_bytes[at] = (uint8_t)(number & 0xFFu);
            number >>= 8;
        }}
        bytes = number_bytes;
    }} else if (entry->ram == 0u) {{
        if (data_type == {}_DOMAIN && {}_size(entry) == 0u) {{
            return {}_ABORT_NO_DATA;
        }}
        bytes = {}_default(entry, &count);
    }} else if (data_type == {}_BLOCK) {{
        bytes = field;
        count = {}_size(entry);
    }} else {{
        uint16_t filled;
        (void)memcpy(&filled, field, sizeof filled);
        bytes = field + sizeof filled;
        count = filled < {}_size(entry) ? filled : {}_size(entry);
    }}
    if (count > size) {{
        return {}_ABORT_OUT_OF_MEMORY;
    }}
    if (count > 0u) {{
        (void)memcpy(buffer, bytes, count);
    }}
    *length = count;
    return {}_OK;
}}

static uint32_t {}_check_length(const {}_entry_t *entry, size_t length)
{{
    const uint8_t data_type = {}_data_type(entry);
    const size_t capacity = {}_size(entry);
    const bool exact = {}_number_size(data_type) > 0u || data_type == {}_BLOCK;
    if (length > capacity) {{
        return {}_ABORT_TOO_LONG;
    }}
    if (exact && length < capacity) {{
        return {}_ABORT_TOO_SHORT;
    }}
    if (data_type == {}_UNICODE_STRING && (length & 1u) != 0u) {{
        return {}_ABORT_LENGTH_MISMATCH;
    }}
    return {}_OK;
}}

#ifndef {}_NO_LIMITS
static uint32_t {}_check_limits(const {}_entry_t *entry, uint64_t number, uint8_t node_id)
{{
    const uint8_t data_type = {}_data_type(entry);
    uint64_t value;
    uint64_t limit = 0u;
    if (({}_flags(entry) & ({}_LOW | {}_HIGH)) == 0u) {{
        return {}_OK;
    }}
    if (!{}_order(data_type, number, &value)) {{
        return {}_ABORT_INVALID_VALUE;
    }}
    if ({}_low_limit(entry, node_id, &limit) && {}_order(data_type, limit, &limit) && value < limit) {{
        return {}_ABORT_TOO_LOW;
    }}
    if ({}_high_limit(entry, node_id, &limit) && {}_order(data_type, limit, &limit) && value > limit) {{
        return {}_ABORT_TOO_HIGH;
    }}
    return {}_OK;
}}
#endif

static uint32_t {}_check_value(const {}_entry_t *entry, uint64_t number, uint8_t node_id)
{{
    if ({}_data_type(entry) == {}_BOOLEAN && number > 1u) {{
        return {}_ABORT_INVALID_VALUE;
    }}
#ifdef {}_NO_LIMITS
    (void)node_id;
    return {}_OK;
#else
    return {}_check_limits(entry, number, node_id);
#endif
}}

uint32_t {}_write({}_data_t *data, uint16_t index, uint8_t sub, const void *bytes, size_t length)
{{
    const {}_entry_t *entry = NULL;
    uint32_t answer = {}_lookup(index, sub, &entry);
    size_t size;
    uint8_t data_type;
    uint8_t *field;", self.lower, self.lower, self.upper, self.lower, self.upper, self.lower, self.upper, self.lower, self.upper, self.lower, self.lower, self.lower, self.upper, self.upper, self.lower, self.lower, self.lower, self.lower, self.lower, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.lower, self.lower, self.lower, self.lower, self.upper, self.upper, self.upper, self.lower, self.upper, self.lower, self.lower, self.upper, self.lower, self.lower, self.upper, self.upper, self.lower, self.lower, self.lower, self.upper, self.upper, self.upper, self.upper, self.lower, self.lower, self.lower, self.lower, self.lower);
        if self.hooks {
            put!(out, "
    uint8_t old[{}];", hooks::room(self.table));
        }
        put!(out, "
    if (answer != {}_OK) {{
        return answer;
    }}
    if (({}_flags(entry) & {}_WRITE) == 0u) {{
        return {}_ABORT_READ_ONLY;
    }}
    if (entry->ram == 0u) {{
        return {}_ABORT_CANNOT_STORE;
    }}
    answer = {}_check_length(entry, length);
    if (answer != {}_OK) {{
        return answer;
    }}
    field = (uint8_t *)data + entry->ram;", self.upper, self.lower, self.upper, self.upper, self.upper, self.lower, self.upper);
        if self.hooks {
            put!(out, "
    if (({}_flags(entry) & {}_HOOK) != 0u) {{
        (void)memcpy(old, field, {}_kept_size(entry));
    }}", self.lower, self.upper, self.lower);
        }
        put!(out, "
    data_type = {}_data_type(entry);
    size = {}_number_size(data_type);
    if (size > 0u) {{
        const uint64_t number = {}_number(data_type, (const uint8_t *)bytes, size);
        answer = {}_check_value(entry, number, data->node_id);
        if (answer == {}_OK) {{
            {}_store(field, data_type, size, number);
        }}
    }} else {{
        {}_store_bytes(field, entry, (const uint8_t *)bytes, length);
    }}", self.lower, self.lower, self.lower, self.lower, self.upper, self.lower, self.lower);
        if self.hooks {
            put!(out, "
    if (answer == {}_OK && ({}_flags(entry) & {}_HOOK) != 0u) {{
        answer = {}_after_write(data, index, sub);
        if (answer != {}_OK) {{
            (void)memcpy(field, old, {}_kept_size(entry));
        }}
    }}", self.upper, self.lower, self.upper, self.lower, self.upper, self.lower);
        }
        out.push_str("
    return answer;
}");
        if !self.groups.is_empty() {
            put!(out, "

/* The location of a storage group in {}_data_t, and the start of its image. */
typedef struct {{
    size_t first;
    size_t size;
    size_t image_size;
    uint32_t layout;
}} {}_kept_t;

/* Finds an entry's value in a group; false if the group does not contain it. */
static bool {}_is_kept(const {}_entry_t *entry, const {}_kept_t *kept, size_t *at)
{{", self.lower, self.lower, self.lower, self.lower, self.lower);
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
        if self.names {
            put!(out, "

#ifndef {}_NO_NAMES
static const char *const {}_names[{}_ENTRY_COUNT] = {{", self.upper, self.lower, self.upper);
            for row in &self.table.rows {
                put!(out, "
    {},", crate::escape::c_text(&row.name));
            }
            put!(out, "
}};

const char *{}_name(const {}_entry_t *entry)
{{
    return {}_names[entry - {}_entries];
}}
#endif", self.lower, self.lower, self.lower, self.lower);
        }
        out
    }
}
