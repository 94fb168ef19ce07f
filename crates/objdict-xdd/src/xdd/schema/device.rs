//! The device profile but for its application process: identity, manager and function (CiA 311 annex A).

use super::values::{Kind, Target};
use super::{Element, elements, need, slot};

/// One of them at least is a name or a description.
pub(super) static LABELS: &[&Element] = &[&LABEL, &DESCRIPTION, &LABEL_REF, &DESCRIPTION_REF];

elements! {
    LABEL local "label" (lang!: Kind::Language) = Kind::Text;
    DESCRIPTION local "description" (lang!: Kind::Language, URI?: Kind::Text) = Kind::Text;
    LABEL_REF local "labelRef" (dictID*: Kind::Text, textID*: Kind::Text) = Kind::Text;
    DESCRIPTION_REF local "descriptionRef" (dictID*: Kind::Text, textID*: Kind::Text) = Kind::Text;

    DEVICE_IDENTITY global "DeviceIdentity", [
        one VENDOR_NAME,
        maybe VENDOR_ID,
        maybe VENDOR_TEXT,
        maybe DEVICE_FAMILY,
        maybe PRODUCT_FAMILY,
        one PRODUCT_NAME,
        maybe PRODUCT_ID,
        maybe PRODUCT_TEXT,
        any ORDER_NUMBER,
        any VERSION,
        maybe BUILD_DATE,
        maybe SPECIFICATION_REVISION,
        maybe INSTANCE_NAME,
    ];
    VENDOR_NAME global "vendorName" (readOnly?: Kind::Boolean) = Kind::Text;
    VENDOR_ID global "vendorID" (readOnly?: Kind::Boolean) = Kind::Text;
    VENDOR_TEXT global "vendorText" (readOnly?: Kind::Boolean), [some (LABELS)];
    DEVICE_FAMILY global "deviceFamily" (readOnly?: Kind::Boolean), [some (LABELS)];
    PRODUCT_FAMILY global "productFamily" (readOnly?: Kind::Boolean) = Kind::Text;
    PRODUCT_NAME global "productName" (readOnly?: Kind::Boolean) = Kind::Text;
    PRODUCT_ID global "productID" (readOnly?: Kind::Boolean) = Kind::Text;
    PRODUCT_TEXT global "productText" (readOnly?: Kind::Boolean), [some (LABELS)];
    ORDER_NUMBER global "orderNumber" (readOnly?: Kind::Boolean) = Kind::Text;
    VERSION global "version" (
        versionType!: Kind::Word(&["SW", "FW", "HW"]), readOnly?: Kind::Boolean,
    ) = Kind::Text;
    BUILD_DATE global "buildDate" = Kind::Date;
    SPECIFICATION_REVISION global "specificationRevision" (readOnly?: Kind::Boolean) = Kind::Text;
    INSTANCE_NAME global "instanceName" (readOnly?: Kind::Boolean) = Kind::Text;

    DEVICE_MANAGER global "DeviceManager", [maybe INDICATOR_LIST, maybe MODULE_MANAGEMENT], newer ["moduleManagement"];
    INDICATOR_LIST global "indicatorList", [maybe LED_LIST];
    LED_LIST global "LEDList", [some LED, any COMBINED_STATE];
    LED global "LED" (
        LEDcolors!: Kind::Word(&["monocolor", "bicolor"]),
        LEDtype?: Kind::Word(&["IO", "device", "communication"]),
    ), [some (LABELS), some LED_STATE];
    LED_STATE global "LEDstate" (
        uniqueID*: Kind::Id,
        state!: Kind::Word(&["on", "off", "flashing"]),
        LEDcolor!: Kind::Word(&["green", "amber", "red"]),
        flashingPeriod?: Kind::INT,
        impulsWidth?: Kind::BYTE,
        numberOfImpulses?: Kind::BYTE,
    ), [some (LABELS)];
    COMBINED_STATE global "combinedState", [some (LABELS), two LED_STATE_REF];
    LED_STATE_REF local "LEDstateRef" (stateIDRef*: Kind::Reference(Target::LedState));

    MODULE_MANAGEMENT global "moduleManagement", [one [MODULE_INTERFACE_LIST | MODULE_INTERFACE]];
    MODULE_INTERFACE_LIST global "moduleInterfaceList", [some INTERFACE];
    INTERFACE global "interface" (
        uniqueID*: Kind::Id,
        maxChilds!: Kind::POSITIVE,
        unusedSlots!: Kind::Boolean,
        multipleChilds!: Kind::Boolean,
    ), [some (LABELS), one FILE_LIST, one MODULE_TYPE_LIST, maybe CONNECTED_MODULE_LIST];
    FILE_LIST global "fileList", [one FILE];
    MODULE_TYPE_LIST global "moduleTypeList", [some MODULE_TYPE];
    MODULE_TYPE global "moduleType" (type*: Kind::Name);
    CONNECTED_MODULE_LIST local "connectedModuleList", [some CONNECTED_MODULE];
    CONNECTED_MODULE local "connectedModule" (childIDRef*: Kind::Name);
    MODULE_INTERFACE local "moduleInterface" (
        childID*: Kind::Name, type*: Kind::Name, maxCount?: Kind::NATURAL,
    );

    DEVICE_FUNCTION global "DeviceFunction", [one CAPABILITIES, maybe PICTURES_LIST, maybe DICTIONARY_LIST];
    CAPABILITIES global "capabilities", [some CHARACTERISTICS_LIST, maybe STANDARD_COMPLIANCE_LIST];
    CHARACTERISTICS_LIST global "characteristicsList", [maybe CATEGORY, some CHARACTERISTIC];
    CATEGORY local "category", [some (LABELS)];
    CHARACTERISTIC global "characteristic", [one CHARACTERISTIC_NAME, some CHARACTERISTIC_CONTENT];
    CHARACTERISTIC_NAME global "characteristicName", [some (LABELS)];
    CHARACTERISTIC_CONTENT global "characteristicContent", [some (LABELS)];
    STANDARD_COMPLIANCE_LIST global "standardComplianceList", [some COMPLIANT_WITH];
    COMPLIANT_WITH global "compliantWith" (
        name!: Kind::Text, range?: Kind::Word(&["international", "internal"]),
    ), [some (LABELS)];
    PICTURES_LIST global "picturesList", [some PICTURE];
    PICTURE global "picture" (URI*: Kind::Text, number?: Kind::INT), [some (LABELS)];
    DICTIONARY_LIST global "dictionaryList", [some DICTIONARY];
    DICTIONARY global "dictionary" (lang!: Kind::Language, dictID*: Kind::Text), [one FILE];
    FILE global "file" (URI*: Kind::Text);
}
