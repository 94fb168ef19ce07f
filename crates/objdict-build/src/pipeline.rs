//! From a description to the files of a product, in one piece for the command and for build scripts: reading, checking as
//! the configuration says, generating, writing. Callers supply arguments and reporting.

#[cfg(feature = "full")]
mod conversion;
#[cfg(feature = "command")]
mod depfile;
mod error;

use std::borrow::Cow;
use std::cmp::Reverse;
#[cfg(feature = "lint")]
use std::collections::BTreeMap;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
#[cfg(feature = "lint")]
use std::sync::Arc;

#[cfg(feature = "full")]
use self::conversion::Conversion;
#[cfg(feature = "command")]
pub use self::depfile::depfile;
pub use self::error::Error;
pub use self::error::placed;
#[cfg(feature = "command")]
pub use self::error::report_lines;
#[cfg(feature = "command")]
pub use crate::output::Hash;
pub use crate::output::OutputError;
#[cfg(feature = "command")]
pub use crate::output::{Manifest, Saved, State, abandon, save};
pub use crate::output::{OutputFolder, Used};
#[cfg(feature = "full")]
use objdict_format::ReadError;
use objdict_format::input::{Input, Reading};
#[cfg(feature = "full")]
use objdict_format::patch::{Patch, Patched};
use objdict_format::{Description, Format};
use objdict_generate as generate;
use objdict_generate::{Generated, Note, Options, OutputFile, Size, Sizes, Target, files_of, general_notes};
use objdict_lint as lint;
use objdict_lint::Severities;
#[cfg(feature = "full")]
use objdict_model::diagnostic::At;
use objdict_model::diagnostic::one_line;
use objdict_model::diagnostic::{Diagnostic, Findings, Severity};
#[cfg(feature = "lint")]
use objdict_model::model::Address;
use objdict_model::model::{Device, Place};
#[cfg(feature = "lint")]
use objdict_model::source::{MAX_TOML_SIZE, read_text, shown};
use objdict_model::source::{SourceOptions, hash};
#[cfg(feature = "lint")]
use objdict_profile as profile;
#[cfg(feature = "lint")]
use objdict_profile::Profile;
#[cfg(feature = "full")]
use objdict_project::baseline;
#[cfg(feature = "full")]
use objdict_project::baseline::Baseline;
use objdict_project::check::{of_devices, with_origin_beside};
#[cfg(feature = "lint")]
use objdict_project::config::Project;
use objdict_project::report::{Location, Subject, grouped, listed};
#[cfg(feature = "lint")]
pub use objdict_project::workspace::ConfigSource;
#[cfg(feature = "lint")]
use objdict_project::workspace::{Overrides, Workspace};

/// What is to be made of a description.
#[derive(Debug, Default)]
pub struct Request {
    /// The description; its bytes may come from elsewhere.
    pub file: PathBuf,
    /// How it is read.
    pub reading: Reading,
    /// Patches, which are read when the description is.
    #[cfg(feature = "full")]
    pub patches: Vec<PathBuf>,
    /// The settings of the check.
    pub check: CheckSettings,
    /// Whether the PDOs are described that `CompactPDO` implies.
    pub implicit_pdos: bool,
    /// Whether to generate although tables will be wrong.
    pub force: bool,
    /// The lowest severity of a finding that stops it, beside those that make a table wrong.
    pub deny: Option<Severity>,
    /// A file of findings that are known and neither stop nor count.
    #[cfg(feature = "full")]
    pub baseline: Option<PathBuf>,
    /// What to generate; what is there twice counts once.
    pub targets: Vec<Target>,
    /// The files that the description is also written to, in the formats of their names.
    #[cfg(feature = "full")]
    pub conversions: Vec<PathBuf>,
    /// The options; the names of files, those in the file of names, and the hash are found out.
    pub options: Options,
    /// Whether the size of the tables is reported.
    pub sizes: bool,
    /// The bytes of flash and of RAM that the tables of a target may take at most.
    pub room: MemoryLimits,
}

