//! An RPDO.

use super::{PdoParameters, Reception};
use crate::frame::can_id;
use crate::{Dictionary, Frame};

#[derive(Clone, Copy, Debug)]
pub(super) struct Rpdo {
    pub(super) parameters: PdoParameters,
    /// The data that wait for SYNC.
    held: Option<u64>,
    /// The time of its last arrival, until its absence is reported.
    came: Option<u64>,
}

impl Rpdo {
    pub(super) const fn new(index: u16) -> Self {
        Self { parameters: PdoParameters::new(index), held: None, came: None }
    }

    pub(super) fn load<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D) {
        self.parameters.load(dictionary);
        self.restart();
    }

    pub(super) fn restart(&mut self) {
        (self.held, self.came) = (None, None);
    }

    /// Whether the RPDO has this CAN-ID. A mapping without entries is disabled (CiA 301 §7.5.2.36), so no
    /// frame is too long for it.
    pub(super) const fn has_id(&self, id: u16) -> bool {
        self.parameters.is_valid()
            && !self.parameters.mapping.is_empty()
            && can_id(self.parameters.cob_id) == id
    }

    pub(super) fn receive<D: Dictionary + ?Sized>(
        &mut self,
        dictionary: &mut D,
        frame: &Frame,
        now: u64,
    ) -> Reception {
        let index = self.parameters.index;
        let length = match self.parameters.mapping.length() {
            Err(abort) => return Reception::Refused(index, abort),
            Ok(length) => usize::from(length),
        };
        if frame.data().len() < length {
            return Reception::TooShort(index);
        }
        self.came = Some(now);
        let data = u64::from_le_bytes(frame.bytes());
        let is_event_driven = self.parameters.is_event_driven();
        if is_event_driven {
            if let Err(abort) = self.parameters.unpack(dictionary, data) {
                return Reception::Refused(index, abort);
            }
        } else {
            self.held = Some(data);
        }
        match frame.data().len() > length {
            true => Reception::TooLong(index),
            false if is_event_driven => Reception::Written(index),
            false => Reception::Held(index),
        }
    }

    pub(super) fn sync<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D) {
        if let Some(data) = self.held.take() {
            // a rejected value remains unchanged, and there is no client to notify
            let _ = self.parameters.unpack(dictionary, data);
        }
    }

    /// The time at which its absence must be reported.
    pub(super) fn deadline(&self) -> Option<u64> {
        let (came, period) = (self.came?, self.parameters.period()?);
        self.parameters.is_valid().then(|| came.saturating_add(period))
    }

    pub(super) fn overdue(&mut self, now: u64) -> Option<u16> {
        if self.deadline()? > now {
            return None;
        }
        self.came = None;
        Some(self.parameters.index)
    }
}
