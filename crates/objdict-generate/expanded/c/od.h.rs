// Generated from templates/c/od.h by `cargo xtask templates`; do not edit.

#[allow(clippy::all, clippy::pedantic, reason = "generated")]
impl CView<'_> {
    pub(super) fn header(&self) -> String {
        let mut out = String::new();
        put!(out, "/**
 * @file
 * {}; do not edit.
 *
 * Object dictionary of {} by {}.
 *
 * {}_data_t contains the variable values, {}_read() and {}_write() implement SDO access.
 */
#ifndef {}_H
#define {}_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern \"C\" {{
#endif", self.table.head.made_by, crate::escape::doxygen(&self.table.head.product), crate::escape::doxygen(&self.table.head.vendor), self.lower, self.lower, self.lower, self.upper, self.upper);
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
        put!(out, "

/** A time of day since 1984-01-01, or a time difference. */
typedef struct {{
    uint32_t milliseconds; /**< after midnight, 28 bits */
    uint16_t days;
}} {}_time_t;", self.lower);
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

/** The variable values; constants are in flash. */
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

/** A location in {}_data_t (0: none, the value is in flash) or in the defaults and limits. */
typedef {} {}_offset_t;

/** An entry of the dictionary; functions return what it has in common with others. */
typedef struct {{
    uint8_t sub;
    {} kind; /**< its data type and flags in {}_kinds */
    {}_offset_t ram;
    {}_offset_t rom;
}} {}_entry_t;

/** An object of the dictionary. */
typedef struct {{
    uint16_t index;
    {} first; /**< the number of its first entry; its last one is before that of the next object */
}} {}_object_t;

/* Flags of an entry. */
#define {}_READ 0x001u            /**< readable by SDO */
#define {}_WRITE 0x002u           /**< writable by SDO */
#define {}_TPDO 0x004u            /**< mappable to TPDOs */
#define {}_RPDO 0x008u            /**< mappable to RPDOs */
#define {}_LOW 0x010u             /**< has a low limit */
#define {}_HIGH 0x020u            /**< has a high limit */
#define {}_NODE_ID_DEFAULT 0x040u /**< the node-ID is added to the default */
#define {}_LOW_NODE_ID 0x080u     /**< the node-ID is added to the low limit */
#define {}_HIGH_NODE_ID 0x100u    /**< the node-ID is added to the high limit */", self.lower, self.lower, self.shared.offset(), self.lower, self.shared.kind(), self.lower, self.lower, self.lower, self.lower, self.shared.first(), self.lower, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper);
        if self.hooks {
            put!(out, "
#define {}_HOOK 0x200u            /**< {}_before_read() and {}_after_write() are called */", self.upper, self.lower, self.lower);
        }
        put!(out, "

/** @name Data types, by their index in CiA 301.
    @{{ */
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
/** @}} */

/* Return codes of {}_read() and {}_write(): the abort codes of CiA 301. */
#define {}_OK 0u
#define {}_ABORT_OUT_OF_MEMORY 0x05040005u   /**< the buffer is shorter than the value */
#define {}_ABORT_WRITE_ONLY 0x06010001u      /**< attempt to read a write-only entry */
#define {}_ABORT_READ_ONLY 0x06010002u       /**< attempt to write a read-only entry */
#define {}_ABORT_NO_OBJECT 0x06020000u       /**< there is no object with this index */
#define {}_ABORT_LENGTH_MISMATCH 0x06070010u /**< the number of bytes does not match the data type */
#define {}_ABORT_TOO_LONG 0x06070012u        /**< more bytes than the data type or the capacity */
#define {}_ABORT_TOO_SHORT 0x06070013u       /**< fewer bytes than the data type */
#define {}_ABORT_NO_SUB_INDEX 0x06090011u    /**< the object has no such sub-index */
#define {}_ABORT_INVALID_VALUE 0x06090030u   /**< not valid for the data type */
#define {}_ABORT_TOO_HIGH 0x06090031u        /**< above the high limit */
#define {}_ABORT_TOO_LOW 0x06090032u         /**< below the low limit */
#define {}_ABORT_CANNOT_STORE 0x08000020u    /**< no capacity for the data; the application must store them */
#define {}_ABORT_NO_DATA 0x08000024u         /**< no data in the table; the application must provide them */", self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.lower, self.lower, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper, self.upper);
        if self.hooks {
            put!(out, "
#define {}_ABORT_INCOMPATIBLE 0x06040043u    /**< for hooks: the value contradicts others */
#define {}_ABORT_HARDWARE 0x06060000u        /**< for hooks: the hardware failed */
#define {}_ABORT_GENERAL 0x08000000u         /**< for hooks: any other error */
#define {}_ABORT_LOCAL_CONTROL 0x08000021u   /**< for hooks: the device is controlled locally */
#define {}_ABORT_DEVICE_STATE 0x08000022u    /**< for hooks: not in this state of the device */", self.upper, self.upper, self.upper, self.upper, self.upper);
        }
        put!(out, "

/** The number of entries. */
#define {}_ENTRY_COUNT {}u
/** All entries in ascending order of index and sub-index. */
extern const {}_entry_t {}_entries[{}_ENTRY_COUNT];
/** Data types and flags of the entries: the type in the lowest five bits. */
extern const uint16_t {}_kinds[{}];

/** The number of objects. */
#define {}_OBJECT_COUNT {}u
/** All objects in ascending order of index. */
extern const {}_object_t {}_objects[{}_OBJECT_COUNT];

/** Sets all values to the defaults for node_id, 1 to 127; only the lower seven bits are used. */
void {}_init({}_data_t *data, uint8_t node_id);

/** Finds the entry with an index and a sub-index by binary search; NULL if there is none. */
const {}_entry_t *{}_find(uint16_t index, uint8_t sub);

/** The index of the object that an entry belongs to, by binary search. */
uint16_t {}_index(const {}_entry_t *entry);

/** The data type of an entry, {}_UNSIGNED32 and the like. */
uint8_t {}_data_type(const {}_entry_t *entry);

/** The flags of an entry, {}_READ and the like. */
uint16_t {}_flags(const {}_entry_t *entry);

/** Maximum size of a value in an SDO transfer, in bytes. */
size_t {}_size(const {}_entry_t *entry);

/** The bytes of the default; for a formula, of the offset to the node-ID. */
const uint8_t *{}_default(const {}_entry_t *entry, size_t *length);
", self.upper, self.table.rows.len(), self.lower, self.lower, self.upper, self.lower, self.shared.kinds.len(), self.upper, self.table.objects.len(), self.lower, self.lower, self.upper, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower, self.upper, self.lower, self.lower, self.upper, self.lower, self.lower, self.lower, self.lower, self.lower, self.lower);
        if self.names {
            put!(out, "
#ifndef {}_NO_NAMES
/** The name in the description, UTF-8. Linkers that remove unused data also remove the names if they are not used. */
const char *{}_name(const {}_entry_t *entry);
#endif
", self.upper, self.lower, self.lower);
        }
        put!(out, "
#ifndef {}_NO_LIMITS
/** The low limit for node_id as a number with the bits of the value; false if there is none. */
bool {}_low_limit(const {}_entry_t *entry, uint8_t node_id, uint64_t *limit);
/** The high limit, like the low one. */
bool {}_high_limit(const {}_entry_t *entry, uint8_t node_id, uint64_t *limit);
#endif", self.upper, self.lower, self.lower, self.lower, self.lower);
        if self.hooks {
            put!(out, "

/* Hooks of the application for the entries selected with --hook: the application defines functions with these names, which replace
   those of {}.c, which only return {}_OK. {}_read() and {}_write() call them. Hooks may change
   any value; codes other than {}_OK abort the transfer. A hook must read its own entry from its member of {}_data_t,
   because {}_read() would call the hook again.

   If {}.c does not support the compiler, define {}_WEAK as its attribute for weak definitions, or define both functions. */
/** Called before an entry is read; may change its value. */
uint32_t {}_before_read({}_data_t *data, uint16_t index, uint8_t sub);
/** Called when an entry has its new value; if the hook rejects it, the old one is restored. Other changes remain. */
uint32_t {}_after_write({}_data_t *data, uint16_t index, uint8_t sub);", self.lower, self.upper, self.lower, self.lower, self.upper, self.lower, self.lower, self.lower, self.upper, self.lower, self.lower, self.lower, self.lower);
        }
        put!(out, "

/** Reads a value into a buffer of size bytes, as transferred by an SDO upload. Returns {}_OK and the number of bytes in
   *length, or the code to abort the upload with. */
uint32_t {}_read(", self.upper, self.lower);
        if !self.hooks {
            out.push_str("const ");
        }
        put!(out, "{}_data_t *data, uint16_t index, uint8_t sub, void *buffer, size_t size, size_t *length);

/** Writes a value transferred by an SDO download if the dictionary allows it. Returns {}_OK, or the code to abort the
   download with and leaves the value unchanged. */
uint32_t {}_write({}_data_t *data, uint16_t index, uint8_t sub, const void *bytes, size_t length);", self.lower, self.upper, self.lower, self.lower);
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
