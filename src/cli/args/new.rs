//! The arguments of `objdict new`.

use std::path::PathBuf;

use clap::ValueEnum;

use crate::format::input::FileKind;
use crate::model::Date;
use crate::scaffold::{EncoderClass, MAX_ANALOG, MAX_DIGITAL};

#[derive(Debug, clap::Args)]
pub(in crate::cli) struct NewArgs {
    /// The file to write: .eds .xdd .json; `-` is standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
    /// The format to write [default: by the extension of the output, else eds]
    #[arg(long, value_enum, value_name = "FORMAT")]
    pub to: Option<NewFormat>,
    /// The device profile: 301, 401 or 406 [default: that of the other arguments]
    #[arg(long, value_name = "NUMBER")]
    pub profile: Option<u16>,
    /// Number of digital inputs of one bit
    #[arg(long, value_name = "N", default_value_t = 0, hide_default_value = true, value_parser = digital())]
    pub digital_inputs: u16,
    /// Number of digital outputs of one bit
    #[arg(long, value_name = "N", default_value_t = 0, hide_default_value = true, value_parser = digital())]
    pub digital_outputs: u16,
    /// Number of analogue inputs of 16 bits
    #[arg(long, alias = "analogue-inputs", value_name = "N", default_value_t = 0, hide_default_value = true, value_parser = analog())]
    pub analog_inputs: u8,
    /// Number of analogue outputs of 16 bits
    #[arg(long, alias = "analogue-outputs", value_name = "N", default_value_t = 0, hide_default_value = true, value_parser = analog())]
    pub analog_outputs: u8,
    /// Class of the encoder [default: c1]
    #[arg(long, value_enum, value_name = "CLASS")]
    pub encoder_class: Option<Class>,
    /// The encoder type of CiA 406: 1 single-turn absolute rotary, 2 multi-turn absolute rotary, … 10 several sensors [default: 2]
    #[arg(long, value_name = "TYPE", value_parser = clap::value_parser!(u8).range(1..=10))]
    pub encoder_type: Option<u8>,
    /// Name of the vendor
    #[arg(long, value_name = "NAME", default_value = "Vendor", value_parser = text)]
    pub vendor_name: String,
    /// Vendor-ID assigned by CiA, such as 418 or 0x1A2
    #[arg(long, value_name = "NUMBER", value_parser = number)]
    pub vendor_id: Option<u32>,
    /// Name of the product
    #[arg(long, value_name = "NAME", default_value = "Device", value_parser = text)]
    pub product_name: String,
    /// Product code
    #[arg(long, value_name = "NUMBER", default_value = "1", value_parser = number)]
    pub product_code: u32,
    /// Revision number, with the major revision in the upper 16 bits
    #[arg(long, value_name = "NUMBER", default_value = "0x00010000", value_parser = number)]
    pub revision: u32,
    /// Author of the description [default: the vendor]
    #[arg(long, value_name = "NAME", value_parser = text)]
    pub author: Option<String>,
    /// Date of the description, such as 2026-11-21 [default: SOURCE_DATE_EPOCH, else now]
    #[arg(long, value_name = "DATE", value_parser = date)]
    pub date: Option<Date>,
    /// Replace an existing file
    #[arg(long, alias = "force")]
    pub overwrite: bool,
}

/// A format of new descriptions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum NewFormat {
    Eds,
    Xdd,
    Json,
}

impl From<NewFormat> for FileKind {
    fn from(format: NewFormat) -> Self {
        match format {
            NewFormat::Eds => Self::Eds,
            NewFormat::Xdd => Self::Xdd,
            NewFormat::Json => Self::Json,
        }
    }
}

/// A class of encoders, as an argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum Class {
    /// Position and its description
    C1,
    /// Also scaling, preset, alarms and diagnosis
    C2,
}

impl From<Class> for EncoderClass {
    fn from(class: Class) -> Self {
        match class {
            Class::C1 => Self::C1,
            Class::C2 => Self::C2,
        }
    }
}

fn digital() -> clap::builder::RangedI64ValueParser<u16> {
    clap::value_parser!(u16).range(0..=i64::from(MAX_DIGITAL))
}

fn analog() -> clap::builder::RangedI64ValueParser<u8> {
    clap::value_parser!(u8).range(0..=i64::from(MAX_ANALOG))
}

/// A number in decimal or, behind `0x`, in hexadecimal.
fn number(text: &str) -> Result<u32, String> {
    let number = match text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")) {
        Some(digits) => u32::from_str_radix(digits, 16).ok(),
        None => text.parse().ok(),
    };
    number.ok_or_else(|| "expected a number of 32 bits such as 418 or 0x1A2".to_owned())
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

fn date(text: &str) -> Result<Date, String> {
    Date::from_iso(text).ok_or_else(|| "expected a date such as 2026-11-21".to_owned())
}
