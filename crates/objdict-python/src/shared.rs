//! Descriptions that were read, as all objects of Python share them.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock, PoisonError, RwLock};

use objdict::config::Project;
use objdict::format::Description;
use objdict::format::input::{FileKind, of_text, refuse_errors};
use objdict::lint;
use objdict::model::Device;
use objdict::source::SourceFile;
use objdict::workspace::{self, Overrides};

use pyo3::PyResult;

use super::meaning::{ValueMeaning, meanings};
use super::raised;

/// A device with its text.
pub(crate) enum Described {
    Text(Box<Description>),
    /// From the JSON of a device, which has no lines that findings could point to.
    Model(Box<Device>, SourceFile),
}

/// A device as Python holds it: what was read, until values of it are set.
pub(crate) struct SharedDevice(RwLock<Arc<SharedDescription>>);

impl SharedDevice {
    pub(crate) fn new(described: SharedDescription) -> Self {
        Self(RwLock::new(Arc::new(described)))
    }

    /// What is described now.
    pub(crate) fn now(&self) -> Arc<SharedDescription> {
        Arc::clone(&self.0.read().unwrap_or_else(PoisonError::into_inner))
    }

    pub(crate) fn set(&self, described: SharedDescription) {
        *self.0.write().unwrap_or_else(PoisonError::into_inner) = Arc::new(described);
    }
}

/// A description between two changes.
pub(crate) struct SharedDescription {
    pub(crate) described: Described,
    /// The file; `None` of bytes.
    pub(crate) path: Option<PathBuf>,
    pub(crate) node_id: Option<u8>,
    /// How often values were set. The text of a file has none.
    pub(crate) revision: u32,
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

    /// The settings of the nearest configuration; bytes have none.
    pub(crate) fn options(&self) -> lint::Options {
        let overrides = Overrides { node_id: self.node_id, ..Overrides::default() };
        match &self.path {
            Some(path) => overrides.options(path, self.project.as_deref()),
            None => overrides.options(Path::new(""), None),
        }
    }

    /// Refuses a source with errors, of which nothing is made.
    pub(crate) fn refuse_errors(&self) -> PyResult<()> {
        match &self.described {
            Described::Text(description) => {
                // what a program gives may be part of a device, as one that python-canopen has
                let found = match &self.path {
                    Some(_) => workspace::findings(description, &self.options()),
                    None => of_text(description),
                };
                refuse_errors(description, found).map_err(raised)
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
