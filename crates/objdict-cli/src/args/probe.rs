//! Arguments of `probe`.

use std::path::PathBuf;

use super::{BaselineArgs, InputArgs, OverwriteArgs, ReportArgs, SettingsArgs, indexes};

#[derive(Debug, clap::Args)]
#[command(mut_arg("compat", |tools| tools.hide(true)), mut_arg("profiles", |profiles| profiles.hide(true)))] // the description is not checked
#[command(mut_arg("node_id", |node| node.help("Node-ID (`$NODEID` in formulas) [default: from the DCF or the log, else 1]")))]
pub(crate) struct ProbeArgs {
    /// Device description
    #[arg(required_unless_present = "learn")]
    pub file: Option<PathBuf>,
    /// Folder for `probe.py`, `probe.log` and `probe.csv`; with --learn, the file of the new description
    #[cfg_attr(feature = "bus", arg(short, long, value_name = "PATH", required_unless_present_any = ["answers", "bus"]))]
    #[cfg_attr(
        not(feature = "bus"),
        arg(short, long, value_name = "PATH", required_unless_present = "answers")
    )]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub overwrite: OverwriteArgs,
    /// Also send requests that the device must reject, and change values and restore them
    ///
    /// Commands and communication objects are not written.
    #[arg(long, conflicts_with = "answers")]
    pub write: bool,
    /// Command objects to write as well, such as 6040 or 1010; repeatable or comma-separated
    #[arg(long, value_name = "INDEX", value_delimiter = ',', value_parser = indexes, requires = "write")]
    pub write_object: Vec<std::ops::RangeInclusive<u16>>,
    /// Interval between the frames of `probe.log` in milliseconds
    #[arg(long, value_name = "MS", default_value_t = 50, conflicts_with = "answers")]
    pub gap: u32,
    /// Responses to check: the CSV or JSON from `probe.py` or a test bench, or a bus log (candump, ASC, TRC, pcap …)
    #[arg(long, value_name = "FILE", conflicts_with_all = ["overwrite"])]
    pub answers: Option<PathBuf>,
    /// Create an EDS from the responses of an unknown device
    #[arg(long, requires = "answers", requires = "output", conflicts_with = "file")]
    pub learn: bool,
    /// HTML file for all responses with their verdicts
    #[arg(long, value_name = "FILE", requires = "answers", conflicts_with = "learn")]
    pub html: Option<PathBuf>,
    /// With --bus and --write: do not ask
    #[cfg(feature = "bus")]
    #[arg(short, long, requires_all = ["bus", "write"])]
    pub yes: bool,
    /// Ask the device on a bus, and judge what it answers
    #[cfg(feature = "bus")]
    #[command(flatten)]
    pub bus: super::BusLinkArgs,
    #[command(flatten)]
    pub report: ReportArgs,
    #[command(flatten)]
    pub input: InputArgs,
    #[command(flatten)]
    pub settings: SettingsArgs,
    #[command(flatten)]
    pub baseline: BaselineArgs,
}

#[cfg(feature = "bus")]
impl ProbeArgs {
    /// Whether the device itself is asked.
    pub(crate) fn is_on_bus(&self) -> bool {
        self.bus.bus.is_some() && self.answers.is_none()
    }
}
