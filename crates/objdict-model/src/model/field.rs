//! The fields of the model, with the names that people give them in files.

use std::borrow::Cow;

/// A field with its names.
#[derive(Clone, Copy, Debug)]
pub struct FieldRow {
    /// In an EDS ([`Field::name`]).
    pub eds: &'static str,
    /// In the JSON of the model, below its part.
    pub json: &'static str,
    /// In a `device.toml`, and of an entry also in a patch; empty for a field that has no key.
    pub key: &'static str,
}

/// Declares the fields in tables: each with its name in an EDS, and of those that other files name too the path in JSON and the key.
macro_rules! fields {
    ($($(#[$about:meta])* $vis:vis $TABLE:ident {
        $($name:ident $eds:literal $($json:literal $key:literal)?,)+
    })+) => {
        /// A field of a part of the model. The names are the keys of CiA 306-1, the common vocabulary, for
        /// descriptions of all formats.
        #[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Field {
            $($(#[doc = concat!("`", $eds, "`.")] $name,)+)+
            /// A numbered key: the `3` of `3=0x1018` in a list.
            Item(u32),
            /// Any other key, such as `Dummy0005`, `Line3` or one of a vendor.
            Named(Box<str>),
        }

        impl Field {
            /// Every field with a fixed name.
            pub const NAMED: &'static [(&'static str, Field)] = &[$($(($eds, Field::$name),)+)+];

            /// The name in the spelling of CiA 306-1.
            pub fn name(&self) -> Cow<'_, str> {
                match self {
                    $($(Self::$name => Cow::Borrowed($eds),)+)+
                    Self::Item(number) => Cow::Owned(number.to_string()),
                    Self::Named(name) => Cow::Borrowed(name),
                }
            }
        }

        $($(#[$about])* $vis const $TABLE: &[FieldRow] = &[$($(FieldRow { eds: $eds, json: $json, key: $key },)?)+];)+
    };
}

