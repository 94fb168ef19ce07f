//! What a file is, and what is found in it: the same as `objdict check` and `objdict network check` find.

use std::path::Path;
use std::sync::Arc;

use objdict_format as format;
use objdict_format::identify::{ContentKind, identify_source};
use objdict_format::input::{FileKind, Reading};
use objdict_format::patch::Patch;
use objdict_format::{Description, Format, ReadError};
use objdict_lint::{KnownObjects, Options};
use objdict_model::diagnostic::Findings;
use objdict_model::source::{CONFIG_FILE, Encoding, MAX_TOML_SIZE, SourceFile, SourceOptions, Span};
use objdict_network_file::{NetworkFile, PathOptions};
use objdict_profile::{OpenError, Profile};
use objdict_project::check_unordered;
use objdict_project::config::{Config, Project};
use objdict_project::report::Subject;
use objdict_project::workspace::{self, Overrides, with_origin_beside};

/// What is in a file.
#[derive(Debug)]
pub(super) enum FileContent {
    /// The description of a device, or of several.
    Description(Box<Description>),
    /// A network and the descriptions of its nodes.
    Network(Box<NetworkFile>),
    /// A configuration, a profile or a patch.
    Text(SourceFile),
    /// A file that nothing here reads.
    Foreign(SourceFile),
}

/// A file with its findings.
#[derive(Debug)]
pub(super) struct Analysis {
    pub(super) content: FileContent,
    /// The findings of each device of a description; of another file one list.
    pub(super) findings: Vec<Findings>,
    /// Errors that are not findings of rules: why the file cannot be read.
    pub(super) errors: Vec<ReadProblem>,
    pub(super) options: Options,
    /// What the rules about single objects found, for the next edit.
    known: KnownObjects,
    /// The configuration that holds for the file.
    project: Option<Arc<Project>>,
}

/// Why a file cannot be read or used.
#[derive(Debug)]
pub(super) struct ReadProblem {
    pub(super) span: Span,
    pub(super) message: String,
    pub(super) help: Option<String>,
}

impl Analysis {
    /// What the findings are about.
    pub(super) fn subject(&self) -> Subject<'_> {
        match &self.content {
            FileContent::Description(description) => (&**description).into(),
            FileContent::Network(network) => (&**network).into(),
            FileContent::Text(source) | FileContent::Foreign(source) => source.into(),
        }
    }

    /// The description; `None` for another file.
    pub(super) fn description(&self) -> Option<&Description> {
        match &self.content {
            FileContent::Description(description) => Some(description),
            _ => None,
        }
    }

    /// The network; `None` for another file.
    pub(super) fn network(&self) -> Option<&NetworkFile> {
        match &self.content {
            FileContent::Network(network) => Some(network),
            _ => None,
        }
    }

    /// How many objects the rules about single objects had to look at.
    #[cfg(test)]
    pub(super) fn checked_objects(&self) -> usize {
        self.known.checked()
    }

    /// What a function makes of each device of the file and its findings; of another file, of all of it.
    pub(super) fn map_subjects<T>(&self, mut make: impl FnMut(Subject<'_>, &Findings) -> T) -> Vec<T> {
        let mut findings = self.findings.iter();
        let Some(description) = self.description() else {
            return findings.map(|findings| make(self.subject(), findings)).collect();
        };
        let made = description.map_devices(|device| Some(make(device.into(), findings.next()?)));
        made.into_iter().flatten().collect()
    }

    /// What is found in another text of the file.
    pub(super) fn again(&self, text: &str) -> Self {
        let source = self.subject().source();
        let encoding = Some(source.encoding()).filter(|encoding| *encoding != Encoding::Utf8);
        let bytes = encoding.and_then(|encoding| encoding.encode(text).ok());
        let bytes = bytes.unwrap_or_else(|| text.as_bytes().to_vec());
        analyse(Path::new(source.name()), bytes, encoding, self.project.clone(), Some(self))
    }

    /// What a check finds in another text of the description.
    pub(super) fn check(&self, description: &Description) -> Findings {
        check_unordered(description, &self.options)
    }

    fn of(content: FileContent, findings: Findings, options: Options) -> Self {
        Self {
            content,
            findings: vec![findings],
            errors: Vec::new(),
            options,
            known: KnownObjects::default(),
            project: None,
        }
    }
}

/// Reads and checks a file, from what was found in another text of it.
pub(super) fn analyse(
    path: &Path,
    bytes: Vec<u8>,
    encoding: Option<Encoding>,
    project: Option<Arc<Project>>,
    before: Option<&Analysis>,
) -> Analysis {
    let analysis = read_and_checked(path, bytes, encoding, project.as_deref(), before);
    Analysis { project, ..analysis }
}

