//! The configuration of the stack for builds with several object dictionaries.

use super::plan::StackObject;
use objdict_model::canopennode::Counters;

/// The members of `CO_config_t` in order: the number of objects with a label, the number of elements of an object, or an
/// object.
const MEMBERS: &str = "
    CNT_NMT ENTRY_H1017 CNT_HB_CONS CNT_ARR_1016 ENTRY_H1016 ENTRY_H100C ENTRY_H100D CNT_EM ENTRY_H1001 ENTRY_H1014
    ENTRY_H1015 CNT_ARR_1003 ENTRY_H1003 CNT_SDO_SRV ENTRY_H1200 CNT_SDO_CLI ENTRY_H1280 CNT_TIME ENTRY_H1012 CNT_SYNC
    ENTRY_H1005 ENTRY_H1006 ENTRY_H1007 ENTRY_H1019 CNT_RPDO ENTRY_H1400 ENTRY_H1600 CNT_TPDO ENTRY_H1800 ENTRY_H1A00
    CNT_LEDS CNT_GFC ENTRY_H1300 CNT_SRDO ENTRY_H1301 ENTRY_H1381 ENTRY_H13FE ENTRY_H13FF CNT_LSS_SLV CNT_LSS_MST
    CNT_GTWA CNT_TRACE
";

/// Settings that no object dictionary has.
const ZERO: [&str; 5] = ["CNT_LEDS", "CNT_LSS_SLV", "CNT_LSS_MST", "CNT_GTWA", "CNT_TRACE"];

/// Members and their values.
pub(super) fn config(
    counters: &Counters,
    objects: &[StackObject<'_>],
    prefix: &str,
) -> Vec<(&'static str, String)> {
    let object = |index: &str| objects.iter().find(|object| format!("{:04X}", object.index) == index);
    let is_there = |member: &str| match (member.strip_prefix("ENTRY_H"), member.strip_prefix("CNT_ARR_")) {
        (Some(index), _) => object(index).is_some(),
        (_, Some(index)) => object(index).is_some_and(|object| object.count.is_some()),
        _ => !ZERO.contains(&member) && counters.count(member.trim_start_matches("CNT_")) > 0,
    };
    let value = |member: &str| match member {
        member if is_there(member) => format!("{prefix}_{member}"),
        "CNT_SDO_SRV" => "1".to_owned(), // the default one, which needs no object
        "CNT_ARR_1003" => "8".to_owned(), // the EMCY producer needs some room
        member if member.starts_with("CNT_") => "0".to_owned(),
        _ => "NULL".to_owned(),
    };
    MEMBERS.split_ascii_whitespace().map(|member| (member, value(member))).collect()
}
