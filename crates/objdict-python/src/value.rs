//! Values as objects of Python and back.

use std::time::Duration;

use objdict::model::{DataType, Time, TypeKind, Value};
use pyo3::IntoPyObjectExt;
use pyo3::exceptions::{PyOverflowError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyBytes, PyFloat, PyInt};

const MILLISECONDS_OF_DAY: u64 = 24 * 60 * 60 * 1000;

/// A node-ID, 1 to 127. Other numbers are a `ValueError`.
#[derive(Clone, Copy)]
pub(crate) struct NodeId(pub(crate) u8);

impl FromPyObject<'_, '_> for NodeId {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
        if !object.is_instance_of::<PyInt>() {
            return Err(PyTypeError::new_err(format!(
                "a node-ID is a number from 1 to 127, not `{}`",
                *object
            )));
        }
        let number = object.extract().ok().filter(|number| (1..=127).contains(number));
        number.map(Self).ok_or_else(|| {
            PyValueError::new_err(format!("`{}` is not a node-ID: write a number from 1 to 127", *object))
        })
    }
}

/// A value that is the node-ID plus a number, as long as the node-ID is unknown.
#[pyclass(frozen, eq, hash, from_py_object, module = "canopen_objdict")]
#[derive(Clone, PartialEq, Eq, Hash)]
pub(crate) struct Formula {
    /// The number.
    #[pyo3(get)]
    pub(crate) offset: u64,
}

#[pymethods]
impl Formula {
    /// The value on a node.
    fn on_node(&self, node_id: NodeId) -> u64 {
        self.offset.wrapping_add(node_id.0.into())
    }

    fn __repr__(&self) -> String {
        Value::NodeId(self.offset).to_string()
    }
}

/// A value on a node; without the node-ID, `$NODEID+n` stays a formula.
pub(crate) fn to_python<'py>(
    py: Python<'py>,
    value: &Value,
    data_type: Option<DataType>,
    node_id: Option<u8>,
) -> PyResult<Bound<'py, PyAny>> {
    let resolved = node_id.zip(data_type).and_then(|(node_id, data_type)| value.resolve(data_type, node_id));
    match resolved.as_ref().unwrap_or(value) {
        Value::Boolean(value) => value.into_bound_py_any(py),
        Value::Signed(number) => number.into_bound_py_any(py),
        Value::Unsigned(number) => number.into_bound_py_any(py),
        // the shortest number that is this REAL32: 0.1 and not 0.10000000149
        Value::Real32(number) => {
            number.to_string().parse().unwrap_or(f64::from(*number)).into_bound_py_any(py)
        }
        Value::Real64(number) => number.into_bound_py_any(py),
        Value::Text(text) | Value::Raw(text) => text.into_bound_py_any(py),
        Value::Bytes(bytes) => Ok(PyBytes::new(py, bytes).into_any()),
        Value::Time(time) => duration(*time).into_bound_py_any(py),
        Value::NodeId(offset) => Formula { offset: *offset }.into_bound_py_any(py),
    }
}

fn duration(time: Time) -> Duration {
    Duration::from_millis(u64::from(time.days) * MILLISECONDS_OF_DAY + u64::from(time.milliseconds))
}

/// A value as a setting states it: as in a DCF. Texts stay as they are.
pub(crate) fn setting_text(value: &Bound<'_, PyAny>) -> PyResult<String> {
    if value.is_instance_of::<PyBool>() {
        return Ok(u8::from(value.is_truthy()?).to_string());
    }
    if value.is_instance_of::<PyInt>() || value.is_instance_of::<PyFloat>() {
        return Ok(value.str()?.to_string());
    }
    if let Ok(formula) = value.extract::<Formula>() {
        return Ok(formula.__repr__());
    }
    if let Ok(text) = value.extract::<String>() {
        return Ok(text);
    }
    let data_type =
        if value.is_instance_of::<PyBytes>() { DataType::OCTET_STRING } else { DataType::TIME_OF_DAY };
    let unfit = |_| PyTypeError::new_err(format!("`{value}` is not a value of an entry"));
    Ok(from_python(value, data_type).map_err(unfit)?.to_string())
}

/// The value of a data type that an object of Python is.
pub(crate) fn from_python(value: &Bound<'_, PyAny>, data_type: DataType) -> PyResult<Value> {
    let unfit = || PyOverflowError::new_err(format!("{value} does not fit {}", name_of(data_type)));
    Ok(match data_type.kind() {
        TypeKind::Boolean => Value::Boolean(value.is_truthy()?),
        TypeKind::Signed(_) | TypeKind::Unsigned(_) => {
            Value::from_integer(value.extract()?, data_type).ok_or_else(unfit)?
        }
        TypeKind::Real32 => Value::Real32(value.extract()?),
        TypeKind::Real64 => Value::Real64(value.extract()?),
        TypeKind::VisibleString | TypeKind::UnicodeString => Value::Text(value.extract::<String>()?.into()),
        TypeKind::OctetString | TypeKind::Domain => Value::Bytes(value.extract::<Vec<u8>>()?.into()),
        TypeKind::TimeOfDay | TypeKind::TimeDifference => {
            let milliseconds = value.extract::<Duration>()?.as_millis();
            let day = u128::from(MILLISECONDS_OF_DAY);
            let days = u16::try_from(milliseconds / day).map_err(|_| unfit())?;
            Value::Time(Time { days, milliseconds: (milliseconds % day) as u32 })
        }
        TypeKind::Structure | TypeKind::Defined | TypeKind::Reserved => {
            return Err(PyTypeError::new_err(format!("a value of {} is bytes", name_of(data_type))));
        }
    })
}

/// `UNSIGNED32`, or the index of a data type without a name.
pub(crate) fn name_of(data_type: DataType) -> String {
    data_type.name().map_or_else(|| format!("0x{:04X}", data_type.0), ToOwned::to_owned)
}
