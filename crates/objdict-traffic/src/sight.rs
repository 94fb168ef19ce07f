//! A frame with all that is known of it.

use crate::history::Seen;
use crate::log::LoggedFrame;
use crate::{Bus, Origin};
use objdict_document::describe::frames::DecodedFrame;

/// A frame in its log, and what it is on its bus.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sight<'s> {
    pub(crate) decoded: &'s DecodedFrame,
    pub(crate) frame: &'s LoggedFrame,
    pub(crate) origin: Origin<'s>,
    pub(crate) bus: &'s Bus<'s>,
}

impl Sight<'_> {
    pub(crate) fn seen(&self) -> Seen {
        Seen::of(self.frame, self.origin)
    }

    pub(crate) fn now(&self) -> i64 {
        self.frame.time.nanoseconds()
    }

    pub(crate) fn name(&self, node_id: u8) -> String {
        self.bus.reader.name(node_id)
    }

    pub(crate) fn words(&self) -> String {
        self.bus.words(self.decoded, self.frame)
    }
}