fn read_and_checked(
    path: &Path,
    bytes: Vec<u8>,
    encoding: Option<Encoding>,
    project: Option<&Project>,
    before: Option<&Analysis>,
) -> Analysis {
    let name = path.display().to_string();
    let options = options(path, project);
    let usable = project.filter(|project| project.is_usable());
    let mut reading = Reading { encoding, ..Reading::default() };
    reading.patches = usable.map(|project| project.patches.clone()).unwrap_or_default();
    if path.file_name().is_some_and(|name| name == CONFIG_FILE) {
        return of_project(path, source(&name, bytes, encoding), options);
    }
    match reading.recognised(&name, bytes.clone()) {
        Ok((kind, text)) => match kind.format() {
            Some(format) => {
                match reading.described_after(text, format, before.and_then(Analysis::description)) {
                    Ok(description) => {
                        let known = before.map(|before| before.known.clone()).unwrap_or_default();
                        of_description(path, description, options, known)
                    }
                    Err(error) => of_error(&error, source(&name, bytes, encoding), options),
                }
            }
            None => of_other(path, source(&name, bytes, encoding), &reading, options),
        },
        Err(ReadError::Foreign { .. }) if is_other(path) => {
            of_other(path, source(&name, bytes, encoding), &reading, options)
        }
        Err(ReadError::Foreign { .. }) if bytes.iter().all(u8::is_ascii_whitespace) => {
            let source = source(&name, bytes, encoding);
            // without an ending it is not saved yet
            let unsaved = path.extension().is_none().then_some(Format::Eds);
            match FileKind::of(path).and_then(FileKind::format).or(unsaved) {
                // a file that is about to be written
                Some(format) => {
                    let content = FileContent::Description(Box::new(format::read(source, format)));
                    Analysis::of(content, Findings::new(), options)
                }
                None => Analysis::of(FileContent::Foreign(source), Findings::new(), options),
            }
        }
        Err(error) => of_error(&error, source(&name, bytes, encoding), options),
    }
}

/// Whether a file may be something else than a description and still be one of ours.
fn is_other(path: &Path) -> bool {
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
    matches!(ending.as_deref(), Some("toml" | "yml" | "yaml" | "json" | "txt" | "cpj"))
}

fn options(path: &Path, project: Option<&Project>) -> Options {
    Overrides::default().options(path, project)
}

fn source(name: &str, bytes: Vec<u8>, encoding: Option<Encoding>) -> SourceFile {
    let options = SourceOptions { encoding, ..SourceOptions::default() };
    SourceFile::from_bytes(name, bytes, &options).unwrap_or_else(|_| SourceFile::from_text(name, ""))
}

fn of_description(
    path: &Path,
    description: Description,
    options: Options,
    mut known: KnownObjects,
) -> Analysis {
    let description = with_origin_beside(path, description, &SourceOptions::default());
    let findings = workspace::findings_after(&description, &options, &mut known);
    let content = FileContent::Description(Box::new(description));
    Analysis { findings, known, ..Analysis::of(content, Findings::new(), options) }
}

fn of_error(error: &ReadError, source: SourceFile, options: Options) -> Analysis {
    let problem = ReadProblem { span: Span::default(), message: error.to_string(), help: error.help() };
    Analysis { errors: vec![problem], ..Analysis::of(FileContent::Foreign(source), Findings::new(), options) }
}

/// A network, a patch or a profile; anything else has no findings.
fn of_other(path: &Path, source: SourceFile, reading: &Reading, options: Options) -> Analysis {
    let kind = identify_source(&source).kind;
    if kind.is_network() {
        let mut paths =
            PathOptions { judge: Some(objdict_project::workspace::judge), ..PathOptions::default() };
        paths.patches.clone_from(&reading.patches);
        let network = NetworkFile::read(source, path.parent().unwrap_or(Path::new("")), &paths);
        let findings = options.severities.apply(network.check());
        return Analysis::of(FileContent::Network(Box::new(network)), findings, options);
    }
    if kind == ContentKind::Patch {
        let patch = Patch::read(source);
        let findings = options.severities.apply(patch.findings().clone());
        let source = SourceFile::from_text(patch.source().name(), patch.source().text());
        return Analysis::of(FileContent::Text(source), findings, options);
    }
    if is_profile(&source) && source.text().len() as u64 <= MAX_TOML_SIZE {
        let error = Profile::from_toml(source.text()).err();
        let errors = error.map(|error| ReadProblem {
            span: error.span.unwrap_or_default(),
            message: error.message,
            help: error.help,
        });
        let errors = errors.into_iter().collect();
        return Analysis { errors, ..Analysis::of(FileContent::Text(source), Findings::new(), options) };
    }
    Analysis::of(FileContent::Foreign(source), Findings::new(), options)
}

/// Whether a text begins as a profile does: with the document that it is about, or its title.
fn is_profile(source: &SourceFile) -> bool {
    let lines = source.text().lines().map(str::trim);
    let mut lines = lines.filter(|line| !line.is_empty() && !line.starts_with('#'));
    let is_toml = Path::new(source.name()).extension().is_some_and(|ending| ending == "toml");
    let head = lines.by_ref().take_while(|line| !line.starts_with('['));
    let has_document = head
        .into_iter()
        .any(|line| line.strip_prefix("document").is_some_and(|rest| rest.trim_start().starts_with('=')));
    is_toml && has_document
}

/// `objdict.toml`, with the errors of the profiles that it names.
fn of_project(path: &Path, source: SourceFile, options: Options) -> Analysis {
    let (mut findings, mut errors) = (Findings::new(), Vec::new());
    if source.text().len() as u64 <= MAX_TOML_SIZE {
        // the text is not always that of the file: fixes are tried on others
        let text = SourceFile::from_text(source.name(), source.text());
        let project = Project::of(Config::read(text, path.parent().unwrap_or(Path::new(""))));
        findings = options.severities.apply(project.findings.clone());
        errors.extend(project.failures.iter().map(|failure| invalid(&project, failure)));
    }
    Analysis { errors, ..Analysis::of(FileContent::Text(source), findings, options) }
}

/// The error of a profile, at its name in the configuration.
fn invalid(project: &Project, failure: &OpenError) -> ReadProblem {
    let file = match failure {
        OpenError::Invalid { source_file, .. } => source_file.name(),
        _ => "",
    };
    let wanted = project.config.profiles().iter().find(|wanted| Path::new(file).ends_with(&wanted.name));
    let span = wanted.map(|wanted| wanted.span).unwrap_or_default();
    ReadProblem { span, message: failure.to_string(), help: failure.help() }
}
