/* A node of the real CANopenNode with generated tables and no CAN controller: it starts, and every entry is uploaded from
   its SDO server, frame by frame. `node N` prints index, sub-index and bytes of each, or the code of the abort. `node N frames`
   takes requests from the standard input, a line each, and `.` for a millisecond; its answers end with a `.`. */
#include "CANopen.h"
#include "OD.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static frame_t answer;
static uint16_t answers_at;
static bool_t prints_answers;

static void print_bytes(const uint8_t *bytes, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        printf("%02X", bytes[i]);
    }
}

void CO_CANsetConfigurationMode(void *can)
{
    (void)can;
}

void CO_CANsetNormalMode(CO_CANmodule_t *module)
{
    module->CANnormal = true;
}

CO_ReturnError_t CO_CANmodule_init(CO_CANmodule_t *module, void *can, CO_CANrx_t rx[], uint16_t rx_size, CO_CANtx_t tx[],
                                   uint16_t tx_size, uint16_t bit_rate)
{
    (void)bit_rate;
    memset(module, 0, sizeof *module);
    memset(rx, 0, sizeof *rx * rx_size);
    memset(tx, 0, sizeof *tx * tx_size);
    module->CANptr = can;
    module->rxArray = rx;
    module->rxSize = rx_size;
    module->txArray = tx;
    module->txSize = tx_size;
    return CO_ERROR_NO;
}

void CO_CANmodule_disable(CO_CANmodule_t *module)
{
    (void)module;
}

CO_ReturnError_t CO_CANrxBufferInit(CO_CANmodule_t *module, uint16_t index, uint16_t can_id, uint16_t mask, bool_t rtr,
                                    void *object, void (*receive)(void *object, void *message))
{
    (void)rtr;
    if (index >= module->rxSize) {
        return CO_ERROR_ILLEGAL_ARGUMENT;
    }
    module->rxArray[index].ident = can_id;
    module->rxArray[index].mask = mask;
    module->rxArray[index].object = object;
    module->rxArray[index].CANrx_callback = receive;
    return CO_ERROR_NO;
}

CO_CANtx_t *CO_CANtxBufferInit(CO_CANmodule_t *module, uint16_t index, uint16_t can_id, bool_t rtr, uint8_t length,
                               bool_t sync)
{
    (void)rtr;
    if (index >= module->txSize) {
        return NULL;
    }
    module->txArray[index].ident = can_id;
    module->txArray[index].DLC = length;
    module->txArray[index].syncFlag = sync;
    return &module->txArray[index];
}

CO_ReturnError_t CO_CANsend(CO_CANmodule_t *module, CO_CANtx_t *buffer)
{
    (void)module;
    if (buffer->ident == answers_at) {
        answer.length = buffer->DLC;
        memcpy(answer.bytes, buffer->data, sizeof answer.bytes);
        if (prints_answers) {
            print_bytes(buffer->data, buffer->DLC);
            printf("\n");
        }
    }
    return CO_ERROR_NO;
}

void CO_CANclearPendingSyncPDOs(CO_CANmodule_t *module)
{
    (void)module;
}

void CO_CANmodule_process(CO_CANmodule_t *module)
{
    (void)module;
}

/* Exits with the name of the failed step. */
static void demand(const char *step, CO_ReturnError_t error, uint32_t info)
{
    if (error != CO_ERROR_NO) {
        printf("%s: error %d, %04lX\n", step, (int)error, (unsigned long)info);
        exit(1);
    }
}

static CO_t *start(uint8_t node_id)
{
    uint32_t info = 0;
    uint8_t pending_id = node_id;
    uint16_t bit_rate = 125;
    CO_LSS_address_t address;
    CO_t *node = CO_new(NULL, &info);
    if (node == NULL) {
        printf("CO_new: no memory\n");
        exit(1);
    }
    OD_applyNodeId(node_id);
#ifdef WITH_HOOKS
    OD_initHooks(NULL);
#endif
    demand("CO_CANinit", CO_CANinit(node, NULL, bit_rate), 0);
    memset(&address, 0, sizeof address);
    demand("CO_LSSinit", CO_LSSinit(node, &address, &pending_id, &bit_rate), 0);
    demand("CO_CANopenInit",
           CO_CANopenInit(node, NULL, NULL, OD, NULL, 0, 500, 1000, 500, false, node_id, &info), info);
    info = 0;
    demand("CO_CANopenInitPDO", CO_CANopenInitPDO(node, node->em, OD, node_id, &info), 0);
    CO_CANsetNormalMode(node->CANmodule);
    for (int i = 0; i < 3; i++) {
        CO_process(node, false, 1000, NULL);
    }
    return node;
}

/* Whether the tables have a PDO as valid. */
static bool_t is_stated(uint16_t communication)
{
    uint32_t cob_id = 0;
    return OD_get_u32(OD_find(OD, communication), 1, &cob_id, true) == ODR_OK && (cob_id & 0x80000000u) == 0;
}

