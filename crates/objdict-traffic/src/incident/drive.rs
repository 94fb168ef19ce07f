//! Drives by their words (CiA 402-2 §8.4): faults, quick stops, and commands that have no effect.

use std::collections::BTreeMap;

use super::book::{IncidentBook, Subject};
use crate::log::LoggedFrame;
use crate::sight::Sight;
use crate::{Bus, raw};
use objdict_document::describe::frames::{DecodedFrame, FrameKind, TransferStep};
use objdict_lint::recorded::traffic as rules;
use objdict_model::diagnostic::RuleInfo;
use objdict_model::model::{Device, PdoKind};
use objdict_network::Service;

const FAULT_RESET: u16 = 0x80;

/// How long a drive may take for the reset of a fault, in nanoseconds.
const RESET_TIME: i64 = 300_000_000;

/// How long a drive may take to enable operation, in nanoseconds: brakes and commutation take their time.
const ENABLE_TIME: i64 = 2_000_000_000;

/// The state of a drive by its statusword.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum DriveState {
    Off,
    Ready,
    Enabled,
    QuickStop,
    Fault,
}

impl DriveState {
    const fn of(status: u16) -> Self {
        match (status & 0x4F, status & 0x6F) {
            (0x08 | 0x0F, _) => Self::Fault,
            (_, 0x27) => Self::Enabled,
            (_, 0x07) => Self::QuickStop,
            (_, 0x21 | 0x23) => Self::Ready,
            _ => Self::Off,
        }
    }

    const fn words(self) -> &'static str {
        match self {
            Self::Off => "switch on disabled",
            Self::Ready => "not enabled",
            Self::Enabled => "operation enabled",
            Self::QuickStop => "quick stop active",
            Self::Fault => "fault",
        }
    }
}

/// An axis of a drive.
#[derive(Clone, Copy, Debug, Default)]
struct Axis {
    status: Option<u16>,
    control: Option<u16>,
    /// Whether it was in a fault and has not enabled operation since.
    was_faulty: bool,
    resets: u32,
    /// When a reset of the fault was asked for, in nanoseconds.
    reset: Option<i64>,
    /// Since when operation is asked for.
    enable: Option<i64>,
}

/// The drives of a bus.
#[derive(Debug, Default)]
pub(crate) struct Drives {
    axes: BTreeMap<(u8, u8), Axis>,
    /// Whether time decides what a word says.
    pub(crate) is_waiting: bool,
}

/// The words of drives in a PDO: node, whether it is the statusword, the axis from 1, and the value.
pub(crate) fn words_in(
    decoded: &DecodedFrame,
    frame: &LoggedFrame,
    bus: &Bus<'_>,
) -> Vec<(u8, bool, u8, u16)> {
    let values = bus.reader.values(decoded, &raw(frame));
    if values.is_empty()
        && let Some(word) = default_word(decoded, frame, bus)
    {
        return vec![word];
    }
    let words = values.into_iter().filter_map(|(node_id, entry, value)| {
        let (is_status, axis) = word_of(entry)?;
        let number = u16::try_from(value.as_integer()?).ok()?;
        is_drive(node_id, bus).then_some((node_id, is_status, axis, number))
    });
    words.collect()
}

/// Without a mapping, PDO 1 of a drive of two bytes has the words that CiA 402-3 maps by default.
fn default_word(decoded: &DecodedFrame, frame: &LoggedFrame, bus: &Bus<'_>) -> Option<(u8, bool, u8, u16)> {
    let (node_id, Some(Service::Pdo(pdo))) = (decoded.node_id?, decoded.service) else { return None };
    let &[low, high] = frame.data() else { return None };
    let is_drive = bus.reader.device(node_id)?.profile() == Some(402);
    let is_default = pdo.number == 1 && decoded.is_predefined() && is_drive;
    is_default.then(|| (node_id, pdo.kind == PdoKind::Tpdo, 1, u16::from_le_bytes([low, high])))
}

/// Other profiles have other objects there; many drives do not state one.
fn is_drive(node_id: u8, bus: &Bus<'_>) -> bool {
    let profile = bus.reader.device(node_id).and_then(Device::profile);
    matches!(profile, None | Some(0 | 402 | 0xFFFF))
}

/// Whether an entry is a statusword, else a controlword, and of which axis.
fn word_of((index, sub): (u16, u8)) -> Option<(bool, u8)> {
    let at = index.checked_sub(0x6000).filter(|at| *at < 0x4000 && sub == 0)?;
    let axis = (at / 0x800) as u8 + 1;
    match at % 0x800 {
        0x41 => Some((true, axis)),
        0x40 => Some((false, axis)),
        _ => None,
    }
}

