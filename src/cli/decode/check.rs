//! What is not as the descriptions say, as findings in logs.

use super::super::args::DecodeArgs;
use super::super::baseline::BaselineArgs;
use super::super::check::Reporter;
use super::super::input::source_name;
use super::super::outcome::{Failure, Outcome};
use super::super::output::Output;
use super::super::settings::Settings;
use crate::diagnostic::Findings;
use crate::source::{SourceFile, SourceOptions};
use crate::traffic::BusReport;

pub(super) fn run(args: &DecodeArgs, reports: &[BusReport], out: &mut Output) -> Result<Outcome, Failure> {
    let Some(report) = args.report() else { return Err(Failure::new("findings have no CSV")) };
    let mut settings = Settings::new(&args.settings)?;
    // the messages have times and values, so a baseline would know none of another log
    let baseline = BaselineArgs::default();
    let mut reporter = Reporter::new(&report, &baseline, out)?;
    for (log, path) in args.logs.iter().enumerate() {
        let project = settings.project_of(path)?;
        let project = project.as_deref();
        let mut found = Findings::new();
        reports.iter().flat_map(|bus| bus.findings(log)).for_each(|finding| found.push(finding));
        let findings = settings.options(path, project).severities.apply(found);
        // the text of a log of any length is not kept, so findings have no places in it
        let name = SourceFile::from_bytes(source_name(path), Vec::new(), &SourceOptions::default());
        let name = name.map_err(Failure::new)?;
        reporter.report_on((&name).into(), findings, settings.deny(project))?;
    }
    for project in settings.projects() {
        reporter.take_project(project, &settings)?;
    }
    reporter.finish(None)
}
