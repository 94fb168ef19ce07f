//! The patches that are named with `--patch`.

use std::path::Path;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use super::ending::{Failure, note};
use super::written_files::keep;
use objdict_format::patch::Patch;
use objdict_model::diagnostic::one_line;

// The argument `--patch`.
#[derive(Clone, Debug, Default, clap::Args)]
#[command(next_help_heading = "Input")]
pub(super) struct PatchArgs {
    /// Patch for the descriptions that it matches (docs/guides/patches.md); repeatable
    #[arg(short = 'p', long = "patch", value_name = "FILE", value_parser = open)]
    pub patches: Vec<Arc<Patch>>,
}

impl PatchArgs {
    /// Refuses patches where the file itself would be written with them.
    pub(super) fn none_with(&self, option: &str) -> Result<(), Failure> {
        if self.patches.is_empty() {
            return Ok(());
        }
        let failure = Failure::new(format_args!("{option} changes the file, but `--patch` does not"));
        Err(failure.help("write the patched file with `objdict patch apply`, and use that"))
    }
}

/// The patches of the run, and whether an argument names them.
static KNOWN: Mutex<Vec<(Arc<Patch>, bool)>> = Mutex::new(Vec::new());

fn open(path: &str) -> Result<Arc<Patch>, String> {
    keep(Path::new(path));
    let patch = Patch::open(Path::new(path)).map(Arc::new).map_err(|error| error.to_string())?;
    known().push((Arc::clone(&patch), true));
    Ok(patch)
}

/// Patches that a configuration names.
pub(super) fn remember(patches: &[Arc<Patch>]) {
    known().extend(patches.iter().map(|patch| (Arc::clone(patch), false)));
}

fn known() -> MutexGuard<'static, Vec<(Arc<Patch>, bool)>> {
    KNOWN.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Names the patches of arguments that are for no file of the run.
pub(super) fn warn_of_unused() {
    for (patch, _) in known().iter().filter(|(patch, is_named)| *is_named && !patch.is_used()) {
        let name = one_line(patch.source().name());
        note(&format!(
            "warning: the patch `{name}` applies to none of the files\n  help: compare its `vendor-id`, `product-code` and `revision` with the files\n"
        ));
    }
}

/// Reports the changes without effect, each once although several nodes may be of one file.
pub(super) fn warn_of_effects() {
    for line in known().iter().flat_map(|(patch, _)| patch.warnings()) {
        note(&format!("{}\n", one_line(&line)));
    }
}
