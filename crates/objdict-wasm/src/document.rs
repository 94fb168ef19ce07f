//! An open description or network: the bytes that it was opened with, what they became, and the way back.

use std::io;
use std::sync::Arc;

use objdict::diagnostic::{Applicability, Change, Findings, Fix};
use objdict::format::Description;
use objdict::format::input::{FileKind, Input, Reading};
use objdict::format::network::NetworkFile;
use objdict::format::patch::{self, Patch};
use objdict::lint::Options;
use objdict::model::{Device, Field, Object};
use objdict::report::{Json, Report as _, Subject, by_place, grouped};
use objdict::source::{Edits, Encoding, SourceFile, SourceOptions, Span};
use serde::{Deserialize, Serialize};

use crate::answer::BadRequest;
use crate::place::place;

/// So many changed bytes are kept for undo, and at least one step.
const MAX_HISTORY: usize = 64 << 20;

/// A text that is being edited.
#[derive(Debug)]
pub(crate) struct EditedDocument {
    content: DocumentContent,
    original: Vec<u8>,
    before: Vec<UndoStep>,
    after: Vec<UndoStep>,
    /// Counts the texts that it has had: an edit of the text is for one of them.
    revision: usize,
}

/// The one stretch of bytes in which two texts differ.
#[derive(Debug)]
struct UndoStep {
    start: usize,
    old: Vec<u8>,
    new: Vec<u8>,
}

impl UndoStep {
    fn between(old: &[u8], new: &[u8]) -> Self {
        let same = |(one, other): &(&u8, &u8)| one == other;
        let start = old.iter().zip(new).take_while(same).count();
        let (old, new) = (old.get(start..).unwrap_or_default(), new.get(start..).unwrap_or_default());
        let end = old.iter().rev().zip(new.iter().rev()).take_while(same).count();
        let inner = |bytes: &[u8]| bytes.get(..bytes.len() - end).unwrap_or_default().to_vec();
        Self { start, old: inner(old), new: inner(new) }
    }

    fn back(self) -> Self {
        Self { old: self.new, new: self.old, ..self }
    }

    fn make(&self, mut bytes: Vec<u8>) -> Vec<u8> {
        bytes.splice(self.start..self.start + self.old.len(), self.new.iter().copied());
        bytes
    }
}

/// What a text is read as.
#[derive(Debug)]
enum DocumentContent {
    Description(Box<Description>),
    /// Its nodes are described by other documents, so it is read when it is asked for.
    Network(SourceFile),
}

/// A piece of the text and what it becomes, as the JSON of findings has it: lines and columns are counted from 1, columns in Unicode
/// scalar values.
#[derive(Debug, Deserialize)]
pub(crate) struct TextEdit {
    line: usize,
    column: usize,
    end_line: usize,
    end_column: usize,
    text: String,
}

/// A change of a field, an object or an entry, with the spelling that the text gets.
#[derive(Debug, Deserialize)]
#[serde(tag = "change", rename_all = "kebab-case", deny_unknown_fields)]
pub(crate) enum FieldChange {
    /// Sets a field.
    Set { at: String, value: String },
    /// Removes a field, an object or an entry.
    Remove { at: String },
    /// Adds an entry with its fields.
    Add { at: String, fields: Vec<(String, String)> },
}

/// What a page shows of a document beside its objects.
#[derive(Debug, Serialize)]
pub(crate) struct DocumentState<'a> {
    pub(crate) name: &'a str,
    /// `device` or `network`.
    pub(crate) kind: &'static str,
    pub(crate) format: &'static str,
    pub(crate) encoding: &'static str,
    pub(crate) text: &'a str,
    pub(crate) is_read_only: bool,
    pub(crate) is_changed: bool,
    pub(crate) can_undo: bool,
    pub(crate) can_redo: bool,
    /// The number of this text.
    pub(crate) revision: usize,
    /// How many devices the file has; the first is shown.
    pub(crate) devices: usize,
}

impl EditedDocument {
    pub(crate) fn open(name: &str, bytes: Vec<u8>) -> Result<Self, BadRequest> {
        let original = bytes.clone();
        let content = DocumentContent::Description(Box::new(read(name, bytes, None)?));
        Ok(Self::unchanged(content, original))
    }

    pub(crate) fn network(name: &str, bytes: Vec<u8>) -> Result<Self, BadRequest> {
        let content = DocumentContent::Network(source(name, bytes.clone())?);
        Ok(Self::unchanged(content, bytes))
    }

