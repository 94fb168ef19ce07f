//! `objdict help`: the help of a command, or a topic. The texts of topics are sections of the documentation.

use std::io::Write;

use clap::{Command, CommandFactory};

use super::Texts;
use super::args::{Args, HelpArgs};
use super::ending::{Failure, Outcome};
use super::stdout::Output;
use super::table::TextTable;
use objdict_generate::Target;
use objdict_model::diagnostic::{listing, nearest};

/// Where the text of a topic comes from.
#[derive(Clone, Copy)]
enum TopicText {
    /// The section of a page that has this heading.
    Section(fn(&Texts) -> &'static str, &'static str),
    /// The list of targets.
    Targets,
}

/// The topics, in the order of their list.
const TOPICS: [(&str, &str, TopicText); 7] = [
    ("exit-codes", "Meaning of the exit codes", TopicText::Section(|texts| texts.cli, "Exit codes")),
    ("severities", "Errors, warnings and notes", TopicText::Section(|texts| texts.cli, "Severities")),
    (
        "names",
        "Names of objects and entries in arguments",
        TopicText::Section(|texts| texts.cli, "Names of objects"),
    ),
    ("formats", "Input and output formats", TopicText::Section(|texts| texts.formats, "Formats")),
    ("targets", "Targets of `generate`", TopicText::Targets),
    (
        "configuration",
        "Settings in `objdict.toml`",
        TopicText::Section(|texts| texts.config, "Configuration"),
    ),
    ("settings", "Settings files for `configure`", TopicText::Section(|texts| texts.dcf, "Settings files")),
];

pub(super) fn run(args: &HelpArgs, texts: &Texts, out: &mut Output) -> Result<Outcome, Failure> {
    let mut command = <Args>::command();
    command.build();
    let topic = match args.subject.as_slice() {
        [topic] => TOPICS.iter().find(|(name, ..)| name == topic),
        _ => None,
    };
    match (topic, args.subject.as_slice()) {
        (Some((.., TopicText::Section(page, heading))), _) => {
            out.write_all(section(page(texts), heading).as_bytes())?;
        }
        (Some((.., TopicText::Targets)), _) => write_targets(out)?,
        (None, [topic]) if topic == "topics" => write_topics(out)?,
        (None, []) => {
            write_help(&mut command, out)?;
            writeln!(out, "\nTopics of `objdict help`:")?;
            write_topics(out)?;
        }
        (None, path) => {
            let mut named = &mut command;
            for name in path {
                named = named.find_subcommand_mut(name).ok_or_else(|| unknown(name))?;
            }
            write_help(named, out)?;
        }
    }
    Ok(Outcome::Clean)
}

fn write_help(command: &mut Command, out: &mut Output) -> Result<(), Failure> {
    let help = command.render_long_help();
    let text = if out.colour() { help.ansi().to_string() } else { help.to_string() };
    Ok(out.write_all(text.as_bytes())?)
}

fn write_topics(out: &mut Output) -> Result<(), Failure> {
    let mut table = TextTable::new(["", ""], usize::MAX);
    for (name, summary, _) in TOPICS {
        table.row([format!("  {name}"), summary.to_owned()]);
    }
    Ok(table.write(out)?)
}

fn write_targets(out: &mut Output) -> Result<(), Failure> {
    let mut table = TextTable::new(["Target", "Output"], usize::MAX);
    for target in Target::all() {
        table.row([target.name().to_owned(), target.summary().to_owned()]);
    }
    Ok(table.write(out)?)
}

fn unknown(name: &str) -> Failure {
    let command = <Args>::command();
    let commands = command.get_subcommands().filter(|command| !command.is_hide_set()).map(Command::get_name);
    let topics = TOPICS.map(|(name, ..)| name);
    let failure = Failure::new(format_args!("unknown command or topic `{name}`"));
    match nearest(name, commands.chain(topics)) {
        Some(meant) => failure.help(format!("did you mean `{meant}`?")),
        None => failure.help(format!("the topics are {}; `objdict -h` lists the commands", listing(topics))),
    }
}

