//! Variables of a template: the JSON of the model, and its entries in table form.

use minijinja::Value;
use minijinja::value::Serde;
use serde::Serialize;

use crate::Options;
use crate::dictionary::{ResolvedEntry, ResolvedObject, TableDictionary};
use crate::model::{DataType, WithPlainValues};
use crate::names::{NameScope, words};
use crate::resolve::Encoded;

/// Version of the JSON names.
const VERSION: u32 = 1;

#[derive(Serialize)]
struct TemplateContext {
    version: u32,
    kind: &'static str,
    /// The JSON written by `objdict convert`.
    device: serde_json::Value,
    made_by: String,
    node_id: Option<u8>,
    entries: Vec<EntryContext>,
}

/// An entry, ready for a table.
#[derive(Serialize)]
struct EntryContext {
    index: u16,
    sub: u8,
    object: String,
    name: String,
    /// Unique among all entries.
    identifier: String,
    /// Whether it is the only entry of its object.
    single: bool,
    data_type: Option<&'static str>,
    /// The index of the data type.
    code: u16,
    /// Maximum size of a value in bytes.
    size: usize,
    access: &'static str,
    readable: bool,
    writable: bool,
    tpdo: bool,
    rpdo: bool,
    constant: bool,
    /// For integers and BOOLEAN; without the node-ID.
    value: Option<i128>,
    /// Whether to add the node-ID to the value.
    plus_node_id: bool,
    /// Little-endian; without the node-ID.
    bytes: Vec<u8>,
    low: Option<i128>,
    high: Option<i128>,
}

/// The variables of a template.
pub(super) fn of(dictionary: &TableDictionary<'_>, options: &Options) -> Result<Value, serde_json::Error> {
    let mut scope = NameScope::of_lower_case("");
    let mut entries = Vec::new();
    dictionary.entries().for_each(|(object, entry)| entries.push(context(&mut scope, object, entry)));
    Ok(Value::from(Serde(TemplateContext {
        version: VERSION,
        kind: "device",
        device: serde_json::to_value(WithPlainValues(dictionary.device))?,
        made_by: options.made_by(),
        node_id: dictionary.node_id,
        entries,
    })))
}

fn context(scope: &mut NameScope, object: &ResolvedObject<'_>, entry: &ResolvedEntry<'_>) -> EntryContext {
    let resolved = &entry.resolved;
    let or = |words: String, number: String| if words.is_empty() { format!("x{number}") } else { words };
    let index = format!("{:04x}", object.index);
    let object_words = or(words(&object.name), index.clone());
    let single = object.is_single();
    let identifier = if single {
        scope.claim(&object_words, format_args!("{index}"))
    } else {
        let sub = format!("{:02x}", entry.sub);
        let entry_words = or(words(&entry.name), sub.clone());
        scope.claim(&format!("{object_words}_{entry_words}"), format_args!("{index}_{sub}"))
    };
    let size = resolved.shape.size();
    let data_type = resolved.shape.data_type().or(entry.entry.data_type).unwrap_or(DataType(0));
    let number = |datum: &Encoded| match datum {
        Encoded::Word(word) | Encoded::Formula(word) => integer(data_type, *word),
        Encoded::Bytes(_) => None,
    };
    EntryContext {
        index: object.index,
        sub: entry.sub,
        object: object.object.name().to_owned(),
        name: entry.entry.name.to_string(),
        identifier,
        single,
        data_type: data_type.name(),
        code: data_type.0,
        size,
        access: resolved.access.name(),
        readable: resolved.access.is_readable(),
        writable: resolved.access.is_writable(),
        tpdo: resolved.tpdo,
        rpdo: resolved.rpdo,
        constant: resolved.constant,
        value: number(&resolved.default),
        plus_node_id: resolved.default.is_formula(),
        bytes: resolved.default.bytes_on(None, size),
        low: resolved.low.as_ref().and_then(number),
        high: resolved.high.as_ref().and_then(number),
    }
}

/// The number of an integer or BOOLEAN.
fn integer(data_type: DataType, word: u64) -> Option<i128> {
    let (low, _) = data_type.integer_range()?;
    Some(if low < 0 { i128::from(word as i64) } else { i128::from(word) }) // a signed word is sign-extended
}
