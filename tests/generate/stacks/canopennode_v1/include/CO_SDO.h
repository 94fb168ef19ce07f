/* The part of the SDO server of CANopenNode 1.3 that a dictionary needs. */
#ifndef CO_SDO_H
#define CO_SDO_H

#define CO_ODA_READABLE 0x04
#define CO_ODA_WRITEABLE 0x08
#define CO_ODA_RPDO_MAPABLE 0x10
#define CO_ODA_TPDO_MAPABLE 0x20
#define CO_ODA_MB_VALUE 0x80

typedef struct {
    uint16_t index;
    uint8_t maxSubIndex;
    uint16_t attribute;
    uint16_t length;
    void *pData;
} CO_OD_entry_t;

typedef struct {
    void *pData;
    uint16_t attribute;
    uint16_t length;
} CO_OD_entryRecord_t;

extern const CO_OD_entry_t CO_OD[];

typedef uint32_t CO_SDO_abortCode_t;

typedef struct {
    void *object;
    uint8_t *data;
    uint16_t dataLength;
    bool_t reading;
} CO_ODF_arg_t;

typedef struct {
    CO_SDO_abortCode_t (*function[2])(CO_ODF_arg_t *);
    void *object;
} CO_SDO_t;

void CO_OD_configure(CO_SDO_t *SDO, uint16_t index, CO_SDO_abortCode_t (*pODFunc)(CO_ODF_arg_t *ODF_arg), void *object,
                     uint8_t *flags, uint8_t flagsSize);

#endif
