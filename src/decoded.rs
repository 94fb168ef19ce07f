//! What the number in an entry says, in words: communication objects (CiA 301 §7.5.2), and what a device profile defines.

use crate::model::{CobId, DataType, Device, MappedObject, PdoKind, Value};
use crate::profile;

/// The meaning of a value, where it has one beside the number; COB-IDs are those of the node `node_id`, where it is given.
pub fn of(device: &Device, index: u16, sub: u8, value: &Value, node_id: Option<u8>) -> Option<String> {
    let number = || u32::try_from(value.as_integer()?).ok();
    match (index, sub) {
        (0x1000, 0) => number().map(|number| device_type(number) + &additional(device, number)),
        (0x1005, 0) => {
            cob_id(value, node_id, |id| if id.bit_30() { "produces SYNC" } else { "consumes SYNC" })
        }
        (0x1006 | 0x1007, 0) => number().map(|time| format!("{time} µs")),
        (0x1012, 0) => cob_id(value, node_id, |id| match (!id.is_valid(), id.bit_30()) {
            (true, true) => "consumes and produces TIME",
            (true, false) => "consumes TIME",
            (false, true) => "produces TIME",
            (false, false) => "neither consumes nor produces TIME",
        }),
        (0x1014, 0) => cob_id(value, node_id, validity),
        (0x1015, 0) => number().map(|time| format!("{}.{} ms", time / 10, time % 10)),
        (0x1016, 1..) => number().map(heartbeat_consumer),
        (0x1017, 0) => number().map(|time| if time == 0 { "off".to_owned() } else { format!("{time} ms") }),
        (0x1018, 3) => number().map(|number| format!("major {}, minor {}", number >> 16, number & 0xFFFF)),
        (0x1200..=0x12FF, 1 | 2) => cob_id(value, node_id, validity),
        _ => pdo(device, index, sub, value, node_id).or_else(|| profile::meaning(device, index, sub, value)),
    }
}

fn pdo(device: &Device, index: u16, sub: u8, value: &Value, node_id: Option<u8>) -> Option<String> {
    let number = u32::try_from(value.as_integer().unwrap_or_default()).ok()?;
    if PdoKind::of_mapping(index).is_some() {
        return mapped(device, sub, number);
    }
    let (kind, _) = PdoKind::of_communication(index)?;
    match sub {
        1 => cob_id(value, node_id, |id| match (id.is_valid(), id.bit_30() && kind == PdoKind::Tpdo) {
            (false, _) => "does not exist",
            (true, false) => "exists",
            (true, true) => "exists, no remote frames",
        }),
        2 => Some(transmission_type(kind, number)),
        3 => Some(format!("{}.{} ms", number / 10, number % 10)),
        5 => Some(if number == 0 { "off".to_owned() } else { format!("{number} ms") }),
        _ => None,
    }
}

fn cob_id(value: &Value, node_id: Option<u8>, flags: impl Fn(CobId) -> &'static str) -> Option<String> {
    let id = CobId::from_value(value)?;
    let can_id = match node_id {
        None if id.depends_on_node_id() => {
            let base = CobId::per_node(id.number() & 0x1FFF_FFFF)?;
            base.to_string()
        }
        node_id => format!("0x{:03X}", id.can_id(node_id.unwrap_or_default())),
    };
    let frame = if id.is_extended() { "29 bits" } else { "11 bits" };
    Some(format!("CAN-ID {can_id}, {frame}, {}", flags(id)))
}

fn validity(id: CobId) -> &'static str {
    if id.is_valid() { "exists" } else { "does not exist" }
}

fn device_type(number: u32) -> String {
    let (additional, profile) = (number >> 16, number & 0xFFFF);
    let name = match profile {
        0 => return "no device profile".to_owned(),
        401 => " (I/O modules)",
        402 => " (drives)",
        404 => " (measuring devices and closed-loop controllers)",
        405 => " (programmable devices)",
        406 => " (encoders)",
        408 => " (hydraulic drives)",
        410 => " (inclinometers)",
        418 => " (battery modules)",
        0xFFFF => return format!("several devices in one, additional information 0x{additional:04X}"),
        _ => "",
    };
    format!("device profile CiA {profile}{name}, additional information 0x{additional:04X}")
}

