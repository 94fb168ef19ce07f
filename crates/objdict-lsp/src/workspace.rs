//! The files of an editor: its buffers in front of the disk, and what was found in each of them.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::rc::Rc;
use std::sync::Arc;

use lsp_server::Request;

use super::analysis::{Analysis, analyse};
use super::baseline;
use super::file::CheckedFile;
use super::mentions::mentions_of;
use super::position::{ColumnUnit, apply};
use super::protocol::{ContentChange, Uri};
use super::uri::{of_path, path_of};
use objdict_format::mention::Mention;
use objdict_model::source;
use objdict_model::source::{Buffers, Encoding, SourceFile, SourceOptions, absolute};
use objdict_network_file::may_be_network;
use objdict_project::config::Project;
use objdict_project::workspace;

/// A text that is open in the editor.
#[derive(Debug)]
struct Buffer {
    uri: Uri,
    version: i32,
    text: String,
    /// The encoding of the file, if it is not UTF-8.
    encoding: Option<Encoding>,
}

impl Buffer {
    fn bytes(&self) -> Vec<u8> {
        let encoded = self.encoding.and_then(|encoding| encoding.encode(&self.text).ok());
        encoded.unwrap_or_else(|| self.text.clone().into_bytes())
    }
}

type OpenTexts = Rc<RefCell<BTreeMap<PathBuf, Buffer>>>;

/// The buffers, which write down which files a reader asks for.
struct Recorder {
    texts: OpenTexts,
    asked: RefCell<BTreeSet<PathBuf>>,
}

impl Buffers for Recorder {
    fn bytes(&self, path: &Path) -> Option<Vec<u8>> {
        self.asked.borrow_mut().insert(path.to_owned());
        self.texts.borrow().get(path).map(Buffer::bytes)
    }
}

/// Something with the files that it depends on.
struct Derived<T> {
    value: Rc<T>,
    files: BTreeSet<PathBuf>,
}

/// What an editor can do beyond showing answers.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct ClientFeatures {
    /// Whether an edit may create files.
    pub(super) creates_files: bool,
    /// Whether it shows a file in the browser.
    pub(super) shows_documents: bool,
    /// Whether it expands snippets: texts with places to fill in.
    pub(super) expands_snippets: bool,
}

/// The open files, and what is known of them.
#[derive(Default)]
pub(super) struct EditorWorkspace {
    texts: OpenTexts,
    /// The folders that are open in the editor.
    pub(super) folders: Vec<PathBuf>,
    pub(super) unit: ColumnUnit,
    pub(super) client: ClientFeatures,
    /// The file with the findings that are known, which the editor names.
    pub(super) baseline: Option<PathBuf>,
    /// The folder of the pages that were shown.
    pub(super) pages: Option<PathBuf>,
    /// What is asked of the client next.
    pub(super) requests: Vec<Request>,
    analyses: BTreeMap<PathBuf, Derived<Analysis>>,
    /// What was found in the open files before the edits since.
    before: BTreeMap<PathBuf, Rc<Analysis>>,
    /// The configurations by the folders that they hold in.
    projects: BTreeMap<PathBuf, Derived<Option<Arc<Project>>>>,
}

impl EditorWorkspace {
    /// Takes a text that was opened.
    pub(super) fn open(&mut self, uri: Uri, version: i32, text: String) {
        let Some(path) = path_of(&uri) else { return };
        let encoding = encoding_of(&path, &text);
        self.texts.borrow_mut().insert(path.clone(), Buffer { uri, version, text, encoding });
        self.forget(&path);
    }

    /// Whether a file is open with this text.
    pub(super) fn has(&self, uri: &str, text: &str) -> bool {
        path_of(uri)
            .is_some_and(|path| self.texts.borrow().get(&path).is_some_and(|buffer| buffer.text == text))
    }

    /// Makes changes of an open file, each in the text that the one before leaves.
    pub(super) fn change(&mut self, uri: &str, version: i32, changes: Vec<ContentChange>) {
        let Some(path) = path_of(uri) else { return };
        let known = self.analyses.remove(&path).map(|known| known.value);
        if let Some(buffer) = self.texts.borrow_mut().get_mut(&path) {
            let source = known.as_ref().map(|known| known.subject().source());
            let mut lines = source.filter(|source| source.text() == buffer.text).map(SourceFile::lines);
            buffer.version = version;
            changes.into_iter().for_each(|change| apply(&mut buffer.text, lines.take(), change, self.unit));
        }
        if let Some(known) = known {
            self.before.insert(path.clone(), known);
        }
        self.forget(&path);
    }

    pub(super) fn close(&mut self, uri: &str) {
        let Some(path) = path_of(uri) else { return };
        self.texts.borrow_mut().remove(&path);
        self.forget(&path);
        self.analyses.remove(&path);
        self.before.remove(&path);
    }

