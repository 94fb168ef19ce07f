//! The list of the files that objdict wrote into a folder. It has the format of `sha256sum`, which can also check it; a
//! comment before files names the program that wrote them.
//!
//! A file is listed before it is written, so a killed run leaves no file that the next run does not recognise.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::{self, Write as _};
use std::fs::{File, OpenOptions};
use std::io::{self, ErrorKind, Write as _};
use std::path::Path;

use super::names::require_portable;
use objdict_model::source::{SourceError, read};

/// The name of the list.
pub(super) const NAME: &str = "objdict.sha256";

/// Its first line.
const HEAD: &str =
    "# Files that objdict wrote here. Check them with `objdict network verify` or `sha256sum -c`.\n";

/// The maximum size of a list in bytes.
const MAX_SIZE: u64 = 16 << 20;

/// A SHA-256.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Hash([u8; 32]);

impl Hash {
    /// The hash of these bytes.
    pub fn of(bytes: &[u8]) -> Self {
        Self(hmac_sha256::Hash::hash(bytes))
    }

    fn parse(digits: &str) -> Option<Self> {
        if digits.len() != 64 || !digits.bytes().all(|digit| digit.is_ascii_hexdigit()) {
            return None;
        }
        let mut hash = [0; 32];
        for (byte, pair) in hash.iter_mut().zip(digits.as_bytes().chunks_exact(2)) {
            *byte = u8::from_str_radix(std::str::from_utf8(pair).ok()?, 16).ok()?;
        }
        Some(Self(hash))
    }
}

impl fmt::Display for Hash {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|byte| write!(f, "{byte:02x}"))
    }
}

impl fmt::Debug for Hash {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

/// The record of a file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct FileRecord {
    /// Its possible contents: several during a replacement, and after an interrupted one.
    pub(super) hashes: BTreeSet<Hash>,
    /// The program that wrote it.
    pub(super) origin: String,
}

/// The current state of a listed file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileState {
    /// As it was written.
    Same,
    /// The content differs.
    Changed,
    /// Not there.
    Missing,
    /// As written, or as it was to be written before an interruption.
    Interrupted,
}

/// The files that objdict wrote into a folder, by name.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Manifest {
    pub(super) files: BTreeMap<String, FileRecord>,
}

impl Manifest {
    /// Its name in the folder.
    pub const NAME: &str = NAME;

    /// The list of a folder; `None` if there is none.
    ///
    /// # Errors
    /// If it cannot be read, or is a different file with this name.
    pub fn open(folder: &Path) -> io::Result<Option<Self>> {
        let bytes = match read(&folder.join(NAME), MAX_SIZE) {
            Ok(bytes) => bytes,
            Err(SourceError::Io { error, .. })
                if matches!(error.kind(), ErrorKind::NotFound | ErrorKind::NotADirectory) =>
            {
                return Ok(None);
            }
            Err(SourceError::Io { error, .. }) => return Err(error),
            Err(error) => return Err(io::Error::other(error.to_string())),
        };
        let text = String::from_utf8_lossy(&bytes);
        // a checkout of git may end lines with CR LF
        match text.lines().next() {
            None => Ok(None),
            Some(line) if line == HEAD.trim_end() => Ok(Some(Self::parse(&text))),
            Some(_) => Err(io::Error::other("objdict did not write this list")),
        }
    }

    /// An unterminated last line was truncated, and is skipped.
    fn parse(text: &str) -> Self {
        let text = text.rfind('\n').map_or("", |end| &text[..=end]);
        let mut files: BTreeMap<String, FileRecord> = BTreeMap::new();
        let mut origin = "";
        for line in text.lines().skip(1) {
            if let Some(heading) = line.strip_prefix("# ") {
                origin = heading;
            }
            // objdict never writes a name outside the folder
            let file = file_of(line).filter(|(_, name)| require_portable(name).is_ok());
            let Some((hash, name)) = file else { continue };
            let record = files.entry(name).or_default();
            record.hashes.insert(hash);
            record.origin = origin.to_owned();
        }
        Self { files }
    }

