//! One table for each stack, read from its sources: CANopenNode 4 of July 2026 and 1.3, canopen-stack 4.4, Lely core 2.4, CanFestival 3.

use super::Stack;
use super::consumers::Consumers;
use super::pdos::{Cause, Mapping, Row};
use super::sdo;
use crate::model::{DataType, Device, MappedObject, PdoKind};

const DISABLED: &str = "will be disabled by the stack";
const MEMORY: &str = "will make the stack access memory behind its mapping";
const ON_NMT: &str = "will use the CAN-ID of NMT";

const fn both(cause: Cause, effect: &'static str) -> Row {
    Row { cause, kind: None, effect }
}

const fn one(cause: Cause, kind: PdoKind, effect: &'static str) -> Row {
    Row { cause, kind: Some(kind), effect }
}

/// `PDO_initMapping`, `CO_RPDO_init`, `CO_TPDO_init`, `CO_HBconsumer_initEntry`, `CO_SDOserver_init`, `CO_SDOclient_init`.
pub(crate) const CANOPENNODE: Stack = Stack {
    mapping: Mapping { reads_all: true, least: 0, most: 8, is_dummy: |_, _, mapped| mapped.sub == 0 },
    pdos: &[
        both(Cause::TooMany, MEMORY),
        both(Cause::Missing, DISABLED),
        both(Cause::Dummy, DISABLED),
        both(Cause::Direction, DISABLED),
        both(Cause::NotMappable, DISABLED),
        both(Cause::Bits, "will be disabled by the stack unless it is configured for mapping of single bits"),
        both(Cause::Short, DISABLED),
        both(Cause::TooLong, DISABLED),
        both(Cause::Empty, DISABLED),
        both(Cause::NoCanId, DISABLED),
        both(Cause::Extended, "will use the lower 11 bits of the CAN-ID in the stack"),
    ],
    consumers: Some(Consumers {
        from_last: false,
        is_counted: false,
        repeated: Some("the stack rejects the heartbeat consumer"),
    }),
    sdo: &[
        sdo::Row::Highest { first: 0x1201, last: 0x127F, allowed: &[2, 3] },
        sdo::Row::Highest { first: 0x1280, last: 0x12FF, allowed: &[3] },
    ],
};

/// `CO_PDOfindMap`, `CO_RPDOconfigCom`, `CO_TPDOconfigCom`, `CO_TPDO_init`, `CO_SDOclient_init`.
pub(crate) const CANOPENNODE_V1: Stack = Stack {
    mapping: Mapping {
        reads_all: false,
        least: 0,
        most: 8,
        is_dummy: |_, _, mapped| mapped.sub == 0 && dummy_bits(mapped.index) >= mapped.bits,
    },
    pdos: &[
        both(Cause::NoCobId, "will not be valid in the tables"),
        both(Cause::TooMany, MEMORY),
        both(Cause::NoMapping, DISABLED),
        both(Cause::Bits, DISABLED),
        both(Cause::TooLong, DISABLED),
        both(Cause::Dummy, DISABLED),
        both(Cause::Missing, DISABLED),
        both(Cause::Direction, DISABLED),
        both(Cause::NotMappable, DISABLED),
        both(Cause::Short, DISABLED),
        both(Cause::Empty, DISABLED),
        both(Cause::Extended, DISABLED),
        both(Cause::NoCanId, DISABLED),
        one(Cause::Reserved, PdoKind::Tpdo, DISABLED),
        one(Cause::SyncStart, PdoKind::Tpdo, DISABLED),
    ],
    consumers: None,
    sdo: &[sdo::Row::Highest { first: 0x1280, last: 0x12FF, allowed: &[3] }],
};

const IGNORED: &str = "will be received without effect by the stack";
const EMPTY: &str = "will not be transmitted by the stack, or empty if the application triggers it";

