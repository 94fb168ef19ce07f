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
    /// Listens for heartbeats and boot-up messages, then reads 1000h and 1018h of every node-ID in the range. Writes nothing. Descriptions
    /// are matched by vendor-ID, product code and revision number; without --with, those in the current folder.
    Scan(BusScanArgs),
    /// Read entries of a node
    ///
    /// Exits with 1 if the node refuses an entry.
    Read(BusReadArgs),
    /// Write entries of a node
    ///
    /// Checks values against the description, shows the present and the new values, and asks before it writes. Each value is read back. Exits
    /// with 1 if the node refuses an entry.
    Write(BusWriteArgs),
    /// Save the present values of a node as a DCF or XDC
    ///
    /// Reads every parameter that the description lets be read and written. Process data, commands and domains are left out and listed. The file
    /// configures another node in the same way (`bus apply`).
    Save(BusSaveArgs),
    /// Configure a node with a DCF, a settings file or a concise DCF
    ///
    /// Writes in an order that devices accept, in state PRE-OPERATIONAL, and restores the state. First writes a file that undoes it. Refuses a
    /// node that is operational or whose drive is enabled. Exits with 1 if the node refuses an entry or answers another value.
    Apply(BusApplyArgs),
    /// Compare the devices on a bus with a network file
    ///
    /// Reports missing and extra nodes, other identities, and entries with other values. Exits with 1 if anything differs.
    Compare(BusCompareArgs),
    /// Restore the default parameters of a node (1011h)
    ///
    /// The defaults are valid after a reset or power-on.
    Restore(BusRestoreArgs),
    /// Send an NMT command: start, stop, reset nodes
    Nmt(BusNmtArgs),
    /// Find devices without a node-ID and assign node-ID and bit rate (LSS)
    Lss(BusLssArgs),
    /// Put a new device in the place of a node of a network
    ///
    /// Finds the device without a node-ID by LSS, checks vendor-ID and product code, assigns the node-ID, and configures it as the network file
    /// says.
    Replace(BusReplaceArgs),
}

// The bus, and how to behave on it.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Bus")]
pub(crate) struct BusLinkArgs {
    /// The bus: `socketcan:can0`, `slcan:/dev/ttyACM0@500` (kbit/s), `candump:FILE` (replays a log) or `sim:network.toml` (simulated nodes; with
    /// `,memory=FILE` they keep their state, `,new=N` makes node N a new device) [default: the variable OBJDICT_BUS]
    #[arg(long, value_name = "ADDRESS", value_parser = named_bus)]
    pub bus: Option<NamedBus>,
    /// Milliseconds to listen before the first frame is sent
    #[arg(long, value_name = "MS", default_value_t = 1000)]
    pub listen: u32,
    /// Milliseconds to wait for an answer
    #[arg(long, value_name = "MS", default_value_t = 500)]
    pub timeout: u32,
    /// Work on the node even if another client or master is heard on its SDO channel
    #[arg(long)]
    pub shared: bool,
    /// Write all frames to this file, as `candump -L` does
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
    /// A description of a node, or a network; `5=drive.eds` describes node 5; repeatable
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
    /// Show what would be sent and send nothing but reads
    #[arg(long)]
    pub dry_run: bool,
    /// Do not ask
    #[arg(short, long)]
    pub yes: bool,
    /// Also change a node that is operational, a drive that is enabled, a device with another identity than the description, and
    /// process data and commands that are otherwise left out
    #[arg(long)]
    pub force: bool,
}

