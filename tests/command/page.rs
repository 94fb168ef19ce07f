//! Pages show sessions as a terminal does; trycmd wants more. Here one becomes the other.
//!
//! * `<!-- exit 0 2 -->` in front of a block has the exit codes of its commands; without it all are 0.
//! * `…` in an output is for any text in the line, a line `…` for any lines.
//! * A block ends with the last line of its last output; trycmd wants an empty line behind it.
//! * `\r\n` of JSON stays; trycmd takes backslashes for separators of paths. So the path `a\\b` in JSON and headings of a command for Windows is `a//b`.
//! * `<!-- append FILE -->` in front of a block: the reader adds its lines to a file, behind an empty one, and so does the test.

use std::fs;
use std::io::Write;
use std::path::Path;

/// A piece of a page up to where its reader changes a file.
pub(crate) struct PagePart<'a> {
    pub(crate) text: &'a str,
}

const APPEND: &str = "<!-- append ";

/// The pieces of a page, one after the other all of it.
pub(crate) fn parts(page: &str) -> impl Iterator<Item = PagePart<'_>> {
    let mut rest = Some(page);
    std::iter::from_fn(move || {
        let text = rest.take()?;
        let end = text.get(1..).and_then(|behind| behind.find(APPEND)).map(|at| at + 1);
        let (part, behind) = end.map_or((text, None), |end| (&text[..end], Some(&text[end..])));
        rest = behind;
        Some(PagePart { text: part })
    })
}

impl PagePart<'_> {
    /// Adds the lines of the block that the piece begins with to the file that it names.
    pub(crate) fn append(&self, folder: &Path) {
        let Some((file, rest)) = self.text.strip_prefix(APPEND).and_then(|rest| rest.split_once(" -->\n"))
        else {
            return;
        };
        let block = rest.split_once('\n').and_then(|(_, block)| block.split_once("```")).expect("a block").0;
        let mut file = fs::File::options().append(true).open(folder.join(file)).unwrap();
        write!(file, "\n{block}").unwrap();
    }
}

/// The sessions of a page as trycmd runs them.
pub(crate) fn to_trycmd(page: &str) -> String {
    let mut text = String::new();
    let mut codes = Vec::new().into_iter();
    let mut in_session = false;
    for line in page.lines() {
        if let Some(list) = line.strip_prefix("<!-- exit ").and_then(|rest| rest.strip_suffix(" -->")) {
            codes = list.split(' ').collect::<Vec<_>>().into_iter();
            continue;
        }
        match line {
            "```console" => in_session = true,
            "```" if in_session => {
                in_session = false;
                text.push('\n');
            }
            "…" if in_session => {
                text.push_str("...\n");
                continue;
            }
            _ => {}
        }
        text.push_str(&if in_session {
            let line = line.replace('…', "[..]").replace(r"\r\n", "/r/n");
            if crate::is_for_windows() { with_paths_of_windows(&line) } else { line }
        } else {
            line.to_owned()
        });
        text.push('\n');
        if in_session && line.starts_with("$ ") {
            let code = codes.next().filter(|code| *code != "0");
            code.into_iter().for_each(|code| text.push_str(&format!("? {code}\n")));
        }
    }
    text
}

fn with_paths_of_windows(line: &str) -> String {
    // a heading of Markdown, where a backslash is escaped too
    if line.starts_with("# fixtures/") {
        return line.replace('/', "//");
    }
    let mut pieces = line.split_inclusive("\"file\":").map(str::to_owned);
    let mut text = pieces.next().unwrap_or_default();
    for piece in pieces {
        let path = piece.trim_start_matches([' ', '"']);
        let end = piece.len() - path.len() + path.find('"').unwrap_or_default();
        text.push_str(&piece[..end].replace('/', "//"));
        text.push_str(&piece[end..]);
    }
    text
}

/// What trycmd wrote, as a page shows it.
pub(crate) fn from_trycmd(text: &str) -> String {
    let mut page = String::new();
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        if line == "```console" {
            let session: Vec<&str> = lines.by_ref().take_while(|line| *line != "```").collect();
            page.push_str(&shown(&session));
        } else {
            page.push_str(line);
            page.push('\n');
        }
    }
    page
}

fn shown(session: &[&str]) -> String {
    let mut codes = Vec::new();
    let mut block = String::from("```console\n");
    for line in session.strip_suffix(&[""]).unwrap_or(session) {
        match line.strip_prefix("? ") {
            Some(code) => {
                codes.pop();
                codes.push(code);
                continue;
            }
            None if line.starts_with("$ ") => codes.push("0"),
            None => {}
        }
        block.push_str(&if *line == "..." {
            "…".to_owned()
        } else {
            line.replace("[..]", "…").replace("/r/n", r"\r\n")
        });
        block.push('\n');
    }
    block.push_str("```\n");
    match codes.iter().all(|code| *code == "0") {
        true => block,
        false => format!("<!-- exit {} -->\n{block}", codes.join(" ")),
    }
}

#[test]
fn a_page_becomes_sessions_and_a_page_again() {
    let page = "Text …\n\n<!-- exit 0 2 -->\n```console\n$ objdict one\n…\n10 … bytes \\r\\n\n\n$ objdict two\n```\n\n```sh\n…\n```\n";
    let sessions = "Text …\n\n```console\n$ objdict one\n...\n10 [..] bytes /r/n\n\n$ objdict two\n? 2\n\n```\n\n```sh\n…\n```\n";
    assert_eq!(to_trycmd(page), sessions);
    assert_eq!(from_trycmd(sessions), page);
}

#[test]
fn a_page_has_parts() {
    let page = "a\n\n<!-- append b.txt -->\n```toml\nb = 1\n```\n\nc\n<!-- append d.txt -->\n```\n```\n";
    let texts: Vec<&str> = parts(page).map(|part| part.text).collect();
    assert_eq!(texts.concat(), page);
    assert_eq!(texts.len(), 3);
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("b.txt"), "a = 1\n").unwrap();
    parts(page).take(2).for_each(|part| part.append(folder.path()));
    assert_eq!(fs::read_to_string(folder.path().join("b.txt")).unwrap(), "a = 1\n\nb = 1\n");
}
