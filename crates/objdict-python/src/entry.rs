//! Entries: their facts, and what their values mean.

use std::collections::BTreeMap;
use std::sync::Arc;

use objdict::describe::Decoder;
use objdict::model::{self, DataType, Value};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use super::configure::{WantedValues, set};
use super::meaning::ValueMeaning;
use super::shared::{SharedDescription, SharedDevice};
use super::value::{Formula, from_python, name_of, setting_text, to_python};

/// An entry of an object.
#[pyclass(name = "Entry", frozen, module = "canopen_objdict")]
pub(crate) struct PythonEntry {
    pub(crate) device: Arc<SharedDevice>,
    /// The index.
    #[pyo3(get)]
    pub(crate) index: u16,
    /// The sub-index.
    #[pyo3(get)]
    pub(crate) sub: u8,
}

impl PythonEntry {
    /// What the entry is now. Python has an entry only of a device that has it, and no value that is set removes one.
    fn of<T>(&self, read: impl FnOnce(&model::Entry, &SharedDescription) -> T) -> T {
        let shared = self.device.now();
        let entry = shared.device().object(self.index).and_then(|object| object.entry(self.sub));
        read(&entry.unwrap_or_default(), &shared)
    }

    /// A value of the entry.
    fn shown<'py>(
        &self,
        py: Python<'py>,
        value: impl FnOnce(&model::Entry) -> Option<&Value>,
    ) -> PyResult<Option<Bound<'py, PyAny>>> {
        self.of(|entry, shared| {
            value(entry).map(|value| to_python(py, value, entry.implied_type(), shared.node_id)).transpose()
        })
    }

    /// What is meant by its values.
    fn meant<T: Default>(&self, read: impl FnOnce(&ValueMeaning) -> T) -> T {
        self.device.now().meaning(self.index, self.sub).map(read).unwrap_or_default()
    }

    fn type_for_transfer(&self) -> PyResult<DataType> {
        let name = || format!("the entry {:04X}h:{:02X} has no data type", self.index, self.sub);
        self.of(|entry, _| entry.implied_type()).ok_or_else(|| PyValueError::new_err(name()))
    }
}

#[pymethods]
impl PythonEntry {
    /// The name.
    #[getter]
    fn name(&self) -> String {
        self.of(|entry, _| entry.name.to_string())
    }

    /// The data type: `UNSIGNED32`.
    #[getter]
    fn data_type(&self) -> Option<String> {
        self.of(|entry, _| entry.implied_type().map(name_of))
    }

    /// The index of the data type.
    #[getter]
    fn data_type_index(&self) -> Option<u16> {
        self.of(|entry, _| entry.implied_type().map(|data_type| data_type.0))
    }

    /// The number of bits; `None` of texts, domains and structures.
    #[getter]
    fn bit_length(&self) -> Option<u8> {
        self.of(|entry, _| entry.implied_type().and_then(DataType::bit_length))
    }

