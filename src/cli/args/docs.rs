//! The arguments of `objdict docs`.

use std::path::PathBuf;

use clap::{Parser, ValueEnum};

use super::ExpandArgs;
use crate::cli::input::InputArgs;
use crate::cli::settings::SettingsArgs;
use crate::document::Form;

/// Make documentation of descriptions: pages for people, tables for programs
///
/// Several descriptions make one site with an index page. What `check` finds stands in the page and changes no exit code, but with
/// --deny.
#[derive(Debug, Parser)]
#[command(mut_arg("deny", |deny| deny.help("The mildest severity that makes the exit code 1: note, warning or error; without it, none does")))]
pub(in crate::cli) struct DocsArgs {
    /// Files, folders and patterns such as `devices/**/*.eds`; `-` is the standard input
    #[arg(required = true, value_name = "PATH")]
    pub files: Vec<PathBuf>,
    /// The file to write, or the folder for a site; `-` is the standard output
    #[arg(short, long, value_name = "FILE|DIR")]
    pub out: PathBuf,
    /// What to write; without it what the ending of the file says, else HTML
    #[arg(long, value_enum, value_name = "FORMAT")]
    pub format: Option<DocsFormat>,
    /// The title of the page or of the site; without it the name of the product
    #[arg(long, value_name = "TEXT")]
    pub title: Option<String>,
    /// The language: names and descriptions in it, where the description has them, headings and sentences in English or German
    #[arg(long, value_name = "TAG")]
    pub lang: Option<String>,
    #[command(flatten)]
    pub expand: ExpandArgs,
    #[command(flatten)]
    pub input: InputArgs,
    #[command(flatten)]
    pub settings: SettingsArgs,
}

/// How documentation is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum DocsFormat {
    /// One page that needs nothing beside it
    Html,
    /// One file of tables, as forges render them
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
