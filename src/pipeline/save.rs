//! Files that are written: as a whole, and only when they change.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// What became of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Saved {
    /// It was written.
    Written,
    /// It had these contents already and was not touched, so that nothing is built again because of it.
    Unchanged,
}

/// Gives the file at `path` its contents: all of them or, when something fails, none. Folders are made.
pub(crate) fn save(path: &Path, contents: &[u8]) -> io::Result<Saved> {
    if fs::read(path).is_ok_and(|old| old == contents) {
        return Ok(Saved::Unchanged);
    }
    replace(path, contents).map(|()| Saved::Written)
}

fn replace(path: &Path, contents: &[u8]) -> io::Result<()> {
    // behind a link, the file that it names is replaced and not the link
    let path = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    if path.is_dir() {
        return Err(io::Error::other("it is a directory"));
    }
    if let Some(folder) = path.parent().filter(|folder| !folder.as_os_str().is_empty()) {
        fs::create_dir_all(folder)?;
    }
    let temporary = temporary(&path);
    let result = write_new(&temporary, contents).and_then(|()| {
        if let Ok(metadata) = fs::metadata(&path) {
            fs::set_permissions(&temporary, metadata.permissions())?;
        }
        fs::rename(&temporary, &path)
    });
    if result.is_err() {
        // what is left of it is of no use; the error that matters is the first one
        let _ = fs::remove_file(&temporary);
    }
    result
}

fn write_new(path: &Path, contents: &[u8]) -> io::Result<()> {
    let mut file = fs::File::create_new(path)?;
    file.write_all(contents)?;
    file.sync_data()
}

/// A name beside the file, so that renaming it stays on one disk.
fn temporary(path: &Path) -> PathBuf {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    path.with_file_name(format!(".{name}.{}.new", std::process::id()))
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

    #[test]
    fn a_folder_in_the_way_is_reported() {
        let folder = tempfile::tempdir().unwrap();
        let error = save(folder.path(), b"1").unwrap_err();
        assert_eq!(error.to_string(), "it is a directory");
    }
}
