//! The command line.

mod configure;
mod convert;
mod dcf;
mod decode;
mod diff;
mod docs;
mod features;
mod generate;
mod network;
mod new;
mod open;
mod patch;
mod probe;
mod report;

use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

use clap::{Parser, Subcommand, ValueEnum};
use clap_complete::Shell;
use objdict_node::ObjectName;

pub(super) use self::configure::{ConfigureArgs, ModulesArgs, VariantsArgs, VariantsFormat};
pub(super) use self::convert::ConvertArgs;
pub(super) use self::dcf::indexes;
pub(super) use self::dcf::{
    BlobFormat, DcfArgs, DcfCommand, DcfDiffArgs, NamingArgs, PackArgs, UnpackArgs, VerifyArgs,
};
pub(super) use self::decode::{DecodeArgs, DecodeFormat, FrameFilterArgs, WithFile};
pub(super) use self::diff::{DiffArgs, DiffFormat, ReleaseArgs, SidesArgs};
pub(super) use self::docs::DocsArgs;
pub(super) use self::generate::{GenerateArgs, SizeFormat};
pub(super) use self::network::{
    GraphFormat, NetworkArgs, NetworkBootArgs, NetworkBuildArgs, NetworkCheckArgs, NetworkCommand,
    NetworkDiffArgs, NetworkFormat, NetworkGraphArgs, NetworkInitArgs, NetworkInputArgs, NetworkSchemaArgs,
    NetworkShowArgs, NetworkTarget, NetworkTimingArgs, NetworkVerifyArgs,
};
pub(super) use self::new::{NewArgs, outputs};
pub(super) use self::open::OpenArgs;
pub(super) use self::patch::{PatchApplyArgs, PatchCheckArgs, PatchCommand, PatchCommandArgs, PatchMakeArgs};
pub(super) use self::probe::ProbeArgs;
pub(super) use self::report::{
    Counting, PlainFormat, ReportArgs, ReportDetailArgs, ReportFormat, ShowFormat,
};
use super::baseline::BaselineArgs;
use super::canonical::DialectArgs;
use super::fix::FixArgs;
use super::input::{ExpandArgs, InputArgs, SizeArgs};
use super::settings::{ConfigFileArgs, SettingsArgs};
use super::terminal::TerminalArgs;
use super::values::node_id;
use super::written_files::OverwriteArgs;
use objdict_generate::StorageGroup;
use objdict_model::model::{Address, NoAddress};

/// The CANopen object-dictionary toolchain
///
/// Checks, converts, documents and configures EDS, DCF, XDD and XDC files, and generates code from them.
///
/// Exit codes: 0 success, 1 findings, 2 failure (see `objdict help exit-codes`).
#[derive(Debug, Parser)]
#[command(name = "objdict", bin_name = "objdict", version, disable_help_subcommand = true)]
pub(super) struct Args<C: Subcommand = Command> {
    #[command(subcommand)]
    pub command: C,
    #[command(flatten)]
    pub terminal: TerminalArgs,
}

/// The command that is run most, alone.
#[derive(Debug, Subcommand)]
#[command(defer = true)]
pub(super) enum OnlyCheck {
    /// Check device descriptions
    ///
    /// Exits with 1 if there is a finding of severity error (see --deny), and with 2 if a file cannot be read.
    Check(CheckArgs),
}

impl Args {
    /// The arguments of the process.
    pub(super) fn of_process() -> Result<Self, clap::Error> {
        // the other commands need not even be named for it
        if std::env::args_os().nth(1).is_some_and(|name| name == "check") {
            let Args { command, terminal } = Args::try_parse()?;
            return Ok(Self { command: Command::Check(command), terminal });
        }
        Self::try_parse()
    }
}

