//! View of templates/c/structs.h and structs.c: the table as an array of structures with pointers.

use std::collections::{HashMap, HashSet};

use super::words::{flags, type_name, word_type};
use crate::c_code::{bytes, number};
use crate::escape::shown;
use crate::memory::{Memory, TypeExtent};
use crate::model::DataType;
use crate::resolve::{Encoded, ValueShape, is_time};
use crate::table::{DeviceTable, Row};
use crate::{Sizes, table_size};

/// The content of the source in addition to the values.
pub(super) struct Structs<'a> {
    prefix: &'a str,
    pub(super) pools: Vec<Pool>,
    pub(super) blocks: Vec<String>,
    pub(super) rows: Vec<StructRowView<'a>>,
    /// The sizes of defaults and limits, by the index of the first object that uses them.
    taken: Vec<(u16, usize)>,
}

/// Numbers of one type used as defaults or limits, without duplicates.
pub(super) struct Pool {
    pub(super) c_type: String,
    pub(super) name: String,
    pub(super) numbers: Vec<String>,
    at: HashMap<String, usize>,
}

/// A row of the table.
pub(super) struct StructRowView<'a> {
    pub(super) row: &'a Row,
    pub(super) type_: &'static str,
    pub(super) flags: String,
    pub(super) data: String,
    pub(super) low: String,
    pub(super) high: String,
    pub(super) default: String,
}

impl<'a> Structs<'a> {
    pub(super) fn new(table: &'a DeviceTable, prefix: &'a str, upper: &str) -> Self {
        let (pools, blocks, taken) = (Vec::new(), Vec::new(), Vec::new());
        let mut structs = Self { prefix, pools, blocks, rows: Vec::new(), taken };
        structs.rows = table.rows.iter().map(|row| row_view(table, row, upper, &mut structs)).collect();
        structs
    }

    /// The address of a number.
    fn number(&mut self, index: u16, word: u64, data_type: DataType) -> String {
        let mut c_type = word_type(data_type).to_owned();
        let text = if is_time(data_type) {
            c_type = format!("{}_time_t", self.prefix);
            format!("{{0x{:07X}u, {}u}}", word & 0x0FFF_FFFF, (word >> 32) & 0xFFFF)
        } else if data_type == DataType::BOOLEAN {
            (if word == 0 { "false" } else { "true" }).to_owned()
        } else {
            number(word, data_type).unwrap_or_else(|| {
                // not finite: stored as bits
                c_type = if data_type == DataType::REAL32 { "uint32_t" } else { "uint64_t" }.to_owned();
                format!("UINT64_C(0x{word:X})")
            })
        };
        let what = if is_time(data_type) { "time" } else { c_type.trim_end_matches("_t") };
        let name = format!("{}_{what}_values", self.prefix);
        let at = self.pools.iter().position(|pool| pool.c_type == c_type).unwrap_or_else(|| {
            let (numbers, at) = (Vec::new(), HashMap::new());
            self.pools.push(Pool { c_type, name, numbers, at });
            self.pools.len() - 1
        });
        let pool = &mut self.pools[at];
        let next = pool.numbers.len();
        let number = *pool.at.entry(text.clone()).or_insert(next);
        if number == next {
            pool.numbers.push(text);
            let is_number = !is_time(data_type);
            let size = if is_number { TypeExtent::of_c(&pool.c_type) } else { TypeExtent::TIME }.size;
            self.taken.push((index, size));
        }
        format!("&{}[{number}]", pool.name)
    }

    /// The address of a value that is not a number.
    fn block(&mut self, row: &Row, value: &[u8]) -> String {
        let name = format!("{}_D{:04X}_{:02X}", self.prefix, row.index, row.sub);
        let (size, text) = (value.len(), bytes(value));
        self.blocks.push(match row.resolved.shape {
            ValueShape::Block(_) => {
                self.taken.push((row.index, size));
                format!("static const uint8_t {name}[{size}] = {text};")
            }
            _ => {
                let room = size.max(1); // C has no empty arrays
                self.taken.push((row.index, TypeExtent::behind_length(room).size));
                format!("static const struct {{ uint16_t length; uint8_t bytes[{room}]; }} {name} = {{{size}u, {text}}};")
            }
        });
        format!("&{name}")
    }

    fn datum(&mut self, row: &Row, datum: &Encoded) -> String {
        match (datum, row.resolved.shape) {
            (Encoded::Word(word) | Encoded::Formula(word), ValueShape::Word(data_type)) => {
                self.number(row.index, *word, data_type)
            }
            (Encoded::Bytes(bytes), _) => self.block(row, bytes),
            _ => "NULL".to_owned(), // numbers always have the shape of a number
        }
    }
}

/// Computes the size of the table.
pub(super) fn size(table: &DeviceTable, prefix: &str, names: bool) -> Sizes {
    let mut tally = table_size::tally(table);
    let mut texts = HashSet::new();
    let numbers = [TypeExtent::HALF, TypeExtent::BYTE, TypeExtent::BYTE, TypeExtent::BYTE, TypeExtent::HALF];
    let pointers = [TypeExtent::POINTER; 5];
    let entry =
        TypeExtent::structure(numbers.into_iter().chain(pointers.into_iter().skip(usize::from(!names))));
    for row in &table.rows {
        tally.of(row.index, Memory::Flash, entry.size);
        let text = shown(&row.name);
        if names && texts.insert(text.clone()) {
            tally.of(row.index, Memory::Flash, text.len() + 1);
        }
    }
    for (index, bytes) in Structs::new(table, prefix, "").taken {
        tally.of(index, Memory::Flash, bytes);
    }
    let mut gaps = table_size::ram(table);
    for field in &table.fields {
        let size = field.extent().size;
        gaps -= size;
        tally.of(table.rows[field.rows.start].index, Memory::Zeroed, size);
    }
    tally.rest(Memory::Zeroed, gaps); // includes the node-ID
    tally.report(COUNTED)
}

/// The content that the sizes include.
const COUNTED: &str = "the tables, names and values, on a processor of 32 bits; without code";

fn row_view<'a>(
    table: &DeviceTable,
    row: &'a Row,
    upper: &str,
    constants: &mut Structs<'_>,
) -> StructRowView<'a> {
    let resolved = &row.resolved;
    let flags = flags(row.flags().filter(|flag| !matches!(*flag, "LOW" | "HIGH")), upper);
    let served =
        resolved.shape.size() == 0 && matches!(resolved.shape, ValueShape::Bytes(DataType::DOMAIN, _));
    let default = if served { "NULL".to_owned() } else { constants.datum(row, &resolved.default) };
    let mut limit =
        |limit: Option<&Encoded>| limit.map_or("NULL".to_owned(), |limit| constants.datum(row, limit));
    let (low, high) = (limit(resolved.low.as_ref()), limit(resolved.high.as_ref()));
    let data = match &row.slot {
        Some(slot) => format!("&{}_data.{}", constants.prefix, table.place(slot)),
        None if served => "NULL".to_owned(),
        None => format!("(void *){default}"),
    };
    StructRowView { row, type_: type_name(resolved.shape), flags, data, low, high, default }
}
