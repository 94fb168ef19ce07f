//! Compiles what is generated from real files.

use std::path::Path;
use std::process::Command;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::{fs, thread};

use objdict::format;
use objdict::generate::{Options, Target, generate};
use objdict::source::SourceOptions;

/// Generates Rust and C from each file and compiles both; adds what fails to `failures`, and returns how many files
/// compiled.
pub(crate) fn run(files: &[&Path], failures: &mut Vec<String>) -> usize {
    let next = AtomicUsize::new(0);
    let problems = Mutex::new(Vec::new());
    thread::scope(|scope| {
        let workers = thread::available_parallelism().map_or(1, usize::from);
        for _ in 0..workers {
            scope.spawn(|| {
                while let Some(file) = files.get(next.fetch_add(1, Ordering::Relaxed)) {
                    if let Err(problem) = compile(file)
                        && let Ok(mut problems) = problems.lock()
                    {
                        problems.push(format!("{}: {problem}", file.display()));
                    }
                }
            });
        }
    });
    let mut problems = problems.into_inner().unwrap_or_default();
    problems.sort();
    let compiled = files.len() - problems.len();
    failures.append(&mut problems);
    compiled
}

fn compile(file: &Path) -> Result<(), String> {
    let description = format::open(file, &SourceOptions::default()).map_err(|error| error.to_string())?;
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    for name in ["rust", "c"] {
        let target = Target::named(name).map_err(|error| error.to_string())?;
        let generated = generate(description.device(), target, &Options::default());
        let generated = generated.map_err(|error| format!("{name}: {error}"))?;
        for output in generated.files {
            fs::write(folder.path().join(output.path), output.contents).map_err(|error| error.to_string())?;
        }
    }
    let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned());
    let rust = ["--edition", "2021", "--crate-type", "lib", "--emit", "metadata", "-D", "warnings", "od.rs"];
    call(folder.path(), &rustc, &rust)?;
    let c = ["-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror", "-c", "od.c"];
    call(folder.path(), "cc", &c)
}

fn call(folder: &Path, program: &str, arguments: &[&str]) -> Result<(), String> {
    let output = Command::new(program).args(arguments).current_dir(folder).output();
    let output = output.map_err(|error| format!("{program}: {error}"))?;
    if output.status.success() {
        return Ok(());
    }
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    Err(format!("{program}: {}", text.lines().find(|line| line.contains("error")).unwrap_or("failed")))
}
