//! The keys of `device.toml`, and its JSON Schema, which is generated from them.

use std::sync::LazyLock;

use crate::scaffold::{FEATURES, FeatureKind};
use objdict_keyed::notation::{
    BASE_TYPE, BITS, COB_ID, DATA_TYPE, DATE, DUMMIES, INDEXES, MAPPED, NUMBERS, TIME_OF_DAY,
    TRANSMISSION_TYPE,
};
use objdict_keyed::schema::{DIALECT, object, one_or_list, text};
use objdict_keyed::section::{Key, Shape, bits, key};
use objdict_keyed::types::{self, OBJECT_TYPES};
use serde_json::{Value, json};

const UNSTATED: &str = "Which facts the description leaves out that would follow from missing keys.";

const EXTRA: &str = "Keys of a description that CiA's documents do not have, in their order.";

/// The value of `format` in the first line.
pub(super) const FORMAT: &str = "objdict-device/1";

/// The keys of the file.
pub(super) fn root() -> &'static [Key] {
    &ROOT
}

/// The keys for a device without the variants in its file, which are read separately.
pub(super) fn of_one_device() -> &'static [Key] {
    &OF_ONE_DEVICE
}

static OF_ONE_DEVICE: LazyLock<Vec<Key>> = LazyLock::new(|| {
    let of_device = |key: &Key| match key.name {
        "variant" => self::key("variant", Shape::Foreign, ""),
        _ => *key,
    };
    root().iter().map(of_device).collect()
});

static ROOT: LazyLock<Vec<Key>> = LazyLock::new(|| {
    let format =
        key("format", Shape::Word(&[FORMAT]), "The format and its version. It is the first key of the file.")
            .required();
    let extends = key(
        "extends",
        Shape::Text,
        "The base file. This file contains only the differences from its device.",
    );
    let variant = key(
        "variant",
        Shape::Named(variant_keys()),
        "The variants of the device by name, each with the keys of this table that are different in it.",
    );
    [&[format, extends], variant_keys(), &[variant]].concat()
});

/// The keys of a variant: those of the file except the variants.
pub(super) fn variant_keys() -> &'static [Key] {
    &VARIANT
}

static VARIANT: LazyLock<Vec<Key>> = LazyLock::new(|| {
    let features = Shape::Map(features());
    vec![
        key(
            "profile",
            Shape::Text,
            "The device profile and the version of objdict's data, `402@1`: the device has every object that the profile and CiA 301 require for its features. With `301@1`, it has only the objects of CiA 301.",
        ),
        key(
            "features",
            features,
            "What the device has and can do; what is not stated is as the profile has it.",
        ),
        key(
            "remove",
            Shape::Foreign,
            "Objects and entries of the profile that the device does not have: a list of addresses such as `1006` or `1018:4`, or a table with the reasons. A variant can also remove objects of the file.",
        ),
        key(
            "kind",
            Shape::Word(&["type", "node"]),
            "Whether the file describes a device type or a node; `[node]` implies `node`.",
        ),
        key("comments", Shape::Texts, "The lines of `Comments`: a text of several lines, or a list."),
        key(
            "dummies",
            Shape::Spelled(DUMMIES),
            "The data types in CiA 306-1's list that fill gaps in RPDOs: `u8 u16 u32`. After `only`, the list has no others: `only u8 !bool`.",
        ),
        key(
            "unstated",
            Shape::Texts,
            "Which parts the description leaves out: `file`, `device`, `comments`, `dummies`.",
        ),
        key("file", Shape::Map(FILE), "About the file with the description."),
        key("device", Shape::Map(DEVICE), "About the device."),
        key("node", Shape::Map(NODE), "The configured node."),
        key("defaults", Shape::Map(DEFAULTS), "Default properties of entries that do not set them."),
        key("rpdo", Shape::Numbered(1, 512, PDO), "RPDOs by number."),
        key("tpdo", Shape::Numbered(1, 512, PDO), "TPDOs by number."),
        key("lists", Shape::Map(LISTS), "Object lists that differ from those derived from the objects."),
        key("object", Shape::Named(OBJECT), "The objects by index: four hex digits."),
        key("extra", Shape::Foreign, "Sections that CiA's documents do not define, each with its keys."),
        key(
            "raw",
            Shape::Foreign,
            "JSON values that have no key, by JSON pointer; they override the other keys.",
        ),
        key(
            "raw-remove",
            Shape::Texts,
            "JSON pointers to values that other keys create but the device does not have.",
        ),
    ]
});

