/*
 * Registers the hooks of a table and prints for which entries, and in which direction, with the declarations of the tests.
 */
#include "hooked_sdev.h"

#include <stdio.h>

struct co_dev {
    int mark;
};

struct co_sub {
    unsigned idx, subidx;
};

co_sub_t *co_dev_find_sub(const co_dev_t *dev, co_unsigned16_t idx, co_unsigned8_t subidx)
{
    static struct co_sub found;
    found.idx = idx;
    found.subidx = subidx;
    return dev->mark == 7 ? &found : NULL;
}

void co_sub_set_dn_ind(co_sub_t *sub, co_sub_dn_ind_t *ind, void *data)
{
    printf("dn %04X %02X %lu\n", sub->idx, sub->subidx, (unsigned long)ind(sub, NULL, data));
}

void co_sub_set_up_ind(co_sub_t *sub, co_sub_up_ind_t *ind, void *data)
{
    printf("up %04X %02X %lu\n", sub->idx, sub->subidx, (unsigned long)ind(sub, NULL, data));
}

#define WRITTEN(index) \
    co_unsigned32_t od_hook##index##_dn(co_sub_t *sub, struct co_sdo_req *req, void *data) \
    { \
        (void)req; \
        return sub->idx == 0x##index ? *(co_unsigned8_t *)data : 0u; \
    }
#define READ(index) \
    co_unsigned32_t od_hook##index##_up(const co_sub_t *sub, struct co_sdo_req *req, void *data) \
    { \
        (void)req; \
        return sub->idx == 0x##index ? *(co_unsigned8_t *)data : 0u; \
    }

READ(1017)
WRITTEN(2101)
READ(2101)
WRITTEN(2102)
READ(2102)

int main(void)
{
    co_unsigned8_t mark = 9u;
    co_dev_t dev = {7};
    od_init_hooks(&dev, &mark);
    return 0;
}
