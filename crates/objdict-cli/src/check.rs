//! `objdict check`: the files are gathered, each is checked, and what was found is reported in their order.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use super::args::{CheckArgs, ReportArgs, ReportFormat};
use super::baseline::{BaselineArgs, KnownFindings};
use super::cache::Cache;
use super::ending::{Failure, Outcome, note};
use super::files::{InputFile, gather_with, is_source, note_networks, note_outside};
use super::fix::{Amended, FixArgs, Fixing, amend};
use super::git;
use super::input::{CheckedInput, name_of, source_name};
use super::parallel::in_order;
use super::progress::give_way;
use super::report;
use super::settings::{CommandSettings, Project};
use super::stdout::Output;
use super::vendor::VendorReport;
use super::written_files::require_other;
use objdict_format::Description;
use objdict_lint::Options;
use objdict_model::diagnostic::plural;
use objdict_model::diagnostic::{Applicability, Findings, Severity, series};
use objdict_model::model::DeviceKind;
use objdict_model::source::{SourceFile, SourceOptions};
use objdict_project::baseline::Baseline;
use objdict_project::check::{last_eds, of_devices};
use objdict_project::report::{Report, Subject, by_place, grouped};
use objdict_project::workspace::with_origin_beside;

pub(super) fn run(args: &CheckArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let mut settings = CommandSettings::new(&args.settings)?;
    let (files, failures) = gather_with(&args.files, &mut settings, is_source)?;
    note_networks(&files);
    let cache = args.cache.as_deref().and_then(|path| Cache::open(path, args, &settings));
    let worker = Worker { args, settings: &settings, cache: cache.as_ref() };
    if args.fixing.safety().is_some() {
        args.input.patch.none_with("`--fix`")?;
        note_outside(&files);
    }
    if args.fixing.diff {
        return show_changes(&worker, &files, &failures, out);
    }
    args.vendor_report.iter().try_for_each(|path| require_other(path))?;
    let mut vendor = VendorReport::default();
    let mut reporter = Reporter::new(&args.report, &args.baseline, out)?;
    for failure in failures {
        reporter.fail(&failure)?;
    }
    for project in settings.projects() {
        reporter.take_project(project, &settings)?;
    }
    in_order(
        &files,
        args.jobs,
        "checking",
        |file| worker.check(file),
        |checked| {
            if checked.is_reported() {
                give_way();
            }
            if let (Checked::Description(examined), Some(_)) = (&checked, &args.vendor_report) {
                vendor.add(&examined.description, &examined.options);
            }
            reporter.take(checked)
        },
    )?;
    let clean = std::mem::take(&mut reporter.clean);
    let outcome = reporter.finish(Some(&args.fixing))?;
    args.vendor_report.iter().try_for_each(|path| vendor.write(path))?;
    if let Some(cache) = cache {
        cache.save(clean);
    }
    Ok(outcome)
}

/// Prints what would be fixed, and reports nothing else.
fn show_changes(
    worker: &Worker<'_>,
    files: &[InputFile],
    failures: &[Failure],
    out: &mut Output,
) -> Result<Outcome, Failure> {
    failures.iter().for_each(Failure::print);
    let mut has_failed = !failures.is_empty();
    for project in worker.settings.projects().filter(|project| !project.is_usable()) {
        let message = format!("`{}` cannot be used", project.config.source().name());
        Failure::new(message).help("run `objdict check` without `--diff` for the reasons").print();
        has_failed = true;
    }
    let mut fixing = Fixing::default();
    in_order(
        files,
        worker.args.jobs,
        "checking",
        |file| worker.check(file),
        |checked| {
            match checked {
                Checked::Description(examined) => {
                    if let Some(amended) = examined.amended {
                        give_way();
                        fixing.show(&amended, out)?;
                    }
                }
                Checked::Failed(failure) => {
                    failure.print();
                    has_failed = true;
                }
                Checked::Clean(..) | Checked::Skipped(_) | Checked::Left => {}
            }
            Ok(())
        },
    )?;
    fixing.finish(true);
    Ok(match fixing.is_needed() {
        _ if has_failed => Outcome::Failed,
        true => Outcome::Findings,
        false => Outcome::Clean,
    })
}

