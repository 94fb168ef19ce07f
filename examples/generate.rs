//! Generates the tables of a device in C: `cargo run --example generate`.
#![allow(clippy::print_stdout, reason = "the output of an example")]

use objdict::generate::{Options, Target, generate};
use objdict::source::SourceOptions;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let description = objdict::format::open("fixtures/eds/io-401.eds".as_ref(), &SourceOptions::default())?;
    let generated = generate(description.device(), Target::named("c")?, &Options::default())?;
    for file in &generated.files {
        println!("{}: {} bytes", file.path, file.contents.len());
    }
    for note in &generated.notes {
        println!("note: {note}");
    }
    Ok(())
}
