//! Concise DCF.

use objdict::download::{ConciseDcf, Download};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use super::raised;

/// A concise DCF of downloads: index, sub-index and bytes.
#[pyfunction]
pub(crate) fn pack(py: Python<'_>, downloads: Vec<(u16, u8, Vec<u8>)>) -> PyResult<Bound<'_, PyBytes>> {
    let downloads = downloads.into_iter().map(|(index, sub, data)| Download::new(index, sub, data));
    let stream = ConciseDcf(downloads.collect()).write().map_err(raised)?;
    Ok(PyBytes::new(py, &stream))
}

/// The downloads of a concise DCF.
#[pyfunction]
pub(crate) fn unpack(py: Python<'_>, data: Vec<u8>) -> PyResult<Vec<(u16, u8, Bound<'_, PyBytes>)>> {
    let configuration = ConciseDcf::parse(&data).map_err(raised)?;
    let downloads = configuration.0.into_iter();
    Ok(downloads.map(|one| (one.index, one.sub, PyBytes::new(py, &one.data))).collect())
}
