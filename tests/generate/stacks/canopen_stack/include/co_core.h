/*
 * The part of the canopen-stack 4.4 interface that a dictionary and a node specification need; the harness next to it
 * reads and writes entries like the stack.
 */
#ifndef CO_CORE_H
#define CO_CORE_H

#include <stddef.h>
#include <stdint.h>

#ifndef CO_SSDO_N
#define CO_SSDO_N 128
#endif
#ifndef CO_CSDO_N
#define CO_CSDO_N 128
#endif
#ifndef CO_RPDO_N
#define CO_RPDO_N 512
#endif
#ifndef CO_TPDO_N
#define CO_TPDO_N 512
#endif
#define CO_EMCY_N 32
#define USE_CSDO 1
#define CO_SDO_BUF_BYTE 889

struct CO_OBJ_T;
struct CO_NODE_T;

typedef enum { CO_ERR_NONE, CO_ERR_BAD_ARG, CO_ERR_OBJ_SIZE, CO_ERR_OBJ_RANGE, CO_ERR_TYPE_RD, CO_ERR_TYPE_WR } CO_ERR;
typedef enum { CO_INVALID, CO_INIT, CO_PREOP, CO_OPERATIONAL, CO_STOP } CO_MODE;
typedef enum { CO_RESET_INVALID, CO_RESET_NODE, CO_RESET_COM } CO_NMT_RESET;

typedef struct {
    uint32_t (*Size)(struct CO_OBJ_T *obj, struct CO_NODE_T *node, uint32_t width);
    CO_ERR (*Init)(struct CO_OBJ_T *obj, struct CO_NODE_T *node);
    CO_ERR (*Read)(struct CO_OBJ_T *obj, struct CO_NODE_T *node, void *buffer, uint32_t size);
    CO_ERR (*Write)(struct CO_OBJ_T *obj, struct CO_NODE_T *node, void *buffer, uint32_t size);
    CO_ERR (*Reset)(struct CO_OBJ_T *obj, struct CO_NODE_T *node, uint32_t para);
} CO_OBJ_TYPE;

typedef uintptr_t CO_DATA;

typedef struct CO_OBJ_T {
    uint32_t Key;
    const CO_OBJ_TYPE *Type;
    CO_DATA Data;
} CO_OBJ;

#define CO_KEY(index, sub, flags) (((uint32_t)(index) << 16) | ((uint32_t)(sub) << 8) | (uint32_t)(flags))
#define CO_DEV(index, sub) CO_KEY(index, sub, 0u)
#define CO_OBJ_DICT_ENDMARK {0u, NULL, 0u}

#define CO_OBJ______W 0x01u
#define CO_OBJ_____R_ 0x02u
#define CO_OBJ____P__ 0x04u
#define CO_OBJ___A___ 0x08u
#define CO_OBJ__N____ 0x40u
#define CO_OBJ_D_____ 0x80u
#define CO_OBJ_____RW 0x03u
#define CO_OBJ____PR_ 0x06u
#define CO_OBJ____P_W 0x05u
#define CO_OBJ____PRW 0x07u
#define CO_OBJ___APR_ 0x0Eu
#define CO_OBJ___AP_W 0x0Du
#define CO_OBJ___APRW 0x0Fu
#define CO_OBJ__N__R_ 0x42u
#define CO_OBJ__N___W 0x41u
#define CO_OBJ__N__RW 0x43u
#define CO_OBJ__N_PR_ 0x46u
#define CO_OBJ__N_P_W 0x45u
#define CO_OBJ__N_PRW 0x47u
#define CO_OBJ_D___R_ 0x82u
#define CO_OBJ_D____W 0x81u
#define CO_OBJ_D___RW 0x83u
#define CO_OBJ_DN__R_ 0xC2u
#define CO_OBJ_DN___W 0xC1u
#define CO_OBJ_DN__RW 0xC3u

extern const CO_OBJ_TYPE Integer8, Integer16, Integer32, String, Domain, History, Consumer, Store, Restore;
#define CO_TUNSIGNED8 (&Integer8)
#define CO_TUNSIGNED16 (&Integer16)
#define CO_TUNSIGNED32 (&Integer32)
#define CO_TSIGNED8 (&Integer8)
#define CO_TSIGNED16 (&Integer16)
#define CO_TSIGNED32 (&Integer32)
#define CO_TSTRING (&String)
#define CO_TDOMAIN (&Domain)
#define CO_TEMCY_HIST (&History)
#define CO_TEMCY_ID (&Integer32)
#define CO_THB_CONS (&Consumer)
#define CO_THB_PROD (&Integer16)
#define CO_TPARA_STORE (&Store)
#define CO_TPARA_RESTORE (&Restore)
#define CO_TPDO_ID (&Integer32)
#define CO_TPDO_TYPE (&Integer8)
#define CO_TPDO_EVENT (&Integer16)
#define CO_TPDO_NUM (&Integer8)
#define CO_TPDO_MAP (&Integer32)
#define CO_TSDO_ID (&Integer32)
#define CO_TSYNC_ID (&Integer32)
#define CO_TSYNC_CYCLE (&Integer32)

typedef struct {
    uint32_t Offset;
    uint8_t *Start;
} CO_OBJ_STR;

typedef struct {
    uint32_t Offset;
    uint32_t Size;
    uint8_t *Start;
} CO_OBJ_DOM;

typedef struct CO_HBCONS_T {
    struct CO_NODE_T *Node;
    struct CO_HBCONS_T *Next;
    CO_MODE State;
    int16_t Tmr;
    uint16_t Time;
    uint8_t NodeId;
    uint8_t Event;
} CO_HBCONS;

typedef struct {
    uint32_t Offset;
    uint32_t Size;
    uint8_t *Start;
    uint8_t *Default;
    CO_NMT_RESET Type;
    void *Ident;
    uint32_t Value;
} CO_PARA;

#define CO_EMCY_REG_GENERAL 0
#define CO_EMCY_CODE_GEN_ERR 0x1000

typedef struct {
    uint8_t Reg;
    uint16_t Code;
} CO_EMCY_TBL;

typedef struct {
    uint32_t Unused;
} CO_TMR_MEM;

struct CO_IF_DRV_T {
    uint32_t Unused;
};

struct CO_NODE_SPEC_T {
    uint8_t NodeId;
    uint32_t Baudrate;
    CO_OBJ *Dict;
    uint16_t DictLen;
    CO_EMCY_TBL *EmcyCode;
    CO_TMR_MEM *TmrMem;
    uint16_t TmrNum;
    uint32_t TmrFreq;
    struct CO_IF_DRV_T *Drv;
    uint8_t *SdoBuf;
};

typedef struct CO_NODE_T {
    uint8_t NodeId;
} CO_NODE;

#endif