fields! {
    /// The fields of the file.
    pub FILE {
        FileName "FileName" "file_name" "file-name",
        FileVersion "FileVersion" "file_version" "file-version",
        FileRevision "FileRevision" "file_revision" "file-revision",
        EdsVersion "EDSVersion" "eds_version" "eds-version",
        Description "Description" "description" "description",
        CreationTime "CreationTime" "creation_time" "creation-time",
        CreationDate "CreationDate" "creation_date" "creation-date",
        CreatedBy "CreatedBy" "created_by" "created-by",
        ModificationTime "ModificationTime" "modification_time" "modification-time",
        ModificationDate "ModificationDate" "modification_date" "modification-date",
        ModifiedBy "ModifiedBy" "modified_by" "modified-by",
        LastEds "LastEDS" "last_eds" "last-eds",
    }
    /// The fields of the device.
    pub DEVICE {
        VendorName "VendorName" "vendor_name" "vendor-name",
        VendorNumber "VendorNumber" "vendor_number" "vendor-number",
        ProductName "ProductName" "product_name" "product-name",
        ProductNumber "ProductNumber" "product_number" "product-number",
        RevisionNumber "RevisionNumber" "revision_number" "revision-number",
        OrderCode "OrderCode" "order_code" "order-code",
        BaudRate10 "BaudRate_10" "baud_rates/10" "bit-rates",
        BaudRate20 "BaudRate_20" "baud_rates/20" "bit-rates",
        BaudRate50 "BaudRate_50" "baud_rates/50" "bit-rates",
        BaudRate125 "BaudRate_125" "baud_rates/125" "bit-rates",
        BaudRate250 "BaudRate_250" "baud_rates/250" "bit-rates",
        BaudRate500 "BaudRate_500" "baud_rates/500" "bit-rates",
        BaudRate800 "BaudRate_800" "baud_rates/800" "bit-rates",
        BaudRate1000 "BaudRate_1000" "baud_rates/1000" "bit-rates",
        BaudRateAuto "BaudRate_auto" "baud_rates/auto" "bit-rates",
        SimpleBootUpMaster "SimpleBootUpMaster" "simple_boot_up_master" "simple-boot-up-master",
        SimpleBootUpSlave "SimpleBootUpSlave" "simple_boot_up_slave" "simple-boot-up-slave",
        Granularity "Granularity" "granularity" "granularity",
        DynamicChannelsSupported "DynamicChannelsSupported" "dynamic_channels_supported" "dynamic-channels-supported",
        GroupMessaging "GroupMessaging" "group_messaging" "group-messaging",
        NrOfRxPdo "NrOfRXPDO" "rpdo_count" "rpdo-count",
        NrOfTxPdo "NrOfTXPDO" "tpdo_count" "tpdo-count",
        LssSupported "LSS_Supported" "lss_supported" "lss-supported",
        CompactPdo "CompactPDO" "compact_pdo" "compact-pdo",
        CanOpenSafetySupported "CANopenSafetySupported" "safety_supported" "safety-supported",
    }
    /// The fields of the node of a DCF.
    pub COMMISSIONING {
        NodeId "NodeID" "node_id" "node-id",
        NodeName "NodeName" "node_name" "node-name",
        NodeRefd "NodeRefd" "node_reference_designator" "node-reference-designator",
        Baudrate "Baudrate" "baud_rate" "baud-rate",
        NetNumber "NetNumber" "net_number" "net-number",
        NetworkName "NetworkName" "network_name" "network-name",
        NetRefd "NetRefd" "net_reference_designator" "net-reference-designator",
        CanOpenManager "CANopenManager" "manager" "manager",
        LssSerialNumber "LSS_SerialNumber" "lss_serial_number" "lss-serial-number",
    }
    /// The fields of an object or entry that patches have too.
    pub ENTRY {
        ParameterName "ParameterName" "name" "name",
        ObjectType "ObjectType" "object_type" "object-type",
        DataType "DataType" "data_type" "type",
        LowLimit "LowLimit" "low_limit" "min",
        HighLimit "HighLimit" "high_limit" "max",
        AccessType "AccessType" "access" "access",
        DefaultValue "DefaultValue" "default" "default",
        PdoMapping "PDOMapping" "pdo_mapping" "map",
        ObjFlags "ObjFlags" "flags" "flags",
        ParameterValue "ParameterValue" "configured/value" "value",
        Denotation "Denotation" "configured/denotation" "denotation",
    }
    /// The other fields of an object or entry, and fields that people do not name in files.
    pub(super) OTHER {
        Lines "Lines",
        SupportedObjects "SupportedObjects",
        NrOfEntries "NrOfEntries",
        SubNumber "SubNumber" "sub_number" "sub-number",
        CompactSubObj "CompactSubObj",
        SrdoMapping "SRDOMapping" "safety/srdo_mapping" "",
        InvertedSrad "InvertedSRAD" "safety/inverted_srad" "",
        UploadFile "UploadFile" "configured/upload_file" "upload-file",
        DownloadFile "DownloadFile" "configured/download_file" "download-file",
        ParamRefd "ParamRefd" "configured/reference_designator" "",
        ObjectLinks "ObjectLinks",
        Count "Count" "count" "",
        ObjExtend "ObjExtend" "obj_extend" "",
        ProductVersion "ProductVersion",
        ProductRevision "ProductRevision",
        NrOfSeg "NrOfSeg",
        Items "Items",
        Name "Name",
        Command "Command",
    }
}

impl Field {
    /// The field with this name, ignoring case. Digits result in an [`Item`](Self::Item), any other unknown
    /// name in a [`Named`](Self::Named).
    pub fn from_name(name: &str) -> Self {
        let fixed = Self::NAMED.iter().find(|(text, _)| text.eq_ignore_ascii_case(name));
        match fixed {
            Some((_, field)) => field.clone(),
            None => Self::item(name).unwrap_or_else(|| Self::Named(name.into())),
        }
    }

    /// The item of a decimal number without leading zero.
    pub fn item(name: &str) -> Option<Self> {
        Self::item_number(name).map(Self::Item)
    }

    /// The number of such an item.
    pub fn item_number(name: &str) -> Option<u32> {
        let plain = name.as_bytes().first().is_some_and(|first| matches!(first, b'1'..=b'9'));
        // the parser accepts a sign only as first character, which is a digit here
        if plain { name.parse().ok() } else { None }
    }
}

crate::messages! { Field: { field => "{}", field.name(); } }

impl FieldRow {
    /// The field of the model.
    pub fn field(&self) -> Field {
        Field::from_name(self.eds)
    }
}
