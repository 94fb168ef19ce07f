//! The processors for generated C: the host, a 32-bit variant of the host, and a Cortex-M4. Missing compilers
//! are skipped with a message, except with `CI=true`.

use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use crate::compile::succeed;
use crate::support::skips::skip_unless_ci;

/// The compiler for a Cortex-M4.
pub(crate) const CORTEX_M4: &str = "arm-none-eabi-gcc";

/// The flags for its object files.
pub(crate) const CORTEX_M4_FLAGS: [&str; 3] = ["-mcpu=cortex-m4", "-mthumb", "-c"];

/// A program that checks whether a compiler has all features for the tests.
const TRIAL: &str = "#include <stdint.h>\n#include <stdio.h>\n#include <string.h>\nint main(void) { return puts(\"\") < 0; }\n";

/// Whether a compiler accepts a program.
fn works(compiler: &OsStr, flags: &[&str]) -> bool {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("trial.c"), TRIAL).unwrap();
    let mut command = Command::new(compiler);
    let result = command.current_dir(folder.path()).args(flags).arg("trial.c").output();
    result.is_ok_and(|output| output.status.success())
}

/// Whether 32-bit programs can be built on this machine.
pub(crate) fn builds_for_32_bits(compiler: &OsStr) -> bool {
    static WORKS: OnceLock<bool> = OnceLock::new();
    *WORKS.get_or_init(|| works(compiler, &["-m32"]))
        || skip_unless_ci("nothing compiles for 32 bits: install the package `gcc-multilib`")
}

/// Whether files can be compiled for a Cortex-M4 on this machine.
pub(crate) fn compiles_for_cortex_m4() -> bool {
    static WORKS: OnceLock<bool> = OnceLock::new();
    *WORKS.get_or_init(|| works(OsStr::new(CORTEX_M4), &CORTEX_M4_FLAGS))
        || skip_unless_ci(
            "nothing compiles for a Cortex-M4: install `gcc-arm-none-eabi` and `libnewlib-arm-none-eabi`",
        )
}

/// Builds the program of a compiler command with its name after `-o`. Builds it again for 32 bits if
/// possible, and compiles its files for a Cortex-M4.
pub(crate) fn build(cc: &Command) -> Result<Programs, String> {
    let folder = cc.get_current_dir().unwrap();
    let arguments: Vec<&OsStr> = cc.get_args().collect();
    let at = arguments.iter().position(|argument| *argument == "-o").unwrap();
    let name = arguments[at + 1];
    let (before, behind) = (&arguments[..at], &arguments[at + 2..]);
    let with = |program: &OsStr| {
        let mut command = Command::new(program);
        command.current_dir(folder).args(before).args(behind);
        command
    };
    succeed(with(cc.get_program()).arg("-o").arg(name), "")?;
    if builds_for_32_bits(cc.get_program()) {
        succeed(with(cc.get_program()).arg("-m32").arg("-o").arg(for_32_bits(name)), "")?;
    }
    if compiles_for_cortex_m4() {
        succeed(with(OsStr::new(CORTEX_M4)).args(CORTEX_M4_FLAGS), "")?;
    }
    Ok(Programs::at(&folder.join(name)))
}

fn for_32_bits(name: &OsStr) -> OsString {
    [name, OsStr::new("-32")].into_iter().collect()
}

/// A program for each processor that can run on this machine.
pub(crate) struct Programs(Vec<PathBuf>);

impl Programs {
    /// The programs that [`build`] created for a name.
    pub(crate) fn at(path: &Path) -> Self {
        let other = path.with_file_name(for_32_bits(path.file_name().unwrap()));
        Self([path.to_owned(), other].into_iter().filter(|path| path.exists()).collect())
    }

    /// Runs them; all must print the same.
    pub(crate) fn run(&self, arguments: &[&str], input: &str) -> Result<String, String> {
        let run = |program: &PathBuf| succeed(Command::new(program).args(arguments), input);
        let (first, others) = self.0.split_first().unwrap();
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
