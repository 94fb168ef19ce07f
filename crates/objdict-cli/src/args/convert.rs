//! The arguments of `objdict convert`.

use std::path::PathBuf;

use clap::builder::{PossibleValuesParser, TypedValueParser};

use super::network::NetworkPathArgs;
use crate::canonical::CanonicalArgs;
use crate::input::{ExpandArgs, FileKind, InputArgs, extensions};
use crate::settings::ConfigFileArgs;
use crate::values::{node_id, node_name, one_of};
use crate::written_files::OverwriteArgs;
use objdict_format::XddVersion;
use objdict_model::diagnostic::series;

#[derive(Debug, clap::Args)]
pub(crate) struct ConvertArgs {
    /// Files to convert; `-` is standard input
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    #[arg(short, long, value_name = "PATH", help = output_help())]
    pub output: Vec<PathBuf>,
    #[command(flatten)]
    pub overwrite: OverwriteArgs,
    /// Output format [default: by the extension of the output]
    #[arg(long, value_name = "FORMAT", value_parser = written_kinds())]
    pub to: Option<FileKind>,
    /// JSON file for lost, omitted, invented and embedded data (docs/reference/json.md); `-` is standard output
    #[arg(long, value_name = "FILE")]
    pub loss_report: Option<PathBuf>,
    /// Exit with 1 if data are lost or invented
    #[arg(long)]
    pub deny_loss: bool,
    /// Drop data that the format cannot express instead of storing them in properties or comments
    #[arg(long, alias = "no-carry")]
    pub no_embed: bool,
    /// Include disabled objects (`CO_disabled`) of an XDD, XDC or JSON in an EDS or DCF
    #[arg(long)]
    pub keep_disabled: bool,
    /// CiA 311 version of a new XDD or XDC
    #[arg(long, value_parser = one_of(&VERSIONS), value_name = "VERSION")]
    pub xdd_version: Option<XddVersion>,
    /// Node-ID (`$NODEID` in formulas) [default: from the DCF]
    #[arg(long, value_name = "N", value_parser = node_id)]
    pub node_id: Option<u8>,
    /// Bit rate in kbit/s [default: from the network or DCF]
    #[arg(long, alias = "baudrate", value_name = "KBIT/S", value_parser = clap::value_parser!(u16).range(1..))]
    pub bit_rate: Option<u16>,
    /// Node name
    #[arg(long, alias = "node-name", value_name = "NAME", value_parser = node_name)]
    pub name: Option<String>,
    /// Write all values to the concise DCF, not only non-default ones
    #[arg(long)]
    pub all: bool,
    #[command(flatten)]
    pub canonical: CanonicalArgs,
    #[command(flatten)]
    pub dbc: DbcArgs,
    #[command(flatten)]
    pub expand: ExpandArgs,
    #[command(flatten)]
    pub input: InputArgs,
    #[command(flatten)]
    pub network: NetworkPathArgs,
    #[command(flatten)]
    pub config: ConfigFileArgs,
}

// What a DBC describes.
#[derive(Clone, Copy, Debug, clap::Args)]
#[command(next_help_heading = "DBC")]
pub(crate) struct DbcArgs {
    /// Add the SDOs of each node to a DBC, with a multiplexed signal per entry of up to 4 bytes
    #[arg(long)]
    pub sdo: bool,
    /// Write a DBC signal per named bit field instead of one per word
    #[arg(long)]
    pub bits: bool,
}

impl ConvertArgs {
    /// Whether anything about the node is to be changed.
    pub(crate) fn changes_node(&self) -> bool {
        self.node_id.is_some() || self.bit_rate.is_some() || self.name.is_some()
    }
}

/// The versions of CiA 311.
const VERSIONS: [(XddVersion, &str, &str); 2] =
    [(XddVersion::V1_0, "1.0", ""), (XddVersion::V1_1, "1.1", "")];

/// The help of the command, with the formats that it reads and writes.
pub(super) fn about() -> String {
    let names = |kinds: &mut dyn Iterator<Item = FileKind>| series(kinds.map(FileKind::name)).to_string();
    let (read, written) = (names(&mut FileKind::read()), names(&mut FileKind::written()));
    format!(
        "Convert between formats\n\n\
         Reads {read}. Writes {written}.\n\n\
         EDS to EDS and DCF to DCF keep every byte. Conversions between EDS and DCF, and between XDD and XDC, edit the text and keep \
         comments, order and spelling. Conversions between INI and XML write a new file; data that the format cannot express are stored \
         in properties or objdict comment lines (docs/reference/formats.md). A DBC contains the messages of one node, or of all nodes of a network \
         (`network.toml`, `bus.yml`, node list).\n\n\
         --node-id applies to DCF, XDC, concise DCF and DBC, --bit-rate to DCF and XDC, --name to DCF, XDC and DBC. \
         With --deny-loss, exits with 1 if data are lost or invented."
    )
}

fn output_help() -> String {
    format!(
        "Output file: {}; `-` is standard output, the default with --to. Repeatable for one input: `-o a.dcf -o a.xdd`. \
         For several inputs: a folder, with --to, or one DBC for all of them",
        extensions(FileKind::written())
    )
}

/// The kinds of files that a description is converted to, by their words.
fn written_kinds() -> impl TypedValueParser<Value = FileKind> {
    let words = PossibleValuesParser::new(FileKind::written().map(FileKind::word));
    words.try_map(|word| FileKind::written().find(|kind| kind.word() == word).ok_or("no kind of file"))
}
