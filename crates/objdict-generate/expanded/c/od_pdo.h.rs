// Generated from templates/c/od_pdo.h by `cargo xtask templates`; do not edit.

#[allow(clippy::all, clippy::pedantic, reason = "generated")]
impl PdoFiles<'_> {
    pub(super) fn header(&self) -> String {
        let mut out = String::new();
        put!(out, "/**
 * @file
 * {}; do not edit.
 *
 * The default mapping of PDOs: one struct per PDO with its members in frame order.
 *
 * {}_..._load() reads the values from the dictionary, {}_..._store() writes them without checking
 * limits; {}_..._pack() and {}_..._unpack() convert them to a frame and back.", self.table.head.made_by, self.lower, self.lower, self.lower, self.lower);
        if !self.are_fixed {
            put!(out, "
 *
 * SDOs can write the mappings, but the structs keep these: the application transfers a PDO with another one with {}_read()
 * and {}_write().", self.lower, self.lower);
        }
        put!(out, "
 */
#ifndef {}_PDO_H
#define {}_PDO_H

#include \"{}.h\"

#ifndef {}_NO_PDO

#ifdef __cplusplus
extern \"C\" {{
#endif", self.upper, self.upper, self.stem, self.upper);
        for frame in &self.frames {
            put!(out, "

/** {} ({}h, {}h) */
#define {}_LENGTH {}u", frame.frame.title, crate::escape::hex4(&frame.frame.communication_index), crate::escape::hex4(&frame.frame.mapping_index), frame.macro_prefix, frame.frame.length);
            if let Some(transmission_type) = &frame.frame.transmission_type {
                put!(out, "
#define {}_TRANSMISSION_TYPE {}u", frame.macro_prefix, transmission_type);
            }
            if let Some(cob_id) = &frame.cob_id {
                put!(out, "
#define {}_COB_ID(node_id) {}", frame.macro_prefix, cob_id);
            }
            out.push_str("

typedef struct {");
            for field in &frame.fields {
                put!(out, "
    {}; /**< {}h sub-index {}h: {} */", field.declaration, crate::escape::hex4(&field.row.index), crate::escape::hex2(&field.row.sub), crate::escape::doxygen(&field.row.name));
            }
            put!(out, "
}} {}_t;

void {}_load(const {}_data_t *data, {}_t *pdo);
void {}_store(const {}_t *pdo, {}_data_t *data);
void {}_pack(const {}_t *pdo, uint8_t frame[{}]);
void {}_unpack(const uint8_t frame[{}], {}_t *pdo);", frame.type_name, frame.type_name, self.lower, frame.type_name, frame.type_name, frame.type_name, self.lower, frame.type_name, frame.type_name, frame.frame.length, frame.type_name, frame.frame.length, frame.type_name);
        }
        put!(out, "

#ifdef __cplusplus
}}
#endif

#endif /* {}_NO_PDO */

#endif", self.upper);
        out
    }
}
