//! The reports that `check` writes.

use std::path::{Path, PathBuf};

use super::args::{Counting, ReportArgs, ReportFormat};
use super::ending::Failure;
use super::stdout::Output;
use objdict_model::source::absolute;
use objdict_project::report::{Concise, Detail, Github, Gitlab, Json, Junit, Report, Sarif, TextReport};

/// The folder of a project in a job of GitHub and of GitLab.
const FOLDERS_OF_JOBS: [&str; 2] = ["GITHUB_WORKSPACE", "CI_PROJECT_DIR"];

/// The folder that paths in reports for services are relative to: the repository's in a job that runs in or below it,
/// otherwise the current one.
pub(super) fn base(stated: Option<&Path>) -> PathBuf {
    let here = std::env::current_dir().unwrap_or_default();
    if let Some(stated) = stated {
        return absolute(stated);
    }
    let of_jobs = FOLDERS_OF_JOBS.iter().filter_map(std::env::var_os).map(|folder| absolute(folder.as_ref()));
    of_jobs.into_iter().find(|folder| here.starts_with(folder)).unwrap_or(here)
}

/// The report that was asked for.
pub(super) fn new<'a>(args: &ReportArgs, out: &'a mut Output) -> Result<Box<dyn Report + 'a>, Failure> {
    let detail = detail(args)?;
    let base = base(args.base.as_deref());
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
            let failure = Failure::new("this format does not support statistics");
            Err(failure.help("use `--statistics` with `--format text`, `concise` or `json`"))
        }
    }
}
