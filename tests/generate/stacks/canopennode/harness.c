/* Reads an object dictionary as CANopenNode does: finds objects by binary search, entries by the kind of their object, and
   values through the functions that an entry has.
   `harness dump N` prints every entry on node N, `harness write N` answers lines of index, sub-index and bytes. */
#define OD_DEFINITION
#include "301/CO_ODinterface.h"
#include "OD.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

OD_entry_t *OD_find(OD_t *od, uint16_t index)
{
    int low = 0;
    int high = (int)od->size - 1;
    while (low <= high) {
        const int middle = (low + high) / 2;
        OD_entry_t *entry = &od->list[middle];
        if (entry->index == index) {
            return entry;
        }
        if (entry->index < index) {
            low = middle + 1;
        } else {
            high = middle - 1;
        }
    }
    return NULL;
}

ODR_t OD_readOriginal(OD_stream_t *stream, void *buf, OD_size_t count, OD_size_t *countRead)
{
    if (stream->dataOrig == NULL) {
        return ODR_SUB_NOT_EXIST;
    }
    if (count < stream->dataLength) {
        return ODR_DEV_INCOMPAT;
    }
    memcpy(buf, stream->dataOrig, stream->dataLength);
    *countRead = stream->dataLength;
    return ODR_OK;
}

ODR_t OD_writeOriginal(OD_stream_t *stream, const void *buf, OD_size_t count, OD_size_t *countWritten)
{
    if (stream->dataOrig == NULL) {
        return ODR_SUB_NOT_EXIST;
    }
    if (count > stream->dataLength) {
        return ODR_DATA_LONG;
    }
    memcpy(stream->dataOrig, buf, count);
    *countWritten = count;
    return ODR_OK;
}

ODR_t OD_getSub(const OD_entry_t *entry, uint8_t subIndex, OD_IO_t *io, bool_t odOrig)
{
    OD_stream_t *stream = &io->stream;
    if (entry == NULL) {
        return ODR_IDX_NOT_EXIST;
    }
    memset(io, 0, sizeof(*io));
    switch (entry->odObjectType & ODT_TYPE_MASK) {
    case ODT_VAR: {
        const OD_obj_var_t *object = entry->odObject;
        if (subIndex > 0) {
            return ODR_SUB_NOT_EXIST;
        }
        stream->dataOrig = object->dataOrig;
        stream->attribute = object->attribute;
        stream->dataLength = object->dataLength;
        break;
    }
    case ODT_ARR: {
        const OD_obj_array_t *object = entry->odObject;
        if (subIndex >= entry->subEntriesCount) {
            return ODR_SUB_NOT_EXIST;
        }
        if (subIndex == 0) {
            stream->dataOrig = object->dataOrig0;
            stream->attribute = object->attribute0;
            stream->dataLength = 1;
        } else {
            uint8_t *first = object->dataOrig;
            stream->dataOrig = first == NULL ? NULL : first + object->dataElementSizeof * (subIndex - 1u);
            stream->attribute = object->attribute;
            stream->dataLength = object->dataElementLength;
        }
        break;
    }
    case ODT_REC: {
        const OD_obj_record_t *members = entry->odObject;
        const OD_obj_record_t *member = NULL;
        for (int i = 0; i < entry->subEntriesCount && member == NULL; i++) {
            member = members[i].subIndex == subIndex ? &members[i] : NULL;
        }
        if (member == NULL) {
            return ODR_SUB_NOT_EXIST;
        }
        stream->dataOrig = member->dataOrig;
        stream->attribute = member->attribute;
        stream->dataLength = member->dataLength;
        break;
    }
    default:
        return ODR_DEV_INCOMPAT;
    }
    io->read = OD_readOriginal;
    io->write = OD_writeOriginal;
    if (entry->extension != NULL && !odOrig) {
        stream->object = entry->extension->object;
        io->read = entry->extension->read;
        io->write = entry->extension->write;
    }
    stream->index = entry->index;
    stream->subIndex = subIndex;
    return ODR_OK;
}

/* Adds the node-ID to the COB-ID of an entry that contains only the function code. */
static void add_node_id(uint16_t index, uint8_t sub, uint32_t function, uint8_t node_id)
{
    OD_IO_t io;
    uint32_t value;
    OD_size_t count;
    if (OD_getSub(OD_find(OD, index), sub, &io, true) != ODR_OK || io.stream.dataLength != 4) {
        return;
    }
    io.read(&io.stream, &value, 4, &count);
    if ((value & 0x7FFu) == function) {
        value += node_id;
        io.write(&io.stream, &value, 4, &count);
    }
}

/* Sets an entry of four bytes. */
static void set(uint16_t index, uint8_t sub, uint32_t value)
{
    OD_IO_t io;
    OD_size_t count;
    if (OD_getSub(OD_find(OD, index), sub, &io, true) == ODR_OK && io.stream.dataLength == 4) {
        io.write(&io.stream, &value, 4, &count);
    }
}

