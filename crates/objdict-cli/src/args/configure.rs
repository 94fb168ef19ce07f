//! The arguments of `objdict configure` and `objdict modules`.

use std::convert::Infallible;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

use clap::ValueEnum;

use super::report::PlainFormat;
use crate::canonical::DialectArgs;
use crate::input::{EntriesArgs, InputArgs, SizeArgs};
use crate::patch_option::PatchArgs;
use crate::settings::{ConfigFileArgs, reading};
use crate::values::{node_id, node_name, serial_number};
use crate::written_files::is_stdout;
use objdict_format::input::{FileKind, Reading};
use objdict_model::model::Moment;
use objdict_model::source::Encoding;
use objdict_node::configure::Setting;

#[derive(Debug, clap::Args)]
pub(crate) struct ConfigureArgs {
    /// EDS, XDD or device as JSON, or a DCF or XDC to change; `-` is standard input
    pub file: PathBuf,
    /// Output file [default: standard output]
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Edit the DCF or XDC in place
    #[arg(long, conflicts_with = "output")]
    pub in_place: bool,
    /// Node-ID (`$NODEID` in formulas) [default: from the DCF]
    #[arg(long, value_name = "N", value_parser = node_id)]
    pub node_id: Option<u8>,
    /// Bit rate in kbit/s [default: from the network or DCF]
    #[arg(long, alias = "baudrate", value_name = "KBIT/S", value_parser = clap::value_parser!(u16).range(1..))]
    pub bit_rate: Option<u16>,
    /// Node name
    #[arg(long, alias = "node-name", value_name = "NAME", value_parser = node_name)]
    pub name: Option<String>,
    /// Network number
    #[arg(long, value_name = "N")]
    pub net_number: Option<u32>,
    /// Network name
    #[arg(long, value_name = "NAME", value_parser = node_name)]
    pub network_name: Option<String>,
    /// Make the node the CANopen manager of the network [values: true (default), false]
    #[arg(long, value_name = "BOOL", num_args = 0..=1, require_equals = true, default_missing_value = "true", hide_possible_values = true)]
    pub manager: Option<bool>,
    /// LSS serial number (the serial number in 1018h)
    #[arg(long, value_name = "NUMBER", value_parser = serial_number)]
    pub lss_serial_number: Option<u32>,
    /// Update the CAN-IDs derived from the node-ID of a DCF when it changes (default)
    #[arg(long, overrides_with = "no_rebase")]
    rebase: bool,
    /// Keep all CAN-IDs when the node-ID changes
    #[arg(long)]
    pub no_rebase: bool,
    /// Value of an entry, by index or name: `1017=250`, `1017=1s`, `Producer heartbeat time=default`; repeatable
    #[arg(long, value_name = "ENTRY=VALUE", value_parser = Setting::value)]
    pub set: Vec<Setting>,
    /// Entries to map into a PDO, by index or name: `tpdo1=6000:1,6401:2`, `tpdo1=Statusword`; repeatable
    #[arg(long, value_name = "PDO=ENTRIES", value_parser = Setting::map)]
    pub map: Vec<Setting>,
    /// CAN-ID of a PDO: `rpdo2=0x2AA`, `tpdo1=$NODEID+0x180`, `tpdo2=auto`, `tpdo3=off`; repeatable
    #[arg(long, value_name = "PDO=ID", value_parser = Setting::cob_id)]
    pub cob_id: Vec<Setting>,
    /// Transmission type of a PDO: `tpdo1=sync/1`, `event`, `event-vendor`, `rtr` or a number; repeatable
    #[arg(long, value_name = "PDO=TYPE", value_parser = Setting::transmission)]
    pub transmission: Vec<Setting>,
    /// Inhibit time of a PDO: `tpdo1=5ms`; repeatable
    #[arg(long, value_name = "PDO=TIME", value_parser = Setting::inhibit)]
    pub inhibit: Vec<Setting>,
    /// Event timer of a PDO: `tpdo1=100ms`; repeatable
    #[arg(long, value_name = "PDO=TIME", value_parser = Setting::event_timer)]
    pub event_timer: Vec<Setting>,
    /// SYNC counter value at which a PDO starts: `tpdo1=3`; repeatable
    #[arg(long, value_name = "PDO=NUMBER", value_parser = Setting::sync_start)]
    pub sync_start: Vec<Setting>,
    /// SYNC settings: CAN-ID, `producer` or `consumer`, period, such as `producer,33ms`
    #[arg(long, value_name = "SYNC", value_parser = Setting::sync)]
    pub sync: Option<Setting>,
    /// CAN-ID of EMCY: `$NODEID+0x80`, `auto` or `off`
    #[arg(long, value_name = "ID", value_parser = Setting::emcy)]
    pub emcy: Option<Setting>,
    /// TIME settings: CAN-ID, `producer`, `consumer` or `off`, such as `0x100,consumer`
    #[arg(long, value_name = "TIME", value_parser = Setting::time)]
    pub time: Option<Setting>,
    /// Guard time and life time factor: `100msx3`
    #[arg(long, value_name = "TIMExFACTOR", value_parser = Setting::guard)]
    pub guard: Option<Setting>,
    /// Heartbeat consumer time for a node: `7=750ms`; repeatable
    #[arg(long, value_name = "NODE=TIME", value_parser = Setting::heartbeat_consumer)]
    pub heartbeat_consumer: Vec<Setting>,
    /// Downloads to send after the values of entries, in this order, even if the node already has the value: `6040=6,7,15`; repeatable
    #[arg(long, value_name = "ENTRY=VALUES", value_parser = |text: &str| Setting::downloads(Moment::After, text))]
    pub sdo: Vec<Setting>,
    /// Downloads to send before the values of entries; repeatable
    #[arg(long, value_name = "ENTRY=VALUES", value_parser = |text: &str| Setting::downloads(Moment::Before, text))]
    pub sdo_before: Vec<Setting>,
    /// Settings file (see `objdict help settings`); options override it
    #[arg(long, value_name = "FILE")]
    settings: Option<PathBuf>,
    /// Log of the bus or table of `probe` with the present values of a device; settings and options override them
    ///
    /// Process data, commands and domains are left out.
    #[arg(long, value_name = "FILE")]
    pub answers: Option<PathBuf>,
    /// Numbers of the modules plugged into a coupler, in order: `1,1,3`
    #[arg(long, value_name = "NUMBERS", value_delimiter = ',')]
    pub modules: Vec<u16>,
    /// Write the output despite errors
    #[arg(long)]
    pub force: bool,
    #[command(flatten)]
    pub dialect: DialectArgs,
    /// Input format [default: detected]
    #[arg(long, value_name = "FORMAT", value_parser = from, help_heading = "Input")]
    from: Option<From>,
    /// Number of the device in a network file (.nxdd, .nxdc) or ESI, starting at 1
    #[arg(long, value_name = "NUMBER", help_heading = "Input")]
    device: Option<NonZeroUsize>,
    /// Variant of a `device.toml` [default: the device without variants]
    #[arg(long, value_name = "NAME", help_heading = "Input")]
    variant: Option<String>,
    /// Input encoding if it cannot be detected: utf-8, windows-1252, cp850, utf-16le …
    #[arg(long, value_name = "ENCODING", help_heading = "Input")]
    encoding: Option<Encoding>,
    #[command(flatten)]
    entries: EntriesArgs,
    #[command(flatten)]
    pub size: SizeArgs,
    #[command(flatten)]
    pub patch: PatchArgs,
    #[command(flatten)]
    pub config: ConfigFileArgs,
}

