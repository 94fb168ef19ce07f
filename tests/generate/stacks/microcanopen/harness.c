/*
 * Prints what an SDO client reads of a node with MicroCANopen: by a linear search, the replies first. With an argument:
 * the calls that initialise PDOs.
 */
#include "device_pimg.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    unsigned index;
    unsigned sub;
    unsigned size;
    int read;
    int write;
    const UNSIGNED8 *value;
} found_t;

void MCO_InitTPDO(UNSIGNED8 number, UNSIGNED16 can_id, UNSIGNED16 event, UNSIGNED16 inhibit, UNSIGNED8 length, UNSIGNED16 offset)
{
    printf("TPDO %u: 0x%03X, %u ms, %u ms, %u bytes at %u\n", number, can_id, event, inhibit, length, offset);
}

void MCO_InitRPDO(UNSIGNED8 number, UNSIGNED16 can_id, UNSIGNED8 length, UNSIGNED16 offset)
{
    printf("RPDO %u: 0x%03X, %u bytes at %u\n", number, can_id, length, offset);
}

/* The row of a reply; the end mark has index FFFFh. */
static found_t reply(const UNSIGNED8 *row)
{
    found_t found;
    found.index = (unsigned)(row[1] | (row[2] << 8));
    found.sub = row[3];
    found.size = 4u - ((row[0] >> 2) & 3u);
    found.read = 1;
    found.write = 0;
    found.value = row + 4;
    return found;
}

static found_t process(const OD_PROCESS_DATA_ENTRY *row)
{
    found_t found;
    found.index = (unsigned)(row->idx_lo | (row->idx_hi << 8));
    found.sub = row->subidx;
    found.size = row->len & 0x07u;
    found.read = (row->len & ODRD) != 0;
    found.write = (row->len & ODWR) != 0;
    found.value = gProcImg + (row->off_lo | (row->off_hi << 8));
    return found;
}

/* The first row with an address. */
static found_t search(unsigned index, unsigned sub)
{
    const UNSIGNED8 *row = SDOResponseTable;
    const OD_PROCESS_DATA_ENTRY *entry = gODProcTable;
    while (reply(row).index != 0xFFFFu) {
        if (reply(row).index == index && reply(row).sub == sub) {
            return reply(row);
        }
        row += 8;
    }
    while (process(entry).index != index || process(entry).sub != sub) {
        entry++;
    }
    return process(entry);
}

static int by_address(const void *a, const void *b)
{
    const found_t *const left = a;
    const found_t *const right = b;
    const unsigned long one = ((unsigned long)left->index << 8) | left->sub;
    const unsigned long other = ((unsigned long)right->index << 8) | right->sub;
    return (one > other) - (one < other);
}

int main(int count, char **arguments)
{
    static found_t all[100000];
    size_t rows = 0u;
    size_t at;
    const UNSIGNED8 *row;
    const OD_PROCESS_DATA_ENTRY *entry;
    (void)arguments;
    if (count > 1) {
        od_init_pdos();
        return 0;
    }
    od_init_image();
    for (row = SDOResponseTable; reply(row).index != 0xFFFFu; row += 8) {
        all[rows++] = reply(row);
    }
    for (entry = gODProcTable; process(entry).index != 0xFFFFu; entry++) {
        if (process(entry).value + process(entry).size > gProcImg + PROCIMG_SIZE) {
            puts("an entry behind the process image");
        }
        all[rows++] = process(entry);
    }
    qsort(all, rows, sizeof all[0], by_address);
    for (at = 0u; at < rows; at++) {
        const found_t *const found = &all[at];
        unsigned byte;
        if (search(found->index, found->sub).value != found->value) {
            puts("a row that is not found");
        }
        printf("%04X %02X - %u %c%c-- ", found->index, found->sub, found->size, found->read ? 'r' : '-',
               found->write ? 'w' : '-');
        for (byte = 0u; byte < found->size; byte++) {
            printf("%02X", found->value[byte]);
        }
        putchar('\n');
    }
    return 0;
}
