//! The configuration of the stack for builds with several object dictionaries.

use super::plan::Planned;
use objdict_model::canopennode::Counters;

/// The content of a configuration member.
enum Holds {
    /// The number of objects with a label.
    Count(&'static str),
    /// The number of elements of an object, and the value if there are none.
    Elements(u16, usize),
    /// An object.
    Entry(u16),
    /// Settings not contained in an object dictionary.
    Zero,
}

use Holds::{Count, Elements, Entry, Zero};

/// The members of `CO_config_t` in order.
const MEMBERS: &[(&str, Holds)] = &[
    ("CNT_NMT", Count("NMT")),
    ("ENTRY_H1017", Entry(0x1017)),
    ("CNT_HB_CONS", Count("HB_CONS")),
    ("CNT_ARR_1016", Elements(0x1016, 0)),
    ("ENTRY_H1016", Entry(0x1016)),
    ("ENTRY_H100C", Entry(0x100C)),
    ("ENTRY_H100D", Entry(0x100D)),
    ("CNT_EM", Count("EM")),
    ("ENTRY_H1001", Entry(0x1001)),
    ("ENTRY_H1014", Entry(0x1014)),
    ("ENTRY_H1015", Entry(0x1015)),
    ("CNT_ARR_1003", Elements(0x1003, 8)), // the EMCY producer needs some room
    ("ENTRY_H1003", Entry(0x1003)),
    ("CNT_SDO_SRV", Count("SDO_SRV")),
    ("ENTRY_H1200", Entry(0x1200)),
    ("CNT_SDO_CLI", Count("SDO_CLI")),
    ("ENTRY_H1280", Entry(0x1280)),
    ("CNT_TIME", Count("TIME")),
    ("ENTRY_H1012", Entry(0x1012)),
    ("CNT_SYNC", Count("SYNC")),
    ("ENTRY_H1005", Entry(0x1005)),
    ("ENTRY_H1006", Entry(0x1006)),
    ("ENTRY_H1007", Entry(0x1007)),
    ("ENTRY_H1019", Entry(0x1019)),
    ("CNT_RPDO", Count("RPDO")),
    ("ENTRY_H1400", Entry(0x1400)),
    ("ENTRY_H1600", Entry(0x1600)),
    ("CNT_TPDO", Count("TPDO")),
    ("ENTRY_H1800", Entry(0x1800)),
    ("ENTRY_H1A00", Entry(0x1A00)),
    ("CNT_LEDS", Zero),
    ("CNT_GFC", Count("GFC")),
    ("ENTRY_H1300", Entry(0x1300)),
    ("CNT_SRDO", Count("SRDO")),
    ("ENTRY_H1301", Entry(0x1301)),
    ("ENTRY_H1381", Entry(0x1381)),
    ("ENTRY_H13FE", Entry(0x13FE)),
    ("ENTRY_H13FF", Entry(0x13FF)),
    ("CNT_LSS_SLV", Zero),
    ("CNT_LSS_MST", Zero),
    ("CNT_GTWA", Zero),
    ("CNT_TRACE", Zero),
];

/// Members and their values.
pub(super) fn config(
    counters: &Counters,
    objects: &[Planned<'_>],
    prefix: &str,
) -> Vec<(&'static str, String)> {
    let object = |index: u16| objects.iter().find(|object| object.index == index);
    let value = |holds: &Holds| match *holds {
        Count("SDO_SRV") if counters.count("SDO_SRV") == 0 => "1".to_owned(), // the default one, which needs no object
        Count(label) if counters.count(label) > 0 => format!("{prefix}_CNT_{label}"),
        Elements(index, _) if object(index).is_some_and(|object| object.count.is_some()) => {
            format!("{prefix}_CNT_ARR_{index:04X}")
        }
        Elements(_, otherwise) => otherwise.to_string(),
        Entry(index) if object(index).is_some() => format!("{prefix}_ENTRY_H{index:04X}"),
        Entry(_) => "NULL".to_owned(),
        Count(_) | Zero => "0".to_owned(),
    };
    MEMBERS.iter().map(|(member, holds)| (*member, value(holds))).collect()
}
