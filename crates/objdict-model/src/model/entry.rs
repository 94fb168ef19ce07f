//! Entries: the content of a sub-index.

use super::part::part;
use super::{
    Access, DataType, Extra, InvalidValues, ObjectType, Parameter, PdoKind, PdoMapping, StackOptions, Value,
};

part! {
    /// The description of a sub-index, or of an object as a whole (CiA 306-1 §4.6.3.2).
    pub struct Entry from "super::flat::EntryForm" {
        /// `ParameterName`; empty if missing.
        always() pub name: Box<str>,
        /// `ObjectType`; VAR if missing.
        pub object_type: Option<ObjectType>,
        /// `DataType`.
        pub data_type: Option<DataType>,
        /// `AccessType`.
        pub access: Option<Access>,
        /// `PDOMapping`; not mappable if missing.
        pub pdo_mapping: Option<PdoMapping>,
        /// `DefaultValue`: the value after restoring the defaults.
        pub default: Option<Value>,
        /// `LowLimit`.
        pub low_limit: Option<Value>,
        /// `HighLimit`.
        pub high_limit: Option<Value>,
        /// `ObjFlags`; no flags if missing.
        pub flags: Option<ObjFlags>,
        /// The keys that a DCF adds.
        pub configured: Option<Box<Configured>>,
        /// `SRDOMapping` and `InvertedSRAD` of a safety device (CiA 306-1 annex A).
        pub safety: Option<Box<SafetyMapping>>,
        /// The description of the entry in the application process (CiA 311).
        pub parameter: Option<Box<Parameter>>,
        /// Settings for the generators of CANopenNode.
        pub stack: Option<Box<StackOptions>>,
        /// Keys without a field in the model.
        pub extra: Extra,
        /// Texts that are not valid in their fields.
        #[cfg_attr(feature = "serde", serde(rename = "misfits"))]
        pub invalid_values: InvalidValues,
    }
}

/// How a configuration tool must treat an entry (CiA 306-1 §4.6.3.3).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(transparent))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ObjFlags(pub u32);

impl ObjFlags {
    /// Bit 0: the tool must not write the entry when it downloads a configuration.
    pub const fn refuses_write(self) -> bool {
        self.0 & 1 != 0
    }

    /// Bit 1: the tool must not read the entry when it scans a device.
    pub const fn refuses_read(self) -> bool {
        self.0 & 2 != 0
    }
}

part! {
    /// The configuration of an entry in a DCF (CiA 306-1 §5.3).
    pub struct Configured {
        /// `ParameterValue`: the value that the node must have.
        pub value: Option<Value>,
        /// `Denotation`: the name in the application.
        pub denotation: Option<Box<str>>,
        /// `UploadFile`: the destination of data read from a DOMAIN.
        pub upload_file: Option<Box<str>>,
        /// `DownloadFile`: the source of data written to a DOMAIN.
        pub download_file: Option<Box<str>>,
        /// `ParamRefd`: the reference designator of the parameter.
        pub reference_designator: Option<Box<str>>,
    }

    /// The keys of an entry of a safety device (CiA 306-1 annex A).
    pub struct SafetyMapping {
        /// `SRDOMapping`: whether an SRDO may carry the entry.
        pub srdo_mapping: Option<bool>,
        /// `InvertedSRAD`: index (upper 16 bits) and sub-index of the entry with the inverted value.
        pub inverted_srad: Option<u32>,
    }
}

impl Entry {
    /// The data type; DOMAIN for an object of type DOMAIN without one (CiA 306-1 §4.6.3.2).
    pub fn implied_type(&self) -> Option<DataType> {
        self.data_type.or((self.object_type == Some(ObjectType::Domain)).then_some(DataType::DOMAIN))
    }

    /// The access type; `rw` for an object of type DOMAIN without one (CiA 306-1 §4.6.3.2).
    pub fn implied_access(&self) -> Option<Access> {
        self.access.or((self.object_type == Some(ObjectType::Domain)).then_some(Access::Rw))
    }

