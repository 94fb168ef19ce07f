//! Writes files: as a whole, and only when they change.

use std::ffi::OsStr;
use std::fs::{self, File, Metadata, OpenOptions};
use std::hash::{BuildHasher, RandomState};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use objdict_model::source::{is_device_name, shown};

/// The result of saving a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Saved {
    /// It was written.
    Written,
    /// It already had these contents and was not touched, so that nothing is rebuilt because of it.
    Unchanged,
}

/// The temporary files that exist now.
static TEMPORARY: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Writes the file at `path`: all of its contents or, on failure, none. Folders are created. An existing file keeps its
/// permissions, its owner and its other names; a read-only one is not changed. A pipe or a device is written to
/// directly.
pub fn save(path: &Path, contents: &[u8]) -> io::Result<Saved> {
    match prepare(path, contents)? {
        Prepared::Done(saved) => Ok(saved),
        Prepared::New(file) => put(vec![file]).map(|()| Saved::Written),
    }
}

/// The preparation of a file before its contents are put in place.
pub(super) enum Prepared {
    /// Nothing remains to be replaced.
    Done(Saved),
    New(NewFile),
}

/// Contents that are already on the disk, next to the target file.
#[derive(Debug)]
pub(super) struct NewFile {
    pub(super) path: PathBuf,
    pub(super) new: Temporary,
    /// The old contents of a file that has other names or a different owner: it is overwritten in place.
    pub(super) backup: Option<Temporary>,
}

/// Writes the contents of a file next to it.
pub(super) fn prepare(path: &Path, contents: &[u8]) -> io::Result<Prepared> {
    let to_device = || {
        OpenOptions::new().append(true).open(path)?.write_all(contents)?;
        Ok(Prepared::Done(Saved::Written))
    };
    // the only information that Windows has about `NUL`
    if cfg!(windows) && path.file_name().and_then(OsStr::to_str).is_some_and(is_device_name) {
        return to_device();
    }
    let Ok(found) = fs::metadata(path) else { return beside(path, None, contents) };
    match () {
        () if found.is_dir() => Err(io::Error::other("it is a directory")),
        () if !found.is_file() || is_of_system(path) => to_device(),
        () if found.len() == contents.len() as u64 && fs::read(path)? == contents => {
            Temporary::clean_up(&replaced(path));
            Ok(Prepared::Done(Saved::Unchanged))
        }
        () if found.permissions().readonly() => Err(io::Error::other("it is read-only")),
        () => beside(path, Some(&found), contents),
    }
}

/// Whether a path refers to an open file, such as `/dev/stdout`.
fn is_of_system(path: &Path) -> bool {
    path.starts_with("/dev") || path.starts_with("/proc")
}

/// Behind a link, the file that it names is replaced and not the link.
fn replaced(path: &Path) -> PathBuf {
    fs::canonicalize(path).unwrap_or_else(|_| path.to_owned())
}

fn beside(path: &Path, found: Option<&Metadata>, contents: &[u8]) -> io::Result<Prepared> {
    let path = replaced(path);
    if let Some(folder) = path.parent().filter(|folder| !folder.as_os_str().is_empty()) {
        fs::create_dir_all(folder)?;
    }
    Temporary::clean_up(&path);
    let (mut file, new) = Temporary::beside(&path)?;
    file.write_all(contents)?;
    file.sync_data()?;
    let mut backup = None;
    match found {
        Some(found) if can_be_renamed(&file, &path, found) => file.set_permissions(found.permissions())?,
        Some(_) => {
            let (mut copy, kept) = Temporary::beside(&path)?;
            io::copy(&mut File::open(&path)?, &mut copy)?;
            copy.sync_data()?;
            backup = Some(kept);
        }
        None => {}
    }
    Ok(Prepared::New(NewFile { path, new, backup }))
}

/// Puts new files in place: all of them or, on failure, none. If there are several, the old files are removed first, so
/// that a killed run leaves none of them next to new ones.
pub(super) fn put(mut files: Vec<NewFile>) -> io::Result<()> {
    let renamed = || files.iter().filter(|file| file.backup.is_none());
    let leaving = renamed().filter(|file| files.len() > 1 && file.path.exists());
    let leaving: Vec<_> =
        leaving.map(|file| (file.path.clone(), Temporary::name_beside(&file.path))).collect();
    // no signal ends the process before this is done
    let mut pending = pending();
    let mut moves = Moves::default();
    leaving.iter().try_for_each(|(path, away)| moves.rename(path, away))?;
    renamed().try_for_each(|file| moves.rename(&file.new.path, &file.path))?;
    files.iter_mut().try_for_each(|file| overwrite(file, &mut pending))?;
    moves.done.clear();
    leaving.iter().for_each(|(_, away)| _ = fs::remove_file(away));
    Ok(())
}