/// The commands; the arguments of a command are declared when it is given.
#[derive(Debug, Subcommand)]
#[command(defer = true)]
pub(super) enum Command {
    #[command(flatten)]
    Check(OnlyCheck),
    /// Recognise files by their content
    ///
    /// Recognises CANopen files, and files of other technologies that look similar. Exits with 1 if a file is not a CANopen
    /// file, and with 2 if a file cannot be read.
    Identify(IdentifyArgs),
    /// Show the object dictionary, or one object in detail
    Show(ShowArgs),
    /// Generate code and configuration from a description
    ///
    /// Checks the description first and generates nothing if an error would make the tables wrong: the type, access or value of
    /// an entry is unknown, or an entry is described twice. Files are written atomically, and only if they change.
    Generate(Box<GenerateArgs>),
    /// Document devices and networks as HTML, Markdown or CSV
    ///
    /// Several descriptions become a site with an index page. So does a network: the index shows its topology, links, CAN-IDs and boot
    /// plan, and each node has a page with its configured description. In a single file, a network is only this index. Pages include the
    /// findings of `check`, which do not change the exit code unless --deny is given.
    Docs(Box<DocsArgs>),
    /// Check the node of a description against CiA 301
    ///
    /// Runs the node of `objdict-device` with the defaults of the description, without compiling it, and checks its services and every
    /// entry as a master does: by frames and time. Exits with 1 if a check fails (docs/guides/runtime.md).
    Conformance(ConformanceArgs),
    /// Put the traffic of a bus into words
    ///
    /// Reads logs of candump, ASC of Vector, TRC of PEAK, CSV of python-can, pcap and pcapng, or a pipe of candump, and says what each
    /// frame means by the descriptions of the nodes: services, entries by name with their values, PDO signals, states. Lines
    /// that are not understood are reported. Exits with 2 if a log has no frame (docs/guides/decode.md).
    Decode(Box<DecodeArgs>),
    /// Check a device against its description
    ///
    /// Writes what to ask the device: a script for python-canopen, the same reads as a log for canplayer, and a table. With --answers, judges
    /// what the device answered: presence, size, type, access, values against defaults and limits, abort codes (docs/guides/probe.md). Exits with 1
    /// if there is a finding of severity error (see --deny).
    Probe(Box<ProbeArgs>),
    /// Compare two descriptions, and say whom each change affects
    ///
    /// Compares by meaning: objects, entries, PDOs and facts about the device; order and spelling do not count. Each change has a verdict
    /// for stored configurations, PDO consumers, SDO clients, firmware source and stored values: breaking, risky or compatible
    /// (docs/guides/diff.md). Exits with 1 if there is a breaking change (see --deny).
    Diff(DiffArgs),
    /// Raise the versions of a new description as its changes demand
    ///
    /// Compares two descriptions as `diff` does, and reports which of revision number, product code, FileVersion, FileRevision and
    /// ModificationDate do not move with the changes. --fix sets them. Exits with 1 if something is missing (docs/guides/diff.md).
    Release(ReleaseArgs),
    /// Convert between formats
    #[command(long_about = convert::about())]
    Convert(ConvertArgs),
    /// Create the DCF of a node from an EDS
    ///
    /// Every setting is checked against the dictionary before anything is written: the entry exists and is writable, the value fits
    /// its type and its limits, mapped entries are mappable, CAN-IDs are free. All problems are reported at once, with exit
    /// code 1. The text of the EDS is edited in place, so comments, order and spelling are preserved.
    Configure(Box<ConfigureArgs>),
    /// List the modules that a coupler supports
    Modules(ModulesArgs),
    /// List the variants of a `device.toml`
    ///
    /// The first row is the device without variants. Of a variant, the features that are different are listed, and the objects that it
    /// has too (+), that it lacks (-), or that are different.
    Variants(VariantsArgs),
    /// Check networks, and build the configurations of their nodes and managers
    Network(NetworkArgs),
    /// Pack, unpack, compare and verify concise DCF
    ///
    /// A concise DCF is the content of 1F22h in a CANopen manager: the SDO downloads that configure a node, as one stream of
    /// bytes (CiA 302-3). Every command reads it as bytes, hex digits, text (.cdcf.txt) or JSON.
    Dcf(DcfArgs),
    /// Create the description of a new device
    ///
    /// Profiles: 301 (communication objects only), 401 (inputs and outputs), 402 (drive), 404 (measuring device), 406 (encoder). The file has the objects that the profile
    /// requires and passes `objdict check`; add your own objects from 2000h on.
    New(NewArgs),
    /// List device profiles and show their requirements
    Profile(ProfileCommandArgs),
    /// Correct descriptions that belong to others
    ///
    /// A patch is a TOML file with changes by address, each with what the file is expected to say (docs/guides/patches.md). `--patch` of other
    /// commands applies patches too.
    Patch(PatchCommandArgs),
    /// Format descriptions
    ///
    /// In EDS and DCF, sections and keys move into the canonical order, with their comments; keys, section names, hex numbers and formulas
    /// are spelled uniformly. In XDD and XDC, elements and attributes move into the order of CiA 311, one element on each line. The content of
    /// the file stays the same. Standard input is written to standard output.
    Fmt(FmtArgs),
    /// List the rules of `check`
    Rules(RulesArgs),
    /// Explain a rule or a standard object
    Explain(ExplainArgs),
    /// Print the JSON Schema of a document that objdict writes
    ///
    /// Without a name, lists the documents. The schemas are of draft 2020-12 and have the version of their document.
    Schema(SchemaArgs),
    /// Open descriptions in the workbench, and save them in place
    ///
    /// Serves the page of the workbench on this computer and starts the browser. The page sees the files that are named, and the descriptions
    /// that a network refers to; it writes a file only after it has asked, and only if the file has not changed since it was read. Ctrl-C ends
    /// it. The command of the packages has the page; others are built with it (docs/guides/workbench.md).
    Open(OpenArgs),
    /// Serve an editor as a language server
    ///
    /// Speaks the Language Server Protocol on standard input and output, for descriptions, networks, `objdict.toml`, profiles and
    /// patches. The editor starts it (docs/guides/editors.md).
    Lsp,
    /// Print the help of a command, or explain a topic
    ///
    /// `objdict help topics` lists the topics.
    Help(HelpArgs),
    /// Generate shell completions
    Completions(CompletionsArgs),
    /// Generate the manual pages, one for each command
    ///
    /// For packagers. Unchanged pages are not rewritten.
    #[command(hide = true)]
    Man(ManArgs),
}

