//! The command line.

#[cfg(feature = "bus")]
mod bus;
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

#[cfg(feature = "bus")]
pub(super) use self::bus::*;
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
    ChecksFormat, Counting, PlainFormat, ReportArgs, ReportDetailArgs, ReportFormat, ShowFormat,
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
/// Checks, converts, documents and configures EDS, DCF, XDD and XDC files and generates code from them.
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
    /// Exits with 1 if there are errors (see --deny) or with 2 if a file cannot be read.
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
    /// Detect file formats
    ///
    /// Detects CANopen files and similar files of other technologies. Exits with 1 if a file is not a CANopen file or with 2 if a file
    /// cannot be read.
    Identify(IdentifyArgs),
    /// Print the object dictionary or one object
    Show(ShowArgs),
    /// Generate code and configuration from a description
    ///
    /// Checks the description first. Generates nothing if an error would make the tables wrong: the type, access or value of an entry is
    /// unknown, or an entry is described twice. Files are written atomically and only if they change.
    Generate(Box<GenerateArgs>),
    /// Generate documentation
    ///
    /// Documents devices and networks as HTML, Markdown or CSV. Several descriptions become a site with an index page. A network becomes
    /// a site as well: the index shows its topology, links, CAN-IDs and boot plan, and each node has a page with its configured
    /// description. In a single file, a network is only this index.
    ///
    /// Pages include the findings of `check`, which change the exit code only with --deny.
    Docs(Box<DocsArgs>),
    /// Test a simulated node against CiA 301
    ///
    /// Runs an `objdict-device` node with the defaults of the description, without compiling anything, and tests its services and every
    /// entry by frames and time, as a master does. With --group, only values in storage groups are stored. With --bus, tests a
    /// device on a bus instead (docs/guides/bus.md). Exits with 1 if a check fails (docs/guides/conformance.md).
    Conformance(ConformanceArgs),
    /// Decode CAN logs with device descriptions
    ///
    /// Reads candump, Vector ASC, PEAK TRC, python-can CSV, pcap and pcapng logs, or a candump pipe. Uses the descriptions of the nodes
    /// to show the meaning of each frame: services, entry names and values, PDO signals and states. Lines that cannot be parsed are
    /// reported. Exits with 2 if a log contains no frame (docs/guides/decode.md).
    Decode(Box<DecodeArgs>),
    /// Check a device against its description
    ///
    /// Writes requests for the device: a script for python-canopen, the same reads as a log for canplayer, and a table. With --answers,
    /// checks the responses: presence, size, type, access, values against defaults and limits, abort codes (docs/guides/probe.md). Exits with 1
    /// if there are errors (see --deny).
    Probe(Box<ProbeArgs>),
    /// Access devices on a CAN bus
    ///
    /// Scans, reads, writes, saves, restores and compares. The bus is an adapter (SocketCAN, SLCAN), a log, or a simulated network, on
    /// which you can try every command without hardware (docs/guides/bus.md). Exits with 1 if something differs or is rejected, and with 2
    /// if the command could not do its work.
    #[cfg(feature = "bus")]
    Bus(Box<BusArgs>),
    /// Compare descriptions and show what breaks
    ///
    /// Compares objects, entries, PDOs and device data, regardless of order and spelling. Rates each change as breaking, risky or
    /// compatible for stored configurations, PDO consumers, SDO clients, firmware source and stored values (docs/guides/diff.md). Exits with 1
    /// if there is a breaking change (see --deny).
    Diff(DiffArgs),
    /// Bump versions to match the changes
    ///
    /// Compares two descriptions like `diff` and reports which of revision number, product code, FileVersion, FileRevision and
    /// ModificationDate must change but did not. --fix sets them. Exits with 1 if a version is outdated (docs/guides/release.md).
    Release(ReleaseArgs),
    /// Convert between formats
    #[command(long_about = convert::about())]
    Convert(ConvertArgs),
    /// Create a node's DCF from an EDS
    ///
    /// Checks every setting before writing: the entry exists and is writable, the value matches its type and limits, mapped entries are
    /// mappable, and CAN-IDs are free. Reports all problems at once, with exit code 1. Errors that `check` finds in the DCF but not in
    /// the EDS also stop it, unless --force is given.
    ///
    /// The text of the EDS is edited in place, so comments, order and spelling are preserved.
    Configure(Box<ConfigureArgs>),
    /// List a coupler's supported modules
    Modules(ModulesArgs),
    /// List the variants of a `device.toml`
    ///
    /// The first row is the device without variants. The other rows list the features that differ and the objects that are added (+),
    /// missing (-) or different.
    Variants(VariantsArgs),
    /// Check, build and simulate networks
    Network(NetworkArgs),
    /// Pack, unpack, compare and verify concise DCFs
    ///
    /// A concise DCF is the content of 1F22h in a CANopen manager: the SDO downloads that configure a node, as one stream of bytes (CiA
    /// 302-3). Every command reads it as bytes, hex digits, text (.cdcf.txt) or JSON.
    Dcf(DcfArgs),
    /// Create a device description
    ///
    /// Profiles: 301 (communication objects only), 401 (inputs and outputs), 402 (drive), 404 (measuring device), 406 (encoder). The file
    /// contains the objects that the profile requires and passes `objdict check`. Add your own objects from 2000h on.
    New(NewArgs),
    /// List and show device profiles
    Profile(ProfileCommandArgs),
    /// Patch vendor descriptions
    ///
    /// A patch is a TOML file with changes by address, each with the expected original value (docs/guides/patches.md). Other commands also apply
    /// patches, with `--patch`.
    Patch(PatchCommandArgs),
    /// Format descriptions
    ///
    /// In EDS and DCF, sections and keys move into canonical order with their comments; keys, section names, hex numbers and formulas get
    /// a uniform spelling. In XDD and XDC, elements and attributes move into the order of CiA 311, one element per line. The content
    /// stays the same. Formatted standard input is written to standard output.
    Fmt(FmtArgs),
    /// List the rules of `check`
    Rules(RulesArgs),
    /// Explain a rule or a standard object
    Explain(ExplainArgs),
    /// Print JSON Schemas
    ///
    /// Prints the schema of a document that objdict writes; without a name, lists the documents. The schemas use draft 2020-12 and have
    /// the version of their document.
    Schema(SchemaArgs),
    /// Edit descriptions in the browser
    ///
    /// Serves the workbench on this computer and starts the browser. The page can access the files that you name and the descriptions
    /// that a network refers to. It asks before it writes a file, and writes only if the file has not changed since it was read. Press
    /// Ctrl-C to stop.
    ///
    /// The packaged command contains the page; other builds need it built first (docs/guides/workbench.md).
    Open(OpenArgs),
    /// Run the language server
    ///
    /// Uses the Language Server Protocol on standard input and output, for descriptions, networks, `objdict.toml`, profiles and patches.
    /// Editors start it (docs/guides/editors.md).
    Lsp,
    /// Show help for a command or topic
    ///
    /// `objdict help topics` lists the topics.
    Help(HelpArgs),
    /// Generate shell completions
    Completions(CompletionsArgs),
    /// Generate man pages
    ///
    /// Writes a page for each command, for packagers. Unchanged pages are not rewritten.
    #[command(hide = true)]
    Man(ManArgs),
}

