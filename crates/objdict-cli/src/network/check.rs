//! `objdict network check`.

use super::super::args::NetworkCheckArgs;
use super::super::check::Reporter;
use super::super::ending::{Failure, Outcome};
use super::super::settings::CommandSettings;
use super::super::stdout::Output;
use super::{findings, of_descriptions, open, parted};
use objdict_project::report::Subject;

pub(super) fn run(args: &NetworkCheckArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let mut settings = CommandSettings::new(&args.settings)?;
    let input = args.paths.with(&args.patch, args.settings.config_file());
    let mut reporter = Reporter::new(&args.report, &args.baseline, out)?;
    let (networks, descriptions) = parted(&args.files);
    let described = (!descriptions.is_empty()).then(|| of_descriptions(&descriptions, &input));
    let described = described.map(|file| (&descriptions[0], file));
    let files = networks.iter().map(|path| (path, open(path, &input))).chain(described);
    for (path, file) in files {
        let file = match file {
            Ok(file) => file,
            Err(failure) => {
                reporter.fail(&failure)?;
                continue;
            }
        };
        let findings = findings(&file, path, &mut settings)?;
        let project = settings.project_of(path)?;
        for (subject, findings) in Subject::of_network(&file, findings) {
            reporter.report_on(subject, findings, settings.deny(project.as_deref()))?;
        }
    }
    for project in settings.projects() {
        reporter.take_project(project, &settings)?;
    }
    reporter.finish(None)
}
