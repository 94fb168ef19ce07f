//! The arguments of `objdict patch`.

use std::path::PathBuf;

use clap::Subcommand;

use crate::input::InputArgs;
use crate::settings::SettingsArgs;

#[derive(Debug, clap::Args)]
pub(crate) struct PatchCommandArgs {
    #[command(subcommand)]
    pub command: PatchCommand,
}

#[derive(Debug, Subcommand)]
#[command(defer = true)]
pub(crate) enum PatchCommand {
    /// Write a patched description
    ///
    /// The text of the vendor is edited: comments, order and spelling stay. What the format has no place for is stored in comment lines of
    /// objdict (docs/reference/formats.md). Exits with 2 if the file does not say what the patch expects.
    Apply(PatchApplyArgs),
    /// Make a patch of an original and an edited description
    ///
    /// The patch has the differences of the content, field by field, each with what the original says.
    Make(PatchMakeArgs),
    /// Compare patches with the descriptions that they are for
    ///
    /// Shows for each patch and file whether it applies, is no longer needed, or expects something else. Exits with 1 if a patch does not
    /// apply or is for none of the files.
    Check(PatchCheckArgs),
}

#[derive(Debug, clap::Args)]
pub(crate) struct PatchApplyArgs {
    /// The description; `-` is standard input
    pub file: PathBuf,
    /// The file to write; `-` is standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
    #[command(flatten)]
    pub input: InputArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct PatchMakeArgs {
    /// The description as it came
    pub original: PathBuf,
    /// The edited description
    pub edited: PathBuf,
    /// The patch to write; `-` is standard output
    #[arg(short, long, value_name = "FILE", default_value = "-")]
    pub output: PathBuf,
    #[command(flatten)]
    pub input: InputArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct PatchCheckArgs {
    /// Files, folders and patterns such as `devices/**/*.eds`
    #[arg(default_value = ".", value_name = "PATH")]
    pub files: Vec<PathBuf>,
    #[command(flatten)]
    pub input: InputArgs,
    #[command(flatten)]
    pub settings: SettingsArgs,
}
