//! What frames are not as the descriptions say.

use crate::incident::words_in;
use crate::log::LoggedFrame;
use crate::sight::Sight;
use crate::{Bus, raw};
use objdict_document::describe::frames::{DecodedFrame, FrameKind, SdoTransfer, TransferStep};
use objdict_lint::recorded::traffic as rules;
use objdict_model::diagnostic::{RuleInfo, plural};
use objdict_model::model::{Access, DataType, Device, Entry, PdoKind};
use objdict_network::Service;

use super::milliseconds;

/// The abort code of a client that waits no longer.
const TIMEOUT: u32 = 0x0504_0000;

/// The abort code of a command that a node does not know.
const UNKNOWN_COMMAND: u32 = 0x0504_0001;

/// A rule that a frame is against, and how.
pub(super) type Deviation = (&'static RuleInfo, String);

/// What a description says of the frames of a TPDO.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct ExpectedFrames {
    /// How often PDOs had changed when it was found.
    changes: Option<u64>,
    bytes: Option<usize>,
    /// The inhibit time in nanoseconds.
    inhibit: Option<i64>,
    /// The event timer in nanoseconds.
    timer: Option<i64>,
    /// The shortest deadline of the receivers in nanoseconds.
    deadline: Option<i64>,
    /// Whether another TPDO has the CAN-ID, which is not yet reported.
    is_shared: bool,
    /// Whether SYNC triggers it.
    is_synchronous: bool,
    /// The synchronous window length in nanoseconds.
    window: Option<i64>,
    /// Whether it carries words of a drive.
    pub(super) has_words: bool,
    is_wrong: bool,
}

/// What came before a frame, in nanoseconds.
#[derive(Clone, Copy, Debug)]
pub(super) struct Preceding {
    /// The frame before with this CAN-ID.
    pub(super) frame: Option<i64>,
    /// The last SYNC.
    pub(super) sync: Option<i64>,
    /// The last change of the state of the node.
    pub(super) state: Option<i64>,
}

impl ExpectedFrames {
    fn of(decoded: &DecodedFrame, frame: &LoggedFrame, bus: &Bus<'_>) -> Self {
        let changes = Some(bus.reader.changes().pdos);
        let bytes = bus.reader.mapped_bytes(decoded, &raw(frame));
        let device = decoded.node_id.and_then(|node_id| bus.reader.device(node_id));
        let pdo = match decoded.service {
            // only frames of a TPDO are as often as its node sends them
            Some(Service::Pdo(pdo)) if pdo.kind == PdoKind::Tpdo => {
                let pdo = device.and_then(|device| device.pdo(pdo.kind, pdo.number));
                // one with another CAN-ID is not the one of this frame
                pdo.filter(|pdo| pdo.cob_id.is_none() || !decoded.is_predefined())
            }
            _ => None,
        };
        let by_event = pdo.as_ref().filter(|pdo| pdo.transmission_type.is_some_and(|kind| kind >= 254));
        let users = || bus.reader.users(&raw(frame));
        let deadlines = users().filter_map(|(node_id, service)| match service {
            Service::Pdo(pdo) if pdo.kind == PdoKind::Rpdo => {
                bus.reader.device(node_id)?.pdo(pdo.kind, pdo.number)?.event_timer.filter(|time| *time != 0)
            }
            _ => None,
        });
        let deadline = deadlines.min().map(|time| i64::from(time) * 1_000_000);
        let inhibit = by_event.and_then(|pdo| pdo.inhibit_time).filter(|time| *time != 0);
        let timer = by_event.and_then(|pdo| pdo.event_timer).filter(|time| *time != 0);
        let is_synchronous = pdo.is_some_and(|pdo| matches!(pdo.transmission_type, Some(1..=240)));
        let window =
            device.filter(|_| is_synchronous).and_then(|device| device.services().synchronous_window);
        Self {
            changes,
            bytes,
            inhibit: inhibit.map(|time| i64::from(time) * 100_000),
            timer: timer.map(|time| i64::from(time) * 1_000_000),
            deadline,
            is_shared: bus.reader.other_senders(decoded, &raw(frame)).next().is_some(),
            is_synchronous,
            window: window.filter(|window| *window != 0).map(|window| i64::from(window) * 1000),
            has_words: !words_in(decoded, frame, bus).is_empty(),
            is_wrong: false,
        }
    }

    /// Whether a frame has the right length after one that has not.
    pub(super) fn is_right_again(&mut self, frame: &LoggedFrame) -> bool {
        let is_wrong = self.bytes.is_some_and(|bytes| bytes != frame.data().len());
        std::mem::replace(&mut self.is_wrong, is_wrong) && !is_wrong
    }

