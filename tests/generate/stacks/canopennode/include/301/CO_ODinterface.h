/* The part of CANopenNode's interface to object dictionaries that generated files and the harness need: names, numbers
   and order of members are facts of version 4 of the stack. */
#ifndef CO_OD_INTERFACE_H
#define CO_OD_INTERFACE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CO_VERSION_MAJOR 4
#define CO_PROGMEM const
#define OD_FLAGS_PDO_SIZE 4U

#ifndef BOOL_T
#define BOOL_T uint_fast8_t
#endif
typedef BOOL_T bool_t;
typedef float float32_t;
typedef double float64_t;
typedef uint32_t OD_size_t;
typedef uint8_t OD_attr_t;

/* Attributes: SDO and PDO access, and how the bytes are stored. */
typedef enum {
    ODA_SDO_R = 0x01,
    ODA_SDO_W = 0x02,
    ODA_SDO_RW = 0x03,
    ODA_TPDO = 0x04,
    ODA_RPDO = 0x08,
    ODA_TRPDO = 0x0C,
    ODA_TSRDO = 0x10,
    ODA_RSRDO = 0x20,
    ODA_TRSRDO = 0x30,
    ODA_MB = 0x40,
    ODA_STR = 0x80
} OD_attributes_t;

/* Return codes of read and write functions; the stack converts them to abort codes. */
typedef enum {
    ODR_PARTIAL = -1,
    ODR_OK = 0,
    ODR_UNSUPP_ACCESS = 2,
    ODR_IDX_NOT_EXIST = 5,
    ODR_DEV_INCOMPAT = 9,
    ODR_TYPE_MISMATCH = 11,
    ODR_DATA_LONG = 12,
    ODR_SUB_NOT_EXIST = 14,
    ODR_INVALID_VALUE = 15,
    ODR_VALUE_HIGH = 16,
    ODR_VALUE_LOW = 17
} ODR_t;

typedef struct {
    void *dataOrig;
    void *object;
    OD_size_t dataLength;
    OD_size_t dataOffset;
    OD_attr_t attribute;
    uint16_t index;
    uint8_t subIndex;
} OD_stream_t;

typedef struct {
    OD_stream_t stream;
    ODR_t (*read)(OD_stream_t *stream, void *buf, OD_size_t count, OD_size_t *countRead);
    ODR_t (*write)(OD_stream_t *stream, const void *buf, OD_size_t count, OD_size_t *countWritten);
} OD_IO_t;

typedef struct {
    void *object;
    ODR_t (*read)(OD_stream_t *stream, void *buf, OD_size_t count, OD_size_t *countRead);
    ODR_t (*write)(OD_stream_t *stream, const void *buf, OD_size_t count, OD_size_t *countWritten);
    uint8_t flagsPDO[OD_FLAGS_PDO_SIZE];
} OD_extension_t;

typedef struct {
    uint16_t index;
    uint8_t subEntriesCount;
    uint8_t odObjectType;
    CO_PROGMEM void *odObject;
    OD_extension_t *extension;
} OD_entry_t;

typedef struct {
    uint16_t size;
    OD_entry_t *list;
} OD_t;

ODR_t OD_readOriginal(OD_stream_t *stream, void *buf, OD_size_t count, OD_size_t *countRead);
ODR_t OD_writeOriginal(OD_stream_t *stream, const void *buf, OD_size_t count, OD_size_t *countWritten);
OD_entry_t *OD_find(OD_t *od, uint16_t index);
ODR_t OD_getSub(const OD_entry_t *entry, uint8_t subIndex, OD_IO_t *io, bool_t odOrig);

static inline ODR_t OD_extension_init(OD_entry_t *entry, OD_extension_t *extension)
{
    if (entry == NULL) {
        return ODR_IDX_NOT_EXIST;
    }
    entry->extension = extension;
    return ODR_OK;
}

#ifdef OD_DEFINITION
typedef enum { ODT_VAR = 0x01, ODT_ARR = 0x02, ODT_REC = 0x03, ODT_TYPE_MASK = 0x0F } OD_objectTypes_t;

typedef struct {
    void *dataOrig;
    OD_attr_t attribute;
    OD_size_t dataLength;
} OD_obj_var_t;

typedef struct {
    uint8_t *dataOrig0;
    void *dataOrig;
    OD_attr_t attribute0;
    OD_attr_t attribute;
    OD_size_t dataElementLength;
    OD_size_t dataElementSizeof;
} OD_obj_array_t;

typedef struct {
    void *dataOrig;
    uint8_t subIndex;
    OD_attr_t attribute;
    OD_size_t dataLength;
} OD_obj_record_t;
#endif

#ifdef __cplusplus
}
#endif

#endif
