/*
 * Prints every row of a dictionary: found as the stack finds it, read as its SDO server reads it, and written back.
 * DICTIONARY names the header of the dictionary.
 */
#include DICTIONARY

#include <stdio.h>
#include <string.h>

enum { LONGEST = 0x20000, SEGMENT = 7 };

static CO_NODE node = {.NodeId = 5u};
struct CO_IF_DRV_T AppDriver = {0u};
extern struct CO_NODE_SPEC_T AppSpec;

static int is(const CO_OBJ *obj, uint32_t flag)
{
    return (obj->Key & flag) != 0u;
}

static uint8_t sub_of(const CO_OBJ *obj)
{
    return (uint8_t)((obj->Key >> 8) & 0xFFu);
}

/* Numbers: in the row or at its address; the node-ID is added and subtracted. */
static CO_ERR number_read(struct CO_OBJ_T *obj, struct CO_NODE_T *own, void *buffer, uint32_t size)
{
    uint32_t value = (uint32_t)obj->Data;
    if (!is(obj, CO_OBJ_D_____)) {
        value = 0u;
        memcpy(&value, (const void *)obj->Data, size);
    }
    if (is(obj, CO_OBJ__N____)) {
        value += own->NodeId;
    }
    memcpy(buffer, &value, size);
    return CO_ERR_NONE;
}

static CO_ERR number_write(struct CO_OBJ_T *obj, struct CO_NODE_T *own, void *buffer, uint32_t size)
{
    uint32_t value = 0u;
    memcpy(&value, buffer, size);
    if (is(obj, CO_OBJ__N____)) {
        value -= own->NodeId;
    }
    if (is(obj, CO_OBJ_D_____)) {
        return CO_ERR_TYPE_WR; /* the table is in flash */
    }
    memcpy((void *)obj->Data, &value, size);
    return CO_ERR_NONE;
}

