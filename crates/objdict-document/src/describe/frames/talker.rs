//! The nodes of a bus and their entries in words.

use crate::describe::{Decoder, Reader};
use crate::model::{DataType, Device, Value};

/// A node whose frames are read. Its device has the values with which the node runs.
#[derive(Clone, Copy, Debug)]
pub struct Talker<'a> {
    /// The name.
    pub name: &'a str,
    /// The node-ID, 1 to 127.
    pub node_id: u8,
    /// The device.
    pub device: &'a Device,
}

/// The nodes of a bus.
#[derive(Debug)]
pub(super) struct Talkers<'a>(pub(super) Vec<Talker<'a>>);

impl<'a> Talkers<'a> {
    /// The name of a node.
    pub(super) fn name(&self, node_id: u8) -> String {
        self.talker(node_id).map_or_else(|| format!("node {node_id}"), |talker| talker.name.to_owned())
    }

    pub(super) fn talker(&self, node_id: u8) -> Option<Talker<'a>> {
        self.0.iter().find(|talker| talker.node_id == node_id).copied()
    }

    /// `1017:00 Producer heartbeat time`.
    pub(super) fn entry(&self, node_id: u8, (index, sub): (u16, u8)) -> String {
        let talker = self.talker(node_id);
        let entry = talker.and_then(|talker| Some(talker.device.entry(index, sub)?.name.clone()));
        match entry.filter(|name| !name.is_empty()) {
            Some(name) => format!("{index:04X}:{sub:02X} {name}"),
            None => format!("{index:04X}:{sub:02X}"),
        }
    }

    /// The same with a value.
    pub(super) fn value(&self, node_id: u8, (index, sub): (u16, u8), bytes: &[u8]) -> String {
        let value = self.talker(node_id).and_then(|talker| {
            let object = talker.device.object(index)?;
            let entry = object.entry(sub)?;
            let of_count =
                || DataType::of_sub_0(index).filter(|_| sub == 0 && object.object_type().has_subs());
            let data_type = entry.implied_type().or_else(of_count)?;
            Some(described(talker, (index, sub), &Value::from_bytes(bytes, data_type)?, true))
        });
        value.unwrap_or_else(|| {
            let digits: Vec<String> = bytes.iter().map(|byte| format!("{byte:02X}")).collect();
            format!("{} = {}", self.entry(node_id, (index, sub)), digits.join(" "))
        })
    }
}

/// An entry with a value: `6041:00 = 1591 (Operation enabled)`, with `is_named` also by its name.
pub(super) fn described(
    talker: Talker<'_>,
    (index, sub): (u16, u8),
    value: &Value,
    is_named: bool,
) -> String {
    let node_id = Some(talker.node_id);
    let entry = talker.device.entry(index, sub);
    let data_type = entry.as_ref().and_then(|entry| entry.implied_type());
    let short = Reader { index, node_id }.short(Some(value), data_type);
    let name = entry.as_ref().map_or("", |entry| &entry.name);
    let named = if is_named && !name.is_empty() { format!(" {name}") } else { String::new() };
    match Decoder::english(talker.device, node_id).of(index, sub, value) {
        Some(meaning) => format!("{index:04X}:{sub:02X}{named} = {short} ({meaning})"),
        None => format!("{index:04X}:{sub:02X}{named} = {short}"),
    }
}
