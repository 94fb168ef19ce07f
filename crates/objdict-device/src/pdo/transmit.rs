//! A TPDO.

use super::PdoParameters;
use crate::clock::earlier;
use crate::{Dictionary, Frame};

#[derive(Clone, Copy, Debug)]
pub(super) struct Tpdo {
    pub(super) parameters: PdoParameters,
    /// Whether the application requested it.
    requested: bool,
    /// Whether a SYNC triggered it.
    due: bool,
    /// SYNCs since its last transmission; `None` before the first counted one.
    syncs: Option<u8>,
    /// The time and content of the last transmission.
    sent: Option<(u64, u64)>,
}

impl Tpdo {
    pub(super) const fn new(index: u16) -> Self {
        let parameters = PdoParameters::new(index);
        Self { parameters, requested: false, due: false, syncs: None, sent: None }
    }

    pub(super) fn load<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D) {
        self.parameters.load(dictionary);
        self.restart();
    }

    pub(super) const fn restart(&mut self) {
        (self.syncs, self.sent, self.due) = (None, None, false);
        self.requested = self.parameters.is_event_driven();
    }

    pub(super) const fn request(&mut self) {
        self.requested = self.parameters.transmission_type == 0 || self.parameters.is_event_driven();
    }

    pub(super) fn request_if_changed<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D) {
        let sent = self.sent.map(|(_, frame)| frame);
        if self.parameters.is_valid()
            && self.parameters.pack(dictionary).is_ok_and(|(frame, _)| Some(frame) != sent)
        {
            self.request();
        }
    }

    /// Counts a SYNC. The first one has a counter equal to the SYNC start value.
    pub(super) fn sync(&mut self, counter: Option<u8>) {
        let start = self.parameters.sync_start;
        match self.parameters.transmission_type {
            0 => self.due |= core::mem::take(&mut self.requested),
            every @ 1..=240 => {
                let waits =
                    self.syncs.is_none() && start != 0 && counter.is_some_and(|counter| counter != start);
                if !waits {
                    let syncs = self.syncs.unwrap_or(0).saturating_add(1);
                    self.due |= syncs >= every;
                    self.syncs = Some(if syncs >= every { 0 } else { syncs });
                }
            }
            _ => {}
        }
    }

    /// The time at which it must be sent, as far as that is known without a SYNC or a request.
    pub(super) fn next(&self, now: u64) -> Option<u64> {
        let parameters = &self.parameters;
        if !parameters.is_valid() {
            return None;
        }
        if !parameters.is_event_driven() {
            return self.due.then_some(now);
        }
        let sent = self.sent.map(|(at, _)| at);
        let requested = self.requested.then_some(now);
        let timer = sent.zip(parameters.period()).map(|(sent, period)| sent.saturating_add(period));
        let inhibited = sent.map(|sent| sent.saturating_add(u64::from(parameters.inhibit_time) * 100));
        earlier(requested, timer).map(|due| due.max(inhibited.unwrap_or(0)))
    }

    pub(super) fn is_due(&self, now: u64) -> bool {
        self.next(now).is_some_and(|due| due <= now)
    }

    /// The frame; `None` for a mapping without entries, or with an unreadable entry.
    pub(super) fn send<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D, now: u64) -> Option<Frame> {
        (self.requested, self.due) = (false, false);
        let packed = self.parameters.pack(dictionary);
        let (frame, length) = packed.unwrap_or_default();
        self.sent = Some((now, frame));
        (length > 0).then(|| Frame::full(self.parameters.cob_id, frame.to_le_bytes()).shortened(length))
    }
}
