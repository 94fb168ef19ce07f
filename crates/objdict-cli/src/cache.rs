//! Files that had no findings: a check with the same settings does not look at them again.

use std::collections::HashSet;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use super::args::CheckArgs;
use super::ending::note;
use super::settings::CommandSettings;
use super::written_files::save;
use hmac_sha256::Hash;
use objdict_model::source::{SourceError, read_text, shown};

/// The first line of a cache.
const HEAD: &str = "objdict cache 2";

/// What the first lines of all versions begin with.
const CACHE: &str = "objdict cache ";

/// The largest cache that is read, in bytes: half a million files.
const MAX_SIZE: u64 = 32 << 20;

/// What is known of earlier checks. A file is known by the hash of its name, its contents and everything else that decides what is
/// found in it.
pub(super) struct Cache {
    path: PathBuf,
    /// The hash of everything but the file.
    settings: Hash,
    known: HashSet<String>,
}

/// Adds bytes that no others are mistaken for.
fn add(hash: &mut Hash, bytes: &[u8]) {
    hash.update((bytes.len() as u64).to_le_bytes());
    hash.update(bytes);
}

impl Cache {
    /// The cache at `path`, for a check with these arguments and the contents of their files. If it cannot be used, the check
    /// is only slower, so a note gives the reason; a file that is not a cache is not changed.
    pub(super) fn open(path: &Path, args: &CheckArgs, settings: &CommandSettings) -> Option<Self> {
        let text = match read_text(path, MAX_SIZE) {
            Ok(text) => text,
            Err(SourceError::Io { error, .. }) if error.kind() == std::io::ErrorKind::NotFound => {
                HEAD.to_owned()
            }
            Err(error) => {
                note(&format!("note: {error}, so every file is checked\n"));
                return None;
            }
        };
        let mut lines = text.lines();
        let head = lines.next().unwrap_or_default();
        if !head.starts_with(CACHE) {
            note(&format!(
                "note: `{}` is not an objdict cache, so every file is checked\n  help: remove it, or name a file that does not exist yet\n",
                shown(path)
            ));
            return None;
        }
        let mut hash = Hash::new();
        add(&mut hash, env!("CARGO_PKG_VERSION").as_bytes());
        add(&mut hash, format!("{:?} {:?} {:?}", args.settings, args.input, args.fixing).as_bytes());
        add(&mut hash, settings.contents().as_bytes());
        // a line that is corrupted is the hash of no file, and the file is checked
        let known = lines.filter(|_| head == HEAD).map(str::to_owned).collect();
        Some(Self { path: path.to_owned(), settings: hash, known })
    }

    /// What a file with these contents is known by, and whether nothing was found in it.
    pub(super) fn look_up(&self, path: &Path, bytes: &[u8]) -> (String, bool) {
        let mut hash = self.settings;
        add(&mut hash, path.as_os_str().as_encoded_bytes());
        add(&mut hash, bytes);
        let mut key = String::with_capacity(64);
        for byte in hash.finalize() {
            let _ = write!(key, "{byte:02x}");
        }
        let is_known = self.known.contains(&key);
        (key, is_known)
    }

    /// Replaces the known files by `clean`, the files without findings of this run. If that fails, a note gives the reason.
    pub(super) fn save(&self, mut clean: Vec<String>) {
        clean.sort_unstable();
        clean.dedup();
        let mut text = format!("{HEAD}\n");
        for key in clean {
            let _ = writeln!(text, "{key}");
        }
        if let Err(failure) = save(&self.path, text.as_bytes()) {
            note(&format!("note: {}, so the next check will be as slow\n", failure.message));
        }
    }
}
