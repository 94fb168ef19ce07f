// Generated from templates/canfestival/od.c by `cargo xtask templates`; do not edit.

#[allow(clippy::all, clippy::pedantic, reason = "generated")]
impl CanFestivalView<'_> {
    pub(super) fn source(&self) -> String {
        let mut out = String::new();
        put!(out, "/*
 * {}; do not edit.
 *
 * Object dictionary of {} by {}, for CanFestival 3.
 * Numbers of 24 and of 40 to 56 bits and times are bytes, for a little-endian processor.
 *
 * With {}_CALLBACK_IN_ROW it is for forks of the stack whose rows have a callback.
 */
#include \"{}.h\"

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#ifdef {}_CALLBACK_IN_ROW
#define {}_ROW(access, type, size, object) {{access, type, size, (void *)(object), NULL}}
#define {}_ROWS static subindex
#else
#define {}_ROW(access, type, size, object) {{access, type, size, (void *)(object)}}
#define {}_ROWS static const subindex
#endif

/* The variables. */", self.head.made_by, crate::escape::c_comment(&self.head.product), crate::escape::c_comment(&self.head.vendor), self.head.upper, self.head.stem, self.head.upper, self.head.upper, self.head.upper, self.head.upper, self.head.upper);
        for definition in &self.plan.definitions {
            out.push_str("
");
            if definition.is_constant() {
                out.push_str("static ");
            }
            put!(out, "{} = {}; /* {} */", definition.declaration(), definition.initializer, definition.described);
        }
        put!(out, "

UNS32 {}_zero = 0u;

/* The node-ID. */
UNS8 {}_bDeviceNodeId = {}u;
const UNS8 {}_iam_a_slave = {}u;
TIMER_HANDLE {}_heartBeatTimers[{}] = {{", self.head.lower, self.head.lower, self.dictionary.node_id.unwrap_or(0), self.head.lower, self.is_slave(), self.head.lower, self.plan.consumers);
        for _ in 0..self.plan.consumers {
            out.push_str("
    TIMER_NONE,");
        }
        out.push_str("
};");
        if self.plan.ranges.unsigned {
            put!(out, "

static UNS64 {}_unsigned(const void *value, unsigned size)
{{
    UNS64 number = 0u;
    while (size > 0u) {{
        size--;
        number = (number << 8) | ((const UNS8 *)value)[size];
    }}
    return number;
}}", self.head.lower);
        }
        if self.plan.ranges.signed {
            put!(out, "

static INTEGER64 {}_signed(const void *value, unsigned size)
{{
    const UNS64 sign = UINT64_C(1) << (8u * size - 1u);
    return (INTEGER64)(({}_unsigned(value, size) ^ sign) - sign);
}}", self.head.lower, self.head.lower);
        }
        out.push_str("

/* Limits: types of the dictionary that the stack has no numbers for. The abort codes are those of CiA 301. */
#define valueRange_EMC 0x9F");
        for range in &self.plan.ranges.list {
            put!(out, "
#define {} 0x{}", range.name(), crate::escape::hex2(&range.code));
        }
        put!(out, "

UNS32 {}_valueRangeTest(UNS8 typeValue, void *value)
{{
    switch (typeValue) {{
    case valueRange_EMC:
        return *(UNS8 *)value == 0u ? 0u : 0x06090030u;", self.head.lower);
        for range in &self.plan.ranges.list {
            put!(out, "
    case {}: {{ /* {} */
        {}", range.name(), range.type_name(), range.declaration);
            if let Some(condition) = &range.too_low {
                put!(out, "
        if ({}) {{
            return 0x06090032u;
        }}", condition);
            }
            if let Some(condition) = &range.too_high {
                put!(out, "
        if ({}) {{
            return 0x06090031u;
        }}", condition);
            }
            out.push_str("
        return 0u;
    }");
        }
        out.push_str("
    default:
        return 0u;
    }
}");
        for object in &self.plan.objects {
            put!(out, "

/* {}h: {} */", crate::escape::hex4(&object.index), crate::escape::c_comment(&object.name));
            if object.callbacks {
                put!(out, "
#ifndef {}_CALLBACK_IN_ROW
static ODCallback_t {}_Index{}_callbacks[{}] = {{NULL}};
#endif", self.head.upper, self.head.lower, crate::escape::hex4(&object.index), object.rows.len());
            }
            put!(out, "
{}_ROWS {}_Index{}[{}] = {{", self.head.upper, self.head.lower, crate::escape::hex4(&object.index), object.rows.len());
            for row in &object.rows {
                put!(out, "
    {}_ROW({}, {}, {}u, &{}),", self.head.upper, row.access, row.data_type, row.size, row.object);
            }
            out.push_str("
};");
        }
        if self.slots.has(ListSlot::Server) {
            put!(out, "

/* The SDO server, which a node also has without 1200h. */
static UNS32 {}_serverCobIds[2] = {{0x{}u, 0x{}u}};
{}_ROWS {}_server[3] = {{
    {}_ROW(RO, uint8, 1u, &{}_zero),
    {}_ROW(RO, uint32, 4u, &{}_serverCobIds[0]),
    {}_ROW(RO, uint32, 4u, &{}_serverCobIds[1]),
}};", self.head.lower, self.server_cob_id(0x600), self.server_cob_id(0x580), self.head.upper, self.head.lower, self.head.upper, self.head.lower, self.head.upper, self.head.lower, self.head.upper, self.head.lower);
        }
        if self.slots.has(ListSlot::NoPdo) {
            put!(out, "

/* The parameters of a mapping without any: a PDO that is not valid. */
static UNS32 {}_noCobId = 0x80000000u;
{}_ROWS {}_noPdo[6] = {{
    {}_ROW(RO, uint8, 1u, &{}_zero),
    {}_ROW(RO, uint32, 4u, &{}_noCobId),
    {}_ROW(RO, uint8, 1u, &{}_zero),
    {}_ROW(RO, uint16, 2u, &{}_zero),
    {}_ROW(RO, uint8, 1u, &{}_zero),
    {}_ROW(RO, uint16, 2u, &{}_zero),
}};", self.head.lower, self.head.upper, self.head.lower, self.head.upper, self.head.lower, self.head.upper, self.head.lower, self.head.upper, self.head.lower, self.head.upper, self.head.lower, self.head.upper, self.head.lower, self.head.upper, self.head.lower);
        }
        if self.slots.has(ListSlot::NoMapping) {
            put!(out, "

/* The mapping of a PDO without any. */
{}_ROWS {}_noMapping[2] = {{
    {}_ROW(RO, uint8, 1u, &{}_zero),
    {}_ROW(RO, uint32, 4u, &{}_zero),
}};", self.head.upper, self.head.lower, self.head.upper, self.head.lower, self.head.upper, self.head.lower);
        }
        put!(out, "

const indextable {}_objdict[] = {{", self.head.lower);
        for slot in &self.slots.list {
            match slot {
                ListSlot::Object(number) => {
                    let object = &self.plan.objects[*number];
                    put!(out, "
    {{(subindex *){}_Index{}, {}u, 0x{}u}},", self.head.lower, crate::escape::hex4(&object.index), object.rows.len(), crate::escape::hex4(&object.index));
                }
                ListSlot::Nothing => {
                    out.push_str("
    {NULL, 0u, 0u},");
                }
                ListSlot::NoPdo => {
                    put!(out, "
    {{(subindex *){}_noPdo, 6u, 0u}},", self.head.lower);
                }
                ListSlot::Server => {
                    put!(out, "
    {{(subindex *){}_server, 3u, 0u}},", self.head.lower);
                }
                ListSlot::NoMapping => {
                    put!(out, "
    {{(subindex *){}_noMapping, 2u, 0u}},", self.head.lower);
                }
            }
        }
        put!(out, "
}};

#ifdef {}_CALLBACK_IN_ROW
#define {}_CALLBACKS(array)
const indextable *{}_scanIndexOD(CO_Data *d, UNS16 wIndex, UNS32 *errorCode)
#else
#define {}_CALLBACKS(array) *callbacks = array;
const indextable *{}_scanIndexOD(UNS16 wIndex, UNS32 *errorCode, ODCallback_t **callbacks)
#endif
{{
    int i;
#ifdef {}_CALLBACK_IN_ROW
    (void)d;
#else
    *callbacks = NULL;
#endif
    switch (wIndex) {{", self.head.upper, self.head.upper, self.head.lower, self.head.upper, self.head.lower, self.head.upper);
        for (position, number) in self.positions() {
            let object = &self.plan.objects[number];
            put!(out, "
    case 0x{}: i = {};", crate::escape::hex4(&object.index), position);
            if object.callbacks {
                put!(out, " {}_CALLBACKS({}_Index{}_callbacks)", self.head.upper, self.head.lower, crate::escape::hex4(&object.index));
            }
            out.push_str(" break;");
        }
        put!(out, "
    default:
        *errorCode = OD_NO_SUCH_OBJECT;
        return NULL;
    }}
    *errorCode = OD_SUCCESSFUL;
    return &{}_objdict[i];
}}

/* The TPDOs. */
s_PDO_status {}_PDO_status[{}] = {{", self.head.lower, self.head.lower, self.slots.transmitted());
        for _ in 0..self.slots.transmitted() {
            out.push_str("
    s_PDO_status_Initializer,");
        }
        put!(out, "
}};

/* SDO servers and clients, RPDOs and their mappings, TPDOs and their mappings. */
const quick_index {}_firstIndex = {{", self.head.lower);
        for (index0, position) in (&self.slots.first).into_iter().enumerate() {
            if !(index0 == 0) {
                out.push_str(", ");
            }
            put!(out, "{}u", position);
        }
        put!(out, "}};
const quick_index {}_lastIndex = {{", self.head.lower);
        for (index0, position) in (&self.slots.last).into_iter().enumerate() {
            if !(index0 == 0) {
                out.push_str(", ");
            }
            put!(out, "{}u", position);
        }
        put!(out, "}};
const UNS16 {}_ObjdictSize = sizeof({}_objdict) / sizeof({}_objdict[0]);

CO_Data {}_Data = CANOPEN_NODE_DATA_INITIALIZER({});", self.head.lower, self.head.lower, self.head.lower, self.head.lower, self.head.lower);
        if !self.plan.formulas.is_empty() {
            if self.stores_bytes() {
                put!(out, "

static void {}_store(UNS8 *bytes, UNS64 number, unsigned size)
{{
    unsigned at;
    for (at = 0u; at < size; at++) {{
        bytes[at] = (UNS8)(number >> (8u * at));
    }}
}}", self.head.lower);
            }
            put!(out, "

void {}_applyNodeId(UNS8 nodeId)
{{", self.head.lower);
            for formula in &self.plan.formulas {
                put!(out, "
    {}", formula);
            }
            out.push_str("
}");
        }
        out
    }
}
