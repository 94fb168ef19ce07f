//! The arguments of `objdict network`.

use std::path::{Path, PathBuf};

use clap::{Subcommand, ValueEnum};

use super::report::{ReportArgs, ShowFormat};
use crate::baseline::BaselineArgs;
use crate::ending::Failure;
use crate::lock;
use crate::patch_option::PatchArgs;
use crate::settings::{CommandSettings, ConfigFileArgs, SettingsArgs, judge};
use crate::values::one_of;
use crate::written_files::OverwriteArgs;
use objdict_model::model::Date;
use objdict_model::source::Folder;
use objdict_network_file::{BootFiles, ConfigurationTime, PathOptions};
use objdict_node::configure::nanoseconds;

#[derive(Debug, clap::Args)]
pub(crate) struct NetworkArgs {
    #[command(subcommand)]
    pub command: NetworkCommand,
}

#[derive(Debug, Subcommand)]
#[command(defer = true)]
pub(crate) enum NetworkCommand {
    /// Check networks
    ///
    /// Exits with 1 if there are errors (see --deny) or with 2 if a file cannot be read.
    Check(NetworkCheckArgs),
    /// Build node and manager configurations
    ///
    /// Checks the network first and builds nothing if there is an error. Files are written atomically and only if they change.
    Build(NetworkBuildArgs),
    /// Verify that built files are unchanged
    ///
    /// `network build` writes SHA-256 hashes to `objdict.sha256`, which `sha256sum -c` also checks. Exits with 1 if a file is missing or
    /// was changed, or if a build was interrupted.
    Verify(NetworkVerifyArgs),
    /// Boot a network in simulated time
    ///
    /// The manager boots the nodes with the files of `network build`, which are built in memory or read from a folder. The nodes respond
    /// as described, and frames are arbitrated by CAN-ID. Prints each frame with its meaning, and when each node becomes operational.
    /// Exits with 1 if a node that the manager must boot does not become operational.
    Boot(NetworkBootArgs),
    /// Compute bus load and worst-case delays
    ///
    /// A message's worst-case delay runs from the moment it is due until it is on the bus. It follows from all messages of higher
    /// priority and the longest frame of lower priority (Davis, Burns, Bril, Lukkien 2007). It is compared with the deadline: the period,
    /// the event timer, the synchronous window, or the timeout of a receiver. Exits with 1 if a message may miss its deadline.
    Timing(NetworkTimingArgs),
    /// Show nodes, links and bus load
    ///
    /// Prints the nodes, links, CAN-IDs, boot plan and bus load of a network.
    Show(NetworkShowArgs),
    /// Draw a network's nodes and messages
    ///
    /// Each message is shown with its CAN-ID. SDO transfers are omitted.
    Graph(NetworkGraphArgs),
    /// Compare two networks
    ///
    /// Compares nodes, CAN-IDs, the boot plan, and the downloads and dictionary of each node; file names, comments and dates are ignored.
    /// Exits with 0 and prints nothing if everything built and shown is the same, or with 1 if anything differs.
    Diff(NetworkDiffArgs),
    /// Create a `network.toml` from descriptions
    ///
    /// Prints a file to start from. It contains the node-IDs, bit rate and manager from the descriptions, and comments on what can be
    /// added.
    Init(NetworkInitArgs),
    /// Print JSON Schemas of network files
    ///
    /// Editors use them for completion and validation.
    Schema(NetworkSchemaArgs),
}

// How the file of a network is read.
#[derive(Clone, Debug, Default, clap::Args)]
#[command(next_help_heading = "Input")]
pub(crate) struct NetworkPathArgs {
    /// Variable to replace in paths, as `@NAME@`, `$NAME` or `${NAME}`; repeatable
    #[arg(short = 'D', long = "define", value_name = "NAME=VALUE", value_parser = variable)]
    pub define: Vec<(String, String)>,
    /// Lock file with CAN-IDs and PDO numbers, which `network build` creates and updates
    #[arg(long, value_name = "FILE")]
    pub lock: Option<PathBuf>,
    #[command(flatten)]
    pub paths: AllowedPathArgs,
}

