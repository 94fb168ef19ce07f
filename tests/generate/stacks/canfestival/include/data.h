/*
 * The part of the interface of CanFestival 3 that a dictionary needs. With OD_CALLBACK_IN_ROW that of a fork.
 */
#ifndef DATA_H
#define DATA_H

#include <stddef.h>
#include <stdint.h>

#define UNS8 uint8_t
#define UNS16 uint16_t
#define UNS32 uint32_t
#define UNS64 uint64_t
#define INTEGER8 int8_t
#define INTEGER16 int16_t
#define INTEGER32 int32_t
#define INTEGER64 int64_t
#define REAL32 float
#define REAL64 double

/* Types of the dictionary. */
#define boolean 0x01
#define int8 0x02
#define int16 0x03
#define int32 0x04
#define uint8 0x05
#define uint16 0x06
#define uint32 0x07
#define real32 0x08
#define visible_string 0x09
#define octet_string 0x0A
#define unicode_string 0x0B
#define time_of_day 0x0C
#define time_difference 0x0D
#define domain 0x0F
#define int24 0x10
#define real64 0x11
#define int40 0x12
#define int48 0x13
#define int56 0x14
#define int64 0x15
#define uint24 0x16
#define uint40 0x18
#define uint48 0x19
#define uint56 0x1A
#define uint64 0x1B

#define RW 0x00
#define WO 0x01
#define RO 0x02
#define TO_BE_SAVE 0x04

#define OD_SUCCESSFUL 0x00000000
#define OD_NO_SUCH_OBJECT 0x06020000

/* Names in headers of the stack that variables must not have. */
#define Rx 0
#define Tx 1
#define NMT 0x0
#define SYNC 0x1
#define REQUEST 1
#define TRUE 1
#define FALSE 0
#define identity 0x23
#define pdo_mapping 0x21
typedef struct { UNS16 cob_id; UNS8 rtr, len, data[8]; } Message;
enum { Initialisation, Disconnected, Operational };

typedef int TIMER_HANDLE;
#define TIMER_NONE (-1)

typedef struct co_data CO_Data;
struct index_table;
typedef UNS32 (*ODCallback_t)(CO_Data *d, const struct index_table *table, UNS8 bSubindex);

typedef struct {
    UNS8 bAccessType;
    UNS8 bDataType;
    UNS32 size;
    void *pObject;
#ifdef OD_CALLBACK_IN_ROW
    ODCallback_t callback;
#endif
} subindex;

typedef struct index_table {
    subindex *pSubindex;
    UNS8 bSubCount;
    UNS16 index;
} indextable;

typedef struct { UNS16 SDO_SVR, SDO_CLT, PDO_RCV, PDO_RCV_MAP, PDO_TRS, PDO_TRS_MAP; } quick_index;
typedef struct { UNS8 type; TIMER_HANDLE event; Message last; } s_PDO_status;
#define s_PDO_status_Initializer {0u, TIMER_NONE, {0u, 0u, 0u, {0u}}}

/* Refers to all that the initializer of the stack refers to, with its types. */
struct co_data {
    UNS8 *node_id;
    const indextable *objdict;
    s_PDO_status *tpdos;
    const quick_index *first, *last;
    const UNS16 *size;
    const UNS8 *slave;
    UNS32 (*range)(UNS8 type, void *value);
    UNS8 *consumers;
    UNS32 *consumer;
    TIMER_HANDLE *timers;
    UNS16 *producer, *guard;
    UNS8 *life;
    UNS32 *sync, *period;
#ifdef OD_CALLBACK_IN_ROW
    const indextable *(*scan)(CO_Data *d, UNS16 wIndex, UNS32 *errorCode);
#else
    const indextable *(*scan)(UNS16 wIndex, UNS32 *errorCode, ODCallback_t **callbacks);
#endif
    size_t history;
    UNS8 *errors;
    UNS32 *error;
    UNS8 *error_register;
    UNS32 *emergency;
};

#define CANOPEN_NODE_DATA_INITIALIZER(NODE) { \
    &NODE##_bDeviceNodeId, NODE##_objdict, NODE##_PDO_status, &NODE##_firstIndex, &NODE##_lastIndex, \
    &NODE##_ObjdictSize, &NODE##_iam_a_slave, NODE##_valueRangeTest, &NODE##_highestSubIndex_obj1016, NODE##_obj1016, \
    NODE##_heartBeatTimers, &NODE##_obj1017, &NODE##_obj100C, &NODE##_obj100D, &NODE##_obj1005, &NODE##_obj1006, \
    NODE##_scanIndexOD, sizeof(NODE##_obj1003) / sizeof(NODE##_obj1003[0]), &NODE##_highestSubIndex_obj1003, \
    &NODE##_obj1003[0], &NODE##_obj1001, &NODE##_obj1014}

#endif
