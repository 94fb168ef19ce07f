/*
 * Prints every entry of an array of structures: where it is, what it is, its value after start and its limits.
 */
#include "od.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int is(const od_entry_t *entry, uint8_t flag)
{
    return (entry->flags & flag) != 0u;
}

/* The bytes of a number, little-endian, including the node-ID if it has to be added. */
static void number(const od_entry_t *entry, const void *from, uint8_t node_id)
{
    uint64_t value = 0u;
    uint16_t at;
    if (entry->data_type == OD_TIME_OF_DAY || entry->data_type == OD_TIME_DIFFERENCE) {
        uint32_t milliseconds;
        uint16_t days;
        memcpy(&milliseconds, from, sizeof milliseconds);
        memcpy(&days, (const uint8_t *)from + sizeof milliseconds, sizeof days);
        value = milliseconds | ((uint64_t)days << 32);
    } else if (entry->size == 1u) {
        value = *(const uint8_t *)from;
    } else if (entry->size == 2u) {
        uint16_t word;
        memcpy(&word, from, sizeof word);
        value = word;
    } else if (entry->size <= 4u) {
        uint32_t word;
        memcpy(&word, from, sizeof word);
        value = word;
    } else {
        memcpy(&value, from, sizeof value);
    }
    value += node_id;
    for (at = 0u; at < entry->size; at++) {
        printf("%02X", (unsigned)((value >> (8u * at)) & 0xFFu));
    }
}

static void bytes(const uint8_t *from, size_t length)
{
    size_t at;
    for (at = 0u; at < length; at++) {
        printf("%02X", from[at]);
    }
    if (length == 0u) {
        putchar('-');
    }
}

static void value(const od_entry_t *entry, uint8_t node_id)
{
    const int text = entry->data_type >= OD_VISIBLE_STRING && entry->data_type <= OD_UNICODE_STRING;
    if (entry->data == NULL) {
        putchar('-');
    } else if (entry->data_type == OD_BLOCK) {
        bytes(entry->data, entry->size);
    } else if (text || entry->data_type == OD_DOMAIN) {
        uint16_t length;
        memcpy(&length, entry->data, sizeof length);
        bytes((const uint8_t *)entry->data + sizeof length, length);
    } else {
        const int constant = entry->data == entry->def;
        number(entry, entry->data, constant && is(entry, OD_NODE_ID_DEFAULT) ? node_id : 0u);
    }
}

static void limit(const od_entry_t *entry, const void *from, uint8_t flag, uint8_t node_id)
{
    putchar(' ');
    if (from == NULL) {
        putchar('-');
    } else {
        number(entry, from, is(entry, flag) ? node_id : 0u);
    }
}

int main(int count, char **arguments)
{
    const uint8_t node_id = (uint8_t)(count > 1 ? atoi(arguments[1]) : 5);
    size_t at;
    od_init(node_id);
    for (at = 0u; at < OD_ENTRY_COUNT; at++) {
        const od_entry_t *const entry = &od_entries[at];
        const uint16_t next = (uint16_t)(entry->index + 1u);
        if (od_find(entry->index, entry->sub) != entry) {
            printf("%04X %02X is not found\n", entry->index, entry->sub);
        }
        if (at + 1u < OD_ENTRY_COUNT && entry[1].index > next && od_find(next, 0u) != NULL) {
            printf("%04X is found\n", next);
        }
        printf("%04X %02X %02X %u %c%c%c%c ", entry->index, entry->sub, entry->data_type, entry->size,
               is(entry, OD_READ) ? 'r' : '-', is(entry, OD_WRITE) ? 'w' : '-', is(entry, OD_TPDO) ? 't' : '-',
               is(entry, OD_RPDO) ? 'p' : '-');
        value(entry, node_id);
        if (count > 2) {
            limit(entry, entry->low, OD_LOW_NODE_ID, node_id);
            limit(entry, entry->high, OD_HIGH_NODE_ID, node_id);
        }
        putchar('\n');
    }
    return 0;
}
