//! Arguments of `probe`.

use std::path::PathBuf;

use super::{BaselineArgs, InputArgs, OverwriteArgs, ReportArgs, SettingsArgs, indexes};

#[derive(Debug, clap::Args)]
#[command(mut_arg("compat", |tools| tools.hide(true)), mut_arg("profiles", |profiles| profiles.hide(true)))] // the description is not checked
#[command(mut_arg("node_id", |node| node.help("The node-ID [default: from the DCF or the log, else 1]")))]
pub(crate) struct ProbeArgs {
    /// The description of the device
    #[arg(required_unless_present = "learn")]
    pub file: Option<PathBuf>,
    /// The folder for `probe.py`, `probe.log` and `probe.csv`; with --learn the new description
    #[arg(short, long, value_name = "PATH", required_unless_present = "answers")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub overwrite: OverwriteArgs,
    /// Also try what must be refused, and write other values and then the ones before, without commands and communication objects
    #[arg(long, conflicts_with = "answers")]
    pub write: bool,
    /// Also write these objects, whose values are commands: 6040, 1010; repeatable, or separated by commas
    #[arg(long, value_name = "INDEX", value_delimiter = ',', value_parser = indexes, requires = "write")]
    pub write_object: Vec<std::ops::RangeInclusive<u16>>,
    /// Milliseconds between the frames of `probe.log`
    #[arg(long, value_name = "MS", default_value_t = 50, conflicts_with = "answers")]
    pub gap: u32,
    /// Judge these answers: the CSV or JSON that `probe.py` or a bench wrote, or a log of the bus (candump, ASC, TRC, pcap …)
    #[arg(long, value_name = "FILE", conflicts_with_all = ["overwrite"])]
    pub answers: Option<PathBuf>,
    /// Make an EDS of the answers of an unknown device
    #[arg(long, requires = "answers", requires = "output", conflicts_with = "file")]
    pub learn: bool,
    /// Also write all answers with their verdicts to this HTML file
    #[arg(long, value_name = "FILE", requires = "answers", conflicts_with = "learn")]
    pub html: Option<PathBuf>,
    #[command(flatten)]
    pub report: ReportArgs,
    #[command(flatten)]
    pub input: InputArgs,
    #[command(flatten)]
    pub settings: SettingsArgs,
    #[command(flatten)]
    pub baseline: BaselineArgs,
}
