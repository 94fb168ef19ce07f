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
    /// Create a concise DCF
    ///
    /// Reads a DCF, XDC, device as JSON, or text. Verifies the stream like `verify`. If the node would reject it, nothing is written and
    /// the exit code is 1.
    Pack(PackArgs),
    /// Convert a concise DCF to text
    ///
    /// Writes one download per line, to review, edit and pack again. The usual extension is `.cdcf.txt`, as in `pump.cdcf.txt`.
    Unpack(UnpackArgs),
    /// Compare two concise DCFs
    ///
    /// Exits with 1 if they differ. To compare device descriptions, use `objdict diff`.
    Diff(DcfDiffArgs),
    /// Verify a concise DCF against a description
    ///
    /// Shows the first write that the node would reject, with its offset, and then all others. Exits with 1 if there are any.
    Verify(VerifyArgs),
}

#[derive(Debug, clap::Args)]
pub(crate) struct PackArgs {
    /// DCF, XDC or device as JSON with the values of the node, or the text of a concise DCF; `-` is standard input
    pub file: PathBuf,
    /// Output file [default: standard output]
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Output format [default: by the extension of the output, else bin]
    #[arg(long, alias = "format", value_enum, value_name = "FORMAT")]
    pub to: Option<BlobFormat>,
    /// Write only non-default values (default)
    #[arg(long, conflicts_with_all = ["all", "pdos"])]
    pub changed: bool,
    /// Write all values to the concise DCF, not only non-default ones
    #[arg(long, conflicts_with = "pdos")]
    pub all: bool,
    /// Write non-default values and the complete configuration of all PDOs
    #[arg(long)]
    pub pdos: bool,
    /// Objects to write exclusively: `1017,1800,1A00`, `1400-1BFF`
    #[arg(long, value_name = "INDEXES", value_delimiter = ',', value_parser = indexes)]
    pub only: Vec<RangeInclusive<u16>>,
    /// Order of the downloads: as CiA 301 requires, or as lely-core's dcfgen writes them
    #[arg(long, value_parser = one_of(&ORDERS), default_value = "safe", hide_possible_values = true, value_name = "safe|dcfgen")]
    pub order: Order,
    /// Description of the node (EDS, DCF, XDD, XDC or device as JSON), for names, types, defaults and limits
    #[arg(long, value_name = "FILE")]
    pub eds: Option<PathBuf>,
    /// Node-ID (`$NODEID` in formulas) [default: from the DCF]
    #[arg(long, value_name = "N", value_parser = node_id)]
    pub node_id: Option<u8>,
    #[command(flatten)]
    pub paths: AllowedPathArgs,
    /// Write the output despite errors
    #[arg(long)]
    pub force: bool,
    #[command(flatten)]
    pub expand: ExpandArgs,
    #[command(flatten)]
    pub input: InputArgs,
}

/// The orders of downloads.
const ORDERS: [(Order, &str, &str); 2] = [
    (Order::Safe, "safe", "The order that a node accepts according to CiA 301"),
    (Order::Dcfgen, "dcfgen", "The order of lely-core's dcfgen"),
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
    /// Concise DCF; `-` is standard input
    #[arg(value_name = "STREAM")]
    pub blob: PathBuf,
    /// Output file [default: standard output]
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub names: NamingArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct DcfDiffArgs {
    /// First concise DCF
    pub first: PathBuf,
    /// Second concise DCF
    pub second: PathBuf,
    #[command(flatten)]
    pub names: NamingArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct VerifyArgs {
    /// Concise DCF; `-` is standard input
    #[arg(value_name = "STREAM")]
    pub blob: PathBuf,
    /// Description of the node (EDS, DCF, XDD, XDC or device as JSON), for names, types, defaults and limits
    #[arg(long, value_name = "FILE")]
    pub eds: PathBuf,
    /// Node-ID (`$NODEID` in formulas) [default: from the DCF]
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
    /// Description of the node (EDS, DCF, XDD, XDC or device as JSON), for names, types, defaults and limits
    #[arg(long, value_name = "FILE")]
    pub eds: Option<PathBuf>,
    /// Node-ID (`$NODEID` in formulas) [default: from the DCF]
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