    /// What is not as described in a frame.
    pub(super) fn deviations(
        &mut self,
        decoded: &DecodedFrame,
        frame: &LoggedFrame,
        bus: &Bus<'_>,
        before: Preceding,
    ) -> Vec<Deviation> {
        if self.changes != Some(bus.reader.changes().pdos) {
            *self = Self::of(decoded, frame, bus);
        }
        let now = frame.time.nanoseconds();
        let count = frame.data().len();
        let length = self.bytes.filter(|bytes| *bytes != count);
        let distance =
            self.inhibit.zip(before.frame).map(|(inhibit, last)| (inhibit, now.saturating_sub(last)));
        // 5 % are the tolerance of clocks
        let early = distance.filter(|(inhibit, distance)| *distance < inhibit / 100 * 95);
        let after = self.window.zip(before.sync).map(|(window, sync)| (window, now.saturating_sub(sync)));
        let late = after.filter(|(window, after)| after > window);
        // a node may be silent when it is stopped
        let last = before.frame.filter(|last| before.state.is_none_or(|state| state <= *last));
        let gap = self.timer.zip(last).map(|(timer, last)| (timer, now.saturating_sub(last)));
        let overdue = gap.filter(|(timer, gap)| *gap > timer / 2 * 3);
        // 5 % are the tolerance of clocks
        let missed = self.deadline.zip(last).map(|(deadline, last)| (deadline, now.saturating_sub(last)));
        let missed = missed.filter(|(deadline, gap)| *gap > deadline / 100 * 105);
        let is_shared = std::mem::take(&mut self.is_shared);
        let last = before.frame.zip(before.sync).filter(|_| self.is_synchronous);
        let is_again = last.is_some_and(|(last, sync)| last >= sync);
        let is_none = length.is_none() && early.is_none() && late.is_none() && overdue.is_none();
        if is_none && missed.is_none() && !is_shared && !is_again {
            return Vec::new();
        }
        let name = name(decoded, bus);
        let texts = [
            length.map(|bytes| (&rules::PDO_LENGTH, format!("{name} has {count} bytes; {bytes} are mapped"))),
            early.map(|(inhibit, distance)| {
                let [distance, inhibit] = [distance, inhibit].map(milliseconds);
                let text = format!("{name} was sent after {distance} ms; its inhibit time is {inhibit} ms");
                (&rules::INHIBIT_TIME, text)
            }),
            late.map(|(window, after)| {
                let [after, window] = [after, window].map(milliseconds);
                let text =
                    format!("{name} was sent {after} ms after SYNC; the synchronous window is {window} ms");
                (&rules::SYNC_WINDOW, text)
            }),
            overdue.map(|(timer, gap)| {
                let [gap, timer] = [gap, timer].map(milliseconds);
                let text = format!("{name} was sent after {gap} ms; its event timer is {timer} ms");
                (&rules::EVENT_TIMER, text)
            }),
            missed.map(|(deadline, gap)| {
                let [gap, deadline] = [gap, deadline].map(milliseconds);
                let text =
                    format!("{name} was sent after {gap} ms; the deadline of its receiver is {deadline} ms");
                (&rules::RPDO_DEADLINE, text)
            }),
            is_shared.then(|| {
                let others = bus.reader.other_senders(decoded, &raw(frame));
                let others: Vec<String> =
                    others.map(|(id, pdo)| format!("{} {pdo}", bus.reader.name(id))).collect();
                let text =
                    format!("{name} has the CAN-ID of {} too: probably both send it", others.join(", "));
                (&rules::SHARED_CAN_ID, text)
            }),
            is_again.then(|| (&rules::REPEATED_PDO, format!("{name} was sent twice after one SYNC"))),
        ];
        texts.into_iter().flatten().collect()
    }
}

pub(super) fn name(decoded: &DecodedFrame, bus: &Bus<'_>) -> String {
    let service = decoded.service.map_or_else(String::new, |service| service.to_string());
    format!("{} {service}", bus.reader.name(decoded.node_id.unwrap_or(0)))
}

