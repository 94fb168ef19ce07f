//! Generates the files of a product from a description, in one piece for the command and for build scripts: reading,
//! checking according to the configuration, generating, writing. Callers supply arguments and reporting.

#[cfg(feature = "lint")]
mod configured;
mod depfile;
mod error;
#[cfg(feature = "full")]
mod full;

use std::borrow::Cow;
use std::cmp::Reverse;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

pub use self::depfile::depfile;
pub use self::error::{Error, placed, report_lines};
#[cfg(feature = "command")]
pub use crate::output::PrivateFile;
pub use crate::output::{FileState, Hash, Manifest, OutputError, OutputFolder, Saved, Used, abandon, save};
use objdict_format::input::{Input, Reading};
use objdict_format::{Description, Format};
use objdict_generate as generate;
use objdict_generate::{Generated, Note, Options, OutputFile, Size, Sizes, Target, files_of, general_notes};
use objdict_lint as lint;
use objdict_lint::Severities;
use objdict_model::diagnostic::{At, Diagnostic, Findings, Severity, one_line};
use objdict_model::model::{Device, Place};
use objdict_model::source::{SourceOptions, hash};
use objdict_project::check::{of_devices, with_origin_beside};
use objdict_project::report::{Subject, grouped, listed};
#[cfg(feature = "lint")]
pub use objdict_project::workspace::ConfigSource;

/// A request to generate files from a description.
#[derive(Debug, Default)]
pub struct Request {
    /// The description; its bytes may come from elsewhere.
    pub file: PathBuf,
    /// Options for reading it.
    pub reading: Reading,
    /// Patches, which are read together with the description.
    pub patches: Vec<PathBuf>,
    /// The settings of the check.
    pub check: CheckSettings,
    /// Whether the PDOs are described that `CompactPDO` implies.
    pub implicit_pdos: bool,
    /// Whether to generate although tables will be wrong.
    pub force: bool,
    /// The lowest severity of a finding that stops it, in addition to errors that make a table wrong.
    pub deny: Option<Severity>,
    /// A file of known findings, which are ignored.
    pub baseline: Option<PathBuf>,
    /// The requested targets; duplicates are ignored.
    pub targets: Vec<Target>,
    /// The files to which the description is also written, in the formats of their extensions.
    pub conversions: Vec<PathBuf>,
    /// The options; the file names, the names in the file of names, and the hash are added automatically.
    pub options: Options,
    /// Whether the size of the tables is reported.
    pub sizes: bool,
    /// The maximum number of flash and RAM bytes for the tables of a target.
    pub room: MemoryLimits,
}

/// The settings of a check.
#[derive(Debug, Default)]
pub struct CheckSettings {
    /// The source of the configuration.
    #[cfg(feature = "lint")]
    pub config: ConfigSource,
    /// The severities that override those of the rules.
    pub severities: Severities,
    /// Additional profiles to check against: numbers, or paths of files.
    pub profiles: Vec<String>,
}

/// A description that was read and checked.
#[derive(Debug)]
pub struct CheckedDescription {
    /// Its name in reports.
    name: String,
    described: DescribedDevice,
    /// Its problems.
    pub findings: Findings,
    /// Warnings about the configuration, a line each.
    pub of_config: Vec<String>,
}

/// A device, with its text if it has one.
#[derive(Debug)]
enum DescribedDevice {
    Text(Box<Description>),
    Model(Box<Device>),
}

/// The description as a file of another format, before it is written.
#[derive(Debug)]
pub struct Conversion {
    /// The file.
    pub path: PathBuf,
    /// Its bytes.
    pub bytes: Vec<u8>,
    /// The losses compared with the device, one line each.
    pub lost: Vec<String>,
}

/// Limits for the tables in bytes.
#[derive(Clone, Copy, Debug, Default)]
pub struct MemoryLimits {
    /// The maximum number of bytes of constants.
    pub flash: Option<usize>,
    /// The maximum number of bytes of variables.
    pub ram: Option<usize>,
}

