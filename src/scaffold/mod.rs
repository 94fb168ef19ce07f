//! New descriptions: a device that has what its profile demands of it, and nothing that it does not.
//!
//! The objects come from the data of the profiles ([`crate::profile`]): what is mandatory, always or for what the device
//! can do, is described with the data type, access and default of the document. Where the document leaves a choice, the
//! first one is taken.

mod objects;
mod pdos;

use crate::model::{
    BaudRates, ClockTime, DataType, Date, Device, DeviceInfo, DummyUsage, FileInfo, ObjectList, ObjectLists,
    PdoKind, Value,
};
use crate::profile::{self, Profile};

/// Properties of a new device.
#[derive(Clone, Debug)]
pub struct Wanted {
    /// What it does.
    pub functions: Functions,
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
    /// When the description is made.
    pub date: Date,
    /// What time it is then.
    pub time: ClockTime,
}

/// What a device does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Functions {
    /// Nothing that a profile knows: the communication objects that every device has (CiA 301).
    Bare,
    /// Inputs and outputs (CiA 401).
    InputsOutputs(ChannelCounts),
    /// An encoder (CiA 406).
    Encoder(Encoder),
}

/// Channels of an I/O module (CiA 401).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ChannelCounts {
    /// Digital inputs, each a bit; up to [`MAX_DIGITAL`].
    pub digital_inputs: u16,
    /// Digital outputs, each a bit; up to [`MAX_DIGITAL`].
    pub digital_outputs: u16,
    /// Analogue inputs of 16 bits; up to [`MAX_ANALOG`].
    pub analog_inputs: u8,
    /// Analogue outputs of 16 bits; up to [`MAX_ANALOG`].
    pub analog_outputs: u8,
}

/// Bits that an array of bytes can hold.
pub const MAX_DIGITAL: u16 = 254 * 8;
/// Words that an array can hold.
pub const MAX_ANALOG: u8 = 254;

/// What an encoder of class C2 has beside one of class C1: scaling, preset, cyclic timer, alarms, warnings, versions,
/// operating time, offset (CiA 406).
const OF_CLASS_2: [u16; 14] = [
    0x6001, 0x6002, 0x6003, 0x6005, 0x6200, 0x6503, 0x6504, 0x6505, 0x6506, 0x6507, 0x6508, 0x6509, 0x650A,
    0x650B,
];

/// An encoder (CiA 406).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Encoder {
    /// What it can do.
    pub class: EncoderClass,
    /// The encoder type in the upper word of 1000h, 1 to 10.
    pub encoder_type: u8,
}

/// What an encoder can do (CiA 406).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EncoderClass {
    /// Position and what describes it.
    C1,
    /// Also scaling, preset, alarms and diagnosis.
    C2,
}

impl Functions {
    /// The device profile number.
    pub fn profile(self) -> Option<u16> {
        match self {
            Self::Bare => None,
            Self::InputsOutputs(_) => Some(401),
            Self::Encoder(_) => Some(406),
        }
    }

    /// The value of 1000h.
    fn device_type(self) -> u32 {
        match self {
            Self::Bare => 0,
            Self::InputsOutputs(channels) => {
                let ChannelCounts { digital_inputs, digital_outputs, analog_inputs, analog_outputs } =
                    channels;
                let has = [digital_inputs, digital_outputs, analog_inputs.into(), analog_outputs.into()];
                let bits = has.iter().enumerate().filter(|(_, count)| **count > 0);
                bits.fold(0x191, |device_type, (bit, _)| device_type | 0x1_0000 << bit)
            }
            Self::Encoder(encoder) => 0x196 | u32::from(encoder.encoder_type) << 16,
        }
    }

    /// The requested objects; the documents require others that follow from them.
    fn objects(self) -> Vec<u16> {
        match self {
            Self::Bare => Vec::new(),
            Self::InputsOutputs(_) => {
                [0x6000, 0x6200, 0x6401, 0x6411].into_iter().filter(|&index| self.count(index) > 0).collect()
            }
            Self::Encoder(Encoder { class: EncoderClass::C1, .. }) => Vec::new(),
            Self::Encoder(Encoder { class: EncoderClass::C2, .. }) => OF_CLASS_2.to_vec(),
        }
    }

