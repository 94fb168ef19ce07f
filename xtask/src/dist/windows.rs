//! The archive of the command for Windows, as [`tarball`](super::tarball) is for others. On Linux the command is built with mingw.
//!
//! It is tested under wine with the existing tests of `tests/command` (`OBJDICT_PROGRAM`, `.ci/windows`). Tests
//! built for Windows would compile everything a second time.

use std::process::Command;

use super::{Built, cross, python, run_program, triple};

/// What is built on Linux.
const MINGW: &str = "x86_64-pc-windows-gnu";

/// Writes a ZIP whose bytes depend on the files and the time alone.
const ZIP: &str = "
import pathlib, sys, time, zipfile
file, stage, seconds = sys.argv[1:]
stamp = time.gmtime(max(int(seconds), 315532800))[:6]
stage = pathlib.Path(stage)
with zipfile.ZipFile(file, 'w') as archive:
    for path in sorted(path for path in stage.rglob('*') if path.is_file()):
        entry = zipfile.ZipInfo(path.relative_to(stage).as_posix(), stamp)
        archive.writestr(entry, path.read_bytes(), zipfile.ZIP_DEFLATED)
";

/// `objdict-VERSION-TARGET.zip`: a folder with program, manual, completions and licences.
pub(super) fn make(built: &Built) -> Result<(), String> {
    let (program, target) = match cfg!(windows) {
        true => (built.program.clone(), triple()),
        false => (cross::program(built, MINGW)?, MINGW.to_owned()),
    };
    let name = format!("objdict-{}-{target}", built.version);
    let stage = built.stage("windows")?;
    built.fill(&stage.join(&name), &program)?;
    let file = built.dist.join(format!("{name}.zip"));
    run_program(Command::new(python()).args(["-c", ZIP]).args([&file, &stage]).arg(built.time("%ct")))
}
