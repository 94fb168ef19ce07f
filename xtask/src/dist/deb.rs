//! The package for Debian and Ubuntu, written by `dpkg-deb`. cargo-deb would be more to install than this is to read, and writes
//! neither manual nor completions.

use std::env::consts::ARCH;
use std::fs;
use std::path::Path;
use std::process::Command;

use super::{Built, DISTRIBUTION, copy, run_program, write};

/// The command has parts of libc in it, so that it runs on every release.
const OVERRIDES: &str = "canopen-objdict: statically-linked-binary [usr/bin/objdict]\n";

/// `canopen-objdict_VERSION-1_ARCHITECTURE.deb`: program, manual and completions where shells and `man` look for them.
pub(super) fn make(built: &Built) -> Result<(), String> {
    let architecture = match ARCH {
        "x86_64" => "amd64",
        "aarch64" => "arm64",
        other => other,
    };
    let version = format!("{}-1", built.version);
    let root = built.stage("deb")?;
    copy(&built.program, &root.join("usr/bin/objdict"))?;
    let share = root.join("usr/share");
    let manual = share.join("man/man1");
    built.manual(&manual)?;
    built.completions("bash", &share.join("bash-completion/completions/objdict"))?;
    built.completions("zsh", &share.join("zsh/vendor-completions/_objdict"))?;
    built.completions("fish", &share.join("fish/vendor_completions.d/objdict.fish"))?;
    write(&share.join("lintian/overrides").join(DISTRIBUTION), OVERRIDES.as_bytes())?;
    let documents = share.join("doc").join(DISTRIBUTION);
    write(&documents.join("copyright"), copyright(&built.root)?.as_bytes())?;
    write(&documents.join("changelog.Debian"), changes(built, &version).as_bytes())?;
    copy(&built.root.join("CHANGELOG.md"), &documents.join("changelog"))?;
    let pages = fs::read_dir(&manual).map_err(|error| format!("{}: {error}", manual.display()))?;
    let pages = pages.filter_map(|page| Some(page.ok()?.path()));
    let texts = pages.chain(["changelog.Debian", "changelog"].map(|name| documents.join(name)));
    run_program(Command::new("gzip").args(["-9", "-n"]).args(texts))?;

    // in KiB, as `Installed-Size` of Debian's policy (§5.6.20)
    let size = Command::new("du").args(["-sk", "--apparent-size"]).arg(root.join("usr")).output();
    let size = size.ok().and_then(|output| String::from_utf8(output.stdout).ok()).unwrap_or_default();
    let size = size.split_whitespace().next().unwrap_or("0");
    let control = format!(
        "Package: {DISTRIBUTION}\nVersion: {version}\nArchitecture: {architecture}\nMaintainer: {}\n\
         Installed-Size: {size}\nSection: electronics\nPriority: optional\nHomepage: {}\n\
         Description: CANopen object-dictionary toolchain\n \
         Checks device descriptions (EDS, XDD) and node configurations (DCF, XDC),\n converts between them, and generates firmware \
         tables, concise DCF and\n documentation.\n",
        maintainer(built),
        built.fact("homepage").as_str().unwrap_or_default(),
    );
    write(&root.join("DEBIAN/control"), control.as_bytes())?;
    // with any umask
    run_program(Command::new("chmod").args(["-R", "u=rwX,go=rX"]).arg(&root))?;
    let file = built.dist.join(format!("{DISTRIBUTION}_{version}_{architecture}.deb"));
    // 45 CPU seconds of a program that is not optimised would be xz, and no one downloads it
    let compression = if built.options.program.is_some() { ["-Zgzip", "-z1"] } else { ["-Zxz", "-z6"] };
    let mut build = Command::new("dpkg-deb");
    build
        .env("SOURCE_DATE_EPOCH", built.time("%ct"))
        .arg("--root-owner-group")
        .args(compression)
        .arg("--build");
    run_program(build.arg(root).arg(file))
}

/// Debian has the text of the Apache licence once for all packages.
fn copyright(root: &Path) -> Result<String, String> {
    let mit = root.join("LICENSE-MIT");
    let mit = fs::read_to_string(&mit).map_err(|error| format!("{}: {error}", mit.display()))?;
    Ok(format!(
        "objdict is under the MIT licence or the Apache licence 2.0, at your choice.\n\n{mit}\n\
         The text of the Apache License, Version 2.0, is in /usr/share/common-licenses/Apache-2.0.\n"
    ))
}

/// The entry of this package; what changed in objdict is in the file `changelog`.
fn changes(built: &Built, version: &str) -> String {
    let [maintainer, time] = [maintainer(built), built.time("%cD")];
    format!(
        "{DISTRIBUTION} ({version}) stable; urgency=medium\n\n  * objdict {}.\n\n -- {maintainer}  {time}\n",
        built.version
    )
}

/// Who packs, in the variables of Debian's tools; otherwise an address that cannot be anyone's.
fn maintainer(built: &Built) -> String {
    let author = built.fact("authors")[0].as_str().unwrap_or_default().to_owned();
    let name = std::env::var("DEBFULLNAME").unwrap_or(author);
    let address = std::env::var("DEBEMAIL").unwrap_or_else(|_| format!("{DISTRIBUTION}@packages.invalid"));
    format!("{name} <{address}>")
}
