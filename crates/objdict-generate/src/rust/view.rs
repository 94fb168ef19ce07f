//! View of templates/rust/od.rs, with the locations of values in the byte array and the code that serves the
//! table.

use super::literal::{grouped, hex, hex_bytes, word_type};
use super::meanings::MeaningModules;
use super::objects::{ObjectModules, path};
use crate::defaults::{Constant, ConstantValue};
use crate::frames::{CarriedType, FrameField, PdoFrame};
use crate::meanings::NamedMeanings;
use crate::model::{CobId, Device};
use crate::resolve::ValueShape;
use crate::table::{DeviceTable, Row};
use crate::{Derive, GenerateError, Note, OptionValue, Options, hooks};
use objdict_device::source;

/// The file `od.rs`.
pub(super) struct RustView<'a> {
    table: &'a DeviceTable,
    /// Size of the longest value in bytes.
    max_size: usize,
    pub(super) places: ValuePlaces,
    objects: ObjectModules<'a>,
    /// Size of the longest value that a hook may reject, if an entry has one.
    hook_room: Option<usize>,
    rows: Vec<RowView<'a>>,
    rom: Vec<String>,
    /// Constants of identity and services.
    defaults: Vec<ItemView>,
    meanings: Option<MeaningModules<'a>>,
    frames: Vec<FrameView<'a>>,
    /// The communication parameters of RPDOs and of TPDOs.
    pdos: [Vec<u16>; 2],
    /// Entries of 1016h: as many heartbeats can be monitored.
    consumers: u8,
    options: &'a Options,
}

include!("../../expanded/rust/od.rs.rs");

/// A row of the table.
struct RowView<'a> {
    row: &'a Row,
    type_: &'static str,
    flags: String,
    /// The location in RAM; 0 for none.
    ram: usize,
}

impl<'a> RustView<'a> {
    pub(super) fn new(
        device: &Device,
        table: &'a DeviceTable,
        options: &'a Options,
        frames: &'a [PdoFrame],
        constants: &[Constant],
        named: &'a NamedMeanings,
    ) -> Result<Self, GenerateError> {
        let places = ValuePlaces::new(table)?;
        let rows = table.rows.iter().zip(&places.rows).map(|(row, &ram)| row_view(row, ram)).collect();
        let derives = derive_lines(&options.derives, "    ");
        Ok(Self {
            table,
            max_size: table.rows.iter().map(|row| row.resolved.shape.size()).max().unwrap_or(0),
            objects: ObjectModules::new(device, table),
            places,
            hook_room: (options.runtime || hooks::has_hooks(table)).then(|| hooks::room(table)),
            rows,
            rom: table.rom.chunks(16).map(hex_bytes).collect(),
            defaults: constants.iter().map(item_view).collect(),
            meanings: (!named.is_empty()).then(|| MeaningModules::new(named, derives)),
            frames: frames.iter().map(|frame| FrameView::new(table, frame)).collect(),
            pdos: [0x1400..=0x15FF, 0x1800..=0x19FF].map(|indexes| {
                let cob_ids = table.rows.iter().filter(|row| row.sub == 1 && indexes.contains(&row.index));
                cob_ids.map(|row| row.index).collect()
            }),
            consumers: table
                .rows
                .iter()
                .filter(|row| row.index == 0x1016)
                .map(|row| row.sub)
                .max()
                .unwrap_or(0),
            options,
        })
    }

    /// The code that serves the table.
    fn code(&self) -> String {
        let parts = PastedParts {
            stored: !self.table.groups.is_empty(),
            hooks: self.hook_room.is_some(),
            pdo: !self.frames.is_empty(),
            derives: &self.options.derives,
        };
        parts.text()
    }

    /// A list of indexes as an array of Rust.
    fn indexes(indexes: &[u16]) -> String {
        let indexes: Vec<String> = indexes.iter().map(|index| format!("0x{index:04X}")).collect();
        format!("[{}]", indexes.join(", "))
    }

    /// The attribute lines after the standard derives, indented.
    fn derives(&self, indent: &str) -> String {
        derive_lines(&self.options.derives, indent)
    }
}

/// The size of the largest image of a storage group in bytes, with the two bytes of the node-ID that `Stored` adds.
fn largest_image(table: &DeviceTable) -> usize {
    table.groups.iter().map(|group| group.image_size + 2).max().unwrap_or(0)
}

