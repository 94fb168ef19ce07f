//! View of storage groups in C: members of the struct of values, and functions for images.

use super::words::{ValueMember, field_view};
use crate::table::{DeviceTable, TableField, TableGroup};
use crate::table_size;

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
pub(super) fn macros(table: &DeviceTable) -> Vec<String> {
    const OF_ALL: [&str; 5] = ["image_ok", "image_length", "image_layout", "image_checksum", "image_value"];
    if table.groups.is_empty() {
        return Vec::new();
    }
    let of_group =
        |group: &TableGroup| ["image_size", "store_sub_index"].map(|name| format!("{}_{name}", group.field));
    table.groups.iter().flat_map(of_group).chain(OF_ALL.map(str::to_owned)).collect()
}
