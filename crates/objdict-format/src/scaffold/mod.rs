//! New descriptions: devices with only the objects that their profile requires.
//!
//! The objects come from the data of the profiles ([`objdict_profile`]): objects that are mandatory, always or for the
//! selected features, are described with the data type, access and default of the document. If the document allows
//! several, the first one is used.

pub mod base;
pub mod demanded;
mod features;
mod infer;
pub mod objects;
mod pdos;

pub use base::{BaseError, MIDNIGHT, NO_VENDOR, PROFILES, base, newest_version, now};
pub use features::{EncoderClass, FEATURES, Feature, FeatureError, FeatureKind, FeatureValue, Features};
pub use infer::infer;

use demanded::Demanded;
use objdict_model::model::{
    BaudRates, ClockTime, DataType, Date, Device, DeviceInfo, Entry, FileInfo, MappedObject, Object, PdoKind,
    Value,
};
use objdict_profile as profile;
use objdict_profile::ObjectFacts;
use objdict_profile::default_mapping::PdoMap;

/// Properties of a new device.
#[derive(Clone, Debug)]
pub struct Wanted {
    /// The number of its profile; 301 for a device without one.
    pub profile: u16,
    /// Its features.
    pub features: Features,
    /// `FileName`.
    pub file_name: String,
    /// `VendorName`.
    pub vendor_name: String,
    /// The vendor-ID that CiA gave the vendor, 1018h sub-index 1.
    pub vendor_id: u32,
    /// `ProductName`, and the device name in 1008h.
    pub product_name: String,
    /// Product code, 1018h sub-index 2.
    pub product_code: u32,
    /// Revision number, 1018h sub-index 3.
    pub revision: u32,
    /// `CreatedBy` and `ModifiedBy`.
    pub author: String,
    /// The date of the description.
    pub date: Date,
    /// The corresponding time.
    pub time: ClockTime,
}

/// The description of a new device, for the newest version of its profile.
///
/// # Errors
/// See [`base()`].
pub fn scaffold(wanted: &Wanted) -> Result<Device, BaseError> {
    let version = newest_version(wanted.profile).ok_or(BaseError::Profile(wanted.profile))?;
    let mut device = base(wanted.profile, version, &wanted.features)?;
    device.file_info = Some(file_info(wanted));
    if let Some(info) = &mut device.device_info {
        info.vendor_name = Some(wanted.vendor_name.clone());
        info.vendor_number = Some(wanted.vendor_id);
        info.product_name = Some(wanted.product_name.clone());
        info.product_number = Some(wanted.product_code);
        info.revision_number = Some(wanted.revision);
    }
    identify(&mut device);
    Ok(device)
}

/// Copies vendor, product and revision from the device information to the objects that contain them (1008h, 1018h), if
/// these are described.
pub fn identify(device: &mut Device) {
    let Some(info) = &device.device_info else { return };
    let number = |number: Option<u32>| number.map(|number| Value::Unsigned(number.into()));
    let identity = [number(info.vendor_number), number(info.product_number), number(info.revision_number)];
    let name = info.product_name.as_deref().map(|name| Value::Text(name.into()));
    if let Some(object) = device.objects.get_mut(&0x1008) {
        object.main.default = name;
    }
    let Some(object) = device.objects.get_mut(&0x1018) else { return };
    for (sub, value) in (1..).zip(identity) {
        if let Some(entry) = object.subs.get_mut(sub) {
            entry.default = value;
        }
    }
}

/// Adds objects as CiA 301 and the document of a profile describe them, with their usual values, to a device that lacks them.
pub fn add_objects(device: &mut Device, profile: u16, indexes: &[u16]) {
    let documents = base::documents(profile);
    let maker =
        objects::ObjectMaker { plan: Demanded::new(profile, &Features::default()), documents: &documents };
    for &index in indexes {
        maker.add(device, index);
        device.lists.add(index);
    }
}

/// An object as the documents for a device specify it; `None` if no document defines it.
pub fn object(device: &Device, index: u16) -> Option<Object> {
    let number = device.profile().unwrap_or_default();
    let documents = base::documents(number);
    documents.iter().find_map(|document| document.object(index))?;
    let maker =
        objects::ObjectMaker { plan: Demanded::new(number, &Features::default()), documents: &documents };
    let mut made = Device::default();
    maker.add(&mut made, index);
    let mut object = made.objects.remove(&index)?;
    if object.object_type().has_subs() {
        let facts = documents.iter().filter_map(|document| document.object(index));
        let elements = facts.filter_map(|facts| elements(device, &facts)).next().unwrap_or(1);
        for sub in (1..=elements).filter(|sub| maker.knows(index, *sub)) {
            object.subs.insert(sub, maker.entry(index, sub));
        }
        maker.count(&mut object, index);
    } else if index == 0x67FF {
        object.main.default = device.value(0x1000, 0).map(std::borrow::Cow::into_owned);
    }
    Some(object)
}

