/* A session with the node: what a client asks, and what goes over the bus. ../session.txt is what it prints. */
#include <stdio.h>

#include "node.h"

static void print(const char *what, const uint8_t *bytes, size_t length)
{
    size_t at;

    printf("%-25s", what);
    for (at = 0; at < length; at++) {
        printf(" %02X", (unsigned)bytes[at]);
    }
    printf("\n");
}

static void send(const node_t *node)
{
    uint8_t frame[OD_TPDO1_LENGTH];
    uint16_t can_id;
    char what[32];

    if (node_tpdo1(node, &can_id, frame)) {
        snprintf(what, sizeof what, "TPDO 1, CAN-ID %03X", (unsigned)can_id);
        print(what, frame, sizeof frame);
    }
}

int main(void)
{
    static const struct {
        const char *what;
        uint8_t bytes[8];
    } requests[] = {
        {"vendor-ID", {0x40, 0x18, 0x10, 0x01, 0, 0, 0, 0}},
        {"heartbeat", {0x40, 0x17, 0x10, 0x00, 0, 0, 0, 0}},
        {"heartbeat is 500", {0x2B, 0x17, 0x10, 0x00, 0xF4, 0x01, 0, 0}},
        {"heartbeat", {0x40, 0x17, 0x10, 0x00, 0, 0, 0, 0}},
        {"temperature", {0x40, 0x00, 0x20, 0x01, 0, 0, 0, 0}},
        {"temperature is read only", {0x2B, 0x00, 0x20, 0x01, 0, 0, 0, 0}},
        {"limit above its limit", {0x2B, 0x10, 0x20, 0x02, 0x53, 0x03, 0, 0}},
        {"one byte of two", {0x2F, 0x10, 0x20, 0x02, 0x14, 0, 0, 0}},
        {"no such object", {0x40, 0x00, 0x30, 0x00, 0, 0, 0, 0}},
        {"no such sub-index", {0x40, 0x00, 0x20, 0x07, 0, 0, 0, 0}},
        {"limit is 20.0", {0x2B, 0x10, 0x20, 0x02, 0xC8, 0x00, 0, 0}},
    };
    static node_t node;
    uint8_t answer[8];
    size_t at;

    node_init(&node, OD_NODE_ID);
    node_measure(&node, 231, 455);
    for (at = 0; at < sizeof requests / sizeof requests[0]; at++) {
        print(requests[at].what, requests[at].bytes, 8);
        print("", answer, node_answer(&node, requests[at].bytes, answer) ? 8u : 0u);
    }
    send(&node);
    node_measure(&node, 231, 455);
    send(&node);
    node_measure(&node, -250, 990);
    send(&node);
    return 0;
}