    fn unchanged(content: DocumentContent, original: Vec<u8>) -> Self {
        Self { content, original, before: Vec::new(), after: Vec::new(), revision: 0 }
    }

    pub(crate) fn description(&self) -> Result<&Description, BadRequest> {
        match &self.content {
            DocumentContent::Description(description) => Ok(description),
            DocumentContent::Network(source) => {
                let message = format!("`{}` is a network, not a device", source.name());
                Err(BadRequest::new(message).help("show the description of one of its nodes"))
            }
        }
    }

    pub(crate) fn device(&self) -> Result<&Device, BadRequest> {
        Ok(self.description()?.device())
    }

    pub(crate) fn is_network(&self) -> bool {
        matches!(self.content, DocumentContent::Network(_))
    }

    pub(crate) fn source(&self) -> &SourceFile {
        match &self.content {
            DocumentContent::Description(description) => description.source(),
            DocumentContent::Network(source) => source,
        }
    }

    pub(crate) fn name(&self) -> &str {
        self.source().name()
    }

    pub(crate) fn state(&self) -> DocumentState<'_> {
        let source = self.source();
        let (kind, format, is_project, devices) = match &self.content {
            DocumentContent::Description(description) => {
                ("device", description.format().name(), description.is_project(), description.device_count())
            }
            DocumentContent::Network(_) => ("network", "network", false, 0),
        };
        DocumentState {
            name: source.name(),
            kind,
            format,
            encoding: source.encoding().name(),
            text: source.text(),
            is_read_only: source.is_read_only() || is_project,
            is_changed: self.bytes() != self.original,
            can_undo: !self.before.is_empty(),
            can_redo: !self.after.is_empty(),
            revision: self.revision,
            devices,
        }
    }

    /// The text that it was opened with.
    pub(crate) fn original_text(&self) -> Result<String, BadRequest> {
        let reading = Reading::default();
        let original = reading.source(self.name(), self.original.clone()).map_err(BadRequest::new)?;
        Ok(original.text().to_owned())
    }

    /// The bytes of the file as it is now.
    pub(crate) fn bytes(&self) -> Vec<u8> {
        match &self.content {
            DocumentContent::Description(description) => description.print(),
            DocumentContent::Network(source) => source.to_bytes(),
        }
    }

    /// The document of `objdict check --format json`. Which fixes are `offered` takes some more checks of the text; without them, no
    /// finding has one. Findings of one cause are joined unless `is_by_place`.
    pub(crate) fn report(
        &self,
        offered: bool,
        is_by_place: bool,
        options: &Options,
    ) -> Result<String, BadRequest> {
        let description = self.description()?;
        let examine = |description: &Description| {
            let findings = objdict::check_with(description, options);
            match offered {
                true => objdict::with_sound_fixes(description, findings, |trial| {
                    objdict::check_unordered(trial, options)
                }),
                false => without_fixes(findings),
            }
        };
        let found = objdict::workspace::of_devices(description, examine);
        report(|report| {
            let mut found = found.into_iter();
            let each = description.map_devices(|device| {
                let findings = found.next().unwrap_or_default();
                let shown = if is_by_place { by_place } else { grouped };
                report.file(device.into(), &shown(device, findings))
            });
            each.into_iter().collect()
        })
    }

    /// Makes edits of the text that has this revision.
    pub(crate) fn edit(&mut self, revision: usize, edits: Vec<TextEdit>) -> Result<(), BadRequest> {
        if revision != self.revision {
            return Err(BadRequest::new("the text was changed meanwhile").help("type it again"));
        }
        let source = self.source();
        let mut made = Edits::new(source);
        for edit in edits {
            let start = offset(source, edit.line, edit.column)?;
            let end = offset(source, edit.end_line, edit.end_column)?;
            made.replace(Span { start: start.min(end), end: end.max(start) }, edit.text);
        }
        let bytes = made.to_bytes().map_err(BadRequest::new)?;
        self.replace(bytes)
    }

    /// Writes the text in another encoding.
    pub(crate) fn encode(&mut self, name: &str) -> Result<(), BadRequest> {
        let encoding: Encoding = name.parse().map_err(BadRequest::new)?;
        let bytes = encoding.encode(self.source().text()).map_err(BadRequest::new)?;
        self.replace(bytes)
    }

    /// Makes changes of fields and entries together, as edits of the text.
    pub(crate) fn change(&mut self, changes: &[FieldChange]) -> Result<(), BadRequest> {
        let changes: Vec<Change> =
            changes.iter().map(|change| self.as_change(change)).collect::<Result<_, _>>()?;
        let description = self.description()?;
        let changes: Vec<Change> =
            changes.into_iter().filter(|change| !is_made(description, change)).collect();
        if changes.is_empty() {
            return Ok(());
        }
        let fix = Fix { changes, ..Fix::risky("edit") };
        let made = description.edits(&fix).ok_or_else(|| {
            BadRequest::new("edits cannot change this in the file")
                .help("edit the text, or save the description in another format first")
        })?;
        let mut edits = Edits::new(description.source());
        made.into_iter().for_each(|(span, text)| edits.replace(span, text));
        let bytes = edits.to_bytes().map_err(BadRequest::new)?;
        self.replace(bytes)
    }

    fn as_change(&self, change: &FieldChange) -> Result<Change, BadRequest> {
        let place_of = |at: &str| {
            place(at).ok_or_else(|| BadRequest::new(format_args!("`{at}` is not edited as fields")))
        };
        Ok(match change {
            FieldChange::Set { at, value } => Change::Set(place_of(at)?, value.clone()),
            FieldChange::Remove { at } => Change::Remove(place_of(at)?),
            FieldChange::Add { at, fields } => {
                let fields = fields.iter().map(|(name, value)| (Field::from_name(name), value.clone()));
                Change::Add(place_of(at)?.part, fields.collect())
            }
        })
    }

    /// Makes a patch, which is how objects and entries are added, removed and moved.
    pub(crate) fn patch(&mut self, text: &str) -> Result<(), BadRequest> {
        let patch = Arc::new(Patch::read(SourceFile::from_text("patch.toml", text)));
        let patched = patch::apply(self.again()?, &[patch]);
        let made = patched.patched().ok_or_else(|| BadRequest::new("the patch is not for this device"))?;
        let problems: Vec<String> = match made.has_errors() {
            true => made
                .by_patch()
                .flat_map(|(_, findings)| findings.iter())
                .map(|it| it.message.to_string())
                .collect(),
            false => Vec::new(),
        };
        if let Some(first) = problems.into_iter().next() {
            return Err(BadRequest::new(first));
        }
        let realised = patched.realised().map_err(BadRequest::new)?;
        let bytes = realised.map_or_else(|| self.bytes(), |realised| realised.print());
        self.replace(bytes)
    }

    /// Makes all fixes of a safety, as `objdict check --fix` does.
    pub(crate) fn fix_all(&mut self, safety: Applicability, options: &Options) -> Result<(), BadRequest> {
        let fixed = objdict::fix_for_readers(self.again()?, safety, options);
        let bytes = fixed.bytes();
        self.replace(bytes)
    }

    /// Adds objects of the profiles as these demand them.
    pub(crate) fn add_objects(&mut self, profile: u16, indexes: &[u16]) -> Result<(), BadRequest> {
        let device = self.device()?;
        if let Some(index) = indexes.iter().find(|index| device.objects.contains_key(index)) {
            return Err(BadRequest::new(format_args!("the device has {index:04X}h already")));
        }
        let mut complete = device.clone();
        objdict::scaffold::add_objects(&mut complete, profile, indexes);
        self.complete(&complete)
    }

    /// Adds objects that the device does not have.
    pub(crate) fn insert(&mut self, objects: Vec<(u16, Object)>) -> Result<(), BadRequest> {
        let mut complete = self.device()?.clone();
        for (index, object) in objects {
            if complete.objects.contains_key(&index) {
                return Err(BadRequest::new(format_args!("the device has {index:04X}h already")));
            }
            complete.objects.insert(index, object);
            complete.lists.add(index);
        }
        self.complete(&complete)
    }

    /// Adds the objects that a device has in addition.
    fn complete(&mut self, complete: &Device) -> Result<(), BadRequest> {
        let bytes = self.description()?.with_objects(complete);
        let bytes = bytes.ok_or_else(|| BadRequest::new("no objects can be added to this file"))?;
        self.replace(bytes)
    }

    pub(crate) fn undo(&mut self) -> Result<(), BadRequest> {
        let Some(step) = self.before.pop() else { return Ok(()) };
        let step = step.back();
        self.take(step.make(self.bytes()))?;
        self.after.push(step);
        Ok(())
    }

    pub(crate) fn redo(&mut self) -> Result<(), BadRequest> {
        let Some(step) = self.after.pop() else { return Ok(()) };
        let step = step.back();
        self.take(step.make(self.bytes()))?;
        self.before.push(step);
        Ok(())
    }

    /// Makes these the bytes of the file, which can be undone.
    pub(crate) fn replace(&mut self, bytes: Vec<u8>) -> Result<(), BadRequest> {
        let now = self.bytes();
        if bytes == now {
            return Ok(());
        }
        let step = UndoStep::between(&now, &bytes);
        self.take(bytes)?;
        self.after.clear();
        self.before.push(step);
        let kept =
            |steps: &[UndoStep]| steps.iter().map(|step| step.old.len() + step.new.len()).sum::<usize>();
        while self.before.len() > 1 && kept(&self.before) > MAX_HISTORY {
            self.before.remove(0);
        }
        Ok(())
    }

    fn take(&mut self, bytes: Vec<u8>) -> Result<(), BadRequest> {
        self.content = self.reread(bytes)?;
        self.revision += 1;
        Ok(())
    }

    /// Another text of this file: what is typed may look like another format for a moment.
    fn reread(&self, bytes: Vec<u8>) -> Result<DocumentContent, BadRequest> {
        Ok(match &self.content {
            DocumentContent::Network(_) => DocumentContent::Network(source(self.name(), bytes)?),
            DocumentContent::Description(description) => {
                let from = Some(description.format().into());
                DocumentContent::Description(Box::new(read(self.name(), bytes, from)?))
            }
        })
    }

    /// A description of its own, which can be changed.
    fn again(&self) -> Result<Description, BadRequest> {
        read(self.name(), self.bytes(), Some(self.description()?.format().into()))
    }
}

