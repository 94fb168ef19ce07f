//! The values that the documents name for an entry, with their meanings.

use objdict_format::scaffold;
use objdict_model::model::{CobId, DataType, Device, Meaning, PdoKind, Value};
use objdict_profile as profile;
use objdict_profile::BitFieldFacts;

/// So many values with one meaning are all offered; of more, one.
const FEW: i128 = 8;

/// The bits of a CAN-ID in a COB-ID.
const CAN_ID: i128 = (1 << 29) - 1;

/// Values of an entry with their meanings. Where bits have meanings of their own, each value differs from the present one in
/// one of them.
pub(super) fn named(device: &Device, index: u16, sub: u8) -> Vec<(String, String)> {
    let usual = usual(device, index, sub);
    let present = device.value(index, sub).filter(|value| value.as_integer().is_some() || is_formula(value));
    let data_type = device.object(index).and_then(|object| object.entry(sub)?.implied_type());
    let data_type =
        data_type.or_else(|| profile::entry(device, index, sub)?.1).unwrap_or(DataType::UNSIGNED32);
    let fields = profile::bits(profile::of_object(device, index).map(|(_, facts)| facts), sub);
    let accepts = |number: i128| {
        let mut facts = profile::of_object(device, index).filter_map(|(_, facts)| facts.entry(sub));
        facts.all(|facts| facts.accepts_value(number))
            && Value::from_integer(number, data_type).is_some()
            && is_within_limits(device, index, sub, number)
            && is_supported(device, index, number)
    };
    let mut values: Vec<(String, String)> =
        usual.iter().map(|value| (written(value, data_type), "usual".to_owned())).collect();
    if let Some(Meaning::Enumeration(found)) = device.meanings().of(index, sub) {
        let named = found.values.into_iter().filter(|value| !value.name.is_empty());
        values.extend(named.map(|value| (value.number.to_string(), value.name.to_owned())));
        return values;
    }
    if let [field] = fields[..] {
        let numbers = field.meanings().flat_map(|(range, meaning)| {
            let [first, last] = [*range.start(), *range.end()].map(|number| signed(number, data_type));
            let first = if last < 0 && last - first >= FEW { last } else { first };
            let last = if last - first < FEW { last } else { first };
            (first..=last).map(move |number| (number, meaning.to_owned()))
        });
        let allowed = numbers.filter(|(number, _)| accepts(*number));
        values.extend(allowed.map(|(number, meaning)| (number.to_string(), meaning)));
        return values;
    }
    // the default SDO cannot be moved, and what happens in the device sets the bits of a status
    if matches!(index, 0x1001 | 0x1002 | 0x1200 | 0x6041) {
        return values;
    }
    let present = present.map(std::borrow::Cow::into_owned).or(usual).unwrap_or(Value::Unsigned(0));
    let is_cob_id = fields.iter().any(|field| field.name == "CAN-ID");
    // a CAN-ID of 11 bits stays one, and NMT has 0
    let is_free = |number: i128| !is_cob_id || number & CAN_ID != 0;
    let fields = fields.iter().filter(|field| !is_cob_id || field.name != "frame");
    values.extend(fields.flat_map(|field| with_field(field, &present)).filter_map(|(value, meaning)| {
        let is_allowed = value.as_integer().is_none_or(|number| accepts(number) && is_free(number));
        is_allowed.then(|| (written(&value, data_type), meaning))
    }));
    values.dedup_by(|next, before| next.0 == before.0);
    values
}

/// The COB-ID that the predefined connection set gives a PDO or a service; a PDO without one is not valid.
fn usual(device: &Device, index: u16, sub: u8) -> Option<Value> {
    if let (Some((kind, number)), 1) = (PdoKind::of_communication(index), sub) {
        let none = Value::Unsigned(CobId::BIT_31.into());
        return Some(kind.predefined_can_id(number).map_or(none, |base| Value::NodeId(base.into())));
    }
    let is_cob_id = matches!((index, sub), (0x1005 | 0x1012 | 0x1014, 0) | (0x1200..=0x12FF, 1 | 2));
    if is_cob_id { scaffold::entry(device, index, sub)?.default } else { None }
}

fn is_within_limits(device: &Device, index: u16, sub: u8, number: i128) -> bool {
    let Some(entry) = device.object(index).and_then(|object| object.entry(sub)) else { return true };
    let limit = |limit: &Option<Value>| limit.as_ref().and_then(Value::as_integer);
    limit(&entry.low_limit).is_none_or(|low| low <= number)
        && limit(&entry.high_limit).is_none_or(|high| number <= high)
}

/// Whether a drive has the mode of operation, if the value of an object is one (CiA 402): 6502h has a bit for each.
fn is_supported(device: &Device, index: u16, number: i128) -> bool {
    let (axis, object) = (index & !0x7FF, index & 0x7FF);
    if index < 0x6000 || !matches!(object, 0x060 | 0x061) || number <= 0 {
        return true;
    }
    let modes = device.value(axis | 0x502, 0).and_then(|modes| modes.as_integer());
    modes.is_none_or(|modes| modes >> (number - 1).min(32) & 1 == 1)
}

fn is_formula(value: &Value) -> bool {
    matches!(value, Value::NodeId(_))
}

/// The present value with each other named value of a bit field.
fn with_field<'a>(field: &BitFieldFacts<'a>, present: &Value) -> Vec<(Value, String)> {
    let (number, is_formula) = match present {
        Value::NodeId(offset) => (*offset, true),
        value => (value.as_integer().map_or(0, |number| number as u64), false),
    };
    let width = u32::from(field.last.saturating_sub(field.first)) + 1;
    let mask = u64::MAX.checked_shr(64_u32.saturating_sub(width)).unwrap_or_default();
    let with = |part: u64, meaning: String| {
        let new = number & !(mask << field.first) | part << field.first;
        let value = if is_formula { Value::NodeId(new) } else { Value::Unsigned(new) };
        (new != number).then_some((value, meaning))
    };
    if field.meanings().len() == 0 && mask == 1 {
        let words = if field.of(number) == 0 { "with" } else { "without" };
        return with(1 - field.of(number), format!("{words} {}", field.name)).into_iter().collect();
    }
    let named = field.meanings().filter(|(range, _)| range.start() == range.end());
    named.filter_map(|(range, meaning)| with(*range.start(), format!("{}: {meaning}", field.name))).collect()
}

/// A number of a bit field that is the whole value, which may be negative.
fn signed(number: u64, data_type: DataType) -> i128 {
    let number = i128::from(number);
    let (low, high) = data_type.integer_range().unwrap_or((0, number));
    if number > high { number - (high - low + 1) } else { number }
}

/// A value as a description writes it: numbers with bits of their own in hex.
fn written(value: &Value, data_type: DataType) -> String {
    let digits = usize::from(data_type.bit_length().unwrap_or(32)).div_ceil(4);
    match value {
        Value::Unsigned(number) => format!("0x{number:0digits$X}"),
        value => value.to_string(),
    }
}
