//! Errors of the node: error register, history and emergency messages (CiA 301 §7.2.7).

use crate::dictionary::word;
use crate::frame::{EXTENDED, NOT_VALID};
use crate::{Abort, Dictionary, Frame};

/// The error register.
const REGISTER: u16 = 0x1001;
/// The error history, newest first.
pub(crate) const HISTORY: u16 = 0x1003;
/// The COB-ID of emergency messages.
pub(crate) const COB_ID: u16 = 0x1014;
/// The inhibit time of emergency messages, in units of 100 µs.
pub(crate) const INHIBIT_TIME: u16 = 0x1015;

/// As many errors can be active at a time.
const ACTIVE: usize = 8;

/// The maximum number of messages that wait for the inhibit time or until the node may send; further ones are
/// only in the history.
const WAITING: usize = 4;

/// Error codes that the services of a node report (CiA 301 §7.2.7.1).
pub mod error_code {
    /// Stored values are lost.
    pub const DATA_SET: u16 = 0x6300;
    /// CAN messages were lost.
    pub const CAN_OVERRUN: u16 = 0x8110;
    /// The CAN controller is error passive.
    pub const ERROR_PASSIVE: u16 = 0x8120;
    /// The heartbeat of a node is missing.
    pub const HEARTBEAT: u16 = 0x8130;
    /// The CAN controller was bus-off.
    pub const BUS_OFF: u16 = 0x8140;
    /// A PDO was too short and was not processed.
    pub const PDO_TOO_SHORT: u16 = 0x8210;
    /// A PDO was too long; its first bytes were processed.
    pub const PDO_TOO_LONG: u16 = 0x8220;
    /// A SYNC with an unexpected length.
    pub const SYNC_LENGTH: u16 = 0x8240;
    /// An RPDO that did not arrive within its event timer.
    pub const RPDO_TIMEOUT: u16 = 0x8250;
}

/// The errors of a node. An error is identified by its code and two bytes, such as the number of a PDO, so that each is
/// reported only once while it is active.
#[derive(Clone, Debug)]
pub struct Errors {
    node_id: u8,
    active: [Option<(u16, [u8; 2])>; ACTIVE],
    /// Oldest first.
    waiting: [Option<[u8; 8]>; WAITING],
    /// `None` while EMCY is not valid.
    cob_id: Option<u32>,
    /// In microseconds.
    inhibit_time: u64,
    sent: Option<u64>,
}

impl Errors {
    /// No errors.
    #[must_use]
    pub const fn new(node_id: u8) -> Self {
        Self {
            node_id,
            active: [None; ACTIVE],
            waiting: [None; WAITING],
            cob_id: None,
            inhibit_time: 0,
            sent: None,
        }
    }

