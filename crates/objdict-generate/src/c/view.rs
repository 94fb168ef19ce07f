//! View of templates/c/od.h and od.c.

use super::defaults::{DefaultMacro, item_views};
use super::meanings::MeaningMacros;
use super::rows::Rows;
use super::stored::{self, MemberView, StoredGroupView};
use super::structs::Structs;
use super::words::{hex_bytes, macro_name};
use crate::defaults::{Constant, constants};
use crate::hooks;
use crate::meanings::{NamedMeanings, meanings};
use crate::model::{DataType, Device};
use crate::names::NameScope;
use crate::resolve::{ValueShape, is_time};
use crate::table::{DeviceTable, Row, TableObject};
use crate::{Note, Options};

/// What the files have.
pub(super) struct CView<'a> {
    /// The prefix of identifiers.
    lower: &'a str,
    pub(super) upper: String,
    table: &'a DeviceTable,
    shared: Rows,
    pub(super) objects: Vec<ObjectMacros<'a>>,
    /// Whether the entries have names.
    names: bool,
    /// Macros of identity and services.
    defaults: Vec<DefaultMacro>,
    meanings: Option<MeaningMacros<'a>>,
    /// Members of the struct of values, including the structs of storage groups.
    fields: Vec<MemberView<'a>>,
    groups: Vec<StoredGroupView<'a>>,
    /// Whether an entry has a hook.
    hooks: bool,
}

include!("../../expanded/c/od.h.rs");
include!("../../expanded/c/od.c.rs");
include!("../../expanded/c/structs.h.rs");
include!("../../expanded/c/structs.c.rs");

/// Further contents of headers.
pub(super) struct HeaderContents {
    pub(super) constants: Vec<Constant>,
    pub(super) named: NamedMeanings,
    pub(super) names: bool,
}

impl HeaderContents {
    pub(super) fn new(
        device: &Device,
        table: &DeviceTable,
        options: &Options,
        notes: &mut Vec<Note>,
    ) -> Self {
        Self {
            constants: constants(device, table, notes),
            named: meanings(device, table, options, notes),
            names: options.entry_names,
        }
    }
}

/// An object with the macros for its index and its entries, in upper case without the prefix.
pub(super) struct ObjectMacros<'a> {
    pub(super) object: &'a TableObject,
    pub(super) name: String,
    /// Empty for a single value.
    pub(super) entries: Vec<(String, &'a Row)>,
}

/// The macros of the templates in lower case, without the prefix.
const MACROS: &str = "
    h c ram rom_size object_count entry_count node_id read write tpdo rpdo low high node_id_default low_node_id
    high_node_id block boolean integer8 integer16 integer24 integer32 integer40 integer48 integer56
    integer64 unsigned8 unsigned16 unsigned24 unsigned32 unsigned40 unsigned48 unsigned56 unsigned64
    real32 real64 visible_string octet_string unicode_string time_of_day time_difference domain ok
    abort_out_of_memory abort_write_only abort_read_only abort_no_object abort_length_mismatch
    abort_too_long abort_too_short abort_no_sub_index abort_invalid_value abort_too_high abort_too_low
    abort_cannot_store abort_no_data no_names no_limits no_pdo
";

/// The objects with their macros, and all macros that are taken.
pub(super) fn object_views<'a>(
    table: &'a DeviceTable,
    prefix: &str,
    defaults: impl IntoIterator<Item = impl std::borrow::Borrow<DefaultMacro>>,
) -> (Vec<ObjectMacros<'a>>, NameScope) {
    let mut macros = NameScope::of_constants(MACROS);
    for item in defaults {
        macros.take(item.borrow().name.split('(').next().unwrap_or_default().to_ascii_lowercase());
    }
    for taken in stored::macros(table).into_iter().chain(hook_macros(table)) {
        macros.claim(&taken, format_args!(""));
    }
    // objects first, so that no entry takes the name of an object
    let names: Vec<String> = table
        .objects
        .iter()
        .map(|object| {
            macro_name(&mut macros, prefix, &object.module, (format_args!("{:04x}", object.index), 4))
        })
        .collect();
    let objects = table.objects.iter().zip(names);
    let objects = objects.map(|(object, name)| object_view(table, object, name, (prefix, &mut macros)));
    (objects.collect(), macros)
}

impl<'a> CView<'a> {
    pub(super) fn new(table: &'a DeviceTable, prefix: &'a str, facts: &'a HeaderContents) -> Self {
        let defaults: Vec<DefaultMacro> = facts.constants.iter().flat_map(item_views).collect();
        let (objects, mut macros) = object_views(table, prefix, &defaults);
        let upper = prefix.to_ascii_uppercase();
        let meanings =
            (!facts.named.is_empty()).then(|| MeaningMacros::new(&facts.named, prefix, &mut macros));
        Self {
            lower: prefix,
            shared: Rows::new(table, &upper),
            upper,
            table,
            objects,
            names: facts.names,
            defaults,
            meanings,
            fields: stored::members(table, prefix),
            groups: stored::group_views(table, prefix),
            hooks: hooks::has_hooks(table),
        }
    }

    /// The lines of the bytes in flash.
    fn rom(&self) -> impl Iterator<Item = String> {
        self.table.rom.chunks(16).map(hex_bytes)
    }

    fn has_time(&self) -> bool {
        let mut shapes = self.table.rows.iter().map(|row| row.resolved.shape);
        shapes.any(|shape| matches!(shape, ValueShape::Word(data_type) if is_time(data_type)))
    }

    /// Whether there is a string, octet string or DOMAIN.
    fn has_bytes(&self) -> bool {
        self.table.rows.iter().any(|row| matches!(row.resolved.shape, ValueShape::Bytes(..)))
    }

    fn structs(&self) -> Structs<'a> {
        Structs::new(self.table, self.lower, &self.upper)
    }
}

/// Additional return codes of hooks, and macros that define hooks.
fn hook_macros(table: &DeviceTable) -> Vec<String> {
    const MACROS: &str =
        "hook weak abort_incompatible abort_hardware abort_general abort_local_control abort_device_state";
    if hooks::has_hooks(table) { MACROS.split(' ').map(str::to_owned).collect() } else { Vec::new() }
}

fn object_view<'a>(
    table: &'a DeviceTable,
    object: &'a TableObject,
    mut name: String,
    (prefix, macros): (&str, &mut NameScope),
) -> ObjectMacros<'a> {
    let rows = if object.single { &[] } else { &table.rows[object.rows.clone()] };
    let entries = rows.iter().map(|row| {
        let words = [name.trim_end_matches('_'), "_", &row.constant].concat();
        let mut name =
            macro_name(macros, prefix, &words, (format_args!("{:04x}_{:02x}", row.index, row.sub), 7));
        name.make_ascii_uppercase();
        (name, row)
    });
    let entries = entries.collect();
    name.make_ascii_uppercase();
    ObjectMacros { object, name, entries }
}
