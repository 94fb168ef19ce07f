//! The arguments of `objdict generate`.

use std::path::{Path, PathBuf};

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueEnum};

use crate::input::{ExpandArgs, InputArgs};
use crate::profile_option::ProfileArgs;
use crate::settings::{ConfigArgs, SEVERITIES};
use crate::values::{self, node_id};
use crate::written_files::OverwriteArgs;
use objdict_generate::{
    CTable, Derive, Names, OptionField, OptionValue, Options, PdoMappings, SharedCell, StackLayout,
    StorageGroup, Target,
};
use objdict_model::diagnostic::Severity;
use objdict_model::model::Address;

#[derive(Debug, Args)]
pub(crate) struct GenerateArgs {
    /// Device description; `-` is standard input
    pub file: PathBuf,
    /// Target to generate; repeatable or comma-separated
    #[arg(long = "target", required = true, value_name = "TARGET", value_delimiter = ',', value_parser = targets())]
    pub targets: Vec<String>,
    /// Output folder
    #[arg(short, long, alias = "out", value_name = "PATH", required_unless_present = "compare")]
    pub output: Option<PathBuf>,
    /// Existing header of the stack to compare with the tables instead of writing them; its source is in the same folder
    #[arg(long, value_name = "FILE", conflicts_with_all = ["output", "list", "stamp", "report"], help_heading = "Output")]
    pub compare: Option<PathBuf>,
    /// Print the names of the output files without writing them
    #[arg(long, help_heading = "Output")]
    pub list: bool,
    /// Stamp file for make, written on every successful run; other files are written only if they change
    #[arg(long, value_name = "FILE", help_heading = "Output")]
    pub stamp: Option<PathBuf>,
    /// Depfile for make: a rule with the inputs of the stamp file
    #[arg(long, value_name = "FILE", requires = "stamp", help_heading = "Output")]
    pub depfile: Option<PathBuf>,
    /// Complete the description with the CiA 301 objects that CANopenNode needs to compile and start
    #[arg(long, help_heading = "Stacks")]
    pub add_missing: bool,
    /// Write the output despite errors
    #[arg(long, help_heading = "Output")]
    pub force: bool,
    #[command(flatten)]
    pub options: OptionArgs,
    #[command(flatten, next_help_heading = "Output")]
    pub overwrite: OverwriteArgs,
    /// Report on the tables: flash and RAM usage, object by object
    #[arg(long, value_enum, value_name = "WHAT", help_heading = "Size")]
    pub report: Option<ReportArg>,
    /// Output format
    #[arg(
        long,
        alias = "report-format",
        value_enum,
        default_value = "table",
        value_name = "FORMAT",
        help_heading = "Size"
    )]
    pub format: SizeFormat,
    /// Maximum flash for the tables of a target, without code; exceeding it fails the run
    #[arg(long, value_name = "BYTES", help_heading = "Size")]
    pub max_flash: Option<usize>,
    /// Maximum RAM for the values; exceeding it fails the run
    #[arg(long, value_name = "BYTES", help_heading = "Size")]
    pub max_ram: Option<usize>,
    #[command(flatten)]
    pub expand: ExpandArgs,
    #[command(flatten)]
    pub input: InputArgs,
    #[command(flatten)]
    pub config: ConfigArgs,
    #[command(flatten)]
    pub profiles: ProfileArgs,
    /// Lowest severity that stops generation: note, warning or error [default: errors that make a table wrong]
    #[arg(long, value_parser = values::one_of(&SEVERITIES), value_name = "SEVERITY", hide_possible_values = true, help_heading = "Settings")]
    pub deny: Option<Severity>,
    /// Baseline from `check --write-baseline`; its findings are not reported
    #[arg(long, value_name = "FILE", help_heading = "Settings")]
    pub baseline: Option<PathBuf>,
}

impl GenerateArgs {
    /// The folder to write to.
    pub(crate) fn folder(&self) -> &Path {
        self.output.as_deref().unwrap_or(Path::new(""))
    }
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
        // The options of generated code.
        #[derive(Debug, Args)]
        pub(crate) struct OptionArgs {
            $(
                $(#[doc = $doc])+
                #[arg(long = $name, long_help = None::<&str>, $($clap)*)]
                $field: $argument,
            )+
        }

        impl OptionArgs {
            pub(crate) fn given(&self) -> Options {
                let mut options = Options::default();
                $(self.$field.give(&mut options.$field);)+
                options
            }
        }
    };
}

objdict_generate::with_options!(arguments);

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

fn one_of<T: OptionValue>() -> impl TypedValueParser<Value = T> {
    values::one_of(T::ALL)
}

/// What is reported about the output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ReportArg {
    /// Flash and RAM in bytes
    Size,
}

/// How a report is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum SizeFormat {
    /// Plain text
    Table,
    /// JSON document instead of the list of files (docs/reference/json.md)
    Json,
}

fn targets() -> PossibleValuesParser {
    let value = |target: Target| PossibleValue::new(target.name()).help(target.summary());
    PossibleValuesParser::new(Target::all().map(value))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Methods of the builder that have other names than the arguments.
    const RENAMED: [(&str, &str); 3] = [("file", "new"), ("output", "out_dir"), ("from", "from_kind")];

    /// Arguments that are about a terminal or make.
    const OF_THE_COMMAND: [&str; 11] = [
        "color",
        "quiet",
        "verbose",
        "help",
        "report",
        "format",
        "list",
        "stamp",
        "depfile",
        "add-missing",
        "compare",
    ];

    /// A build script can do all that the command can.
    #[test]
    fn every_other_argument_is_a_method_of_the_builder() {
        let builder = include_str!("../../../objdict-build/src/build_script/builder.rs");
        let mut command = GenerateArgs::augment_args(clap::Command::default());
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
                "`--{name}` has no method `{method}` in crates/objdict-build/src/build_script/builder.rs"
            );
        }
    }
}
