/*
 * A node of the stack: each PDO that its tables have as valid is used once, as its transmission type says, and those that are not
 * served are printed, the heartbeat consumers that it does not watch, and whether no SDO of its node-ID is answered.
 */
#include "data.h"

#include <stdlib.h>
#include <string.h>

extern CO_Data od_Data;
void od_applyNodeId(UNS8 nodeId) __attribute__((weak));

static scanIndexOD_t scan;
/* Entries that were looked up and written, frames that were sent and their last CAN-ID. */
static unsigned looked, written, sent;
static UNS16 sent_on;

UNS8 canSend(CAN_PORT port, Message *message)
{
    (void)port;
    sent++;
    sent_on = message->cob_id;
    return 0;
}
void setTimer(TIMEVAL value)
{
    (void)value;
}
TIMEVAL getElapsedTime(void)
{
    return 0;
}

static const indextable *look(UNS16 index, UNS32 *error, ODCallback_t **callbacks)
{
    looked++;
    return scan(index, error, callbacks);
}

/* The values are zeros, so limits may refuse them, which is no fault of the PDO. */
static UNS32 take(UNS8 type, void *value)
{
    (void)type;
    (void)value;
    written++;
    return 0;
}

static Message frame(UNS32 cob_id, UNS8 rtr)
{
    Message message = Message_Initializer;
    message.cob_id = (UNS16)(cob_id & 0x7FFu);
    message.rtr = rtr;
    message.len = 8;
    return message;
}

static void dispatch(UNS32 cob_id, UNS8 rtr)
{
    Message message = frame(cob_id, rtr);
    looked = written = 0u;
    canDispatch(&od_Data, &message);
}

/* The mapped objects within 8 bytes, but so many at least. */
static unsigned mapped(const subindex *mapping, unsigned least)
{
    const UNS8 stated = *(const UNS8 *)mapping[0].pObject;
    const unsigned number = stated < least ? least : stated;
    unsigned at, bits = 0u, count = 0u;
    for (at = 1u; at <= number; at++) {
        const unsigned size = *(const UNS32 *)mapping[at].pObject & 0xFFu;
        if (size > 0u && bits + size <= 64u) {
            bits += size;
            count++;
        }
    }
    return count;
}

static void receive(unsigned number, UNS32 cob_id, const subindex *mapping)
{
    UNS8 *const count = mapping[0].pObject;
    const UNS8 described = *count;
    const unsigned expected = mapped(mapping, 0u);
    int is_taken;
    *count = 0;
    dispatch(cob_id, NOT_A_REQUEST);
    is_taken = looked > 0u; /* by another one */
    *count = described;
    dispatch(cob_id, NOT_A_REQUEST);
    if (expected > 0u && (is_taken || looked == 0u)) {
        printf("RPDO %u without effect\n", number);
    } else if (written < expected) {
        printf("RPDO %u rejected\n", number);
    }
}

static void transmit(unsigned number, UNS32 cob_id, const subindex *mapping, s_PDO_status *status)
{
    unsigned at;
    if (mapped(mapping, 1u) == 0u) {
        return; /* there is nothing to send */
    }
    memset(status, 0, sizeof *status);
    status->event_timer = status->inhibit_timer = TIMER_NONE;
    sent = 0u;
    sendPDOevent(&od_Data);
    for (at = 0u; at < 240u && sent == 0u; at++) {
        (void)_sendPDOevent(&od_Data, 1);
    }
    if (sent == 0u && (cob_id & 0x40000000u) == 0u) {
        dispatch(cob_id, REQUEST);
    }
    if (sent == 0u) {
        printf("TPDO %u silent\n", number);
    } else if (sent_on == 0u) {
        printf("TPDO %u nmt\n", number);
    }
}

static void ask(UNS8 node_id)
{
    Message request = frame(0x600u + node_id, NOT_A_REQUEST);
    request.data[0] = 0x40; /* 1000h */
    request.data[2] = 0x10;
    sent = 0u;
    canDispatch(&od_Data, &request);
    if (sent != 1u || sent_on != 0x580u + node_id) {
        puts("server off");
    }
}

int main(int count, char **arguments)
{
    const UNS8 node_id = (UNS8)atoi(arguments[count - 1]);
    const quick_index *const first = od_Data.firstIndex, *const last = od_Data.lastIndex;
    static UNS32 cob_ids[1024];
    unsigned at;
    setNodeId(&od_Data, node_id);
    if (od_applyNodeId != NULL) {
        od_applyNodeId(node_id);
    }
    setState(&od_Data, Initialisation);
    for (at = 0u; at < 127u; at++) {
        UNS32 error;
        ODCallback_t *callbacks;
        const indextable *const consumers = od_Data.scanIndexOD(0x1016, &error, &callbacks);
        if (consumers != NULL && at + 1u < consumers->bSubCount
            && (consumers->pSubindex[at + 1u].bAccessType & 3u) != (RO | WO)) {
            const UNS32 value = *(const UNS32 *)consumers->pSubindex[at + 1u].pObject;
            if ((value & 0xFFFFu) != 0u && (value >> 16 & 0xFFu) != 0u && od_Data.ConsumerHeartBeatTimers[at] == TIMER_NONE) {
                printf("consumer %u rejected\n", at + 1u);
            }
        }
    }
    ask(node_id);
    setState(&od_Data, Operational);
    scan = od_Data.scanIndexOD;
    od_Data.scanIndexOD = &look;
    od_Data.valueRangeTest = &take;
    for (at = 0u; first->PDO_RCV != 0u && at <= (unsigned)(last->PDO_RCV - first->PDO_RCV); at++) {
        const indextable *const pdo = &od_Data.objdict[first->PDO_RCV + at];
        const UNS32 cob_id = *(const UNS32 *)pdo->pSubindex[1].pObject;
        if ((cob_id & 0x80000000u) == 0u) {
            receive(pdo->index - 0x1400u + 1u, cob_id, od_Data.objdict[first->PDO_RCV_MAP + at].pSubindex);
        }
    }
    for (at = 0u; first->PDO_TRS != 0u && at <= (unsigned)(last->PDO_TRS - first->PDO_TRS); at++) {
        UNS32 *const cob_id = od_Data.objdict[first->PDO_TRS + at].pSubindex[1].pObject;
        cob_ids[at] = *cob_id;
        *cob_id = 0x80000000u; /* one after the other */
    }
    for (at = 0u; first->PDO_TRS != 0u && at <= (unsigned)(last->PDO_TRS - first->PDO_TRS); at++) {
        const indextable *const pdo = &od_Data.objdict[first->PDO_TRS + at];
        UNS32 *const cob_id = pdo->pSubindex[1].pObject;
        if ((cob_ids[at] & 0x80000000u) == 0u) {
            *cob_id = cob_ids[at];
            transmit(pdo->index - 0x1800u + 1u, cob_ids[at], od_Data.objdict[first->PDO_TRS_MAP + at].pSubindex,
                     &od_Data.PDO_status[at]);
            *cob_id = 0x80000000u;
        }
    }
    return 0;
}
