//! Views of the CanFestival templates.

use askama::Template;

use super::plan::Plan;
use super::positions::{Slot, Slots};
use crate::Options;
use crate::dictionary::Dictionary;
use crate::escape::filters;

/// Data common to both files.
pub(super) struct Head {
    /// The name of the node.
    node: String,
    upper: String,
    stem: String,
    made_by: String,
    product: String,
    vendor: String,
    node_id: u8,
    slave: u8,
}

/// The dictionary.
#[derive(Template)]
#[template(path = "canfestival/od.c", escape = "none")]
pub(super) struct Source<'a> {
    head: &'a Head,
    plan: &'a Plan,
    slots: &'a Slots,
    /// Whether a PDO or a mapping is missing.
    no_pdo: bool,
    no_mapping: bool,
}

/// The declarations.
#[derive(Template)]
#[template(path = "canfestival/od.h", escape = "none")]
pub(super) struct Header<'a> {
    head: &'a Head,
    plan: &'a Plan,
}

impl Head {
    pub(super) fn new(dictionary: &Dictionary<'_>, options: &Options, node: &str, stem: &str) -> Self {
        let device = dictionary.device;
        let info = device.device_info.as_ref();
        let is_manager = device.commissioning.as_ref().is_some_and(|node| node.manager == Some(true));
        Self {
            node: node.to_owned(),
            upper: node.to_ascii_uppercase(),
            stem: stem.to_owned(),
            made_by: options.made_by(),
            product: info.and_then(|info| info.product_name.clone()).unwrap_or_default(),
            vendor: info.and_then(|info| info.vendor_name.clone()).unwrap_or_default(),
            node_id: dictionary.node_id.unwrap_or(0),
            slave: u8::from(!is_manager),
        }
    }
}

impl<'a> Source<'a> {
    pub(super) fn new(head: &'a Head, plan: &'a Plan, slots: &'a Slots) -> Self {
        let has = |slot| slots.list.contains(&slot);
        Self { head, plan, slots, no_pdo: has(Slot::NoPdo), no_mapping: has(Slot::NoMapping) }
    }

    /// The position of each object.
    fn positions(&self) -> impl Iterator<Item = (usize, usize)> {
        let list = self.slots.list.iter().enumerate();
        list.filter_map(|(position, slot)| match slot {
            Slot::Object(number) => Some((position, *number)),
            _ => None,
        })
    }
}

impl<'a> Header<'a> {
    pub(super) fn new(head: &'a Head, plan: &'a Plan) -> Self {
        Self { head, plan }
    }
}
