//! Objects that zencan creates from settings; they must not be listed as objects.

use super::ConfigMaker;
use super::answers::{EntryAnswer, Held};
use super::value::text_of;
use crate::model::{Access, Place};
use crate::resolve::Encoded;

/// The settings of the device.
pub(super) struct DeviceSettings {
    /// The device name, and the versions of hardware and software.
    pub(super) texts: [String; 3],
    /// In milliseconds.
    pub(super) heartbeat_period: u64,
    /// Vendor-ID, product code and revision number.
    pub(super) identity: [u64; 3],
}

/// The index of the object that stores values.
pub(super) const STORE: u16 = 0x1010;

/// Whether zencan creates the object from a setting.
pub(super) fn is_made_by_zencan(index: u16) -> bool {
    matches!(index, 0x1000 | 0x1001 | 0x1008..=0x100A | STORE | 0x1017 | 0x1018 | 0x1400..=0x1BFF)
}

impl ConfigMaker<'_> {
    /// The settings of the device; records the objects that zencan creates from them.
    pub(super) fn settings(&mut self) -> DeviceSettings {
        self.number(0x1000, 0, 4, 0); // zencan does not support a device type
        self.number(0x1001, 0, 1, 0);
        let [device_name, hardware_version, software_version] =
            [0x1008, 0x1009, 0x100A].map(|index| self.name(index));
        let device_name = device_name.unwrap_or_else(|| self.product_name());
        let texts = [device_name, hardware_version.unwrap_or_default(), software_version.unwrap_or_default()];
        for (index, text) in (0x1008..).zip(&texts) {
            let held = Held::Bytes(text.as_bytes().to_vec());
            self.answers.put(
                index,
                0,
                EntryAnswer { held, ..EntryAnswer::number(Access::Const, text.len(), 0) },
            );
        }
        let heartbeat_period = self.described(0x1017, 0, u64::from(u16::MAX));
        self.number(0x1017, 0, 2, heartbeat_period);
        let identity = [1, 2, 3].map(|sub| self.described(0x1018, sub, u64::from(u32::MAX)));
        for (sub, number) in (1..).zip(identity.into_iter().chain([0])) {
            self.number(0x1018, sub, 4, number); // the application sets the serial number
        }
        self.number(0x1018, 0, 1, 4);
        if self.stores {
            self.number(STORE, 0, 1, 1);
            self.note(Place::entry(STORE, 0), "zencan 0.0.5 aborts the upload of the entry");
            let answer = EntryAnswer { held: Held::Served, ..EntryAnswer::number(Access::Rw, 4, 0) };
            self.answers.put(STORE, 1, answer);
        }
        DeviceSettings { texts, heartbeat_period, identity }
    }

    fn number(&mut self, index: u16, sub: u8, size: usize, number: u64) {
        self.answers.put(index, sub, EntryAnswer::number(Access::Const, size, number));
    }

    /// The default of an entry.
    pub(super) fn datum(&self, index: u16, sub: u8) -> Option<&Encoded> {
        Some(&self.dictionary.entry(index, sub)?.resolved.default)
    }

    /// The number of an entry; 0 if it is missing or too large.
    pub(super) fn described(&self, index: u16, sub: u8, most: u64) -> u64 {
        match self.datum(index, sub) {
            Some(Encoded::Word(number)) if *number <= most => *number,
            _ => 0,
        }
    }

    /// The text of an object; `None` without the object, empty if it is not a text.
    fn name(&self, index: u16) -> Option<String> {
        match self.datum(index, 0)? {
            Encoded::Bytes(bytes) => {
                Some(text_of(bytes).filter(|text| !text.contains('\0')).unwrap_or_default())
            }
            Encoded::Word(_) | Encoded::Formula(_) => Some(String::new()),
        }
    }

    fn product_name(&self) -> String {
        let info = self.dictionary.device.device_info.as_ref();
        let name = info.and_then(|info| info.product_name.clone()).unwrap_or_default();
        name.replace('\0', "")
    }
}
