//! The properties and capabilities of a device, as keywords with values. Each feature is declared once, in `features!`
//! below: its field, its keyword, its values, its meaning, and the described content of a device. Files, schemas and
//! arguments are derived from [`FEATURES`].

use objdict_model::model::DataType;
use objdict_profile as profile;

/// A feature of a device.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Feature {
    /// Its name: words joined by hyphens.
    pub word: &'static str,
    /// Its possible values.
    pub kind: FeatureKind,
    /// The device profiles that have it; empty for all.
    pub profiles: &'static [u16],
    /// Its meaning, without a full stop.
    pub meaning: &'static str,
    /// The corresponding content of a device.
    pub(super) describes: Describes,
}

/// The possible values of a feature.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FeatureKind {
    /// Yes or no.
    Flag,
    /// A number in a range, both limits included.
    Number {
        /// The lowest number.
        lowest: u16,
        /// The highest number.
        highest: u16,
    },
    /// One of these names.
    OneOf(&'static [&'static str]),
    /// Any of the names that a document has for the bits of an object.
    Bits {
        /// The number of the document.
        document: u16,
        /// The index of the object.
        index: u16,
    },
}

/// The value of a feature.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FeatureValue {
    /// For [`FeatureKind::Flag`].
    Flag(bool),
    /// For [`FeatureKind::Number`].
    Number(i64),
    /// For [`FeatureKind::OneOf`].
    Name(String),
    /// For [`FeatureKind::Bits`].
    Names(Vec<String>),
}

/// Why a feature cannot be set.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FeatureError {
    /// No feature has the word.
    Unknown {
        /// The word.
        word: String,
    },
    /// The feature does not accept the value.
    Misfit {
        /// The word of the feature.
        word: &'static str,
        /// Its possible values.
        expected: String,
    },
}

objdict_model::error_messages! { FeatureError: {
    Self::Unknown { word } => "`{word}` is not a feature";
    Self::Misfit { word, expected } => "`{word}` must be {expected}";
} }

/// The content of a device that a feature describes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Describes {
    /// These objects, all or none.
    Objects(&'static [u16]),
    /// The elements of this object; the object is missing if there are none.
    Elements(u16),
    /// Objects from this index on.
    Series(u16),
    /// A bit in the value of an object.
    Bit(u16, u8),
    /// The elements of an array in each profile that has the feature, with the channels of an element.
    Channels(&'static [(u16, u16, u16)]),
    /// Depends on code for its profile.
    Other,
}

/// The capabilities of an encoder (CiA 406).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EncoderClass {
    /// Position and its description.
    C1,
    /// Also scaling, preset, alarms and diagnosis.
    C2,
}

const fn number(lowest: u16, highest: u16) -> FeatureKind {
    FeatureKind::Number { lowest, highest }
}

/// The maximum number of bits in an array of bytes.
const MAX_DIGITAL: u16 = 254 * 8;
/// The maximum number of values in an array.
const MAX_ANALOG: u16 = 254;
/// Numbers of nodes.
const MAX_NODES: u16 = 127;

const CLASSES: &[&str] = &["c1", "c2"];
/// The types of process values, one thousand indexes (hexadecimal) apart in CiA 404.
pub(super) const VALUE_TYPES: [DataType; 4] =
    [DataType::REAL32, DataType::INTEGER16, DataType::INTEGER24, DataType::INTEGER32];
const VALUE_TYPE_NAMES: &[&str] = &["REAL32", "INTEGER16", "INTEGER24", "INTEGER32"];

