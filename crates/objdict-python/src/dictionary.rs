//! Descriptions that were read, and their objects.

use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};

use objdict::config::Project;
use objdict::format::input::{Input, Reading};
use objdict::format::json;
use objdict::format::patch::Patch;
use objdict::model::{Device, Object, Pdo, PdoKind};
use objdict::source::{SourceFile, SourceOptions};
use objdict::workspace::{Workspace, with_origin_beside};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use super::configure::{WantedValues, set};
use super::entry::PythonEntry;
use super::shared::{Described, SharedDescription, SharedDevice};
use super::value::{NodeId, name_of, setting_text};
use super::{raised, unreadable};

/// A description.
#[pyclass(frozen, name = "Dictionary", module = "canopen_objdict._native")]
pub(crate) struct NativeDictionary(pub(crate) Arc<SharedDevice>);

impl NativeDictionary {
    fn new(described: SharedDescription) -> Self {
        Self(Arc::new(SharedDevice::new(described)))
    }

    /// What is described now.
    pub(crate) fn now(&self) -> Arc<SharedDescription> {
        self.0.now()
    }
}

/// An object of a description.
#[pyclass(frozen, name = "Object", module = "canopen_objdict._native")]
pub(crate) struct NativeObject {
    device: Arc<SharedDevice>,
    /// The index.
    #[pyo3(get)]
    index: u16,
}

/// The configuration that holds for a file, with the profiles and patches that it names.
pub(crate) fn project_of(workspace: &mut Workspace, path: &Path) -> PyResult<Option<Arc<Project>>> {
    let project = workspace.project_of(path).map_err(raised)?;
    match project.as_ref().and_then(|project| project.failures.first()) {
        Some(failure) => Err(raised(failure)),
        None => Ok(project),
    }
}

/// Reads a file, with patches and with those of the nearest configuration.
#[pyfunction]
#[pyo3(signature = (path, node_id=None, device=None, variant=None, patches=Vec::new()))]
pub(crate) fn open(
    py: Python<'_>,
    path: PathBuf,
    node_id: Option<NodeId>,
    device: Option<NonZeroUsize>,
    variant: Option<String>,
    patches: Vec<PathBuf>,
) -> PyResult<NativeDictionary> {
    py.detach(|| {
        let project = project_of(&mut Workspace::default(), &path)?;
        let mut reading = reading(node_id, device, variant, project.as_deref());
        reading.patches.extend(opened(&patches)?);
        let bytes = objdict::source::read(&path, reading.max_size).map_err(unreadable)?;
        one(&reading, &path.display().to_string(), bytes, Some(path), project)
    })
}

/// The node-ID, the number of the device in the file, and the variant.
type ChosenDevice = (Option<NodeId>, Option<NonZeroUsize>, Option<String>);

/// Reads the bytes of a file of this name, with patches; with the path that they were read from, with its configuration.
#[pyfunction]
#[pyo3(signature = (data, name, chosen, patches=Vec::new(), path=None))]
pub(crate) fn read(
    py: Python<'_>,
    data: Vec<u8>,
    name: String,
    chosen: ChosenDevice,
    patches: Vec<PathBuf>,
    path: Option<PathBuf>,
) -> PyResult<NativeDictionary> {
    py.detach(|| {
        let project = match &path {
            Some(path) => project_of(&mut Workspace::default(), path)?,
            None => None,
        };
        let (node_id, device, variant) = chosen;
        let mut reading = reading(node_id, device, variant, None);
        reading.patches = opened(&patches)?;
        one(&reading, &name, data, path, project)
    })
}

fn opened(patches: &[PathBuf]) -> PyResult<Vec<Arc<Patch>>> {
    patches.iter().map(|path| Patch::open(path).map(Arc::new).map_err(unreadable)).collect()
}

/// How a file is read that this configuration is for.
pub(crate) fn reading(
    node_id: Option<NodeId>,
    device: Option<NonZeroUsize>,
    variant: Option<String>,
    project: Option<&Project>,
) -> Reading {
    // its findings can be asked for; what would be made of it is refused
    let mut reading = Reading { judge: None, ..Reading::default() };
    (reading.node_id, reading.device, reading.variant) = (node_id.map(|node| node.0), device, variant);
    reading.patches = project.map(|project| project.patches.clone()).unwrap_or_default();
    reading
}

/// The one device that was asked for.
fn one(
    reading: &Reading,
    name: &str,
    bytes: Vec<u8>,
    path: Option<PathBuf>,
    project: Option<Arc<Project>>,
) -> PyResult<NativeDictionary> {
    let (_, input) = reading.read_one(name, bytes).map_err(raised)?;
    Ok(NativeDictionary::new(described(name, input, path, reading, project)?))
}