    /// Drops what depends on a file.
    pub(super) fn forget(&mut self, path: &Path) {
        self.analyses.retain(|_, known| !known.files.contains(path));
        self.projects.retain(|_, known| !known.files.contains(path));
    }

    /// Drops all that is known of the disk.
    pub(super) fn forget_all(&mut self) {
        self.analyses.clear();
        self.projects.clear();
    }

    /// The open files whose findings are not known, with their versions.
    pub(super) fn unknown(&self) -> Vec<(PathBuf, Uri, i32)> {
        let texts = self.texts.borrow();
        let unknown = texts.iter().filter(|(path, _)| !self.analyses.contains_key(*path));
        unknown.map(|(path, buffer)| (path.clone(), buffer.uri.clone(), buffer.version)).collect()
    }

    /// What is found in an open file, or in one of the disk.
    pub(super) fn analysis(&mut self, path: &Path) -> Option<Rc<Analysis>> {
        if let Some(known) = self.analyses.get(path) {
            return Some(Rc::clone(&known.value));
        }
        let project = self.project(path);
        let before = self.before.remove(path);
        let (analysis, mut files) = self.recorded(|| {
            let bytes = source::read(path, source::DEFAULT_MAX_SIZE).ok()?;
            let encoding = self.texts.borrow().get(path).and_then(|buffer| buffer.encoding);
            let mut analysis = analyse(path, bytes, encoding, project.0.clone(), before.as_deref());
            if let Some(baseline) = &self.baseline {
                baseline::sift(baseline, &mut analysis);
            }
            Some(Rc::new(analysis))
        });
        let analysis = analysis?;
        files.extend(project.1);
        files.insert(path.to_owned());
        // of the disk it is not kept: nothing says when it changes
        if self.texts.borrow().contains_key(path) {
            self.analyses.insert(path.to_owned(), Derived { value: Rc::clone(&analysis), files });
        }
        Some(analysis)
    }

    /// A file that a request is about.
    pub(super) fn file(&mut self, uri: &str) -> Option<CheckedFile> {
        let analysis = self.analysis(&path_of(uri)?)?;
        Some(CheckedFile { analysis, uri: uri.to_owned(), unit: self.unit })
    }

    /// The descriptions in the open folders, and the others that are open.
    pub(super) fn descriptions(&mut self) -> Vec<CheckedFile> {
        let files = self.files(is_description).into_iter();
        files.filter(|file| file.description().is_some()).collect()
    }

    /// The `network.toml` of a folder: the first file that is one.
    pub(super) fn network_in(&mut self, folder: &Path) -> Option<CheckedFile> {
        let mut paths: Vec<PathBuf> = self.texts.borrow().keys().cloned().collect();
        let entries = std::fs::read_dir(folder).into_iter().flatten().filter_map(Result::ok);
        paths.extend(entries.map(|entry| absolute(&entry.path())).take(MAX_FOUND));
        paths.retain(|path| {
            path.extension().is_some_and(|ending| ending == "toml")
                && path.parent() == Some(&absolute(folder))
        });
        paths.sort();
        let files = paths.iter().filter_map(|path| of_path(path)).filter_map(|uri| self.file(&uri));
        files.into_iter().find(|file| file.analysis.network().is_some())
    }

    /// The networks in the open folders, and the others that are open.
    fn networks(&mut self) -> Vec<CheckedFile> {
        let files = self.files(may_be_network).into_iter();
        files.filter(|file| file.analysis.network().is_some()).collect()
    }

    /// The files in the open folders whose names say that they may be wanted, and all that are open.
    fn files(&mut self, is_wanted: fn(&Path) -> bool) -> Vec<CheckedFile> {
        let mut paths: BTreeSet<PathBuf> = self.texts.borrow().keys().cloned().collect();
        self.folders.iter().for_each(|folder| add_files(folder, is_wanted, 0, &mut paths));
        paths.iter().filter_map(|path| of_path(path)).filter_map(|uri| self.file(&uri)).collect()
    }

    /// The files that name the objects of a description, with all that they name of it: first the description itself, then that of
    /// its type and those of nodes of this type, then networks.
    pub(super) fn naming(&mut self, path: &Path) -> Vec<(CheckedFile, Vec<Mention>)> {
        let path_of = |file: &CheckedFile| absolute(file.source().name().as_ref());
        let type_of = |file: &CheckedFile| {
            let origin = file.description().and_then(|description| description.origin());
            origin.map_or_else(|| path_of(file), |origin| absolute(origin.source().name().as_ref()))
        };
        let own = of_path(path).and_then(|uri| self.file(&uri));
        let Some(own) = own.filter(|file| file.description().is_some()) else { return Vec::new() };
        let of_type = type_of(&own);
        let mut files = self.descriptions();
        files.retain(|file| type_of(file) == of_type && path_of(file) != path);
        files.insert(0, own);
        let described: Vec<PathBuf> = files.iter().map(path_of).collect();
        files.extend(self.networks());
        let found = files.into_iter().map(|file| {
            let mentions = mentions_of(&file, &described);
            (file, mentions)
        });
        found.filter(|(_, mentions)| !mentions.is_empty()).collect()
    }

