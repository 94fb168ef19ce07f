//! Settings of a node.

use std::fmt;
use std::str::FromStr;

use super::time::milliseconds;
use crate::model::{Moment, PdoKind};
use crate::resolve::ObjectName;
use objdict_model::literal::{nanoseconds, written_number};

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
    /// Monitors the heartbeat of a node.
    HeartbeatConsumer {
        /// The monitored node.
        node_id: u8,
        /// The consumer heartbeat time in milliseconds.
        milliseconds: u16,
    },
    /// Sets a communication parameter of a PDO.
    Pdo {
        /// The PDO.
        pdo: PdoName,
        /// The parameter.
        parameter: PdoParameter,
        /// The value: a number, or a time with a unit.
        text: String,
    },
    /// Configures SYNC (1005h, 1006h). `None` keeps the current setting.
    Sync {
        /// The CAN-ID; [`CanId::Off`] is not possible.
        id: Option<CanId>,
        /// Whether the node produces SYNC.
        producer: Option<bool>,
        /// The communication cycle period: microseconds, or a time with a unit.
        period: Option<String>,
    },
    /// Sets the CAN-ID of EMCY (1014h).
    Emcy(CanId),
    /// Configures TIME (1012h). `None` keeps the current setting.
    TimeStamp {
        /// The CAN-ID; [`CanId::Off`]: the node neither produces nor consumes TIME.
        id: Option<CanId>,
        /// Whether the node produces TIME.
        producer: Option<bool>,
        /// Whether the node consumes TIME.
        consumer: Option<bool>,
    },
    /// Downloads that are performed as stated, in addition to the values of entries.
    Downloads {
        /// Whether they are performed before or after the values of entries.
        when: Moment,
        /// The entry; for a VAR, the object.
        at: ObjectName,
        /// The values in order, spelled as in a DCF.
        texts: Vec<String>,
    },
    /// Sets up node guarding (100Ch, 100Dh).
    Guard {
        /// The guard time in milliseconds; 0: no guarding.
        milliseconds: u16,
        /// The life time factor.
        factor: u8,
    },
}

objdict_model::named! {
    /// A parameter of a PDO, a sub-index of its communication parameter (CiA 301 §7.5.2.35, §7.5.2.37).
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum PdoParameter {
        /// Transmission type.
        Transmission (code 2) = "transmission",
        /// Inhibit time, in multiples of 100 µs.
        Inhibit (code 3) = "inhibit",
        /// Event timer in milliseconds.
        EventTimer (code 5) = "event-timer",
        /// SYNC start value.
        SyncStart (code 6) = "sync-start",
    }
}

impl PdoParameter {
    /// Its sub-index in the communication parameter.
    pub const fn sub(self) -> u8 {
        self as u8
    }
}

/// Transmission types with names (CiA 301 §7.5.2.35); `sync/N` are the numbers 1 to 240.
const TRANSMISSION: [(&str, u8); 7] = [
    ("sync", 1),
    ("sync/0", 0),
    ("rtr-sync", 252),
    ("rtr", 253),
    ("event-vendor", 254),
    ("event", 255),
    ("event-profile", 255),
];

/// The number of a transmission type: `sync/1`, `event`, `254`.
pub fn transmission_type(text: &str) -> Option<u8> {
    let lower = text.trim().to_ascii_lowercase();
    if let Some(&(_, number)) = TRANSMISSION.iter().find(|(name, _)| *name == lower) {
        return Some(number);
    }
    match lower.strip_prefix("sync/") {
        Some(number) => number.parse().ok().filter(|number| *number <= 240),
        None => number(&lower).and_then(|number| u8::try_from(number).ok()),
    }
}

/// The name of a transmission type, as [`transmission_type`] reads it.
pub fn transmission_word(number: u8) -> String {
    let named = ["event", "event-vendor", "rtr", "rtr-sync"].map(str::to_owned);
    let words = named.into_iter().chain([format!("sync/{number}"), number.to_string()]);
    words.into_iter().find(|word| transmission_type(word) == Some(number)).unwrap_or_default()
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
    /// The CAN-ID of the predefined connection set if it is free; otherwise, for a PDO, the first free one
    /// from 680h on, which CiA 301 does not assign to a service.
    Auto,
    /// No CAN-ID: the PDO is not valid.
    Off,
}

/// A text that is not a valid setting.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NoSetting {
    /// The text.
    text: String,
    /// The expected syntax.
    expected: &'static str,
}

objdict_model::error_messages! { NoSetting: { Self { text, expected } => "`{text}` is not a setting: {expected}"; } }

