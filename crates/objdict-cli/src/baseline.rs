//! The baseline of a check: a file, and the names of other files in it.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use clap::Args;

use super::ending::{Failure, note};
use super::input::name_of;
use super::written_files::{keep, save};
use objdict_model::diagnostic::plural;
use objdict_model::diagnostic::{Findings, counted};
use objdict_model::source::read_text;
use objdict_project::baseline::{Baseline, MAX_SIZE, folder_of, name_in};
use objdict_project::report::{Fingerprint, Subject};
use objdict_traffic::Incident;

// Findings that are known.
#[derive(Debug, Default, Args)]
#[command(next_help_heading = "Settings")]
pub(super) struct BaselineArgs {
    /// Baseline from `check --write-baseline`; its findings are not reported
    #[arg(long, value_name = "FILE")]
    baseline: Option<PathBuf>,
    /// Baseline file for all findings, which are written instead of reported
    #[arg(long, value_name = "FILE", conflicts_with = "baseline")]
    write_baseline: Option<PathBuf>,
}

/// What is done with findings that may be known.
pub(super) enum KnownFindings {
    /// There is no baseline.
    Nothing,
    /// They are looked for in a baseline, whose file this is.
    Read(PathBuf, Baseline, KnownCounts),
    /// They become a baseline in this file.
    Write(PathBuf, Baseline),
}

/// How many findings of each file that was checked were known.
type KnownCounts = BTreeMap<String, usize>;

impl KnownFindings {
    /// What the arguments say.
    ///
    /// # Errors
    /// When the baseline that they name cannot be read.
    pub(super) fn new(args: &BaselineArgs) -> Result<Self, Failure> {
        Ok(match (&args.baseline, &args.write_baseline) {
            (Some(path), _) => Self::Read(path.clone(), read(path)?, KnownCounts::new()),
            (None, Some(path)) => Self::Write(path.clone(), Baseline::default()),
            (None, None) => Self::Nothing,
        })
    }

    /// Takes the findings away that are not to be reported.
    pub(super) fn sift(&mut self, subject: Subject<'_>, findings: &mut Findings) {
        let file = subject.source().name();
        match self {
            Self::Nothing => {}
            Self::Read(path, baseline, matched) => {
                let count = baseline.suppress_beside(path, subject, findings);
                *matched.entry(name_in(path, file)).or_default() += count;
            }
            Self::Write(path, baseline) => {
                baseline.add(&name_in(path, file), subject, findings);
                findings.suppress(|_| true);
            }
        }
    }

    /// Removes known incidents, from any log, and returns their number.
    pub(super) fn sift_incidents(&mut self, log: &str, incidents: &mut Vec<Incident>) -> usize {
        let before = incidents.len();
        let print = |incident: &Incident| incident.fingerprint.parse::<Fingerprint>().ok();
        match self {
            Self::Nothing => {}
            Self::Read(_, baseline, matched) => {
                // the logs that it is of are others
                matched.extend(baseline.files().map(|(file, _)| (file.to_owned(), 0)));
                incidents.retain(|incident| {
                    let file =
                        print(incident).and_then(|print| baseline.file_of(incident.kind.rule.id, print));
                    file.into_iter().for_each(|file| *matched.entry(file.to_owned()).or_default() += 1);
                    file.is_none()
                });
            }
            Self::Write(path, baseline) => {
                for incident in incidents.drain(..) {
                    if let Some(print) = print(&incident) {
                        baseline.insert(&name_in(path, log), incident.kind.rule.id, print, incident.text);
                    }
                }
            }
        }
        before - incidents.len()
    }

    /// Whether the findings become a baseline, instead of being reported.
    pub(super) const fn is_written(&self) -> bool {
        matches!(self, Self::Write(..))
    }

    /// Writes the baseline, or reports the entries that are no longer found.
    pub(super) fn finish(self) -> Result<(), Failure> {
        match self {
            Self::Nothing => {}
            Self::Read(path, baseline, matched) => {
                let folder = folder_of(&path);
                let fixed = |(file, count): (&str, usize)| match matched.get(file) {
                    Some(found) => count.saturating_sub(*found),
                    None if folder.join(file).exists() => 0,
                    None => count,
                };
                let fixed: usize = baseline.files().map(fixed).sum();
                // those of a file that was moved are found there
                let is_moved = |file: &&String| baseline.files().all(|(known, _)| known != **file);
                let moved: usize =
                    matched.iter().filter(|(file, _)| is_moved(file)).map(|(_, count)| count).sum();
                let fixed = fixed.saturating_sub(moved);
                if fixed > 0 {
                    let (entries, are) = if fixed == 1 { ("entry", "is") } else { ("entries", "are") };
                    note(&format!(
                        "note: {fixed} {entries} of the baseline `{path}` {are} no longer found\n  help: write it again: `--write-baseline {path}`\n",
                        path = name_of(&path)
                    ));
                }
            }
            Self::Write(path, baseline) => {
                save(&path, baseline.write().as_bytes())?;
                let files = baseline.files().filter(|(_, count)| *count > 0).count();
                note(&format!(
                    "note: the baseline `{}` has {} in {}\n",
                    name_of(&path),
                    counted(baseline.len(), "finding", "findings"),
                    plural(files, "file")
                ));
            }
        }
        Ok(())
    }
}

fn read(path: &Path) -> Result<Baseline, Failure> {
    keep(path);
    let help = || format!("`--write-baseline {}` writes it", name_of(path));
    let text = read_text(path, MAX_SIZE).map_err(|error| Failure::new(error).help(help()))?;
    let invalid = |error| Failure::new(format_args!("`{}` {error}", name_of(path))).help(help() + " anew");
    Baseline::read(&text).map_err(invalid)
}
