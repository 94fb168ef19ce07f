// Generated from templates/canopen-stack/spec.c by `cargo xtask templates`; do not edit.

#[allow(clippy::all, clippy::pedantic, reason = "generated")]
impl CanOpenStackView<'_> {
    pub(super) fn specification(&self) -> String {
        let mut out = String::new();
        put!(out, "/*
 * {}.
 *
 * A template for the node specification: copy it into the application and complete the marked parts. This file is overwritten
 * with the dictionary.
 */
#include \"{}.h\"

/* FILL IN: the node-ID, if it comes from a switch or from LSS. */
#define APP_NODE_ID {}u

/* FILL IN: the baud rate in bit/s. */
#define APP_BAUDRATE {}u

/* Heartbeat, SYNC and LSS, a timer per heartbeat consumer, two per TPDO. FILL IN: those of the application. */
#define APP_TMR_N {}u

/* FILL IN: ticks of the timer driver per second. */
#define APP_TICKS_PER_SECOND 1000u

/* FILL IN: the drivers for CAN, timer and non-volatile memory. */
extern struct CO_IF_DRV_T AppDriver;", self.head.made_by, self.head.stem, self.dictionary.node_id.unwrap_or(1), self.baud_rate(), self.timers());
        if self.has_emcy() {
            out.push_str("

/* FILL IN: a row for each error of the application; its number is the argument of COEmcySet(). */
static CO_EMCY_TBL AppEmcyTbl[CO_EMCY_N] = {
    {.Reg = CO_EMCY_REG_GENERAL, .Code = CO_EMCY_CODE_GEN_ERR},
};");
        }
        put!(out, "

static CO_TMR_MEM AppTmrMem[APP_TMR_N];
static uint8_t AppSdoMem[CO_SSDO_N * CO_SDO_BUF_BYTE];

extern struct CO_NODE_SPEC_T AppSpec;
struct CO_NODE_SPEC_T AppSpec = {{
    .NodeId = APP_NODE_ID,
    .Baudrate = APP_BAUDRATE,
    .Dict = (CO_OBJ *){}_objects, /* not written: no row is direct and writable */
    .DictLen = {}_LEN,
    .EmcyCode = ", self.head.lower, self.head.upper);
        if self.has_emcy() {
            out.push_str("AppEmcyTbl");
        }
        else {
            out.push_str("NULL");
        }
        out.push_str(",
    .TmrMem = AppTmrMem,
    .TmrNum = APP_TMR_N,
    .TmrFreq = APP_TICKS_PER_SECOND,
    .Drv = &AppDriver,
    .SdoBuf = AppSdoMem,
};");
        out
    }
}
