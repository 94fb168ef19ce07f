//! Decoded frames as text, including those of LSS (CiA 305).

use super::decoded::{DecodedFrame, FrameKind, RawFrame, SdoFrame, TransferStep};
use super::signals::{self, Multiplexer, PdoSignal};
use super::talker::{MISSING, TalkingNode, named, other_length, raw_bytes};
use super::{FrameReader, nmt_state};
use crate::describe::{Decoder, time};
use crate::model::PdoKind;
use objdict_device::Abort;
use objdict_model::diagnostic::plural;
use objdict_network::Service;

impl FrameReader<'_> {
    /// The text of a decoded frame.
    pub fn words(&self, decoded: &DecodedFrame, frame: &RawFrame<'_>) -> String {
        let RawFrame { can_id, data, .. } = *frame;
        let name = || decoded.node_id.map_or_else(String::new, |node_id| self.nodes.name(node_id));
        match decoded.kind {
            FrameKind::Nmt => self.nmt(data),
            FrameKind::Sync | FrameKind::Time | FrameKind::Emcy if frame.is_remote => {
                request(decoded, &name())
            }
            FrameKind::Sync => match data {
                [] => "SYNC".to_owned(),
                [counter, ..] => format!("SYNC {counter}"),
            },
            FrameKind::Time => time_stamp(data),
            FrameKind::Emcy => match decoded.node_id.and_then(|node_id| self.nodes.get(node_id)) {
                Some(node) => emergency(node, data, self.missing_mark(decoded)),
                None => String::new(),
            },
            FrameKind::Pdo if frame.is_remote => request(decoded, &name()),
            FrameKind::Pdo => self.pdo(decoded, frame, &name()),
            FrameKind::Sdo => match (decoded.node_id, &decoded.sdo) {
                (Some(node_id), Some(sdo)) => self.transfer_words(node_id, sdo, data),
                _ => String::new(),
            },
            FrameKind::Guarding if frame.is_remote => format!("guarding request to {}", name()),
            FrameKind::Heartbeat | FrameKind::BootUp | FrameKind::Guarding => error_control(&name(), data),
            FrameKind::Lss => words(data, can_id == FROM_MASTER),
            FrameKind::Unknown => match can_id {
                0x6E0 if !frame.is_extended => "request of a dynamic SDO connection".to_owned(),
                _ => "not a service of a known node".to_owned(),
            },
        }
    }

    fn nmt(&self, data: &[u8]) -> String {
        let &[command, node_id, ..] = data else { return "NMT command without node-ID".to_owned() };
        let whom = if node_id == 0 { "all nodes".to_owned() } else { self.nodes.name(node_id) };
        match command {
            1 => format!("start {whom}"),
            2 => format!("stop {whom}"),
            0x80 => format!("{whom}: enter pre-operational"),
            0x81 => format!("reset {whom}"),
            0x82 => format!("reset the communication of {whom}"),
            _ => format!("unknown NMT command {command:02X}h to {whom}"),
        }
    }

    /// The values of a PDO.
    fn pdo(&self, decoded: &DecodedFrame, frame: &RawFrame<'_>, name: &str) -> String {
        let service = decoded.service.map_or_else(String::new, |service| service.to_string());
        let is_rpdo = matches!(decoded.service, Some(Service::Pdo(pdo)) if pdo.kind == PdoKind::Rpdo);
        let content = self.content(decoded, frame).map(|(_, content)| content);
        let is_multiplexed = content.is_some_and(|content| content.is_multiplexed);
        let multiplexer = signals::multiplexed(frame.data).filter(|_| is_multiplexed);
        let signals = self.signals(decoded, frame);
        let owner = |signal: &PdoSignal<'_>| self.nodes.get(signal.node_id);
        let values: Vec<String> = signals.iter().map(|signal| signal_words(owner(signal), signal)).collect();
        let text = match (values.as_slice(), multiplexer) {
            ([value, ..], Some((Multiplexer::To(0), ..))) => format!("to all nodes: {value}"),
            ([value, ..], Some((Multiplexer::To(node_id), ..))) => {
                format!("to {}: {value}", self.nodes.name(node_id))
            }
            ([value, ..], Some((Multiplexer::Of(node_id), ..))) => {
                format!("of {}: {value}", self.nodes.name(node_id))
            }
            ([], _) if is_multiplexed => format!("MPDO {}", raw_bytes(frame.data)),
            ([], _) if content.is_some() && frame.data.is_empty() => "nothing is mapped".to_owned(),
            ([], _) if content.is_some() => format!("{}, nothing is mapped", raw_bytes(frame.data)),
            ([], _) => raw_bytes(frame.data),
            (values, None) => values.join(", "),
        };
        let expected = self.mapped_bytes(decoded, frame);
        let other =
            expected.and_then(|expected| other_length(frame.data.len(), expected)).unwrap_or_default();
        let mut mark = self.missing_mark(decoded).to_owned();
        if decoded.node_id.and_then(|id| self.nodes.get(id)).is_some_and(|node| node.is_unconfirmed) {
            mark += " (its mapping was written, without an answer)";
        }
        let others: Vec<String> = self
            .other_senders(decoded, frame)
            .map(|(id, pdo)| format!("{} {pdo}", self.nodes.name(id)))
            .collect();
        if !others.is_empty() {
            mark += &format!(" (or {}, with the same CAN-ID)", others.join(", "));
        }
        format!("{}{name} {service}{mark}{other}: {text}", if is_rpdo { "to " } else { "" })
    }

    /// The mark for a message that the description of its node lacks.
    fn missing_mark(&self, decoded: &DecodedFrame) -> &'static str {
        let is_described = decoded.node_id.is_some_and(|node_id| self.is_described(node_id));
        if is_described && decoded.is_predefined() { MISSING } else { "" }
    }

    fn transfer_words(&self, node_id: u8, sdo: &SdoFrame, data: &[u8]) -> String {
        let name = self.nodes.name(node_id);
        let mark = |entry| self.nodes.get(node_id).map_or("", |node| node.missing_mark(entry));
        let address = || sdo.entry.map_or_else(String::new, |entry| named(entry, "") + mark(entry));
        let entry = || sdo.entry.map_or_else(String::new, |entry| self.nodes.marked_entry(node_id, entry));
        let value = || {
            let in_words = |entry| {
                let bytes = self.nodes.transferred(&self.transfers, (node_id, sdo.channel), entry);
                self.nodes.value(node_id, entry, bytes)
            };
            sdo.entry.map_or_else(String::new, in_words)
        };
        let size = |size: Option<u32>| {
            size.map_or_else(String::new, |size| format!(", {}", plural(size as usize, "byte")))
        };
        let said = match sdo.step {
            TransferStep::Read | TransferStep::BlockRead => format!("read {}", entry()),
            TransferStep::Write => format!("write {}", value()),
            TransferStep::WriteStart(stated) => format!("write {}{}", entry(), size(stated)),
            TransferStep::Expected => format!("{} is expected", address()),
            TransferStep::Written => format!("{} is written", address()),
            TransferStep::Value => value(),
            TransferStep::ValueStart(stated) => format!("{}{}", entry(), size(stated)),
            TransferStep::NextSegment => "next segment".to_owned(),
            TransferStep::Segment(used) => format!("segment of {}", plural(used.into(), "byte")),
            TransferStep::LastSegment => format!("last segment, {}", value()),
            TransferStep::Accepted => "segment is accepted".to_owned(),
            TransferStep::Stray if sdo.entry.is_none() => "segment or end of segments".to_owned(),
            TransferStep::Stray => "segment without a transfer".to_owned(),
            TransferStep::Abort(code) => format!("{}: {}", entry(), Abort::from(code)),
            TransferStep::BlockStart => "start of the blocks".to_owned(),
            TransferStep::BlockSegment(number, false) => format!("segment {number} of a block"),
            TransferStep::BlockSegment(number, true) => format!("segment {number} of a block, the last one"),
            TransferStep::BlockAccepted(number) => format!("segments up to {number} are accepted"),
            TransferStep::BlockEnd => format!("end of the blocks, {}", value()),
            TransferStep::BlockDone => "end of the blocks is confirmed".to_owned(),
            TransferStep::Malformed if sdo.is_request => {
                return format!("SDO of {} to {name}", bytes_of(data));
            }
            TransferStep::Malformed => return format!("SDO of {} from {name}", bytes_of(data)),
            TransferStep::Unknown(command) => format!("unknown SDO command {command:02X}h"),
        };
        let is_known = sdo.entry.is_some() || matches!(sdo.step, TransferStep::Unknown(_));
        let said = if is_known { said } else { said + ", in a transfer that began before the log" };
        let short = if data.len() < 8 { format!(" (in {})", bytes_of(data)) } else { String::new() };
        match sdo.channel {
            1 => format!("{name}: {said}{short}"),
            channel => format!("{name}, SDO channel {channel}: {said}{short}"),
        }
    }
}

