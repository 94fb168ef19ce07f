//! What the arguments say about the terminal.

use std::io::{self, IsTerminal};
use std::sync::OnceLock;

use clap::ValueEnum;

// Text output of every command.
#[derive(Clone, Copy, Debug, clap::Args)]
pub(super) struct TerminalArgs {
    /// When to use colours
    #[arg(long, global = true, value_enum, default_value = "auto", value_name = "WHEN", display_order = 900)]
    pub color: Color,
    /// Do not print notes, summaries or progress
    #[arg(short, long, global = true, conflicts_with = "verbose", display_order = 901)]
    pub quiet: bool,
    /// Print the name of each input file to standard error
    #[arg(short, long, global = true, display_order = 902)]
    pub verbose: bool,
}

/// When to use colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Color {
    /// On a terminal, unless `NO_COLOR` is set or `TERM` is `dumb`
    Auto,
    /// Always
    Always,
    /// Never
    Never,
}

impl Color {
    pub(super) fn is_on(self) -> bool {
        let is_set = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
        match self {
            Self::Always => true,
            Self::Never => false,
            Self::Auto => {
                let is_dumb = std::env::var_os("TERM").is_some_and(|term| term == "dumb");
                io::stdout().is_terminal() && !is_set("NO_COLOR") && !is_dumb
            }
        }
    }
}

/// The arguments of this run.
static TERMINAL: OnceLock<TerminalArgs> = OnceLock::new();

/// Notes what the arguments of this run say.
pub(super) fn set(args: TerminalArgs) {
    let _ = TERMINAL.set(args);
}

/// Whether `--quiet` is given.
pub(super) fn is_quiet() -> bool {
    TERMINAL.get().is_some_and(|terminal| terminal.quiet)
}

/// Whether `--verbose` is given.
pub(super) fn is_verbose() -> bool {
    TERMINAL.get().is_some_and(|terminal| terminal.verbose)
}
