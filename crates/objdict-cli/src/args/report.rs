//! How results are written.

use std::path::PathBuf;

use clap::ValueEnum;

// How findings are reported.
#[derive(Debug, clap::Args)]
pub(crate) struct ReportArgs {
    /// Output format
    #[arg(long, value_enum, default_value = "text")]
    pub format: ReportFormat,
    /// Folder to which paths are relative in sarif, github, gitlab and junit reports [default: the repository in a GitHub or GitLab job,
    /// else the current folder]
    #[arg(long, value_name = "FOLDER")]
    pub base: Option<PathBuf>,
    #[command(flatten)]
    pub detail: ReportDetailArgs,
}

// How much a report says.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct ReportDetailArgs {
    /// Report every finding separately, even if it is a consequence of another
    ///
    /// By default, text and concise merge findings with the same cause, and text shows 20 findings per file.
    #[arg(long)]
    pub all: bool,
    /// Count the findings per rule; `=only` hides the findings themselves (text, concise and json)
    #[arg(long, value_enum, value_name = "WHICH", num_args = 0..=1, require_equals = true, default_missing_value = "also")]
    pub statistics: Option<Counting>,
}

/// How findings are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ReportFormat {
    /// Source excerpts with markers
    Text,
    /// One line per finding: file:line:column: severity rule: message
    Concise,
    /// JSON document (docs/reference/json.md)
    Json,
    /// SARIF 2.1.0 for code scanning services and editors
    Sarif,
    /// GitHub workflow annotations
    Github,
    /// GitLab code quality report
    Gitlab,
    /// JUnit XML for test report viewers
    Junit,
}

/// Whether the findings are counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Counting {
    /// After the findings
    Also,
    /// Instead of the findings
    Only,
}

/// How a dictionary is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ShowFormat {
    /// Plain text
    #[value(alias = "text")]
    Table,
    /// JSON document with one entry per line (docs/reference/json.md)
    Json,
}

/// How the checks of a device are reported.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ChecksFormat {
    /// Plain text
    #[value(alias = "text")]
    Table,
    /// JSON document with one entry per line (docs/reference/json.md)
    Json,
    /// JUnit XML for test report viewers
    Junit,
    /// HTML page
    Html,
}

/// How what is found is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum PlainFormat {
    /// Plain text
    Text,
    /// JSON document (docs/reference/json.md)
    Json,
}
