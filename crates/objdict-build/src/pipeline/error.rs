//! The reasons why nothing was generated.

use std::fmt::{self, Display};
use std::io;
use std::path::PathBuf;

use crate::output::OutputError;
use objdict_format::{EditError, ReadError};
use objdict_generate::{ChoiceError, GenerateError, Note};
use objdict_model::diagnostic::{Findings, one_line, plural};
use objdict_model::model::Place;
use objdict_model::source::SourceError;
#[cfg(feature = "lint")]
use objdict_profile::OpenError;
#[cfg(feature = "full")]
use objdict_project::baseline::BaselineError;
#[cfg(feature = "lint")]
use objdict_project::report::problem;

/// The reason why a build script generated nothing.
///
/// `Display` is one sentence, and `Debug` is suitable for build output: the sentence, the findings with their places,
/// and the help. So `fn main() -> Result<(), Error>` reports all of it.
#[non_exhaustive]
pub enum Error {
    /// The description cannot be read.
    Input(ReadError),
    /// A configuration, or a file in an option, cannot be read.
    Config(SourceError),
    /// A profile cannot be used.
    #[cfg(feature = "lint")]
    Profile(OpenError),
    /// A baseline cannot be used.
    #[cfg(feature = "full")]
    Baseline {
        /// The file.
        path: PathBuf,
        /// Why.
        error: BaselineError,
    },
    /// Errors in the description make a table wrong, or the configuration has errors.
    Findings {
        /// The file that they are in.
        file: String,
        /// The findings that stop the generation, errors first.
        findings: Findings,
        /// `error`, or `finding` if a lower severity stops the generation.
        noun: &'static str,
        /// The errors with their places: excerpts, or one line each if the crate is built without the feature
        /// `cli`.
        report: String,
    },
    /// No rule and no group has this name.
    UnknownRule {
        /// The name.
        name: String,
    },
    /// The file of names cannot be used.
    Names {
        /// The file.
        file: String,
        /// Its problems.
        error: ChoiceError,
    },
    /// An option has a value that it cannot have.
    Choice(ChoiceError),
    /// A target cannot express the device.
    Target {
        /// The target.
        target: &'static str,
        /// Why.
        error: GenerateError,
    },
    /// The tables exceed a limit.
    TooLarge {
        /// The target.
        target: &'static str,
        /// `flash` or `RAM`.
        memory: &'static str,
        /// Their size.
        bytes: usize,
        /// The limit.
        most: usize,
    },
    /// A limit is set, but the table size is unknown for all targets.
    NotMeasured {
        /// The first of the targets.
        target: &'static str,
        /// The reason why the size is unknown.
        why: &'static str,
    },
    /// The file name for a conversion does not belong to a format that can describe the device.
    NoFormat {
        /// The file.
        path: PathBuf,
    },
    /// The description cannot be converted to another format.
    Conversion {
        /// The file.
        path: PathBuf,
        /// Why.
        error: EditError,
    },
    /// A file cannot be written.
    Output(OutputError),
    /// No output folder is set.
    NoOutDir,
    /// The output to Cargo failed.
    Cargo(io::Error),
}

objdict_model::error_messages! { Error:
    from ReadError as Input
    from SourceError as Config
    #[cfg(feature = "lint")]
    from OpenError as Profile
    from ChoiceError as Choice
    from OutputError as Output
{
    Self::Input(error) => "{error}";
    Self::Config(error) => "{error}";
    #[cfg(feature = "lint")]
    Self::Profile(error) => "{error}";
    #[cfg(feature = "full")]
    Self::Baseline { path, error } => "`{}` {error}", objdict_model::source::shown(path);
    Self::Findings { file, findings, noun, .. } =>
        "`{file}` has {}, so nothing was generated", plural(findings.len(), noun);
    Self::UnknownRule { name } => "unknown rule or group `{name}`";
    Self::Names { file, error } =>
        "{file}{}: {error}", error.line.map(|line| format!(":{line}")).unwrap_or_default();
    Self::Choice(error) => "{error}";
    Self::Target { target, error } => "target `{target}`: {error}";
    Self::TooLarge { target, memory, bytes, most } =>
        "target `{target}`: the tables use {bytes} bytes of {memory}, more than the limit of {most}";
    Self::NotMeasured { target, why } =>
        "target `{target}`: the size of the tables is unknown and cannot be limited: {why}";
    Self::NoFormat { path } => "the description cannot be written as `{}`", objdict_model::source::shown(path);
    Self::Conversion { path, error } =>
        "the description cannot be written as `{}`: {error}", objdict_model::source::shown(path);
    Self::Output(error) => "{error}";
    Self::NoOutDir => "the variable `OUT_DIR` is not set";
    Self::Cargo(error) => "cannot write to Cargo: {error}";
} }

