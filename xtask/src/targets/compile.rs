//! How the files of each target are compiled.

use std::path::{Path, PathBuf};
use std::process::Command;

use objdict::generate::Note;

use super::crates::Crates;

/// Compiler flags of the plain C, and of code for stacks with the declarations of this project.
const C_FLAGS: [&str; 6] = ["-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"];

/// What is needed to compile.
pub(super) struct Tools {
    cc: String,
    pub(super) rustc: String,
    /// Where our declarations of the stacks are.
    stacks: PathBuf,
    /// Checkouts of the real stacks, where the environment names them, as the tests take them.
    canopennode: Option<PathBuf>,
    canopen_stack: Option<PathBuf>,
    /// The crates of others.
    pub(super) crates: Option<Crates>,
    /// What waits for zencan-build.
    pub(super) waiting: tempfile::TempDir,
}

impl Tools {
    pub(super) fn find(crates: bool) -> Result<Self, String> {
        let or =
            |variable: &str, default: &str| std::env::var(variable).unwrap_or_else(|_| default.to_owned());
        let checkout = |variable: &str| std::env::var_os(variable).map(PathBuf::from);
        Ok(Self {
            cc: or("CC", "cc"),
            rustc: or("RUSTC", "rustc"),
            stacks: Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/generate/stacks"),
            canopennode: checkout("OBJDICT_CANOPENNODE_DIR"),
            canopen_stack: checkout("OBJDICT_CANOPEN_STACK_DIR"),
            crates: if crates { Some(Crates::build()?) } else { None },
            waiting: tempfile::tempdir().map_err(|error| error.to_string())?,
        })
    }

    /// Where the configuration of a file waits for zencan-build.
    pub(super) fn zencan_file(&self, number: usize) -> PathBuf {
        self.waiting.path().join(format!("node{number}.toml"))
    }
}

/// A call of a compiler.
pub(super) struct Call {
    program: String,
    arguments: Vec<String>,
    /// Which of the generated files it gets.
    takes: fn(&str) -> bool,
    /// Whether it has to fail, given the notes.
    fails: fn(&[Note]) -> bool,
}

impl Call {
    fn new(program: &str, arguments: &[&str], takes: fn(&str) -> bool) -> Self {
        let arguments = arguments.iter().map(|&argument| argument.to_owned()).collect();
        Self { program: program.to_owned(), arguments, takes, fails: |_| false }
    }

    fn argument(mut self, argument: impl Into<String>) -> Self {
        self.arguments.push(argument.into());
        self
    }

    pub(super) fn run(&self, folder: &Path, files: &[&str], notes: &[Note]) -> Result<(), String> {
        let files = files.iter().filter(|file| (self.takes)(file));
        let output =
            Command::new(&self.program).args(&self.arguments).args(files).current_dir(folder).output();
        let output = output.map_err(|error| format!("{}: {error}", self.program))?;
        match (output.status.success(), (self.fails)(notes)) {
            (true, false) | (false, true) => return Ok(()),
            (true, true) => return Err("it compiles, although a note says that it does not".to_owned()),
            (false, false) => {}
        }
        let text = String::from_utf8_lossy(&output.stderr).into_owned();
        let mut lines = text.lines().filter(|line| line.contains("error"));
        Err(format!("{}: {}", self.program, lines.next().unwrap_or("failed")))
    }
}

fn is_source(file: &str) -> bool {
    file.ends_with(".c")
}

pub(super) fn rust(tools: &Tools) -> Vec<Call> {
    let arguments = ["--edition=2021", "--crate-type=lib", "--emit=metadata", "-Dwarnings"];
    vec![Call::new(&tools.rustc, &arguments, |file| file == "od.rs")]
}

fn own_c(tools: &Tools) -> Call {
    Call::new(&tools.cc, &C_FLAGS, is_source).argument("-I.").argument("-c")
}

pub(super) fn c(tools: &Tools) -> Vec<Call> {
    vec![own_c(tools)]
}

fn with_declarations(tools: &Tools, stack: &str) -> Call {
    own_c(tools).argument(format!("-I{}", tools.stacks.join(stack).join("include").display()))
}

pub(super) fn microcanopen(tools: &Tools) -> Vec<Call> {
    vec![with_declarations(tools, "microcanopen").argument("-DOD_NODE_ID=5")]
}

pub(super) fn canfestival(tools: &Tools) -> Vec<Call> {
    vec![with_declarations(tools, "canfestival")]
}

pub(super) fn canopennode_v1(tools: &Tools) -> Vec<Call> {
    vec![with_declarations(tools, "canopennode_v1")]
}

pub(super) fn lely(tools: &Tools) -> Vec<Call> {
    vec![with_declarations(tools, "lely")]
}

/// With our declarations; with those of the stack, and the stack with the tables, where there is a checkout.
pub(super) fn canopennode(tools: &Tools) -> Vec<Call> {
    let mut calls = vec![with_declarations(tools, "canopennode")];
    if let Some(stack) = &tools.canopennode {
        let real = |flags: &[&str], takes| {
            let call = Call::new(&tools.cc, &["-std=c99", "-fsyntax-only", "-I."], takes);
            let call = call.argument(format!("-I{}", stack.display()));
            let call = call.argument(format!("-I{}", stack.join("example").display()));
            flags.iter().fold(call, |call, &flag| call.argument(flag))
        };
        calls.push(real(&["-Wall", "-Wextra", "-Werror"], is_source));
        let whole = real(&[], |_| false).argument(stack.join("CANopen.c").display().to_string());
        calls.push(Call { fails: stack_refuses, ..whole });
    }
    calls
}

/// Whether a note says that CANopenNode does not compile with the tables.
fn stack_refuses(notes: &[Note]) -> bool {
    notes.iter().any(|note| note.message.contains("the stack does not compile"))
}

pub(super) fn canopen_stack(tools: &Tools) -> Vec<Call> {
    let mut calls = vec![with_declarations(tools, "canopen_stack")];
    if let Some(stack) = &tools.canopen_stack {
        let folders =
            ["config", "core", "hal", "object/basic", "object/cia301", "service/cia301", "service/cia305"];
        let mut call = Call::new(&tools.cc, &C_FLAGS, is_source).argument("-fsyntax-only").argument("-I.");
        for folder in folders {
            call = call.argument("-isystem").argument(stack.join("src").join(folder).display().to_string());
        }
        for count in ["CO_RPDO_N=512", "CO_TPDO_N=512", "CO_SSDO_N=128", "CO_CSDO_N=128"] {
            call = call.argument(format!("-D{count}"));
        }
        calls.push(call);
    }
    calls
}

pub(super) fn canopen_rs(tools: &Tools) -> Vec<Call> {
    let call = rust(tools).into_iter().map(|call| match &tools.crates {
        Some(crates) => crates.arguments("canopen_rs").into_iter().fold(call, Call::argument),
        None => call,
    });
    call.collect()
}
