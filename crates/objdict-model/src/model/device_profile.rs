//! What CiA 311 says of a device and an EDS has no key for: identity, indicators, module interfaces, functions.

use super::part::{part, words};
use super::{Date, FileInfo, Labels};

part! {
    /// The headers of the two profiles of a description (`ProfileHeader`).
    pub struct ProfileHeaders {
        /// That of the device profile.
        pub device: Option<ProfileHeader>,
        /// That of the communication network profile.
        pub network: Option<ProfileHeader>,
        /// What the communication network profile says of its file, where that differs from the device profile.
        pub network_file: Option<Box<FileInfo>>,
    }

    /// What a profile says of itself (ISO 15745-1).
    pub struct ProfileHeader {
        /// `ProfileIdentification`.
        pub identification: Box<str>,
        /// `ProfileRevision`.
        pub revision: Box<str>,
        /// `ProfileName`.
        pub name: Box<str>,
        /// `ProfileSource`: who validated it.
        pub source: Box<str>,
        /// `ProfileDate`, as it is written.
        pub date: Option<Box<str>>,
        /// `AdditionalInformation`: where more stands.
        pub additional_information: Option<Box<str>>,
        /// `IASInterfaceType`.
        pub interface_types: Vec<Box<str>>,
    }

    /// Who made the device and what it is called (`DeviceIdentity`), as far as [`DeviceInfo`](super::DeviceInfo) has no
    /// field for it.
    pub struct DeviceIdentity {
        /// `vendorText`.
        pub vendor_text: Labels,
        /// `deviceFamily`.
        pub device_family: Labels,
        /// `productFamily`.
        pub product_family: Option<Box<str>>,
        /// `productText`.
        pub product_text: Labels,
        /// `orderNumber` behind the first, which is [`DeviceInfo::order_code`](super::DeviceInfo::order_code).
        pub further_order_numbers: Vec<Box<str>>,
        /// `version`.
        pub versions: Vec<DeviceVersion>,
        /// `buildDate`.
        pub build_date: Option<Date>,
        /// `specificationRevision`.
        pub specification_revision: Option<Box<str>>,
        /// `instanceName`.
        pub instance_name: Option<Box<str>>,
        /// The elements whose attribute `readOnly` stands there, with its value.
        pub read_only: Vec<(Box<str>, bool)>,
    }

    /// The `identity` of the communication network profile.
    pub struct NetworkIdentity {
        /// `vendorID`, as it is written.
        pub vendor_id: Option<Box<str>>,
        /// `productID`, as it is written.
        pub product_id: Option<Box<str>>,
        /// The elements that the device profile has too.
        pub identity: DeviceIdentity,
    }

    /// A version of the device.
    pub struct DeviceVersion {
        /// `versionType`: `SW`, `FW` or `HW`.
        pub kind: Box<str>,
        /// The version.
        pub version: Box<str>,
    }

    /// What is managed about the device itself (`DeviceManager`).
    pub struct DeviceManager {
        /// `LEDList`: its LEDs.
        pub leds: Vec<Led>,
        /// `combinedState`: states that several LEDs show together.
        pub combined_states: Vec<CombinedState>,
        /// `moduleManagement`: the interfaces that modules are plugged into.
        pub module_interfaces: Vec<ModuleInterface>,
        /// `moduleManagement` of a module: what it is plugged into.
        pub own_interface: Option<OwnInterface>,
    }

    /// A light emitting diode.
    pub struct Led {
        /// `LEDcolors`.
        pub colors: Option<LedColors>,
        /// `LEDtype`.
        pub kind: Option<LedType>,
        /// Names and descriptions.
        pub labels: Labels,
        /// `LEDstate`: what it can show.
        pub states: Vec<LedState>,
    }

    /// Something that a LED shows.
    pub struct LedState {
        /// `uniqueID`.
        pub unique_id: Box<str>,
        /// `state`.
        pub state: Option<LedOn>,
        /// `LEDcolor`.
        pub color: Option<LedColor>,
        /// `flashingPeriod` in ms.
        pub flashing_period: Option<u32>,
        /// `impulsWidth` in percent of the period; missing means 50.
        pub impulse_width: Option<u8>,
        /// `numberOfImpulses` in a period; missing means 1.
        pub impulses: Option<u8>,
        /// Names and descriptions.
        pub labels: Labels,
    }

    /// A state that several LEDs show together.
    pub struct CombinedState {
        /// Names and descriptions.
        pub labels: Labels,
        /// `LEDstateRef`: the ids of the states.
        pub states: Vec<Box<str>>,
    }

    /// An interface that modules are plugged into.
    pub struct ModuleInterface {
        /// `uniqueID`.
        pub unique_id: Box<str>,
        /// `maxChilds`: the largest number of modules.
        pub max_modules: Option<Box<str>>,
        /// `unusedSlots`: whether slots may stay empty.
        pub unused_slots: Option<bool>,
        /// `multipleChilds`: whether a module may be there several times.
        pub multiple: Option<bool>,
        /// Names and descriptions.
        pub labels: Labels,
        /// `fileList`: the descriptions of the modules.
        pub files: Vec<Box<str>>,
        /// `moduleTypeList`: the types of modules.
        pub module_types: Vec<ModuleType>,
        /// `connectedModuleList`: what is plugged in.
        pub connected: Vec<ConnectedModule>,
    }

    /// A type of module.
    pub struct ModuleType {
        /// `uniqueID`, which EPSG 311 has and CiA 311 has not.
        pub unique_id: Option<Box<str>>,
        /// `type`.
        pub kind: Box<str>,
    }

    /// A module that is plugged in.
    pub struct ConnectedModule {
        /// `childIDRef`.
        pub child: Box<str>,
        /// `position`: its slot.
        pub position: Option<u32>,
        /// `address`.
        pub address: Option<u32>,
    }

    /// What a module is plugged into.
    pub struct OwnInterface {
        /// `childID`.
        pub child_id: Box<str>,
        /// `type`.
        pub kind: Box<str>,
        /// `maxCount`: how many of them may be there; missing or 0 means any number.
        pub max_count: Option<u32>,
    }

    /// How the objects of modules lie in the dictionary (`moduleManagement` of `ApplicationLayers`).
    pub struct ModuleObjects {
        /// `interface`.
        pub interfaces: Vec<ModuleRanges>,
        /// `moduleInterface` of a module.
        pub own: Option<OwnAddressing>,
    }

    /// The ranges of indexes of one interface.
    pub struct ModuleRanges {
        /// `uniqueIDRef`: the interface of the [`DeviceManager`].
        pub interface: Box<str>,
        /// `addressing`: `auto` or `manual`.
        pub addressing: Option<Box<str>>,
        /// `rangeList`.
        pub ranges: Vec<ModuleRange>,
    }

    /// A range of indexes for the objects of modules.
    pub struct ModuleRange {
        /// `name`.
        pub name: Box<str>,
        /// `moduleType`.
        pub module_type: Option<Box<str>>,
        /// `baseIndex`, hexadecimal.
        pub base_index: Box<str>,
        /// `maxIndex`, hexadecimal.
        pub max_index: Option<Box<str>>,
        /// `maxSubIndex`, hexadecimal.
        pub max_sub_index: Option<Box<str>>,
        /// `sortMode`: `index` or `subIndex`.
        pub sort_mode: Option<Box<str>>,
        /// `sortNumber`: `continuous` or `address`.
        pub sort_number: Option<Box<str>>,
        /// `sortStep`, hexadecimal.
        pub sort_step: Option<Box<str>>,
    }

    /// Where a module's objects lie.
    pub struct OwnAddressing {
        /// `childIDRef`.
        pub child: Box<str>,
        /// `addressMin`.
        pub address_min: Option<Box<str>>,
        /// `addressMax`.
        pub address_max: Option<Box<str>>,
        /// `addressing`.
        pub addressing: Option<Box<str>>,
    }

    /// What the device does, in words (`DeviceFunction`).
    pub struct DeviceFunction {
        /// `capabilities`: lists of characteristics.
        pub characteristics: Vec<CharacteristicsList>,
        /// `standardComplianceList`: the standards that the device keeps.
        pub compliance: Vec<Compliance>,
        /// `picturesList`.
        pub pictures: Vec<Picture>,
        /// `dictionaryList`: where the texts stand that labels refer to.
        pub dictionaries: Vec<Dictionary>,
    }

    /// Characteristics of one category.
    pub struct CharacteristicsList {
        /// `category`.
        pub category: Labels,
        /// The characteristics.
        pub characteristics: Vec<Characteristic>,
    }

    /// Something to know about the device.
    pub struct Characteristic {
        /// `characteristicName`.
        pub name: Labels,
        /// `characteristicContent`.
        pub contents: Vec<Labels>,
    }

    /// A standard that the device keeps.
    pub struct Compliance {
        /// `name`.
        pub name: Box<str>,
        /// `range`: `international` or `internal`.
        pub range: Option<Box<str>>,
        /// Names and descriptions.
        pub labels: Labels,
    }

    /// A picture of the device.
    pub struct Picture {
        /// `URI`.
        pub uri: Box<str>,
        /// `number`.
        pub number: Option<u32>,
        /// Names and descriptions.
        pub labels: Labels,
    }

    /// A text resource in one language.
    pub struct Dictionary {
        /// `lang`.
        pub lang: Box<str>,
        /// `dictID`: what labels call it.
        pub id: Box<str>,
        /// `URI` of its file.
        pub uri: Box<str>,
    }
}

words! {
    /// The colours of a LED.
    pub enum LedColors {
        /// One.
        Mono = "monocolor",
        /// Two.
        Bi = "bicolor",
    }

    /// What a LED is for.
    pub enum LedType {
        /// An input or output.
        Io = "IO",
        /// The device.
        Device = "device",
        /// The communication.
        Communication = "communication",
    }

    /// Whether a LED is on.
    pub enum LedOn {
        /// It is.
        On = "on",
        /// It is not.
        Off = "off",
        /// By turns.
        Flashing = "flashing",
    }

    /// The colour that a LED shows.
    pub enum LedColor {
        /// Green.
        Green = "green",
        /// Amber.
        Amber = "amber",
        /// Red.
        Red = "red",
    }

    /// What kind of device a description is for.
    pub enum DeviceClass {
        /// One that is as it is.
        Compact = "compact",
        /// One of modules.
        Modular = "modular",
        /// One that can be configured.
        Configurable = "configurable",
    }
}

/// The bit rate that a device has when it is new.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum DefaultBaudRate {
    /// So many kbit/s.
    Kbit(u16),
    /// The device finds it out.
    Auto,
}