/// The settings of a check.
#[derive(Debug, Default)]
pub struct CheckSettings {
    /// Where the configuration comes from.
    #[cfg(feature = "lint")]
    pub config: ConfigSource,
    /// The severities that replace those of the rules.
    pub severities: Severities,
    /// Profiles to check against beside that of the device: numbers, or paths of files.
    #[cfg(feature = "lint")]
    pub profiles: Vec<String>,
}

/// A description that was read and checked.
#[derive(Debug)]
pub struct CheckedDescription {
    /// What reports call it.
    name: String,
    described: Described,
    /// Its problems.
    pub findings: Findings,
    /// Warnings about the configuration, a line each.
    pub of_config: Vec<String>,
}

/// A device, with its text where it has one.
#[derive(Debug)]
enum Described {
    Text(Box<Description>),
    #[cfg(feature = "full")]
    Model(Box<Device>),
}

/// What tables may take at most, in bytes.
#[derive(Clone, Copy, Debug, Default)]
pub struct MemoryLimits {
    /// The most bytes of constants.
    pub flash: Option<usize>,
    /// The most bytes of variables.
    pub ram: Option<usize>,
}

/// The files of a product, before they are written.
#[derive(Debug)]
pub struct Generation {
    /// How many objects the device has.
    pub objects: usize,
    /// How many entries they have.
    pub entries: usize,
    /// What was made, in the order of the targets.
    pub outputs: Vec<(Target, Generated)>,
    /// The description in other formats.
    #[cfg(feature = "full")]
    pub conversions: Vec<Conversion>,
    /// Sizes of the tables; empty unless requested.
    pub sizes: Vec<(Target, Sizes)>,
}

impl Request {
    /// Reads and checks the bytes of the description, which reports call `name`. The other files that are read for it go
    /// to `files`, whatever becomes of it.
    pub fn check(
        &self,
        name: &str,
        bytes: Vec<u8>,
        files: &mut Vec<PathBuf>,
    ) -> Result<CheckedDescription, Error> {
        #[cfg(feature = "full")]
        let reading = &self.with_patches(files)?;
        #[cfg(not(feature = "full"))]
        let reading = &self.reading;
        let described = match reading.read_one(name, bytes)? {
            (_, Input::Description(description)) => {
                let options = SourceOptions { encoding: None, max_size: reading.max_size };
                let description = with_origin_beside(&self.file, *description, &options);
                files.extend_from_slice(description.extended_files());
                files.extend(description.origin().map(|origin| PathBuf::from(origin.source().name())));
                Described::Text(Box::new(description))
            }
            #[cfg(feature = "full")]
            (_, Input::Device(device)) => Described::Model(device),
            #[cfg(feature = "full")]
            (kind, _) => return Err(ReadError::NoDevice { name: name.to_owned(), kind }.into()),
        };
        #[cfg(feature = "lint")]
        let (options, of_config) = self.configured(files)?;
        #[cfg(feature = "full")]
        let of_config = match &described {
            Described::Text(description) => {
                let patched = description.patched().map(Patched::lines).unwrap_or_default();
                of_config.into_iter().chain(patched).collect()
            }
            Described::Model(_) => of_config,
        };
        #[cfg(not(feature = "lint"))]
        let (options, of_config) = {
            let node_id = self.options.node_id.filter(|id| (1..=127).contains(id));
            (lint::Options { node_id, ..lint::Options::default() }, Vec::new())
        };
        let findings = match &described {
            Described::Text(description) => {
                let findings = checked(description, &options);
                #[cfg(feature = "full")]
                let findings = self.unknown(description, findings, files)?;
                grouped(&**description, findings)
            }
            #[cfg(feature = "full")]
            Described::Model(device) => options.severities.apply(lint::check(device, &options)),
        };
        Ok(CheckedDescription { name: name.to_owned(), described, findings, of_config })
    }