/// `6041:00 Statusword = 1591 (state: operation enabled)`.
fn signal_words(owner: Option<&TalkingNode<'_>>, signal: &PdoSignal<'_>) -> String {
    let entry = (signal.index, signal.sub);
    let mark = owner.map_or("", |node| node.missing_mark(entry));
    let value = if signal.raw.is_some() { format!("= {}", signal.text) } else { "is missing".to_owned() };
    format!("{}{mark} {value}", named(entry, &signal.name))
}

/// The request for a PDO, SYNC or another message by a remote frame.
fn request(decoded: &DecodedFrame, name: &str) -> String {
    let service = decoded.service.map_or_else(String::new, |service| service.to_string());
    if name.is_empty() { format!("request of {service}") } else { format!("request of {service}, {name}") }
}

fn error_control(name: &str, data: &[u8]) -> String {
    match data {
        [] => format!("{name}: empty heartbeat"),
        [0, ..] => format!("{name}: boot-up"),
        [state, ..] => {
            let toggle = if state & 0x80 == 0 { "" } else { ", toggle bit" };
            format!("{name}: {}{toggle}", nmt_state(state & 0x7F))
        }
    }
}

/// `5 bytes`: the length of a frame that is too short.
fn bytes_of(data: &[u8]) -> String {
    plural(data.len(), "byte")
}

