//! Files that are written: as a whole, and only when they change.

use std::ffi::OsStr;
use std::fs::{self, File, Metadata, OpenOptions};
use std::hash::{BuildHasher, RandomState};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use super::names::is_device;
use objdict_model::source::shown;

/// What became of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Saved {
    /// It was written.
    Written,
    /// It had these contents already and was not touched, so that nothing is built again because of it.
    Unchanged,
}

/// The temporary files that exist now.
static TEMPORARY: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Gives the file at `path` its contents: all of them or, when something fails, none. Folders are made. A file that exists
/// keeps its permissions, its owner and its other names; one that is read-only is left alone. A pipe or a device is
/// written to.
pub fn save(path: &Path, contents: &[u8]) -> io::Result<Saved> {
    let to_device =
        || OpenOptions::new().append(true).open(path)?.write_all(contents).map(|()| Saved::Written);
    // of `NUL` Windows knows nothing else
    if cfg!(windows) && path.file_name().and_then(OsStr::to_str).is_some_and(is_device) {
        return to_device();
    }
    let Ok(found) = fs::metadata(path) else { return replace(path, None, contents) };
    match () {
        () if found.is_dir() => Err(io::Error::other("it is a directory")),
        () if !found.is_file() || is_of_system(path) => to_device(),
        () if found.len() == contents.len() as u64 && fs::read(path)? == contents => Ok(Saved::Unchanged),
        () if found.permissions().readonly() => Err(io::Error::other("it is read-only")),
        () => replace(path, Some(&found), contents),
    }
}

/// Whether a path names what is open already, such as `/dev/stdout`.
fn is_of_system(path: &Path) -> bool {
    path.starts_with("/dev") || path.starts_with("/proc")
}

fn replace(path: &Path, found: Option<&Metadata>, contents: &[u8]) -> io::Result<Saved> {
    // behind a link, the file that it names is replaced and not the link
    let path = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    if let Some(folder) = path.parent().filter(|folder| !folder.as_os_str().is_empty()) {
        fs::create_dir_all(folder)?;
    }
    let (mut file, temporary) = Temporary::beside(&path)?;
    if found.is_some_and(|found| !can_be_renamed(&file, &path, found)) {
        overwrite(&path, file, temporary, contents)?;
    } else {
        file.write_all(contents)?;
        file.sync_data()?;
        if let Some(found) = found {
            file.set_permissions(found.permissions())?;
        }
        fs::rename(&temporary.0, &path)?;
    }
    Ok(Saved::Written)
}

/// Whether a new file may take the place of one: not if that has other names, or another owner.
#[cfg(unix)]
fn can_be_renamed(new: &File, _: &Path, found: &Metadata) -> bool {
    use std::os::unix::fs::MetadataExt;
    let is_ours = |new: Metadata| (new.uid(), new.gid()) == (found.uid(), found.gid());
    found.nlink() == 1 && new.metadata().is_ok_and(is_ours)
}

#[cfg(all(windows, feature = "command"))]
fn can_be_renamed(_: &File, path: &Path, _: &Metadata) -> bool {
    information(path).is_some_and(|found| found.number_of_links() == 1)
}

#[cfg(not(any(unix, all(windows, feature = "command"))))]
fn can_be_renamed(_: &File, _: &Path, _: &Metadata) -> bool {
    true
}

/// What Windows knows of a file, and `std` keeps for itself.
#[cfg(all(windows, feature = "command"))]
pub(super) fn information(path: &Path) -> Option<winapi_util::file::Information> {
    winapi_util::file::information(winapi_util::Handle::from_path_any(path).ok()?).ok()
}

/// Writes into a file, which has its former contents again if that fails.
fn overwrite(path: &Path, mut backup: File, temporary: Temporary, contents: &[u8]) -> io::Result<()> {
    let mut file = OpenOptions::new().read(true).write(true).open(path)?;
    io::copy(&mut file, &mut backup)?;
    backup.sync_data()?;
    // no signal ends the process before this is done
    let mut pending = pending();
    let Err(error) = fs::write(path, contents).and_then(|()| file.sync_data()) else { return Ok(()) };
    if fs::copy(&temporary.0, path).is_ok() {
        return Err(error);
    }
    let error = io::Error::other(format!("{error}; its former contents are in `{}`", shown(&temporary.0)));
    pending.retain(|path| *path != temporary.0);
    std::mem::forget(temporary);
    Err(error)
}