    /// How the description is read, with the patches of arguments and configuration.
    #[cfg(feature = "full")]
    fn with_patches(&self, files: &mut Vec<PathBuf>) -> Result<Reading, Error> {
        let mut reading = self.reading.clone();
        for path in &self.patches {
            files.push(path.clone());
            let patch = Patch::open(path).map_err(ReadError::from)?;
            reading.patches.push(Arc::new(patch));
        }
        if let Some(project) = self.project(&mut Vec::new())? {
            reading.patches.extend(project.patches.iter().cloned());
        }
        Ok(reading)
    }

    /// The findings that are not in the baseline.
    #[cfg(feature = "full")]
    fn unknown(
        &self,
        description: &Description,
        mut findings: Findings,
        files: &mut Vec<PathBuf>,
    ) -> Result<Findings, Error> {
        if let Some(path) = &self.baseline {
            files.push(path.clone());
            let text = read_text(path, baseline::MAX_SIZE)?;
            let baseline =
                Baseline::read(&text).map_err(|error| Error::Baseline { path: path.clone(), error })?;
            baseline.suppress_beside(path, description, &mut findings);
        }
        Ok(findings)
    }

    /// The options of the check, and the problems of the configuration that they come from.
    #[cfg(feature = "lint")]
    fn configured(&self, files: &mut Vec<PathBuf>) -> Result<(lint::Options, Vec<String>), Error> {
        let project = self.project(files)?;
        let profiles = self.check.profiles.iter().map(|name| self.profile(name, files));
        let overrides = Overrides {
            severities: self.check.severities.clone(),
            profiles: profiles.collect::<Result<_, _>>()?,
            node_id: self.options.node_id.filter(|id| (1..=127).contains(id)),
            ..Overrides::default()
        };
        let options = overrides.options(&self.file, project.as_ref());
        let findings = project.map(|project| config_findings(&project, &options)).transpose()?;
        Ok((options, findings.unwrap_or_default()))
    }

    #[cfg(feature = "lint")]
    fn project(&self, files: &mut Vec<PathBuf>) -> Result<Option<Project>, Error> {
        let mut workspace = Workspace::new(self.check.config.clone(), Overrides::default())?;
        let project = workspace.project_of(&self.file)?;
        files.extend(workspace.inputs());
        drop(workspace);
        let Some(mut project) = project.and_then(Arc::into_inner) else { return Ok(None) };
        if !project.failures.is_empty() {
            return Err(project.failures.swap_remove(0).into());
        }
        Ok(Some(project))
    }

    #[cfg(feature = "lint")]
    fn profile(&self, name: &str, files: &mut Vec<PathBuf>) -> Result<Arc<Profile>, Error> {
        if profile::named(name).is_none() && Path::new(name).is_file() {
            files.push(name.into());
        }
        Ok(profile::open(name, Path::new(""))?)
    }

    /// Everything that is to be written, before anything is.
    ///
    /// # Errors
    /// When errors in the description make a table wrong and `force` is not set, or a target cannot express the device.
    pub fn produce(
        &self,
        checked: &CheckedDescription,
        files: &mut Vec<PathBuf>,
    ) -> Result<Generation, Error> {
        if !self.force {
            checked.refuse(|finding| self.is_stopped_by(finding))?;
        }
        let device = checked.device();
        let device = if self.implicit_pdos { device.with_implicit_pdos() } else { Cow::Borrowed(device) };
        let options = self.options(checked, files)?;
        let mut outputs: Vec<(Target, Generated)> = Vec::new();
        let mut sizes = Vec::new();
        let mut paths: BTreeSet<String> = BTreeSet::new();
        for &target in &self.targets {
            if outputs.iter().any(|(other, _)| other.name() == target.name()) {
                continue;
            }
            let refused = |error| Error::Target { target: target.name(), error };
            let mut generated = files_of(&device, target, &options).map_err(refused)?;
            if self.sizes || self.room.is_limited() {
                let size = generate::size(&device, target, &options).map_err(refused)?;
                generated.notes.extend(self.room.admit(target, &size)?);
                sizes.push((target, size));
            }
            // `od.h` and `OD.h` are one file on many systems
            let is_taken = |file: &OutputFile| paths.contains(&file.path.to_ascii_lowercase());
            if generated.files.iter().any(is_taken) {
                generated
                    .files
                    .iter_mut()
                    .for_each(|file| file.path = format!("{}/{}", target.name(), file.path));
            }
            paths.extend(generated.files.iter().map(|file| file.path.to_ascii_lowercase()));
            outputs.push((target, generated));
        }
        self.room.is_measured(&sizes)?;
        if let Some((_, first)) = outputs.first_mut() {
            first.notes.splice(0..0, general_notes(&device, &self.targets, &options));
        }
        let entries = device.objects.values().map(|object| object.entries().count()).sum();
        Ok(Generation {
            objects: device.objects.len(),
            entries,
            outputs,
            #[cfg(feature = "full")]
            conversions: self.conversions_of(checked.device())?,
            sizes,
        })
    }

