//! What is not as the descriptions say, as findings in logs.

use super::super::args::DecodeArgs;
use super::super::baseline::BaselineArgs;
use super::super::check::Reporter;
use super::super::ending::{Failure, Outcome};
use super::super::input::source_name;
use super::super::settings::CommandSettings;
use super::super::stdout::Output;
use objdict_traffic as traffic;
use objdict_traffic::BusReport;

pub(super) fn run(args: &DecodeArgs, reports: &[BusReport], out: &mut Output) -> Result<Outcome, Failure> {
    let Some(report) = args.report() else { return Err(Failure::new("findings have no CSV")) };
    let mut settings = CommandSettings::new(&args.settings)?;
    // the messages have times and values, so a baseline would know none of another log
    let baseline = BaselineArgs::default();
    let mut reporter = Reporter::new(&report, &baseline, out)?;
    for (log, path) in args.logs.iter().enumerate() {
        let project = settings.project_of(path)?;
        let project = project.as_deref();
        let (lines, found) = traffic::findings(reports, log, source_name(path));
        let findings = settings.options(path, project).severities.apply(found);
        reporter.report_on((&lines).into(), findings, settings.deny(project))?;
    }
    for project in settings.projects() {
        reporter.take_project(project, &settings)?;
    }
    reporter.finish(None)
}
