//! Changes of objects and entries.

use super::changes;

changes! {
    source: "CiA 306-1 §4.6.3.2";

    "change/object-added" = OBJECT_ADDED {
        Configurations: Compatible, "a stored configuration does not write the object, which keeps its defaults";
        SdoClients: Compatible, "clients that do not know the object do not access it";
        Firmware: Compatible, "generated code has another name; existing names stay";
        StoredValues: Risky, "an image of the storage group has another layout and is not loaded: the group starts with its defaults";
    }
    summary: "an object is added",
    checks: "Whether the new description has an object at an index that the old one does not have, and that no object has moved to.",
    example: "`[2001]` is only in the new description",
    remedy: "Raise the major part of the revision number, if the device already has users.",
    source: "CiA 301 §7.5.2.21 (revision number); objdict, docs/guides/storage.md (images)",

    "change/object-removed" = OBJECT_REMOVED {
        Configurations: Breaking, "the device refuses the download with abort code 06020000h";
        PdoConsumers: Breaking, "no PDO can carry the object any more";
        SdoClients: Breaking, "each access is refused with abort code 06020000h";
        Firmware: Breaking, "the names of the object are gone from generated code";
        StoredValues: Breaking, "the stored value has no entry any more, and images of the group have another layout";
    }
    summary: "an object is removed",
    checks: "Whether an object of the old description is missing in the new one, and has not moved to another index.",
    example: "`[2001]` is only in the old description",
    remedy: "Keep the object, or raise the major part of the revision number and give the device another product code if both are in use.",
    source: "CiA 301 §7.2.4.3.17 (abort codes), §7.5.2.21 (revision number)",

    "change/object-moved" = OBJECT_MOVED {
        Configurations: Breaking, "the configuration writes to the old index";
        PdoConsumers: Breaking, "mappings that a manager writes contain the old index";
        SdoClients: Breaking, "clients access the old index";
        Firmware: Compatible, "the names of the object stay; its index is a constant of generated code";
        StoredValues: Risky, "the layout of an image depends on the index: images of the group are not loaded";
    }
    summary: "an object moved to another index",
    checks: "Whether an object with the name, the type and the shape of an old one is at another index, and the old index is gone or has another object. Objects below 2000h have fixed indexes and do not move.",
    example: "`Brightness` at 2000h in the old description, at 2010h in the new one",
    remedy: "Leave the object at its index.",
    source: "CiA 301 §7.4.3 (index and sub-index address an entry)",

    "change/object-renamed" = OBJECT_RENAMED {
        Configurations: Compatible, "a stored configuration addresses entries by index and sub-index";
        SdoClients: Compatible, "clients address entries by index and sub-index";
        Firmware: Risky, "identifiers of generated code are made of the name: sources that use the old one no longer compile";
    }
    summary: "an object has another name",
    checks: "Whether the name of an object is another one, apart from case, blanks and punctuation.",
    example: "`ParameterName=Brightness`, then `ParameterName=Luminance`",
    remedy: "Keep the name, or keep the identifier with `objdict generate --rename`.",
    source: "CiA 306-1 §4.6.3.2; objdict, docs/reference/generate.md (names)",

    "change/object-type-changed" = OBJECT_TYPE_CHANGED {
        Configurations: Breaking, "values are at other sub-indexes, or a domain takes what was a value";
        PdoConsumers: Breaking, "the mapped sub-index means something else or is gone";
        SdoClients: Breaking, "values are at other sub-indexes, or a domain takes what was a value";
        Firmware: Breaking, "generated code has another structure";
        StoredValues: Breaking, "images of the group have another layout";
    }
    summary: "an object has another structure",
    checks: "Whether one description has a variable or a domain where the other has an array or a record, or a variable where the other has a domain. The entries of such an object are not compared.",
    example: "`ObjectType=0x7`, then `ObjectType=0x9`",
    remedy: "Describe the new structure at another index.",
    source: "CiA 301 §7.4.3",

    "change/array-or-record" = ARRAY_OR_RECORD {
        SdoClients: Compatible, "sub-indexes are accessed in the same way";
        Firmware: Risky, "generated code has an array where it had a struct, or the reverse";
    }
    summary: "an array became a record, or a record an array",
    checks: "Whether one description has an ARRAY where the other has a RECORD or DEFSTRUCT.",
    example: "`ObjectType=0x8`, then `ObjectType=0x9`",
    remedy: "Keep the object type if all sub-indexes have the same type.",
    source: "CiA 301 §7.4.3",

    "change/entry-added" = ENTRY_ADDED {
        Configurations: Compatible, "a stored configuration does not write the entry, which keeps its default";
        SdoClients: Compatible, "clients that do not know the entry do not access it";
        Firmware: Compatible, "generated code has another name; existing names stay";
        StoredValues: Risky, "an image of the storage group has another layout and is not loaded: the group starts with its defaults";
    }
    summary: "a sub-index is added",
    checks: "Whether an object has a sub-index that it did not have, and that no entry has moved to.",
    example: "`[2001sub3]` is only in the new description",
    remedy: "Raise the major part of the revision number, if the device already has users.",
    source: "CiA 301 §7.5.2.21 (revision number)",

    "change/entry-removed" = ENTRY_REMOVED {
        Configurations: Breaking, "the device refuses the download with abort code 06090011h";
        PdoConsumers: Breaking, "no PDO can carry the entry any more";
        SdoClients: Breaking, "each access is refused with abort code 06090011h";
        Firmware: Breaking, "the name of the entry is gone from generated code";
        StoredValues: Breaking, "the stored value has no entry any more, and images of the group have another layout";
    }
    summary: "a sub-index is removed",
    checks: "Whether a sub-index of an object is missing in the new description, and has not moved.",
    example: "`[2001sub3]` is only in the old description",
    remedy: "Keep the entry, or raise the major part of the revision number.",
    source: "CiA 301 §7.2.4.3.17 (abort codes)",

    "change/entry-moved" = ENTRY_MOVED {
        Configurations: Breaking, "the configuration writes to the old sub-index";
        PdoConsumers: Breaking, "mappings that a manager writes contain the old sub-index";
        SdoClients: Breaking, "clients access the old sub-index";
        Firmware: Compatible, "the name of the entry stays";
        StoredValues: Risky, "the layout of an image depends on the sub-index: images of the group are not loaded";
    }
    summary: "an entry moved to another sub-index",
    checks: "Whether an entry with the name and the type of an old one is at another sub-index of the same object, and the old sub-index is gone or has another entry.",
    example: "`Gain` at sub-index 1 in the old description, at 2 in the new one, behind a new entry",
    remedy: "Add new entries behind the existing ones.",
    source: "CiA 301 §7.4.3 (index and sub-index address an entry)",

    "change/entry-renamed" = ENTRY_RENAMED {
        Configurations: Compatible, "a stored configuration addresses entries by index and sub-index";
        SdoClients: Compatible, "clients address entries by index and sub-index";
        Firmware: Risky, "identifiers of generated code are made of the name: sources that use the old one no longer compile";
    }
    summary: "an entry has another name",
    checks: "Whether the name of a sub-index is another one, apart from case, blanks and punctuation.",
    example: "`ParameterName=Gain`, then `ParameterName=Factor`",
    remedy: "Keep the name, or keep the identifier with `objdict generate --rename`.",
    source: "CiA 306-1 §4.6.3.2; objdict, docs/reference/generate.md (names)",

    "change/name-respelled" = NAME_RESPELLED {
        SdoClients: Compatible, "clients address entries by index and sub-index";
        Firmware: Compatible, "identifiers stay, or are a change of their own";
    }
    summary: "a name is spelled differently",
    checks: "Whether a name differs in case, blanks or punctuation only. If identifiers of generated code change with it, `change/identifier-changed` reports that.",
    example: "`Device Type`, then `Device type`",
    remedy: "Keep the spelling, unless it was wrong.",
    source: "CiA 306-1 §4.6.3.2; objdict, docs/reference/generate.md (names)",

    "change/identifier-changed" = IDENTIFIER_CHANGED {
        Firmware: Risky, "sources that use the old identifier no longer compile, or mean another entry";
    }
    summary: "an entry has another identifier in generated code, and the same name",
    checks: "Whether the identifier of an object or entry in the targets `c` and `rust` is another one although its name stays, or differs in its spelling only: a new entry of the same name gives both a number.",
    example: "`OD_GAIN` becomes `OD_GAIN_2001`, because 2005h is called `Gain` too",
    remedy: "Give the new entry another name, or keep the identifier with `objdict generate --rename`.",
    source: "objdict, docs/reference/generate.md (names)",

    "change/data-type-changed" = DATA_TYPE_CHANGED {
        Configurations: Breaking, "the stored value has another length or meaning: the device refuses it (06070010h) or misreads it";
        PdoConsumers: Breaking, "consumers read other bits, or read them as another type";
        SdoClients: Breaking, "clients read and write another length or meaning";
        Firmware: Breaking, "variables of generated code have another type";
        StoredValues: Breaking, "stored bytes have another length or meaning";
    }
    summary: "the data type of an entry changes",
    checks: "Whether both descriptions state a data type and it is not the same. Limits are not compared then.",
    example: "`DataType=0x0006`, then `DataType=0x0007`",
    remedy: "Describe the new value at another index or sub-index.",
    source: "CiA 301 §7.4.7 (data types), §7.2.4.3.17 (abort codes)",

    "change/data-type-stated" = DATA_TYPE_STATED {
        SdoClients: Risky, "tools that read the description now treat the value differently";
        Firmware: Risky, "generated code has the entry in only one of the two cases";
    }
    summary: "only one of the descriptions states the data type",
    checks: "Whether one description has a valid data type for an entry and the other has none.",
    example: "an entry without `DataType`, then `DataType=0x0005`",
    remedy: "State the data type in both descriptions and compare again.",

    "change/access-unknown" = ACCESS_UNKNOWN {
        Configurations: Risky, "tools treat an unknown access type as they like, and may not write the entry";
        SdoClients: Risky, "tools treat an unknown access type as they like";
        Firmware: Risky, "generated code has the entry in only one of the two cases";
    }
    summary: "only one of the descriptions has a valid access type",
    checks: "Whether one description has a valid access type for an entry and the other has none, or a text that is none.",
    example: "`AccessType=rw`, then `AccessType=readwrite`",
    remedy: "State the access type in both descriptions and compare again.",

    "change/access-narrowed" = ACCESS_NARROWED {
        Configurations: Breaking, "the device refuses the download with abort code 06010002h";
        PdoConsumers: Compatible, "the data in the frames stay";
        SdoClients: Breaking, "what clients read or write is refused (06010001h, 06010002h)";
        Firmware: Risky, "generated code may have a constant where it had a variable";
    }
    summary: "an entry can no longer be read or written",
    checks: "Whether the new access type lacks a right to read or write that the old one has.",
    example: "`AccessType=rw`, then `AccessType=ro`",
    remedy: "Keep the access type.",
    source: "CiA 306-1 §4.6.3.2; CiA 301 §7.2.4.3.17 (abort codes)",

    "change/access-widened" = ACCESS_WIDENED {
        Configurations: Compatible, "what was written before may still be written";
        SdoClients: Compatible, "what was accessed before may still be accessed";
        Firmware: Compatible, "the network may now change the value";
    }
    summary: "an entry can be read or written where it could not",
    checks: "Whether the new access type has a right to read or write that the old one lacks, and no right less.",
    example: "`AccessType=ro`, then `AccessType=rw`",
    remedy: "Raise the major part of the revision number, if the device already has users.",

    "change/constant-changed" = CONSTANT_CHANGED {
        SdoClients: Compatible, "the value is read in the same way, but may change where it did not";
        Firmware: Risky, "generated code has a constant where it had a variable, or the reverse";
    }
    summary: "a constant became variable, or the reverse",
    checks: "Whether the access type changes between `const` and `ro`.",
    example: "`AccessType=ro`, then `AccessType=const`",
    remedy: "Keep the access type, unless it was wrong.",

    "change/mapping-narrowed" = MAPPING_NARROWED {
        Configurations: Breaking, "the device refuses a mapping with the entry (06040041h)";
        PdoConsumers: Breaking, "PDOs of the direction cannot carry the entry any more";
        Firmware: Compatible, "names and types stay";
    }
    summary: "an entry can no longer be mapped to PDOs",
    checks: "Whether PDOs of a direction may no longer carry an entry, by `PDOMapping` and access type.",
    example: "`PDOMapping=1`, then `PDOMapping=0`",
    remedy: "Keep the entry mappable.",
    source: "CiA 306-1 §4.6.3.2; CiA 301 §7.4.5",

    "change/mapping-widened" = MAPPING_WIDENED {
        Configurations: Compatible, "mappings that were accepted still are";
        PdoConsumers: Compatible, "frames change only when a manager maps the entry";
    }
    summary: "an entry can be mapped to PDOs",
    checks: "Whether PDOs of a direction may carry an entry that they could not, and none may carry it no longer.",
    example: "`PDOMapping=0`, then `PDOMapping=1`",
    remedy: "Raise the major part of the revision number, if the device already has users.",
    source: "CiA 306-1 §4.6.3.2; CiA 301 §7.4.5",

    "change/limits-narrowed" = LIMITS_NARROWED {
        Configurations: Breaking, "the device may refuse a stored value that was allowed (06090031h, 06090032h)";
        PdoConsumers: Compatible, "frames have the same bits";
        SdoClients: Breaking, "the device may refuse a value that was allowed (06090031h, 06090032h)";
        Firmware: Compatible, "names and types stay";
        StoredValues: Risky, "a stored value may be outside the new limits";
    }
    summary: "the limits of an entry are narrower",
    checks: "Whether a value that the old limits allow is not allowed by the new ones. A missing limit is that of the data type.",
    example: "`HighLimit=1000`, then `HighLimit=500`",
    remedy: "Keep the limits, or let the device clip values.",
    source: "CiA 306-1 §4.6.3.2; CiA 301 §7.2.4.3.17 (abort codes)",

    "change/read-limits-widened" = READ_LIMITS_WIDENED {
        PdoConsumers: Risky, "consumers may receive values that they did not receive";
        SdoClients: Risky, "clients may read values that they did not read";
        Firmware: Compatible, "names and types stay";
    }
    summary: "the limits of a read-only entry are wider",
    checks: "Whether the new limits of an entry that no SDO can write allow a value that the old ones do not allow, and all that these allow.",
    example: "`HighLimit=1000`, then `HighLimit=4000` of an entry with `AccessType=ro`",
    remedy: "Check what the clients make of the new values.",

    "change/read-limits-narrowed" = READ_LIMITS_NARROWED {
        PdoConsumers: Compatible, "consumers receive values that they know";
        SdoClients: Compatible, "clients read values that they know";
        Firmware: Compatible, "names and types stay";
    }
    summary: "the limits of a read-only entry are narrower",
    checks: "Whether the new limits of an entry that no SDO can write exclude a value that the old ones allow.",
    example: "`HighLimit=4000`, then `HighLimit=1000` of an entry with `AccessType=ro`",
    remedy: "Check the clients that wait for a value outside the new limits.",

    "change/limits-widened" = LIMITS_WIDENED {
        Configurations: Compatible, "all values that were allowed still are";
        SdoClients: Compatible, "all values that were allowed still are";
        Firmware: Compatible, "names and types stay";
    }
    summary: "the limits of an entry are wider",
    checks: "Whether the new limits allow more values, and all that the old ones allow.",
    example: "`HighLimit=500`, then `HighLimit=1000`",
    remedy: "Raise the major part of the revision number, if the device already has users.",

    "change/default-changed" = DEFAULT_CHANGED {
        Configurations: Risky, "a stored configuration that has only what differs from the defaults leaves the new default";
        PdoConsumers: Compatible, "frames have the same bits";
        SdoClients: Risky, "a device that is not configured starts with another value";
        Firmware: Compatible, "names and types stay";
        StoredValues: Compatible, "stored values are loaded over the defaults";
    }
    summary: "the default value of an entry changes",
    checks: "Whether the default values are different numbers, texts or bytes. The number of sub-indexes at sub-index 0, what identifies the device, and the parameters of PDOs belong to other rules.",
    example: "`DefaultValue=10`, then `DefaultValue=0x14`",
    remedy: "Keep the default, or name the change in the release notes.",

    "change/default-stated" = DEFAULT_STATED {
        SdoClients: Compatible, "the device starts with the value that it had without a stated default";
        Firmware: Compatible, "generated tables have the same value";
    }
    summary: "only one of the descriptions states a default value of 0",
    checks: "Whether one description has the default 0, or an empty text, and the other has none: without a default, tables and configurations take 0. COB-IDs belong to other rules.",
    example: "an entry without `DefaultValue`, then `DefaultValue=0`",
    remedy: "State the default in both descriptions.",

    "change/read-only-default-changed" = READ_ONLY_DEFAULT_CHANGED {
        SdoClients: Compatible, "clients must read the value, which the device sets";
        Firmware: Compatible, "the initial value of generated code changes";
    }
    summary: "the default value of a read-only entry changes",
    checks: "Whether the default values of an entry that no SDO can write are different.",
    example: "`DefaultValue=1` of an entry with `AccessType=ro`, then `DefaultValue=2`",
    remedy: "Check the clients that know the value without reading it.",

    "change/configured-value-changed" = CONFIGURED_VALUE_CHANGED {
        Configurations: Risky, "the node is configured with another value";
        SdoClients: Risky, "the node works with another value";
    }
    summary: "the configured value of an entry changes",
    checks: "Whether the value of an entry after configuration is another one, where at least one description configures it.",
    example: "`ParameterValue=100`, then `ParameterValue=200`",
    remedy: "Download the new configuration to the node.",
    source: "CiA 306-1 §5.3",

    "change/unit-changed" = UNIT_CHANGED {
        Configurations: Risky, "the stored number means another physical value";
        PdoConsumers: Risky, "the number in the frame means another physical value";
        SdoClients: Risky, "the number means another physical value";
        Firmware: Risky, "the number means another physical value";
        StoredValues: Risky, "the stored number means another physical value";
    }
    summary: "the unit or scaling of an entry changes",
    checks: "Whether the unit, the multiplier or the offset of a parameter (CiA 311) is another one, where both descriptions state one.",
    example: "`<unit multiplier=\"1\">` with the label `mm`, then `µm`",
    remedy: "Describe the new quantity at another index.",
    source: "CiA 311 §6.4.5",

    "change/unit-stated" = UNIT_STATED {
        SdoClients: Compatible, "the number means what it meant, unless the device changed with its description";
        Firmware: Compatible, "names and types stay";
    }
    summary: "only one of the descriptions states a unit or scaling",
    checks: "Whether one description has a unit, a multiplier or an offset for an entry (CiA 311) and the other has none.",
    example: "an entry without `unit`, then with `mm`",
    remedy: "State the unit in both descriptions.",
    source: "CiA 311 §6.4.5",

    "change/values-removed" = VALUES_REMOVED {
        Configurations: Breaking, "the device may refuse a stored value that was allowed (06090030h)";
        PdoConsumers: Risky, "consumers may wait for values that do not come";
        SdoClients: Breaking, "the device may refuse a value that was allowed (06090030h)";
        Firmware: Risky, "names of values are gone from generated code";
        StoredValues: Risky, "a stored value may have no meaning any more";
    }
    summary: "named values of an entry are removed",
    checks: "Whether a value has a name in the old application process and none in the new one, where both name values.",
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
    checks: "Whether a value has a name in the new application process and none in the old one, where both name values.",
    example: "`<enumValue value=\"3\">` is only in the new description",
    remedy: "Check what the consumers make of the new value.",
    source: "CiA 311 §6.4.5",

    "change/value-renamed" = VALUE_RENAMED {
        SdoClients: Risky, "the number may mean something else";
        Firmware: Risky, "names of generated code are made of the names of values: sources that use the old one no longer compile";
    }
    summary: "a named value of an entry has another name",
    checks: "Whether a value has another name in the new application process.",
    example: "the value 1 is `open` in the old description and `opened` in the new one",
    remedy: "Keep the name, unless it was wrong.",
    source: "CiA 311 §6.4.5",

    "change/flags-changed" = FLAGS_CHANGED {
        Configurations: Risky, "tools write or read the entry where they did not, or the reverse";
        SdoClients: Compatible, "the device answers in the same way";
    }
    summary: "configuration tools must treat an entry differently",
    checks: "Whether `ObjFlags` refuses the download or the scan of an entry in only one of the descriptions.",
    example: "`ObjFlags=0`, then `ObjFlags=1`",
    remedy: "Keep the flags, unless they were wrong.",
    source: "CiA 306-1 §4.6.3.3",

    "change/safety-changed" = SAFETY_CHANGED {
        Configurations: Breaking, "the safety configuration and its checksum (13FEh) do not fit any more";
        PdoConsumers: Breaking, "SRDOs cannot carry the entry, or carry another inverted value";
        SdoClients: Compatible, "the entry is accessed in the same way";
    }
    summary: "the safety mapping of an entry changes",
    checks: "Whether `SRDOMapping` or `InvertedSRAD` of an entry is another one.",
    example: "`SRDOMapping=1`, then `SRDOMapping=0`",
    remedy: "Assess the safety function anew.",
    source: "CiA 306-1 annex A; CiA 304",

    "change/storage-changed" = STORAGE_CHANGED {
        SdoClients: Compatible, "the entry is accessed in the same way";
        Firmware: Risky, "generated code has the variable in another structure";
        StoredValues: Risky, "the value is stored with another group or no longer stored, and images of the groups have another layout";
    }
    summary: "an object is stored with another group",
    checks: "Whether the storage group of an object, or whether its value survives power-off (`persistent`), is another one. The groups `RAM` and `ROM` are not stored.",
    example: "`;StorageLocation=RAM`, then `;StorageLocation=PERSIST_COMM`",
    remedy: "Keep the group, or let the firmware load images of the old layout.",
    source: "objdict, docs/guides/storage.md; CiA 311 §6.4.5 (`persistent`)",
}
