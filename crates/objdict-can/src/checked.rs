//! A device that is checked for conformance.

use objdict_bus::{Frame, RemoteDevice};

use crate::client::{BusClient, ClientError};
use crate::sim::data_frame;

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
                Ok(None) => return None,
                Ok(Some(frame)) => {
                    if let Some(frame) = data_frame(&frame) {
                        return Some(frame);
                    }
                }
                Err(error) => self.failure = Some(error),
            }
        }
        None
    }
}
