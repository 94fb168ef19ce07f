//! Files that a command writes, none of which takes the place of one that it reads.

use std::collections::HashSet;
use std::path::Path;
use std::sync::{Mutex, Once, PoisonError};

use super::Failure;
use crate::pipeline;
pub(super) use crate::pipeline::Saved;

/// The files that this run reads or has written.
static KNOWN: Mutex<Option<HashSet<Identity>>> = Mutex::new(None);

/// What a file is, whatever it is called: its device and its number there, or its full path where files have no numbers.
#[cfg(unix)]
type Identity = (u64, u64);
#[cfg(not(unix))]
type Identity = std::path::PathBuf;

/// `None` for what does not exist, and for pipes and devices: writing to these takes nothing away.
#[cfg(unix)]
fn identity(path: &Path) -> Option<Identity> {
    use std::os::unix::fs::MetadataExt;
    path.metadata().ok().filter(std::fs::Metadata::is_file).map(|file| (file.dev(), file.ino()))
}

#[cfg(not(unix))]
fn identity(path: &Path) -> Option<Identity> {
    path.canonicalize().ok().filter(|path| path.is_file())
}

/// Notes that this run uses a file, so that nothing is written over it.
pub(super) fn keep(path: &Path) {
    if let Some(identity) = identity(path) {
        KNOWN.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert_default().insert(identity);
    }
}

/// Gives the file at `path` its contents: all of them or, when something fails, none. Folders are made.
///
/// # Errors
/// When it cannot be written, or is a file that this run reads or has written.
pub(super) fn save(path: &Path, contents: &[u8]) -> Result<Saved, Failure> {
    require_other(path)?;
    let saved = save_in_place(path, contents)?;
    keep(path);
    Ok(saved)
}

/// The same for a file that is changed by what is read from it.
pub(super) fn save_in_place(path: &Path, contents: &[u8]) -> Result<Saved, Failure> {
    static SIGNALS: Once = Once::new();
    SIGNALS.call_once(|| {
        // without it, a temporary file may be left when the command is interrupted
        let _ = ctrlc::set_handler(|| pipeline::abandon(|| std::process::exit(130)));
    });
    pipeline::save(path, contents)
        .map_err(|error| Failure::new(format_args!("cannot write `{}`: {error}", path.display())))
}

/// Refuses an output that is a file which this run reads or has written.
pub(super) fn require_other(path: &Path) -> Result<(), Failure> {
    let known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    match (&*known, identity(path)) {
        (Some(known), Some(identity)) if known.contains(&identity) => {
            let message = format_args!("`{}` is another input or output of this run", path.display());
            Err(Failure::new(message).help("name another file for the output"))
        }
        _ => Ok(()),
    }
}

/// Whether an output is the standard output.
pub(super) fn is_stdout(path: &Path) -> bool {
    path == Path::new("-") || path == Path::new("/dev/stdout")
}

/// Whether an output is a folder: one that exists, or a name that ends like one.
pub(super) fn is_folder(path: &Path) -> bool {
    path.is_dir() || path.to_string_lossy().ends_with(['/', std::path::MAIN_SEPARATOR])
}
