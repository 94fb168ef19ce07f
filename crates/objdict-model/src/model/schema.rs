//! JSON Schemas of the parts that are a single string, or a special map or list, in JSON.

use std::collections::BTreeMap;

use schemars::json_schema;

use super::plain::Plain;
use super::serial::HexText;
use super::{ClockTime, DataType, Date, Entry, Extra, Field, Subs};

/// Bytes as pairs of hex digits.
#[derive(Debug)]
pub struct HexBytes;

/// Gives types an inline JSON Schema: the type, and its schema from the generator.
#[macro_export]
macro_rules! inline_schemas {
    ($($Type:ty: |$generator:pat_param| $schema:expr;)*) => {$(
        impl schemars::JsonSchema for $Type {
            fn inline_schema() -> bool {
                true
            }

            fn schema_name() -> std::borrow::Cow<'static, str> {
                stringify!($Type).into()
            }

            fn json_schema($generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
                $schema
            }
        }
    )*};
}

/// A string that matches `pattern`.
fn text(pattern: &str) -> schemars::Schema {
    json_schema!({ "type": "string", "pattern": pattern })
}

inline_schemas! {
    HexText<u16>: |_| text("^0x[0-9A-F]{4}$");
    HexText<u8>: |_| text("^0x[0-9A-F]{2}$");
    HexBytes: |_| text("^([0-9A-F]{2})*$");
    DataType: |_| text("^([A-Z][A-Z0-9_]*|0x[0-9A-F]{4})$");
    Date: |_| text("^[0-9]{4}-[0-9]{2}-[0-9]{2}$");
    ClockTime: |_| text("^[0-9]{2}:[0-9]{2}(:[0-9]{2}(\\.[0-9]{1,9})?(Z|[+-][0-9]{2}:[0-9]{2})?)?$");
    Field: |generator| str::json_schema(generator);
    Subs: |generator| BTreeMap::<HexText<u8>, Entry>::json_schema(generator);
    Extra: |generator| Vec::<(String, String)>::json_schema(generator);
    Plain<'_>: |_| json_schema!({ "type": ["boolean", "number", "string"] });
}
