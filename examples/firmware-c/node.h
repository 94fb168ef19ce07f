/*
 * The node: an SDO server for expedited transfers and a TPDO, both of the generated dictionary.
 *
 * There is no driver here: frames come as bytes and go as bytes, so that a test can be the bus.
 */
#ifndef NODE_H
#define NODE_H

#include <stdbool.h>
#include <stdint.h>

#include "od.h"
#include "od_pdo.h"

/* The sensor as a CANopen node. The application reads and writes the members of the dictionary. */
typedef struct {
    od_data_t data;
} node_t;

/* The node after reset. */
void node_init(node_t *node, uint8_t node_id);

/* Takes a measurement: tenths of a degree Celsius and tenths of a percent. */
void node_measure(node_t *node, int16_t temperature, uint16_t humidity);

/* The TPDO as it would go out now; false while its COB-ID says that it does not exist. */
bool node_tpdo1(const node_t *node, uint16_t *can_id, uint8_t frame[OD_TPDO1_LENGTH]);

/* The answer to the request of an SDO client; false for an abort, which has none. */
bool node_answer(node_t *node, const uint8_t request[8], uint8_t answer[8]);

#endif
