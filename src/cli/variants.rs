//! `objdict variants`.

use super::args::VariantsArgs;
use super::input::{Input, name_of, source_name};
use super::outcome::{Failure, Outcome};
use super::output::Output;
use super::table::Table;
use crate::format::Description;
use crate::format::input::Reading;
use crate::model::{Device, PdoKind};
use crate::scaffold::{self, FEATURES, FeatureValue};

/// So many characters of a cell are shown.
const CELL: usize = 100;

pub(super) fn run(args: &VariantsArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let bytes = args.size.read(&args.file)?;
    let (_, input) = Reading::default().read(&source_name(&args.file), bytes)?;
    let file = name_of(&args.file);
    let Input::Description(base) = input else {
        return Err(Failure::new(format_args!("`{file}` has no variants")).help(HELP));
    };
    let headings =
        ["Variant", "Product", "File name", "Objects", "RPDOs", "TPDOs", "Features", "Other objects"];
    let mut table = Table::new(headings, CELL);
    let rows = base.map_devices(|variant| row(base.device(), variant));
    if rows.len() == 1 {
        return Err(Failure::new(format_args!("`{file}` has no variants")).help(HELP));
    }
    rows.into_iter().for_each(|cells| table.row(cells));
    table.write(out)?;
    Ok(Outcome::Clean)
}

const HELP: &str = "only a `device.toml` with `[variant.…]` has variants";

/// What is said of the device without variants, or of a variant.
fn row(base: &Device, variant: &Description) -> [String; 8] {
    let device = variant.device();
    let product = device.device_info.as_ref().and_then(|info| info.product_number);
    let file = device.file_info.as_ref().and_then(|info| info.file_name.clone());
    [
        variant.variant().unwrap_or_default().to_owned(),
        product.map_or_else(String::new, |number| format!("0x{number:X}")),
        file.unwrap_or_default(),
        device.objects.len().to_string(),
        device.pdo_count(PdoKind::Rpdo).to_string(),
        device.pdo_count(PdoKind::Tpdo).to_string(),
        features(base, variant),
        other_objects(base, device),
    ]
}

/// The features of the device, or of a variant those that are different.
fn features(base: &Device, variant: &Description) -> String {
    let (_, of_base) = scaffold::infer(base);
    let (_, own) = scaffold::infer(variant.device());
    let stated = FEATURES.iter().filter_map(|feature| {
        let value = own.get(feature.word);
        let is_shown = variant.variant().is_none() || value != of_base.get(feature.word);
        Some((feature.word, value.filter(|_| is_shown)?))
    });
    let stated = stated.map(|(word, value)| match value {
        FeatureValue::Flag(flag) => format!("{word}={flag}"),
        FeatureValue::Number(number) => format!("{word}={number}"),
        FeatureValue::Name(name) => format!("{word}={name}"),
        FeatureValue::Names(names) => format!("{word}={}", names.join("+")),
    });
    stated.collect::<Vec<_>>().join(" ")
}

/// The objects that the device has and the variant has not, those that are new, and those that are different.
fn other_objects(base: &Device, device: &Device) -> String {
    let removed = base.objects.keys().filter(|index| !device.objects.contains_key(index));
    let removed = removed.map(|index| format!("-{index:04X}"));
    let other = device.objects.iter().filter_map(|(index, object)| match base.objects.get(index) {
        None => Some(format!("+{index:04X}")),
        Some(known) if known != object => Some(format!("{index:04X}")),
        Some(_) => None,
    });
    removed.chain(other).collect::<Vec<_>>().join(" ")
}