/// What became of a file.
enum Checked {
    /// It was checked.
    Description(Box<Examined>),
    /// Nothing was found in it when it was checked before.
    Clean(SourceFile, String),
    /// It was found in a folder and is no description of a CANopen device, but what is said here.
    Skipped(String),
    /// It could not be read, or is no description although it was named.
    Failed(Failure),
    /// Not checked, because its configuration or a profile could not be read.
    Left,
}

/// A file that was checked.
struct Examined {
    /// The description of its first device.
    description: Description,
    /// The findings of each device.
    findings: Vec<Findings>,
    /// What it was checked with.
    options: Options,
    /// The lowest severity that fails the run.
    deny: Severity,
    /// What is fixed in it.
    amended: Option<Amended>,
    /// Why its fixes were not written.
    unwritten: Option<Failure>,
    /// What it is known by in the cache, if there is one.
    key: Option<String>,
}

impl Checked {
    /// Whether something is written because of it.
    fn is_reported(&self) -> bool {
        match self {
            Self::Description(examined) => examined.findings.iter().any(|findings| !findings.is_empty()),
            Self::Failed(_) => true,
            Self::Clean(..) | Self::Skipped(_) | Self::Left => false,
        }
    }
}

/// Checks one file. Threads share only data that none of them changes.
struct Worker<'a> {
    args: &'a CheckArgs,
    settings: &'a CommandSettings,
    cache: Option<&'a Cache>,
}

impl Worker<'_> {
    fn check(&self, file: &InputFile) -> Checked {
        if file.project.as_ref().is_some_and(|project| !project.is_usable()) {
            return Checked::Left;
        }
        let bytes = match self.args.input.size.bytes(&file.path) {
            Ok(bytes) => bytes,
            Err(failure) => return Checked::Failed(failure),
        };
        let known = self.cache.map(|cache| cache.look_up(&file.path, &bytes));
        if let Some((key, true)) = known {
            return match self.args.input.reading().source(&source_name(&file.path), bytes) {
                Ok(source) => Checked::Clean(source, key),
                Err(error) => Checked::Failed(Failure::new(error)),
            };
        }
        let key = known.map(|(key, _)| key);
        let patches = file.project.as_ref().map(|project| &project.patches[..]).unwrap_or_default();
        match self.args.input.candidate(&file.path, bytes, patches) {
            Ok(CheckedInput::Description(description)) => self.fix_devices(file, *description, key),
            Ok(CheckedInput::Foreign(kind, _)) if !file.is_named => Checked::Skipped(kind),
            Ok(CheckedInput::Foreign(_, failure)) | Err(failure) => Checked::Failed(failure),
        }
    }

    fn fix_devices(&self, file: &InputFile, description: Description, key: Option<String>) -> Checked {
        let project = file.project.as_deref();
        let mut options = self.settings.options(&file.path, project);
        let readers = self.args.fixing.dialect.tools();
        if !readers.is_empty() && !self.args.settings.names_tools() {
            options.tools = readers.to_vec();
        }
        let check = |description: &Description| objdict_project::check_with(description, &options);
        let (description, amended, unwritten) = match self.args.fixing.safety().filter(|_| !file.is_outside) {
            None => (description, None, None),
            Some(_) if !self.args.fixing.diff && file.path == Path::new("-") => {
                let failure = Failure::new("the standard input cannot be fixed in place");
                return Checked::Failed(failure.help("use `--diff` to print the changes"));
            }
            Some(safety) => match amend_all(&file.path, description, safety, &options) {
                Some((description, Some(amended))) if !self.args.fixing.diff => match amended.write() {
                    Ok(()) => (description, Some(amended), None),
                    // what is reported is what is on the disk
                    Err(failure) => (amended.original(), None, Some(failure)),
                },
                Some((description, amended)) => (description, amended, None),
                None => {
                    let message = format!("cannot fix `{}`", name_of(&file.path));
                    return Checked::Failed(Failure::new(message));
                }
            },
        };
        let description = match self.with_origin(&file.path, description) {
            Ok(description) => description,
            Err(failure) => return Checked::Failed(failure),
        };
        // what is found in it depends on another file
        let key = key.filter(|_| last_eds(&description).is_none() && description.extended().is_none());
        // what these formats offer, other programs apply without a check of the result; only to count fixes, it takes too long
        let is_offered = matches!(self.args.report.format, ReportFormat::Json | ReportFormat::Sarif);
        let examine = |description: &Description| match check(description) {
            findings if is_offered => objdict_project::with_sound_fixes(description, findings, |trial| {
                objdict_project::check_unordered(trial, &options)
            }),
            findings => findings,
        };
        let mut findings = of_devices(&description, examine);
        if let Some(revision) = &self.args.since
            && let Err(failure) = self.sift(revision, file, &description, &mut findings, &check)
        {
            return Checked::Failed(failure);
        }
        let deny = self.settings.deny(project);
        Checked::Description(Box::new(Examined {
            description,
            findings,
            options,
            deny,
            amended,
            unwritten,
            key,
        }))
    }
}