// How the descriptions that a network names are read.
#[derive(Clone, Debug, Default, clap::Args)]
#[command(next_help_heading = "Input")]
pub(crate) struct NetworkInputArgs {
    #[command(flatten)]
    pub paths: NetworkPathArgs,
    #[command(flatten)]
    pub patch: PatchArgs,
    #[command(flatten)]
    pub config: ConfigFileArgs,
}

impl NetworkInputArgs {
    /// How the descriptions of a network in this file are read.
    ///
    /// # Errors
    /// When its configuration, which names patches, cannot be used.
    pub(crate) fn options(&self, network: &Path) -> Result<PathOptions, Failure> {
        let of_config = SettingsArgs::from(&self.config);
        let mut patches = self.patch.patches.clone();
        patches.extend(CommandSettings::new(&of_config)?.patches_of(network)?);
        let variables = self.paths.define.iter().cloned().collect();
        let lock = self.paths.lock.as_deref().map(lock::read).transpose()?.unwrap_or_default();
        Ok(PathOptions { variables, patches, lock, ..self.paths.paths.options() })
    }
}

impl NetworkInputArgs {
    /// The same for a network that is built for the first time.
    pub(crate) fn without_lock(&self) -> Self {
        Self { paths: NetworkPathArgs { lock: None, ..self.paths.clone() }, ..self.clone() }
    }
}

impl NetworkPathArgs {
    /// The same with the patches of the input and a configuration.
    pub(crate) fn with(&self, patch: &PatchArgs, config: &ConfigFileArgs) -> NetworkInputArgs {
        NetworkInputArgs { paths: self.clone(), patch: patch.clone(), config: config.clone() }
    }
}

// Where the files may be that a file names.
#[derive(Clone, Debug, Default, clap::Args)]
#[command(next_help_heading = "Input")]
pub(crate) struct AllowedPathArgs {
    /// Additional folder from which files named in the input may be read; repeatable
    ///
    /// Without it, they must be in the project: the nearest parent folder with `objdict.toml` or `.git`, else the folder of the input.
    #[arg(long, value_name = "DIR")]
    pub allow_path: Vec<PathBuf>,
}

impl AllowedPathArgs {
    pub(crate) fn options(&self) -> PathOptions {
        PathOptions { allowed: self.allow_path.clone(), judge: Some(judge), ..PathOptions::default() }
    }

    /// The folders that files named in `file` may be read from.
    pub(crate) fn folder_of(&self, file: &Path) -> Folder {
        self.allow_path.iter().fold(Folder::of(file), Folder::allow)
    }
}

pub(super) fn configuration_time(text: &str) -> Result<ConfigurationTime, &'static str> {
    let time = || {
        let (date, time) = text.split_once('T')?;
        let days = Date::from_iso(date)?.days_after_1984().filter(|days| *days > 0)?;
        let (hours, minutes) = time.split_once(':')?;
        let number = |text: &str, end: u32| {
            let is_number = text.len() == 2 && text.bytes().all(|byte| byte.is_ascii_digit());
            text.parse::<u32>().ok().filter(|number| is_number && *number < end)
        };
        let minutes: u32 = number(hours, 24)? * 60 + number(minutes, 60)?;
        // midnight is a millisecond late, because 0 means that no time is expected
        Some(ConfigurationTime { days, milliseconds: (minutes * 60_000).max(1) })
    };
    time().ok_or("write date and time, as in `2026-11-22T11:30`")
}

/// A time of at most an hour in nanoseconds.
fn duration(text: &str) -> Result<u64, &'static str> {
    const HOUR: u64 = 3600 * 1_000_000_000;
    nanoseconds(text)
        .filter(|time| *time <= HOUR)
        .ok_or("write a time of at most an hour, as in `100ms` or `1.5s`")
}

/// A time of at least 100 µs and at most an hour in nanoseconds.
fn inhibit_time(text: &str) -> Result<u64, &'static str> {
    duration(text)
        .ok()
        .filter(|time| *time >= 100_000)
        .ok_or("write a time of 100 µs up to an hour, as in `10ms` or `500us`")
}

