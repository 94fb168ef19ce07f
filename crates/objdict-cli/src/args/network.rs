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
    /// Exits with 1 if there is a finding of severity error (see --deny), and with 2 if a file cannot be read.
    Check(NetworkCheckArgs),
    /// Build the configurations of the nodes and the manager of a network
    ///
    /// Checks the network first and builds nothing if there is an error. Files are written atomically, and only if they change.
    Build(NetworkBuildArgs),
    /// Verify that the files in a folder are unchanged since objdict wrote them
    ///
    /// `network build` writes their hashes (SHA-256) to `objdict.sha256`, which `sha256sum -c` checks too. Exits with 1 if a file is
    /// missing or was changed, or if a build was interrupted.
    Verify(NetworkVerifyArgs),
    /// Boot a network in simulated time
    ///
    /// The manager boots the nodes with the files of `network build`, which are built in memory or read from a folder. The nodes answer as their
    /// descriptions state, and frames are arbitrated by CAN-ID. Prints each frame with its meaning, and the time at which each node becomes
    /// operational. Exits with 1 if a node that the manager must boot does not become operational.
    Boot(NetworkBootArgs),
    /// Compute the bus load, and how long each message may take in the worst case
    ///
    /// The longest time from the moment at which a message is due until it is on the bus follows from all messages of higher priority and the
    /// longest frame of lower priority (Davis, Burns, Bril, Lukkien 2007). Prints it beside the deadline: the period, the event timer,
    /// the synchronous window, or the time that a receiver waits. Exits with 1 if a message may miss its deadline.
    Timing(NetworkTimingArgs),
    /// Show nodes, links, CAN-IDs, boot plan and bus load of a network
    Show(NetworkShowArgs),
    /// Draw the nodes of a network and their messages, each with its CAN-ID
    ///
    /// SDO transfers are left out.
    Graph(NetworkGraphArgs),
    /// Compare two networks: nodes, CAN-IDs, boot plan, and the downloads and dictionary of each node
    ///
    /// Prints nothing and exits with 0 if everything built and shown is the same, apart from file names, comments and dates. Exits with 1 if anything differs.
    Diff(NetworkDiffArgs),
    /// Print a `network.toml` to start from, for nodes with these descriptions
    ///
    /// The output contains the node-IDs, bit rate and manager that the descriptions state, and comments on what can be added.
    Init(NetworkInitArgs),
    /// Print the JSON Schema of a file format, for completion and validation in editors
    Schema(NetworkSchemaArgs),
}

// How the file of a network is read.
#[derive(Clone, Debug, clap::Args)]
#[command(next_help_heading = "Input")]
pub(crate) struct NetworkPathArgs {
    /// Replace `@NAME@`, `$NAME` and `${NAME}` in paths; repeatable
    #[arg(short = 'D', long = "define", value_name = "NAME=VALUE", value_parser = variable)]
    pub define: Vec<(String, String)>,
    /// Use the CAN-IDs and PDO numbers in this file, which `network build` creates and updates
    #[arg(long, value_name = "FILE")]
    pub lock: Option<PathBuf>,
    #[command(flatten)]
    pub paths: AllowedPathArgs,
}

