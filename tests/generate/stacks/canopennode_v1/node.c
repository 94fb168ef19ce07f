/*
 * Starts the stack with the tables on the node of the argument, and prints every entry that its SDO server reads, in the lines of
 * the harness. Without a bus: with the driver template of the stack.
 */
#include "CANopen.h"

#include <stdio.h>
#include <stdlib.h>

extern const CO_OD_entry_t CO_OD[CO_OD_NoOfElements];
void CO_OD_applyNodeId(uint8_t nodeId) __attribute__((weak));
void CO_OD_initHooks(void *SDO, void *object) __attribute__((weak));

static void print(CO_SDO_t *server, uint16_t index, uint8_t sub)
{
    uint16_t at, length, mapping;
    if (CO_SDO_initTransfer(server, index, sub) != 0u || server->ODF_arg.ODdataStorage == NULL
        || CO_SDO_readOD(server, CO_SDO_BUFFER_SIZE) != 0u) {
        return;
    }
    length = server->ODF_arg.dataLength;
    /* TPDOs map the number of elements if they map the elements */
    mapping = sub > 0u || CO_OD[server->entryNo].maxSubIndex == 0u ? server->ODF_arg.attribute : 0u;
    printf("%04X %02X - %u %c%c%c%c ", index, sub, length, 'r', (server->ODF_arg.attribute & CO_ODA_WRITEABLE) ? 'w' : '-',
           (mapping & CO_ODA_TPDO_MAPABLE) ? 't' : '-', (mapping & CO_ODA_RPDO_MAPABLE) ? 'p' : '-');
    for (at = 0u; at < length; at++) {
        printf("%02X", server->databuffer[at]);
    }
    puts(length > 0u ? "" : "-");
}

/* Prints the PDOs that the tables have as valid and the stack did not accept. */
static void print_rejected(void)
{
    unsigned at;
    for (at = 0u; at < CO_NO_RPDO; at++) {
        if ((CO->RPDO[at]->RPDOCommPar->COB_IDUsedByRPDO & 0x80000000u) == 0u && !CO->RPDO[at]->valid) {
            printf("RPDO %u disabled\n", at + 1u);
        }
    }
    for (at = 0u; at < CO_NO_TPDO; at++) {
        if ((CO->TPDO[at]->TPDOCommPar->COB_IDUsedByTPDO & 0x80000000u) == 0u && !CO->TPDO[at]->valid) {
            printf("TPDO %u disabled\n", at + 1u);
        }
    }
}

int main(int count, char **arguments)
{
    const uint8_t node_id = (uint8_t)atoi(arguments[count - 1]);
    unsigned at;
    if (CO_OD_applyNodeId != NULL) {
        CO_OD_applyNodeId(node_id);
    }
    if (CO_new() != CO_ERROR_NO || CO_CANinit(NULL, 125u) != CO_ERROR_NO) {
        return 2;
    }
#if CO_NO_LSS_SERVER == 1
    (void)CO_LSSinit(node_id, 125u); /* fails without a serial number, which a product sets */
#endif
    if (CO_CANopenInit(node_id) != CO_ERROR_NO) {
        return 4;
    }
    if (CO_OD_initHooks != NULL) {
        static uint8_t mark = 0x5A;
        CO_OD_initHooks(CO->SDO[0], &mark);
    }
    print_rejected();
    for (at = 0u; at < CO_OD_NoOfElements; at++) {
        unsigned sub;
        for (sub = 0u; sub <= CO_OD[at].maxSubIndex; sub++) {
            print(CO->SDO[0], CO_OD[at].index, (uint8_t)sub);
        }
    }
    return 0;
}
