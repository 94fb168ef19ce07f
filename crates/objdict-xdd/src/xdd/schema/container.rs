//! The container, its profiles with their headers, and the bodies (ISO 15745-1, CiA 311 annex A).

use super::application::APPLICATION_PROCESS;
use super::device::{DEVICE_FUNCTION, DEVICE_IDENTITY, DEVICE_MANAGER};
use super::network::{APPLICATION_LAYERS, NETWORK_MANAGEMENT, TRANSPORT_LAYERS};
use super::values::Kind;
use super::{elements, need, slot};

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

elements! {
    ROOT global "ISO15745ProfileContainer", [some PROFILE];
    PROFILE global "ISO15745Profile", [one PROFILE_HEADER, key BODY];
    // abstract: which of the bodies below it is says `xsi:type`
    BODY local "ProfileBody";

    PROFILE_HEADER local "ProfileHeader", [
        one PROFILE_IDENTIFICATION,
        one PROFILE_REVISION,
        one PROFILE_NAME,
        one PROFILE_SOURCE,
        one PROFILE_CLASS_ID,
        maybe PROFILE_DATE,
        maybe ADDITIONAL_INFORMATION,
        one ISO_REFERENCE,
        any IAS_INTERFACE_TYPE,
    ];
    PROFILE_IDENTIFICATION local "ProfileIdentification" = Kind::Text;
    PROFILE_REVISION local "ProfileRevision" = Kind::Text;
    PROFILE_NAME local "ProfileName" = Kind::Text;
    PROFILE_SOURCE local "ProfileSource" = Kind::Text;
    PROFILE_CLASS_ID local "ProfileClassID" = Kind::Word(PROFILE_CLASSES);
    PROFILE_DATE local "ProfileDate" = Kind::Date;
    ADDITIONAL_INFORMATION local "AdditionalInformation" = Kind::Text;
    ISO_REFERENCE local "ISO15745Reference", [one ISO_PART, one ISO_EDITION, one PROFILE_TECHNOLOGY];
    ISO_PART local "ISO15745Part" = Kind::POSITIVE;
    ISO_EDITION local "ISO15745Edition" = Kind::POSITIVE;
    PROFILE_TECHNOLOGY local "ProfileTechnology" = Kind::Text;
    IAS_INTERFACE_TYPE local "IASInterfaceType" = Kind::Text;

    EXTERNAL_HANDLE local "ExternalProfileHandle", [
        one PROFILE_IDENTIFICATION, one PROFILE_REVISION, maybe PROFILE_LOCATION,
    ];
    PROFILE_LOCATION local "ProfileLocation" = Kind::Text;

    DEVICE local "ProfileBody" (
        formatName?: Kind::Word(&["CANopen"]),
        formatVersion?: Kind::Word(&["1.0"]),
        fileName!: Kind::Text,
        fileCreator!: Kind::Text,
        fileCreationDate!: Kind::Date,
        fileCreationTime?: Kind::Time,
        fileModifiedBy?: Kind::Text,
        fileModificationDate?: Kind::Date,
        fileModificationTime?: Kind::Time,
        fileVersion!: Kind::Text,
        supportedLanguages?: Kind::Languages,
        deviceClass?: Kind::Word(&["compact", "modular", "configurable"]),
    ), [
        maybe DEVICE_IDENTITY,
        maybe DEVICE_MANAGER,
        some DEVICE_FUNCTION,
        any APPLICATION_PROCESS,
        any EXTERNAL_HANDLE,
    ];
    NETWORK local "ProfileBody" (
        formatName?: Kind::Word(&["CANopen"]),
        formatVersion?: Kind::Word(&["1.0"]),
        fileName!: Kind::Text,
        fileCreator!: Kind::Text,
        fileCreationDate!: Kind::Date,
        fileCreationTime?: Kind::Time,
        fileModifiedBy?: Kind::Text,
        fileModificationDate?: Kind::Date,
        fileModificationTime?: Kind::Time,
        fileVersion!: Kind::Text,
        supportedLanguages?: Kind::Languages,
    ), [key APPLICATION_LAYERS, one TRANSPORT_LAYERS, maybe NETWORK_MANAGEMENT];
    EXTERNAL_NETWORK local "ProfileBody" (
        formatName?: Kind::Word(&["CANopen"]),
        formatVersion?: Kind::Word(&["1.0"]),
        fileName!: Kind::Text,
        fileCreator!: Kind::Text,
        fileCreationDate!: Kind::Date,
        fileCreationTime?: Kind::Time,
        fileModifiedBy?: Kind::Text,
        fileModificationDate?: Kind::Date,
        fileModificationTime?: Kind::Time,
        fileVersion!: Kind::Text,
        supportedLanguages?: Kind::Languages,
    ), [one EXTERNAL_HANDLE];
}

/// `ISO15745ProfileContainer`.
pub(crate) static CONTAINER: &super::Element = &ROOT;
/// `ProfileBody` of type `ProfileBody_Device_CANopen`.
pub(crate) static DEVICE_BODY: &super::Element = &DEVICE;
/// `ProfileBody` of type `ProfileBody_CommunicationNetwork_CANopen`.
pub(crate) static NETWORK_BODY: &super::Element = &NETWORK;
/// The same body where it only names a file that is not XML.
pub(crate) static EXTERNAL_NETWORK_BODY: &super::Element = &EXTERNAL_NETWORK;
