//! Views of the `objdict-macros` templates.

use askama::Template;

use super::mapping::{PdoRow, SLOTS};
use super::{Definition, ObjectRow, Objects};
use crate::Options;
use crate::dictionary::Dictionary;
use crate::escape::filters;
use crate::model::PdoKind;

/// Data common to all files.
pub(super) struct Head {
    made_by: String,
    product: String,
    vendor: String,
}

/// The macros and the declarations.
#[derive(Template)]
#[template(path = "objdict-macros/objdict.h", escape = "none")]
pub(super) struct Header<'a> {
    head: &'a Head,
    rows: usize,
    variables: &'a [Definition],
    rpdos: usize,
    tpdos: usize,
    slots: usize,
}

/// The dictionary.
#[derive(Template)]
#[template(path = "objdict-macros/objdict.c", escape = "none")]
pub(super) struct Source<'a> {
    head: &'a Head,
    rows: &'a [ObjectRow],
    variables: &'a [Definition],
}

/// The mapping.
#[derive(Template)]
#[template(path = "objdict-macros/mapping.c", escape = "none")]
pub(super) struct Mapping<'a> {
    head: &'a Head,
    rpdos: Vec<&'a PdoRow>,
    tpdos: Vec<&'a PdoRow>,
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

fn of(pdos: &[PdoRow], kind: PdoKind) -> Vec<&PdoRow> {
    pdos.iter().filter(|pdo| pdo.kind == kind).collect()
}

impl<'a> Header<'a> {
    pub(super) fn new(head: &'a Head, objects: &'a Objects, pdos: &[PdoRow]) -> Self {
        let count = |kind: PdoKind| of(pdos, kind).len();
        let (rows, variables) = (objects.rows.len(), objects.variables.as_slice());
        Self { head, rows, variables, rpdos: count(PdoKind::Rpdo), tpdos: count(PdoKind::Tpdo), slots: SLOTS }
    }
}

impl<'a> Source<'a> {
    pub(super) fn new(head: &'a Head, objects: &'a Objects) -> Self {
        Self { head, rows: &objects.rows, variables: &objects.variables }
    }
}

impl<'a> Mapping<'a> {
    pub(super) fn new(head: &'a Head, pdos: &'a [PdoRow]) -> Self {
        Self { head, rpdos: of(pdos, PdoKind::Rpdo), tpdos: of(pdos, PdoKind::Tpdo) }
    }
}
