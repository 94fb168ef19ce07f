//! The arguments of `objdict diff`.

use std::path::{Path, PathBuf};

use clap::ValueEnum;

use super::network::AllowedPathArgs;
use super::new::{date, number};
use super::report::ReportArgs;
use crate::changes::ChangeChoice;
use crate::input::InputArgs;
use crate::settings::ConfigFileArgs;
use crate::values::{node_id, one_of};
use objdict_model::diagnostic::Severity;
use objdict_model::model::Date;

#[derive(Debug, clap::Args)]
#[command(
    override_usage = "objdict diff [OPTIONS] <OLD> <NEW>\n       objdict diff [OPTIONS] --git <REV> <NEW>"
)]
pub(crate) struct DiffArgs {
    #[command(flatten)]
    pub sides: SidesArgs,
    /// Output format
    #[arg(long, value_enum, default_value = "text")]
    pub format: DiffFormat,
    /// Changes to report exclusively; repeatable or comma-separated
    ///
    /// Use a rule such as entry-renamed, a verdict such as breaking, an audience such as sdo-clients, or objects as in `show` or
    /// 2000-2FFF.
    #[arg(long, value_name = "CHANGE", value_delimiter = ',')]
    pub select: Vec<ChangeChoice>,
    /// Changes to ignore; repeatable or comma-separated
    #[arg(long, value_name = "CHANGE", value_delimiter = ',')]
    pub ignore: Vec<ChangeChoice>,
    /// Lowest verdict that fails the run: compatible, risky or breaking [default: breaking]
    #[arg(long, value_parser = one_of(&VERDICTS), value_name = "VERDICT", hide_possible_values = true)]
    pub deny: Option<Severity>,
    /// Stored configuration to check against the new device: a concise DCF, DCF or XDC, or a network with nodes that are the old device
    ///
    /// Also reports which of its downloads the new device rejects.
    #[arg(long, value_name = "FILE")]
    pub against: Option<PathBuf>,
    /// Node-ID (`$NODEID`) of the stored configuration [default: from the DCF]
    #[arg(long, value_name = "N", value_parser = node_id, requires = "against")]
    pub node_id: Option<u8>,
    #[command(flatten)]
    pub paths: AllowedPathArgs,
    #[command(flatten)]
    pub input: InputArgs,
    #[command(flatten)]
    pub config: ConfigFileArgs,
}

// Which descriptions are compared.
#[derive(Debug, clap::Args)]
pub(crate) struct SidesArgs {
    /// Old description: EDS, DCF, XDD, XDC or JSON; `-` is standard input; omitted with --git
    pub old: PathBuf,
    /// New description, in any of these formats
    #[arg(required_unless_present = "git", conflicts_with = "git")]
    pub new: Option<PathBuf>,
    /// Git revision of the old description, such as origin/main, in the repository of the new one
    #[arg(long, value_name = "REV")]
    pub git: Option<String>,
}

impl SidesArgs {
    /// The new description: the only one beside a revision.
    pub(crate) fn newer(&self) -> &Path {
        self.new.as_deref().unwrap_or(&self.old)
    }
}

#[derive(Debug, clap::Args)]
#[command(
    override_usage = "objdict release [OPTIONS] <OLD> <NEW>\n       objdict release [OPTIONS] --git <REV> <NEW>"
)]
pub(crate) struct ReleaseArgs {
    #[command(flatten)]
    pub sides: SidesArgs,
    /// Bump outdated versions in the new description; change nothing else
    #[arg(long)]
    pub fix: bool,
    /// Print the changes without writing them; exit with 1 if there are any
    #[arg(long)]
    pub diff: bool,
    /// Product code of the new device if it must change, such as 418 or 0x1A2
    #[arg(long, value_name = "NUMBER", value_parser = number)]
    pub product_code: Option<u32>,
    /// Date of the description, such as 2026-11-21 [default: SOURCE_DATE_EPOCH, else now]
    #[arg(long, value_name = "DATE", value_parser = date)]
    pub date: Option<Date>,
    #[command(flatten)]
    pub report: ReportArgs,
    #[command(flatten)]
    pub input: InputArgs,
    #[command(flatten)]
    pub config: ConfigFileArgs,
}

/// How changes are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum DiffFormat {
    /// One line per change, with the audiences that it affects
    Text,
    /// JSON document (docs/reference/json.md)
    Json,
    /// Tables for release notes and pull requests
    Markdown,
    /// HTML page with both sides, PDO diagrams and a filter
    Html,
    /// GitHub workflow annotations
    Github,
}

/// The lowest verdict that fails the run, as the severity of a finding about such a change.
const VERDICTS: [(Severity, &str, &str); 3] = [
    (Severity::Note, "compatible", "Any change"),
    (Severity::Warning, "risky", "Risky or breaking changes"),
    (Severity::Error, "breaking", "Breaking changes"),
];
