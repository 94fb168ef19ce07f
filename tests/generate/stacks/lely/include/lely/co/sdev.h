/*
 * The part of the interface of Lely core 2.4 that a static device needs.
 */
#ifndef LELY_CO_SDEV_H
#define LELY_CO_SDEV_H

#include <float.h>
#include <stddef.h>
#include <stdint.h>

#define CO_OBJECT_NULL 0
#define CO_OBJECT_DOMAIN 2
#define CO_OBJECT_DEFTYPE 5
#define CO_OBJECT_DEFSTRUCT 6
#define CO_OBJECT_VAR 7
#define CO_OBJECT_ARRAY 8
#define CO_OBJECT_RECORD 9

#define CO_ACCESS_READ 0x01
#define CO_ACCESS_WRITE 0x02
#define CO_ACCESS_TPDO 0x04
#define CO_ACCESS_RPDO 0x08
#define CO_ACCESS_RO 0x05
#define CO_ACCESS_WO 0x0A
#define CO_ACCESS_RW 0x0F
#define CO_ACCESS_RWR 0x07
#define CO_ACCESS_RWW 0x0B
#define CO_ACCESS_CONST 0x15

#define CO_OBJ_FLAGS_READ 0x001
#define CO_OBJ_FLAGS_WRITE 0x002
#define CO_OBJ_FLAGS_UPLOAD_FILE 0x004
#define CO_OBJ_FLAGS_DOWNLOAD_FILE 0x008
#define CO_OBJ_FLAGS_MIN_NODEID 0x010
#define CO_OBJ_FLAGS_MAX_NODEID 0x020
#define CO_OBJ_FLAGS_DEF_NODEID 0x040
#define CO_OBJ_FLAGS_VAL_NODEID 0x080
#define CO_OBJ_FLAGS_PARAMETER_VALUE 0x100

#define CO_BAUD_1000 0x001
#define CO_BAUD_800 0x002
#define CO_BAUD_500 0x004
#define CO_BAUD_250 0x008
#define CO_BAUD_125 0x020
#define CO_BAUD_50 0x040
#define CO_BAUD_20 0x080
#define CO_BAUD_10 0x100
#define CO_BAUD_AUTO 0x200

/* The codes of the types, and the ranges of numbers. */
enum {
    CO_DEFTYPE_BOOLEAN = 0x01, CO_DEFTYPE_INTEGER8, CO_DEFTYPE_INTEGER16, CO_DEFTYPE_INTEGER32, CO_DEFTYPE_UNSIGNED8,
    CO_DEFTYPE_UNSIGNED16, CO_DEFTYPE_UNSIGNED32, CO_DEFTYPE_REAL32, CO_DEFTYPE_VISIBLE_STRING, CO_DEFTYPE_OCTET_STRING,
    CO_DEFTYPE_UNICODE_STRING, CO_DEFTYPE_TIME_OF_DAY, CO_DEFTYPE_TIME_DIFF, CO_DEFTYPE_DOMAIN = 0x0F,
    CO_DEFTYPE_INTEGER24, CO_DEFTYPE_REAL64, CO_DEFTYPE_INTEGER40, CO_DEFTYPE_INTEGER48, CO_DEFTYPE_INTEGER56,
    CO_DEFTYPE_INTEGER64, CO_DEFTYPE_UNSIGNED24, CO_DEFTYPE_UNSIGNED40 = 0x18, CO_DEFTYPE_UNSIGNED48,
    CO_DEFTYPE_UNSIGNED56, CO_DEFTYPE_UNSIGNED64
};

