//! The package for Debian and Ubuntu, written by `dpkg-deb`.

use std::env::consts::ARCH;
use std::fs;
use std::process::Command;

use super::{Built, DISTRIBUTION, copy, run_program, write};

/// `canopen-objdict_VERSION_ARCHITECTURE.deb`: program, manual and completions where shells and `man` look for them.
pub(super) fn make(built: &Built) -> Result<(), String> {
    let architecture = match ARCH {
        "x86_64" => "amd64",
        "aarch64" => "arm64",
        other => other,
    };
    let root = built.stage("deb")?;
    copy(&built.program, &root.join("usr/bin/objdict"))?;
    let manual = root.join("usr/share/man/man1");
    built.manual(&manual)?;
    let pages = fs::read_dir(&manual).map_err(|error| format!("{}: {error}", manual.display()))?;
    let pages: Vec<_> = pages.filter_map(|page| Some(page.ok()?.path())).collect();
    run_program(Command::new("gzip").args(["-9", "-n"]).args(pages))?;
    let share = root.join("usr/share");
    built.completions("bash", &share.join("bash-completion/completions/objdict"))?;
    built.completions("zsh", &share.join("zsh/vendor-completions/_objdict"))?;
    built.completions("fish", &share.join("fish/vendor_completions.d/objdict.fish"))?;
    let copyright = "The licence is MIT or Apache-2.0; both texts are in this folder.\n";
    let documents = share.join("doc").join(DISTRIBUTION);
    write(&documents.join("copyright"), copyright.as_bytes())?;
    built.licences(&documents)?;

    // in KiB, as `Installed-Size` of Debian's policy (§5.6.20)
    let size = Command::new("du").args(["-sk", "--apparent-size"]).arg(root.join("usr")).output();
    let size = size.ok().and_then(|output| String::from_utf8(output.stdout).ok()).unwrap_or_default();
    let size = size.split_whitespace().next().unwrap_or("0");
    let control = format!(
        "Package: {DISTRIBUTION}\nVersion: {}\nArchitecture: {architecture}\nMaintainer: the authors of objdict <objdict@localhost>\n\
         Installed-Size: {size}\nSection: electronics\nPriority: optional\n\
         Description: CANopen object-dictionary toolchain\n \
         Checks device descriptions (EDS, XDD) and node configurations (DCF, XDC),\n converts between them, and generates firmware \
         tables, concise DCF and\n documentation.\n",
        built.version
    );
    write(&root.join("DEBIAN/control"), control.as_bytes())?;
    let file = built.dist.join(format!("{DISTRIBUTION}_{}_{architecture}.deb", built.version));
    let mut build = Command::new("dpkg-deb");
    build.env("SOURCE_DATE_EPOCH", built.time()).args(["--root-owner-group", "-Zxz", "--build"]);
    run_program(build.arg(root).arg(file))
}
