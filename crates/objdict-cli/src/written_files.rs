//! Files that a command writes, none of which takes the place of one that it reads.

use std::path::Path;
use std::sync::{Mutex, MutexGuard, Once, PoisonError};

use super::ending::Failure;
use objdict_build::pipeline;
pub(crate) use objdict_build::pipeline::Saved;
pub(crate) use objdict_build::pipeline::{OutputError, OutputFolder, Used};

/// The files that this run reads or has written.
static USED: Mutex<Option<Used>> = Mutex::new(None);

fn with_used<T>(act: impl FnOnce(&mut Used) -> Result<T, OutputError>) -> Result<T, Failure> {
    let mut used: MutexGuard<'_, Option<Used>> = USED.lock().unwrap_or_else(PoisonError::into_inner);
    Ok(act(used.get_or_insert_default())?)
}

/// Notes that this run uses a file, so that nothing is written over it.
pub(super) fn keep(path: &Path) {
    let _ = with_used(|used| {
        used.add(path);
        Ok(())
    });
}

/// Gives the file at `path`, which an argument names, its contents: all of them or, when something fails, none. Folders are
/// made.
///
/// # Errors
/// When it cannot be written, or is a file that this run reads or has written.
pub(super) fn save(path: &Path, contents: &[u8]) -> Result<Saved, Failure> {
    end_well();
    with_used(|used| used.save(path, contents))
}

/// A file with what only the user may know, as long as it is needed.
pub(super) fn private(name: &str, contents: &[u8]) -> std::io::Result<pipeline::PrivateFile> {
    end_well();
    pipeline::PrivateFile::new(name, contents)
}

/// The same for a file that is changed by what is read from it.
pub(super) fn save_in_place(path: &Path, contents: &[u8]) -> Result<Saved, Failure> {
    end_well();
    pipeline::save(path, contents)
        .map_err(|error| OutputError::Unwritable { path: path.to_owned(), error }.into())
}

/// Leaves no temporary file when the command is interrupted, or reaches the limit of the system for the size of a file.
fn end_well() {
    #[cfg(unix)]
    {
        use nix::sys::signal::{SigSet, Signal};
        // of this thread, which writes: it gets an error instead
        let _ = SigSet::from(Signal::SIGXFSZ).thread_block();
    }
    SIGNALS.call_once(|| {
        let _ = ctrlc::set_handler(abandon);
    });
}

/// Whether the handler of interrupts is set.
static SIGNALS: Once = Once::new();

fn abandon() {
    pipeline::abandon(|| std::process::exit(130));
}

/// Sets a flag at the first interrupt, so that the command ends what it has begun; the second one ends it at once.
#[cfg(feature = "bus")]
pub(super) fn end_orderly(is_interrupted: &'static std::sync::atomic::AtomicBool) {
    SIGNALS.call_once(|| {
        let _ = ctrlc::set_handler(|| {
            if is_interrupted.swap(true, std::sync::atomic::Ordering::Relaxed) {
                abandon();
            }
        });
    });
}

/// Refuses an output that is a file which this run reads or has written.
pub(super) fn require_other(path: &Path) -> Result<(), Failure> {
    with_used(|used| used.require_other(path))
}

// What is replaced in a folder.
#[derive(Clone, Copy, Debug, Default, clap::Args)]
pub(super) struct OverwriteArgs {
    /// Also replace files in the folder that objdict did not create or that differ from their hash in `objdict.sha256`
    #[arg(long)]
    pub overwrite: bool,
}

/// A folder that a command writes into, where only what objdict wrote is replaced.
pub(super) struct SaveFolder(OutputFolder);

impl SaveFolder {
    /// The folder at `path`; `origin` is the command.
    pub(super) fn open(path: &Path, origin: &str, args: &OverwriteArgs) -> Result<Self, Failure> {
        Ok(Self(OutputFolder::open(path, origin, args.overwrite)?))
    }

    /// Refuses a file that must not be written.
    pub(super) fn admit(&self, name: &str, contents: &[u8]) -> Result<(), Failure> {
        with_used(|used| self.0.admit(name, contents, used))
    }

    /// As [`save`], for a file in the folder.
    pub(super) fn save(&mut self, name: &str, contents: &[u8]) -> Result<Saved, Failure> {
        end_well();
        with_used(|used| self.0.save(name, contents, used))
    }

    /// Writes all files or none, and returns the names of those of earlier runs; see [`OutputFolder::replace`].
    pub(super) fn replace(self, files: &[(&str, &[u8])]) -> Result<Vec<String>, Failure> {
        end_well();
        with_used(|used| self.0.replace(files, used))
    }

    /// Puts all files in their places, or none.
    pub(super) fn finish(self) -> Result<(), Failure> {
        with_used(|used| self.0.finish(used))
    }
}

impl From<OutputError> for Failure {
    fn from(error: OutputError) -> Self {
        Self::new(&error).maybe_help(error.help("--overwrite"))
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
