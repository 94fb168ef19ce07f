//! Settings files, for keeping settings under version control:
//!
//! ```toml
//! node-id = 5
//! bit-rate = 250
//! name = "pump"
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
//! [heartbeat-consumer]
//! 7 = "750ms"
//! ```

use std::collections::BTreeMap;

use serde::Deserialize;
use toml::Value as Toml;

use super::{NoSetting, Setting};

/// The content of a settings file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SettingsFile {
    /// `node-id`.
    pub node_id: Option<u8>,
    /// `bit-rate` in kbit/s; `baudrate` in older files.
    pub baud_rate: Option<u16>,
    /// `name`.
    pub name: Option<String>,
    /// The settings: values, mappings, CAN-IDs, heartbeat consumers.
    pub settings: Vec<Setting>,
}

/// Why a settings file cannot be read.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SettingsFileError {
    /// Not valid TOML, or unknown keys.
    #[error("{}", .0.to_string().trim_end())]
    Toml(toml::de::Error),
    /// All invalid settings of the file.
    #[error("{}", .0.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"))]
    Settings(Vec<NoSetting>),
}

#[derive(Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
struct Document {
    node_id: Option<u8>,
    #[serde(alias = "baudrate")]
    bit_rate: Option<u16>,
    name: Option<String>,
    #[serde(default)]
    set: BTreeMap<String, Toml>,
    #[serde(default)]
    map: BTreeMap<String, Vec<String>>,
    #[serde(default)]
    cob_id: BTreeMap<String, Toml>,
    #[serde(default)]
    heartbeat_consumer: BTreeMap<String, Toml>,
}

impl SettingsFile {
    /// Parses settings in TOML.
    ///
    /// # Errors
    /// Fails on invalid TOML, unknown keys and invalid values.
    pub fn parse(text: &str) -> Result<Self, SettingsFileError> {
        let document: Document = toml::from_str(text).map_err(SettingsFileError::Toml)?;
        let values = document.set.iter().map(|(at, value)| Setting::value(&format!("{at}={}", plain(value))));
        let maps =
            document.map.iter().map(|(pdo, objects)| Setting::map(&format!("{pdo}={}", objects.join(","))));
        let ids = document.cob_id.iter().map(|(pdo, id)| Setting::cob_id(&format!("{pdo}={}", plain(id))));
        let consumers = document.heartbeat_consumer.iter();
        let consumers =
            consumers.map(|(node, time)| Setting::heartbeat_consumer(&format!("{node}={}", plain(time))));
        let mut settings = Vec::new();
        let mut wrong = Vec::new();
        for setting in values.chain(maps).chain(ids).chain(consumers) {
            match setting {
                Ok(setting) => settings.push(setting),
                Err(error) => wrong.push(error),
            }
        }
        if !wrong.is_empty() {
            return Err(SettingsFileError::Settings(wrong));
        }
        let Document { node_id, bit_rate, name, .. } = document;
        Ok(Self { node_id, baud_rate: bit_rate, name, settings })
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
                    [map]\ntpdo1 = ['6000:1', '6401:2']\n[cob-id]\nrpdo2 = 0x2AA\n[heartbeat-consumer]\n7 = '750ms'\n";
        let file = SettingsFile::parse(text).unwrap();
        assert_eq!((file.node_id, file.baud_rate, file.name.as_deref()), (Some(5), Some(250), Some("pump")));
        let settings: Vec<String> = file.settings.iter().map(ToString::to_string).collect();
        let expected = [
            "1017=250",
            "1800:2=0xFE",
            "2000=1",
            "Producer heartbeat time=5",
            "tpdo1=6000:1,6401:2",
            "rpdo2=0x2AA",
            "7=750ms",
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
