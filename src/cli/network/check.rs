//! `objdict network check`.

use super::super::args::NetworkCheckArgs;
use super::super::check::Reporter;
use super::super::output::Output;
use super::super::settings::Settings;
use super::super::{Failure, Outcome};
use super::open;

pub(super) fn run(args: &NetworkCheckArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let mut settings = Settings::new(&args.settings)?;
    let mut reporter = Reporter::new(&args.report, &args.baseline, out)?;
    for path in &args.files {
        let project = settings.project_of(path)?;
        let file = match open(path, &args.input) {
            Ok(file) => file,
            Err(failure) => {
                reporter.fail(&failure)?;
                continue;
            }
        };
        let severities = settings.options(path, project.as_deref()).severities;
        let findings = severities.apply(file.check());
        reporter.report_on((&file).into(), findings, settings.deny(project.as_deref()))?;
    }
    for project in settings.projects() {
        reporter.take_project(project, &settings)?;
    }
    reporter.finish(None)
}
