//! The typed object dictionary. The model is independent of files, spans and text formats; all later stages
//! use a [`Device`].
//!
//! Typed fields therefore contain only valid values, and no later stage needs to check one.
//!
//! Names follow CANopen: a device has *objects* at an *index*, objects have *entries* at a *sub-index*, an
//! entry has a *data type*, an *access* type and *values*. If a text of a description is not valid in its
//! field, the typed field is empty and the text is in the [`InvalidValues`]; keys without a field are in
//! [`Extra`].

mod access;
mod application_process;
mod calendar;
mod cob_id;
mod commissioning;
mod configuration;
mod data_type;
mod data_type_ref;
mod device;
mod device_class;
mod device_info;
mod device_profile;
mod entry;
mod expand;
mod field;
#[doc(hidden)] // for the crates that name fields in files
pub mod field_names;
mod file_info;
#[cfg(feature = "serde")]
mod flat;
pub mod hex;
mod identity;
mod implicit_pdo;
mod label;
mod meaning;
mod module;
mod node_list;
mod object;
mod object_type;
mod objects;
mod parameter;
mod part;
mod parts;
mod pdo;
mod pdo_kind;
mod place;
#[cfg(feature = "serde")]
mod plain;
#[cfg(feature = "schema")]
mod schema;
#[cfg(feature = "serde")]
mod serial;
mod services;
#[cfg(feature = "serde")]
mod spelled;
mod stack;
mod unparsed;
mod value;

/// The category of characteristics of an XDD or XDC, and in a [`Device`] the section of EDS or DCF lines, in which
/// objdict stores content that the format does not support. Earlier versions wrote it into an EDS or DCF.
pub const EMBEDDED_SECTION: &str = "ObjdictCarried";

/// The section with node settings of an objdictgen project: `Profile`, and `Type00A0` … for types with limits. A device
/// with this section keeps the names from objdictgen.
pub const OBJDICTGEN_SECTION: &str = "objdictgen";

/// The section with device information from EtherCAT slave information (ESI), apart from the objects. A device with
/// this section comes from an ESI and is not a CANopen node. Vendors may have a section `EtherCAT` in the EDS of a
/// CANopen device.
pub const ETHERCAT_SECTION: &str = "EtherCATInfo";

/// The start of a comment line of an EDS or DCF in which objdict stores content that the format does not
/// support, after the semicolon.
pub const EMBEDDED_COMMENT: &str = " objdict-embed: ";

pub use access::{Access, PdoMapping};
pub use application_process::{
    ApplicationProcess, Connection, Count, EnumValue, FunctionInstance, FunctionInstances, FunctionType,
    Subrange, TypeDefinition, TypeShape, VarDeclaration, VersionInfo,
};
pub use calendar::{ClockTime, Date};
pub use cob_id::{CobId, predefined, restricted};
pub use commissioning::{Commissioning, ExplicitDownload, Moment};
pub use configuration::Assignment;
pub use data_type::{DataType, TypeKind};
pub use data_type_ref::{DataTypeRef, MemberRef, SimpleType, VariableRef};
pub use device::{Device, DeviceKind, DummyUsage, ObjectLists};
pub use device_class::DeviceClass;
pub use device_info::{BaudRates, DeviceInfo};
pub use device_profile::{
    Characteristic, CharacteristicsList, CombinedState, Compliance, ConnectedModule, DefaultBaudRate,
    DeviceFunction, DeviceIdentity, DeviceManager, DeviceVersion, Dictionary, Led, LedColor, LedColors,
    LedOn, LedState, LedType, ModuleInterface, ModuleObjects, ModuleRange, ModuleRanges, ModuleType,
    NetworkIdentity, OwnAddressing, OwnInterface, Picture, ProfileHeader, ProfileHeaders,
};
pub use entry::{Configured, Entry, ObjFlags, SafetyMapping};
pub use field::Field;
pub use file_info::FileInfo;
pub use identity::Identity;
pub use label::{LANGUAGE, Label, Labels, TextRef};
#[doc(hidden)]
pub use meaning::Definitions;
pub use meaning::{BitField, BitStruct, Enumeration, Meaning, Meanings, NamedValue, Scaling};
pub use module::{DynamicChannels, Extension, ExtensionCount, Module, Modules, Segment, ToolCommand};
pub use node_list::{NodeList, Topology, TopologyNode};
pub use object::{Compact, Object, Subs};
pub use object_type::ObjectType;
pub use objects::Objects;
pub use parameter::{
    AllowedValues, AllowedValuesTemplate, Parameter, ParameterAccess, ParameterGroup, ParameterTemplate,
    Property, ScaledValue, Support, Unit, ValueRange,
};
pub use pdo::{MappedObject, MappingSlot, Pdo};
pub use pdo_kind::PdoKind;
pub use place::{Address, ModulePart, NoAddress, ObjectList, Part, Place};
#[cfg(feature = "serde")]
pub use plain::{Plain, WithPlainValues};
#[cfg(feature = "schema")]
pub use schema::HexBytes;
#[cfg(feature = "serde")]
pub use serial::{HexText, hex_number, hex_text, unique_keys};
#[cfg(feature = "serde")]
pub(crate) use serial::{index_keys, index_list, is_default, real_text, sub_list};
pub use services::{HeartbeatConsumer, SdoChannel, Services};
pub use stack::{SrdoAccess, StackOptions};
pub use unparsed::{Extra, ExtraSection, InvalidValue, InvalidValues, Reason};
pub use value::{Time, Value};