/// What `--from` names: a format or, as it did in the past, a file of settings.
#[derive(Clone, Debug)]
enum From {
    Format(FileKind),
    Settings(PathBuf),
}

fn from(text: &str) -> Result<From, Infallible> {
    Ok(FileKind::from_str(text, false).map_or_else(|_| From::Settings(text.into()), From::Format))
}

impl ConfigureArgs {
    /// The file to write; `None` is the standard output.
    pub(crate) fn output(&self) -> Option<&Path> {
        let output = if self.in_place { Some(&self.file) } else { self.output.as_ref() };
        output.map(PathBuf::as_path).filter(|path| !is_stdout(path))
    }

    /// The file of settings.
    pub(crate) fn settings(&self) -> Option<&Path> {
        match (&self.settings, &self.from) {
            (None, Some(From::Settings(path))) => Some(path),
            (settings, _) => settings.as_deref(),
        }
    }

    /// How the input is read.
    pub(crate) fn reading(&self) -> Reading {
        let from = match self.from {
            Some(From::Format(kind)) => Some(kind),
            _ => None,
        };
        let (device, variant, encoding) = (self.device, self.variant.clone(), self.encoding);
        let (max_size, max_entries) = (self.size.max_size, self.entries.max_entries);
        let patches = self.patch.patches.clone();
        Reading {
            from,
            device,
            variant,
            encoding,
            max_size,
            max_entries,
            patches,
            is_node: true,
            ..reading()
        }
    }
}

#[derive(Debug, clap::Args)]
pub(crate) struct ModulesArgs {
    /// EDS or DCF of the coupler; `-` is standard input
    pub file: PathBuf,
    /// Output format
    #[arg(long, value_enum, default_value = "text")]
    pub format: PlainFormat,
    #[command(flatten)]
    pub input: InputArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct VariantsArgs {
    /// `device.toml`; `-` is standard input
    pub file: PathBuf,
    /// Output format
    #[arg(long, value_enum, default_value = "text")]
    pub format: VariantsFormat,
    #[command(flatten)]
    pub size: SizeArgs,
}

/// How variants are shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum VariantsFormat {
    /// Plain text
    Text,
    /// JSON document (docs/reference/json.md)
    Json,
    /// HTML page
    Html,
}
