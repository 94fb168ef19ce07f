/* The declarations of a CANopenNode port, for a little-endian node without CAN controller and with one thread. */
#ifndef CO_DRIVER_TARGET_H
#define CO_DRIVER_TARGET_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define CO_LITTLE_ENDIAN
#define CO_SWAP_16(number) number
#define CO_SWAP_32(number) number
#define CO_SWAP_64(number) number

typedef bool bool_t;
typedef float float32_t;
typedef double float64_t;

typedef struct {
    uint16_t can_id;
    uint8_t length;
    uint8_t bytes[8];
} frame_t;

#define CO_CANrxMsg_readIdent(frame) (((const frame_t *)(frame))->can_id)
#define CO_CANrxMsg_readDLC(frame) (((const frame_t *)(frame))->length)
#define CO_CANrxMsg_readData(frame) (((const frame_t *)(frame))->bytes)

typedef struct {
    uint16_t ident;
    uint16_t mask;
    void *object;
    void (*CANrx_callback)(void *object, void *message);
} CO_CANrx_t;

typedef struct {
    uint32_t ident;
    uint8_t DLC;
    uint8_t data[8];
    bool_t bufferFull;
    bool_t syncFlag;
} CO_CANtx_t;

typedef struct {
    void *CANptr;
    CO_CANrx_t *rxArray;
    uint16_t rxSize;
    CO_CANtx_t *txArray;
    uint16_t txSize;
    uint16_t CANerrorStatus;
    bool_t CANnormal;
} CO_CANmodule_t;

typedef struct {
    void *addr;
    size_t len;
    uint8_t subIndexOD;
    uint8_t attr;
} CO_storage_entry_t;

#define CO_LOCK_CAN_SEND(module) (void)(module)
#define CO_UNLOCK_CAN_SEND(module) (void)(module)
#define CO_LOCK_EMCY(module) (void)(module)
#define CO_UNLOCK_EMCY(module) (void)(module)
#define CO_LOCK_OD(module) (void)(module)
#define CO_UNLOCK_OD(module) (void)(module)

#define CO_MemoryBarrier()
#define CO_FLAG_READ(received) ((received) != NULL)
#define CO_FLAG_SET(received) ((received) = (void *)1L)
#define CO_FLAG_CLEAR(received) ((received) = NULL)

#endif
