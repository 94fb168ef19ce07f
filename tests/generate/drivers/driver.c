/* Executes operations from standard input on the table of od.h, see driver.rs. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "od.h"

static char line[400000];
static uint8_t buffer[0x10000];
static od_data_t data;

static void print_bytes(const uint8_t *bytes, size_t length)
{
    size_t at;
    for (at = 0; at < length; at++) {
        printf("%02X", (unsigned int)bytes[at]);
    }
    printf(length == 0 ? "-" : "");
}

static void print_limit(bool exists, uint64_t limit)
{
    if (exists) {
        printf(" %llX", (unsigned long long)limit);
    } else {
        printf(" -");
    }
}

static void print_table(void)
{
    size_t at;
    for (at = 0; at < OD_ENTRY_COUNT; at++) {
        const od_entry_t *entry = &od_entries[at];
        size_t length = 0;
        const uint8_t *bytes = od_default(entry, &length);
        uint64_t limit = 0;
        bool exists;
        const uint16_t flags = od_flags(entry);
        if (od_find(od_index(entry), entry->sub) != entry) {
            printf("lost ");
        }
        printf("%04X %02X %02X ", (unsigned int)od_index(entry), (unsigned int)entry->sub, (unsigned int)od_data_type(entry));
        printf("%d%d%d%d%d ", (flags & OD_READ) != 0, (flags & OD_WRITE) != 0,
               (flags & OD_TPDO) != 0, (flags & OD_RPDO) != 0, (flags & OD_NODE_ID_DEFAULT) != 0);
        printf("%lu ", (unsigned long)od_size(entry));
        print_bytes(bytes, length);
        exists = od_low_limit(entry, data.node_id, &limit);
        print_limit(exists, limit);
        exists = od_high_limit(entry, data.node_id, &limit);
        print_limit(exists, limit);
        printf("\n");
    }
}

static size_t parse_bytes(const char *text)
{
    size_t length = 0;
    while (text[0] != '-' && text[0] != '\0' && text[0] != '\n') {
        char pair[3] = {text[0], text[1], '\0'};
        buffer[length++] = (uint8_t)strtoul(pair, NULL, 16);
        text += 2;
    }
    return length;
}

int main(void)
{
    od_init(&data, 1);
    while (fgets(line, (int)sizeof line, stdin) != NULL) {
        char *word = line + 1;
        const uint16_t index = (uint16_t)strtoul(word, &word, 16);
        const uint8_t sub = (uint8_t)strtoul(word, &word, 16);
        size_t length = 0;
        uint32_t answer;
        if (line[0] == 'i') {
            od_init(&data, (uint8_t)index);
            continue;
        }
        if (line[0] == 't') {
            print_table();
            continue;
        }
        if (line[0] == 'r') {
            answer = od_read(&data, index, sub, buffer, (size_t)strtoul(word, NULL, 16), &length);
        } else {
            answer = od_write(&data, index, sub, buffer, parse_bytes(word + 1));
        }
        if (answer == OD_OK) {
            printf("ok ");
            print_bytes(buffer, length);
            printf("\n");
        } else {
            printf("abort %08lX\n", (unsigned long)answer);
        }
    }
    return 0;
}