    /// The list as text, grouped by program and sorted by name.
    pub(super) fn text(&self) -> String {
        let mut by_origin: BTreeMap<&str, String> = BTreeMap::new();
        for (name, record) in &self.files {
            let text = by_origin.entry(&record.origin).or_default();
            record.hashes.iter().for_each(|hash| text.push_str(&line(name, *hash)));
        }
        let mut text = HEAD.to_owned();
        for (origin, files) in by_origin {
            let _ = write!(text, "# {origin}\n{files}"); // writing to a string does not fail
        }
        text
    }

    /// Records a completely written file.
    pub(super) fn set(&mut self, name: &str, hash: Hash, origin: &str) {
        let record = FileRecord { hashes: BTreeSet::from([hash]), origin: origin.to_owned() };
        self.files.insert(name.to_owned(), record);
    }

    /// Whether objdict wrote a file of this name and content.
    pub(super) fn has(&self, name: &str, contents: &[u8]) -> bool {
        self.files.get(name).is_some_and(|record| record.hashes.contains(&Hash::of(contents)))
    }

    /// Whether a file is in the list, or is the list.
    pub fn lists(&self, name: &str) -> bool {
        name == NAME || self.files.contains_key(name)
    }

    /// The files with their current states, by name.
    pub fn verify(&self, folder: &Path) -> impl Iterator<Item = (&str, io::Result<FileState>)> {
        self.files.iter().map(move |(name, record)| (name.as_str(), record.state(&folder.join(name))))
    }
}

impl FileRecord {
    fn state(&self, path: &Path) -> io::Result<FileState> {
        let bytes = match std::fs::read(path) {
            Ok(bytes) => bytes,
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(FileState::Missing),
            Err(error) => return Err(error),
        };
        Ok(match self.hashes.contains(&Hash::of(&bytes)) {
            false => FileState::Changed,
            true if self.hashes.len() > 1 => FileState::Interrupted,
            true => FileState::Same,
        })
    }
}

/// Files that are about to be written, so that they are known if the run ends before the list is written.
#[derive(Debug)]
pub(super) struct WriteLog(File);

impl WriteLog {
    /// Opens the list of a folder for appending, or creates it.
    pub(super) fn open(folder: &Path, origin: &str) -> io::Result<Self> {
        std::fs::create_dir_all(folder)?;
        let mut file = OpenOptions::new().create(true).append(true).open(folder.join(NAME))?;
        let head = if file.metadata()?.len() == 0 { HEAD } else { "" };
        file.write_all(format!("{head}# {origin}\n").as_bytes())?;
        Ok(Self(file))
    }

    pub(super) fn add(&mut self, name: &str, hash: Hash) -> io::Result<()> {
        self.0.write_all(line(name, hash).as_bytes())
    }
}

/// A line of `sha256sum`; names in folders have no character that it escapes.
fn line(name: &str, hash: Hash) -> String {
    format!("{hash}  {name}\n")
}

fn file_of(line: &str) -> Option<(Hash, String)> {
    let (digits, name) = line.split_once("  ")?;
    Some((Hash::parse(digits)?, name.to_owned()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_reads_back() {
        let mut manifest = Manifest::default();
        manifest.set("left.dcf", Hash::of(b"abc"), "network build --target dcf");
        manifest.set("a b.eds", Hash::of(b""), "convert");
        manifest.files.get_mut("left.dcf").unwrap().hashes.insert(Hash::of(b"new"));
        let text = manifest.text();
        assert!(text.contains(
            "# convert\ne3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855  a b.eds\n"
        ));
        assert!(
            text.contains("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad  left.dcf\n")
        );
        assert_eq!(Manifest::parse(&text), manifest);
        let cut = &text[..text.len() - 5];
        assert_eq!(Manifest::parse(cut).files["left.dcf"].hashes.len(), 1);
    }
}
