//! Verdicts of compilers, kept in `verdicts.tsv`: what passed once is neither compiled nor run again.
//!
//! A line has the tests that it belongs to and a hash of everything that decides about the verdict: the sources with
//! the headers of this project, flags, version, target and system headers of each compiler, the input, the expected
//! output, and the source of the test with the helpers that compare. A verdict is kept only if it follows from these
//! alone, so a new text, a new expectation and another compiler are tried as if there were no record.
//!
//! * `OBJDICT_SAMPLE=all` ignores the record; the nightly gate runs so.
//! * `OBJDICT_VERDICTS=write cargo test --test generate` writes it. Without further arguments this removes lines that
//!   no test uses. No other run changes the file.

use std::collections::{BTreeSet, HashMap};
use std::ffi::{OsStr, OsString};
use std::fmt::Debug;
use std::io::{Write, stderr};
use std::panic::Location;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::{LazyLock, Mutex};

use hmac_sha256::Hash;

use crate::compile::succeed;
use crate::support::skips::samples_all;

/// The folder of the project.
const PROJECT: &str = env!("CARGO_MANIFEST_DIR");

/// The helpers that build, run and compare for all tests.
const HELPERS: [&str; 6] = [
    include_str!("batch.rs"),
    include_str!("compile.rs"),
    include_str!("main.rs"),
    include_str!("processors.rs"),
    include_str!("stacks/truth.rs"),
    include_str!("verdicts.rs"),
];

/// Sources that compilers read; other files of a folder are made by the tests or the compilers.
const SOURCES: [&str; 5] = ["c", "cpp", "h", "rs", "toml"];

/// What decides about a verdict.
#[derive(Clone)]
pub(crate) struct Key {
    hash: Hash,
    /// The source of the tests, without folder and extension.
    tests: String,
    /// Whether all of it is known: nothing is about files outside of the project.
    is_complete: bool,
}

impl Key {
    /// The key of a test in the file of the caller.
    #[track_caller]
    pub(crate) fn new() -> Self {
        static HASH: LazyLock<Hash> = LazyLock::new(|| {
            let mut key = Key { hash: Hash::new(), tests: String::new(), is_complete: true };
            HELPERS.iter().for_each(|helper| key.add(helper));
            key.hash
        });
        let mut key = Self { hash: *HASH, tests: String::new(), is_complete: true };
        key.tests_of_caller();
        key
    }

    /// Adds the source of the caller, which the verdict then belongs to.
    #[track_caller]
    pub(crate) fn tests_of_caller(&mut self) {
        let file = Location::caller().file();
        let (_, tests) = file.split_once("tests/generate/").unwrap_or(("", file));
        self.tests = tests.trim_end_matches(".rs").trim_end_matches("/mod").to_owned();
        self.file(Path::new(PROJECT).join("tests/generate").join(tests));
    }

    /// Adds bytes.
    pub(crate) fn add(&mut self, bytes: impl AsRef<[u8]>) {
        let bytes = bytes.as_ref();
        self.hash.update((bytes.len() as u64).to_le_bytes());
        self.hash.update(bytes);
    }

    /// Adds a value.
    pub(crate) fn debug(&mut self, value: &dyn Debug) {
        self.add(format!("{value:?}"));
    }

    /// Adds another key.
    pub(crate) fn key(&mut self, other: &Self) {
        self.add(other.hash.finalize());
        self.is_complete &= other.is_complete;
    }

    fn file(&mut self, path: impl AsRef<Path>) {
        self.add(std::fs::read(path.as_ref()).unwrap_or_else(|error| panic!("{:?}: {error}", path.as_ref())));
    }

    /// Adds names and contents of the sources in a folder and below.
    pub(crate) fn folder(&mut self, folder: &Path) {
        let mut paths: Vec<PathBuf> = folder.read_dir().unwrap().map(|entry| entry.unwrap().path()).collect();
        paths.sort();
        for path in paths {
            let is_source = path.extension().is_some_and(|found| SOURCES.iter().any(|known| found == *known));
            if path.is_dir() {
                self.add(path.file_name().unwrap().as_encoded_bytes());
                self.folder(&path);
                self.add("end of the folder");
            } else if is_source {
                self.add(path.file_name().unwrap().as_encoded_bytes());
                self.file(path);
            }
        }
    }

    /// Adds a command of a compiler, and the sources in its folder.
    pub(crate) fn command(&mut self, command: &Command) {
        self.tool(command);
        self.folder(command.get_current_dir().unwrap());
    }

    /// Adds a command without its folder: the version of the program, its arguments, and the files of the project that
    /// these name.
    pub(crate) fn tool(&mut self, command: &Command) {
        let arguments: Vec<&OsStr> = command.get_args().collect();
        self.add(version(command.get_program(), &arguments));
        for argument in arguments {
            let text = argument.to_str().unwrap();
            let start = text.find('/').filter(|start| ["", "-I"].contains(&&text[..*start]));
            match start.map(|start| Path::new(&text[start..])) {
                Some(path) if path.starts_with(PROJECT) => {
                    self.add(path.strip_prefix(PROJECT).unwrap().as_os_str().as_encoded_bytes());
                    if path.is_dir() { self.folder(path) } else { self.file(path) }
                }
                Some(path) if path.starts_with("/dev/null") => {}
                Some(_) => self.is_complete = false,
                None => self.add(text),
            }
        }
    }

