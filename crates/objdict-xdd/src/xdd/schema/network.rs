//! The communication network profile: the object dictionary, the bit rates and the network management (CiA 311 annex A).

use super::device::{BUILD_DATE, DEVICE_FAMILY, PRODUCT_ID, SPECIFICATION_REVISION, VENDOR_ID, VERSION};
use super::values::{Kind, Target};
use super::{elements, need, slot};

const ENTITIES: Kind = Kind::Words(&["slave", "master", "server", "client", "interconnection", "peer"]);
const ACCESS: Kind = Kind::Word(&["ro", "wo", "rw", "const"]);
const PDO_MAPPING: Kind = Kind::Word(&["no", "default", "optional", "TPDO", "RPDO"]);
const INDEX: Kind = Kind::Hex(4, 4);
/// The standard says two digits, and most tools write four.
const DATA_TYPE: Kind = Kind::Hex(2, 4);
/// The standard says four digits, and defines 32 bits.
const FLAGS: Kind = Kind::Hex(2, 8);

elements! {
    APPLICATION_LAYERS local "ApplicationLayers" (
        conformanceClass?: Kind::Text, communicationEntityType?: ENTITIES,
    ), [
        maybe IDENTITY,
        key OBJECT_LIST,
        maybe DUMMY_USAGE,
        maybe DYNAMIC_CHANNELS,
        maybe MODULE_MANAGEMENT,
    ], newer ["moduleManagement"];
    IDENTITY local "identity", [
        maybe VENDOR_ID,
        maybe DEVICE_FAMILY,
        maybe PRODUCT_ID,
        any VERSION,
        maybe BUILD_DATE,
        maybe SPECIFICATION_REVISION,
    ];

    OBJECT_LIST global "CANopenObjectList" (
        mandatoryObjects?: Kind::INT, optionalObjects?: Kind::INT, manufacturerObjects?: Kind::INT,
    ), [some OBJECT];
    // a missing name is the business of cia306/missing-name
    OBJECT local "CANopenObject" (
        index*: INDEX,
        name?: Kind::Text,
        objectType!: Kind::BYTE,
        dataType?: DATA_TYPE,
        lowLimit?: Kind::Text,
        highLimit?: Kind::Text,
        accessType?: ACCESS,
        defaultValue?: Kind::Text,
        actualValue?: Kind::Text,
        denotation?: Kind::Text,
        PDOmapping?: PDO_MAPPING,
        objFlags?: FLAGS,
        uniqueIDRef?: Kind::Reference(Target::Application),
        subNumber?: Kind::BYTE,
        rangeSelector?: Kind::Text,
    ), [any SUB_OBJECT], newer ["rangeSelector"];
    SUB_OBJECT local "CANopenSubObject" (
        subIndex*: Kind::Hex(2, 2),
        name?: Kind::Text,
        objectType!: Kind::BYTE,
        dataType?: DATA_TYPE,
        lowLimit?: Kind::Text,
        highLimit?: Kind::Text,
        accessType?: ACCESS,
        defaultValue?: Kind::Text,
        actualValue?: Kind::Text,
        denotation?: Kind::Text,
        PDOmapping?: PDO_MAPPING,
        objFlags?: FLAGS,
        uniqueIDRef?: Kind::Reference(Target::Application),
        rangeSelector?: Kind::Text,
    ), newer ["rangeSelector"];

    DUMMY_USAGE local "dummyUsage", [some DUMMY];
    DUMMY local "dummy" (entry*: Kind::Dummy);
    DYNAMIC_CHANNELS local "dynamicChannels", [some DYNAMIC_CHANNEL];
    DYNAMIC_CHANNEL local "dynamicChannel" (
        dataType*: DATA_TYPE,
        accessType!: Kind::Word(&["readOnly", "writeOnly", "readWriteOutput"]),
        startIndex*: INDEX,
        endIndex*: INDEX,
        maxNumber!: Kind::INT,
        addressOffset!: Kind::Hex(2, 8),
        bitAlignment?: Kind::BYTE,
    );

    MODULE_MANAGEMENT local "moduleManagement", [one [INTERFACE_LIST | MODULE_INTERFACE]];
    INTERFACE_LIST local "interfaceList", [some INTERFACE];
    INTERFACE local "interface" (
        uniqueIDRef*: Kind::Reference(Target::ModuleInterface),
        addressing!: Kind::Word(&["auto", "manual"]),
    ), [one RANGE_LIST];
    RANGE_LIST local "rangeList", [some RANGE];
    RANGE local "range" (
        name!: Kind::Text,
        moduleType*: Kind::Name,
        baseIndex*: INDEX,
        maxIndex*: INDEX,
        maxSubIndex?: Kind::Hex(2, 2),
        sortMode!: Kind::Word(&["index", "subIndex"]),
        sortNumber!: Kind::Word(&["continuous", "address"]),
        // the standard misprints its default as `1`
        sortStep?: Kind::Hex(1, 4),
    );
    MODULE_INTERFACE local "moduleInterface" (
        childIDRef*: Kind::Name,
        addressMin!: Kind::POSITIVE,
        addressMax?: Kind::POSITIVE,
        addressing?: Kind::Word(&["inherit", "auto", "manual"]),
    );

    TRANSPORT_LAYERS local "TransportLayers", [one PHYSICAL_LAYER];
    PHYSICAL_LAYER local "PhysicalLayer", [one BAUD_RATE];
    // that there is no rate at all is the business of cia306/no-baud-rate
    BAUD_RATE local "baudRate" (defaultValue?: Kind::BaudRate), [any SUPPORTED_BAUD_RATE];
    SUPPORTED_BAUD_RATE local "supportedBaudRate" (value*: Kind::BaudRate);

    NETWORK_MANAGEMENT local "NetworkManagement", [
        one GENERAL_FEATURES, maybe MASTER_FEATURES, maybe DEVICE_COMMISSIONING,
    ];
    GENERAL_FEATURES local "CANopenGeneralFeatures" (
        groupMessaging?: Kind::Boolean,
        dynamicChannels?: Kind::BYTE,
        selfStartingDevice?: Kind::Boolean,
        SDORequestingDevice?: Kind::Boolean,
        granularity!: Kind::BYTE,
        nrOfRxPDO?: Kind::SHORT,
        nrOfTxPDO?: Kind::SHORT,
        bootUpSlave?: Kind::Boolean,
        layerSettingServiceSlave?: Kind::Boolean,
    );
    MASTER_FEATURES local "CANopenMasterFeatures" (
        bootUpMaster?: Kind::Boolean,
        flyingMaster?: Kind::Boolean,
        SDOManager?: Kind::Boolean,
        configurationManager?: Kind::Boolean,
        layerSettingServiceMaster?: Kind::Boolean,
    );
    DEVICE_COMMISSIONING local "deviceCommissioning" (
        nodeID*: Kind::BYTE,
        nodeName!: Kind::Text,
        actualBaudRate!: Kind::Text,
        networkNumber!: Kind::UNSIGNED_LONG,
        networkName!: Kind::Text,
        CANopenManager!: Kind::Boolean,
    );
}
