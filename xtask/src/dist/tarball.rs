//! The archive of the command, which `cargo binstall` downloads too (`package.metadata.binstall` in Cargo.toml has its name).

use std::process::Command;

use super::{Built, run_program, triple};

/// `objdict-VERSION-TARGET.tar.gz`: a folder with program, manual, completions and licences.
pub(super) fn make(built: &Built) -> Result<(), String> {
    let name = format!("objdict-{}-{}", built.version, triple());
    let stage = built.stage("tarball")?;
    built.fill(&stage.join(&name), &built.program)?;
    let mut tar = Command::new("tar");
    if cfg!(target_os = "linux") {
        // the same bytes each time
        let time = format!("--mtime=@{}", built.time("%ct"));
        tar.args(["--sort=name", "--owner=0", "--group=0", "--numeric-owner", &time, "-I", "gzip -n"]);
    } else {
        tar.arg("-z");
    }
    let file = built.dist.join(format!("{name}.tar.gz"));
    run_program(tar.arg("-cf").arg(file).arg("-C").arg(stage).arg(name))
}