#define INTEGER(name, bytes) \
    static uint32_t name##Size(struct CO_OBJ_T *obj, struct CO_NODE_T *own, uint32_t width) \
    { \
        (void)own; \
        (void)width; \
        return is(obj, CO_OBJ_D_____) || obj->Data != 0u ? bytes : 0u; \
    } \
    const CO_OBJ_TYPE name = {name##Size, NULL, number_read, number_write, NULL}

INTEGER(Integer8, 1u);
INTEGER(Integer16, 2u);
INTEGER(Integer32, 4u);

/* A text continues where the last read ended. */
static uint32_t string_size(struct CO_OBJ_T *obj, struct CO_NODE_T *own, uint32_t width)
{
    (void)own;
    (void)width;
    return (uint32_t)strlen((const char *)((CO_OBJ_STR *)obj->Data)->Start);
}

static CO_ERR string_read(struct CO_OBJ_T *obj, struct CO_NODE_T *own, void *buffer, uint32_t size)
{
    CO_OBJ_STR *const text = (CO_OBJ_STR *)obj->Data;
    uint8_t *out = buffer;
    (void)own;
    for (; size > 0u && text->Start[text->Offset] != 0u; size--) {
        *out++ = text->Start[text->Offset++];
    }
    return CO_ERR_NONE;
}

static CO_ERR string_reset(struct CO_OBJ_T *obj, struct CO_NODE_T *own, uint32_t para)
{
    (void)own;
    ((CO_OBJ_STR *)obj->Data)->Offset = para;
    return CO_ERR_NONE;
}

const CO_OBJ_TYPE String = {string_size, NULL, string_read, NULL, string_reset};

/* So does a domain. */
static uint32_t domain_size(struct CO_OBJ_T *obj, struct CO_NODE_T *own, uint32_t width)
{
    const uint32_t size = ((CO_OBJ_DOM *)obj->Data)->Size;
    (void)own;
    return width > 0u && width < size ? width : size;
}

static CO_ERR domain_read(struct CO_OBJ_T *obj, struct CO_NODE_T *own, void *buffer, uint32_t size)
{
    CO_OBJ_DOM *const domain = (CO_OBJ_DOM *)obj->Data;
    const uint32_t rest = domain->Size - domain->Offset;
    const uint32_t count = size < rest ? size : rest;
    (void)own;
    memcpy(buffer, domain->Start + domain->Offset, count);
    domain->Offset += count;
    return CO_ERR_NONE;
}

static CO_ERR domain_reset(struct CO_OBJ_T *obj, struct CO_NODE_T *own, uint32_t para)
{
    (void)own;
    ((CO_OBJ_DOM *)obj->Data)->Offset = para;
    return CO_ERR_NONE;
}

const CO_OBJ_TYPE Domain = {domain_size, NULL, domain_read, NULL, domain_reset};

/* Sub-index 0 is a byte, the others have 4; their data differ. */
static uint32_t list_size(struct CO_OBJ_T *obj, struct CO_NODE_T *own, uint32_t width)
{
    return sub_of(obj) == 0u ? Integer8Size(obj, own, width) : Integer32Size(obj, own, width);
}

static uint32_t consumer_size(struct CO_OBJ_T *obj, struct CO_NODE_T *own, uint32_t width)
{
    (void)own;
    (void)width;
    return obj->Data == 0u ? 0u : sub_of(obj) == 0u ? 1u : 4u;
}

static CO_ERR history_read(struct CO_OBJ_T *obj, struct CO_NODE_T *own, void *buffer, uint32_t size)
{
    return sub_of(obj) == 0u ? number_read(obj, own, buffer, size) : CO_ERR_TYPE_RD; /* no error has happened */
}

static CO_ERR consumer_read(struct CO_OBJ_T *obj, struct CO_NODE_T *own, void *buffer, uint32_t size)
{
    if (sub_of(obj) > 0u) {
        const CO_HBCONS *const consumer = (const CO_HBCONS *)obj->Data;
        const uint32_t value = ((uint32_t)consumer->NodeId << 16) | consumer->Time;
        memcpy(buffer, &value, sizeof value);
        return CO_ERR_NONE;
    }
    return number_read(obj, own, buffer, size);
}

static CO_ERR store_read(struct CO_OBJ_T *obj, struct CO_NODE_T *own, void *buffer, uint32_t size)
{
    if (sub_of(obj) > 0u) {
        memcpy(buffer, &((const CO_PARA *)obj->Data)->Value, sizeof(uint32_t));
        return CO_ERR_NONE;
    }
    return number_read(obj, own, buffer, size);
}

static CO_ERR restore_read(struct CO_OBJ_T *obj, struct CO_NODE_T *own, void *buffer, uint32_t size)
{
    if (sub_of(obj) > 0u) {
        const uint32_t value = ((const CO_PARA *)obj->Data)->Default != NULL ? 1u : 0u;
        memcpy(buffer, &value, sizeof value);
        return CO_ERR_NONE;
    }
    return number_read(obj, own, buffer, size);
}

const CO_OBJ_TYPE History = {list_size, NULL, history_read, NULL, NULL};
const CO_OBJ_TYPE Consumer = {consumer_size, NULL, consumer_read, NULL, NULL};
const CO_OBJ_TYPE Store = {list_size, NULL, store_read, NULL, NULL};
const CO_OBJ_TYPE Restore = {list_size, NULL, restore_read, NULL, NULL};

/* The stack's search: both ends are inclusive, so it also checks the end mark. */
static CO_OBJ *find(uint32_t key)
{
    int32_t start = 0;
    int32_t end = (int32_t)AppSpec.DictLen;
    while (start <= end) {
        const int32_t middle = start + (end - start) / 2;
        CO_OBJ *const obj = &AppSpec.Dict[middle];
        if ((obj->Key & 0xFFFFFF00u) == key) {
            return obj;
        }
        if ((obj->Key & 0xFFFFFF00u) > key) {
            end = middle - 1;
        } else {
            start = middle + 1;
        }
    }
    return NULL;
}

/* An upload: in one frame without a reset, else in segments. -1: the server would abort. */
static long upload(CO_OBJ *obj, uint8_t *value)
{
    const uint32_t size = obj->Type->Size(obj, &node, 0u);
    uint32_t done = 0u;
    CO_ERR error = CO_ERR_NONE;
    if (size <= 4u) {
        return size == 0u ? 0 : obj->Type->Read(obj, &node, value, size) == CO_ERR_NONE ? (long)size : -1;
    }
    if (obj->Type->Reset != NULL) {
        obj->Type->Reset(obj, &node, 0u);
    }
    obj->Type->Read(obj, &node, value, 0u);
    for (; done < size && error == CO_ERR_NONE; done += SEGMENT) {
        error = obj->Type->Read(obj, &node, value + done, size - done < SEGMENT ? size - done : SEGMENT);
    }
    return error == CO_ERR_NONE ? (long)size : -1;
}

/* A download of the same value. */
static int download(CO_OBJ *obj, uint8_t *value, uint32_t size)
{
    uint32_t done = 0u;
    CO_ERR error = CO_ERR_NONE;
    if (obj->Type->Write == NULL || obj->Type->Size(obj, &node, size) != size) {
        return 0;
    }
    if (size <= 4u) {
        return obj->Type->Write(obj, &node, value, size) == CO_ERR_NONE;
    }
    if (obj->Type->Reset != NULL) {
        obj->Type->Reset(obj, &node, 0u);
    }
    obj->Type->Write(obj, &node, value, 0u);
    for (; done < size && error == CO_ERR_NONE; done += SEGMENT) {
        error = obj->Type->Write(obj, &node, value + done, size - done < SEGMENT ? size - done : SEGMENT);
    }
    return error == CO_ERR_NONE;
}

static int fail(const CO_OBJ *obj, const char *what)
{
    printf("%08lX: %s\n", (unsigned long)obj->Key, what);
    return 1;
}

static int print(CO_OBJ *obj)
{
    static uint8_t value[LONGEST];
    static uint8_t again[LONGEST];
    const int plain = obj->Type == CO_TUNSIGNED8 || obj->Type == CO_TUNSIGNED16 || obj->Type == CO_TUNSIGNED32;
    const int own = obj->Type->Write != NULL && !plain;
    const unsigned long size = obj->Type->Size(obj, &node, UINT32_MAX);
    const long length = upload(obj, value);
    long at;
    if (length != upload(obj, again) || (length > 0 && memcmp(value, again, (size_t)length) != 0)) {
        return fail(obj, "the second upload differs");
    }
    if (is(obj, CO_OBJ______W) && length > 0 && (plain || own)) {
        if (!download(obj, value, (uint32_t)length)) {
            return fail(obj, "the download fails");
        }
        if (length != upload(obj, again) || memcmp(value, again, (size_t)length) != 0) {
            return fail(obj, "the upload after the download differs");
        }
        if (obj->Type->Size(obj, &node, (uint32_t)size + 1u) > size) {
            return fail(obj, "a longer value is taken");
        }
    }
    printf("%04lX %02X - %lu %c%c%c%c ", (unsigned long)(obj->Key >> 16), sub_of(obj), size,
           is(obj, CO_OBJ_____R_) ? 'r' : '-', is(obj, CO_OBJ______W) ? 'w' : '-',
           is(obj, CO_OBJ____P__) && is(obj, CO_OBJ_____R_) ? 't' : '-',
           is(obj, CO_OBJ____P__) && is(obj, CO_OBJ______W) ? 'p' : '-');
    for (at = 0; at < length; at++) {
        printf("%02X", value[at]);
    }
    puts(length > 0 ? "" : "-");
    return 0;
}

int main(void)
{
    uint16_t number;
    node.NodeId = AppSpec.NodeId;
    for (number = 0u; number < AppSpec.DictLen; number++) {
        CO_OBJ *const obj = &AppSpec.Dict[number];
        const uint32_t key = obj->Key & 0xFFFFFF00u;
        if (find(key) != obj) {
            return fail(obj, "not found");
        }
        if (find(key + 0x100u) != NULL && find(key + 0x100u) != obj + 1) {
            return fail(obj, "its neighbour is found elsewhere");
        }
        if (print(obj) != 0) {
            return 1;
        }
    }
    return AppSpec.Dict[AppSpec.DictLen].Key == 0u ? 0 : 1;
}