macro_rules! features {
    ($($field:ident: $type:ty, $word:literal, $kind:expr, $profiles:expr, $describes:expr, $meaning:literal;)+) => {
        /// The features of a device. `None` uses the profile's default, otherwise that of most devices.
        #[derive(Clone, Debug, Default, PartialEq, Eq)]
        #[non_exhaustive]
        pub struct Features {
            $(#[doc = concat!($meaning, ".")] pub $field: Option<$type>,)+
        }

        /// All features, the general ones first.
        pub const FEATURES: &[Feature] = &[$(Feature {
            word: $word, kind: $kind, profiles: &$profiles, describes: $describes, meaning: $meaning,
        }),+];

        impl Features {
            /// Sets the feature with this word.
            ///
            /// # Errors
            /// If there is no such feature, or if it does not accept the value.
            pub fn set(&mut self, word: &str, value: &FeatureValue) -> Result<(), FeatureError> {
                let unknown = || FeatureError::Unknown { word: word.to_owned() };
                let feature = Feature::named(word).ok_or_else(unknown)?;
                match word {
                    $($word => self.$field = Some(feature.stored(value)?),)+
                    _ => return Err(unknown()),
                }
                Ok(())
            }

            /// The value of the feature with this word; `None` if it is not set.
            pub fn get(&self, word: &str) -> Option<FeatureValue> {
                match word {
                    $($word => self.$field.map(|stored| stored.shown($kind)),)+
                    _ => None,
                }
            }

            /// Leaves the feature with this word to the profile.
            pub fn unset(&mut self, word: &str) {
                match word {
                    $($word => self.$field = None,)+
                    _ => {}
                }
            }
        }
    };
}

use Describes::{Bit, Channels, Elements, Objects, Other, Series};
use FeatureKind::{Bits, Flag, OneOf};

const IO: [u16; 2] = [401, 404];

features! {
    // the communication objects of CiA 301
    rpdos: u16, "rpdos", number(0, 512), [], Series(0x1400),
        "Number of RPDOs [default: from the profile]";
    tpdos: u16, "tpdos", number(0, 512), [], Series(0x1800),
        "Number of TPDOs [default: from the profile]";
    mapping_entries: u16, "mapping-entries", number(1, 64), [], Other,
        "Maximum application objects per PDO mapping [default: the mapped objects, or 8]";
    rpdo_parameters: u16, "rpdo-parameters", number(2, 6), [], Other,
        "Highest sub-index of the RPDO communication parameters: 5 with an event timer [default: 2]";
    tpdo_parameters: u16, "tpdo-parameters", number(2, 6), [], Other,
        "Highest sub-index of the TPDO communication parameters: 6 with a SYNC start value [default: 5]";
    sdo_servers: u16, "sdo-servers", number(0, 128), [], Series(0x1200),
        "Number of described SDO servers, including the default one [default: 0]";
    sdo_clients: u16, "sdo-clients", number(0, 128), [], Series(0x1280),
        "Number of SDO clients [default: 0]";
    heartbeat: bool, "heartbeat", Flag, [], Objects(&[0x1017]),
        "Send heartbeats [default: true]";
    heartbeat_consumers: u16, "heartbeat-consumers", number(0, MAX_NODES), [], Elements(0x1016),
        "Number of nodes whose heartbeat is monitored [default: 0]";
    guarding: bool, "guarding", Flag, [], Objects(&[0x100C, 0x100D]),
        "Respond to node guarding [default: false]";
    emcy: bool, "emcy", Flag, [], Objects(&[0x1014]),
        "Send EMCY messages [default: true]";
    emcy_inhibit_time: bool, "emcy-inhibit-time", Flag, [], Objects(&[0x1015]),
        "Include an EMCY inhibit time [default: false]";
    emcy_consumers: u16, "emcy-consumers", number(0, MAX_NODES), [], Elements(0x1028),
        "Number of nodes whose EMCY messages are received [default: 0]";
    error_history: u16, "error-history", number(0, 254), [], Elements(0x1003),
        "Number of stored errors [default: 0]";
    error_behavior: u16, "error-behavior", number(0, 254), [], Elements(0x1029),
        "Number of error classes with a configurable reaction [default: 0]";
    status_register: bool, "status-register", Flag, [], Objects(&[0x1002]),
        "Include a manufacturer status register [default: false]";
    sync: bool, "sync", Flag, [], Objects(&[0x1005]),
        "Include a SYNC COB-ID [default: true if there are PDOs]";
    sync_producer: bool, "sync-producer", Flag, [], Bit(0x1005, 30),
        "Produce SYNC [default: false]";
    cycle_period: bool, "cycle-period", Flag, [], Objects(&[0x1006]),
        "Include a communication cycle period [default: true for SYNC producers]";
    sync_window: bool, "sync-window", Flag, [], Objects(&[0x1007]),
        "Include a synchronous window length [default: false]";
    sync_counter: bool, "sync-counter", Flag, [], Objects(&[0x1019]),
        "Include a SYNC counter [default: false]";
    time: bool, "time", Flag, [], Objects(&[0x1012]),
        "Include a TIME COB-ID [default: true for TIME producers]";
    time_producer: bool, "time-producer", Flag, [], Bit(0x1012, 30),
        "Produce TIME instead of consuming it [default: false]";
    store: u16, "store", number(0, MAX_NODES), [], Elements(0x1010),
        "Number of parameter groups that can be stored [default: 0]";
    restore: u16, "restore", number(0, MAX_NODES), [], Elements(0x1011),
        "Number of parameter groups that can be reset to defaults [default: as for `store`]";
    verify_configuration: bool, "verify-configuration", Flag, [], Objects(&[0x1020]),
        "Store the date and time of the configuration [default: false]";
    identity_entries: u16, "identity-entries", number(1, 4), [], Elements(0x1018),
        "Number of entries in the identity object: 4 with a serial number [default: 4]";
    device_name: bool, "device-name", Flag, [], Objects(&[0x1008]),
        "Include a device name [default: true]";
    hardware_version: bool, "hardware-version", Flag, [], Objects(&[0x1009]),
        "Include a hardware version [default: false]";
    software_version: bool, "software-version", Flag, [], Objects(&[0x100A]),
        "Include a software version [default: false]";
    lss: bool, "lss", Flag, [], Other,
        "Support LSS [default: false]";
    // device profiles
    digital_inputs: u16, "digital-inputs", number(0, MAX_DIGITAL), IO, Channels(&[(401, 0x6000, 8), (404, 0x6000, 8)]),
        "Number of one-bit digital inputs [default: 0]";
    digital_outputs: u16, "digital-outputs", number(0, MAX_DIGITAL), IO, Channels(&[(401, 0x6200, 8), (404, 0x6200, 8)]),
        "Number of one-bit digital outputs [default: 0]";
    analog_inputs: u16, "analog-inputs", number(0, MAX_ANALOG), IO, Channels(&[(401, 0x6401, 1), (404, 0x6130, 1)]),
        "Number of analogue inputs [default: 0]";
    analog_outputs: u16, "analog-outputs", number(0, MAX_ANALOG), IO, Channels(&[(401, 0x6411, 1), (404, 0x6300, 1)]),
        "Number of analogue outputs [default: 0]";
    value_type: DataType, "value-type", OneOf(VALUE_TYPE_NAMES), [404], Other,
        "Data type of process values [default: REAL32]";
    drive_types: u32, "drive-types", Bits { document: 402, index: 0x1000 }, [402], Other,
        "Drive types [default: servo-drive]";
    modes: u32, "modes", Bits { document: 402, index: 0x6502 }, [402], Other,
        "Modes of operation, by name or by an abbreviation such as `pp`, `hm`, `csv`";
    encoder_class: EncoderClass, "encoder-class", OneOf(CLASSES), [406], Other,
        "Encoder class [default: c1]";
    encoder_type: u16, "encoder-type", number(1, 10), [406], Other,
        "CiA 406 encoder type: 1 single-turn absolute rotary, 2 multi-turn absolute rotary, … 10 several sensors [default: 2]";
}

impl Feature {
    /// The feature with a word.
    pub fn named(word: &str) -> Option<&'static Self> {
        FEATURES.iter().find(|feature| feature.word == word)
    }

    /// Whether devices of a profile have the feature.
    pub fn is_of(&self, profile: u16) -> bool {
        self.profiles.is_empty() || self.profiles.contains(&profile)
    }

    fn stored<T: StoredFeature>(&self, value: &FeatureValue) -> Result<T, FeatureError> {
        let misfit = || FeatureError::Misfit { word: self.word, expected: self.kind.expected() };
        T::stored(value, self.kind).ok_or_else(misfit)
    }
}

