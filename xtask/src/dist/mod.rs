//! Packages of the command, of the Python module and of the extension of VS Code, into `target/dist`, with their checksums.
//!
//! docs/install.md is the test: `cargo xtask dist try` runs its blocks. The feature `open` is enabled if the page
//! of the workbench has been built.
//!
//! The command is built once and linked statically where the system allows it, so one program runs on every Linux, in an empty
//! image, and beside any Python. With `--program` nothing is built but the Python module: the gate packs the program that it tested,
//! and its packages run on this machine alone.

mod cross;
mod deb;
mod docker;
mod npm;
mod tarball;
mod try_out;
mod vsix;
mod wheel;
mod windows;

use std::env::consts::{ARCH, EXE_SUFFIX};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use toml::Table;

pub(crate) use try_out::try_out;

/// The distribution on PyPI and npm, and the package for Debian: the names `objdict` there belong to packages of others.
const DISTRIBUTION: &str = "canopen-objdict";

/// A kind of package.
struct Kind {
    /// What `cargo xtask dist` calls it.
    name: &'static str,
    /// Makes it of the built command.
    make: fn(&Built) -> Result<(), String>,
    /// Whether it can be made on this system.
    here: bool,
}

const KINDS: [Kind; 7] = [
    Kind { name: "wheel", make: wheel::make, here: true },
    Kind { name: "tarball", make: tarball::make, here: cfg!(unix) },
    // elsewhere it needs mingw, so it is made where it is asked for
    Kind { name: "windows", make: windows::make, here: cfg!(windows) },
    Kind { name: "deb", make: deb::make, here: cfg!(target_os = "linux") },
    Kind { name: "npm", make: npm::make, here: true },
    Kind { name: "docker", make: docker::make, here: cfg!(target_os = "linux") },
    Kind { name: "vsix", make: vsix::make, here: true },
];

/// The command as Cargo built it.
struct Built {
    root: PathBuf,
    /// The folder of all packages.
    dist: PathBuf,
    program: PathBuf,
    /// The version of all packages.
    version: String,
    /// Cargo.toml of the workspace.
    manifest: Table,
    options: Options,
}

/// How packages are built.
#[derive(Default)]
pub(crate) struct Options {
    /// The profile of Cargo; `None` for packages that are published.
    profile: Option<String>,
    /// The system that a wheel is for; `None` for this one.
    target: Option<String>,
    /// The command, if it is built already.
    program: Option<PathBuf>,
    /// Features that the module in a wheel is built with besides its own.
    features: Option<String>,
}

impl Options {
    /// What the words behind a kind choose.
    pub(crate) fn of(mut words: &[&str]) -> Option<Self> {
        let mut options = Self::default();
        while let [name, value, rest @ ..] = words {
            match *name {
                "--profile" => options.profile = Some((*value).to_owned()),
                "--features" => options.features = Some((*value).to_owned()),
                "--program" => options.program = Some(PathBuf::from(value)),
                "--target" => options.target = Some((*value).to_owned()),
                _ => return None,
            }
            words = rest;
        }
        words.is_empty().then_some(options)
    }
}

/// Makes one kind, or `all` that can be made here. Programs of the profile `dev` are made sooner, for tests.
pub(crate) fn run(kind: &str, options: Options) -> Result<(), String> {
    let kinds: Vec<&Kind> =
        KINDS.iter().filter(|own| own.name == kind || kind == "all" && own.here).collect();
    if kinds.is_empty() {
        let names: Vec<&str> = KINDS.iter().map(|kind| kind.name).collect();
        return Err(format!(
            "`{kind}` is not a kind of package: choose `all` or one of {}",
            names.join(", ")
        ));
    }
    if options.target.is_some() && kind != "wheel" {
        return Err(format!("`--target` is for a wheel, not for `{kind}`"));
    }
    if options.program.is_some() && !matches!(kind, "wheel" | "tarball" | "deb" | "npm" | "vsix") {
        return Err(format!("`--program` is for a package of this machine, not for `{kind}`: leave it out"));
    }
    let built = Built::new(options)?;
    for kind in kinds {
        (kind.make)(&built)?;
    }
    checksums(&built.dist)
}