impl Drives {
    /// Takes the words in a PDO, or in an SDO.
    pub(crate) fn frame(&mut self, sight: Sight<'_>, book: &mut IncidentBook) {
        let Sight { decoded, frame, bus, .. } = sight;
        if decoded.kind == FrameKind::Pdo {
            for (node_id, is_status, axis, word) in words_in(decoded, frame, bus) {
                self.word((node_id, axis), is_status, word, sight, book);
            }
            return;
        }
        let Some((sdo, node_id)) = decoded.sdo.zip(decoded.node_id) else { return };
        let Some((is_status, axis)) = sdo.entry.and_then(word_of) else { return };
        let is_value = if is_status { sdo.step.has_value() } else { sdo.step == TransferStep::Written };
        let is_taken = is_value && !sdo.is_request && is_drive(node_id, bus);
        if let (true, Some(&[low, high, ..])) = (is_taken, bus.reader.transferred_bytes(decoded)) {
            self.word((node_id, axis), is_status, u16::from_le_bytes([low, high]), sight, book);
        }
    }

    fn word(&mut self, of: (u8, u8), is_status: bool, word: u16, sight: Sight<'_>, book: &mut IncidentBook) {
        let axis = self.axes.entry(of).or_default();
        if !is_status {
            axis.control(word, sight.now());
        } else if axis.status != Some(word) || axis.reset.is_some() || axis.enable.is_some() {
            // nothing waits for a word that says the same
            axis.status(of, word, sight, book);
        }
        self.is_waiting = self.axes.values().any(|axis| axis.reset.is_some() || axis.enable.is_some());
    }
}

impl Axis {
    fn control(&mut self, word: u16, now: i64) {
        let former = self.control.replace(word);
        if former == Some(word) {
            return;
        }
        let is_faulty = self.status.is_some_and(|status| DriveState::of(status) == DriveState::Fault);
        let is_rising = word & FAULT_RESET != 0 && former.is_none_or(|former| former & FAULT_RESET == 0);
        if is_faulty && is_rising && self.reset.is_none() {
            (self.reset, self.resets) = (Some(now), self.resets + 1);
        }
        let is_asked = word & 0x8F == 0x0F;
        self.enable = self.enable.or(Some(now)).filter(|_| is_asked);
    }

    fn status(&mut self, of: (u8, u8), word: u16, sight: Sight<'_>, book: &mut IncidentBook) {
        let (node_id, axis) = of;
        let subject = |rule: &'static RuleInfo| Subject::new(rule, node_id, axis.into());
        let (state, now) = (DriveState::of(word), sight.now());
        let former = self.status.replace(word).map(DriveState::of);
        let drive = || match axis {
            1 => sight.name(node_id),
            _ => format!("{} axis {axis}", sight.name(node_id)),
        };
        if state == DriveState::Fault {
            if self.reset.take_if(|reset| now.saturating_sub(*reset) > RESET_TIME).is_some() {
                let text = format!("reset {} of the fault has no effect", self.resets);
                book.step(subject(&rules::DRIVE_FAULT), sight.seen(), &text);
            }
            if former != Some(DriveState::Fault) {
                (self.was_faulty, self.resets, self.reset) = (true, 0, None);
                book.against(subject(&rules::DRIVE_FAULT), sight.seen(), || {
                    format!("{} is in a fault", drive())
                });
            }
        }
        if former != Some(state) {
            if former == Some(DriveState::Fault) {
                let text = format!("the fault is cleared: {}", state.words());
                book.end(subject(&rules::DRIVE_FAULT), || sight.seen(), &text);
            }
            if former == Some(DriveState::QuickStop) {
                book.end(subject(&rules::QUICK_STOP), || sight.seen(), state.words());
            }
            let is_asked = self.control.is_none_or(|control| control & 4 == 0);
            if state == DriveState::QuickStop && former.is_some() && !is_asked {
                let text = || format!("{} stops by itself: quick stop active", drive());
                book.against(subject(&rules::QUICK_STOP), sight.seen(), text);
            }
        }
        if state == DriveState::Enabled {
            if former != Some(state) && std::mem::take(&mut self.was_faulty) {
                book.step(subject(&rules::DRIVE_FAULT), sight.seen(), "operation is enabled again");
            }
            if former != Some(state) {
                book.end(subject(&rules::REFUSED_TRANSITION), || sight.seen(), state.words());
            }
            self.enable = None;
        } else if matches!(state, DriveState::Off | DriveState::Ready)
            && self.enable.is_some_and(|since| now.saturating_sub(since) > ENABLE_TIME)
        {
            // said once: the word has to ask for something else before it asks again
            self.enable = Some(i64::MAX);
            let text = || format!("{} does not enable operation: {}", drive(), state.words());
            book.against(subject(&rules::REFUSED_TRANSITION), sight.seen(), text);
        }
    }
}
