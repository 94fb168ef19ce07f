//! Names of files that every system can have. They are judged as texts, so that the same is refused everywhere.

use std::ffi::OsStr;
use std::path::Path;

use super::error::OutputError;

/// Names that Windows keeps for devices, in any case and with any extension (Microsoft, *Naming Files, Paths, and Namespaces*).
const DEVICES: [&str; 6] = ["CON", "PRN", "AUX", "NUL", "CONIN$", "CONOUT$"];

const RESERVED: &str = "Windows reserves it for a device";

/// Refuses the name of a file in a folder, with `/` between its parts, that leads out of the folder or that Windows does not
/// allow.
pub(super) fn require_portable(name: &str) -> Result<(), OutputError> {
    match name.split('/').find_map(defect) {
        Some(reason) => Err(OutputError::Name { name: name.to_owned(), reason }),
        None => Ok(()),
    }
}

/// The same for a file that an argument names, whose folder is given. `NUL` is what Windows calls `/dev/null`.
pub(super) fn require_file(path: &Path) -> Result<(), OutputError> {
    match path.file_name().and_then(OsStr::to_str).filter(|name| name.contains('.') && is_device(name)) {
        Some(name) => Err(OutputError::Name { name: name.to_owned(), reason: RESERVED }),
        None => Ok(()),
    }
}

/// Why a name without separators is not valid on every system.
fn defect(part: &str) -> Option<&'static str> {
    let is_forbidden = |character: char| character.is_control() || "<>:\"|?*\\".contains(character);
    match part {
        "" | "." | ".." => Some("it leads to another folder"),
        _ if part.contains(is_forbidden) => Some("Windows does not allow its characters"),
        _ if part.ends_with(['.', ' ']) => Some("Windows does not allow a dot or a blank at its end"),
        _ if is_device(part) => Some(RESERVED),
        _ => None,
    }
}

/// Whether Windows takes a name for a device: `con`, `AUX.txt`, `com1 .log`.
pub(super) fn is_device(name: &str) -> bool {
    let stem = name.split(['.', ':']).next().unwrap_or_default().trim_end_matches(' ').to_ascii_uppercase();
    let port = stem.strip_prefix("COM").or_else(|| stem.strip_prefix("LPT"));
    DEVICES.contains(&stem.as_str())
        || port.is_some_and(|number| {
            matches!(number, "\u{B9}" | "\u{B2}" | "\u{B3}")
                || matches!(number.as_bytes(), [digit] if digit.is_ascii_digit())
        })
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
