//! Settings of a node.

use std::fmt;
use std::str::FromStr;

use crate::model::PdoKind;
use crate::resolve::ObjectName;

/// One setting.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Setting {
    /// Sets an entry to a value, spelled as in a DCF.
    Value {
        /// The entry; for a VAR, the object.
        at: ObjectName,
        /// The value.
        text: String,
    },
    /// Replaces the mapping of a PDO by these entries, in this order.
    Map {
        /// The PDO.
        pdo: PdoName,
        /// The entries; for an RPDO also data types as dummy entries (`0005`).
        objects: Vec<ObjectName>,
    },
    /// Sets the CAN-ID of a PDO.
    CobId {
        /// The PDO.
        pdo: PdoName,
        /// The CAN-ID.
        id: CanId,
    },
    /// Monitors the heartbeat of another node.
    HeartbeatConsumer {
        /// The monitored node.
        node_id: u8,
        /// The consumer heartbeat time in milliseconds.
        milliseconds: u16,
    },
}

/// A PDO by its name, such as `tpdo1`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct PdoName {
    /// The direction.
    pub kind: PdoKind,
    /// The PDO number, 1 to 512.
    pub number: u16,
}

/// The CAN-ID of a PDO.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CanId {
    /// A fixed CAN-ID: 11 bits up to 7FFh, 29 bits above.
    Number(u32),
    /// The node-ID plus an offset.
    PerNode(u32),
    /// No CAN-ID: the PDO is not valid.
    Off,
}

/// A text that is not a valid setting.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{text}` is not a setting: {expected}")]
pub struct NoSetting {
    /// The text.
    text: String,
    /// The expected syntax.
    expected: &'static str,
}

impl NoSetting {
    fn new(text: &str, expected: &'static str) -> Self {
        Self { text: text.to_owned(), expected }
    }
}

impl Setting {
    /// `1017=250`, `1800:2=1`, `2001="a text"`, `Producer heartbeat time=250`.
    ///
    /// # Errors
    /// Fails if the text does not match this syntax.
    pub fn value(text: &str) -> Result<Self, NoSetting> {
        let wrong =
            || NoSetting::new(text, "write an entry and its value, as in `1017=250` or `1800:2=0xFE`");
        let (at, value) = text.split_once('=').ok_or_else(wrong)?;
        let at = at.parse().map_err(|_| wrong())?;
        Ok(Self::Value { at, text: value.trim().to_owned() })
    }

    /// `tpdo1=6000:1,6401:2`, `tpdo1=Statusword`; an empty list after `=` clears the mapping.
    ///
    /// # Errors
    /// Fails if the text does not match this syntax.
    pub fn map(text: &str) -> Result<Self, NoSetting> {
        let wrong = || NoSetting::new(text, "write a PDO and its mapping, as in `tpdo1=6000:1,6401:2`");
        let (pdo, objects) = text.split_once('=').ok_or_else(wrong)?;
        let pdo = pdo.parse().map_err(|_| wrong())?;
        let objects = objects.split(',').map(str::trim).filter(|object| !object.is_empty());
        let objects = objects.map(|object| object.parse().map_err(|_| wrong()));
        Ok(Self::Map { pdo, objects: objects.collect::<Result<_, _>>()? })
    }

    /// `rpdo2=0x2AA`, `tpdo1=$NODEID+0x180`, `tpdo3=off`.
    ///
    /// # Errors
    /// Fails if the text does not match this syntax.
    pub fn cob_id(text: &str) -> Result<Self, NoSetting> {
        let wrong = || NoSetting::new(text, "write a PDO and its CAN-ID, as in `rpdo2=0x2AA` or `tpdo3=off`");
        let (pdo, id) = text.split_once('=').ok_or_else(wrong)?;
        let pdo = pdo.parse().map_err(|_| wrong())?;
        Ok(Self::CobId { pdo, id: id.parse().map_err(|()| wrong())? })
    }

    /// `7=750ms`, `7=750`, `9=1.5s`.
    ///
    /// # Errors
    /// Fails if the text does not match this syntax.
    pub fn heartbeat_consumer(text: &str) -> Result<Self, NoSetting> {
        let wrong = || {
            NoSetting::new(text, "write a node-ID from 1 to 127 and a time up to 65535 ms, as in `7=750ms`")
        };
        let (node, time) = text.split_once('=').ok_or_else(wrong)?;
        let node_id = number(node).and_then(|number| u8::try_from(number).ok());
        let node_id = node_id.filter(|node_id| (1..=127).contains(node_id)).ok_or_else(wrong)?;
        let milliseconds = milliseconds(time).ok_or_else(wrong)?;
        Ok(Self::HeartbeatConsumer { node_id, milliseconds })
    }
}

/// A decimal number, or a hexadecimal one with prefix `0x`.
fn number(text: &str) -> Option<u32> {
    let text = text.trim();
    match text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")) {
        Some(digits) if !digits.starts_with('+') => u32::from_str_radix(digits, 16).ok(),
        Some(_) => None,
        None if text.starts_with('+') => None,
        None => text.parse().ok(),
    }
}