fn variable(text: &str) -> Result<(String, String), &'static str> {
    match text.split_once('=') {
        Some((name, value)) if !name.is_empty() => Ok((name.to_owned(), value.to_owned())),
        _ => Err("write a name and its value, as in `BUS_CONFIG_PATH=/opt/bus`"),
    }
}

#[derive(Debug, clap::Args)]
pub(crate) struct NetworkCheckArgs {
    /// Networks (`network.toml`, `bus.yml` of dcfgen or ros2_canopen, node lists); all descriptions together form one more
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    #[command(flatten)]
    pub report: ReportArgs,
    #[command(flatten)]
    pub paths: NetworkPathArgs,
    #[command(flatten)]
    pub patch: PatchArgs,
    #[command(flatten)]
    pub settings: SettingsArgs,
    #[command(flatten)]
    pub baseline: BaselineArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct NetworkBuildArgs {
    /// Network (`network.toml`, `bus.yml` of dcfgen or ros2_canopen, node list), or the descriptions of its nodes
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// Files to build
    #[arg(long, value_enum)]
    pub target: NetworkTarget,
    /// Output folder
    #[arg(short, long, value_name = "PATH")]
    pub output: PathBuf,
    #[command(flatten)]
    pub overwrite: OverwriteArgs,
    /// Date and time of the configuration, such as 2026-11-22T11:30, which nodes store in 1020h and the manager checks
    #[arg(long, value_name = "TIME", value_parser = configuration_time)]
    pub configured_at: Option<ConfigurationTime>,
    /// Write the output despite errors
    #[arg(long)]
    pub force: bool,
    /// Replay each configuration against its node and check the resulting network
    ///
    /// Exits with 1 if a node rejects a download or a rule finds an error.
    #[arg(long)]
    pub verify: bool,
    /// Store the PDO mappings of the nodes in the manager, like `dcfgen -r`
    #[arg(short, long, help_heading = "Lely")]
    pub remote_pdo: bool,
    /// Write the same bytes as dcfgen 2.4.2, including its errors; reject only files that dcfgen rejects
    #[arg(long, conflicts_with = "lock", help_heading = "Lely")]
    pub strict_dcfgen: bool,
    #[command(flatten)]
    pub input: NetworkInputArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct NetworkVerifyArgs {
    /// Folder to verify
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
}

#[derive(Debug, clap::Args)]
pub(crate) struct NetworkBootArgs {
    /// Network, descriptions of its nodes, or a folder from `network build`
    ///
    /// If the folder contains no node descriptions, also name the network that refers to them.
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// Files to build and boot [default: lely for bus.yml, dcf for others]
    #[arg(long, value_parser = one_of(&BOOT_FILES), value_name = "TARGET")]
    pub target: Option<BootFiles>,
    /// Output format
    #[arg(long, value_enum, default_value = "table")]
    pub format: ShowFormat,
    /// Show only the result of each node, without frames
    #[arg(long)]
    pub summary: bool,
    /// Bit rate in kbit/s [default: from the network or DCF]
    #[arg(long, value_name = "KBIT/S", value_parser = clap::value_parser!(u16).range(1..=1000), help_heading = "Simulation")]
    pub bit_rate: Option<u16>,
    /// Time that a node needs for a response or a reset, such as 1ms
    #[arg(long, value_name = "TIME", default_value = "1ms", value_parser = duration, help_heading = "Simulation")]
    pub response_time: u64,
    /// Simulated time after the boot
    #[arg(long, value_name = "TIME", default_value = "100ms", value_parser = duration, help_heading = "Simulation")]
    pub run_time: u64,
    /// Maximum simulated time, up to an hour
    #[arg(long, value_name = "TIME", default_value = "60s", value_parser = duration, help_heading = "Simulation")]
    pub time_limit: u64,
    #[command(flatten)]
    pub input: NetworkInputArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct NetworkTimingArgs {
    /// Network (`network.toml`, `bus.yml` of dcfgen or ros2_canopen, node list), or the descriptions of its nodes
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// Output format
    #[arg(long, value_enum, default_value = "table")]
    pub format: ShowFormat,
    /// SVG file for a diagram of what each node sends within at most a second, and its load
    #[arg(long, value_name = "PATH")]
    pub svg: Option<PathBuf>,
    /// Bit rate in kbit/s [default: from the network or DCF]
    #[arg(long, value_name = "KBIT/S", value_parser = clap::value_parser!(u16).range(1..=1000), help_heading = "Assumptions")]
    pub bit_rate: Option<u16>,
    /// Minimum time that a node needs to respond to an SDO or guarding request
    #[arg(long, value_name = "TIME", default_value = "1ms", value_parser = duration, help_heading = "Assumptions")]
    pub response_time: u64,
    /// Maximum delay from SYNC to transmission
    #[arg(long, value_name = "TIME", default_value = "0ms", value_parser = duration, help_heading = "Assumptions")]
    pub node_delay: u64,
    /// Inhibit time of event-driven PDOs that have none, such as 10ms
    #[arg(long, value_name = "TIME", value_parser = inhibit_time, help_heading = "Assumptions")]
    pub inhibit_time: Option<u64>,
    /// Assume no SDO transfers, as in a configured network
    #[arg(long, help_heading = "Assumptions")]
    pub no_sdo: bool,
    /// Assume that all nodes send emergencies as often as their inhibit time (1015h) allows
    #[arg(long, help_heading = "Assumptions")]
    pub emergencies: bool,
    /// Exit with 0 despite messages without a bound, if all others meet their deadlines
    #[arg(long)]
    pub allow_unbounded: bool,
    #[command(flatten)]
    pub input: NetworkInputArgs,
}

/// The files that boot a network.
const BOOT_FILES: [(BootFiles, &str, &str); 2] = [
    (BootFiles::Dcf, "dcf", "DCF of each node and of the manager"),
    (BootFiles::Lely, "lely", "Files of Lely's master; the nodes behave as described"),
];

/// What is built of a network.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum NetworkTarget {
    /// Files of Lely's master: master.dcf, master.bin and one .bin per node
    Lely,
    /// DCF of each node and of the manager
    Dcf,
    /// One concise DCF per node, in an order that nodes accept
    Concise,
    /// DCF of the manager, with the concise DCF of each node in 1F22h
    Manager,
    /// bus.yml of dcfgen, with the node descriptions
    Busyml,
    /// Node list (CiA 306-3) with the DCF of each node
    Cpj,
    /// C tables of the manager for custom firmware
    C,
    /// Rust tables of the manager for custom firmware
    Rust,
}

#[derive(Debug, clap::Args)]
pub(crate) struct NetworkShowArgs {
    /// Network (`network.toml`, `bus.yml` of dcfgen or ros2_canopen, node list), or the descriptions of its nodes
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// Output format
    #[arg(long, value_enum, default_value = "table")]
    pub format: ShowFormat,
    #[command(flatten)]
    pub input: NetworkInputArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct NetworkGraphArgs {
    /// Network (`network.toml`, `bus.yml` of dcfgen or ros2_canopen, node list), or the descriptions of its nodes
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// Output format
    #[arg(long, value_enum, default_value = "svg")]
    pub format: GraphFormat,
    #[command(flatten)]
    pub input: NetworkInputArgs,
}

/// A format of pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum GraphFormat {
    /// SVG diagram with a column per node and a row per message
    Svg,
    /// Graph for Graphviz
    Dot,
}

#[derive(Debug, clap::Args)]
pub(crate) struct NetworkDiffArgs {
    /// First network
    pub first: PathBuf,
    /// Second network
    pub second: PathBuf,
    #[command(flatten)]
    pub input: NetworkInputArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct NetworkInitArgs {
    /// Descriptions, files with several devices (`.nxdd`, `.nxdc`), and node lists
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    #[command(flatten)]
    pub paths: AllowedPathArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct NetworkSchemaArgs {
    /// File format
    #[arg(value_enum)]
    pub format: NetworkFormat,
}

/// A file format of networks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum NetworkFormat {
    /// bus.yml of dcfgen and ros2_canopen
    Bus,
    /// network.toml of objdict
    Network,
}