/// What was read, where it is a device.
pub(crate) fn described(
    name: &str,
    input: Input,
    path: Option<PathBuf>,
    reading: &Reading,
    project: Option<Arc<Project>>,
) -> PyResult<SharedDescription> {
    let described = match input {
        Input::Description(description) => {
            let description = match &path {
                Some(path) => with_origin_beside(path, *description, &SourceOptions::default()),
                None => *description,
            };
            Described::Text(Box::new(description))
        }
        Input::Device(device) => Described::Model(device, SourceFile::from_text(name, "")),
        _ => {
            return Err(raised(format_args!("`{name}` describes no device")));
        }
    };
    let mut shared = SharedDescription {
        described,
        path,
        node_id: reading.node_id,
        revision: 0,
        project,
        meanings: OnceLock::new(),
    };
    let stated = || shared.device().node_id().filter(|node_id| (1..=127).contains(node_id));
    shared.node_id = shared.node_id.or_else(stated);
    Ok(shared)
}

/// The facts of a PDO: direction, number, COB-ID, whether it is valid, transmission type, inhibit time, event timer and SYNC
/// start value.
type PdoFields =
    (&'static str, u16, Option<u32>, Option<bool>, Option<u8>, Option<u16>, Option<u16>, Option<u8>);

/// An entry in a PDO: index, sub-index and bits.
type MappedBits = (u16, u8, u8);

#[pymethods]
impl NativeDictionary {
    /// The indexes of all objects.
    fn indexes(&self) -> Vec<u16> {
        self.now().device().objects.keys().copied().collect()
    }

    /// The number of objects.
    fn __len__(&self) -> usize {
        self.now().device().objects.len()
    }

    /// Whether there is an object.
    fn has(&self, index: u16) -> bool {
        self.now().device().objects.contains_key(&index)
    }

    /// An object.
    fn object(&self, index: u16) -> Option<NativeObject> {
        self.has(index).then(|| NativeObject { device: Arc::clone(&self.0), index })
    }

    /// The names of all objects with their indexes, in their order.
    fn names(&self) -> Vec<(String, u16)> {
        let shared = self.now();
        let objects = shared.device().objects.iter();
        objects.map(|(&index, object)| (object.name().to_owned(), index)).collect()
    }

    /// The PDOs: RPDOs first.
    fn pdos(&self) -> Vec<(PdoFields, Vec<MappedBits>)> {
        let shared = self.now();
        shared.device().pdos().map(|pdo| row(&pdo, shared.node_id)).collect()
    }

    /// The name of the file.
    #[getter]
    fn name(&self) -> String {
        self.now().source().name().to_owned()
    }

    /// The file; `None` of bytes.
    #[getter]
    fn path(&self) -> Option<PathBuf> {
        self.now().path.clone()
    }

    /// The format: `EDS`, `DCF`, `XDD`, `XDC`, `device.toml` or `JSON`.
    #[getter]
    fn format(&self) -> &'static str {
        self.now().kind().name()
    }

    /// The node-ID that was given, or that the description has.
    #[getter]
    fn node_id(&self) -> Option<u8> {
        self.now().node_id
    }

    /// Sets values, those of a file of settings first: all of them, or none.
    #[pyo3(signature = (settings, file=None, node_id=None, bit_rate=None))]
    fn configure(
        &self,
        py: Python<'_>,
        settings: Vec<(String, Bound<'_, PyAny>)>,
        file: Option<PathBuf>,
        node_id: Option<NodeId>,
        bit_rate: Option<u16>,
    ) -> PyResult<()> {
        let settings = settings.iter().map(|(name, value)| Ok((name.clone(), setting_text(value)?)));
        let settings = settings.collect::<PyResult<_>>()?;
        let wanted = WantedValues::new(settings, file, node_id.map(|node| node.0), bit_rate);
        py.detach(|| set(&self.0, wanted))
    }

    /// How often values were set.
    #[getter]
    fn revision(&self) -> u32 {
        self.now().revision
    }

    /// The number of the device profile.
    #[getter]
    fn profile(&self) -> Option<u16> {
        self.now().device().profile()
    }

    /// The bit rates in kbit/s.
    #[getter]
    fn bit_rates(&self) -> Vec<u16> {
        let shared = self.now();
        let info = shared.device().device_info.as_ref();
        info.map(|info| info.baud_rates.supported().collect()).unwrap_or_default()
    }

    /// The whole model as JSON.
    fn json(&self, py: Python<'_>) -> String {
        py.detach(|| json::write_device(self.now().whole()))
    }

    /// File, device and node of the model as JSON, without the objects.
    fn facts(&self, py: Python<'_>) -> String {
        let shared = self.now();
        let device = shared.device();
        let facts = Device {
            kind: device.kind,
            file_info: device.file_info.clone(),
            device_info: device.device_info.clone(),
            commissioning: device.commissioning.clone(),
            comments: device.comments.clone(),
            dummy_usage: device.dummy_usage.clone(),
            ..Device::default()
        };
        py.detach(|| json::write_device(&facts))
    }

    /// Whether another device is the same, for the same node, in a file of any name.
    fn is_same(&self, py: Python<'_>, other: &Self) -> bool {
        let unnamed = |shared: &SharedDescription| {
            let mut device = shared.whole().clone();
            device.file_info.iter_mut().for_each(|info| info.file_name = None);
            device
        };
        let (one, other) = (self.now(), other.now());
        py.detach(|| one.node_id == other.node_id && unnamed(&one) == unnamed(&other))
    }

    /// What a copy is read of: bytes, the number of the device in them, and the variant; the JSON of a device whose text is not all
    /// that describes it.
    fn copied<'py>(&self, py: Python<'py>) -> (Bound<'py, PyBytes>, Option<usize>, Option<String>) {
        let shared = self.now();
        match &shared.described {
            Described::Text(text) if !text.is_composed() && text.patched().is_none() => {
                let number = (text.device_count() > 1).then(|| text.number() + 1);
                let variant = text.variant().map(str::to_owned);
                (PyBytes::new(py, &shared.source().to_bytes()), number, variant)
            }
            _ => (PyBytes::new(py, json::write_device(shared.whole()).as_bytes()), None, None),
        }
    }

    /// The bytes that were read.
    fn source<'py>(&self, py: Python<'py>) -> Bound<'py, PyBytes> {
        PyBytes::new(py, &self.now().source().to_bytes())
    }
}

