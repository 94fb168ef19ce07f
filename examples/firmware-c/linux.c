/*
 * The node on a CAN interface of Linux: `linux_node vcan0`. It boots up, answers SDOs, and sends heartbeats and its TPDO.
 */
#include <net/if.h>
#include <poll.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <linux/can.h>
#include <linux/can/raw.h>

#include "node.h"

#define OPERATIONAL 0x05u

static int open_bus(const char *name)
{
    struct sockaddr_can address;
    struct ifreq interface;
    const int bus = socket(PF_CAN, SOCK_RAW, CAN_RAW);

    memset(&interface, 0, sizeof interface);
    (void)snprintf(interface.ifr_name, sizeof interface.ifr_name, "%s", name);
    if (bus < 0 || ioctl(bus, SIOCGIFINDEX, &interface) < 0) {
        return -1;
    }
    memset(&address, 0, sizeof address);
    address.can_family = AF_CAN;
    address.can_ifindex = interface.ifr_ifindex;
    return bind(bus, (struct sockaddr *)&address, sizeof address) < 0 ? -1 : bus;
}

static void send_frame(int bus, uint32_t can_id, const uint8_t *bytes, uint8_t length)
{
    struct can_frame frame;

    memset(&frame, 0, sizeof frame);
    frame.can_id = can_id;
    frame.can_dlc = length;
    memcpy(frame.data, bytes, length);
    if (write(bus, &frame, sizeof frame) < 0) {
        perror("cannot send");
    }
}

int main(int argc, char **argv)
{
    const uint8_t boot_up = 0u;
    const uint8_t state = OPERATIONAL;
    struct pollfd bus;
    struct can_frame frame;
    node_t node;

    if (argc != 2) {
        (void)fprintf(stderr, "usage: %s INTERFACE, such as vcan0 or can0\n", argv[0]);
        return 2;
    }
    bus.fd = open_bus(argv[1]);
    bus.events = POLLIN;
    if (bus.fd < 0) {
        perror(argv[1]);
        return 1;
    }
    node_init(&node, OD_NODE_ID);
    send_frame(bus.fd, 0x700u + OD_NODE_ID, &boot_up, 1u);
    for (;;) {
        const int heartbeat = node.data.producer_heartbeat_time;
        uint8_t bytes[8];
        uint16_t can_id;

        /* a heartbeat of 0 is off; this small loop also sends it late after an SDO */
        if (poll(&bus, 1, heartbeat > 0 ? heartbeat : -1) == 0) {
            send_frame(bus.fd, 0x700u + OD_NODE_ID, &state, 1u);
            node_measure(&node, 231, 455);
            if (node_tpdo1(&node, &can_id, bytes)) {
                send_frame(bus.fd, can_id, bytes, OD_TPDO1_LENGTH);
            }
        } else if (read(bus.fd, &frame, sizeof frame) != sizeof frame) {
            return 1; /* the interface is gone */
        } else if (frame.can_id == 0x600u + OD_NODE_ID && frame.can_dlc == 8u && node_answer(&node, frame.data, bytes)) {
            send_frame(bus.fd, 0x580u + OD_NODE_ID, bytes, 8u);
        }
    }
}
