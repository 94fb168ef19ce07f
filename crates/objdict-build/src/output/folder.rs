//! A folder into which files are written, next to foreign ones.

use std::collections::{BTreeMap, HashSet};
use std::io;
use std::path::{Path, PathBuf};

use super::error::OutputError;
use super::manifest::{Hash, Manifest, NAME, WriteLog};
use super::names::require_portable;
use super::save::{NewFile, Prepared, Saved, prepare, put};
use super::used::Used;
use objdict_model::source::read;

/// The mark in a comment in the first lines of generated files.
const MARK: &[u8] = b"Made by objdict ";

/// The number of lines at the start of a file that may contain the mark.
const HEAD_LINES: usize = 3;

/// An output folder. A run replaces only files of objdict: those with the mark in their first lines, or those in the
/// folder's list if they are unchanged. Files without a mark are added to the list.
#[derive(Debug)]
pub struct OutputFolder {
    pub(super) path: PathBuf,
    /// The program that writes the files, for the list.
    pub(super) origin: String,
    /// Whether files of others are replaced too.
    pub(super) overwrite: bool,
    pub(super) manifest: Manifest,
    /// The files of this run that are in the list.
    listed: BTreeMap<String, Hash>,
    /// The files of this run: their contents and, until all are put in place, their temporary locations.
    new: Vec<NewFile>,
    saved: Vec<PathBuf>,
    /// The names that this run has written to, compared like on systems that ignore case.
    pub(super) taken: HashSet<String>,
}

/// The file at an output path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FoundFile {
    /// None, or one that may be replaced.
    Replaceable,
    /// A file with the contents.
    Same,
}

impl OutputFolder {
    /// The folder at `path`, which need not exist; `origin` is the program that writes the files.
    ///
    /// # Errors
    /// If its list cannot be read.
    pub fn open(path: &Path, origin: &str, overwrite: bool) -> Result<Self, OutputError> {
        let manifest = Manifest::open(path).map_err(OutputError::unwritable(path.join(NAME)))?;
        Ok(Self {
            path: path.to_owned(),
            origin: origin.to_owned(),
            overwrite,
            manifest: manifest.unwrap_or_default(),
            listed: BTreeMap::new(),
            new: Vec::new(),
            saved: Vec::new(),
            taken: HashSet::new(),
        })
    }

    /// Rejects a file that must not be written; `name` has `/` between folder and file.
    ///
    /// # Errors
    /// If the name is not valid, the run uses the file, or another program wrote or changed it.
    pub fn admit(&self, name: &str, contents: &[u8], used: &Used) -> Result<(), OutputError> {
        self.find(name, contents, used).map(|_| ())
    }

    /// The path of a file in the folder.
    pub fn join(&self, name: &str) -> PathBuf {
        let mut path = self.path.clone();
        path.extend(name.split('/'));
        path
    }

    pub(super) fn find(&self, name: &str, contents: &[u8], used: &Used) -> Result<FoundFile, OutputError> {
        require_portable(name)?;
        let path = self.join(name);
        if name.eq_ignore_ascii_case(NAME) || self.taken.contains(&name.to_lowercase()) {
            return Err(OutputError::InUse { path });
        }
        used.require_other(&path)?;
        let former = match read(&path, u64::MAX) {
            Ok(former) => former,
            Err(_) if path.is_file() && !self.overwrite => return Err(OutputError::Foreign { path }),
            // missing, or not a regular file; the system reports whether it can be written
            Err(_) => return Ok(FoundFile::Replaceable),
        };
        let is_marked = former.split(|&byte| byte == b'\n').take(HEAD_LINES).any(is_mark);
        match () {
            () if former == contents => Ok(FoundFile::Same),
            () if self.overwrite || former.is_empty() || is_marked => Ok(FoundFile::Replaceable),
            () if self.manifest.has(name, &former) => Ok(FoundFile::Replaceable),
            () if self.manifest.files.contains_key(name) => Err(OutputError::Changed { path }),
            () => Err(OutputError::Foreign { path }),
        }
    }

    /// Saves a file to the folder; all files are put in place by [`finish`](Self::finish).
    ///
    /// # Errors
    /// Like [`admit`](Self::admit), and if the contents cannot be written.
    pub fn save(&mut self, name: &str, contents: &[u8], used: &mut Used) -> Result<Saved, OutputError> {
        let found = self.find(name, contents, used)?;
        let path = self.join(name);
        let is_marked = contents.split(|&byte| byte == b'\n').take(HEAD_LINES).any(is_mark);
        let is_listed = found == FoundFile::Same && self.manifest.has(name, contents);
        if !is_marked && !is_listed {
            self.listed.insert(name.to_owned(), Hash::of(contents));
        }
        self.taken.insert(name.to_lowercase());
        let prepared = match found {
            FoundFile::Same => Prepared::Done(Saved::Unchanged),
            FoundFile::Replaceable => prepare(&path, contents).map_err(OutputError::unwritable(&path))?,
        };
        used.add(&path);
        self.saved.push(path);
        Ok(match prepared {
            Prepared::Done(saved) => saved,
            Prepared::New(file) => {
                self.new.push(file);
                Saved::Written
            }
        })
    }

    /// Puts all files in place, or none, with the list if it contains new or changed files.
    ///
    /// # Errors
    /// If one of them cannot be written.
    pub fn finish(mut self, used: &mut Used) -> Result<(), OutputError> {
        self.put_all().map_err(OutputError::unwritable(&self.path))?;
        self.saved.iter().for_each(|path| used.add(path));
        Ok(())
    }

    fn put_all(&mut self) -> io::Result<()> {
        let new = std::mem::take(&mut self.new);
        let mut list = Vec::new();
        if !self.listed.is_empty() {
            // another run may have written to the folder
            let mut manifest = Manifest::open(&self.path)?.unwrap_or_default();
            self.listed.iter().for_each(|(name, hash)| manifest.set(name, *hash, &self.origin));
            if let Prepared::New(file) = prepare(&self.path.join(NAME), manifest.text().as_bytes())? {
                // a killed run leaves no file that the next run does not recognise
                let mut log = WriteLog::open(&self.path, &self.origin)?;
                self.listed.iter().try_for_each(|(name, hash)| log.add(name, *hash))?;
                list.push(file);
            }
        }
        put(new)?;
        put(list)
    }
}

fn is_mark(line: &[u8]) -> bool {
    memchr::memmem::find(line, MARK).is_some()
}
