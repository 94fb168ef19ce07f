//! Pages show sessions as a terminal does; trycmd wants more. Here one becomes the other.
//!
//! * `<!-- exit 0 2 -->` in front of a block has the exit codes of its commands; without it all are 0.
//! * `…` in an output is for any text in the line, a line `…` for any lines.
//! * A block ends with the last line of its last output; trycmd wants an empty line behind it.
//! * `\r\n` of JSON stays; trycmd takes backslashes for separators of paths.

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
            line.replace('…', "[..]").replace(r"\r\n", "/r/n")
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
