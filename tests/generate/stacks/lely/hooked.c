/*
 * Hooks of an application, with the library: downloads to 2101h end with abort code 0609 0030h where the value is above 1000, and
 * uploads of 2102h:01 provide the argument.
 */
#include "hooked_sdev.h"

#include <lely/co/sdo.h>

#include <stdio.h>

co_unsigned32_t od_hook1017_up(const co_sub_t *sub, struct co_sdo_req *req, void *data)
{
    co_unsigned32_t ac = 0;
    (void)data;
    co_sub_on_up(sub, req, &ac);
    return ac;
}

co_unsigned32_t od_hook2101_dn(co_sub_t *sub, struct co_sdo_req *req, void *data)
{
    co_unsigned32_t ac = 0;
    co_integer16_t value = 0;
    (void)data;
    if (co_sdo_req_dn_val(req, CO_DEFTYPE_INTEGER16, &value, &ac) == -1) {
        return ac;
    }
    if (value > 1000) {
        return CO_SDO_AC_PARAM_VAL;
    }
    co_sub_dn(sub, &value);
    return 0;
}

co_unsigned32_t od_hook2101_up(const co_sub_t *sub, struct co_sdo_req *req, void *data)
{
    return od_hook1017_up(sub, req, data);
}

co_unsigned32_t od_hook2102_dn(co_sub_t *sub, struct co_sdo_req *req, void *data)
{
    co_unsigned32_t ac = 0;
    (void)data;
    co_sub_on_dn(sub, req, &ac);
    return ac;
}

co_unsigned32_t od_hook2102_up(const co_sub_t *sub, struct co_sdo_req *req, void *data)
{
    co_unsigned32_t ac = 0;
    co_sdo_req_up_val(req, co_sub_get_type(sub), data, &ac);
    return ac;
}

static void write(co_dev_t *dev, co_unsigned16_t index, co_unsigned8_t sub, co_integer16_t value)
{
    co_unsigned32_t ac = co_sub_dn_ind_val(co_dev_find_sub(dev, index, sub), CO_DEFTYPE_INTEGER16, &value);
    printf("%04X %02X: %08lX\n", (unsigned)index, (unsigned)sub, (unsigned long)ac);
}

static void read(co_dev_t *dev, co_unsigned16_t index, co_unsigned8_t sub)
{
    struct co_sdo_req req = CO_SDO_REQ_INIT;
    co_integer16_t value = 0;
    co_unsigned32_t ac = co_sub_up_ind(co_dev_find_sub(dev, index, sub), &req);
    co_sdo_req_dn_val(&req, CO_DEFTYPE_INTEGER16, &value, NULL);
    printf("%04X %02X = %d: %08lX\n", (unsigned)index, (unsigned)sub, (int)value, (unsigned long)ac);
    co_sdo_req_fini(&req);
}

int main(void)
{
    co_integer16_t reading = 1234;
    co_dev_t *const dev = co_dev_create_from_sdev(&od_sdev);
    if (dev == NULL) {
        return 1;
    }
    od_init_hooks(dev, &reading);
    write(dev, 0x2101, 0, 1001);
    write(dev, 0x2101, 0, 1000);
    read(dev, 0x2101, 0);
    write(dev, 0x2102, 1, 5);
    read(dev, 0x2102, 1);
    read(dev, 0x2102, 2);
    co_dev_destroy(dev);
    return 0;
}
