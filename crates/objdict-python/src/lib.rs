//! The native part of the Python module `canopen_objdict`: descriptions are read, and everything is made of them, by the
//! library objdict. What a class of Python is, is in `python/canopen_objdict`; what passes between both are numbers, texts,
//! bytes and the JSON documents of `docs/reference/json.md`.
//!
//! Findings, mappings and the dictionaries of python-canopen are Python, which suits them better. Findings and
//! meanings of values are computed at first use, so opening a file costs only reading it. The stable interface
//! (abi3) needs neither headers nor an interpreter to build.

mod bus;
mod configure;
mod dictionary;
mod entry;
mod findings;
mod meaning;
mod network;
mod output;
mod shared;
mod streams;
mod traffic;
mod value;

use objdict::source::SourceError;
use pyo3::exceptions::PyOSError;
use pyo3::prelude::*;

pyo3::create_exception!(
    canopen_objdict,
    ObjdictError,
    pyo3::exceptions::PyException,
    "What cannot be read, written or made, with the report as its text."
);

pyo3::create_exception!(
    canopen_objdict,
    BusError,
    ObjdictError,
    "What a bus or a node refuses. `abort` is the abort code of SDO, or `None`."
);

/// A failure of objdict as an exception.
fn raised(error: impl std::fmt::Display) -> PyErr {
    ObjdictError::new_err(error.to_string())
}

/// A file that cannot be read: an `OSError` as that of Python's own functions, such as `FileNotFoundError`.
fn unreadable(error: SourceError) -> PyErr {
    match error {
        SourceError::Io { path, error } => match error.raw_os_error() {
            Some(number) => {
                let text = error.to_string();
                let text = text.split(" (os error").next().unwrap_or_default().to_owned();
                PyOSError::new_err((number, text, path))
            }
            None => raised(format_args!("cannot read `{path}`: {error}")),
        },
        error => raised(error),
    }
}

#[pymodule]
mod _native {
    #[pymodule_export]
    use super::{
        BusError, ObjdictError,
        bus::NativeBus,
        dictionary::{NativeDictionary, NativeObject, open, read},
        entry::PythonEntry,
        findings::{check, errors, findings},
        network::{build_network, check_network},
        output::{card, changes, convert, docs, generate},
        streams::{pack, unpack},
        traffic::{Frames, decode, is_network},
        value::Formula,
    };

    /// The version of objdict.
    #[pymodule_export]
    #[expect(non_upper_case_globals, reason = "the name that modules of Python have for it")]
    const __version__: &str = env!("CARGO_PKG_VERSION");
}
