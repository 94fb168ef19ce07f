//! `objdict variants`.

use std::collections::BTreeMap;
use std::io::{self, Write};

use serde::Serialize;

use super::args::{VariantsArgs, VariantsFormat};
use super::ending::{Failure, Outcome};
use super::input::{Input, name_of, source_name};
use super::stdout::Output;
use super::table::TextTable;
use objdict_document::TablePage;
use objdict_format::Description;
use objdict_format::input::Reading;
use objdict_format::scaffold;
use objdict_format::scaffold::{FEATURES, FeatureValue, Features};
use objdict_model::json::Version;
use objdict_model::model::PdoKind;

/// So many characters of a cell are shown.
const CELL: usize = 100;

const HEADINGS: [&str; 8] =
    ["Variant", "Product", "File name", "Objects", "RPDOs", "TPDOs", "Features", "Other objects"];

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct VariantsJson {
    /// The version of the document.
    version: Version<1>,
    /// The file.
    file: String,
    /// The device without variants, then its variants in the order of the file.
    variants: Vec<Variant>,
}

/// A variant of a device.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Variant {
    /// Its name; `null` for the device without variants.
    name: Option<String>,
    /// The product code.
    product_code: Option<u32>,
    /// The name of its EDS.
    file_name: Option<String>,
    /// The number of objects.
    objects: usize,
    /// The number of RPDOs.
    rpdos: usize,
    /// The number of TPDOs.
    tpdos: usize,
    /// The features of the device by name. A variant has only the features that differ.
    features: BTreeMap<&'static str, String>,
    /// Indexes of objects that only the variant has.
    added: Vec<u16>,
    /// Indexes of objects that only the device without variants has.
    removed: Vec<u16>,
    /// Indexes of objects that differ.
    different: Vec<u16>,
}

pub(super) fn run(args: &VariantsArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let bytes = args.size.read(&args.file)?;
    let (_, input) = Reading::default().read(&source_name(&args.file), bytes)?;
    let file = name_of(&args.file);
    let none = || Failure::new(format_args!("`{file}` has no variants")).help(HELP);
    let Input::Description(base) = input else { return Err(none()) };
    let (_, of_base) = scaffold::infer(base.device());
    let variants = base.map_devices(|variant| Variant::new(&base, &of_base, variant));
    if variants.len() == 1 {
        return Err(none());
    }
    match args.format {
        VariantsFormat::Text => write_table(&variants, out)?,
        VariantsFormat::Json => {
            let document = VariantsJson { version: Version, file, variants };
            out.pretty_json(&document)?;
        }
        VariantsFormat::Html => {
            let info = base.device().device_info.as_ref();
            let product = info.and_then(|info| info.product_name.as_deref()).unwrap_or(&file);
            let rows = variants.iter().map(|variant| (variant.cells().to_vec(), false)).collect();
            let summary = format!("Variants in {file}");
            let page = TablePage { file: &file, heading: product, summary, headings: &HEADINGS, rows };
            out.raw()?.write_all(page.html().as_bytes())?;
        }
    }
    Ok(Outcome::Clean)
}

const HELP: &str = "only a `device.toml` with `[variant.…]` has variants";

fn write_table(variants: &[Variant], out: &mut Output) -> io::Result<()> {
    let mut table = TextTable::new(HEADINGS, CELL);
    variants.iter().for_each(|variant| table.row(variant.cells()));
    table.write(out)
}

impl Variant {
    fn new(base: &Description, of_base: &Features, variant: &Description) -> Self {
        let device = variant.device();
        let [known, own] = [base.device(), device].map(|device| &device.objects);
        let missing_in = |one: &objdict_model::model::Objects, other: &objdict_model::model::Objects| {
            one.keys().filter(|index| !other.contains_key(index)).copied().collect()
        };
        let is_other = |index: &u16| known.get(index).is_some_and(|object| own.get(index) != Some(object));
        Self {
            name: variant.variant().map(str::to_owned),
            product_code: device.device_info.as_ref().and_then(|info| info.product_number),
            file_name: device.file_info.as_ref().and_then(|info| info.file_name.clone()),
            objects: own.len(),
            rpdos: device.pdo_count(PdoKind::Rpdo),
            tpdos: device.pdo_count(PdoKind::Tpdo),
            features: features(of_base, variant),
            added: missing_in(own, known),
            removed: missing_in(known, own),
            different: own.keys().copied().filter(is_other).collect(),
        }
    }

    /// The cells of a table, below the headings.
    fn cells(&self) -> [String; 8] {
        let marked = |mark: &'static str, indexes: &[u16]| {
            indexes.iter().map(|index| (*index, format!("{mark}{index:04X}"))).collect::<Vec<_>>()
        };
        let mut others =
            [marked("-", &self.removed), marked("+", &self.added), marked("", &self.different)].concat();
        others.sort();
        let others: Vec<String> = others.into_iter().map(|(_, text)| text).collect();
        let features: Vec<String> =
            self.features.iter().map(|(word, value)| format!("{word}={value}")).collect();
        [
            self.name.clone().unwrap_or_default(),
            self.product_code.map_or_else(String::new, |number| format!("0x{number:X}")),
            self.file_name.clone().unwrap_or_default(),
            self.objects.to_string(),
            self.rpdos.to_string(),
            self.tpdos.to_string(),
            features.join(" "),
            others.join(" "),
        ]
    }
}

/// The features of the device; of a variant, only the features that differ.
fn features(of_base: &Features, variant: &Description) -> BTreeMap<&'static str, String> {
    let own = variant.variant().map(|_| scaffold::infer(variant.device()).1);
    let stated = FEATURES.iter().filter_map(|feature| {
        let known = of_base.get(feature.word);
        let value = match &own {
            Some(own) => own.get(feature.word).filter(|value| known.as_ref() != Some(value)),
            None => known,
        };
        Some((feature.word, value?))
    });
    let stated = stated.map(|(word, value)| {
        let text = match value {
            FeatureValue::Flag(flag) => flag.to_string(),
            FeatureValue::Number(number) => number.to_string(),
            FeatureValue::Name(name) => name,
            FeatureValue::Names(names) => names.join("+"),
        };
        (word, text)
    });
    stated.collect()
}
