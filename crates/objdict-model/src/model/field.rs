//! The names of the fields of the model.

use std::borrow::Cow;

macro_rules! fields {
    ($($name:ident $text:literal,)*) => {
        /// A field of a part of the model. The names are the keys of CiA 306-1, the common vocabulary, for
        /// descriptions of all formats.
        #[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Field {
            $(#[doc = concat!("`", $text, "`.")] $name,)*
            /// A numbered key: the `3` of `3=0x1018` in a list.
            Item(u32),
            /// Any other key, such as `Dummy0005`, `Line3` or a vendor key.
            Named(Box<str>),
        }

        impl Field {
            /// Every field with a fixed name.
            pub const NAMED: &'static [(&'static str, Field)] = &[$(($text, Field::$name)),*];

            /// The name in the spelling of CiA 306-1.
            pub fn name(&self) -> Cow<'_, str> {
                match self {
                    $(Self::$name => Cow::Borrowed($text),)*
                    Self::Item(number) => Cow::Owned(number.to_string()),
                    Self::Named(name) => Cow::Borrowed(name),
                }
            }
        }
    };
}

fields! {
    FileName "FileName",
    FileVersion "FileVersion",
    FileRevision "FileRevision",
    EdsVersion "EDSVersion",
    Description "Description",
    CreationTime "CreationTime",
    CreationDate "CreationDate",
    CreatedBy "CreatedBy",
    ModificationTime "ModificationTime",
    ModificationDate "ModificationDate",
    ModifiedBy "ModifiedBy",
    LastEds "LastEDS",
    VendorName "VendorName",
    VendorNumber "VendorNumber",
    ProductName "ProductName",
    ProductNumber "ProductNumber",
    RevisionNumber "RevisionNumber",
    OrderCode "OrderCode",
    BaudRate10 "BaudRate_10",
    BaudRate20 "BaudRate_20",
    BaudRate50 "BaudRate_50",
    BaudRate125 "BaudRate_125",
    BaudRate250 "BaudRate_250",
    BaudRate500 "BaudRate_500",
    BaudRate800 "BaudRate_800",
    BaudRate1000 "BaudRate_1000",
    BaudRateAuto "BaudRate_auto",
    SimpleBootUpMaster "SimpleBootUpMaster",
    SimpleBootUpSlave "SimpleBootUpSlave",
    Granularity "Granularity",
    DynamicChannelsSupported "DynamicChannelsSupported",
    GroupMessaging "GroupMessaging",
    NrOfRxPdo "NrOfRXPDO",
    NrOfTxPdo "NrOfTXPDO",
    LssSupported "LSS_Supported",
    CompactPdo "CompactPDO",
    CanOpenSafetySupported "CANopenSafetySupported",
    Lines "Lines",
    SupportedObjects "SupportedObjects",
    NrOfEntries "NrOfEntries",
    ParameterName "ParameterName",
    ObjectType "ObjectType",
    DataType "DataType",
    LowLimit "LowLimit",
    HighLimit "HighLimit",
    AccessType "AccessType",
    DefaultValue "DefaultValue",
    PdoMapping "PDOMapping",
    ObjFlags "ObjFlags",
    SubNumber "SubNumber",
    CompactSubObj "CompactSubObj",
    SrdoMapping "SRDOMapping",
    InvertedSrad "InvertedSRAD",
    ParameterValue "ParameterValue",
    Denotation "Denotation",
    UploadFile "UploadFile",
    DownloadFile "DownloadFile",
    ParamRefd "ParamRefd",
    ObjectLinks "ObjectLinks",
    Count "Count",
    ObjExtend "ObjExtend",
    ProductVersion "ProductVersion",
    ProductRevision "ProductRevision",
    NodeId "NodeID",
    NodeName "NodeName",
    NodeRefd "NodeRefd",
    Baudrate "Baudrate",
    NetNumber "NetNumber",
    NetworkName "NetworkName",
    NetRefd "NetRefd",
    CanOpenManager "CANopenManager",
    LssSerialNumber "LSS_SerialNumber",
    NrOfSeg "NrOfSeg",
    Items "Items",
    Name "Name",
    Command "Command",
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
