//! Replaces all related files of a folder at once: a run that fails or is killed leaves the old files, and never a
//! mixture of old and new ones.
//!
//! Renaming the files one by one would leave a mixture after a kill; a journal would need readers that know it.
//!
//! A folder without other files is built next to the old one, and both are exchanged in one step. If that is not
//! possible, for example because of foreign files in the folder, the old files are removed before the new ones are
//! added.

use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

use super::error::OutputError;
use super::folder::{FoundFile, OutputFolder};
use super::manifest::{Hash, Manifest, NAME, WriteLog};
use super::names::require_portable;
use super::save::{NewFile, Temporary, pending, put};
use super::used::Used;

/// A file that is to be in the folder.
struct WantedFile<'a> {
    name: &'a str,
    contents: &'a [u8],
    found: FoundFile,
}

impl OutputFolder {
    /// Replaces the folder's files with these. Other files are kept; returns the names of those that the same
    /// origin wrote before.
    ///
    /// # Errors
    /// If one of the files must not be written, or cannot be. All are then unchanged.
    pub fn replace(mut self, files: &[(&str, &[u8])], used: &mut Used) -> Result<Vec<String>, OutputError> {
        let failed = |path: PathBuf| OutputError::unwritable(path);
        files.iter().try_for_each(|(name, _)| require_flat(name))?;
        let shown = self.path.clone();
        fs::create_dir_all(&shown).map_err(failed(shown.clone()))?;
        let folder = fs::canonicalize(&shown).map_err(failed(shown.clone()))?;
        let _lock = locked(&folder).map_err(failed(shown.clone()))?;
        // another run may have held the lock
        self.manifest = Manifest::open(&folder).map_err(failed(shown.join(NAME)))?.unwrap_or_default();
        let mut wanted = Vec::with_capacity(files.len());
        for &(name, contents) in files {
            let found = self.find(name, contents, used)?;
            if found == FoundFile::Replaceable {
                require_file(&folder.join(name)).map_err(failed(shown.join(name)))?;
            }
            self.taken.insert(name.to_lowercase());
            wanted.push(WantedFile { name, contents, found });
        }
        let is_stale = |name: &&String| {
            let is_ours = self.manifest.files.get(*name).is_some_and(|record| record.origin == self.origin);
            is_ours && files.iter().all(|(wanted, _)| wanted != name) && folder.join(name).exists()
        };
        let stale = self.manifest.files.keys().filter(is_stale).cloned().collect();
        let mut manifest = self.manifest.clone();
        wanted.iter().for_each(|file| manifest.set(file.name, Hash::of(file.contents), &self.origin));
        let is_same = manifest == self.manifest && wanted.iter().all(|file| file.found == FoundFile::Same);
        let replacement = FolderReplacement { folder: &folder, wanted, manifest, former: &self.manifest };
        replacement.clean_up();
        if !is_same && !replacement.by_exchange().map_err(failed(shown.clone()))? {
            replacement.in_place(&self.origin).map_err(failed(shown))?;
        }
        files.iter().for_each(|(name, _)| used.add(&folder.join(name)));
        Ok(stale)
    }
}

/// The new files of a folder.
struct FolderReplacement<'a> {
    /// Its full path.
    folder: &'a Path,
    wanted: Vec<WantedFile<'a>>,
    /// The list in the end.
    manifest: Manifest,
    /// The current list.
    former: &'a Manifest,
}

impl FolderReplacement<'_> {
    /// Removes leftovers of killed runs.
    fn clean_up(&self) {
        let names = self.manifest.files.keys().map(String::as_str);
        Temporary::clean_up_in(self.folder, &names.chain([NAME]).collect::<Vec<_>>());
        Temporary::clean_up(self.folder);
    }

    /// Builds the new folder next to the existing one and exchanges both. Returns whether that was possible.
    fn by_exchange(&self) -> io::Result<bool> {
        if !CAN_EXCHANGE || !self.is_ours_alone() {
            return Ok(false);
        }
        let Ok(new) = Temporary::folder_beside(self.folder) else { return Ok(false) };
        if !has_owner_of(&new.path, self.folder) {
            return Ok(false);
        }
        fs::set_permissions(&new.path, fs::metadata(self.folder)?.permissions())?;
        let wanted = |name: &str| self.wanted.iter().find(|file| file.name == name);
        for name in self.manifest.files.keys() {
            let (old, path) = (self.folder.join(name), new.path.join(name));
            match wanted(name).filter(|file| file.found != FoundFile::Same) {
                Some(file) => write(&path, file.contents, &old)?,
                None if !old.exists() => {}
                None => fs::hard_link(&old, &path).or_else(|_| fs::copy(&old, &path).map(|_| ()))?,
            }
        }
        write(&new.path.join(NAME), self.manifest.text().as_bytes(), &self.folder.join(NAME))?;
        // no signal ends the process before this is done
        let _pending = pending();
        if exchange(&new.path, self.folder).is_err() {
            return Ok(false);
        }
        // files added to the old folder in the meantime
        for entry in fs::read_dir(&new.path)?.flatten().filter(|entry| !self.is_known(entry)) {
            fs::rename(entry.path(), self.folder.join(entry.file_name()))?;
        }
        Ok(true)
    }

    /// Whether an entry of the folder has the name of a file that objdict wrote or writes.
    fn is_known(&self, entry: &fs::DirEntry) -> bool {
        entry
            .file_name()
            .to_str()
            .is_some_and(|name| self.former.lists(name) || self.wanted.iter().any(|file| file.name == name))
    }

    /// Whether the folder contains only files of the list, and is not the working directory, which would remain the old
    /// one.
    fn is_ours_alone(&self) -> bool {
        let is_ours = |entry: fs::DirEntry| {
            let is_file = entry.metadata().is_ok_and(|found| found.is_file() && has_one_name(&found));
            is_file && self.is_known(&entry)
        };
        let is_flat = self.manifest.files.keys().all(|name| !name.contains('/'));
        let is_elsewhere = std::env::current_dir().is_ok_and(|here| !here.starts_with(self.folder));
        is_flat
            && is_elsewhere
            && fs::read_dir(self.folder)
                .is_ok_and(|mut entries| entries.all(|entry| entry.is_ok_and(is_ours)))
    }

    /// Moves the old files away and the new ones in. The list has the contents of both in the meantime.
    fn in_place(&self, origin: &str) -> io::Result<()> {
        let beside = |path: PathBuf, contents: &[u8]| {
            let (_, new) = Temporary::beside(&path)?;
            write(&new.path, contents, &path).map(|()| NewFile { path, new, backup: None })
        };
        let changed = || self.wanted.iter().filter(|file| file.found != FoundFile::Same);
        let new = changed().map(|file| beside(self.folder.join(file.name), file.contents));
        let new = new.collect::<io::Result<_>>()?;
        let list = beside(self.folder.join(NAME), self.manifest.text().as_bytes())?;
        let mut log = WriteLog::open(self.folder, origin)?;
        changed().try_for_each(|file| log.add(file.name, Hash::of(file.contents)))?;
        // Windows does not replace a file that is open
        drop(log);
        put(new)?;
        put(vec![list])
    }
}