/// The text below a heading of a page, up to the next heading, without sessions and the addresses of links.
fn section(page: &str, heading: &str) -> String {
    let is_heading = |line: &&str| line.trim_start_matches('#').strip_prefix(' ') == Some(heading);
    let lines = page.lines().skip_while(|line| !(line.starts_with('#') && is_heading(line))).skip(1);
    let mut block = None; // what the code block is that the line is in
    let mut text = Vec::new();
    for line in lines {
        match (line.strip_prefix("```"), block) {
            (Some(_), Some(_)) => block = None,
            (Some(kind), None) => block = Some(kind),
            (None, None) if line.starts_with('#') => break,
            (None, Some("console")) => {}
            (None, _) => text.push(line.to_owned()),
        }
    }
    align_tables(&mut text);
    text.retain(|line| !line.starts_with("<!--"));
    text.dedup_by(|line, before| line.is_empty() && before.is_empty());
    without_links(text.join("\n").trim()) + "\n"
}

/// Gives the columns of tables one width, and removes their lines.
fn align_tables(lines: &mut Vec<String>) {
    lines.retain(|line| !line.starts_with("|--"));
    let is_row = |line: &String| line.starts_with('|');
    for table in lines.chunk_by_mut(|a, b| is_row(a) == is_row(b)).filter(|table| is_row(&table[0])) {
        let cells =
            |row: &String| row.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect();
        let rows: Vec<Vec<String>> = table.iter().map(cells).collect();
        let length =
            |row: &Vec<String>, column: usize| row.get(column).map_or(0, |cell| cell.chars().count());
        let width = |column| rows.iter().map(|row| length(row, column)).max().unwrap_or_default();
        for (line, row) in table.iter_mut().zip(&rows) {
            let padded = row.iter().enumerate().map(|(column, cell)| {
                let width = width(column) + 2;
                format!("{cell:width$}")
            });
            *line = padded.collect::<String>().trim_end().to_owned();
        }
    }
}

/// `see [formats.md](formats.md)` becomes `see formats.md`.
fn without_links(text: &str) -> String {
    let mut plain = String::new();
    let mut rest = text;
    while let Some((before, behind)) = rest.split_once("](") {
        let opened = before.rfind('[').map(|at| (&before[..at], &before[at + 1..]));
        let (Some((before, name)), Some((_, behind))) = (opened, behind.split_once(')')) else { break };
        plain += before;
        plain += name;
        rest = behind;
    }
    plain + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_topic_has_a_text() {
        let mut command = <Args>::command();
        command.build();
        let help = command.find_subcommand_mut("help").unwrap().render_help().to_string().replace('\n', " ");
        let texts = Texts {
            cli: include_str!("../../../docs/reference/cli.md"),
            config: include_str!("../../../docs/reference/config.md"),
            dcf: include_str!("../../../docs/guides/dcf.md"),
            formats: include_str!("../../../docs/reference/formats.md"),
            schemas: &[],
            workbench: None,
        };
        for (name, _, text) in TOPICS {
            assert!(help.contains(name), "`{name}` is not in `{help}`");
            assert!(command.find_subcommand(name).is_none(), "`{name}` is a command");
            if let TopicText::Section(page, heading) = text {
                let text = section(page(&texts), heading);
                assert!(text.len() > 100 && !text.contains("](") && !text.contains("```"), "{name}: {text}");
            }
        }
    }

    #[test]
    fn a_section_ends_at_the_next_heading() {
        let page =
            "# One\n\ntext\n\n## Two\n\nsee [a](b.md#c).\n```toml\n# no heading\n```\n\n# Three\nmore\n";
        assert_eq!(section(page, "One"), "text\n");
        assert_eq!(section(page, "Two"), "see a.\n# no heading\n");
        let page = "# One\n\n| a | b |\n|---|---|\n| long | `x` |\n\n<!-- exit 1 -->\n```console\n$ cmd\n```\n\nend\n";
        assert_eq!(section(page, "One"), "a     b\nlong  `x`\n\nend\n");
    }
}
