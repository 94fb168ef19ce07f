//! Reads the files that another file refers to, only from its project. Buffers can replace files: the unsaved texts of
//! an editor, or the files of a browser.

use std::cell::RefCell;
use std::path::{Component, MAIN_SEPARATOR_STR, Path, PathBuf};
use std::rc::Rc;
use std::{fs, io};

use super::{HARD_LIMIT, SourceError, read, shown};

/// The name of configuration files.
pub const CONFIG_FILE: &str = "objdict.toml";

/// The files and folders that mark a project folder.
const MARKS: [&str; 2] = [CONFIG_FILE, ".git"];

/// The folder of a file, and the folders that may contain the files it refers to: its own; its project folder, the
/// nearest ancestor with an `objdict.toml` or a `.git`; and explicitly allowed folders.
#[derive(Clone, Debug)]
pub struct Folder {
    folder: PathBuf,
    allowed: Vec<PathBuf>,
}

/// The reason why a referenced file is not read.
#[derive(Debug)]
#[non_exhaustive]
pub enum FolderError {
    /// The file cannot be read, or is not a regular file.
    Unreadable(SourceError),
    /// The name points outside the allowed folders.
    Outside {
        /// The name, as in the file.
        name: String,
    },
    /// The path is on a network share.
    Remote {
        /// The name, as in the file.
        name: String,
    },
}

crate::error_messages! { FolderError: from SourceError as Unreadable {
    Self::Unreadable(error) => "{error}";
    Self::Outside { name } => "`{name}` is outside the project";
    Self::Remote { name } => "`{name}` is on a different computer";
} }

impl FolderError {
    /// How to fix the error; options belong to the command line.
    pub fn help(&self) -> Option<&'static str> {
        match self {
            Self::Outside { .. } => Some(
                "if you trust the file that names it, allow its folder with `--allow-path`; a project is the folder with \
                 `objdict.toml` or `.git`",
            ),
            Self::Remote { .. } => Some("copy it into the project"),
            Self::Unreadable(_) => None,
        }
    }
}

impl Folder {
    /// A folder; an empty path is the current one.
    pub fn new(folder: impl Into<PathBuf>) -> Self {
        let folder = or_current(folder.into());
        let own = absolute(&folder);
        let is_project = |folder: &&Path| MARKS.iter().any(|mark| folder.join(mark).exists());
        let project = own.ancestors().find(is_project).map(Path::to_owned);
        Self { folder, allowed: std::iter::once(own).chain(project).collect() }
    }

    /// The folder that a file is in.
    pub fn of(file: &Path) -> Self {
        Self::new(file.parent().unwrap_or(Path::new("")))
    }

    /// Also allows files below `folder`.
    #[must_use]
    pub fn allow(mut self, folder: impl AsRef<Path>) -> Self {
        self.allowed.push(absolute(folder.as_ref()));
        self
    }

    /// The bytes of a file; `name` is resolved as in [`resolve`](Self::resolve).
    ///
    /// # Errors
    /// If the file is missing, is outside the allowed folders, is a pipe or a device, or is larger than 1
    /// GiB.
    pub fn read(&self, name: &str) -> Result<Vec<u8>, FolderError> {
        Ok(read(&self.resolve(name)?, HARD_LIMIT)?)
    }

    /// The path of a file from its name relative to the folder. Links are followed before the check. Names may use
    /// Windows separators.
    ///
    /// # Errors
    /// If the file is missing, outside the allowed folders, or on a network share.
    pub fn resolve(&self, name: &str) -> Result<PathBuf, FolderError> {
        let is_separator = |character: char| matches!(character, '/' | '\\');
        if name.starts_with(is_separator) && name[1..].starts_with(is_separator) {
            return Err(FolderError::Remote { name: name.to_owned() });
        }
        let outside = || FolderError::Outside { name: name.to_owned() };
        let plain = self.folder.join(name);
        // a path that begins with `\\?\` uses only Windows separators
        let foreign = if cfg!(windows) { '/' } else { '\\' };
        let native = self.folder.join(name.replace(foreign, MAIN_SEPARATOR_STR));
        // checked before accessing the file system, to reveal nothing about its contents
        let may_lead_to = |path: &Path| self.allowed.iter().any(|folder| absolute(path).starts_with(folder));
        if !may_lead_to(&plain) || !may_lead_to(&native) {
            return Err(outside());
        }
        let path = if !cfg!(windows) && plain.exists() { plain } else { native };
        if !path.exists() && is_file(&path) {
            // an unsaved file has no symlink to check
            return Ok(path);
        }
        let failed = |error: io::Error| {
            // a browser has only buffers
            let is_missing = error.kind() == io::ErrorKind::Unsupported;
            let error = if is_missing { io::ErrorKind::NotFound.into() } else { error };
            SourceError::Io { path: shown(&path), error }
        };
        let real = fs::canonicalize(&path).map_err(failed)?;
        let is_below =
            |folder: &PathBuf| fs::canonicalize(folder).is_ok_and(|folder| real.starts_with(folder));
        if self.allowed.iter().any(is_below) { Ok(path) } else { Err(outside()) }
    }
}

