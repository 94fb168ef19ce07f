/*
 * A node of the stack: takes the node-ID of the argument, starts, and prints every entry as its functions read it, in the lines of
 * the harness.
 */
#include "data.h"

#include <stdlib.h>

extern CO_Data od_Data;
const indextable *od_scanIndexOD(UNS16 wIndex, UNS32 *errorCode, ODCallback_t **callbacks);
void od_applyNodeId(UNS8 nodeId) __attribute__((weak));

/* The port: no bus, no time. */
UNS8 canSend(CAN_PORT port, Message *message)
{
    (void)port;
    (void)message;
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

static void print(const indextable *table, UNS8 sub)
{
    static UNS8 value[0x20000];
    const subindex *const row = &table->pSubindex[sub];
    UNS32 size = sizeof value, at;
    UNS8 type;
    const UNS32 error = _getODentry(&od_Data, table->index, sub, value, &size, &type, 0, 0);
    const unsigned access = row->bAccessType & 3u;
    if (error != OD_SUCCESSFUL) {
        printf("%04X %02X error %08X\n", table->index, sub, error);
        return;
    }
    printf("%04X %02X ", table->index, sub);
    if (row->bDataType < 0x24u) {
        printf("%02X", row->bDataType);
    } else {
        putchar('-');
    }
    printf(" %u %c%c-- ", row->size, access == WO ? '-' : 'r', access == RO ? '-' : 'w');
    for (at = 0u; at < size; at++) {
        printf("%02X", value[at]);
    }
    puts(size > 0u ? "" : "-");
}

int main(int count, char **arguments)
{
    const UNS8 node_id = (UNS8)atoi(arguments[count - 1]);
    unsigned long index;
    setNodeId(&od_Data, node_id);
    if (od_applyNodeId != NULL) {
        od_applyNodeId(node_id);
    }
    setState(&od_Data, Initialisation);
    for (index = 0u; index <= 0xFFFFu; index++) {
        UNS32 error;
        ODCallback_t *callbacks;
        const indextable *const table = od_scanIndexOD((UNS16)index, &error, &callbacks);
        unsigned sub;
        for (sub = 0u; table != NULL && sub < table->bSubCount; sub++) {
            if ((table->pSubindex[sub].bAccessType & 3u) != (RO | WO)) {
                print(table, (UNS8)sub);
            }
        }
    }
    return 0;
}
