// Generated from templates/c/od_pdo.c by `cargo xtask templates`; do not edit.

#[allow(clippy::all, clippy::pedantic, reason = "generated")]
impl PdoFiles<'_> {
    pub(super) fn source(&self) -> String {
        let mut out = String::new();
        put!(out, "/*
 * {}; do not edit.
 */
#include \"{}_pdo.h\"

#include <string.h>

#ifndef {}_NO_PDO

/* The lowest bits of a number, 1 to 64. */
static uint64_t {}_lowest(uint64_t number, unsigned bits)
{{
    const unsigned unused = 64u - bits;
    return number & (UINT64_MAX >> unused);
}}

/* Converts a frame to a number; the first byte is the lowest. */
static uint64_t {}_from_frame(const uint8_t *frame, size_t length)
{{
    uint64_t number = 0u;
    while (length > 0u) {{
        length--;
        number = (number << 8) | frame[length];
    }}
    return number;
}}

static void {}_to_frame(uint64_t number, uint8_t *frame, size_t length)
{{
    size_t at;
    for (at = 0u; at < length; at++) {{
        frame[at] = (uint8_t)(number & 0xFFu);
        number >>= 8;
    }}
}}", self.table.head.made_by, self.stem, self.upper, self.lower, self.lower, self.lower);
        if self.uses_signs() {
            put!(out, "

/* Converts the given number of bits to a signed number. */
static int64_t {}_signed(uint64_t number, unsigned bits)
{{
    const uint64_t lowest = {}_lowest(UINT64_MAX, bits);
    if (number > (lowest >> 1)) {{
        const uint64_t below = lowest - number;
        return -(int64_t)below - 1;
    }}
    return (int64_t)number;
}}", self.lower, self.lower);
        }
        if self.uses(TypeKind::Real32) {
            put!(out, "

static uint64_t {}_from_real32(float value)
{{
    uint32_t bits;
    (void)memcpy(&bits, &value, sizeof bits);
    return bits;
}}

static float {}_to_real32(uint64_t number)
{{
    const uint32_t bits = (uint32_t)number;
    float value;
    (void)memcpy(&value, &bits, sizeof value);
    return value;
}}", self.lower, self.lower);
        }
        if self.uses(TypeKind::Real64) {
            put!(out, "

static uint64_t {}_from_real64(double value)
{{
    uint64_t bits;
    (void)memcpy(&bits, &value, sizeof bits);
    return bits;
}}

static double {}_to_real64(uint64_t number)
{{
    double value;
    (void)memcpy(&value, &number, sizeof value);
    return value;
}}", self.lower, self.lower);
        }
        if self.uses(TypeKind::TimeOfDay) || self.uses(TypeKind::TimeDifference) {
            put!(out, "

static uint64_t {}_from_time({}_time_t value)
{{
    return (value.milliseconds & 0x0FFFFFFFu) | ((uint64_t)value.days << 32);
}}

static {}_time_t {}_to_time(uint64_t number)
{{
    {}_time_t value;
    value.milliseconds = (uint32_t)(number & 0x0FFFFFFFu);
    value.days = (uint16_t)((number >> 32) & 0xFFFFu);
    return value;
}}", self.lower, self.lower, self.lower, self.lower, self.lower);
        }
        for frame in &self.frames {
            put!(out, "

/* {} */

void {}_load(const {}_data_t *data, {}_t *pdo)
{{", frame.frame.title, frame.type_name, self.lower, frame.type_name);
            if !frame.reads_data {
                out.push_str("
    (void)data;");
            }
            out.push_str("
    (void)memset(pdo, 0, sizeof *pdo);");
            for field in &frame.fields {
                put!(out, "
    {};", field.load);
            }
            put!(out, "
}}

void {}_store(const {}_t *pdo, {}_data_t *data)
{{", frame.type_name, frame.type_name, self.lower);
            if !frame.writes_data {
                out.push_str("
    (void)pdo;
    (void)data;");
            }
            for field in &frame.fields {
                for line in &field.store {
                    put!(out, "
    {};", line);
                }
            }
            put!(out, "
}}

void {}_pack(const {}_t *pdo, uint8_t frame[{}])
{{
    uint64_t number = 0u;", frame.type_name, frame.type_name, frame.frame.length);
            for field in &frame.fields {
                put!(out, "
    number |= {}_lowest({}, {}u) << {};", self.lower, field.pack, field.field.bits, field.field.first);
            }
            put!(out, "
    {}_to_frame(number, frame, {}u);
}}

void {}_unpack(const uint8_t frame[{}], {}_t *pdo)
{{
    const uint64_t number = {}_from_frame(frame, {}u);", self.lower, frame.frame.length, frame.type_name, frame.frame.length, frame.type_name, self.lower, frame.frame.length);
            for field in &frame.fields {
                put!(out, "
    {};", field.unpack);
            }
            out.push_str("
}");
        }
        out.push_str("

#endif");
        out
    }
}
