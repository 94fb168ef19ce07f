//! The arguments of `objdict new`.

use std::path::PathBuf;

use super::features::FeatureArgs;
use crate::input::extensions;
use crate::values::{self, one_of};
use objdict_format::input::FileKind;
use objdict_model::model::Date;

#[derive(Debug, clap::Args)]
pub(crate) struct NewArgs {
    /// Output file; `-` is standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
    /// Output format [default: by the extension of the output, else eds]
    #[arg(long, value_parser = one_of(&KINDS), value_name = "FORMAT")]
    pub to: Option<FileKind>,
    /// CSV table of objects with the columns of `docs --to csv`, instead of the objects of a profile
    #[arg(long, value_name = "FILE", conflicts_with = "profile")]
    pub from: Option<PathBuf>,
    /// Device profile: 301, 401, 402, 404 or 406 [default: from the features]
    #[arg(long, value_name = "NUMBER")]
    pub profile: Option<u16>,
    /// Vendor name
    #[arg(long, value_name = "NAME", default_value = "Vendor", value_parser = text)]
    pub vendor_name: String,
    /// Vendor-ID assigned by CiA, such as 418 or 0x1A2
    #[arg(long, value_name = "NUMBER", value_parser = number)]
    pub vendor_id: Option<u32>,
    /// Product name
    #[arg(long, value_name = "NAME", default_value = "Device", value_parser = text)]
    pub product_name: String,
    /// Product code [default: 1, or from 1018h of the table]
    #[arg(long, value_name = "NUMBER", value_parser = number)]
    pub product_code: Option<u32>,
    /// Revision number, with the major revision in the upper 16 bits [default: 0x00010000, or from 1018h of the table]
    #[arg(long, value_name = "NUMBER", value_parser = number)]
    pub revision: Option<u32>,
    /// Author of the description [default: the vendor]
    #[arg(long, value_name = "NAME", value_parser = text)]
    pub author: Option<String>,
    /// Date of the description, such as 2026-11-21 [default: SOURCE_DATE_EPOCH, else now]
    #[arg(long, value_name = "DATE", value_parser = date)]
    pub date: Option<Date>,
    /// Replace an existing file
    #[arg(long, alias = "force")]
    pub overwrite: bool,
    #[command(flatten)]
    pub features: FeatureArgs,
}

/// The formats of new descriptions.
const KINDS: [(FileKind, &str, &str); 4] = [
    (FileKind::Eds, "eds", ""),
    (FileKind::Xdd, "xdd", ""),
    (FileKind::Toml, "toml", "Compact device source (docs/reference/device.md)"),
    (FileKind::Json, "json", ""),
];

/// The extensions of new descriptions.
pub(crate) fn outputs() -> String {
    extensions(KINDS.map(|(kind, ..)| kind))
}

/// A number in decimal or, behind `0x`, in hexadecimal.
pub(super) fn number(text: &str) -> Result<u32, String> {
    values::number(text).ok_or_else(|| "expected a number of 32 bits such as 418 or 0x1A2".to_owned())
}

/// A line of ISO 646, which every tool reads.
fn text(text: &str) -> Result<String, String> {
    if text.bytes().all(|byte| (0x20..0x7F).contains(&byte)) && text.len() <= MAX_NAME {
        Ok(text.to_owned())
    } else {
        Err(format!("expected at most {MAX_NAME} characters of ISO 646"))
    }
}

/// Characters that a name may have, so that its line stays below 255 (CiA 306-1 §4.2).
const MAX_NAME: usize = 100;

pub(super) fn date(text: &str) -> Result<Date, String> {
    Date::from_iso(text).ok_or_else(|| "expected a date such as 2026-11-21".to_owned())
}