impl FeatureKind {
    /// Its possible names; none for flags and numbers.
    pub fn names(self) -> Vec<String> {
        match self {
            Self::Flag | Self::Number { .. } => Vec::new(),
            Self::OneOf(names) => names.iter().map(|&name| name.to_owned()).collect(),
            Self::Bits { .. } => self.bits().into_iter().map(|(_, name)| name).collect(),
        }
    }

    /// The single bits that the document names, with the name as a keyword.
    pub(super) fn bits(self) -> Vec<(u8, String)> {
        let Self::Bits { document, index } = self else { return Vec::new() };
        let facts = profile::of_number(document).and_then(|document| document.object(index)?.entry(0));
        let fields = facts.iter().flat_map(profile::EntryFacts::bits);
        let single = fields.filter(|field| field.first == field.last);
        single.map(|field| (field.first, field.name.to_ascii_lowercase().replace(' ', "-"))).collect()
    }

    /// Additional abbreviations of its names.
    pub fn abbreviations(self) -> impl Iterator<Item = &'static str> {
        let is_modes = matches!(self, Self::Bits { document: 402, index: 0x6502 });
        MODES.iter().filter(move |_| is_modes).map(|(short, _)| *short)
    }

    fn expected(self) -> String {
        match self {
            Self::Flag => "true or false".to_owned(),
            Self::Number { lowest, highest } => format!("a number from {lowest} to {highest}"),
            Self::OneOf(names) => format!("one of {}", names.join(", ")),
            Self::Bits { .. } => format!("a list of these: {}", self.names().join(", ")),
        }
    }
}