    /// The sub-indexes that an array of channels has behind sub-index 0.
    fn count(self, index: u16) -> u8 {
        let bytes = |bits: u16| u8::try_from(bits.div_ceil(8)).unwrap_or(254);
        match self {
            Self::InputsOutputs(channels) => match index {
                0x6000..=0x61FF => bytes(channels.digital_inputs),
                0x6200..=0x63FF => bytes(channels.digital_outputs),
                0x6400..=0x640F | 0x6420..=0x643F => channels.analog_inputs,
                0x6410..=0x641F | 0x6440..=0x645F => channels.analog_outputs,
                _ => 1,
            },
            _ => 1,
        }
    }
}

/// The description of a new device.
pub fn scaffold(wanted: &Wanted) -> Device {
    let mut device = Device {
        file_info: Some(file_info(wanted)),
        dummy_usage: Some(DummyUsage {
            types: (1..=7).map(|code| (DataType(code), code >= 5)).collect(),
            ..DummyUsage::default()
        }),
        comments: Some(Vec::new()),
        ..Device::default()
    };
    let general = profile::named("301");
    let own = wanted.functions.profile().and_then(profile::of_number);
    let documents: Vec<&Profile> = general.into_iter().chain(own).collect();
    let maker = objects::Maker { wanted: Some(wanted), functions: wanted.functions, documents: &documents };
    for index in [0x1000, 0x1001, 0x1008, 0x1014, 0x1017, 0x1018] {
        maker.add(&mut device, index);
    }
    pdos::add(&mut device, &maker);
    for index in wanted.functions.objects() {
        if own.is_some_and(|own| is_for(own, &device, index)) {
            maker.add(&mut device, index);
        }
    }
    while let Some(index) = missing(&device, &documents) {
        maker.add(&mut device, index);
    }
    // the transmission types of the PDOs can be changed to synchronous ones
    if device.pdos().next().is_some() {
        maker.add(&mut device, 0x1005);
    }
    device.lists = ObjectLists::naming(device.objects.keys().copied());
    device.device_info = Some(device_info(wanted, &device));
    device
}

/// Adds communication objects as CiA 301 describes them, with their usual values, to a device that lacks them.
pub fn add_objects(device: &mut Device, indexes: &[u16]) {
    let documents: Vec<&Profile> = profile::named("301").into_iter().collect();
    let maker = objects::Maker { wanted: None, functions: Functions::Bare, documents: &documents };
    for &index in indexes {
        maker.add(device, index);
        if let Some(list) = ObjectList::of(index) {
            let members = device.lists.get_mut(list).get_or_insert_default();
            let at = members.partition_point(|&member| member < index);
            members.insert(at, index);
        }
    }
}

/// Whether a document has an object, and not only for other devices.
fn is_for(document: &Profile, device: &Device, index: u16) -> bool {
    document.object(index).is_some_and(|facts| facts.is_for(device, 0))
}

/// The first object that a document demands and the device does not have.
fn missing(device: &Device, documents: &[&Profile]) -> Option<u16> {
    let objects = documents.iter().flat_map(|document| document.objects());
    let mut demanded = objects.filter(|facts| facts.is_demanded(device, 0)).map(|facts| facts.first);
    demanded.find(|index| !device.objects.contains_key(index))
}

fn file_info(wanted: &Wanted) -> FileInfo {
    let profile = wanted.functions.profile().and_then(profile::of_number);
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

fn device_info(wanted: &Wanted, device: &Device) -> DeviceInfo {
    let count = |kind: PdoKind| u16::try_from(device.pdo_count(kind)).unwrap_or(PdoKind::MAX);
    DeviceInfo {
        vendor_name: Some(wanted.vendor_name.clone()),
        vendor_number: Some(wanted.vendor_id),
        product_name: Some(wanted.product_name.clone()),
        product_number: Some(wanted.product_code),
        revision_number: Some(wanted.revision),
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
        // in steps of a byte, when there is something to map
        granularity: Some(if device.pdos().next().is_some() { 8 } else { 0 }),
        dynamic_channels_supported: Some(0),
        group_messaging: Some(false),
        rpdo_count: Some(count(PdoKind::Rpdo)),
        tpdo_count: Some(count(PdoKind::Tpdo)),
        lss_supported: Some(false),
        ..DeviceInfo::default()
    }
}

/// A number as a value of its type.
fn number(number: u32, data_type: DataType) -> Option<Value> {
    Value::from_integer(number.into(), data_type)
}
