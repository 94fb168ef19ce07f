//! The arguments of `objdict dcf`.

use std::path::PathBuf;

use clap::{Parser, Subcommand, ValueEnum};

use super::{ExpandArgs, node_id};
use crate::cli::input::InputArgs;
use crate::format::concise::BlobSpelling;

/// Make, take apart, compare and prove concise DCF
///
/// A concise DCF is what a CANopen manager keeps in 1F22h for a node: the SDO downloads that configure it, as one stream of
/// bytes (CiA 302-3). Wherever one is read, it may be the stream, its hex digits, its text (.cdcf.txt) or its JSON.
#[derive(Debug, Parser)]
pub(in crate::cli) struct DcfArgs {
    #[command(subcommand)]
    pub command: DcfCommand,
}

#[derive(Debug, Subcommand)]
pub(in crate::cli) enum DcfCommand {
    Pack(PackArgs),
    Unpack(UnpackArgs),
    Diff(DcfDiffArgs),
    Verify(VerifyArgs),
}

/// Make the stream of a DCF or XDC, or of a text
///
/// What is made is verified as `verify` does it; a stream that a node refuses is not written, and the exit code is 1.
#[derive(Debug, Parser)]
pub(in crate::cli) struct PackArgs {
    /// The DCF, XDC or device as JSON whose values a node shall have, or the text of a stream; `-` is the standard input
    pub file: PathBuf,
    /// The file to write; without it the standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// How to write it
    #[arg(long, value_enum, default_value = "bin", value_name = "SPELLING")]
    pub format: BlobFormat,
    /// Write what differs from the defaults; that is what happens anyway
    #[arg(long, conflicts_with = "all")]
    pub changed: bool,
    /// Write all values, whatever the node may have
    #[arg(long)]
    pub all: bool,
    /// The description that the node comes with: its defaults count, and it is what the stream is verified against
    #[arg(long, value_name = "FILE")]
    pub eds: Option<PathBuf>,
    /// The node-ID of the node; a DCF names its own
    #[arg(long, value_name = "N", value_parser = node_id)]
    pub node_id: Option<u8>,
    /// A folder that files of DOMAINs (`DownloadFile`) may be read from, beside that of the DCF; may be given several times
    #[arg(long, value_name = "DIR")]
    pub allow_path: Vec<PathBuf>,
    /// Write the stream although a node refuses it
    #[arg(long)]
    pub force: bool,
    #[command(flatten)]
    pub expand: ExpandArgs,
    #[command(flatten)]
    pub input: InputArgs,
}

/// Write a stream as a text of one download a line, to be reviewed, edited and packed again
#[derive(Debug, Parser)]
pub(in crate::cli) struct UnpackArgs {
    /// The stream; `-` is the standard input
    pub blob: PathBuf,
    /// The file to write, such as pump.cdcf.txt; without it the standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub names: NamingArgs,
}

/// Show what two streams write differently
///
/// Exits with 1 when they are different.
#[derive(Debug, Parser)]
pub(in crate::cli) struct DcfDiffArgs {
    /// The first stream
    pub first: PathBuf,
    /// The second stream
    pub second: PathBuf,
    #[command(flatten)]
    pub names: NamingArgs,
}

/// Play a stream against a description, as the node does, and show which writes it refuses
///
/// Shows the first write that fails with its offset, then all others. Exits with 1 when there is one.
#[derive(Debug, Parser)]
pub(in crate::cli) struct VerifyArgs {
    /// The stream; `-` is the standard input
    pub blob: PathBuf,
    /// The description of the node: EDS, DCF, XDD, XDC or a device as JSON
    #[arg(long, value_name = "FILE")]
    pub eds: PathBuf,
    /// The node-ID of the node; a DCF names its own
    #[arg(long, value_name = "N", value_parser = node_id)]
    pub node_id: Option<u8>,
    /// How to write what is found
    #[arg(long, value_enum, default_value = "text")]
    pub format: VerdictFormat,
    #[command(flatten)]
    pub expand: ExpandArgs,
    #[command(flatten)]
    pub input: InputArgs,
}

/// What gives the entries of a stream their names and types.
#[derive(Debug, clap::Args)]
pub(in crate::cli) struct NamingArgs {
    /// The description of the node, for names, data types and meanings
    #[arg(long, value_name = "FILE")]
    pub eds: Option<PathBuf>,
    /// The node-ID of the node; a DCF names its own
    #[arg(long, value_name = "N", value_parser = node_id)]
    pub node_id: Option<u8>,
    #[command(flatten)]
    pub expand: ExpandArgs,
    #[command(flatten)]
    pub input: InputArgs,
}

/// A spelling of a stream, as an argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum BlobFormat {
    /// The bytes
    Bin,
    /// Pairs of hex digits
    Hex,
    /// `const uint8_t name[]`
    C,
    /// `const NAME: [u8; N]`
    Rust,
}

impl From<BlobFormat> for BlobSpelling {
    fn from(format: BlobFormat) -> Self {
        match format {
            BlobFormat::Bin => Self::Binary,
            BlobFormat::Hex => Self::Hex,
            BlobFormat::C => Self::C,
            BlobFormat::Rust => Self::Rust,
        }
    }
}

/// How what is found is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum VerdictFormat {
    /// For people
    Text,
    /// For programs: one JSON document (docs/json.md)
    Json,
}
