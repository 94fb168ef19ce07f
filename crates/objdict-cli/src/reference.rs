//! The reference of the command in Markdown, from the declaration of the arguments: what is in the help, as tables.

use std::fmt::Write;

use clap::builder::StyledStr;
use clap::{Arg, Command, CommandFactory};

use super::args::Args;

/// The heading of options that say how files are read.
const INPUT: &str = "Input";

/// The tables of a page about a command, and those of all commands.
pub struct CommandTables {
    /// Each command with its sub-commands, as the text of a page behind its title.
    pub commands: Vec<CommandReference>,
    /// A table of the options of all commands under "Input".
    pub input: String,
    /// A table of the options that each command has.
    pub common: String,
}

/// What the help of a command says.
pub struct CommandReference {
    /// Its name: `network`.
    pub name: String,
    /// What it does, without a full stop.
    pub summary: String,
    /// Its usage, arguments and options, then those of its sub-commands.
    pub text: String,
}

/// The reference of all commands that the help lists.
pub fn reference() -> CommandTables {
    let mut top = <Args>::command();
    top.build();
    let mut input: Vec<&Arg> = Vec::new();
    let commands = shown(&top).map(|command| {
        collect_input(command, &mut input);
        let mut text = String::new();
        describe(command, &format!("objdict {}", command.get_name()), &mut text);
        for sub in shown(command) {
            let name = format!("objdict {} {}", command.get_name(), sub.get_name());
            let _ = write!(text, "\n## {}\n\n{}.\n\n", &name["objdict ".len()..], summary(sub));
            describe(sub, &name, &mut text);
        }
        CommandReference { name: command.get_name().to_owned(), summary: summary(command), text }
    });
    let commands = commands.collect();
    let common = top.get_arguments().filter(|option| !option.is_hide_set());
    CommandTables {
        commands,
        input: table("Option", &input),
        common: table("Option", &common.collect::<Vec<_>>()),
    }
}

/// The sub-commands that the help lists.
fn shown(command: &Command) -> impl Iterator<Item = &Command> {
    command.get_subcommands().filter(|sub| !sub.is_hide_set() && sub.get_name() != "help")
}

/// Adds the options about the input that no command had before.
fn collect_input<'a>(command: &'a Command, input: &mut Vec<&'a Arg>) {
    for option in command.get_arguments().filter(|option| option.get_help_heading() == Some(INPUT)) {
        if input.iter().all(|known| known.get_long() != option.get_long()) {
            input.push(option);
        }
    }
    shown(command).for_each(|sub| collect_input(sub, input));
}

fn summary(command: &Command) -> String {
    command.get_about().map(plain).unwrap_or_default()
}

/// Usage, arguments and options.
fn describe(command: &Command, name: &str, text: &mut String) {
    let usage = command.clone().render_usage().to_string();
    let usage = usage.trim_start_matches("Usage: ").trim();
    let usage = usage.split_once(name).map_or(usage, |(_, rest)| rest);
    let _ = writeln!(text, "Usage: `{name}{usage}`");
    let arguments: Vec<&Arg> = command.get_positionals().filter(|argument| !argument.is_hide_set()).collect();
    if !arguments.is_empty() {
        let _ = write!(text, "\n{}", table("Argument", &arguments));
    }
    let is_own = |option: &&Arg| {
        !option.is_hide_set()
            && !option.is_positional()
            && !option.is_global_set()
            && option.get_id() != "help"
    };
    let (input, options): (Vec<&Arg>, Vec<&Arg>) =
        command.get_arguments().filter(is_own).partition(|option| option.get_help_heading() == Some(INPUT));
    let mut headings: Vec<Option<&str>> = Vec::new();
    for option in &options {
        if !headings.contains(&option.get_help_heading()) {
            headings.push(option.get_help_heading());
        }
    }
    for heading in headings {
        let of_heading = |option: &&&Arg| option.get_help_heading() == heading;
        let options: Vec<&Arg> = options.iter().filter(of_heading).copied().collect();
        let _ = write!(text, "\n{}", table(heading.unwrap_or("Option"), &options));
    }
    if !input.is_empty() {
        let names: Vec<String> = input.iter().map(|option| format!("`--{}`", name_of(option))).collect();
        let _ = writeln!(text, "\nInput: {} ([input options](../cli.md#input-options)).", names.join(", "));
    }
}

/// A row for each argument: how it is written, and what it means.
fn table(heading: &str, arguments: &[&Arg]) -> String {
    let mut table = format!("| {heading} | |\n|---|---|\n");
    for argument in arguments {
        let _ = writeln!(table, "| `{}` | {} |", written(argument), meaning(argument));
    }
    table
}

fn name_of(argument: &Arg) -> &str {
    argument.get_long().unwrap_or(argument.get_id().as_str())
}

/// `-o, --output <FILE>`, `<FILE>...`
fn written(argument: &Arg) -> String {
    if argument.is_positional() {
        return argument.to_string();
    }
    let short = argument.get_short().map(|short| format!("-{short}, ")).unwrap_or_default();
    let names = argument.get_value_names().filter(|_| argument.get_action().takes_values());
    let names = names.into_iter().flatten().map(|name| format!(" <{name}>"));
    format!("{short}--{}{}", name_of(argument), names.collect::<String>())
}

/// The help, with possible values and the default.
fn meaning(argument: &Arg) -> String {
    let help = argument.get_long_help().or(argument.get_help()).map(ToString::to_string).unwrap_or_default();
    let mut text = cell(&help.split("\n\n").map(sentence).collect::<Vec<_>>().join(" "));
    let values = argument.get_possible_values();
    let values = values.iter().filter(|value| !value.is_hide_set() && argument.get_action().takes_values());
    let values = values.map(|value| match value.get_help() {
        Some(help) => format!("`{}` ({})", value.get_name(), plain(help)),
        None => format!("`{}`", value.get_name()),
    });
    let values: Vec<String> = values.collect();
    if !values.is_empty() && !argument.is_hide_possible_values_set() {
        let _ = write!(text, " Values: {}.", values.join(", "));
    }
    let defaults = argument.get_default_values().iter().map(|value| format!("`{}`", value.to_string_lossy()));
    let defaults: Vec<String> = defaults.collect();
    let is_told = text.contains("[default") || argument.is_hide_default_value_set();
    if !defaults.is_empty() && argument.get_action().takes_values() && !is_told {
        let _ = write!(text, " Default: {}.", defaults.join(", "));
    }
    text
}

/// A paragraph of the help as a sentence.
fn sentence(paragraph: &str) -> String {
    let end = if paragraph.ends_with(['.', ']', ':']) { "" } else { "." };
    format!("{}{end}", paragraph.trim_end())
}

fn plain(text: &StyledStr) -> String {
    cell(&text.to_string())
}

/// A text as the cell of a table.
fn cell(text: &str) -> String {
    let words: Vec<&str> = text.split_whitespace().collect();
    words.join(" ").replace('|', "\\|").replace('<', "&lt;")
}
