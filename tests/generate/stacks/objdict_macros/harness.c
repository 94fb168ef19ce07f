/* Prints every entry of a table of macros; with an argument, the mapping. */
#include "objdict.h"

#include <stdio.h>

#if NUM_OF_RPDOS + NUM_OF_TPDOS > 0
static void print(const char *kind, const PDO_MAP *maps, unsigned count)
{
    unsigned at;
    for (at = 0u; at < count; at++) {
        unsigned slot;
        printf("%s %u:", kind, at + 1u);
        for (slot = 0u; slot < maps[at].count; slot++) {
            const MAP_OBJ *const map = &maps[at].entries[slot];
            const OBJ_ENTRY *entry = gObjDict;
            while (entry < gObjDict + NUM_OF_OBJ_ENTRIES && (entry->index != map->index || entry->sub != map->sub)) {
                entry++;
            }
            if (entry == gObjDict + NUM_OF_OBJ_ENTRIES ? map->address != NULL : map->address != entry->address) {
                printf(" elsewhere");
            }
            printf(" %04X.%02X.%u", map->index, map->sub, map->bits);
        }
        putchar('\n');
    }
}
#endif

int main(int count, char **arguments)
{
    const OBJ_ENTRY *entry;
    (void)arguments;
    if (count > 1) {
#if NUM_OF_RPDOS > 0
        print("RPDO", gRpdoMap, NUM_OF_RPDOS);
#endif
#if NUM_OF_TPDOS > 0
        print("TPDO", gTpdoMap, NUM_OF_TPDOS);
#endif
        return 0;
    }
    for (entry = gObjDict; entry < gObjDict + NUM_OF_OBJ_ENTRIES; entry++) {
        const uint8_t *const value = entry->address;
        const int access = entry->access;
        uint32_t at;
        printf("%04X %02X - %lu %c%c%c%c ", entry->index, entry->sub, (unsigned long)entry->length,
               access == WO || access == WOMAP ? '-' : 'r', access == RO || access == ROMAP ? '-' : 'w',
               access == ROMAP || access == RWRMAP ? 't' : '-', access == WOMAP || access == RWWMAP ? 'p' : '-');
        for (at = 0u; at < entry->length; at++) {
            printf("%02X", value[at]);
        }
        puts(entry->length > 0u ? "" : "-");
    }
    return 0;
}
