//! JSON Schemas of the parts that are a single text, or a special map or list, in JSON.

use std::borrow::Cow;
use std::collections::BTreeMap;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};

use super::serial::HexText;
use super::{ClockTime, DataType, Date, Entry, Extra, Field, Subs};

/// Bytes as pairs of hex digits.
#[derive(Debug)]
pub struct HexBytes;

macro_rules! texts {
    ($($Type:ty, $name:literal, $pattern:literal;)*) => {$(
        impl JsonSchema for $Type {
            fn inline_schema() -> bool {
                true
            }

            fn schema_name() -> Cow<'static, str> {
                $name.into()
            }

            fn json_schema(_: &mut SchemaGenerator) -> Schema {
                json_schema!({ "type": "string", "pattern": $pattern })
            }
        }
    )*};
}

texts! {
    HexText<u16>, "Index", "^0x[0-9A-F]{4}$";
    HexText<u8>, "SubIndex", "^0x[0-9A-F]{2}$";
    HexBytes, "HexBytes", "^([0-9A-F]{2})*$";
    DataType, "DataType", "^([A-Z][A-Z0-9_]*|0x[0-9A-F]{4})$";
    Date, "Date", "^[0-9]{4}-[0-9]{2}-[0-9]{2}$";
    ClockTime, "ClockTime", "^[0-9]{2}:[0-9]{2}(:[0-9]{2}(\\.[0-9]{1,9})?(Z|[+-][0-9]{2}:[0-9]{2})?)?$";
}

impl JsonSchema for Field {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "Field".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        str::json_schema(generator)
    }
}

impl JsonSchema for Subs {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "Subs".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        BTreeMap::<HexText<u8>, Entry>::json_schema(generator)
    }
}

impl JsonSchema for Extra {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "Extra".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        Vec::<(String, String)>::json_schema(generator)
    }
}
