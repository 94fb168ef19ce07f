//! `objdict modules`.

use std::io::{self, Write};

use serde::Serialize;

use super::args::{ModulesArgs, PlainFormat};
use super::ending::{Failure, Outcome};
use super::input::{Input, name_of, source_name};
use super::settings::ConfigFileArgs;
use super::stdout::Output;
use super::table::TextTable;
use objdict_model::json::Version;
use objdict_model::model::{Device, ExtensionCount, HexText, Module};

/// So many characters of a cell are shown.
const CELL: usize = 48;

pub(super) fn run(args: &ModulesArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let (_, input) = args.input.read_one(&args.file, &ConfigFileArgs::default())?;
    let file = name_of(&args.file);
    let device: &Device = match &input {
        Input::Description(description) => description.device(),
        Input::Device(device) => device,
        _ => return Err(Failure::new(format_args!("`{file}` does not describe a device"))),
    };
    let modules =
        device.modules.as_ref().map(|modules| &modules.supported).filter(|modules| !modules.is_empty());
    let Some(modules) = modules else {
        return Err(Failure::new(format_args!("`{file}` has no modules"))
            .help("only the description of a coupler lists them, in `[SupportedModules]`"));
    };
    let connected = device.modules.as_ref().and_then(|modules| modules.connected.as_deref());
    let rows: Vec<ModuleJson<'_>> =
        modules.iter().map(|(&number, module)| row(number, module, connected)).collect();
    match args.format {
        PlainFormat::Text => text(&rows, out)?,
        PlainFormat::Json => {
            let file = source_name(&args.file);
            let document = ModulesJson { version: Version, file: &file, connected, modules: rows };
            out.pretty_json(&document)?;
        }
    }
    Ok(Outcome::Clean)
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct ModulesJson<'a> {
    /// The version of the document.
    version: Version<1>,
    /// The file as it was given.
    file: &'a str,
    /// The numbers of the modules that are plugged in, in their physical order; only of a DCF with `ConnectedModules`.
    #[serde(skip_serializing_if = "Option::is_none")]
    connected: Option<&'a [u16]>,
    /// The modules by number.
    modules: Vec<ModuleJson<'a>>,
}

/// A module.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Module"))]
struct ModuleJson<'a> {
    /// Its number, counted from 1.
    number: u16,
    /// The product name; empty if missing.
    product_name: &'a str,
    /// The order code; empty if missing.
    order_code: &'a str,
    /// Objects that are there once.
    fixed: Vec<HexText<u16>>,
    /// What each module adds.
    adds: Vec<Added>,
    /// How many are plugged in; only of a DCF with `ConnectedModules`.
    #[serde(skip_serializing_if = "Option::is_none")]
    plugged: Option<usize>,
    /// The lines of its comments.
    comments: &'a [String],
}

/// What a module adds to an object.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Added {
    /// The index of the object.
    index: HexText<u16>,
    /// The number of sub-indexes.
    #[serde(skip_serializing_if = "Option::is_none")]
    subs: Option<u8>,
    /// The number of bits of a sub-index that modules share.
    #[serde(skip_serializing_if = "Option::is_none")]
    bits: Option<u8>,
}

fn row<'a>(number: u16, module: &'a Module, connected: Option<&[u16]>) -> ModuleJson<'a> {
    let adds = module.extensions.iter().map(|(index, extension)| {
        let (subs, bits) = match extension.count {
            Some(ExtensionCount::Subs(count)) => (Some(count), None),
            Some(ExtensionCount::SharedBits(bits)) => (None, Some(bits)),
            None => (None, None),
        };
        Added { index: HexText(*index), subs, bits }
    });
    ModuleJson {
        number,
        product_name: module.product_name.as_deref().unwrap_or_default(),
        order_code: module.order_code.as_deref().unwrap_or_default(),
        fixed: module.fixed.keys().copied().map(HexText).collect(),
        adds: adds.collect(),
        plugged: connected.map(|connected| connected.iter().filter(|&&other| other == number).count()),
        comments: &module.comments,
    }
}

fn text(rows: &[ModuleJson<'_>], out: &mut dyn Write) -> io::Result<()> {
    let mut table =
        TextTable::new(["Number", "Product", "Order code", "Adds", "Brings once", "Plugged"], CELL);
    for row in rows {
        let added = |added: &Added| match (added.subs, added.bits) {
            (Some(subs), _) => format!("{:04X} x {subs}", added.index.0),
            (None, Some(1)) => format!("{:04X} x 1 bit", added.index.0),
            (None, Some(bits)) => format!("{:04X} x {bits} bits", added.index.0),
            (None, None) => format!("{:04X}", added.index.0),
        };
        let adds: Vec<String> = row.adds.iter().map(added).collect();
        let fixed: Vec<String> = row.fixed.iter().map(|index| format!("{:04X}", index.0)).collect();
        table.row([
            row.number.to_string(),
            row.product_name.to_owned(),
            row.order_code.to_owned(),
            adds.join(", "),
            fixed.join(", "),
            row.plugged.map_or(String::new(), |count| count.to_string()),
        ]);
    }
    table.write(out)
}
