//! Generates the node code for each device configuration `*.toml` in a folder, next to it, like zencan-build
//! in a build script; prints those that it rejects. Called by `cargo xtask targets`.

#![allow(clippy::print_stdout, reason = "what is printed is the result")]

use std::error::Error;
use std::path::PathBuf;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = PathBuf::from(std::env::args_os().nth(1).ok_or("the folder is missing")?);
    let mut files: Vec<PathBuf> = Vec::new();
    for entry in std::fs::read_dir(folder)? {
        files.push(entry?.path());
    }
    files.retain(|path| path.extension().is_some_and(|ending| ending == "toml"));
    files.sort();
    for file in files {
        if let Err(error) = zencan_build::compile_device_config(&file, file.with_extension("rs")) {
            let name = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
            let chain = std::iter::successors(Some(&error as &dyn Error), |&error| error.source());
            let chain: Vec<String> = chain.map(ToString::to_string).collect();
            println!("{name}\t{}", chain.join(": ").replace('\n', " "));
        }
    }
    Ok(())
}
