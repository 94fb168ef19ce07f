//! An RPDO.

use super::{Parameters, Reception, mapping};
use crate::frame::can_id;
use crate::{Dictionary, Frame};

#[derive(Clone, Copy, Debug)]
pub(super) struct Rpdo {
    parameters: Parameters,
    /// The data that wait for SYNC.
    held: Option<u64>,
    /// When it came last, as long as its absence was not reported.
    came: Option<u64>,
}

impl Rpdo {
    pub(super) const fn new(index: u16) -> Self {
        Self { parameters: Parameters::new(index), held: None, came: None }
    }

    pub(super) const fn index(&self) -> u16 {
        self.parameters.index
    }

    pub(super) fn load<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D) {
        self.parameters.load(dictionary);
        self.restart();
    }

    pub(super) fn restart(&mut self) {
        (self.held, self.came) = (None, None);
    }

    pub(super) const fn has_id(&self, id: u16) -> bool {
        self.parameters.is_valid() && can_id(self.parameters.cob_id) == id
    }

    pub(super) fn receive<D: Dictionary + ?Sized>(
        &mut self,
        dictionary: &mut D,
        frame: &Frame,
        now: u64,
    ) -> Reception {
        let (index, mapping) = (self.index(), self.parameters.mapping());
        match mapping::length(dictionary, mapping) {
            Err(abort) => return Reception::Refused(index, abort),
            Ok(length) if frame.data().len() < usize::from(length) => return Reception::TooShort(index),
            Ok(_) => {}
        }
        self.came = Some(now);
        let data = u64::from_le_bytes(frame.bytes());
        if self.parameters.is_event_driven() {
            return match mapping::unpack(dictionary, mapping, data) {
                Ok(()) => Reception::Written(index),
                Err(abort) => Reception::Refused(index, abort),
            };
        }
        self.held = Some(data);
        Reception::Held(index)
    }

    pub(super) fn sync<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D) {
        if let Some(data) = self.held.take() {
            // what the dictionary refuses stays as it is, and its client is not here to be asked
            let _ = mapping::unpack(dictionary, self.parameters.mapping(), data);
        }
    }

    pub(super) fn overdue(&mut self, now: u64) -> Option<u16> {
        let (came, period) = (self.came?, self.parameters.period()?);
        if !self.parameters.is_valid() || now.saturating_sub(came) < period {
            return None;
        }
        self.came = None;
        Some(self.index())
    }
}