/// The text of a file.
pub(crate) fn source(name: &str, bytes: Vec<u8>) -> Result<SourceFile, BadRequest> {
    SourceFile::from_bytes(name, bytes, &SourceOptions::default()).map_err(BadRequest::new)
}

/// What is written into a report as JSON.
fn report(write: impl FnOnce(&mut Json<&mut Vec<u8>>) -> io::Result<()>) -> Result<String, BadRequest> {
    let mut out = Vec::new();
    let mut report = Json::new(&mut out);
    write(&mut report).map_err(BadRequest::new)?;
    report.finish().map_err(BadRequest::new)?;
    drop(report);
    String::from_utf8(out).map_err(BadRequest::new)
}

/// The document of `objdict network check --format json`.
pub(crate) fn network_report(network: &NetworkFile) -> Result<String, BadRequest> {
    report(|report| {
        let subjects = Subject::of_network(network, network.check());
        subjects.into_iter().try_for_each(|(subject, found)| report.file(subject, &grouped(subject, found)))
    })
}

/// The findings in a text that is not a description, as the same document.
pub(crate) fn text_report(text: &SourceFile, findings: Findings) -> Result<String, BadRequest> {
    report(|report| report.file(text.into(), &grouped(text, findings)))
}

/// Whether the text says it already.
fn is_made(description: &Description, change: &Change) -> bool {
    match change {
        Change::Set(place, value) => {
            let span = description.locate(place);
            span.is_some_and(|span| span.of(description.source().text()) == value)
        }
        _ => false,
    }
}