/// The number of elements of the object that determines the number of elements of this one.
fn elements(device: &Device, facts: &ObjectFacts<'_>) -> Option<u8> {
    facts.as_many_as.iter().find_map(|&other| device.object(other)?.highest_sub())
}

/// A sub-index of an object as the documents for a device specify it; `None` if no document defines it.
pub fn entry(device: &Device, index: u16, sub: u8) -> Option<Entry> {
    let number = device.profile().unwrap_or_default();
    let documents = base::documents(number);
    documents.iter().find_map(|document| document.object(index)?.entry(sub))?;
    let maker =
        objects::ObjectMaker { plan: Demanded::new(number, &Features::default()), documents: &documents };
    Some(maker.entry(index, sub))
}

/// The lowest missing sub-index of an object that the documents do not reserve; `None` if there is none.
pub fn next_sub_index(device: &Device, index: u16) -> Option<u8> {
    let object = device.object(index).filter(|object| object.object_type().has_subs())?;
    let facts = profile::of_object(device, index).map(|(_, facts)| facts);
    let whole: Vec<_> = facts.filter(|facts| facts.states_type() && facts.entries().len() > 0).collect();
    let may_have = |sub: u8| {
        // the default SDO has no specific client
        if (index, sub) == (0x1200, 3) {
            return false;
        }
        let highest = object.highest_sub().map_or(sub, |highest| highest.max(sub));
        whole.iter().all(|facts| {
            facts.entry(sub).is_some_and(|entry| entry.name != "Reserved")
                && facts.entry(0).is_none_or(|count| count.accepts_value(highest.into()))
                && elements(device, facts).is_none_or(|elements| sub <= elements)
        })
    };
    let sub = (0..=254).find(|sub| !object.has(*sub) && may_have(*sub))?;
    object.compact.is_none().then_some(sub)
}

/// The communication and mapping parameters of a PDO that carries these objects.
pub fn pdo(
    device: &Device,
    kind: PdoKind,
    number: u16,
    mapped: Vec<MappedObject>,
) -> Option<[(u16, Object); 2]> {
    let profile = device.profile().unwrap_or_default();
    let documents = base::documents(profile);
    let maker =
        objects::ObjectMaker { plan: Demanded::new(profile, &Features::default()), documents: &documents };
    pdos::records(&maker, &PdoMap { kind, number, mapped })
}

/// The file information of a new description.
pub fn file_info(wanted: &Wanted) -> FileInfo {
    let profile = profile::of_number(wanted.profile);
    let profile = profile
        .map_or_else(|| "CiA 301".to_owned(), |profile| format!("{} ({})", profile.document, profile.title));
    FileInfo {
        file_name: Some(wanted.file_name.clone()),
        file_version: Some(1),
        file_revision: Some(0),
        eds_version: Some("4.0".to_owned()),
        description: Some(format!("{}, {profile}", wanted.product_name)),
        creation_time: Some(wanted.time),
        creation_date: Some(wanted.date),
        created_by: Some(wanted.author.clone()),
        modification_time: Some(wanted.time),
        modification_date: Some(wanted.date),
        modified_by: Some(wanted.author.clone()),
        ..FileInfo::default()
    }
}

/// The device information of a new description.
pub fn device_info(plan: &Demanded, device: &Device) -> DeviceInfo {
    let count = |kind: PdoKind| u16::try_from(device.pdo_count(kind)).unwrap_or(PdoKind::MAX);
    DeviceInfo {
        order_code: Some(String::new()),
        baud_rates: BaudRates {
            kbit_10: Some(false),
            kbit_20: Some(true),
            kbit_50: Some(true),
            kbit_125: Some(true),
            kbit_250: Some(true),
            kbit_500: Some(true),
            kbit_800: Some(false),
            kbit_1000: Some(true),
            ..BaudRates::default()
        },
        simple_boot_up_master: Some(false),
        simple_boot_up_slave: Some(true),
        // in bytes, if there are mapped objects
        granularity: Some(if device.pdos().next().is_some() { 8 } else { 0 }),
        dynamic_channels_supported: Some(0),
        group_messaging: Some(false),
        rpdo_count: Some(count(PdoKind::Rpdo)),
        tpdo_count: Some(count(PdoKind::Tpdo)),
        lss_supported: Some(plan.features.lss == Some(true)),
        ..DeviceInfo::default()
    }
}

/// A number as a value of this type.
fn number(number: u32, data_type: DataType) -> Option<Value> {
    Value::from_integer(number.into(), data_type)
}
