// Generated from templates/c/structs.h by `cargo xtask templates`; do not edit.

#[allow(clippy::all, clippy::pedantic, reason = "generated")]
impl CView<'_> {
    pub(super) fn structs_header(&self) -> String {
        let mut out = String::new();
        put!(out, "/**
 * @file
 * {}; do not edit.
 *
 * Object dictionary of {} by {}.
 *
 * {}_entries is an array of structures, one per entry; {}_data contains the variable values.
 */
#ifndef {}_H
#define {}_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern \"C\" {{
#endif", self.table.head.made_by, crate::escape::doxygen(&self.table.head.product), crate::escape::doxygen(&self.table.head.vendor), self.lower, self.lower, self.upper, self.upper);
        if let Some(node_id) = &self.table.node_id {
            put!(out, "

/** The configured node-ID. */
#define {}_NODE_ID {}u", self.upper, node_id);
        }
        out.push_str("

/* Indexes of objects and sub-indexes of their entries. */");
        for view in &self.objects {
            put!(out, "

/** {}h: {} */
#define {}_{} 0x{}u", crate::escape::hex4(&view.object.index), crate::escape::doxygen(&view.object.name), self.upper, view.name, crate::escape::hex4(&view.object.index));
            for (name, row) in &view.entries {
                put!(out, "
#define {}_{} 0x{}u /**< {} */", self.upper, name, crate::escape::hex2(&row.sub), crate::escape::doxygen(&row.name));
            }
        }
        out.push_str("

/* Default values of identity and services, decoded. COB-IDs depend on the node-ID. */");
        for item in &self.defaults {
            put!(out, "
#define {}_{} {} /**< {} */", self.upper, item.name, item.value, item.meaning);
        }
        if let Some(meanings) = &self.meanings {
            put!(out, "

{}", meanings.text());
        }
        if self.has_time() || !self.groups.is_empty() {
            put!(out, "
/** A time of day since 1984-01-01, or a time difference. */
typedef struct {{
    uint32_t milliseconds; /**< after midnight, 28 bits */
    uint16_t days;
}} {}_time_t;", self.lower);
        }
        for group in &self.groups {
            put!(out, "

/** The storage group {}. */
typedef struct {{", crate::escape::doxygen(&group.group.name));
            for field in &group.fields {
                put!(out, "
    {}; /**< {}h sub-index {}h", field.declaration, crate::escape::hex4(&field.first.index), crate::escape::hex2(&field.first.sub));
                if field.array {
                    put!(out, " to {}h", crate::escape::hex2(&field.last.sub));
                }
                put!(out, ", {}: {} */", field.first.access(), crate::escape::doxygen(&field.first.name));
            }
            put!(out, "
}} {}_t;", group.lower);
        }
        put!(out, "

/** The variable values; constants are in flash. A string, octet string or DOMAIN is preceded by its length. */
typedef struct {{
    uint8_t node_id; /**< set by {}_init() */", self.lower);
        for member in &self.fields {
            match member {
                MemberView::Field(field) => {
                    put!(out, "
    {}; /**< {}h sub-index {}h", field.declaration, crate::escape::hex4(&field.first.index), crate::escape::hex2(&field.first.sub));
                    if field.array {
                        put!(out, " to {}h", crate::escape::hex2(&field.last.sub));
                    }
                    put!(out, ", {}: {} */", field.first.access(), crate::escape::doxygen(&field.first.name));
                }
                MemberView::Group(group) => {
                    put!(out, "
    {}_t {}; /**< the storage group {} */", group.lower, group.group.field, crate::escape::doxygen(&group.group.name));
                }
            }
        }
        put!(out, "
}} {}_data_t;
extern {}_data_t {}_data;

/** An entry of the dictionary. data, low, high and def point to the C type of the data type as in
   {}_data_t; an integer of 24 to 56 bits uses the next larger type. */
typedef struct {{
    uint16_t index;
    uint8_t sub;
    uint8_t data_type; /**< {}_UNSIGNED32 and the like */
    uint8_t flags;     /**< {}_READ and the like */
    uint16_t size;     /**< maximum size of a value in an SDO transfer, in bytes */
    void *data;        /**< the value; for a constant, its default in flash. NULL: the application must provide it */
    const void *low;   /**< limits; NULL if there are none */
    const void *high;
    const void *def;   /**< the default */", self.lower, self.lower, self.lower, self.lower, self.upper, self.upper);
        if self.names {
            out.push_str("
    const char *name; /**< the name in the description, UTF-8 */");
        }
        put!(out, "
}} {}_entry_t;

/* Flags of an entry. */
#define {}_READ 0x01u            /**< readable by SDO */
#define {}_WRITE 0x02u           /**< writable by SDO */
#define {}_TPDO 0x04u            /**< mappable to TPDOs */
#define {}_RPDO 0x08u            /**< mappable to RPDOs */
#define {}_NODE_ID_DEFAULT 0x10u /**< the node-ID must be added to the default */
#define {}_LOW_NODE_ID 0x20u     /**< the node-ID is to be added to the low limit */
#define {}_HIGH_NODE_ID 0x40u    /**< the node-ID is to be added to the high limit */", self.lower, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper);
        if self.hooks {
            put!(out, "
#define {}_HOOK 0x80u           /**< selected with --hook: the application handles reads and writes */", self.upper);
        }
        put!(out, "

/* Data types, by their index in CiA 301. */
#define {}_BLOCK 0x00u /**< a device-specific type */
#define {}_BOOLEAN 0x01u
#define {}_INTEGER8 0x02u
#define {}_INTEGER16 0x03u
#define {}_INTEGER32 0x04u
#define {}_UNSIGNED8 0x05u
#define {}_UNSIGNED16 0x06u
#define {}_UNSIGNED32 0x07u
#define {}_REAL32 0x08u
#define {}_VISIBLE_STRING 0x09u
#define {}_OCTET_STRING 0x0Au
#define {}_UNICODE_STRING 0x0Bu
#define {}_TIME_OF_DAY 0x0Cu
#define {}_TIME_DIFFERENCE 0x0Du
#define {}_DOMAIN 0x0Fu
#define {}_INTEGER24 0x10u
#define {}_REAL64 0x11u
#define {}_INTEGER40 0x12u
#define {}_INTEGER48 0x13u
#define {}_INTEGER56 0x14u
#define {}_INTEGER64 0x15u
#define {}_UNSIGNED24 0x16u
#define {}_UNSIGNED40 0x18u
#define {}_UNSIGNED48 0x19u
#define {}_UNSIGNED56 0x1Au
#define {}_UNSIGNED64 0x1Bu

/** All entries in ascending order of index and sub-index. */
#define {}_ENTRY_COUNT {}u
extern const {}_entry_t {}_entries[{}_ENTRY_COUNT];

/** Finds the entry with an index and a sub-index by binary search; NULL if there is none. */
const {}_entry_t *{}_find(uint16_t index, uint8_t sub);

/** Sets all values to the defaults for node_id, 1 to 127; only the lower seven bits are used. */
void {}_init(uint8_t node_id);", self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.table.rows.len(), self.lower, self.lower, self.upper, self.lower, self.lower, self.lower);
        if !self.groups.is_empty() {
            put!(out, "

/** An image of a storage group has {}_..._IMAGE_SIZE bytes: a hash of its layout, the values and a CRC. It is the same for
   every compiler and processor. */
typedef enum {{
    {}_IMAGE_OK,
    {}_IMAGE_LENGTH,   /**< wrong length */
    {}_IMAGE_LAYOUT,   /**< from a group with other entries, data types or lengths, or never saved */
    {}_IMAGE_CHECKSUM, /**< wrong CRC */
    {}_IMAGE_VALUE     /**< a value is not valid for its data type */
}} {}_image_t;

/* {}_..._STORE_SUB_INDEX is the group's sub-index of objects 1010h and 1011h, if known. */", self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.lower, self.upper);
            for group in &self.groups {
                put!(out, "
#define {}_IMAGE_SIZE {}u", group.upper, group.group.image_size);
                if let Some(sub_index) = &group.group.sub_index {
                    put!(out, "
#define {}_STORE_SUB_INDEX {}u", group.upper, sub_index);
                }
                put!(out, "
/** Writes the values of the group to an image for non-volatile memory. */
void {}_save(const {}_t *group, uint8_t image[{}_IMAGE_SIZE]);
/** Reads the values from an image without checking limits; unless it returns {}_IMAGE_OK, no value changes. */
{}_image_t {}_load({}_t *group, const uint8_t *image, size_t length);", group.lower, group.lower, group.upper, self.upper, self.lower, group.lower, group.lower);
            }
        }
        out.push_str("

#ifdef __cplusplus
}
#endif

#endif");
        out
    }
}
