//! Chores: `cargo xtask corpus FOLDER [--generate] [--shares FILE]`, `cargo xtask fuzz FOLDER COUNT|SECONDSs [PART]`,
//! `cargo xtask targets FOLDER [--damaged] [--hostile] [--only TARGET]`, `cargo xtask concise CORPUS`,
//! `cargo xtask readers FOLDER PYTHON [MODULES]`, `cargo xtask docs [--check]`, `cargo xtask profiles [--check]`,
//! `cargo xtask templates [--check]`, `cargo xtask fuzz-corpus FOLDER`, `cargo xtask xsd FOLDER`, `cargo xtask dist KIND`,
//! `cargo xtask publish [--upload]`, `cargo xtask interface [--check]`.

#![allow(clippy::print_stdout, reason = "the table is the result of the chore")]

mod changes;
mod concise;
mod corpus;
mod dist;
mod docs;
mod examples;
mod fuzz;
mod interface;
mod json_pages;
mod mutate;
mod profiles;
mod publish;
mod readers;
mod round_trip;
mod rule_pages;
#[cfg(feature = "schema")]
mod schemas;
#[cfg(not(feature = "schema"))]
mod schemas {
    /// The schemas are made of types by a feature that tests and commands do without.
    pub(crate) fn run(_: bool) -> Result<(), String> {
        Err("the schemas need the feature `schema`: call `cargo xtask`, which has it".to_owned())
    }
}
mod shares;
mod targets;
mod templates;
mod unit_graph;

use std::path::Path;
use std::process::ExitCode;

