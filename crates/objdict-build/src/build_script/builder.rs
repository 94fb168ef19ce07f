//! The builder for build scripts.

use std::cmp::Reverse;
use std::collections::BTreeSet;
use std::io::{self, Write};
use std::num::NonZeroUsize;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};

use super::cargo::Cargo;
use super::{Built, Error};
use crate::pipeline::{CheckedDescription, Generation, OutputFolder, Request, Used, placed};
use objdict_format::ReadError;
use objdict_format::input::FileKind;
use objdict_generate::{
    CTable, ChoiceError, Derive, Names, OptionField, PdoMappings, SharedCell, StackLayout, StorageGroup,
    Target,
};
use objdict_lint::{Level, Severities};
use objdict_model::diagnostic::{Selection, Severity, Text, counted};
use objdict_model::model::Address;
use objdict_model::source;
use objdict_model::source::Encoding;
use objdict_project::registry;

/// The default maximum number of warnings about a description, and of notes about a target.
const MAX_WARNINGS: usize = 20;

/// Generates files from a description; see [the module](super).
///
/// Paths are relative to the current folder, which Cargo sets to the folder of `Cargo.toml` when it runs a
/// build script.
#[derive(Debug)]
#[must_use = "nothing is generated without `generate`"]
pub struct Builder {
    request: Request,
    out_dir: Option<PathBuf>,
    overwrite: bool,
    max_warnings: usize,
    /// The accepted warnings and notes: rules, and texts in notes.
    accepted: Vec<String>,
    /// The first invalid option.
    failure: Option<Error>,
}

impl Builder {
    /// Generates from the description at `path`: EDS, DCF, XDD, XDC, or a JSON device.
    pub fn new(path: impl AsRef<Path>) -> Self {
        let request = Request { file: path.as_ref().to_owned(), ..Request::default() };
        Self {
            request,
            out_dir: None,
            overwrite: false,
            max_warnings: MAX_WARNINGS,
            accepted: Vec::new(),
            failure: None,
        }
    }

    /// Adds a target; may be called several times. Without it, the first target in the enabled
    /// crate features: `rust`, if enabled.
    pub fn target(mut self, target: Target) -> Self {
        self.request.targets.push(target);
        self
    }

    /// The output folder, instead of the one in the variable `OUT_DIR`.
    pub fn out_dir(mut self, folder: impl AsRef<Path>) -> Self {
        self.out_dir = Some(folder.as_ref().to_owned());
        self
    }

    /// Whether to replace files in the folder that objdict did not write, or that differ from their
    /// entry in `objdict.sha256`. Input files are never replaced.
    pub fn overwrite(mut self, overwrite: bool) -> Self {
        self.overwrite = overwrite;
        self
    }

    /// Whether to generate despite errors in the description that make the tables wrong. They become build
    /// warnings.
    pub fn force(mut self, force: bool) -> Self {
        self.request.force = force;
        self
    }

    /// A replacement name for the identifiers of an object or entry; a name in a file of names takes
    /// precedence.
    pub fn name_of(mut self, at: impl Into<Address>, name: impl Into<String>) -> Self {
        self.request.options.renamed.insert(at.into(), name.into());
        self
    }

    /// The maximum number of flash bytes for each target's tables, without the code that serves them.
    pub fn max_flash(mut self, bytes: usize) -> Self {
        self.request.room.flash = Some(bytes);
        self
    }

    /// The maximum number of RAM bytes for each target's values.
    pub fn max_ram(mut self, bytes: usize) -> Self {
        self.request.room.ram = Some(bytes);
        self
    }

    /// Computes the size of the tables of each target, for [`Built::sizes`]; without it, only if there is a limit.
    pub fn sizes(mut self) -> Self {
        self.request.sizes = true;
        self
    }

    /// Whether to describe the PDOs that `CompactPDO` implies, as many as `NrOfRXPDO` and `NrOfTXPDO` state.
    pub fn implicit_pdos(mut self, describe: bool) -> Self {
        self.request.implicit_pdos = describe;
        self
    }

