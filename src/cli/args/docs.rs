//! The arguments of `objdict docs`.

use std::path::PathBuf;

use clap::ValueEnum;

use super::network::NetworkPathArgs;
use crate::cli::input::{ExpandArgs, InputArgs};
use crate::cli::save::OverwriteArgs;
use crate::cli::settings::SettingsArgs;
use crate::document::Form;

#[derive(Debug, clap::Args)]
#[command(mut_arg("deny", |deny| deny.help("Lowest severity that fails the run: note, warning or error [default: none]")))]
pub(in crate::cli) struct DocsArgs {
    /// Files, folders and patterns such as `devices/**/*.eds`; networks (`network.toml`, `bus.yml`, a node list); `-` is
    /// standard input
    #[arg(required = true, value_name = "PATH")]
    pub files: Vec<PathBuf>,
    /// The file to write, or the folder for a site; `-` is standard output
    #[arg(short, long, alias = "out", value_name = "PATH")]
    pub output: PathBuf,
    #[command(flatten)]
    pub overwrite: OverwriteArgs,
    /// The format of the pages [default: by the extension of the output, else html]
    #[arg(long, alias = "format", value_enum, value_name = "FORMAT")]
    pub to: Option<DocsFormat>,
    /// The title of the page or site [default: the name of the product or network]
    #[arg(long, value_name = "TEXT")]
    pub title: Option<String>,
    /// The language of names and descriptions, if the file has it; headings and sentences are in English or German
    #[arg(long, value_name = "TAG")]
    pub lang: Option<String>,
    #[command(flatten)]
    pub expand: ExpandArgs,
    #[command(flatten)]
    pub input: InputArgs,
    #[command(flatten)]
    pub network: NetworkPathArgs,
    #[command(flatten)]
    pub settings: SettingsArgs,
}

/// How documentation is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum DocsFormat {
    /// One self-contained page
    Html,
    /// One file of tables, as GitHub and GitLab render them
    Markdown,
    /// One line for each entry, for spreadsheets
    Csv,
}

impl From<DocsFormat> for Form {
    fn from(format: DocsFormat) -> Self {
        match format {
            DocsFormat::Html => Self::Html,
            DocsFormat::Markdown => Self::Markdown,
            DocsFormat::Csv => Self::Csv,
        }
    }
}
