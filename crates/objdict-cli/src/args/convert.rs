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
    /// The format to write [default: by the extension of the output]
    #[arg(long, value_name = "FORMAT", value_parser = written_kinds())]
    pub to: Option<FileKind>,
    /// Write lost, omitted, invented and embedded data to this file, as JSON (docs/reference/json.md); `-` is standard output
    #[arg(long, value_name = "FILE")]
    pub loss_report: Option<PathBuf>,
    /// Exit with 1 if data are lost or invented
    #[arg(long)]
    pub deny_loss: bool,
    /// Do not store data that the format cannot express in properties or comments: such data are lost
    #[arg(long, alias = "no-carry")]
    pub no_embed: bool,
    /// Also write disabled objects (`CO_disabled`) of an XDD, XDC or JSON to an EDS or DCF
    #[arg(long)]
    pub keep_disabled: bool,
    /// Version of CiA 311 of a new XDD or XDC
    #[arg(long, value_parser = one_of(&VERSIONS), value_name = "VERSION")]
    pub xdd_version: Option<XddVersion>,
    /// Node-ID in the DCF, XDC, concise DCF or DBC
    #[arg(long, value_name = "N", value_parser = node_id)]
    pub node_id: Option<u8>,
    /// Bit rate in kbit/s in the DCF or XDC
    #[arg(long, alias = "baudrate", value_name = "KBIT/S", value_parser = clap::value_parser!(u16).range(1..))]
    pub bit_rate: Option<u16>,
    /// Node name in the DCF, XDC or DBC
    #[arg(long, alias = "node-name", value_name = "NAME", value_parser = node_name)]
    pub name: Option<String>,
    /// Write all values to a concise DCF, not only those that differ from the default
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
    /// Add the SDOs of each node to a DBC, with a multiplexed signal for each entry of at most 4 bytes
    #[arg(long)]
    pub sdo: bool,
    /// Write one signal to a DBC for each named bit field, instead of one for the whole word
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
         Reads {read}, and writes {written}. \
         EDS to EDS and DCF to DCF keep every byte. Conversions between EDS and DCF, and between XDD and XDC, edit the text and keep \
         comments, order and spelling. Conversions between INI and XML write a new file; data that the format cannot express are stored \
         in properties or comment lines of objdict (docs/reference/formats.md). A DBC contains the messages of one node, or of all nodes of a network \
         (`network.toml`, `bus.yml`, node list). Exits with 1 if --deny-loss is given and data are lost or invented."
    )
}

fn output_help() -> String {
    format!(
        "The file to write: {}; `-` is standard output, the default with --to. Of one file also several: `-o a.dcf -o a.xdd`. \
         For several files: a folder, with --to, or one DBC for all of them",
        extensions(FileKind::written())
    )
}

/// The kinds of files that a description is converted to, by their words.
fn written_kinds() -> impl TypedValueParser<Value = FileKind> {
    let words = PossibleValuesParser::new(FileKind::written().map(FileKind::word));
    words.try_map(|word| FileKind::written().find(|kind| kind.word() == word).ok_or("no kind of file"))
}
