/* Two object dictionaries in one program, each with its stack configuration. */
#include "301/CO_ODinterface.h"

typedef struct {
    uint8_t CNT_NMT, CNT_HB_CONS, CNT_ARR_1016, CNT_EM, CNT_ARR_1003, CNT_SDO_SRV, CNT_SDO_CLI, CNT_TIME, CNT_SYNC, CNT_LEDS,
        CNT_GFC, CNT_SRDO, CNT_LSS_SLV, CNT_LSS_MST, CNT_GTWA;
    uint16_t CNT_RPDO, CNT_TPDO, CNT_TRACE;
    OD_entry_t *ENTRY_H1017, *ENTRY_H1016, *ENTRY_H100C, *ENTRY_H100D, *ENTRY_H1014, *ENTRY_H1015, *ENTRY_H1003, *ENTRY_H1200,
        *ENTRY_H1280, *ENTRY_H1012, *ENTRY_H1005, *ENTRY_H1006, *ENTRY_H1007, *ENTRY_H1019, *ENTRY_H1400, *ENTRY_H1600,
        *ENTRY_H1800, *ENTRY_H1A00, *ENTRY_H1300, *ENTRY_H1301, *ENTRY_H1381, *ENTRY_H13FE, *ENTRY_H13FF;
    const OD_entry_t *ENTRY_H1001;
} CO_config_t;

#include "motor.h"
#include "OD.h"

#include <string.h>

/* The minimal part of the stack that the files need. */
ODR_t OD_readOriginal(OD_stream_t *stream, void *buf, OD_size_t count, OD_size_t *countRead)
{
    (void)stream;
    (void)buf;
    (void)count;
    (void)countRead;
    return ODR_OK;
}

ODR_t OD_writeOriginal(OD_stream_t *stream, const void *buf, OD_size_t count, OD_size_t *countWritten)
{
    (void)stream;
    (void)buf;
    (void)count;
    (void)countWritten;
    return ODR_OK;
}

int main(void)
{
    CO_config_t motor;
    CO_config_t odd;
    memset(&motor, 0xFF, sizeof motor);
    memset(&odd, 0xFF, sizeof odd);
    MOTOR_INIT_CONFIG(motor);
    OD_INIT_CONFIG(odd);
    MOTOR_initLimits(5);
    OD_initLimits(5);
    if (motor.CNT_NMT != 1 || motor.CNT_TPDO != MOTOR_CNT_TPDO || motor.ENTRY_H1A00->index != 0x1A00) {
        return 1;
    }
    if (MOTOR_ENTRY_H1000->index != 0x1000 || motor.CNT_TRACE != 0 || motor.ENTRY_H100C != NULL) {
        return 2;
    }
    return odd.CNT_NMT == 0 && odd.ENTRY_H1A00 == NULL && odd.CNT_ARR_1003 == 8 && odd.CNT_SDO_SRV == 1 ? 0 : 3;
}
