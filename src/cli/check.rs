//! `objdict check`: the files are gathered, each is checked, and what was found is reported in their order.

use std::collections::BTreeMap;
use std::path::Path;

use super::args::CheckArgs;
use super::files::{File, gather};
use super::fix::{Amended, FixArgs, Mending, amend};
use super::input::Candidate;
use super::output::Output;
use super::parallel::in_order;
use super::{Failure, Outcome, report, tell};
use crate::diagnostic::{Findings, Severity, series};
use crate::format::Description;
use crate::lint::Options;
use crate::report::{Report, Tally, plural};

pub(super) fn run(args: &CheckArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let mut options = Options::default();
    options.profiles = args.profiles.load()?;
    let (files, failures) = gather(&args.files);
    if args.mending.diff {
        return show_changes(&Worker { args, options: &options }, &files, &failures, out);
    }
    let mut reporter = Reporter::new(args, out)?;
    for failure in failures {
        reporter.fail(&failure)?;
    }
    let worker = Worker { args, options: &options };
    in_order(&files, args.jobs, |file| worker.check(file), |checked| reporter.take(checked))?;
    reporter.finish()
}

/// Prints what would be mended, and reports nothing else.
fn show_changes(
    worker: &Worker<'_>,
    files: &[File],
    failures: &[Failure],
    out: &mut Output,
) -> Result<Outcome, Failure> {
    failures.iter().for_each(Failure::print);
    let mut has_failed = !failures.is_empty();
    let mut mending = Mending::default();
    in_order(
        files,
        worker.args.jobs,
        |file| worker.check(file),
        |checked| {
            match checked {
                Checked::Description(.., Some(amended)) => mending.show(&amended, out)?,
                Checked::Failed(failure) => {
                    failure.print();
                    has_failed = true;
                }
                Checked::Description(..) | Checked::Skipped(_) => {}
            }
            Ok(())
        },
    )?;
    mending.finish(&worker.args.mending);
    Ok(match mending.is_needed() {
        _ if has_failed => Outcome::Failed,
        true => Outcome::Findings,
        false => Outcome::Clean,
    })
}

/// What became of a file.
enum Checked {
    /// It was checked: the description of its first device, and the findings of each; what is mended in it.
    Description(Box<Description>, Vec<Findings>, Option<Box<Amended>>),
    /// It was found in a folder and is no description of a CANopen device, but what is said here.
    Skipped(String),
    /// It could not be read, or is no description although it was named.
    Failed(Failure),
}

/// Checks one file. Nothing is shared but what everybody only reads.
struct Worker<'a> {
    args: &'a CheckArgs,
    options: &'a Options,
}

impl Worker<'_> {
    fn check(&self, file: &File) -> Checked {
        match self.args.input.candidate(&file.path) {
            Ok(Candidate::Description(description)) => self.mend_devices(&file.path, *description),
            Ok(Candidate::Foreign(kind, _)) if !file.is_named => Checked::Skipped(kind),
            Ok(Candidate::Foreign(_, failure)) | Err(failure) => Checked::Failed(failure),
        }
    }

    fn mend_devices(&self, path: &Path, description: Description) -> Checked {
        let Some(safety) = self.args.mending.safety() else { return self.check_devices(description, None) };
        if self.args.mending.fix && path == Path::new("-") {
            let failure = Failure::new("the standard input cannot be mended in its place");
            return Checked::Failed(failure.help("`--diff` shows what would be changed"));
        }
        let check = |description: &Description| crate::check_with(description, self.options);
        match amend(path, description, safety, check) {
            Some((description, amended)) => self.check_devices(description, amended.map(Box::new)),
            None => Checked::Failed(Failure::new(format_args!("cannot mend `{}`", path.display()))),
        }
    }

    fn check_devices(&self, description: Description, amended: Option<Box<Amended>>) -> Checked {
        let count = description.device_count();
        let mut findings = vec![crate::check_with(&description, self.options)];
        if count == 1 {
            return Checked::Description(Box::new(description), findings, amended);
        }
        let mut next = Some(description);
        for number in 1..count {
            next = next.and_then(|description| description.select(number));
            findings.extend(next.as_ref().map(|description| crate::check_with(description, self.options)));
        }
        match next.and_then(|description| description.select(0)) {
            Some(first) => Checked::Description(Box::new(first), findings, amended),
            None => Checked::Skipped("network without devices".to_owned()),
        }
    }
}

/// Writes what was found, and keeps account of it.
struct Reporter<'a> {
    report: Box<dyn Report + 'a>,
    tally: Tally,
    deny: Severity,
    has_failed: bool,
    mending: Mending,
    args: &'a FixArgs,
    /// How many files of a folder are no descriptions, by what they are.
    skipped: BTreeMap<String, usize>,
}

impl<'a> Reporter<'a> {
    fn new(args: &'a CheckArgs, out: &'a mut Output) -> Result<Self, Failure> {
        let report = report::new(args, out)?;
        let deny = args.deny.into();
        Ok(Self {
            report,
            tally: Tally::default(),
            deny,
            has_failed: false,
            mending: Mending::default(),
            args: &args.mending,
            skipped: BTreeMap::new(),
        })
    }

    fn fail(&mut self, failure: &Failure) -> Result<(), Failure> {
        failure.print();
        self.has_failed = true;
        Ok(self.report.unread(&failure.message)?)
    }

    fn take(&mut self, checked: Checked) -> Result<(), Failure> {
        match checked {
            Checked::Description(description, findings, amended) => {
                if let Some(Err(failure)) = amended.map(|amended| self.mending.write(&amended)) {
                    self.fail(&failure)?;
                }
                let mut next = Some(*description);
                for (number, findings) in findings.into_iter().enumerate() {
                    let Some(description) = next.and_then(|description| description.select(number)) else {
                        break;
                    };
                    self.tally.add(&findings);
                    self.report.file((&description).into(), &findings)?;
                    next = Some(description);
                }
            }
            Checked::Skipped(kind) => *self.skipped.entry(kind).or_default() += 1,
            Checked::Failed(failure) => self.fail(&failure)?,
        }
        Ok(())
    }

    fn finish(mut self) -> Result<Outcome, Failure> {
        let outcome = match self.tally.at_least(self.deny) {
            _ if self.has_failed => Outcome::Failed,
            0 => Outcome::Clean,
            _ => Outcome::Findings,
        };
        self.report.exit_code(outcome.code());
        self.report.finish()?;
        self.mending.finish(self.args);
        let skipped: usize = self.skipped.values().sum();
        if skipped > 0 {
            let kinds = series(self.skipped.iter().map(|(kind, count)| format!("{count} {kind}")));
            let are = if skipped == 1 { "is no description" } else { "are no descriptions" };
            tell(&format!(
                "note: {} {are} of CANopen devices: {kinds}\n  help: `objdict identify` says what a file is\n",
                plural(skipped, "file"),
            ));
        }
        Ok(outcome)
    }
}
