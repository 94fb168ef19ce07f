//! Information about the device (CiA 306-1 §4.5).

use super::part::part;
use super::{DefaultBaudRate, Extra, Field, InvalidValues};

part! {
    /// Vendor, product and general features of the device.
    pub struct DeviceInfo {
        /// `VendorName`.
        pub vendor_name: Option<String>,
        /// `VendorNumber`: the vendor-ID, as in 1018h sub-index 1.
        pub vendor_number: Option<u32>,
        /// `ProductName`.
        pub product_name: Option<String>,
        /// `ProductNumber`: the product code, as in 1018h sub-index 2.
        pub product_number: Option<u32>,
        /// `RevisionNumber`, as in 1018h sub-index 3.
        pub revision_number: Option<u32>,
        /// `OrderCode`.
        pub order_code: Option<String>,
        /// `BaudRate_x`: the supported bit rates.
        pub baud_rates: BaudRates,
        /// `SimpleBootUpMaster`.
        pub simple_boot_up_master: Option<bool>,
        /// `SimpleBootUpSlave`.
        pub simple_boot_up_slave: Option<bool>,
        /// `Granularity` of the PDO mapping in bits, 1 to 64; 0 if the mapping is fixed.
        pub granularity: Option<u8>,
        /// `DynamicChannelsSupported` (CiA 302-4); 0 if not supported.
        pub dynamic_channels_supported: Option<u8>,
        /// `GroupMessaging`: whether the device supports multiplexed PDOs.
        pub group_messaging: Option<bool>,
        /// `NrOfRXPDO`: the number of RPDOs, including implicit ones.
        pub rpdo_count: Option<u16>,
        /// `NrOfTXPDO`: the number of TPDOs, including implicit ones.
        pub tpdo_count: Option<u16>,
        /// `LSS_Supported`.
        pub lss_supported: Option<bool>,
        /// `CompactPDO`: bit n is set if the communication parameter of an implicit PDO has sub-index n + 1.
        pub compact_pdo: Option<u8>,
        /// `CANopenSafetySupported` (CiA 306-1 annex A).
        pub safety_supported: Option<bool>,
        /// `conformanceClass` (CiA 311).
        pub conformance_class: Option<String>,
        /// `communicationEntityType` (CiA 311), such as `slave`, as written.
        pub communication_entities: Vec<Box<str>>,
        /// `selfStartingDevice` (CiA 311): whether the device becomes operational automatically.
        pub self_starting: Option<bool>,
        /// `SDORequestingDevice` (CiA 311, CiA 302-5).
        pub sdo_requesting: Option<bool>,
        /// `flyingMaster` (CiA 311, CiA 302-2).
        pub flying_master: Option<bool>,
        /// `SDOManager` (CiA 311, CiA 302-5).
        pub sdo_manager: Option<bool>,
        /// `configurationManager` (CiA 311, CiA 302-3).
        pub configuration_manager: Option<bool>,
        /// `layerSettingServiceMaster` (CiA 311, CiA 305).
        pub lss_master: Option<bool>,
        /// The bit rate of a new device (`baudRate` / `defaultValue` of CiA 311).
        pub default_baud_rate: Option<DefaultBaudRate>,
        /// Keys without a field in the model, including obsolete ones of EDS 3.0.
        pub extra: Extra,
        /// Texts that are not valid in their fields.
        #[cfg_attr(feature = "serde", serde(rename = "misfits"))]
        pub invalid_values: InvalidValues,
    }
}

/// Whether each bit rate is supported, as far as stated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct BaudRates {
    /// 10 kbit/s.
    #[cfg_attr(feature = "serde", serde(rename = "10", skip_serializing_if = "Option::is_none"))]
    pub kbit_10: Option<bool>,
    /// 20 kbit/s.
    #[cfg_attr(feature = "serde", serde(rename = "20", skip_serializing_if = "Option::is_none"))]
    pub kbit_20: Option<bool>,
    /// 50 kbit/s.
    #[cfg_attr(feature = "serde", serde(rename = "50", skip_serializing_if = "Option::is_none"))]
    pub kbit_50: Option<bool>,
    /// 100 kbit/s, which is defined in CiA 311 but not in CiA 301.
    #[cfg_attr(feature = "serde", serde(rename = "100", skip_serializing_if = "Option::is_none"))]
    pub kbit_100: Option<bool>,
    /// 125 kbit/s.
    #[cfg_attr(feature = "serde", serde(rename = "125", skip_serializing_if = "Option::is_none"))]
    pub kbit_125: Option<bool>,
    /// 250 kbit/s.
    #[cfg_attr(feature = "serde", serde(rename = "250", skip_serializing_if = "Option::is_none"))]
    pub kbit_250: Option<bool>,
    /// 500 kbit/s.
    #[cfg_attr(feature = "serde", serde(rename = "500", skip_serializing_if = "Option::is_none"))]
    pub kbit_500: Option<bool>,
    /// 800 kbit/s.
    #[cfg_attr(feature = "serde", serde(rename = "800", skip_serializing_if = "Option::is_none"))]
    pub kbit_800: Option<bool>,
    /// 1000 kbit/s.
    #[cfg_attr(feature = "serde", serde(rename = "1000", skip_serializing_if = "Option::is_none"))]
    pub kbit_1000: Option<bool>,
    /// Automatic bit rate detection.
    #[cfg_attr(feature = "serde", serde(rename = "auto", skip_serializing_if = "Option::is_none"))]
    pub auto: Option<bool>,
}

/// Keys of EDS version 3.0 that later versions reserve (CiA 306-1 §4.5).
const RESERVED: [&str; 6] = [
    "ProductVersion",
    "ProductRevision",
    "LMT_ManufacturerName",
    "LMT_ProductName",
    "ExtendedBootUpMaster",
    "ExtendedBootUpSlave",
];

impl DeviceInfo {
    /// Whether a key is obsolete since EDS version 3.0, so that readers ignore it. Such keys are in
    /// [`extra`](Self::extra).
    pub fn is_reserved(key: &str) -> bool {
        RESERVED.iter().any(|reserved| reserved.eq_ignore_ascii_case(key))
    }
}

impl BaudRates {
    /// The bit rates of CiA 301 in kbit/s (§6.2).
    pub const DEFINED: [u16; 8] = [10, 20, 50, 125, 250, 500, 800, 1000];

    /// Every bit rate of CiA 301 in kbit/s, with its field and whether it is supported.
    pub fn iter(&self) -> impl Iterator<Item = (u16, Field, Option<bool>)> {
        [
            (10, Field::BaudRate10, self.kbit_10),
            (20, Field::BaudRate20, self.kbit_20),
            (50, Field::BaudRate50, self.kbit_50),
            (125, Field::BaudRate125, self.kbit_125),
            (250, Field::BaudRate250, self.kbit_250),
            (500, Field::BaudRate500, self.kbit_500),
            (800, Field::BaudRate800, self.kbit_800),
            (1000, Field::BaudRate1000, self.kbit_1000),
        ]
        .into_iter()
    }

    /// Whether a bit rate in kbit/s is supported; `None` if not stated, or for a rate that CiA 301 does not
    /// define.
    pub fn get(&self, kbit: u16) -> Option<bool> {
        self.iter().find(|(rate, ..)| *rate == kbit).and_then(|(.., supported)| supported)
    }

    /// The supported bit rates in kbit/s.
    pub fn supported(&self) -> impl Iterator<Item = u16> {
        self.iter().filter(|(.., supported)| *supported == Some(true)).map(|(rate, ..)| rate)
    }
}
