//! The device profile without its application process: identity, manager and function (CiA 311 annex A).

use super::{
    AttributePlace, Child, ElementChoice, Occurrence, ReferenceTarget, SchemaAttribute, SchemaElement, Shape,
    TextKind, at, attribute, choice, elements, kept, lens, of, slot,
};
use crate::model::{
    Characteristic, CharacteristicsList, CombinedState, Compliance, ConnectedModule, DeviceFunction,
    DeviceManager, DeviceVersion, Dictionary, Label, Labels, Led, LedState, ModuleInterface, ModuleType,
    OwnInterface, Picture, TextRef,
};
use crate::xdd::shape::{IdentityContent, Nothing, PartsIn, Same, ValuesIn};
use crate::xml::n;

// at least one of them is a name or a description
choice! { LABELS of Label: LABEL DESCRIPTION LABEL_REF DESCRIPTION_REF }

const FLAG: TextKind = TextKind::Boolean;

/// An element with only a text and a Boolean mark.
type MarkedText = Box<str>;

elements! {
    LABEL local label of Label as (Label::Name { lang: Box::default(), text: Box::default() }, Label::Name { .. }) (
        lang!: TextKind::Language => [in self Label::Name { lang, .. } => lang],
    ) = TextKind::Text => [in self Label::Name { text, .. } => text];
    DESCRIPTION local description of Label as (
        Label::Description { lang: Box::default(), uri: None, text: Box::default() }, Label::Description { .. }
    ) (
        lang!: TextKind::Language => [in self Label::Description { lang, .. } => lang],
        URI?: TextKind::Text => [in self Label::Description { uri, .. } => uri],
    ) = TextKind::Text => [in self Label::Description { text, .. } => text];
    LABEL_REF local labelRef of Label as (Label::NameRef(TextRef::default()), Label::NameRef(_)) (
        dictID*: TextKind::Text => [in self Label::NameRef(TextRef { dictionary, .. }) => dictionary],
        textID*: TextKind::Text => [in self Label::NameRef(TextRef { text_id, .. }) => text_id],
    ) = TextKind::Text => [in self Label::NameRef(TextRef { uri, .. }) => uri];
    DESCRIPTION_REF local descriptionRef of Label as (Label::DescriptionRef(TextRef::default()), Label::DescriptionRef(_)) (
        dictID*: TextKind::Text => [in self Label::DescriptionRef(TextRef { dictionary, .. }) => dictionary],
        textID*: TextKind::Text => [in self Label::DescriptionRef(TextRef { text_id, .. }) => text_id],
    ) = TextKind::Text => [in self Label::DescriptionRef(TextRef { uri, .. }) => uri];

    DEVICE_IDENTITY global DeviceIdentity of IdentityContent, [
        one VENDOR_NAME => [vendor_name],
        maybe VENDOR_ID => [vendor_id],
        maybe VENDOR_TEXT => [rest.vendor_text],
        maybe DEVICE_FAMILY => [rest.device_family],
        maybe PRODUCT_FAMILY => [rest.product_family],
        one PRODUCT_NAME => [product_name],
        maybe PRODUCT_ID => [product_id],
        maybe PRODUCT_TEXT => [rest.product_text],
        any ORDER_NUMBER => [order_numbers],
        any VERSION => [rest.versions],
        maybe BUILD_DATE => {rest.build_date},
        maybe SPECIFICATION_REVISION => [rest.specification_revision],
        maybe INSTANCE_NAME => [rest.instance_name],
    ], marks [rest.read_only];
    VENDOR_NAME global vendorName of MarkedText (readOnly?: FLAG => mark) = TextKind::Text => [self];
    VENDOR_ID global vendorID of MarkedText (readOnly?: FLAG => mark) = TextKind::Text => [self];
    VENDOR_TEXT global vendorText of Labels (readOnly?: FLAG => mark), [some (LABELS) => [0]];
    DEVICE_FAMILY global deviceFamily of Labels (readOnly?: FLAG => mark), [some (LABELS) => [0]];
    PRODUCT_FAMILY global productFamily of MarkedText (readOnly?: FLAG => mark) = TextKind::Text => [self];
    PRODUCT_NAME global productName of MarkedText (readOnly?: FLAG => mark) = TextKind::Text => [self];
    PRODUCT_ID global productID of MarkedText (readOnly?: FLAG => mark) = TextKind::Text => [self];
    PRODUCT_TEXT global productText of Labels (readOnly?: FLAG => mark), [some (LABELS) => [0]];
    ORDER_NUMBER global orderNumber of MarkedText (readOnly?: FLAG => mark) = TextKind::Text => [self];
    VERSION global version of DeviceVersion (
        versionType!: TextKind::Word(&["SW", "FW", "HW"]) => [kind], readOnly?: FLAG => mark,
    ) = TextKind::Text => [version];
    BUILD_DATE global buildDate of Nothing = TextKind::Date;
    SPECIFICATION_REVISION global specificationRevision of MarkedText (readOnly?: FLAG => mark) = TextKind::Text => [self];
    INSTANCE_NAME global instanceName of MarkedText (readOnly?: FLAG => mark) = TextKind::Text => [self];

    DEVICE_MANAGER global DeviceManager of DeviceManager, [
        maybe INDICATOR_LIST => same, maybe MODULE_MANAGEMENT => same,
    ], newer [moduleManagement];
    INDICATOR_LIST global indicatorList of DeviceManager, [maybe LED_LIST => same];
    LED_LIST global LEDList of DeviceManager, [some LED => [leds], any COMBINED_STATE => [combined_states]];
    LED global LED of Led (
        LEDcolors!: TextKind::Word(&["monocolor", "bicolor"]) => [colors],
        LEDtype?: TextKind::Word(&["IO", "device", "communication"]) => [kind],
    ), [some (LABELS) => [labels.0], some LED_STATE => [states]];
    LED_STATE global LEDstate of LedState (
        uniqueID*: TextKind::Id => [unique_id],
        state!: TextKind::Word(&["on", "off", "flashing"]) => [state],
        LEDcolor!: TextKind::Word(&["green", "amber", "red"]) => [color],
        flashingPeriod?: TextKind::INT => [flashing_period],
        impulsWidth?: TextKind::BYTE => [impulse_width],
        numberOfImpulses?: TextKind::BYTE => [impulses],
    ), [some (LABELS) => [labels.0]];
    COMBINED_STATE global combinedState of CombinedState, [some (LABELS) => [labels.0], two LED_STATE_REF => {states}];
    LED_STATE_REF local LEDstateRef of Nothing (stateIDRef*: TextKind::Reference(ReferenceTarget::LedState));

    MODULE_MANAGEMENT global moduleManagement of DeviceManager, [
        one [MODULE_INTERFACE_LIST | MODULE_INTERFACE] => (same [own_interface]),
    ];
    MODULE_INTERFACE_LIST global moduleInterfaceList of DeviceManager, [some INTERFACE => [module_interfaces]];
    INTERFACE global interface of ModuleInterface (
        uniqueID*: TextKind::Id => [unique_id],
        maxChilds!: TextKind::POSITIVE => [max_modules],
        unusedSlots!: FLAG => [unused_slots],
        multipleChilds!: FLAG => [multiple],
    ), [
        some (LABELS) => [labels.0], one FILE_LIST => same, one MODULE_TYPE_LIST => same, maybe CONNECTED_MODULE_LIST => same,
    ];
    FILE_LIST global fileList of ModuleInterface, [one FILE => {files}];
    MODULE_TYPE_LIST global moduleTypeList of ModuleInterface, [some MODULE_TYPE => [module_types]];
    MODULE_TYPE global moduleType of ModuleType (uniqueID+: TextKind::Id => [unique_id], r#type*: TextKind::Name => [kind]);
    CONNECTED_MODULE_LIST local connectedModuleList of ModuleInterface, [some CONNECTED_MODULE => [connected]];
    CONNECTED_MODULE local connectedModule of ConnectedModule (
        childIDRef*: TextKind::Name => [child], position+: TextKind::INT => [position], address+: TextKind::INT => [address],
    );
    MODULE_INTERFACE local moduleInterface of OwnInterface (
        childID*: TextKind::Name => [child_id], r#type*: TextKind::Name => [kind], maxCount?: TextKind::NATURAL => [max_count],
    );

    DEVICE_FUNCTION global DeviceFunction of DeviceFunction, [
        one CAPABILITIES => same, maybe PICTURES_LIST => same, maybe DICTIONARY_LIST => same,
    ];
    CAPABILITIES global capabilities of DeviceFunction, [
        some CHARACTERISTICS_LIST => [characteristics], maybe STANDARD_COMPLIANCE_LIST => same,
    ];
    CHARACTERISTICS_LIST global characteristicsList of CharacteristicsList, [
        maybe CATEGORY => [category], some CHARACTERISTIC => [characteristics],
    ];
    CATEGORY local category of Labels, [some (LABELS) => [0]];
    CHARACTERISTIC global characteristic of Characteristic, [
        one CHARACTERISTIC_NAME => [name], some CHARACTERISTIC_CONTENT => [contents],
    ];
    CHARACTERISTIC_NAME global characteristicName of Labels, [some (LABELS) => [0]];
    CHARACTERISTIC_CONTENT global characteristicContent of Labels, [some (LABELS) => [0]];
    STANDARD_COMPLIANCE_LIST global standardComplianceList of DeviceFunction, [some COMPLIANT_WITH => [compliance]];
    COMPLIANT_WITH global compliantWith of Compliance (
        name!: TextKind::Text => [name], range?: TextKind::Word(&["international", "internal"]) => [range],
    ), [some (LABELS) => [labels.0]];
    PICTURES_LIST global picturesList of DeviceFunction, [some PICTURE => [pictures]];
    PICTURE global picture of Picture (URI*: TextKind::Text => [uri], number?: TextKind::INT => [number]), [some (LABELS) => [labels.0]];
    DICTIONARY_LIST global dictionaryList of DeviceFunction, [some DICTIONARY => [dictionaries]];
    DICTIONARY global dictionary of Dictionary (lang!: TextKind::Language => [lang], dictID*: TextKind::Text => [id]), [
        one FILE => {uri},
    ];
    FILE global file of Nothing (URI*: TextKind::Text);
}