impl EncoderClass {
    const ALL: [Self; 2] = [Self::C1, Self::C2];
}

/// Abbreviations of the modes of operation in CiA 402, and the names of their bits in 6502h.
const MODES: [(&str, &str); 10] = [
    ("pp", "profile-position"),
    ("vl", "velocity"),
    ("pv", "profile-velocity"),
    ("tq", "torque-profile"),
    ("hm", "homing"),
    ("ip", "interpolated-position"),
    ("csp", "cyclic-synchronous-position"),
    ("csv", "cyclic-synchronous-velocity"),
    ("cst", "cyclic-synchronous-torque"),
    ("cstca", "cyclic-synchronous-torque-with-commutation-angle"),
];

/// A field type of [`Features`].
trait StoredFeature: Sized {
    /// The field value for a feature value; `None` if the feature does not accept it.
    fn stored(value: &FeatureValue, kind: FeatureKind) -> Option<Self>;

    /// The value that this is stored for.
    fn shown(self, kind: FeatureKind) -> FeatureValue;
}

impl StoredFeature for bool {
    fn stored(value: &FeatureValue, _: FeatureKind) -> Option<Self> {
        if let FeatureValue::Flag(flag) = value { Some(*flag) } else { None }
    }

    fn shown(self, _: FeatureKind) -> FeatureValue {
        FeatureValue::Flag(self)
    }
}

impl StoredFeature for u16 {
    fn stored(value: &FeatureValue, kind: FeatureKind) -> Option<Self> {
        let (FeatureValue::Number(number), FeatureKind::Number { lowest, highest }) = (value, kind) else {
            return None;
        };
        Self::try_from(*number).ok().filter(|number| (lowest..=highest).contains(number))
    }

    fn shown(self, _: FeatureKind) -> FeatureValue {
        FeatureValue::Number(self.into())
    }
}

/// Bits of a value.
impl StoredFeature for u32 {
    fn stored(value: &FeatureValue, kind: FeatureKind) -> Option<Self> {
        let FeatureValue::Names(names) = value else { return None };
        let bits = kind.bits();
        let bit = |name: &String| {
            let name = MODES.iter().find(|(short, _)| *short == name).map_or(name.as_str(), |(_, name)| name);
            bits.iter().find(|(_, of)| of == name).map(|(bit, _)| 1 << bit)
        };
        names.iter().try_fold(0, |mask, name| Some(mask | bit(name)?))
    }

    fn shown(self, kind: FeatureKind) -> FeatureValue {
        let set = kind.bits().into_iter().filter(|(bit, _)| self >> bit & 1 == 1);
        FeatureValue::Names(set.map(|(_, name)| name).collect())
    }
}

impl StoredFeature for EncoderClass {
    fn stored(value: &FeatureValue, _: FeatureKind) -> Option<Self> {
        one_of(value, CLASSES, &Self::ALL)
    }

    fn shown(self, _: FeatureKind) -> FeatureValue {
        name_of(&self, CLASSES, &Self::ALL)
    }
}

impl StoredFeature for DataType {
    fn stored(value: &FeatureValue, _: FeatureKind) -> Option<Self> {
        one_of(value, VALUE_TYPE_NAMES, &VALUE_TYPES)
    }

    fn shown(self, _: FeatureKind) -> FeatureValue {
        name_of(&self, VALUE_TYPE_NAMES, &VALUE_TYPES)
    }
}

fn one_of<T: Copy>(value: &FeatureValue, names: &[&str], values: &[T]) -> Option<T> {
    let FeatureValue::Name(name) = value else { return None };
    values.get(names.iter().position(|of| of == name)?).copied()
}

fn name_of<T: PartialEq>(value: &T, names: &[&str], values: &[T]) -> FeatureValue {
    let at = values.iter().position(|of| of == value);
    FeatureValue::Name(at.and_then(|at| names.get(at)).copied().unwrap_or_default().to_owned())
}
