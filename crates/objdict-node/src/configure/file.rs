//! Settings files, for keeping settings under version control:
//!
//! ```toml
//! node-id = 5
//! bit-rate = 250
//! name = "pump"
//! sync = "0x80,consumer"
//! emcy = "auto"
//!
//! [set]
//! "1017" = 250
//! "1800:2" = "0xFE"
//!
//! [map]
//! tpdo1 = ["6000:1", "6401:2"]
//!
//! [cob-id]
//! rpdo2 = "0x2AA"
//!
//! [transmission]
//! tpdo1 = "sync/1"
//!
//! [heartbeat-consumer]
//! 7 = "750ms"
//!
//! [[sdo]]
//! entry = "6040"
//! value = [6, 7, 15]
//! ```

use std::collections::BTreeMap;

use serde::Deserialize;
use toml::Value as Toml;

use super::{NoSetting, Setting};
use crate::model::Moment;

/// The content of a settings file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SettingsFile {
    /// `node-id`.
    pub node_id: Option<u8>,
    /// `bit-rate` in kbit/s; `baudrate` in older files.
    pub baud_rate: Option<u16>,
    /// `name`.
    pub name: Option<String>,
    /// `net-number`.
    pub net_number: Option<u32>,
    /// `network-name`.
    pub network_name: Option<String>,
    /// `manager`: whether the node is the CANopen manager of the network.
    pub manager: Option<bool>,
    /// `lss-serial-number`.
    pub lss_serial_number: Option<u32>,
    /// The settings: values, mappings, parameters of PDOs, services, heartbeat consumers.
    pub settings: Vec<Setting>,
}

/// Why a settings file cannot be read.
#[derive(Debug)]
#[non_exhaustive]
pub enum SettingsFileError {
    /// Not valid TOML, or unknown keys.
    Toml(toml::de::Error),
    /// All invalid settings of the file.
    Settings(Vec<NoSetting>),
}

objdict_model::error_messages! { SettingsFileError: {
    Self::Toml(error) => "{}", error.to_string().trim_end();
    Self::Settings(settings) => "{}", settings.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n");
} }

#[derive(Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
struct SettingsDocument {
    node_id: Option<u8>,
    #[serde(alias = "baudrate")]
    bit_rate: Option<u16>,
    name: Option<String>,
    net_number: Option<u32>,
    network_name: Option<String>,
    manager: Option<bool>,
    lss_serial_number: Option<u32>,
    sync: Option<Toml>,
    emcy: Option<Toml>,
    time: Option<Toml>,
    guard: Option<String>,
    #[serde(default)]
    set: SettingsTable,
    #[serde(default)]
    map: BTreeMap<String, Vec<String>>,
    #[serde(default)]
    cob_id: SettingsTable,
    #[serde(default)]
    transmission: SettingsTable,
    #[serde(default)]
    inhibit: SettingsTable,
    #[serde(default)]
    event_timer: SettingsTable,
    #[serde(default)]
    sync_start: SettingsTable,
    #[serde(default)]
    heartbeat_consumer: SettingsTable,
    #[serde(default)]
    sdo: Vec<Sdo>,
}

/// Downloads of one entry.
#[derive(Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
struct Sdo {
    entry: String,
    /// One value, or several in order.
    value: Toml,
    #[serde(default)]
    when: SettingTime,
}

#[derive(Clone, Copy, Default, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum SettingTime {
    Before,
    #[default]
    After,
}

impl Sdo {
    fn setting(&self) -> Result<Setting, NoSetting> {
        let when = match self.when {
            SettingTime::Before => Moment::Before,
            SettingTime::After => Moment::After,
        };
        let values = match &self.value {
            Toml::Array(values) => values.iter().map(plain).collect(),
            value => vec![plain(value)],
        };
        Setting::downloads(when, &format!("{}={}", self.entry, values.join(",")))
    }
}

/// The settings of one option, by the part before `=`.
type SettingsTable = BTreeMap<String, Toml>;

/// Parses the setting of an option.
type Read = fn(&str) -> Result<Setting, NoSetting>;

impl SettingsDocument {
    /// The settings in order of application; later settings of an entry override earlier ones.
    fn settings(&self) -> Vec<Result<Setting, NoSetting>> {
        let pairs = |table: &SettingsTable, read: Read| -> Vec<_> {
            table.iter().map(|(at, value)| read(&format!("{at}={}", plain(value)))).collect()
        };
        let service = |value: &Option<Toml>, read: Read| value.as_ref().map(|value| read(&plain(value)));
        let mut settings = pairs(&self.set, Setting::value);
        let maps = self.map.iter().map(|(pdo, objects)| format!("{pdo}={}", objects.join(",")));
        settings.extend(maps.map(|map| Setting::map(&map)));
        settings.extend(pairs(&self.cob_id, Setting::cob_id));
        settings.extend(pairs(&self.transmission, Setting::transmission));
        settings.extend(pairs(&self.inhibit, Setting::inhibit));
        settings.extend(pairs(&self.event_timer, Setting::event_timer));
        settings.extend(pairs(&self.sync_start, Setting::sync_start));
        settings.extend(service(&self.sync, Setting::sync));
        settings.extend(service(&self.emcy, Setting::emcy));
        settings.extend(service(&self.time, Setting::time));
        settings.extend(self.guard.as_deref().map(Setting::guard));
        settings.extend(pairs(&self.heartbeat_consumer, Setting::heartbeat_consumer));
        settings.extend(self.sdo.iter().map(Sdo::setting));
        settings
    }
}