    /// Starts without errors, after a reset.
    pub fn boot<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D) {
        *self = Self::new(self.node_id);
        // an application may have neither
        if are_kept(dictionary) {
            let _ = put(dictionary, REGISTER, 0, 0);
        }
        if dictionary.objects().has(HISTORY) {
            let _ = put(dictionary, HISTORY, 0, 0);
        }
        if dictionary.objects().has(COB_ID) {
            self.load(dictionary);
        }
    }

    /// Reads 1014h and 1015h, after a write to one of them. A device without 1014h does not send EMCY (CiA
    /// 301 §7.5.2.17).
    pub fn load<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D) {
        let cob_id = word(dictionary, COB_ID, 0, NOT_VALID);
        self.cob_id = (cob_id & (NOT_VALID | EXTENDED) == 0).then_some(cob_id);
        self.inhibit_time = u64::from(word(dictionary, INHIBIT_TIME, 0, 0).min(0xFFFF)) * 100;
    }

    /// The error register.
    #[must_use]
    pub fn register(&self) -> u8 {
        let bits = self.active.iter().flatten().map(|(code, _)| class(*code));
        bits.fold(0, |register, bit| register | 1 | bit)
    }

    /// Reports an error with a code, such as 8130h, and vendor-specific bytes, unless the error with this code and
    /// first two bytes is already active. Returns whether it is new.
    pub fn report<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D, code: u16, vendor: [u8; 5]) -> bool {
        let [low, high, ..] = vendor;
        let error = Some((code, [low, high]));
        if self.active.contains(&error) {
            return false;
        }
        if let Some(room) = self.active.iter_mut().find(|active| active.is_none()) {
            *room = error;
        }
        self.send(dictionary, code, vendor, self.register() | class(code) | 1);
        let _ = put(dictionary, REGISTER, 0, u32::from(self.register()));
        let [code_low, code_high] = code.to_le_bytes();
        remember(dictionary, [code_low, code_high, low, high]);
        true
    }

    /// Reports that an error no longer exists. Returns whether it was active.
    pub fn resolve<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D, code: u16, name: [u8; 2]) -> bool {
        let Some(active) = self.active.iter_mut().find(|active| **active == Some((code, name))) else {
            return false;
        };
        *active = None;
        let [low, high] = name;
        self.send(dictionary, 0, [low, high, 0, 0, 0], self.register());
        let _ = put(dictionary, REGISTER, 0, u32::from(self.register()));
        true
    }

    fn send<D: Dictionary + ?Sized>(
        &mut self,
        dictionary: &D,
        code: u16,
        [a, b, c, d, e]: [u8; 5],
        register: u8,
    ) {
        if !dictionary.objects().has(COB_ID) {
            return;
        }
        let [low, high] = code.to_le_bytes();
        let room = self.waiting.iter_mut().find(|waiting| waiting.is_none());
        if let Some(room) = room.filter(|_| self.cob_id.is_some()) {
            *room = Some([low, high, register, a, b, c, d, e]);
        }
    }

    /// The next emergency message that may be sent at `now`, in microseconds.
    pub fn poll(&mut self, now: u64) -> Option<Frame> {
        if self.next(now)? > now {
            return None;
        }
        // `rotate_left` would link the 700 bytes of `memmove`
        let mut first = None;
        self.waiting.iter_mut().rev().for_each(|waiting| core::mem::swap(&mut first, waiting));
        let bytes = first?;
        self.sent = Some(now);
        self.cob_id.map(|cob_id| Frame::full(cob_id, bytes))
    }

    /// The time at which the next message may be sent.
    #[must_use]
    pub fn next(&self, now: u64) -> Option<u64> {
        let waits = self.waiting.iter().any(Option::is_some);
        let after = self.sent.map_or(now, |sent| sent.saturating_add(self.inhibit_time).max(now));
        waits.then_some(after)
    }
}

/// Whether a node keeps its errors: without messages and history, it leaves the error register to the application.
#[inline(always)]
pub(crate) fn are_kept<D: Dictionary + ?Sized>(dictionary: &D) -> bool {
    dictionary.objects().has(COB_ID) || dictionary.objects().has(HISTORY)
}

/// The bit of the error register for a code (CiA 301 §7.5.2.2).
const fn class(code: u16) -> u8 {
    match code >> 12 {
        0x2 => 1 << 1,
        0x3 => 1 << 2,
        0x4 => 1 << 3,
        0x8 => 1 << 4,
        0xF if code >= 0xFF00 => 1 << 7,
        _ => 0,
    }
}

/// Puts an error at the start of the history; the oldest one is dropped when it is full.
fn remember<D: Dictionary + ?Sized>(dictionary: &mut D, error: [u8; 4]) {
    if !dictionary.objects().has(HISTORY) {
        return;
    }
    let Ok(count) = dictionary.number(HISTORY, 0) else { return };
    let mut rest = u32::from_le_bytes(error);
    let mut sub = 0;
    while u64::from(sub) <= count && sub < 0xFE {
        let old = dictionary.number(HISTORY, sub + 1).unwrap_or(0) as u32;
        if put(dictionary, HISTORY, sub + 1, rest).is_err() {
            break;
        }
        (rest, sub) = (old, sub + 1);
    }
    let _ = put(dictionary, HISTORY, 0, u32::from(sub));
}

/// Replaces a number, using the length from the description.
fn put<D: Dictionary + ?Sized>(dictionary: &mut D, index: u16, sub: u8, value: u32) -> Result<(), Abort> {
    let size = dictionary.attributes(index, sub)?.size;
    let bytes = value.to_le_bytes();
    dictionary.replace(index, sub, bytes.get(..size).unwrap_or(&bytes))
}
