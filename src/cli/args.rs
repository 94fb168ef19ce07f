//! The command line.

mod configure;
mod dcf;
mod docs;
mod generate;
mod new;

use std::borrow::Cow;
use std::num::NonZeroUsize;
use std::path::PathBuf;

use clap::{Parser, Subcommand, ValueEnum};
use clap_complete::Shell;

pub(super) use self::configure::{ConfigureArgs, ModulesArgs, ModulesFormat};
pub(super) use self::dcf::{
    DcfArgs, DcfCommand, DcfDiffArgs, NamingArgs, PackArgs, UnpackArgs, VerdictFormat, VerifyArgs,
};
pub(super) use self::docs::DocsArgs;
pub(super) use self::generate::{GenerateArgs, SizeFormat};
pub(super) use self::new::NewArgs;
use super::baseline::BaselineArgs;
use super::fix::FixArgs;
use super::input::{FileKind, InputArgs, SizeArgs};
use super::output::Color;
use super::settings::SettingsArgs;
use crate::diagnostic::Severity;
use crate::format::literal::RealSpelling;
use crate::format::{WriteOptions, XddVersion};
use crate::model::{Address, Device};
use crate::source::Encoding;

/// The CANopen object-dictionary toolchain
///
/// Reads EDS and DCF files, says what is wrong with them and where, and turns them into what a product needs.
///
/// Exit codes: 0 all is well, 1 something was found, 2 the tool could not do its work.
#[derive(Debug, Parser)]
#[command(name = "objdict", version, disable_help_subcommand = true)]
pub(super) struct Args<C: Subcommand = Command> {
    #[command(subcommand)]
    pub command: C,
    /// When to use colours
    #[arg(long, global = true, value_enum, default_value = "auto", value_name = "WHEN", display_order = 900)]
    pub color: Color,
}

/// The command that is run most, alone.
#[derive(Debug, Subcommand)]
enum OnlyCheck {
    Check(CheckArgs),
}

impl Args {
    /// The arguments of the process.
    pub(super) fn of_process() -> Result<Self, clap::Error> {
        // to declare all commands takes longer than to check a small file
        if std::env::args_os().nth(1).is_some_and(|name| name == "check") {
            let Args { command: OnlyCheck::Check(check), color } = Args::try_parse()?;
            return Ok(Self { command: Command::Check(check), color });
        }
        Self::try_parse()
    }
}

#[derive(Debug, Subcommand)]
pub(super) enum Command {
    Check(CheckArgs),
    Identify(IdentifyArgs),
    Show(ShowArgs),
    Generate(Box<GenerateArgs>),
    Docs(Box<DocsArgs>),
    Convert(ConvertArgs),
    Configure(ConfigureArgs),
    Modules(ModulesArgs),
    Dcf(DcfArgs),
    New(NewArgs),
    Profile(ProfileCommandArgs),
    Fmt(FmtArgs),
    Rules(RulesArgs),
    Explain(ExplainArgs),
    Completions(CompletionsArgs),
    Man(ManArgs),
}

/// Say what is wrong with descriptions, and where
///
/// Exits with 1 when there is a finding of severity warning or error (see --deny), with 2 when a file cannot be read.
#[derive(Debug, Parser)]
pub(super) struct CheckArgs {
    /// Files, folders and patterns such as `devices/**/*.eds`; `-` is the standard input
    ///
    /// In folders all descriptions are checked, but for what is hidden or named in a `.gitignore`.
    #[arg(default_value = ".", value_name = "PATH")]
    pub files: Vec<PathBuf>,
    /// How to write the findings
    #[arg(long, value_enum, default_value = "text")]
    pub format: ReportFormat,
    /// Count the findings of each rule; `=only` instead of showing them. With the formats text, concise and json
    #[arg(long, value_enum, value_name = "WHICH", num_args = 0..=1, require_equals = true, default_missing_value = "also")]
    pub statistics: Option<Counting>,
    /// The number of files that are checked at the same time; without it, as many as there are processors
    #[arg(long, value_name = "N")]
    pub jobs: Option<NonZeroUsize>,
    #[command(flatten)]
    pub input: InputArgs,
    #[command(flatten)]
    pub settings: SettingsArgs,
    #[command(flatten)]
    pub baseline: BaselineArgs,
    #[command(flatten)]
    pub mending: FixArgs,
}

