/*
 * Prints every entry as the stack finds and reads it on the node of the argument. The structures have the sizes of the stack's.
 */
#include "CO_driver.h"
#include "CO_OD.h"
#include "CO_SDO.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The structures of the stack with their sizes; all that it refers to by name is there. */
struct rpdo { uint8_t count; uint32_t id; uint8_t type; };
struct tpdo { uint8_t count; uint32_t id; uint8_t type; uint16_t inhibit; uint8_t compatibility; uint16_t event; uint8_t start; };
struct mapping { uint8_t count; uint32_t mapped[8]; };
struct client { uint8_t count; uint32_t to_server, to_client; uint8_t node; };
typedef char sizes[(sizeof(OD_RPDOCommunicationParameter_t) == sizeof(struct rpdo)
                    && sizeof(OD_TPDOCommunicationParameter_t) == sizeof(struct tpdo)
                    && sizeof(OD_RPDOMappingParameter_t) == sizeof(struct mapping)
                    && sizeof(OD_TPDOMappingParameter_t) == sizeof(struct mapping)
                    && sizeof(OD_SDOClientParameter_t) == sizeof(struct client)) ? 1 : -1];
#if CO_NO_RPDO < 1 || CO_NO_TPDO < 1 || CO_NO_SDO_SERVER < 1 || ODL_errorStatusBits_stringLength < 10 \
    || ODL_consumerHeartbeatTime_arrayLength < 1 || ODL_preDefinedErrorField_arrayLength < 1
#error "the stack does not compile"
#endif
static const void *used[] = {
    &OD_errorRegister, OD_preDefinedErrorField, &OD_COB_ID_SYNCMessage, &OD_communicationCyclePeriod, &OD_synchronousWindowLength,
    &OD_COB_ID_TIME, &OD_inhibitTimeEMCY, OD_consumerHeartbeatTime, &OD_producerHeartbeatTime, &OD_synchronousCounterOverflowValue,
    OD_errorBehavior, &OD_NMTStartup, OD_errorStatusBits, OD_SDOServerParameter, OD_RPDOCommunicationParameter,
    OD_RPDOMappingParameter, OD_TPDOCommunicationParameter, OD_TPDOMappingParameter,
};

static const CO_OD_entry_t *find(unsigned index)
{
    int low = 0, high = CO_OD_NoOfElements - 1;
    while (low <= high) {
        const int middle = (low + high) / 2;
        if (CO_OD[middle].index == index) {
            return &CO_OD[middle];
        }
        if (CO_OD[middle].index > index) {
            high = middle - 1;
        } else {
            low = middle + 1;
        }
    }
    return NULL;
}

/* The stack adds the node-ID to COB-IDs of the pre-defined connection set. */
static uint32_t added(unsigned index, unsigned sub, uint32_t value, uint32_t node_id)
{
    const uint32_t id = value & 0x7FFu;
    if (index == 0x1200u && (sub == 1u || sub == 2u)) {
        return value + node_id;
    }
    if ((index == 0x1014u && sub == 0u)
        || (index >= 0x1400u && index <= 0x1403u && sub == 1u && id == 0x200u + 0x100u * (index & 3u))
        || (index >= 0x1800u && index <= 0x1803u && sub == 1u && id == 0x180u + 0x100u * (index & 3u))) {
        return value + node_id;
    }
    return value;
}

static void print(const CO_OD_entry_t *object, unsigned sub, uint32_t node_id)
{
    static uint8_t value[0x10000];
    CO_OD_entryRecord_t row = {object->pData, object->attribute, object->length};
    unsigned at;
    if (object->maxSubIndex > 0u && object->attribute == 0u) {
        row = ((const CO_OD_entryRecord_t *)object->pData)[sub];
    } else if (object->maxSubIndex > 0u && sub == 0u) {
        /* the number of elements */
        memcpy(value, &object->maxSubIndex, 1u);
        row.pData = value;
        row.length = 1u;
        row.attribute = CO_ODA_READABLE;
    } else if (sub > 0u) {
        row.pData = (uint8_t *)object->pData + (size_t)(sub - 1u) * object->length;
    }
    if (object->maxSubIndex > 0u && sub == 0u) {
        /* TPDOs map the number of elements if they map the elements */
        row.attribute &= (uint16_t)~(CO_ODA_TPDO_MAPABLE | CO_ODA_RPDO_MAPABLE);
    }
    if ((row.attribute & (CO_ODA_READABLE | CO_ODA_WRITEABLE)) == 0u) {
        return; /* no entry */
    }
    if (row.length > 0u && row.pData != value) {
        memcpy(value, row.pData, row.length);
    }
    if (row.length == 4u) {
        uint32_t number;
        memcpy(&number, value, sizeof number);
        number = added(object->index, sub, number, node_id);
        memcpy(value, &number, sizeof number);
    }
    printf("%04X %02X - %u %c%c%c%c ", object->index, sub, row.length, (row.attribute & CO_ODA_READABLE) != 0u ? 'r' : '-',
           (row.attribute & CO_ODA_WRITEABLE) != 0u ? 'w' : '-', (row.attribute & CO_ODA_TPDO_MAPABLE) != 0u ? 't' : '-',
           (row.attribute & CO_ODA_RPDO_MAPABLE) != 0u ? 'p' : '-');
    for (at = 0u; at < row.length; at++) {
        printf("%02X", value[at]);
    }
    puts(row.length > 0u ? "" : "-");
}

void CO_OD_applyNodeId(uint8_t nodeId) __attribute__((weak));

int main(int count, char **arguments)
{
    const uint32_t node_id = (uint32_t)atoi(arguments[count - 1]);
    int at;
    size_t number;
    for (number = 0u; number < sizeof used / sizeof used[0]; number++) {
        if (used[number] == NULL) {
            return 1;
        }
    }
    if (CO_OD_applyNodeId != NULL) {
        CO_OD_applyNodeId((uint8_t)node_id);
    }
    if (CO_OD_RAM.FirstWord != CO_OD_FIRST_LAST_WORD || CO_OD_ROM.LastWord != CO_OD_FIRST_LAST_WORD || sizeof(sizes) != 1u) {
        return 1;
    }
    for (at = 0; at < CO_OD_NoOfElements; at++) {
        unsigned sub;
        if (find(CO_OD[at].index) != &CO_OD[at]) {
            return 1;
        }
        for (sub = 0u; sub <= CO_OD[at].maxSubIndex; sub++) {
            print(&CO_OD[at], sub, node_id);
        }
    }
    return 0;
}
