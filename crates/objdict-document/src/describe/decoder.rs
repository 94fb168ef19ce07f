//! The value of an entry as text.

use super::time;
use crate::model::{Device, Value};
use crate::{Language, profile};

/// Describes the values of a device as text.
#[derive(Clone, Copy, Debug)]
pub struct Decoder<'a> {
    /// The device.
    pub device: &'a Device,
    /// The node-ID for COB-IDs, 1 to 127; without it they remain formulas.
    pub node_id: Option<u8>,
    /// The language of the sentences. Terms of device profiles are always English.
    pub language: Language,
    /// The description with all objects of the node: an object that it lacks is worth a word.
    pub description: Option<&'a Device>,
}

impl<'a> Decoder<'a> {
    /// Creates an English decoder.
    pub fn english(device: &'a Device, node_id: Option<u8>) -> Self {
        Self { device, node_id, language: Language::English, description: Some(device) }
    }

    /// The meaning of an entry's value, if it is more than a number.
    pub fn of(&self, index: u16, sub: u8, value: &Value) -> Option<String> {
        self.of_communication(index, sub, value).or_else(|| profile::meaning(self.device, index, sub, value))
    }

    fn of_communication(&self, index: u16, sub: u8, value: &Value) -> Option<String> {
        let number = || u32::try_from(value.as_integer()?).ok();
        match (index, sub) {
            (0x1000, 0) => number().map(|number| self.device_type(number)),
            (0x1001, 0) => number().map(|number| self.error_register(number)),
            (0x1003, 1..) => number().map(|number| self.error_field(number)),
            (0x1005, 0) => self.sync_cob_id(value),
            (0x1006, 0) => number().map(|time| self.or_off(time, time::of_microseconds)),
            (0x1007, 0) => number().map(|time| match time {
                0 => self.pick("no window", "kein Fenster").to_owned(),
                _ => time::of_microseconds(time, self.language),
            }),
            (0x100C | 0x1017, 0) => number().map(|time| self.or_off(time, time::of_milliseconds)),
            (0x100D, 0) => number().map(|factor| self.life_time(factor)),
            (0x1010 | 0x1011 | 0x1F25, 1..) => number().and_then(|number| self.storage(index, number)),
            (0x1012, 0) => self.time_cob_id(value),
            (0x1014, 0) => self.service_cob_id(value),
            (0x1015, 0) => number().map(|time| self.or_off(time, time::of_tenths)),
            (0x1016, 1..) => number().map(|number| self.heartbeat_consumer(sub, number)),
            (0x1018, 3) => number().map(|number| self.revision(number)),
            (0x1019, 0) => number().map(|highest| self.sync_counter(highest)),
            (0x1020, 1) => number().map(|days| self.configuration_date(days)),
            (0x1020, 2) => number().and_then(time::of_day),
            (0x1028, 1..=127) => self.emergency_consumer(sub, value),
            (0x1029, 1..) => number().map(|reaction| self.error_reaction(reaction)),
            (0x1200..=0x12FF, 1 | 2) => self.sdo_cob_id(value),
            (0x1200..=0x12FF, 3) => number().and_then(|node| self.other_node(index, node)),
            (0x1300..=0x13FE, _) => self.safety(index, sub, value),
            (0x603F, 0)
                if profile::of_device(self.device).is_some_and(|profile| profile.errors().len() > 0) =>
            {
                number().map(|code| self.error_code(code).to_owned())
            }
            (0x1FA0..=0x1FCF, 1..) => number().and_then(|number| self.scanned(number)),
            _ => self.of_pdo(index, sub, value),
        }
    }

    /// Selects the text in the language of the decoder.
    pub(super) const fn pick<'t>(&self, english: &'t str, german: &'t str) -> &'t str {
        self.language.pick(english, german)
    }

    pub(super) fn or_off(&self, time: u32, text: fn(u32, Language) -> String) -> String {
        if time == 0 { self.pick("off", "aus").to_owned() } else { text(time, self.language) }
    }

    /// The value of an entry as a number for this node.
    pub(crate) fn number(&self, index: u16, sub: u8) -> Option<u32> {
        let entry = self.device.entry(index, sub)?;
        u32::try_from(entry.value()?.as_integer()?).ok()
    }
}