/// The keys of `[features]`.
pub(super) fn features() -> &'static [Key] {
    static KEYS: LazyLock<Vec<Key>> = LazyLock::new(|| {
        let keys = FEATURES.iter().map(|feature| {
            let shape = match feature.kind {
                FeatureKind::Flag => Shape::Flag,
                FeatureKind::Number { lowest, highest } => Shape::Integer(lowest.into(), highest.into()),
                FeatureKind::OneOf(words) => Shape::Word(words),
                _ => Shape::Texts,
            };
            key(feature.word, shape, feature.meaning)
        });
        keys.collect()
    });
    &KEYS
}

pub(super) const PDO: &[Key] = &[
    key(
        "map",
        Shape::AllSpelled(MAPPED),
        "The mapped entries in the order of the frame: `6000:1`, `6041` for sub-index 0, `0005` for a dummy, `2000:1/8` with a number of bits.",
    ),
    key(
        "cob-id",
        Shape::IntegerOrText(0, 0xFFFF_FFFF, COB_ID),
        "COB-ID: a number, `$NODEID+0x180`, or `off` for the usual one of a PDO that is not valid.",
    ),
    key(
        "transmission",
        TRANSMISSION_TYPE,
        "The transmission type: `sync/1` to `sync/240`, `event`, `rtr`, or its number.",
    ),
    key(
        "inhibit",
        Shape::Time(0xFFFF, 100_000),
        "The inhibit time: a text with a unit, or a number of 100 µs.",
    ),
    key(
        "event-timer",
        Shape::Time(0xFFFF, 1_000_000),
        "The event timer: a text with a unit, or a number of ms.",
    )
    .formerly("event"),
    key("sync-start", bits(8), "SYNC start value."),
];

pub(super) const FILE: &[Key] = &[
    key("file-name", Shape::Text, "`FileName`."),
    key("file-version", bits(8), "`FileVersion`; 1 without this key."),
    key("file-revision", bits(8), "`FileRevision`; 0 without this key."),
    key("eds-version", Shape::Text, "`EDSVersion`; 4.0 without this key."),
    key("description", Shape::Text, "`Description`."),
    key("creation-time", Shape::Spelled(TIME_OF_DAY), "`CreationTime`: `14:40`."),
    key("creation-date", Shape::Spelled(DATE), "`CreationDate`: `2026-05-30`."),
    key("created-by", Shape::Text, "`CreatedBy`."),
    key("modification-time", Shape::Spelled(TIME_OF_DAY), "`ModificationTime`."),
    key("modification-date", Shape::Spelled(DATE), "`ModificationDate`."),
    key("modified-by", Shape::Text, "`ModifiedBy`."),
    key("last-eds", Shape::Text, "`LastEDS`."),
    key("languages", Shape::Texts, "The languages of the texts (CiA 311)."),
    key("extra", Shape::Foreign, EXTRA),
    key("unstated", Shape::Texts, UNSTATED),
];

pub(super) const DEVICE: &[Key] = &[
    key("vendor-name", Shape::Text, "`VendorName`."),
    key("vendor-number", bits(32), "`VendorNumber`, the vendor-ID."),
    key("product-name", Shape::Text, "`ProductName`."),
    key("product-number", bits(32), "`ProductNumber`, the product code."),
    key("revision-number", bits(32), "`RevisionNumber`."),
    key("order-code", Shape::Text, "`OrderCode`."),
    key("bit-rates", BIT_RATES, "The bit rates in kbit/s, and `auto` for automatic detection."),
    key("simple-boot-up-master", Shape::Flag, "`SimpleBootUpMaster`; false without this key."),
    key("simple-boot-up-slave", Shape::Flag, "`SimpleBootUpSlave`; true without this key."),
    key("granularity", bits(8), "`Granularity` of PDO mappings in bits; 8 without this key."),
    key("dynamic-channels-supported", bits(8), "`DynamicChannelsSupported`; 0 without this key."),
    key("group-messaging", Shape::Flag, "`GroupMessaging`; false without this key."),
    key("rpdo-count", bits(16), "`NrOfRXPDO`; the number of RPDOs without this key."),
    key("tpdo-count", bits(16), "`NrOfTXPDO`; the number of TPDOs without this key."),
    key("lss-supported", Shape::Flag, "`LSS_Supported`; false without this key."),
    key("compact-pdo", bits(8), "`CompactPDO`."),
    key("safety-supported", Shape::Flag, "`CANopenSafetySupported`."),
    key("conformance-class", Shape::Text, "`conformanceClass` (CiA 311)."),
    key("communication-entities", Shape::Texts, "`communicationEntityType` (CiA 311)."),
    key("self-starting", Shape::Flag, "`selfStartingDevice` (CiA 311)."),
    key("sdo-requesting", Shape::Flag, "`SDORequestingDevice` (CiA 311)."),
    key("flying-master", Shape::Flag, "`flyingMaster` (CiA 311)."),
    key("sdo-manager", Shape::Flag, "`SDOManager` (CiA 311)."),
    key("configuration-manager", Shape::Flag, "`configurationManager` (CiA 311)."),
    key("lss-master", Shape::Flag, "`layerSettingServiceMaster` (CiA 311)."),
    key("extra", Shape::Foreign, EXTRA),
    key("unstated", Shape::Texts, UNSTATED),
];

