//! One table for each stack, read from its sources: CANopenNode 4 of July 2026 and 1.3, canopen-stack 4.4, Lely core 2.4, CanFestival 3.

use super::pdos::{CauseRow, StackMapping};
use super::{Consumers, DemandRow, PdoCause, Stack};
use crate::model::{DataType, Device, MappedObject, PdoKind};

const DISABLED: &str = "will be disabled by the stack";
const MEMORY: &str = "will make the stack access memory beyond its mapping";
const ON_NMT: &str = "will use the CAN-ID of NMT";

const fn both(cause: PdoCause, effect: &'static str) -> CauseRow {
    CauseRow { cause, kind: None, effect }
}

const fn one(cause: PdoCause, kind: PdoKind, effect: &'static str) -> CauseRow {
    CauseRow { cause, kind: Some(kind), effect }
}

/// `PDO_initMapping`, `CO_RPDO_init`, `CO_TPDO_init`, `CO_HBconsumer_initEntry`, `CO_SDOserver_init`, `CO_SDOclient_init`.
pub(crate) const CANOPENNODE: Stack = Stack {
    mapping: StackMapping { reads_all: true, least: 0, most: 8, is_dummy: |_, _, mapped| mapped.sub == 0 },
    pdos: &[
        both(PdoCause::TooMany, MEMORY),
        both(PdoCause::Missing, DISABLED),
        both(PdoCause::Dummy, DISABLED),
        both(PdoCause::Direction, DISABLED),
        both(PdoCause::NotMappable, DISABLED),
        both(
            PdoCause::Bits,
            "will be disabled by the stack unless it is configured for mapping of single bits",
        ),
        both(PdoCause::Short, DISABLED),
        both(PdoCause::TooLong, DISABLED),
        both(PdoCause::Empty, DISABLED),
        both(PdoCause::NoCanId, DISABLED),
        both(PdoCause::Extended, "will use the lower 11 bits of the CAN-ID in the stack"),
    ],
    consumers: Some(Consumers {
        from_last: false,
        is_counted: false,
        repeated: Some("the stack rejects the heartbeat consumer"),
    }),
    sdo: &[
        DemandRow::Highest { first: 0x1201, last: 0x127F, allowed: &[2, 3], stops: true },
        DemandRow::Highest { first: 0x1280, last: 0x12FF, allowed: &[3], stops: false },
    ],
};

/// `CO_PDOfindMap`, `CO_RPDOconfigCom`, `CO_TPDOconfigCom`, `CO_TPDO_init`, `CO_SDOclient_init`.
pub(crate) const CANOPENNODE_V1: Stack = Stack {
    mapping: StackMapping {
        reads_all: false,
        least: 0,
        most: 8,
        is_dummy: |_, _, mapped| mapped.sub == 0 && dummy_bits(mapped.index) >= mapped.bits,
    },
    pdos: &[
        both(PdoCause::NoCobId, "will not be valid in the tables"),
        both(PdoCause::TooMany, MEMORY),
        both(PdoCause::NoMapping, DISABLED),
        both(PdoCause::Bits, DISABLED),
        both(PdoCause::TooLong, DISABLED),
        both(PdoCause::Dummy, DISABLED),
        both(PdoCause::Missing, DISABLED),
        both(PdoCause::Direction, DISABLED),
        both(PdoCause::NotMappable, DISABLED),
        both(PdoCause::Short, DISABLED),
        both(PdoCause::Empty, DISABLED),
        both(PdoCause::Extended, DISABLED),
        both(PdoCause::NoCanId, DISABLED),
        one(PdoCause::Reserved, PdoKind::Tpdo, DISABLED),
        one(PdoCause::SyncStart, PdoKind::Tpdo, DISABLED),
    ],
    consumers: None,
    sdo: &[DemandRow::Highest { first: 0x1280, last: 0x12FF, allowed: &[3], stops: true }],
};

const IGNORED: &str = "will be received without effect by the stack";
const EMPTY: &str = "will not be transmitted by the stack, or empty if the application triggers it";

