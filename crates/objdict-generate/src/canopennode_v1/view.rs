//! Views of the templates of CANopenNode 1.3.

use askama::Template;

use super::cell::Location;
use super::plan::Plan;
use crate::Options;
use crate::dictionary::Dictionary;
use crate::escape::filters;

/// Data common to both files.
pub(super) struct Head {
    made_by: String,
    product: String,
    vendor: String,
}

/// The declarations.
#[derive(Template)]
#[template(path = "canopennode-v1/CO_OD.h", escape = "none")]
pub(super) struct Header<'a> {
    head: &'a Head,
    plan: &'a Plan,
}

/// The dictionary.
#[derive(Template)]
#[template(path = "canopennode-v1/CO_OD.c", escape = "none")]
pub(super) struct Source<'a> {
    head: &'a Head,
    plan: &'a Plan,
    /// Whether a value of bytes depends on the node-ID.
    stores_bytes: bool,
}

impl Head {
    pub(super) fn new(dictionary: &Dictionary<'_>, options: &Options) -> Self {
        let info = dictionary.device.device_info.as_ref();
        Self {
            made_by: options.made_by(),
            product: info.and_then(|info| info.product_name.clone()).unwrap_or_default(),
            vendor: info.and_then(|info| info.vendor_name.clone()).unwrap_or_default(),
        }
    }
}

impl<'a> Header<'a> {
    pub(super) fn new(head: &'a Head, plan: &'a Plan) -> Self {
        Self { head, plan }
    }
}

impl<'a> Source<'a> {
    pub(super) fn new(head: &'a Head, plan: &'a Plan) -> Self {
        let stores_bytes = plan.formulas.iter().any(|formula| formula.starts_with("CO_OD_store("));
        Self { head, plan, stores_bytes }
    }
}