/// One line per crate with derived traits.
fn derive_lines(derives: &[Derive], indent: &str) -> String {
    let line = |(derive, traits)| derives.contains(&derive).then(|| format!("\n{indent}#[derive({traits})]"));
    let all = [(Derive::Defmt, "defmt::Format"), (Derive::Serde, "serde::Serialize, serde::Deserialize")];
    all.into_iter().filter_map(line).collect()
}

fn row_view(row: &Row, ram: usize) -> RowView<'_> {
    let type_ = match row.resolved.shape {
        ValueShape::Word(data_type) | ValueShape::Bytes(data_type, _) => data_type.name().unwrap_or("BLOCK"),
        ValueShape::Block(_) => "BLOCK",
    };
    let flags: Vec<&str> = row.flags().collect();
    let flags = if flags.is_empty() { "0".to_owned() } else { flags.join(" | ") };
    RowView { row, type_, flags, ram }
}

/// The limit of offsets in rows, which have 19 bits.
const LARGEST: usize = 1 << 19;

/// The locations of all values.
pub(super) struct ValuePlaces {
    /// The offset of each row; 0 for a value in flash.
    pub(super) rows: Vec<usize>,
    /// The first offset of each storage group.
    pub(super) groups: Vec<usize>,
    /// Size of the array, with the node-ID.
    pub(super) total: usize,
}

impl ValuePlaces {
    pub(super) fn new(table: &DeviceTable) -> Result<Self, GenerateError> {
        let mut places = Self { rows: vec![0; table.rows.len()], groups: Vec::new(), total: 1 };
        places.put(table, None);
        for group in 0..table.groups.len() {
            places.groups.push(places.total);
            places.put(table, Some(group));
        }
        if places.total.max(table.rom.len()) > LARGEST {
            let text = format!("the tables are larger than {LARGEST} bytes");
            return Err(GenerateError::Inexpressible(vec![Note::new(crate::model::Place::device(), text)]));
        }
        Ok(places)
    }

    fn put(&mut self, table: &DeviceTable, group: Option<usize>) {
        for field in table.members(group) {
            for row in field.rows.clone() {
                self.rows[row] = self.total;
                self.total += value_size(field.shape);
            }
        }
    }
}

/// Size of a value in the array: a string follows its length.
pub(super) fn value_size(shape: ValueShape) -> usize {
    crate::stored::image_length(shape)
}

/// The parts of the code that a table needs.
#[derive(Clone, Copy)]
pub(super) struct PastedParts<'a> {
    pub(super) stored: bool,
    pub(super) hooks: bool,
    pub(super) pdo: bool,
    pub(super) derives: &'a [Derive],
}

impl PastedParts<'_> {
    /// The text of the parts.
    pub(super) fn text(self) -> String {
        let has = |derive| self.derives.contains(&derive);
        let optional = [
            (self.stored, source::STORED),
            (self.hooks, source::HOOKS),
            (self.pdo, source::PDO),
            (has(Derive::Defmt), source::DEFMT),
            (has(Derive::Serde), source::SERDE),
        ];
        let optional = optional.into_iter().filter_map(|(is_needed, text)| is_needed.then_some(text));
        let texts = source::TABLE.iter().copied().chain(optional).map(|text| self.joined(text));
        texts.collect::<Vec<_>>().join("\n")
    }

    /// A file without its imports from the others, and with the requested derives.
    fn joined(self, text: &str) -> String {
        let mut joined = String::with_capacity(text.len());
        let mut is_import = false;
        for line in text.lines() {
            is_import |= line.starts_with("use super::");
            if is_import {
                is_import = !line.ends_with(';');
                continue;
            }
            let Some(condition) = line.trim_start().strip_prefix("#[cfg_attr(feature = \"") else {
                joined.push_str(line);
                joined.push('\n');
                continue;
            };
            let names = Derive::ALL.iter().filter(|(derive, ..)| self.derives.contains(derive));
            let derive = names
                .map(|(_, name, _)| condition.strip_prefix(name))
                .find_map(|rest| rest?.strip_prefix("\", ")?.strip_suffix(")]"));
            if let Some(derive) = derive {
                let indent = &line[..line.len() - line.trim_start().len()];
                joined.push_str(&format!("{indent}#[{derive}]\n"));
            }
        }
        joined.trim().to_owned() + "\n"
    }
}