/// TIME: milliseconds since midnight in 28 bits, days since 1984-01-01.
fn time_stamp(data: &[u8]) -> String {
    let Ok([a, b, c, d, low, high]) = <[u8; 6]>::try_from(data) else {
        return format!("TIME of {}", bytes_of(data));
    };
    let day = time::date(u16::from_le_bytes([low, high]).into());
    let clock = time::of_day(u32::from_le_bytes([a, b, c, d]) & 0x0FFF_FFFF);
    match day.zip(clock) {
        Some((day, clock)) => format!("TIME {day} {clock}"),
        None => format!("TIME {}, not a valid time", raw_bytes(data)),
    }
}

/// An emergency message: `EMCY 8130h (heartbeat or guarding lost), error register 11h (generic error, communication)`.
fn emergency(node: &TalkingNode<'_>, data: &[u8], mark: &str) -> String {
    let &[low, high, register, ref vendor @ ..] = data else {
        return format!("{} EMCY{mark} with {}", node.name, bytes_of(data));
    };
    let decoder = Decoder::english(&node.device, Some(node.node_id));
    let code = u16::from_le_bytes([low, high]);
    let mut text = format!(
        "{} EMCY{mark} {code:04X}h ({}), error register {register:02X}h ({})",
        node.name,
        decoder.error_code(code.into()),
        decoder.error_register(register.into())
    );
    if vendor.iter().any(|byte| *byte != 0) {
        text += &format!(", {}", raw_bytes(vendor));
    }
    text
}

