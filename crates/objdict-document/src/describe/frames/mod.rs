//! Frames of a bus in words: which service of which node, and what it says.

mod sdo;
mod talker;

use std::collections::BTreeMap;

use objdict_network::Service;

use self::sdo::Transfers;
pub use self::talker::Talker;
use self::talker::{Talkers, described};
use super::Decoder;
use crate::layout::{FieldKind, Layout};
use crate::model::{CobId, DataType, Pdo, PdoKind, Value, predefined};

/// Reads frames in the order of their times: segments of SDOs belong to the transfers before them.
#[derive(Debug)]
pub struct FrameReader<'a> {
    talkers: Talkers<'a>,
    /// The services with CAN-IDs of 11 bits that nodes configure.
    services: BTreeMap<u16, Vec<(usize, Service)>>,
    transfers: Transfers,
}

/// What a frame says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FrameWords {
    /// The service; `None` for a CAN-ID that no node uses.
    pub service: Option<Service>,
    /// What it says, with the name of its node.
    pub text: String,
}

impl FrameWords {
    fn new(service: Service, text: impl Into<String>) -> Self {
        Self { service: Some(service), text: text.into() }
    }
}

impl<'a> FrameReader<'a> {
    /// A reader of the frames of these nodes.
    pub fn new(talkers: Vec<Talker<'a>>) -> Self {
        let mut reader =
            Self { talkers: Talkers(talkers), services: BTreeMap::new(), transfers: Transfers::default() };
        for at in 0..reader.talkers.0.len() {
            reader.add(at);
        }
        reader
    }

    fn add(&mut self, at: usize) {
        let Talker { node_id, device, .. } = self.talkers.0[at];
        let services = device.services();
        let mut add = |cob_id: Option<CobId>, service| {
            let cob_id = cob_id.filter(|cob_id| !cob_id.is_extended());
            if let Some(id) = cob_id.and_then(|cob_id| u16::try_from(cob_id.can_id(node_id)).ok()) {
                self.services.entry(id).or_default().push((at, service));
            }
        };
        add(services.sync.or(Some(CobId::new(predefined::SYNC.into()))), Service::Sync);
        add(services.time.or(Some(CobId::new(predefined::TIME.into()))), Service::Time);
        let emcy = services.emcy.or(Some(predefined::per_node(predefined::EMCY)));
        add(emcy.filter(|emcy| emcy.is_valid()), Service::Emcy);
        for kind in [PdoKind::Tpdo, PdoKind::Rpdo] {
            let pdos = device.pdos().filter(|pdo| pdo.kind == kind && pdo.is_valid() == Some(true));
            for pdo in pdos.collect::<Vec<Pdo<'_>>>() {
                add(pdo.cob_id, Service::pdo(kind, pdo.number));
            }
        }
    }

    /// The words for a frame with a CAN-ID of 11 bits.
    pub fn read(&mut self, can_id: u16, data: &[u8], is_remote: bool) -> FrameWords {
        let node_id = (can_id & 0x7F) as u8;
        match can_id {
            0 => FrameWords::new(Service::Nmt, self.nmt(data)),
            0x581..=0x5FF => {
                FrameWords::new(Service::SdoResponse, self.transfers.response(&self.talkers, node_id, data))
            }
            0x601..=0x67F => {
                FrameWords::new(Service::SdoRequest, self.transfers.request(&self.talkers, node_id, data))
            }
            0x701..=0x77F => {
                FrameWords::new(Service::ErrorControl, self.error_control(node_id, data, is_remote))
            }
            _ => self.configured(can_id, data, is_remote),
        }
    }

    fn nmt(&self, data: &[u8]) -> String {
        let &[command, node_id, ..] = data else { return "NMT command without node-ID".to_owned() };
        let whom = if node_id == 0 { "all nodes".to_owned() } else { self.talkers.name(node_id) };
        match command {
            1 => format!("start {whom}"),
            2 => format!("stop {whom}"),
            0x80 => format!("{whom}: enter pre-operational"),
            0x81 => format!("reset {whom}"),
            0x82 => format!("reset the communication of {whom}"),
            _ => format!("unknown NMT command {command:02X}h to {whom}"),
        }
    }

    fn error_control(&self, node_id: u8, data: &[u8], is_remote: bool) -> String {
        let name = self.talkers.name(node_id);
        if is_remote {
            return format!("guarding request to {name}");
        }
        match data {
            [] => format!("{name}: empty heartbeat"),
            [0, ..] => format!("{name}: boot-up"),
            [state, ..] => {
                let toggle = if state & 0x80 == 0 { "" } else { ", toggle bit" };
                format!("{name}: {}{toggle}", nmt_state(state & 0x7F))
            }
        }
    }

    /// A frame of a service whose CAN-ID is in the dictionary.
    fn configured(&self, can_id: u16, data: &[u8], is_remote: bool) -> FrameWords {
        let users = self.services.get(&can_id).map_or(&[][..], Vec::as_slice);
        // a TPDO names the sender
        let is_rpdo = |service| matches!(service, Service::Pdo(pdo) if pdo.kind == PdoKind::Rpdo);
        let Some(&(at, service)) = users.iter().min_by_key(|(_, service)| is_rpdo(*service)) else {
            return FrameWords { service: None, text: "not a service of a known node".to_owned() };
        };
        let talker = self.talkers.0[at];
        let text = match service {
            _ if is_remote => format!("request of {service}, {}", talker.name),
            Service::Sync => match data {
                [] => "SYNC".to_owned(),
                [counter, ..] => format!("SYNC {counter}"),
            },
            Service::Emcy => emergency(talker, data),
            Service::Pdo(pdo) => {
                let content = talker.device.pdo(pdo.kind, pdo.number);
                let content = content.map(|pdo| self.content(talker, &pdo, data)).unwrap_or_default();
                let to = if pdo.kind == PdoKind::Rpdo { "to " } else { "" };
                format!("{to}{} {service}: {content}", talker.name)
            }
            _ => format!("{service}"),
        };
        FrameWords::new(service, text)
    }

    /// The values of a PDO.
    fn content(&self, talker: Talker<'_>, pdo: &Pdo<'_>, data: &[u8]) -> String {
        let frame = data.iter().take(8).rev().fold(0, |frame, &byte| frame << 8 | u64::from(byte));
        let layout = Layout::new(talker.device, pdo, &|entry| entry.name.to_string());
        let values =
            layout.shown().filter(|(field, _)| field.kind != FieldKind::Dummy).map(|(field, span)| {
                let (index, sub) = field.object.map_or((0, 0), |object| (object.index, object.sub));
                if span.end > 8 * data.len() as u32 {
                    return format!("{index:04X}:{sub:02X} is missing");
                }
                let bits = frame >> span.start & u64::MAX >> (64 - (span.end - span.start));
                let value =
                    field.data_type.and_then(|data_type| of_bits(bits, span.end - span.start, data_type));
                match value {
                    Some(value) => described(talker, (index, sub), &value, false),
                    None => format!("{index:04X}:{sub:02X} = {bits:X}h"),
                }
            });
        let values: Vec<String> = values.collect();
        if values.is_empty() { "nothing is mapped".to_owned() } else { values.join(", ") }
    }
}

