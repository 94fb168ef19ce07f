/* The part of the MicroCANopen interface that its tables need; offsets have 16 bits, as in its Plus version. */
#ifndef MCO_H
#define MCO_H

#include <stdint.h>

typedef uint8_t UNSIGNED8;
typedef uint16_t UNSIGNED16;
#define MEM_CONST const

/* A reply of 8 bytes: command, index, sub-index, value. */
#define SDOREPLY(index, sub, length, value) \
    (UNSIGNED8)(0x43u | ((4u - (length)) << 2)), (index) & 0xFF, (index) >> 8, sub, (UNSIGNED8)((value) & 0xFF), \
        (UNSIGNED8)(((value) >> 8) & 0xFF), (UNSIGNED8)(((value) >> 16) & 0xFF), (UNSIGNED8)(((value) >> 24) & 0xFF)
#define SDOREPLY4(index, sub, length, a, b, c, d) \
    (UNSIGNED8)(0x43u | ((4u - (length)) << 2)), (index) & 0xFF, (index) >> 8, sub, a, b, c, d

/* An entry of the process image. */
typedef struct {
    UNSIGNED8 idx_lo;
    UNSIGNED8 idx_hi;
    UNSIGNED8 subidx;
    UNSIGNED8 len;
    UNSIGNED8 off_lo;
    UNSIGNED8 off_hi;
} OD_PROCESS_DATA_ENTRY;
#define ODENTRY(index, sub, length, offset) \
    {(index) & 0xFF, (index) >> 8, sub, length, (offset) & 0xFF, ((offset) >> 8) & 0xFF}
#define ODRD 0x10
#define ODWR 0x20

extern UNSIGNED8 gProcImg[];
extern UNSIGNED8 MEM_CONST SDOResponseTable[];
extern OD_PROCESS_DATA_ENTRY MEM_CONST gODProcTable[];

void MCO_InitTPDO(UNSIGNED8 number, UNSIGNED16 can_id, UNSIGNED16 event, UNSIGNED16 inhibit, UNSIGNED8 length, UNSIGNED16 offset);
void MCO_InitRPDO(UNSIGNED8 number, UNSIGNED16 can_id, UNSIGNED8 length, UNSIGNED16 offset);

#endif