/* Prints what the tables have and the stack did not accept. */
static void print_rejected(const CO_t *node)
{
    (void)node;
#if OD_CNT_RPDO > 0
    for (uint16_t i = 0; i < OD_CNT_RPDO; i++) {
        if (is_stated((uint16_t)(0x1400u + i)) && !node->RPDO[i].PDO_common.valid) {
            printf("RPDO %u disabled\n", i + 1u);
        }
    }
#endif
#if OD_CNT_TPDO > 0
    for (uint16_t i = 0; i < OD_CNT_TPDO; i++) {
        if (is_stated((uint16_t)(0x1800u + i)) && !node->TPDO[i].PDO_common.valid) {
            printf("TPDO %u disabled\n", i + 1u);
        }
    }
#endif
#if OD_CNT_HB_CONS > 0
    for (uint8_t i = 0; i < node->HBcons->numberOfMonitoredNodes; i++) {
        uint32_t value = 0;
        (void)OD_get_u32(OD_find(OD, 0x1016), i + 1u, &value, true);
        if ((value & 0xFFFFu) != 0 && ((value >> 16) & 0xFFu) != 0 && node->HBcons->monitoredNodes[i].time_us == 0) {
            printf("consumer %u rejected\n", i + 1u);
        }
    }
#endif
}

/* Sends a request to the SDO server. */
static void deliver(CO_t *node, uint16_t can_id, const uint8_t *request)
{
    frame_t frame = {can_id, 8, {0}};
    memcpy(frame.bytes, request, 8);
    for (uint16_t i = 0; i < node->CANmodule->rxSize; i++) {
        const CO_CANrx_t *rx = &node->CANmodule->rxArray[i];
        if (rx->ident == can_id && rx->CANrx_callback != NULL) {
            rx->CANrx_callback(rx->object, &frame);
        }
    }
}

/* Sends a request to the SDO server and waits for the answer. */
static void ask(CO_t *node, uint16_t can_id, const uint8_t *request)
{
    memset(&answer, 0, sizeof answer);
    deliver(node, can_id, request);
    for (int i = 0; i < 20 && answer.length == 0; i++) {
        CO_process(node, false, 1000, NULL);
    }
}

/* Uploads an entry as defined in CiA 301. */
static void upload(CO_t *node, uint8_t node_id, uint16_t index, uint8_t sub)
{
    const uint16_t can_id = (uint16_t)(0x600u + node_id);
    uint8_t request[8] = {0x40, (uint8_t)(index & 0xFFu), (uint8_t)(index >> 8), sub, 0, 0, 0, 0};
    uint8_t toggle = 0;
    printf("%04X %02X ", index, sub);
    ask(node, can_id, request);
    if (answer.length == 8 && (answer.bytes[0] & 0xE3u) == 0x43u) {
        print_bytes(&answer.bytes[4], 4u - ((answer.bytes[0] >> 2) & 3u));
    } else if (answer.length == 8 && (answer.bytes[0] & 0xE2u) == 0x40u) {
        bool_t last = false;
        while (!last) {
            memset(request, 0, sizeof request);
            request[0] = (uint8_t)(0x60u | toggle);
            ask(node, can_id, request);
            if (answer.length != 8 || (answer.bytes[0] & 0xF0u) != toggle) {
                break;
            }
            print_bytes(&answer.bytes[1], 7u - ((answer.bytes[0] >> 1) & 7u));
            last = (answer.bytes[0] & 1u) != 0;
            toggle ^= 0x10u;
        }
    }
    if (answer.length == 0) {
        printf("silent");
    } else if (answer.bytes[0] == 0x80u) {
        printf("abort %02X%02X%02X%02X", answer.bytes[7], answer.bytes[6], answer.bytes[5], answer.bytes[4]);
    }
    printf("\n");
}

/* Answers the requests of a client. */
static void converse(CO_t *node, uint8_t node_id)
{
    char line[32];
    prints_answers = true;
    while (fgets(line, (int)sizeof line, stdin) != NULL) {
        uint8_t request[8];
        if (line[0] != '.') {
            for (int i = 0; i < 8; i++) {
                const char digits[3] = {line[2 * i], line[2 * i + 1], '\0'};
                request[i] = (uint8_t)strtoul(digits, NULL, 16);
            }
            deliver(node, (uint16_t)(0x600u + node_id), request);
        }
        CO_process(node, false, line[0] == '.' ? 1000 : 0, NULL);
        printf(".\n");
        (void)fflush(stdout);
    }
}

int main(int argc, char **argv)
{
    const uint8_t node_id = (uint8_t)(argc >= 2 ? atoi(argv[1]) : 0);
    CO_t *node = start(node_id);
    answers_at = (uint16_t)(0x580u + node_id);
    if (argc == 3) {
        converse(node, node_id);
        return 0;
    }
    print_rejected(node);
    for (uint16_t i = 0; i < OD->size; i++) {
        for (unsigned sub = 0; sub <= 0xFF; sub++) {
            OD_IO_t io;
            if (OD_getSub(&OD->list[i], (uint8_t)sub, &io, true) == ODR_OK) {
                upload(node, node_id, OD->list[i].index, (uint8_t)sub);
            }
        }
    }
    return 0;
}
