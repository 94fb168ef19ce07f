//! Entries: their facts, and what their values mean.

use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

use objdict::describe::Decoder;
use objdict::model::{self, DataType, Device, Meaning as Meant, PdoMapping, Scaling, Value};
use objdict::profile;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use super::dictionary::SharedDescription;
use super::value::{from_python, name_of, to_python};

/// A value that is the node-ID plus a number, as long as the node-ID is unknown.
#[pyclass(frozen, eq, hash, module = "canopen_objdict")]
#[derive(Clone, PartialEq, Eq, Hash)]
pub(crate) struct Formula {
    /// The number.
    #[pyo3(get)]
    pub(crate) offset: u64,
}

#[pymethods]
impl Formula {
    /// The value on a node.
    fn on_node(&self, node_id: u8) -> u64 {
        self.offset.wrapping_add(node_id.into())
    }

    fn __repr__(&self) -> String {
        Value::NodeId(self.offset).to_string()
    }
}

/// What a description or a CiA document says of the values of an entry.
#[derive(Default)]
pub(crate) struct ValueMeaning {
    unit: Option<String>,
    factor: Option<f64>,
    offset: Option<f64>,
    values: BTreeMap<i128, String>,
    /// Not bytes, which Python would have for `u8`.
    bits: BTreeMap<String, Vec<u16>>,
}

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
    fn pdo_mapping(&self) -> &'static str {
        match self.entry.pdo_mapping.unwrap_or_default() {
            PdoMapping::No => "no",
            PdoMapping::Optional => "optional",
            PdoMapping::Default => "default",
            PdoMapping::Tpdo => "tpdo",
            PdoMapping::Rpdo => "rpdo",
        }
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
        let stated = || self.entry.extra.get("Unit").map(str::trim).filter(|unit| !unit.is_empty());
        self.meaning_of_values().and_then(|meaning| meaning.unit.as_deref()).or_else(stated)
    }

    /// What the value, with the offset, is multiplied by to be in the unit.
    #[getter]
    fn factor(&self) -> f64 {
        let stated = || self.entry.extra.get("Factor").and_then(|factor| factor.trim().parse().ok());
        self.meaning_of_values().and_then(|meaning| meaning.factor).or_else(stated).unwrap_or(1.0)
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

/// The meanings of all entries of a device that have one.
pub(crate) fn meanings(device: &Device) -> HashMap<(u16, u8), ValueMeaning> {
    let described = device.meanings();
    let mut found = HashMap::new();
    for (&index, object) in device.objects.iter() {
        let documents: Vec<_> = profile::of_object(device, index).map(|(_, facts)| facts).collect();
        for (sub, _) in object.entries() {
            let mut meaning = ValueMeaning::default();
            for facts in documents.iter().filter_map(|facts| facts.entry(sub)) {
                if meaning.unit.is_none() {
                    meaning.set_unit_of_document(facts.unit.unwrap_or_default());
                }
            }
            for field in profile::bits(documents.iter().copied(), sub) {
                meaning
                    .bits
                    .insert(field.name.to_owned(), (field.first.into()..=field.last.into()).collect());
            }
            let stated = object.subs.get(sub).or((sub == 0).then_some(&object.main));
            if let Some(entry) = stated {
                meaning.set_scaling(described.scaling_of(entry));
            }
            meaning.set_names(described.of(index, sub));
            if !meaning.is_empty() {
                found.insert((index, sub), meaning);
            }
        }
    }
    found
}

impl ValueMeaning {
    fn is_empty(&self) -> bool {
        let is_scaled = self.unit.is_some() || self.factor.is_some() || self.offset.is_some();
        !is_scaled && self.values.is_empty() && self.bits.is_empty()
    }

    /// The unit of a document, such as `0.1 % of the rated torque`.
    fn set_unit_of_document(&mut self, unit: &str) {
        let scaled = unit.split_once(' ').and_then(|(number, unit)| Some((number.parse().ok()?, unit)));
        let (factor, unit) = scaled.map_or((None, unit), |(factor, unit)| (Some(factor), unit));
        if !unit.is_empty() {
            (self.factor, self.unit) = (factor, Some(unit.to_owned()));
        }
    }

    /// What the description states replaces what the document says.
    fn set_scaling(&mut self, scaling: Scaling<'_>) {
        if scaling.is_empty() {
            return;
        }
        let number = |text: Option<&str>| text.and_then(|text| text.parse().ok());
        let unit = scaling.unit.and_then(|unit| unit.labels.name_in("en")).map(str::trim);
        (self.factor, self.offset) = (number(scaling.multiplier), number(scaling.offset));
        self.unit = unit.filter(|unit| !unit.is_empty()).map(ToOwned::to_owned);
    }

    fn set_names(&mut self, meaning: Option<Meant<'_>>) {
        match meaning {
            Some(Meant::Enumeration(names)) => {
                let named = names.values.into_iter().filter(|value| !value.name.is_empty());
                self.values = named.map(|value| (value.number, value.name.to_owned())).collect();
            }
            Some(Meant::BitStruct(word)) => {
                let bits = |first: u8, bits: u8| (first.into()..u16::from(first) + u16::from(bits)).collect();
                let fields = word.fields.into_iter();
                self.bits =
                    fields.map(|field| (field.name.to_owned(), bits(field.first, field.bits))).collect();
            }
            None => {}
        }
    }
}
