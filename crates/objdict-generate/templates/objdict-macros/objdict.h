{# ObjdictMacrosView<'_>::header #}
/*
 * {{ head.made_by }}; do not edit.
 *
 * Object dictionary of {{ head.product|c_comment }} by {{ head.vendor|c_comment }}.
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
enum { RO, WO, RW, ROMAP, WOMAP, RWRMAP, RWWMAP };

/* An entry of the dictionary. */
typedef struct {
    uint16_t index;
    uint8_t sub;
    uint8_t access;
    uint32_t length; /* bytes */
    void *address;   /* of the value; little-endian if it is larger than a C number */
} OBJ_ENTRY;

/* The only entry of an object, and an entry of an object with several. */
#define SINGLE_OBJ(index, length, address, access) {index, 0u, access, length, (void *)(address)}
#define SUB_OBJ(index, sub, length, address, access) {index, sub, access, length, (void *)(address)}

/* The mapping of a PDO. */
typedef struct {
    uint16_t index;
    uint8_t sub;
    uint8_t bits;
    void *address;
} MAP_OBJ;

#define MAP_ENTRIES {{ SLOTS }}
typedef struct {
    uint8_t count;
    MAP_OBJ entries[MAP_ENTRIES];
} PDO_MAP;

#define NUM_OF_MAP_ENTRIES(count) count
#define MAP_ENTRY(index, sub, bits, address) {index, sub, bits, (void *)(address)}
#define VOID_MAP_ENTRY {0u, 0u, 0u, NULL}
#endif

/* All entries in ascending order of index and sub-index. */
#define NUM_OF_OBJ_ENTRIES {{ rows.len() }}u
extern const OBJ_ENTRY gObjDict[NUM_OF_OBJ_ENTRIES];

/* The mapping of PDO 1 and up. */
#define NUM_OF_RPDOS {{ self.of(PdoKind::Rpdo).len() }}u
{%- if !self.of(PdoKind::Rpdo).is_empty() %}
extern const PDO_MAP gRpdoMap[NUM_OF_RPDOS];
{%- endif %}
#define NUM_OF_TPDOS {{ self.of(PdoKind::Tpdo).len() }}u
{%- if !self.of(PdoKind::Tpdo).is_empty() %}
extern const PDO_MAP gTpdoMap[NUM_OF_TPDOS];
{%- endif %}

/* The values. */
{%- for variable in variables %}
extern {{ variable.declaration() }}; /* {{ variable.described|c_comment }} */
{%- endfor %}

#endif