// How the descriptions that a network names are read.
#[derive(Clone, Debug, clap::Args)]
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
#[derive(Clone, Debug, clap::Args)]
#[command(next_help_heading = "Input")]
pub(crate) struct AllowedPathArgs {
    /// Allow files named in the input to be read from this folder, in addition to the project: the nearest parent folder with `objdict.toml` or `.git`, else the folder of the input; repeatable
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

fn configuration_time(text: &str) -> Result<ConfigurationTime, &'static str> {
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
    /// Networks: `network.toml`, `bus.yml` of dcfgen or ros2_canopen, node lists; all descriptions together form one more
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
    /// The network: `network.toml`, `bus.yml` of dcfgen or ros2_canopen, a node list, or the descriptions of its nodes
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// The files to build
    #[arg(long, value_enum)]
    pub target: NetworkTarget,
    /// The folder to write to
    #[arg(short, long, value_name = "PATH")]
    pub output: PathBuf,
    #[command(flatten)]
    pub overwrite: OverwriteArgs,
    /// Date and time of the configuration, such as 2026-11-22T11:30: nodes store it in 1020h, and the manager checks it
    #[arg(long, value_name = "TIME", value_parser = configuration_time)]
    pub configured_at: Option<ConfigurationTime>,
    /// Build even if there are errors
    #[arg(long)]
    pub force: bool,
    /// Replay each configuration against its node, and check the resulting network; exit with 1 if a node refuses a download or a rule finds an error
    #[arg(long)]
    pub verify: bool,
    /// Store the mappings of the nodes' PDOs in the manager, like `dcfgen -r`
    #[arg(short, long, help_heading = "Lely")]
    pub remote_pdo: bool,
    /// Write the same bytes as dcfgen 2.4.2, including its errors; refuse only what dcfgen refuses
    #[arg(long, conflicts_with = "lock", help_heading = "Lely")]
    pub strict_dcfgen: bool,
    #[command(flatten)]
    pub input: NetworkInputArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct NetworkVerifyArgs {
    /// The folder
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
}

#[derive(Debug, clap::Args)]
pub(crate) struct NetworkBootArgs {
    /// The network, the descriptions of its nodes, or a folder that `network build` wrote; if the folder has no descriptions of
    /// nodes, also the network that names them
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// The files to build and boot [default: lely for bus.yml, dcf for others]
    #[arg(long, value_parser = one_of(&BOOT_FILES), value_name = "TARGET")]
    pub target: Option<BootFiles>,
    /// Output format
    #[arg(long, value_enum, default_value = "table")]
    pub format: ShowFormat,
    /// Omit the frames, and show only the result of each node
    #[arg(long)]
    pub summary: bool,
    /// The bit rate in kbit/s [default: that of the network]
    #[arg(long, value_name = "KBIT", value_parser = clap::value_parser!(u16).range(1..=1000), help_heading = "Simulation")]
    pub bit_rate: Option<u16>,
    /// The time that a node needs for an answer or a reset, such as 1ms
    #[arg(long, value_name = "TIME", default_value = "1ms", value_parser = duration, help_heading = "Simulation")]
    pub response_time: u64,
    /// How long to run the network after the boot
    #[arg(long, value_name = "TIME", default_value = "100ms", value_parser = duration, help_heading = "Simulation")]
    pub run_time: u64,
    /// The maximum simulated time, at most an hour
    #[arg(long, value_name = "TIME", default_value = "60s", value_parser = duration, help_heading = "Simulation")]
    pub time_limit: u64,
    #[command(flatten)]
    pub input: NetworkInputArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct NetworkTimingArgs {
    /// The network, or the descriptions of its nodes
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// Output format
    #[arg(long, value_enum, default_value = "table")]
    pub format: ShowFormat,
    /// Also write a picture: what each node sends in a time of at most a second, and its load
    #[arg(long, value_name = "PATH")]
    pub svg: Option<PathBuf>,
    /// The bit rate in kbit/s [default: that of the network]
    #[arg(long, value_name = "KBIT", value_parser = clap::value_parser!(u16).range(1..=1000), help_heading = "Assumptions")]
    pub bit_rate: Option<u16>,
    /// The least time that a node needs for the answer to an SDO or guarding request
    #[arg(long, value_name = "TIME", default_value = "1ms", value_parser = duration, help_heading = "Assumptions")]
    pub response_time: u64,
    /// The most time that a node needs after SYNC until it sends
    #[arg(long, value_name = "TIME", default_value = "0ms", value_parser = duration, help_heading = "Assumptions")]
    pub node_delay: u64,
    /// The inhibit time of event-driven PDOs that have none, such as 10ms
    #[arg(long, value_name = "TIME", value_parser = inhibit_time, help_heading = "Assumptions")]
    pub inhibit_time: Option<u64>,
    /// No SDO transfers, as in a network that is configured
    #[arg(long, help_heading = "Assumptions")]
    pub no_sdo: bool,
    /// All nodes send emergencies, as often as their inhibit time (1015h) allows
    #[arg(long, help_heading = "Assumptions")]
    pub emergencies: bool,
    /// Exit with 0 although messages have no bound, if those that have one meet their deadlines
    #[arg(long)]
    pub allow_unbounded: bool,
    #[command(flatten)]
    pub input: NetworkInputArgs,
}

/// The files that boot a network.
const BOOT_FILES: [(BootFiles, &str, &str); 2] = [
    (BootFiles::Dcf, "dcf", "The DCF of each node, and of the manager"),
    (BootFiles::Lely, "lely", "The files of Lely's master; the nodes are their descriptions"),
];

/// What is built of a network.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum NetworkTarget {
    /// The files of Lely's master: master.dcf, master.bin and one .bin per node
    Lely,
    /// The DCF of each node, and of the manager
    Dcf,
    /// One concise DCF per node, in an order that nodes accept
    Concise,
    /// The DCF of the manager, with the concise DCF of each node in 1F22h
    Manager,
    /// bus.yml of dcfgen, with the descriptions of the nodes
    Busyml,
    /// A node list (CiA 306-3) with the DCF of each node
    Cpj,
    /// C tables of the manager for its own firmware
    C,
    /// Rust tables of the manager for its own firmware
    Rust,
}

#[derive(Debug, clap::Args)]
pub(crate) struct NetworkShowArgs {
    /// The network, or the descriptions of its nodes
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
    /// The network, or the descriptions of its nodes
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
    /// A picture for browsers and documents, with a column for each node and a row for each message
    Svg,
    /// A graph that Graphviz lays out
    Dot,
}

#[derive(Debug, clap::Args)]
pub(crate) struct NetworkDiffArgs {
    /// The first network
    pub first: PathBuf,
    /// The second network
    pub second: PathBuf,
    #[command(flatten)]
    pub input: NetworkInputArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct NetworkInitArgs {
    /// Descriptions, files with several (`.nxdd`, `.nxdc`), and node lists
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    #[command(flatten)]
    pub paths: AllowedPathArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct NetworkSchemaArgs {
    /// The file format
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
