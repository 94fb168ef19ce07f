//! Writes an EDS as an XDD and says what the XDD has no place for: `cargo run --example convert`.
#![allow(clippy::print_stdout, reason = "the output of an example")]

use objdict::format::{Format, WriteOptions};
use objdict::source::SourceOptions;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let eds = objdict::format::open("fixtures/eds/drive-402.eds".as_ref(), &SourceOptions::default())?;
    let written = objdict::format::write(eds.device(), Format::Xdd, &WriteOptions::default())?;
    println!("{} bytes", written.bytes.len());
    for loss in &written.losses {
        println!("{loss}");
    }
    Ok(())
}
