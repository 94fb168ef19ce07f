//! The arguments of `objdict docs`.

use std::path::PathBuf;

use super::network::NetworkPathArgs;
use crate::input::{ExpandArgs, InputArgs};
use crate::settings::SettingsArgs;
use crate::values::one_of;
use crate::written_files::OverwriteArgs;
use objdict_document::Form;

#[derive(Debug, clap::Args)]
#[command(mut_arg("deny", |deny| deny.help("Lowest severity that fails the run: note, warning or error [default: none]")))]
pub(crate) struct DocsArgs {
    /// Files, folders, patterns such as `devices/**/*.eds`, or networks (`network.toml`, `bus.yml`, node lists); `-` is standard input
    #[arg(required = true, value_name = "PATH")]
    pub files: Vec<PathBuf>,
    /// Output file, or folder for a site; `-` is standard output
    #[arg(short, long, alias = "out", value_name = "PATH")]
    pub output: PathBuf,
    #[command(flatten)]
    pub overwrite: OverwriteArgs,
    /// Output format [default: by the extension of the output, else html]
    #[arg(long, alias = "format", value_parser = one_of(&FORMS), value_name = "FORMAT")]
    pub to: Option<Form>,
    /// Title of the page or site [default: name of the product or network]
    #[arg(long, value_name = "TEXT")]
    pub title: Option<String>,
    /// Language of names and descriptions, if the file has it; headings and sentences are English or German
    #[arg(long, value_name = "TAG")]
    pub lang: Option<String>,
    /// Workbench address to which each page links: a URL or a path relative to the pages (docs/guides/workbench.md)
    #[arg(long, value_name = "ADDRESS", value_parser = workbench)]
    pub workbench: Option<String>,
    #[command(flatten)]
    pub expand: ExpandArgs,
    #[command(flatten)]
    pub input: InputArgs,
    #[command(flatten)]
    pub network: NetworkPathArgs,
    #[command(flatten)]
    pub settings: SettingsArgs,
}

/// The address of a workbench, which becomes a link: no other scheme than those of hosts.
fn workbench(text: &str) -> Result<String, String> {
    let is_plain = |byte: u8| byte.is_ascii_graphic() && !b"<>\"\\".contains(&byte);
    let is_address = !text.is_empty() && text.bytes().all(is_plain);
    let has_scheme = text.split(['/', '?', '#']).next().is_some_and(|first| first.contains(':'));
    match is_address && (!has_scheme || text.starts_with("https://") || text.starts_with("http://")) {
        true => Ok(text.to_owned()),
        false => Err("expected a URL such as `https://example.com/workbench/`, or a path".to_owned()),
    }
}

/// How documentation is written.
const FORMS: [(Form, &str, &str); 3] = [
    (Form::Html, "html", "One self-contained HTML page"),
    (Form::Markdown, "markdown", "One file with tables for GitHub and GitLab"),
    (Form::Csv, "csv", "One line per entry, for spreadsheets"),
];
