//! The files of a run.

use std::collections::HashSet;
use std::path::Path;
#[cfg(not(any(unix, all(windows, feature = "command"))))]
use std::path::PathBuf;

use super::error::OutputError;
use super::names::require_file;
use super::save::{Saved, save};

/// The identity of a file, regardless of its name: its device and its number there, or its full path if files
/// have no numbers.
#[cfg(any(unix, all(windows, feature = "command")))]
type FileIdentity = (u64, u64);
#[cfg(not(any(unix, all(windows, feature = "command"))))]
type FileIdentity = PathBuf;

/// `None` for missing files, and for pipes and devices, because writing to them destroys nothing.
#[cfg(unix)]
fn identity(path: &Path) -> Option<FileIdentity> {
    use std::os::unix::fs::MetadataExt;
    path.metadata().ok().filter(std::fs::Metadata::is_file).map(|file| (file.dev(), file.ino()))
}

#[cfg(all(windows, feature = "command"))]
fn identity(path: &Path) -> Option<FileIdentity> {
    let file = path.is_file().then(|| super::save::information(path)).flatten()?;
    Some((file.volume_serial_number(), file.file_index()))
}

#[cfg(not(any(unix, all(windows, feature = "command"))))]
fn identity(path: &Path) -> Option<FileIdentity> {
    path.canonicalize().ok().filter(|path| path.is_file())
}

/// The files that a run reads or has written.
#[derive(Debug, Default)]
pub struct Used(HashSet<FileIdentity>);

impl Used {
    /// Notes that the run uses a file.
    pub fn add(&mut self, path: &Path) {
        self.0.extend(identity(path));
    }

    /// Rejects a file that the run already uses.
    pub fn require_other(&self, path: &Path) -> Result<(), OutputError> {
        match identity(path) {
            Some(identity) if self.0.contains(&identity) => Err(OutputError::InUse { path: path.to_owned() }),
            _ => Ok(()),
        }
    }

    /// Writes a file given as an argument: it replaces an existing one, but no file that the run uses.
    pub fn save(&mut self, path: &Path, contents: &[u8]) -> Result<Saved, OutputError> {
        require_file(path)?;
        self.require_other(path)?;
        let saved = save(path, contents).map_err(OutputError::unwritable(path))?;
        self.add(path);
        Ok(saved)
    }
}
