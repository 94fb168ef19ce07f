//! Checks a description with demands of your own besides the built-in rules: `cargo run --example check_with_rules`.
#![allow(clippy::print_stdout, reason = "the output of an example")]

use std::sync::Arc;

use objdict::lint::Options;
use objdict::profile::Profile;
use objdict::report::{Concise, Report as _, grouped};
use objdict::source::SourceOptions;

/// What the company demands of each device.
const DEMANDS: &str = r#"
document = "Company rules"
title = "what every device of ours has"

[[object]]
index = 0x1008
name = "Manufacturer device name"
need = "mandatory"
data-type = "VISIBLE_STRING"

[[object]]
index = 0x2F00
name = "Build number"
need = "mandatory"
data-type = "UNSIGNED32"
access = "ro"
"#;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let description = objdict::format::open("fixtures/eds/io-401.eds".as_ref(), &SourceOptions::default())?;
    let options = Options { profiles: vec![Arc::new(Profile::from_toml(DEMANDS)?)], ..Options::default() };
    let findings = objdict::check_with(&description, &options);

    let mut report = Concise::new(std::io::stdout().lock());
    report.file((&description).into(), &grouped(&description, findings))?;
    report.finish()?;
    Ok(())
}
