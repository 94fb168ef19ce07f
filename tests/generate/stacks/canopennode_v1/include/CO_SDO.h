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

#endif