    fn line(&self) -> String {
        let digits: String = self.hash.finalize()[..8].iter().map(|byte| format!("{byte:02x}")).collect();
        format!("{}\t{digits}", self.tests)
    }

    /// Whether the record has it.
    pub(crate) fn is_kept(&self) -> bool {
        let line = self.line();
        let mut record = RECORD.lock().unwrap();
        let is_kept = self.is_complete && record.known.contains(&line);
        record.tried += 1;
        record.kept += usize::from(is_kept);
        if is_kept {
            record.write(line);
        }
        is_kept
    }

    /// Notes that it passed.
    pub(crate) fn keep(&self) {
        if self.is_complete {
            RECORD.lock().unwrap().write(self.line());
        }
    }

    /// Calls a function whose result depends on nothing but the key, unless the record has it.
    pub(crate) fn or_try(&self, check: impl FnOnce() -> Result<(), String>) -> Result<(), String> {
        if self.is_kept() {
            return Ok(());
        }
        check()?;
        self.keep();
        Ok(())
    }
}

/// A command that must succeed and whose output decides nothing, if it is not in the record.
#[track_caller]
pub(crate) fn accepts(command: &mut Command) -> Result<(), String> {
    let mut key = Key::new();
    key.command(command);
    key.or_try(|| succeed(command, "").map(drop))
}

/// What a program says of itself; of a C compiler also its target and what the headers of the system define.
fn version(program: &OsStr, arguments: &[&OsStr]) -> Vec<u8> {
    static KNOWN: LazyLock<Mutex<HashMap<Vec<OsString>, Vec<u8>>>> = LazyLock::new(Mutex::default);
    let text = |argument: &&&OsStr| argument.to_str().unwrap_or_default().to_owned();
    let is_c =
        arguments.iter().any(|argument| [".c", ".cpp"].iter().any(|end| text(&argument).ends_with(end)));
    let of_target = arguments.iter().filter(|argument| is_c && text(argument).starts_with("-m"));
    let id: Vec<OsString> = [program].iter().chain(of_target).map(|&part| part.to_owned()).collect();
    let mut known = KNOWN.lock().unwrap();
    let found = known.entry(id.clone()).or_insert_with(|| {
        // of a Rust compiler with `-v` also the host; others take it as part of the same question
        let mut output = Command::new(program).args(["--version", "-v"]).output().unwrap();
        let mut version = output.stdout;
        if is_c {
            let folder = tempfile::tempdir().unwrap();
            let headers =
                ["assert", "errno", "limits", "stdbool", "stddef", "stdint", "stdio", "stdlib", "string"];
            let headers = headers.map(|name| format!("#include <{name}.h>\n")).concat();
            std::fs::write(folder.path().join("headers.c"), headers).unwrap();
            let mut command = Command::new(program);
            command.current_dir(folder.path()).args(&id[1..]).args(["-E", "-dD", "-P", "headers.c"]);
            output = command.output().unwrap();
            version.extend(output.stdout);
            for variable in ["C_INCLUDE_PATH", "CPATH", "CPLUS_INCLUDE_PATH"] {
                version.extend(std::env::var_os(variable).unwrap_or_default().as_encoded_bytes());
            }
        }
        Hash::hash(&version).to_vec()
    });
    found.clone()
}

/// The file, and what this run adds.
struct Record {
    known: BTreeSet<String>,
    /// The lines of the file that is written; `None` if none is.
    written: Option<BTreeSet<String>>,
    /// The verdicts that were asked for, and how many of them are known.
    tried: usize,
    kept: usize,
}

static RECORD: LazyLock<Mutex<Record>> = LazyLock::new(|| {
    let text = std::fs::read_to_string(Record::path()).unwrap_or_default();
    let lines = || text.lines().map(str::to_owned).collect::<BTreeSet<_>>();
    let known = if samples_all() { BTreeSet::new() } else { lines() };
    // with arguments not every test runs
    let kept = || if std::env::args().len() > 1 { lines() } else { BTreeSet::new() };
    let written = std::env::var("OBJDICT_VERDICTS").is_ok_and(|word| word == "write").then(kept);
    assert!(
        written.is_none() || std::env::var_os("OBJDICT_CORPUS_DIR").is_none(),
        "the record has no verdicts about `OBJDICT_CORPUS_DIR`: unset it"
    );
    shutdown_hooks::add_shutdown_hook(end);
    Mutex::new(Record { known, written, tried: 0, kept: 0 })
});

impl Record {
    fn path() -> PathBuf {
        Path::new(PROJECT).join("tests/generate/verdicts.tsv")
    }

    fn write(&mut self, line: String) {
        if let Some(lines) = &mut self.written {
            lines.insert(line);
        }
    }
}

/// Writes the file, and prints what was taken from it.
extern "C" fn end() {
    // a panic must not reach the caller, which is C
    let Ok(record) = RECORD.lock() else { return };
    if let Some(lines) = &record.written {
        let text: String = lines.iter().map(|line| format!("{line}\n")).collect();
        if let Err(error) = std::fs::write(Record::path(), text) {
            writeln!(stderr(), "{:?}: {error}", Record::path()).ok();
        }
    }
    let Record { tried, kept, .. } = *record;
    if kept > 0 {
        writeln!(stderr(), "recorded: {kept} of {tried} verdicts, none with `OBJDICT_SAMPLE=all`").ok();
    }
}
