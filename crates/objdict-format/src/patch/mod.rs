//! Patches: corrections of description files that belong to others (docs/guides/patches.md).
//!
//! `Reading` applies patches to every description that it opens, so commands and build scripts share one entry
//! point. A patched description keeps the text of its file and thus the line numbers of findings; a label
//! `At::Patch` points to the cause.
//!
//! A patch changes values of the model by address, and states the expected old ones. The text of the file is edited
//! where it differs ([`Description::realised`](super::Description)), so one patch works for all formats.

mod apply;
mod edit;
mod fields;
mod keys;
mod make;
mod patched;
mod read;
pub mod schema;
mod words;

use std::collections::BTreeSet;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

pub use self::apply::apply;
pub(super) use self::edit::edited;
pub use self::make::make;
pub use self::patched::Patched;
pub(super) use self::read::RULES;
use crate::compare::DatumChange;
use objdict_keyed::tree::KeyedTree;
use objdict_model::diagnostic::{Findings, Text};
use objdict_model::model::{Address, Device, Part};
use objdict_model::source::{Said, SourceError, SourceFile, SourceOptions, Span};

/// The maximum size of a patch, which may contain whole objects.
const MAX_SIZE: u64 = 16 << 20;

/// A patch of description files.
#[derive(Debug)]
pub struct Patch {
    source: SourceFile,
    /// Its purpose.
    pub title: Option<String>,
    selector: Selector,
    changes: Vec<PatchChange>,
    findings: Findings,
    /// Whether it was for a description.
    is_used: AtomicBool,
    /// Warnings of its applications so far.
    warnings: Mutex<BTreeSet<String>>,
}

/// The files that a patch selects; missing conditions select all.
#[derive(Clone, Debug, Default)]
struct Selector {
    vendor_id: Option<u32>,
    product_code: Option<u32>,
    revision: Option<u32>,
    sha256: Option<Said<String>>,
}

/// A change of a description.
#[derive(Clone, Debug)]
struct PatchChange {
    /// The table in the patch.
    span: Span,
    what: ChangedPart,
    reason: Option<String>,
    source: Option<String>,
}

/// The target of a change.
#[derive(Clone, Debug)]
enum ChangedPart {
    /// Fields of a part, or the part itself, by keyword.
    Words(ChangeWords),
    /// A value of the model, with its current value.
    Raw(DatumChange),
}

/// A change by keywords.
#[derive(Clone, Debug)]
struct ChangeWords {
    part: Part,
    expect: Vec<Worded>,
    absent: Vec<Said<String>>,
    set: Vec<Worded>,
    unset: Vec<Said<String>>,
    add: Option<Vec<Worded>>,
    is_removed: bool,
    rename: Option<Said<Address>>,
}

impl ChangeWords {
    /// No change of a part yet.
    fn of(part: Part) -> Self {
        let (expect, absent, set, unset) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        Self { part, expect, absent, set, unset, add: None, is_removed: false, rename: None }
    }
}

/// A field by its keyword, and its value.
#[derive(Clone, Debug)]
struct Worded {
    word: String,
    value: KeyedTree,
}

impl Patch {
    /// Reads the file at `path`.
    ///
    /// # Errors
    /// If it cannot be opened. Errors in it are [findings](Self::findings).
    pub fn open(path: &Path) -> Result<Self, SourceError> {
        let options = SourceOptions { encoding: None, max_size: MAX_SIZE };
        Ok(Self::read(SourceFile::open(path, &options)?))
    }

    /// Reads a text.
    pub fn read(source: SourceFile) -> Self {
        read::read(source)
    }

    /// The text.
    pub fn source(&self) -> &SourceFile {
        &self.source
    }

    /// Whether it was [for](Self::selects) a description so far.
    pub fn is_used(&self) -> bool {
        self.is_used.load(Ordering::Relaxed)
    }

    /// Warnings of its applications so far, such as changes without effect: one line each, as in [`Patched::lines`].
    pub fn warnings(&self) -> Vec<String> {
        self.warnings.lock().unwrap_or_else(PoisonError::into_inner).iter().cloned().collect()
    }

    fn warn(&self, lines: Vec<String>) {
        self.warnings.lock().unwrap_or_else(PoisonError::into_inner).extend(lines);
    }

    /// Errors in the patch itself.
    pub fn findings(&self) -> &Findings {
        &self.findings
    }

    /// The reasons for the changes, each once: reason and source.
    pub fn reasons(&self) -> Vec<(Option<&str>, Option<&str>)> {
        let reasons = self.changes.iter().map(|change| (change.reason.as_deref(), change.source.as_deref()));
        let mut reasons: Vec<_> = reasons.filter(|reason| *reason != (None, None)).collect();
        reasons.dedup();
        reasons
    }

    /// How many changes it has.
    pub fn len(&self) -> usize {
        self.changes.len()
    }

    /// Whether it changes nothing.
    pub fn is_empty(&self) -> bool {
        self.changes.is_empty()
    }

    /// Whether it applies to a device: vendor-ID, product code and revision number match those in the patch.
    pub fn selects(&self, device: &Device) -> bool {
        let identity = device.identity();
        let info = device.device_info.as_ref();
        let is = |wanted: Option<u32>, object: Option<u32>, info: Option<u32>| {
            wanted.is_none() || wanted == object.filter(|&number| number != 0 || info.is_none()).or(info)
        };
        let Selector { vendor_id, product_code, revision, .. } = self.selector;
        is(vendor_id, identity.vendor_id, info.and_then(|info| info.vendor_number))
            && is(product_code, identity.product_code, info.and_then(|info| info.product_number))
            && is(revision, identity.revision_number, info.and_then(|info| info.revision_number))
    }
}

/// The patches that apply to a device.
pub fn selected(patches: &[Arc<Patch>], device: &Device) -> Vec<Arc<Patch>> {
    let selected: Vec<Arc<Patch>> = patches.iter().filter(|patch| patch.selects(device)).cloned().collect();
    selected.iter().for_each(|patch| patch.is_used.store(true, Ordering::Relaxed));
    selected
}

/// The problem of an address.
fn no_part(text: &str) -> Text {
    objdict_model::diagnostic::say!(
        "`{}` is not an object, an entry, `file`, `device` or `commissioning`",
        text
    )
}
