/* A node of the real canopen-stack with generated tables and no CAN controller: it starts, and prints each PDO that the tables
   have as valid and that it does not serve, each heartbeat consumer that it does not monitor, and a default SDO server on other
   COB-IDs. DICTIONARY names the header of the dictionary. */
#include DICTIONARY

#include <stdio.h>

static CO_NODE node;
extern struct CO_NODE_SPEC_T AppSpec;

static void can_init(void) {}
static void can_enable(uint32_t baud_rate) { (void)baud_rate; }
static void can_reset(void) {}
static void can_close(void) {}
static int16_t can_read(CO_IF_FRM *frame) { (void)frame; return 0; }
static int16_t can_send(CO_IF_FRM *frame) { (void)frame; return (int16_t)sizeof(CO_IF_FRM); }
static void timer_init(uint32_t frequency) { (void)frequency; }
static void timer_start(void) {}
static uint8_t timer_update(void) { return 0u; }
static uint32_t timer_delay(void) { return 1u; }
static void timer_reload(uint32_t ticks) { (void)ticks; }
static void timer_stop(void) {}
static void nvm_init(void) {}
static uint32_t nvm_read(uint32_t start, uint8_t *buffer, uint32_t size) { (void)start; (void)buffer; return size; }
static uint32_t nvm_write(uint32_t start, uint8_t *buffer, uint32_t size) { (void)start; (void)buffer; return size; }

static const CO_IF_CAN_DRV can = {can_init, can_enable, can_read, can_send, can_reset, can_close};
static const CO_IF_TIMER_DRV timer = {timer_init, timer_reload, timer_delay, timer_stop, timer_start, timer_update};
static const CO_IF_NVM_DRV memory = {nvm_init, nvm_read, nvm_write};
struct CO_IF_DRV_T AppDriver = {&can, &timer, &memory};

/* Whether the tables have a PDO as valid; without a COB-ID it counts as valid. */
static int is_valid(uint16_t communication)
{
    uint32_t cob_id = 0u;
    if (CODictFind(&node.Dict, CO_DEV(communication, 0)) == NULL && CODictFind(&node.Dict, CO_DEV(communication, 1)) == NULL
        && CODictFind(&node.Dict, CO_DEV(communication, 2)) == NULL) {
        return 0;
    }
    return CODictRdLong(&node.Dict, CO_DEV(communication, 1), &cob_id) != CO_ERR_NONE || (cob_id & 0x80000000u) == 0u;
}

/* Whether a mapping is missing or has objects. */
static int maps(uint16_t mapping)
{
    uint8_t count = 0u;
    return CODictRdByte(&node.Dict, CO_DEV(mapping, 0), &count) != CO_ERR_NONE || count > 0u;
}

static void print(const char *kind, uint16_t number, int is_on, uint32_t can_id, uint16_t objects, int has_mapping)
{
    const char *state = !is_on ? "disabled" : can_id == 0u ? "nmt" : objects == 0u && has_mapping ? "without effect" : NULL;
    if (state != NULL) {
        printf("%s %u %s\n", kind, number + 1u, state);
    }
}

static int is_monitored(const CO_HBCONS *wanted)
{
    const CO_HBCONS *consumer;
    for (consumer = node.Nmt.HbCons; consumer != NULL; consumer = consumer->Next) {
        if (consumer == wanted) {
            return 1;
        }
    }
    return 0;
}

int main(void)
{
    uint16_t at;
    CONodeInit(&node, &AppSpec);
    CONodeStart(&node);
    CONmtSetMode(&node.Nmt, CO_OPERATIONAL);
    for (at = 0u; at < CO_RPDO_N; at++) {
        if (is_valid((uint16_t)(0x1400u + at))) {
            const CO_RPDO *pdo = &node.RPdo[at];
            print("RPDO", at, (pdo->Flag & CO_RPDO_FLG__E) != 0u, pdo->Identifier, pdo->ObjNum, maps((uint16_t)(0x1600u + at)));
        }
    }
    for (at = 0u; at < CO_TPDO_N; at++) {
        if (is_valid((uint16_t)(0x1800u + at))) {
            const CO_TPDO *pdo = &node.TPdo[at];
            print("TPDO", at, pdo->Identifier != CO_TPDO_COBID_OFF, pdo->Identifier & 0x7FFu, pdo->ObjNum,
                  maps((uint16_t)(0x1A00u + at)));
        }
    }
    for (at = 1u; at < 0x80u; at++) {
        const CO_OBJ *object = CODictFind(&node.Dict, CO_DEV(0x1016u, at));
        if (object != NULL && object->Type == CO_THB_CONS) {
            const CO_HBCONS *consumer = (const CO_HBCONS *)object->Data;
            if (consumer->Time != 0u && consumer->NodeId != 0u && !is_monitored(consumer)) {
                printf("consumer %u rejected\n", at);
            }
        }
    }
    if (node.Sdo[0].RxId != 0x600u + node.NodeId || node.Sdo[0].TxId != 0x580u + node.NodeId) {
        printf("server off\n");
    }
    return 0;
}
