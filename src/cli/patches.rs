//! The patches that are named with `--patch`.

use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

use super::outcome::{Failure, note};
use super::save::keep;
use crate::diagnostic::one_line;
use crate::format::patch::Patch;

// The argument `--patch`.
#[derive(Clone, Debug, Default, clap::Args)]
#[command(next_help_heading = "Input")]
pub(super) struct PatchArgs {
    /// Apply this patch to the descriptions that it is for (docs/patches.md); repeatable
    #[arg(short = 'p', long = "patch", value_name = "FILE", value_parser = open)]
    pub patches: Vec<Arc<Patch>>,
}

impl PatchArgs {
    /// Refuses patches where the file itself would be written with them.
    pub(super) fn none_with(&self, option: &str) -> Result<(), Failure> {
        if self.patches.is_empty() {
            return Ok(());
        }
        let failure =
            Failure::new(format_args!("{option} changes the file itself, and `--patch` leaves it as it is"));
        Err(failure.help("write the patched file with `objdict patch apply`, and use that"))
    }
}

/// The patches that arguments name.
static NAMED: Mutex<Vec<Arc<Patch>>> = Mutex::new(Vec::new());

fn open(path: &str) -> Result<Arc<Patch>, String> {
    keep(Path::new(path));
    let patch = Patch::open(Path::new(path)).map(Arc::new).map_err(|error| error.to_string())?;
    NAMED.lock().unwrap_or_else(PoisonError::into_inner).push(Arc::clone(&patch));
    Ok(patch)
}

/// Names the patches that are for no file of the run.
pub(super) fn warn_of_unused() {
    for patch in NAMED.lock().unwrap_or_else(PoisonError::into_inner).iter().filter(|patch| !patch.is_used())
    {
        let name = one_line(patch.source().name());
        note(&format!(
            "warning: the patch `{name}` is for none of the files\n  help: compare its `vendor-id`, `product-code` and `revision` with those of the files\n"
        ));
    }
}
