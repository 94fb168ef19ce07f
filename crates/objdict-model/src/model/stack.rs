//! Settings for the generators of CANopenNode in description files.

use super::part::{part, words};

part! {
    /// How a stack must store and treat an object or entry: `CO_` properties of an XDD, or comments such as
    /// `;StorageLocation=RAM` of an EDS, in the notation of CANopenEditor.
    pub struct StackOptions {
        /// `CO_storageGroup`, `StorageLocation`: the group of variables with common storage, such as
        /// `RAM` or `PERSIST_COMM`.
        pub storage_group: Option<Box<str>>,
        /// `CO_countLabel`: the macro that counts objects of this kind, such as `TPDO`.
        pub count_label: Option<Box<str>>,
        /// `CO_disabled`: whether the object is described but not generated.
        pub disabled: Option<bool>,
        /// `CO_accessSRDO`: the SRDOs that may carry the entry.
        pub srdo_access: Option<SrdoAccess>,
        /// `CO_stringLengthMin`: the minimum capacity of a string in characters, if the default is shorter.
        pub min_string_length: Option<u32>,
        /// `CO_flagsPDO`: whether a change of the value triggers its TPDO.
        pub detects_change: Option<bool>,
        /// `CO_extensionIO`: whether the application handles reading and writing.
        pub io_extension: Option<bool>,
    }
}

words! {
    /// The SRDOs that may carry an entry.
    pub enum SrdoAccess {
        /// None.
        No = "no",
        /// SRDOs that the device sends.
        Tx = "tx",
        /// SRDOs that the device receives.
        Rx = "rx",
        /// Both.
        Trx = "trx",
    }
}

impl StackOptions {
    /// Sets the option with this property name. `false` for an unknown name, an invalid value, or an
    /// option that is already set.
    pub fn set(&mut self, name: &str, value: &str) -> bool {
        fn once<T>(field: &mut Option<T>, value: Option<T>) -> bool {
            let takes = field.is_none() && value.is_some();
            if takes {
                *field = value;
            }
            takes
        }
        let flag = || match value {
            "true" | "1" => Some(true),
            "false" | "0" => Some(false),
            _ => None,
        };
        match name {
            "CO_storageGroup" => once(&mut self.storage_group, Some(value.into())),
            "CO_countLabel" => once(&mut self.count_label, Some(value.into())),
            "CO_disabled" => once(&mut self.disabled, flag()),
            "CO_accessSRDO" => once(&mut self.srdo_access, SrdoAccess::from_name(value)),
            "CO_stringLengthMin" => once(&mut self.min_string_length, value.parse().ok()),
            "CO_flagsPDO" => once(&mut self.detects_change, flag()),
            "CO_extensionIO" => once(&mut self.io_extension, flag()),
            _ => false,
        }
    }

    /// The settings, by the names of their properties.
    pub fn settings(&self) -> impl Iterator<Item = (&'static str, String)> {
        let text = |text: &Option<Box<str>>| text.as_deref().map(str::to_owned);
        let flag = |flag: Option<bool>| flag.map(|flag| flag.to_string());
        [
            ("CO_disabled", flag(self.disabled)),
            ("CO_countLabel", text(&self.count_label)),
            ("CO_storageGroup", text(&self.storage_group)),
            ("CO_extensionIO", flag(self.io_extension)),
            ("CO_flagsPDO", flag(self.detects_change)),
            ("CO_accessSRDO", self.srdo_access.map(|access| access.name().to_owned())),
            ("CO_stringLengthMin", self.min_string_length.map(|length| length.to_string())),
        ]
        .into_iter()
        .filter_map(|(name, value)| value.map(|value| (name, value)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn settings_are_set_once_and_come_back() {
        let settings = [
            ("CO_disabled", "true"),
            ("CO_countLabel", "TPDO"),
            ("CO_storageGroup", "PERSIST_COMM"),
            ("CO_extensionIO", "false"),
            ("CO_flagsPDO", "true"),
            ("CO_accessSRDO", "trx"),
            ("CO_stringLengthMin", "40"),
        ];
        let mut options = StackOptions::default();
        for (name, value) in settings {
            assert!(options.set(name, value) && !options.set(name, value), "{name}");
        }
        let back: Vec<_> = options.settings().collect();
        assert_eq!(back.iter().map(|(name, value)| (*name, value.as_str())).collect::<Vec<_>>(), settings);
        for (name, value) in [("CO_disabled", "yes"), ("CO_accessSRDO", "both"), ("CO_color", "red")] {
            assert!(!StackOptions::default().set(name, value), "{name}");
        }
    }
}
