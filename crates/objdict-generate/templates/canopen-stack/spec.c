{# CanOpenStackView<'_>::specification #}
/*
 * {{ head.made_by }}.
 *
 * A template for the node specification: copy it into the application and complete the marked parts. This file is overwritten
 * with the dictionary.
 */
#include "{{ head.stem }}.h"

/* FILL IN: the node-ID, if it comes from a switch or from LSS. */
#define APP_NODE_ID {{ dictionary.node_id.unwrap_or(1) }}u

/* FILL IN: the baud rate in bit/s. */
#define APP_BAUDRATE {{ self.baud_rate() }}u

/* Heartbeat, SYNC and LSS, a timer per heartbeat consumer, two per TPDO. FILL IN: those of the application. */
#define APP_TMR_N {{ self.timers() }}u

/* FILL IN: ticks of the timer driver per second. */
#define APP_TICKS_PER_SECOND 1000u

/* FILL IN: the drivers for CAN, timer and non-volatile memory. */
extern struct CO_IF_DRV_T AppDriver;
{%- if self.has_emcy() %}

/* FILL IN: a row for each error of the application; its number is the argument of COEmcySet(). */
static CO_EMCY_TBL AppEmcyTbl[CO_EMCY_N] = {
    {.Reg = CO_EMCY_REG_GENERAL, .Code = CO_EMCY_CODE_GEN_ERR},
};
{%- endif %}

static CO_TMR_MEM AppTmrMem[APP_TMR_N];
static uint8_t AppSdoMem[CO_SSDO_N * CO_SDO_BUF_BYTE];

extern struct CO_NODE_SPEC_T AppSpec;
struct CO_NODE_SPEC_T AppSpec = {
    .NodeId = APP_NODE_ID,
    .Baudrate = APP_BAUDRATE,
    .Dict = (CO_OBJ *){{ head.lower }}_objects, /* not written: no row is direct and writable */
    .DictLen = {{ head.upper }}_LEN,
    .EmcyCode = {% if self.has_emcy() %}AppEmcyTbl{% else %}NULL{% endif %},
    .TmrMem = AppTmrMem,
    .TmrNum = APP_TMR_N,
    .TmrFreq = APP_TICKS_PER_SECOND,
    .Drv = &AppDriver,
    .SdoBuf = AppSdoMem,
};
