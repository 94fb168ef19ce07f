//! The communication network profile: the object dictionary, the bit rates and the network management (CiA
//! 311 annex A).

use super::device::{
    BUILD_DATE, DEVICE_FAMILY, INSTANCE_NAME, PRODUCT_FAMILY, PRODUCT_ID, PRODUCT_TEXT,
    SPECIFICATION_REVISION, VENDOR_ID, VENDOR_TEXT, VERSION,
};
use super::{
    AttributePlace, Child, Occurrence, ReferenceTarget, SchemaAttribute, SchemaElement, Shape, Slots,
    TextKind, at, attribute, elements, kept, lens, of, slot,
};
use crate::model::{
    Commissioning, DeviceInfo, Entry, Field, ModuleObjects, ModuleRange, ModuleRanges, OwnAddressing,
};
use crate::xdd::defaults;
use crate::xdd::shape::{IdentityContent, Nothing, PartsIn, Same, ValuesIn};
use crate::xml::n;

const ENTITIES: TextKind =
    TextKind::Words(&["slave", "master", "server", "client", "interconnection", "peer"]);
const ACCESS: TextKind = TextKind::Word(&["ro", "wo", "rw", "const"]);
const PDO_MAPPING: TextKind = TextKind::Word(&["no", "default", "optional", "TPDO", "RPDO"]);
const INDEX: TextKind = TextKind::Hex(4, 4);
/// The standard specifies two digits, and most tools write four.
const DATA_TYPE: TextKind = TextKind::Hex(2, 4);
/// The standard specifies four digits, and defines 32 bits.
const FLAGS: TextKind = TextKind::Hex(2, 8);
const FLAG: TextKind = TextKind::Boolean;