/// What a transfer says against the type, the access or the limits of its entry.
pub(super) fn of_transfer(node_id: u8, decoded: &DecodedFrame, bus: &Bus<'_>) -> Option<Deviation> {
    let sdo = decoded.sdo?;
    let is_written = sdo.step == TransferStep::Written;
    let is_answer = !sdo.is_request && sdo.step.has_value();
    let (index, sub) = sdo.entry.filter(|_| is_written || is_answer)?;
    let described = bus.description(node_id)?;
    let entry = described.device.entry(index, sub)?;
    let bytes = bus.reader.transferred_bytes(decoded)?;
    let name = || format!("{}: {}", bus.reader.name(node_id), bus.reader.entry_name(node_id, (index, sub)));
    let access = entry.implied_access();
    match access {
        Some(Access::Ro | Access::Const) if is_written => {
            let word = if access == Some(Access::Const) { "const" } else { "ro" };
            return Some((&rules::SDO_ACCESS, format!("{} is written, but is {word}", name())));
        }
        Some(Access::Wo) if is_answer => {
            return Some((&rules::SDO_ACCESS, format!("{} is read, but is wo", name())));
        }
        _ => {}
    }
    if let Some(text) = other_identity(&described.device, (index, sub), bytes).filter(|_| is_answer) {
        return Some((&rules::OTHER_IDENTITY, format!("{}: {text}", bus.reader.name(node_id))));
    }
    let length = entry.data_type.and_then(DataType::byte_length).map(usize::from);
    if let Some(length) = length.filter(|length| *length != bytes.len()) {
        let text = format!("{} has {} bytes instead of {length}", name(), bytes.len());
        return Some((&rules::SDO_SIZE, text));
    }
    let limits = limits(&entry, node_id);
    if limits == [None; 2] {
        return None;
    }
    let number = bus.reader.transferred(decoded)?.1?.as_integer()?;
    let is_outside = limits[0].is_some_and(|low| number < low) || limits[1].is_some_and(|high| number > high);
    let bound = |limit: Option<i128>| limit.map_or_else(String::new, |limit| limit.to_string());
    is_outside.then(|| {
        let [low, high] = limits.map(bound);
        (&rules::SDO_LIMITS, format!("{} = {number} is outside of the limits {low} to {high}", name()))
    })
}

/// The difference between a response and the described identity. Only the upper half of the revision affects the behaviour.
fn other_identity(device: &Device, (index, sub): (u16, u8), bytes: &[u8]) -> Option<String> {
    let (what, shift) = match (index, sub) {
        (0x1000, 0) => ("the device type", 0),
        (0x1018, 1) => ("the vendor-ID", 0),
        (0x1018, 2) => ("the product code", 0),
        (0x1018, 3) => ("the upper half of the revision", 16),
        _ => return None,
    };
    let is = u32::from_le_bytes(bytes.try_into().ok()?) >> shift;
    let described = u32::try_from(device.value(index, sub)?.as_integer()?).ok()? >> shift;
    (described != 0 && is != described)
        .then(|| format!("{what} is {is:X}h, expected {described:X}h: a different device"))
}

/// The rule that an abort is against: of reads only those that break off are, as a client may ask for what a node does not have.
pub(super) fn of_abort(code: u32, decoded: &DecodedFrame, bus: &Bus<'_>) -> Option<&'static RuleInfo> {
    let is_write = bus.reader.transfer(decoded).is_some_and(SdoTransfer::is_download);
    let is_client = decoded.sdo.is_some_and(|sdo| sdo.is_request);
    match code >> 16 {
        _ if is_client && code == TIMEOUT => Some(&rules::UNANSWERED_REQUEST),
        // toggle bit, time, block size, sequence, checksum
        0x0503 | 0x0504 if code != UNKNOWN_COMMAND => Some(&rules::BROKEN_TRANSFER),
        _ if is_write && !is_client => Some(&rules::REFUSED_WRITE),
        _ => None,
    }
}

/// An abort in words, with the value that was to be written.
pub(super) fn refused(sight: Sight<'_>) -> String {
    let words = sight.words();
    let value = sight.bus.reader.transfer(sight.decoded).filter(|transfer| transfer.is_download());
    match value.map(SdoTransfer::data) {
        Some(data @ [_, ..]) if data.len() <= 8 => {
            let number = data.iter().rev().fold(0, |number, byte| number << 8 | u64::from(*byte));
            format!("{words}; the value was {number} ({number:X}h)")
        }
        _ => words,
    }
}

/// A frame of a service whose length is not the one of the service.
pub(super) fn malformed(decoded: &DecodedFrame, frame: &LoggedFrame) -> Option<String> {
    let count = frame.data().len();
    let is_right = match decoded.kind {
        _ if frame.is_remote || frame.is_fd => true,
        FrameKind::Sync => count <= 1,
        FrameKind::Nmt => count == 2,
        FrameKind::Heartbeat | FrameKind::BootUp | FrameKind::Guarding => count == 1,
        FrameKind::Emcy => count == 8,
        FrameKind::Time => count == 6,
        _ => true,
    };
    (!is_right).then(|| format!("{} with {}", decoded.kind.name(), plural(count, "byte")))
}

fn limits(entry: &Entry, node_id: u8) -> [Option<i128>; 2] {
    [&entry.low_limit, &entry.high_limit].map(|limit| limit.as_ref()?.integer_for(node_id))
}