/// Say what files are, from their content, and how that shows
///
/// Knows the files of CANopen and those of other technologies that are taken for them. Exits with 1 when a file is none of
/// CANopen, with 2 when a file cannot be read.
#[derive(Debug, Parser)]
pub(super) struct IdentifyArgs {
    /// Files to look at; `-` is the standard input
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// How to write the answers
    #[arg(long, value_enum, default_value = "text")]
    pub format: AnswerFormat,
    #[command(flatten)]
    pub size: SizeArgs,
}

/// How answers about files are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum AnswerFormat {
    /// For people: a line a file
    Text,
    /// For programs: one JSON document, one file a line (docs/json.md)
    Json,
}

/// How findings are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum ReportFormat {
    /// For people: the lines with marks under them
    Text,
    /// A line each: file:line:column: severity rule: message
    Concise,
    /// For programs: one JSON document (docs/json.md)
    Json,
    /// SARIF 2.1.0, for code scanning services and editors
    Sarif,
    /// Annotations of GitHub workflows
    Github,
    /// A code quality report of GitLab
    Gitlab,
    /// JUnit XML, for what shows the results of tests
    Junit,
}

/// Whether the findings are counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Counting {
    /// Behind the findings
    Also,
    /// Instead of the findings
    Only,
}

/// Show the dictionary as a table, or one object or entry of it in detail
#[derive(Debug, Parser)]
pub(super) struct ShowArgs {
    /// The file; `-` is the standard input
    pub file: PathBuf,
    /// Only this object or entry: 1018, 0x1018, 1018:1, 1018sub1; all numbers are hexadecimal
    #[arg(value_name = "INDEX[:SUB]")]
    pub address: Option<Address>,
    /// The node that formulas such as $NODEID+0x180 are worked out for; a DCF names its own
    #[arg(long, value_name = "N", value_parser = node_id)]
    pub node_id: Option<u8>,
    /// Only what a DCF configures to another value than the default
    #[arg(long)]
    pub changed: bool,
    /// How to write it
    #[arg(long, value_enum, default_value = "table")]
    pub format: ShowFormat,
    #[command(flatten)]
    pub expand: ExpandArgs,
    #[command(flatten)]
    pub input: InputArgs,
}

/// How a dictionary is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum ShowFormat {
    /// For people
    Table,
    /// For programs: one JSON document, one entry a line (docs/json.md)
    Json,
}

/// Turn files into another format, and say what it cannot carry
///
/// EDS to EDS and DCF to DCF keep every byte; EDS to DCF and back edit the text and keep comments, order and spelling; XDD and
/// XDC alike. Between the two worlds everything is written anew, and what has no place in the other is carried in
/// properties or sections of its own (docs/formats.md). Exits with 1 when --deny-loss is given and something is lost.
#[derive(Debug, Parser)]
pub(super) struct ConvertArgs {
    /// The files to convert; `-` is the standard input
    #[arg(required = true, value_name = "IN")]
    pub files: Vec<PathBuf>,
    /// The file to write; its ending says what: .eds .dcf .xdd .xdc .json .cdcf (concise DCF) .cdcf.txt. `-` is the standard output.
    /// Or the folder for several files, with --to
    pub out: PathBuf,
    /// What to write, where the name does not say it
    #[arg(long, value_enum, value_name = "FORMAT")]
    pub to: Option<WrittenKind>,
    /// Write what is lost, left out and carried to this file, as JSON (docs/json.md); `-` is the standard output
    #[arg(long, value_name = "FILE")]
    pub loss_report: Option<PathBuf>,
    /// Exit with 1 when a datum is lost
    #[arg(long)]
    pub deny_loss: bool,
    /// Carry nothing in properties or sections of objdict: what the format has no place for is lost
    #[arg(long)]
    pub no_carry: bool,
    /// The version of CiA 311 of a new XDD or XDC
    #[arg(long, value_enum, value_name = "VERSION")]
    pub xdd_version: Option<Version>,
    /// The node-ID of the node that a DCF, XDC or concise DCF is for
    #[arg(long, value_name = "N", value_parser = node_id)]
    pub node_id: Option<u8>,
    /// The bit rate in kbit/s that a DCF or XDC states
    #[arg(long, value_name = "KBIT/S", value_parser = clap::value_parser!(u16).range(1..))]
    pub bit_rate: Option<u16>,
    /// The name of the node that a DCF or XDC states
    #[arg(long, value_name = "NAME", value_parser = node_name)]
    pub node_name: Option<String>,
    /// Write all values into a concise DCF, not only those that differ from the default
    #[arg(long)]
    pub all: bool,
    /// A folder that files of DOMAINs (`DownloadFile`) may be read from, beside that of the DCF; may be given several times
    #[arg(long, value_name = "DIR")]
    pub allow_path: Vec<PathBuf>,
    #[command(flatten)]
    pub canonical: CanonicalArgs,
    #[command(flatten)]
    pub expand: ExpandArgs,
    #[command(flatten)]
    pub input: InputArgs,
}

