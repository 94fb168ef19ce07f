//! Bus frames as text: service, node, and content.
//!
//! A frame is first decoded, which is fast, and converted to text only on request.

mod decoded;
mod sdo;
mod signals;
mod stale;
mod talker;
mod users;
mod words;

use std::collections::BTreeSet;

use objdict_network::Service;

pub use self::decoded::{DecodedFrame, FrameKind, RawFrame, SdoFrame, TransferStep};
pub use self::sdo::SdoTransfer;
use self::sdo::Transfers;
use self::signals::{PdoContent, SignalPlace};
pub use self::signals::{PdoSignal, SignalReading};
use self::stale::Stale;
use self::talker::{Nodes, TalkingNode};
pub use self::talker::{Talker, raw_bytes};
use self::users::{CanIdUser, Users};
use super::Decoder;
use crate::model::{Device, PdoKind, Value};

/// The objects whose values affect the meaning of frames: those of CiA 301 and its frameworks.
const COMMUNICATION: std::ops::Range<u16> = 0x1000..0x2000;

/// Reads frames in chronological order. Segments of SDOs belong to the preceding transfers, and values that nodes
/// accept or return apply from then on: for example, a new mapping changes the meaning of a PDO.
#[derive(Debug)]
pub struct FrameReader<'a> {
    nodes: Nodes<'a>,
    users: Users,
    transfers: Transfers,
    /// The changes of nodes since their services were determined.
    stale: BTreeSet<(u8, Stale)>,
    /// Node-IDs with a pending guarding request.
    guarded: u128,
    /// Whether unknown CAN-IDs are interpreted with the predefined connection set.
    has_defaults: bool,
    changes: Changes,
}

/// The number of node changes, by affected property.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Changes {
    /// Changes that affect cycles: the producers and consumers of heartbeats, and the SYNC period.
    pub cycles: u64,
    /// Changes that affect PDOs: their parameters and the synchronous window length.
    pub pdos: u64,
}

/// A frame as text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FrameWords {
    /// The service; `None` for a CAN-ID that no node uses.
    pub service: Option<Service>,
    /// The text, with the name of its node.
    pub text: String,
}

impl<'a> FrameReader<'a> {
    /// A reader of the frames of these nodes, on a bus without further nodes.
    pub fn new(talkers: Vec<Talker<'a>>) -> Self {
        let nodes = Nodes::new(talkers);
        let stale = nodes.iter().map(|node| (node.node_id, Stale::All)).collect();
        Self {
            nodes,
            users: Users::default(),
            transfers: Transfers::default(),
            stale,
            guarded: 0,
            has_defaults: false,
            changes: Changes::default(),
        }
    }

    /// A reader of the frames of a bus with further nodes, whose CAN-IDs come from the predefined connection set (CiA
    /// 301 §7.3.5).
    pub fn of_bus(talkers: Vec<Talker<'a>>) -> Self {
        Self { has_defaults: true, ..Self::new(talkers) }
    }

    /// Nodes without a description that do not state a device profile have this one.
    pub fn assume_profile(&mut self, number: u16) {
        self.nodes.profile = Some(number);
    }

    /// Describes a node from now on.
    pub fn describe(&mut self, talker: Talker<'a>) {
        self.nodes.describe(talker);
        self.note_other_values(talker.node_id, [Stale::All]);
    }

    /// The number of changes of node values that affect the meaning of frames.
    pub const fn changes(&self) -> Changes {
        self.changes
    }