/// Files that were renamed; they get their former names when one cannot be.
#[derive(Default)]
struct Moves {
    done: Vec<(PathBuf, PathBuf)>,
}

impl Moves {
    fn rename(&mut self, from: &Path, to: &Path) -> io::Result<()> {
        fs::rename(from, to)?;
        self.done.push((from.to_owned(), to.to_owned()));
        Ok(())
    }
}

impl Drop for Moves {
    fn drop(&mut self) {
        for (from, to) in self.done.drain(..).rev() {
            let _ = fs::rename(to, from);
        }
    }
}

/// Whether a new file may replace the existing one: not if that has other names, or a different owner.
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

/// Windows file information that `std` does not expose.
#[cfg(all(windows, feature = "command"))]
pub(super) fn information(path: &Path) -> Option<winapi_util::file::Information> {
    winapi_util::file::information(winapi_util::Handle::from_path_any(path).ok()?).ok()
}

/// Writes into a file that keeps its other names; it has its former contents again if that fails.
fn overwrite(file: &mut NewFile, pending: &mut Vec<PathBuf>) -> io::Result<()> {
    let Some(backup) = file.backup.take() else { return Ok(()) };
    let copy = |from: &Temporary| {
        fs::write(&file.path, fs::read(&from.path)?)?;
        OpenOptions::new().write(true).open(&file.path)?.sync_data()
    };
    let Err(error) = copy(&file.new) else {
        file.backup = Some(backup);
        return Ok(());
    };
    if copy(&backup).is_ok() {
        file.backup = Some(backup);
        return Err(error);
    }
    let error = io::Error::other(format!("{error}; its previous contents are in `{}`", shown(&backup.path)));
    pending.retain(|path| *path != backup.path);
    std::mem::forget(backup);
    Err(error)
}

/// A file or folder next to another one, so that it can be renamed on the same disk. It is finally removed if
/// it still exists.
#[derive(Debug)]
pub(super) struct Temporary {
    pub(super) path: PathBuf,
    _lock: Option<lock::Lock>,
}

/// The file extension of temporary files.
const ENDING: &str = ".new";

/// The maximum number of temporary files locked at once; some systems open no more than 256 files.
const MAX_LOCKS: usize = 100;

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
                    let lock = if pending.len() < MAX_LOCKS { lock::of(&temporary) } else { None };
                    // another run may have held the lock first, and removed it
                    if temporary.exists() {
                        pending.push(temporary.clone());
                        return Ok((made, Self { path: temporary, _lock: lock }));
                    }
                }
                Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
                Err(error) => return Err(error),
            }
        }
    }

    /// An unused name next to `path`.
    pub(super) fn name_beside(path: &Path) -> PathBuf {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let random = RandomState::new().hash_one(path);
        path.with_file_name(format!(".{name}.{random:016x}{ENDING}"))
    }

    /// Removes the temporary files that killed runs left next to `path`.
    pub(super) fn clean_up(path: &Path) {
        let (Some(folder), Some(name)) = (path.parent(), path.file_name()) else { return };
        let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
        Self::clean_up_in(folder, &[&name.to_string_lossy()]);
    }

    /// Removes the temporary files that killed runs left in a folder for files of these names.
    pub(super) fn clean_up_in(folder: &Path, names: &[&str]) {
        let is_left = |name: &str| {
            let rest = name.strip_prefix('.').and_then(|name| name.strip_suffix(ENDING));
            let parts = rest.and_then(|rest| rest.rsplit_once('.'));
            parts.is_some_and(|(name, random)| {
                names.contains(&name)
                    && random.len() == 16
                    && random.bytes().all(|byte| byte.is_ascii_hexdigit())
            })
        };
        let entries = fs::read_dir(folder).into_iter().flatten().flatten();
        for entry in entries.filter(|entry| entry.file_name().to_str().is_some_and(is_left)) {
            lock::if_abandoned(&entry.path(), Self::remove);
        }
    }

    fn remove(path: &Path) {
        // after renaming there is nothing to remove
        if fs::remove_file(path).is_err() && path.is_dir() {
            let _ = fs::remove_dir_all(path);
        }
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        Self::remove(&self.path);
        pending().retain(|path| *path != self.path);
    }
}

pub(super) fn pending() -> MutexGuard<'static, Vec<PathBuf>> {
    TEMPORARY.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A file that no other user can read, in its own folder. Both are removed when it is dropped, and when the