#[derive(Debug, clap::Args)]
pub(crate) struct BusScanArgs {
    /// The node-IDs to ask
    #[arg(long, value_name = "FIRST-LAST", default_value = "1-127", value_parser = node_range)]
    pub nodes: RangeInclusive<u8>,
    /// Output format
    #[arg(long, value_enum, default_value = "table")]
    pub format: ShowFormat,
    #[command(flatten)]
    pub connect: BusConnectArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct BusReadArgs {
    /// The node-ID
    #[arg(value_name = "NODE", value_parser = node_id)]
    pub node: u8,
    /// What to read: an index such as 1018, 1018:1, a name, a PDO such as tpdo1, a pattern (see `objdict help names`). An object without a
    /// sub-index is read whole
    #[arg(required = true, value_name = "ENTRY")]
    pub entries: Vec<String>,
    /// Output format
    #[arg(long, value_enum, default_value = "table")]
    pub format: ShowFormat,
    #[command(flatten)]
    pub connect: BusConnectArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct BusWriteArgs {
    /// The node-ID
    #[arg(value_name = "NODE", value_parser = node_id)]
    pub node: u8,
    /// The values, by index or name: `1017=250`, `1017=1s`, `2001="a text"`, `Producer heartbeat time=default`
    #[arg(required = true, value_name = "ENTRY=VALUE", value_parser = Setting::value)]
    pub values: Vec<Setting>,
    /// Output format
    #[arg(long, value_enum, default_value = "table")]
    pub format: ShowFormat,
    #[command(flatten)]
    pub change: BusChangeArgs,
    #[command(flatten)]
    pub connect: BusConnectArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct BusSaveArgs {
    /// The node-ID
    #[arg(value_name = "NODE", value_parser = node_id)]
    pub node: u8,
    /// The file to write: a DCF of an EDS, an XDC of an XDD
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
    /// Output format of the list of differences to the description
    #[arg(long, value_enum, default_value = "table")]
    pub format: ShowFormat,
    #[command(flatten)]
    pub connect: BusConnectArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct BusApplyArgs {
    /// The node-ID
    #[arg(value_name = "NODE", value_parser = node_id)]
    pub node: u8,
    /// A DCF or XDC, a settings file of `configure` (.toml, with --with), or a concise DCF in any spelling
    pub file: PathBuf,
    /// Write all values of the file, also those that are defaults
    #[arg(long)]
    pub all: bool,
    /// Read back each value
    #[arg(long)]
    pub verify: bool,
    /// Go on after the node has refused an entry
    #[arg(long)]
    pub go_on: bool,
    /// Begin with this download of the list, counted from 1, to resume
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub start: usize,
    /// The file for the downloads that undo it, a new one [default: node-N-undo.cdcf.txt, or with a number]
    #[arg(long, value_name = "FILE")]
    pub undo: Option<PathBuf>,
    /// Write this date and time to 1020h, as in `2026-11-22T11:30`, so that a manager knows the configuration
    #[arg(long, value_name = "TIME", value_parser = configuration_time)]
    pub stamp: Option<ConfigurationTime>,
    /// Let the node store its parameters (1010h), after 1020h
    #[arg(long)]
    pub store: bool,
    /// Output format
    #[arg(long, value_enum, default_value = "table")]
    pub format: ShowFormat,
    #[command(flatten)]
    pub change: BusChangeArgs,
    #[command(flatten)]
    pub connect: BusConnectArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct BusCompareArgs {
    /// The network
    pub network: PathBuf,
    /// The state that every node must be in; nodes without a heartbeat do not show it
    #[arg(long, value_enum, value_name = "STATE")]
    pub state: Option<NodeState>,
    /// Output format
    #[arg(long, value_enum, default_value = "table")]
    pub format: ShowFormat,
    #[command(flatten)]
    pub connect: BusConnectArgs,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum NodeState {
    /// 7Fh in a heartbeat
    PreOperational = 0x7F,
    /// 05h
    Operational = 5,
    /// 04h
    Stopped = 4,
}

#[derive(Debug, clap::Args)]
pub(crate) struct BusRestoreArgs {
    /// The node-ID
    #[arg(value_name = "NODE", value_parser = node_id)]
    pub node: u8,
    /// What to restore, a sub-index of 1011h: 1 all, 2 communication, 3 application, 4 and more by vendor
    #[arg(long, value_name = "SUB", default_value_t = 1, value_parser = clap::value_parser!(u8).range(1..=127))]
    pub sub: u8,
    #[command(flatten)]
    pub change: BusChangeArgs,
    #[command(flatten)]
    pub connect: BusConnectArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct BusNmtArgs {
    /// The command
    #[arg(value_enum, value_name = "COMMAND")]
    pub command: NmtService,
    /// The node-ID, or `all`
    #[arg(value_name = "NODE", value_parser = node_or_all)]
    pub node: u8,
    /// Send a command to all nodes although some are heard
    #[arg(long)]
    pub alone: bool,
    #[command(flatten)]
    pub change: BusChangeArgs,
    #[command(flatten)]
    pub connect: BusConnectArgs,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum NmtService {
    /// Start: PDOs are sent and obeyed, so machines may move
    Start = 1,
    /// Stop: no SDOs and PDOs
    Stop = 2,
    /// SDOs but no PDOs
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
    /// Devices that have a node-ID do not answer. Of several devices the one with the lowest numbers is found.
    Scan(BusLssScanArgs),
    /// Assign a node-ID, and a bit rate from the next power-on
    Assign(BusLssAssignArgs),
    /// Print the commands that assign the node-IDs and the bit rate of a network
    ///
    /// Devices whose serial number the network file states are assigned on one bus; the others one by one.
    Plan(BusLssPlanArgs),
}

#[derive(Debug, clap::Args)]
pub(crate) struct BusLssScanArgs {
    /// Work on a bus on which other nodes are heard
    #[arg(long)]
    pub alone: bool,
    /// Output format
    #[arg(long, value_enum, default_value = "table")]
    pub format: ShowFormat,
    #[command(flatten)]
    pub connect: BusConnectArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct BusLssAssignArgs {
    /// The node-ID to assign
    #[arg(value_name = "NODE", value_parser = node_id)]
    pub node: u8,
    /// The device: vendor-ID, product code, revision number and serial number, as in `0x3F9:0x402:0x10001:7` [default: the device without a
    /// node-ID]
    #[arg(long, value_name = "V:P:R:S", value_parser = identity)]
    pub identity: Option<LssIdentity>,
    /// The bit rate in kbit/s from the next power-on
    #[arg(long, value_name = "KBIT/S", value_parser = lss_bit_rate)]
    pub bit_rate: Option<u16>,
    /// Work on a bus on which other nodes are heard
    #[arg(long)]
    pub alone: bool,
    #[command(flatten)]
    pub change: BusChangeArgs,
    #[command(flatten)]
    pub connect: BusConnectArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct BusLssPlanArgs {
    /// The network
    pub network: PathBuf,
    #[command(flatten)]
    pub input: NetworkInputArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct BusReplaceArgs {
    /// The node-ID
    #[arg(value_name = "NODE", value_parser = node_id)]
    pub node: u8,
    /// The network
    pub network: PathBuf,
    /// Let the node store its parameters (1010h)
    #[arg(long)]
    pub store: bool,
    /// Work on a bus on which other nodes are heard
    #[arg(long)]
    pub alone: bool,
    #[command(flatten)]
    pub change: BusChangeArgs,
    #[command(flatten)]
    pub connect: BusConnectArgs,
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
