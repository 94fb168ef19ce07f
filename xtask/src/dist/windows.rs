//! The archive of the command for Windows, as [`tarball`](super::tarball) is for others. On Linux the command is built with mingw.

use std::path::PathBuf;
use std::process::Command;

use super::{Built, python, run_program, triple};

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
        false => (cross_built(built)?, "x86_64-pc-windows-gnu".to_owned()),
    };
    let name = format!("objdict-{}-{target}", built.version);
    let stage = built.stage("windows")?;
    built.fill(&stage.join(&name), &program)?;
    let file = built.dist.join(format!("{name}.zip"));
    run_program(Command::new(python()).args(["-c", ZIP]).args([&file, &stage]).arg(built.time()))
}

fn cross_built(built: &Built) -> Result<PathBuf, String> {
    let script = built.root.join(".ci/windows");
    let missing = Command::new(&script).arg("missing").output();
    let missing = missing.map_err(|error| format!("{}: {error}", script.display()))?;
    // running it is for tests alone
    let missing = String::from_utf8_lossy(&missing.stdout);
    if !matches!(missing.trim(), "" | "wine") {
        return Err(format!("for Windows this machine lacks {}", missing.trim()));
    }
    let mut cargo = Command::new(script);
    run_program(built.with_options(cargo.args(["cargo", "build"])))?;
    Ok(built.root.join("target/x86_64-pc-windows-gnu").join(built.folder()).join("objdict.exe"))
}