/// command is interrupted.
#[cfg(feature = "command")]
#[derive(Debug)]
pub struct PrivateFile {
    _folder: Temporary,
    /// Its path.
    pub path: PathBuf,
}

#[cfg(feature = "command")]
impl PrivateFile {
    /// A file of this name in the folder for temporary files.
    pub fn new(name: &str, contents: &[u8]) -> io::Result<Self> {
        let mut folder = fs::DirBuilder::new();
        #[cfg(unix)]
        std::os::unix::fs::DirBuilderExt::mode(&mut folder, 0o700);
        let beside = std::env::temp_dir().join("objdict");
        let ((), folder) = Temporary::make(&beside, |path| folder.create(path))?;
        let path = folder.path.join(name);
        let mut options = OpenOptions::new();
        #[cfg(unix)]
        std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o600);
        options.write(true).create_new(true).open(&path)?.write_all(contents)?;
        Ok(Self { _folder: folder, path })
    }
}

/// Removes all temporary files and runs `end`; no new ones are created before that.
pub fn abandon(end: impl FnOnce()) {
    let pending = pending();
    pending.iter().for_each(|path| Temporary::remove(path));
    end();
}

/// Locks of temporary files, which end with the process that holds them.
#[cfg(all(unix, feature = "command"))]
mod lock {
    use std::fs::File;
    use std::path::Path;

    use nix::fcntl::{Flock, FlockArg};

    pub(super) type Lock = Flock<File>;

    /// The lock of a new file or folder; `None` if the file system does not support locks.
    pub(super) fn of(path: &Path) -> Option<Lock> {
        Flock::lock(File::open(path).ok()?, FlockArg::LockExclusive).ok()
    }

    /// Removes it unless a process holds its lock; keeps the lock during removal, so that no other process
    /// gets it.
    pub(super) fn if_abandoned(path: &Path, remove: impl Fn(&Path)) {
        // opening a pipe would wait for its other end
        if path.symlink_metadata().is_ok_and(|found| found.is_file() || found.is_dir())
            && let Ok(file) = File::open(path)
            && let Ok(_lock) = Flock::lock(file, FlockArg::LockExclusiveNonblock)
        {
            remove(path);
        }
    }
}

/// Without locks, a file younger than a minute is assumed to be in use.
#[cfg(not(all(unix, feature = "command")))]
mod lock {
    use std::fs;
    use std::path::Path;
    use std::time::Duration;

    pub(super) type Lock = ();

    pub(super) fn of(_: &Path) -> Option<Lock> {
        None
    }

    pub(super) fn if_abandoned(path: &Path, remove: impl Fn(&Path)) {
        let age = fs::metadata(path).and_then(|found| found.modified()).map(|time| time.elapsed());
        if matches!(age, Ok(Ok(age)) if age > Duration::from_secs(60)) {
            remove(path);
        }
    }
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

    /// The temporary files of all tests in its process are removed, hence it has one of its own.
    #[cfg(feature = "command")]
    #[test]
    fn an_interrupted_command_leaves_no_temporary_file() {
        if std::env::var_os("OBJDICT_OWN_PROCESS").is_some() {
            let folder = tempfile::tempdir().unwrap();
            let (_, temporary) = Temporary::beside(&folder.path().join("od.c")).unwrap();
            assert!(temporary.path.exists());
            return abandon(|| assert!(!temporary.path.exists()));
        }
        let mut test = std::process::Command::new(std::env::current_exe().unwrap());
        test.args(["--exact", "output::save::tests::an_interrupted_command_leaves_no_temporary_file"]);
        let output = test.env("OBJDICT_OWN_PROCESS", "1").output().unwrap();
        let text = String::from_utf8_lossy(&output.stdout);
        assert!(output.status.success() && text.contains("1 passed"), "{text}");
    }

    /// A killed process no longer holds its lock.
    #[test]
    fn what_a_killed_run_has_left_is_removed() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("od.c");
        let left = |random: &str, name: &str| {
            let left = folder.path().join(format!(".{name}.{random}.new"));
            let file = File::create(&left).unwrap();
            file.set_modified(std::time::SystemTime::UNIX_EPOCH).unwrap();
            left
        };
        let others = [left("0123456789abcdef", "od.h"), left("new", "od.c")];
        // when it is written, and when it is already up to date
        for _ in 0..2 {
            let left = left("0123456789abcdef", "od.c");
            save(&path, b"1").unwrap();
            assert!(!left.exists() && others.iter().all(|path| path.exists()));
        }
        let (_, used) = Temporary::beside(&path).unwrap();
        save(&path, b"2").unwrap();
        assert!(used.path.exists(), "another run is writing it");
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
