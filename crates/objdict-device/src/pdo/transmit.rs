//! A TPDO.

use super::{Parameters, mapping};
use crate::{Dictionary, Frame};

#[derive(Clone, Copy, Debug)]
pub(super) struct Tpdo {
    parameters: Parameters,
    /// Whether the application asked for it.
    requested: bool,
    /// Whether a SYNC asked for it.
    due: bool,
    /// SYNCs since it was sent; `None` before the first one that counts.
    syncs: Option<u8>,
    /// When it was sent last, and what.
    sent: Option<(u64, u64)>,
}

impl Tpdo {
    pub(super) const fn new(index: u16) -> Self {
        Self { parameters: Parameters::new(index), requested: false, due: false, syncs: None, sent: None }
    }

    pub(super) const fn index(&self) -> u16 {
        self.parameters.index
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
            && mapping::pack(dictionary, self.parameters.mapping())
                .is_ok_and(|(frame, _)| Some(frame) != sent)
        {
            self.request();
        }
    }

    /// Counts a SYNC. The one whose counter is the SYNC start value is the first.
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

    pub(super) fn is_due(&self, now: u64) -> bool {
        let since = self.sent.map(|(at, _)| now.saturating_sub(at));
        let parameters = &self.parameters;
        if !parameters.is_valid() {
            return false;
        }
        if !parameters.is_event_driven() {
            return self.due;
        }
        let timer = since.zip(parameters.period()).is_some_and(|(since, period)| since >= period);
        let inhibited = since.is_some_and(|since| since < u64::from(parameters.inhibit_time) * 100);
        (self.requested || timer) && !inhibited
    }

    /// The frame; `None` for a mapping without entries, or with one that cannot be read.
    pub(super) fn send<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D, now: u64) -> Option<Frame> {
        (self.requested, self.due) = (false, false);
        let packed = mapping::pack(dictionary, self.parameters.mapping());
        let (frame, length) = packed.unwrap_or_default();
        self.sent = Some((now, frame));
        (length > 0).then(|| Frame::full(self.parameters.cob_id, frame.to_le_bytes()).shortened(length))
    }
}
