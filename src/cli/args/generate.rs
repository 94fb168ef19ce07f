//! The arguments of `objdict generate`.

use std::path::PathBuf;

use clap::builder::PossibleValuesParser;
use clap::{Parser, ValueEnum};

use super::{ExpandArgs, node_id};
use crate::cli::input::InputArgs;
use crate::cli::profiles::ProfileArgs;
use crate::cli::settings::ConfigArgs;
use crate::generate::{CTable, Derive, Group, Names, Target};
use crate::model::Address;

/// Turn a description into what a product compiles or downloads
///
/// Checks the description first and generates nothing when there is an error in it. Files are only written when they
/// change, and then as a whole.
#[derive(Debug, Parser)]
pub(in crate::cli) struct GenerateArgs {
    /// The description; `-` is the standard input
    pub file: PathBuf,
    /// What to generate; may be given several times, or with commas between
    #[arg(long = "target", required = true, value_name = "TARGET", value_delimiter = ',', value_parser = targets())]
    pub targets: Vec<String>,
    /// The folder that the files go to
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Write nothing, print the names of the files that would be written
    #[arg(long)]
    pub list: bool,
    /// A file that is written each time when all is done, for make: the others are only written when they change
    #[arg(long, value_name = "FILE")]
    pub stamp: Option<PathBuf>,
    /// Write which files the stamp was made of, as a rule of make
    #[arg(long, value_name = "FILE", requires = "stamp")]
    pub depfile: Option<PathBuf>,
    /// The node-ID of the node; a DCF names its own
    #[arg(long, value_name = "N", value_parser = node_id)]
    pub node_id: Option<u8>,
    /// Generate although there are errors in the description
    #[arg(long)]
    pub force: bool,
    /// Room for a string that can be written and has a shorter default or none
    #[arg(long, value_name = "BYTES", value_parser = clap::value_parser!(u16).range(1..))]
    pub string_capacity: Option<u16>,
    /// Room for a DOMAIN that can be written; without it, only for its default
    #[arg(long, value_name = "BYTES")]
    pub domain_capacity: Option<u16>,
    /// What identifiers are made of
    #[arg(long, value_enum, default_value = "words", value_name = "OF")]
    pub names: NamesArg,
    /// Other names to make identifiers of: lines as `"2000sub1" = "target speed"`
    #[arg(long, value_name = "FILE")]
    pub rename: Option<PathBuf>,
    /// What C identifiers and files start with, instead of `od`
    #[arg(long, value_name = "WORD")]
    pub prefix: Option<String>,
    /// The name of the Rust module and its file, instead of `od`
    #[arg(long, value_name = "WORD")]
    pub module: Option<String>,
    /// The storage group of objects, as `2000-2FFF=PERSIST_APP`; may be given several times
    #[arg(long = "group", value_name = "INDEXES=NAME")]
    pub groups: Vec<Group>,
    /// Call the application before reads and after writes of an object or entry, as `6000` or `6000:1`; may be given several
    /// times, or with commas between
    #[arg(long = "hook", value_name = "ADDRESS", value_delimiter = ',')]
    pub hooks: Vec<Address>,
    /// Show what the tables take in flash and RAM, object by object
    #[arg(long, value_enum, value_name = "WHAT")]
    pub report: Option<ReportArg>,
    /// How it is shown
    #[arg(long, value_enum, default_value = "table", requires = "report", value_name = "FORMAT")]
    pub report_format: SizeFormat,
    /// Generate nothing when the tables of a target take more flash, without the code that serves them
    #[arg(long, value_name = "BYTES")]
    pub max_flash: Option<usize>,
    /// Generate nothing when the values take more RAM
    #[arg(long, value_name = "BYTES")]
    pub max_ram: Option<usize>,
    /// Keep `LowLimit` and `HighLimit` where the stack does not
    #[arg(long)]
    pub limits: bool,
    /// The template that the target `template` renders; its output is called like it without `.j2`
    #[arg(long, value_name = "FILE")]
    pub template: Option<PathBuf>,
    /// How the table of the target `c` is laid out
    #[arg(long, value_enum, default_value = "compact", value_name = "LAYOUT")]
    pub table: TableArg,
    /// Leave the names of entries out
    #[arg(long)]
    pub no_names: bool,
    /// Let the Rust file have names, PDOs and limits only with the features `od-names`, `od-pdo` and `od-limits`
    #[arg(long)]
    pub feature_gates: bool,
    /// Derive traits of other crates for the types of the Rust file
    #[arg(long, value_enum, value_name = "CRATE", value_delimiter = ',')]
    pub derive: Vec<DeriveArg>,
    #[command(flatten)]
    pub expand: ExpandArgs,
    #[command(flatten)]
    pub input: InputArgs,
    #[command(flatten)]
    pub config: ConfigArgs,
    #[command(flatten)]
    pub profiles: ProfileArgs,
}

/// What is reported of the output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum ReportArg {
    /// Bytes of flash and RAM
    Size,
}

/// How a report is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum SizeFormat {
    /// For people
    Table,
    /// For programs: one JSON document, in the place of the list of files (docs/json.md)
    Json,
}

/// What identifiers are made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum NamesArg {
    /// `ParameterName`
    Words,
    /// Index and sub-index
    Index,
}

impl From<NamesArg> for Names {
    fn from(names: NamesArg) -> Self {
        match names {
            NamesArg::Words => Self::Words,
            NamesArg::Index => Self::Index,
        }
    }
}

/// How the table of the target `c` is laid out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum TableArg {
    /// Short rows, with functions that answer as an SDO server does
    Compact,
    /// An array of structures with pointers, for a stack of one's own
    Structs,
}

impl From<TableArg> for CTable {
    fn from(table: TableArg) -> Self {
        match table {
            TableArg::Compact => Self::Compact,
            TableArg::Structs => Self::Structs,
        }
    }
}

/// A crate whose traits are derived.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum DeriveArg {
    /// `defmt::Format`
    Defmt,
    /// `serde::Serialize` and `serde::Deserialize`
    Serde,
}

impl From<DeriveArg> for Derive {
    fn from(derive: DeriveArg) -> Self {
        match derive {
            DeriveArg::Defmt => Self::Defmt,
            DeriveArg::Serde => Self::Serde,
        }
    }
}

fn targets() -> PossibleValuesParser {
    let value = |target: Target| clap::builder::PossibleValue::new(target.name()).help(target.summary());
    PossibleValuesParser::new(Target::all().map(value))
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::*;

    /// Methods of the builder that have other names than the arguments.
    const RENAMED: [(&str, &str); 3] = [("file", "new"), ("out", "out_dir"), ("from", "from_kind")];

    /// Arguments that are about a terminal or make; Cargo is told without being asked.
    const OF_THE_COMMAND: [&str; 7] =
        ["color", "help", "report", "report-format", "list", "stamp", "depfile"];

    /// Whatever the command can do, a build script can do.
    #[test]
    fn every_option_is_a_method_of_the_builder() {
        let builder = include_str!("../../build_script/builder.rs");
        let mut command = GenerateArgs::command();
        command.build();
        for argument in command.get_arguments() {
            let name = argument.get_long().map_or(argument.get_id().as_str(), |long| long);
            if OF_THE_COMMAND.contains(&name) {
                continue;
            }
            let renamed = RENAMED.iter().find(|(argument, _)| *argument == name);
            let method = renamed.map_or_else(|| name.replace('-', "_"), |(_, method)| (*method).to_owned());
            assert!(
                builder.contains(&format!("    pub fn {method}(")),
                "`--{name}` has no method `{method}` in src/build_script/builder.rs"
            );
        }
    }
}
