//! Why the manager did not boot a node.

use objdict_device::Abort;

/// An error of the process "boot NMT slave" (CiA 302-2).
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum BootFailure {
    /// 1000h cannot be read: nothing answers, or the node aborts.
    NoAnswer(Abort),
    /// An entry of 1000h or 1018h is not what 1F84h to 1F88h of the manager expect.
    Identity {
        /// Index of the entry.
        index: u16,
        /// Sub-index of the entry.
        sub: u8,
        /// What the manager expects.
        expected: u32,
        /// What the node answers.
        found: Result<u32, Abort>,
    },
    /// The manager must not reset a node that is operational (1F81h bit 4), and the node does not say what it is: no heartbeat
    /// came within its consumer time (1016h), in milliseconds.
    NoState(u16),
    /// The same of a node that is guarded.
    NoGuarding,
    /// The node did not restart within a second.
    NoRestart,
    /// The software is to be checked (1F81h bit 5), but 1F55h does not say which one is expected.
    NoSoftwareExpected,
    /// 1F56h is not what 1F55h of the manager expects.
    Software {
        /// What the manager expects.
        expected: u32,
        /// What the node answers.
        found: Result<u32, Abort>,
    },
    /// The node refuses to restore its defaults (1F8Ah).
    Restore(u8, Abort),
    /// The configuration of the node (1F22h) cannot be read.
    Configuration(String),
    /// The node refuses a download of its configuration.
    Download {
        /// Number of the download, counted from 1.
        number: usize,
        /// Index of the entry.
        index: u16,
        /// Sub-index of the entry.
        sub: u8,
        /// The reason.
        abort: Abort,
    },
    /// After the configuration no heartbeat came within the consumer time (1016h), in milliseconds.
    NoHeartbeat(u16),
}

impl BootFailure {
    /// The letter that CiA 302-2 has for the error.
    pub const fn status(&self) -> char {
        match self {
            Self::NoAnswer(_) => 'B',
            Self::Identity { index: 0x1018, sub, .. } => match sub {
                1 => 'D',
                2 => 'M',
                3 => 'N',
                _ => 'O',
            },
            Self::Identity { .. } => 'C',
            Self::NoState(_) => 'E',
            Self::NoGuarding => 'F',
            Self::NoSoftwareExpected => 'G',
            Self::Software { .. } => 'H',
            Self::Restore(..) | Self::Configuration(_) | Self::Download { .. } | Self::NoRestart => 'J',
            Self::NoHeartbeat(_) => 'K',
        }
    }
}

// a sentence without its subject, the node: `has 1018:01 = 000003F9h, but …`
objdict_model::messages! { BootFailure: {
    Self::NoAnswer(Abort::Timeout) => "does not respond";
    Self::NoAnswer(abort) => "aborts the upload of 1000:00: {abort}";
    Self::Identity { index, sub, expected, found } =>
        "{}", compared((*index, *sub), *expected, *found, expecting(*index, *sub));
    Self::NoState(time) =>
        "sends no heartbeat within {time} ms (1016h), so the manager does not know whether it is operational (1F81h bit 4)";
    Self::NoGuarding =>
        "does not respond to node guarding, so the manager does not know whether it is operational (1F81h bit 4)";
    Self::NoRestart => "does not restart within 1 s";
    Self::NoSoftwareExpected => "is to be checked for its software (1F81h bit 5), but 1F55h is 0";
    Self::Software { expected, found } => "{}", compared((0x1F56, 1), *expected, *found, 0x1F55);
    Self::Restore(sub, abort) => "refuses to restore its defaults, 1011:{sub:02X}: {abort}";
    Self::Configuration(reason) => "has no valid configuration: {reason}";
    Self::Download { number, index, sub, abort } =>
        "refuses download {number}, {index:04X}:{sub:02X}: {abort}";
    Self::NoHeartbeat(time) => "sends no heartbeat within {time} ms (1016h)";
} }

/// The object of the manager with the expected value.
const fn expecting(index: u16, sub: u8) -> u16 {
    if index == 0x1000 { 0x1F84 } else { 0x1F84 + sub as u16 }
}

fn compared((index, sub): (u16, u8), expected: u32, found: Result<u32, Abort>, object: u16) -> String {
    match found {
        Ok(found) => format!(
            "has {index:04X}:{sub:02X} = {found:08X}h, but the manager expects {expected:08X}h ({object:04X}h)"
        ),
        Err(abort) => format!("aborts the upload of {index:04X}:{sub:02X}: {abort}"),
    }
}
