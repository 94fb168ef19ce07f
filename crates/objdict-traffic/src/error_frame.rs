//! Error frames in words, as SocketCAN codes them.

use crate::log::LoggedFrame;

/// The classes of errors by the bits of the CAN-ID.
const CLASSES: [&str; 9] = [
    "sending timed out",
    "arbitration lost",
    "controller",
    "protocol violation",
    "transceiver",
    "no acknowledgement",
    "bus-off",
    "bus error",
    "controller restarted",
];

pub(super) fn words(frame: &LoggedFrame) -> String {
    let set = CLASSES.iter().enumerate().filter(|(bit, _)| frame.can_id >> bit & 1 == 1);
    let names: Vec<&str> = set.map(|(_, name)| *name).collect();
    if names.is_empty() { "error frame".to_owned() } else { format!("error frame: {}", names.join(", ")) }
}