    /// The limits and values that are stated, with their names in JSON.
    pub(super) fn values(&self) -> impl Iterator<Item = (&'static str, &Value)> {
        let values = [
            ("default", self.default.as_ref()),
            ("low_limit", self.low_limit.as_ref()),
            ("high_limit", self.high_limit.as_ref()),
            ("configured", self.configured_value()),
        ];
        values.into_iter().filter_map(|(name, value)| Some((name, value?)))
    }

    /// Whether all limits and values are in the range of `data_type`, so that they remain meaningful with it.
    pub fn fits_type(&self, data_type: DataType) -> bool {
        let Some((low, high)) = data_type.integer_range() else { return true };
        self.values().filter_map(|(_, value)| value.as_integer()).all(|number| (low..=high).contains(&number))
    }

    /// Whether a PDO may carry the entry.
    pub fn is_mappable(&self) -> bool {
        self.pdo_mapping.is_some_and(PdoMapping::is_mappable)
    }

    /// Whether its access type and its mapping allow PDOs of a direction to carry it; `true` without an
    /// access type.
    pub fn fits_pdo(&self, kind: PdoKind) -> bool {
        match (kind, self.pdo_mapping) {
            (PdoKind::Rpdo, Some(PdoMapping::Tpdo)) | (PdoKind::Tpdo, Some(PdoMapping::Rpdo)) => false,
            (PdoKind::Rpdo, _) => self.access.is_none_or(Access::fits_rpdo),
            (PdoKind::Tpdo, _) => self.access.is_none_or(Access::fits_tpdo),
        }
    }

    /// The kinds of PDOs that may map it: `RPDO`, `TPDO`, both, or empty.
    pub fn pdo_directions(&self) -> &'static str {
        match self.pdo_mapping {
            None | Some(PdoMapping::No) => "",
            Some(_) => match (self.fits_pdo(PdoKind::Rpdo), self.fits_pdo(PdoKind::Tpdo)) {
                (true, true) => "RPDO TPDO",
                (true, false) => "RPDO",
                (false, true) => "TPDO",
                // not allowed by the access type, which `check` reports
                (false, false) => "PDO",
            },
        }
    }

    /// The flags; no flags if missing.
    pub fn flags(&self) -> ObjFlags {
        self.flags.unwrap_or_default()
    }

    /// The configured value of a DCF; `None` if it keeps the default.
    pub fn configured_value(&self) -> Option<&Value> {
        self.configured.as_ref()?.value.as_ref()
    }

    /// Whether a DCF configures a value other than the default. Formulas are evaluated for the node
    /// `node_id`; without it they are considered changed.
    pub fn is_changed(&self, node_id: Option<u8>) -> bool {
        let Some(configured) = self.configured_value() else { return false };
        let Some(default) = &self.default else { return true };
        if configured == default {
            return false;
        }
        let number = |value: &Value| value.integer_for(node_id?);
        let (configured, default) = (number(configured), number(default));
        configured.is_none() || configured != default
    }

    /// The value after configuration: from the DCF, otherwise the default.
    pub fn value(&self) -> Option<&Value> {
        self.configured_value().or(self.default.as_ref())
    }

    /// Mutable access to the configuration, which is created if missing.
    pub fn configured_mut(&mut self) -> &mut Configured {
        self.configured.get_or_insert_default()
    }

    /// Mutable access to the parameter, which is created if missing.
    pub fn parameter_mut(&mut self) -> &mut Parameter {
        self.parameter.get_or_insert_default()
    }

    /// Mutable access to the settings for CANopenNode, which are created if missing.
    pub fn stack_mut(&mut self) -> &mut StackOptions {
        self.stack.get_or_insert_default()
    }

    /// Mutable access to the safety keys, which are created if missing.
    pub fn safety_mut(&mut self) -> &mut SafetyMapping {
        self.safety.get_or_insert_default()
    }
}