impl Error {
    /// How to fix the error, if known.
    pub fn help(&self) -> Option<String> {
        match self {
            Self::Input(ReadError::SeveralDevices { .. }) => {
                Some("choose one with `device`, counted from 1".to_owned())
            }
            Self::Input(error) => error.help(),
            #[cfg(feature = "lint")]
            Self::Profile(error) => error.help(),
            Self::Findings { .. } => Some(
                "fix them, lower the severity of a rule with `severity`, or generate anyway with `force`"
                    .to_owned(),
            ),
            #[cfg(feature = "full")]
            Self::Baseline { path, .. } => Some(format!(
                "`objdict check --write-baseline {}` recreates it",
                objdict_model::source::shown(path)
            )),
            Self::UnknownRule { name } => Some(match objdict_project::registry::nearest_selection(name) {
                Some(meant) => format!("did you mean `{meant}`?"),
                None => "`objdict rules` lists all".to_owned(),
            }),
            Self::Names { .. } => {
                Some("write a line as `\"2000sub1\" = \"target speed\"` for each name".to_owned())
            }
            Self::TooLarge { .. } => {
                Some("`objdict generate --report size` shows what each object takes".to_owned())
            }
            Self::NotMeasured { .. } => Some("see the linker map file".to_owned()),
            Self::NoOutDir => {
                Some("Cargo sets it for build scripts; otherwise set the folder with `out_dir`".to_owned())
            }
            Self::NoFormat { .. } => Some("name a file that ends in .eds or .xdd".to_owned()),
            Self::Output(error) => error.help("overwrite"),
            Self::Config(_)
            | Self::Choice(_)
            | Self::Target { .. }
            | Self::Conversion { .. }
            | Self::Cargo(_) => None,
        }
    }

    /// The problems with places and lines; `None` if the sentence is complete.
    pub fn report(&self) -> Option<String> {
        match self {
            Self::Findings { report, .. } => Some(report.clone()),
            #[cfg(feature = "lint")]
            Self::Profile(OpenError::Invalid { source_file, error }) => {
                let help = error.help.as_deref();
                error.span.map(|span| problem(source_file, span, &error.message, help))
            }
            Self::Target { target, error: GenerateError::NoEntries { notes } } if !notes.is_empty() => {
                Some(notes.iter().map(|note| report_lines(target, note)).collect())
            }
            _ => None,
        }
    }
}

/// A note with its advice, as lines.
pub fn report_lines(target: &str, note: &Note) -> String {
    let mut text = format!("{}: {target}: {}\n", note.severity, placed(note));
    if let Some(help) = &note.help {
        text.push_str(&format!("  help: {help}\n"));
    }
    text
}

/// The message of a note with its place; a note about the whole device has none.
pub fn placed(note: &Note) -> String {
    if note.place == Place::device() { note.message.clone() } else { note.to_string() }
}

impl fmt::Debug for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let lines = |f: &mut fmt::Formatter<'_>, text: &dyn Display| -> fmt::Result {
            let text = text.to_string();
            text.trim_end().lines().try_for_each(|line| writeln!(f, "{}", one_line(line)))
        };
        lines(f, self)?;
        if let Some(report) = self.report() {
            writeln!(f)?;
            lines(f, &report)?;
            writeln!(f)?;
        }
        match self.help() {
            Some(help) => write!(f, "  help: {}", one_line(&help)),
            None => Ok(()),
        }
    }
}