/// An absolute path without `.` and `..`. Links are not followed.
pub fn absolute(path: &Path) -> PathBuf {
    let path = std::path::absolute(or_current(path.to_owned())).unwrap_or_else(|_| path.to_owned());
    let mut plain = PathBuf::new();
    for component in path.components() {
        match component {
            Component::CurDir => {}
            Component::ParentDir => {
                plain.pop();
            }
            component => plain.push(component),
        }
    }
    plain
}

/// The current folder for an empty path.
pub(super) fn or_current(folder: PathBuf) -> PathBuf {
    if folder.as_os_str().is_empty() { PathBuf::from(".") } else { folder }
}

/// Buffers that take precedence over files of the same path.
pub trait Buffers {
    /// The bytes at an absolute path without `.` and `..`; `None` if the file must be read.
    fn bytes(&self, path: &Path) -> Option<Vec<u8>>;
}

thread_local! {
    static BUFFERS: RefCell<Option<Rc<dyn Buffers>>> = const { RefCell::new(None) };
}

/// Restores the previous buffers, even after a panic.
struct Restored(Option<Rc<dyn Buffers>>);

impl Drop for Restored {
    fn drop(&mut self) {
        BUFFERS.replace(self.0.take());
    }
}

/// Runs a function; files it opens on this thread are read from the buffers if present.
pub fn with_buffers<T>(buffers: Rc<dyn Buffers>, run: impl FnOnce() -> T) -> T {
    let _restored = Restored(BUFFERS.replace(Some(buffers)));
    run()
}

/// The buffer that replaces a file.
pub(super) fn buffered(path: &Path) -> Option<Vec<u8>> {
    let buffers = BUFFERS.with_borrow(Clone::clone)?;
    buffers.bytes(&absolute(path))
}

/// Whether a file or a buffer with this path exists.
pub fn is_file(path: &Path) -> bool {
    path.is_file() || buffered(path).is_some()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::{Folder, read};

    #[test]
    fn only_files_of_the_project_are_read() {
        let root = std::env::temp_dir().join(format!("objdict-folder-{}", std::process::id()));
        let inside = root.join("node");
        fs::create_dir_all(inside.join("data")).unwrap();
        fs::write(root.join("secret.bin"), b"secret").unwrap();
        fs::write(inside.join("data/a.bin"), b"a").unwrap();
        let folder = Folder::new(&inside);
        assert_eq!(folder.read("data/a.bin").unwrap(), b"a");
        assert_eq!(folder.read("data\\a.bin").unwrap(), b"a");
        let absolute = root.join("secret.bin");
        for name in ["../secret.bin", "..\\secret.bin", absolute.to_str().unwrap(), "../none"] {
            assert!(matches!(folder.read(name), Err(FolderError::Outside { .. })), "{name}");
        }
        #[cfg(unix)]
        {
            std::os::unix::fs::symlink(&absolute, inside.join("link")).unwrap();
            assert!(matches!(folder.read("link"), Err(FolderError::Outside { .. })));
        }
        assert!(matches!(folder.read("none"), Err(FolderError::Unreadable(SourceError::Io { .. }))));
        for name in [r"\\server\share\a.bin", "//server/share/a.bin", r"\/server/a.bin"] {
            let remote = folder.clone().allow("/").read(name);
            assert!(matches!(remote, Err(FolderError::Remote { .. })), "{name}");
        }
        let allowed = folder.allow(&root);
        assert_eq!(allowed.read("../secret.bin").unwrap(), b"secret");
        fs::write(root.join(CONFIG_FILE), b"").unwrap();
        let in_project = Folder::of(&inside.join("node.eds"));
        assert_eq!(in_project.read("../secret.bin").unwrap(), b"secret");
        assert!(matches!(in_project.read("../../secret.bin"), Err(FolderError::Outside { .. })));
        fs::remove_dir_all(root).unwrap();
    }

    struct One(&'static str);

    impl Buffers for One {
        fn bytes(&self, path: &Path) -> Option<Vec<u8>> {
            path.ends_with(self.0).then(|| b"buffer".to_vec())
        }
    }

    #[test]
    fn a_buffer_counts_more_than_the_disk_for_a_time() {
        let path = std::env::temp_dir().join("objdict-no-such-folder").join("a.eds");
        let text = with_buffers(Rc::new(One("a.eds")), || {
            assert!(is_file(&path));
            assert_eq!(Folder::of(&path).resolve("a.eds").unwrap(), path);
            assert!(matches!(read(&path, 3), Err(crate::source::SourceError::TooLarge { .. })));
            read(&path, 100).unwrap()
        });
        assert_eq!(text, b"buffer");
        assert!(read(&path, 100).is_err() && !is_file(&path));
    }
}
