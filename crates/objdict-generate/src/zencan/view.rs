//! View of templates/zencan/device.toml.

use askama::Template;

use crate::escape::filters;

/// The file.
#[derive(Template)]
#[template(path = "zencan/device.toml", escape = "none")]
pub(super) struct Config {
    pub(super) made_by: String,
    pub(super) head: Head,
    pub(super) pdos: Pdos,
    pub(super) objects: Vec<ObjectView>,
}

/// The settings of the device.
pub(super) struct Head {
    pub(super) device_name: String,
    pub(super) hardware_version: String,
    pub(super) software_version: String,
    /// In milliseconds.
    pub(super) heartbeat_period: u64,
    pub(super) support_storage: bool,
    pub(super) vendor_id: u64,
    pub(super) product_code: u64,
    pub(super) revision_number: u64,
}

/// The PDOs.
pub(super) struct Pdos {
    pub(super) num_rpdo: u16,
    pub(super) num_tpdo: u16,
    pub(super) pdos: Vec<Pdo>,
}

/// The initial state of a PDO.
pub(super) struct Pdo {
    /// `rpdo` or `tpdo`.
    pub(super) direction: &'static str,
    /// Counted from 0.
    pub(super) number: u16,
    pub(super) cob_id: u32,
    pub(super) extended: bool,
    pub(super) add_node_id: bool,
    pub(super) enabled: bool,
    pub(super) rtr_disabled: bool,
    pub(super) transmission_type: u64,
    pub(super) mappings: Vec<Mapping>,
}

/// The mapping of a PDO.
pub(super) struct Mapping {
    pub(super) index: u16,
    pub(super) sub: u8,
    pub(super) bits: u8,
}

/// An object. Names are TOML literals.
pub(super) struct ObjectView {
    pub(super) index: u16,
    pub(super) name: String,
    pub(super) kind: ObjectContent,
}

/// The content of an object.
pub(super) enum ObjectContent {
    Var(EntryView),
    Array { entry: EntryView, size: usize },
    Record(Vec<SubView>),
}

/// An entry of a record.
pub(super) struct SubView {
    pub(super) sub: u8,
    pub(super) name: String,
    /// A Rust identifier.
    pub(super) field: String,
    pub(super) entry: EntryView,
}

/// An entry, or all elements of an array.
pub(super) struct EntryView {
    pub(super) data_type: String,
    pub(super) access: &'static str,
    /// A TOML literal.
    pub(super) default: Option<String>,
    pub(super) pdo_mapping: &'static str,
    pub(super) persist: bool,
}