#[derive(Debug, clap::Args)]
pub(super) struct CheckArgs {
    /// Files, folders and patterns such as `devices/**/*.eds`; `-` is standard input
    ///
    /// In folders, all descriptions are checked, except hidden files and files that a `.gitignore` excludes.
    #[arg(default_value = ".", value_name = "PATH")]
    pub files: Vec<PathBuf>,
    #[command(flatten)]
    pub report: ReportArgs,
    /// Write the most important problems of each file, their effects on tools and a patch for the vendor to this file, in Markdown
    #[arg(long, value_name = "FILE", conflicts_with_all = ["fix", "diff", "cache"])]
    pub vendor_report: Option<PathBuf>,
    /// Number of files to check in parallel [default: number of processors]
    #[arg(long, value_name = "N")]
    pub jobs: Option<NonZeroUsize>,
    /// The EDS or XDD that the DCF or XDC were made from [default: the file of `LastEDS`, if it is in the folder of the DCF]
    ///
    /// Configured nodes are checked against it: identity, entries, types, access, defaults, limits.
    #[arg(long, value_name = "FILE", conflicts_with = "cache")]
    pub eds: Option<PathBuf>,
    /// Remember in this file which files have no findings, and skip them as long as they and the settings stay the same
    #[arg(long, value_name = "FILE", conflicts_with_all = ["fix", "diff"])]
    pub cache: Option<PathBuf>,
    /// Report only what was not found in git's version of each file at this revision, such as the base of a merge request
    #[arg(long, value_name = "REV", conflicts_with_all = ["fix", "diff", "write_baseline"])]
    pub since: Option<String>,
    #[command(flatten)]
    pub input: InputArgs,
    #[command(flatten)]
    pub settings: SettingsArgs,
    #[command(flatten)]
    pub baseline: BaselineArgs,
    #[command(flatten)]
    pub fixing: FixArgs,
}

#[derive(Debug, clap::Args)]
pub(super) struct IdentifyArgs {
    /// Files to identify; `-` is standard input
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// Output format
    #[arg(long, value_enum, default_value = "text")]
    pub format: AnswerFormat,
    #[command(flatten)]
    pub size: SizeArgs,
}

/// How answers about files are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum AnswerFormat {
    /// One line per file
    Text,
    /// For programs: one JSON document, one file per line (docs/reference/json.md)
    Json,
}

#[derive(Debug, clap::Args)]
pub(super) struct ConformanceArgs {
    /// The description of the node; `-` is standard input
    pub file: PathBuf,
    /// The node-ID [default: from the DCF, else 1]
    #[arg(long, value_name = "N", value_parser = node_id)]
    pub node_id: Option<u8>,
    /// Storage group of the build, as of `generate`; then only values in groups are stored; repeatable
    #[arg(long = "group", value_name = "INDEXES=NAME")]
    pub groups: Vec<StorageGroup>,
    /// Show only checks that fail
    #[arg(long)]
    pub summary: bool,
    /// Output format
    #[arg(long, value_enum, default_value = "table")]
    pub format: ShowFormat,
    #[command(flatten)]
    pub input: InputArgs,
}

#[derive(Debug, clap::Args)]
pub(super) struct ShowArgs {
    /// The file to show; `-` is standard input
    pub file: PathBuf,
    /// Only these objects: an index such as 1018, 0x1018 or 1018:1 (hexadecimal), a name such as statusword, a PDO such as tpdo1, a
    /// pattern such as 60* or *velocity*, or communication, manufacturer, profile (see `objdict help names`)
    #[arg(value_name = "OBJECT", value_parser = object)]
    pub object: Option<String>,
    /// Evaluate formulas such as $NODEID+0x180 for this node-ID [default: from the DCF]
    #[arg(long, value_name = "N", value_parser = node_id)]
    pub node_id: Option<u8>,
    /// Only entries that a DCF sets to a value other than the default
    #[arg(long)]
    pub changed: bool,
    /// Output format
    #[arg(long, value_enum, default_value = "table")]
    pub format: ShowFormat,
    #[command(flatten)]
    pub expand: ExpandArgs,
    #[command(flatten)]
    pub input: InputArgs,
}

