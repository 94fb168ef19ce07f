/*
 * The part of the interface of Lely core 2.4 that finds an entry of a device.
 */
#ifndef LELY_CO_DEV_H
#define LELY_CO_DEV_H

#include <lely/co/obj.h>

co_sub_t *co_dev_find_sub(const co_dev_t *dev, co_unsigned16_t idx, co_unsigned8_t subidx);

#endif