/* How the stack applies the node-ID at start. */
static void start(uint8_t node_id)
{
    OD_applyNodeId(node_id);
    set(0x1200, 1, 0x600u + node_id);
    set(0x1200, 2, 0x580u + node_id);
    add_node_id(0x1014, 0, 0x80, node_id);
    for (unsigned i = 0; i < 4; i++) {
        add_node_id((uint16_t)(0x1400u + i), 1, 0x200u + 0x100u * i, node_id);
        add_node_id((uint16_t)(0x1800u + i), 1, 0x180u + 0x100u * i, node_id);
    }
}

static uint8_t buffer[0x20000];

/* Alignment of a number: 32-bit processors need not align 64 bits to 8 bytes. */
static size_t alignment(size_t length)
{
    struct widest {
        char first;
        uint64_t number;
    };
    return length == sizeof(uint64_t) ? offsetof(struct widest, number) : length;
}

static void dump_entry(OD_IO_t *io)
{
    const OD_stream_t *stream = &io->stream;
    const OD_attr_t flags = stream->attribute;
    OD_size_t length = 0;
    const ODR_t answer = io->read(&io->stream, buffer, sizeof buffer, &length);
    if (answer != (stream->dataOrig == NULL ? ODR_SUB_NOT_EXIST : ODR_OK)) {
        fprintf(stderr, "%04X %02X: %d\n", stream->index, stream->subIndex, (int)answer);
        exit(1);
    }
    if ((flags & ODA_MB) != 0 && length > 0 && (size_t)stream->dataOrig % alignment(length) != 0) {
        fprintf(stderr, "%04X %02X: not aligned\n", stream->index, stream->subIndex);
        exit(1);
    }
    while ((flags & ODA_STR) != 0 && length > 0 && buffer[length - 1] == 0) {
        length--;
    }
    printf("%04X %02X - %lu ", stream->index, stream->subIndex, (unsigned long)stream->dataLength);
    printf("%c%c%c%c ", flags & ODA_SDO_R ? 'r' : '-', flags & ODA_SDO_W ? 'w' : '-', flags & ODA_TPDO ? 't' : '-',
           flags & ODA_RPDO ? 'p' : '-');
    for (OD_size_t i = 0; i < length; i++) {
        printf("%02X", buffer[i]);
    }
    printf(length == 0 ? "-\n" : "\n");
}

static void dump(void)
{
    for (uint32_t index = 0; index <= 0xFFFF; index++) {
        const OD_entry_t *entry = OD_find(OD, (uint16_t)index);
        for (unsigned sub = 0; entry != NULL && sub <= 0xFF; sub++) {
            OD_IO_t io;
            if (OD_getSub(entry, (uint8_t)sub, &io, false) == ODR_OK) {
                dump_entry(&io);
            }
        }
    }
}

/* The answer of the SDO server. */
static unsigned long write(OD_IO_t *io, const uint8_t *bytes, OD_size_t count)
{
    OD_size_t written = 0;
    if (count != io->stream.dataLength) {
        return count > io->stream.dataLength ? 0x06070012ul : 0x06070013ul;
    }
    switch (io->write(&io->stream, bytes, count, &written)) {
    case ODR_OK:
        return written == count ? 0ul : 0x08000000ul;
    case ODR_INVALID_VALUE:
        return 0x06090030ul;
    case ODR_VALUE_HIGH:
        return 0x06090031ul;
    case ODR_VALUE_LOW:
        return 0x06090032ul;
    default:
        return 0x08000000ul;
    }
}

static void answer_writes(void)
{
    unsigned index;
    unsigned sub;
    char text[64];
    while (scanf("%x %x %63s", &index, &sub, text) == 3) {
        OD_IO_t io;
        uint8_t bytes[32];
        OD_size_t count = 0;
        for (const char *at = text; at[0] != '\0' && at[1] != '\0'; at += 2) {
            unsigned byte;
            sscanf(at, "%2x", &byte);
            bytes[count++] = (uint8_t)byte;
        }
        if (OD_getSub(OD_find(OD, (uint16_t)index), (uint8_t)sub, &io, false) != ODR_OK) {
            printf("missing\n");
            continue;
        }
        printf("%08lX\n", write(&io, bytes, count));
    }
}

int main(int argc, char **argv)
{
    const uint8_t node_id = (uint8_t)(argc == 3 ? atoi(argv[2]) : 0);
    const OD_entry_t *last = &OD->list[OD->size];
    for (uint16_t i = 1; i < OD->size; i++) {
        if (OD->list[i - 1].index >= OD->list[i].index) {
            return 2;
        }
    }
    if (node_id == 0 || last->index != 0 || last->odObject != NULL) {
        return 3;
    }
    start(node_id);
    if (strcmp(argv[1], "dump") == 0) {
        dump();
        return 0;
    }
#ifdef WITH_HOOKS
    OD_initHooks(buffer);
#endif
#ifdef WITH_LIMITS
    OD_initLimits(node_id);
#endif
    answer_writes();
    return 0;
}