const BIT_RATES: Shape = Shape::ValueOrList;

pub(super) const NODE: &[Key] = &[
    key("node-id", Shape::Integer(0, 255), "`NodeID`."),
    key("node-name", Shape::Text, "`NodeName`."),
    key("node-reference-designator", Shape::Text, "`NodeRefd`."),
    key("baud-rate", bits(16), "`Baudrate` in kbit/s."),
    key("net-number", bits(32), "`NetNumber`."),
    key("network-name", Shape::Text, "`NetworkName`."),
    key("net-reference-designator", Shape::Text, "`NetRefd`."),
    key("manager", Shape::Flag, "`CANopenManager`."),
    key("lss-serial-number", bits(32), "`LSS_SerialNumber`."),
    key("extra", Shape::Foreign, EXTRA),
];

pub(super) const LISTS: &[Key] = &[
    key("mandatory", Shape::Spelled(INDEXES), "The mandatory objects: `1000-1001 1018`."),
    key("optional", Shape::Spelled(INDEXES), "The optional objects."),
    key("manufacturer", Shape::Spelled(INDEXES), "The objects of the manufacturer."),
    key("unstated", Shape::Texts, UNSTATED),
];

const ACCESS: Shape = Shape::Word(types::ACCESS);
const MAP: Shape = Shape::Word(&["no", "optional", "default", "tpdo", "rpdo"]);

pub(super) const DEFAULTS: &[Key] = &[
    key("access", ACCESS, "The access type of entries without `access`; `rw` without this key."),
    key("map", MAP, "Whether PDOs carry entries without `map`; `no` without this key."),
    key("sub0", Shape::Map(ENTRY), "Sub-index 0 of objects without `sub.0`."),
    key("unstated", Shape::Texts, UNSTATED),
];

/// The keys of an entry, and those of an object, which has additional ones.
macro_rules! entry_keys {
    ($($of_object:expr,)*) => {
        &[
            key("name", Shape::Text, "`ParameterName`."),
            key("type", Shape::Spelled(DATA_TYPE), "The data type: `bool`, `u8` to `u64`, `i8` to `i64`, `f32`, `f64`, `string`, `string(20)`, `unicode`, `bytes`, `time`, `time-difference`, `domain`, or the index of its definition (`0x0023`). Of an object also `record`, `array`, `[u16]` for an array of it, and `[u16; 8]` for one of 8 equal elements."),
            key("object-type", Shape::Word(OBJECT_TYPES), "The object type, where it does not follow from `type`."),
            key("access", ACCESS, "The access type."),
            key("map", MAP, "Whether PDOs carry the entry, and which."),
            key("default", Shape::ValueOrList, "The default value; of a range of sub-indexes, or of the elements of `[u16; 8]`, also a list of them."),
            key("min", Shape::ValueOrList, "The low limit; a list as in `default`."),
            key("max", Shape::ValueOrList, "The high limit; a list as in `default`."),
            key("value", Shape::ValueOrList, "The configured value of a node; a list as in `default`."),
            key("flags", bits(32), "`ObjFlags`."),
            key("unit", Shape::Text, "The unit of the engineering value."),
            key("factor", Shape::Text, "Multiplier from the value to the engineering value."),
            key("offset", Shape::Text, "Offset that is added to the value before `factor` is applied."),
            key("enum", Shape::ValuesOf(NUMBERS), "The names of values by number."),
            key("bits", Shape::ValuesOf(BITS), "The names of bits, or of ranges of them (`4-7`)."),
            key("description", Shape::Text, "Purpose of the object or entry, in English."),
            key("group", Shape::Text, "The storage group of CANopenNode."),
            key("disabled", Shape::Flag, "Whether the CANopenNode generators skip the object."),
            key("count-label", Shape::Text, "The label by which CANopenNode counts objects."),
            key("srdo", Shape::Word(&["no", "tx", "rx", "trx"]), "Which SRDOs carry it in CANopenNode."),
            key("detects-change", Shape::Flag, "Whether CANopenNode has flags that start PDOs for it."),
            key("io-extension", Shape::Flag, "Whether CANopenNode calls application functions for the object."),
            key("denotation", Shape::Text, "`Denotation`: its name in the application."),
            key("upload-file", Shape::Text, "`UploadFile`."),
            key("download-file", Shape::Text, "`DownloadFile`."),
            key("extra", Shape::Foreign, EXTRA),
            key("unstated", Shape::Texts, UNSTATED),
            $($of_object,)*
        ]
    };
}

