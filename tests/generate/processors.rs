//! The processors for generated C: the host, a 32-bit variant of the host, and a Cortex-M4. Missing compilers
//! are skipped, or fail with `CI=true`.

use std::ffi::{OsStr, OsString};
use std::fmt::Debug;
use std::path::PathBuf;
use std::process::Command;
use std::sync::{Mutex, OnceLock};

use crate::compile::succeed;
use crate::support::skips::skip_unless_ci;
use crate::verdicts::Key;

/// The compiler for a Cortex-M4.
pub(crate) const CORTEX_M4: &str = "arm-none-eabi-gcc";

/// The flags for its object files.
pub(crate) const CORTEX_M4_FLAGS: [&str; 3] = ["-mcpu=cortex-m4", "-mthumb", "-c"];

/// A program that checks whether a compiler has all features for the tests.
const TRIAL: &str = "#include <stdint.h>\n#include <stdio.h>\n#include <string.h>\nint main(void) { return puts(\"\") < 0; }\n";

/// Whether a compiler accepts a program.
fn works((what, package): (&str, &str), compiler: &OsStr, flags: &[&str]) -> bool {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("trial.c"), TRIAL).unwrap();
    let mut command = Command::new(compiler);
    let result = command.current_dir(folder.path()).args(flags).arg("trial.c").output();
    let works = result.is_ok_and(|output| output.status.success());
    if !works {
        skip_unless_ci(format_args!("nothing compiles for {what}: install the package `{package}`"));
    }
    works
}

/// Whether 32-bit programs can be built on this machine.
pub(crate) fn builds_for_32_bits(compiler: &OsStr) -> bool {
    static WORKS: OnceLock<bool> = OnceLock::new();
    *WORKS.get_or_init(|| works(("32 bits", "gcc-multilib"), compiler, &["-m32"]))
}

/// Whether files can be compiled for a Cortex-M4 on this machine.
pub(crate) fn compiles_for_cortex_m4() -> bool {
    static WORKS: OnceLock<bool> = OnceLock::new();
    *WORKS
        .get_or_init(|| works(("a Cortex-M4", "gcc-arm-none-eabi"), OsStr::new(CORTEX_M4), &CORTEX_M4_FLAGS))
}

/// The programs of a compiler command for this machine, for 32 bits if possible, and objects for a Cortex-M4. The
/// command has the name of a program after `-o`.
#[track_caller]
pub(crate) fn build(cc: &Command) -> Programs {
    let arguments: Vec<&OsStr> = cc.get_args().collect();
    let at = arguments.iter().position(|argument| *argument == "-o").unwrap();
    let with = |program: &OsStr, arguments: &[&OsStr]| {
        let mut command = Command::new(program);
        command.current_dir(cc.get_current_dir().unwrap()).args(arguments);
        command
    };
    let mut programs = host(cc);
    if builds_for_32_bits(cc.get_program()) {
        let name = for_32_bits(arguments[at + 1]);
        let own = [OsStr::new("-m32"), arguments[at], &name];
        let own = [&arguments[..at], &own, &arguments[at + 2..]].concat();
        programs.add(with(cc.get_program(), &own), Some(&name));
    }
    if compiles_for_cortex_m4() {
        let own = [&arguments[..at], &CORTEX_M4_FLAGS.map(OsStr::new), &arguments[at + 2..]].concat();
        programs.add(with(OsStr::new(CORTEX_M4), &own), None);
    }
    programs
}

/// The program of a compiler command for this machine alone.
#[track_caller]
pub(crate) fn host(cc: &Command) -> Programs {
    let arguments: Vec<&OsStr> = cc.get_args().collect();
    let at = arguments.iter().position(|argument| *argument == "-o").unwrap();
    let mut programs =
        Programs { key: Key::new(), commands: Vec::new(), paths: Vec::new(), built: OnceLock::new() };
    let mut command = Command::new(cc.get_program());
    command.current_dir(cc.get_current_dir().unwrap()).args(&arguments);
    programs.add(command, Some(arguments[at + 1]));
    programs
}

fn for_32_bits(name: &OsStr) -> OsString {
    [name, OsStr::new("-32")].into_iter().collect()
}

/// A program for each processor that can run on this machine. They are compiled when they run first, so the sources must
/// be there until then.
pub(crate) struct Programs {
    key: Key,
    commands: Vec<Mutex<Command>>,
    paths: Vec<PathBuf>,
    built: OnceLock<Result<(), String>>,
}

impl Programs {
    fn add(&mut self, command: Command, name: Option<&OsStr>) {
        self.key.command(&command);
        self.paths.extend(name.map(|name| command.get_current_dir().unwrap().join(name)));
        self.commands.push(Mutex::new(command));
    }

    /// What decides whether they compile, and what they print.
    pub(crate) fn key(&self) -> &Key {
        &self.key
    }

    /// Compiles them, unless the record has that they compile and run without an error.
    #[track_caller]
    pub(crate) fn succeed(&self) -> Result<(), String> {
        self.check(&[], "", &"", |_| Ok(()))
    }

    /// Checks the output.
    #[track_caller]
    pub(crate) fn expect(&self, arguments: &[&str], expected: &str) -> Result<(), String> {
        self.check(arguments, "", &expected, |printed| match printed == expected {
            true => Ok(()),
            false => Err(format!("`{printed}` where `{expected}` was expected")),
        })
    }

    /// Compiles them, runs them, and compares what they print, unless the record has that it passed. The function may
    /// depend on the expected value and what is printed, and on nothing else.
    #[track_caller]
    pub(crate) fn check(
        &self,
        arguments: &[&str],
        input: &str,
        expected: &dyn Debug,
        compare: impl FnOnce(&str) -> Result<(), String>,
    ) -> Result<(), String> {
        let mut key = self.key.clone();
        key.tests_of_caller();
        key.debug(&(arguments, input, expected));
        key.or_try(|| compare(&self.run(arguments, input)?))
    }

    /// Runs them, and compiles them first if they did not run yet; all must print the same.
    pub(crate) fn run(&self, arguments: &[&str], input: &str) -> Result<String, String> {
        let build = || {
            let mut commands = self.commands.iter();
            commands.try_for_each(|command| succeed(&mut command.lock().unwrap(), "").map(drop))
        };
        self.built.get_or_init(build).clone()?;
        let run = |program: &PathBuf| succeed(Command::new(program).args(arguments), input);
        let (first, others) = self.paths.split_first().unwrap();
        let printed = run(first)?;
        for program in others {
            let other = run(program)?;
            if let Some((line, other)) =
                printed.lines().zip(other.lines()).find(|(line, other)| line != other)
            {
                return Err(format!("{program:?}: `{other}` where `{line}` was expected"));
            }
            if printed.len() != other.len() {
                return Err(format!(
                    "{program:?}: {} bytes where {} were expected",
                    other.len(),
                    printed.len()
                ));
            }
        }
        Ok(printed)
    }
}