/// The CAN-ID of the slaves.
pub(super) const FROM_SLAVE: u32 = 0x7E4;
/// The CAN-ID of the master.
pub(super) const FROM_MASTER: u32 = 0x7E5;

/// The parts of an LSS address.
const PARTS: [&str; 4] = ["vendor-ID", "product code", "revision number", "serial number"];

/// Bit rates of table 0 in kbit/s.
const BIT_RATES: [&str; 10] = ["1000", "800", "500", "250", "125", "100", "50", "20", "10", "automatic"];

/// The text of a frame.
pub(super) fn words(data: &[u8], is_request: bool) -> String {
    let Ok([command, first, second, third, fourth, bit, part, next]) = <[u8; 8]>::try_from(data) else {
        return format!("LSS of {}", bytes_of(data));
    };
    let number = u32::from_le_bytes([first, second, third, fourth]);
    let said = match (command, is_request) {
        (0x04, _) if first == 0 => "all nodes to waiting".to_owned(),
        (0x04, _) if first == 1 => "all nodes to configuration".to_owned(),
        (0x04, _) => format!("all nodes to {first:02X}h, which is no mode"),
        (0x40..=0x43, _) => format!("select {} {number:08X}h", PARTS[usize::from(command - 0x40)]),
        (0x44, _) => "the selected node is in configuration".to_owned(),
        (0x11, true) if first == 0xFF => "configure no node-ID".to_owned(),
        (0x11, true) => format!("configure node-ID {first}"),
        (0x13, true) => format!("configure bit rate {}", bit_rate(first, second)),
        (0x15, _) => format!("activate the bit rate after {} ms", u16::from_le_bytes([first, second])),
        (0x17, true) => "store the configuration".to_owned(),
        (0x11 | 0x13 | 0x17, false) => format!("{} {}", configured(command), result(first)),
        (0x5A..=0x5D, true) => format!("inquire {}", PARTS[usize::from(command - 0x5A)]),
        (0x5A..=0x5D, false) => format!("{} {number:08X}h", PARTS[usize::from(command - 0x5A)]),
        (0x5E, true) => "inquire node-ID".to_owned(),
        (0x5E, false) if first == 0xFF => "the node has no node-ID".to_owned(),
        (0x5E, false) => format!("node-ID {first}"),
        (0x46..=0x4B, _) => format!("identify {} {number:08X}h", RANGE[usize::from(command - 0x46)]),
        (0x4C, _) => "identify nodes without node-ID".to_owned(),
        (0x4F, _) => "a node is identified".to_owned(),
        (0x50, _) => "a node without node-ID is there".to_owned(),
        (0x51, _) if bit == 0x80 => "fastscan: all nodes without node-ID".to_owned(),
        (0x51, _) => {
            let part = PARTS.get(usize::from(part)).copied().unwrap_or("unknown part");
            format!("fastscan: {part} {number:08X}h from bit {bit} on, next {next}")
        }
        _ => format!("unknown command {command:02X}h"),
    };
    format!("LSS {}: {said}", if is_request { "master" } else { "node" })
}

/// The parts of a range of LSS addresses.
const RANGE: [&str; 6] = [
    "vendor-ID",
    "product code",
    "revision numbers from",
    "revision numbers to",
    "serial numbers from",
    "serial numbers to",
];

fn configured(command: u8) -> &'static str {
    match command {
        0x11 => "node-ID",
        0x13 => "bit rate",
        _ => "configuration",
    }
}

fn result(error: u8) -> String {
    match error {
        0 => "is accepted".to_owned(),
        0xFF => "is refused, error of the vendor".to_owned(),
        _ => format!("is refused, error {error}"),
    }
}

fn bit_rate(table: u8, at: u8) -> String {
    match BIT_RATES.get(usize::from(at)) {
        Some(&rate) if table == 0 && rate != "automatic" => format!("{rate} kbit/s"),
        Some(&rate) if table == 0 => rate.to_owned(),
        _ => format!("{at} of table {table}"),
    }
}
