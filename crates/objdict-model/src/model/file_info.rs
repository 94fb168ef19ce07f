//! Information about the description file (CiA 306-1 §4.4).

use super::part::part;
use super::{ClockTime, Date, DeviceClass, Extra, InvalidValues};

part! {
    /// The author, date and version of the description.
    pub struct FileInfo {
        /// `FileName`.
        pub file_name: Option<String>,
        /// `FileVersion`.
        pub file_version: Option<u8>,
        /// `FileRevision`.
        pub file_revision: Option<u8>,
        /// `EDSVersion`, such as `4.0`; 3.0 if missing.
        pub eds_version: Option<String>,
        /// `Description`.
        pub description: Option<String>,
        /// `CreationTime`.
        pub creation_time: Option<ClockTime>,
        /// `CreationDate`.
        pub creation_date: Option<Date>,
        /// `CreatedBy`.
        pub created_by: Option<String>,
        /// `ModificationTime`.
        pub modification_time: Option<ClockTime>,
        /// `ModificationDate`.
        pub modification_date: Option<Date>,
        /// `ModifiedBy`.
        pub modified_by: Option<String>,
        /// `LastEDS` of a DCF: the EDS it was created from.
        pub last_eds: Option<String>,
        /// `supportedLanguages` (CiA 311): language tags.
        pub languages: Vec<Box<str>>,
        /// `deviceClass` (CiA 311).
        pub device_class: Option<DeviceClass>,
        /// Keys without a field in the model.
        pub extra: Extra,
        /// Texts that are not valid in their fields.
        #[cfg_attr(feature = "serde", serde(rename = "misfits"))]
        pub invalid_values: InvalidValues,
    }
}
