//! The device: the complete content of a description.

use std::borrow::Cow;
use std::collections::BTreeMap;

use super::part::part;
use super::{
    ApplicationProcess, Commissioning, DataType, DeviceFunction, DeviceIdentity, DeviceInfo, DeviceManager,
    DynamicChannels, Entry, ExplicitDownload, ExtraSection, Field, FileInfo, InvalidValues, ModuleObjects,
    Modules, NetworkIdentity, Object, ObjectList, Objects, Part, Place, ProfileHeaders, ToolCommand,
};

part! {
    /// A device description, independent of its format.
    pub struct Device {
        /// Whether it describes a device type or a configured node.
        always() pub kind: DeviceKind,
        /// Information about the file; `None` if missing.
        pub file_info: Option<FileInfo>,
        /// Information about the device; `None` if missing.
        pub device_info: Option<DeviceInfo>,
        /// The data types that can be dummy entries in an RPDO; `None` if not stated.
        pub dummy_usage: Option<DummyUsage>,
        /// The lines of `Comments`; `None` if missing.
        pub comments: Option<Vec<String>>,
        /// The configured node.
        pub commissioning: Option<Commissioning>,
        /// Downloads that configure the node in addition to the values of its entries, in order.
        pub downloads: Vec<ExplicitDownload>,
        /// The object lists.
        pub lists: ObjectLists,
        /// The objects by index.
        #[cfg_attr(feature = "schema", schemars(with = "BTreeMap<super::HexText<u16>, Object>"))]
        always() pub objects: Objects,
        /// The modules of a modular device; `None` for any other device.
        pub modules: Option<Modules>,
        /// The dynamic channels (CiA 302-4).
        pub dynamic_channels: Option<DynamicChannels>,
        /// The tools that can be started for the device.
        pub tools: Vec<ToolCommand>,
        /// The headers of the profiles (CiA 311).
        pub headers: ProfileHeaders,
        /// The identity of the device that has no field in `device_info` (CiA 311).
        pub identity: Option<Box<DeviceIdentity>>,
        /// The identity in the communication network profile, if it differs.
        pub network_identity: Option<Box<NetworkIdentity>>,
        /// Indicators and module interfaces (CiA 311).
        pub manager: Option<Box<DeviceManager>>,
        /// Descriptions of the device's functions (CiA 311).
        pub functions: Vec<DeviceFunction>,
        /// Data types, functions and parameters without an entry (CiA 311).
        pub application: Vec<ApplicationProcess>,
        /// The address ranges for the objects of modules (CiA 311).
        pub module_objects: Option<Box<ModuleObjects>>,
        /// Unknown sections.
        pub extra: Vec<ExtraSection>,
    }
}

/// The subject of a description.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum DeviceKind {
    /// A device type (EDS, XDD).
    #[default]
    Type,
    /// A configured node (DCF, XDC).
    Node,
}

impl Device {
    /// Whether it was read from EtherCAT slave information (ESI), directly or via other formats, and so is
    /// not a CANopen node.
    pub fn is_ethercat(&self) -> bool {
        self.extra.iter().any(|section| section.name() == super::ETHERCAT_SECTION)
    }

    /// The device without [disabled](super::Object::is_disabled) objects, as used everywhere except when writing a
    /// description.
    pub fn without_disabled(&self) -> Cow<'_, Self> {
        if !self.objects.values().any(super::Object::is_disabled) {
            return Cow::Borrowed(self);
        }
        let mut device = self.clone();
        device.objects.retain(|_, object| !object.is_disabled());
        for list in ObjectList::ALL {
            let members = device.lists.get_mut(list).iter_mut();
            members.for_each(|members| {
                members.retain(|index| !self.objects.get(index).is_some_and(super::Object::is_disabled));
            });
        }
        Cow::Owned(device)
    }
}

part! {
    /// The object lists of a device; `None` for a missing list.
    pub struct ObjectLists {
        /// `MandatoryObjects`.
        #[cfg_attr(feature = "serde", serde(with = "super::index_list"))]
        #[cfg_attr(feature = "schema", schemars(with = "Option<Vec<super::HexText<u16>>>"))]
        pub mandatory: Option<Vec<u16>>,
        /// `OptionalObjects`.
        #[cfg_attr(feature = "serde", serde(with = "super::index_list"))]
        #[cfg_attr(feature = "schema", schemars(with = "Option<Vec<super::HexText<u16>>>"))]
        pub optional: Option<Vec<u16>>,
        /// `ManufacturerObjects`.
        #[cfg_attr(feature = "serde", serde(with = "super::index_list"))]
        #[cfg_attr(feature = "schema", schemars(with = "Option<Vec<super::HexText<u16>>>"))]
        pub manufacturer: Option<Vec<u16>>,
    }
}

impl ObjectLists {
    /// The lists for these objects: all except definitions of data types.
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

