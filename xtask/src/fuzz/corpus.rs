//! What libFuzzer starts from: a dictionary, and a folder of inputs for each part.

use std::fs;
use std::io::Result;
use std::path::{Path, PathBuf};

use super::seeds::{Seed, files, seeds};
use super::targets::{FUZZED, Fuzzed};
use super::{SIZE, dictionary};

/// Writes `objdict.dict` and the folders into a folder, from the fixtures.
pub(crate) fn write(folder: &Path) -> Result<()> {
    let fixtures = fixtures();
    let seeds = seeds(&fixtures, SIZE)?;
    fs::create_dir_all(folder)?;
    let lines = dictionary::words(&seeds).iter().map(|word| dictionary::line(word)).collect::<String>();
    fs::write(folder.join("objdict.dict"), lines)?;
    for fuzzed in &FUZZED {
        let to = folder.join(fuzzed.name);
        fs::create_dir_all(&to)?;
        for (name, input) in seeds.iter().filter_map(|seed| Some((&seed.name, of_seed(fuzzed, seed)?))) {
            fs::write(to.join(name), input)?;
        }
        for file in kept(fuzzed)? {
            fs::copy(&file, to.join(file.file_name().unwrap_or_default()))?;
        }
    }
    Ok(())
}

pub(super) fn fixtures() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures")
}

/// The inputs that a part once failed on.
pub(super) fn kept(fuzzed: &Fuzzed) -> Result<Vec<PathBuf>> {
    let folder = fixtures().join("fuzz").join(fuzzed.name);
    if folder.is_dir() { files(&folder) } else { Ok(Vec::new()) }
}

/// A seed as an input of a part; `None` for a part that does not read such files.
pub(super) fn of_seed(fuzzed: &Fuzzed, seed: &Seed) -> Option<Vec<u8>> {
    input(fuzzed, &seed.ending, &seed.bytes)
}

/// A file with an ending as an input of a part.
pub(super) fn input(fuzzed: &Fuzzed, ending: &str, bytes: &[u8]) -> Option<Vec<u8>> {
    let first = (0..=u8::MAX).find(|&first| fuzzed.ending(first) == ending)?;
    Some([&[first], bytes].concat())
}