/// `COTPdoReset`, `CORPdoReset`, `COTPdoGetMap`, `CORPdoGetMap`, `COTNmtHbConsInit`, `COSdoEnable`.
pub(crate) const CANOPEN_STACK: Stack = Stack {
    mapping: StackMapping {
        reads_all: false,
        least: 0,
        most: 8,
        is_dummy: |_, kind, mapped| kind == PdoKind::Rpdo && (2..=7).contains(&mapped.index),
    },
    pdos: &[
        both(PdoCause::Number, "will keep the stack from starting"),
        both(PdoCause::NoTransmissionType, DISABLED),
        both(PdoCause::NoCobId, DISABLED),
        one(PdoCause::RtrAllowed, PdoKind::Tpdo, DISABLED),
        both(PdoCause::Extended, DISABLED),
        both(PdoCause::NoCanId, ON_NMT),
        both(PdoCause::Overrun, MEMORY),
        one(PdoCause::NoMapping, PdoKind::Rpdo, IGNORED),
        one(PdoCause::TooMany, PdoKind::Rpdo, IGNORED),
        one(PdoCause::NoSlot, PdoKind::Rpdo, IGNORED),
        one(PdoCause::TooLong, PdoKind::Rpdo, IGNORED),
        one(PdoCause::Dummy, PdoKind::Rpdo, IGNORED),
        one(PdoCause::Missing, PdoKind::Rpdo, IGNORED),
        one(PdoCause::NoMapping, PdoKind::Tpdo, EMPTY),
        one(PdoCause::TooMany, PdoKind::Tpdo, EMPTY),
        one(PdoCause::NoSlot, PdoKind::Tpdo, EMPTY),
        one(PdoCause::TooLong, PdoKind::Tpdo, EMPTY),
        one(PdoCause::Dummy, PdoKind::Tpdo, EMPTY),
        one(PdoCause::Missing, PdoKind::Tpdo, EMPTY),
        both(PdoCause::Bits, "will be misread by the stack"),
    ],
    consumers: Some(Consumers {
        from_last: true,
        is_counted: true,
        repeated: Some("the stack does not monitor the nodes of this and of all entries before"),
    }),
    sdo: &[DemandRow::DefaultServer],
};

const REJECTED: &str = "will be rejected by the stack whenever it is received";
const NOT_SENT: &str = "will not be transmitted by the stack";

/// `co_pdo_dn`, `co_pdo_up`, `co_dev_chk_rpdo`, `co_dev_chk_tpdo`.
pub(crate) const LELY: Stack = Stack {
    mapping: StackMapping {
        reads_all: false,
        least: 0,
        most: 64,
        is_dummy: |device, kind, mapped| {
            mapped.is_unused() || kind == PdoKind::Rpdo && mapped.sub == 0 && is_enabled(device, mapped)
        },
    },
    pdos: &[
        one(PdoCause::Reserved, PdoKind::Rpdo, IGNORED),
        one(PdoCause::TooLong, PdoKind::Rpdo, REJECTED),
        one(PdoCause::Dummy, PdoKind::Rpdo, REJECTED),
        one(PdoCause::Missing, PdoKind::Rpdo, REJECTED),
        one(PdoCause::Direction, PdoKind::Rpdo, REJECTED),
        one(PdoCause::NotMappable, PdoKind::Rpdo, REJECTED),
        one(PdoCause::Size, PdoKind::Rpdo, REJECTED),
        one(PdoCause::NoTrigger, PdoKind::Tpdo, NOT_SENT),
        one(PdoCause::TooLong, PdoKind::Tpdo, NOT_SENT),
        one(PdoCause::Dummy, PdoKind::Tpdo, NOT_SENT),
        one(PdoCause::Missing, PdoKind::Tpdo, NOT_SENT),
        one(PdoCause::Direction, PdoKind::Tpdo, NOT_SENT),
        one(PdoCause::NotMappable, PdoKind::Tpdo, NOT_SENT),
    ],
    consumers: None,
    sdo: &[],
};

/// `proceedPDO`, `buildPDO`, `_sendPDOevent`, `canDispatch`, `proceedSDO`, `heartbeatInit`.
pub(crate) const CANFESTIVAL: Stack = Stack {
    mapping: StackMapping { reads_all: false, least: 1, most: 64, is_dummy: |_, _, mapped| mapped.bits == 0 },
    pdos: &[
        one(PdoCause::NotDispatched, PdoKind::Rpdo, IGNORED),
        one(PdoCause::Taken, PdoKind::Rpdo, IGNORED),
        one(PdoCause::Dummy, PdoKind::Rpdo, REJECTED),
        one(PdoCause::Missing, PdoKind::Rpdo, REJECTED),
        one(PdoCause::Length, PdoKind::Rpdo, REJECTED),
        one(PdoCause::Constant, PdoKind::Rpdo, "will make the stack write to constants"),
        one(PdoCause::NoTrigger, PdoKind::Tpdo, NOT_SENT),
        one(PdoCause::Dummy, PdoKind::Tpdo, NOT_SENT),
        one(PdoCause::Missing, PdoKind::Tpdo, NOT_SENT),
        one(PdoCause::Length, PdoKind::Tpdo, NOT_SENT),
        one(PdoCause::OnNmt, PdoKind::Tpdo, ON_NMT),
        both(PdoCause::Extended, "will use the lower 11 bits of the CAN-ID in the stack"),
        both(PdoCause::TooLong, "will lose data beyond 8 bytes in the stack"),
    ],
    consumers: Some(Consumers { from_last: false, is_counted: true, repeated: None }),
    sdo: &[DemandRow::DefaultServer],
};

/// The bits that CANopenNode 1.3 has for a dummy entry.
const fn dummy_bits(index: u16) -> u8 {
    match index {
        2 | 5 => 8,
        3 | 6 => 16,
        4 | 7 => 32,
        _ => 0,
    }
}

/// Whether `[DummyUsage]` enables a data type.
fn is_enabled(device: &Device, mapped: MappedObject) -> bool {
    let usage = device.dummy_usage.as_ref();
    usage.is_some_and(|usage| usage.types.get(&DataType(mapped.index)) == Some(&true))
}