fn amend_all(
    path: &Path,
    description: Description,
    safety: Applicability,
    options: &Options,
) -> Option<(Description, Option<Amended>)> {
    let count = description.device_count();
    amend(path, description, 0..count, |description| {
        objdict_project::fix_for_readers(description, safety, options)
    })
}

impl Worker<'_> {
    /// Removes the findings that the file has at a revision of git too; of a new file everything stays.
    fn sift(
        &self,
        revision: &str,
        file: &InputFile,
        description: &Description,
        findings: &mut [Findings],
        check: &dyn Fn(&Description) -> Findings,
    ) -> Result<(), Failure> {
        let Some(bytes) = git::read(revision, &file.path, self.args.input.size.max_size)? else {
            return Ok(());
        };
        let patches = file.project.as_ref().map(|project| &project.patches[..]).unwrap_or_default();
        let Ok(CheckedInput::Description(former)) = self.args.input.candidate(&file.path, bytes, patches)
        else {
            return Ok(());
        };
        let former = self.with_origin(&file.path, *former)?;
        let mut known = Baseline::default();
        let reported = |device: &Description, findings| match self.args.report.detail.all {
            true => findings,
            false => by_place(device, findings),
        };
        former.map_devices(|device| known.add("", device, &reported(device, check(device))));
        let mut of_devices = findings.iter_mut();
        description.map_devices(|device| {
            if let Some(findings) = of_devices.next() {
                *findings = reported(device, std::mem::take(findings));
                known.suppress("", device, findings, |_| false);
            }
        });
        Ok(())
    }

    /// The configuration of a node with the description of its type: the one that was said, else the one that `LastEDS` names, if
    /// it is in the same folder.
    fn with_origin(&self, path: &Path, description: Description) -> Result<Description, Failure> {
        if description.device().kind != DeviceKind::Node {
            return Ok(description);
        }
        let options = SourceOptions { encoding: None, max_size: self.args.input.size.max_size };
        let open = |path: &Path| objdict_format::open(path, &options);
        if let Some(eds) = &self.args.eds {
            let origin = open(eds)?;
            return match origin.device().kind {
                DeviceKind::Type => Ok(description.with_origin(origin)),
                DeviceKind::Node => {
                    let message = format!("`{}` describes a node, not a type of device", name_of(eds));
                    Err(Failure::new(message).help("name an EDS or XDD with `--eds`"))
                }
            };
        }
        Ok(with_origin_beside(path, description, &options))
    }
}

/// Writes what was found, and keeps account of it.
pub(super) struct Reporter<'a> {
    report: Box<dyn Report + 'a>,
    known: KnownFindings,
    /// Whether a finding fails the run.
    has_denied: bool,
    has_failed: bool,
    fixing: Fixing,
    /// Whether each finding is reported on its own.
    all: bool,
    /// How many files of a folder are no descriptions, by what they are.
    skipped: BTreeMap<String, usize>,
    /// What the files without findings are known by in the cache.
    clean: Vec<String>,
}

impl<'a> Reporter<'a> {
    pub(super) fn new(
        args: &ReportArgs,
        baseline: &'a BaselineArgs,
        out: &'a mut Output,
    ) -> Result<Self, Failure> {
        Ok(Self {
            known: KnownFindings::new(baseline)?,
            report: report::new(args, out)?,
            has_denied: false,
            has_failed: false,
            fixing: Fixing::default(),
            all: args.detail.all,
            skipped: BTreeMap::new(),
            clean: Vec::new(),
        })
    }

    pub(super) fn fail(&mut self, failure: &Failure) -> Result<(), Failure> {
        failure.print();
        self.has_failed = true;
        Ok(self.report.unread(&failure.message)?)
    }