#[derive(Debug, clap::Args)]
pub(super) struct CheckArgs {
    /// Files, folders and patterns such as `devices/**/*.eds`; `-` is standard input
    ///
    /// In folders, all descriptions are checked except hidden files and files excluded by a `.gitignore`.
    #[arg(default_value = ".", value_name = "PATH")]
    pub files: Vec<PathBuf>,
    #[command(flatten)]
    pub report: ReportArgs,
    /// Markdown file for a vendor report: the most important problems of each file, their effects on tools, and a patch
    #[arg(long, value_name = "FILE", conflicts_with_all = ["fix", "diff", "cache"])]
    pub vendor_report: Option<PathBuf>,
    /// Number of files to check in parallel [default: number of processors]
    #[arg(long, value_name = "N")]
    pub jobs: Option<NonZeroUsize>,
    /// EDS or XDD from which the DCF or XDC was created [default: the file of `LastEDS`, if it is in the DCF's folder]
    ///
    /// Configured nodes are checked against it: identity, entries, types, access, defaults, limits.
    #[arg(long, value_name = "FILE", conflicts_with = "cache")]
    pub eds: Option<PathBuf>,
    /// Cache file: files without findings are skipped until they or the settings change
    #[arg(long, value_name = "FILE", conflicts_with_all = ["fix", "diff"])]
    pub cache: Option<PathBuf>,
    /// Git revision to compare with, such as the base of a merge request; only new findings are reported
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
    /// JSON document with one file per line (docs/reference/json.md)
    Json,
}

