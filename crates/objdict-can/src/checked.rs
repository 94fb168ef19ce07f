//! A device that is checked for conformance.

use objdict_bus::{Frame, RemoteDevice};

use crate::client::{BusClient, ClientError};

/// A client with the first error of its bus: what follows it is silence.
pub struct CheckedDevice {
    /// The client.
    pub client: BusClient,
    /// The reason why the bus can no longer be used.
    pub failure: Option<ClientError>,
}

impl RemoteDevice for CheckedDevice {
    fn send(&mut self, frame: &Frame) -> bool {
        if self.failure.is_none() {
            self.failure = self.client.send(&(*frame).into()).err();
        }
        self.failure.is_none()
    }

    fn now(&self) -> u64 {
        self.client.now()
    }

    fn receive(&mut self, until: u64) -> Option<Frame> {
        while self.failure.is_none() {
            match self.client.next_frame(until) {
                Ok(Some(frame)) if frame.is_extended || frame.is_error || frame.is_remote => {}
                Ok(Some(frame)) => return Frame::new(u16::try_from(frame.can_id).ok()?, frame.data()),
                Ok(None) => return None,
                Err(error) => self.failure = Some(error),
            }
        }
        None
    }
}
