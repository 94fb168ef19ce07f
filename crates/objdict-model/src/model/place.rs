//! Addresses in the model, and the notation of object and entry addresses for users.

use std::fmt;
use std::str::FromStr;

use super::Field;

/// A place in a device description, independent of its format: a part and usually a field of it.
///
/// ```
/// use objdict_model::model::{Field, Place};
/// assert_eq!(Place::entry(0x1018, 1).field(Field::DefaultValue).to_string(), "0x1018sub1 / DefaultValue");
/// ```
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Place {
    /// The part.
    pub part: Part,
    /// The field; `None` for the part as a whole.
    pub field: Option<Field>,
}

/// A part of a device description.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Part {
    /// The description as a whole.
    Device,
    /// Information about the file.
    FileInfo,
    /// Information about the device.
    DeviceInfo,
    /// The data types that can be dummy entries in a PDO.
    DummyUsage,
    /// Comments on the device.
    Comments,
    /// The node of a DCF (`DeviceComissioning`).
    Commissioning,
    /// A list of objects.
    List(ObjectList),
    /// An object.
    Object(u16),
    /// A sub-index of an object.
    Entry(u16, u8),
    /// The names of the sub-indexes of a compact object.
    CompactNames(u16),
    /// The values of the sub-indexes of a compact object.
    CompactValues(u16),
    /// The denotations of the sub-indexes of a compact object.
    CompactDenotations(u16),
    /// The links of an object.
    Links(u16),
    /// The supported modules.
    SupportedModules,
    /// The connected modules.
    ConnectedModules,
    /// A part of the module with this number.
    Module(u16, ModulePart),
    /// The dynamic channels (CiA 302-4).
    DynamicChannels,
    /// The list of tools.
    Tools,
    /// The tool with this number.
    Tool(u16),
    /// The headers of the profiles (CiA 311).
    Headers,
    /// The identity of the device (CiA 311).
    Identity,
    /// The identity in the communication network profile (CiA 311).
    NetworkIdentity,
    /// Indicators and module interfaces (CiA 311).
    Manager,
    /// Descriptions of the device's functions (CiA 311).
    Functions,
    /// The application process, without the parameters of entries (CiA 311).
    Application,
    /// The address ranges for the objects of modules (CiA 311).
    ModuleObjects,
    /// An unknown section.
    Section(Box<str>),
}

impl Part {
    /// An object or, with a sub-index, an entry of it.
    pub const fn at(index: u16, sub: Option<u8>) -> Self {
        match sub {
            Some(sub) => Self::Entry(index, sub),
            None => Self::Object(index),
        }
    }

    /// The index of the object that this part belongs to.
    pub fn object(&self) -> Option<u16> {
        match *self {
            Self::Object(index)
            | Self::Entry(index, _)
            | Self::CompactNames(index)
            | Self::CompactValues(index)
            | Self::CompactDenotations(index)
            | Self::Links(index) => Some(index),
            _ => None,
        }
    }
}

named! {
    /// One of the three object lists of a device (CiA 306-1 §4.6.3.1).
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
    #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
    #[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
    pub enum ObjectList {
        /// `MandatoryObjects`.
        Mandatory = "MandatoryObjects",
        /// `OptionalObjects`.
        Optional = "OptionalObjects",
        /// `ManufacturerObjects`.
        Manufacturer = "ManufacturerObjects",
    }
}

/// A part of the description of a module (CiA 306-1 §6.3).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ModulePart {
    /// `MxModuleInfo`.
    Info,
    /// `MxComments`.
    Comments,
    /// `MxFixedObjects`.
    FixedObjects,
    /// `MxFixedxxxx`.
    Fixed(u16),
    /// `MxFixedxxxxsubx`.
    FixedEntry(u16, u8),
    /// `MxSubExtends`.
    SubExtends,
    /// `MxSubExtxxxx`.
    SubExt(u16),
}

impl ObjectList {
    /// The list that an object belongs to; `None` for the definition of a data type, below 1000h.
    pub const fn of(index: u16) -> Option<Self> {
        match index {
            0..=0x0FFF => None,
            0x1000 | 0x1001 | 0x1018 => Some(Self::Mandatory),
            0x2000..=0x5FFF => Some(Self::Manufacturer),
            _ => Some(Self::Optional),
        }
    }
}

impl Place {
    /// The place of a part as a whole.
    pub const fn of(part: Part) -> Self {
        Self { part, field: None }
    }

    /// The description as a whole.
    pub const fn device() -> Self {
        Self::of(Part::Device)
    }

    /// An object.
    pub const fn object(index: u16) -> Self {
        Self::of(Part::Object(index))
    }

    /// A sub-index of an object.
    pub const fn entry(index: u16, sub: u8) -> Self {
        Self::of(Part::Entry(index, sub))
    }

    /// An object or, with a sub-index, an entry of it.
    pub const fn at(index: u16, sub: Option<u8>) -> Self {
        Self::of(Part::at(index, sub))
    }

    /// A field of this part.
    #[must_use]
    pub fn field(self, field: Field) -> Self {
        Self { field: Some(field), ..self }
    }
}

