//! What is generated for stacks that others wrote compiles with their declarations and, run, holds what the description
//! says: each harness looks the entries up as its stack does and prints them, and the lines are compared with those that
//! follow from the model alone. So one description is one truth for all stacks.
//!
//! The declarations are our own, and as few as the generated files need. Where a variable `OBJDICT_<STACK>_DIR` names a
//! checkout of the real stack, the files are also compiled against its headers.

mod c_structs;
mod canopen_stack;
mod canopennode;
mod columns;
mod figures;
mod measure;
mod microcanopen;
mod objdict_macros;
mod one_truth;
mod pages;
mod sizes;
mod truth;

use std::path::{Path, PathBuf};

/// A file or folder beside the tests of a stack.
fn beside(stack: &str, name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/generate/stacks").join(stack).join(name)
}

/// The checkout of a real stack that the environment names, if it does.
fn checkout(variable: &str) -> Option<PathBuf> {
    let folder = PathBuf::from(std::env::var_os(variable)?);
    assert!(folder.is_dir(), "`{variable}` names no folder: {}", folder.display());
    Some(folder)
}