fn row(pdo: &Pdo<'_>, node_id: Option<u8>) -> (PdoFields, Vec<MappedBits>) {
    let kind = match pdo.kind {
        PdoKind::Rpdo => "rpdo",
        PdoKind::Tpdo => "tpdo",
    };
    let is_known = |cob_id: &objdict::model::CobId| node_id.is_some() || !cob_id.depends_on_node_id();
    let cob_id = pdo.cob_id.filter(is_known).map(|cob_id| cob_id.on_node(node_id.unwrap_or_default()));
    let mapped = pdo.mapped().map(|mapped| (mapped.index, mapped.sub, mapped.bits)).collect();
    let Pdo { number, transmission_type, inhibit_time, event_timer, sync_start_value, .. } = *pdo;
    let is_valid = pdo.is_valid();
    ((kind, number, cob_id, is_valid, transmission_type, inhibit_time, event_timer, sync_start_value), mapped)
}

#[pymethods]
impl NativeObject {
    /// The name.
    #[getter]
    fn name(&self) -> String {
        self.of(|object| object.name().to_owned())
    }

    /// The object type: `VAR`, `ARRAY`, `RECORD` …
    #[getter]
    fn object_type(&self) -> &'static str {
        self.of(|object| object.object_type().name())
    }

    /// The data type that the object itself states.
    #[getter]
    fn data_type(&self) -> Option<String> {
        self.of(|object| object.main.data_type.map(name_of))
    }

    /// What the description says of it.
    #[getter]
    fn description(&self) -> Option<String> {
        self.of(|object| super::entry::description_of(&object.main))
    }

    /// The sub-indexes of its entries.
    fn subs(&self) -> Vec<u8> {
        self.of(|object| object.entries().map(|(sub, _)| sub).collect())
    }

    /// Whether there is an entry.
    fn has(&self, sub: u8) -> bool {
        self.of(|object| object.has(sub))
    }

    /// An entry.
    fn entry(&self, sub: u8) -> Option<PythonEntry> {
        self.has(sub).then(|| PythonEntry { device: Arc::clone(&self.device), index: self.index, sub })
    }

    /// The names of all entries with their sub-indexes, in their order.
    fn names(&self) -> Vec<(String, u8)> {
        self.of(|object| object.entries().map(|(sub, entry)| (entry.name.to_string(), sub)).collect())
    }
}

impl NativeObject {
    /// What the object is now. Python has an object only of an index that the device has, and no value that is set removes one.
    fn of<T>(&self, read: impl FnOnce(&Object) -> T) -> T {
        let shared = self.device.now();
        read(shared.device().object(self.index).unwrap_or(&Object::default()))
    }
}
