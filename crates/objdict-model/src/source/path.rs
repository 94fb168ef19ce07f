//! Paths as the file system has them.

use std::path::{Component, Path, PathBuf};

/// A path from the root without `.` and `..`. Links are not followed.
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