const USAGE: &str = "\
usage:
  cargo xtask corpus FOLDER [--generate] [--shares FILE]
      read, print, check and convert there and back every description below FOLDER, and print a table; with --generate also
      that of `targets`, with --shares write how many files each rule fires on (docs/rules-shares.tsv)
  cargo xtask targets FOLDER [--damaged] [--hostile] [--only TARGET]
      generate every target from every description below FOLDER that has no error finding (--damaged: also from the
      others), with its names or with hostile ones (--hostile), compile that, and print a table; where a variable
      OBJDICT_<STACK>_DIR names a checkout of a stack, compile with it too
  cargo xtask fuzz FOLDER COUNT|SECONDSs [PART]
      corrupt the files below FOLDER so often or so long, and give them to every part of the library that takes foreign
      bytes, or to one; nothing may panic or break its promise (xtask/src/fuzz/targets.rs)
  cargo xtask fuzz-corpus FOLDER
      write what libFuzzer starts from: FOLDER/objdict.dict, and FOLDER/<part> with the fixtures that the part reads
  cargo xtask concise CORPUS
      unpack and pack the concise DCF of a corpus (dev/concise, sets.csv), and play them against the descriptions that they
      were made of
  cargo xtask readers FOLDER PYTHON [MODULES]
      count the EDS and DCF below FOLDER that python-canopen, dcf-tools and node-canopen read, as they are and after safe
      fixes; PYTHON is an interpreter that has the first two, MODULES the folder node_modules that has the last
  cargo xtask docs [--check]
      write docs/rules (with docs/rules-shares.tsv), docs/reference/portability.md and the JSON Schemas in schemas; with --check only
      compare
  cargo xtask interface [--check]
      write tests/interface.txt, the public items of `objdict` and `objdict-device` with their signatures; with --check only
      compare (only with the compiler that xtask/src/interface.rs names, which writes the JSON that it reads)
  cargo xtask profiles [--check]
      write the constants of the profiles that come with the program from their TOML (crates/objdict-profile); with
      --check only compare
  cargo xtask templates [--check]
      write the templates of crates/objdict-generate as Rust, so that no build compiles a template engine; with --check only
      compare
  cargo xtask xsd FOLDER
      write the structure of CiA 311, versions 1.0 and 1.1, as XML Schemas: 1.0.xsd and 1.1.xsd
  cargo xtask dist KIND|all [--profile PROFILE] [--target TARGET] [--program FILE] [--features LIST]
      build a package for this machine into target/dist, with SHA256SUMS (with --program, of a command that is built already; --features are for the module of a wheel, so that it shares what is built): wheel (command and Python module; needs Python and
      gets maturin from PyPI; with --target, on Linux, for another system, by mingw or by zig from PyPI), tarball, windows (a ZIP; on Linux needs mingw and rustc-web, see .ci/windows; not built by
      `all`), deb, npm, docker (the folder of an image), vsix (the extension of VS Code; needs npm)
  cargo xtask dist try
      install each of them in an empty folder as docs/install.md says, and check a description
  cargo xtask publish [--upload]
      package the crates in the order of their dependencies, and compile what is in the packages; with --upload publish them";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let result = match arguments[..] {
        // cargo calls this program as rustdoc
        _ if std::env::var_os(interface::RUSTDOC).is_some() => interface::rustdoc(&arguments),
        ["corpus", folder] => corpus::run(Path::new(folder), false, None),
        ["corpus", folder, "--generate"] => corpus::run(Path::new(folder), true, None),
        ["corpus", folder, "--shares", file] => corpus::run(Path::new(folder), false, Some(Path::new(file))),
        ["corpus", folder, "--generate", "--shares", file] => {
            corpus::run(Path::new(folder), true, Some(Path::new(file)))
        }
        ["targets", folder, ref choices @ ..] => match selection(choices) {
            Some(selection) => targets::run(Path::new(folder), selection),
            None => Err(USAGE.to_owned()),
        },
        ["fuzz", folder, budget, ref part @ ..] if part.len() < 2 => match fuzz::Budget::parse(budget) {
            Some(budget) => fuzz::run(Path::new(folder), fuzz::SIZE, budget, part.first().copied()),
            None => Err(USAGE.to_owned()),
        },
        ["fuzz-corpus", folder] => {
            fuzz::write_corpus(Path::new(folder)).map_err(|error| format!("{folder}: {error}"))
        }
        ["concise", corpus] => concise::run(Path::new(corpus)),
        ["readers", folder, python, ref modules @ ..] if modules.len() < 2 => {
            readers::run(Path::new(folder), Path::new(python), modules.first().map(Path::new))
        }
        // the tables of pages come from the schemas
        ["docs"] => schemas::run(false).and_then(|()| docs::run(false)),
        ["docs", "--check"] => schemas::run(true).and_then(|()| docs::run(true)),
        ["interface"] => interface::run(false),
        ["interface", "--check"] => interface::run(true),
        ["profiles"] => profiles::run(false),
        ["profiles", "--check"] => profiles::run(true),
        ["templates"] => templates::run(false),
        ["templates", "--check"] => templates::run(true),
        ["xsd", folder] => write_schemas(Path::new(folder)),
        ["dist", "try"] => dist::try_out(),
        ["dist", kind, ref options @ ..] => match dist::Options::of(options) {
            Some(options) => dist::run(kind, options),
            None => Err(USAGE.to_owned()),
        },
        ["publish"] => publish::run(false),
        ["publish", "--upload"] => publish::run(true),
        _ => Err(USAGE.to_owned()),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

/// The table of CiA 311 as schemas for validators.
fn write_schemas(folder: &Path) -> Result<(), String> {
    for version in objdict::format::XddVersion::ALL {
        let path = folder.join(format!("{}.xsd", version.name()));
        let written = std::fs::write(&path, objdict_xdd::xdd::xsd(version));
        written.map_err(|error| format!("{}: {error}", path.display()))?;
    }
    Ok(())
}

/// What the words behind the folder choose.
fn selection<'a>(mut choices: &[&'a str]) -> Option<targets::Selection<'a>> {
    let mut selection = targets::Selection::default();
    loop {
        choices = match *choices {
            [] => return Some(selection),
            ["--damaged", ref rest @ ..] => {
                selection.damaged = true;
                rest
            }
            ["--hostile", ref rest @ ..] => {
                selection.hostile = true;
                rest
            }
            ["--only", only, ref rest @ ..] => {
                selection.only = Some(only);
                rest
            }
            _ => return None,
        };
    }
}