impl Built {
    fn new(options: Options) -> Result<Self, String> {
        let root = root();
        let dist = root.join("target/dist");
        make_folder(&dist)?;
        // a later build replaces the one in `target`
        let program = dist.join("stage").join(format!("objdict{EXE_SUFFIX}"));
        let manifest = manifest(&root)?;
        let version = manifest["workspace"]["package"]["version"].as_str().unwrap_or_default().to_owned();
        let mut built = Self { dist, program, version, manifest, options, root };
        if let Some(target) = &built.options.target {
            built.program = cross::program(&built, target)?;
            return Ok(built);
        }
        if let Some(program) = &built.options.program {
            copy(program, &built.program)?;
            if cfg!(target_os = "linux") {
                // packages have no symbols, which are half of a program of the profile `dev`
                run_program(Command::new("strip").arg(&built.program))?;
            }
            return Ok(built);
        }
        let mut cargo = Command::new(env!("CARGO"));
        built.with_options(cargo.arg("rustc"));
        if cfg!(target_os = "linux") {
            // of glibc the command calls nothing that a static program lacks: no names of hosts or users, no `dlopen`
            cargo.args(["--", "-C", "target-feature=+crt-static"]);
        }
        run_program(&mut cargo)?;
        copy(
            &built.root.join("target").join(built.folder()).join(format!("objdict{EXE_SUFFIX}")),
            &built.program,
        )?;
        Ok(built)
    }

    /// What Cargo.toml says about all packages or about the command, such as its keywords; `Null` if it does not.
    fn fact(&self, key: &str) -> serde_json::Value {
        let tables = [&self.manifest["workspace"]["package"], &self.manifest["package"]];
        serde_json::json!(tables.iter().find_map(|table| table.get(key)))
    }

    /// A command of Cargo with the options of the packages.
    fn with_options<'a>(&self, cargo: &'a mut Command) -> &'a mut Command {
        let profile = self.options.profile.as_deref().unwrap_or("release");
        cargo.current_dir(&self.root).args([
            "--package",
            "objdict",
            "--bin",
            "objdict",
            "--profile",
            profile,
        ]);
        let page = self.root.join("web/dist/objdict-workbench.html");
        if page.is_file() {
            cargo.args(["--features", "open"]).env("OBJDICT_WORKBENCH", &page);
        } else {
            println!("without the page of `objdict open`: `cd web && npm ci && npm run build` makes it");
        }
        cargo
    }

    /// Where Cargo puts what it builds.
    fn folder(&self) -> &str {
        match self.options.profile.as_deref() {
            Some("dev") => "debug",
            profile => profile.unwrap_or("release"),
        }
    }

    /// Fills the folder of an archive: the program, its manual, completions and licences.
    fn fill(&self, folder: &Path, program: &Path) -> Result<(), String> {
        copy(program, &folder.join(program.file_name().unwrap_or_default()))?;
        self.manual(&folder.join("man"))?;
        for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
            self.completions(shell, &folder.join("completions").join(format!("objdict.{shell}")))?;
        }
        self.licences(folder)?;
        copy(&self.root.join("README.md"), &folder.join("README.md"))
    }

    /// A folder below `target/dist/stage` for the parts of a package, empty.
    fn stage(&self, name: &str) -> Result<PathBuf, String> {
        let folder = self.dist.join("stage").join(name);
        if folder.exists() {
            fs::remove_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
        }
        make_folder(&folder)?;
        Ok(folder)
    }

    /// Writes the manual pages into a folder.
    fn manual(&self, folder: &Path) -> Result<(), String> {
        make_folder(folder)?;
        run_program(Command::new(&self.program).args(["man", "-o"]).arg(folder))
    }

    /// Writes the completions of a shell into a file.
    fn completions(&self, shell: &str, file: &Path) -> Result<(), String> {
        let output = Command::new(&self.program).args(["completions", shell]).output();
        let output = output.map_err(|error| format!("{}: {error}", self.program.display()))?;
        write(file, &output.stdout)
    }

    /// Copies the licences into a folder.
    fn licences(&self, folder: &Path) -> Result<(), String> {
        ["LICENSE-MIT", "LICENSE-APACHE"]
            .iter()
            .try_for_each(|name| copy(&self.root.join(name), &folder.join(name)))
    }

    /// The time of the commit in a format of git, which all files in packages have, so that the same commit makes the same package.
    fn time(&self, format: &str) -> String {
        let mut git = Command::new("git");
        let output = git.current_dir(&self.root).args(["log", "-1", &format!("--format={format}")]).output();
        let time = output.ok().and_then(|output| String::from_utf8(output.stdout).ok()).unwrap_or_default();
        if time.trim().is_empty() { "0".to_owned() } else { time.trim().to_owned() }
    }
}

