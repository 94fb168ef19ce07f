//! The arguments of `objdict bus`.

use std::ops::RangeInclusive;
use std::path::PathBuf;

use clap::{Subcommand, ValueEnum};
use objdict_can::{BusAddress, LssIdentity, NoBusAddress};
use objdict_network_file::ConfigurationTime;
use objdict_node::configure::Setting;

use super::decode::described;
use super::network::configuration_time;
use super::{NetworkInputArgs, ShowFormat, WithFile};
use crate::values::{node_id, number};

#[derive(Debug, clap::Args)]
pub(crate) struct BusArgs {
    #[command(subcommand)]
    pub command: BusCommand,
}

#[derive(Debug, Subcommand)]
#[command(defer = true)]
pub(crate) enum BusCommand {
    /// List the nodes on a bus
    ///
    /// Listens for heartbeats and boot-up messages, then reads 1000h and 1018h of every node-ID in the range. Writes nothing. Matches
    /// descriptions by vendor-ID, product code and revision number; without --with, uses the descriptions in the current folder.
    Scan(BusScanArgs),
    /// Read entries of a node
    ///
    /// Exits with 1 if the node rejects an entry.
    Read(BusReadArgs),
    /// Write entries of a node
    ///
    /// Checks values against the description, shows the current and new values, and asks before it writes. Reads back each value. Exits with
    /// 1 if the node rejects an entry.
    Write(BusWriteArgs),
    /// Save a node's current values as a DCF or XDC
    ///
    /// Reads every parameter that is readable and writable in the description. Omits and lists process data, commands and domains. The file
    /// configures a different node in the same way (`bus apply`).
    Save(BusSaveArgs),
    /// Configure a node with a DCF, a settings file or a concise DCF
    ///
    /// Writes in an order that devices accept, in state PRE-OPERATIONAL, and restores the state. First creates a file that undoes the
    /// changes. Rejects a node that is operational or whose drive is enabled. Exits with 1 if the node rejects an entry or returns a
    /// different value.
    Apply(BusApplyArgs),
    /// Compare the devices on a bus with a network file
    ///
    /// Reports missing and extra nodes, and different identities and values. Exits with 1 if anything differs.
    Compare(BusCompareArgs),
    /// Watch a bus: verdict, nodes, load and incidents
    ///
    /// Shows them live on a terminal, and at the end as `decode --summary` does. Sends nothing.
    Watch(BusWatchArgs),
    /// Restore a node's default parameters (1011h)
    ///
    /// The defaults apply after a reset or power-on.
    Restore(BusRestoreArgs),
    /// Send an NMT command: start, stop, reset nodes
    Nmt(BusNmtArgs),
    /// Find devices without a node-ID and assign node-ID and bit rate (LSS)
    Lss(BusLssArgs),
    /// Replace a node of a network with a new device
    ///
    /// Finds the device without a node-ID by LSS, checks vendor-ID and product code, assigns the node-ID, and configures the device from the
    /// network file.
    Replace(BusReplaceArgs),
}

// The bus, and how to behave on it.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Bus")]
pub(crate) struct BusLinkArgs {
    /// Bus: `socketcan:can0`, `slcan:/dev/ttyACM0@500` (kbit/s, or `auto`), `candump:FILE` (replays a log) or `sim:network.toml` (simulated nodes; with
    /// `,memory=FILE` they keep their state, `,new=N` makes node N a new device) [default: from the variable OBJDICT_BUS]
    #[arg(long, value_name = "ADDRESS", value_parser = named_bus)]
    pub bus: Option<NamedBus>,
    /// Listening time before the first frame is sent, in milliseconds
    #[arg(long, value_name = "MS", default_value_t = 1000)]
    pub listen: u32,
    /// Response timeout in milliseconds
    #[arg(long, value_name = "MS", default_value_t = 500)]
    pub timeout: u32,
    /// Access the node even if a different client uses its SDO channel
    #[arg(long)]
    pub shared: bool,
    /// Log file for all frames, in `candump -L` format
    #[arg(long, value_name = "FILE")]
    pub log: Option<PathBuf>,
}

/// The address of a bus as it was given.
#[derive(Clone, Debug)]
pub(crate) struct NamedBus {
    pub address: BusAddress,
    pub name: String,
}

pub(crate) fn named_bus(text: &str) -> Result<NamedBus, NoBusAddress> {
    Ok(NamedBus { address: text.parse()?, name: text.to_owned() })
}

// The bus, and the descriptions of its nodes.
#[derive(Debug, clap::Args)]
pub(crate) struct BusConnectArgs {
    /// Output format
    #[arg(long, value_enum, default_value = "table")]
    pub format: ShowFormat,
    /// Network or node description, such as `5=drive.eds` for node 5; repeatable
    #[arg(long, value_name = "[N=]FILE", value_parser = described)]
    pub with: Vec<WithFile>,
    #[command(flatten)]
    pub link: BusLinkArgs,
    #[command(flatten)]
    pub input: NetworkInputArgs,
}