    #[cfg(feature = "full")]
    fn conversions_of(&self, device: &Device) -> Result<Vec<Conversion>, Error> {
        self.conversions.iter().map(|path| Conversion::of(device, path)).collect()
    }

    fn is_stopped_by(&self, finding: &Diagnostic) -> bool {
        let is_denied = self.deny.is_some_and(|deny| finding.severity >= deny);
        is_denied || self.targets.iter().any(|target| finding.stops(target.name()))
    }

    fn options(&self, checked: &CheckedDescription, files: &mut Vec<PathBuf>) -> Result<Options, Error> {
        let mut options = self.options.clone();
        options.file_stem = stem(&self.file);
        options.source_hash = match &checked.described {
            Described::Text(description) => Some(hash(description.source().text().as_bytes())),
            #[cfg(feature = "full")]
            Described::Model(_) => None,
        };
        files.extend(options.template.clone());
        #[cfg(feature = "lint")]
        if let Some(path) = options.rename.take() {
            files.push(path.clone());
            options.renamed.extend(names_in(&path)?);
        }
        Ok(options)
    }
}

impl MemoryLimits {
    fn is_limited(self) -> bool {
        self.flash.is_some() || self.ram.is_some()
    }

    /// Refuses tables that take more; a note where that is not known.
    fn admit(self, target: Target, sizes: &Sizes) -> Result<Option<Note>, Error> {
        let Size { flash, ram } = match sizes {
            Sizes::Known(report) => report.total,
            Sizes::Unknown(why) if self.is_limited() => {
                let text = format!("the size of the tables is unknown and so not limited: {why}");
                let note = Note::new(Place::device(), text);
                return Ok(Some(note.help("see the map file of the linker")));
            }
            Sizes::Unknown(_) => return Ok(None),
        };
        for (memory, bytes, most) in [("flash", flash, self.flash), ("RAM", ram, self.ram)] {
            if let Some(most) = most.filter(|&most| bytes > most) {
                return Err(Error::TooLarge { target: target.name(), memory, bytes, most });
            }
        }
        Ok(None)
    }

    /// Refuses limits that hold for none of the targets.
    fn is_measured(self, sizes: &[(Target, Sizes)]) -> Result<(), Error> {
        match sizes.first() {
            Some((target, Sizes::Unknown(why)))
                if self.is_limited() && sizes.iter().all(|(_, sizes)| matches!(sizes, Sizes::Unknown(_))) =>
            {
                Err(Error::NotMeasured { target: target.name(), why })
            }
            _ => Ok(()),
        }
    }
}

impl CheckedDescription {
    fn device(&self) -> &Device {
        match &self.described {
            Described::Text(description) => description.device(),
            #[cfg(feature = "full")]
            Described::Model(device) => device,
        }
    }

    /// The findings that stop as an error, if there are any.
    fn refuse(&self, stops: impl Fn(&Diagnostic) -> bool) -> Result<(), Error> {
        refusal(&self.name, &self.findings, stops, |errors| match &self.described {
            Described::Text(description) => text_of((&**description).into(), errors),
            #[cfg(feature = "full")]
            Described::Model(_) => {
                errors.iter().map(|error| without_text(&self.name, error) + "\n").collect()
            }
        })
    }

