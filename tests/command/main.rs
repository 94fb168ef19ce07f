//! What the command does with arguments, files and exit codes, and what a build script does in its place.

#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod build_script;
mod building;
#[cfg(unix)]
mod ci;
mod cli;
mod dialects;
mod diff;
mod drawn_page;
mod emacs;
mod fixing;
mod flags;
mod hostile;
mod limits;
#[cfg(unix)]
mod live;
mod lsp;
mod neovim;
mod networks;
mod open;
mod outputs;
mod page;
mod patches;
mod pictures;
mod proportion;
mod recipes;
mod refused;
mod replaced;
mod reports;
#[path = "../support/mod.rs"]
mod support;
mod verdicts;
mod windows;

/// The command: the one that Cargo built, or the one that `OBJDICT_PROGRAM` names, as `.ci/run` does with that for Windows.
fn program() -> &'static str {
    static PROGRAM: std::sync::LazyLock<Option<String>> =
        std::sync::LazyLock::new(|| std::env::var("OBJDICT_PROGRAM").ok());
    PROGRAM.as_deref().unwrap_or(env!("CARGO_BIN_EXE_objdict"))
}

/// What the command printed, with `/` between folders on every system.
fn printed(bytes: &[u8]) -> String {
    let text = String::from_utf8_lossy(bytes);
    if is_for_windows() { text.replace('\\', "/") } else { text.into_owned() }
}

/// Whether the command is one for Windows.
fn is_for_windows() -> bool {
    cfg!(windows) || std::env::var_os("OBJDICT_PROGRAM").is_some()
}