    /// The format of the description, instead of the detected one.
    pub fn from_kind(mut self, kind: FileKind) -> Self {
        self.request.reading.from = Some(kind);
        self
    }

    /// The device of a network file (`.nxdd`, `.nxdc`), counted from 1.
    pub fn device(mut self, number: NonZeroUsize) -> Self {
        self.request.reading.device = Some(number);
        self
    }

    /// The encoding of the description, if it cannot be detected.
    pub fn encoding(mut self, encoding: Encoding) -> Self {
        self.request.reading.encoding = Some(encoding);
        self
    }

    /// The maximum size of a description in bytes; without it,
    /// [64 MiB](objdict_model::source::DEFAULT_MAX_SIZE).
    pub fn max_size(mut self, bytes: u64) -> Self {
        self.request.reading.max_size = bytes;
        self
    }

    /// How many entries the description may have in compact storage; without it,
    /// [25,000](objdict_format::input::DEFAULT_MAX_ENTRIES).
    pub fn max_entries(mut self, count: usize) -> Self {
        self.request.reading.max_entries = count;
        self
    }

    /// The severity of a rule or group, such as `cia306/file-name` or `cia302`. Later calls override earlier ones and
    /// the configuration.
    pub fn severity(self, rules: &str, level: Level) -> Self {
        self.with_rules(rules, |severities, rules| severities.set(rules, level))
    }

    /// Reports only a rule or group; may be called several times.
    pub fn select(self, rules: &str) -> Self {
        self.with_rules(rules, Severities::select)
    }

    /// Does not report a rule or group; may be called several times.
    pub fn ignore(self, rules: &str) -> Self {
        self.severity(rules, Level::Off)
    }

    /// The lowest severity of a finding that stops the generation. Without it, only errors that make a table wrong stop
    /// it: the type, access or value of an entry is unknown, or the entry is described twice.
    pub fn deny(mut self, severity: Severity) -> Self {
        self.request.deny = Some(severity);
        self
    }

    fn with_rules(mut self, name: &str, change: impl FnOnce(&mut Severities, Selection)) -> Self {
        match registry::select(name) {
            Some(rules) => change(&mut self.request.check.severities, rules),
            None => self.fail(Error::UnknownRule { name: name.to_owned() }),
        }
        self
    }

    /// The maximum number of check warnings, and of notes for each target, that Cargo shows, followed by the number of
    /// the rest. Default: 20. Errors of the check are all shown.
    pub fn max_warnings(mut self, most: usize) -> Self {
        self.max_warnings = most;
        self
    }

    /// Suppresses accepted warnings and notes: warnings of a rule such as `cia306/file-name`, and warnings and notes of
    /// targets whose line contains the text, such as a place (`0x1003sub0`) or words of the message; may be called
    /// several times. Unused values are reported in a warning. Errors are always reported.
    pub fn accept(mut self, what: impl Into<String>) -> Self {
        self.accepted.push(what.into());
        self
    }

    /// Checks the description, writes the files and reports to Cargo on the standard output.
    ///
    /// # Errors
    /// If there is an error in the description, or a file cannot be read or written; see [`Error`].
    pub fn generate(self) -> Result<Built, Error> {
        self.generate_to(&mut io::stdout().lock())
    }