    /// A finding in a line: its place, the rule and the message.
    pub fn line(&self, finding: &Diagnostic) -> String {
        match &self.described {
            Described::Text(description) => line((&**description).into(), finding),
            #[cfg(feature = "full")]
            Described::Model(_) => without_text(&self.name, finding),
        }
    }
}

/// The findings of a description. A `device.toml` is checked with its variants, because its author corrects both; a selected variant is
/// checked alone.
fn checked(description: &Description, options: &lint::Options) -> Findings {
    let check = |description: &Description| objdict_project::check_with(description, options);
    if description.format() != Format::Toml || description.variant().is_some() {
        return check(description);
    }
    of_devices(description, check).into_iter().fold(Findings::new(), |mut all, found| {
        all.append(found);
        all
    })
}

/// Warnings about a configuration, a line each. Its errors stop the run even with `--force`, because the intended check is
/// unknown.
#[cfg(feature = "lint")]
fn config_findings(project: &Project, options: &lint::Options) -> Result<Vec<String>, Error> {
    let findings = options.severities.apply(project.findings.clone());
    let subject = Subject::Text(project.config.source());
    let is_error = |finding: &Diagnostic| finding.severity == Severity::Error;
    refusal(subject.source().name(), &findings, is_error, |errors| text_of(subject, errors))?;
    let warnings = findings.iter().filter(|finding| finding.severity >= Severity::Warning);
    Ok(warnings.map(|finding| line(subject, finding)).collect())
}

/// The findings that stop as an error, the worst first.
fn refusal(
    file: &str,
    findings: &Findings,
    stops: impl Fn(&Diagnostic) -> bool,
    shown: impl FnOnce(&Findings) -> String,
) -> Result<(), Error> {
    let mut findings = findings.clone().filter_map(|finding| stops(&finding).then_some(finding));
    if findings.is_empty() {
        return Ok(());
    }
    findings.sort_by_key(|finding| Reverse(finding.severity));
    let is_error = findings.iter().all(|finding| finding.severity == Severity::Error);
    let noun = if is_error { "error" } else { "finding" };
    let report = shown(&findings);
    Err(Error::Findings { file: file.to_owned(), findings, noun, report })
}

fn text_of(subject: Subject<'_>, findings: &Findings) -> String {
    listed(subject, findings).unwrap_or_else(|error| format!("the findings cannot be shown: {error}\n"))
}

/// A finding of a text in a line.
fn line(subject: Subject<'_>, finding: &Diagnostic) -> String {
    let start = Location::start_of(subject, finding);
    let (name, rule, severity) = (subject.source().name(), finding.rule.id, finding.severity);
    let message = &finding.message;
    one_line(&format!("{name}:{}:{}: {severity} {rule}: {message}", start.line, start.column))
}

/// A finding of a device that has no text.
#[cfg(feature = "full")]
fn without_text(name: &str, finding: &Diagnostic) -> String {
    let place = match finding.labels.first().map(|label| &label.at) {
        Some(At::Place(place)) => place.to_string(),
        _ => Place::device().to_string(),
    };
    let (rule, severity, message) = (finding.rule.id, finding.severity, &finding.message);
    one_line(&format!("{name}: {severity} {rule}: {place}: {message}"))
}

/// The names that a file gives to objects and entries.
#[cfg(feature = "lint")]
fn names_in(path: &Path) -> Result<BTreeMap<Address, String>, Error> {
    let text = read_text(path, MAX_TOML_SIZE)?;
    generate::renames(&text).map_err(|error| Error::Names { file: shown(path), error })
}

/// The file's name without its last ending.
fn stem(file: &Path) -> String {
    let stem = file.file_stem().filter(|_| file != Path::new("-"));
    stem.map_or_else(|| "device".to_owned(), |stem| stem.to_string_lossy().into_owned())
}