#define CO_BOOLEAN_MIN 0
#define CO_BOOLEAN_MAX 1
#define CO_INTEGER8_MIN INT8_MIN
#define CO_INTEGER8_MAX INT8_MAX
#define CO_INTEGER16_MIN INT16_MIN
#define CO_INTEGER16_MAX INT16_MAX
#define CO_INTEGER24_MIN (-0x800000)
#define CO_INTEGER24_MAX 0x7FFFFF
#define CO_INTEGER32_MIN INT32_MIN
#define CO_INTEGER32_MAX INT32_MAX
#define CO_INTEGER40_MIN (-INT64_C(0x8000000000))
#define CO_INTEGER40_MAX INT64_C(0x7FFFFFFFFF)
#define CO_INTEGER48_MIN (-INT64_C(0x800000000000))
#define CO_INTEGER48_MAX INT64_C(0x7FFFFFFFFFFF)
#define CO_INTEGER56_MIN (-INT64_C(0x80000000000000))
#define CO_INTEGER56_MAX INT64_C(0x7FFFFFFFFFFFFF)
#define CO_INTEGER64_MIN INT64_MIN
#define CO_INTEGER64_MAX INT64_MAX
#define CO_UNSIGNED8_MIN 0
#define CO_UNSIGNED8_MAX UINT8_MAX
#define CO_UNSIGNED16_MIN 0
#define CO_UNSIGNED16_MAX UINT16_MAX
#define CO_UNSIGNED24_MIN 0
#define CO_UNSIGNED24_MAX UINT32_C(0xFFFFFF)
#define CO_UNSIGNED32_MIN 0
#define CO_UNSIGNED32_MAX UINT32_MAX
#define CO_UNSIGNED40_MIN 0
#define CO_UNSIGNED40_MAX UINT64_C(0xFFFFFFFFFF)
#define CO_UNSIGNED48_MIN 0
#define CO_UNSIGNED48_MAX UINT64_C(0xFFFFFFFFFFFF)
#define CO_UNSIGNED56_MIN 0
#define CO_UNSIGNED56_MAX UINT64_C(0xFFFFFFFFFFFFFF)
#define CO_UNSIGNED64_MIN 0
#define CO_UNSIGNED64_MAX UINT64_MAX
#define CO_REAL32_MIN (-FLT_MAX)
#define CO_REAL32_MAX FLT_MAX
#define CO_REAL64_MIN (-DBL_MAX)
#define CO_REAL64_MAX DBL_MAX
#define CO_TIME_OF_DAY_MIN {0, 0}
#define CO_TIME_OF_DAY_MAX {0x0FFFFFFF, 0xFFFF}
#define CO_TIME_DIFF_MIN CO_TIME_OF_DAY_MIN
#define CO_TIME_DIFF_MAX CO_TIME_OF_DAY_MAX

typedef uint8_t co_unsigned8_t;
typedef uint16_t co_unsigned16_t;
typedef uint32_t co_unsigned32_t;
struct co_time { co_unsigned32_t ms; co_unsigned16_t days; };

union co_val {
    _Bool b;
    int8_t i8;
    int16_t i16;
    int32_t i24, i32;
    int64_t i40, i48, i56, i64;
    uint8_t u8;
    uint16_t u16;
    uint32_t u24, u32;
    uint64_t u40, u48, u56, u64;
    float r32;
    double r64;
    char *vs;
    uint8_t *os;
    uint_least16_t *us;
    void *dom;
    struct co_time t, td;
};

/* Arrays follow their length, as the harness reads them. */
struct co_array_hdr { size_t capacity, size; };
#define CO_ARRAY_OF(element, count, length, ...) \
    (((struct { struct co_array_hdr hdr; union { element of[count]; union co_val val; } u; }){ \
        .hdr = {.capacity = sizeof(element[count]), .size = length}, .u = {.of = __VA_ARGS__}}).u.of)
#define CO_COUNT(element, ...) (sizeof((element[])__VA_ARGS__) / sizeof(element))
#define CO_VISIBLE_STRING_C(text) CO_ARRAY_OF(char, sizeof(text), sizeof(text) - 1u, text)
#define CO_OCTET_STRING_C(text) CO_ARRAY_OF(uint8_t, sizeof(text), sizeof(text) - 1u, text)
#define CO_UNICODE_STRING_C(...) \
    CO_ARRAY_OF(uint_least16_t, CO_COUNT(uint_least16_t, __VA_ARGS__), \
                2u * CO_COUNT(uint_least16_t, __VA_ARGS__) - 2u, __VA_ARGS__)
#define CO_DOMAIN_NC(element, capacity, ...) \
    CO_ARRAY_OF(element, (capacity), sizeof((element[])__VA_ARGS__), __VA_ARGS__)
#define CO_DOMAIN_C(element, ...) CO_DOMAIN_NC(element, CO_COUNT(element, __VA_ARGS__), __VA_ARGS__)

struct co_ssub {
#if !LELY_NO_CO_OBJ_NAME
    const char *name;
#endif
    co_unsigned8_t subidx;
    co_unsigned16_t type;
#if !LELY_NO_CO_OBJ_LIMITS
    union co_val min, max;
#endif
#if !LELY_NO_CO_OBJ_DEFAULT
    union co_val def;
#endif
    union co_val val;
    uint_least32_t access : 5;
    uint_least32_t pdo_mapping : 1;
    uint_least32_t flags : 26;
};

struct co_sobj {
#if !LELY_NO_CO_OBJ_NAME
    const char *name;
#endif
    co_unsigned16_t idx;
    co_unsigned8_t code, nsub;
    const struct co_ssub *subs;
};

struct co_sdev {
    co_unsigned8_t id;
    const char *name, *vendor_name;
    co_unsigned32_t vendor_id;
    const char *product_name;
    co_unsigned32_t product_code, revision;
    const char *order_code;
    unsigned baud : 10;
    co_unsigned16_t rate;
    int lss;
    co_unsigned32_t dummy;
    co_unsigned16_t nobj;
    const struct co_sobj *objs;
};

typedef struct co_dev co_dev_t;
co_dev_t *co_dev_create_from_sdev(const struct co_sdev *sdev);
int co_dev_set_id(co_dev_t *dev, co_unsigned8_t id);

#endif
