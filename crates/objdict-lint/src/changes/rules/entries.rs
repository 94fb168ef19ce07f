//! Changes of objects and entries.

use super::changes;

changes! {
    source: "CiA 306-1 §4.6.3.2";

    "change/object-added" = OBJECT_ADDED {
        Configurations: Compatible, "a stored configuration does not write the object, which keeps its defaults";
        SdoClients: Compatible, "clients that do not know the object do not access it";
        Firmware: Compatible, "generated code has additional names; existing names are unchanged";
        StoredValues: Risky, "an image of the storage group has a different layout and is not loaded: the group starts with its defaults";
    }
    summary: "an object is added",
    checks: "Reports an object at an index that the old description does not have, unless an object moved to this index.",
    example: "`[2001]` is only in the new description",
    remedy: "Bump the major revision number if the device already has users.",
    source: "CiA 301 §7.5.2.21 (revision number); objdict, docs/guides/storage.md (images)",

    "change/object-removed" = OBJECT_REMOVED {
        Configurations: Breaking, "the device rejects the download with abort code 06020000h";
        PdoConsumers: Breaking, "PDOs can no longer carry the object";
        SdoClients: Breaking, "each access is rejected with abort code 06020000h";
        Firmware: Breaking, "the object's names are missing from generated code";
        StoredValues: Breaking, "the stored value no longer has an entry, and images of the group have a different layout";
    }
    summary: "an object is removed",
    checks: "Reports an object of the old description that is missing in the new one and has not moved to a different index.",
    example: "`[2001]` is only in the old description",
    remedy: "Keep the object, or bump the major revision number and assign a different product code if both are in use.",
    source: "CiA 301 §7.2.4.3.17 (abort codes), §7.5.2.21 (revision number)",

    "change/object-moved" = OBJECT_MOVED {
        Configurations: Breaking, "the configuration writes to the old index";
        PdoConsumers: Breaking, "mappings that a manager writes contain the old index";
        SdoClients: Breaking, "clients access the old index";
        Firmware: Compatible, "the object's names stay the same; its index is a constant of generated code";
        StoredValues: Risky, "the layout of an image depends on the index: images of the group are not loaded";
    }
    summary: "an object moved to a different index",
    checks: "An object with the old object's name, type and shape is at a different index. The old index is missing or has a different object. Objects below 2000h have fixed indexes and do not move.",
    example: "`Brightness` at 2000h in the old description, at 2010h in the new one",
    remedy: "Leave the object at its index.",
    source: "CiA 301 §7.4.3 (index and sub-index address an entry)",

    "change/object-renamed" = OBJECT_RENAMED {
        Configurations: Compatible, "a stored configuration addresses entries by index and sub-index";
        SdoClients: Compatible, "clients address entries by index and sub-index";
        Firmware: Risky, "identifiers of generated code are derived from the name: sources that use the old one no longer compile";
    }
    summary: "an object has a different name",
    checks: "Reports an object whose name changed in more than case, spaces and punctuation.",
    example: "`ParameterName=Brightness`, then `ParameterName=Luminance`",
    remedy: "Keep the name, or keep the identifier with `objdict generate --rename`.",
    source: "CiA 306-1 §4.6.3.2; objdict, docs/reference/generate.md (names)",

    "change/object-type-changed" = OBJECT_TYPE_CHANGED {
        Configurations: Breaking, "values are at other sub-indexes, or a domain replaces a value";
        PdoConsumers: Breaking, "the mapped sub-index has a different meaning or is missing";
        SdoClients: Breaking, "values are at other sub-indexes, or a domain replaces a value";
        Firmware: Breaking, "generated code has a different structure";
        StoredValues: Breaking, "images of the group have a different layout";
    }
    summary: "an object has a different structure",
    checks: "A variable or domain became an array or record, a variable became a domain, or the reverse. The entries of such an object are not compared.",
    example: "`ObjectType=0x7`, then `ObjectType=0x9`",
    remedy: "Describe the new structure at a different index.",
    source: "CiA 301 §7.4.3",

    "change/array-or-record" = ARRAY_OR_RECORD {
        SdoClients: Compatible, "sub-indexes are accessed in the same way";
        Firmware: Risky, "generated code has an array where it had a struct, or the reverse";
    }
    summary: "an array became a record, or a record an array",
    checks: "One description has an ARRAY where the other has a RECORD or DEFSTRUCT.",
    example: "`ObjectType=0x8`, then `ObjectType=0x9`",
    remedy: "Keep the object type if all sub-indexes have the same type.",
    source: "CiA 301 §7.4.3",

    "change/entry-added" = ENTRY_ADDED {
        Configurations: Compatible, "a stored configuration does not write the entry, which keeps its default";
        SdoClients: Compatible, "clients that do not know the entry do not access it";
        Firmware: Compatible, "generated code has an additional name; existing names are unchanged";
        StoredValues: Risky, "an image of the storage group has a different layout and is not loaded: the group starts with its defaults";
    }
    summary: "a sub-index is added",
    checks: "Reports a new sub-index of an object, unless an entry moved to it.",
    example: "`[2001sub3]` is only in the new description",
    remedy: "Bump the major revision number if the device already has users.",
    source: "CiA 301 §7.5.2.21 (revision number)",

    "change/entry-removed" = ENTRY_REMOVED {
        Configurations: Breaking, "the device rejects the download with abort code 06090011h";
        PdoConsumers: Breaking, "PDOs can no longer carry the entry";
        SdoClients: Breaking, "each access is rejected with abort code 06090011h";
        Firmware: Breaking, "the entry's name is missing from generated code";
        StoredValues: Breaking, "the stored value no longer has an entry, and images of the group have a different layout";
    }
    summary: "a sub-index is removed",
    checks: "Reports a sub-index of an object that is missing in the new description and has not moved.",
    example: "`[2001sub3]` is only in the old description",
    remedy: "Keep the entry, or bump the major revision number.",
    source: "CiA 301 §7.2.4.3.17 (abort codes)",

    "change/entry-moved" = ENTRY_MOVED {
        Configurations: Breaking, "the configuration writes to the old sub-index";
        PdoConsumers: Breaking, "mappings that a manager writes contain the old sub-index";
        SdoClients: Breaking, "clients access the old sub-index";
        Firmware: Compatible, "the entry's name stays the same";
        StoredValues: Risky, "the layout of an image depends on the sub-index: images of the group are not loaded";
    }
    summary: "an entry moved to a different sub-index",
    checks: "An entry with the old entry's name and type is at a different sub-index of the same object. The old sub-index is missing or has a different entry.",
    example: "`Gain` at sub-index 1 in the old description, at 2 in the new one, behind a new entry",
    remedy: "Add new entries after the existing ones.",
    source: "CiA 301 §7.4.3 (index and sub-index address an entry)",

    "change/entry-renamed" = ENTRY_RENAMED {
        Configurations: Compatible, "a stored configuration addresses entries by index and sub-index";
        SdoClients: Compatible, "clients address entries by index and sub-index";
        Firmware: Risky, "identifiers of generated code are derived from the name: sources that use the old one no longer compile";
    }
    summary: "an entry has a different name",
    checks: "Reports a sub-index whose name changed in more than case, spaces and punctuation.",
    example: "`ParameterName=Gain`, then `ParameterName=Factor`",
    remedy: "Keep the name, or keep the identifier with `objdict generate --rename`.",
    source: "CiA 306-1 §4.6.3.2; objdict, docs/reference/generate.md (names)",

    "change/name-respelled" = NAME_RESPELLED {
        SdoClients: Compatible, "clients address entries by index and sub-index";
        Firmware: Compatible, "identifiers stay the same, or their change is reported separately";
    }
    summary: "a name is spelled differently",
    checks: "A name differs only in case, spaces or punctuation. If identifiers of generated code change with it, `change/identifier-changed` reports that.",
    example: "`Device Type`, then `Device type`",
    remedy: "Keep the spelling, unless it was wrong.",
    source: "CiA 306-1 §4.6.3.2; objdict, docs/reference/generate.md (names)",

    "change/identifier-changed" = IDENTIFIER_CHANGED {
        Firmware: Risky, "sources that use the old identifier no longer compile or refer to a different entry";
    }
    summary: "an entry has the same name but a different identifier in generated code",
    checks: "In the targets `c` and `rust`, the identifier of an object or entry changes although its name is unchanged or differs only in its spelling. For example, a new entry with the same name gives both a number.",
    example: "`OD_GAIN` becomes `OD_GAIN_2001`, because 2005h is called `Gain` too",
    remedy: "Give the new entry a different name, or keep the identifier with `objdict generate --rename`.",
    source: "objdict, docs/reference/generate.md (names)",

    "change/data-type-changed" = DATA_TYPE_CHANGED {
        Configurations: Breaking, "the stored value has a different length or meaning: the device rejects it (06070010h) or misreads it";
        PdoConsumers: Breaking, "consumers read other bits or interpret them as a different type";
        SdoClients: Breaking, "clients read and write a different length or meaning";
        Firmware: Breaking, "variables of generated code have a different type";
        StoredValues: Breaking, "stored bytes have a different length or meaning";
    }
    summary: "the data type of an entry changes",
    checks: "Both descriptions state a data type, and the types differ. Limits are not compared then.",
    example: "`DataType=0x0006`, then `DataType=0x0007`",
    remedy: "Describe the new value at a different index or sub-index.",
    source: "CiA 301 §7.4.7 (data types), §7.2.4.3.17 (abort codes)",

    "change/data-type-stated" = DATA_TYPE_STATED {
        SdoClients: Risky, "tools that read the description now treat the value differently";
        Firmware: Risky, "generated code contains the entry in only one of the two cases";
    }
    summary: "only one of the descriptions states the data type",
    checks: "One description has a valid data type for an entry, but the other has none.",
    example: "an entry without `DataType`, then `DataType=0x0005`",
    remedy: "State the data type in both descriptions and compare again.",

    "change/access-unknown" = ACCESS_UNKNOWN {
        Configurations: Risky, "tools interpret an unknown access type differently and may not write the entry";
        SdoClients: Risky, "tools interpret an unknown access type differently";
        Firmware: Risky, "generated code contains the entry in only one of the two cases";
    }
    summary: "only one of the descriptions has a valid access type",
    checks: "One description has a valid access type for an entry. The other has none or an invalid text.",
    example: "`AccessType=rw`, then `AccessType=readwrite`",
    remedy: "State the access type in both descriptions and compare again.",

    "change/access-narrowed" = ACCESS_NARROWED {
        Configurations: Breaking, "the device rejects the download with abort code 06010002h";
        PdoConsumers: Compatible, "the data in the frames are unchanged";
        SdoClients: Breaking, "reading or writing the entry is rejected (06010001h, 06010002h)";
        Firmware: Risky, "generated code may have a constant where it had a variable";
    }
    summary: "an entry can no longer be read or written",
    checks: "The new access type lacks a read or write right that the old one has.",
    example: "`AccessType=rw`, then `AccessType=ro`",
    remedy: "Keep the access type.",
    source: "CiA 306-1 §4.6.3.2; CiA 301 §7.2.4.3.17 (abort codes)",

    "change/access-widened" = ACCESS_WIDENED {
        Configurations: Compatible, "entries that were writable still are";
        SdoClients: Compatible, "each access that was allowed still is";
        Firmware: Compatible, "the network may now change the value";
    }
    summary: "an entry can be read or written where it could not",
    checks: "The new access type adds a right to read or write and removes none.",
    example: "`AccessType=ro`, then `AccessType=rw`",
    remedy: "Bump the major revision number if the device already has users.",

    "change/constant-changed" = CONSTANT_CHANGED {
        SdoClients: Compatible, "the value is read in the same way, but may change where it could not";
        Firmware: Risky, "generated code has a constant where it had a variable, or the reverse";
    }
    summary: "a constant became variable, or the reverse",
    checks: "The access type changes between `const` and `ro`.",
    example: "`AccessType=ro`, then `AccessType=const`",
    remedy: "Keep the access type, unless it was wrong.",

    "change/mapping-narrowed" = MAPPING_NARROWED {
        Configurations: Breaking, "the device rejects a mapping with the entry (06040041h)";
        PdoConsumers: Breaking, "PDOs of the direction can no longer carry the entry";
        Firmware: Compatible, "names and types are unchanged";
    }
    summary: "an entry can no longer be mapped to PDOs",
    checks: "By `PDOMapping` and access type, PDOs of one direction may no longer carry an entry.",
    example: "`PDOMapping=1`, then `PDOMapping=0`",
    remedy: "Keep the entry mappable.",
    source: "CiA 306-1 §4.6.3.2; CiA 301 §7.4.5",

    "change/mapping-widened" = MAPPING_WIDENED {
        Configurations: Compatible, "mappings that were accepted still are";
        PdoConsumers: Compatible, "frames change only if a manager maps the entry";
    }
    summary: "an entry can be mapped to PDOs",
    checks: "PDOs of one direction may carry an entry that they could not carry before. Neither direction loses an entry.",
    example: "`PDOMapping=0`, then `PDOMapping=1`",
    remedy: "Bump the major revision number if the device already has users.",
    source: "CiA 306-1 §4.6.3.2; CiA 301 §7.4.5",

    "change/limits-narrowed" = LIMITS_NARROWED {
        Configurations: Breaking, "the device may reject a stored value that was allowed (06090031h, 06090032h)";
        PdoConsumers: Compatible, "frames have the same bits";
        SdoClients: Breaking, "the device may reject a value that was allowed (06090031h, 06090032h)";
        Firmware: Compatible, "names and types are unchanged";
        StoredValues: Risky, "a stored value may be outside the new limits";
    }
    summary: "the limits of an entry are narrower",
    checks: "The new limits exclude a value that the old limits allow. If a limit is missing, the data type's limit applies.",
    example: "`HighLimit=1000`, then `HighLimit=500`",
    remedy: "Keep the limits, or let the device clip values.",
    source: "CiA 306-1 §4.6.3.2; CiA 301 §7.2.4.3.17 (abort codes)",

    "change/read-limits-widened" = READ_LIMITS_WIDENED {
        PdoConsumers: Risky, "consumers may receive values that they did not receive before";
        SdoClients: Risky, "clients may read values that they did not read before";
        Firmware: Compatible, "names and types are unchanged";
    }
    summary: "the limits of a read-only entry are wider",
    checks: "A read-only entry's limits become wider: they allow a new value and exclude none that was allowed. A read-only entry cannot be written by SDO.",
    example: "`HighLimit=1000`, then `HighLimit=4000` of an entry with `AccessType=ro`",
    remedy: "Check how the clients handle the new values.",

    "change/read-limits-narrowed" = READ_LIMITS_NARROWED {
        PdoConsumers: Compatible, "consumers receive values that they know";
        SdoClients: Compatible, "clients read values that they know";
        Firmware: Compatible, "names and types are unchanged";
    }
    summary: "the limits of a read-only entry are narrower",
    checks: "A read-only entry's limits exclude a value that they allowed before. A read-only entry cannot be written by SDO.",
    example: "`HighLimit=4000`, then `HighLimit=1000` of an entry with `AccessType=ro`",
    remedy: "Check the clients that wait for a value outside the new limits.",

    "change/limits-widened" = LIMITS_WIDENED {
        Configurations: Compatible, "all values that were allowed still are";
        SdoClients: Compatible, "all values that were allowed still are";
        Firmware: Compatible, "names and types are unchanged";
    }
    summary: "the limits of an entry are wider",
    checks: "The new limits allow more values and exclude none that was allowed.",
    example: "`HighLimit=500`, then `HighLimit=1000`",
    remedy: "Bump the major revision number if the device already has users.",

    "change/default-changed" = DEFAULT_CHANGED {
        Configurations: Risky, "a stored configuration that contains only differences from the defaults does not overwrite the new default";
        PdoConsumers: Compatible, "frames have the same bits";
        SdoClients: Risky, "a device that is not configured starts with a different value";
        Firmware: Compatible, "names and types are unchanged";
        StoredValues: Compatible, "stored values are loaded over the defaults";
    }
    summary: "the default value of an entry changes",
    checks: "The default values are different numbers, strings or bytes. Other rules cover the number of sub-indexes at sub-index 0, the identity of the device, and PDO parameters.",
    example: "`DefaultValue=10`, then `DefaultValue=0x14`",
    remedy: "Keep the default, or mention the change in the release notes.",

    "change/default-stated" = DEFAULT_STATED {
        SdoClients: Compatible, "the device starts with the value that it had without a stated default";
        Firmware: Compatible, "generated tables have the same value";
    }
    summary: "only one of the descriptions states a default value of 0",
    checks: "One description has the default 0 or an empty string, but the other has none. Without a default, tables and configurations use 0. Other rules cover COB-IDs.",
    example: "an entry without `DefaultValue`, then `DefaultValue=0`",
    remedy: "State the default in both descriptions.",

    "change/read-only-default-changed" = READ_ONLY_DEFAULT_CHANGED {
        SdoClients: Compatible, "clients must read the value, which the device sets";
        Firmware: Compatible, "the initial value of generated code changes";
    }
    summary: "the default value of a read-only entry changes",
    checks: "The default values of an entry that no SDO can write differ.",
    example: "`DefaultValue=1` of an entry with `AccessType=ro`, then `DefaultValue=2`",
    remedy: "Check the clients that assume the value without reading it.",

    "change/configured-value-changed" = CONFIGURED_VALUE_CHANGED {
        Configurations: Risky, "the node is configured with a different value";
        SdoClients: Risky, "the node works with a different value";
    }
    summary: "the configured value of an entry changes",
    checks: "An entry's value after configuration changes, and at least one description configures it.",
    example: "`ParameterValue=100`, then `ParameterValue=200`",
    remedy: "Download the new configuration to the node.",
    source: "CiA 306-1 §5.3",

    "change/unit-changed" = UNIT_CHANGED {
        Configurations: Risky, "the stored number represents a different physical value";
        PdoConsumers: Risky, "the number in the frame represents a different physical value";
        SdoClients: Risky, "the number represents a different physical value";
        Firmware: Risky, "the number represents a different physical value";
        StoredValues: Risky, "the stored number represents a different physical value";
    }
    summary: "the unit or scaling of an entry changes",
    checks: "Both descriptions state a parameter's unit, multiplier or offset (CiA 311), and it differs.",
    example: "`<unit multiplier=\"1\">` with the label `mm`, then `µm`",
    remedy: "Describe the new quantity at a different index.",
    source: "CiA 311 §6.4.5",

    "change/unit-stated" = UNIT_STATED {
        SdoClients: Compatible, "the number has the same meaning, unless the device changed with its description";
        Firmware: Compatible, "names and types are unchanged";
    }
    summary: "only one of the descriptions states a unit or scaling",
    checks: "One description has a unit, a multiplier or an offset for an entry (CiA 311), but the other has none.",
    example: "an entry without `unit`, then with `mm`",
    remedy: "State the unit in both descriptions.",
    source: "CiA 311 §6.4.5",

    "change/values-removed" = VALUES_REMOVED {
        Configurations: Breaking, "the device may reject a stored value that was allowed (06090030h)";
        PdoConsumers: Risky, "consumers may wait for values that are never sent";
        SdoClients: Breaking, "the device may reject a value that was allowed (06090030h)";
        Firmware: Risky, "names of values are missing from generated code";
        StoredValues: Risky, "a stored value may no longer have a meaning";
    }
    summary: "named values of an entry are removed",
    checks: "A value has a name in the old application process but none in the new one. Both must name values of the entry.",
    example: "`<enumValue value=\"2\">` is only in the old description",
    remedy: "Keep the value.",
    source: "CiA 311 §6.4.5",

    "change/values-added" = VALUES_ADDED {
        Configurations: Compatible, "all values that were allowed still are";
        PdoConsumers: Risky, "consumers may receive values that they do not know";
        SdoClients: Compatible, "all values that were allowed still are";
        Firmware: Compatible, "generated code has more names";
    }
    summary: "an entry has new named values",
    checks: "A value has a name in the new application process but none in the old one. Both must name values of the entry.",
    example: "`<enumValue value=\"3\">` is only in the new description",
    remedy: "Check how the consumers handle the new value.",
    source: "CiA 311 §6.4.5",

    "change/value-renamed" = VALUE_RENAMED {
        SdoClients: Risky, "the number may have a different meaning";
        Firmware: Risky, "names of generated code are derived from the names of values: sources that use the old one no longer compile";
    }
    summary: "a named value of an entry has a different name",
    checks: "The name of a value changes in the application process.",
    example: "the value 1 is `open` in the old description and `opened` in the new one",
    remedy: "Keep the name, unless it was wrong.",
    source: "CiA 311 §6.4.5",

    "change/flags-changed" = FLAGS_CHANGED {
        Configurations: Risky, "tools write or read the entry that they skipped before, or the reverse";
        SdoClients: Compatible, "the device responds in the same way";
    }
    summary: "configuration tools must treat an entry differently",
    checks: "`ObjFlags` forbids the download or the scan of an entry in only one of the descriptions.",
    example: "`ObjFlags=0`, then `ObjFlags=1`",
    remedy: "Keep the flags, unless they were wrong.",
    source: "CiA 306-1 §4.6.3.3",

    "change/safety-changed" = SAFETY_CHANGED {
        Configurations: Breaking, "the safety configuration and its checksum (13FEh) no longer match";
        PdoConsumers: Breaking, "SRDOs cannot carry the entry or carry a different inverted value";
        SdoClients: Compatible, "the entry is accessed in the same way";
    }
    summary: "the safety mapping of an entry changes",
    checks: "`SRDOMapping` or `InvertedSRAD` of an entry changes.",
    example: "`SRDOMapping=1`, then `SRDOMapping=0`",
    remedy: "Assess the safety function again.",
    source: "CiA 306-1 annex A; CiA 304",

    "change/storage-changed" = STORAGE_CHANGED {
        SdoClients: Compatible, "the entry is accessed in the same way";
        Firmware: Risky, "generated code has the variable in a different structure";
        StoredValues: Risky, "the value is stored with a different group or no longer stored, and images of the groups have a different layout";
    }
    summary: "an object is stored with a different group",
    checks: "An object's storage group changes, or its value starts or stops surviving power-off (`persistent`). The groups `RAM` and `ROM` are not stored.",
    example: "`;StorageLocation=RAM`, then `;StorageLocation=PERSIST_COMM`",
    remedy: "Keep the group, or let the firmware load images of the old layout.",
    source: "objdict, docs/guides/storage.md; CiA 311 §6.4.5 (`persistent`)",
}
