/* The node as a client sees it; the exit code is the number of what is wrong. */
#include <stdio.h>
#include <string.h>

#include "node.h"
#include "spare.h"

static int failures;

static void expect(bool holds, const char *what)
{
    if (!holds) {
        fprintf(stderr, "not so: %s\n", what);
        failures++;
    }
}

/* Whether the node answers a request with these bytes. */
static bool answers(node_t *node, const uint8_t request[8], const uint8_t expected[8])
{
    uint8_t answer[8];

    return node_answer(node, request, answer) && memcmp(answer, expected, sizeof answer) == 0;
}

#define BYTES(...) ((const uint8_t[8]){__VA_ARGS__})

int main(void)
{
    static const uint8_t alarmed[OD_TPDO1_LENGTH] = {0x06, 0xFF, 0xDE, 0x03, 0x03};
    static node_t node;
    static spare_data_t spare;
    uint8_t frame[OD_TPDO1_LENGTH];
    uint8_t answer[8];
    uint16_t can_id = 0;

    node_init(&node, OD_NODE_ID);
    expect(answers(&node, BYTES(0x22, 0x17, 0x10, 0, 0x64), BYTES(0x60, 0x17, 0x10, 0)), "two bytes are taken");
    expect(node.data.producer_heartbeat_time == 100u, "the heartbeat time is 100 ms");
    expect(answers(&node, BYTES(0x40, 0x11, 0x20), BYTES(0x80, 0x11, 0x20, 0, 0x01, 0x00, 0x01, 0x06)), "write only");
    expect(answers(&node, BYTES(0x40, 0x08, 0x10), BYTES(0x80, 0x08, 0x10, 0, 0x05, 0x00, 0x04, 0x05)), "seven bytes");
    expect(answers(&node, BYTES(0x60), BYTES(0x80, 0, 0, 0, 0x01, 0x00, 0x04, 0x05)), "segments are not served");
    expect(!node_answer(&node, BYTES(0x80), answer), "an abort has no answer");

    node_measure(&node, -250, 990);
    expect(node_tpdo1(&node, &can_id, frame) && can_id == 0x185u, "the TPDO exists");
    expect(memcmp(frame, alarmed, sizeof frame) == 0, "its bits are those of the mapping");
    expect(answers(&node, BYTES(0x23, 0x00, 0x18, 1, 0x85, 0x01, 0x00, 0xC0), BYTES(0x60, 0x00, 0x18, 1)), "bit 31");
    expect(!node_tpdo1(&node, &can_id, frame), "the TPDO is switched off");

    spare_init(&spare, 9);
    expect(spare_find(0x2010, 1) != NULL, "both dictionaries are linked");
    return failures;
}
