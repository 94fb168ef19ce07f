//! Changes of the device as a whole, and of the identification of the device and its description.

use super::changes;

changes! {
    source: "CiA 306-1 §4.5";

    "change/device-type-changed" = DEVICE_TYPE_CHANGED {
        Configurations: Breaking, "a manager compares 1000h with 1F84h and does not start the node";
        PdoConsumers: Compatible, "changes of PDOs are reported separately";
        SdoClients: Breaking, "the device follows a different profile or other parts of it";
        Firmware: Compatible, "names and types are unchanged";
    }
    summary: "the device type (1000h) changes",
    checks: "The value of 1000h changes: the device profile or its additional information.",
    example: "`DefaultValue=0x000F0191` of 1000h, then `DefaultValue=0x00030191`",
    remedy: "Assign the device a different product code.",
    source: "CiA 301 §7.5.2.1; CiA 302-2 (1F84h)",

    "change/identity-changed" = IDENTITY_CHANGED {
        Configurations: Breaking, "a manager compares 1018h with 1F85h and 1F86h and does not start the node";
        PdoConsumers: Compatible, "changes of PDOs are reported separately";
        SdoClients: Breaking, "tools choose the description by vendor-ID and product code and mistake the device for a different one";
        Firmware: Compatible, "names and types are unchanged";
    }
    summary: "the vendor-ID or the product code changes",
    checks: "Sub-index 1 or 2 of 1018h changes.",
    example: "`DefaultValue=0x100` of 1018h sub-index 2, then `DefaultValue=0x101`",
    remedy: "Keep the identity. For a different product, the comparison with the old one shows what users must change.",
    source: "CiA 301 §7.5.2.21; CiA 302-2 (1F85h, 1F86h)",

    "change/configuration-refused" = CONFIGURATION_REFUSED {
        Configurations: Breaking, "the configuration of the node is not complete, and a manager does not start it";
    }
    summary: "the new device rejects a download of a stored configuration",
    checks: "With `objdict diff --against`, the new device must accept each download of a stored configuration. `objdict dcf verify` performs the same check.",
    example: "the configuration writes 6083h, which is read-only in the new description",
    remedy: "Remove the download from the configuration, or change its value.",
    source: "CiA 302-3; CiA 301 §7.2.4.3.17 (abort codes)",

    "change/node-changed" = NODE_CHANGED {
        Configurations: Breaking, "the configuration is for a different node-ID, bit rate or network";
        PdoConsumers: Breaking, "CAN-IDs follow the node-ID, and all nodes need the same bit rate";
        SdoClients: Breaking, "the SDO channel follows the node-ID, and all nodes need the same bit rate";
    }
    summary: "the node has a different node-ID, bit rate or network",
    checks: "Two configured nodes differ in `NodeID`, `Baudrate` or `NetNumber`.",
    example: "`NodeID=5`, then `NodeID=6`",
    remedy: "Change the other nodes and the manager as well.",
    source: "CiA 306-1 §5.4",

    "change/node-fact-changed" = NODE_FACT_CHANGED {
        Configurations: Compatible, "the node is configured in the same way";
        SdoClients: Compatible, "the node responds in the same way";
    }
    summary: "a detail of the configured node changes",
    checks: "Any other key of `[DeviceComissioning]` differs. This covers the name of the node or network, a reference designator, the serial number for LSS, and the node's role as manager. It also applies if only one description is of a node.",
    example: "`NodeName=Door`, then `NodeName=Gate`",
    remedy: "Check where the name is used.",
    source: "CiA 306-1 §5.4",

    "change/device-fact-changed" = DEVICE_FACT_CHANGED {
        Configurations: Compatible, "no value that a configuration writes is affected";
        SdoClients: Compatible, "the device responds in the same way";
        Firmware: Compatible, "names and types are unchanged";
    }
    summary: "a detail of the device changes",
    checks: "A key of `[DeviceInfo]` that no other rule covers changes, such as the vendor name, product name or order code. So does a string or number that identifies the device (1008h to 100Ah, the serial number).",
    example: "`ProductName=Lamp`, then `ProductName=Lamp 2`",
    remedy: "Check where the name is used.",
    source: "CiA 306-1 §4.5; CiA 301 §7.5.2.9 to §7.5.2.11, §7.5.2.21",

    "change/data-changed" = DATA_CHANGED {
        Configurations: Compatible, "no value that a configuration writes is affected";
        SdoClients: Compatible, "no type, access or value that is known from the description is affected";
        Firmware: Risky, "generated code can have different content";
    }
    summary: "the descriptions differ in data that no other rule covers",
    checks: "Reports any other field that differs or is stated in only one of the descriptions. It is identified by its key in an EDS, otherwise by its path in JSON. Comments, names, authors, dates, file versions and order are ignored. So are other notations of the same content (compact objects, numbers).",
    example: "`;CO_countLabel=TPDO` of 1800h, then none; `Denotation=Pump`, then `Denotation=Fan`",
    remedy: "Compare both places.",
    source: "objdict, docs/reference/json.md",

    "change/bit-rate-removed" = BIT_RATE_REMOVED {
        Configurations: Breaking, "a network with the bit rate cannot use the device";
        PdoConsumers: Breaking, "a network with the bit rate cannot use the device";
        SdoClients: Breaking, "a network with the bit rate cannot use the device";
    }
    summary: "a bit rate is no longer supported",
    checks: "The old description states support for a bit rate or for automatic detection, but the new one does not.",
    example: "`BaudRate_20=1`, then `BaudRate_20=0`",
    remedy: "Keep the bit rate, unless the old description was wrong.",

    "change/bit-rate-added" = BIT_RATE_ADDED {
        Configurations: Compatible, "all bit rates that were supported still are";
        SdoClients: Compatible, "all bit rates that were supported still are";
    }
    summary: "an additional bit rate is supported",
    checks: "The new description states support for a bit rate or for automatic detection, but the old one does not.",
    example: "`BaudRate_20=0`, then `BaudRate_20=1`",
    remedy: "Bump the major revision number if the device already has users.",

    "change/feature-removed" = FEATURE_REMOVED {
        Configurations: Risky, "a manager or tool that uses the feature cannot configure the device";
        SdoClients: Risky, "a manager or tool that uses the feature cannot work with the device";
    }
    summary: "a feature is no longer supported",
    checks: "Only the old description supports LSS, group messaging, boot-up as master or slave, dynamic channels, safety, or the type of a dummy entry.",
    example: "`LSS_Supported=1`, then `LSS_Supported=0`",
    remedy: "Keep the feature, unless the old description was wrong.",
    source: "CiA 306-1 §4.5, §4.6.2",

    "change/feature-added" = FEATURE_ADDED {
        Configurations: Compatible, "features that were used are still supported";
        SdoClients: Compatible, "features that were used are still supported";
    }
    summary: "the device has a new feature",
    checks: "Only the new description supports LSS, group messaging, boot-up as master or slave, dynamic channels, safety, or the type of a dummy entry.",
    example: "`LSS_Supported=0`, then `LSS_Supported=1`",
    remedy: "Bump the major revision number if the device already has users.",
    source: "CiA 306-1 §4.5, §4.6.2",

    "change/granularity-coarser" = GRANULARITY_COARSER {
        Configurations: Breaking, "the device rejects a mapping with shorter entries or any mapping (06040041h)";
        SdoClients: Compatible, "entries are accessed in the same way";
    }
    summary: "short entries can no longer be mapped",
    checks: "`Granularity` becomes a larger number of bits, or 0, which means that mappings are fixed.",
    example: "`Granularity=1`, then `Granularity=8`",
    remedy: "Keep the granularity.",

    "change/granularity-finer" = GRANULARITY_FINER {
        Configurations: Compatible, "mappings that were accepted still are";
        SdoClients: Compatible, "entries are accessed in the same way";
    }
    summary: "shorter entries can be mapped",
    checks: "`Granularity` becomes a smaller number of bits or is no longer 0.",
    example: "`Granularity=8`, then `Granularity=1`",
    remedy: "Bump the major revision number if the device already has users.",

    "change/module-removed" = MODULE_REMOVED {
        Configurations: Breaking, "a configuration with the module does not match the coupler";
        PdoConsumers: Breaking, "the module's data are missing";
        SdoClients: Breaking, "the module's objects are missing";
    }
    summary: "a coupler no longer supports a module",
    checks: "A module of the old description, identified by its number, is missing in the new one.",
    example: "`[M3ModuleInfo]` is only in the old description",
    remedy: "Keep the module and its number.",
    source: "CiA 306-1 §6.3",

    "change/module-added" = MODULE_ADDED {
        Configurations: Compatible, "the modules of existing configurations are still supported";
        SdoClients: Compatible, "the modules of existing couplers are still supported";
    }
    summary: "a coupler supports an additional module",
    checks: "The new description has a module, identified by its number, that the old one does not have.",
    example: "`[M3ModuleInfo]` is only in the new description",
    remedy: "Bump the major revision number if the device already has users.",
    source: "CiA 306-1 §6.3",

    "change/module-changed" = MODULE_CHANGED {
        Configurations: Risky, "the module's objects may have other types or defaults";
        PdoConsumers: Risky, "the module's objects may have other types or lengths";
        SdoClients: Risky, "the module's objects may have other types or access";
    }
    summary: "a module of a coupler changes",
    checks: "The description of a module or the list of connected modules changes.",
    example: "`DataType=0x0005` in `[M3SubExt6000]`, then `DataType=0x0006`",
    remedy: "Plug the modules with `objdict configure` in both descriptions and compare the results.",
    source: "CiA 306-1 §6.3",

    "change/revision-not-raised" = REVISION_NOT_RAISED {
        Configurations: Risky, "a manager cannot distinguish the devices by 1018h sub-index 3 (1F87h)";
        SdoClients: Risky, "tools choose the description by the revision number and use the old one for the new device";
    }
    summary: "the behaviour on the bus changes, but the major revision does not",
    checks: "If objects, entries, PDOs or features change, the upper 16 bits of 1018h sub-index 3 must be greater than before.",
    example: "an entry is removed, and `DefaultValue=0x00010000` of 1018h sub-index 3 stays",
    remedy: "Bump the upper 16 bits of 1018h sub-index 3 and `RevisionNumber`.",
    source: "CiA 301 §7.5.2.21",

    "change/revision-raised" = REVISION_RAISED {
        Configurations: Risky, "a manager that compares 1018h sub-index 3 with the old number (1F87h) does not start the node";
        SdoClients: Compatible, "tools that choose the description by the revision number need the new one";
        Firmware: Compatible, "names and types are unchanged";
    }
    summary: "the revision number is higher than before",
    checks: "1018h sub-index 3 is a higher number than in the old description. If the behaviour on the bus changes, stored configurations are affected by that change and not by the number.",
    example: "`DefaultValue=0x00010001` of 1018h sub-index 3, then `DefaultValue=0x00020000`",
    remedy: "Rebuild the manager's configuration so that 1F87h has the new number.",
    source: "CiA 301 §7.5.2.21; CiA 302-2 (1F87h)",

    "change/revision-lowered" = REVISION_LOWERED {
        Configurations: Risky, "a manager that accepts only newer revisions does not start the node";
        SdoClients: Risky, "tools mistake the new device for an older one";
    }
    summary: "the revision number is lower than before",
    checks: "1018h sub-index 3 is a lower number than in the old description.",
    example: "`DefaultValue=0x00020000` of 1018h sub-index 3, then `DefaultValue=0x00010000`",
    remedy: "Bump the revision number; if the arguments are swapped, pass the old description first.",
    source: "CiA 301 §7.5.2.21",

    "change/file-version-not-raised" = FILE_VERSION_NOT_RAISED {
        Configurations: Risky, "tools that keep descriptions by file version keep the old one";
    }
    summary: "the description changes, but its version does not",
    checks: "If anything changes, `FileVersion` must be greater than before, or `FileRevision` within the same version. This is not checked if a description does not state them.",
    example: "an entry is added, and `FileVersion=1` and `FileRevision=2` stay",
    remedy: "Bump `FileRevision` or `FileVersion`.",
    source: "CiA 306-1 §4.4",

    "change/modification-date-not-moved" = MODIFICATION_DATE_NOT_MOVED {
        Configurations: Compatible, "the file version decides";
    }
    summary: "the description changes, but its modification date does not",
    checks: "If anything changes, `ModificationDate` and `ModificationTime` must be later than before. This is not checked if a description does not state them.",
    example: "an entry is added, and `ModificationDate=11-21-2026` stays",
    remedy: "Write the date of the change to `ModificationDate`.",
    source: "CiA 306-1 §4.4",

    "change/product-code-not-changed" = PRODUCT_CODE_NOT_CHANGED {
        Configurations: Risky, "a manager cannot distinguish the products by 1018h sub-index 2 (1F86h)";
        SdoClients: Risky, "tools choose the description by the product code and use the old one for the new product";
    }
    summary: "the device follows a different profile but has the same product code",
    checks: "If the profile changes (the lower 16 bits of 1000h), sub-index 2 of 1018h must change too.",
    example: "1000h changes from CiA 401 to CiA 402, and 1018h sub-index 2 stays",
    remedy: "Assign the product a different product code.",
    source: "CiA 301 §7.5.2.1, §7.5.2.21",
}
