//! Files that a command writes.

use std::path::Path;

use super::Failure;
pub(super) use crate::pipeline::Saved;

/// Gives the file at `path` its contents: all of them or, when something fails, none. Folders are made.
pub(super) fn save(path: &Path, contents: &[u8]) -> Result<Saved, Failure> {
    crate::pipeline::save(path, contents)
        .map_err(|error| Failure::new(format_args!("cannot write `{}`: {error}", path.display())))
}

/// Whether an output is a folder: one that exists, or a name that ends like one.
pub(super) fn is_folder(path: &Path) -> bool {
    path.is_dir() || path.to_string_lossy().ends_with(['/', std::path::MAIN_SEPARATOR])
}