/// The system of this build as Rust calls it.
fn triple() -> String {
    let system = match std::env::consts::OS {
        "linux" => "unknown-linux-gnu",
        "macos" => "apple-darwin",
        "windows" => "pc-windows-msvc",
        other => other,
    };
    format!("{ARCH}-{system}")
}

/// What Python is called.
fn python() -> &'static str {
    if cfg!(windows) { "python" } else { "python3" }
}

/// Writes `SHA256SUMS` over all packages in the folder, which `sha256sum --check` reads.
fn checksums(dist: &Path) -> Result<(), String> {
    let failed = |error: std::io::Error| format!("{}: {error}", dist.display());
    let mut lines = Vec::new();
    for entry in fs::read_dir(dist).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        let Some(name) = path.file_name().and_then(|name| name.to_str()) else { continue };
        if path.is_file() && name != "SHA256SUMS" {
            let bytes = fs::read(&path).map_err(failed)?;
            let sum: String =
                hmac_sha256::Hash::hash(&bytes).iter().map(|byte| format!("{byte:02x}")).collect();
            println!("{name}: {} bytes", bytes.len());
            lines.push(format!("{sum}  {name}\n"));
        }
    }
    lines.sort_unstable_by(|a, b| a[64..].cmp(&b[64..]));
    write(&dist.join("SHA256SUMS"), lines.concat().as_bytes())
}

/// The manifest of the workspace.
fn manifest(root: &Path) -> Result<Table, String> {
    let path = root.join("Cargo.toml");
    let text = fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
    text.parse().map_err(|error| format!("{}: {error}", path.display()))
}

pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().map(Path::to_owned).unwrap_or_default()
}

fn make_folder(folder: &Path) -> Result<(), String> {
    fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))
}

/// Writes a file and the folders above it.
pub(crate) fn write(file: &Path, bytes: &[u8]) -> Result<(), String> {
    file.parent().map_or(Ok(()), make_folder)?;
    fs::write(file, bytes).map_err(|error| format!("{}: {error}", file.display()))
}

/// Copies a file with its permissions, and makes the folders above the copy.
fn copy(from: &Path, to: &Path) -> Result<(), String> {
    to.parent().map_or(Ok(()), make_folder)?;
    fs::copy(from, to).map(drop).map_err(|error| format!("{} to {}: {error}", from.display(), to.display()))
}

/// npm, or a program that comes with it.
fn npm() -> Command {
    Command::new(if cfg!(windows) { "npm.cmd" } else { "npm" })
}

pub(crate) fn run_program(command: &mut Command) -> Result<(), String> {
    let program = command.get_program().to_owned();
    let status = command.status().map_err(|error| format!("{}: {error}", program.display()))?;
    if status.success() { Ok(()) } else { Err(format!("{} failed: {status}", program.display())) }
}