/// What is added to the device that a file describes.
#[derive(Debug, clap::Args)]
pub(super) struct ExpandArgs {
    /// Describe the PDOs that CompactPDO implies, as many as NrOfRXPDO and NrOfTXPDO say
    #[arg(long)]
    pub implicit_pdos: bool,
}

impl ExpandArgs {
    /// The device with what was asked for.
    pub(super) fn device<'a>(&self, device: &'a Device) -> Cow<'a, Device> {
        if self.implicit_pdos { device.with_implicit_pdos() } else { Cow::Borrowed(device) }
    }
}

/// How an EDS or DCF is written that is no edit of a text.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Canonical EDS and DCF")]
pub(super) struct CanonicalArgs {
    /// Write an EDS or DCF anew from the model, in the order and spelling that most tools take, instead of editing the text
    #[arg(long)]
    pub canonical: bool,
    /// How REAL numbers are written; implies --canonical
    #[arg(long, value_enum, value_name = "SPELLING")]
    pub real: Option<Real>,
    /// Put strings into quotes, as Lely's tools want them; implies --canonical
    #[arg(long)]
    pub quote_strings: bool,
    /// Keep compact storage (CompactSubObj), which many tools do not know; implies --canonical
    #[arg(long)]
    pub compact: bool,
    /// The encoding of the text that is written; without it ISO 646, as CiA 306 demands, in which `ü` is `ue`; implies
    /// --canonical
    #[arg(long, value_name = "ENCODING")]
    pub output_encoding: Option<Encoding>,
}

/// A spelling of REAL numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Real {
    /// As decimal numbers
    Decimal,
    /// As the hex digits of their bits, as Lely's tools read them
    Bits,
}

impl CanonicalArgs {
    /// Whether a new text is wanted although there is one to edit.
    pub(super) fn is_asked(&self) -> bool {
        self.canonical
            || self.real.is_some()
            || self.quote_strings
            || self.compact
            || self.output_encoding.is_some()
    }

    /// How the text is written; an encoding that was said for reading holds for writing too.
    pub(super) fn options(&self, read_in: Option<Encoding>) -> WriteOptions {
        let mut options = WriteOptions::default();
        if self.real == Some(Real::Bits) {
            options.eds.real = RealSpelling::Hex;
        }
        options.eds.quote_strings = self.quote_strings;
        options.eds.compact = self.compact;
        options.eds.encoding = self.output_encoding.or(read_in);
        options
    }
}

impl ConvertArgs {
    /// Whether anything about the node is to be changed.
    pub(super) fn changes_node(&self) -> bool {
        self.node_id.is_some() || self.bit_rate.is_some() || self.node_name.is_some()
    }
}

/// List the profiles that `check` knows, and show what they demand
#[derive(Debug, Parser)]
pub(super) struct ProfileCommandArgs {
    #[command(subcommand)]
    pub command: ProfileCommand,
}

#[derive(Debug, Subcommand)]
pub(super) enum ProfileCommand {
    List(ProfileListArgs),
    Show(ProfileShowArgs),
}

/// List the documents of CiA that come with the program
#[derive(Debug, Parser)]
pub(super) struct ProfileListArgs {
    /// How to write them
    #[arg(long, value_enum, default_value = "text")]
    pub format: ProfileFormat,
}

/// Show the objects of a profile, or all that it says of one
#[derive(Debug, Parser)]
pub(super) struct ProfileShowArgs {
    /// The number of the document, such as 401, or the file of a profile of your own (docs/profiles.md)
    pub profile: String,
    /// Only this object, with its sub-indexes and bits
    #[arg(value_name = "INDEX")]
    pub index: Option<Address>,
    /// How to write it
    #[arg(long, value_enum, default_value = "text")]
    pub format: ProfileFormat,
}

