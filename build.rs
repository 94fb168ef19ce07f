//! Finds the page that the feature `open` puts into the command.
//!
//! The feature `open` is not part of `cli`, so `cargo install` needs neither Node nor a compiler for WebAssembly.
//! Every build contains the server, which reads the page from the file in the variable `OBJDICT_WORKBENCH`.

#![allow(clippy::print_stdout, reason = "so a build script talks to Cargo")]

use std::env;
use std::path::PathBuf;

fn main() {
    // without the feature nothing is looked for, so nothing is built again
    println!("cargo::rerun-if-changed=build.rs");
    if env::var_os("CARGO_FEATURE_OPEN").is_none() {
        return;
    }
    println!("cargo::rerun-if-env-changed=OBJDICT_WORKBENCH");
    let root = env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from).unwrap_or_default();
    let stated = env::var_os("OBJDICT_WORKBENCH");
    let page = root.join(stated.unwrap_or_else(|| "web/dist/objdict-workbench.html".into()));
    println!("cargo::rerun-if-changed={}", page.display());
    if page.is_file() {
        println!("cargo::rustc-env=OBJDICT_WORKBENCH={}", page.display());
    } else {
        println!(
            "cargo::error=the feature `open` needs the page of the workbench, and `{}` does not exist: \
             build it with `cd web && npm ci && npm run build`, or name it with `OBJDICT_WORKBENCH`",
            page.display()
        );
    }
}
