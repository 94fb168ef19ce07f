//! The files of an editor: its buffers in front of the disk, and what was found in each of them.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::rc::Rc;

use lsp_types::Uri;

use super::analysis::{Analysis, analyse};
use super::file::File;
use super::position::ColumnUnit;
use super::uri::{of_path, path_of};
use crate::config::{Config, Project};
use crate::source::{self, Buffers, Encoding, SourceFile, SourceOptions, absolute};

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

type Texts = Rc<RefCell<BTreeMap<PathBuf, Buffer>>>;

/// The buffers, which write down which files a reader asks for.
struct Recorder {
    texts: Texts,
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

/// The open files, and what is known of them.
#[derive(Default)]
pub(super) struct Workspace {
    texts: Texts,
    /// The folders that are open in the editor.
    pub(super) folders: Vec<PathBuf>,
    pub(super) unit: ColumnUnit,
    /// Whether the editor expands snippets: texts with places to fill in.
    pub(super) has_snippets: bool,
    analyses: BTreeMap<PathBuf, Derived<Analysis>>,
    /// The configurations by the folders that they hold in.
    projects: BTreeMap<PathBuf, Derived<Option<Project>>>,
}

impl Workspace {
    /// Takes a text that was opened.
    pub(super) fn open(&mut self, uri: Uri, version: i32, text: String) {
        let Some(path) = path_of(&uri) else { return };
        let encoding = encoding_of(&path, &text);
        self.texts.borrow_mut().insert(path.clone(), Buffer { uri, version, text, encoding });
        self.forget(&path);
    }

    /// Takes a new text of an open file.
    pub(super) fn change(&mut self, uri: &Uri, version: i32, text: String) {
        let Some(path) = path_of(uri) else { return };
        if let Some(buffer) = self.texts.borrow_mut().get_mut(&path) {
            (buffer.version, buffer.text) = (version, text);
        }
        self.forget(&path);
    }

    pub(super) fn close(&mut self, uri: &Uri) {
        let Some(path) = path_of(uri) else { return };
        self.texts.borrow_mut().remove(&path);
        self.forget(&path);
        self.analyses.remove(&path);
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
        let (analysis, mut files) = self.recorded(|| {
            let bytes = source::read(path, source::DEFAULT_MAX_SIZE).ok()?;
            let encoding = self.texts.borrow().get(path).and_then(|buffer| buffer.encoding);
            Some(Rc::new(analyse(path, bytes, encoding, (*project.0).as_ref())))
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
    pub(super) fn file(&mut self, uri: &Uri) -> Option<File> {
        let analysis = self.analysis(&path_of(uri)?)?;
        Some(File { analysis, uri: uri.clone(), unit: self.unit })
    }

    /// The descriptions in the open folders, and the others that are open.
    pub(super) fn descriptions(&mut self) -> Vec<File> {
        let mut paths: BTreeSet<PathBuf> = self.texts.borrow().keys().cloned().collect();
        self.folders.iter().for_each(|folder| add_descriptions(folder, 0, &mut paths));
        let uris = paths.iter().filter_map(|path| of_path(path));
        let mut files = Vec::new();
        for uri in uris {
            files.extend(self.file(&uri).filter(|file| file.description().is_some()));
        }
        files
    }

    /// The configuration that holds for a file, and the files that it depends on.
    fn project(&mut self, path: &Path) -> (Rc<Option<Project>>, BTreeSet<PathBuf>) {
        let folder = path.parent().map(absolute).unwrap_or_default();
        if !self.projects.contains_key(&folder) {
            let (project, files) =
                self.recorded(|| Config::find(&folder).and_then(|path| Project::open(&path).ok()));
            self.projects.insert(folder.clone(), Derived { value: Rc::new(project), files });
        }
        let known = &self.projects[&folder];
        (Rc::clone(&known.value), known.files.clone())
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

/// So deep folders are searched for descriptions, and so many of them are found.
const MAX_DEPTH: usize = 8;
const MAX_FOUND: usize = 1000;

/// Adds the descriptions below a folder.
fn add_descriptions(folder: &Path, depth: usize, paths: &mut BTreeSet<PathBuf>) {
    let entries = std::fs::read_dir(folder).into_iter().flatten().filter_map(Result::ok);
    for entry in entries {
        let (path, kind) = (entry.path(), entry.file_type());
        let is_hidden = entry.file_name().to_string_lossy().starts_with('.');
        if is_hidden || paths.len() >= MAX_FOUND {
            continue;
        }
        match kind {
            Ok(kind) if kind.is_dir() && depth < MAX_DEPTH => add_descriptions(&path, depth + 1, paths),
            Ok(kind) if kind.is_file() && is_description(&path) => {
                paths.insert(path);
            }
            _ => {}
        }
    }
}

fn is_description(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
    let ending = name.rsplit('.').next().unwrap_or_default();
    matches!(ending, "eds" | "dcf" | "xdd" | "xdc") || name.ends_with("device.toml")
}