/// The files of a product, before they are written.
#[derive(Debug)]
pub struct Generation {
    /// How many objects the device has.
    pub objects: usize,
    /// How many entries they have.
    pub entries: usize,
    /// The generated output, in the order of the targets.
    pub outputs: Vec<(Target, Generated)>,
    /// The description in other formats.
    pub conversions: Vec<Conversion>,
    /// Sizes of the tables; empty unless requested.
    pub sizes: Vec<(Target, Sizes)>,
}

impl Request {
    /// Reads and checks the bytes of the description, called `name` in reports. Other files that are read for it are
    /// added to `files`, even on failure.
    pub fn check(
        &self,
        name: &str,
        bytes: Vec<u8>,
        files: &mut Vec<PathBuf>,
    ) -> Result<CheckedDescription, Error> {
        let reading = self.reading.clone();
        #[cfg(feature = "lint")]
        let project = self.project(files)?;
        #[cfg(feature = "full")]
        let reading = self.with_patches(reading, project.as_ref(), files)?;
        // its errors are among the findings, and stop the generation
        let reading = Reading { judge: None, ..reading };
        let described = match reading.read_one(name, bytes)? {
            (_, Input::Description(description)) => {
                let options = SourceOptions { encoding: None, max_size: reading.max_size };
                let description = with_origin_beside(&self.file, *description, &options);
                files.extend_from_slice(description.extended_files());
                files.extend(description.origin().map(|origin| PathBuf::from(origin.source().name())));
                DescribedDevice::Text(Box::new(description))
            }
            (_, Input::Device(device)) => DescribedDevice::Model(device),
            #[cfg(feature = "full")]
            (kind, _) => {
                return Err(objdict_format::ReadError::NoDevice { name: name.to_owned(), kind }.into());
            }
        };
        let node_id = self.options.node_id.filter(|id| (1..=127).contains(id));
        #[cfg(feature = "lint")]
        let (options, of_config) = self.configured(project.as_ref(), node_id, files)?;
        #[cfg(feature = "full")]
        let of_config = described.with_lines_of_patches(of_config);
        #[cfg(not(feature = "lint"))]
        let (options, of_config) = (lint::Options { node_id, ..lint::Options::default() }, Vec::new());
        let findings = match &described {
            DescribedDevice::Text(description) => {
                let findings = checked(description, &options);
                #[cfg(feature = "full")]
                let findings = self.unknown(description, findings, files)?;
                grouped(&**description, findings)
            }
            DescribedDevice::Model(device) => options.severities.apply(lint::check(device, &options)),
        };
        Ok(CheckedDescription { name: name.to_owned(), described, findings, of_config })
    }

    /// Produces everything that is to be written, before anything is.
    ///
    /// # Errors
    /// If errors in the description make a table wrong, or a `device.toml` has any, and `force` is not set; or if a
    /// target cannot express the device.
    pub fn produce(
        &self,
        checked: &CheckedDescription,
        files: &mut Vec<PathBuf>,
    ) -> Result<Generation, Error> {
        if !self.force {
            let is_error = |finding: &Diagnostic| finding.severity == Severity::Error;
            checked
                .refuse(|finding| self.is_stopped_by(finding) || checked.is_source() && is_error(finding))?;
        }
        let device = checked.device();
        let device = if self.implicit_pdos { device.with_implicit_pdos() } else { Cow::Borrowed(device) };
        let options = self.options(checked, files)?;
        let mut outputs: Vec<(Target, Generated)> = Vec::new();
        let mut sizes = Vec::new();
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
            outputs.push((target, generated));
        }
        separate(&mut outputs);
        self.room.is_measured(&sizes)?;
        if let Some((_, first)) = outputs.first_mut() {
            first.notes.splice(0..0, general_notes(&device, &self.targets, &options));
        }
        let entries = device.objects.values().map(|object| object.entries().count()).sum();
        let conversions = Vec::new();
        let generation = Generation { objects: device.objects.len(), entries, outputs, conversions, sizes };
        #[cfg(feature = "full")]
        let generation = self.with_conversions(generation, checked.described())?;
        Ok(generation)
    }

    fn is_stopped_by(&self, finding: &Diagnostic) -> bool {
        let is_denied = self.deny.is_some_and(|deny| finding.severity >= deny);
        is_denied || self.targets.iter().any(|target| finding.stops(target.name()))
    }

    fn options(&self, checked: &CheckedDescription, files: &mut Vec<PathBuf>) -> Result<Options, Error> {
        let mut options = self.options.clone();
        options.file_stem = stem(&self.file);
        options.source_hash = match &checked.described {
            DescribedDevice::Text(description) => Some(hash(description.source().text().as_bytes())),
            DescribedDevice::Model(_) => None,
        };
        files.extend(options.template.clone());
        #[cfg(feature = "lint")]
        configured::rename(&mut options, files)?;
        Ok(options)
    }
}