    /// Like [`generate`](Self::generate), but writes the lines for Cargo to `cargo`.
    ///
    /// # Errors
    /// Like [`generate`](Self::generate), and if `cargo` cannot be written to.
    pub fn generate_to(mut self, cargo: &mut dyn Write) -> Result<Built, Error> {
        if let Some(error) = self.failure {
            return Err(error);
        }
        if self.request.targets.is_empty() {
            self.request.targets.extend(Target::all().next());
        }
        let mut cargo = Cargo::new(cargo);
        let mut files = vec![self.request.file.clone()];
        let produced = self.produce(&mut files);
        // also on failure, so that Cargo runs the script again when these files change
        files.iter().try_for_each(|file| cargo.depends_on(file)).map_err(Error::Cargo)?;
        let (checked, generation) = produced?;
        self.warn(&checked, &generation, &mut cargo).map_err(Error::Cargo)?;
        let folder = self.out_dir.or_else(|| std::env::var_os("OUT_DIR").map(PathBuf::from));
        let folder = OutputFolder::open(&folder.ok_or(Error::NoOutDir)?, "generate", self.overwrite)?;
        write(&generation, folder, &files)
    }

    fn produce(&self, files: &mut Vec<PathBuf>) -> Result<(CheckedDescription, Generation), Error> {
        let Request { file, reading, .. } = &self.request;
        let bytes = source::read(file, reading.max_size).map_err(ReadError::from)?;
        let checked = self.request.check(&source::shown(file), bytes, files)?;
        let generation = self.request.produce(&checked, files)?;
        Ok((checked, generation))
    }

    fn warn(
        &self,
        checked: &CheckedDescription,
        generation: &Generation,
        cargo: &mut Cargo<impl Write>,
    ) -> io::Result<()> {
        let file = source::shown(&self.request.file);
        let mut unused: BTreeSet<&str> = self.accepted.iter().map(String::as_str).collect();
        let mut is_new = |line: &str, is_error: bool| {
            let accepts = |what: &&String| !is_error && line.contains(what.as_str());
            let accepted: Vec<_> = self.accepted.iter().filter(accepts).collect();
            for what in &accepted {
                unused.remove(what.as_str());
            }
            accepted.is_empty()
        };
        let of_file = |severity| {
            let of_severity = checked.findings.iter().filter(move |finding| finding.severity == severity);
            of_severity.map(|finding| {
                with_advice(checked.line(finding), finding.help.as_ref().map(Text::shown).as_deref())
            })
        };
        cargo.warn(usize::MAX, of_file(Severity::Error), |_| String::new())?;
        let warnings = checked.of_config.iter().cloned().chain(of_file(Severity::Warning));
        let warnings: Vec<String> = warnings.filter(|line| is_new(line, false)).collect();
        cargo.warn(self.max_warnings, warnings, |count| {
            let warnings = counted(count, "more warning", "more warnings");
            format!("{file}: {warnings}; run `objdict check`")
        })?;
        for (target, generated) in &generation.outputs {
            let target = target.name();
            let mut notes: Vec<_> = generated.notes.iter().collect();
            // the most severe first, so that the limit does not drop them
            notes.sort_by_key(|note| Reverse(note.severity));
            let notes = notes.into_iter().filter_map(|note| {
                let text = format!("{file}: {}: {target}: {}", note.severity, placed(note));
                let is_error = note.severity == Severity::Error;
                is_new(&text, is_error).then(|| with_advice(text, note.help.as_deref()))
            });
            cargo.warn(self.max_warnings, notes, |count| {
                let notes = counted(count, "more note", "more notes");
                format!("{file}: {notes} of the target {target}; run `objdict generate`")
            })?;
        }
        let unused = unused.iter().map(|what| format!("{file}: `accept` matches no `{what}`: remove it"));
        cargo.warn(usize::MAX, unused, |_| String::new())?;
        for conversion in &generation.conversions {
            let to = source::shown(&conversion.path);
            let lost = conversion.lost.iter().map(|loss| format!("{file}: {to}: {loss}"));
            cargo.warn(self.max_warnings, lost, |count| {
                let losses = counted(count, "more loss", "more losses");
                format!("{file}: {to}: {losses}; run `objdict convert`")
            })?;
        }
        Ok(())
    }

    fn fail(&mut self, error: Error) {
        self.failure.get_or_insert(error);
    }
}

