/*
 * Loads a device with the library, gives it the node-ID of the first argument, and prints its entries. The device is SDEV, or with
 * LELY_NO_MALLOC what CREATE makes; else that of the EDS or DCF of the second argument, which then takes the concise DCF of the
 * third, if there is one.
 */
#include <lely/co/dcf.h>
#include <lely/co/dev.h>
#include <lely/co/obj.h>
#include <lely/co/sdev.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#if LELY_NO_MALLOC
extern co_dev_t *CREATE(void);
#elif defined(SDEV)
extern const struct co_sdev SDEV;
#endif

/* The device of the arguments of the program; NULL if it cannot be loaded. */
static co_dev_t *load(int count, char **arguments)
{
    co_dev_t *dev = NULL;
    if (count < 2) {
        return NULL;
    }
#if LELY_NO_MALLOC
    dev = CREATE();
#elif defined(SDEV)
    dev = co_dev_create_from_sdev(&SDEV);
#else
    dev = count > 2 ? co_dev_create_from_dcf_file(arguments[2]) : NULL;
#endif
    if (dev == NULL || co_dev_set_id(dev, (co_unsigned8_t)atoi(arguments[1])) == -1) {
        return NULL;
    }
#if !LELY_NO_MALLOC
    if (count > 3 && co_dev_read_dcf_file(dev, NULL, NULL, arguments[3]) == -1) {
        return NULL;
    }
#endif
    return dev;
}

static void print(const co_obj_t *obj, const co_sub_t *sub)
{
    static unsigned char bytes[0x20000];
    const unsigned type = co_sub_get_type(sub);
    const unsigned access = co_sub_get_access(sub);
    const void *const val = co_sub_get_val(sub);
    const size_t size = co_val_write(co_sub_get_type(sub), val, NULL, NULL);
    const int mapping = co_sub_get_pdo_mapping(sub);
    size_t at;
    co_val_write(co_sub_get_type(sub), val, bytes, bytes + size);
    printf("%04X %02X %02X ", co_obj_get_idx(obj), co_sub_get_subidx(sub), type);
    if (co_type_is_array(co_sub_get_type(sub))) {
        putchar('-');
    } else {
        printf("%u", (unsigned)size);
    }
    printf(" %c%c%c%c ", (access & CO_ACCESS_READ) ? 'r' : '-', (access & CO_ACCESS_WRITE) ? 'w' : '-',
           mapping && (access & CO_ACCESS_TPDO) ? 't' : '-', mapping && (access & CO_ACCESS_RPDO) ? 'p' : '-');
    for (at = 0u; at < size; at++) {
        printf("%02X", bytes[at]);
    }
    puts(size > 0u ? "" : "-");
}

int main(int count, char **arguments)
{
    static co_unsigned16_t indexes[0x10000];
    co_dev_t *const dev = load(count, arguments);
    co_unsigned16_t objects, at;
    if (dev == NULL) {
        return 1;
    }
    objects = co_dev_get_idx(dev, 0xFFFF, indexes);
    for (at = 0u; at < objects; at++) {
        const co_obj_t *const obj = co_dev_find_obj(dev, indexes[at]);
        co_unsigned8_t subs[0xFF];
        const co_unsigned8_t entries = co_obj_get_subidx(obj, 0xFF, subs);
        co_unsigned8_t sub;
        for (sub = 0u; sub < entries; sub++) {
            print(obj, co_obj_find_sub(obj, subs[sub]));
        }
    }
#if !LELY_NO_MALLOC
    co_dev_destroy(dev);
#endif
    return 0;
}