/// Writes a new file, with the permissions of an old one.
fn write(path: &Path, contents: &[u8], old: &Path) -> io::Result<()> {
    fs::write(path, contents)?;
    let file = File::options().write(true).open(path)?;
    file.sync_data()?;
    match fs::metadata(old) {
        Ok(found) => file.set_permissions(found.permissions()),
        Err(_) => Ok(()),
    }
}

/// Rejects a target that is not a regular file, or is read-only.
fn require_file(path: &Path) -> io::Result<()> {
    match fs::metadata(path) {
        Ok(found) if !found.is_file() => Err(io::Error::other("it is not a file")),
        Ok(found) if found.permissions().readonly() => Err(io::Error::other("it is read-only")),
        _ => Ok(()),
    }
}

/// Whether the system can exchange two folders.
const CAN_EXCHANGE: bool = cfg!(all(target_os = "linux", target_env = "gnu"));

#[cfg(all(target_os = "linux", target_env = "gnu"))]
fn exchange(one: &Path, other: &Path) -> io::Result<()> {
    use nix::fcntl::{AT_FDCWD, RenameFlags, renameat2};
    Ok(renameat2(AT_FDCWD, one, AT_FDCWD, other, RenameFlags::RENAME_EXCHANGE)?)
}

#[cfg(not(all(target_os = "linux", target_env = "gnu")))]
fn exchange(_: &Path, _: &Path) -> io::Result<()> {
    Err(io::ErrorKind::Unsupported.into())
}

/// Waits until no other run uses the folder. If the folder is exchanged in the meantime, locks the new one.
#[cfg(unix)]
fn locked(folder: &Path) -> io::Result<Option<nix::fcntl::Flock<File>>> {
    use std::os::unix::fs::MetadataExt;

    use nix::fcntl::{Flock, FlockArg};
    loop {
        // not every file system has locks
        let Ok(lock) = Flock::lock(File::open(folder)?, FlockArg::LockExclusive) else { return Ok(None) };
        let is_there = fs::metadata(folder).is_ok_and(|found| {
            lock.metadata().is_ok_and(|locked| (locked.dev(), locked.ino()) == (found.dev(), found.ino()))
        });
        if is_there {
            return Ok(Some(lock));
        }
        fs::create_dir_all(folder)?;
    }
}

#[cfg(not(unix))]
fn locked(_: &Path) -> io::Result<Option<()>> {
    Ok(None)
}

#[cfg(unix)]
fn has_one_name(file: &fs::Metadata) -> bool {
    use std::os::unix::fs::MetadataExt;
    file.nlink() == 1
}

#[cfg(not(unix))]
fn has_one_name(_: &fs::Metadata) -> bool {
    true
}

#[cfg(unix)]
fn has_owner_of(one: &Path, other: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let owner = |path: &Path| fs::metadata(path).ok().map(|found| (found.uid(), found.gid()));
    owner(one) == owner(other)
}

#[cfg(not(unix))]
fn has_owner_of(_: &Path, _: &Path) -> bool {
    true
}

/// Rejects the name of a file that is not directly in the folder, or that is not valid on every system.
fn require_flat(name: &str) -> Result<(), OutputError> {
    if name.contains('/') {
        return Err(OutputError::Name { name: name.to_owned(), reason: "it points to a different folder" });
    }
    require_portable(name)
}

impl Temporary {
    /// A new folder, to be renamed to `path`.
    fn folder_beside(path: &Path) -> io::Result<Self> {
        Self::make(path, |path| fs::create_dir(path)).map(|((), made)| made)
    }
}
