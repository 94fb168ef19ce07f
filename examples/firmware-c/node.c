#include "node.h"

#include <string.h>

/* the command specifier is none that this server knows */
#define UNKNOWN_COMMAND 0x05040001u

/* the COB-ID is not in use */
#define INVALID 0x80000000u

void node_init(node_t *node, uint8_t node_id)
{
    od_init(&node->data, node_id);
}

void node_measure(node_t *node, int16_t temperature, uint16_t humidity)
{
    od_data_t *data = &node->data;

    data->climate_temperature = temperature;
    data->climate_humidity = humidity;
    data->contacts_heater = temperature < data->alarm_limits_lowest_temperature;
    data->contacts_alarm = data->contacts_heater || temperature > data->alarm_limits_highest_temperature;
}

bool node_tpdo1(const node_t *node, uint16_t *can_id, uint8_t frame[OD_TPDO1_LENGTH])
{
    const uint32_t cob_id = node->data.tpdo_1_cob_id;
    od_tpdo1_t pdo;

    if ((cob_id & INVALID) != 0u) {
        return false;
    }
    od_tpdo1_load(&node->data, &pdo);
    od_tpdo1_pack(&pdo, frame);
    *can_id = (uint16_t)(cob_id & 0x7FFu);
    return true;
}

/* The client writes: bit 1 says that the data are in the frame, bit 0 that the frame says how many they are. */
static uint32_t download(node_t *node, uint16_t index, uint8_t sub, const uint8_t request[8])
{
    const od_entry_t *entry = od_find(index, sub);
    size_t length = 4u;

    switch (request[0] & 3u) {
    case 3u:
        length = 4u - ((request[0] >> 2) & 3u);
        break;
    case 2u:
        if (entry != NULL && od_size(entry) < length) {
            length = od_size(entry);
        }
        break;
    default:
        return UNKNOWN_COMMAND;
    }
    return od_write(&node->data, index, sub, &request[4], length);
}

bool node_answer(node_t *node, const uint8_t request[8], uint8_t answer[8])
{
    const uint16_t index = (uint16_t)(request[1] | ((uint16_t)request[2] << 8));
    const uint8_t sub = request[3];
    uint32_t abort_code = UNKNOWN_COMMAND;
    size_t length = 0;
    unsigned at;

    memset(answer, 0, 8);
    memcpy(&answer[1], &request[1], 3);
    switch (request[0] >> 5) {
    case 1:
        abort_code = download(node, index, sub, request);
        answer[0] = 0x60u;
        break;
    case 2:
        /* a value of more than four bytes needs a server for segments */
        abort_code = od_read(&node->data, index, sub, &answer[4], 4u, &length);
        answer[0] = (uint8_t)(0x43u | ((4u - length) << 2));
        break;
    case 4:
        return false;
    default:
        break;
    }
    if (abort_code != OD_OK) {
        answer[0] = 0x80u;
        for (at = 0; at < 4u; at++) {
            answer[4u + at] = (uint8_t)(abort_code >> (8u * at));
        }
    }
    return true;
}
