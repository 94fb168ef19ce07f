//! Reads a description and lists its objects: `cargo run --example list_objects [FILE]`.
#![allow(clippy::print_stdout, reason = "the output of an example")]

use std::path::PathBuf;

use objdict::source::SourceOptions;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path =
        std::env::args_os().nth(1).map_or_else(|| PathBuf::from("fixtures/eds/io-401.eds"), PathBuf::from);
    let description = objdict::format::open(&path, &SourceOptions::default())?;
    for (index, object) in &description.device().objects {
        println!("{index:04X}h  {}", object.name());
        for (sub, entry) in object.entries() {
            let value = entry.value().map(ToString::to_string).unwrap_or_default();
            println!("  {sub:02X}  {}  {value}", entry.name);
        }
    }
    Ok(())
}
