/*
 * Boots a network in simulated time with the library: its NMT master with the DCF and the concise DCF of the second and third argument, a
 * slave for each further pair of node-ID and description. Prints the frames and, at the end, what the master says of the slaves and the
 * states that they have. The first argument is the time in milliseconds; the third one is "-" for a master without a concise DCF.
 */
#include <lely/can/net.h>
#include <lely/co/dcf.h>
#include <lely/co/dev.h>
#include <lely/co/nmt.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define NODES 128
#define FRAMES 4096

struct node {
    can_net_t *net;
    co_dev_t *dev;
    co_nmt_t *nmt;
};

/* The master, then the slaves. */
static struct node nodes[NODES];
static int count;

/* The frames that are on their way, each with its sender. */
static struct { int sender; struct can_msg msg; } frames[FRAMES];
static size_t first, end;

/* What the master says: 0 nothing yet, '-' success, else the letter of CiA 302-2. */
static char status[NODES];

static int take(const struct can_msg *msg, void *data)
{
    frames[end % FRAMES].sender = (int)((struct node *)data - nodes);
    frames[end % FRAMES].msg = *msg;
    end++;
    return end - first > FRAMES ? -1 : 0;
}

static void booted(co_nmt_t *nmt, co_unsigned8_t id, co_unsigned8_t st, char es, void *data)
{
    (void)nmt;
    (void)st;
    (void)data;
    status[id % NODES] = es ? es : '-';
}

/* Gives all frames to all other nodes, and those that they send in turn. */
static void deliver(void)
{
    while (first < end) {
        const int sender = frames[first % FRAMES].sender;
        const struct can_msg msg = frames[first % FRAMES].msg;
        int i;
        first++;
        printf("%03X ", (unsigned)msg.id);
        for (i = 0; i < msg.len; i++) {
            printf("%02X", msg.data[i]);
        }
        puts(msg.flags & CAN_FLAG_RTR ? "R" : "");
        for (i = 0; i < count; i++) {
            if (i != sender) {
                can_net_recv(nodes[i].net, &msg);
            }
        }
    }
}

/* Adds a node; a node-ID of 0 leaves that of the description. */
static int add(int id, const char *description, const char *configuration)
{
    struct node *const node = &nodes[count];
    node->net = can_net_create();
    node->dev = co_dev_create_from_dcf_file(description);
    if (node->net == NULL || node->dev == NULL) {
        return -1;
    }
    if ((id != 0 && co_dev_set_id(node->dev, (co_unsigned8_t)id) == -1)
            || (configuration != NULL && co_dev_read_dcf_file(node->dev, NULL, NULL, configuration) == -1)) {
        return -1;
    }
    can_net_set_send_func(node->net, &take, node);
    node->nmt = co_nmt_create(node->net, node->dev);
    count++;
    return node->nmt == NULL ? -1 : 0;
}

int main(int argc, char **argv)
{
    const long limit = argc > 3 ? atol(argv[1]) : 0;
    long time;
    int i;
    if (limit == 0 || add(0, argv[2], strcmp(argv[3], "-") ? argv[3] : NULL) == -1) {
        return 1;
    }
    for (i = 4; i + 1 < argc && count < NODES; i += 2) {
        if (add(atoi(argv[i]), argv[i + 1], NULL) == -1) {
            return 1;
        }
    }
    co_nmt_set_boot_ind(nodes[0].nmt, &booted, NULL);
    /* the master is switched on last */
    for (i = count - 1; i >= 0; i--) {
        co_nmt_cs_ind(nodes[i].nmt, CO_NMT_CS_RESET_NODE);
        if (i > 0) {
            end = first;
        }
    }
    deliver();
    for (time = 1; time < limit; time++) {
        const struct timespec now = { time / 1000, time % 1000 * 1000000 };
        for (i = 0; i < count; i++) {
            can_net_set_time(nodes[i].net, &now);
            deliver();
        }
    }
    for (i = 0; i < count; i++) {
        const co_unsigned8_t id = co_dev_get_id(nodes[i].dev);
        printf("node %u %u %c\n", id, co_nmt_get_st(nodes[i].nmt), status[id % NODES] ? status[id % NODES] : '?');
    }
    return 0;
}
