//! Drives by their words (CiA 402-2 §8.4): faults, quick stops, limits, and commands that have no effect.

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

/// How long a drive may take to acknowledge a set-point, in nanoseconds.
const SET_POINT_TIME: i64 = 500_000_000;

/// Bits of the words whose meaning is the same in all modes, or that one mode defines: new set-point, its acknowledgement, the internal limit,
/// and the error of the mode.
const NEW_SET_POINT: u16 = 1 << 4;
const ACKNOWLEDGED: u16 = 1 << 12;
const INTERNAL_LIMIT: u16 = 1 << 11;
const MODE_ERROR: u16 = 1 << 13;

const PROFILE_POSITION: i8 = 1;
const HOMING: i8 = 6;

/// The limit switches in 60FDh: negative and positive.
const SWITCHES: u32 = 3;

/// An object of a drive that shows what it does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum DriveWord {
    Control,
    Status,
    /// The mode of operation that is active.
    Mode,
    /// The digital inputs.
    Inputs,
}

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
    mode: Option<i8>,
    inputs: Option<u32>,
    /// When a set-point was given that is not acknowledged.
    set_point: Option<i64>,
}

/// The drives of a bus.
#[derive(Clone, Debug, Default)]
pub(crate) struct Drives {
    axes: BTreeMap<(u8, u8), Axis>,
    /// Whether time decides what a word says.
    pub(crate) is_waiting: bool,
}

/// The words of drives in a PDO: node, which word, the axis from 1, and the value.
pub(crate) fn words_in(
    decoded: &DecodedFrame,
    frame: &LoggedFrame,
    bus: &Bus<'_>,
) -> Vec<(u8, DriveWord, u8, u32)> {
    let values = bus.reader.values(decoded, &raw(frame));
    if values.is_empty()
        && let Some(word) = default_word(decoded, frame, bus)
    {
        return vec![word];
    }
    let words = values.into_iter().filter_map(|(node_id, entry, value)| {
        let (word, axis) = word_of(entry)?;
        // modes are negative too
        let number = (value.as_integer()? & i128::from(u32::MAX)) as u32;
        is_drive(node_id, bus).then_some((node_id, word, axis, number))
    });
    words.collect()
}

/// Without a mapping, PDO 1 of a drive of two bytes has the words that CiA 402-3 maps by default.
fn default_word(
    decoded: &DecodedFrame,
    frame: &LoggedFrame,
    bus: &Bus<'_>,
) -> Option<(u8, DriveWord, u8, u32)> {
    let (node_id, Some(Service::Pdo(pdo))) = (decoded.node_id?, decoded.service) else { return None };
    let &[low, high] = frame.data() else { return None };
    let is_drive = bus.reader.device(node_id)?.profile() == Some(402);
    let is_default = pdo.number == 1 && decoded.is_predefined() && is_drive;
    let word = if pdo.kind == PdoKind::Tpdo { DriveWord::Status } else { DriveWord::Control };
    is_default.then(|| (node_id, word, 1, u16::from_le_bytes([low, high]).into()))
}

/// Other profiles have other objects there; many drives do not state one.
fn is_drive(node_id: u8, bus: &Bus<'_>) -> bool {
    let profile = bus.reader.device(node_id).and_then(Device::profile);
    matches!(profile, None | Some(0 | 402 | 0xFFFF))
}

/// Which word an entry is, and of which axis.
fn word_of((index, sub): (u16, u8)) -> Option<(DriveWord, u8)> {
    let at = index.checked_sub(0x6000).filter(|at| *at < 0x4000 && sub == 0)?;
    let axis = (at / 0x800) as u8 + 1;
    let word = match at % 0x800 {
        0x40 => DriveWord::Control,
        0x41 => DriveWord::Status,
        0x61 => DriveWord::Mode,
        0xFD => DriveWord::Inputs,
        _ => return None,
    };
    Some((word, axis))
}

impl Drives {
    /// Takes the words in a PDO, or in an SDO.
    pub(crate) fn frame(&mut self, sight: Sight<'_>, book: &mut IncidentBook) {
        let Sight { decoded, frame, bus, .. } = sight;
        if decoded.kind == FrameKind::Pdo {
            // the mode decides what the status says
            let mut words = words_in(decoded, frame, bus);
            words.sort_by_key(|(_, word, ..)| *word == DriveWord::Status);
            for (node_id, word, axis, number) in words {
                self.word((node_id, axis), word, number, sight, book);
            }
            return;
        }
        let Some((sdo, node_id)) = decoded.sdo.zip(decoded.node_id) else { return };
        let Some((word, axis)) = sdo.entry.and_then(word_of) else { return };
        let is_value =
            if word == DriveWord::Control { sdo.step == TransferStep::Written } else { sdo.step.has_value() };
        if !sdo.is_request && is_value && is_drive(node_id, bus) {
            let bytes = bus.reader.transferred_bytes(decoded).unwrap_or_default();
            let number = bytes.iter().take(4).rev().fold(0, |number, byte| number << 8 | u32::from(*byte));
            self.word((node_id, axis), word, number, sight, book);
        }
    }

