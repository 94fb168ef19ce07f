/*
 * Prints every entry, found by the scan function and read as the stack reads it, and writes it back. With an argument, writes the
 * values of the input instead: lines of index, sub-index and bytes; prints the results. Without the header of the dictionary,
 * whose variables have any names.
 */
#include "data.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

extern CO_Data od_Data;
UNS32 od_valueRangeTest(UNS8 typeValue, void *value);
#ifdef OD_CALLBACK_IN_ROW
const indextable *od_scanIndexOD(CO_Data *d, UNS16 wIndex, UNS32 *errorCode);
#else
const indextable *od_scanIndexOD(UNS16 wIndex, UNS32 *errorCode, ODCallback_t **callbacks);
#endif

enum { LONGEST = 0x20000 };
static UNS8 value[LONGEST];

static const indextable *find(UNS16 index, UNS32 *error)
{
#ifdef OD_CALLBACK_IN_ROW
    return od_scanIndexOD(&od_Data, index, error);
#else
    ODCallback_t *callbacks;
    return od_scanIndexOD(index, error, &callbacks);
#endif
}

static UNS32 upload(const subindex *row)
{
    const UNS8 *const object = row->pObject;
    UNS32 length = 0u;
    if (row->bDataType != visible_string) {
        memcpy(value, object, row->size);
        return row->size;
    }
    while (object[length] != 0u && length < row->size) {
        value[length] = object[length];
        length++;
    }
    if (length < row->size) {
        ((UNS8 *)row->pObject)[length] = 0u;
    }
    return length;
}

static UNS32 download(const subindex *row, UNS8 *bytes, UNS32 size)
{
    UNS32 error;
    if (size != row->size && !(row->bDataType == visible_string && size < row->size)) {
        return 0x06070010u;
    }
    error = od_valueRangeTest(row->bDataType, bytes);
    if (error == 0u) {
        memcpy(row->pObject, bytes, size);
    }
    return error;
}

static void print(const indextable *table, UNS8 sub)
{
    const subindex *const row = &table->pSubindex[sub];
    const unsigned access = row->bAccessType & 3u;
    const UNS32 length = upload(row);
    UNS32 at;
    if (access != RO && row->size > 0u) {
        static UNS8 same[LONGEST];
        memcpy(same, value, length);
        (void)download(row, same, length);
        if (upload(row) != length || memcmp(value, same, length) != 0) {
            printf("%04X %02X differs after a write\n", table->index, sub);
        }
    }
    printf("%04X %02X ", table->index, sub);
    if (row->bDataType < 0x24u) {
        printf("%02X", row->bDataType);
    } else {
        putchar('-');
    }
    printf(" %lu %c%c-- ", (unsigned long)row->size, access == WO ? '-' : 'r', access == RO ? '-' : 'w');
    for (at = 0u; at < length; at++) {
        printf("%02X", value[at]);
    }
    puts(length > 0u ? "" : "-");
}

static void write_lines(void)
{
    unsigned index, sub;
    static char hex[2 * LONGEST];
    while (scanf("%x %x %s", &index, &sub, hex) == 3) {
        UNS32 error;
        const indextable *const table = find((UNS16)index, &error);
        const UNS32 size = (UNS32)(strlen(hex) / 2u);
        UNS32 at;
        for (at = 0u; at < size; at++) {
            const char digits[3] = {hex[2u * at], hex[2u * at + 1u], 0};
            value[at] = (UNS8)strtoul(digits, NULL, 16);
        }
        printf("%08lX\n", (unsigned long)download(&table->pSubindex[sub], value, size));
    }
}

int main(int count, char **arguments)
{
    unsigned long index;
    (void)arguments;
    if (count > 1) {
        write_lines();
        return 0;
    }
    for (index = 0u; index <= 0xFFFFu; index++) {
        UNS32 error;
        const indextable *const table = find((UNS16)index, &error);
        unsigned sub;
        if (table == NULL) {
            continue;
        }
        for (sub = 0u; sub < table->bSubCount; sub++) {
            if ((table->pSubindex[sub].bAccessType & 3u) != (RO | WO)) {
                print(table, (UNS8)sub);
            }
        }
    }
    return 0;
}
