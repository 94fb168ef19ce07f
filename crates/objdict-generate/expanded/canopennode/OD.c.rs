// Generated from templates/canopennode/OD.c by `cargo xtask templates`; do not edit.

#[allow(clippy::all, clippy::pedantic, reason = "generated")]
impl CanOpenNodeView<'_> {
    pub(super) fn source(&self) -> String {
        let mut out = String::new();
        let od = self.prefix.as_str();
        put!(out, "/*
 * {}; do not edit.
 *
 * Object dictionary of {} by {} for CANopenNode 4.
 */
#define OD_DEFINITION
#include \"301/CO_ODinterface.h\"
#include \"{}.h\"", self.head.made_by, crate::escape::c_comment(&self.head.product), crate::escape::c_comment(&self.head.vendor), self.head.stem);
        if self.has_math() {
            out.push_str("

#include <math.h>");
        }
        if self.limits.is_some() {
            out.push_str("

#include <string.h>");
        }
        out.push_str("

#if CO_VERSION_MAJOR < 4
#error this object dictionary is for CANopenNode 4
#endif

/* Values by storage group. Formulas do not include the node-ID. */");
        for group in &self.groups {
            put!(out, "
{}_ATTR_{} {}_{}_t {}_{} = {{", od, group.name, od, group.name, od, group.name);
            for field in &group.fields {
                put!(out, "
    {},", field.initialiser);
            }
            out.push_str("
};
");
        }
        out.push_str("
/* Object descriptors. */
typedef struct {");
        for object in &self.objects {
            match &object.layout {
                ObjectLayout::Var(_) => {
                    put!(out, "
    OD_obj_var_t o_{};", object.name());
                }
                ObjectLayout::Array(_, _) => {
                    put!(out, "
    OD_obj_array_t o_{};", object.name());
                }
                ObjectLayout::Record(members) => {
                    put!(out, "
    OD_obj_record_t o_{}[{}];", object.name(), members.len());
                }
            }
        }
        out.push_str("
} ODObjs_t;

static CO_PROGMEM ODObjs_t ODObjs = {");
        for object in &self.objects {
            put!(out, "
    .o_{} = {{", object.name());
            match &object.layout {
                ObjectLayout::Var(member) => {
                    put!(out, "
        .dataOrig = {},
        .attribute = {},
        .dataLength = {},", object.address(member, od), member.storage.attribute, member.storage.length);
                }
                ObjectLayout::Array(sub0, elements) => {
                    let storage = &elements[0].storage;
                    put!(out, "
        .dataOrig0 = {},
        .dataOrig = {},
        .attribute0 = {},
        .attribute = {},
        .dataElementLength = {},
        .dataElementSizeof = ", object.address(sub0, od), object.address(&elements[0], od), sub0.storage.attribute, storage.attribute, storage.length);
                    if let Some(type_) = &storage.type_ {
                        put!(out, "sizeof({}{})", type_, storage.dimension());
                    }
                    else {
                        out.push_str("0");
                    }
                    out.push_str(",");
                }
                ObjectLayout::Record(members) => {
                    for member in members {
                        put!(out, "
        {{.dataOrig = {}, .subIndex = {}, .attribute = {}, .dataLength = {}}},", object.address(member, od), member.entry.sub, member.storage.attribute, member.storage.length);
                    }
                }
            }
            out.push_str("
    },");
        }
        put!(out, "
}};

/* All objects, by index. */
static {}_ATTR_OD OD_entry_t ODList[] = {{", od);
        for object in &self.objects {
            put!(out, "
    {{0x{}, 0x{:02X}, ODT_{}, &ODObjs.o_{}, NULL}},", crate::escape::hex4(&object.index), object.members().count(), object.kind(), object.name());
        }
        put!(out, "
    {{0x0000, 0x00, 0, NULL, NULL}}
}};

static OD_t _{} = {{
    (sizeof(ODList) / sizeof(ODList[0])) - 1,
    &ODList[0]
}};

OD_t *{} = &_{};", od, od, od);
        if self.sets_bytes() {
            out.push_str("

/* Sets a value stored as bytes. */
static void setBytes(uint8_t *bytes, uint8_t length, uint64_t value)
{
    for (uint8_t i = 0; i < length; i++) {
        bytes[i] = (uint8_t)(value & 0xFFU);
        value >>= 8;
    }
}");
        }
        put!(out, "

void {}_applyNodeId(uint8_t nodeId)
{{", od);
        if self.applied.is_empty() {
            out.push_str("
    (void)nodeId;");
        }
        else {
            out.push_str("
    const uint32_t id = nodeId & 0x7FU;");
            for statement in &self.applied {
                put!(out, "
    {}", statement);
            }
        }
        out.push_str("
}");
        if !self.hooks.is_empty() {
            put!(out, "

static OD_extension_t hookExtensions[{}] = {{", self.hooks.len());
            for hook in &self.hooks {
                out.push_str("
    {.read = ");
                if hook.is_read {
                    put!(out, "{}_read_H{}", od, crate::escape::hex4(&hook.index));
                }
                else {
                    out.push_str("OD_readOriginal");
                }
                out.push_str(",
     .write = ");
                if hook.is_written {
                    put!(out, "{}_write_H{}", od, crate::escape::hex4(&hook.index));
                }
                else {
                    out.push_str("OD_writeOriginal");
                }
                out.push_str("},");
            }
            put!(out, "
}};

void {}_initHooks(void *object)
{{", od);
            for (index0, hook) in (&self.hooks).into_iter().enumerate() {
                put!(out, "
    hookExtensions[{}].object = object;
    (void)OD_extension_init(&ODList[{}], &hookExtensions[{}]);", index0, hook.position, index0);
            }
            out.push_str("
}");
        }
        if let Some(limits) = &self.limits {
            out.push_str("
");
            if limits.is_empty() {
                put!(out, "
void {}_initLimits(uint8_t nodeId)
{{
    (void)nodeId;
}}

ODR_t {}_writeLimited(OD_stream_t *stream, const void *buf, OD_size_t count, OD_size_t *countWritten)
{{
    return OD_writeOriginal(stream, buf, count, countWritten);
}}", od, od);
            }
            else {
                out.push_str("
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

static CO_PROGMEM Limit_t limits[] = {");
                for row in limits {
                    put!(out, "
    {{{}}},", row.row);
                }
                put!(out, "
}};

static uint8_t limitNodeId;
static OD_extension_t limitExtensions[{}];

/* Converts a value to a number, with sign extension. */
static uint64_t limitedValue(CO_PROGMEM Limit_t *limit, const void *buf)
{{
    uint64_t value = 0;
    if ((limit->flags & LIMIT_BYTES) != 0U || limit->length == 1U) {{
        const uint8_t *bytes = (const uint8_t *)buf;
        for (uint8_t i = limit->length; i > 0U; i--) {{
            value = (value << 8) | bytes[i - 1U];
        }}
    }} else if (limit->length == 2U) {{
        uint16_t number;
        (void)memcpy(&number, buf, sizeof(number));
        value = number;
    }} else if (limit->length == 4U) {{
        uint32_t number;
        (void)memcpy(&number, buf, sizeof(number));
        value = number;
    }} else {{
        (void)memcpy(&value, buf, sizeof(value));
    }}
    if ((limit->flags & LIMIT_SIGNED) != 0U) {{
        const uint64_t sign = 1ULL << (8U * limit->length - 1U);
        value = (value ^ sign) - sign;
    }}
    return value;
}}", limits::objects(limits));
                if limits::has_real(limits) {
                    out.push_str("

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
}");
                }
                out.push_str("

/* Whether the first number is less than the second. */
static bool_t isLess(CO_PROGMEM Limit_t *limit, uint64_t first, uint64_t second)
{
    /* inverting the sign bit makes signed numbers comparable as unsigned */
    const uint64_t bias = (limit->flags & LIMIT_SIGNED) != 0U ? 1ULL << 63 : 0U;");
                if limits::has_real(limits) {
                    out.push_str("
    if ((limit->flags & LIMIT_REAL) != 0U) {
        return realNumber(limit, first) < realNumber(limit, second);
    }");
                }
                out.push_str("
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
    value = limitedValue(limit, buf);");
                if limits::has_real(limits) {
                    out.push_str("
    if ((limit->flags & LIMIT_REAL) != 0U) {
        const float64_t number = realNumber(limit, value);
        if (!(number <= 0.0) && !(number >= 0.0)) {
            return ODR_INVALID_VALUE; /* not a number */
        }
    }");
                }
                put!(out, "
    if ((limit->flags & LIMIT_LOW) != 0U && isLess(limit, value, low)) {{
        return ODR_VALUE_LOW;
    }}
    if ((limit->flags & LIMIT_HIGH) != 0U && isLess(limit, high, value)) {{
        return ODR_VALUE_HIGH;
    }}
    return ODR_OK;
}}

static uint32_t limitKey(uint16_t index, uint8_t subIndex)
{{
    return ((uint32_t)index << 8) | subIndex;
}}

/* Finds the limits of an entry by binary search; NULL if it has none. */
static CO_PROGMEM Limit_t *findLimit(uint16_t index, uint8_t subIndex)
{{
    const uint32_t key = limitKey(index, subIndex);
    CO_PROGMEM Limit_t *limit = limits;
    size_t count = sizeof(limits) / sizeof(limits[0]);
    while (count > 1U) {{ /* ends at the last row not greater than the key */
        const size_t half = count / 2U;
        if (limitKey(limit[half].index, limit[half].subIndex) <= key) {{
            limit += half;
        }}
        count -= half;
    }}
    return limitKey(limit->index, limit->subIndex) == key ? limit : NULL;
}}

ODR_t {}_writeLimited(OD_stream_t *stream, const void *buf, OD_size_t count, OD_size_t *countWritten)
{{
    if (stream != NULL && buf != NULL) {{
        CO_PROGMEM Limit_t *limit = findLimit(stream->index, stream->subIndex);
        const ODR_t answer = limit != NULL ? checkLimit(limit, buf, count) : ODR_OK;
        if (answer != ODR_OK) {{
            return answer;
        }}
    }}
    return OD_writeOriginal(stream, buf, count, countWritten);
}}

void {}_initLimits(uint8_t nodeId)
{{
    OD_extension_t *extension = limitExtensions;
    limitNodeId = (uint8_t)(nodeId & 0x7FU);
    for (size_t i = 0; i < sizeof(limits) / sizeof(limits[0]); i++) {{
        OD_entry_t *entry = &ODList[limits[i].object];
        if (i > 0U && limits[i].object != limits[i - 1U].object) {{
            extension++;
        }}
        if (entry->extension == NULL) {{
            extension->object = NULL;
            extension->read = OD_readOriginal;
            extension->write = {}_writeLimited;
            (void)OD_extension_init(entry, extension);
        }}
    }}
}}", od, od, od);
            }
        }
        out
    }
}
