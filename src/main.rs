//! The command `objdict`.

use std::process::ExitCode;

use objdict::cli::Texts;

macro_rules! schemas {
    ($($name:literal)+) => {
        &[$(($name, include_str!(concat!("../schemas/", $name, ".json")))),+]
    };
}

/// The texts of this repository that the command prints, and the page of `objdict open`.
const TEXTS: Texts = Texts {
    cli: include_str!("../docs/reference/cli.md"),
    config: include_str!("../docs/reference/config.md"),
    dcf: include_str!("../docs/guides/dcf.md"),
    formats: include_str!("../docs/reference/formats.md"),
    schemas: schemas!(
        "device-json" "concise-dcf" "findings" "changes" "baseline" "identify" "entries" "node-list" "modules" "losses" "sizes" "tables" "variants" "network" "boot" "timing" "conformance" "frame" "traffic" "verify" "bus-scan" "bus-values" "bus-writes" "bus-comparison" "bus-command" "bus-lss" "bus-lss-plan" "profiles" "profile" "rules" "patch" "answers"
    ),
    #[cfg(feature = "open")]
    workbench: Some(include_str!(env!("OBJDICT_WORKBENCH"))),
    #[cfg(not(feature = "open"))]
    workbench: None,
};

fn main() -> ExitCode {
    objdict::cli::run(&TEXTS)
}
