/*
 * A node of the stack with a dictionary. Sends the requests of the arguments, 16 hexadecimal digits each, to its SDO server and
 * prints the responses. DICTIONARY names the header of the dictionary.
 */
#include DICTIONARY

#include <stdio.h>
#include <string.h>

extern struct CO_NODE_SPEC_T AppSpec;

static CO_NODE node;
static CO_IF_FRM request;

static void nothing(void)
{
}

static void take(uint32_t number)
{
    (void)number;
}

static uint32_t zero(void)
{
    return 0u;
}

static uint8_t elapsed(void)
{
    return 0u;
}

static uint32_t store(uint32_t start, uint8_t *buffer, uint32_t size)
{
    (void)start;
    (void)buffer;
    return size;
}

static int16_t can_read(CO_IF_FRM *frame)
{
    *frame = request;
    return sizeof *frame;
}

static int16_t can_send(CO_IF_FRM *frame)
{
    if (frame->Identifier == 0x580u + AppSpec.NodeId) {
        uint8_t at;
        for (at = 0u; at < 8u; at++) {
            printf("%02X", frame->Data[at]);
        }
        putchar('\n');
    }
    return sizeof *frame;
}

static const CO_IF_CAN_DRV can = {nothing, take, can_read, can_send, nothing, nothing};
static const CO_IF_TIMER_DRV timer = {take, take, zero, nothing, nothing, elapsed};
static const CO_IF_NVM_DRV memory = {nothing, store, store};
struct CO_IF_DRV_T AppDriver = {&can, &timer, &memory};

int main(int count, char **arguments)
{
    int at;
    CONodeInit(&node, &AppSpec);
    if (CONodeGetErr(&node) != CO_ERR_NONE) {
        return 1;
    }
    CONodeStart(&node);
    for (at = 1; at < count; at++) {
        unsigned byte;
        request.Identifier = 0x600u + AppSpec.NodeId;
        request.DLC = 8u;
        for (byte = 0u; byte < 8u; byte++) {
            unsigned value;
            sscanf(arguments[at] + 2u * byte, "%2x", &value);
            request.Data[byte] = (uint8_t)value;
        }
        CONodeProcess(&node);
    }
    return 0;
}
