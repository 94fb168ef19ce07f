//! Test operations for the drivers, and the expected answers.

use std::collections::BTreeMap;
use std::fmt::Write;

use objdict::model::{Device, TypeKind, Value};

use crate::oracle::{Answer, Dictionary, Facts, facts_of, hex};

/// Operations for a driver and the expected lines.
#[derive(Default)]
pub(crate) struct Script {
    pub(crate) input: String,
    pub(crate) expected: Vec<String>,
}

/// All operations on a device, for two node-IDs.
pub(crate) fn without_hooks(device: &Device) -> Script {
    of(device, Dictionary::freeze_mappings)
}

/// All operations on a device with hooks for all entries or with dynamic mappings, for two node-IDs.
pub(crate) fn with_hooks(device: &Device) -> Script {
    of(device, |_| {})
}

fn of(device: &Device, change: fn(&mut Dictionary)) -> Script {
    let mut script = Script::default();
    for node_id in [5, 127] {
        let mut dictionary = Dictionary::new(device, node_id);
        change(&mut dictionary);
        writeln!(script.input, "i {node_id:02X}\nt").unwrap();
        script.expected.extend(dictionary.table());
        let entries: BTreeMap<(u16, u8), Facts> = facts_of(device).collect();
        for (&(index, sub), facts) in &entries {
            let neighbours = [sub.wrapping_sub(1), sub.wrapping_add(1)].map(|sub| entries.get(&(index, sub)));
            if neighbours.iter().flatten().filter(|other| other.is_like(facts)).count() == 2 {
                script.element(&mut dictionary, index, sub, facts);
            } else {
                script.entry(&mut dictionary, index, sub, facts);
            }
        }
        script.missing(&mut dictionary, &entries);
        for &(index, sub) in entries.keys() {
            script.read(&dictionary, index, sub, 0xFFFF).ok(); // no write changed another entry
        }
    }
    script
}

impl Script {
    /// All operations on an entry.
    fn entry(&mut self, dictionary: &mut Dictionary, index: u16, sub: u8, facts: &Facts) {
        let default = self.read(dictionary, index, sub, 0xFFFF).unwrap_or_default();
        if !default.is_empty() {
            self.read(dictionary, index, sub, default.len() - 1).unwrap_err();
        }
        self.read(dictionary, index, sub, default.len()).ok();
        let mut values = vec![default.clone()];
        let length = facts.size;
        let mut lengths = vec![0, length.saturating_sub(1), length, length + 1, length + 8];
        lengths.dedup();
        values.extend(lengths.into_iter().map(|length| vec![0x41; length]));
        values.extend(edges(facts));
        for value in values {
            self.write(dictionary, index, sub, &value);
            self.read(dictionary, index, sub, 0xFFFF).ok();
        }
        self.write(dictionary, index, sub, &default);
    }

    /// A few operations on an array element; only the first and the last one get all operations.
    fn element(&mut self, dictionary: &mut Dictionary, index: u16, sub: u8, facts: &Facts) {
        self.read(dictionary, index, sub, 0xFFFF).ok();
        self.write(dictionary, index, sub, &vec![sub & 1; facts.size + 1]);
        self.write(dictionary, index, sub, &vec![sub & 1; facts.size]);
    }

    /// Missing sub-indexes and indexes next to existing ones.
    fn missing(&mut self, dictionary: &mut Dictionary, entries: &BTreeMap<(u16, u8), Facts>) {
        let mut addresses = vec![(0, 0), (0xFFFF, 0xFF)];
        for &(index, sub) in entries.keys() {
            addresses.extend([(index, sub.wrapping_add(1)), (index, 0xFE), (index, 0xFF), (index, 0)]);
            addresses.extend([(index - 1, 0xFF), (index - 1, sub), (index + 1, 0), (index + 1, sub)]);
        }
        addresses.sort_unstable();
        addresses.dedup();
        for (index, sub) in addresses {
            if !entries.contains_key(&(index, sub)) {
                self.read(dictionary, index, sub, 0xFFFF).unwrap_err();
                self.write(dictionary, index, sub, &[0]);
            }
        }
    }

    fn read(&mut self, dictionary: &Dictionary, index: u16, sub: u8, size: usize) -> Answer {
        writeln!(self.input, "r {index:04X} {sub:02X} {size:04X}").unwrap();
        let answer = dictionary.read(index, sub, size);
        self.expect(&answer);
        answer
    }

    fn write(&mut self, dictionary: &mut Dictionary, index: u16, sub: u8, bytes: &[u8]) {
        writeln!(self.input, "w {index:04X} {sub:02X} {}", hex(bytes)).unwrap();
        let answer = dictionary.write(index, sub, bytes);
        self.expect(&answer);
    }

    fn expect(&mut self, answer: &Answer) {
        self.expected.push(match answer {
            Ok(bytes) => format!("ok {}", hex(bytes)),
            Err(code) => format!("abort {code:08X}"),
        });
    }
}

/// Values at and around the limits of an entry and of its type.
pub(crate) fn edges(facts: &Facts) -> Vec<Vec<u8>> {
    let limits = [&facts.low, &facts.high].into_iter().flatten();
    let values: Vec<Option<Value>> = match facts.data_type.kind() {
        TypeKind::Boolean => return vec![vec![0], vec![1], vec![2], vec![0xFF]],
        TypeKind::TimeOfDay | TypeKind::TimeDifference => {
            return vec![vec![0xFF; 6], vec![0x00; 6], vec![1, 2, 3, 4, 5, 6]];
        }
        TypeKind::Real32 => {
            let limits =
                limits.filter_map(|limit| if let Value::Real32(limit) = limit { Some(*limit) } else { None });
            let around = limits.flat_map(|limit| [limit.next_down(), limit, limit.next_up()]);
            let special = [
                0.0,
                -0.0,
                1.5,
                -1.5,
                f32::MIN,
                f32::MAX,
                f32::INFINITY,
                f32::NEG_INFINITY,
                f32::NAN,
                -f32::NAN,
            ];
            around.chain(special).map(|number| Some(Value::Real32(number))).collect()
        }
        TypeKind::Real64 => {
            let limits =
                limits.filter_map(|limit| if let Value::Real64(limit) = limit { Some(*limit) } else { None });
            let around = limits.flat_map(|limit| [limit.next_down(), limit, limit.next_up()]);
            let special = [
                0.0,
                -0.0,
                1.5,
                -1.5,
                f64::MIN,
                f64::MAX,
                f64::INFINITY,
                f64::NEG_INFINITY,
                f64::NAN,
                -f64::NAN,
            ];
            around.chain(special).map(|number| Some(Value::Real64(number))).collect()
        }
        _ => {
            let Some((least, greatest)) = facts.data_type.integer_range() else { return Vec::new() };
            // if a limit is a formula, its value for both node-IDs of the script
            let limits = limits.flat_map(|limit| [limit.integer_for(5), limit.integer_for(127)]).flatten();
            let around = limits.flat_map(|limit| [limit - 1, limit, limit + 1]);
            let numbers = around.chain([least, -1, 0, 1, greatest / 3, greatest]);
            numbers.map(|number| Value::from_integer(number, facts.data_type)).collect()
        }
    };
    values.into_iter().flatten().filter_map(|value| value.to_bytes(facts.data_type)).collect()
}