/// A value in the bits of a PDO; signed ones may be cut.
fn of_bits(bits: u64, count: u32, data_type: DataType) -> Option<Value> {
    let Some((low, _)) = data_type.integer_range() else {
        let length = usize::from(data_type.byte_length()?);
        return Value::from_bytes(bits.to_le_bytes().get(..length)?, data_type);
    };
    let shift = 64 - count;
    let number = if low < 0 { i128::from((bits << shift) as i64 >> shift) } else { bits.into() };
    Value::from_integer(number, data_type)
}

/// An NMT state as in a heartbeat: `operational`.
pub fn nmt_state(state: u8) -> String {
    match state {
        0 => "initialising".to_owned(),
        4 => "stopped".to_owned(),
        5 => "operational".to_owned(),
        0x7F => "pre-operational".to_owned(),
        _ => format!("unknown state {state:02X}h"),
    }
}

/// An emergency message: `EMCY 8130h (heartbeat or guarding lost), error register 11h (generic error, communication)`.
fn emergency(talker: Talker<'_>, data: &[u8]) -> String {
    let &[low, high, register, ref vendor @ ..] = data else {
        return format!("{} EMCY with {} bytes", talker.name, data.len());
    };
    let decoder = Decoder::english(talker.device, Some(talker.node_id));
    let code = u16::from_le_bytes([low, high]);
    let mut text = format!(
        "{} EMCY {code:04X}h ({}), error register {register:02X}h ({})",
        talker.name,
        decoder.error_code(code.into()),
        decoder.error_register(register.into())
    );
    if vendor.iter().any(|byte| *byte != 0) {
        let bytes: Vec<String> = vendor.iter().map(|byte| format!("{byte:02X}")).collect();
        text += &format!(", {}", bytes.join(" "));
    }
    text
}

#[cfg(test)]
mod tests;
