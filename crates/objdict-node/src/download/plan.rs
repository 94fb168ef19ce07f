//! A plan: ordered downloads, and its options.

use std::collections::BTreeSet;

use super::{ConciseDcf, Download, Skipped};

/// Options of a plan.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct PlanOptions {
    /// The node-ID for formulas such as `$NODEID+0x180`; `None` uses the commissioned node-ID of the
    /// description.
    pub node_id: Option<u8>,
    /// The written entries.
    pub scope: Scope,
    /// The order of the downloads.
    pub order: Order,
    /// The objects whose values are written; `None` for all.
    pub only: Option<BTreeSet<u16>>,
    /// Whether to write configured values to entries that start an action, such as 1010h (store).
    pub commands: bool,
}

/// The entries that a plan writes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Scope {
    /// Entries with a configured value that differs from the default.
    #[default]
    Changed,
    /// As above, and every parameter and mapping of every PDO.
    Pdos,
    /// All writable entries that have a value.
    All,
}

/// The order of the downloads of a plan.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Order {
    /// The order that a node accepts by CiA 301.
    #[default]
    Safe,
    /// The order of dcfgen of lely-core: services, RPDOs, TPDOs, all other entries. A PDO gets its new CAN-ID
    /// while it is valid, which some nodes reject.
    Dcfgen,
}

/// The downloads of a node in order, and the skipped entries.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Plan {
    /// The downloads.
    pub steps: Vec<Step>,
    /// Entries with a configured value that is not written.
    pub skipped: Vec<Skipped>,
}

/// One download of a plan.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Step {
    /// A download whose bytes are known.
    Write(Download),
    /// A download with data in a file.
    File(NeededFile),
}

/// A DOMAIN with data in a file (`DownloadFile`, CiA 306-1 §5.3).
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct NeededFile {
    /// Index of the object.
    pub index: u16,
    /// Sub-index of the entry.
    pub sub: u8,
    /// The file name in the description.
    pub name: Box<str>,
}

impl Plan {
    /// The files whose data the plan needs.
    pub fn files(&self) -> impl Iterator<Item = &NeededFile> {
        self.steps.iter().filter_map(|step| match step {
            Step::File(file) => Some(file),
            Step::Write(_) => None,
        })
    }

    /// The concise DCF without the downloads whose data is in files.
    pub fn without_files(self) -> ConciseDcf {
        let downloads = self.steps.into_iter().filter_map(|step| match step {
            Step::Write(download) => Some(download),
            Step::File(_) => None,
        });
        ConciseDcf(downloads.collect())
    }

    /// Creates the concise DCF; `read` supplies the data of each file.
    ///
    /// # Errors
    /// Returns the first error of `read`.
    pub fn into_concise<E>(
        self,
        mut read: impl FnMut(&NeededFile) -> Result<Vec<u8>, E>,
    ) -> Result<ConciseDcf, E> {
        let download = |step| match step {
            Step::Write(download) => Ok(download),
            Step::File(file) => read(&file).map(|data| Download::new(file.index, file.sub, data)),
        };
        self.steps.into_iter().map(download).collect::<Result<_, E>>().map(ConciseDcf)
    }
}
