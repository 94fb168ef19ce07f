// Generated from templates/objdict-macros/objdict.h by `cargo xtask templates`; do not edit.

#[allow(clippy::all, clippy::pedantic, reason = "generated")]
impl ObjdictMacrosView<'_> {
    pub(super) fn header(&self) -> String {
        let mut out = String::new();
        put!(out, "/*
 * {}; do not edit.
 *
 * Object dictionary of {} by {}.
 */
#ifndef OBJDICT_H
#define OBJDICT_H

#include <stddef.h>
#include <stdint.h>

/* A stack that defines these macros and their types sets the name of its header here. */
#ifdef OBJDICT_TYPES
#include OBJDICT_TYPES
#else

/* Access types: SDO access and the PDOs that may map the entry. */
enum {{ RO, WO, RW, ROMAP, WOMAP, RWRMAP, RWWMAP }};

/* An entry of the dictionary. */
typedef struct {{
    uint16_t index;
    uint8_t sub;
    uint8_t access;
    uint32_t length; /* bytes */
    void *address;   /* of the value; little-endian if it is larger than a C number */
}} OBJ_ENTRY;

/* The only entry of an object, and an entry of an object with several. */
#define SINGLE_OBJ(index, length, address, access) {{index, 0u, access, length, (void *)(address)}}
#define SUB_OBJ(index, sub, length, address, access) {{index, sub, access, length, (void *)(address)}}

/* The mapping of a PDO. */
typedef struct {{
    uint16_t index;
    uint8_t sub;
    uint8_t bits;
    void *address;
}} MAP_OBJ;

#define MAP_ENTRIES {}
typedef struct {{
    uint8_t count;
    MAP_OBJ entries[MAP_ENTRIES];
}} PDO_MAP;

#define NUM_OF_MAP_ENTRIES(count) count
#define MAP_ENTRY(index, sub, bits, address) {{index, sub, bits, (void *)(address)}}
#define VOID_MAP_ENTRY {{0u, 0u, 0u, NULL}}
#endif

/* All entries in ascending order of index and sub-index. */
#define NUM_OF_OBJ_ENTRIES {}u
extern const OBJ_ENTRY gObjDict[NUM_OF_OBJ_ENTRIES];

/* The mapping of PDO 1 and up. */
#define NUM_OF_RPDOS {}u", self.head.made_by, crate::escape::c_comment(&self.head.product), crate::escape::c_comment(&self.head.vendor), SLOTS, self.rows.len(), self.of(PdoKind::Rpdo).len());
        if !self.of(PdoKind::Rpdo).is_empty() {
            out.push_str("
extern const PDO_MAP gRpdoMap[NUM_OF_RPDOS];");
        }
        put!(out, "
#define NUM_OF_TPDOS {}u", self.of(PdoKind::Tpdo).len());
        if !self.of(PdoKind::Tpdo).is_empty() {
            out.push_str("
extern const PDO_MAP gTpdoMap[NUM_OF_TPDOS];");
        }
        out.push_str("

/* The values. */");
        for variable in &self.variables {
            put!(out, "
extern {}; /* {} */", variable.declaration(), crate::escape::c_comment(&variable.described));
        }
        out.push_str("

#endif");
        out
    }
}
