//! The plan: what to write into a node, in which order.

use super::order::arrange;
use super::settings::Settings;
use super::{ConciseDcf, Download, PlanError, Skipped};
use crate::model::Device;

/// What a plan is for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PlanOptions {
    /// The node that formulas such as `$NODEID+0x180` are evaluated for; without one, that of the description's
    /// commissioning.
    pub node_id: Option<u8>,
    /// Which entries are written.
    pub scope: Scope,
    /// Whether entries whose write starts an action, such as 1010h (store), are written where the description
    /// configures a value for them.
    pub commands: bool,
}

/// Which entries a plan writes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Scope {
    /// Those whose configured value differs from the default.
    #[default]
    Changed,
    /// All that can be written and have a value.
    All,
}

/// What to write into a node, in order, and what is left out.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Plan {
    /// The downloads.
    pub steps: Vec<Step>,
    /// Entries that have a configured value and are not written.
    pub skipped: Vec<Skipped>,
}

/// One download of a plan.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Step {
    /// A download whose bytes are known.
    Write(Download),
    /// A download whose bytes are in a file.
    File(NeededFile),
}

/// A DOMAIN whose data are in a file (`DownloadFile`, CiA 306-1 §5.3).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NeededFile {
    /// Index of the object.
    pub index: u16,
    /// Sub-index of the entry.
    pub sub: u8,
    /// The name of the file, as the description has it.
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

    /// The configuration; `read` gets the data of each file.
    ///
    /// # Errors
    /// The first error of `read`.
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

impl ConciseDcf {
    /// What must be written into a node so that it is configured as `device` describes.
    ///
    /// A node is taken to have its defaults. Values are those of the description: what is configured, else the default.
    /// Read-only entries, commands, and entries that refuse a download are left out; if the description configures one of
    /// them, the plan says so. Communication objects are switched off by the identifier that they have, changed, and
    /// switched on again (CiA 301 §7.5.2).
    ///
    /// # Errors
    /// Every entry whose value is unknown, does not fit its data type or its limits, or needs a node-ID that is not there.
    pub fn plan(device: &Device, options: &PlanOptions) -> Result<Plan, PlanError> {
        if let Some(node_id) = options.node_id.filter(|node_id| !(1..=127).contains(node_id)) {
            return Err(PlanError::NodeId(node_id));
        }
        let compact = device.objects.iter().filter(|(_, object)| object.compact.is_some());
        let expanded = compact.map(|(&index, object)| (index, object.expanded().into_owned())).collect();
        let mut settings = Settings::collect(device, &expanded, options);
        let steps = arrange(&mut settings);
        settings.finish(steps)
    }
}
