//! The command `objdict`: one file a command. Results go to the standard output, messages to the
//! standard error.

mod annotation;
mod args;
mod baseline;
mod cache;
mod check;
mod configure;
mod convert;
mod dcf;
mod diff;
mod docs;
mod files;
mod fix;
mod fmt;
mod generate;
mod help;
mod identify;
mod input;
mod modules;
mod network;
mod new;
mod node;
mod output;
mod packaging;
mod parallel;
mod profile;
mod profiles;
mod progress;
mod report;
mod rules;
mod save;
mod schema;
mod settings;
mod show;
mod sizes;
mod table;

use std::io::Write;
use std::path::Path;
use std::process::ExitCode;
use std::sync::OnceLock;

use self::args::{Args, Command, OnlyCheck, TerminalArgs};
use self::output::Output;
#[cfg(feature = "schema")]
pub use self::schema::schemas;
use crate::diagnostic::{one_line, printable_lines};

/// Runs the command that the arguments of the process name.
pub fn run() -> ExitCode {
    let args = match Args::of_process() {
        Ok(args) => args,
        Err(error) => {
            print_usage(&error);
            return if error.use_stderr() { Outcome::Failed.into() } else { Outcome::Clean.into() };
        }
    };
    let terminal = TERMINAL.get_or_init(|| args.terminal);
    let mut out = Output::stdout(terminal.color);
    let outcome = match &args.command {
        Command::Check(OnlyCheck::Check(command)) => check::run(command, &mut out),
        Command::Convert(command) => convert::run(command, &mut out),
        Command::Configure(command) => configure::run(command, &mut out),
        Command::Modules(command) => modules::run(command, &mut out),
        Command::Dcf(command) => dcf::run(&command.command, &mut out),
        Command::Network(command) => network::run(&command.command, &mut out),
        Command::Identify(command) => identify::run(command, &mut out),
        Command::Generate(command) => generate::run(command, &mut out),
        Command::Docs(command) => docs::run(command, &mut out),
        Command::New(command) => new::run(command, &mut out),
        Command::Profile(command) => profile::run(&command.command, &mut out),
        Command::Fmt(command) => fmt::run(command, &mut out),
        Command::Rules(command) => rules::list(command, &mut out),
        Command::Schema(command) => schema::run(command, &mut out),
        Command::Explain(command) => rules::explain(command, &mut out),
        Command::Show(command) => show::run(command, &mut out),
        Command::Help(command) => help::run(command, &mut out),
        Command::Completions(command) => packaging::completions(command, &mut out),
        Command::Man(command) => packaging::man(command),
    };
    outcome
        .and_then(|outcome| out.finish().map(|()| outcome))
        .unwrap_or_else(|failure| {
            failure.print();
            Outcome::Failed
        })
        .into()
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

/// How a command ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Outcome {
    /// Success.
    Clean,
    /// The work was done and something was found.
    Findings,
    /// The work could not be done, or not for every file.
    Failed,
}

impl Outcome {
    /// The exit code.
    const fn code(self) -> u8 {
        match self {
            Self::Clean => 0,
            Self::Findings => 1,
            Self::Failed => 2,
        }
    }
}

impl From<Outcome> for ExitCode {
    fn from(outcome: Outcome) -> Self {
        Self::from(outcome.code())
    }
}

/// Why a command could not do its work.
#[derive(Debug)]
struct Failure {
    message: String,
    help: Option<String>,
    /// The lines of a text that it is about, with the message: shown instead of message and help.
    excerpt: Option<String>,
}

impl Failure {
    /// A message of one line.
    fn new(message: impl std::fmt::Display) -> Self {
        Self { message: one_line(&message.to_string()), help: None, excerpt: None }
    }

    /// A message of several lines.
    fn of_lines(lines: impl IntoIterator<Item = impl AsRef<str>>) -> Self {
        let lines: Vec<String> = lines.into_iter().map(|line| one_line(line.as_ref())).collect();
        Self { message: lines.join("\n"), help: None, excerpt: None }
    }

    fn help(mut self, help: impl AsRef<str>) -> Self {
        self.help = Some(one_line(help.as_ref()));
        self
    }

    fn maybe_help(self, help: Option<impl AsRef<str>>) -> Self {
        help.into_iter().fold(self, Self::help)
    }

    fn excerpt(mut self, excerpt: String) -> Self {
        self.excerpt = Some(excerpt);
        self
    }

    /// Prints it on the standard error.
    fn print(&self) {
        if let Some(excerpt) = &self.excerpt {
            return tell(excerpt);
        }
        let mut text = format!("error: {}\n", self.message);
        if let Some(help) = &self.help {
            text.push_str(&format!("  help: {help}\n"));
        }
        tell(&text);
    }
}

/// What the arguments say about messages.
static TERMINAL: OnceLock<TerminalArgs> = OnceLock::new();

fn terminal() -> Option<&'static TerminalArgs> {
    TERMINAL.get()
}

/// Whether `--quiet` is given.
fn is_quiet() -> bool {
    terminal().is_some_and(|terminal| terminal.quiet)
}

/// Writes a note or a summary to the standard error, unless `--quiet` is given.
fn note(text: &str) {
    if !is_quiet() {
        tell(text);
    }
}

/// Names a file that is read, with `--verbose`.
fn detail(path: &Path) {
    if terminal().is_some_and(|terminal| terminal.verbose) {
        tell(&format!("reading {}\n", input::name_of(path)));
    }
}

/// Writes lines to the standard error; they may quote anything from a file.
fn tell(text: &str) {
    let _line = progress::hide();
    // there is no other place to report an error of this
    let _ = std::io::stderr().write_all(printable_lines(text).as_bytes());
}

impl From<std::io::Error> for Failure {
    fn from(error: std::io::Error) -> Self {
        Self::new(format_args!("cannot write the output: {error}"))
    }
}
