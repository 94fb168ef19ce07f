//! Reads the files that a description references, only from its folder.

use std::fs;
use std::path::{Component, Path, PathBuf};

use super::{HARD_LIMIT, SourceError, read};

/// A folder whose files a description may reference, and further allowed folders.
#[derive(Clone, Debug)]
pub struct Folder {
    folder: PathBuf,
    allowed: Vec<PathBuf>,
}

/// Why a referenced file is not read.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FolderError {
    /// The file cannot be read, or is none.
    #[error(transparent)]
    Unreadable(#[from] SourceError),
    /// The name points outside the folder.
    #[error("`{name}` is not in the folder of the description")]
    Outside {
        /// The name, as in the description.
        name: String,
    },
}

impl FolderError {
    /// How to fix the error; options are those of the command line.
    pub fn help(&self) -> Option<&'static str> {
        match self {
            Self::Outside { .. } => {
                Some("allow its folder with `--allow-path`, if you trust the description")
            }
            Self::Unreadable(_) => None,
        }
    }
}

impl Folder {
    /// The folder of a description; an empty path is the current folder.
    pub fn new(folder: impl Into<PathBuf>) -> Self {
        Self { folder: or_current(folder.into()), allowed: Vec::new() }
    }

    /// The folder that a file is in.
    pub fn of(file: &Path) -> Self {
        Self::new(file.parent().unwrap_or(Path::new("")))
    }

    /// Also allows files below `folder`.
    #[must_use]
    pub fn allow(mut self, folder: impl Into<PathBuf>) -> Self {
        self.allowed.push(or_current(folder.into()));
        self
    }

    /// The bytes of a file by its name relative to the folder. Links are resolved before the check. Names
    /// with the separators of Windows are accepted.
    ///
    /// # Errors
    /// When the file cannot be read, is outside the allowed folders, is a pipe or a device, or is larger than 1 GiB.
    pub fn read(&self, name: &str) -> Result<Vec<u8>, FolderError> {
        let outside = || FolderError::Outside { name: name.to_owned() };
        // before accessing the file system, to reveal nothing about its contents
        let path = self.path_of(name).ok_or_else(outside)?;
        let failed = |error| SourceError::Io { path: path.display().to_string(), error };
        let real = fs::canonicalize(&path).map_err(failed)?;
        let is_below =
            |folder: &PathBuf| fs::canonicalize(folder).is_ok_and(|folder| real.starts_with(folder));
        if !self.folders().any(is_below) {
            return Err(outside());
        }
        Ok(read(&real, HARD_LIMIT)?)
    }

    fn folders(&self) -> impl Iterator<Item = &PathBuf> {
        std::iter::once(&self.folder).chain(&self.allowed)
    }

    /// The path that a name means: as it is or, where there is no such file, with the separators of Windows. `None` where
    /// the name leads out of the allowed folders.
    fn path_of(&self, name: &str) -> Option<PathBuf> {
        let plain = self.folder.join(name);
        let of_windows = self.folder.join(name.replace('\\', "/"));
        if !self.may_lead_to(&plain) || !self.may_lead_to(&of_windows) {
            return None;
        }
        Some(if plain.exists() { plain } else { of_windows })
    }

    /// Whether the name alone stays in the folder, or can lead to an allowed folder.
    fn may_lead_to(&self, path: &Path) -> bool {
        let own = path.strip_prefix(&self.folder).ok();
        let stays = own.is_some_and(|own| {
            own.components().all(|part| matches!(part, Component::Normal(_) | Component::CurDir))
        });
        stays || !self.allowed.is_empty()
    }
}

fn or_current(folder: PathBuf) -> PathBuf {
    if folder.as_os_str().is_empty() { PathBuf::from(".") } else { folder }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_files_of_the_folder_are_read() {
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
        let allowed = folder.allow(&root);
        assert_eq!(allowed.read("../secret.bin").unwrap(), b"secret");
        fs::remove_dir_all(root).unwrap();
    }
}
