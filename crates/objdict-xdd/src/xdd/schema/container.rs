//! The container, its profiles with their headers, and the bodies (ISO 15745-1, CiA 311 annex A).

use super::application::APPLICATION_PROCESS;
use super::device::{DEVICE_FUNCTION, DEVICE_IDENTITY, DEVICE_MANAGER};
use super::network::{APPLICATION_LAYERS, NETWORK_MANAGEMENT, TRANSPORT_LAYERS};
use super::{
    AttributePlace, Child, Occurrence, SchemaAttribute, SchemaElement, Shape, TextKind, at, attribute,
    elements, kept, lens, of, slot,
};
use crate::model::{Field, FileInfo, ProfileHeader};
use crate::xdd::defaults;
use crate::xdd::shape::{FixedContent, Nothing, Same, ValuesIn};
use crate::xml::n;

const PROFILE_CLASSES: &[&str] = &[
    "AIP",
    "Process",
    "InformationExchange",
    "Resource",
    "Device",
    "CommunicationNetwork",
    "Equipment",
    "Human",
    "Material",
];
const CANOPEN: TextKind = TextKind::Word(&["CANopen"]);
const FORMAT: TextKind = TextKind::Word(&["1.0"]);
const DEVICE_CLASSES: TextKind = TextKind::Word(&["compact", "modular", "configurable"]);

elements! {
    CONTAINER global ISO15745ProfileContainer of Nothing, [some PROFILE];
    PROFILE global ISO15745Profile of Nothing, [one DEVICE_HEADER, key BODY];
    // abstract: `xsi:type` selects one of the bodies below
    BODY local ProfileBody of Nothing;

    PROFILE_IDENTIFICATION local ProfileIdentification of Nothing = TextKind::Text;
    PROFILE_REVISION local ProfileRevision of Nothing = TextKind::Text;
    PROFILE_NAME local ProfileName of Nothing = TextKind::Text;
    PROFILE_SOURCE local ProfileSource of Nothing = TextKind::Text;
    PROFILE_CLASS_ID local ProfileClassID of Nothing = TextKind::Word(PROFILE_CLASSES);
    PROFILE_DATE local ProfileDate of Nothing = TextKind::Date;
    ADDITIONAL_INFORMATION local AdditionalInformation of Nothing = TextKind::Text;
    ISO_REFERENCE local ISO15745Reference of ProfileHeader, [
        one ISO_PART => "1", one ISO_EDITION => "1", one PROFILE_TECHNOLOGY => "CANopen",
    ];
    ISO_PART local ISO15745Part of Nothing = TextKind::POSITIVE;
    ISO_EDITION local ISO15745Edition of Nothing = TextKind::POSITIVE;
    PROFILE_TECHNOLOGY local ProfileTechnology of Nothing = TextKind::Text;
    IAS_INTERFACE_TYPE local IASInterfaceType of Nothing = TextKind::Text;

    EXTERNAL_HANDLE local ExternalProfileHandle of Nothing, [
        one PROFILE_IDENTIFICATION, one PROFILE_REVISION, maybe PROFILE_LOCATION,
    ];
    PROFILE_LOCATION local ProfileLocation of Nothing = TextKind::Text;
}

/// Declares the header of each profile; they differ only in their class.
macro_rules! headers {
    ($($NAME:ident $class:literal)+) => {elements! {
        $($NAME local ProfileHeader of ProfileHeader, [
            one PROFILE_IDENTIFICATION => {identification},
            one PROFILE_REVISION => {revision},
            one PROFILE_NAME => {name},
            one PROFILE_SOURCE => {source},
            one PROFILE_CLASS_ID => $class,
            maybe PROFILE_DATE => {date},
            maybe ADDITIONAL_INFORMATION => {additional_information},
            one ISO_REFERENCE => same,
            any IAS_INTERFACE_TYPE => {interface_types},
        ];)+
    }};
}

headers! { DEVICE_HEADER "Device" NETWORK_HEADER "CommunicationNetwork" }

/// Declares the bodies, which have the same file attributes.
macro_rules! bodies {
    ($($NAME:ident ($($attribute:tt)*) [$($content:tt)+])+) => {elements! {
        $($NAME local ProfileBody of FileInfo (
            formatName?: CANOPEN,
            formatVersion?: FORMAT,
            fileName!: TextKind::Text => {FileName file_name unstated defaults::FILE_NAME},
            fileCreator!: TextKind::Text => {CreatedBy created_by unstated defaults::NOT_STATED},
            fileCreationDate!: TextKind::Date => {CreationDate creation_date unstated defaults::DATE},
            fileCreationTime?: TextKind::Time => {CreationTime creation_time},
            fileModifiedBy?: TextKind::Text => {ModifiedBy modified_by},
            fileModificationDate?: TextKind::Date => {ModificationDate modification_date},
            fileModificationTime?: TextKind::Time => {ModificationTime modification_time},
            fileVersion!: TextKind::Text => {FileVersion self unstated ""},
            supportedLanguages?: TextKind::Languages => {Named languages},
            $($attribute)*
        ), [$($content)+];)+
    }};
}

bodies! {
    DEVICE_BODY (deviceClass?: DEVICE_CLASSES => {Named device_class}) [
        maybe DEVICE_IDENTITY, maybe DEVICE_MANAGER, some DEVICE_FUNCTION, any APPLICATION_PROCESS, any EXTERNAL_HANDLE
    ]
    NETWORK_BODY () [key APPLICATION_LAYERS, one TRANSPORT_LAYERS, maybe NETWORK_MANAGEMENT]
    // for a profile that only refers to a file that is not XML
    EXTERNAL_NETWORK_BODY () [one EXTERNAL_HANDLE]
}