impl NoSetting {
    fn new(text: &str, expected: &'static str) -> Self {
        Self { text: text.to_owned(), expected }
    }
}

/// Splits a text at `=` into its key and value.
fn pair<'t, T: FromStr>(text: &'t str, expected: &'static str) -> Result<(T, &'t str), NoSetting> {
    let pair = text.split_once('=').and_then(|(at, value)| Some((at.parse().ok()?, value)));
    pair.ok_or_else(|| NoSetting::new(text, expected))
}

impl Setting {
    /// `1017=250`, `1800:2=1`, `2001="a text"`, `Producer heartbeat time=250`, `1017=1s`, `1017=default`.
    ///
    /// # Errors
    /// If the text does not match this syntax.
    pub fn value(text: &str) -> Result<Self, NoSetting> {
        let (at, value) = pair(text, "write an entry and its value, as in `1017=250` or `1800:2=0xFE`")?;
        Ok(Self::Value { at, text: value.trim().to_owned() })
    }

    /// `6040=6,7,15`: downloads of an entry in this order, before or after the values of entries.
    ///
    /// # Errors
    /// If the text does not match this syntax.
    pub fn downloads(when: Moment, text: &str) -> Result<Self, NoSetting> {
        let expected = "write an entry and its values in order, as in `6040=6,7,15`";
        let (at, values) = pair(text, expected)?;
        let texts: Vec<String> = split_values(values).map(|value| value.trim().to_owned()).collect();
        if texts.iter().any(String::is_empty) {
            return Err(NoSetting::new(text, expected));
        }
        Ok(Self::Downloads { when, at, texts })
    }

    /// `tpdo1=6000:1,6401:2`, `tpdo1=Statusword`; an empty list after `=` clears the mapping.
    ///
    /// # Errors
    /// If the text does not match this syntax.
    pub fn map(text: &str) -> Result<Self, NoSetting> {
        let expected = "write a PDO and its mapping, as in `tpdo1=6000:1,6401:2`";
        let (pdo, objects) = pair(text, expected)?;
        let objects = objects.split(',').map(str::trim).filter(|object| !object.is_empty());
        let objects = objects.map(|object| object.parse().map_err(|_| NoSetting::new(text, expected)));
        Ok(Self::Map { pdo, objects: objects.collect::<Result<_, _>>()? })
    }

    /// `rpdo2=0x2AA`, `tpdo1=$NODEID+0x180`, `tpdo3=off`, `tpdo1=auto`.
    ///
    /// # Errors
    /// If the text does not match this syntax.
    pub fn cob_id(text: &str) -> Result<Self, NoSetting> {
        let expected = "write a PDO and its CAN-ID, as in `rpdo2=0x2AA` or `tpdo3=off`";
        let (pdo, id) = pair(text, expected)?;
        Ok(Self::CobId { pdo, id: id.parse().map_err(|()| NoSetting::new(text, expected))? })
    }

    /// `7=750ms`, `7=750`, `9=1.5s`.
    ///
    /// # Errors
    /// If the text does not match this syntax.
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

    /// `tpdo1=sync/1`, `tpdo1=event`, `tpdo1=254`.
    ///
    /// # Errors
    /// If the text does not match this syntax.
    pub fn transmission(text: &str) -> Result<Self, NoSetting> {
        Self::pdo(PdoParameter::Transmission, text)
    }

    /// `tpdo1=5ms`, `tpdo1=50` (multiples of 100 µs).
    ///
    /// # Errors
    /// If the text does not match this syntax.
    pub fn inhibit(text: &str) -> Result<Self, NoSetting> {
        Self::pdo(PdoParameter::Inhibit, text)
    }

    /// `tpdo1=100ms`, `tpdo1=100`.
    ///
    /// # Errors
    /// If the text does not match this syntax.
    pub fn event_timer(text: &str) -> Result<Self, NoSetting> {
        Self::pdo(PdoParameter::EventTimer, text)
    }

    /// `tpdo1=3`.
    ///
    /// # Errors
    /// If the text does not match this syntax.
    pub fn sync_start(text: &str) -> Result<Self, NoSetting> {
        Self::pdo(PdoParameter::SyncStart, text)
    }

