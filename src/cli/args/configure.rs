//! The arguments of `objdict configure` and `objdict modules`.

use std::num::NonZeroUsize;
use std::path::PathBuf;

use clap::{Parser, ValueEnum};

use super::{node_id, node_name};
use crate::cli::input::{InputArgs, SizeArgs};
use crate::configure::Setting;
use crate::source::Encoding;

/// Make the DCF of a node out of an EDS
///
/// Every setting is checked against the dictionary before anything is written: that the entry is there and can be written,
/// that the value fits its type and its limits, that what is mapped can be mapped, that a CAN-ID is free. All that is wrong
/// is told at once, and the exit code is 1. The text of the EDS is edited, so comments, order and spelling stay.
#[derive(Debug, Parser)]
pub(in crate::cli) struct ConfigureArgs {
    /// The EDS, XDD or device as JSON; a DCF or XDC is configured further. `-` is the standard input
    pub file: PathBuf,
    /// The file to write; without it the standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// The node-ID
    #[arg(long, value_name = "N", value_parser = node_id)]
    pub node_id: Option<u8>,
    /// The bit rate in kbit/s
    #[arg(long, value_name = "KBIT/S", visible_alias = "bit-rate", value_parser = clap::value_parser!(u16).range(1..))]
    pub baudrate: Option<u16>,
    /// The name of the node
    #[arg(long, value_name = "NAME", visible_alias = "node-name", value_parser = node_name)]
    pub name: Option<String>,
    /// Give an entry a value: `1017=250`, `1800:2=0xFE`; may be given several times
    #[arg(long, value_name = "ENTRY=VALUE", value_parser = Setting::value)]
    pub set: Vec<Setting>,
    /// What a PDO carries: `tpdo1=6000:1,6401:2`; may be given several times
    #[arg(long, value_name = "PDO=ENTRIES", value_parser = Setting::map)]
    pub map: Vec<Setting>,
    /// The CAN-ID of a PDO: `rpdo2=0x2AA`, `tpdo1=$NODEID+0x180`, `tpdo3=off`; may be given several times
    #[arg(long, value_name = "PDO=ID", value_parser = Setting::cob_id)]
    pub cob_id: Vec<Setting>,
    /// Watch the heartbeat of a node: `7=750ms`; may be given several times
    #[arg(long, value_name = "NODE=TIME", value_parser = Setting::heartbeat_consumer)]
    pub heartbeat_consumer: Vec<Setting>,
    /// Settings in a file (docs/dcf.md); what is said here counts more
    #[arg(long = "from", value_name = "FILE")]
    pub from_file: Option<PathBuf>,
    /// The modules that are plugged into a coupler, by their numbers and in their order: `1,1,3`
    #[arg(long, value_name = "NUMBERS", value_delimiter = ',')]
    pub modules: Vec<u16>,
    /// Write the DCF although what `check` finds in it are errors that the EDS does not have
    #[arg(long)]
    pub force: bool,
    /// Which device of a network file (.nxdd, .nxdc), counted from 1
    #[arg(long, value_name = "NUMBER")]
    pub device: Option<NonZeroUsize>,
    /// The encoding of the file, where it cannot be found out: utf-8, windows-1252, cp850, utf-16le …
    #[arg(long, value_name = "ENCODING")]
    pub encoding: Option<Encoding>,
    #[command(flatten)]
    pub size: SizeArgs,
}

/// List the modules that a coupler supports, and what each brings
#[derive(Debug, Parser)]
pub(in crate::cli) struct ModulesArgs {
    /// The EDS or DCF of the coupler; `-` is the standard input
    pub file: PathBuf,
    /// How to write them
    #[arg(long, value_enum, default_value = "text")]
    pub format: ModulesFormat,
    #[command(flatten)]
    pub input: InputArgs,
}

/// How modules are listed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum ModulesFormat {
    /// For people
    Text,
    /// For programs: one JSON document (docs/json.md)
    Json,
}
