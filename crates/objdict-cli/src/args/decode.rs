//! The arguments of `objdict decode`.

use std::path::PathBuf;

use clap::ValueEnum;
use clap::builder::{PossibleValuesParser, TypedValueParser};

use super::super::baseline::BaselineArgs;
use super::super::patch_option::PatchArgs;
use super::super::values::node_id;
use super::network::{NetworkInputArgs, NetworkPathArgs};
use super::{ReportArgs, ReportDetailArgs, ReportFormat, SettingsArgs};
use objdict_document::describe::frames::FrameKind;
use objdict_traffic as traffic;
use objdict_traffic::PlotChoice;
use objdict_traffic::log::LogTime;

#[derive(Debug, clap::Args)]
#[command(mut_arg("compat", |tools| tools.hide(true)), mut_arg("node_id", |node| node.hide(true)))] // descriptions are not checked
#[command(mut_arg("profiles", |profiles| profiles.help("Device profile for nodes without a description or profile number, such as 402")))]
#[command(mut_args(|arg| if ["baseline", "write_baseline"].contains(&arg.get_id().as_str()) { arg.requires("summary") } else { arg }))]
#[command(mut_arg("baseline", |file| file.help("Baseline whose incidents --summary omits")))]
#[command(mut_arg("write_baseline", |file| file.help("Baseline to write instead of showing the incidents")))]
#[command(mut_args(|arg| if ["all", "statistics", "deny"].contains(&arg.get_id().as_str()) { arg.requires("check") } else { arg }))]
pub(crate) struct DecodeArgs {
    /// Logs, merged by time; `-` is standard input, as in `candump -L can0 | objdict decode -`
    #[arg(required = true, value_name = "LOG")]
    pub logs: Vec<PathBuf>,
    /// Network or node description, such as `5=drive.eds` for node 5; repeatable
    ///
    /// Without a node-ID, a description applies to the node whose responses to 1000h and 1018h match, or to the only node of the log.
    #[arg(long, value_name = "[N=]FILE", value_parser = described)]
    pub with: Vec<WithFile>,
    /// Network or node description for one channel of the logs, such as `can0=plant.toml`; repeatable
    #[arg(long, value_name = "NAME=[N=]FILE", value_parser = of_channel)]
    pub channel: Vec<ChannelFile>,
    /// Output format
    #[arg(long, value_enum, default_value = "text")]
    pub format: DecodeFormat,
    /// Write CSV with one column per signal, held in memory, instead of one row per signal
    #[arg(long)]
    pub wide: bool,
    /// Maximum rows of --wide
    #[arg(long, value_name = "N", default_value_t = 1_000_000)]
    pub max_rows: usize,
    /// Show a verdict, incidents and statistics instead of frames
    ///
    /// Lists unresolved incidents first. Statistics cover bus load (at --bit-rate), measured and expected cycle times, aborted transfers,
    /// emergencies, and the configuration. With --check, exits with 1 if an incident is unresolved.
    #[arg(long, conflicts_with = "wide")]
    pub summary: bool,
    /// Number of an incident in --summary to show: its frames, likely causes, and what to check
    #[arg(short = 'd', long, value_name = "N", conflicts_with_all = ["summary", "wide"])]
    pub incident: Option<usize>,
    /// Report faults and deviations from the descriptions (rules `traffic/…`) instead of frames
    ///
    /// Formats: text, concise, json, sarif, github, gitlab and junit. Exits with 1 if there are errors.
    #[arg(long, conflicts_with = "wide")]
    pub check: bool,
    /// HTML file to write instead of frames: timeline, signal plots, and the statistics of --summary
    #[arg(long, value_name = "FILE", conflicts_with = "wide")]
    pub html: Option<PathBuf>,
    /// Signal to plot, by index or name, such as `6064`, `drive.6064` or `NMT state`; repeatable [default: the first 8 PDO signals that
    /// change]
    ///
    /// An index is in hex, with or without a sub-index. An index or name may follow a node, as in `5.Position actual value`.
    #[arg(long, value_name = "[NODE.]SIGNAL", requires = "html")]
    pub plot: Vec<PlotChoice>,
    /// Maximum points per plot; larger plots are downsampled and keep minima and maxima
    #[arg(long, value_name = "N", default_value_t = 2000, requires = "html", value_parser = points())]
    pub points: usize,
    #[command(flatten)]
    pub detail: ReportDetailArgs,
    /// Bit rate in kbit/s [default: from the network or DCF]
    #[arg(long, value_name = "KBIT/S", value_parser = clap::value_parser!(u16).range(1..=1000))]
    pub bit_rate: Option<u16>,
    /// Read the times of a candump log as intervals (candump -td) [default: detected from the first lines]
    #[arg(long)]
    pub distances: bool,
    #[command(flatten)]
    pub filter: FrameFilterArgs,
    #[command(flatten)]
    pub paths: NetworkPathArgs,
    #[command(flatten)]
    pub patch: PatchArgs,
    #[command(flatten)]
    pub settings: SettingsArgs,
    #[command(flatten)]
    pub baseline: BaselineArgs,
}