impl SettingsFile {
    /// Parses settings in TOML.
    ///
    /// # Errors
    /// If the TOML is invalid, or contains unknown keys or invalid values.
    pub fn parse(text: &str) -> Result<Self, SettingsFileError> {
        let document: SettingsDocument = toml::from_str(text).map_err(SettingsFileError::Toml)?;
        let mut settings = Vec::new();
        let mut wrong = Vec::new();
        for setting in document.settings() {
            match setting {
                Ok(setting) => settings.push(setting),
                Err(error) => wrong.push(error),
            }
        }
        if !wrong.is_empty() {
            return Err(SettingsFileError::Settings(wrong));
        }
        Ok(Self {
            node_id: document.node_id,
            baud_rate: document.bit_rate,
            name: document.name,
            net_number: document.net_number,
            network_name: document.network_name,
            manager: document.manager,
            lss_serial_number: document.lss_serial_number,
            settings,
        })
    }
}

/// A value as written in a command-line option.
fn plain(value: &Toml) -> String {
    match value {
        Toml::String(text) => text.clone(),
        Toml::Boolean(flag) => u8::from(*flag).to_string(),
        Toml::Integer(number) => number.to_string(),
        Toml::Float(number) => format!("{number:?}"),
        // not a valid setting; the error message quotes it
        Toml::Array(_) => "[…]".to_owned(),
        Toml::Table(_) => "{…}".to_owned(),
        Toml::Datetime(_) => "a date".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_says_what_the_options_say() {
        let text = "node-id = 5\nbit-rate = 250\nname = 'pump'\n[set]\n'1017' = 250\n'1800:2' = '0xFE'\n'2000' = true\n'Producer heartbeat time' = 5\n\
                    [map]\ntpdo1 = ['6000:1', '6401:2']\n[cob-id]\nrpdo2 = 0x2AA\n[heartbeat-consumer]\n7 = '750ms'\n\
                    [transmission]\ntpdo1 = 1\n[inhibit]\ntpdo1 = '5ms'\n[event-timer]\ntpdo1 = 100\n[sync-start]\ntpdo1 = 3\n\
                    [[sdo]]\nentry = '6040'\nvalue = [6, '0x7']\n[[sdo]]\nentry = '2001'\nvalue = 1\nwhen = 'before'\n";
        let text = format!(
            "net-number = 2\nnetwork-name = 'line 2'\nmanager = false\nlss-serial-number = 0x1234\n{text}"
        );
        let text = format!("sync = 'producer,33ms'\nemcy = 'auto'\ntime = 0x100\nguard = '100x3'\n{text}");
        let file = SettingsFile::parse(&text).unwrap();
        assert_eq!((file.node_id, file.baud_rate, file.name.as_deref()), (Some(5), Some(250), Some("pump")));
        let network = (file.net_number, file.network_name.as_deref(), file.manager, file.lss_serial_number);
        assert_eq!(network, (Some(2), Some("line 2"), Some(false), Some(0x1234)));
        let settings: Vec<String> = file.settings.iter().map(ToString::to_string).collect();
        let expected = [
            "1017=250",
            "1800:2=0xFE",
            "2000=1",
            "Producer heartbeat time=5",
            "tpdo1=6000:1,6401:2",
            "rpdo2=0x2AA",
            "transmission tpdo1=1",
            "inhibit tpdo1=5ms",
            "event-timer tpdo1=100",
            "sync-start tpdo1=3",
            "sync producer,33ms",
            "emcy auto",
            "time 0x100",
            "guard 100msx3",
            "7=750ms",
            "sdo 6040=6,0x7",
            "sdo-before 2001=1",
        ];
        assert_eq!(settings, expected);
    }

    #[test]
    fn every_error_has_a_message() {
        let error = |text: &str| SettingsFile::parse(text).unwrap_err().to_string();
        assert!(error("nodeid = 5").contains("unknown field `nodeid`"));
        let settings = error("[map]\npdo1 = []\n[heartbeat-consumer]\n0 = 5");
        assert_eq!(settings.lines().count(), 2, "{settings}");
    }
}