/// Settings of the check.
#[cfg(feature = "lint")]
impl Builder {
    /// The configuration; without it, the nearest `objdict.toml` in the folder of the description or above.
    pub fn config(mut self, file: impl AsRef<Path>) -> Self {
        self.request.check.config = crate::pipeline::ConfigSource::At(file.as_ref().to_owned());
        self
    }

    /// Uses no configuration.
    pub fn no_config(mut self) -> Self {
        self.request.check.config = crate::pipeline::ConfigSource::Off;
        self
    }

    /// Also checks against a profile: a CiA number such as `401`, or the path of a custom profile; may be called several times.
    pub fn profile(mut self, name: impl Into<String>) -> Self {
        self.request.check.profiles.push(name.into());
        self
    }
}

/// Patches, variants and conversions of the description.
#[cfg(feature = "full")]
impl Builder {
    /// Also writes the description to the file at `path`, in the format of its extension and with the same bytes as
    /// `objdict convert`, replacing an existing file; may be called several times. For an EDS or XDD that ships with
    /// the firmware.
    pub fn convert_to(mut self, path: impl AsRef<Path>) -> Self {
        self.request.conversions.push(path.as_ref().to_owned());
        self
    }

    /// The variant of a `device.toml`, by name.
    pub fn variant(mut self, name: impl Into<String>) -> Self {
        self.request.reading.variant = Some(name.into());
        self
    }

    /// Also applies a patch to the description if the patch selects it (docs/guides/patches.md), in addition to those
    /// of `objdict.toml`; may be called several times.
    pub fn patch(mut self, path: impl AsRef<Path>) -> Self {
        self.request.patches.push(path.as_ref().to_owned());
        self
    }

    /// A file of known findings, as written by `objdict check --write-baseline`: they neither stop the generation nor
    /// become warnings.
    pub fn baseline(mut self, file: impl AsRef<Path>) -> Self {
        self.request.baseline = Some(file.as_ref().to_owned());
        self
    }
}

macro_rules! methods {
    ($(
        $(#[doc = $doc:tt])+
        $choice:ident $name:literal {
            field: $field:ident: $type:ty = $default:expr,
            argument: $argument:ty [$($clap:tt)*],
            method: $method:ident($($parameter:ident: $of:ty),*) => $value:expr,
            $(needs: $feature:tt,)?
        }
    )+) => {
        /// Options of generated code.
        impl Builder {
            $(
                $(#[doc = $doc])+
                $(#[cfg(feature = $feature)])?
                pub fn $method(mut self $(, $parameter: $of)*) -> Self {
                    let value: Result<_, ChoiceError> = $value;
                    match value {
                        Ok(value) => self.request.options.$field.put(value),
                        Err(error) => self.fail(error.into()),
                    }
                    self
                }
            )+
        }
    };
}

objdict_generate::with_options!(methods);

fn with_advice(line: String, help: Option<&str>) -> String {
    match help {
        Some(help) => format!("{line} ({help})"),
        None => line,
    }
}

fn write(generation: &Generation, mut folder: OutputFolder, read: &[PathBuf]) -> Result<Built, Error> {
    let mut used = Used::default();
    read.iter().for_each(|file| used.add(file));
    let files = || generation.outputs.iter().flat_map(|(_, generated)| &generated.files);
    files().try_for_each(|file| folder.admit(&file.path, &file.contents, &used))?;
    generation.conversions.iter().try_for_each(|conversion| used.require_other(&conversion.path))?;
    let Generation { objects, entries, .. } = *generation;
    let sizes = generation.sizes.iter().map(|(target, sizes)| (target.name(), sizes.clone())).collect();
    let mut built = Built { objects, entries, files: Vec::new(), sizes };
    for file in files() {
        folder.save(&file.path, &file.contents, &mut used)?;
        built.files.push(folder.join(&file.path));
    }
    folder.finish(&mut used)?;
    for conversion in &generation.conversions {
        used.save(&conversion.path, &conversion.bytes)?;
        built.files.push(conversion.path.clone());
    }
    Ok(built)
}
