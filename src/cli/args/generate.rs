//! The arguments of `objdict generate`.

use std::path::PathBuf;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args, Parser, ValueEnum};

use super::{ExpandArgs, node_id};
use crate::cli::input::InputArgs;
use crate::cli::profiles::ProfileArgs;
use crate::cli::settings::ConfigArgs;
use crate::generate::{
    CTable, Choice, Derive, Names, OptionField, OptionValue, Options, StorageGroup, Target,
};
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
    #[command(flatten)]
    pub options: OptionArgs,
    /// Generate although there are errors in the description
    #[arg(long, display_order = behind(Choice::NodeId))]
    pub force: bool,
    /// Show what the tables take in flash and RAM, object by object
    #[arg(long, value_enum, value_name = "WHAT", display_order = behind(Choice::Hooks))]
    pub report: Option<ReportArg>,
    /// How it is shown
    #[arg(long, value_enum, default_value = "table", requires = "report", value_name = "FORMAT", display_order = behind(Choice::Hooks) + 1)]
    pub report_format: SizeFormat,
    /// Generate nothing when the tables of a target take more flash, without the code that serves them
    #[arg(long, value_name = "BYTES", display_order = behind(Choice::Hooks) + 2)]
    pub max_flash: Option<usize>,
    /// Generate nothing when the values take more RAM
    #[arg(long, value_name = "BYTES", display_order = behind(Choice::Hooks) + 3)]
    pub max_ram: Option<usize>,
    #[command(flatten, next_display_order = 500)]
    pub expand: ExpandArgs,
    #[command(flatten)]
    pub input: InputArgs,
    #[command(flatten)]
    pub config: ConfigArgs,
    #[command(flatten)]
    pub profiles: ProfileArgs,
}

macro_rules! arguments {
    ($(
        $(#[doc = $doc:tt])+
        $choice:ident $name:literal {
            field: $field:ident: $type:ty = $default:expr,
            argument: $argument:ty [$($clap:tt)*],
            method: $method:ident($($parameter:ident: $of:ty),*) => $value:expr,
            $(needs: $feature:tt,)?
        }
    )+) => {
        /// The options of generated code.
        #[derive(Debug, Args)]
        pub(in crate::cli) struct OptionArgs {
            $(
                $(#[doc = $doc])+
                #[arg(long = $name, long_help = None::<&str>, display_order = order(Choice::$choice), $($clap)*)]
                $field: $argument,
            )+
        }

        impl OptionArgs {
            pub(in crate::cli) fn given(&self) -> Options {
                let mut options = Options::default();
                $(self.$field.give(&mut options.$field);)+
                options
            }
        }
    };
}

crate::generate::with_options!(arguments);

/// Where help shows an option of generated code: there is room behind each for arguments that belong to it.
fn order(choice: Choice) -> usize {
    10 * (choice as usize + 1)
}

fn behind(choice: Choice) -> usize {
    order(choice) + 1
}

/// What the command line gives for a setting.
trait Given<S> {
    fn give(&self, setting: &mut S);
}

/// A flag turns the setting over.
impl Given<bool> for bool {
    fn give(&self, setting: &mut bool) {
        *setting ^= self;
    }
}

impl<S: OptionField<Value: Clone>> Given<S> for Option<S::Value> {
    fn give(&self, setting: &mut S) {
        self.iter().for_each(|value| setting.put(value.clone()));
    }
}

impl<S: OptionField<Value: Clone>> Given<S> for Vec<S::Value> {
    fn give(&self, setting: &mut S) {
        self.iter().for_each(|value| setting.put(value.clone()));
    }
}

/// The names of a few values, each with what it is.
fn one_of<T: OptionValue>() -> impl TypedValueParser<Value = T> {
    let names = T::ALL.iter().map(|(_, name, help)| PossibleValue::new(*name).help(*help));
    PossibleValuesParser::new(names).try_map(|given| {
        let found = T::ALL.iter().find(|(_, name, _)| *name == given);
        found.map(|(value, ..)| *value).ok_or("there is no such value")
    })
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

fn targets() -> PossibleValuesParser {
    let value = |target: Target| PossibleValue::new(target.name()).help(target.summary());
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
    fn every_other_argument_is_a_method_of_the_builder() {
        let builder = include_str!("../../build_script/builder.rs");
        let mut command = GenerateArgs::command();
        command.build();
        let declared = OptionArgs::augment_args(clap::Command::default()); // their methods are made of the same lines
        for argument in command.get_arguments() {
            let name = argument.get_long().map_or(argument.get_id().as_str(), |long| long);
            let is_declared = declared.get_arguments().any(|declared| declared.get_id() == argument.get_id());
            if is_declared || OF_THE_COMMAND.contains(&name) {
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
