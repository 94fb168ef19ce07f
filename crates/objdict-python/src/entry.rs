//! Entries: their facts, and what their values mean.

use std::collections::BTreeMap;
use std::sync::Arc;

use objdict::describe::Decoder;
use objdict::model::{self, DataType, Value};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use super::meaning::ValueMeaning;
use super::shared::SharedDescription;
use super::value::{Formula, from_python, name_of, to_python};

/// An entry of an object.
#[pyclass(name = "Entry", frozen, module = "canopen_objdict")]
pub(crate) struct PythonEntry {
    pub(crate) shared: Arc<SharedDescription>,
    /// The index.
    #[pyo3(get)]
    pub(crate) index: u16,
    /// The sub-index.
    #[pyo3(get)]
    pub(crate) sub: u8,
    pub(crate) entry: model::Entry,
}

impl PythonEntry {
    fn shown<'py>(&self, py: Python<'py>, value: Option<&Value>) -> PyResult<Option<Bound<'py, PyAny>>> {
        value.map(|value| to_python(py, value, self.entry.implied_type(), self.shared.node_id)).transpose()
    }

    fn meaning_of_values(&self) -> Option<&ValueMeaning> {
        self.shared.meaning(self.index, self.sub)
    }

    fn type_for_transfer(&self) -> PyResult<DataType> {
        let name = || format!("the entry {:04X}h:{:02X} has no data type", self.index, self.sub);
        self.entry.implied_type().ok_or_else(|| PyValueError::new_err(name()))
    }
}

#[pymethods]
impl PythonEntry {
    /// The name.
    #[getter]
    fn name(&self) -> &str {
        &self.entry.name
    }

    /// The data type: `UNSIGNED32`.
    #[getter]
    fn data_type(&self) -> Option<String> {
        self.entry.implied_type().map(name_of)
    }

    /// The index of the data type.
    #[getter]
    fn data_type_index(&self) -> Option<u16> {
        self.entry.implied_type().map(|data_type| data_type.0)
    }

    /// The number of bits; `None` of texts, domains and structures.
    #[getter]
    fn bit_length(&self) -> Option<u8> {
        self.entry.implied_type().and_then(DataType::bit_length)
    }

    /// The access type: `ro`, `wo`, `rw`, `rwr`, `rww` or `const`.
    #[getter]
    fn access(&self) -> Option<&'static str> {
        self.entry.implied_access().map(|access| access.name())
    }

    /// Whether an SDO may read it.
    #[getter]
    fn is_readable(&self) -> bool {
        self.entry.implied_access().is_none_or(|access| access.is_readable())
    }

    /// Whether an SDO may write it.
    #[getter]
    fn is_writable(&self) -> bool {
        self.entry.implied_access().is_none_or(|access| access.is_writable())
    }

    /// The default.
    #[getter]
    fn default<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        self.shown(py, self.entry.default.as_ref())
    }

    /// The configured value, else the default.
    #[getter]
    fn value<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        self.shown(py, self.entry.value())
    }

    /// Whether a DCF configures the value.
    #[getter]
    fn is_configured(&self) -> bool {
        self.entry.configured_value().is_some()
    }

    /// The lowest value.
    #[getter]
    fn low_limit<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        self.shown(py, self.entry.low_limit.as_ref())
    }

    /// The highest value.
    #[getter]
    fn high_limit<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        self.shown(py, self.entry.high_limit.as_ref())
    }

    /// The default as the description states it, where it is the node-ID plus a number.
    #[getter]
    fn formula(&self) -> Option<Formula> {
        match self.entry.default {
            Some(Value::NodeId(offset)) => Some(Formula { offset }),
            _ => None,
        }
    }

    /// Whether PDOs may carry it: `no`, `optional`, `default`, `tpdo` or `rpdo`.
    #[getter]
    fn pdo_mapping(&self) -> String {
        self.entry.pdo_mapping.unwrap_or_default().name().to_ascii_lowercase()
    }

    /// What the description says of it.
    #[getter]
    fn description(&self) -> Option<String> {
        description_of(&self.entry)
    }

    /// The name in the application (DCF).
    #[getter]
    fn denotation(&self) -> Option<&str> {
        self.entry.configured.as_ref()?.denotation.as_deref()
    }

    /// The unit.
    #[getter]
    fn unit(&self) -> Option<&str> {
        self.meaning_of_values()?.unit.as_deref()
    }

    /// What the value, with the offset, is multiplied by to be in the unit.
    #[getter]
    fn factor(&self) -> f64 {
        self.meaning_of_values().and_then(|meaning| meaning.factor).unwrap_or(1.0)
    }

    /// What is added to the value before it is multiplied.
    #[getter]
    fn offset(&self) -> f64 {
        self.meaning_of_values().and_then(|meaning| meaning.offset).unwrap_or(0.0)
    }

    /// The names of values.
    #[getter]
    fn value_names(&self) -> BTreeMap<i128, String> {
        self.meaning_of_values().map(|meaning| meaning.values.clone()).unwrap_or_default()
    }

    /// The names of bits, with the bits that they have.
    #[getter]
    fn bit_names(&self) -> BTreeMap<String, Vec<u16>> {
        self.meaning_of_values().map(|meaning| meaning.bits.clone()).unwrap_or_default()
    }

    /// The value in the bytes of an SDO transfer.
    fn decode<'py>(&self, py: Python<'py>, data: Vec<u8>) -> PyResult<Bound<'py, PyAny>> {
        let Some(data_type) = self.entry.implied_type().filter(|data_type| data_type.name().is_some()) else {
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

    fn __repr__(&self) -> String {
        format!("<Entry {:04X}h:{:02X} '{}'>", self.index, self.sub, self.entry.name)
    }

    /// What a value means in words, if it is more than a number; without one, the value of the description.
    #[pyo3(signature = (value=None))]
    fn meaning(&self, value: Option<&Bound<'_, PyAny>>) -> PyResult<Option<String>> {
        let given = value.map(|value| from_python(value, self.type_for_transfer()?)).transpose()?;
        let Some(value) = given.as_ref().or(self.entry.value()) else { return Ok(None) };
        let named = || self.meaning_of_values()?.values.get(&value.as_integer()?).cloned();
        let decoder = Decoder::english(self.shared.device(), self.shared.node_id);
        Ok(named().or_else(|| decoder.of(self.index, self.sub, value)))
    }
}

/// The description in the application process, or that of tools which write one into an EDS.
pub(crate) fn description_of(entry: &model::Entry) -> Option<String> {
    let parameter = entry.parameter.as_ref().and_then(|parameter| parameter.labels.description_in("en"));
    let text = parameter.or_else(|| entry.extra.get("Description"))?.trim();
    (!text.is_empty()).then(|| text.to_owned())
}
