//! View of templates/rust/od.rs.

use super::defaults::{ItemView, item_view};
use super::literal::{hex, hex_bytes};
use super::meanings::MeaningModules;
use super::objects::ObjectModules;
use super::paste::PastedParts;
use super::pdo::FrameView;
use super::places::ValuePlaces;
use crate::defaults::Constant;
use crate::frames::PdoFrame;
use crate::hooks;
use crate::meanings::NamedMeanings;
use crate::model::Device;
use crate::resolve::ValueShape;
use crate::table::{DeviceTable, Row};
use crate::{Derive, GenerateError, Options};

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

/// The size of the largest image of a storage group in bytes.
fn largest_image(table: &DeviceTable) -> usize {
    table.groups.iter().map(|group| group.image_size).max().unwrap_or(0)
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
