//! Descriptions that were read, as all objects of Python share them.

use std::collections::HashMap;
use std::path::PathBuf;
use std::sync::{Arc, OnceLock};

use objdict::config::Project;
use objdict::format::Description;
use objdict::format::input::{FileKind, refuse_errors};
use objdict::model::Device;
use objdict::source::SourceFile;
use objdict::workspace;

use pyo3::PyResult;

use super::findings::options;
use super::meaning::{ValueMeaning, meanings};
use super::raised;

/// A device with its text.
pub(crate) enum Described {
    Text(Box<Description>),
    /// From the JSON of a device, which has no lines that findings could point to.
    Model(Box<Device>, SourceFile),
}

/// What a description says, shared by all that Python has of it.
pub(crate) struct SharedDescription {
    pub(crate) described: Described,
    /// The file; `None` of bytes.
    pub(crate) path: Option<PathBuf>,
    pub(crate) node_id: Option<u8>,
    /// The nearest configuration of the file.
    pub(crate) project: Option<Arc<Project>>,
    pub(crate) meanings: OnceLock<HashMap<(u16, u8), ValueMeaning>>,
}

impl SharedDescription {
    pub(crate) fn device(&self) -> &Device {
        match &self.described {
            Described::Text(description) => description.device(),
            Described::Model(device, _) => device,
        }
    }

    /// All that is described, disabled objects too, for what is written.
    pub(crate) fn whole(&self) -> &Device {
        match &self.described {
            Described::Text(description) => description.described(),
            Described::Model(device, _) => device,
        }
    }

    /// Refuses a source with errors, of which nothing is made.
    pub(crate) fn refuse_errors(&self) -> PyResult<()> {
        match &self.described {
            Described::Text(description) => {
                refuse_errors(description, workspace::findings(description, &options(self))).map_err(raised)
            }
            Described::Model(..) => Ok(()),
        }
    }

    pub(crate) fn source(&self) -> &SourceFile {
        match &self.described {
            Described::Text(description) => description.source(),
            Described::Model(_, source) => source,
        }
    }

    pub(crate) fn kind(&self) -> FileKind {
        match &self.described {
            Described::Text(description) => description.format().into(),
            Described::Model(..) => FileKind::Json,
        }
    }

    /// Units and names of values, which are looked for in the whole description at once.
    pub(crate) fn meaning(&self, index: u16, sub: u8) -> Option<&ValueMeaning> {
        self.meanings.get_or_init(|| meanings(self.device())).get(&(index, sub))
    }
}