    /// The nodes, in the order of detection.
    pub fn node_ids(&self) -> impl Iterator<Item = u8> + '_ {
        self.nodes.iter().map(|node| node.node_id)
    }

    /// Records that several values of a node may have changed, which affects these services.
    fn note_other_values(&mut self, node_id: u8, stale: impl IntoIterator<Item = Stale>) {
        self.stale.extend(stale.into_iter().map(|stale| (node_id, stale)));
        self.changes.cycles += 1;
        self.changes.pdos += 1;
    }

    /// Records that the value of an entry has changed.
    fn note_change(&mut self, node_id: u8, entry: (u16, u8)) {
        let (stale, (index, _)) = (Stale::of(entry), entry);
        self.stale.extend(stale.map(|stale| (node_id, stale)));
        self.changes.cycles += u64::from(matches!(index, 0x1005 | 0x1006 | 0x1016 | 0x1017));
        self.changes.pdos +=
            u64::from(matches!(stale, Some(Stale::Pdo(..) | Stale::Content(..))) || index == 0x1007);
    }

    /// The text for a frame with an 11-bit CAN-ID.
    pub fn read(&mut self, can_id: u16, data: &[u8], is_remote: bool) -> FrameWords {
        let frame = RawFrame { can_id: can_id.into(), is_extended: false, is_remote, data };
        let decoded = self.decode(&frame);
        FrameWords { service: decoded.service, text: self.words(&decoded, &frame) }
    }

    /// Decodes a frame.
    pub fn decode(&mut self, frame: &RawFrame<'_>) -> DecodedFrame {
        let RawFrame { can_id, is_extended, is_remote, data } = *frame;
        let node_id = (can_id & 0x7F) as u8;
        if is_extended || self.is_channel(frame) {
            return self.configured(frame);
        }
        match can_id {
            0 => self.command(data),
            0x581..=0x5FF if !is_remote => self.sdo((node_id, 1), data, false),
            0x601..=0x67F if !is_remote => self.sdo((node_id, 1), data, true),
            0x701..=0x77F => {
                let kind = self.error_control(node_id, data, is_remote);
                DecodedFrame::new(kind, Some(Service::ErrorControl), Some(node_id))
            }
            words::FROM_SLAVE | words::FROM_MASTER => DecodedFrame::new(FrameKind::Lss, None, None),
            _ => self.configured(frame),
        }
    }

    /// The values of a PDO.
    pub fn signals<'r>(&'r self, decoded: &DecodedFrame, frame: &'r RawFrame<'_>) -> Vec<PdoSignal<'r>> {
        let signals = self.content(decoded, frame).and_then(|(node, content)| {
            if content.is_multiplexed {
                let (node, place, value) = self.multiplexed(node, frame)?;
                return Some(vec![place.signal(node, Some(value)).into_owned()]);
            }
            Some(content.signals(node, frame.data).collect())
        });
        signals.unwrap_or_default()
    }

    /// The values of a PDO without their text, each with the node of its entry; without a type the bits are a
    /// number.
    pub fn values(&self, decoded: &DecodedFrame, frame: &RawFrame<'_>) -> Vec<(u8, (u16, u8), Value)> {
        let values = self.content(decoded, frame).and_then(|(node, content)| {
            if content.is_multiplexed {
                let (node, place, value) = self.multiplexed(node, frame)?;
                return Some(vec![(node.node_id, place.entry(), place.number(value))]);
            }
            let values = content.values(frame.data);
            Some(values.map(|(entry, value)| (node.node_id, entry, value)).collect())
        });
        values.unwrap_or_default()
    }

    /// The content of a node's multiplexed PDO: the node of the entry, the entry, and its bytes.
    fn multiplexed<'n>(
        &'n self,
        sender: &'n TalkingNode<'a>,
        frame: &RawFrame<'_>,
    ) -> Option<(&'n TalkingNode<'a>, SignalPlace, u64)> {
        let (multiplexer, entry, bytes) = signals::multiplexed(frame.data)?;
        // the entry of no one node has the type that the sender has
        let node = self.nodes.get(multiplexer.node_id()).unwrap_or(sender);
        Some((node, SignalPlace::multiplexed(node, entry), u32::from_le_bytes(bytes).into()))
    }

    /// The number of bytes of a PDO according to its mapping, if known.
    pub fn mapped_bytes(&self, decoded: &DecodedFrame, frame: &RawFrame<'_>) -> Option<usize> {
        self.content(decoded, frame)?.1.bytes
    }

    /// The services of nodes that use the CAN-ID of a frame.
    pub fn users<'r>(&'r self, frame: &RawFrame<'_>) -> impl Iterator<Item = (u8, Service)> + use<'r, 'a> {
        let users = self.users.all(users::key(frame.can_id, frame.is_extended));
        users.map(|user| (user.node_id, user.service))
    }

    /// Other TPDOs whose CAN-ID is that of a TPDO. A multiplexed one names its node, so several may share it.
    pub fn other_senders<'r>(
        &'r self,
        decoded: &DecodedFrame,
        frame: &RawFrame<'_>,
    ) -> impl Iterator<Item = (u8, Service)> + use<'r, 'a> {
        let own = decoded.node_id.zip(decoded.service);
        let is_sender = |service| matches!(service, Service::Pdo(pdo) if pdo.kind == PdoKind::Tpdo);
        let is_named = self.content(decoded, frame).is_none_or(|(_, content)| content.is_multiplexed);
        let has_others = !is_named && own.is_some_and(|(_, service)| is_sender(service));
        let senders = self.users(frame).filter(move |user| has_others && is_sender(user.1));
        senders.filter(move |user| Some(*user) != own)
    }

    /// The SDO transfer of a frame, after it.
    pub fn transfer(&self, decoded: &DecodedFrame) -> Option<&SdoTransfer> {
        self.transfers.get((decoded.node_id?, decoded.sdo?.channel))
    }

    /// The value of an SDO transfer that this frame completes: its bytes, and the value if its type is known.
    pub fn transferred(&self, decoded: &DecodedFrame) -> Option<(&[u8], Option<Value>)> {
        let bytes = self.transferred_bytes(decoded)?;
        let node = decoded.node_id.and_then(|node_id| self.nodes.get(node_id));
        Some((bytes, node.and_then(|node| node.value_of(decoded.sdo?.entry?, bytes))))
    }

    /// The bytes of that value.
    pub fn transferred_bytes(&self, decoded: &DecodedFrame) -> Option<&[u8]> {
        let (node_id, sdo) = decoded.node_id.zip(decoded.sdo)?;
        let is_known = sdo.step.has_value() || sdo.step == TransferStep::Written;
        let entry = sdo.entry.filter(|_| is_known)?;
        Some(self.nodes.transferred(&self.transfers, (node_id, sdo.channel), entry))
    }

    /// The representation of an entry's value in a plot.
    pub fn reading(&self, node_id: u8, entry: (u16, u8), value: &Value) -> SignalReading {
        let node = self.nodes.get(node_id);
        let scaled = node.and_then(|node| node.scaling(&node.meanings(), entry));
        let in_unit = scaled.as_ref().and_then(|scaled| scaled.number(value)?.parse().ok());
        let plain = || value.as_integer().map(|number| number as f64).or_else(|| value.as_real());
        SignalReading {
            number: in_unit.or_else(plain),
            word: node.and_then(|node| node.state(entry, value)),
            unit: scaled.map(|scaled| scaled.unit).unwrap_or_default(),
        }
    }

    /// The device of a node with the values that the frames have shown.
    pub fn device(&self, node_id: u8) -> Option<&Device> {
        Some(&self.nodes.get(node_id)?.device)
    }

    /// The name of a node: `node 5` without a description.
    pub fn name(&self, node_id: u8) -> String {
        self.nodes.name(node_id)
    }

    /// Whether a description covers a node.
    pub fn is_described(&self, node_id: u8) -> bool {
        self.nodes.get(node_id).is_some_and(|node| node.is_described)
    }

    /// The name of an entry: `1017:00 Producer heartbeat time`.
    pub fn entry_name(&self, node_id: u8, entry: (u16, u8)) -> String {
        self.nodes.entry(node_id, entry)
    }

    /// The meaning of an EMCY error code for a node.
    pub fn error_code(&self, node_id: u8, code: u16) -> &'static str {
        let empty = Device::default();
        let device = self.device(node_id).unwrap_or(&empty);
        Decoder::english(device, Some(node_id)).error_code(code.into())
    }

    /// The node that describes the PDO of a frame, and the content of the PDO.
    fn content(
        &self,
        decoded: &DecodedFrame,
        frame: &RawFrame<'_>,
    ) -> Option<(&TalkingNode<'a>, &PdoContent)> {
        let (node, user) = self.user(decoded, frame)?;
        Some((node, user.content(node)))
    }

    /// The node that describes the PDO of a frame, and the PDO of that node.
    fn user(&self, decoded: &DecodedFrame, frame: &RawFrame<'_>) -> Option<(&TalkingNode<'a>, &CanIdUser)> {
        let key = users::key(frame.can_id, frame.is_extended);
        let is_pdo = matches!(decoded.service, Some(Service::Pdo(_)));
        let user = self.users.all(key).nth(decoded.user);
        let user = user.filter(|user| is_pdo && Some(user.service) == decoded.service)?;
        let node_of = |user: &CanIdUser| self.nodes.get(user.node_id);
        let is_describing = |user: &&CanIdUser| node_of(user).is_some_and(|node| !node.is_counterpart);
        let user = [user].into_iter().chain(self.users.all(key)).find(is_describing).unwrap_or(user);
        Some((node_of(user)?, user))
    }

    /// An NMT command: a reset restores the initial values of nodes.
    fn command(&mut self, data: &[u8]) -> DecodedFrame {
        let node_id = data.get(1).copied().filter(|node_id| *node_id != 0);
        if let &[0x81 | 0x82, whom, ..] = data {
            let all = if whom == 0 { 1..=127 } else { whom..=whom };
            all.for_each(|node_id| self.reset(node_id));
        }
        DecodedFrame::new(FrameKind::Nmt, Some(Service::Nmt), node_id)
    }

    fn reset(&mut self, node_id: u8) {
        if let Some(stale) = self.nodes.get_mut(node_id).and_then(TalkingNode::reset) {
            self.note_other_values(node_id, stale);
        }
    }

    fn error_control(&mut self, node_id: u8, data: &[u8], is_remote: bool) -> FrameKind {
        let bit = 1_u128 << node_id;
        if is_remote {
            self.guarded |= bit;
            return FrameKind::Guarding;
        }
        let is_answer = self.guarded & bit != 0;
        self.guarded &= !bit;
        match data {
            [0, ..] => {
                self.reset(node_id);
                FrameKind::BootUp
            }
            [state, ..] if is_answer || state & 0x80 != 0 => FrameKind::Guarding,
            _ => FrameKind::Heartbeat,
        }
    }

    fn sdo(&mut self, channel: (u8, u16), data: &[u8], is_request: bool) -> DecodedFrame {
        let (node_id, _) = channel;
        let is_download = self.transfers.get(channel).is_some_and(SdoTransfer::is_download);
        // of a log that has the requests alone, all writes but the last one are known to be without an answer
        let unanswered = self.transfers.unanswered_write(channel).filter(|_| is_request && self.has_defaults);
        if let Some(entry) = unanswered {
            self.take_unanswered(channel, entry);
        }
        let sdo = self.transfers.frame(channel, data, is_request);
        if let (Some(_), TransferStep::Write, Some(entry)) = (unanswered, sdo.step, sdo.entry) {
            self.take_unanswered(channel, entry);
        }
        if self.has_defaults && sdo.entry.is_some() {
            self.nodes.add_unknown(node_id);
        }
        if let Some(entry) = sdo.entry {
            let is_accepted = is_download && !is_request && sdo.step == TransferStep::Written;
            let is_answer = !is_download && !is_request && sdo.step.has_value();
            if COMMUNICATION.contains(&entry.0) && (is_accepted || is_answer) {
                self.take(channel, entry, is_accepted);
            } else if self.has_defaults && (is_accepted || is_answer) {
                self.note_use(node_id, entry);
            }
        }
        let service = if is_request { Service::SdoRequest } else { Service::SdoResponse };
        let decoded = DecodedFrame::new(FrameKind::Sdo, Some(service), Some(node_id));
        DecodedFrame { sdo: Some(sdo), ..decoded }
    }

    /// A node without a description uses an entry, which may show that it is a drive.
    fn note_use(&mut self, node_id: u8, entry: (u16, u8)) {
        if self.nodes.get_mut(node_id).is_some_and(|node| node.note_use(entry)) {
            self.note_other_values(node_id, [Stale::All]);
        }
    }

    /// Takes a mapping that was written and that no answer confirms.
    fn take_unanswered(&mut self, channel: (u8, u16), entry: (u16, u8)) {
        if (0x1400..0x1C00).contains(&entry.0) {
            self.take(channel, entry, true);
            if let Some(node) = self.nodes.get_mut(channel.0) {
                node.is_unconfirmed = true;
            }
        }
    }

    /// Takes a value that a node has accepted, or has sent as an answer.
    fn take(&mut self, (node_id, channel): (u8, u16), entry: (u16, u8), is_accepted: bool) {
        let bytes = self.nodes.transferred(&self.transfers, (node_id, channel), entry);
        let Some(node) = self.nodes.get_mut(node_id) else { return };
        match entry {
            (0x1010, 1 | 2) if is_accepted && bytes == b"save" => return node.store(),
            (0x1011, 1 | 2) if is_accepted && bytes == b"load" => return node.restore(),
            (0x1010 | 0x1011, _) => return,
            _ => {}
        }
        let mapped = if self.has_defaults { node.learn_written(entry, bytes) } else { None };
        if node.take(entry, bytes) {
            self.note_change(node_id, entry);
        }
        if let Some(entry) = mapped {
            self.note_use(node_id, entry);
        }
    }

    /// Determines the services of nodes whose values have changed, when a frame may belong to one: a mapping
    /// is written entry by entry.
    fn find_users(&mut self) {
        for (node_id, stale) in std::mem::take(&mut self.stale) {
            if let Some(node) = self.nodes.get_mut(node_id) {
                if self.has_defaults && stale == Stale::All {
                    node.learn_mapped();
                }
                self.users.update(node, stale);
            }
        }
    }

    /// Whether an SDO channel of a description has the CAN-ID that is a default one of a node without a description.
    fn is_channel(&mut self, frame: &RawFrame<'_>) -> bool {
        let is_sdo = |user: &CanIdUser| matches!(user.service, Service::SdoRequest | Service::SdoResponse);
        if !matches!(frame.can_id, 0x581..=0x5FF | 0x601..=0x67F)
            || self.is_described((frame.can_id & 0x7F) as u8)
        {
            return false;
        }
        self.find_users();
        self.users.of(users::key(frame.can_id, false)).is_some_and(|(_, user)| is_sdo(user))
    }

    /// A frame of a service whose CAN-ID is in the dictionary.
    fn configured(&mut self, frame: &RawFrame<'_>) -> DecodedFrame {
        self.find_users();
        let key = users::key(frame.can_id, frame.is_extended);
        let Some((at, &CanIdUser { node_id, service, channel, .. })) = self.users.of(key) else {
            return self.predefined(frame);
        };
        if let Service::SdoRequest | Service::SdoResponse = service {
            if frame.is_remote {
                return DecodedFrame::UNKNOWN;
            }
            return self.sdo((node_id, channel), frame.data, service == Service::SdoRequest);
        }
        let kind = match service {
            Service::Sync => FrameKind::Sync,
            Service::Time => FrameKind::Time,
            Service::Emcy => FrameKind::Emcy,
            _ => FrameKind::Pdo,
        };
        // SYNC and TIME are for all nodes
        let node_id = Some(node_id).filter(|_| !matches!(kind, FrameKind::Sync | FrameKind::Time));
        DecodedFrame { user: at, ..DecodedFrame::new(kind, Some(service), node_id) }
    }

    /// A frame that no description has, by the predefined connection set.
    fn predefined(&mut self, frame: &RawFrame<'_>) -> DecodedFrame {
        let node_id = (frame.can_id & 0x7F) as u8;
        let is_node = node_id != 0;
        let pdo = |kind| Service::pdo(kind, (frame.can_id >> 8) as u16 - u16::from(kind == PdoKind::Rpdo));
        let (kind, service) = match frame.can_id {
            _ if !self.has_defaults || frame.is_extended => (FrameKind::Unknown, None),
            0x080 => (FrameKind::Sync, Some(Service::Sync)),
            0x100 => (FrameKind::Time, Some(Service::Time)),
            0x081..=0x0FF if is_node => (FrameKind::Emcy, Some(Service::Emcy)),
            0x181..=0x57F if is_node && frame.can_id & 0x80 != 0 => {
                (FrameKind::Pdo, Some(pdo(PdoKind::Tpdo)))
            }
            0x181..=0x57F if is_node => (FrameKind::Pdo, Some(pdo(PdoKind::Rpdo))),
            _ => (FrameKind::Unknown, None),
        };
        let has_node = matches!(kind, FrameKind::Emcy | FrameKind::Pdo);
        if has_node {
            self.nodes.add_unknown(node_id);
        }
        DecodedFrame {
            user: usize::MAX,
            ..DecodedFrame::new(kind, service, Some(node_id).filter(|_| has_node))
        }
    }
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

#[cfg(test)]
mod tests;