#[derive(Debug, clap::Args)]
pub(super) struct ConformanceArgs {
    /// Device description; `-` is standard input
    pub file: PathBuf,
    /// Node-ID (`$NODEID` in formulas) [default: from the DCF, else 1]
    #[arg(long, value_name = "N", value_parser = node_id)]
    pub node_id: Option<u8>,
    /// Storage group of objects, such as `2000-2FFF=PERSIST_APP`; repeatable
    #[arg(long = "group", value_name = "INDEXES=NAME")]
    pub groups: Vec<StorageGroup>,
    /// Also run the checks that write values to the device, which is reset before each check
    #[cfg(feature = "bus")]
    #[arg(long, requires = "bus")]
    pub write: bool,
    /// Also run the checks that start and stop the device by NMT
    #[cfg(feature = "bus")]
    #[arg(long, requires = "write")]
    pub nmt: bool,
    /// List the checks with their effects on the device, and send nothing
    #[cfg(feature = "bus")]
    #[arg(long, requires = "bus")]
    pub dry_run: bool,
    /// Do not ask before writing
    #[cfg(feature = "bus")]
    #[arg(short, long, requires = "write")]
    pub yes: bool,
    /// Show only failed checks
    #[arg(long)]
    pub summary: bool,
    /// Output format
    #[arg(long, value_enum, default_value = "table")]
    pub format: ChecksFormat,
    /// Check the device on a bus
    #[cfg(feature = "bus")]
    #[command(flatten)]
    pub bus: BusLinkArgs,
    #[command(flatten)]
    pub input: InputArgs,
}

#[derive(Debug, clap::Args)]
pub(super) struct ShowArgs {
    /// File to show; `-` is standard input
    pub file: PathBuf,
    /// Objects to show: an index such as 1018, 0x1018 or 1018:1 (hexadecimal), a name such as statusword, a PDO such as tpdo1, a pattern
    /// such as 60* or *velocity*, or communication, manufacturer or profile (see `objdict help names`)
    #[arg(value_name = "OBJECT", value_parser = object)]
    pub object: Option<String>,
    /// Node-ID (`$NODEID` in formulas) [default: from the DCF]
    #[arg(long, value_name = "N", value_parser = node_id)]
    pub node_id: Option<u8>,
    /// Show only entries that a DCF sets to a non-default value
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
    /// Show the objects of a profile or one in detail
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
    /// CiA document number such as 401, or a custom profile file (docs/guides/profiles.md)
    pub profile: String,
    /// Object to show, with its sub-indexes and bits
    #[arg(value_name = "INDEX")]
    pub index: Option<Address>,
    /// Output format
    #[arg(long, value_enum, default_value = "text")]
    pub format: ProfileFormat,
}

/// How profiles are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum ProfileFormat {
    /// Plain text
    Text,
    /// JSON document (docs/reference/json.md)
    Json,
}

#[derive(Debug, clap::Args)]
#[command(mut_arg("max_entries", |entries| entries.hide(true)))] // no entry is expanded
pub(super) struct FmtArgs {
    /// Files, folders and patterns such as `devices/**/*.eds`; `-` is standard input
    #[arg(default_value = ".", value_name = "PATH")]
    pub files: Vec<PathBuf>,
    /// List unformatted files without changing them; exit with 1 if there are any
    #[arg(long)]
    pub check: bool,
    /// Print the changes without writing them; exit with 1 if there are any
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
    /// Group of rules to list, such as cia301; repeatable or comma-separated
    #[arg(long, value_name = "GROUP", value_delimiter = ',')]
    pub group: Vec<String>,
}

/// How rules are listed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum RulesFormat {
    /// One line per rule
    Text,
    /// JSON document with the rules and their pages
    Json,
}

#[derive(Debug, clap::Args)]
pub(super) struct ExplainArgs {
    /// Rule such as cia306/duplicate-key (if unique, the name is enough), or index such as 1018 or 0x6040
    #[arg(value_name = "RULE|INDEX")]
    pub subject: String,
}

#[derive(Debug, clap::Args)]
pub(super) struct SchemaArgs {
    /// Document, such as device, findings or network
    #[arg(value_name = "DOCUMENT")]
    pub name: Option<String>,
}

#[derive(Debug, clap::Args)]
pub(super) struct HelpArgs {
    /// Command such as `check` or `dcf pack`, or topic: exit-codes, severities, names, formats, targets, configuration, settings
    #[arg(value_name = "COMMAND|TOPIC")]
    pub subject: Vec<String>,
}

#[derive(Debug, clap::Args)]
pub(super) struct CompletionsArgs {
    /// Shell
    #[arg(value_enum)]
    pub shell: Shell,
}

#[derive(Debug, Default, clap::Args)]
pub(super) struct ManArgs {
    /// Output folder, such as share/man/man1
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
