//! The fields of a device that users name in files: a row for each, with its name in every vocabulary. JSON paths, keys
//! of `device.toml` and terms of patches are looked up here; the names of CiA 311 are in its schema.

use super::{Field, Part};

/// A field with its names.
#[derive(Clone, Copy, Debug)]
pub struct FieldRow {
    /// In an EDS ([`Field::name`]).
    pub eds: &'static str,
    /// In the JSON of the model, relative to its part.
    pub json: &'static str,
    /// In a `device.toml`, and for an entry also in a patch; empty for a field without a key.
    pub key: &'static str,
}

const fn row(eds: &'static str, json: &'static str, key: &'static str) -> FieldRow {
    FieldRow { eds, json, key }
}

/// The fields of the file.
pub const FILE: &[FieldRow] = &[
    row("FileName", "file_name", "file-name"),
    row("FileVersion", "file_version", "file-version"),
    row("FileRevision", "file_revision", "file-revision"),
    row("EDSVersion", "eds_version", "eds-version"),
    row("Description", "description", "description"),
    row("CreationTime", "creation_time", "creation-time"),
    row("CreationDate", "creation_date", "creation-date"),
    row("CreatedBy", "created_by", "created-by"),
    row("ModificationTime", "modification_time", "modification-time"),
    row("ModificationDate", "modification_date", "modification-date"),
    row("ModifiedBy", "modified_by", "modified-by"),
    row("LastEDS", "last_eds", "last-eds"),
];

/// The fields of the device.
pub const DEVICE: &[FieldRow] = &[
    row("VendorName", "vendor_name", "vendor-name"),
    row("VendorNumber", "vendor_number", "vendor-number"),
    row("ProductName", "product_name", "product-name"),
    row("ProductNumber", "product_number", "product-number"),
    row("RevisionNumber", "revision_number", "revision-number"),
    row("OrderCode", "order_code", "order-code"),
    row("BaudRate_10", "baud_rates/10", "bit-rates"),
    row("BaudRate_20", "baud_rates/20", "bit-rates"),
    row("BaudRate_50", "baud_rates/50", "bit-rates"),
    row("BaudRate_125", "baud_rates/125", "bit-rates"),
    row("BaudRate_250", "baud_rates/250", "bit-rates"),
    row("BaudRate_500", "baud_rates/500", "bit-rates"),
    row("BaudRate_800", "baud_rates/800", "bit-rates"),
    row("BaudRate_1000", "baud_rates/1000", "bit-rates"),
    row("BaudRate_auto", "baud_rates/auto", "bit-rates"),
    row("SimpleBootUpMaster", "simple_boot_up_master", "simple-boot-up-master"),
    row("SimpleBootUpSlave", "simple_boot_up_slave", "simple-boot-up-slave"),
    row("Granularity", "granularity", "granularity"),
    row("DynamicChannelsSupported", "dynamic_channels_supported", "dynamic-channels-supported"),
    row("GroupMessaging", "group_messaging", "group-messaging"),
    row("NrOfRXPDO", "rpdo_count", "rpdo-count"),
    row("NrOfTXPDO", "tpdo_count", "tpdo-count"),
    row("LSS_Supported", "lss_supported", "lss-supported"),
    row("CompactPDO", "compact_pdo", "compact-pdo"),
    row("CANopenSafetySupported", "safety_supported", "safety-supported"),
];

/// The fields of the node in a DCF.
pub const COMMISSIONING: &[FieldRow] = &[
    row("NodeID", "node_id", "node-id"),
    row("NodeName", "node_name", "node-name"),
    row("NodeRefd", "node_reference_designator", "node-reference-designator"),
    row("Baudrate", "baud_rate", "baud-rate"),
    row("NetNumber", "net_number", "net-number"),
    row("NetworkName", "network_name", "network-name"),
    row("NetRefd", "net_reference_designator", "net-reference-designator"),
    row("CANopenManager", "manager", "manager"),
    row("LSS_SerialNumber", "lss_serial_number", "lss-serial-number"),
];

/// The fields of an object or entry that patches have too.
pub const ENTRY: &[FieldRow] = &[
    row("ParameterName", "name", "name"),
    row("ObjectType", "object_type", "object-type"),
    row("DataType", "data_type", "type"),
    row("AccessType", "access", "access"),
    row("DefaultValue", "default", "default"),
    row("ParameterValue", "configured/value", "value"),
    row("LowLimit", "low_limit", "min"),
    row("HighLimit", "high_limit", "max"),
    row("PDOMapping", "pdo_mapping", "map"),
    row("ObjFlags", "flags", "flags"),
    row("Denotation", "configured/denotation", "denotation"),
];

/// The other fields of an object or entry.
const ENTRY_ONLY: &[FieldRow] = &[
    row("SubNumber", "sub_number", "sub-number"),
    row("UploadFile", "configured/upload_file", "upload-file"),
    row("DownloadFile", "configured/download_file", "download-file"),
    row("Count", "count", ""),
    row("ObjExtend", "obj_extend", ""),
    row("ParamRefd", "configured/reference_designator", ""),
    row("SRDOMapping", "safety/srdo_mapping", ""),
    row("InvertedSRAD", "safety/inverted_srad", ""),
];

impl FieldRow {
    /// The field of the model.
    pub fn field(&self) -> Field {
        Field::from_name(self.eds)
    }
}

/// The rows of a part with information about the description; `None` for any other part.
pub fn facts_of(part: &Part) -> Option<&'static [FieldRow]> {
    match part {
        Part::FileInfo => Some(FILE),
        Part::DeviceInfo => Some(DEVICE),
        Part::Commissioning => Some(COMMISSIONING),
        _ => None,
    }
}

/// The rows of a part: information about the description, otherwise an entry.
fn rows_of(part: &Part) -> impl Iterator<Item = &'static FieldRow> {
    let (rows, more) = facts_of(part).map_or((ENTRY, ENTRY_ONLY), |facts| (facts, &[]));
    rows.iter().chain(more)
}

/// The field of a part at a JSON path. The path to a value also contains its kind, which is ignored.
pub fn at_json(part: &Part, path: &str) -> Option<Field> {
    let is_it = |row: &&FieldRow| {
        path.strip_prefix(row.json).is_some_and(|rest| rest.is_empty() || rest.starts_with('/'))
    };
    rows_of(part).find(is_it).map(FieldRow::field)
}

/// The key of a field of a part.
pub fn key_of(part: &Part, field: &Field) -> Option<&'static str> {
    rows_of(part).find(|row| row.eds == field.name()).map(|row| row.key).filter(|key| !key.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_of_an_eds_is_a_field_of_the_model() {
        for row in [FILE, DEVICE, COMMISSIONING, ENTRY, ENTRY_ONLY].concat() {
            assert!(
                Field::NAMED.iter().any(|(name, field)| *name == row.eds && *field == row.field()),
                "{row:?}"
            );
        }
    }
}
