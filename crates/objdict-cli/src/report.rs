//! The reports that `check` writes.

use std::path::PathBuf;

use super::args::{Counting, ReportArgs, ReportFormat};
use super::ending::Failure;
use super::stdout::Output;
use objdict_project::report::{Concise, Detail, Github, Gitlab, Json, Junit, Report, Sarif, TextReport};

/// The report that was asked for. Services get paths as they are seen from the current folder.
pub(super) fn new<'a>(args: &ReportArgs, out: &'a mut Output) -> Result<Box<dyn Report + 'a>, Failure> {
    let detail = detail(args)?;
    let base = std::env::current_dir().unwrap_or_else(|_| PathBuf::new());
    Ok(match args.format {
        ReportFormat::Text => {
            let colour = out.colour();
            let width = terminal_size::terminal_size_of(std::io::stdout());
            let report = TextReport::new(out, colour).detail(detail);
            let report = match width {
                Some((columns, _)) => report.width(columns.0.into()),
                None => report,
            };
            Box::new(if args.detail.all { report } else { report.brief() })
        }
        ReportFormat::Concise => Box::new(Concise::new(out).detail(detail)),
        ReportFormat::Json => Box::new(Json::new(out.raw()?).detail(detail)),
        ReportFormat::Sarif => Box::new(Sarif::new(out.raw()?).base(&base)),
        ReportFormat::Github => Box::new(Github::new(out.raw()?).base(&base)),
        ReportFormat::Gitlab => Box::new(Gitlab::new(out.raw()?).base(&base)),
        ReportFormat::Junit => Box::new(Junit::new(out.raw()?).base(&base)),
    })
}

/// What is shown; only the formats of objdict have a place for statistics.
fn detail(args: &ReportArgs) -> Result<Detail, Failure> {
    use ReportFormat::{Concise, Github, Gitlab, Json, Junit, Sarif, Text};
    match (args.detail.statistics, args.format) {
        (None, _) => Ok(Detail::Findings),
        (Some(Counting::Also), Text | Concise | Json) => Ok(Detail::Both),
        (Some(Counting::Only), Text | Concise | Json) => Ok(Detail::Statistics),
        (Some(_), Sarif | Github | Gitlab | Junit) => {
            let failure = Failure::new("this format has no room for statistics");
            Err(failure.help("`--statistics` goes with `--format text`, `concise` and `json`"))
        }
    }
}
