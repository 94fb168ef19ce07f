//! Output for third-party stacks compiles with their declarations and contains the described values: each
//! harness looks up the entries like its stack and prints them, and the lines are compared with those
//! expected from the model alone. So all stacks agree with the description.
//!
//! The declarations are written for this project and contain only what the generated files need. If a
//! variable `OBJDICT_<STACK>_DIR` names a checkout of the real stack, the files are also compiled with its
//! headers.

mod c_structs;
mod canfestival;
mod canopen_stack;
mod canopennode;
mod canopennode_v1;
mod columns;
pub(crate) mod figures;
mod lely;
mod measure;
mod microcanopen;
mod objdict_macros;
mod one_truth;
mod pages;
mod sizes;
mod startup;
mod truth;

use std::fmt::Debug;
use std::path::{Path, PathBuf};

use objdict::generate::{Note, Options};

use crate::compile::{c_compiler, cc, generate_with};
use crate::devices::{devices, for_all};
use crate::processors::Programs;
use crate::support::skips::skip;
use crate::verdicts::accepts;

/// A file or folder next to the tests of a stack.
fn beside(stack: &str, name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/generate/stacks").join(stack).join(name)
}

/// The checkout of a real stack named by an environment variable; without it the test is skipped.
#[track_caller]
fn checkout(variable: &str) -> Option<PathBuf> {
    let Some(folder) = std::env::var_os(variable).map(PathBuf::from) else {
        skip(format_args!("`{variable}` names no checkout"));
        return None;
    };
    assert!(folder.is_dir(), "`{variable}` names no folder: {}", folder.display());
    Some(folder)
}

/// The sources of these targets have no cast that drops `const`. The structures of the other stacks point to constants and values with
/// the same member, which is not `const`.
#[test]
fn no_cast_drops_const() {
    let Some(compiler) = c_compiler() else { return };
    for_all(&devices(), |(name, device)| {
        for (target, stack) in [
            ("c", ""),
            ("canopennode", "canopennode"),
            ("canopennode-v1", "canopennode_v1"),
            ("lely", "lely"),
            ("microcanopen", "microcanopen"),
        ] {
            let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
            let files = generate_with(folder.path(), device, target, &for_node(5)).files;
            let sources = files.iter().map(|file| &file.path).filter(|path| path.ends_with(".c"));
            let mut cc = cc(&compiler, folder.path());
            cc.args(["-fsyntax-only", "-Wcast-qual", "-I."]);
            if !stack.is_empty() {
                cc.arg("-isystem").arg(beside(stack, "include"));
            }
            accepts(cc.args(sources)).map_err(|error| format!("{name}, {target}: {error}"))?;
        }
        Ok(())
    });
}

/// A program that looks up the entries of generated tables as a stack does and prints them, and the notes.
pub(crate) struct Harness {
    pub(crate) programs: Programs,
    pub(crate) arguments: Vec<String>,
    pub(crate) notes: Vec<Note>,
}

impl Harness {
    fn arguments(&self) -> Vec<&str> {
        self.arguments.iter().map(String::as_str).collect()
    }

    /// The entries, one per line.
    pub(crate) fn dump(&self) -> Result<String, String> {
        self.programs.run(&self.arguments(), "")
    }

    /// Compares the entries with the expected ones, unless the record has that they are equal. The function may depend
    /// on these and the dump, and on nothing else.
    #[track_caller]
    pub(crate) fn check(
        &self,
        expected: &dyn Debug,
        compare: impl FnOnce(&str) -> Result<(), String>,
    ) -> Result<(), String> {
        self.programs.check(&self.arguments(), "", expected, compare)
    }
}

/// The options for the files of a node.
pub(crate) fn for_node(node_id: u8) -> Options {
    let mut options = Options::default();
    options.node_id = Some(node_id);
    options.file_stem = "device".to_owned();
    options
}