/// `COTPdoReset`, `CORPdoReset`, `COTPdoGetMap`, `CORPdoGetMap`, `COTNmtHbConsInit`, `COSdoEnable`.
pub(crate) const CANOPEN_STACK: Stack = Stack {
    mapping: Mapping {
        reads_all: false,
        least: 0,
        most: 8,
        is_dummy: |_, kind, mapped| kind == PdoKind::Rpdo && (2..=7).contains(&mapped.index),
    },
    pdos: &[
        both(Cause::Number, "will keep the stack from starting"),
        both(Cause::NoTransmissionType, DISABLED),
        both(Cause::NoCobId, DISABLED),
        one(Cause::RtrAllowed, PdoKind::Tpdo, DISABLED),
        both(Cause::Extended, DISABLED),
        both(Cause::NoCanId, ON_NMT),
        both(Cause::Overrun, MEMORY),
        one(Cause::NoMapping, PdoKind::Rpdo, IGNORED),
        one(Cause::TooMany, PdoKind::Rpdo, IGNORED),
        one(Cause::NoSlot, PdoKind::Rpdo, IGNORED),
        one(Cause::TooLong, PdoKind::Rpdo, IGNORED),
        one(Cause::Dummy, PdoKind::Rpdo, IGNORED),
        one(Cause::Missing, PdoKind::Rpdo, IGNORED),
        one(Cause::NoMapping, PdoKind::Tpdo, EMPTY),
        one(Cause::TooMany, PdoKind::Tpdo, EMPTY),
        one(Cause::NoSlot, PdoKind::Tpdo, EMPTY),
        one(Cause::TooLong, PdoKind::Tpdo, EMPTY),
        one(Cause::Dummy, PdoKind::Tpdo, EMPTY),
        one(Cause::Missing, PdoKind::Tpdo, EMPTY),
        both(Cause::Bits, "will be misread by the stack"),
    ],
    consumers: Some(Consumers {
        from_last: true,
        is_counted: true,
        repeated: Some("the stack does not monitor the nodes of this and of all entries before"),
    }),
    sdo: &[sdo::Row::DefaultServer],
};

const REJECTED: &str = "will be rejected by the stack whenever it is received";
const NOT_SENT: &str = "will not be transmitted by the stack";

/// `co_pdo_dn`, `co_pdo_up`, `co_dev_chk_rpdo`, `co_dev_chk_tpdo`.
pub(crate) const LELY: Stack = Stack {
    mapping: Mapping {
        reads_all: false,
        least: 0,
        most: 64,
        is_dummy: |device, kind, mapped| {
            mapped.is_unused() || kind == PdoKind::Rpdo && mapped.sub == 0 && is_enabled(device, mapped)
        },
    },
    pdos: &[
        one(Cause::Reserved, PdoKind::Rpdo, IGNORED),
        one(Cause::TooLong, PdoKind::Rpdo, REJECTED),
        one(Cause::Dummy, PdoKind::Rpdo, REJECTED),
        one(Cause::Missing, PdoKind::Rpdo, REJECTED),
        one(Cause::Direction, PdoKind::Rpdo, REJECTED),
        one(Cause::NotMappable, PdoKind::Rpdo, REJECTED),
        one(Cause::Size, PdoKind::Rpdo, REJECTED),
        one(Cause::NoTrigger, PdoKind::Tpdo, NOT_SENT),
        one(Cause::TooLong, PdoKind::Tpdo, NOT_SENT),
        one(Cause::Dummy, PdoKind::Tpdo, NOT_SENT),
        one(Cause::Missing, PdoKind::Tpdo, NOT_SENT),
        one(Cause::Direction, PdoKind::Tpdo, NOT_SENT),
        one(Cause::NotMappable, PdoKind::Tpdo, NOT_SENT),
    ],
    consumers: None,
    sdo: &[],
};

/// `proceedPDO`, `buildPDO`, `_sendPDOevent`, `canDispatch`, `proceedSDO`, `heartbeatInit`.
pub(crate) const CANFESTIVAL: Stack = Stack {
    mapping: Mapping { reads_all: false, least: 1, most: 64, is_dummy: |_, _, mapped| mapped.bits == 0 },
    pdos: &[
        one(Cause::NotDispatched, PdoKind::Rpdo, IGNORED),
        one(Cause::Taken, PdoKind::Rpdo, IGNORED),
        one(Cause::Dummy, PdoKind::Rpdo, REJECTED),
        one(Cause::Missing, PdoKind::Rpdo, REJECTED),
        one(Cause::Length, PdoKind::Rpdo, REJECTED),
        one(Cause::Constant, PdoKind::Rpdo, "will make the stack write to constants"),
        one(Cause::NoTrigger, PdoKind::Tpdo, NOT_SENT),
        one(Cause::Dummy, PdoKind::Tpdo, NOT_SENT),
        one(Cause::Missing, PdoKind::Tpdo, NOT_SENT),
        one(Cause::Length, PdoKind::Tpdo, NOT_SENT),
        one(Cause::OnNmt, PdoKind::Tpdo, ON_NMT),
        both(Cause::Extended, "will use the lower 11 bits of the CAN-ID in the stack"),
        both(Cause::TooLong, "will lose in the stack what is behind 8 bytes"),
    ],
    consumers: Some(Consumers { from_last: false, is_counted: true, repeated: None }),
    sdo: &[sdo::Row::DefaultServer],
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
