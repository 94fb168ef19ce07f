//! The names of sections in the spelling of the standard.

use crate::model::{ModulePart, ObjectList, Part};

/// The names without a number.
pub(super) static FIXED: [(&str, Part); 12] = [
    ("FileInfo", Part::FileInfo),
    ("DeviceInfo", Part::DeviceInfo),
    ("DummyUsage", Part::DummyUsage),
    ("Comments", Part::Comments),
    ("DeviceComissioning", Part::Commissioning),
    ("MandatoryObjects", Part::List(ObjectList::Mandatory)),
    ("OptionalObjects", Part::List(ObjectList::Optional)),
    ("ManufacturerObjects", Part::List(ObjectList::Manufacturer)),
    ("SupportedModules", Part::SupportedModules),
    ("ConnectedModules", Part::ConnectedModules),
    ("DynamicChannels", Part::DynamicChannels),
    ("Tools", Part::Tools),
];

/// The sections of a module, after `M` and its number.
pub(super) static OF_MODULE: [(&str, ModulePart); 4] = [
    ("ModuleInfo", ModulePart::Info),
    ("Comments", ModulePart::Comments),
    ("FixedObjects", ModulePart::FixedObjects),
    ("SubExtends", ModulePart::SubExtends),
];

/// The section of the object with an index.
pub(super) type OfIndex = fn(u16) -> Part;

/// The sections of an object, after its index.
pub(super) static OF_OBJECT: [(&str, OfIndex); 4] = [
    ("Name", Part::CompactNames),
    ("Value", Part::CompactValues),
    ("Denotation", Part::CompactDenotations),
    ("ObjectLinks", Part::Links),
];
