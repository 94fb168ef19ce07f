//! `objdict check`: the files are gathered, each is checked, and what was found is reported in their order.

use std::collections::BTreeMap;

use super::args::CheckArgs;
use super::files::{File, gather};
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
    let mut reporter = Reporter::new(args, out)?;
    for failure in failures {
        reporter.fail(&failure)?;
    }
    let worker = Worker { args, options: &options };
    in_order(&files, args.jobs, |file| worker.check(file), |checked| reporter.take(checked))?;
    reporter.finish()
}

/// What became of a file.
enum Checked {
    /// It was checked: the description of its first device, and the findings of each.
    Description(Box<Description>, Vec<Findings>),
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
            Ok(Candidate::Description(description)) => self.check_devices(*description),
            Ok(Candidate::Foreign(kind, _)) if !file.is_named => Checked::Skipped(kind),
            Ok(Candidate::Foreign(_, failure)) | Err(failure) => Checked::Failed(failure),
        }
    }

    fn check_devices(&self, description: Description) -> Checked {
        let count = description.device_count();
        let mut findings = vec![crate::check_with(&description, self.options)];
        if count == 1 {
            return Checked::Description(Box::new(description), findings);
        }
        let mut next = Some(description);
        for number in 1..count {
            next = next.and_then(|description| description.select(number));
            findings.extend(next.as_ref().map(|description| crate::check_with(description, self.options)));
        }
        match next.and_then(|description| description.select(0)) {
            Some(first) => Checked::Description(Box::new(first), findings),
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
    /// How many files of a folder are no descriptions, by what they are.
    skipped: BTreeMap<String, usize>,
}

impl<'a> Reporter<'a> {
    fn new(args: &CheckArgs, out: &'a mut Output) -> Result<Self, Failure> {
        let report = report::new(args, out)?;
        let deny = args.deny.into();
        Ok(Self { report, tally: Tally::default(), deny, has_failed: false, skipped: BTreeMap::new() })
    }

    fn fail(&mut self, failure: &Failure) -> Result<(), Failure> {
        failure.print();
        self.has_failed = true;
        Ok(self.report.unread(&failure.message)?)
    }

    fn take(&mut self, checked: Checked) -> Result<(), Failure> {
        match checked {
            Checked::Description(description, findings) => {
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