impl From<Part> for Place {
    fn from(part: Part) -> Self {
        Self::of(part)
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.part)?;
        match &self.field {
            Some(field) => write!(f, " / {field}"),
            None => Ok(()),
        }
    }
}

crate::messages! { Part: {
    Self::Device => "device";
    Self::FileInfo => "FileInfo";
    Self::DeviceInfo => "DeviceInfo";
    Self::DummyUsage => "DummyUsage";
    Self::Comments => "Comments";
    Self::Commissioning => "DeviceComissioning";
    Self::List(list) => "{list}";
    Self::Object(index) => "0x{index:04X}";
    Self::Entry(index, sub) => "0x{index:04X}sub{sub:X}";
    Self::CompactNames(index) => "0x{index:04X}Name";
    Self::CompactValues(index) => "0x{index:04X}Value";
    Self::CompactDenotations(index) => "0x{index:04X}Denotation";
    Self::Links(index) => "0x{index:04X}ObjectLinks";
    Self::SupportedModules => "SupportedModules";
    Self::ConnectedModules => "ConnectedModules";
    Self::Module(number, part) => "M{number}{part}";
    Self::DynamicChannels => "DynamicChannels";
    Self::Tools => "Tools";
    Self::Tool(number) => "Tool{number}";
    Self::Headers => "ProfileHeader";
    Self::Identity => "DeviceIdentity";
    Self::NetworkIdentity => "ApplicationLayers/identity";
    Self::Manager => "DeviceManager";
    Self::Functions => "DeviceFunction";
    Self::Application => "ApplicationProcess";
    Self::ModuleObjects => "ApplicationLayers/moduleManagement";
    Self::Section(name) => "{name}";
} }

crate::messages! { ModulePart: {
    Self::Info => "ModuleInfo";
    Self::Comments => "Comments";
    Self::FixedObjects => "FixedObjects";
    Self::Fixed(index) => "Fixed{index:04X}";
    Self::FixedEntry(index, sub) => "Fixed{index:04X}sub{sub:X}";
    Self::SubExtends => "SubExtends";
    Self::SubExt(index) => "SubExt{index:04X}";
} }

/// An object or entry, in the notations that users write.
///
/// ```
/// use objdict_model::model::Address;
///
/// let address: Address = "1018sub1".parse()?;
/// assert_eq!(address, Address { index: 0x1018, sub: Some(1) });
/// # Ok::<(), objdict_model::model::NoAddress>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Address {
    /// The index.
    pub index: u16,
    /// The sub-index; `None` for the object as a whole.
    pub sub: Option<u8>,
}

impl From<u16> for Address {
    fn from(index: u16) -> Self {
        Self { index, sub: None }
    }
}

impl From<(u16, u8)> for Address {
    fn from((index, sub): (u16, u8)) -> Self {
        Self { index, sub: Some(sub) }
    }
}

/// A text that is not an address.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NoAddress;

crate::error_messages! { NoAddress: {
    Self => "write the index and sub-index in hex: `1018`, `0x1018`, `1018:1`, `1018sub1`";
} }

/// `1018`, `0x1018` or `1018h`, optionally followed by `:1`, `sub1`, `.1` or `/1`. All numbers are
/// hexadecimal, as in the section names of an EDS.
impl FromStr for Address {
    type Err = NoAddress;

    fn from_str(text: &str) -> Result<Self, NoAddress> {
        let text = text.trim().to_ascii_lowercase();
        let (index, sub) = match text.split_once("sub").or_else(|| text.split_once([':', '.', '/'])) {
            Some((index, sub)) => (index, Some(sub)),
            None => (text.as_str(), None),
        };
        let index = hex(index).ok_or(NoAddress)?;
        let sub =
            sub.map(|sub| hex(sub).and_then(|sub| u8::try_from(sub).ok()).ok_or(NoAddress)).transpose()?;
        Ok(Self { index, sub })
    }
}

fn hex(text: &str) -> Option<u16> {
    let text = text.trim();
    let digits = text.strip_prefix("0x").or_else(|| text.strip_suffix('h')).unwrap_or(text);
    let is_hex = (1..=4).contains(&digits.len()) && digits.bytes().all(|byte| byte.is_ascii_hexdigit());
    if is_hex { u16::from_str_radix(digits, 16).ok() } else { None }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_spelling_of_the_field() {
        let entry = Ok(Address { index: 0x1018, sub: Some(0xA) });
        for text in ["1018:a", "0x1018:0x0A", "1018subA", "1018h:0Ah", "1018.A", "1018/0a", "0x1018 sub a"] {
            assert_eq!(text.parse::<Address>(), entry, "{text}");
        }
        for text in ["1018", "0x1018", "1018h", "0X1018"] {
            assert_eq!(text.parse(), Ok(Address { index: 0x1018, sub: None }), "{text}");
        }
    }

    #[test]
    fn what_is_none() {
        for text in ["", "10181", "name", "1018:", "1018:100", "0x", ":1", "+101", "1018:-1"] {
            assert_eq!(text.parse::<Address>(), Err(NoAddress), "{text}");
        }
    }
}
