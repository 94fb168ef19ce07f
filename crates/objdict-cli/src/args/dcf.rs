//! The arguments of `objdict dcf`.

use std::ops::RangeInclusive;
use std::path::PathBuf;

use clap::{Subcommand, ValueEnum};

use super::network::AllowedPathArgs;
use super::report::PlainFormat;
use crate::input::{ExpandArgs, InputArgs};
use crate::values::{node_id, one_of};
use objdict_node::concise::BlobSpelling;
use objdict_node::download::Order;

#[derive(Debug, clap::Args)]
pub(crate) struct DcfArgs {
    #[command(subcommand)]
    pub command: DcfCommand,
}

#[derive(Debug, Subcommand)]
#[command(defer = true)]
pub(crate) enum DcfCommand {
    /// Create a concise DCF from a DCF, XDC or text
    ///
    /// Verifies the stream like `verify`. If the node would reject it, nothing is written and the exit code is 1.
    Pack(PackArgs),
    /// Write a stream as text, one download per line, to review, edit and pack again
    Unpack(UnpackArgs),
    /// Compare two streams
    ///
    /// Exits with 1 if they differ. `objdict diff` compares the descriptions of devices.
    Diff(DcfDiffArgs),
    /// Verify a stream against the description of the node
    ///
    /// Shows the first write that the node would reject, with its offset, and then all others. Exits with 1 if there are any.
    Verify(VerifyArgs),
}

#[derive(Debug, clap::Args)]
pub(crate) struct PackArgs {
    /// DCF, XDC or device as JSON with the values of the node, or the text of a stream; `-` is standard input
    pub file: PathBuf,
    /// The file to write [default: standard output]
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// The format to write [default: by the extension of the output, else bin]
    #[arg(long, alias = "format", value_enum, value_name = "FORMAT")]
    pub to: Option<BlobFormat>,
    /// Write values that differ from the defaults (default)
    #[arg(long, conflicts_with_all = ["all", "pdos"])]
    pub changed: bool,
    /// Write all values
    #[arg(long, conflicts_with = "pdos")]
    pub all: bool,
    /// Write values that differ from the defaults, and the complete configuration of all PDOs
    #[arg(long)]
    pub pdos: bool,
    /// Write values of these objects only: `1017,1800,1A00`, `1400-1BFF`
    #[arg(long, value_name = "INDEXES", value_delimiter = ',', value_parser = indexes)]
    pub only: Vec<RangeInclusive<u16>>,
    /// The order of the downloads: as CiA 301 requires, or as dcfgen of lely-core writes them
    #[arg(long, value_parser = one_of(&ORDERS), default_value = "safe", hide_possible_values = true, value_name = "safe|dcfgen")]
    pub order: Order,
    /// The EDS of the node, which provides the defaults and verifies the stream
    #[arg(long, value_name = "FILE")]
    pub eds: Option<PathBuf>,
    /// The node-ID [default: from the DCF]
    #[arg(long, value_name = "N", value_parser = node_id)]
    pub node_id: Option<u8>,
    #[command(flatten)]
    pub paths: AllowedPathArgs,
    /// Write the stream even if the node would reject it
    #[arg(long)]
    pub force: bool,
    #[command(flatten)]
    pub expand: ExpandArgs,
    #[command(flatten)]
    pub input: InputArgs,
}

/// The orders of downloads.
const ORDERS: [(Order, &str, &str); 2] = [
    (Order::Safe, "safe", "The order that a node accepts by CiA 301"),
    (Order::Dcfgen, "dcfgen", "The order of dcfgen of lely-core"),
];

/// An index, or a range of them: `1400-1BFF`.
pub(crate) fn indexes(text: &str) -> Result<RangeInclusive<u16>, String> {
    let index = |text: &str| {
        let digits = text.trim().trim_start_matches("0x");
        u16::from_str_radix(digits, 16).map_err(|_| format!("`{text}` is not an index, such as `1800`"))
    };
    match text.split_once('-') {
        Some((first, last)) => Ok(index(first)?..=index(last)?),
        None => index(text).map(|index| index..=index),
    }
}

#[derive(Debug, clap::Args)]
pub(crate) struct UnpackArgs {
    /// The stream; `-` is standard input
    #[arg(value_name = "STREAM")]
    pub blob: PathBuf,
    /// The file to write, such as pump.cdcf.txt [default: standard output]
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub names: NamingArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct DcfDiffArgs {
    /// The first stream
    pub first: PathBuf,
    /// The second stream
    pub second: PathBuf,
    #[command(flatten)]
    pub names: NamingArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct VerifyArgs {
    /// The stream; `-` is standard input
    #[arg(value_name = "STREAM")]
    pub blob: PathBuf,
    /// The description of the node: EDS, DCF, XDD, XDC or a device as JSON
    #[arg(long, value_name = "FILE")]
    pub eds: PathBuf,
    /// The node-ID [default: from the DCF]
    #[arg(long, value_name = "N", value_parser = node_id)]
    pub node_id: Option<u8>,
    /// Output format
    #[arg(long, value_enum, default_value = "text")]
    pub format: PlainFormat,
    #[command(flatten)]
    pub expand: ExpandArgs,
    #[command(flatten)]
    pub input: InputArgs,
}

// What gives the entries of a stream their names and types.
#[derive(Debug, clap::Args)]
pub(crate) struct NamingArgs {
    /// The description of the node, for names, data types and meanings
    #[arg(long, value_name = "FILE")]
    pub eds: Option<PathBuf>,
    /// The node-ID [default: from the DCF]
    #[arg(long, value_name = "N", value_parser = node_id)]
    pub node_id: Option<u8>,
    #[command(flatten)]
    pub expand: ExpandArgs,
    #[command(flatten)]
    pub input: InputArgs,
}

/// A spelling of a stream, as an argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum BlobFormat {
    /// Raw bytes
    Bin,
    /// One download per line, as `unpack` writes it (`.cdcf.txt`)
    Text,
    /// Pairs of hex digits
    Hex,
    /// `const uint8_t name[]`
    C,
    /// `const NAME: [u8; N]`
    Rust,
}

impl BlobFormat {
    /// The spelling of the bytes; `None` for the text.
    pub(crate) const fn spelling(self) -> Option<BlobSpelling> {
        Some(match self {
            Self::Bin => BlobSpelling::Binary,
            Self::Text => return None,
            Self::Hex => BlobSpelling::Hex,
            Self::C => BlobSpelling::C,
            Self::Rust => BlobSpelling::Rust,
        })
    }
}
