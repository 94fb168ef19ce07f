//! What mutations start from.

use std::ffi::OsStr;
use std::fs;
use std::io::Result;
use std::path::{Path, PathBuf};

use objdict::format::{self, Format, json};
use objdict::source::SourceOptions;

use super::patches;

/// A file, and the ending whose format it has.
pub(super) struct Seed {
    /// Unique among the seeds of a folder.
    pub name: String,
    pub ending: String,
    pub bytes: Vec<u8>,
}

/// The files below a folder that have at most `size` bytes, and each description as JSON too. Patches of fixtures are
/// the devices that they stand for.
pub(super) fn seeds(folder: &Path, size: usize) -> Result<Vec<Seed>> {
    if !folder.join("bases").is_dir() {
        return of_files(folder, size);
    }
    let expanded = tempfile::tempdir()?;
    patches::expand(folder, expanded.path());
    of_files(expanded.path(), size)
}

fn of_files(folder: &Path, size: usize) -> Result<Vec<Seed>> {
    let mut seeds = Vec::new();
    for file in files(folder)? {
        let bytes = fs::read(&file)?;
        if bytes.len() > size {
            continue;
        }
        let ending = file.extension().and_then(OsStr::to_str).unwrap_or_default().to_ascii_lowercase();
        let path = file.strip_prefix(folder).unwrap_or(&file);
        let name = path.iter().map(OsStr::to_string_lossy).collect::<Vec<_>>().join("-");
        if Format::from_name(&ending).is_some()
            && let Ok(description) = format::open(&file, &SourceOptions::default())
        {
            let bytes = json::write_device(description.device()).into_bytes();
            seeds.push(Seed { name: format!("{name}.json"), ending: "json".to_owned(), bytes });
        }
        seeds.push(Seed { name, ending, bytes });
    }
    Ok(seeds)
}

/// The files below a folder, in order.
pub(super) fn files(folder: &Path) -> Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    collect(folder, &mut files)?;
    files.sort();
    Ok(files)
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) -> Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() { collect(&path, files)? } else { files.push(path) }
    }
    Ok(())
}