    /// The indexes of a list; empty for a missing list.
    pub fn get(&self, list: ObjectList) -> &[u16] {
        self.indexes(list).unwrap_or_default()
    }

    /// Whether there is a list, even if empty.
    pub fn has(&self, list: ObjectList) -> bool {
        self.indexes(list).is_some()
    }

    fn indexes(&self, list: ObjectList) -> Option<&[u16]> {
        let indexes = match list {
            ObjectList::Mandatory => &self.mandatory,
            ObjectList::Optional => &self.optional,
            ObjectList::Manufacturer => &self.manufacturer,
        };
        indexes.as_deref()
    }

    /// Mutable access to a list.
    pub fn get_mut(&mut self, list: ObjectList) -> &mut Option<Vec<u16>> {
        match list {
            ObjectList::Mandatory => &mut self.mandatory,
            ObjectList::Optional => &mut self.optional,
            ObjectList::Manufacturer => &mut self.manufacturer,
        }
    }

    /// Adds an object to its list, before the next higher index. A definition of a data type has no list.
    pub fn add(&mut self, index: u16) {
        if let Some(list) = ObjectList::of(index) {
            let members = self.get_mut(list).get_or_insert_default();
            members.insert(members.partition_point(|&member| member < index), index);
        }
    }

    /// Whether one of the lists contains an index. The search is linear.
    pub fn contains(&self, index: u16) -> bool {
        ObjectList::ALL.into_iter().any(|list| self.get(list).contains(&index))
    }

    /// Every listed index with its list, in the order of the file.
    pub fn iter(&self) -> impl Iterator<Item = (ObjectList, u16)> + '_ {
        ObjectList::ALL.into_iter().flat_map(|list| self.get(list).iter().map(move |&index| (list, index)))
    }
}

part! {
    /// The data types that can be dummy entries in an RPDO (CiA 306-1 §4.6.2).
    pub struct DummyUsage {
        /// Data types, and whether they are allowed.
        #[cfg_attr(feature = "serde", serde(with = "super::unique_keys"))]
        #[cfg_attr(feature = "schema", schemars(with = "BTreeMap<DataType, bool>"))]
        always() pub types: BTreeMap<DataType, bool>,
        /// Texts that are not valid in their fields.
        #[cfg_attr(feature = "serde", serde(rename = "misfits"))]
        pub invalid_values: InvalidValues,
        /// Keys without a field in the model.
        pub extra: super::Extra,
    }
}

impl Device {
    /// The object at an index.
    pub fn object(&self, index: u16) -> Option<&Object> {
        self.objects.get(&index)
    }

    /// The entry at an index and a sub-index; see [`Object::entry`].
    pub fn entry(&self, index: u16, sub: u8) -> Option<std::borrow::Cow<'_, super::Entry>> {
        self.object(index)?.entry(sub)
    }

    /// The configured node-ID, if it is valid.
    pub fn node_id(&self) -> Option<u8> {
        self.commissioning.as_ref()?.node_id.filter(|id| (1..=127).contains(id))
    }

    /// The number of the device profile: the low word of 1000h, 0 for no profile; `None` if 1000h has no
    /// value.
    pub fn profile(&self) -> Option<u16> {
        let device_type = self.entry(0x1000, 0)?.value()?.as_integer()?;
        u16::try_from(device_type & 0xFFFF).ok()
    }

    /// Whether modules may add objects, so that a reference to a missing object may be valid.
    pub fn is_modular(&self) -> bool {
        self.modules.as_ref().is_some_and(|modules| !modules.supported.is_empty())
    }
}

impl Device {
    /// The place that describes an entry: the sub-index if described, otherwise the object, which describes a VAR and
    /// all sub-indexes of a compact object.
    pub fn entry_place(&self, index: u16, sub: u8) -> Place {
        match self.object(index).and_then(|object| object.subs.get(sub)) {
            Some(_) => Place::entry(index, sub),
            None => Place::object(index),
        }
    }

    /// The place of a sub-index's value: the configured value of a DCF, otherwise the default
    /// ([`Object::value`](super::Object::value)).
    pub fn value_place(&self, index: u16, sub: u8) -> Place {
        let Some(object) = self.object(index) else { return Place::object(index) };
        let field = |entry: &Entry| match entry.configured_value() {
            Some(_) => Field::ParameterValue,
            None => Field::DefaultValue,
        };
        if let Some(entry) = object.subs.get(sub) {
            return Place::entry(index, sub).field(field(entry));
        }
        match &object.compact {
            Some(_) if sub == 0 => Place::object(index).field(Field::CompactSubObj),
            Some(compact) if compact.values.iter().any(|(number, _)| *number == sub) => {
                Place::of(Part::CompactValues(index)).field(Field::Item(sub.into()))
            }
            _ => Place::object(index).field(field(&object.main)),
        }
    }
}