/// A file or folder beside another, so that renaming it stays on one disk. It is removed in the end, if it is still there.
#[derive(Debug)]
pub(super) struct Temporary(pub(super) PathBuf);

/// The last extension of temporary files.
pub(super) const ENDING: &str = ".new";

impl Temporary {
    /// A new file, to be renamed to `path`.
    pub(super) fn beside(path: &Path) -> io::Result<(File, Self)> {
        Self::make(path, |path| File::create_new(path))
    }

    pub(super) fn make<T>(path: &Path, make: impl Fn(&Path) -> io::Result<T>) -> io::Result<(T, Self)> {
        loop {
            let temporary = Self::name_beside(path);
            let mut pending = pending();
            match make(&temporary) {
                Ok(made) => {
                    pending.push(temporary.clone());
                    return Ok((made, Self(temporary)));
                }
                Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
                Err(error) => return Err(error),
            }
        }
    }

    /// A name beside `path` that nothing else has.
    pub(super) fn name_beside(path: &Path) -> PathBuf {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let random = RandomState::new().hash_one(path);
        path.with_file_name(format!(".{name}.{random:016x}{ENDING}"))
    }

    fn remove(path: &Path) {
        // after a renaming there is nothing to remove
        if fs::remove_file(path).is_err() && path.is_dir() {
            let _ = fs::remove_dir_all(path);
        }
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        Self::remove(&self.0);
        pending().retain(|path| *path != self.0);
    }
}

pub(super) fn pending() -> MutexGuard<'static, Vec<PathBuf>> {
    TEMPORARY.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes all temporary files and runs `end`, before which no other one is made.
pub fn abandon(end: impl FnOnce()) {
    let pending = pending();
    pending.iter().for_each(|path| Temporary::remove(path));
    end();
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_equal_is_not_touched() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("new/od.rs");
        assert_eq!(save(&path, b"1").unwrap(), Saved::Written);
        let time = fs::metadata(&path).unwrap().modified().unwrap();
        assert_eq!(save(&path, b"1").unwrap(), Saved::Unchanged);
        assert_eq!(fs::metadata(&path).unwrap().modified().unwrap(), time);
        assert_eq!(save(&path, b"2").unwrap(), Saved::Written);
        assert_eq!(fs::read(&path).unwrap(), b"2");
        assert_eq!(fs::read_dir(path.parent().unwrap()).unwrap().count(), 1, "no temporary file is left");
    }

    #[cfg(feature = "command")]
    #[test]
    fn an_interrupted_command_leaves_no_temporary_file() {
        let folder = tempfile::tempdir().unwrap();
        let (_, temporary) = Temporary::beside(&folder.path().join("od.c")).unwrap();
        assert!(temporary.0.exists());
        abandon(|| assert!(!temporary.0.exists()));
    }

    #[test]
    fn a_folder_in_the_way_is_reported() {
        let folder = tempfile::tempdir().unwrap();
        let error = save(folder.path(), b"1").unwrap_err();
        assert_eq!(error.to_string(), "it is a directory");
    }

    #[test]
    fn a_read_only_file_is_left_alone() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("od.c");
        fs::write(&path, "1").unwrap();
        let mut permissions = fs::metadata(&path).unwrap().permissions();
        permissions.set_readonly(true);
        fs::set_permissions(&path, permissions).unwrap();
        assert_eq!(save(&path, b"2").unwrap_err().to_string(), "it is read-only");
        assert_eq!(fs::read(&path).unwrap(), b"1");
    }

    #[cfg(unix)]
    #[test]
    fn other_names_of_a_file_see_what_is_written() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        let (path, other) = (folder.path().join("od.c"), folder.path().join("link.c"));
        fs::write(&path, "longer than the new one").unwrap();
        fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).unwrap();
        fs::hard_link(&path, &other).unwrap();
        assert_eq!(save(&path, b"2").unwrap(), Saved::Written);
        assert_eq!(fs::read(&other).unwrap(), b"2");
        fs::remove_file(&other).unwrap();
        assert_eq!(save(&path, b"3").unwrap(), Saved::Written);
        assert_eq!(fs::metadata(&path).unwrap().permissions().mode() & 0o777, 0o640);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "no temporary file is left");
    }

    #[cfg(unix)]
    #[test]
    fn a_device_is_written_to_and_stays() {
        use std::os::unix::fs::FileTypeExt;
        assert_eq!(save(Path::new("/dev/null"), b"1").unwrap(), Saved::Written);
        assert!(fs::metadata("/dev/null").unwrap().file_type().is_char_device());
    }
}