#[derive(Debug, clap::Args)]
pub(super) struct ProfileCommandArgs {
    #[command(subcommand)]
    pub command: ProfileCommand,
}

#[derive(Debug, Subcommand)]
#[command(defer = true)]
pub(super) enum ProfileCommand {
    /// List the built-in CiA documents
    List(ProfileListArgs),
    /// Show the objects of a profile, or one in detail
    Show(ProfileShowArgs),
}

#[derive(Debug, clap::Args)]
pub(super) struct ProfileListArgs {
    /// Output format
    #[arg(long, value_enum, default_value = "text")]
    pub format: ProfileFormat,
}

#[derive(Debug, clap::Args)]
pub(super) struct ProfileShowArgs {
    /// The number of a CiA document, such as 401, or the file of a custom profile (docs/guides/profiles.md)
    pub profile: String,
    /// Only this object, with its sub-indexes and bits
    #[arg(value_name = "INDEX")]
    pub index: Option<Address>,
    /// Output format
    #[arg(long, value_enum, default_value = "text")]
    pub format: ProfileFormat,
}

/// How profiles are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum ProfileFormat {
    /// Tables
    Text,
    /// For programs: one JSON document (docs/reference/json.md)
    Json,
}

#[derive(Debug, clap::Args)]
#[command(mut_arg("max_entries", |entries| entries.hide(true)))] // no entry is expanded
pub(super) struct FmtArgs {
    /// Files, folders and patterns such as `devices/**/*.eds`; `-` is standard input
    #[arg(default_value = ".", value_name = "PATH")]
    pub files: Vec<PathBuf>,
    /// Print the names of unformatted files without changing them, and exit with 1 if there are any
    #[arg(long)]
    pub check: bool,
    /// Print the changes without writing them, and exit with 1 if there are any
    #[arg(long, conflicts_with = "check")]
    pub diff: bool,
    #[command(flatten)]
    pub dialect: DialectArgs,
    #[command(flatten)]
    pub input: InputArgs,
    #[command(flatten)]
    pub config: ConfigFileArgs,
}

#[derive(Debug, clap::Args)]
pub(super) struct RulesArgs {
    /// Output format
    #[arg(long, value_enum, default_value = "text")]
    pub format: RulesFormat,
    /// Only the rules of this group, such as cia301; repeatable, or separated by commas
    #[arg(long, value_name = "GROUP", value_delimiter = ',')]
    pub group: Vec<String>,
}

/// How rules are listed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum RulesFormat {
    /// One line per rule
    Text,
    /// One JSON document that includes their pages
    Json,
}

#[derive(Debug, clap::Args)]
pub(super) struct ExplainArgs {
    /// The rule, such as cia306/duplicate-key; the name alone is enough if it is unique. Or an index, such as 1018 or
    /// 0x6040
    #[arg(value_name = "RULE|INDEX")]
    pub subject: String,
}

#[derive(Debug, clap::Args)]
pub(super) struct SchemaArgs {
    /// The document, such as device, findings or network
    #[arg(value_name = "DOCUMENT")]
    pub name: Option<String>,
}

#[derive(Debug, clap::Args)]
pub(super) struct HelpArgs {
    /// A command, such as `check` or `dcf pack`, or a topic: exit-codes, severities, names, formats, targets, configuration,
    /// settings
    #[arg(value_name = "COMMAND|TOPIC")]
    pub subject: Vec<String>,
}

#[derive(Debug, clap::Args)]
pub(super) struct CompletionsArgs {
    /// The shell
    #[arg(value_enum)]
    pub shell: Shell,
}

#[derive(Debug, Default, clap::Args)]
pub(super) struct ManArgs {
    /// The folder to write to, such as share/man/man1
    #[arg(short, long, value_name = "DIR", required_unless_present = "folder")]
    pub output: Option<PathBuf>,
    /// The same, in its old place
    #[arg(value_name = "DIR", hide = true, conflicts_with = "output")]
    pub folder: Option<PathBuf>,
    #[command(flatten)]
    pub overwrite: OverwriteArgs,
}

impl ManArgs {
    /// The folder to write to; one of both is required.
    pub(super) fn output(&self) -> &Path {
        self.output.as_deref().or(self.folder.as_deref()).unwrap_or(Path::new("."))
    }
}

/// The name of objects, which a device resolves.
fn object(text: &str) -> Result<String, NoAddress> {
    text.parse::<ObjectName>().map(|_| text.to_owned())
}