// What is asked before a node is changed.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Safety")]
pub(crate) struct BusChangeArgs {
    /// Show the writes without sending them (reads are sent)
    #[arg(long)]
    pub dry_run: bool,
    /// Skip the confirmation
    #[arg(short, long)]
    pub yes: bool,
    /// Also change operational nodes, enabled drives and devices with a wrong identity, and write process data and commands
    #[arg(long)]
    pub force: bool,
}

#[derive(Debug, clap::Args)]
pub(crate) struct BusScanArgs {
    /// Node-IDs to scan
    #[arg(long, value_name = "FIRST-LAST", default_value = "1-127", value_parser = node_range)]
    pub nodes: RangeInclusive<u8>,
    #[command(flatten)]
    pub connect: BusConnectArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct BusReadArgs {
    /// Node-ID
    #[arg(value_name = "NODE", value_parser = node_id)]
    pub node: u8,
    /// Entries to read: index such as 1018 or 1018:1, name, PDO such as tpdo1 or pattern (see `objdict help names`); without a sub-index,
    /// the whole object
    #[arg(required = true, value_name = "ENTRY")]
    pub entries: Vec<String>,
    /// Read again after this time, in milliseconds, and print the values that change
    #[arg(long, value_name = "MS", num_args = 0..=1, require_equals = true, default_missing_value = "500", value_parser = clap::value_parser!(u32).range(10..))]
    pub watch: Option<u32>,
    /// End after this time, in seconds [default: at Ctrl-C; after 10 s of a simulation]
    #[arg(long = "for", value_name = "SECONDS", requires = "watch", value_parser = clap::value_parser!(u32).range(1..))]
    pub duration: Option<u32>,
    #[command(flatten)]
    pub connect: BusConnectArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct BusWriteArgs {
    /// Node-ID
    #[arg(value_name = "NODE", value_parser = node_id)]
    pub node: u8,
    /// Values to write, by index or name: `1017=250`, `1017=1s`, `2001="a text"`, `Producer heartbeat time=default`
    #[arg(required = true, value_name = "ENTRY=VALUE", value_parser = Setting::value)]
    pub values: Vec<Setting>,
    #[command(flatten)]
    pub connect: BusConnectArgs,
    #[command(flatten)]
    pub change: BusChangeArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct BusSaveArgs {
    /// Node-ID
    #[arg(value_name = "NODE", value_parser = node_id)]
    pub node: u8,
    /// Output file: a DCF for an EDS, an XDC for an XDD
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
    #[command(flatten)]
    pub connect: BusConnectArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct BusApplyArgs {
    /// Node-ID
    #[arg(value_name = "NODE", value_parser = node_id)]
    pub node: u8,
    /// DCF, XDC, settings file of `configure` (.toml, with --with) or concise DCF in any format
    pub file: PathBuf,
    /// Write all values of the file, including defaults
    #[arg(long)]
    pub all: bool,
    /// Read back each value
    #[arg(long)]
    pub verify: bool,
    /// Continue after the node rejects an entry
    #[arg(long)]
    pub go_on: bool,
    /// Number of the first download to send, from 1, to resume
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub start: usize,
    /// New file for the downloads that undo the changes [default: node-N-undo.cdcf.txt, or with a number]
    #[arg(long, value_name = "FILE")]
    pub undo: Option<PathBuf>,
    /// Date and time to write to 1020h, such as `2026-11-22T11:30`, so that a manager recognizes the configuration
    #[arg(long, value_name = "TIME", value_parser = configuration_time)]
    pub stamp: Option<ConfigurationTime>,
    /// Store the node's parameters (1010h), after 1020h
    #[arg(long)]
    pub store: bool,
    #[command(flatten)]
    pub connect: BusConnectArgs,
    #[command(flatten)]
    pub change: BusChangeArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct BusCompareArgs {
    /// Network
    pub network: PathBuf,
    /// NMT state required of every node; nodes without a heartbeat do not show it
    #[arg(long, value_enum, value_name = "STATE")]
    pub state: Option<NodeState>,
    #[command(flatten)]
    pub connect: BusConnectArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct BusWatchArgs {
    /// Print each frame decoded, as `decode` does
    #[arg(long, conflicts_with = "check")]
    pub frames: bool,
    /// Exit with 1 if an incident is unresolved
    #[arg(long)]
    pub check: bool,
    /// End after this time, in seconds [default: at Ctrl-C; after 10 s of a simulation]
    #[arg(long = "for", value_name = "SECONDS", value_parser = clap::value_parser!(u32).range(1..))]
    pub duration: Option<u32>,
    #[command(flatten)]
    pub connect: BusConnectArgs,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum NodeState {
    /// Heartbeat value 7Fh
    PreOperational = 0x7F,
    /// Heartbeat value 05h
    Operational = 5,
    /// Heartbeat value 04h
    Stopped = 4,
}

#[derive(Debug, clap::Args)]
pub(crate) struct BusRestoreArgs {
    /// Node-ID
    #[arg(value_name = "NODE", value_parser = node_id)]
    pub node: u8,
    /// Sub-index of 1011h to restore: 1 all, 2 communication, 3 application, 4 or higher vendor-specific
    #[arg(long, value_name = "SUB", default_value_t = 1, value_parser = clap::value_parser!(u8).range(1..=127))]
    pub sub: u8,
    #[command(flatten)]
    pub connect: BusConnectArgs,
    #[command(flatten)]
    pub change: BusChangeArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct BusNmtArgs {
    /// NMT command
    #[arg(value_enum, value_name = "COMMAND")]
    pub command: NmtService,
    /// Node-ID, or `all`
    #[arg(value_name = "NODE", value_parser = node_or_all)]
    pub node: u8,
    /// Send a command to all nodes even if some are heard
    #[arg(long)]
    pub alone: bool,
    #[command(flatten)]
    pub connect: BusConnectArgs,
    #[command(flatten)]
    pub change: BusChangeArgs,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum NmtService {
    /// Start the node: PDOs take effect, so machines may move
    Start = 1,
    /// Stop the node: no SDOs or PDOs
    Stop = 2,
    /// Enter PRE-OPERATIONAL: SDOs but no PDOs
    PreOperational = 0x80,
    /// Reset the whole node
    Reset = 0x81,
    /// Reset the communication objects (1000h to 1FFFh)
    ResetCommunication = 0x82,
}

#[derive(Debug, clap::Args)]
pub(crate) struct BusLssArgs {
    #[command(subcommand)]
    pub command: BusLssCommand,
}

#[derive(Debug, Subcommand)]
#[command(defer = true)]
pub(crate) enum BusLssCommand {
    /// Find a device without a node-ID by fastscan
    ///
    /// Devices with a node-ID do not respond. If there are several devices, finds the device with the lowest numbers.
    Scan(BusLssScanArgs),
    /// Assign a node-ID, and a bit rate from the next power-on
    Assign(BusLssAssignArgs),
    /// Print the commands that assign a network's node-IDs and bit rate
    ///
    /// Devices whose serial number is in the network file are assigned on one bus, the others one by one.
    Plan(BusLssPlanArgs),
}

#[derive(Debug, clap::Args)]
pub(crate) struct BusLssScanArgs {
    /// Access the bus even if other nodes are heard
    #[arg(long)]
    pub alone: bool,
    #[command(flatten)]
    pub connect: BusConnectArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct BusLssAssignArgs {
    /// Node-ID to assign
    #[arg(value_name = "NODE", value_parser = node_id)]
    pub node: u8,
    /// Identity of the device: vendor-ID, product code, revision number and serial number, such as `0x3F9:0x402:0x10001:7` [default: the
    /// device without a node-ID]
    #[arg(long, value_name = "V:P:R:S", value_parser = identity)]
    pub identity: Option<LssIdentity>,
    /// Bit rate in kbit/s; tested before it is stored, unless the adapter cannot change its own
    #[arg(long, value_name = "KBIT/S", value_parser = lss_bit_rate)]
    pub bit_rate: Option<u16>,
    /// Access the bus even if other nodes are heard
    #[arg(long)]
    pub alone: bool,
    #[command(flatten)]
    pub connect: BusConnectArgs,
    #[command(flatten)]
    pub change: BusChangeArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct BusLssPlanArgs {
    /// Network
    pub network: PathBuf,
    /// Output format
    #[arg(long, value_enum, default_value = "table")]
    pub format: ShowFormat,
    #[command(flatten)]
    pub input: NetworkInputArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct BusReplaceArgs {
    /// Node-ID
    #[arg(value_name = "NODE", value_parser = node_id)]
    pub node: u8,
    /// Network
    pub network: PathBuf,
    /// Store the node's parameters (1010h)
    #[arg(long)]
    pub store: bool,
    /// Access the bus even if other nodes are heard
    #[arg(long)]
    pub alone: bool,
    #[command(flatten)]
    pub connect: BusConnectArgs,
    #[command(flatten)]
    pub change: BusChangeArgs,
}

fn node_or_all(text: &str) -> Result<u8, String> {
    if text == "all" { Ok(0) } else { node_id(text).map_err(|error| format!("{error}, or `all`")) }
}

fn identity(text: &str) -> Result<LssIdentity, &'static str> {
    let numbers: Option<Vec<u32>> = text.split(':').map(number).collect();
    let numbers = numbers.and_then(|numbers| numbers.try_into().ok());
    numbers.ok_or("write four numbers of 1018h with `:` between them, as in `0x3F9:0x402:0x10001:7`")
}

fn lss_bit_rate(text: &str) -> Result<u16, &'static str> {
    let rate = text.parse().ok().filter(|rate| objdict_can::lss_rate(*rate).is_some());
    rate.ok_or("the bit rate is 10, 20, 50, 100, 125, 250, 500, 800 or 1000 kbit/s")
}

/// `1-127`, or one node-ID.
fn node_range(text: &str) -> Result<RangeInclusive<u8>, String> {
    let (first, last) = text.split_once('-').unwrap_or((text, text));
    let id =
        |text| number(text).and_then(|number| u8::try_from(number).ok()).filter(|id| (1..=127).contains(id));
    match (id(first), id(last)) {
        (Some(first), Some(last)) if first <= last => Ok(first..=last),
        _ => Err("write node-IDs from 1 to 127, as in `1-16` or `5`".to_owned()),
    }
}