elements! {
    APPLICATION_LAYERS local ApplicationLayers of DeviceInfo (
        conformanceClass?: TextKind::Text => {Named conformance_class},
        communicationEntityType?: ENTITIES => {Named communication_entities},
    ), [
        maybe IDENTITY, key OBJECT_LIST, maybe DUMMY_USAGE, maybe DYNAMIC_CHANNELS, maybe MODULE_MANAGEMENT,
    ], newer [moduleManagement];
    IDENTITY local identity of IdentityContent, [
        maybe VENDOR_ID => [vendor_id],
        stray VENDOR_TEXT => [rest.vendor_text],
        maybe DEVICE_FAMILY => [rest.device_family],
        stray PRODUCT_FAMILY => [rest.product_family],
        maybe PRODUCT_ID => [product_id],
        stray PRODUCT_TEXT => [rest.product_text],
        any VERSION => [rest.versions],
        maybe BUILD_DATE => {rest.build_date},
        maybe SPECIFICATION_REVISION => [rest.specification_revision],
        stray INSTANCE_NAME => [rest.instance_name],
    ], marks [rest.read_only];

    OBJECT_LIST global CANopenObjectList of Nothing (
        mandatoryObjects?: TextKind::INT, optionalObjects?: TextKind::INT, manufacturerObjects?: TextKind::INT,
    ), [some OBJECT];
    DUMMY_USAGE local dummyUsage of Nothing, [some DUMMY];
    DUMMY local dummy of Nothing (entry*: TextKind::Dummy);
    DYNAMIC_CHANNELS local dynamicChannels of Nothing, [some DYNAMIC_CHANNEL];
    DYNAMIC_CHANNEL local dynamicChannel of Nothing (
        dataType*: DATA_TYPE, accessType!: TextKind::Word(&["readOnly", "writeOnly", "readWriteOutput"]),
        startIndex*: INDEX, endIndex*: INDEX, maxNumber!: TextKind::INT, addressOffset!: TextKind::Hex(2, 8), bitAlignment?: TextKind::BYTE,
    );

    MODULE_MANAGEMENT local moduleManagement of ModuleObjects, [
        one [INTERFACE_LIST | MODULE_INTERFACE] => (same [own]),
    ];
    INTERFACE_LIST local interfaceList of ModuleObjects, [some INTERFACE => [interfaces]];
    INTERFACE local interface of ModuleRanges (
        uniqueIDRef*: TextKind::Reference(ReferenceTarget::ModuleInterface) => [interface],
        addressing!: TextKind::Word(&["auto", "manual"]) => [addressing],
    ), [one RANGE_LIST => same];
    RANGE_LIST local rangeList of ModuleRanges, [some RANGE => [ranges]];
    RANGE local range of ModuleRange (
        name!: TextKind::Text => [name],
        moduleType*: TextKind::Name => [module_type],
        baseIndex*: INDEX => [base_index],
        maxIndex*: INDEX => [max_index],
        maxSubIndex?: TextKind::Hex(2, 2) => [max_sub_index],
        sortMode!: TextKind::Word(&["index", "subIndex"]) => [sort_mode],
        sortNumber!: TextKind::Word(&["continuous", "address"]) => [sort_number],
        // the standard misprints its default as `1`
        sortStep?: TextKind::Hex(1, 4) => [sort_step],
    );
    MODULE_INTERFACE local moduleInterface of OwnAddressing (
        childIDRef*: TextKind::Name => [child],
        addressMin!: TextKind::POSITIVE => [address_min],
        addressMax?: TextKind::POSITIVE => [address_max],
        addressing?: TextKind::Word(&["inherit", "auto", "manual"]) => [addressing],
    );

    TRANSPORT_LAYERS local TransportLayers of Nothing, [one PHYSICAL_LAYER];
    PHYSICAL_LAYER local PhysicalLayer of Nothing, [one BAUD_RATE];
    // a missing bit rate is reported by cia306/no-baud-rate
    BAUD_RATE local baudRate of Nothing (defaultValue?: TextKind::BaudRate), [any SUPPORTED_BAUD_RATE];
    SUPPORTED_BAUD_RATE local supportedBaudRate of Nothing (value*: TextKind::BaudRate);

    NETWORK_MANAGEMENT local NetworkManagement of Nothing, [
        one GENERAL_FEATURES, maybe MASTER_FEATURES, maybe DEVICE_COMMISSIONING,
    ];
    // ranges: CiA 306-1 §4.5
    GENERAL_FEATURES local CANopenGeneralFeatures of DeviceInfo (
        groupMessaging?: FLAG => {GroupMessaging group_messaging},
        dynamicChannels?: TextKind::BYTE => {DynamicChannelsSupported dynamic_channels_supported},
        selfStartingDevice?: FLAG => {Named self_starting},
        SDORequestingDevice?: FLAG => {Named sdo_requesting},
        granularity!: TextKind::BYTE => {Granularity granularity most 64 unstated defaults::NUMBER},
        nrOfRxPDO?: TextKind::SHORT => {NrOfRxPdo rpdo_count most 512},
        nrOfTxPDO?: TextKind::SHORT => {NrOfTxPdo tpdo_count most 512},
        bootUpSlave?: FLAG => {SimpleBootUpSlave simple_boot_up_slave},
        layerSettingServiceSlave?: FLAG => {LssSupported lss_supported},
    );
    MASTER_FEATURES local CANopenMasterFeatures of DeviceInfo (
        flyingMaster?: FLAG => {Named flying_master},
        SDOManager?: FLAG => {Named sdo_manager},
        configurationManager?: FLAG => {Named configuration_manager},
        layerSettingServiceMaster?: FLAG => {Named lss_master},
        bootUpMaster?: FLAG => {SimpleBootUpMaster simple_boot_up_master},
    );
    DEVICE_COMMISSIONING local deviceCommissioning of Commissioning (
        nodeID*: TextKind::BYTE => {NodeId node_id unstated defaults::NUMBER},
        nodeName!: TextKind::Text => {NodeName node_name unstated defaults::NAME},
        actualBaudRate!: TextKind::Rate => {Baudrate baud_rate unstated ""},
        networkNumber!: TextKind::UNSIGNED_LONG => {NetNumber net_number unstated defaults::NUMBER},
        networkName!: TextKind::Text => {NetworkName network_name unstated defaults::NAME},
        CANopenManager!: FLAG => {CanOpenManager manager unstated defaults::FLAG},
    );
}

/// Declares objects and sub-objects.
macro_rules! entries {
    ($($NAME:ident $name:ident ($address:ident $kind:expr) ($($own:tt)*) [$($content:tt)*])+) => {elements! {
        $($NAME local $name of Entry (
            $address*: $kind,
            name*: TextKind::Text => (field ParameterName),
            objectType!: TextKind::BYTE => {ObjectType object_type unstated defaults::OBJECT_TYPE},
            dataType?: DATA_TYPE => {DataType data_type},
            lowLimit?: TextKind::Text => (value Low),
            highLimit?: TextKind::Text => (value High),
            accessType?: ACCESS => {AccessType access},
            defaultValue?: TextKind::Text => (value Default),
            actualValue?: TextKind::Text => (value Actual),
            denotation?: TextKind::Text => (field Denotation),
            PDOmapping?: PDO_MAPPING => {PdoMapping pdo_mapping},
            objFlags?: FLAGS => {ObjFlags flags},
            uniqueIDRef?: TextKind::Reference(ReferenceTarget::Application),
            rangeSelector?: TextKind::Text,
            $($own)*
        ) $($content)*, newer [rangeSelector];)+
    }};
}

entries! {
    OBJECT CANopenObject (index INDEX) (subNumber?: TextKind::BYTE => (field SubNumber)) [, [any SUB_OBJECT]]
    SUB_OBJECT CANopenSubObject (subIndex TextKind::Hex(2, 2)) () []
}