impl DecodeArgs {
    /// How descriptions and networks are read.
    pub(crate) fn input(&self) -> NetworkInputArgs {
        self.paths.with(&self.patch, self.settings.config_file())
    }

    /// Whether incidents are shown.
    pub(crate) const fn is_summary(&self) -> bool {
        self.summary || self.incident.is_some()
    }

    /// How findings are reported; `None` for a format of frames.
    pub(crate) fn report(&self) -> Option<ReportArgs> {
        let format = match self.format {
            DecodeFormat::Text => ReportFormat::Text,
            DecodeFormat::Json => ReportFormat::Json,
            DecodeFormat::Concise => ReportFormat::Concise,
            DecodeFormat::Sarif => ReportFormat::Sarif,
            DecodeFormat::Github => ReportFormat::Github,
            DecodeFormat::Gitlab => ReportFormat::Gitlab,
            DecodeFormat::Junit => ReportFormat::Junit,
            DecodeFormat::Csv => return None,
        };
        Some(ReportArgs { format, base: None, detail: self.detail.clone() })
    }
}

// Which frames are shown. The others are read too, because they change what these say.
#[derive(Debug, Default, clap::Args)]
#[command(next_help_heading = "Filter")]
pub(crate) struct FrameFilterArgs {
    /// Node to show, including NMT commands for it; repeatable
    #[arg(long, value_name = "N", value_parser = node_id)]
    pub only_node: Vec<u8>,
    /// Entry whose SDOs and PDOs to show, in hex: 6041 or 1018:1; repeatable
    #[arg(long, value_name = "INDEX[:SUB]", value_parser = address)]
    pub object: Vec<(u16, Option<u8>)>,
    /// Kind of frames to show; repeatable
    #[arg(long, value_name = "KIND", value_parser = kind())]
    pub kind: Vec<FrameKind>,
    /// Time of the first frames to show, in seconds as in the log
    #[arg(long, value_name = "SECONDS", allow_hyphen_values = true)]
    pub from: Option<LogTime>,
    /// Time of the last frames to show, in seconds as in the log
    #[arg(long, value_name = "SECONDS", allow_hyphen_values = true)]
    pub to: Option<LogTime>,
}

/// How frames are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum DecodeFormat {
    /// One line per frame
    Text,
    /// One JSON object per line and frame (`objdict schema frame`)
    Json,
    /// One row per signal, SDO or other frame
    Csv,
    /// With --check: one line per finding
    Concise,
    /// With --check: SARIF 2.1.0
    Sarif,
    /// With --check: GitHub workflow annotations
    Github,
    /// With --check: GitLab code quality report
    Gitlab,
    /// With --check: JUnit XML
    Junit,
}

impl DecodeFormat {
    /// Whether only findings are written in it.
    pub(crate) fn is_of_findings(self) -> bool {
        !matches!(self, Self::Text | Self::Json | Self::Csv)
    }
}

/// A file that describes a node or a network.
#[derive(Clone, Debug)]
pub(crate) struct WithFile {
    pub node_id: Option<u8>,
    pub path: PathBuf,
}

/// The same for a channel.
#[derive(Clone, Debug)]
pub(crate) struct ChannelFile {
    pub channel: String,
    pub file: WithFile,
}

pub(super) fn described(text: &str) -> Result<WithFile, String> {
    let number = text.split_once('=').filter(|(number, _)| number.bytes().all(|byte| byte.is_ascii_digit()));
    match number {
        Some((number, path)) => Ok(WithFile { node_id: Some(node_id(number)?), path: path.into() }),
        None => Ok(WithFile { node_id: None, path: text.into() }),
    }
}

fn of_channel(text: &str) -> Result<ChannelFile, String> {
    match text.split_once('=') {
        Some((channel, file)) if !channel.is_empty() && !file.is_empty() => {
            Ok(ChannelFile { channel: channel.to_owned(), file: described(file)? })
        }
        _ => Err("write a channel and its file, as in `can0=plant.toml`".to_owned()),
    }
}

fn address(text: &str) -> Result<(u16, Option<u8>), &'static str> {
    traffic::address(text)
        .ok_or("write an index in hex, with or without a sub-index, as in `6041` or `1018:1`")
}

fn points() -> impl TypedValueParser<Value = usize> {
    clap::value_parser!(u32).range(10..=100_000).map(|points| points as usize)
}

fn kind() -> impl TypedValueParser<Value = FrameKind> {
    let find = |word: String| FrameKind::ALL.into_iter().find(|kind| kind.name() == word);
    PossibleValuesParser::new(FrameKind::ALL.map(FrameKind::name))
        .map(move |word| find(word).unwrap_or(FrameKind::Unknown))
}
