//! Portable file names. They are checked as strings, so that the same names are rejected on every system.

use std::ffi::OsStr;
use std::path::Path;

use super::error::OutputError;
use objdict_model::source::{is_device_name, unportable};

/// Rejects the name of a file in a folder, with `/` between its parts, that is outside the folder or that Windows does
/// not allow.
pub(super) fn require_portable(name: &str) -> Result<(), OutputError> {
    match name.split('/').find_map(unportable) {
        Some(reason) => Err(OutputError::Name { name: name.to_owned(), reason }),
        None => Ok(()),
    }
}

/// Like `require_portable`, for a file given as an argument, whose folder exists. `NUL` is the Windows name
/// of `/dev/null`.
pub(super) fn require_file(path: &Path) -> Result<(), OutputError> {
    let name = path.file_name().and_then(OsStr::to_str);
    let name = name.filter(|name| name.contains('.') && is_device_name(name));
    match name.and_then(|name| Some((name, unportable(name)?))) {
        Some((name, reason)) => Err(OutputError::Name { name: name.to_owned(), reason }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_windows_reserves_are_refused() {
        for name in
            ["con", "Aux.dcf", "nul.tar.gz", "COM1.bin", "lpt9", "com\u{B2}.eds", "a/prn.h", "com1 .dcf"]
        {
            assert!(require_portable(name).is_err(), "{name}");
        }
        for path in ["con.xdd", "out/Nul.html"] {
            assert!(require_file(Path::new(path)).is_err(), "{path}");
        }
        for path in ["/dev/null", "nul", "con/a.xdd", "console.xdd"] {
            assert!(require_file(Path::new(path)).is_ok(), "{path}");
        }
        for name in ["a.", "a ", "a:b", "a?", "a\\b", "a\u{1B}", "../a", "/a", "a//b", ""] {
            assert!(require_portable(name).is_err(), "{name}");
        }
        for name in ["od.h", "canopennode/OD.h", "console.eds", "com10.dcf", "aux-2.bin", "ü.html", ".hidden"]
        {
            assert!(require_portable(name).is_ok(), "{name}");
        }
    }
}