    /// Parses a parameter of a PDO like the function with its name.
    ///
    /// # Errors
    /// If the text does not match the syntax.
    pub fn pdo(parameter: PdoParameter, text: &str) -> Result<Self, NoSetting> {
        let expected = match parameter {
            PdoParameter::Transmission => {
                "write a PDO and its transmission type: `tpdo1=sync/1`, up to `sync/240`, `event`, `event-vendor`, `rtr`, `rtr-sync` or a number up to 255"
            }
            PdoParameter::Inhibit => "write a PDO and its inhibit time, as in `tpdo1=5ms`",
            PdoParameter::EventTimer => "write a PDO and its event timer, as in `tpdo1=100ms`",
            PdoParameter::SyncStart => "write a PDO and the SYNC that it starts with, as in `tpdo1=3`",
        };
        let (pdo, value) = pair(text, expected)?;
        let value = match parameter {
            PdoParameter::Transmission => transmission_type(value).map(|number| number.to_string()),
            PdoParameter::SyncStart => {
                number(value).filter(|number| *number <= 240).map(|number| number.to_string())
            }
            _ => Some(value.trim().to_owned()).filter(|value| !value.is_empty()),
        };
        Ok(Self::Pdo { pdo, parameter, text: value.ok_or_else(|| NoSetting::new(text, expected))? })
    }

    /// `producer,33ms`, `0x80`, `0x90,consumer`: a CAN-ID, the role of the node, and the SYNC period; all
    /// optional, in any order.
    ///
    /// # Errors
    /// If the text does not match this syntax.
    pub fn sync(text: &str) -> Result<Self, NoSetting> {
        let wrong = || {
            NoSetting::new(
                text,
                "write a CAN-ID, `producer` or `consumer`, and a period, as in `0x80,producer,33ms`",
            )
        };
        let (mut id, mut producer, mut period) = (None, None, None);
        for part in text.split(',').map(str::trim) {
            let is_new = match (part, part.parse()) {
                ("producer" | "consumer", _) => producer.replace(part == "producer").is_none(),
                (_, Ok(CanId::Off)) => false,
                (_, Ok(can_id)) => id.replace(can_id).is_none(),
                _ => nanoseconds(part).is_some() && period.replace(part.to_owned()).is_none(),
            };
            if !is_new {
                return Err(wrong());
            }
        }
        Ok(Self::Sync { id, producer, period })
    }

    /// `0x90`, `$NODEID+0x80`, `off`, `auto`.
    ///
    /// # Errors
    /// If the text does not match this syntax.
    pub fn emcy(text: &str) -> Result<Self, NoSetting> {
        let wrong =
            || NoSetting::new(text, "write the CAN-ID of EMCY, as in `$NODEID+0x80`, `auto` or `off`");
        text.parse().map(Self::Emcy).map_err(|()| wrong())
    }

    /// `consumer`, `0x100,producer`, `off`: a CAN-ID and the node's role for TIME.
    ///
    /// # Errors
    /// If the text does not match this syntax.
    pub fn time(text: &str) -> Result<Self, NoSetting> {
        let wrong = || {
            NoSetting::new(
                text,
                "write a CAN-ID, `producer` and `consumer`, as in `0x100,consumer`, or `off`",
            )
        };
        let (mut id, mut producer, mut consumer) = (None, None, None);
        for part in text.split(',').map(str::trim) {
            let is_new = match part {
                "producer" => producer.replace(true).is_none(),
                "consumer" => consumer.replace(true).is_none(),
                _ => id.replace(part.parse().map_err(|()| wrong())?).is_none(),
            };
            if !is_new || id == Some(CanId::Off) && text.contains(',') {
                return Err(wrong());
            }
        }
        Ok(Self::TimeStamp { id, producer, consumer })
    }

    /// `100x3`, `0.1s x 3`: guard time and life time factor; `0x0` disables guarding.
    ///
    /// # Errors
    /// If the text does not match this syntax.
    pub fn guard(text: &str) -> Result<Self, NoSetting> {
        let wrong = || {
            NoSetting::new(
                text,
                "write a guard time up to 65535 ms, `x` and a life time factor up to 255, as in `100msx3`",
            )
        };
        let (time, factor) = text.rsplit_once('x').ok_or_else(wrong)?;
        let milliseconds = milliseconds(time).ok_or_else(wrong)?;
        Ok(Self::Guard {
            milliseconds,
            factor: number(factor).and_then(|factor| u8::try_from(factor).ok()).ok_or_else(wrong)?,
        })
    }
}

/// The parts between commas outside of quotes.
fn split_values(text: &str) -> impl Iterator<Item = &str> {
    let mut is_quoted = false;
    text.split(move |c: char| {
        is_quoted ^= c == '"';
        c == ',' && !is_quoted
    })
}

