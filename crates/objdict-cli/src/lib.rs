//! The command `objdict`: one file a command. Results go to the standard output, messages to the
//! standard error.
//!
//! `dcf`, `convert`, `network`, `show` and `docs` import their submodules and vice versa: they share printed
//! output and are split for length.

mod annotation;
mod args;
mod baseline;
#[cfg(feature = "bus")]
mod bus;
mod cache;
mod canonical;
mod changes;
mod check;
mod configure;
mod conformance;
mod convert;
mod dcf;
mod decode;
mod diff;
mod docs;
mod ending;
mod files;
mod fix;
mod fmt;
mod generate;
mod git;
mod help;
mod identify;
mod input;
mod lock;
mod lsp;
mod modules;
mod network;
mod new;
mod node;
mod open;
mod packaging;
mod parallel;
mod patch;
mod patch_option;
mod probe;
mod profile;
mod profile_option;
mod progress;
mod reference;
mod report;
mod rules;
mod schema;
mod settings;
mod show;
mod sizes;
mod stdout;
mod table;
mod terminal;
mod values;
mod variants;
mod vendor;
mod written_files;

use std::io::Write;
use std::process::ExitCode;

use clap::error::{ContextKind, ContextValue};

use self::args::{Args, Command, OnlyCheck};
use self::ending::Outcome;
pub use self::reference::{CommandReference, CommandTables, reference};
#[cfg(feature = "schema")]
pub use self::schema::schemas;
use self::stdout::Output;
use objdict_model::diagnostic::{nearest, printable_lines};

/// What the command prints of the repository. A published crate has only its own folder, so the program brings these.
#[derive(Debug)]
pub struct Texts {
    /// `docs/reference/cli.md`.
    pub cli: &'static str,
    /// `docs/reference/config.md`.
    pub config: &'static str,
    /// `docs/guides/dcf.md`.
    pub dcf: &'static str,
    /// `docs/reference/formats.md`.
    pub formats: &'static str,
    /// The JSON Schemas of documents, by their names.
    pub schemas: &'static [(&'static str, &'static str)],
    /// The page of `objdict open`; `None` in a program that was built without it.
    pub workbench: Option<&'static str>,
}

/// Runs the command that the arguments of the process name.
pub fn run(texts: &Texts) -> ExitCode {
    let args = match Args::of_process() {
        Ok(args) => args,
        Err(mut error) => {
            suggest_nearest(&mut error);
            print_usage(&error);
            return if error.use_stderr() { Outcome::Failed.into() } else { Outcome::Clean.into() };
        }
    };
    terminal::set(args.terminal);
    let mut out = Output::stdout(args.terminal.color);
    let outcome = match &args.command {
        Command::Check(OnlyCheck::Check(command)) => check::run(command, &mut out),
        Command::Diff(command) => changes::run(command, &mut out),
        Command::Release(command) => changes::release::run(command, &mut out),
        Command::Convert(command) => convert::run(command, &mut out),
        Command::Configure(command) => configure::run(command, &mut out),
        Command::Modules(command) => modules::run(command, &mut out),
        Command::Variants(command) => variants::run(command, &mut out),
        Command::Dcf(command) => dcf::run(&command.command, &mut out),
        Command::Network(command) => network::run(&command.command, &mut out),
        Command::Conformance(command) => conformance::run(command, &mut out),
        Command::Decode(command) => decode::run(command, &mut out),
        #[cfg(feature = "bus")]
        Command::Bus(command) => bus::run(&command.command, &mut out),
        Command::Probe(command) => probe::run(command, &mut out),
        Command::Identify(command) => identify::run(command, &mut out),
        Command::Generate(command) => generate::run(command, &mut out),
        Command::Docs(command) => docs::run(command, &mut out),
        Command::New(command) => new::run(command, &mut out),
        Command::Profile(command) => profile::run(&command.command, &mut out),
        Command::Patch(command) => patch::run(&command.command, &mut out),
        Command::Fmt(command) => fmt::run(command, &mut out),
        Command::Rules(command) => rules::list(command, &mut out),
        Command::Schema(command) => schema::run(command, texts, &mut out),
        Command::Explain(command) => rules::explain(command, &mut out),
        Command::Show(command) => show::run(command, &mut out),
        Command::Lsp => lsp::run(),
        Command::Open(command) => open::run(command, texts, &mut out),
        Command::Help(command) => help::run(command, texts, &mut out),
        Command::Completions(command) => packaging::completions(command, &mut out),
        Command::Man(command) => packaging::man(command),
    };
    if outcome.is_ok() && !matches!(args.command, Command::Patch(_)) {
        patch_option::warn_of_unused();
    }
    // these report them with their other findings
    if !matches!(args.command, Command::Patch(_) | Command::Check(_) | Command::Generate(_)) {
        patch_option::warn_of_effects();
    }
    outcome
        .and_then(|outcome| out.finish().map(|()| outcome))
        .unwrap_or_else(|failure| {
            failure.print();
            Outcome::Failed
        })
        .into()
}

/// Leaves of the commands that clap suggests the one that is meant: it compares first letters, and offers `schema` for `chekc`.
fn suggest_nearest(error: &mut clap::Error) {
    let Some(ContextValue::String(wrong)) = error.get(ContextKind::InvalidSubcommand) else { return };
    let Some(ContextValue::Strings(names)) = error.get(ContextKind::SuggestedSubcommand) else { return };
    if let Some(meant) = nearest(wrong, names.iter().map(String::as_str)).map(str::to_owned) {
        error.insert(ContextKind::SuggestedSubcommand, ContextValue::Strings(vec![meant]));
    }
}

/// Prints the help, or an error of the arguments, which quotes them.
fn print_usage(error: &clap::Error) {
    let plain = error.render().to_string();
    let shown = printable_lines(&plain);
    // there is no other place to report an error of this
    let _ = if error.use_stderr() && shown != plain {
        std::io::stderr().write_all(shown.as_bytes())
    } else {
        error.print()
    };
}