    /// The configuration that holds for a file, and the files that it depends on.
    fn project(&mut self, path: &Path) -> (Option<Arc<Project>>, BTreeSet<PathBuf>) {
        let folder = path.parent().map(absolute).unwrap_or_default();
        if !self.projects.contains_key(&folder) {
            // what cannot be opened is an error in the configuration's own analysis
            let find = || workspace::Workspace::default().project_of(path).ok().flatten();
            let (project, files) = self.recorded(find);
            self.projects.insert(folder.clone(), Derived { value: Rc::new(project), files });
        }
        let known = &self.projects[&folder];
        (Option::clone(&known.value), known.files.clone())
    }

    /// What a function makes of the buffers and the disk, and the files that it asked for.
    fn recorded<T>(&self, run: impl FnOnce() -> T) -> (T, BTreeSet<PathBuf>) {
        let recorder = Rc::new(Recorder { texts: Rc::clone(&self.texts), asked: RefCell::default() });
        let made = source::with_buffers(Rc::clone(&recorder) as Rc<dyn Buffers>, run);
        let files = recorder.asked.take();
        (made, files)
    }

    /// Runs a function that reads files, in front of which are the buffers.
    pub(super) fn reading<T>(&self, run: impl FnOnce() -> T) -> T {
        self.recorded(run).0
    }
}

/// The encoding of a file whose text an editor shows; `None` for UTF-8, or where the editor shows another text.
fn encoding_of(path: &Path, text: &str) -> Option<Encoding> {
    let bytes = source::read(path, source::DEFAULT_MAX_SIZE).ok()?;
    let source = SourceFile::from_bytes(path.display().to_string(), bytes, &SourceOptions::default()).ok()?;
    (source.text() == text && source.encoding() != Encoding::Utf8).then(|| source.encoding())
}

/// So deep folders are searched for files, and so many of them are found.
const MAX_DEPTH: usize = 8;
const MAX_FOUND: usize = 1000;

/// Adds the files below a folder.
fn add_files(folder: &Path, is_wanted: fn(&Path) -> bool, depth: usize, paths: &mut BTreeSet<PathBuf>) {
    let entries = std::fs::read_dir(folder).into_iter().flatten().filter_map(Result::ok);
    for entry in entries {
        let (path, kind) = (entry.path(), entry.file_type());
        let is_hidden = entry.file_name().to_string_lossy().starts_with('.');
        if is_hidden || paths.len() >= MAX_FOUND {
            continue;
        }
        match kind {
            Ok(kind) if kind.is_dir() && depth < MAX_DEPTH => add_files(&path, is_wanted, depth + 1, paths),
            Ok(kind) if kind.is_file() && is_wanted(&path) => {
                paths.insert(path);
            }
            _ => {}
        }
    }
}

pub(super) fn is_description(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
    let ending = name.rsplit('.').next().unwrap_or_default();
    matches!(ending, "eds" | "dcf" | "xdd" | "xdc") || name.ends_with("device.toml")
}

#[cfg(test)]
mod tests {
    use super::super::protocol::{Position, Range};
    use super::*;

    #[test]
    fn an_edit_is_read_and_checked_from_what_was_found_before() {
        let (uri, mut workspace) = ("file:///nowhere/a.eds", EditorWorkspace::default());
        let text: String = (0x2000..0x2010).map(|index| format!("[{index:X}]\nParameterName=a\n")).collect();
        workspace.open(uri.to_owned(), 0, text);
        let path = path_of(uri).unwrap();
        let before = workspace.analysis(&path).unwrap();
        assert_eq!(before.checked_objects(), 16);
        // also with another edit before the findings are asked for
        for line in [7, 9] {
            let place = Position::new(line, 14);
            let change = ContentChange { range: Some(Range::new(place, place)), text: "b".to_owned() };
            workspace.change(uri, 1, vec![change]);
        }
        let after = workspace.analysis(&path).unwrap();
        assert_eq!(after.checked_objects(), 2);
        let [before, after] = [&before, &after].map(|one| &one.description().unwrap().described().objects);
        assert_eq!(after.keys().filter(|index| !after.shares(before, index)).count(), 2);
    }
}