fn milliseconds(text: &str) -> Option<u16> {
    let text = text.trim();
    if let Some(number) = text.strip_suffix("ms") {
        return number.trim().parse().ok();
    }
    let Some(seconds) = text.strip_suffix('s') else { return text.parse().ok() };
    let (whole, fraction) = seconds.trim().split_once('.').unwrap_or((seconds.trim(), ""));
    if fraction.len() > 3 || !fraction.bytes().all(|digit| digit.is_ascii_digit()) {
        return None;
    }
    let whole: u32 = whole.parse().ok()?;
    let fraction: u32 = format!("{fraction:0<3}").parse().ok()?;
    u16::try_from(whole.checked_mul(1000)?.checked_add(fraction)?).ok()
}

impl FromStr for PdoName {
    type Err = ();

    fn from_str(text: &str) -> Result<Self, ()> {
        let lower = text.trim().to_ascii_lowercase();
        let kinds = [("rpdo", PdoKind::Rpdo), ("tpdo", PdoKind::Tpdo)];
        let found = kinds.into_iter().find_map(|(word, kind)| {
            let number: u16 = lower.strip_prefix(word)?.parse().ok()?;
            kind.communication_index(number).map(|_| Self { kind, number })
        });
        found.ok_or(())
    }
}

impl fmt::Display for PdoName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.kind.name().to_ascii_lowercase(), self.number)
    }
}

impl FromStr for CanId {
    type Err = ();

    fn from_str(text: &str) -> Result<Self, ()> {
        let text = text.trim();
        if text.eq_ignore_ascii_case("off") {
            return Ok(Self::Off);
        }
        let upper = text.to_ascii_uppercase();
        let (id, is_per_node) = match upper.strip_prefix("$NODEID") {
            Some("") => (Some(0), true),
            Some(rest) => (
                rest.trim_start().strip_prefix('+').and_then(|rest| number(&rest.to_ascii_lowercase())),
                true,
            ),
            None => (number(text), false),
        };
        match id.filter(|&id| id <= 0x1FFF_FFFF - 127) {
            Some(id) if is_per_node => Ok(Self::PerNode(id)),
            Some(id) => Ok(Self::Number(id)),
            None => Err(()),
        }
    }
}

impl fmt::Display for CanId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => write!(f, "0x{number:X}"),
            Self::PerNode(number) => write!(f, "$NODEID+0x{number:X}"),
            Self::Off => f.write_str("off"),
        }
    }
}

/// The syntax of the command-line option.
impl fmt::Display for Setting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Value { at, text } => write!(f, "{at}={text}"),
            Self::Map { pdo, objects } => {
                let objects: Vec<String> = objects.iter().map(ToString::to_string).collect();
                write!(f, "{pdo}={}", objects.join(","))
            }
            Self::CobId { pdo, id } => write!(f, "{pdo}={id}"),
            Self::HeartbeatConsumer { node_id, milliseconds } => write!(f, "{node_id}={milliseconds}ms"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn settings_are_written_as_they_are_read() {
        for text in
            ["1017=250", "1800:2=0xFE", "2001=\"a = b\"", "1F80=$NODEID+0x1", "Producer heartbeat time=250"]
        {
            assert_eq!(Setting::value(text).map(|setting| setting.to_string()).as_deref(), Ok(text));
        }
        for text in ["tpdo1=6000:1,6401:2", "rpdo512=0005,6200:1", "tpdo3=", "tpdo1=Statusword,6064"] {
            assert_eq!(Setting::map(text).map(|setting| setting.to_string()).as_deref(), Ok(text));
        }
        for text in ["rpdo2=0x2AA", "tpdo1=$NODEID+0x180", "tpdo3=off"] {
            assert_eq!(Setting::cob_id(text).map(|setting| setting.to_string()).as_deref(), Ok(text));
        }
        for (text, read) in [("7=750ms", "7=750ms"), ("0x7F=750", "127=750ms"), ("9=1.5s", "9=1500ms")] {
            assert_eq!(
                Setting::heartbeat_consumer(text).map(|setting| setting.to_string()).as_deref(),
                Ok(read)
            );
        }
    }

    #[test]
    fn what_is_no_setting() {
        for text in ["1017", "-=1", "10170=1", "=1"] {
            assert!(Setting::value(text).is_err(), "{text}");
        }
        for text in ["tpdo0=6000", "tpdo513=6000", "pdo1=6000", "tpdo1=60000"] {
            assert!(Setting::map(text).is_err(), "{text}");
        }
        for text in ["tpdo1=0x1FFFFFFF", "tpdo1=-1", "tpdo1=$NODEID-1", "tpdo1"] {
            assert!(Setting::cob_id(text).is_err(), "{text}");
        }
        for text in ["0=1", "128=1", "7=65536", "7=66s", "7=1.2345s", "7=-1", "7=", "7"] {
            assert!(Setting::heartbeat_consumer(text).is_err(), "{text}");
        }
    }
}
