//! `objdict diff`: what changes between two descriptions.

mod against;
mod choice;
mod html;
mod identifiers;
mod json;
mod markdown;
pub(super) mod release;
mod side;
mod text;

pub(super) use self::choice::ChangeChoice;
#[cfg(feature = "schema")]
pub(super) use self::json::ChangesJson as ChangesDocument;
use self::side::{ComparedSide, sides};
use super::args::{DiffArgs, DiffFormat};
use super::ending::{Failure, Outcome};
use super::report;
use super::settings::{CommandSettings, SettingsArgs};
use super::stdout::Output;
use objdict_lint::changes::{ChangeVerdict, DeviceChange, compare};
use objdict_lint::{Level, Severities};
use objdict_model::diagnostic::Findings;
use objdict_model::diagnostic::Severity;
use objdict_project::report::{Github, Report, Subject};

/// Both descriptions and what changes between them.
struct ComparedDescriptions {
    old: ComparedSide,
    new: ComparedSide,
    changes: Vec<DeviceChange>,
}

pub(super) fn run(args: &DiffArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let [old, new] = sides(&args.sides, &args.input, &args.config)?;
    let devices = [old.device()?, new.device()?];
    let mut changes = compare(devices[0], devices[1]);
    identifiers::add(&mut changes, devices[0], devices[1]);
    changes.extend(against::refused(args, devices)?);
    let is_one_of = |choices: &[ChangeChoice], change: &DeviceChange| {
        choices.iter().any(|choice| choice.has(change, devices))
    };
    changes.retain(|change| args.select.is_empty() || is_one_of(&args.select, change));
    changes.retain(|change| !is_one_of(&args.ignore, change));
    let severities = severities(args)?;
    changes.retain(|change| severities.of(&change.rule.info) != Some(Level::Off));
    let comparison = ComparedDescriptions { old, new, changes };
    match args.format {
        DiffFormat::Text => text::write(&comparison, out)?,
        DiffFormat::Json => json::write(&comparison, out)?,
        DiffFormat::Markdown => markdown::write(&comparison, out)?,
        DiffFormat::Html => {
            html::write(&comparison, [comparison.old.device()?, comparison.new.device()?], out)?;
        }
        DiffFormat::Github => github(&comparison, out)?,
    }
    let denied = args.deny.unwrap_or(Severity::Error);
    let severity = |change: &DeviceChange| match severities.of(&change.rule.info) {
        Some(Level::At(severity)) => severity,
        _ => change.finding().severity,
    };
    let is_denied = comparison.changes.iter().any(|change| severity(change) >= denied);
    Ok(if is_denied { Outcome::Findings } else { Outcome::Clean })
}

/// The severities that the configuration of the new description has for changes.
fn severities(args: &DiffArgs) -> Result<Severities, Failure> {
    let (of_config, path) = (SettingsArgs::from(&args.config), args.sides.newer());
    let mut settings = CommandSettings::new(&of_config)?;
    let project = settings.project_of(path)?;
    let severities = settings.options(path, project.as_deref()).severities;
    settings.unusable().next().map_or(Ok(severities), Err)
}

impl ComparedDescriptions {
    /// The number of changes of a verdict.
    fn count(&self, verdict: ChangeVerdict) -> usize {
        self.changes.iter().filter(|change| change.verdict() == verdict).count()
    }

    /// The worst verdict.
    fn verdict(&self) -> Option<ChangeVerdict> {
        self.changes.iter().map(DeviceChange::verdict).max()
    }

    /// The number of changes by verdict, in words.
    fn summary(&self) -> String {
        if self.changes.is_empty() {
            return "no changes".to_owned();
        }
        let counts = ChangeVerdict::ALL.into_iter().rev().map(|verdict| (self.count(verdict), verdict));
        let counts = counts.filter(|(count, _)| *count > 0);
        let counts: Vec<String> = counts.map(|(count, verdict)| format!("{count} {verdict}")).collect();
        let total = objdict_model::diagnostic::counted(self.changes.len(), "change", "changes");
        format!("{total}: {}", counts.join(", "))
    }
}

/// The address of a change: `6040h:00`, `TPDO` parameters as objects; empty for the device as a whole.
pub(super) fn address(change: &DeviceChange) -> String {
    match (change.index, change.sub) {
        (Some(index), Some(sub)) => format!("{index:04X}h:{sub:02X}"),
        (Some(index), None) => format!("{index:04X}h"),
        (None, _) => "device".to_owned(),
    }
}

/// What was removed is annotated in the old file, all else in the new one.
fn github(comparison: &ComparedDescriptions, out: &mut Output) -> Result<(), Failure> {
    let ComparedDescriptions { old, new, changes } = comparison;
    let (here, gone): (Vec<&DeviceChange>, Vec<&DeviceChange>) =
        changes.iter().partition(|change| change.new_place.is_some());
    let mut raw = out.raw()?;
    let mut report = Github::new(&mut raw).base(&report::base(None));
    for (side, changes) in [(old, gone), (new, here)] {
        let mut findings = Findings::new();
        changes.into_iter().for_each(|change| findings.push(change.finding()));
        match side.description() {
            Some(description) => report.file(Subject::Description(description), &findings)?,
            None => findings.iter().try_for_each(|finding| report.unread(&finding.message.shown()))?,
        }
    }
    report.finish()?;
    Ok(())
}
