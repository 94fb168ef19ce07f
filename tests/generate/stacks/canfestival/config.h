/* What the configuration of CanFestival writes for a port. */
#ifndef CONFIG_H
#define CONFIG_H

#define MAX_CAN_BUS_ID 1
#define SDO_MAX_LENGTH_TRANSFER 65536
#define SDO_MAX_SIMULTANEOUS_TRANSFERS 1
#define SDO_BLOCK_SIZE 16
#define SDO_TIMEOUT_MS 3000
#define NMT_MAX_NODE_ID 1
#define EMCY_MAX_ERRORS 1
#define MAX_NB_TIMER 512
#define REPEAT_SDO_MAX_SIMULTANEOUS_TRANSFERS_TIMES(repeat) repeat
#define REPEAT_NMT_MAX_NODE_ID_TIMES(repeat) repeat
#define REPEAT_EMCY_MAX_ERRORS_TIMES(repeat) repeat

#endif
