/*
 * Prints every row of a static device as the library loads it. With an argument, also what only the library reads: names, codes,
 * limits, defaults and flags. SDEV is the device; compiles with the headers of the library, too.
 */
#include <lely/co/sdev.h>

#include <stdio.h>
#include <string.h>

extern const struct co_sdev SDEV;

static void hexadecimal(const void *bytes, size_t size)
{
    size_t at;
    for (at = 0u; at < size; at++) {
        printf("%02X", ((const unsigned char *)bytes)[at]);
    }
    if (size == 0u) {
        putchar('-');
    }
}

/* The size of a number on the bus, and the type in which it is stored; 0 for an array. */
static size_t size_of(unsigned type)
{
    switch (type) {
    case CO_DEFTYPE_BOOLEAN: case CO_DEFTYPE_INTEGER8: case CO_DEFTYPE_UNSIGNED8: return 1u;
    case CO_DEFTYPE_INTEGER16: case CO_DEFTYPE_UNSIGNED16: return 2u;
    case CO_DEFTYPE_INTEGER24: case CO_DEFTYPE_UNSIGNED24: return 3u;
    case CO_DEFTYPE_INTEGER32: case CO_DEFTYPE_UNSIGNED32: case CO_DEFTYPE_REAL32: return 4u;
    case CO_DEFTYPE_INTEGER40: case CO_DEFTYPE_UNSIGNED40: return 5u;
    case CO_DEFTYPE_INTEGER48: case CO_DEFTYPE_UNSIGNED48: case CO_DEFTYPE_TIME_OF_DAY: case CO_DEFTYPE_TIME_DIFF: return 6u;
    case CO_DEFTYPE_INTEGER56: case CO_DEFTYPE_UNSIGNED56: return 7u;
    case CO_DEFTYPE_INTEGER64: case CO_DEFTYPE_UNSIGNED64: case CO_DEFTYPE_REAL64: return 8u;
    default: return 0u;
    }
}

/* A value as an SDO carries it. */
static void value(unsigned type, const union co_val *val)
{
    const size_t size = size_of(type);
    if (type == CO_DEFTYPE_TIME_OF_DAY || type == CO_DEFTYPE_TIME_DIFF) {
        const uint32_t ms = type == CO_DEFTYPE_TIME_OF_DAY ? val->t.ms : val->td.ms;
        const uint16_t days = type == CO_DEFTYPE_TIME_OF_DAY ? val->t.days : val->td.days;
        hexadecimal(&ms, sizeof ms);
        hexadecimal(&days, sizeof days);
    } else if (size > 0u) {
        hexadecimal(val, size); /* a little-endian processor */
    } else if (val->dom == NULL) {
        putchar('-');
    } else {
        struct co_array_hdr hdr;
        memcpy(&hdr, (const char *)val->dom - offsetof(struct { struct co_array_hdr hdr; union co_val val; }, val), sizeof hdr);
        if (type == CO_DEFTYPE_UNICODE_STRING) {
            size_t length = 0u; /* the library copies characters up to the first zero */
            while (2u * length < hdr.size && val->us[length] != 0u) {
                length++;
            }
            hdr.size = 2u * length;
        }
        hexadecimal(val->dom, hdr.capacity >= hdr.size ? hdr.size : 0u);
    }
}

static void text(const char *name, const char *string)
{
    printf(" %s=", name);
    if (string == NULL) {
        putchar('-');
    } else {
        hexadecimal(string, strlen(string));
    }
}

static void details(const struct co_ssub *sub)
{
#if !LELY_NO_CO_OBJ_NAME
    text("name", sub->name);
#endif
#if !LELY_NO_CO_OBJ_LIMITS
    if (size_of(sub->type) > 0u) {
        printf(" min=");
        value(sub->type, &sub->min);
        printf(" max=");
        value(sub->type, &sub->max);
    }
#endif
#if !LELY_NO_CO_OBJ_DEFAULT
    printf(" def=");
    value(sub->type, &sub->def);
#endif
    printf(" flags=%X", (unsigned)sub->flags);
}

static void row(const struct co_sobj *obj, const struct co_ssub *sub, int all)
{
    const unsigned access = sub->access;
    const unsigned long size = (unsigned long)size_of(sub->type);
    printf("%04X %02X %02X ", obj->idx, sub->subidx, sub->type);
    if (size > 0u) {
        printf("%lu", size);
    } else {
        putchar('-');
    }
    printf(" %c%c%c%c ", (access & CO_ACCESS_READ) != 0u ? 'r' : '-', (access & CO_ACCESS_WRITE) != 0u ? 'w' : '-',
           sub->pdo_mapping != 0u && (access & CO_ACCESS_TPDO) != 0u ? 't' : '-',
           sub->pdo_mapping != 0u && (access & CO_ACCESS_RPDO) != 0u ? 'p' : '-');
    value(sub->type, &sub->val);
    if (all) {
        details(sub);
    }
    putchar('\n');
}

int main(int count, char **arguments)
{
    const struct co_sobj *obj;
    (void)arguments;
    if (count > 1) {
        printf("device %02X vendor=%08lX product=%08lX revision=%08lX baud=%X rate=%u lss=%d dummy=%lX", SDEV.id,
               (unsigned long)SDEV.vendor_id, (unsigned long)SDEV.product_code, (unsigned long)SDEV.revision,
               (unsigned)SDEV.baud, SDEV.rate, SDEV.lss, (unsigned long)SDEV.dummy);
        text("name", SDEV.name);
        text("vendor", SDEV.vendor_name);
        text("product", SDEV.product_name);
        text("order", SDEV.order_code);
        putchar('\n');
    }
    for (obj = SDEV.objs; obj < SDEV.objs + SDEV.nobj; obj++) {
        const struct co_ssub *sub;
        if (count > 1) {
            printf("object %04X %u", obj->idx, obj->code);
#if !LELY_NO_CO_OBJ_NAME
            text("name", obj->name);
#endif
            putchar('\n');
        }
        for (sub = obj->subs; sub < obj->subs + obj->nsub; sub++) {
            row(obj, sub, count > 1);
        }
    }
    return 0;
}