/// How profiles are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum ProfileFormat {
    /// For people: tables
    Text,
    /// For programs: one JSON document (docs/json.md)
    Json,
}

/// Put EDS and DCF files in the canonical order and spelling
///
/// Sections and keys are moved with the comments that belong to them; keys, section names, hex numbers and formulas are
/// spelled alike. What is read of the file stays the same. The standard input goes to the standard output.
#[derive(Debug, Parser)]
pub(super) struct FmtArgs {
    /// Files, folders and patterns such as `devices/**/*.eds`; `-` is the standard input
    #[arg(required = true, value_name = "PATH")]
    pub files: Vec<PathBuf>,
    /// Write nothing, print the names of the files that are not in order, and exit with 1 when there is one
    #[arg(long)]
    pub check: bool,
    /// Write nothing, print what would be changed, and exit with 1 when there is something
    #[arg(long, conflicts_with = "check")]
    pub diff: bool,
    #[command(flatten)]
    pub input: InputArgs,
}

/// List the rules that `check` knows
#[derive(Debug, Parser)]
pub(super) struct RulesArgs {
    /// How to write them
    #[arg(long, value_enum, default_value = "text")]
    pub format: RulesFormat,
    /// Only the rules of this group, such as cia301; may be given several times, or with commas between
    #[arg(long, value_name = "GROUP", value_delimiter = ',')]
    pub group: Vec<String>,
}

/// How rules are listed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum RulesFormat {
    /// A line each
    Text,
    /// One JSON document with their pages
    Json,
}

/// Print the page of a rule: what it checks, why it matters, how to mend it
#[derive(Debug, Parser)]
pub(super) struct ExplainArgs {
    /// The rule, such as cia306/duplicate-key; the name alone is enough where it is the only one
    pub rule: String,
}

/// Print what makes a shell complete the arguments
#[derive(Debug, Parser)]
pub(super) struct CompletionsArgs {
    /// The shell
    #[arg(value_enum)]
    pub shell: Shell,
}

/// Write the manual pages, one for each command
///
/// For packages. A page that is there with the same text is not touched.
#[derive(Debug, Parser)]
#[command(hide = true)]
pub(super) struct ManArgs {
    /// The folder that they go to, such as share/man/man1
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
}

/// A version of CiA 311, as an argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Version {
    #[value(name = "1.0")]
    V1_0,
    #[value(name = "1.1")]
    V1_1,
}

impl From<Version> for XddVersion {
    fn from(version: Version) -> Self {
        match version {
            Version::V1_0 => Self::V1_0,
            Version::V1_1 => Self::V1_1,
        }
    }
}

/// A kind of file that can be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum WrittenKind {
    Eds,
    Dcf,
    Xdd,
    Xdc,
    Json,
    Cdcf,
    #[value(name = "cdcf.txt")]
    CdcfText,
}

impl From<WrittenKind> for FileKind {
    fn from(kind: WrittenKind) -> Self {
        match kind {
            WrittenKind::Eds => Self::Eds,
            WrittenKind::Dcf => Self::Dcf,
            WrittenKind::Xdd => Self::Xdd,
            WrittenKind::Xdc => Self::Xdc,
            WrittenKind::Json => Self::Json,
            WrittenKind::Cdcf => Self::Cdcf,
            WrittenKind::CdcfText => Self::CdcfText,
        }
    }
}

/// A text of one line.
fn node_name(text: &str) -> Result<String, String> {
    if text.chars().any(char::is_control) {
        Err("a name is one line".to_owned())
    } else {
        Ok(text.to_owned())
    }
}

/// 1 to 127, in decimal or as `0x7F`.
pub(super) fn node_id(text: &str) -> Result<u8, String> {
    let number = match text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")) {
        Some(digits) => u8::from_str_radix(digits, 16).ok(),
        None => text.parse().ok(),
    };
    number.filter(|id| (1..=127).contains(id)).ok_or_else(|| "a node-ID is a number from 1 to 127".to_owned())
}

/// A severity, as an argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Deny {
    Note,
    Warning,
    Error,
}

impl From<Deny> for Severity {
    fn from(deny: Deny) -> Self {
        match deny {
            Deny::Note => Self::Note,
            Deny::Warning => Self::Warning,
            Deny::Error => Self::Error,
        }
    }
}
