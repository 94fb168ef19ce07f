//! The device: everything that a description says.

use std::collections::BTreeMap;

use super::{
    ApplicationProcess, Commissioning, DataType, DeviceFunction, DeviceIdentity, DeviceInfo, DeviceManager,
    DynamicChannels, ExtraSection, FileInfo, InvalidValues, ModuleObjects, Modules, NetworkIdentity, Object,
    ObjectList, ProfileHeaders, ToolCommand,
};

/// A device description, whatever format it came from.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Device {
    /// Whether this describes a device type or one configured node.
    pub kind: DeviceKind,
    /// Facts about the file; `None` when it has none.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub file_info: Option<FileInfo>,
    /// Facts about the device; `None` when the file has none.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub device_info: Option<DeviceInfo>,
    /// Which data types may be dummies in an RPDO; `None` when the file does not say.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub dummy_usage: Option<DummyUsage>,
    /// The lines of `Comments`; `None` when the file has none.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub comments: Option<Vec<String>>,
    /// The node that the device was configured for.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub commissioning: Option<Commissioning>,
    /// The lists that name the objects.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "super::is_default"))]
    pub lists: ObjectLists,
    /// The objects by index.
    #[cfg_attr(feature = "serde", serde(with = "super::index_keys"))]
    pub objects: BTreeMap<u16, Object>,
    /// The modules of a modular device; `None` when it is not one.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub modules: Option<Modules>,
    /// The dynamic channels (CiA 302-4).
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub dynamic_channels: Option<DynamicChannels>,
    /// The tools that can be started from the description.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Vec::is_empty"))]
    pub tools: Vec<ToolCommand>,
    /// What the profiles say of themselves (CiA 311).
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "super::is_default"))]
    pub headers: ProfileHeaders,
    /// Who made the device, as far as `device_info` has no field for it (CiA 311).
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub identity: Option<Box<DeviceIdentity>>,
    /// What the communication network profile says of the same, where it says more or else.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub network_identity: Option<Box<NetworkIdentity>>,
    /// Indicators and module interfaces (CiA 311).
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub manager: Option<Box<DeviceManager>>,
    /// What the device does, in words (CiA 311).
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Vec::is_empty"))]
    pub functions: Vec<DeviceFunction>,
    /// Data types, functions and the parameters that belong to no entry (CiA 311).
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Vec::is_empty"))]
    pub application: Vec<ApplicationProcess>,
    /// How the objects of modules lie in the dictionary (CiA 311).
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub module_objects: Option<Box<ModuleObjects>>,
    /// Sections that the model does not know.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Vec::is_empty"))]
    pub extra: Vec<ExtraSection>,
}

/// What a description describes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum DeviceKind {
    /// A type of device (EDS, XDD).
    #[default]
    Type,
    /// One node, configured (DCF, XDC).
    Node,
}

/// The lists that name a device's objects; `None` for a list that the file does not have.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct ObjectLists {
    /// `MandatoryObjects`.
    #[cfg_attr(
        feature = "serde",
        serde(with = "super::index_list", skip_serializing_if = "Option::is_none")
    )]
    pub mandatory: Option<Vec<u16>>,
    /// `OptionalObjects`.
    #[cfg_attr(
        feature = "serde",
        serde(with = "super::index_list", skip_serializing_if = "Option::is_none")
    )]
    pub optional: Option<Vec<u16>>,
    /// `ManufacturerObjects`.
    #[cfg_attr(
        feature = "serde",
        serde(with = "super::index_list", skip_serializing_if = "Option::is_none")
    )]
    pub manufacturer: Option<Vec<u16>>,
}

impl ObjectLists {
    /// The lists that name these objects: all but definitions of data types.
    pub fn naming(objects: impl IntoIterator<Item = u16>) -> Self {
        let mut lists =
            Self { mandatory: Some(Vec::new()), optional: Some(Vec::new()), manufacturer: Some(Vec::new()) };
        for index in objects {
            if let Some(members) = ObjectList::of(index).and_then(|list| lists.get_mut(list).as_mut()) {
                members.push(index);
            }
        }
        lists
    }

    /// The indexes of a list; empty for one that the file does not have.
    pub fn get(&self, list: ObjectList) -> &[u16] {
        let indexes = match list {
            ObjectList::Mandatory => &self.mandatory,
            ObjectList::Optional => &self.optional,
            ObjectList::Manufacturer => &self.manufacturer,
        };
        indexes.as_deref().unwrap_or_default()
    }

    /// A list, for writing.
    pub fn get_mut(&mut self, list: ObjectList) -> &mut Option<Vec<u16>> {
        match list {
            ObjectList::Mandatory => &mut self.mandatory,
            ObjectList::Optional => &mut self.optional,
            ObjectList::Manufacturer => &mut self.manufacturer,
        }
    }

    /// Whether an index stands in one of the lists. This looks at each item.
    pub fn contains(&self, index: u16) -> bool {
        ObjectList::ALL.into_iter().any(|list| self.get(list).contains(&index))
    }

    /// Every listed index with its list, in the order of the file.
    pub fn iter(&self) -> impl Iterator<Item = (ObjectList, u16)> + '_ {
        ObjectList::ALL.into_iter().flat_map(|list| self.get(list).iter().map(move |&index| (list, index)))
    }
}

/// Which data types may be dummies in an RPDO (CiA 306-1 §4.6.2).
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct DummyUsage {
    /// Data types with whether they may.
    #[cfg_attr(feature = "serde", serde(with = "super::unique_keys"))]
    pub types: BTreeMap<DataType, bool>,
    /// Texts that are no values of their fields.
    #[cfg_attr(
        feature = "serde",
        serde(rename = "misfits", skip_serializing_if = "InvalidValues::is_empty")
    )]
    pub invalid_values: InvalidValues,
    /// Keys that the model does not know.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "super::Extra::is_empty"))]
    pub extra: super::Extra,
}

impl Device {
    /// The object of an index.
    pub fn object(&self, index: u16) -> Option<&Object> {
        self.objects.get(&index)
    }

    /// The entry of an index and a sub-index; see [`Object::entry`].
    pub fn entry(&self, index: u16, sub: u8) -> Option<std::borrow::Cow<'_, super::Entry>> {
        self.object(index)?.entry(sub)
    }

    /// The node-ID that the device was configured for, where it is one.
    pub fn node_id(&self) -> Option<u8> {
        self.commissioning.as_ref()?.node_id.filter(|id| (1..=127).contains(id))
    }

    /// The number of the device profile: the low word of 1000h, 0 for none; `None` where 1000h has no value.
    pub fn profile(&self) -> Option<u16> {
        let device_type = self.entry(0x1000, 0)?.value()?.as_integer()?;
        u16::try_from(device_type & 0xFFFF).ok()
    }

    /// Whether modules may add objects, so that a reference to a missing object may be right.
    pub fn is_modular(&self) -> bool {
        self.modules.as_ref().is_some_and(|modules| !modules.supported.is_empty())
    }
}