/// Moves the files of a target to a folder if an earlier one in the list of all targets has a file of the same name.
/// The order of the request does not matter, so a build with the same targets finds its files.
fn separate(outputs: &mut [(Target, Generated)]) {
    let mut paths: BTreeSet<String> = BTreeSet::new();
    for known in Target::all() {
        let Some((target, generated)) = outputs.iter_mut().find(|(target, _)| target.name() == known.name())
        else {
            continue;
        };
        // `od.h` and `OD.h` are one file on many systems
        let is_taken = |file: &OutputFile| paths.contains(&file.path.to_ascii_lowercase());
        if generated.files.iter().any(is_taken) {
            let files = generated.files.iter_mut();
            files.for_each(|file| file.path = format!("{}/{}", target.name(), file.path));
        }
        paths.extend(generated.files.iter().map(|file| file.path.to_ascii_lowercase()));
    }
}

impl MemoryLimits {
    fn is_limited(self) -> bool {
        self.flash.is_some() || self.ram.is_some()
    }

    /// Rejects tables that exceed the limits; adds a note if the size is unknown.
    fn admit(self, target: Target, sizes: &Sizes) -> Result<Option<Note>, Error> {
        let Size { flash, ram } = match sizes {
            Sizes::Known(report) => report.total,
            Sizes::Unknown(why) if self.is_limited() => {
                let text = format!("the table size is unknown, so it is not limited: {why}");
                let note = Note::new(Place::device(), text);
                return Ok(Some(note.help("see the linker map file")));
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

    /// Rejects limits that apply to none of the targets.
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
            DescribedDevice::Text(description) => description.device(),
            DescribedDevice::Model(device) => device,
        }
    }

    /// All that is described, disabled objects too.
    #[cfg(feature = "full")]
    fn described(&self) -> &Device {
        match &self.described {
            DescribedDevice::Text(description) => description.described(),
            DescribedDevice::Model(device) => device,
        }
    }

    /// Whether it was written for objdict, so that its author can correct every error.
    fn is_source(&self) -> bool {
        matches!(&self.described, DescribedDevice::Text(description) if description.format() == Format::Toml)
    }

    /// The findings that stop the generation, as an error if there are any.
    fn refuse(&self, stops: impl Fn(&Diagnostic) -> bool) -> Result<(), Error> {
        refusal(&self.name, &self.findings, stops, |errors| match &self.described {
            DescribedDevice::Text(description) => text_of((&**description).into(), errors),
            DescribedDevice::Model(_) => {
                errors.iter().map(|error| without_text(&self.name, error) + "\n").collect()
            }
        })
    }

    /// A finding on one line: its place, the rule and the message.
    pub fn line(&self, finding: &Diagnostic) -> String {
        match &self.described {
            DescribedDevice::Text(description) => {
                finding.line(description.source(), |at| description.span_of(at))
            }
            DescribedDevice::Model(_) => without_text(&self.name, finding),
        }
    }
}

/// The findings of a description. A `device.toml` is checked with its variants, because its author corrects both; a
/// selected variant is checked on its own.
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

/// A finding for a device without a text.
fn without_text(name: &str, finding: &Diagnostic) -> String {
    let place = match finding.labels.first().map(|label| &label.at) {
        Some(At::Place(place)) => place.to_string(),
        _ => Place::device().to_string(),
    };
    let (rule, severity, message) = (finding.rule.id, finding.severity, &finding.message);
    one_line(&format!("{name}: {severity} {rule}: {place}: {message}"))
}

/// The file name without its last extension.
fn stem(file: &Path) -> String {
    let stem = file.file_stem().filter(|_| file != Path::new("-"));
    stem.map_or_else(|| "device".to_owned(), |stem| stem.to_string_lossy().into_owned())
}
