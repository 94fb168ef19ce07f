//! Views of templates/c/od.h and od.c, with the constants of identity and services, and the members and images of storage groups.

use super::meanings::MeaningMacros;
use super::rows::Rows;
use super::structs::Structs;
use super::words::{ValueMember, field_view, hex_bytes, macro_name};
use crate::defaults::{Constant, ConstantValue, constants};
use crate::meanings::{NamedMeanings, meanings};
use crate::model::{CobId, DataType, Device};
use crate::names::NameScope;
use crate::resolve::{ValueShape, is_time};
use crate::table::{DeviceTable, Row, TableField, TableGroup, TableObject};
use crate::{Note, Options, hooks, table_size};

/// The content of the files.
pub(super) struct CView<'a> {
    /// The prefix of identifiers.
    lower: &'a str,
    /// The name of files, without its end.
    stem: &'a str,
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

/// The objects with their macros, and all macro names in use.
pub(super) fn object_views<'a>(
    table: &'a DeviceTable,
    prefix: &str,
    defaults: impl IntoIterator<Item = impl std::borrow::Borrow<DefaultMacro>>,
) -> (Vec<ObjectMacros<'a>>, NameScope) {
    let mut macros = NameScope::of_constants(MACROS);
    for item in defaults {
        macros.take(item.borrow().name.split('(').next().unwrap_or_default().to_ascii_lowercase());
    }
    for taken in stored_macros(table).into_iter().chain(hook_macros(table)) {
        macros.claim(&taken, format_args!(""));
    }
    // objects first, so that no entry has the name of an object
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
    pub(super) fn new(
        table: &'a DeviceTable,
        (prefix, stem): (&'a str, &'a str),
        facts: &'a HeaderContents,
    ) -> Self {
        let defaults: Vec<DefaultMacro> = facts.constants.iter().flat_map(item_views).collect();
        let (objects, mut macros) = object_views(table, prefix, &defaults);
        let upper = prefix.to_ascii_uppercase();
        let meanings =
            (!facts.named.is_empty()).then(|| MeaningMacros::new(&facts.named, prefix, &mut macros));
        Self {
            lower: prefix,
            stem,
            shared: Rows::new(table, &upper),
            upper,
            table,
            objects,
            names: facts.names,
            defaults,
            meanings,
            fields: members(table, prefix),
            groups: group_views(table, prefix),
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

/// A storage group.
pub(super) struct StoredGroupView<'a> {
    pub(super) group: &'a TableGroup,
    /// `od_persist_comm`.
    pub(super) lower: String,
    /// `OD_PERSIST_COMM`.
    pub(super) upper: String,
    pub(super) layout: String,
    pub(super) fields: Vec<ValueMember<'a>>,
}

/// A member of the struct of values.
pub(super) enum MemberView<'a> {
    Field(ValueMember<'a>),
    Group(StoredGroupView<'a>),
}

/// The groups of a table.
pub(super) fn group_views<'a>(table: &'a DeviceTable, prefix: &str) -> Vec<StoredGroupView<'a>> {
    (0..table.groups.len()).map(|number| group_view(table, number, prefix)).collect()
}

/// Fields and groups in ascending order of alignment after the one-byte node-ID, which needs hardly any
/// padding.
pub(super) fn members<'a>(table: &'a DeviceTable, prefix: &str) -> Vec<MemberView<'a>> {
    let fields = table
        .members(None)
        .map(|field| (field.extent().alignment, MemberView::Field(field_view(table, field, prefix))));
    let groups = (0..table.groups.len()).map(|number| {
        (table_size::group(table, number).alignment, MemberView::Group(group_view(table, number, prefix)))
    });
    let mut members: Vec<(usize, MemberView<'a>)> = fields.chain(groups).collect();
    members.sort_by_key(|(alignment, _)| *alignment); // stable sort: equal alignment stays ordered by index
    members.into_iter().map(|(_, member)| member).collect()
}

/// A group has no leading byte, so fields with the largest alignment come first.
fn group_view<'a>(table: &'a DeviceTable, number: usize, prefix: &str) -> StoredGroupView<'a> {
    let mut fields: Vec<&TableField> = table.members(Some(number)).collect();
    fields.sort_by_key(|field| std::cmp::Reverse(field.extent().alignment));
    let group = &table.groups[number];
    let lower = format!("{prefix}_{}", group.field);
    StoredGroupView {
        group,
        layout: format!("0x{:08X}", group.layout),
        upper: lower.to_ascii_uppercase(),
        lower,
        fields: fields.into_iter().map(|field| field_view(table, field, prefix)).collect(),
    }
}

/// The macros of groups in lower case, without the prefix.
pub(super) fn stored_macros(table: &DeviceTable) -> Vec<String> {
    const OF_ALL: [&str; 5] = ["image_ok", "image_length", "image_layout", "image_checksum", "image_value"];
    if table.groups.is_empty() {
        return Vec::new();
    }
    let of_group =
        |group: &TableGroup| ["image_size", "store_sub_index"].map(|name| format!("{}_{name}", group.field));
    table.groups.iter().flat_map(of_group).chain(OF_ALL.map(str::to_owned)).collect()
}

/// The part after the prefix in each name.
const OF_DEFAULTS: &str = "default_";

/// A macro.
pub(super) struct DefaultMacro {
    pub(super) meaning: String,
    /// The name after the prefix, with the parameter of a function-like macro.
    pub(super) name: String,
    pub(super) value: String,
}

/// The macros of a constant.
pub(super) fn item_views(constant: &Constant) -> Vec<DefaultMacro> {
    let Constant { name, source, meaning, value } = constant;
    let meaning = format!("{meaning} ({source})");
    let upper = format!("{OF_DEFAULTS}{name}").to_ascii_uppercase();
    let item = |name: String, meaning: String, value: String| DefaultMacro { meaning, name, value };
    match value {
        ConstantValue::CobId(cob_id) | ConstantValue::CanId(cob_id) => {
            let is_can_id = matches!(value, ConstantValue::CanId(_));
            let value = of_node(*cob_id, is_can_id.then(|| cob_id.can_id_mask()));
            vec![item(format!("{upper}(node_id)"), meaning, value)]
        }
        ConstantValue::Flag(flag) => vec![item(upper, meaning, u8::from(*flag).to_string())],
        ConstantValue::Code(number) => vec![item(upper, meaning, format!("0x{number:X}u"))],
        ConstantValue::Number(number, _) => vec![item(upper, meaning, format!("{number}u"))],
        ConstantValue::Consumers(consumers) => {
            let pairs: Vec<String> =
                consumers.iter().map(|(node, time)| format!("{{{node}u, {time}u}}")).collect();
            let count = format!("{upper}_COUNT");
            let meaning = format!("{meaning}: an initializer");
            vec![
                item(count, format!("How many nodes there are ({source})"), format!("{}u", pairs.len())),
                item(upper, meaning, format!("{{{}}}", pairs.join(", "))),
            ]
        }
    }
}

/// A number, or some bits of it, as an expression of the node-ID.
pub(super) fn of_node(cob_id: CobId, mask: Option<u32>) -> String {
    let number = cob_id.number();
    match (cob_id.depends_on_node_id(), mask) {
        (true, None) => format!("(0x{number:X}u + (uint32_t)(node_id))"),
        (true, Some(mask)) => format!("((0x{number:X}u + (uint32_t)(node_id)) & 0x{mask:X}u)"),
        (false, mask) => format!("0x{:X}u", number & mask.unwrap_or(u32::MAX)),
    }
}