    /// The access type: `ro`, `wo`, `rw`, `rwr`, `rww` or `const`.
    #[getter]
    fn access(&self) -> Option<&'static str> {
        self.of(|entry, _| entry.implied_access().map(|access| access.name()))
    }

    /// Whether an SDO may read it.
    #[getter]
    fn is_readable(&self) -> bool {
        self.of(|entry, _| entry.implied_access().is_none_or(|access| access.is_readable()))
    }

    /// Whether an SDO may write it.
    #[getter]
    fn is_writable(&self) -> bool {
        self.of(|entry, _| entry.implied_access().is_none_or(|access| access.is_writable()))
    }

    /// The default.
    #[getter]
    fn default<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        self.shown(py, |entry| entry.default.as_ref())
    }

    /// The configured value, else the default.
    #[getter]
    fn value<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        self.shown(py, |entry| entry.value())
    }

    /// Sets the value that the node is configured with.
    #[setter]
    fn set_value(&self, py: Python<'_>, value: &Bound<'_, PyAny>) -> PyResult<()> {
        let setting = (format!("{:04X}:{:X}", self.index, self.sub), setting_text(value)?);
        py.detach(|| set(&self.device, WantedValues::value(setting)))
    }

    /// Whether a DCF configures the value.
    #[getter]
    fn is_configured(&self) -> bool {
        self.of(|entry, _| entry.configured_value().is_some())
    }

    /// The lowest value.
    #[getter]
    fn low_limit<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        self.shown(py, |entry| entry.low_limit.as_ref())
    }

    /// The highest value.
    #[getter]
    fn high_limit<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        self.shown(py, |entry| entry.high_limit.as_ref())
    }

    /// The default as the description states it, where it is the node-ID plus a number.
    #[getter]
    fn formula(&self) -> Option<Formula> {
        self.of(|entry, _| match entry.default {
            Some(Value::NodeId(offset)) => Some(Formula { offset }),
            _ => None,
        })
    }

    /// Whether PDOs may carry it: `no`, `optional`, `default`, `tpdo` or `rpdo`.
    #[getter]
    fn pdo_mapping(&self) -> String {
        self.of(|entry, _| entry.pdo_mapping.unwrap_or_default().name().to_ascii_lowercase())
    }

    /// What the description says of it.
    #[getter]
    fn description(&self) -> Option<String> {
        self.of(|entry, _| description_of(entry))
    }

    /// The name in the application (DCF).
    #[getter]
    fn denotation(&self) -> Option<String> {
        self.of(|entry, _| entry.configured.as_ref()?.denotation.as_deref().map(str::to_owned))
    }

    /// The unit.
    #[getter]
    fn unit(&self) -> Option<String> {
        self.meant(|meaning| meaning.unit.clone())
    }

    /// What the value, with the offset, is multiplied by to be in the unit.
    #[getter]
    fn factor(&self) -> f64 {
        self.meant(|meaning| meaning.factor).unwrap_or(1.0)
    }

    /// What is added to the value before it is multiplied.
    #[getter]
    fn offset(&self) -> f64 {
        self.meant(|meaning| meaning.offset).unwrap_or(0.0)
    }

    /// The names of values.
    #[getter]
    fn value_names(&self) -> BTreeMap<i128, String> {
        self.meant(|meaning| meaning.values.clone())
    }

    /// The names of bits, with the bits that they have.
    #[getter]
    fn bit_names(&self) -> BTreeMap<String, Vec<u16>> {
        self.meant(|meaning| meaning.bits.clone())
    }

    /// The value in the bytes of an SDO transfer.
    fn decode<'py>(&self, py: Python<'py>, data: Vec<u8>) -> PyResult<Bound<'py, PyAny>> {
        let data_type = self.of(|entry, _| entry.implied_type());
        let Some(data_type) = data_type.filter(|data_type| data_type.name().is_some()) else {
            return Ok(PyBytes::new(py, &data).into_any());
        };
        let unfit = || PyValueError::new_err(format!("{} bytes are no {}", data.len(), name_of(data_type)));
        let value = Value::from_bytes(&data, data_type).ok_or_else(unfit)?;
        to_python(py, &value, Some(data_type), None)
    }

    /// The bytes of a value, as an SDO transfers them.
    fn encode<'py>(&self, py: Python<'py>, value: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyBytes>> {
        let data_type = self.type_for_transfer()?;
        let bytes = from_python(value, data_type)?.to_bytes(data_type);
        let unfit = || PyValueError::new_err(format!("{value} is no {}", name_of(data_type)));
        Ok(PyBytes::new(py, &bytes.ok_or_else(unfit)?))
    }

    /// Whether another entry has the same address and the same content.
    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        let Ok(other) = other.cast::<Self>() else { return false };
        let other = other.get();
        let is_same = |entry: &model::Entry| other.of(|there, _| entry == there);
        (self.index, self.sub) == (other.index, other.sub) && self.of(|entry, _| is_same(entry))
    }

    fn __hash__(&self) -> u64 {
        u64::from(self.index) << 8 | u64::from(self.sub)
    }

    fn __repr__(&self) -> String {
        format!("<Entry {:04X}h:{:02X} '{}'>", self.index, self.sub, self.name())
    }

    /// What a value means in words, if it is more than a number; without one, the value of the description.
    #[pyo3(signature = (value=None))]
    fn meaning(&self, value: Option<&Bound<'_, PyAny>>) -> PyResult<Option<String>> {
        let given = value.map(|value| from_python(value, self.type_for_transfer()?)).transpose()?;
        let Some(value) = given.or_else(|| self.of(|entry, _| entry.value().cloned())) else {
            return Ok(None);
        };
        let shared = self.device.now();
        let named = || shared.meaning(self.index, self.sub)?.values.get(&value.as_integer()?).cloned();
        let decoder = Decoder::english(shared.device(), shared.node_id);
        Ok(named().or_else(|| decoder.of(self.index, self.sub, &value)))
    }
}

/// The description in the application process, or that of tools which write one into an EDS.
pub(crate) fn description_of(entry: &model::Entry) -> Option<String> {
    let parameter = entry.parameter.as_ref().and_then(|parameter| parameter.labels.description_in("en"));
    let text = parameter.or_else(|| entry.extra.get("Description"))?.trim();
    (!text.is_empty()).then(|| text.to_owned())
}
