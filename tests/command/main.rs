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
mod lsp;
mod neovim;
#[cfg(feature = "open")]
mod open;
mod outputs;
mod page;
mod patches;
mod pictures;
mod recipes;
mod replaced;
mod reports;
#[path = "../support/mod.rs"]
mod support;
#[cfg(windows)]
mod windows;