    /// Errors in a configuration; one without errors is not mentioned.
    pub(super) fn take_project(
        &mut self,
        project: &Project,
        settings: &CommandSettings,
    ) -> Result<(), Failure> {
        for failure in &project.failures {
            self.fail(&failure.into())?;
        }
        let config = &project.config;
        self.has_failed |= !config.is_toml();
        let options = settings.options(config.source().name().as_ref(), Some(project));
        let findings = options.severities.apply(project.findings.clone());
        if findings.is_empty() {
            return Ok(());
        }
        self.report_on(config.source().into(), findings, settings.deny(Some(project)))
    }

    pub(super) fn report_on(
        &mut self,
        subject: Subject<'_>,
        findings: Findings,
        deny: Severity,
    ) -> Result<(), Failure> {
        let mut findings = if self.all { findings } else { by_place(subject, findings) };
        self.known.sift(subject, &mut findings);
        if !self.all && self.report.is_for_people() {
            findings = grouped(subject, findings);
        }
        self.report.deny_from(deny);
        self.has_denied |= findings.worst() >= Some(deny);
        Ok(self.report.file(subject, &findings)?)
    }

    fn take(&mut self, checked: Checked) -> Result<(), Failure> {
        match checked {
            Checked::Description(examined) => {
                let Examined { description, findings, options, deny, amended, unwritten, key } = *examined;
                // reports list each device and count what comments suppress, so that such files are checked again
                let is_patched = description.patched().is_some_and(|patched| !patched.lines().is_empty());
                let is_clean = |found: &Findings| found.is_empty() && found.suppressed() == 0 && !is_patched;
                self.clean.extend(key.filter(|_| matches!(&findings[..], [only] if is_clean(only))));
                if let Some(failure) = unwritten {
                    self.fail(&failure)?;
                }
                amended.iter().for_each(|amended| self.fixing.count(amended));
                for (patch, findings) in description.patched().iter().flat_map(|patched| patched.by_patch()) {
                    let findings = options.severities.apply(findings.clone());
                    if !findings.is_empty() {
                        self.report_on(patch.source().into(), findings, deny)?;
                    }
                }
                let mut next = Some(description);
                for (number, findings) in findings.into_iter().enumerate() {
                    let Some(description) = next.and_then(|description| description.select(number)) else {
                        break;
                    };
                    self.report_on((&description).into(), findings, deny)?;
                    next = Some(description);
                }
            }
            Checked::Clean(source, key) => {
                self.clean.push(key);
                self.report_on(Subject::Unchanged(&source), Findings::default(), Severity::Error)?;
            }
            Checked::Skipped(kind) => *self.skipped.entry(kind).or_default() += 1,
            Checked::Failed(failure) => self.fail(&failure)?,
            Checked::Left => {}
        }
        Ok(())
    }

    /// `fixing` is what was asked for, where files may be fixed.
    pub(super) fn finish(mut self, fixing: Option<&FixArgs>) -> Result<Outcome, Failure> {
        let outcome = match (self.has_failed, self.has_denied) {
            (true, _) => Outcome::Failed,
            (false, true) => Outcome::Findings,
            (false, false) => Outcome::Clean,
        };
        self.report.exit_code(outcome.code());
        self.report.finish()?;
        if let Some(args) = fixing.filter(|args| args.safety().is_some()) {
            self.fixing.finish(args.diff);
        }
        let skipped: usize = self.skipped.values().sum();
        if skipped > 0 {
            let kinds = series(self.skipped.iter().map(|(kind, count)| format!("{count} {kind}")));
            let (describe, were) = if skipped == 1 { ("describes", "was") } else { ("describe", "were") };
            let help = |(kind, _): (&String, &usize)| match kind.as_str() {
                "patch" => "`objdict patch check` checks patches",
                "network" | "bus configuration" | "node list" => "`objdict network check` checks networks",
                _ => "`objdict identify` shows a file's format",
            };
            let help: BTreeSet<&str> = self.skipped.iter().map(help).collect();
            let help = help.into_iter().collect::<Vec<_>>().join(", ");
            note(&format!(
                "note: {} {describe} no CANopen device and {were} not checked: {kinds}\n  help: {help}\n",
                plural(skipped, "file"),
            ));
        }
        self.known.finish()?;
        Ok(outcome)
    }
}