/// The description in the bytes of a file; `from` is its format where that is known.
fn read(name: &str, bytes: Vec<u8>, from: Option<FileKind>) -> Result<Description, BadRequest> {
    match (Reading { from, judge: None, ..Reading::default() }).read(name, bytes)? {
        (_, Input::Description(description)) => Ok(*description),
        (kind, _) => {
            let message =
                format!("`{name}` is read as {}, and the workbench edits descriptions", kind.name());
            Err(BadRequest::new(message).help("open an EDS, DCF, XDD, XDC or device.toml"))
        }
    }
}

fn without_fixes(findings: Findings) -> Findings {
    findings.rearrange(|mut kept| {
        kept.iter_mut().for_each(|finding| finding.fix = None);
        kept
    })
}

/// The offset of a line and column.
fn offset(source: &SourceFile, line: usize, column: usize) -> Result<u32, BadRequest> {
    let text = source.text();
    let outside = || BadRequest::new(format_args!("the text has no line {line}, column {column}"));
    let number =
        line.checked_sub(1).filter(|line| *line < source.lines().line_count()).ok_or_else(outside)?;
    let start = source.lines().line_span(text, number).start;
    let rest = text.get(start as usize..).ok_or_else(outside)?;
    let before = column.checked_sub(1).ok_or_else(outside)?;
    let length: usize = rest.chars().take(before).map(char::len_utf8).sum();
    u32::try_from(start as usize + length).map_err(|_| outside())
}
