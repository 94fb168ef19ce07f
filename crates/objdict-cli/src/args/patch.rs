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
    /// Edits the text of the vendor and keeps comments, order and spelling. Data that the format cannot express are stored in objdict
    /// comment lines (docs/reference/formats.md). Exits with 2 if the file does not contain what the patch expects.
    Apply(PatchApplyArgs),
    /// Create a patch from an edited description
    ///
    /// The patch lists the differences in content, field by field, each with its original value.
    Make(PatchMakeArgs),
    /// Check patches against their descriptions
    ///
    /// Shows for each patch and file whether the patch applies, is no longer needed, or expects something else. Exits with 1 if a patch
    /// does not apply or matches none of the files.
    Check(PatchCheckArgs),
}

#[derive(Debug, clap::Args)]
pub(crate) struct PatchApplyArgs {
    /// Device description; `-` is standard input
    pub file: PathBuf,
    /// Output file; `-` is standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
    #[command(flatten)]
    pub input: InputArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct PatchMakeArgs {
    /// Original description
    pub original: PathBuf,
    /// Edited description
    pub edited: PathBuf,
    /// Output file; `-` is standard output
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