/// A constant or a function.
pub(super) struct ItemView {
    /// Its meaning and its source.
    pub(super) meaning: String,
    /// For a function, whether it uses its argument.
    pub(super) function: Option<bool>,
    pub(super) name: String,
    pub(super) type_: String,
    /// An expression.
    pub(super) value: String,
}

pub(super) fn item_view(constant: &Constant) -> ItemView {
    let Constant { name, source, meaning, value } = constant;
    let of_cob_id =
        |cob_id: CobId, mask| (Some(cob_id.depends_on_node_id()), "u32".to_owned(), of_node(cob_id, mask));
    let (function, type_, value) = match value {
        ConstantValue::CobId(cob_id) => of_cob_id(*cob_id, None),
        ConstantValue::CanId(cob_id) => of_cob_id(*cob_id, Some(cob_id.can_id_mask())),
        ConstantValue::Flag(flag) => (None, "bool".to_owned(), flag.to_string()),
        ConstantValue::Code(number) => (None, "u32".to_owned(), hex((*number).into())),
        ConstantValue::Number(number, bits) => (None, format!("u{bits}"), grouped(&number.to_string(), 3)),
        ConstantValue::Consumers(consumers) => {
            let list: Vec<String> =
                consumers.iter().map(|(node, time)| format!("({node}, {time})")).collect();
            (None, format!("[(u8, u16); {}]", list.len()), format!("[{}]", list.join(", ")))
        }
    };
    let name = if function.is_some() { name.clone() } else { name.to_ascii_uppercase() };
    let source = if source.starts_with("CiA") { format!("`CiA` {}", &source[4..]) } else { source.clone() };
    ItemView { meaning: format!("{meaning} ({source})"), function, name, type_, value }
}

/// A number, or some bits of it, as an expression of the node-ID.
pub(super) fn of_node(cob_id: CobId, mask: Option<u32>) -> String {
    let number = cob_id.number();
    match (cob_id.depends_on_node_id(), mask) {
        (true, None) => format!("{} + node_id as u32", hex(number.into())),
        (true, Some(mask)) => format!("({} + node_id as u32) & {}", hex(number.into()), hex(mask.into())),
        (false, mask) => hex((number & mask.unwrap_or(u32::MAX)).into()),
    }
}

/// A frame.
pub(super) struct FrameView<'a> {
    pub(super) frame: &'a PdoFrame,
    /// The COB-ID as an expression of `node_id`.
    pub(super) cob_id: Option<String>,
    /// Whether a field is stored there.
    pub(super) writes_data: bool,
    pub(super) fields: Vec<FieldView<'a>>,
}

/// A field of a frame.
pub(super) struct FieldView<'a> {
    pub(super) field: &'a FrameField,
    pub(super) row: &'a Row,
    pub(super) type_: String,
    /// The value in the dictionary.
    pub(super) load: String,
    /// The statement that stores it there; `None` for constants.
    pub(super) store: Option<String>,
}

impl<'a> FrameView<'a> {
    pub(super) fn new(table: &'a DeviceTable, frame: &'a PdoFrame) -> Self {
        let fields: Vec<FieldView<'a>> = frame.fields.iter().map(|field| field_view(table, field)).collect();
        Self {
            frame,
            cob_id: frame.cob_id.map(|cob_id| of_node(cob_id, None)),
            writes_data: fields.iter().any(|field| field.store.is_some()),
            fields,
        }
    }
}

fn field_view<'a>(table: &'a DeviceTable, field: &'a FrameField) -> FieldView<'a> {
    let row = &table.rows[field.row];
    let (handle, name) = (format!("super::{}", path(table, row)), &field.name);
    let is_whole = matches!(field.carried, CarriedType::Number(_));
    let type_ = match field.carried {
        CarriedType::Number(data_type) => match word_type(data_type) {
            "Time" => "super::Time".to_owned(),
            number => number.to_owned(),
        },
        CarriedType::Bytes(length) => format!("[u8; {length}]"),
    };
    let load = match row.resolved.shape {
        _ if is_whole => format!("data.get({handle})"),
        ValueShape::Bytes(..) => format!("first(data.get({handle}))"),
        _ => format!("first(&data.get({handle}))"),
    };
    let value = match row.resolved.shape {
        _ if is_whole => format!("self.{name}"),
        ValueShape::Bytes(..) => format!("&self.{name}"),
        _ => format!("first(&self.{name})"),
    };
    let store = row.slot.map(|_| format!("data.put({handle}, {value})"));
    FieldView { field, row, type_, load, store }
}