/// What the device profile says of the high word.
fn additional(device: &Device, number: u32) -> String {
    let high_word = Value::Unsigned(u64::from(number & 0xFFFF_0000));
    let meaning = profile::meaning(device, 0x1000, 0, &high_word).filter(|_| number >> 16 != 0);
    meaning.map(|meaning| format!(" ({meaning})")).unwrap_or_default()
}

fn heartbeat_consumer(number: u32) -> String {
    let (node, time) = (number >> 16 & 0xFF, number & 0xFFFF);
    if node == 0 || time == 0 { "unused".to_owned() } else { format!("node {node}, {time} ms") }
}

fn transmission_type(kind: PdoKind, number: u32) -> String {
    match (kind, number) {
        (PdoKind::Tpdo, 0) => "synchronous, when the value changed".to_owned(),
        (PdoKind::Tpdo, 1) => "synchronous, with every SYNC".to_owned(),
        (PdoKind::Tpdo, 2..=240) => format!("synchronous, with every {number}. SYNC"),
        (PdoKind::Rpdo, 0..=240) => "synchronous, taken over with the next SYNC".to_owned(),
        (PdoKind::Tpdo, 252) => "on remote frame, sampled with SYNC".to_owned(),
        (PdoKind::Tpdo, 253) => "on remote frame".to_owned(),
        (_, 254) => "event-driven, events of the manufacturer".to_owned(),
        (_, 255) => "event-driven, events of the device profile".to_owned(),
        _ => "reserved".to_owned(),
    }
}

fn mapped(device: &Device, sub: u8, number: u32) -> Option<String> {
    if sub == 0 {
        return None;
    }
    let object = MappedObject::from_number(number);
    if object.is_unused() {
        return None;
    }
    let bits = object.bits;
    if object.is_dummy() {
        return Some(format!("{bits} bits unused (dummy {})", DataType(object.index)));
    }
    let place = format!("0x{:04X}sub{:X}", object.index, object.sub);
    Some(match device.entry(object.index, object.sub) {
        Some(entry) => format!("{place} {}, {bits} bits", entry.name),
        None => format!("{place}, which the description does not have, {bits} bits"),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(index: u16, sub: u8, value: &Value, node_id: Option<u8>) -> String {
        super::of(&Device::default(), index, sub, value, node_id).unwrap_or_default()
    }

    #[test]
    fn cob_ids_say_what_they_do() {
        assert_eq!(of(0x1400, 1, &Value::NodeId(0x200), Some(5)), "CAN-ID 0x205, 11 bits, exists");
        assert_eq!(
            of(0x1400, 1, &Value::NodeId(0x8000_0200), None),
            "CAN-ID $NODEID+0x200, 11 bits, does not exist"
        );
        assert_eq!(
            of(0x1801, 1, &Value::Unsigned(0x4000_0285), None),
            "CAN-ID 0x285, 11 bits, exists, no remote frames"
        );
        assert_eq!(
            of(0x1005, 0, &Value::Unsigned(0x4000_0080), None),
            "CAN-ID 0x080, 11 bits, produces SYNC"
        );
        assert_eq!(
            of(0x1012, 0, &Value::Unsigned(0x8000_0100), None),
            "CAN-ID 0x100, 11 bits, consumes TIME"
        );
        assert_eq!(of(0x1200, 1, &Value::Unsigned(0x2001_0000), None), "CAN-ID 0x10000, 29 bits, exists");
    }

    #[test]
    fn mappings_say_what_they_carry() {
        assert_eq!(of(0x1A00, 1, &Value::Unsigned(0x0005_0008), None), "8 bits unused (dummy UNSIGNED8)");
        assert_eq!(of(0x1A00, 2, &Value::Unsigned(0), None), "");
        let missing = of(0x1600, 1, &Value::Unsigned(0x6040_0010), None);
        assert_eq!(missing, "0x6040sub0, which the description does not have, 16 bits");
    }

    #[test]
    fn times_have_units() {
        assert_eq!(of(0x1800, 3, &Value::Unsigned(105), None), "10.5 ms");
        assert_eq!(of(0x1016, 2, &Value::Unsigned(0x0003_01F4), None), "node 3, 500 ms");
        assert_eq!(
            of(0x1000, 0, &Value::Unsigned(0x0002_0192), None),
            "device profile CiA 402 (drives), additional information 0x0002"
        );
    }
}
