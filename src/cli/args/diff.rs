//! The arguments of `objdict diff`.

use std::path::PathBuf;

use clap::ValueEnum;

use super::network::AllowedPathArgs;
use crate::cli::changes::Choice;
use crate::cli::input::InputArgs;
use crate::cli::values::node_id;

#[derive(Debug, clap::Args)]
pub(in crate::cli) struct DiffArgs {
    /// The old description: EDS, DCF, XDD, XDC or JSON; `-` is standard input
    pub old: PathBuf,
    /// The new description, in any of these formats
    pub new: PathBuf,
    /// Output format
    #[arg(long, value_enum, default_value = "text")]
    pub format: DiffFormat,
    /// Report only these changes: a rule such as entry-renamed, a verdict such as breaking, an audience such as sdo-clients, or
    /// objects as in `show` or 2000-2FFF; repeatable, or separated by commas
    #[arg(long, value_name = "WHAT", value_delimiter = ',')]
    pub select: Vec<Choice>,
    /// Do not report these changes; repeatable, or separated by commas
    #[arg(long, value_name = "WHAT", value_delimiter = ',')]
    pub ignore: Vec<Choice>,
    /// Lowest verdict that fails the run: compatible, risky or breaking [default: breaking]
    #[arg(long, value_enum, value_name = "VERDICT", hide_possible_values = true)]
    pub deny: Option<DeniedVerdict>,
    /// Also report which downloads of this stored configuration the new device refuses: a concise DCF, DCF or XDC, or a network with
    /// nodes that are the old device
    #[arg(long, value_name = "FILE")]
    pub against: Option<PathBuf>,
    /// Evaluate formulas of the stored configuration for this node-ID [default: from the DCF]
    #[arg(long, value_name = "N", value_parser = node_id, requires = "against")]
    pub node_id: Option<u8>,
    #[command(flatten)]
    pub paths: AllowedPathArgs,
    #[command(flatten)]
    pub input: InputArgs,
}

/// How changes are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum DiffFormat {
    /// A line per change, and whom it affects
    Text,
    /// For programs: one JSON document (docs/json.md)
    Json,
    /// Tables, for release notes and pull requests
    Markdown,
    /// A page with both sides, PDO diagrams and a filter
    Html,
    /// Annotations of GitHub workflows
    Github,
}

/// The lowest verdict that fails the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum DeniedVerdict {
    /// Any change
    Compatible,
    /// Changes that are risky or breaking
    Risky,
    /// Changes that are breaking
    Breaking,
}