    fn word(
        &mut self,
        of: (u8, u8),
        word: DriveWord,
        number: u32,
        sight: Sight<'_>,
        book: &mut IncidentBook,
    ) {
        let axis = self.axes.entry(of).or_default();
        let short = number as u16;
        match word {
            DriveWord::Control => axis.control(short, sight.now()),
            DriveWord::Mode => axis.mode = Some(number as i8),
            DriveWord::Inputs => axis.inputs(of, number, sight, book),
            // nothing waits for a word that says the same
            DriveWord::Status if axis.status != Some(short) || axis.is_waiting() => {
                axis.status(of, short, sight, book);
            }
            DriveWord::Status => {}
        }
        self.is_waiting = self.axes.values().any(Axis::is_waiting);
    }
}

impl Axis {
    /// Whether time decides what a word says.
    const fn is_waiting(&self) -> bool {
        self.reset.is_some() || self.enable.is_some() || self.set_point.is_some()
    }

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
        let is_new = word & NEW_SET_POINT != 0 && former.is_some_and(|former| former & NEW_SET_POINT == 0);
        let takes = |status| DriveState::of(status) == DriveState::Enabled && status & ACKNOWLEDGED == 0;
        if is_new && self.mode == Some(PROFILE_POSITION) && self.status.is_some_and(takes) {
            self.set_point = Some(now);
        }
        let is_asked = word & 0x8F == 0x0F;
        self.enable = self.enable.or(Some(now)).filter(|_| is_asked);
    }

    /// A limit switch that becomes active; homing looks for one.
    fn inputs(&mut self, of: (u8, u8), inputs: u32, sight: Sight<'_>, book: &mut IncidentBook) {
        let subject = Subject::new(&rules::LIMIT_SWITCH, of.0, of.1.into());
        let former = self.inputs.replace(inputs);
        let on = inputs & SWITCHES & former.map_or(0, |former| !former);
        if on != 0 && self.mode != Some(HOMING) {
            let which = if on & 1 != 0 { "negative" } else { "positive" };
            let text = || format!("{}: the {which} limit switch is active", name(of, sight));
            book.against(subject, sight.seen(), text);
        } else if inputs & SWITCHES == 0 {
            book.end(subject, || sight.seen(), "no limit switch is active");
        }
    }

    /// The bits of a statusword that are not part of the state.
    fn bits(&mut self, of: (u8, u8), word: u16, former: u16, sight: Sight<'_>, book: &mut IncidentBook) {
        let is_enabled = DriveState::of(word) == DriveState::Enabled;
        let error = match self.mode {
            Some(PROFILE_POSITION | 8) => Some("a following error"),
            Some(3) => Some("too much slippage"),
            Some(HOMING) => Some("an error of homing"),
            _ => None,
        };
        let bits = [
            (&rules::INTERNAL_LIMIT, INTERNAL_LIMIT, Some("an active limit").filter(|_| is_enabled)),
            (&rules::MOTION_ERROR, MODE_ERROR, error),
        ];
        for (rule, bit, what) in bits {
            let subject = Subject::new(rule, of.0, of.1.into());
            match what.filter(|_| word & bit != 0) {
                Some(what) if former & bit == 0 => {
                    book.against(subject, sight.seen(), || format!("{} reports {what}", name(of, sight)));
                }
                Some(_) => {}
                None => book.end(subject, || sight.seen(), "the statusword no longer reports it"),
            }
        }
        let subject = Subject::new(&rules::SET_POINT, of.0, of.1.into());
        if word & ACKNOWLEDGED != 0 {
            book.end(subject, || sight.seen(), "a set-point is acknowledged");
        }
        self.set_point = self.set_point.filter(|_| word & ACKNOWLEDGED == 0 && is_enabled);
        let is_late = |since: &mut i64| sight.now().saturating_sub(*since) > SET_POINT_TIME;
        if self.set_point.take_if(is_late).is_some() {
            let text = || format!("{} does not acknowledge a set-point", name(of, sight));
            book.against(subject, sight.seen(), text);
        }
    }

    fn status(&mut self, of: (u8, u8), word: u16, sight: Sight<'_>, book: &mut IncidentBook) {
        let (node_id, axis) = of;
        let subject = |rule: &'static RuleInfo| Subject::new(rule, node_id, axis.into());
        let (state, now) = (DriveState::of(word), sight.now());
        let former = self.status.replace(word);
        self.bits(of, word, former.unwrap_or(0), sight, book);
        let former = former.map(DriveState::of);
        let drive = || name(of, sight);
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

/// The name of a drive, with its axis if it is not the first one.
fn name((node_id, axis): (u8, u8), sight: Sight<'_>) -> String {
    match axis {
        1 => sight.name(node_id),
        _ => format!("{} axis {axis}", sight.name(node_id)),
    }
}
