//! Content of CiA 311 without keys in an EDS: identity, indicators, module interfaces, functions.

use super::part::{part, words};
use super::{Date, FileInfo, Labels};

part! {
    /// The headers of the two profiles of a description (`ProfileHeader`).
    pub struct ProfileHeaders {
        /// The header of the device profile.
        pub device: Option<ProfileHeader>,
        /// The header of the communication network profile.
        pub network: Option<ProfileHeader>,
        /// The file attributes of the communication network profile that differ from the device profile.
        pub network_file: Option<Box<FileInfo>>,
    }

    /// The identification of a profile (ISO 15745-1).
    pub struct ProfileHeader {
        /// `ProfileIdentification`.
        pub identification: Box<str>,
        /// `ProfileRevision`.
        pub revision: Box<str>,
        /// `ProfileName`.
        pub name: Box<str>,
        /// `ProfileSource`: the organisation that validated it.
        pub source: Box<str>,
        /// `ProfileDate`, as written.
        pub date: Option<Box<str>>,
        /// `AdditionalInformation`: references to further information.
        pub additional_information: Option<Box<str>>,
        /// `IASInterfaceType`.
        pub interface_types: Vec<Box<str>>,
    }

    /// The vendor and the names of the device (`DeviceIdentity`), unless they have fields in
    /// [`DeviceInfo`](super::DeviceInfo).
    pub struct DeviceIdentity {
        /// `vendorText`.
        pub vendor_text: Labels,
        /// `deviceFamily`.
        pub device_family: Labels,
        /// `productFamily`.
        pub product_family: Option<Box<str>>,
        /// `productText`.
        pub product_text: Labels,
        /// Every `orderNumber` except the first, which is
        /// [`DeviceInfo::order_code`](super::DeviceInfo::order_code).
        pub further_order_numbers: Vec<Box<str>>,
        /// `version`.
        pub versions: Vec<DeviceVersion>,
        /// `buildDate`.
        pub build_date: Option<Date>,
        /// `specificationRevision`.
        pub specification_revision: Option<Box<str>>,
        /// `instanceName`.
        pub instance_name: Option<Box<str>>,
        /// The elements with an attribute `readOnly`, and its value.
        pub read_only: Vec<(Box<str>, bool)>,
    }

    /// The `identity` of the communication network profile.
    pub struct NetworkIdentity {
        /// `vendorID`, as written.
        pub vendor_id: Option<Box<str>>,
        /// `productID`, as written.
        pub product_id: Option<Box<str>>,
        /// The elements that are also in the device profile.
        pub identity: DeviceIdentity,
    }

    /// A version of the device.
    pub struct DeviceVersion {
        /// `versionType`: `SW`, `FW` or `HW`.
        pub kind: Box<str>,
        /// The version.
        pub version: Box<str>,
    }

    /// The management of the device (`DeviceManager`).
    pub struct DeviceManager {
        /// `LEDList`: the LEDs.
        pub leds: Vec<Led>,
        /// `combinedState`: states that several LEDs show together.
        pub combined_states: Vec<CombinedState>,
        /// `moduleManagement`: the interfaces that modules are plugged into.
        pub module_interfaces: Vec<ModuleInterface>,
        /// `moduleManagement` of a module: the interface it is plugged into.
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
        /// `LEDstate`: the possible states.
        pub states: Vec<LedState>,
    }

    /// A state of a LED.
    pub struct LedState {
        /// `uniqueID`.
        pub unique_id: Box<str>,
        /// `state`.
        pub state: Option<LedOn>,
        /// `LEDcolor`.
        pub color: Option<LedColor>,
        /// `flashingPeriod` in ms.
        pub flashing_period: Option<u32>,
        /// `impulsWidth` in percent of the period; 50 if missing.
        pub impulse_width: Option<u8>,
        /// `numberOfImpulses` in a period; 1 if missing.
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
        /// `maxChilds`: the maximum number of modules.
        pub max_modules: Option<Box<str>>,
        /// `unusedSlots`: whether slots may be empty.
        pub unused_slots: Option<bool>,
        /// `multipleChilds`: whether a module may be plugged in several times.
        pub multiple: Option<bool>,
        /// Names and descriptions.
        pub labels: Labels,
        /// `fileList`: the descriptions of the modules.
        pub files: Vec<Box<str>>,
        /// `moduleTypeList`: the types of modules.
        pub module_types: Vec<ModuleType>,
        /// `connectedModuleList`: the connected modules.
        pub connected: Vec<ConnectedModule>,
    }

    /// A type of module.
    pub struct ModuleType {
        /// `uniqueID`, which EPSG 311 defines but CiA 311 does not.
        pub unique_id: Option<Box<str>>,
        /// `type`.
        pub kind: Box<str>,
    }

    /// A connected module.
    pub struct ConnectedModule {
        /// `childIDRef`.
        pub child: Box<str>,
        /// `position`: its slot.
        pub position: Option<u32>,
        /// `address`.
        pub address: Option<u32>,
    }

    /// The interface that a module is plugged into.
    pub struct OwnInterface {
        /// `childID`.
        pub child_id: Box<str>,
        /// `type`.
        pub kind: Box<str>,
        /// `maxCount`: the maximum number of such modules; unlimited if missing or 0.
        pub max_count: Option<u32>,
    }

    /// The address ranges for the objects of modules (`moduleManagement` of `ApplicationLayers`).
    pub struct ModuleObjects {
        /// `interface`.
        pub interfaces: Vec<ModuleRanges>,
        /// `moduleInterface` of a module.
        pub own: Option<OwnAddressing>,
    }

    /// The index ranges of one interface.
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

    /// The address range for the objects of a module.
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

    /// The description of the device's functions (`DeviceFunction`).
    pub struct DeviceFunction {
        /// `capabilities`: lists of characteristics.
        pub characteristics: Vec<CharacteristicsList>,
        /// `standardComplianceList`: the standards that the device complies with.
        pub compliance: Vec<Compliance>,
        /// `picturesList`.
        pub pictures: Vec<Picture>,
        /// `dictionaryList`: the text resources that labels refer to.
        pub dictionaries: Vec<Dictionary>,
    }

    /// Characteristics of one category.
    pub struct CharacteristicsList {
        /// `category`.
        pub category: Labels,
        /// The characteristics.
        pub characteristics: Vec<Characteristic>,
    }

    /// A characteristic of the device.
    pub struct Characteristic {
        /// `characteristicName`.
        pub name: Labels,
        /// `characteristicContent`.
        pub contents: Vec<Labels>,
    }

    /// A standard that the device complies with.
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
        /// `dictID`: the id in references of labels.
        pub id: Box<str>,
        /// `URI` of its file.
        pub uri: Box<str>,
    }
}

words! {
    /// The number of colours of a LED.
    pub enum LedColors {
        /// One.
        Mono = "monocolor",
        /// Two.
        Bi = "bicolor",
    }

    /// The purpose of a LED.
    pub enum LedType {
        /// An input or output.
        Io = "IO",
        /// The device.
        Device = "device",
        /// The communication.
        Communication = "communication",
    }

    /// The light of a LED.
    pub enum LedOn {
        /// On.
        On = "on",
        /// Off.
        Off = "off",
        /// Flashing.
        Flashing = "flashing",
    }

    /// The colour of a LED.
    pub enum LedColor {
        /// Green.
        Green = "green",
        /// Amber.
        Amber = "amber",
        /// Red.
        Red = "red",
    }
}

/// The default bit rate of a new device.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum DefaultBaudRate {
    /// A bit rate in kbit/s.
    Kbit(u16),
    /// Automatic bit rate detection.
    Auto,
}
