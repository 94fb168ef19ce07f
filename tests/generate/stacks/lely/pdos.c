/*
 * A node of the library with the device SDEV and the node-ID of the first argument: each PDO that the tables have as valid is used
 * once, as its transmission type says, and those that are rejected or not transmitted are printed.
 */
#include <lely/can/net.h>
#include <lely/co/dev.h>
#include <lely/co/obj.h>
#include <lely/co/rpdo.h>
#include <lely/co/sdev.h>
#include <lely/co/sdo.h>
#include <lely/co/tpdo.h>

#include <stdio.h>
#include <stdlib.h>

extern const struct co_sdev SDEV;

static can_net_t *net;
static co_dev_t *dev;
/* The frames that were sent, and the PDOs that were taken. */
static unsigned sent, processed, taken;

static int take(const struct can_msg *msg, void *data)
{
    (void)data;
    sent += (msg->flags & CAN_FLAG_RTR) == 0;
    return 0;
}

/* The values are zeros, so limits may refuse them, which is no fault of the PDO. */
static void received(co_rpdo_t *pdo, co_unsigned32_t ac, const void *bytes, size_t size, void *data)
{
    (void)pdo;
    (void)bytes;
    (void)size;
    (void)data;
    processed++;
    taken += ac == 0u || ac == CO_SDO_AC_PARAM_VAL || ac == CO_SDO_AC_PARAM_HI || ac == CO_SDO_AC_PARAM_LO
        || ac == CO_SDO_AC_PARAM_RANGE;
}

static struct can_msg frame(co_unsigned32_t cob_id, uint_least8_t flags)
{
    struct can_msg msg = CAN_MSG_INIT;
    const int is_extended = (cob_id & CO_PDO_COBID_FRAME) != 0u;
    msg.id = cob_id & (is_extended ? CAN_MASK_EID : CAN_MASK_BID);
    msg.flags = (uint_least8_t)(flags | (is_extended ? CAN_FLAG_IDE : 0));
    msg.len = (flags & CAN_FLAG_RTR) ? 0 : CAN_MAX_LEN;
    return msg;
}

/* Whether both objects are there, the COB-ID is valid, and the PDO is no MPDO, whose frame says what it is for. */
static int is_valid(unsigned communication)
{
    return co_dev_find_obj(dev, (co_unsigned16_t)communication) && co_dev_find_obj(dev, (co_unsigned16_t)(communication + 0x200u))
        && co_dev_get_val_u8(dev, (co_unsigned16_t)(communication + 0x200u), 0) <= CO_PDO_NUM_MAPS
        && !(co_dev_get_val_u32(dev, (co_unsigned16_t)communication, 1) & CO_PDO_COBID_VALID);
}

static void receive(co_unsigned16_t number)
{
    co_rpdo_t *const pdo = co_rpdo_create(net, dev, number);
    const struct can_msg msg = frame(co_rpdo_get_comm_par(pdo)->cobid, 0);
    co_rpdo_set_ind(pdo, &received, NULL);
    processed = taken = 0u;
    can_net_recv(net, &msg);
    co_rpdo_sync(pdo, 0);
    if (taken == 0u) {
        printf("RPDO %u %s\n", (unsigned)number, processed > 0u ? "rejected" : "without effect");
    }
    co_rpdo_destroy(pdo);
}

static void transmit(co_unsigned16_t number)
{
    co_tpdo_t *const pdo = co_tpdo_create(net, dev, number);
    const struct can_msg msg = frame(co_tpdo_get_comm_par(pdo)->cobid, CAN_FLAG_RTR);
    unsigned at;
    sent = 0u;
    co_tpdo_event(pdo);
    for (at = 0u; at < 240u && sent == 0u; at++) {
        co_tpdo_sync(pdo, 0);
    }
    if (sent == 0u) {
        can_net_recv(net, &msg);
    }
    if (sent == 0u) {
        printf("TPDO %u silent\n", (unsigned)number);
    }
    co_tpdo_destroy(pdo);
}

int main(int count, char **arguments)
{
    unsigned at;
    net = can_net_create();
    dev = co_dev_create_from_sdev(&SDEV);
    if (count < 2 || net == NULL || dev == NULL || co_dev_set_id(dev, (co_unsigned8_t)atoi(arguments[1])) == -1) {
        return 1;
    }
    can_net_set_send_func(net, &take, NULL);
    for (at = 0u; at < CO_NUM_PDOS; at++) {
        if (is_valid(0x1400u + at)) {
            receive((co_unsigned16_t)(at + 1u));
        }
        if (is_valid(0x1800u + at)) {
            transmit((co_unsigned16_t)(at + 1u));
        }
    }
    return 0;
}