/// A number of 32 bits.
fn number(text: &str) -> Option<u32> {
    written_number(text.trim(), u32::MAX.into()).map(|number| number as u32)
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

objdict_model::messages! { PdoName: { Self { kind, number } => "{}{number}", kind.name().to_ascii_lowercase(); } }

impl FromStr for CanId {
    type Err = ();

    fn from_str(text: &str) -> Result<Self, ()> {
        let text = text.trim();
        if text.eq_ignore_ascii_case("off") {
            return Ok(Self::Off);
        }
        if text.eq_ignore_ascii_case("auto") {
            return Ok(Self::Auto);
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

objdict_model::messages! { CanId: {
    Self::Number(number) => "0x{number:X}";
    Self::PerNode(number) => "$NODEID+0x{number:X}";
    Self::Off => "off";
    Self::Auto => "auto";
} }

/// The syntax of the command-line option; for settings of one service, preceded by the name of the option.
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
            Self::Pdo { pdo, parameter, text } => write!(f, "{} {pdo}={text}", parameter.name()),
            Self::Sync { id, producer, period } => {
                let role = producer.map(|yes| if yes { "producer" } else { "consumer" }.to_owned());
                write_parts(f, "sync", [id.map(|id| id.to_string()), role, period.clone()])
            }
            Self::Emcy(id) => write!(f, "emcy {id}"),
            Self::TimeStamp { id, producer, consumer } => {
                let role = |is: &Option<bool>, word: &str| is.filter(|yes| *yes).map(|_| word.to_owned());
                let roles = [role(producer, "producer"), role(consumer, "consumer")];
                let [producer, consumer] = roles;
                write_parts(f, "time", [id.map(|id| id.to_string()), producer, consumer])
            }
            Self::Downloads { when, at, texts } => {
                let option = if *when == Moment::Before { "sdo-before" } else { "sdo" };
                write!(f, "{option} {at}={}", texts.join(","))
            }
            Self::Guard { milliseconds, factor } => write!(f, "guard {milliseconds}msx{factor}"),
        }
    }
}

/// `sync 0x80,producer`: the name of an option and the existing parts.
fn write_parts(f: &mut fmt::Formatter<'_>, name: &str, parts: [Option<String>; 3]) -> fmt::Result {
    let parts: Vec<String> = parts.into_iter().flatten().collect();
    write!(f, "{name} {}", parts.join(","))
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
        for text in ["rpdo2=0x2AA", "tpdo1=$NODEID+0x180", "tpdo3=off", "tpdo4=auto"] {
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
    fn settings_of_services_are_written_behind_their_option() {
        let written = |setting: Result<Setting, NoSetting>| {
            setting.map(|setting| setting.to_string()).unwrap_or_default()
        };
        assert_eq!(written(Setting::transmission("tpdo1=sync/4")), "transmission tpdo1=4");
        assert_eq!(written(Setting::inhibit("tpdo1= 5ms")), "inhibit tpdo1=5ms");
        assert_eq!(written(Setting::sync("33ms, producer,0x80")), "sync 0x80,producer,33ms");
        assert_eq!(written(Setting::emcy("$NODEID+0x80")), "emcy $NODEID+0x80");
        assert_eq!(written(Setting::time("producer,consumer")), "time producer,consumer");
        assert_eq!(written(Setting::downloads(Moment::After, "6040=6, 7,15")), "sdo 6040=6,7,15");
        assert_eq!(
            written(Setting::downloads(Moment::Before, "2001=\"a,b\",c")),
            "sdo-before 2001=\"a,b\",c"
        );
        assert!(Setting::downloads(Moment::After, "6040=6,,7").is_err());
        assert_eq!(written(Setting::guard("0.1s x 3")), "guard 100msx3");
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
        for text in ["tpdo1=sync/241", "tpdo1=events", "tpdo1=256", "tpdo1=", "tpdo1"] {
            assert!(Setting::transmission(text).is_err(), "{text}");
        }
        for text in ["", "off", "0x80,0x90", "producer,consumer", "33", "33ms,33ms"] {
            let is_id = text == "33";
            assert_eq!(Setting::sync(text).is_ok(), is_id, "{text}");
        }
        for text in ["", "off,consumer", "consumer,off", "consumer,consumer", "33ms"] {
            assert!(Setting::time(text).is_err(), "{text}");
        }
        assert!(Setting::sync_start("tpdo1=241").is_err() && Setting::inhibit("tpdo1=").is_err());
        assert!(
            Setting::guard("100").is_err()
                && Setting::guard("66sx3").is_err()
                && Setting::guard("1x256").is_err()
        );
        for text in ["0=1", "128=1", "7=65536", "7=66s", "7=1.2345s", "7=-1", "7=", "7"] {
            assert!(Setting::heartbeat_consumer(text).is_err(), "{text}");
        }
    }
}