pub(super) const ENTRY: &[Key] = entry_keys!();

pub(super) const OBJECT: &[Key] = entry_keys![
    key(
        "data-type",
        Shape::Spelled(BASE_TYPE),
        "The data type of a record or array as a whole, as in `type`."
    ),
    key(
        "sub",
        Shape::Named(ENTRY),
        "The entries by sub-index in hex digits, or by a range (`1-8`) with `{}` in the name for the number."
    ),
    key("sub-number", bits(8), "`SubNumber`, where it is not the number of entries."),
    key(
        "names",
        Shape::ValuesOrList,
        "The names of single elements of `[u16; 8]` by sub-index, or of all in a list."
    ),
    key(
        "values",
        Shape::ValuesOrList,
        "The configured values of single elements by sub-index, or of all in a list."
    ),
    key(
        "denotations",
        Shape::ValuesOrList,
        "The denotations of single elements by sub-index, or of all in a list."
    ),
    key("links", Shape::Spelled(INDEXES), "`ObjectLinks`: indexes as in a list."),
];

/// The JSON Schema of `device.toml`, with which editors complete and check it.
pub fn schema() -> Value {
    let mut schema = object(root());
    refine(&mut schema["properties"]);
    let mut variant = object(variant_keys());
    refine(&mut variant["properties"]);
    schema["properties"]["variant"]["additionalProperties"] = variant;
    if let Some(fields) = schema.as_object_mut() {
        fields.insert("$schema".to_owned(), DIALECT.into());
        fields.insert("title".to_owned(), "device.toml of objdict".into());
    }
    schema
}

/// Adds the keys of tables by address.
fn refine(properties: &mut Value) {
    let by_hex = |digits: &str, values: Value| json!({ "type": "object", "patternProperties": { digits: values }, "additionalProperties": false });
    let mut of_object = object(OBJECT);
    with_meaning(
        &mut of_object["properties"]["sub"],
        by_hex("^[0-9A-Fa-f]{1,2}(-[0-9A-Fa-f]{1,2})?$", object(ENTRY)),
    );
    with_meaning(&mut properties["object"], by_hex("^[0-9A-Fa-f]{4}$", of_object));
    with_meaning(&mut properties["raw"], by_hex("^/", json!({})));
    with_meaning(&mut properties["extra"], json!({ "type": ["object", "array"] }));
    let address = text(MAPPED);
    let reasons = json!({ "type": "object", "propertyNames": address });
    with_meaning(&mut properties["remove"], json!({ "anyOf": [one_or_list(&address), reasons] }));
    let rates = text("^(auto|10|20|50|100|125|250|500|800|1000)$");
    let rate = json!({ "anyOf": [rates, { "enum": [10, 20, 50, 100, 125, 250, 500, 800, 1000] }] });
    with_meaning(&mut properties["device"]["properties"]["bit-rates"], one_or_list(&rate));
}

/// Replaces a schema, but for its description.
fn with_meaning(schema: &mut Value, new: Value) {
    let meaning = schema["description"].take();
    *schema = new;
    schema["description"] = meaning;
}

#[cfg(test)]
mod tests {
    use super::*;
    use objdict_model::model::field_names;

    #[test]
    fn fields_have_the_keys_of_their_rows() {
        for (rows, keys) in [
            (field_names::FILE, FILE),
            (field_names::DEVICE, DEVICE),
            (field_names::COMMISSIONING, NODE),
            (field_names::ENTRY, OBJECT),
        ] {
            for row in rows {
                assert!(keys.iter().any(|key| key.name == row.key), "{row:?}");
            }
        }
    }
}
